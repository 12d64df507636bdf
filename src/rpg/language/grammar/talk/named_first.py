"""Words that are told first and spelt then: "My name is Anna. Spell it with the letter cubes." asks to spell ANNA."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_WHOSE = frozenset({"my", "the", "our", "her", "his", "their", "your", "daughter", "son", "friend", "'s"})
_NAMES = frozenset({"name", "word"})
_BEFORE = frozenset({"please", "and", "so", "now", "can", "could", "would", "you", "then"})
_SPELL = frozenset({"spell", "write", "show", "build", "make", "form"})
_IT = Patterns("it|that|this", "that|this|the|my|our|her|his|their|your name|word")


def with_names(parts: list[list[Token]]) -> list[list[Token]]:
    """Sentences, with the word in its place where one says which it is and the next what to do with it."""
    out: list[list[Token]] = []
    for part in parts:
        comma = next((n for n, token in enumerate(part) if token.word == ","), 0)
        told = _spelt(part[:comma], part[comma + 1 :]) if comma else None
        before = _spelt(out[-1], part) if out and told is None else None
        if before is None and told is None and out and _introduced(out[-1]):
            before = part
        out[-1:] = [before] if before is not None else [*out[-1:], told or part]
    return out


def _introduced(part: Sequence[Token]) -> bool:
    """ "My name is Anna. Put the red block ...": who speaks, and no word to be spelt, if nothing more is said of it."""
    words = [token.word for token in part]
    return words[:3] == ["my", "name", "is"] and len(words) == 4


def _spelt(named: Sequence[Token], told: Sequence[Token]) -> list[Token] | None:
    """What is said of a word behind "my name is Anna", with the word itself; None where it is no such thing."""
    words = [token.word for token in named]
    if len(named) < 4 or words[-2] != "is" or words[-3] not in _NAMES or not _WHOSE.issuperset(words[:-3]):
        return None
    if named[-1].kind not in ("literal", "quote"):
        return None
    begin = next((n for n, token in enumerate(told) if token.word not in _BEFORE), 0)
    p = Parser([*told])
    ends = [*_IT.matches(p, begin + 1)] if p.stands(begin, _SPELL) else []
    if not ends:
        return None
    return [told[begin].saying("spell"), named[-1], *told[max(ends) :]]
