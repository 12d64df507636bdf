"""Towers that stand in a row: which one is the left one, the middle one, one of the outer two."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.places_of import places
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Unclear

IN_A_ROW, IN_ORDER, FROM_LEFT = "in a row", "in a row in this order", "in a row from the left"


def line_up(scene: Scene, ids: list[int], *, from_left: bool) -> None:
    """Towers stand in a row: their lowest blocks do. Which one is where is left open, unless told from the left."""
    figures = [scene.figures[n] for n in ids]
    if len(ids) < 2 or any(figure.kind != "tower" for figure in figures):
        raise Unclear
    for figure in figures:
        scene.settle(figure)
    scene.lines.append(list(ids))
    scene.facts.append(Fact(_lowest(figures), FROM_LEFT if from_left else IN_A_ROW))


def of_line(scene: Scene, found: list[int], ranks: tuple[str, ...], nth: int, count: int) -> list[int]:
    """Those of towers in a row that are at such places; where they look alike, any of them may be there."""
    line = next((line for line in scene.lines if set(line) == set(found)), None)
    if line is None:
        raise Unclear
    figures = [scene.figures[n] for n in line]
    lowest = _lowest(figures)
    at = next(n for n, fact in enumerate(scene.facts) if fact.a == lowest and fact.said.startswith(IN_A_ROW))
    looks = {tuple(scene.blocks[n].look for n in figure.blocks) for figure in figures}
    if scene.facts[at].said == IN_A_ROW and len(looks) > 1:
        raise Unclear
    chosen = places(Figure("row", line), ranks, nth, count)
    sided = bool({"left", "right"} & set(ranks)) or scene.facts[at].said == FROM_LEFT
    scene.facts[at] = replace(scene.facts[at], said=FROM_LEFT if sided else IN_ORDER)
    return [line[n] for n in chosen]


def _lowest(figures: list[Figure]) -> Ref:
    return Ref("block", [figure.blocks[0] for figure in figures])
