"""What stands right behind a part: a place of the second of two blocks, "touching", "10 cm apart"; a tower that is told
and then taken apart."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Put A left of B and C right of D",
         "The A block must be to the left of the B block. The C block must be to the right of the D block."),
        ("A in front of 1 and B behind 2",
         "The A block must be in front of the 1 block. The B block must be behind the 2 block."),
        ("A behind B and C 5 cm left of D",
         "The A block must be behind the B block. The C block must be to the left of the D block. The C block must be "
         "5 cm from the D block."),
        ("Put A left of B and C, in front of D",
         "The A block must be to the left of the blocks B and C. The A block must be in front of the D block."),
        ("Put A left of both B and C behind D",
         "The A block must be to the left of the blocks B and C. The A block must be behind the D block."),
        ("Put A between B and C in front of D",
         "The A block must be between the B block and the C block. The A block must be in front of the D block."),
    ],
)  # fmt: skip
def test_a_place_right_behind_the_second_of_two_is_its_own(text: str, end: str) -> None:
    assert start_and_end(text)[1].rstrip(".") == end.rstrip(".")


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("red on blue, green next to it, touching", "The green block must touch the blue block."),
        ("Build a tower of three red blocks and put the blue one next to it, touching.",
         "The blue block must touch the tower of the three red blocks."),
        ("red on blue, green next to it, 5 cm apart", "The green block must be 5 cm from the blue block."),
    ],
)  # fmt: skip
def test_touching_what_it_is_put_next_to(text: str, end: str) -> None:
    assert start_and_end(text)[1].endswith(end)


def test_so_far_apart_behind_two_groups_is_of_the_groups() -> None:
    told = means("three red blocks in a pile and three blue ones in a pile, at least 15 cm apart").replace("\n", " ")
    assert told.endswith("The three blue blocks must be at least 15 cm from the three red blocks.")


@pytest.mark.parametrize(
    "text",
    ["three red blocks in a row and three blue ones in a row behind it, 10 cm apart",
     "a row of three red blocks and behind it a row of three blue ones, touching"],
)  # fmt: skip
def test_behind_two_rows_it_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    ("text", "start"),
    [
        ("A tower of red on blue. Put the red block on the table.",
         "At the start, the red and blue blocks are stacked from top to bottom in the order red, blue"),
        ("Two towers, A on B and C on D. Put A on C.",
         "At the start, the blocks A and B are stacked from top to bottom in the order A, B. At the start, the blocks "
         "C and D are stacked from top to bottom in the order C, D"),
        ("Red on blue and green on yellow. Swap red and green.",
         "At the start, the red block is on the blue block. At the start, the green block is on the yellow block"),
    ],
)  # fmt: skip
def test_what_is_not_so_any_more_is_how_it_starts(text: str, start: str) -> None:
    assert start_and_end(text)[0] == start


@pytest.mark.parametrize(
    "text",
    ["Build a tower of A, B and C from bottom to top. Put C on D.",
     "Build a tower of A, B and C from bottom to top. Put D on A.",
     "Put red on blue and green on yellow. Swap red and green."],
)  # fmt: skip
def test_what_is_built_cannot_lie_elsewhere(text: str) -> None:
    assert code_of(text) == "contradiction"
