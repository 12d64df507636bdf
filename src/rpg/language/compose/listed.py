"""Several things of one phrase: what shows a letter or a digit, and what is counted alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.figures import ALL, Resolve
from rpg.language.compose.items import shows
from rpg.language.compose.scene import Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun, Phrase


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
    found = [n for n in among if (labels[n] == noun.word if noun.noun == "sign" else shows(labels[n], noun.noun))]
    many = noun.many or noun.det in ALL
    if noun.det not in {"the", *ALL} or noun.ranks or noun.nth or noun.bound or noun.color or noun.content is not None:
        raise Unclear
    if not found or (not many and len(found) > 1) or (noun.count and noun.count != len(found)):
        raise Unclear
    return Ref("block", found, each=noun.det == "each", every=noun.det in ALL)
