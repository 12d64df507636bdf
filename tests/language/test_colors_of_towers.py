"""In which colours each of several towers has its blocks, told of each, of none, or of so many of them."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means

_TWO = "Build two towers of three out of two red and four white blocks"


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("We have three red and three white blocks. Make two towers of three with both colors in each.",
         "Build a tower of 2 red blocks and 1 white block. Build a tower of 1 red block and 2 white blocks."),
        ("Three red and three blue blocks make three towers of two, and no tower has more than one red block.",
         "Build a tower of 1 blue block and 1 red block. Build a tower of 1 blue block and 1 red block. "
         "Build a tower of 1 blue block and 1 red block."),
        ("Three towers of two, bottoms all black, just one has a red top, the other two a yellow top.",
         "Build a tower of 1 black block and 1 red block with a red block at the top. Build a tower of 1 black block "
         "and 1 yellow block with a yellow block at the top. Build a tower of 1 black block and 1 yellow block with a "
         "yellow block at the top."),
        ("Two towers of three: one is all red, the other is white with a red top.",
         "Build a tower of 3 red blocks. Build a tower of 1 red block and 2 white blocks with a red block at the top."),
    ],
)  # fmt: skip
def test_each_of_them_has_its_blocks(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_ends_of_one_color_and_colors_that_take_turns_in_one_tower() -> None:
    mirrored = "The two brown blocks and the two white blocks must be stacked with mirrored colors."
    assert mirrored in means("Make a tower of two brown and two white blocks, top and bottom the same color.")
    assert "in the order red, white, red, white, red." in means(
        "Make a tower of three red and two white blocks, colors taking turns, red at the top."
    )
    assert code_of("Make a tower of three red and two white blocks, top and bottom of different colors.")


def test_towers_of_mixed_colors() -> None:
    meant = {
        "assets": {"red": 3, "blue": 3},
        "hold": ["red^blue ; blue^red ; red^blue"],
        "miss": ["red^red ; blue^blue ; red^blue", "red^blue ; red^blue"],
    }
    stock = "from three red and three blue blocks"
    assert_means(f"Build three towers of two {stock}, none of them in a single color.", meant)
    assert_means(f"Build three towers of two {stock}, with no block on one of the same color.", meant)


def test_colors_that_take_turns_in_several_towers() -> None:
    alternating = "must form a tower of exactly three with alternating colors"
    assert means("Build two towers of three from three red and three blue blocks, never two of the same color on each "
                 "other.").count(alternating) == len("AB")  # fmt: skip
    assert code_of("Build two towers of three from five red and one blue block, never two of the same color together.")


@pytest.mark.parametrize(
    "text",
    [
        f"{_TWO}. Neither of them has a red block on top.",
        f"{_TWO} with a red block on top.",
        f"{_TWO}, each with a red block on top.",
        "Make two towers of two out of two red and two blue blocks. Only one of them may have a red block on top.",
        "There are two towers of two. Make each of them all red.",
        "Build two towers from three red and three blue blocks, colors alternating.",
    ],
)
def test_what_leaves_their_blocks_open_is_asked(text: str) -> None:
    assert code_of(text)
