"""Several structures, and what each of them has: "a tower of A and B and one of C and D", "groups of one red and one
blue"."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Stack four red and blue blocks, alternating.",
        "Build a tower of three red and blue blocks.",
        "Arrange six red, blue and green blocks in a row.",
    ],
)
def test_a_number_of_several_colors_is_not_that_of_the_first(text: str) -> None:
    assert code_of(text) in ("ambiguous", "count-mismatch")


def test_a_number_for_each_color_is_read() -> None:
    assert "three red blocks and a blue block" in means("Build a tower of three red blocks and a blue block.")
    assert "two red blocks, a blue block and three green" in means("Stack two red, one blue and three green blocks.")


@pytest.mark.parametrize("joined", ["and one", ", and one", "and next to it one", "and another"])
def test_one_of_c_and_d_is_one_more_tower(joined: str) -> None:
    told = means(f"There is a tower of A and B {joined} of C and D. Put A on D.")
    assert "At the start, the blocks A and B form a tower of exactly two." in told
    assert "At the start, the blocks C and D form a tower of exactly two." in told


def test_one_more_tower_is_built_where_the_first_one_is() -> None:
    told = means("Put a tower of A and B and one of C and D on the patch.")
    assert "The blocks C and D must form a tower of exactly two. The blocks A to D must be on the gray patch." in told


def test_one_of_the_blocks_is_one_of_them() -> None:
    for text in ("Build a tower of A and B and put one of C and D on the patch.",
                 "Put A and B and one of C and D on the patch."):  # fmt: skip
        assert "Exactly one of the blocks C and D must be on the gray patch." in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Put three red and three blue blocks in groups of one red and one blue.",
        "Sort three red and three blue blocks into groups of one red and one blue block.",
        "Put three red and three blue blocks in groups of a red and a blue block each.",
    ],
)
def test_groups_have_what_is_told_of_each(text: str) -> None:
    assert "A red block and a blue block must be in one group, another red block and another blue block" in means(text)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put two red and four blue blocks in two groups, each with one red block.", "count-mismatch"),
        ("Put two red, two blue and two green blocks in groups of three.", "count-mismatch"),
        ("Put four red and four blue blocks in pairs.", "count-mismatch"),
        ("Gather three red and three blue blocks in two mixed groups.", "ambiguous"),
    ],
)
def test_groups_are_not_sorted_by_color_where_something_else_is_said(text: str, code: str) -> None:
    assert code_of(text) == code


def test_groups_by_color_are_by_color() -> None:
    for text in ("Put two red and four blue blocks in two groups.", "Sort two red and four blue blocks by color."):
        assert "two groups" in means(text) or "in one group and the four blue blocks" in means(text)


@pytest.mark.parametrize("each", ["each of the outer ones", "both outer ones", "the two outer ones", "each outer one"])
def test_what_is_on_the_outer_ones_lies_on_them(each: str) -> None:
    told = means(f"Put three red blocks in a row, and on {each} a blue one.")
    assert "A blue block must be on red block 1. The other blue block must be on red block 3." in told


def test_what_is_at_the_ends_lengthens_the_row() -> None:
    assert "The three red blocks and the two blue blocks must be in a row" in means(
        "Put three red blocks in a row and at each end a blue one."
    )


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of five white blocks with the second and the fourth red.",
        "Build a row of five white blocks with the first three red.",
        "Build a row of five white blocks with the first and the last red.",
        "Build a row of six white blocks, the last two red.",
        "Build a tower of four blue blocks with the top two red.",
    ],
)
def test_blocks_of_one_color_are_not_of_another(text: str) -> None:
    assert code_of(text) in ("ambiguous", "misplaced")


def test_parts_of_a_counted_line_are_of_it() -> None:
    told = means("Build a row of five blocks, the second and fourth red and the others white.")
    assert "There are three white blocks and two red blocks." in told
    assert "There are four white blocks and two red blocks." in means(
        "Build a row of four white and two red blocks with the last two red."
    )
    assert "There are four white blocks and a red block." in means(
        "Build a row of four white blocks and a red one, with the first one red."
    )


def test_blocks_stacked_so_high_are_all_stacked() -> None:
    assert "The six red blocks must form three towers of two." in means("Stack six red blocks two high.")
    assert "must form two towers of three" in means("There are six red blocks. Stack them three high.")
    assert "must form a tower of exactly three" in means("Stack three red blocks three high.")
    assert code_of("Stack seven red blocks two high.") == "count-mismatch"


@pytest.mark.parametrize("line", ["row of three red blocks", "tower of three red blocks"])
def test_blocks_behind_a_line_may_be_of_it(line: str) -> None:
    assert code_of(f"Build a {line} and a yellow and a white block next to it.") == "ambiguous"
    told = means(f"Build a {line}, and a yellow and a white block next to it.")
    assert "The yellow block must be next to the" in told
    assert "The white block must be next to the" in told


def test_the_last_of_a_list_is_beside_the_others() -> None:
    for listed in ("three red blocks, a yellow block, and", "three red blocks, a yellow block and"):
        assert "The three red blocks and the yellow block must be in a row." in means(
            f"Build a row of {listed} a white block behind it."
        )
