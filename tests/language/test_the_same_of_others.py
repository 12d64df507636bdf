"""What is said again of others: "nor is", "as are", "too"; how many "the other two" make; one of two on the other."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end

NOT = "The red block must not touch the green block. The blue block must not touch the green block."
PAIRS = "The A block must be next to the B block. The C block must be next to the D block."
LEFT = "The A block must be to the left of the B block. The C block must be to the left of the B block."


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("The red block does not touch the green one, nor does the blue one.", NOT),
        ("The red block must not touch the green one, and neither must the blue one.", NOT),
        ("A and B are next to each other, as are C and D.", PAIRS),
        ("A and B are next to each other, C and D too.", PAIRS),
        ("A is left of B, as is C.", LEFT),
        ("A is left of B, C as well.", LEFT),
        ("A is left of B, and C too.", LEFT),
    ],
)
def test_the_same_is_said_of_others(text: str, end: str) -> None:
    assert start_and_end(text)[1].rstrip(".") == end.rstrip(".")


@pytest.mark.parametrize(
    "text",
    ["A is left of B and C too.", "two red and two blue blocks: the red ones touch each other and the blue ones too"],
)
def test_without_a_comma_it_may_be_what_the_others_are_next_to(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("One red block is on the left, the other on the right.",
         "A red block must be to the left of the other red block."),
        ("Put one block on the red mat and the other two on the blue one.",
         "A red block must be on the red patch. The other two red blocks must be on the blue patch."),
        ("Put two red blocks on the mat and the other one on the table.",
         "Two red blocks must be on the gray patch. The other red block must be on the table."),
    ],
)  # fmt: skip
def test_the_other_ones_are_like_those_before(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


@pytest.mark.parametrize(
    "text",
    ["The red block is on the mat, the other is not.", "Put two red blocks on the mat and the others on the table."],
)
def test_it_is_not_said_which_others(text: str) -> None:
    assert code_of(text) == "no-referent"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("There are two blocks, A and B; put one on top of the other.",
         "The A block must be on the B block or the B block must be on the A block."),
        ("Two blocks, one red and one blue. One is left of the other.",
         "The red block must be to the left of the blue block or the blue block must be to the left of the red block."),
    ],
)  # fmt: skip
def test_one_of_two_stands_so_to_the_other(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


def test_one_of_three_is_not_clear() -> None:
    assert code_of("There are three blocks, A, B and C. Put one on the other.") == "ambiguous"
