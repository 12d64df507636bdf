"""Fields of a form that names a text: "Title: Hanoi light.", "Task name: swap.", "ID: 17.", "Difficulty: easy.",
"Task: sorting. Start: ... Goal: ...", and what a text is called in quotation marks. They tell nothing of it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.language.headings import ENDS
from rpg.language.headlines import tells_nothing_else
from rpg.language.telling import may_tell
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_NAMES = (("title",), ("name",), ("task", "name"), ("task", "title"), ("topic",), ("theme",), ("skill",))
_GRADES = (("id",), ("task", "id"), ("difficulty",), ("level",), ("difficulty", "level"), ("version",), ("author",))
_GRADED = listed("easy simple hard difficult medium beginner beginners advanced expert low high intermediate")
_TOLD = (("description",), ("task", "description"), ("instruction",), ("instructions",))
"""Behind these the task itself is told."""
_LONGEST = 8
"""No name has more words."""


def field(tokens: Sequence[Token], at: int) -> int:
    """Where to go on behind a field that begins here, or `at`."""
    if at == 0 and len(tokens) > 3 and tokens[0].kind == "quote" and tokens[1].word == ":":
        return 2 if _named(str(tokens[0].value).lower().split(), tokens[2:]) else at
    colon = next((n for n in range(at + 1, min(at + 3, len(tokens) - 2)) if tokens[n].word == ":"), 0)
    called = tuple(token.word for token in tokens[at:colon])
    if not colon or called not in (*_NAMES, *_GRADES, *_TOLD, ("task",)):
        return at
    if called in _TOLD:
        return colon + 1 if at else at
    end = next((n for n in range(colon + 1, min(colon + _LONGEST, len(tokens))) if tokens[n].word in ENDS), 0)
    told, behind = tokens[colon + 1 : end], tokens[end + 1 :]
    if not end or not told or not behind:
        return at
    if called in _GRADES:
        graded = all(t.kind == "number" or t.word in _GRADED or len(t.word) == 1 for t in told)
        return end + 1 if graded or called == ("author",) else at
    words = [token for token in told if token.kind not in ("quote", "punct")]
    aimed = any(one.word in ("goal", "start") and other.word == ":" for one, other in pairwise(behind))
    named = all(tells_nothing_else(words, n, behind) for n in range(len(words)))
    return end + 1 if named and (aimed or called != ("task",)) else at


def _named(words: Sequence[str], behind: Sequence[Token]) -> bool:
    """Whether several words in quotation marks only call the text something."""
    return len(words) > 1 and all(not may_tell(w) or any(token.word == w for token in behind) for w in words)
