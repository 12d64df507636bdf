"""Clauses that follow from the rest are left out where the task says so without them, and nowhere else."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.language.tokens import tokenize
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.passes.schema.nothing_more import without_more


@pytest.mark.parametrize(
    ("text", "clause"),
    [
        ("Stack red, blue and green", ", three in total"),
        ("Put two red and two blue blocks on the mat", ", two of each"),
        ("Put red, blue and green in a row", ", nothing on top of anything"),
        ("Put red, blue and green in a row", ", no tower please"),
        ("Put three cubes in a row", ", any colours are fine"),
        ("Stack red on blue and green on red", ". Blue is the bottom one"),
        ("At most two of the four red blocks should be on the mat", ", not three"),
    ],
)
def test_what_follows_changes_nothing(text: str, clause: str) -> None:
    front = BuiltinFrontEnd()
    bare, _ = front.read(text + ".")
    told, notes = front.read(f"{text}{clause}.")
    assert bare is not None
    assert told is not None, notes
    assert describe(told) == describe(bare)


@pytest.mark.parametrize(
    "text",
    [
        "Stack red, blue and green, so four in total.",
        "Put two red and three blue blocks on the mat, two of each.",
        "Stack red, blue and green, nothing on top of anything.",
        "Stack red, blue and green, no tower please.",
        "Stack red on blue and green on red. Green is the bottom one.",
        "At least two of the four red blocks should be on the mat, not three.",
        "Put red behind blue, not behind it.",
        "Put red on blue, not on top of it.",
    ],
)
def test_what_does_not_follow_is_not_left_out(text: str) -> None:
    task, _ = BuiltinFrontEnd().read(text)
    assert task is None


def test_the_rest_stands_without_what_joins_the_clause_to_it() -> None:
    tokens = tokenize("Put A on B , and nothing on top of another , then turn C .")[0]
    rest = [" ".join(token.word for token in left) for left, _ in without_more(tokens)]
    assert rest == ["put a on b , then turn c ."]
