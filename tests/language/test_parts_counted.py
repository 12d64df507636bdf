"""Kinds of which one is meant, parts that are counted, letters of a word, and lots in corners of which it is not said
which."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

_VOWEL = "The A block must be on the red patch or the E block must be on the red patch."


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("There are A, B and E. Put a vowel on the red mat.", _VOWEL),
        ("A vowel must be on the red mat. The letters are A, B and E.", _VOWEL),
        ("There are A, B and E. Exactly one vowel goes on the red mat.",
         "Exactly one of the blocks A and E must be on the red patch."),
        ("Put the vowels of BED on the red mat and the consonants on the blue mat.",
         "The E block must be on the red patch. The blocks B and D must be on the blue patch."),
        ("Two of the green blocks go on the red mat and the other three on the blue mat.",
         "Two green blocks must be on the red patch. The other three green blocks must be on the blue patch."),
        ("There are a red zone and a green zone. Put two white blocks in the red zone, one in the green zone.",
         "Two white blocks must be on the red patch. The other white block must be on the green patch."),
        ("Both patches must carry a tower of two green blocks.",
         "Two green blocks must form a tower of exactly two on the gray patch. The other two green blocks must form a "
         "tower of exactly two on the blue patch."),
    ],
)  # fmt: skip
def test_what_is_meant_of_them(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


def test_a_kind_is_not_all_of_it() -> None:
    assert code_of("There are A, B and E. Put a cube with a vowel on the mat.") == "ambiguous"
    assert "The blocks A and E must be on the" in means("There are A, B and E. Put every vowel on the mat.")
    assert "The A block must be on the" in means("Put a vowel on the mat.")


def test_what_lies_on_a_patch_that_is_cleared() -> None:
    start, end = start_and_end("Clear the blue zone: the two white blocks lying on it have to go to the green zone.")
    assert start == "At the start, the two white blocks are on the blue patch"
    assert end == "The two white blocks must be on the green patch. The blue patch must be empty."


def test_as_many_here_as_there() -> None:
    told = means("There are two blocks. The number of blocks on the red mat must equal the number on the blue mat.")
    assert "Exactly one of the red and blue blocks must be on the red patch. Exactly one" in told.replace("\n", " ")


def test_different_corners() -> None:
    told = start_and_end("Put the red and the blue block in different corners of the table.")[1]
    assert told.startswith("The red and blue blocks must be in a corner of the table. At most one of the red and blue")
    lots = start_and_end("Put the two red blocks in one corner and the two blue ones in another corner.")[1]
    assert lots.count("in the far left corner") == 2 * 3
    assert code_of("Put the red block in a different corner of the table.") == "ambiguous"
    assert code_of("Put the red block in one corner, the blue one in another and the green one on the mat.")
