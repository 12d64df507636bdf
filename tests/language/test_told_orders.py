"""Orders of lines, put together of what is lined up, the words that do it and the end that they begin at: of all orders
of the blocks just the one that is said has to be right."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations, product
from random import Random

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 150
"""Sentences, drawn from all there are."""
READ = 0.95
"""At least so many of them are read."""
LINES = {"row": " ", "column": " | ", "tower": "^"}
"""How pictures join the blocks of a line: from left to right, from far to near, from bottom to top."""
FRAMES = (
    "Put {blocks} in a {line} {way}", "Arrange {blocks} in a {line} {way}", "Make a {line} of {blocks} {way}",
    "{blocks} form a {line} {way}", "{blocks} should be in a {line} {way}", "A {line} of {blocks} {way}",
    "Build a {line} with {blocks} {way}", "Place {blocks} in a {line}, {way}", "{blocks}, {way}, in a {line}",
    "A {line} {way}: {blocks}", "In a {line} {way}: {blocks}", "There should be a {line} of {blocks}, {way}",
    "Put {blocks} in a {line} in this order {way}",
)  # fmt: skip
WAYS = {
    "row": (("from left to right", "left to right", "starting from the left", "beginning at the left end"),
            ("from right to left", "starting on the right", "counted from the right", "from the right")),
    "column": (("from back to front", "from far to near", "beginning at the back"),
               ("from front to back", "from near to far", "starting nearest to me", "from the front")),
    "tower": (("from bottom to top", "from the bottom up", "starting at the bottom", "bottom first"),
              ("from top to bottom", "from the top down", "starting from the top", "top first")),
}  # fmt: skip
"""The words for the way along a line in which its picture goes, and those for the other way."""
SORTED = (("in alphabetical order", "in reverse alphabetical order"), ("in ascending order", "in descending order"))
Line = tuple[str, str, tuple[str, ...]]
"""The kind of a line, what is said of it, and its blocks as the picture has them."""


def listed() -> Iterator[Line]:
    """ "Put the blocks 2, 5 and 3 in a row from right to left"."""
    colors, letters, digits = ("red", "green", "blue"), ("A", "C", "B"), ("2", "5", "3")
    named = [(blocks, f"{blocks[0]}, {blocks[1]} and {blocks[2]}") for blocks in (colors, letters, digits)]
    named += [(colors, "the red, the green and the blue block"), (letters, "the blocks A, C and B"),
              (digits, "the blocks 2, 5 and 3")]  # fmt: skip
    for (blocks, words), frame, line in product(named, FRAMES, LINES):
        for against, ways in enumerate(WAYS[line]):
            order = blocks[::-1] if against else blocks
            yield from ((line, frame.format(blocks=words, line=line, way=way), order) for way in ways)


def sorted_out() -> Iterator[Line]:
    """ "Sort the letters A, C and B in reverse alphabetical order from left to right in a row"."""
    for blocks, kind, orders in ((("A", "C", "B"), "letters", SORTED[0]), (("2", "5", "3"), "digits", SORTED[1])):
        words = f"the {kind} {blocks[0]}, {blocks[1]} and {blocks[2]}"
        for (down, order), line in product(enumerate(orders), LINES):
            for against, ways in enumerate(WAYS[line]):
                rising = tuple(sorted(blocks))
                told = rising[::-1] if down != against else rising
                yield line, f"Put {words} in a {line} {order} {ways[0]}", told
                yield line, f"Sort {words} {order} {ways[0]} in a {line}", told


def test_the_order_that_is_said_and_no_other() -> None:
    lines = sorted({*listed(), *sorted_out()})
    outcomes = []
    for line, said, blocks in Random(0).sample(lines, SAMPLE):
        pictures = {order: LINES[line].join(order) for order in permutations(blocks)}
        right = pictures.pop(blocks)
        told = {"assets": dict.fromkeys(blocks, 1), "hold": [right], "miss": [*pictures.values()]}
        score = judge(entry("orders", line, said, told), read)
        assert score.outcome in ("right", "refused"), (said, score.why)
        outcomes.append(score.outcome)
    assert outcomes.count("right") >= READ * SAMPLE


WAYS_OF = {"row": ("from left to right", "from right to left"), "line": ("from back to front", "from front to back")}


def test_a_rainbow_starts_where_its_line_starts() -> None:
    for (line, ways), turned, starts in product(WAYS_OF.items(), (False, True), ("red", "yellow")):
        way = ways[turned]
        said = f"Red, orange and yellow in a {line} {way} in rainbow order, starting with {starts}."
        seen = ["red", "orange", "yellow"]
        seen = seen[::-1] if turned != (starts == "yellow") else seen
        join = " " if line == "row" else " | "
        meant = {"assets": dict.fromkeys(seen, 1), "hold": [join.join(seen)], "miss": [join.join(seen[::-1])]}
        score = judge(entry("orders", "rainbow", said, meant), read)
        assert score.outcome == "right", (said, score.why)
