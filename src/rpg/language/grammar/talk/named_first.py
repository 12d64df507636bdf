"""Words that are told first and spelt then: "My name is Anna. Spell it with the letter cubes." asks to spell ANNA."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_WHOSE = frozenset({"my", "the", "our", "her", "his", "their", "your", "'s"})
_NAMES = frozenset({"name", "word"})
_BEFORE = frozenset({"please", "and", "so", "now", "can", "could", "would", "you", "then"})
_SPELL = frozenset({"spell", "write", "show", "build", "make", "form"})
_IT = Patterns("it|that|this", "that|this|the|my|our|her|his|their|your name|word")
_NAMED = Patterns("my|our|her|his|their|your name|word", "that|the name")
_CALLED = frozenset({"called", "named"})
_MARKS = frozenset({",", ":", "-"})


def with_names(parts: list[list[Token]]) -> list[list[Token]]:
    """Sentences, with the word in its place where one says which it is and the next what to do with it."""
    out: list[list[Token]] = []
    for part in parts:
        mark = next((n for n, token in enumerate(part) if token.word in _MARKS), 0)
        told = _spelt(part[:mark], part[mark + 1 :]) if mark else None
        before = _spelt(out[-1], part) if out and told is None else None
        if before is None and told is None and out and _introduced(out[-1]):
            before = part
        out[-1:] = [before] if before is not None else [*out[-1:], told or part]
    return out


def _introduced(part: Sequence[Token]) -> bool:
    """ "My name is Anna. Put the red block ...": who speaks, and no word to be spelt, if nothing more is said of it."""
    words = [token.word for token in part]
    whom = words[:3] == ["my", "name", "is"] or words[-2:-1] in (["called"], ["named"])
    return whom and len(words) > 3 and part[-1].kind in ("literal", "quote") and _tells(part)


def _spelt(named: Sequence[Token], told: Sequence[Token]) -> list[Token] | None:
    """What is said of a word behind "my name is Anna", with the word itself; None where it is no such thing."""
    if not named or named[-1].kind not in ("literal", "quote") or not _tells(named):
        return None
    begin = next((n for n, token in enumerate(told) if token.word not in _BEFORE), 0)
    p = Parser([*told])
    if ends := [*_IT.matches(p, begin + 1)] if p.stands(begin, _SPELL) else []:
        return [told[begin].saying("spell"), named[-1], *told[max(ends) :]]
    for at in range(1, len(told)) if len(named) > 1 else ():
        if ends := [*_NAMED.matches(p, at)]:
            return [*told[:at], named[-1], *told[max(ends) :]]
    return None


def _tells(named: Sequence[Token]) -> bool:
    """Whether no more is told than which word it is: "SOS!", "my name is Anna", "my granddaughter is called Zoe"."""
    words = [token.word for token in named[:-1]]
    whose = _WHOSE | harmless.PEOPLE
    if words[-1:] == ["is"]:
        return len(words) > 2 and words[-2] in _NAMES and whose.issuperset(words[:-2])
    called = words[-2:-1] == ["is"] and words[-1] in _CALLED
    return not words or (called and len(words) > 2 and whose.issuperset(words[:-2]))
