"""What has to be moved, and nobody says where to: "brown must be moved, cyan must stay where it is"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Meaning, parts_of

_ENDS = frozenset({"", ",", "and", "but", "while"})
_NONE = frozenset({"no", "none", "neither", "nothing"})
_ALLOWED = frozenset({"may", "might", "can", "could"})


def just_moved(p: Parser, j: int, end: int, lemma: str, theme: Meaning) -> bool:
    """Whether "moved" at a place says all, before its end and behind "must be"; none is moved by "no block must be"."""
    if lemma not in ("move", "shift") or p.words[end] not in _ENDS or p.words[j - 1] != "be":
        return False
    if p.words[end] in ("and", "but", ",") and "not" in p.words[end + 1 : end + 3]:
        return False  # "... must be moved, but not the blue one": nothing would come of the blue one
    told = " ".join(f"{getattr(x, 'det', '')} {getattr(x, 'word', '')}" for x in parts_of(theme)).split()
    return p.words[j - 2] not in _ALLOWED and _NONE.isdisjoint(told)
