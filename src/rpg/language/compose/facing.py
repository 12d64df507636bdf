"""Figures that are told apart by their sides: "the left tower" and "the right one", "a back row" and "a front row"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.figures import OPPOSITE, TOWARD, Resolve
from rpg.language.compose.items import FIGURES
from rpg.language.compose.scene import Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun, Phrase

_ACROSS = (("left", "middle", "right"), ("near", "middle", "far"))


def one_more(scene: Scene, noun: Noun) -> Noun:
    """ "(A and B in one tower, C and D) in another", "in the right one": a further one, of the same kind.

    Raises Unclear where it may be one that is there already.
    """
    told_by_side = noun.det == "the" and bool(noun.ranks)
    if not told_by_side and noun.det not in {"another", "other"}:
        return noun
    kind = noun.noun if noun.noun in FIGURES else scene.figures[-1].kind if scene.figures else ""
    alike = [figure for figure in scene.figures if figure.kind == kind]
    if told_by_side:
        known = noun.ranks[0] in scene.facing or not any(noun.ranks[0] in sides for sides in _ACROSS)
        if known or len(scene.figures) > len(scene.facing) or not kind:
            raise Unclear
    elif not alike or any(figure.implied for figure in alike) or (noun.det == "other" and len(scene.figures) > 1):
        raise Unclear
    return replace(noun, det="a", noun=kind, ranks=())


def face(scene: Scene, side: str, figure: int) -> None:
    """A figure is at that side of others that are told by theirs."""
    for sides in _ACROSS:
        for other, n in scene.facing.items() if side in sides else ():
            if other in sides:
                ahead = sides.index(other) < sides.index(side)
                said = TOWARD[sides[0] if ahead else sides[2]]
                scene.facts.append(Fact(Ref("figure", [n]), said, Ref("figure", [figure])))
    scene.facing[side] = figure


def check_facing(scene: Scene) -> None:
    """Raises Unclear where there is a left one, but no right one."""
    for side in scene.facing:
        needed = (OPPOSITE[side],) if side in OPPOSITE else ()
        if any(other not in scene.facing for other in needed) or len(scene.facing) < 2:
            raise Unclear


def face_each_other(scene: Scene, parts: Sequence[Phrase], resolve: Resolve) -> list[Ref]:
    """ "a back row of three red blocks and a front row of two": figures at opposite sides of each other."""
    nouns = [part for part in parts if isinstance(part, Noun) and part.noun in FIGURES and part.det in {"a", ""}]
    ranks = [part.ranks[0] for part in nouns if len(part.ranks) == 1]
    if len(ranks) < len(parts) or not any(set(ranks) in ({*sides}, {sides[0], sides[2]}) for sides in _ACROSS):
        return []
    if len({*ranks}) < len(ranks):
        raise Unclear
    refs = [resolve(scene, replace(part, ranks=())) for part in nouns]
    if any(ref.kind != "figure" or len(ref.ids) != 1 or not ref.fresh for ref in refs):
        raise Unclear
    for rank, ref in zip(ranks, refs, strict=True):
        face(scene, rank, ref.ids[0])
    return refs
