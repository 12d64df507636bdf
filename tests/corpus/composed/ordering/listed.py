"""Rows, columns and towers whose blocks are listed, and blocks told by their places in them."""

from __future__ import annotations

from random import Random

from tests.corpus.composed.ordering.phrased import (
    BLOCK,
    BLOCKS,
    COLORS,
    PUT,
    RIGHT,
    WANT,
    Meaning,
    joined,
    listed,
    once,
)

Gaps = dict[str, str]
_KINDS = ("colors", "colors", "letters", "digits")
WAYS: dict[str, tuple[str, ...]] = {
    "right": (
        f"{PUT} {{the_shuffled}} in a row {RIGHT} [in the order|in this order:|like this:|as] {{list}}",
        f"{PUT} {{the_list}} [in a row|in a line|side by side], {RIGHT}",
        f"{PUT} {{the_list}} in a row in [this|that] order, {RIGHT}",
        f"in a row {RIGHT}: {{list}}",
        f"{{list}} [in a row|in a line|side by side] {RIGHT}",
        f"a row that [reads|goes|is|says] {{list}} {RIGHT}",
        "[make|build|lay] a row [which|that] [starts|begins] with {x1} on the left, [followed by|then comes|then] "
        "{rest}",
        "[there should be|I want|make] a row [beginning|starting] with {x1} [at the left end|on the left|at the left],"
        " [followed by|then] {rest}",
        "the row [starts|begins] with {x1} [on the left|at the left end], [followed by|and goes on with] {rest}",
        f"{WANT} a row with {{x1}} on the [far left|left|left end], [then|followed by|next to it] {{rest}}",
        f"{WANT} a row: {{x1}} first [on|from] the left, then {{rest}}",
        "{X1} is [the leftmost|the first on the left|first from the left|on the far left], then [comes|follows] {rest},"
        " [all in a row|in one row|in a single row]",
        "[lined up|in line|in a row] {right} - {list}",
        "{the_list} [should be|are|have to be|shall be] [arranged|lined up|placed|standing] in a row,"
        f" [in this order|in that order|in the order named], {RIGHT}",
        "[the blocks in|the members of] the row are to be, in this order and starting on the left: {list}",
        f"the row, when [read|seen|viewed] {RIGHT}, is {{list}}",
        f"{WANT} a row of {{the_shuffled}} such that {{x1}} [comes|is] first from the left, then {{rest}}",
        f"a row [running|going|reading] {{list}} {RIGHT}",
        f"[I have|there are|we have] {{a_shuffled}}. {PUT} them in a row, {{list}} {RIGHT}",
        f"[I have|there are|you have] {{a_shuffled}}. The row [should be|must be|has to be|is] {{list}} {RIGHT}",
        f"{PUT} {{the_shuffled}} in a row. {RIGHT}[,|] [it|they] should [be|read] {{list}}",
        f"could you [put|line up|arrange] {{the_list}} in a row, [{RIGHT}|going from left to right]?",
        f"{RIGHT}[,|:| I want|, I'd like] {{list}} [, all in a row|in a row|in one line]",
    ),
    "left": (
        "a row [that reads|going|of] {list} from right to left",
        "{the_list} [in a row|lined up] [from right to left|right to left|starting on the right|, starting from the "
        "right]",
        "put {the_shuffled} in a row: {x1} [at the right end|on the far right|rightmost], then {rest} [to the left|"
        "going left]",
        "a row with {x1} [on the far right|at the right end], then {x2} to its left, then {x3} [to the left of that|]",
        "the row [starts|begins] on the right with {x1}, then {rest}",
    ),
    "back": (
        "{the_list} [in a column|one behind the other|one behind another|one after the other] [from front to back|"
        "front to back]",
        "[put|place|line up] {the_shuffled} one behind the other [with|, with] {x1} [nearest to me|closest to me|"
        "nearest|at the front]",
        "first {x1}, [which is closest to me|the nearest to me|nearest to me], then {x2}, [then|and] {x3} [is|] the "
        "[farthest|furthest]"
        " [away|], [in a column|all in one line]",
        "[make|build] a column on the table: {x1} [nearest to me|at the front|in front], then {x2}, and {x3} [at the "
        "back|farthest away]",
        "{X1} is [nearest to me|closest to me|at the front], then comes {x2}, and {x3} is [farthest away|at the back],"
        " [all in one straight line|in one column|in a line]",
        "a column on the table [with|, with] {x1} [at the front|nearest to me], then {x2}, [and|then] {x3} at the back",
        "[make|lay] a column on the table that [starts|begins] with {x1} [nearest to me|at the front], [goes on|"
        "continues] with {x2} and"
        " ends with {x3} [farthest away|at the back]",
        "[queue up|line up] {the_list} one behind the other, [with {x1} in front|{x1} in front|with {x1} nearest to "
        "me]",
        "{the_list} [should|are to|shall] form a column [running|going|] from front to back",
        "on the table a column [from front to back|going from front to back]: {list}",
        "{X1} in front, {x2} behind it, {x3} behind that, [in one column|all in one line|in a straight line]",
        "in the column on the table {x1} is [the nearest to me|nearest|at the front], {x2} in the middle and {x3} "
        "[farthest away|at the back]",
    ),
    "up": (
        "a tower [of|with] {list} from bottom to top",
        "a tower [with|, with], from bottom to top, {list}",
        "[stack|pile up] {the_list} from bottom to top",
        "[stack|pile up] {the_list} in [this|that] order, {x1} [at the bottom|lowest|first]",
        "{X1} [at the bottom|is at the bottom|goes at the bottom], then {x2}, [then|and] {x3} [on top|at the top|at "
        "the very top], in one tower",
        "[make|build|I want] a tower: {x1} at the bottom, on that {x2}, on that {x3}",
        "from bottom to top [I want|I'd like|: |build] {list}, all in one [stack|tower]",
        "[make|build] a tower [which|that] [starts|begins] with {x1} at the bottom, [then has|followed by] {rest}",
        "in the tower, [which reads from bottom to top|read from bottom to top|from bottom to top], [are|we see] "
        "{list}",
        "[the tower is|the tower should be|the stack should be] {list} from [bottom to top|the bottom up|the bottom "
        "to the top]",
        "{list}, stacked [in that order|in this order], {x1} [lowest|at the bottom|being the lowest]",
        "stack with {x1} at the bottom, {x2} in the middle and {x3} [on top|at the top]",
        "[put|place] {x1} on the table, then {x2} on it, then {x3} on that",
        "[there are|I have] {a_shuffled}. [stack|pile] them [with|so that] {x1} [at the bottom|lowest], {x2} [in the "
        "middle|second] and {x3}"
        " on top",
        "when the tower is [read|seen] from bottom to top, [it reads|it is|you see] {list}",
    ),
    "down": (
        "a tower [of|with] {list} from top to bottom",
        "[stack|pile up] {the_list} from top to bottom",
        "[the tower is|the stack should be] {list} from [top to bottom|the top down|the top to the bottom]",
        "{X1} on top, {x2} [under it|below it|in the middle], {x3} [at the bottom|at the very bottom], all in one "
        "tower",
        "a stack that, read from top to bottom, [is|says|goes] {list}",
    ),
}


def _named(kind: str, look: str, style: int) -> str:
    noun = {"colors": BLOCK, "letters": "[cube|letter|letter]", "digits": "[digit|number|cube]"}[kind]
    if kind == "colors":
        return (look, f"the {look} {noun}", f"the {look} one", look)[style]
    first = {"letters": "letter", "digits": "digit"}[kind]
    return (look, f"the {look}", f"the {first} {look}", f"the {look}")[style]


def looks(rng: Random, kind: str, number: int) -> list[str]:
    """Blocks of one kind, in no order."""
    return rng.sample({"colors": COLORS, "letters": "ABCDEFGHKLMNPRSTUVXZ", "digits": "123456789"}[kind], number)


def gaps_for(rng: Random, kind: str, order: list[str]) -> Gaps:
    """Ways of naming blocks of one kind, alone and in lists."""
    style = rng.randrange(4)
    names = [_named(kind, look, style) for look in order]
    noun = {"colors": BLOCKS, "letters": "[letters|letter cubes]", "digits": "[digits|number cubes|numbers]"}[kind]
    shuffled = rng.sample(order, len(order))
    if kind == "colors":
        the_list = rng.choice(
            (f"the {joined(order)} {BLOCK}", f"[the|] {joined(order)} [{BLOCKS}|]", listed(rng, names))
        )
        the_shuffled = f"the {joined(shuffled)} {BLOCK}"
        a_shuffled = "a " + joined(shuffled, " and a ").replace(", ", ", a ") + f" {BLOCK}"
    else:
        the_list = rng.choice((f"[the|] {noun} {joined(order)}", listed(rng, names)))
        the_shuffled = f"the {noun} {joined(shuffled)}"
        a_shuffled = f"the {noun} {joined(shuffled)}"
    gaps = {f"x{i + 1}": name for i, name in enumerate(names)}
    return gaps | {
        "X1": names[0],
        "list": rng.choice((joined(order), joined(order, ", "), listed(rng, names))),
        "the_list": the_list,
        "the_shuffled": the_shuffled,
        "a_shuffled": a_shuffled,
        "rest": rng.choice((joined(names[1:]), joined(names[1:], ", then "), joined(names[1:], " and then "))),
        "right": RIGHT,
    }


def pictured(way: str, order: list[str]) -> str:
    """The state that shows blocks in that order."""
    match way:
        case "right":
            return " ".join(order)
        case "left":
            return " ".join(reversed(order))
        case "back":
            return " | ".join(reversed(order))
        case "up":
            return "^".join(order)
    return "^".join(reversed(order))


def lists(rng: Random) -> tuple[str, Gaps, Meaning]:
    """Blocks listed in the order in which they are to stand."""
    way = rng.choice(("right", "right", "right", "left", "back", "back", "up", "up", "down"))
    kind = rng.choice(_KINDS)
    order = looks(rng, kind, 3 if way != "right" else rng.choice((3, 3, 4)))
    swapped = [order[1], order[0], *order[2:]]
    miss = [pictured(way, order[::-1]), pictured(way, swapped)]
    return (
        rng.choice(WAYS[way]),
        gaps_for(rng, kind, order),
        {
            "assets": once(order),
            "hold": [pictured(way, order)],
            "miss": miss,
        },
    )
