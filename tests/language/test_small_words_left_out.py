"""How people type who leave small words out or put others: "change place with each other", "on the 4 corners", "most
top", "put first"; and what is taken apart."""

import pytest

from tests.language.meaning import code_of, means

_SWAP = "There are a red block and a yellow block. The red block and the yellow block must swap places."
_SIDES = (
    "There are a pink block and an orange block. The pink block must be to the left of the orange block or the pink "
    "block must be to the right of the orange block."
)
_APART = (
    "There are a red block, a green block and a blue block. At the start, the three blocks are stacked from top to "
    "bottom in the order red, green, blue. The blue, green and red blocks must be on the table."
)
_CORNERS = (
    "There are four red blocks. A red block must be in the far left corner of the table. Another red block must be in "
    "the far right corner of the table. Another red block must be in the near left corner of the table. The other red "
    "block must be in the near right corner of the table."
)
_THEN = (
    "There are a green block and a red block. There is a gray patch. First, the green block must be on the gray patch. "
    "Then, the red block must be on the green block."
)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("red cube and yellow cube change place with each other", _SWAP),
        ("put pink to the left or the right of orange", _SIDES),
        ("unstack red on green on blue", _APART),
        ("unstack the tower of red on green on blue onto the table", _APART),
        ("4 red cubes, put them on the 4 corners of the table, one cube each corner", _CORNERS),
        ("put green on the mat. after, put red on green.", _THEN),
        (
            "place cube on mat. color: red. mat: blue.",
            "There is a red block. There is a blue patch. The red block must be on the blue patch.",
        ),
        (
            "leave gap 2 cm between gray cube and pink cube",
            "There are a gray block and a pink block. There must be a gap of 2 cm between the gray block and the pink "
            "block.",
        ),
    ],
)
def test_what_is_meant(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("take apart the tower of three red blocks on the mat", "ambiguous"),  # is it there, or do they go there?
        ("unstack the tower of red on blue onto the green patch", "ambiguous"),
    ],
)
def test_what_is_open_is_refused(text: str, code: str) -> None:
    assert code_of(text) == code
