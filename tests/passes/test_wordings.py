"""What readings say, wherever in the text it stands and in however many records."""

from __future__ import annotations

from collections.abc import Hashable

import pytest

from rpg.language.read import read_sentences
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from rpg.passes.schema.wordings import wording


def worded(text: str) -> list[Hashable]:
    (sentence,) = read_sentences(read_words(tokenize(text)[0])[0])
    known: dict[int, Hashable] = {}
    return [wording(reading, known) for reading in sentence.readings]


def test_where_it_stands_says_nothing() -> None:
    assert worded("put the red block on the blue block") == worded("put   the red block   on the blue block")


@pytest.mark.parametrize("other", ["put the blue block on the red block", "move the red block on the blue block"])
def test_other_words_say_something_else(other: str) -> None:
    assert not set(worded("put the red block on the blue block")) & set(worded(other))


def test_parts_say_the_same_one_by_one_and_as_a_list_behind_the_noun_and_behind_the_clause() -> None:
    readings = worded("A 3x3 grid: row 1 is red, row 2 is white, row 3 is blue.")
    assert len(set(readings[:8])) == 1
