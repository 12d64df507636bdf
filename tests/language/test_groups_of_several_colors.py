"""Groups of several colours: strangers told by the group that they are in, and what each of several groups has."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

_BY_COLOR = "Group three red and three blue blocks by colour, "
_STRANGER = (
    "There are three red blocks and three blue blocks. The three red blocks and a blue block must be in one group and "
    "the other two blue blocks must be in another group."
)


@pytest.mark.parametrize(
    "text",
    [
        f"{_BY_COLOR}but with one blue block among the red ones.",
        f"{_BY_COLOR}but leave one blue one in the red group.",
        f"{_BY_COLOR}but one of the blue blocks goes with the red ones.",
    ],
)
def test_a_stranger_is_told_by_the_group_that_it_is_in(text: str) -> None:
    assert means(text) == _STRANGER


def test_as_many_strangers_in_both_groups_are_strangers_in_each() -> None:
    told = "with one red block among the blue ones and one blue block among the red ones."
    assert means(f"{_BY_COLOR}{told}").endswith("sorted by color into two groups with one outlier in each group.")


def test_groups_may_share_look_alikes() -> None:
    told = means("Make two groups of four: one all red except for one blue block, the other all blue.")
    assert told.endswith(
        "The three red blocks and a blue block must be in one group and the other four blue blocks must be in another "
        "group."
    )
    told = means("Two groups of four, one with orange blocks, the other with three orange blocks and a gray one.")
    assert told.startswith("There are seven orange blocks and a gray block. Four orange blocks must be in one group")


@pytest.mark.parametrize(
    "text",
    [
        "Make two bunches of three blocks. In each bunch exactly one block is white, the others are brown.",
        "Put six blocks into two groups. In each group one block is white and the rest is brown.",
        "Two groups of one white block, and two brown blocks added to each.",
        "Divide two white and four brown blocks into two groups, one white and two browns in each.",
    ],
)
def test_what_each_group_has_is_told_at_once(text: str) -> None:
    assert means(text) == (
        "There are two white blocks and four brown blocks. A white block and two brown blocks must be in one group and "
        "the other white block and the other two brown blocks must be in another group."
    )


def test_pairs_of_either_color() -> None:
    told = means("Divide two red and two blue blocks into pairs. Each pair has one of either colour.")
    assert told.endswith(
        "must be in one group and the other red block and the other blue block must be in another group."
    )


@pytest.mark.parametrize(
    "text",
    [
        f"{_BY_COLOR}but put one blue block on the red ones.",
        f"{_BY_COLOR}with four blue blocks among the red ones.",
        "Divide two red and four blue blocks into pairs. Each pair has one red and one blue block.",
        "Put seven blocks into two groups. In each group exactly one block is white, the others are brown.",
    ],
)
def test_what_does_not_come_out_even_is_refused(text: str) -> None:
    assert code_of(text)
