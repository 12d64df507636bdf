"""Who "one", "the other", "both", "only", "all but" and "instead" are, where a careless reading takes others."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("Two red blocks are on the mat. Put one on top of the other.", "Red block 1 must be on red block 2."),
        ("A red and a blue block are on the mat. Put the red one on the other.", "The red block must be on the blue"),
        ("There are two red blocks. Put one on the mat and A on the other.", "The A block must be on the other red"),
    ],
)
def test_the_other_is_a_block_where_there_is_one_mat(text: str, goal: str) -> None:
    told = means(text)
    assert goal in told
    assert "blue patch" not in told


@pytest.mark.parametrize("other", ["the other", "the other one"])
def test_one_and_the_other_of_two_mats(other: str) -> None:
    told = means(f"There are two mats. Put the red block on one and the blue block on {other}.")
    assert "Either the red block must be on the gray patch and the blue block must be on the blue patch, or" in told
    assert "the red block must be on the blue patch and the blue block must be on the gray patch." in told
    assert "Put red on one" not in means("Put red on one patch and blue on the other.")


@pytest.mark.parametrize(
    ("text", "goals"),
    [
        (
            "Put a blue block on A and one on B.",
            ("A blue block must be on the A block.", "The other blue block must be"),
        ),
        ("Make a row of three red blocks. Put one blue block in front of it and one behind it.", ("two blue blocks",)),
        ("There are three blue blocks. Put one blue block on A and one on B.", ("three blue blocks", "Another blue")),
    ],
)
def test_and_one_is_a_further_one_of_that_look(text: str, goals: tuple[str, ...]) -> None:
    told = means(text)
    assert all(goal in told for goal in goals)


def test_one_of_two_before_it_is_asked_about() -> None:
    assert code_of("Put a red block and a blue block on the mat, and one on the red block.") == "ambiguous"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Build a tower of five blocks. Use only red and blue.", "unused-block"),
        ("Build a row of four blocks. Use green and yellow blocks.", "unused-block"),
        ("Four blocks, A, B, C and D, are in a row. A and D should swap, B and C too.", "unused-block"),
        ("Put A left of B. Put C on each.", "ambiguous"),
        ("Build a tower of five blocks. Red must not be on top.", "ambiguous"),
        ("Four blocks, A, B, C and D, are in a row. Put a red block at either end.", "ambiguous"),
        ("Put both red blocks on one of the blue blocks.", "ambiguous"),
        ("There are two red blocks. Put A and B next to one of them.", "ambiguous"),
        ("The green block must not be on both mats.", "ambiguous"),
        ("There are two mats, a red and a blue one, and a green block. It must not be on both.", "ambiguous"),
        ("Put A on the mat. Put B in the same spot.", "ambiguous"),
        ("The red block should be on the mat. The blue block should be in the same position.", "ambiguous"),
        ("Put A in the near left corner. Put B in the same corner.", "ambiguous"),
        ("A and B must not be in the same corner.", "ambiguous"),
        ("Put the red block on the mat. Put the blue one there instead.", "ambiguous"),
    ],
)
def test_what_is_not_clear_is_asked(text: str, code: str) -> None:
    assert code_of(text) == code


@pytest.mark.parametrize(
    "text",
    [
        "Build a tower of two blocks. Use red and blue.",
        "Each red block must touch one of the two blue blocks. There are two red blocks.",
        "Put a red block on each of the two blue blocks.",
        "Put A and B in the same corner.",
        "Put A on the mat and keep B in the same spot.",
        "The red block is on the mat. Put it on the table instead.",
        "A should be on the mat, B too.",
    ],
)
def test_what_is_clear_is_not_asked(text: str) -> None:
    means(text)


def test_odd_numbers_on_each_are_odd() -> None:
    told = means("Put an odd number on each of the two red blocks.")
    assert "a 1 block" in told
    assert "a 3 block" in told


@pytest.mark.parametrize("but", ["All but B", "All except B"])
def test_all_but_a_letter_is_the_others(but: str) -> None:
    told = means(f"Make a row of A, B and C. {but} should be upside down.")
    assert "The A block must be upside down. The C block must be upside down. The B block must not be upside" in told


@pytest.mark.parametrize(
    ("text", "others"),
    [
        ("There are a red, a blue and a green block on the mat. Only the green one should leave it.",
         "The red block must be on the gray patch. The blue block must be on the gray patch."),
        ("There are a red, a blue and a green block. Only the red block must not be in the left half.",
         "The blue block must be in the left half of the table. The green block must be in the left half"),
        ("Red and blue are on the mat. Move only the red one off.", "The blue block must stay where it is."),
        ("There are a red, a blue and a green block. Put the red one on the mat. Not the others.",
         "The blue block must not be on the gray patch. The green block must not be on the gray patch."),
    ],
)  # fmt: skip
def test_only_speaks_of_the_others_too(text: str, others: str) -> None:
    assert others in means(text)


@pytest.mark.parametrize("there", ["there", "on it"])
def test_instead_is_where_the_other_was(there: str) -> None:
    told = means(f"The red block is on the green one. Put the blue one {there} instead.")
    assert "At the start, the red block is on the green block." in told
    assert "The blue block must be on the green block. The red block must not be on the green block." in told
