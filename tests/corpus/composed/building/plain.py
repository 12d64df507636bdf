"""Figures told by their size, all of one colour."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.building import shapes
from tests.corpus.composed.ordering.phrased import COLORS, Meaning, count

Told = tuple[str, dict[str, str], Meaning]
"""A frame, what fills its gaps, and its meaning."""
SOME = "[blocks|cubes|blocks|bricks]"
WANT = (
    "[build|make|make me|please build|construct|I want|I'd like|form|||there should be|the goal is|lay out|create|we "
    "need|could you make|my picture shows|what I want:|goal:]"
)


def gaps(rng: Random, **numbers: int) -> dict[str, str]:
    """A colour, blocks of it, and numbers."""
    color = rng.choice(COLORS)
    said = {name: count(rng, number) if number <= 10 else str(number) for name, number in numbers.items()}
    return said | {"c": color, "bs": f"{color} {SOME}", "want": WANT}


def wall(rng: Random) -> Told:
    wide, high = rng.choice(((3, 2), (4, 2), (2, 3), (3, 3)))
    told = gaps(rng, m=wide, n=high, all=wide * high)
    unit = rng.choice(("", "", f" {SOME}"))
    size = rng.choice((
        "{m}{unit} [wide|long] and {n} [high|tall]", "{m}{unit} [wide|long], {n} [high|tall]",
        "{n}{unit} high and {m} [wide|long]", "{m} [wide|long] by {n} high",
    )).format(m=told["m"], n=told["n"], unit=unit)  # fmt: skip
    frame = rng.choice((
        "{want} a wall of {bs}, {size}", "{want} a {c} wall, {size}", "{want} a {c} wall {size}",
        "{want} a wall {size} [made of|built of|from|out of] {bs}",
        "{want} a {c} wall [that is|which is|that should be] {size}",
        f"{{want}} a {{c}} wall with a [width|length] of {{m}} {SOME} and a height of {{n}}",
        "{want} a wall of {n} [layers|rows|courses], {m} {bs} in each",
        f"{{want}} a {{c}} wall with {{n}} [layers|rows] of {{m}} {SOME} [each|]",
        f"{{want}} a {{c}} wall, {{m}} {SOME} [long|wide] and {{n}} layers high",
        "{want} a wall [of|out of|from] {all} {bs}, {m} [in each layer|per layer]",
        "{want} a wall of {bs}. It is {size}",
        f"{{want}} a wall of {{bs}}. Its [width|length] is {{m}} {SOME}, its height {{n}}",
        "{want} a {m} wide, {n} high wall of {bs}",
    ))  # fmt: skip
    other = [] if wide == high else [shapes.cuboid(1, high, wide)]
    return frame, told | {"size": size}, shapes.of_one_color(shapes.cuboid(1, wide, high), told["c"], other)


def big_cube(rng: Random) -> Told:
    told = gaps(rng, eight=8)
    told["size"] = "[two by two by two|2x2x2|2 x 2 x 2|two layers of four|two layers of two by two]"
    frame = rng.choice((
        "{want} a [big|large|solid] cube [from|out of|made of|of] {eight} {bs}[, i.e. |, that is, |, |: ]{size}",
        "{want} a [2x2x2|2 by 2 by 2|two by two by two] cube [of|made of|from] {bs}",
        "{want} a big cube of {bs}, {size}",
        f"{{want}} a big cube of {{bs}} whose edge is two {SOME} long",
    ))  # fmt: skip
    wrong = [shapes.cuboid(2, 4, 1), shapes.cuboid(1, 4, 2)]
    return frame, told, shapes.of_one_color(shapes.cuboid(2, 2, 2), told["c"], wrong)


def flat_pyramid(rng: Random) -> Told:
    base = rng.choice((2, 3, 3, 4))
    told = gaps(rng, m=base, n=base * (base + 1) // 2)
    told["down"] = "-".join(str(k) for k in range(base, 0, -1))
    told["layer"] = "[bottom row|bottom layer|base|lowest row|lowest layer]"
    frame = rng.choice((
        "{want} a [flat|] pyramid of {bs} with {m} [at the bottom|at the base|in the bottom row|in the lowest layer]",
        "{want} a pyramid [of|out of|from] {n} {bs}, {m} at the [base|bottom]",
        f"{{want}} a {{c}} pyramid whose {{layer}} is {{m}} {SOME} [long|wide]",
        f"{{want}} a {{c}} [flat|] pyramid whose {{layer}} has {{m}} {SOME}",
        f"{{want}} a {{c}} pyramid with a base of {{m}}[| {SOME}]",
        "{want} a [flat|] pyramid of {bs}, {m} [layers|levels] high",
        f"{{want}} a {{c}} pyramid. The {{layer}} has {{m}} {SOME}",
        "{want} a [flat|small|] pyramid [of|out of|using|built from] {n} {bs}", "{want} a {down} pyramid of {bs}",
    ))  # fmt: skip
    return frame, told, shapes.of_one_color(shapes.pyramid(base), told["c"], [])


def squared_pyramid(rng: Random) -> Told:
    told = gaps(rng)
    told["size"] = "[2x2|two by two|2 by 2|2 x 2]"
    frame = rng.choice((
        "{want} a square pyramid of {bs} with a {size} base", "{want} a {c} square pyramid whose base is {size}",
        "{want} a pyramid of {bs} [on|with] a square base of {size}",
        "{want} a square pyramid of {bs}, {size} at the bottom [and|,] one on top",
        f"{{want}} a {{c}} pyramid whose [bottom layer|base|lowest layer] is {{size}} [{SOME}|in size|]",
        "{want} a {size} pyramid of {bs}",
        "{want} a pyramid of {bs}. [The base|Its base|The bottom layer] is a {size} square",
    ))  # fmt: skip
    return frame, told, shapes.of_one_color(shapes.square_pyramid(2), told["c"], [shapes.cuboid(1, 5)])


def staircase(rng: Random) -> Told:
    steps, left = rng.choice((2, 3, 3, 4)), rng.random() < 0.5
    told = gaps(rng, m=steps, n=steps * (steps + 1) // 2)
    side, low = ("left", "right") if left else ("right", "left")
    told |= {"side": side, "low": low, "stair": "[staircase|staircase|flight of stairs]"}
    told["up"] = (
        f"[going up to the {side}|rising to the {side}|that goes up to the {side}|ascending to the {side}|climbing to "
        f"the {side}|which rises from the {low} to the {side}|rising from {low} to {side}|with the highest step on the "
        f"{side}|with its lowest step on the {low}|lowest on the {low}|highest on the {side}]"
    )
    frame = rng.choice((
        "{want} a {stair} of {m} steps {up}, made of {bs}", "{want} a {c} {stair} with {m} steps {up}",
        "{want} {m} steps of {bs} [going up|rising|climbing] to the {side}",
        "{want} a {m}-step {stair} of {bs} {up}", "{want} a {stair} [of|out of|from] {n} {bs} {up}",
        "{want} a {c} {stair} with {m} steps. It [goes up|rises|climbs|should go up|must rise] to the {side}",
        "{want} stairs of {bs}, {m} steps high, [rising|going up] to the {side}",
        "{want} a {stair} of {bs}, {m} steps, getting higher to the {side}",
    ))  # fmt: skip
    figure, other = shapes.stairs(steps, left=left), shapes.stairs(steps, left=not left)
    return frame, told, shapes.of_one_color(figure, told["c"], [other])


def grid(rng: Random) -> Told:
    rows, columns = rng.choice(((2, 3), (3, 2), (2, 4), (3, 4), (2, 2), (3, 3)))
    told = gaps(rng, m=rows, n=columns, all=rows * columns)
    frame = rng.choice((
        "{want} {m} rows of {n} {bs} [each|], [as a grid|forming a grid|in a grid|one row behind the other]",
        "{want} a grid of {bs} [with|of|having] {m} rows and {n} columns", "{want} a {c} grid, {m} rows by {n} columns",
        "{want} a {c} grid, [i.e.|] {m} rows of {n}",
        f"{{want}} a grid of {{bs}} with {{m}} rows, {{n}} {SOME} in [each|each row|every row]",
        "{want} {all} {bs} in {m} rows of {n}", "{want} a grid of {bs}. It has {m} rows and {n} columns",
        f"{{want}} a grid of {{bs}}: {{m}} rows with {{n}} [each|{SOME} each|in each]",
        "{want} a {c} grid, {m} rows deep and {n} columns wide",
    ))  # fmt: skip
    other = [] if rows == columns else [shapes.cuboid(columns, rows)]
    return frame, told, shapes.of_one_color(shapes.cuboid(rows, columns), told["c"], other)


def square(rng: Random) -> Told:
    told = gaps(rng, eight=8, nine=9, three=3)
    empty = (
        "[empty inside|with nothing inside|hollow|empty in the middle|just the outline|with a hole in the middle|only "
        "the border|with an empty middle|not filled]"
    )
    per_side = f"[per side|on each side|along each side|to a side|{SOME} per side]"
    outlines = (
        "{want} the outline of a square [of|made of|out of|from|with] {eight} {bs}",
        f"{{want}} [a hollow|an empty|an unfilled|an outline] square of {{bs}}, {{three}} {per_side}",
        f"{{want}} a square [of|out of] {{eight}} {{bs}}, {empty}",
        f"{{want}} a {{c}} square outline, {{three}} {SOME} [on each side|per side]",
        f"{{want}} a {{c}} square outline whose sides are {{three}} {SOME} long",
    )
    filled = (
        "{want} a filled square of {bs}, [3x3|3 by 3|three by three]",
        "{want} a [filled|solid|full] [3x3|3 by 3|three by three] square [of|made of] {bs}",
        "{want} a {c} 3x3 square, [filled|filled in|completely filled|without holes|with no hole in it]",
        "{want} a filled square of {bs}, {three} [per side|on each side|along each side]",
        "{want} a filled square [of|from|out of] {nine} {bs}",
    )
    if rng.random() < 0.5:
        wrong = shapes.of("xxxx", "xxxx")
        return rng.choice(outlines), told, shapes.of_one_color(shapes.RING, told["c"], [wrong])
    wrong = shapes.of("xxxx", "x..x", "xxx.")
    return rng.choice(filled), told, shapes.of_one_color(shapes.cuboid(3, 3), told["c"], [wrong])
