"""Rows of rewording are found by what words have in them: none that fits is missed."""

from __future__ import annotations

import re

import pytest

from rpg.language.grammar.rows import formal
from rpg.language.grammar.rows.turned import Turns
from rpg.language.needs import needed
from rpg.language.tokens import tokenize
from tests.corpus.entries import load


@pytest.mark.parametrize(
    ("pattern", "parts"),
    [
        ("^(?:put|lay down) (?:an?|the) (.+) there$", [{"there"}, {"put", "down"}, {"a", "the"}]),
        ("\\bcolou?rs?\\b", [{"colo"}, {"r"}]),
        ("(?: ,)? (?:so(?: that)?|where) (?!no )it (\\w+ )*even{1,2}ly", [{"even"}, {"so", "where"}, {"ly"}, {"it"}]),
        ("(?:\\d+|one) blocks? \\+ (?:two|)", [{"block"}, {"+"}]),
    ],
)  # fmt: skip
def test_what_a_row_needs(pattern: str, parts: list[set[str]]) -> None:
    assert sorted(map(sorted, needed(pattern))) == sorted(map(sorted, parts))


def test_brackets_that_are_too_deep_are_told() -> None:
    assert needed("(" * 16 + "a" + ")" * 16) == [{"a"}]
    with pytest.raises(ValueError, match="too deep"):
        needed("(" * 17 + "a" + ")" * 17)


@pytest.mark.parametrize("turns", [formal.AT_ONCE, formal.UNREAD])
def test_no_row_that_fits_is_missed(turns: Turns) -> None:
    rows = [re.compile(row) for row, _ in turns.rows]
    for entry in load("dev")[::120]:
        text = " ".join(token.word for token in tokenize(entry.text)[0])
        fitting = {n for n, row in enumerate(rows) if row.search(text)}
        assert fitting <= set(turns.fitting([(0, 0, text.split(), text)]))
