"""Words that are told in one sentence and spelt in another: "My name is Anna. Spell it with the letter cubes." asks to
spell ANNA, and so does "Can you write my daughter's name? It's Anna."."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.phrases import Classes
from rpg.language.tokens import Token

_BEFORE = frozenset({"please", "and", "so", "now", "can", "could", "would", "you", "then"})
_SPELL = frozenset({"spell", "write", "show", "build", "make", "form"})
_SOMEBODY = {
    "whose": ("my|our|her|his|their|your",),
    "who": ("<whose>|the little|big|older|younger|youngest|oldest|best|new|first? <folk>",),
    "folk": (f"{PEOPLE}|baby|boy|girl|pet|doll|teddy",),
    "name": (
        "<whose> first|full|own? name|nickname",
        "<who> 's first|full? name|nickname",
        "the name|nickname of <who>",
    ),
}
_CLASSES = Classes(_SOMEBODY)
_NAMED = Patterns("<name>", "<whose> word", "that|the name", classes=_CLASSES)
_IT = Patterns("it|that|this", "that|this|the name|word", "<whose> word", "<name>", classes=_CLASSES)
_TELLS = Patterns(
    "<name> is", "the word|name is", "<who>|he|she is called|named", "i am called|named", classes=_CLASSES
)
_ANSWERS = Patterns("it|that|this|which is", "so it is", classes=_CLASSES)
_ASKS = Patterns(
    "spell|write|show|print|type|lay|put|place|make|build|form out|down|up? <name>",
    "spell|write|lay|show|make|build|form out|down? a|the|my|our|this|one? following? word|name",
    classes=_CLASSES,
)
_MARKS = frozenset({",", ":", "-"})
_SHOWN = frozenset({"literal", "quote"})
"""Kinds of words to be spelt."""


def with_names(parts: list[list[Token]]) -> list[list[Token]]:
    """Sentences, with the word in its place where one says which it is and another what to do with it."""
    out: list[list[Token]] = []
    for part in parts:
        mark = next((n for n, token in enumerate(part) if token.word in _MARKS), 0)
        told = (_spelt(part[:mark], part[mark + 1 :]) or _asked(part[:mark], part[mark + 1 :])) if mark else None
        before = (_spelt(out[-1], part) or _asked(out[-1], part)) if out and told is None else None
        if before is None and told is None and out and _introduced(out[-1]):
            before = part
        out[-1:] = [before] if before is not None else [*out[-1:], told or part]
    return out


def _introduced(part: Sequence[Token]) -> bool:
    """ "My name is Anna. Put the red block ...": who speaks, and no word to be spelt, if nothing more is said of it."""
    words = [token.word for token in part]
    whom = words[:3] == ["my", "name", "is"] or words[-2:-1] in (["called"], ["named"])
    return whom and len(words) > 3 and part[-1].kind in _SHOWN and _tells(part)


def _spelt(named: Sequence[Token], told: Sequence[Token]) -> list[Token] | None:
    """What is said of a word behind "my name is Anna", with the word itself; None where it is no such thing."""
    if not named or named[-1].kind not in _SHOWN or not _tells(named):
        return None
    begin = next((n for n, token in enumerate(told) if token.word not in _BEFORE), 0)
    p = Parser([*told])
    if ends := [*_IT.matches(p, begin + 1)] if p.stands(begin, _SPELL) else []:
        return [told[begin].saying("spell"), named[-1], *told[max(ends) :]]
    for at in range(1, len(told)) if len(named) > 1 else ():
        if ends := [*_NAMED.matches(p, at)]:
            return [*told[:at], named[-1], *told[max(ends) :]]
    return None


def _asked(told: Sequence[Token], named: Sequence[Token]) -> list[Token] | None:
    """ "Write my name with the cubes" with the word that is told behind it; None where it is no such thing."""
    if not named or named[-1].kind not in _SHOWN or any(token.kind in _SHOWN for token in told):
        return None
    begin = next((n for n, token in enumerate(told) if token.word not in _BEFORE), 0)
    ends = [*_ASKS.matches(Parser([*told]), begin)]
    if not ends or not (_tells(named) or any(j == len(named) - 1 for j in _ANSWERS.matches(Parser([*named]), 0))):
        return None
    return [told[begin].saying("spell"), named[-1], *told[max(ends) :]]


def _tells(named: Sequence[Token]) -> bool:
    """Whether no more is told than which word it is: "SOS!", "my name is Anna", "my granddaughter is called Zoe"."""
    return len(named) == 1 or any(j == len(named) - 1 for j in _TELLS.matches(Parser([*named]), 0))
