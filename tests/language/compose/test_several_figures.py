"""Several towers and rows in one text: told by their sides, in a row themselves, what is said of both, starts."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

READ = {
    "Stack the digits 1 and 2 in one tower and the letters A and B in another, both in ascending order from bottom to "
    "top.": "The blocks 1 and 2 must form a tower of exactly two from bottom to top in ascending numerical order. "
    "The blocks A and B must form a tower of exactly two from bottom to top in alphabetical order.",
    "Stack A and B in the left tower and C and D in the right one.": "The blocks A and B must form a tower of exactly "
    "two. The blocks C and D must form a tower of exactly two. The tower of the blocks A and B must be to the left of "
    "the tower of the blocks C and D.",
    "Build three towers, each white on black, in a column.": "A black block and a white block must form a tower of "
    "exactly two from bottom to top in the order black, white. Another black block and another white block must form "
    "a tower of exactly two from bottom to top in the order black, white. The other black block and the other white "
    "block must form a tower of exactly two from bottom to top in the order black, white. The three black blocks must "
    "be in a column on the table.",
    "Put a red block, a tower of two yellows and a tower of three blues in a row, the heights rising to the right.": (
        "The two yellow blocks must form a tower of exactly two from bottom to top in the order yellow, yellow. The "
        "three blue blocks must form a tower of exactly three from bottom to top in the order blue, blue, blue. The "
        "red block, a yellow block and a blue block must be in a row from left to right in the order red, yellow, blue."
    ),
    "The stack on the left is red over green, the stack on the right is green over red.": "Green block 1 and red "
    "block 1 must form a tower of exactly two from bottom to top in the order green, red. Red block 2 and green "
    "block 2 must form a tower of exactly two from bottom to top in the order red, green. Green block 1 must be to "
    "the left of red block 2.",
    "Build a tower of four out of two green and two white cubes, with both white ones in the middle.": "The two green "
    "blocks and the two white blocks must form a tower of exactly four from bottom to top in the order green, white, "
    "white, green.",
    "The tower starts as red, blue, yellow from bottom to top. Rebuild it in the reverse order, with yellow at the "
    "bottom.": "At the start, the red, blue and yellow blocks form a tower of exactly three from bottom to top in the "
    "order red, blue, yellow. The yellow, blue and red blocks must form a tower of exactly three from bottom to top in "
    "the order yellow, blue, red.",
    "At the start C is on B and B is on A. Move the top block to the right of the other two, which stay stacked.": "At "
    "the start, the C block is on the B block. At the start, the B block is on the A block. The blocks A and B must be "
    "stacked from bottom to top in the order A, B. The C block must be to the right of the blocks A and B.",
}
REFUSED = (
    "Start: a row of red, green and blue from left to right. Turn it upside down.",
    "Stack A and B in the left tower.",
    "Make three pairs of red blocks and arrange them in a column.",
    "Put 1 and 2 in one tower and A and B in another, both in descending order from left to right.",
    "The tower starts as red, blue, yellow from bottom to top. Rebuild it in reverse order, with yellow at the top.",
    "Build a row of three red blocks with a column of three blue blocks behind its left end.",
    "Line up three red blocks and put a blue block at the left end.",
)


@pytest.mark.parametrize("text", READ)
def test_read(text: str) -> None:
    """Behind what there is, the text is told so."""
    assert means(text).partition(". ")[2] == READ[text]


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
