"""Two words, each in a row of its own or somewhere else, and one that is there twice: of cubes of their own."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

SUN_AND_DAY = (
    "There are an S block, a U block, an N block, a D block, an A block and a Y block. The blocks S, U and N "
    "must spell the word SUN. The blocks D, A and Y must spell the word DAY. The blocks D, A and Y must be {} "
    "the blocks S, U and N."
)
TWICE = (
    'There are two blocks labelled "S", two blocks labelled "E" and two blocks labelled "A". {}The S block '
    "number 1, the E block number 1 and the A block number 1 must spell the word SEA. {}The S block number 2, "
    "the E block number 2 and the A block number 2 must spell the word SEA."
)
SECOND = " The S block number 2, the E block number 2 and the A block number 2 must be {}."
FIRST = "The S block number 1, the E block number 1 and the A block number 1 must be {}. "
NO_AND_ON = (
    'There are two blocks labelled "N" and two blocks labelled "O". There are a red patch and a blue patch. '
    "The N block number 1 and the O block number 1 must spell the word NO. The N block number 1 and the O "
    "block number 1 must be on the red patch. The O block number 2 and the N block number 2 must spell the "
    "word ON. The O block number 2 and the N block number 2 must be on the blue patch."
)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Spell SUN and, in a second row right in front of it, spell DAY.", SUN_AND_DAY.format(
         "immediately in front of")),
        ("spell sun in one row and day in another row behind it", SUN_AND_DAY.format("behind")),
        ("Write SUN in the front row and DAY in the row behind it.", SUN_AND_DAY.format("behind")),
        ("Spell SUN. And DAY behind it.", SUN_AND_DAY.format("behind")),
        ("Spell SUN, with DAY in front of it.", SUN_AND_DAY.format("in front of")),
        ("Spell SEA twice.", TWICE.format("", "")),
        ("Spell SEA twice, one word behind the other.", TWICE.format("", "") + SECOND.format(
         "behind the S block number 1, the E block number 1 and the A block number 1")),
        ("Spell SEA twice, once in the far half and once in the near half.", TWICE.format(
         "", FIRST.format("in the far half of the table")) + SECOND.format("in the near half of the table")),
        ("Spell SEA in the far half and SEA in the near half.", TWICE.format(
         "", FIRST.format("in the far half of the table")) + SECOND.format("in the near half of the table")),
        ("Spell NO on the red mat and ON on the blue one.", NO_AND_ON),
        ("There are the letters N, O, O and N. Spell NO on the red mat and ON on the blue mat.", NO_AND_ON),
    ],
)  # fmt: skip
def test_each_has_its_cubes(text: str, meaning: str) -> None:
    assert means(text).replace("\n", " ") == meaning


def test_what_is_behind_a_word_may_be_no_word() -> None:
    assert means("Spell SUN with a red block behind it.").endswith(
        "The red block must be behind the blocks S, U and N."
    )
    assert code_of("Spell SUN with blocks behind it.") == "self-reference"
    assert code_of("Spell SUN with none behind it.") == "misplaced-word"
    assert code_of("Spell SUN. And one behind it.") == "ambiguous"
    assert code_of("There are the letters T, E and A. Spell TEA and EAT.") == "contradiction"
