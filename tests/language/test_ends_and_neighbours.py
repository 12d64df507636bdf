"""Lines of which only some is said, "red is at one end and not next to blue": of all orders of the blocks those are
right that agree with what is said, and no others. A fact says it here with what it lets stand, apart from the
grammar."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations
from random import Random

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 100
"""Sentences, drawn at random."""
READ = 0.9
"""At least so many of them are read."""
COLORS = ("red", "blue", "green", "yellow", "white", "orange")
LINES = {"row": (" ", "left", "right"), "column": (" | ", "far", "near"), "tower": ("^", "bottom", "top")}
"""How pictures join the blocks of a line, and its two ends in the order of pictures."""
BEFORE = {
    "row": ("to the left of", "to the right of"),
    "column": ("behind", "in front of"),
    "tower": ("below", "above"),
}
FRAMES = (
    "Put {blocks} in a {line}", "Make a {line} of {blocks}", "{blocks} should be in a {line}",
    "Build a {line} from {blocks}", "There should be a {line} of {blocks}", "Arrange {blocks} in a {line}",
    "{blocks} form a {line}",
)  # fmt: skip
Order = tuple[str, ...]
Fact = tuple[str, Callable[[Order], bool]]


def facts(line: str, blocks: Order, rng: Random) -> list[Fact]:
    """What can be said of two or three of the blocks, with the orders that it lets stand."""
    a, b, c = rng.sample(blocks, 3)
    one, two, three = (f"the {color} {rng.choice(('block', 'cube', 'one'))}" for color in (a, b, c))
    must = rng.choice(("must be", "should be", "has to be"))
    first, last = (end if line == "tower" else f"{end} end" for end in LINES[line][1:])
    before, behind = BEFORE[line]
    found: list[Fact] = [
        (f"{one} {must} somewhere {before} {two}", lambda o: o.index(a) < o.index(b)),
        (f"{one} {must} somewhere {behind} {two}", lambda o: o.index(a) > o.index(b)),
        (f"{one} {must} at the {first}", lambda o: o[0] == a),
        (f"{one} {must} at the {last}", lambda o: o[-1] == a),
        (f"{one} must not be at the {first}", lambda o: o[0] != a),
        (f"{one} must not be at the {last}", lambda o: o[-1] != a),
        (f"{one} or {two} {must} at the {first}", lambda o: o[0] in (a, b)),
        (f"{one} {must} somewhere between {two} and {three}", lambda o: _amid(o.index(b), o.index(a), o.index(c))),
        (f"there {must} exactly one block between {one} and {two}", lambda o: abs(o.index(a) - o.index(b)) == 2),
    ]
    if line == "tower":
        found += [
            (f"{one} {must} directly above {two}", lambda o: o.index(a) == o.index(b) + 1),
            (f"{one} {must} directly below {two}", lambda o: o.index(a) + 1 == o.index(b)),
            (f"{one} {must} lower than {two}", lambda o: o.index(a) < o.index(b)),
            (f"{one} must be neither at the top nor at the bottom", lambda o: a not in (o[0], o[-1])),
        ]
    else:
        found += [
            (f"{one} {must} next to {two}", lambda o: abs(o.index(a) - o.index(b)) == 1),
            (f"{one} must not be next to {two}", lambda o: abs(o.index(a) - o.index(b)) != 1),
            (f"{one} {must} at one end", lambda o: a in (o[0], o[-1])),
            (f"{one} must not be at either end", lambda o: a not in (o[0], o[-1])),
            (f"neither {one} nor {two} {must} at an end", lambda o: not {a, b} & {o[0], o[-1]}),
            (f"{one} and {two} {must} at the ends", lambda o: {o[0], o[-1]} == {a, b}),
        ]
    return found


def _amid(one: int, inside: int, other: int) -> bool:
    return min(one, other) < inside < max(one, other)


def told(rng: Random) -> tuple[str, list[str], list[str]]:
    """A text with the pictures that it is to hold in, and those in which it is not."""
    line = rng.choice(list(LINES))
    blocks = tuple(rng.sample(COLORS, rng.choice((3, 4))))
    while True:
        said = [rng.choice(facts(line, blocks, rng)) for _ in range(rng.choice((1, 2)))]
        right = [order for order in permutations(blocks) if all(holds(order) for _, holds in said)]
        if right:
            break
    named = f"the {', '.join(blocks[:-1])} and {blocks[-1]} blocks"
    begun = rng.choice(FRAMES).format(line=line, blocks=named)
    text = ". ".join(part[0].upper() + part[1:] for part in (begun, *(fact for fact, _ in said)))
    draw = LINES[line][0].join
    return text, [draw(o) for o in right], [draw(o) for o in permutations(blocks) if o not in right]


def test_the_orders_that_agree_and_no_others() -> None:
    rng = Random(0)
    outcomes = []
    for _ in range(SAMPLE):
        text, right, wrong = told(rng)
        colors = [color for color in COLORS if color in right[0]]
        expected = {"assets": dict.fromkeys(colors, 1), "hold": right, "miss": wrong}
        score = judge(entry("orders", "ends", text, expected), read)
        assert score.outcome in ("right", "refused"), (text, score.why)
        outcomes.append(score.outcome)
    assert outcomes.count("right") >= READ * SAMPLE
