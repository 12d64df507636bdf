"""Every row compiles, and what it says instead names groups that it has, word by word."""

from __future__ import annotations

import re

from rpg.language.grammar.rows import formal

ROWS = [*formal.AT_ONCE.rows, *formal.UNREAD.rows, *formal.OVER_ALL.rows]
_GROUP = re.compile(r"\{(\d+)s?\}")


def test_a_row_says_what_it_has() -> None:
    wrong = [f"{looked_for!r}: {told}" for looked_for, said in ROWS if (told := _unsound(looked_for, said))]
    assert not wrong, "\n".join(wrong)


def _unsound(looked_for: str, said: str) -> str:
    groups = re.compile(looked_for).groups
    for word in said.split():
        if "{" in word:
            met = _GROUP.fullmatch(word.strip(",.:;"))
            if met is None:
                return f"{word!r} is no group by itself"
            if int(met[1]) > groups:
                return f"there is no group {met[1]}"
    return ""


def test_no_row_is_told_twice() -> None:
    for table in (formal.AT_ONCE, formal.UNREAD, formal.OVER_ALL):
        assert len({*table.rows}) == len(table.rows)


def test_what_is_no_row_is_found() -> None:
    assert _unsound("(a) b", "{2} c") and _unsound("(a) b", "x{1} c") and not _unsound("(a) b", "{1} c")
