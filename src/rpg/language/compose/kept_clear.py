"""Where no block is: "no block is on the blue patch", "nothing in front of it", "with nothing touching it"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.nouns import resolve
from rpg.language.compose.parts import whole_figures
from rpg.language.compose.pronouns import landmark
from rpg.language.compose.resting import tops_of
from rpg.language.compose.scene import SIDES, Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import NOTHING, Clause, Noun, Place

_SAID = {**SIDES, "next": "next to", "touch": "touch"}
_HOLLOW = frozenset({"circle", "square"})


def kept_clear(scene: Scene, clause: Clause) -> bool:
    """Whether a clause says where nothing is. What is beside it is known when all blocks have been told of."""
    subject, said = clause.subject, clause.predicates[0] if len(clause.predicates) == 1 else None
    if not isinstance(subject, Noun) or replace(subject, word="", many=False) != NOTHING:
        return False
    if not isinstance(said, Place) or said.no or said.of is None or said.cm or clause.mood == "start":
        raise Unclear
    if _is_inside(scene, said):
        return True
    around, scene.around = landmark(scene, said), None
    target = scene.mention(around) if around else resolve(scene, said.of)
    named = around is not None or (isinstance(said.of, Noun) and said.of.det == "the")
    if (
        (target.fresh and not named)
        or target.bound
        or target.rest
        or target.no
        or target.either
        or said.how == "somewhere"
    ):
        raise Unclear
    if target.kind == "patch" and said.relation in {"on", "in"}:
        scene.facts += [Fact(Ref("patch", [n]), "empty") for n in target.ids]
    elif target.kind == "patch" or target.kind == "table":
        raise Unclear
    elif said.relation == "on":
        scene.facts += [Fact(Ref("block", [n]), "clear") for n in tops_of(scene, target)]
    elif said.relation in _SAID and not said.how:
        others = [replace(target, ids=[n], each=False) for n in target.ids]
        scene.clear += [(_SAID[said.relation], other, subject.word == "else", scene.stage) for other in others]
    else:
        raise Unclear
    return True


def _is_inside(scene: Scene, said: Place) -> bool:
    """Whether it is the middle of an outline that is told to be empty: so it is anyway."""
    if not isinstance(said.of, Noun) or said.of.noun != "middle" or said.relation not in {"in", "on"}:
        return False
    if said.of.ranks or said.of.nth or any(f.kind not in _HOLLOW for f in whole_figures(scene, said.of, resolve)):
        raise Unclear
    return True


def keep_clear(scene: Scene) -> None:
    """Says of each block that it is not where nothing is; of all but those that were told to be there, where nothing
    else is. Raises Unclear where one was told to be there."""
    for said, target, other, stage in scene.clear:
        own = [n for at in target.ids for n in scene.figures[at].blocks] if target.kind == "figure" else target.ids
        there = {n for fact in scene.facts if fact.said.endswith(said) and not fact.no and _same(fact.b, target)
                 for n in _blocks(scene, fact.a)}  # fmt: skip
        there |= {n for fact in scene.facts if said in {"next to", "touch"} and fact.said == said and not fact.no
                  and _same(fact.a, target) for n in _blocks(scene, fact.b)}  # fmt: skip
        if there and not other:
            raise Unclear
        rest = [n for n in range(len(scene.blocks)) if n not in own and n not in there]
        if not rest:
            raise Unclear  # there are no others that could be there
        scene.facts += [Fact(Ref("block", [n]), said, target, no=True, stage=stage) for n in rest]
    scene.clear = []


def _same(ref: Ref | None, target: Ref) -> bool:
    return ref is not None and (ref.kind, ref.ids) == (target.kind, target.ids)


def _blocks(scene: Scene, ref: Ref | None) -> list[int]:
    if ref is None or ref.kind == "patch":
        return []
    return [n for at in ref.ids for n in scene.figures[at].blocks] if ref.kind == "figure" else ref.ids
