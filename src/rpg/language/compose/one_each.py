"""One for each of several: "a white block on each end", "two white blocks on it, one on each end"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.nouns import resolve
from rpg.language.compose.relating import place
from rpg.language.compose.resting import on
from rpg.language.compose.scene import SIDES, Ref, Scene, Unclear
from rpg.language.compose.syntax import Both, Noun, Phrase, Place, Predicate, Pronoun, any_number, on_an_end


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
    for n in target.ids:
        one = resolve(scene, replace(subject, det="a", many=False, count=0))
        if not one.fresh:
            raise Unclear
        place(scene, one, Ref(target.kind, [n]), said)
        scene.used.update(one.ids)
