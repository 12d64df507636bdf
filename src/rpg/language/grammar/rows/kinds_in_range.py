"""Those of a range that are of a kind: "the even digits from 1 to 5" are 2 and 4; where the others are spoken of as
well, "... but not the odd ones", there is the whole range."""

from __future__ import annotations

import re

from rpg.blocks.traits import symbols_of
from rpg.language.grammar.rows.parting import text_of
from rpg.language.tokens import Token

_NOUN = "(?:digits|numbers|(?:digit|number) (?:blocks|cubes))"
_RANGE = "(?P<range>(?:(?:from|of) )?(?P<first>\\S) to (?P<last>\\S)|between (?P<low>\\S) and (?P<high>\\S))"
_KINDS = re.compile(
    f"(?:(?:all )?(?:the )?)(?P<kind>odd|even) {_NOUN} {_RANGE}(?= |$)"
    f"|(?:(?:all )?(?:the )?)(?P<letters>vowels|consonants) {_RANGE.replace('P<', 'P<l_')}(?= |$)"
)
_OPPOSITE = {"odd": "even", "even": "odd", "vowels": "consonants", "consonants": "vowels"}
_OTHERS = frozenset({"other", "others", "rest", "remaining", "only", "unless", "except"})


def kinds_in_range(tokens: list[Token]) -> list[Token]:
    """The tokens with such blocks listed one by one, or with the range told first."""
    words = [token.word for token in tokens]
    kinds = [word for word in words if word in _OPPOSITE]
    if not kinds:
        return tokens
    met = _KINDS.search(text_of(tokens))
    if met is None or (met.start() and text_of(tokens)[met.start() - 1] != " "):
        return tokens
    told = {name.removeprefix("l_"): found for name, found in met.groupdict().items() if found}
    kind = told.get("kind") or told["letters"]
    first, last = (told.get("first") or told["low"]).upper(), (told.get("last") or told["high"]).upper()
    whole = "".join(map(chr, range(ord(first), ord(last) + 1)))
    of_kind = [symbol for symbol in whole if symbol in symbols_of(kind.rstrip("s"))]
    if len(of_kind) in (0, len(whole)) or not (whole.isdigit() or whole.isalpha()):
        return tokens
    begin = met.string[: met.start()].count(" ")
    end = begin + met[0].count(" ") + 1
    say = tokens[begin].saying
    noun = "digits" if whole.isdigit() else "letters"
    if not {_OPPOSITE[kind], *_OTHERS}.isdisjoint(words):
        kept = end - told["range"].count(" ") - 1
        stock = [*map(say, ("there", "are", "the", noun)), _shown(first, tokens[begin]), say("to"),
                 _shown(last, tokens[begin]), say(".")]  # fmt: skip
        return [*stock, *tokens[:kept], *tokens[end:]]
    ends = tokens[end - 3], tokens[end - 1]
    listed = [x for symbol in of_kind for x in (_shown(symbol, ends[0]), say(","))][:-1]
    if len(of_kind) > 1:
        listed[-2] = say("and")
    return [
        *tokens[:begin],
        say("the"),
        ends[1].saying(noun if len(of_kind) > 1 else noun[:-1]),
        *listed,
        *tokens[end:],
    ]


def _shown(symbol: str, like: Token) -> Token:
    if symbol.isdigit():
        return Token("number", symbol, symbol, like.span, float(symbol))
    return Token("word", symbol.lower(), symbol, like.span)
