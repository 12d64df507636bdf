"""Every row compiles, and what it says instead names groups that it has, word by word."""

from __future__ import annotations

import re

import pytest

from rpg.language.grammar.rows import formal
from rpg.language.grammar.rows.turned import Turn

ROWS = [*formal.AT_ONCE.rows, *formal.UNREAD.rows, *formal.OVER_ALL.rows]
_GROUP = re.compile(r"\{(\d+)s?\}")


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[1][:60])
def test_a_row_says_what_it_has(row: Turn) -> None:
    looked_for, said = row
    groups = re.compile(looked_for).groups
    for word in said.split():
        if "{" in word:
            met = _GROUP.fullmatch(word.strip(",.:;"))
            assert met is not None, f"{word!r} is no group by itself"
            assert int(met[1]) <= groups, f"there is no group {met[1]}"
