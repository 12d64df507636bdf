"""Towers that stand in a row, a column or a grid: which one is the left one, the middle one, one of the outer two."""

from __future__ import annotations

from dataclasses import replace
from math import isqrt, prod

from rpg.blocks.nouns import number
from rpg.language.compose.places_of import places
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun

IN_A_ROW, IN_ORDER, FROM_LEFT = "in a row", "in a row in this order", "in a row from the left"
_FLAT = frozenset({"grid", "square"})


def feet(scene: Scene, ref: Ref) -> list[int]:
    """What tells where several towers are: their lowest blocks. One may be a single block."""
    if ref.kind != "figure":
        return ref.ids
    figures = [scene.figures[n] for n in ref.ids]
    if any(figure.kind != "tower" for figure in figures):
        raise Unclear
    for figure in figures:
        scene.settle(figure)
    return [figure.blocks[0] for figure in figures]


def stand_in(scene: Scene, ref: Ref, shape: Noun) -> None:
    """They stand in a row, a column or a grid. Which one is where is left open, unless told from the left."""
    lowest = feet(scene, ref)
    many = len(lowest)
    if many < 2 or shape.order or shape.gaps:
        raise Unclear
    if (shape.way and shape.noun != "column") or shape.word or shape.nth or ref.bound:
        raise Unclear
    if shape.noun in {"row", "line"} and shape.ranks in {(), ("left",)} and shape.size in {(), (many,)}:
        if ref.kind == "figure":
            scene.lines.append(list(ref.ids))
        said = FROM_LEFT if shape.ranks else IN_A_ROW
    elif shape.noun == "column" and not shape.ranks and shape.size in {(), (many,)}:
        said = "in a column on the table"
    elif shape.noun in _FLAT and not shape.ranks:
        rows, across = shape.size if len(shape.size) == 2 else (isqrt(many), isqrt(many))
        if prod((rows, across)) != many or 1 in {rows, across} or (shape.noun == "square" and rows != across):
            raise Unclear
        said = f"in a grid of {number(rows)} rows and {number(across)} columns"
    else:
        raise Unclear
    scene.facts.append(Fact(Ref("block", lowest), said))


def rise(scene: Scene, ref: Ref, side: str) -> None:
    """Those that stand in a row do so by their heights, rising to a side; from the left, if they are told so."""
    lowest = feet(scene, ref)
    at = next((n for n, fact in enumerate(scene.facts) if fact.a.ids == lowest and fact.said.startswith(IN_A_ROW)), -1)
    heights = {n: next((len(f.blocks) for f in scene.figures if n in f.blocks), 1) for n in lowest}
    if at < 0 or len({*heights.values()}) < len(lowest) or scene.facts[at].said == IN_ORDER:
        raise Unclear
    sided = bool(side) or scene.facts[at].said == FROM_LEFT
    order = sorted(lowest, key=heights.__getitem__, reverse=side in {"left", "fall"})
    scene.facts[at] = replace(scene.facts[at], a=Ref("block", order), said=FROM_LEFT if sided else IN_ORDER)


def of_line(scene: Scene, found: list[int], ranks: tuple[str, ...], nth: int, count: int) -> list[int]:
    """Those of towers in a row that are at such places; where they look alike, any of them may be there."""
    line = next((line for line in scene.lines if set(line) == set(found)), None)
    if line is None:
        raise Unclear
    figures = [scene.figures[n] for n in line]
    lowest = Ref("block", [figure.blocks[0] for figure in figures])
    at = next((n for n, fact in enumerate(scene.facts) if fact.a == lowest and fact.said.startswith(IN_A_ROW)), -1)
    looks = {tuple(scene.blocks[n].look for n in figure.blocks) for figure in figures}
    if at < 0 or (scene.facts[at].said == IN_A_ROW and len(looks) > 1):
        raise Unclear
    chosen = places(Figure("row", line), ranks, nth, count)
    sided = bool({"left", "right"} & set(ranks)) or scene.facts[at].said == FROM_LEFT
    scene.facts[at] = replace(scene.facts[at], said=FROM_LEFT if sided else IN_ORDER)
    return [line[n] for n in chosen]
