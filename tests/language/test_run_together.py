"""Texts whose sentences nothing parts: a part of a figure, how many blocks there are, or what is left open is told
behind it as in a sentence of its own."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]
PLAIN: Meant = {"assets": {"plain": 4}, "hold": ["plain^plain#2^plain#3^plain#4"], "miss": ["plain^plain#2 ; plain#3"]}
TOPPED: Meant = {"assets": {"red": 1, "blue": 4}, "hold": ["blue^blue#2^blue#3^blue#4^red"],
                 "miss": ["red^blue^blue#2^blue#3^blue#4", "blue^blue#2^red^blue#3^blue#4"]}  # fmt: skip
CENTERED: Meant = {"assets": {"orange": 1, "gray": 8}, "hold": ["gray gray gray | gray orange gray | gray gray gray"],
                   "miss": ["orange gray gray | gray gray gray | gray gray gray"]}  # fmt: skip
LETTER: Meant = {
    "assets": {"blue": 8},
    "hold": ["blue blue blue blue blue | . . blue . . | . . blue . . | . . blue . ."],
    "miss": ["blue* at=0,0", "blue blue blue . . | . . blue . . | . . blue . . | . . blue blue blue"],
}
LEAST: Meant = {"assets": {"green": 4, "red_patch": 1}, "hold": ["green^green#2 at=red_patch ; green#3 ; green#4",
                                                               "green^green#2^green#3 at=red_patch ; green#4"],
                "miss": ["green at=red_patch ; green#2 ; green#3 ; green#4",
                         "green^green#2 ; green#3 ; green#4"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("make a tower thats four high i dont care what colors", PLAIN),
        ("make a tower of four any color is fine", PLAIN),
        ("a tower four high colors dont matter", PLAIN),
        ("make a tower with five blocks the top one has to be red and the rest blue", TOPPED),
        ("make a tower with five blocks the top one is red and the rest are blue", TOPPED),
        ("i want a 3x3 grid all of them gray except the middle one which is orange", CENTERED),
        ("make a big letter t out of blue blocks the bar is five blocks long and the stem is three more", LETTER),
        ("a stack of at least two green blocks on the red patch please there are four green ones in total", LEAST),
        ("make a row of three blocks the left one is red the right one is blue the middle one has to be green",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["red green blue"], "miss": ["red blue green"]}),
        ("build a wall three wide and two high the top layer is red the bottom layer is blue",
         {"assets": {"red": 3, "blue": 3}, "hold": ["blue^red blue^red blue^red pitch=1"],
          "miss": ["red^blue red^blue red^blue pitch=1"]}),
        ("make two towers of two blocks the left one is red and the right one is blue",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red^red#2 ; blue^blue#2"], "miss": ["blue^blue#2 ; red^red#2"]}),
    ],
)  # fmt: skip
def test_sentences_that_nothing_parts_are_read_as_several(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "make a tower of three red blocks they should be touching the wall",
        "put the red block on the block the blue one is on",
        "is there a tower of three blocks the top one is red",
        "make a row of three red blocks the top one is blue",
        "put the A block next to the B block the first one should be left",  # on the left, or alone?
    ],
)
def test_what_is_no_sentence_behind_another_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
