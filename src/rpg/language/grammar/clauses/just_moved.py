"""What has to be moved, and nobody says where to: "brown must be moved, cyan must stay where it is"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Meaning, parts_of

_ENDS = frozenset({"", ",", "and", "but", "while"})
_NONE = frozenset({"no", "none", "neither", "nothing"})
_ALLOWED = frozenset({"may", "might", "can", "could"})


def just_moved(p: Parser, j: int, end: int, lemma: str, theme: Meaning) -> bool:
    """Whether "moved" at a place says all, before its end and behind "must be"; none is moved by "no block must be"."""
    if lemma not in ("move", "shift") or p.words[j - 1] != "be" or not ends_there(p, end):
        return False
    return p.words[j - 2] not in _ALLOWED and not of_none(theme)


def ends_there(p: Parser, end: int) -> bool:
    """Whether nothing follows that tells where to, nor ", but not the blue one", of which nothing would come."""
    if p.words[end] in ("and", "but", ",") and "not" in p.words[end + 1 : end + 3]:
        return False
    return p.words[end] in _ENDS


def of_none(theme: Meaning) -> bool:
    """Whether it is said of none: "no block", "neither of them"."""
    told = " ".join(f"{getattr(x, 'det', '')} {getattr(x, 'word', '')}" for x in parts_of(theme)).split()
    return not _NONE.isdisjoint(told)
