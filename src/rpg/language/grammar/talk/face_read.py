"""On which face a symbol is that is turned: "the letter F on its cube's top face is upside down" is told of the F,
which is read from above anyway. What is on another face is not left out."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_THE_TOP = "top|upper|uppermost face|side|surface"
_FACE = Patterns(
    f"on|of|at the|its {_THE_TOP}",
    f"on|of|at the|its cube|block|cube_'s|block_'s {_THE_TOP}",
    "on|of the|its cube|block",
    f"on|at the {_THE_TOP} of the|its cube|block",
    "on its top|face",
)
_ON_TOP = Patterns("on top", "on_the|at_the top")
_TURNED = frozenset({"upside", "upright", "sideways"})
_WAYS = frozenset({"is", "reads", "should", "must", "shall", "has", "looks", "stands", "appears", *_TURNED})
_NAMED = frozenset({*lexicon.LETTER, *lexicon.DIGIT, *lexicon.SYMBOL})


def without_face(part: list[Token]) -> list[Token]:
    """The tokens without the face on which a symbol is read from above."""
    p = Parser(part)
    if _TURNED.isdisjoint(p.all):
        return part
    for i in range(1, p.end):
        shown = p.words[i - 1] in _NAMED
        known = shown or (p.words[i - 2] in {*_NAMED, "the"} and i > 1 and _symbol(part[i - 1]))
        ends = [*(_FACE.matches(p, i) if known else ()), *(_ON_TOP.matches(p, i) if shown else ())]
        for j in sorted(ends, reverse=True):
            if p.stands(j, _WAYS) or (p.stands(j, ("of",)) and p.words[i - 1] in _NAMED):
                return [*part[:i], *part[j:]]
    return part


def _symbol(token: Token) -> bool:
    """A letter or a digit by itself."""
    return len(token.raw) == 1 and (token.raw.isupper() or token.raw.isdigit())
