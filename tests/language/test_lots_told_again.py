"""Lots that are shared out or told again: so many that cannot be halved, "two red blocks, one red block on the patch",
"gray bricks on the table, two rows of three", and one of two patches and the other, step by step."""

import pytest

from tests.language.meaning import code_of, means

_ROWS = (
    "There are two red blocks and four white blocks. The two red blocks must be in a row. The four white blocks must "
    "be in a row. The two red blocks must be in front of the four white blocks."
)
_EITHER = (
    "There are a red block and a blue block. There are a gray patch and a blue patch. First, the red block must be on "
    "the gray patch or the red block must be on the blue patch, then the blue block must be on the blue patch or the "
    "blue block must be on the gray patch. Either the red block must be on the gray patch and the blue block must be "
    "on the blue patch, or the red block must be on the blue patch and the blue block must be on the gray patch."
)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "divide the nine blue blocks into three towers of the same height, with none left over",
            "There are nine blue blocks. The nine blue blocks must form three towers of equal height.",
        ),
        (
            "stack seven red blocks into two towers, one a block higher than the other",
            "There are seven red blocks. Four red blocks must form a tower of exactly four. The other three red blocks "
            "must form a tower of exactly three.",
        ),
        (
            "Two red blocks, one red block on the patch",
            "There are two red blocks. There is a gray patch. Exactly one of the two red blocks must be on the gray "
            "patch.",
        ),
        (
            "Four red blocks, three red blocks in a row",
            "There are four red blocks. Three red blocks must be in a row.",
        ),
        ("there are 2 red and 4 white cubes, make 2 rows, red in front", _ROWS),
        ("there are 2 red and 4 white cubes, make 2 rows, red in front and white behind", _ROWS),
        ("There are two patches. First put the red block on one and then the blue block on the other.", _EITHER),
        ("First put a red block on one of the two patches, then a blue block on the other.", _EITHER),
        (
            "Put the left block of the row onto the patch",
            "There are a red block, a blue block, a green block and a yellow block. There is a gray patch. At the "
            "start, the four blocks are in a row from left to right in the order red, blue, green, yellow. The red "
            "block must be on the gray patch.",
        ),
    ],
)
def test_each_lot_is_told_once(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("divide the seven blue blocks into two towers of the same height, with none left over", "count-mismatch"),
        ("divide seven red blocks into three towers of the same height", "count-mismatch"),
        ("Two red blocks and one red block on the patch", "ambiguous"),
        ("Put two red blocks, one red block on the patch.", "ambiguous"),
        ("six red blocks on the table, two rows of three", "ambiguous"),
        ("There is a row of three red blocks. Put the left block of the row onto the patch.", "ambiguous"),
        ("spell ON in a column", "ambiguous"),
        ("there are 2 red and 4 white cubes, make 2 rows of three, red in front and white behind", "count-mismatch"),
        ("There are two red blocks. Build a red tower of three.", "count-mismatch"),
        ("There are three patches. Put the red block on one of the patches and the blue block on the other.",
         "ambiguous"),
    ],
)  # fmt: skip
def test_what_is_open_is_refused(text: str, code: str) -> None:
    assert code_of(text) == code
