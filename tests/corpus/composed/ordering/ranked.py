"""Rows, columns and towers of digits, letters, colours and sizes in their natural order."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.ordering.listed import Gaps, pictured
from tests.corpus.composed.ordering.phrased import (
    BLOCK,
    BLOCKS,
    PUT,
    RAINBOW,
    RIGHT,
    WANT,
    Meaning,
    joined,
    listed,
    once,
)

Drawn = tuple[str, Gaps, Meaning]
UP = (
    "[in ascending order|in increasing order|sorted ascending|from smallest to largest|in numeric order|in numerical "
    "order|sorted from small to large|from the smallest to the largest|from lowest to highest]"
)
DOWN = (
    "[in descending order|in decreasing order|sorted descending|from largest to smallest|from the highest to the "
    "lowest|from biggest to smallest|from high to low]"
)
ALPHA = (
    "[in alphabetical order|alphabetically|sorted alphabetically|in alphabetic order|sorted by the alphabet|in "
    "the order of the alphabet|as in the alphabet]"
)
BACKWARDS = (
    "[in reverse alphabetical order|backwards through the alphabet|sorted backwards through the alphabet|in "
    "reversed alphabetical order|against the alphabet|from last to first in the alphabet|reverse alphabetically]"
)
ROWED = (
    f"{PUT} {{the}} in a row {RIGHT} {{sorted}}",
    f"{PUT} {{the}} {{sorted}} [in a row|in a line] {RIGHT}",
    f"{{the}} {{sorted}}, in a row, {RIGHT}",
    f"{WANT} a row of {{the}}, {{sorted}}, {RIGHT}",
    f"[there are|I have] {{the}}. {PUT} them in a row, {{sorted}} {RIGHT}",
    f"{{the}} [should be|are|have to be] in a row, {{sorted}} {RIGHT}",
    f"{PUT} {{the}} in a row. [They|It|The row] should be {{sorted}} {RIGHT}",
    f"[in a row|in one row|row], {{sorted}} {RIGHT}: {{list}}",
    f"{RIGHT}, {{sorted}}: {{the}} in a row",
    f"the row of {{the}} [is|should be|must be] {{sorted}} {RIGHT}",
    f"a row {RIGHT} {{sorted}} [made of|of|consisting of|with] {{the}}",
)
NUMBERED = {
    "right": (
        "{the} in a row, [the smallest|the lowest|the smallest number|smallest] [on the left|at the left end|first "
        "from the left] [and the|, the|,] [biggest|largest|highest] [on the right|at the right end]",
        f"{PUT} {{the}} in a row [so that|such that] [the numbers|the digits|they] [increase|go up|get bigger|grow|"
        f"get larger] {RIGHT}",
        "{the} in a row, [increasing|growing|getting bigger|ascending] [to the right|from left to right|towards the "
        "right]",
        f"{RIGHT}, the row [formed by|of|made of] {{the}} [increases|goes up|ascends]",
        f"the numbers in the row [increase|go up|get bigger|rise] {RIGHT}: {{list}}",
        f"{PUT} {{the}} in a row: {{x1}} is the leftmost [and the others|, the others|and the rest] follow to its "
        f"right {UP}",
        f"{PUT} {{the}} in a row {RIGHT}, each [one|number|digit] [larger|bigger|higher|greater] than the one [to its "
        f"left|before it|before]",
    ),
    "left": (
        "{the} in a row, [the biggest|the largest|the highest number|biggest|largest] [on the left|at the left end|"
        "leftmost] [and the|, the|,] smallest [on the right|at the right end]",
        f"{PUT} {{the}} in a row [so that|such that] [the numbers|the digits|they] [decrease|go down|get smaller|"
        f"shrink] {RIGHT}",
        "{the} in a row, [decreasing|getting smaller|descending] [to the right|from left to right|towards the right]",
        f"{RIGHT}, the row [formed by|of|made of] {{the}} [decreases|goes down|descends]",
        "line up {the} so that, [going|read] from right to left, they [get bigger|go up|increase]",
        f"{PUT} {{the}} in a row {RIGHT} {DOWN}",
        f"{PUT} {{the}} in a row, {DOWN}, with {{xn}} [on the left|at the left end|leftmost]",
        f"{{the}} in a row {DOWN} {RIGHT}",
        f"count down: {{the}} in a row {RIGHT} {DOWN}",
    ),
    "back": (
        "{the} in a column [with|,] the [largest|biggest|highest] [number|] [farthest from me|farthest away|at the "
        "back] [and the|, the] smallest [nearest to me|nearest|closest to me|at the front]",
        f"{PUT} {{the}} one behind the other {UP}, the smallest [nearest to me|in front|at the front|closest to me]",
        f"{{the}} in a column {UP} from front to back",
        f"{{the}} in a column[, ascending| {UP}], {{x1}} nearest [to|] the robot",
        "put {the} in a column on the table [so that|such that] they [get bigger|increase|go up] [from front to back|"
        "towards the back|away from me]",
    ),
    "front": (
        "{the} in a column, [the largest number|the biggest number|the largest one|the highest one] [nearest to the "
        "robot|nearest to me|nearest the robot|at the front], [the|and the] smallest [farthest away|at the back]",
        f"{{the}} in a column {DOWN} from front to back",
        f"{{the}} in a column {UP} from back to front",
        f"{PUT} {{the}} one behind the other {UP}, the [largest|biggest] [nearest to me|in front|closest to me]",
    ),
    "up": (
        f"[stack|pile up] {{the}} {UP} from bottom to top",
        "[stack|pile up] {the} [with|so that] the smallest [number|digit|one|] [is|] at the bottom [and|,] the "
        "[largest|biggest|highest] [is|] [on top|at the top]",
        f"a tower of {{the}}, {UP} from [the|] bottom to [the|] top",
        "a tower of {the} [in which|where] the numbers [go up|increase|get bigger] from bottom to top",
        "a [number tower|tower of numbers|tower of digits] going up {list}",
    ),
    "down": (
        "[stack|pile up] {the} so that the [greatest|biggest|largest|highest] [one|] is [lowest|at the bottom] and "
        "the [least|smallest|lowest one] is [on top|at the top]",
        f"[stack|pile up] {{the}} {DOWN} from bottom to top",
        f"a tower of {{the}}, {UP} from [the|] top to [the|] bottom",
        "[stack|pile up] {the} [so that|such that] each number is [bigger|larger|greater|higher] than the one [on "
        "it|on top of it|above it]",
        "a tower of {the} [in which|where] each [number|digit|cube] is smaller than the one [below it|under it|it "
        "stands on]",
    ),
}
PARITY = (
    f"{{the}} in [a|one] row, [first the even [numbers|ones|digits], then the odd [ones|numbers|digits]|even before "
    f"odd|even [digits|ones] before odd [ones|digits]|the even ones first and the odd ones after them] {RIGHT}",
    f"{RIGHT} in a row: {{the}}, [even ones before odd ones|even ones first|evens first, then odds|first the evens, "
    f"then the odds]",
    f"{PUT} {{the}} in a row {RIGHT}, [the even numbers before the odd numbers|the even numbers first|with the even "
    f"numbers before the odd ones|first the even ones and then the odd ones]",
    f"{PUT} {{the}} in a row [so that|such that] all [the|] even [numbers|ones|digits] are [left of|to the left of] "
    f"all [the|] odd [ones|numbers|digits]",
    f"[we have|there are] {{the}}. [in one row|{PUT} them in a row]: even [digits|numbers] before odd [digits|ones] "
    f"{RIGHT}",
    "{the} in a row with the even [ones|numbers|digits] on the left and the odd [ones|numbers|digits] on the right",
)
PARITY_EACH = (
    f"{{the}} in [a|one] row {RIGHT}, [first the even [numbers|ones|digits], then the odd [ones|numbers|digits]|even "
    f"ones before odd ones|even ones first, then the odd ones], [each kind|both|each group|both kinds|each part|each] "
    f"{UP}",
    f"{PUT} {{the}} in a row {RIGHT}, the even numbers {UP}, [then|followed by|and then] the odd [numbers|ones] {UP}",
    f"{PUT} {{the}} in a row {RIGHT}: the even numbers before the odd numbers[,| and|, and] {UP} within each [part|"
    f"kind|group|half]",
)
VOWELS = (
    f"{{the}} in [a|one] row {RIGHT}, [vowels first|the vowels first|vowels before consonants|first the vowels, then "
    f"the consonants|the vowels before the consonants]",
    f"{PUT} {{the}} in a row {RIGHT} with the vowels [before the consonants|first|in front of the consonants]",
    f"{PUT} {{the}} in a row [so that|such that] [all the|the|all] vowels [come before|are left of|are to the left "
    f"of] [all the|the|all] consonants{{right_of_before}}",
    f"{RIGHT}: first the vowels and then the consonants, in a row, [the letters are|from the letters|out of] {{list}}",
)
RAINBOWED = (
    "{the} in a row in [rainbow order|the order of the rainbow|rainbow colo[u|]r order], {x1} [on the left|at "
    "the left end|leftmost|first on the left]",
    f"{PUT} {{the}} in a row in [rainbow order|the order of the rainbow], [starting|beginning] with {{x1}} on the left",
    f"{PUT} {{the}} in a row [like a rainbow|as a rainbow|as in a rainbow|like in a rainbow], {{x1}} [on the left|"
    f"leftmost|at the left end]",
    f"{PUT} {{the}} in a row so [that|] their colo[u|]rs form a [gradient|rainbow] [from left to right|], {{x1}} [on "
    f"the left|at the left end]",
    "the colo[u|]rs of the row [should|shall|must] follow the rainbow, [and the first [at|on the] left is|with|"
    "starting with] {x1} [on the left|]: use {list}",
    "a colo[u|]r gradient [from left to right|] in a row: {the}, {x1} [leftmost|on the left]",
    "a [rainbow|gradient] [in a row|row] [of|from|made of] {the}, {x1} [on the left|at the left end]",
    "a row of {the} in rainbow order [with|,] {x1} [leftmost|on the left|at the left end|on the far left]",
    f"[there are|I have] {{the}}. {PUT} them in a row in rainbow order, [starting with|beginning with] {{x1}} on the "
    f"left",
)
SIZED = (
    f"[a 3 cm, a 4 cm and a 5 cm|a 3 cm, a 5 cm and a 4 cm] {{a}} {BLOCK} in a row, [the|] smallest [on the left|at "
    f"the left end|leftmost] [and the|, the|,] [biggest|largest] on the right",
    f"{PUT} [a 3 cm, a 4 cm and a 5 cm {{a}} {BLOCK}|three {{a}} {BLOCKS} of 3, 4 and 5 cm|three {{a}} {BLOCKS} with "
    f"edges of 3, 4 and 5 cm|{{a}} {BLOCKS} of 3 cm, 4 cm and 5 cm] in a row [by size|sorted by size|ordered by "
    f"size], [the|] smallest [on the left|leftmost|at the left end]",
    f"three {{a}} {BLOCKS}, [one of 3 cm, one of 4 cm and one of 5 cm|of 3, 4 and 5 cm|3, 4 and 5 cm in size|with "
    f"edges of 3, 4 and 5 cm], in a row [by size|from small to large|from smallest to largest|of increasing size] "
    f"{RIGHT}",
    f"[there are|I have] three {{a}} {BLOCKS}, 3, 4 and 5 cm [in size|wide|large|big]. {PUT} them in a row [from "
    f"smallest to largest|by size, smallest first|by increasing size] {RIGHT}",
)


def _shuffled(rng: Random, order: list[str]) -> list[str]:
    found = rng.sample(order, len(order))
    return found if found not in (order, order[::-1]) else [order[1], order[0], *order[2:]]


def _gaps(rng: Random, order: list[str], noun: str, one: str) -> Gaps:
    mixed = _shuffled(rng, order)
    the = rng.choice((f"[the|] {noun} {joined(mixed)}", f"[the|] {noun} {listed(rng, mixed)}", listed(rng, mixed)))
    if rng.random() < 0.3:
        the = "the " + joined(mixed, " and the ").replace(", ", ", the ")
    return {"the": the, "list": listed(rng, mixed), "x1": f"[the|the {one}] {order[0]}", "xn": f"the {order[-1]}"}


def numbers(rng: Random) -> Drawn:
    """Digits by their value."""
    order = sorted(rng.sample("123456789", rng.choice((3, 3, 4))))
    way = rng.choice(("right", "right", "right", "left", "left", "back", "front", "up", "down"))
    gaps = _gaps(rng, order, "[digits|numbers|number cubes|digit cubes|cubes]", "[number|digit]")
    frames = NUMBERED[way]
    if way == "right" and rng.random() < 0.5:
        frames, gaps["sorted"] = ROWED, UP
    if frames[-1].endswith("{list}"):
        gaps["list"] = listed(rng, order)
    shown = order[::-1] if way in ("left", "front", "down") else order
    way = {"left": "right", "front": "back", "down": "up"}.get(way, way)
    return rng.choice(frames), gaps, _meaning(way, shown)


def letters(rng: Random) -> Drawn:
    """Letters by the alphabet, either way."""
    order = sorted(rng.sample("ABCDEFGHKLMNPRSTUVXZ", rng.choice((3, 4))))
    gaps = _gaps(rng, order, "[letters|letter cubes|cubes]", "letter")
    backwards = rng.random() < 0.35
    gaps["sorted"] = BACKWARDS if backwards else ALPHA
    return rng.choice(ROWED), gaps, _meaning("right", order[::-1] if backwards else order)


def kinds(rng: Random) -> Drawn:
    """Even before odd, vowels before consonants."""
    if rng.random() < 0.3:
        v, w, c, d = *rng.sample("AEIOU", 2), *rng.sample("BDKMRST", 2)
        gaps = _gaps(rng, [v, c, w, d], "[letters|letter cubes]", "letter") | {"right_of_before": f" {RIGHT}"}
        hold = [f"{v} {w} {c} {d}", f"{w} {v} {d} {c}"]
        return (
            rng.choice(VOWELS),
            gaps,
            {"assets": once([v, w, c, d]), "hold": hold, "miss": [f"{c} {d} {v} {w}", f"{v} {c} {w} {d}"]},
        )
    a, b = sorted(rng.sample("2468", 2))
    c, d = sorted(rng.sample("13579", 2))
    gaps = _gaps(rng, [a, c, b, d], "[digits|numbers|number cubes]", "digit")
    wrong = [f"{c} {d} {a} {b}", f"{a} {c} {b} {d}"]
    assets = once([a, b, c, d])
    if rng.random() < 0.3:
        return (
            rng.choice(PARITY_EACH),
            gaps,
            {"assets": assets, "hold": [f"{a} {b} {c} {d}"], "miss": [*wrong, f"{b} {a} {c} {d}"]},
        )
    return rng.choice(PARITY), gaps, {"assets": assets, "hold": [f"{a} {b} {c} {d}", f"{b} {a} {d} {c}"], "miss": wrong}


def colors(rng: Random) -> Drawn:
    """A rainbow."""
    order = sorted(rng.sample(RAINBOW, rng.choice((4, 5))), key=RAINBOW.index)
    if rng.random() < 0.3:
        order.reverse()
    mixed = _shuffled(rng, order)
    the = rng.choice(
        (
            f"the {joined(mixed)} {BLOCK}",
            f"[the|] {joined(mixed)} {BLOCKS}",
            joined(mixed),
            "a " + joined(mixed, " and a ").replace(", ", ", a ") + f" {BLOCK}",
        )
    )
    gaps = {
        "the": the.replace("a orange", "an orange"),
        "list": joined(mixed),
        "x1": f"[{order[0]}|{order[0]}|the {order[0]} one]",
    }
    return rng.choice(RAINBOWED), gaps, _meaning("right", order)


def sizes(rng: Random) -> Drawn:
    """Three sizes of one colour."""
    a = rng.choice(RAINBOW)
    row = [f"{a}{{3}}", a, f"{a}{{5}}"]
    return rng.choice(SIZED), {"a": a}, _meaning("right", row)


def _meaning(way: str, order: list[str]) -> Meaning:
    miss = [pictured(way, order[::-1]), pictured(way, [order[1], order[0], *order[2:]])]
    return {"assets": once(order), "hold": [pictured(way, order)], "miss": miss}
