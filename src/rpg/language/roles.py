"""In whose place somebody speaks, and whose name it is: "as a bricklayer I ask for a wall" asks for what anybody would
get, and "my niece's name, OLA," is a word like any other."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from rpg.language import harmless, lexicon
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.tokens import Token

_PERSONS = harmless.PEOPLE | {*PEOPLE.split("|"), "worker", "lead", "member"}
_MOST = 3
"""No role has more words."""
_THINGS = (lexicon.STRUCTURE, lexicon.BLOCK, lexicon.PATCH)
_LOOKS = (lexicon.COLOR, lexicon.NUMBER, lexicon.ORDINAL)


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
    if not 0 < len(told) <= _MOST or any(t.kind != "word" for t in tokens[2:end]):
        return tokens
    told_of = told[:-1] if told[-1] in _PERSONS else told  # "line worker", "block designer"
    if any(word in table for word in told for table in _LOOKS) or (
        told_of == told and (told[-1] in known or any(word in table for word in told for table in _THINGS))
    ):
        return tokens
    return [*tokens[:2], replace(tokens[end - 1], word="user", raw="user"), *tokens[end:]]


_BE = frozenset({"be", "is", "look"})
_VERY = frozenset({"so", "very", "really", "quite", "most", "totally", "rather", "pretty", "super", "just"})
_OF_LIKING = (frozenset({"satisfying", "pleasing"}) | harmless.FINE) - {"possible", "okay", "ok", "true", "fair"}


def as_nice(tokens: list[Token]) -> list[Token]:
    """The tokens with "nice" for whatever is thought of it where a text begins: "it would be so cute if ..."."""
    words = [token.word for token in tokens[:8]]
    be = next((n for n in range(1, len(words)) if words[n] in _BE), 0)
    at = be + 1
    while at < len(words) and words[at] in _VERY:
        at += 1
    begun = words[:1] in (["it"], ["that"])
    if not (be and begun and at + 1 < len(words) and words[at + 1] in ("if", "to") and words[at] in _OF_LIKING):
        return tokens
    return [*tokens[: be + 1], tokens[at].saying("nice"), *tokens[at + 1 :]]


_MARKS = {",": ",", "(": ")", ":": ""}
"""What sets a name off, and what closes it."""
_OWN = frozenset({"my", "our", "your", "his", "her", "their", "the"})
_LONGEST = 4


def names_as_words(tokens: list[Token]) -> list[Token]:
    """The tokens with "the word" for whosever name is told in capitals: "my little niece's name, OLA,", "my name,
    LEO,"."""
    words = [token.word for token in tokens]
    at = words.index("name") if "name" in words else 0
    if not at or (words[at - 1] != "'s" and words[at - 1] not in _OWN):
        return tokens
    mark = at + 1 + (words[at + 1 : at + 2] != [] and words[at + 1] in _MARKS)
    begin = next((n for n in range(at - 1, max(at - 2 - _LONGEST, -1), -1) if words[n] in _OWN), at)
    shown = mark < len(tokens) and tokens[mark].kind == "word" and tokens[mark].raw.isupper() and len(words[mark]) > 1
    if begin == at or not shown or any(word in table for word in words[begin:at] for table in (*_THINGS, *_LOOKS)):
        return tokens
    end = mark + 1
    end += mark > at + 1 and words[end : end + 1] == [_MARKS[words[at + 1]]]
    the, word = tokens[begin].saying("the"), tokens[at].saying("word")
    return [*tokens[:begin], the, word, tokens[mark], *tokens[end:]]
