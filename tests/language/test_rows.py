"""Rows that turn one wording into another: what they say instead is made of what they look for."""

from __future__ import annotations

import re

import pytest

from rpg.language.grammar.rows.formal import AT_ONCE, UNREAD
from rpg.language.grammar.rows.turned import Turn

ROWS = (*AT_ONCE.rows, *UNREAD.rows)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[1])
def test_a_row_names_only_groups_that_it_has(row: Turn) -> None:
    pattern, said = row
    named = {int(number) for number in re.findall(r"\{(\d+)s?\}", said)}
    assert max(named, default=0) <= re.compile(pattern).groups


def test_no_row_is_told_twice() -> None:
    assert len({*AT_ONCE.rows}) == len(AT_ONCE.rows)
    assert len({*UNREAD.rows}) == len(UNREAD.rows)
