"""Towers that stand in a row, a column or a grid: which one is the left one, the middle one, one of the outer two."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise, permutations
from math import factorial, isqrt, prod

from rpg.blocks.nouns import number
from rpg.blocks.symmetry import MAX_NAMINGS
from rpg.language.compose.places_of import places
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun

IN_A_ROW, IN_ORDER, FROM_LEFT = "in a row", "in a row in this order", "in a row from the left"
IN_ROW_NEXT = "next in the row to"
"""What a tower in a row is to the next one, near it."""
_MOST_IN_LINE = 6
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


def put_in_line(scene: Scene, ref: Ref, told: tuple[tuple[str, str], ...]) -> None:
    """ "The tallest in the middle", "the shortest on the left and the tallest on the right": which one is where.

    Raises Unclear where several orders would do, but for one and the same from the left or from the right.
    """
    lowest = feet(scene, ref)
    at = next((n for n, fact in enumerate(scene.facts) if fact.a.ids == lowest and fact.said == IN_A_ROW), -1)
    if at < 0 or len(lowest) > _MOST_IN_LINE:
        raise Unclear
    towers = {n: next((f.blocks for f in scene.figures if n in f.blocks), [n]) for n in lowest}
    heights = [len(blocks) for blocks in towers.values()]
    best = {"tall": max(heights), "short": min(heights)}
    where = {"left": 0, "right": len(lowest) - 1, "middle": len(lowest) // 2}
    if any(heights.count(best[rank]) > 1 for rank, _ in told) or (
        len(lowest) % 2 == 0 and "middle" in dict(told).values()
    ):
        raise Unclear
    orders = {
        tuple(tuple(scene.blocks[m].look[:2] for m in towers[n]) for n in order): list(order)
        for order in permutations(lowest)
        if all(len(towers[order[where[side]]]) == best[rank] for rank, side in told)
    }
    sided = {side for _, side in told} != {"middle"}
    first = next(iter(orders), ())
    if not orders or len(orders) > (1 if sided else 2) or (len(orders) == 2 and first[::-1] not in orders):
        raise Unclear
    ways = list(orders.values())
    if len(ways) > 1 and many_alike(scene, ways[0]):
        ways, sided = [ways[scene.choose(2)]], True  # told from the left, the one way or the other
    scene.facts[at] = replace(scene.facts[at], a=Ref("block", ways[0]), said=FROM_LEFT if sided else IN_ORDER)


def many_alike(scene: Scene, lowest: list[int]) -> bool:
    """Whether there are too many ways to tell the lowest block of each tower from others that look alike."""
    looks: dict[tuple[str, str], list[int]] = {}
    for n, block in enumerate(scene.blocks):
        looks.setdefault((block.color, block.label), []).append(n)
    ways = 1
    for lot in looks.values():
        if not set(lot) & set(lowest):
            continue
        rests = [len([n for n in f.blocks[1:] if n in lot]) for f in scene.figures if f.blocks[0] in lowest]
        ways *= factorial(len(lot)) // prod(map(factorial, rests))
    return ways > MAX_NAMINGS


def told_by_neighbours(scene: Scene) -> None:
    """Towers in a row from the left of which many blocks look alike are told by what each one is to the left of."""
    for fact in [fact for fact in scene.facts if fact.said in {FROM_LEFT, IN_ORDER}]:
        towers = [next((k for k, f in enumerate(scene.figures) if f.blocks[0] == n), -1) for n in fact.a.ids]
        looks = [tuple(scene.blocks[n].look for n in scene.figures[k].blocks) for k in towers]
        if -1 in towers or not many_alike(scene, fact.a.ids) or (fact.said == IN_ORDER and looks != looks[::-1]):
            continue
        for figure in (scene.figures[k] for k in towers):
            figure.told &= not scene.alike(figure.blocks)
        at = scene.facts.index(fact)
        pairs = pairwise(towers)
        scene.facts[at : at + 1] = [Fact(Ref("figure", [a]), IN_ROW_NEXT, Ref("figure", [b])) for a, b in pairs]


def from_left(scene: Scene, line: list[int]) -> None:
    """Towers in a row are told from the left; where they do not look alike, which one is where has to be known."""
    of_line(scene, line, ("left",), 1, 0)


def of_line(scene: Scene, found: list[int], ranks: tuple[str, ...], nth: int, count: int) -> list[int]:
    """Those of towers in a row that are at such places; where they look alike, any of them may be there."""
    line = next((line for line in scene.lines if set(line) == set(found)), None)
    if line is None:
        raise Unclear
    figures = [scene.figures[n] for n in line]
    lowest = Ref("block", [figure.blocks[0] for figure in figures])
    at = next((n for n, fact in enumerate(scene.facts) if fact.a == lowest and fact.said.startswith(IN_A_ROW)), -1)
    looks = {tuple(scene.blocks[n].look[:2] for n in figure.blocks) for figure in figures}
    if at < 0 or (scene.facts[at].said == IN_A_ROW and len(looks) > 1):
        raise Unclear
    chosen = places(Figure("row", line), ranks, nth, count)
    sided = bool({"left", "right"} & set(ranks)) or scene.facts[at].said == FROM_LEFT
    scene.facts[at] = replace(scene.facts[at], said=FROM_LEFT if sided else IN_ORDER)
    return [line[n] for n in chosen]
