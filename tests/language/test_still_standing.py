"""Towers that are there at the start and beside or on which something is put, and blocks that give their place to
another: put together of the parts of such sentences, with just those ends right that they tell."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from random import Random

import pytest

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read
from tests.language.meaning import assert_means

SAMPLE = 60
"""Sentences, drawn from all there are."""
READ = 0.9
"""At least so many of them are read."""
TOWERS = {
    ("green", "red"): ("There is a tower of a red block on a green block.", "There is a stack of red on green.",
                       "There is a tower with a green block at the bottom and a red block on top."),
    ("red", "green", "pink"): ("There is a tower of red, green and pink from bottom to top.",
                               "Three blocks are stacked: red at the bottom, green in the middle, pink on top.",
                               "A tower stands on the table: red at the bottom, then green, then pink."),
}  # fmt: skip
TOPPED = ("Put a blue block on top of the tower.", "Add a blue block on top.", "Place a blue block on the tower.",
          "On top of the tower, put a blue block.", "A blue block should be on top of the tower.",
          "Stack a blue block on the tower.", "Top the tower with a blue block.")  # fmt: skip
BESIDE = ("Put a blue block next to the tower.", "Place a blue block beside the tower.", "Next to it put a blue block.",
          "A blue block should be next to the tower.", "Put a blue block right next to the tower.")  # fmt: skip
UNDER = ("Put the tower on a blue block.", "Put a blue block under the tower.", "The tower should be on a blue block.",
         "Move the tower onto a blue block.")  # fmt: skip
REPLACED = (
    "Replace the {old} block by a blue one.", "Exchange the {old} block for a blue block.",
    "Put a blue block in place of the {old} block.", "Put a blue block where the {old} block is.",
    "The {old} block should be replaced with a blue block.", "A blue block should take the place of the {old} one.",
    "Substitute a blue block for the {old} one.", "Take out the {old} block and put a blue block in its place.",
)  # fmt: skip
Case = tuple[str, dict[str, int], str, str, tuple[str, ...]]
"""A sentence, its blocks, how it begins, an end that is right, and others."""


def lasting() -> Iterator[Case]:
    """ "There is a tower of a red block on a green block. Put a blue block on top of the tower"."""
    for tower, starts in TOWERS.items():
        stack, alone = "^".join(tower), " ; ".join(tower[1:])
        begun, blocks = f"{stack} ; blue", dict.fromkeys((*tower, "blue"), 1)
        fallen = f"{'^'.join(tower[:-1])} ; {tower[-1]}^blue"
        for start, said in product(starts, TOPPED):
            yield f"{start} {said}", blocks, begun, f"{stack}^blue", (fallen, f"blue^{stack}", begun)
        for start, said in product(starts, BESIDE):
            yield f"{start} {said}", blocks, begun, f"{stack} blue", (f"{tower[0]} blue ; {alone}", begun)
        for start, said in product(starts, UNDER):
            yield f"{start} {said}", blocks, begun, f"blue^{stack}", (f"blue^{tower[0]} ; {alone}", f"{stack}^blue")


def replaced() -> Iterator[Case]:
    """ "Replace the red block by a blue one": in the tower, where it is."""
    for tower, starts in TOWERS.items():
        stack, blocks = "^".join(tower), dict.fromkeys((*tower, "blue"), 1)
        for start, said, n in product(starts, REPLACED, range(len(tower))):
            after = [*tower[:n], "blue", *tower[n + 1 :]]
            misses = (f"{stack}^blue", f"{'^'.join(reversed(after))} ; {tower[n]}", f"{stack} ; blue")
            right = f"{'^'.join(after)} ; {tower[n]}"
            yield f"{start} {said.format(old=tower[n])}", blocks, f"{stack} ; blue", right, misses


def test_just_those_ends() -> None:
    cases = [*lasting(), *replaced()]
    outcomes = []
    for said, blocks, begun, right, others in Random(0).sample(cases, SAMPLE):
        told = {"say": [said], "assets": blocks, "hold": [[begun, right]], "miss": [[begun, x] for x in others]}
        found = judge(entry("made", "standing", said, told), read)
        assert found.outcome in ("right", "refused"), f"{said}: {found.why}"
        outcomes.append(found.outcome)
    assert outcomes.count("right") >= READ * SAMPLE


@pytest.mark.parametrize("rest", ["the rest", "the others", "the other two"])
def test_what_is_left_of_a_tower_still_stands_where_it_is_spoken_of_so(rest: str) -> None:
    assert_means(
        f"There is a tower of pink on cyan on black. Take the top block off and put it to the left of {rest}.",
        {
            "assets": {"pink": 1, "cyan": 1, "black": 1},
            "hold": ["pink black^cyan"],
            "miss": ["pink cyan^black", "black^cyan pink", "black^cyan^pink"],
        },
    )
