""" "The digits 1 to 5 but 3", "1 to 5 in a row, except for the 3": 1, 2, 4 and 5."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.phrases import behind
from rpg.language.tokens import Token

_EXCEPT = (("but", "not"), ("but",), ("except", "for"), ("except",), ("without",), ("other", "than"), ("apart", "from"),
           ("excluding",), ("minus",), ("all", "but"), ("leaving", "out"), ("not",), ("with", "the", "exception", "of"),
           ("but", "without"))  # fmt: skip
_TO = frozenset({"to", "through"})
_NOUNS = frozenset({"block", "cube", "letter", "number", "digit"})


def range_but(tokens: list[Token]) -> list[Token]:
    """The words with all that a range has but for what is taken out of it; "it" behind that is what was taken out."""
    words = [token.word for token in tokens]
    if not any(words[n] in _TO for n in range(1, len(words) - 1)) or not any(way[0] in words for way in _EXCEPT):
        return tokens
    for at in (n for n in range(1, len(words) - 2) if words[n] in _TO):
        all_of_it = _range(tokens[at - 1].raw, tokens[at + 1].raw)
        stop = next((n for n in range(at, len(words)) if words[n] in STOPS), len(words))
        for begin in range(at + 2, stop) if all_of_it else ():
            found = _taken_out(tokens, words, begin, stop)
            if found is None or found[0].raw not in all_of_it[1:-1] or (begin > at + 3 and found[1] < stop):
                continue
            out, end = found
            kept = [symbol for symbol in all_of_it if symbol != out.raw]
            listed = [t for symbol in kept for t in (_showing(symbol, tokens[at]), tokens[at].saying(","))][:-1]
            listed[-2] = tokens[at].saying("and")
            if begin > at + 2 and words[begin - 1] == "with":  # "... with all but C in red": of what is built
                continue
            head = begin - (words[begin - 1] == ",")
            return [*tokens[: at - 1], *listed, *tokens[at + 2 : head], *_named(tokens[end:], out)]
    return tokens


def _taken_out(tokens: list[Token], words: list[str], begin: int, stop: int) -> tuple[Token, int] | None:
    """The symbol behind "except for the", if it is one alone, and where that ends."""
    at = behind(words, begin, _EXCEPT)
    if not at:
        return None
    at += words[at : at + 1] == ["the"]
    at += at + 1 < stop and words[at] in _NOUNS
    alone = at < stop and words[at + 1 : at + 2] not in ([","], ["and"], ["or"])
    return (tokens[at], at + 1) if alone and _is_symbol(tokens[at].raw) else None


def _range(first: str, last: str) -> str:
    """All the symbols from one to another."""
    alike = _is_symbol(first) and _is_symbol(last) and first.isdigit() == last.isdigit()
    return "".join(map(chr, range(ord(first), ord(last) + 1))) if alike else ""


def _is_symbol(raw: str) -> bool:
    return len(raw) == 1 and raw.isascii() and (raw.isdigit() or raw.isupper())


def _showing(symbol: str, like: Token) -> Token:
    if symbol.isdigit():
        return Token("number", symbol, symbol, like.span, float(symbol))
    return Token("word", symbol.lower(), symbol, like.span)


def _named(rest: list[Token], out: Token) -> list[Token]:
    """ "(..., except for the 3). It goes ...": the 3."""
    if [t.word for t in rest[1:2]] == ["it"] and rest[0].word in STOPS:
        return [rest[0], rest[1].saying("the"), out, *rest[2:]]
    return rest
