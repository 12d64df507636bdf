"""What is said behind a figure and changes nothing, "a triangle, not a line", "no need to touch", and what does:
"no stacking", "they must lie flat"."""

import pytest

from tests.language.meaning import code_of, means

_BESIDE = "There are a blue block and a yellow block. The blue block must be next to the yellow block."
_FLAT = (
    "There are two red blocks. There is a green patch. The two red blocks must be on the green patch. Red block 1 must "
    "not be somewhere above red block 2. Red block 2 must not be somewhere above red block 1."
)
_TOWERS = (
    "There are two red blocks and two blue blocks. The two red blocks and the two blue blocks must form two towers of "
    "two, each of a different color."
)
_RIGHT_OF = "There are a green block and an orange block. The green block must be to the right of the orange block."


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("put blue next to yellow, they dont have to touch", _BESIDE),
        ("put blue next to yellow, no need to touch", _BESIDE),
        ("make a row of 2 pink cubes, not a tower", "There are two pink blocks. The two pink blocks must be in a row."),
        ("2 stacks, one red one blue, 2 bricks each, dont mix the colors", _TOWERS),
        ("two red blocks on the green mat, no stack", _FLAT),
        ("2 red cubes go on green mat, they must lie flat", _FLAT),
        ("move the green block so its to the right of the orange block", _RIGHT_OF),
        ("green brick must be to the right of orange brick, how far is not important", _RIGHT_OF),
    ],
)
def test_nothing_is_lost(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put two red blocks on the mat, not a tower", "incomplete"),  # may they be in a row?
        ("put blue next to yellow so that they touch, they dont have to touch", "no-goal"),
        ("a tower of two red blocks and a blue one, dont mix the colors", "misplaced-word"),
    ],
)
def test_what_tells_more_is_not_left_out(text: str, code: str) -> None:
    assert code_of(text) == code
