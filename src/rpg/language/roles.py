"""In whose place somebody speaks: "as a bricklayer I ask for a wall" asks for what anybody would get."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.tokens import Token

_PERSONS = frozenset(PEOPLE.split("|"))
_MOST = 3
"""No role has more words."""
_THINGS = (lexicon.STRUCTURE, lexicon.BLOCK, lexicon.PATCH, lexicon.COLOR, lexicon.NUMBER, lexicon.ORDINAL)


def as_anyone(tokens: list[Token], known: Collection[str]) -> list[Token]:
    """The tokens with "user" for whatever trade is named where a text begins: "as a maths teacher, we want ...".

    The last word of it is a person, or one that means nothing here; "as a first step I want ..." names none.
    """
    words = [token.word for token in tokens[: _MOST + 5]]
    if words[:1] != ["as"] or words[1:2] not in (["a"], ["an"]):
        return tokens
    end = next((n for n in range(3, len(words)) if words[n] in ("i", "we")), 0)
    end -= bool(end) and words[end - 1] == ","
    told = words[2:end] if end else []
    if not 0 < len(told) <= _MOST or any(word in table for word in told for table in _THINGS):
        return tokens
    if any(t.kind != "word" for t in tokens[2:end]) or not (told[-1] in _PERSONS or told[-1] not in known):
        return tokens
    return [*tokens[:2], replace(tokens[end - 1], word="user", raw="user"), *tokens[end:]]
