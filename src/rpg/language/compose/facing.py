"""Figures that are told apart by their sides: "the left tower" and "the right one", "a back row" and "a front row"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.items import FIGURES
from rpg.language.compose.scene import OPPOSITE, TOWARD, Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun

_ACROSS = (("left", "middle", "right"), ("near", "middle", "far"))
SIDED = frozenset(side for sides in _ACROSS for side in sides)


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
        known = noun.ranks[0] in scene.facing or noun.ranks[0] not in SIDED
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
