"""Several things of one phrase: what shows a letter or a digit, and what is counted alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.items import shows
from rpg.language.compose.scene import Ref, Resolve, Scene, Unclear
from rpg.language.compose.syntax import ALL, Both, Label, Noun, Phrase

_WORTH = {"bottom": 1, "short": 1, "top": -1, "tall": -1}
"""Whether the lowest or the highest number comes first."""


def counted_alike(parts: Sequence[Phrase]) -> list[Phrase]:
    """ "the second and the fourth block from the left": what is said of the last one is said of all."""
    last = parts[-1]
    if not isinstance(last, Noun) or not (last.nth or last.ranks == ("last",)):
        return list(parts)
    bare = [isinstance(part, Noun) and part == Noun(part.det, nth=part.nth, noun="one") for part in parts]
    told = [
        replace(last, nth=part.nth, ranks=last.ranks if last.nth else ()) if alike and isinstance(part, Noun) else part
        for part, alike in zip(parts, bare, strict=True)
    ]
    new = isinstance(last.of, Noun) and last.of.det in {"a", ""}
    return [replace(part, of=None) if new and n and isinstance(part, Noun) else part for n, part in enumerate(told)]


def symbols(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """ "the letters", "each vowel of the word", "the even digits": those that show such symbols."""
    among = list(range(len(scene.blocks)))
    if noun.of is not None:
        whole = resolve(scene, noun.of)
        among = [n for at in whole.ids for n in scene.figures[at].blocks] if whole.kind == "figure" else whole.ids
    labels = {n: scene.blocks[n].label for n in among}
    if noun.ranks:
        return _by_worth(scene, noun, [n for n in among if shows(labels[n], _kind_of(noun))])
    found = [n for n in among if (labels[n] == noun.word if noun.noun == "sign" else shows(labels[n], noun.noun))]
    many = noun.many or noun.det in ALL
    if noun.det not in {"the", *ALL} or noun.ranks or noun.nth or noun.bound or noun.color or noun.content is not None:
        raise Unclear
    if not found or (not many and len(found) > 1) or (noun.count and noun.count != len(found)):
        raise Unclear
    return Ref("block", found, each=noun.det == "each", every=noun.det in ALL)


def by_worth(scene: Scene, noun: Noun) -> bool:
    """Whether "the lowest number" is the one of least worth: it is not where it stands that is meant."""
    of = noun.of.parts if isinstance(noun.of, Both) and noun.noun == "one" else ()
    digits = bool(of) and all(isinstance(part, Label) and part.label.isdigit() for part in of)
    if not (digits or noun.noun in {"digit", "even", "odd"}) or noun.nth or len(noun.ranks) != 1:
        return False
    upright = any(figure.kind in {"tower", "wall", "grid"} for figure in scene.figures)
    return noun.ranks[0] in _WORTH and not (upright and noun.ranks[0] in {"bottom", "top"})


def _kind_of(noun: Noun) -> str:
    return "digit" if noun.noun == "one" else noun.noun


def _by_worth(scene: Scene, noun: Noun, among: list[int]) -> Ref:
    """ "The smallest number", "the three highest numbers"."""
    worth = {n: int(scene.blocks[n].label) for n in among}
    count = noun.count or 1
    if noun.det != "the" or noun.bound or noun.color or noun.content is not None or (noun.many and not noun.count):
        raise Unclear
    if len(set(worth.values())) < len(among) or count >= len(among):
        raise Unclear
    found = sorted(among, key=lambda n: worth[n] * _WORTH[noun.ranks[0]])[:count]
    if len(among) == len(scene.blocks):  # the rest of them may be spoken of
        scene.whole, scene.taken = list(among), list(found)
    scene.spare |= set(among)
    return Ref("block", found)
