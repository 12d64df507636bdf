"""One for each of several: "a white block on each end", "two white blocks on it, one on each end"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.items import FIGURES
from rpg.language.compose.nouns import resolve
from rpg.language.compose.relating import place
from rpg.language.compose.resting import on
from rpg.language.compose.scene import SIDES, Ref, Scene, Unclear
from rpg.language.compose.syntax import OWN, Both, Noun, Phrase, Place, Predicate, Pronoun, any_number, on_an_end


def one_by_one(scene: Scene, subject: Noun, said: Sequence[Predicate]) -> None:
    """ "one on each end": where those are that lie somewhere on the figure told before."""
    upper, lower = scene.pending.pop()
    if (
        subject.noun not in {"", "one", "block"}
        or len(said) != 1
        or not isinstance(said[0], Place)
        or said[0].of is None
    ):
        raise Unclear
    target = resolve(scene, said[0].of)
    if (
        said[0].relation != "on"
        or said[0].no
        or target.kind != "block"
        or not target.each
        or not set(target.ids) <= set(lower)
    ):
        raise Unclear
    scene.used -= set(upper)
    on(scene, Ref("block", upper), Ref("block", target.ids), "on", no=False)


def each_of_a_new_one(subject: Phrase, said: Sequence[Predicate]) -> bool:
    """Whether there is a further one for each of those that it is put on."""
    if len(said) != 1 or not isinstance(said[0], Place) or said[0].no:
        return False
    target = said[0].of
    if isinstance(target, Both) and all(isinstance(part, Noun) and (part.nth or part.ranks) for part in target.parts):
        target = Noun(det="both")  # "on the second and the fourth"
    if target == Pronoun("each"):
        target = Noun(det="each")
    if not isinstance(subject, Noun) or not isinstance(target, Noun):
        return False
    several = any_number(subject)
    if said[0].relation == "next" and subject.noun in FIGURES:
        return False  # "a tower next to each of two blocks": one for all of them, or one for each
    if said[0].relation != "on" and target.det != "each":
        return False  # to the left of both of them at once
    if target.det not in {"each", "both", "all"} and not (several and target.det == "the" and target.count > 1):
        return False
    one = subject.det in {"a", "another"} or (not subject.det and subject.count == 1 and not subject.bound)
    return several or (one and not subject.of and not subject.many and subject.count < 2)


def one_for_each(scene: Scene, subject: Phrase, said: Predicate) -> None:
    """ "a white block on each end": as many white blocks as there are ends."""
    assert isinstance(said, Place) and said.of is not None and isinstance(subject, Noun)
    target = resolve(scene, said.of)
    if said.relation not in {"on", "next", *SIDES} or target.no or target.bound or on_an_end(said):
        raise Unclear
    loose = target.kind == "block" and not all(scene.figure_of(n) for n in target.ids)
    if said.relation in SIDES and (loose or (said.of == Pronoun("each") and target.kind != "patch")):
        raise Unclear  # "left of each of the three blocks": one for each, or one for all of them
    if subject.color == OWN and (target.kind != "patch" and scene.stock):
        raise Unclear  # which of those that there are
    for n in target.ids:
        color = _color_of(scene, target.kind, n) if subject.color == OWN else subject.color
        noun = "block" if subject.noun == "one" and subject.color and n != target.ids[0] else subject.noun
        one = resolve(scene, replace(subject, det="a", color=color, noun=noun, many=False, count=0))
        if not one.fresh:
            raise Unclear
        place(scene, one, Ref(target.kind, [n]), said)
        scene.used.update(one.ids)


def _color_of(scene: Scene, kind: str, n: int) -> str:
    """The colour of a patch, of a block, or of all blocks of a figure."""
    if kind == "patch":
        return scene.patches[n].color
    colors = {scene.blocks[m].color for m in (scene.figures[n].blocks if kind == "figure" else [n])}
    if len(colors) > 1 or not all(colors):
        raise Unclear
    return colors.pop()


def in_turn(scene: Scene, ref: Ref, target: Ref, said: Place) -> None:
    """ "A and B on the red and the blue block respectively": the first on the first one."""
    if len(ref.ids) != len(target.ids) or len(ref.ids) < 2 or ref.bound or ref.rest or ref.no or said.no:
        raise Unclear
    for a, b in zip(ref.ids, target.ids, strict=True):
        place(scene, Ref(ref.kind, [a]), Ref(target.kind, [b]), replace(said, how=""))
