"""Two towers by where they stand, and several by their heights: put together of the parts of such sentences, with just
those states right that they tell."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from random import Random

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 60
"""Sentences, drawn from all there are."""
READ = 0.9
"""At least so many of them are read."""
TOWERS = (
    ("a tower of two red blocks", "a tower of three blue blocks"), ("a red tower of two", "a blue tower of three"),
    ("a stack of two red cubes", "a stack of three blue cubes"), ("a two-block red tower", "a three-block blue tower"),
)  # fmt: skip
SIDES = {
    "left of": "{a} . . {b}",
    "right of": "{b} . . {a}",
    "behind": "{a} | . | . | {b}",
    "in front of": "{b} | . | . | {a}",
}
"""How the first of two towers stands to the second, and pictures of it."""
BESIDE = (
    "Build {a} {side} {b}", "{a} stands {side} {b}", "{a} should be {side} {b}", "There is {a} {side} {b}",
    "{side} {b} there is {a}", "{b}, and {side} it {a}", "Build {b}. {side} it, build {a}",
    "Build {a} and {b}. The red tower is {side} the blue tower",
    "Build {a} and {b} such that the red tower is {side} the blue one",
)  # fmt: skip
HEIGHTS = (
    "Build towers of {heights} red blocks from {way}", "{many} red towers of heights {heights} from {way}",
    "Stack {all} red blocks into {many} towers of {heights} blocks from {way}",
    "{many} towers of red blocks. From {way} they have {heights} blocks",
    "Build {many} red towers. Their heights from {way} are {heights}",
    "From {way}, the {many} red towers have {heights} blocks",
)  # fmt: skip
WORDS = ("no", "one", "two", "three", "four", "five", "six")
Case = tuple[str, dict[str, int], str, tuple[str, ...]]
"""A sentence, its blocks, the picture that is right, and others."""


def beside() -> Iterator[Case]:
    """ "Build a tower of two red blocks left of a tower of three blue blocks"."""
    good, mixed = {"a": "red^red", "b": "blue^blue^blue"}, {"a": "red^blue", "b": "blue^blue^red"}
    for (a, b), frame, side in product(TOWERS, BESIDE, SIDES):
        said = frame.format(a=a, b=b, side=side)
        wrong = [picture.format(**good) for other, picture in SIDES.items() if other != side]
        misses = (*wrong, SIDES[side].format(**mixed), "red^red^blue^blue^blue", "red red . . blue blue blue")
        yield said, {"red": 2, "blue": 3}, SIDES[side].format(**good), misses


def by_height() -> Iterator[Case]:
    """ "Three red towers of heights 3, 1 and 2 from left to right"."""
    for heights, frame, words in product(((2, 3), (3, 2, 1), (1, 3, 2)), HEIGHTS, (True, False)):
        told = [WORDS[n] if words else str(n) for n in heights]
        listed = f"{', '.join(told[:-1])} and {told[-1]}"
        for way, order in (("left to right", heights), ("right to left", heights[::-1])):
            said = frame.format(heights=listed, way=way, many=WORDS[len(heights)], all=WORDS[sum(heights)])
            row, back = (" . . ".join("^".join(["red"] * n) for n in x) for x in (order, order[::-1]))
            yield said, {"red": sum(heights)}, row, (back, "^".join(["red"] * sum(heights)))


def test_just_those_towers() -> None:
    cases = [*beside(), *by_height()]
    outcomes = []
    for said, assets, right, others in Random(0).sample(cases, SAMPLE):
        text = said[0].upper() + said[1:] + "."
        score = judge(entry("towers", "told", text, {"assets": assets, "hold": [right], "miss": [*others]}), read)
        assert score.outcome in ("right", "refused"), (text, score.why)
        outcomes.append(score.outcome)
    assert outcomes.count("right") >= READ * SAMPLE
