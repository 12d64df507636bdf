"""What is there at the start and is changed: taken out, swapped, moved to an end, replaced, added to, taken apart."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]


def there(start: str, *, end: list[str], miss: list[str], start_miss: list[str] | None = None) -> Meant:
    """States of which the first is the one at the start, and ends that must hold, or must not."""
    pieces = start.replace("^", " ").replace("|", " ").split()
    assets = {look: pieces.count(look) for look in pieces}
    for state in (*end, *miss):
        for look in state.replace("^", " ").replace("|", " ").replace(";", " ").split():
            if not look.startswith(("at=", "pitch=", ".")):
                assets[look] = max(assets.get(look, 0), state.replace("^", " ").split().count(look))
    return {
        "assets": assets, "start": [start], "start_miss": start_miss or [],
        "hold": [[f"{start} at=0,0", state] for state in end], "miss": [[f"{start} at=0,0", state] for state in miss],
    }  # fmt: skip


TOP_OFF = there(
    "pink^gray^brown",
    end=["pink^gray at=0,0 ; brown at=0,4"],
    miss=["pink^gray^brown at=0,0"],
    start_miss=["brown^gray^pink"],
)
OTHER_END = there(
    "cyan pink black",
    end=["pink black cyan at=0,0"],
    miss=["black pink cyan at=0,0", "cyan pink black at=0,0", "pink cyan black at=0,0"],
    start_miss=["black pink cyan"],
)
OUTER_SWAPPED = there(
    "2 3 4 5", end=["5 3 4 2 at=0,0"], miss=["5 4 3 2 at=0,0", "2 3 4 5 at=0,0"], start_miss=["5 3 4 2", "5 4 3 2"]
)
GAP_CLOSED = there(
    "M N O P", end=["M N P at=0,0 ; O at=3,5"], miss=["M N . . P at=0,0 ; O at=3,5", "M N P O at=0,0"]
)  # fmt: skip
MIDDLE_REPLACED = there(
    "cyan pink black", end=["cyan white black at=0,0"], miss=["cyan pink black at=0,0", "white pink black at=0,0"]
)
LAST_AHEAD = there("P A R K", end=["K P A R at=0,0"], miss=["P A R K at=0,0", "K R A P at=0,0"])
LONGER = there("D O G", end=["D O G S at=0,0"], miss=["D O G at=0,0", "S D O G at=0,0"], start_miss=["D O G S"])
BARE = there(
    "pink^cyan^black", end=["pink at=0,0 ; cyan^black at=0,4"], miss=["pink^cyan at=0,0 ; black at=0,4"]
)  # fmt: skip
ONE_TO_THE_LEFT = there("M N O P", end=["M O N P at=0,0"], miss=["O M N P at=0,0", "M N P O at=0,0"])
FRONT_BACK = there(
    "black | pink | cyan", end=["cyan | black | pink at=0,0"], miss=["cyan | pink | black at=0,0"],
    start_miss=["cyan | pink | black"],
)  # fmt: skip
SHORTER = there("pink^gray^brown", end=["gray^brown at=0,0"], miss=["brown^gray at=0,0", "pink^gray at=0,0"])
FOUR_OF_NINE = there(
    "white white white | white white white | white white white",
    end=["white white white | white red white | white white white"],
    miss=["red white white | white white white | white white white"],
)
TWO_LEFT: Meant = {
    "assets": {"pink": 3},
    "hold": [["pink ; pink ; pink", "pink#1^pink#2^pink#3", "pink#1^pink#2 ; pink#3"]],
    "miss": [["pink ; pink ; pink", "pink#1^pink#2 ; pink#3"], ["pink ; pink ; pink", "pink^pink^pink"]],
}
INNER_SWAPPED = there("A B C D", end=["A C B D at=0,0"], miss=["A B C D at=0,0", "A C B D at=3,0"])
BACKWARDS = there("4 7 2 9", end=["9 2 7 4 at=0,0"], miss=["4 7 2 9 at=0,0", "9 7 2 4 at=0,0"], start_miss=["9 2 7 4"])
ONLY_TOP = there(
    "black^pink^cyan",
    end=["black^pink at=0,0 ; cyan at=0,4"],
    miss=["black at=0,0 ; pink^cyan at=0,4", "black^pink^cyan at=0,0"],
)
ON_WHITE = there(
    "cyan pink white", end=[". pink white^cyan at=0,0"], miss=["cyan pink white at=0,0", "cyan^white pink . at=0,0"]
)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("The tower is pink, gray, brown from the bottom up. Take the top block off.", TOP_OFF),
        ("The stack is pink then gray then brown on top. Remove the top one.", TOP_OFF),
        ("A tower has pink at the bottom, gray in the middle and brown on top. Take the brown one off.", TOP_OFF),
        ("Cyan, pink and black stand in a row from left to right. Move the cyan one to the other end.", OTHER_END),
        ("From left to right lie cyan, pink and black. Bring the left one round to the right end.", OTHER_END),
        ("2 to 5 lie in order from left to right. Swap the first and the last.", OUTER_SWAPPED),
        ("The row is M, N, O, P. Take the O out and close the gap.", GAP_CLOSED),
        ("Remove the third letter from the row M N O P and close the gap.", GAP_CLOSED),
        (
            "Cyan, pink and black lie in a row from left to right. Replace the middle one with a white one.",
            MIDDLE_REPLACED,
        ),
        ("The letters spell PARK. Move the last letter to the front.", LAST_AHEAD),
        ("The word DOG is already there. Add an S at the end.", LONGER),
        ("Cyan is on pink and black is on cyan. Take everything off pink.", BARE),
        ("The row is M, N, O, P. Move the O one place to the left.", ONE_TO_THE_LEFT),
        ("Cyan, pink and black stand in a line from front to back. Bring the front one to the back.", FRONT_BACK),
        (
            "The tower is pink, gray, brown from the bottom up. Remove the bottom one and keep the others in order.",
            SHORTER,
        ),
        (
            "Nine white blocks form a filled three by three square. Replace the one in the middle with a red one.",
            FOUR_OF_NINE,
        ),
        ("Build a tower of three pink blocks, then take the top one off again.", TWO_LEFT),
        ("Start with the row A B C D. End with B and C swapped and A and D not moved.", INNER_SWAPPED),
        ("Can you turn the order round? The row is 4 7 2 9 now.", BACKWARDS),
        ("Cyan starts on top of pink, which is on black. Only cyan has to come off.", ONLY_TOP),
        (
            "Cyan, pink and white are in a row from left to right. Take the left one and put it on the right one.",
            ON_WHITE,
        ),
    ],
)
def test_what_is_there_is_changed(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Three pink blocks lie in a row. Take the middle one out.",  # which of them is where is not told
        "The row is M, N, O, P. Move the O three places to the left.",  # there are only two
        "The tower is red, gray, pink from the bottom up. Take the bottom one off and leave the others where they are.",
        "The letters spell PARK. Take away the P and leave PAR.",
        "Three pink blocks stand in a row with a blue one on the middle one. Move the blue one onto the left one.",
        "Stack pink on cyan. Cyan must not move at any time.",  # not only where it is at the end
        "Four pink blocks in a row. Take the rightmost one and put it on the leftmost one.",
    ],
)
def test_changes_that_are_not_clear(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


@pytest.mark.parametrize(
    ("text", "start", "end"),
    [
        ("Cyan is on the pink mat. Move cyan onto the brown mat.", "cyan at=pink_patch", "cyan at=brown_patch"),
        ("The cyan block is already on the pink mat. At the end it is on the brown one.",
         "cyan at=pink_patch", "cyan at=brown_patch"),
    ],
)  # fmt: skip
def test_what_is_put_elsewhere_is_there_first(text: str, start: str, end: str) -> None:
    assets = {"cyan": 1, "pink_patch": 1, "brown_patch": 1}
    assert_means(text, {"assets": assets, "start": [start], "start_miss": [end], "hold": [end], "miss": [start]})


def test_where_it_starts_and_where_it_ends() -> None:
    assert_means(
        "The cyan block starts on the pink mat. At the end it is on the brown mat.",
        {
            "assets": {"cyan": 1, "pink_patch": 1, "brown_patch": 1},
            "start": ["cyan at=pink_patch"], "start_miss": ["cyan at=brown_patch"],
            "hold": ["cyan at=brown_patch"], "miss": ["cyan at=pink_patch"],
        },
    )  # fmt: skip
