""" "It must never be on the red mat in between": at no time, which "never" says as well; "... not on it though"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Manner

_MEANWHILE = ("in between", "on the way", "along the way", "on its way", "on the way there", "on its way there",
              "in the meantime", "meanwhile", "underway", "while moving", "while it moves")  # fmt: skip
_IT = frozenset({"it", "there", "them", "that"})
_NEVER = frozenset({"never", "ever", "always"})


def on_the_way(p: Parser, i: int) -> Results[Manner]:
    """Behind what is said to be so at all times or at none."""
    if (j := p.one(i, "though")) and p.follows(i, _IT) and j >= p.end:
        yield Manner(kind="idle", span=p.span(i, j)), j
    if (j := p.any_of(i, _MEANWHILE)) and p.anywhere(_NEVER) and (j >= p.end or p.stands(j, (",", "and", ";"))):
        yield Manner(kind="always", span=p.span(i, j)), j
