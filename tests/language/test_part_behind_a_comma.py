"""What is said of one block of a structure behind a comma is said of that one alone, and not of the whole."""

import pytest

from tests.language.meaning import means

ROW = "The three green blocks must be in a row"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("The word BED, its first letter on the red patch.", "The B block must be on the red patch."),
        ("Spell BED with its first letter on the red patch.", "The B block must be on the red patch."),
        ("A row of A, B and C, the B on the patch.", "The B block must be on the gray patch."),
        ("A row of three green blocks, the left one on the red patch.", "A green block must be on the red patch."),
        ("A row of three red blocks, the blue one on the patch.", "The blue block must be on the gray patch."),
    ],
)
def test_one_block_is_there(text: str, meant: str) -> None:
    assert means(text).endswith(meant)


def test_a_block_of_another_look_is_not_in_the_row() -> None:
    assert "The three red blocks must be in a row." in means("A row of three red blocks, the blue one on the patch.")


def test_what_lies_on_a_patch_is_beside_what_was_told_before() -> None:
    text = "Make a row of three green blocks and put a red tower of two on the patch to its right."
    assert means(text).endswith("The tower of the two red blocks must be to the right of the three green blocks.")


def test_the_whole_is_on_the_patch() -> None:
    assert means("A row of three green blocks on the red patch.").endswith(
        "The three green blocks must be on the red patch."
    )
