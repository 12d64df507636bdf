"""Calculations that wait for a number: "put the correct answer after 2+2=", "fill in the missing number: 3 + ? = 7"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.grammar.structures.equations import value_of
from rpg.language.tokens import Token

_ANSWER = frozenset({"answer", "result", "solution", "missing"})
_PUT = frozenset({"put", "add", "place", "write", "set"})
_SOLVE = frozenset({"solve", "complete", "finish", "fill", "find", "show", *_PUT})
_BESIDE_WORDS = (
    "please the a right correct number digit block cube sum equation calculation problem behind after at end of to for "
    "with by putting adding placing it its in out and then so that is true on using blocks cubes makes equals equal "
    "sign : , ."
)
_BESIDE = frozenset(_BESIDE_WORDS.split())
_ALLOWED = _SOLVE | _ANSWER | _BESIDE
_SIGNS = frozenset("+-*/=")
_OPEN = "?"
_CANDIDATES = range(100)


def answers_wanted(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens of the whole equation: all that is said besides must ask for its number, and only one may fit."""
    tokens = [_as_minus(tokens, n) for n in range(len(tokens))]
    begin = next((n for n in range(len(tokens)) if _operand(tokens, n)), -1)
    end = _calculation(tokens, begin) if begin >= 0 else 0
    rest = words[:begin] + words[end:]
    if not end or not _ALLOWED.issuperset(rest) or any(t.kind == "number" for t in tokens[end:]):
        return None
    found = list(tokens[begin:end])
    shown = [token.word for token in found]
    if "=" not in shown and _PUT & {*rest} and _ANSWER & {*rest}:
        found, shown = [*found, _sign(found[-1])], [*shown, "="]
    open_ = shown.count(_OPEN) + (shown[-1] == "=")
    if open_ != 1 or shown.count("=") != 1 or not (_OPEN in shown or _SOLVE & {*rest}):
        return None
    if shown[-1] == "=":
        found, shown = [*found, found[-1]], [*shown, _OPEN]
    at = shown.index(_OPEN)
    fits = [n for n in _CANDIDATES if _true([*shown[:at], str(n), *shown[at + 1 :]])]
    if len(fits) != 1:
        return None
    found[at] = replace(found[at], kind="number", word=str(fits[0]), raw=str(fits[0]), value=float(fits[0]))
    return [tokens[begin].saying("make"), *found]


def _calculation(tokens: list[Token], begin: int) -> int:
    """The position behind "2 + 2 = ?"; 0 where there is no sign in it."""
    at = begin
    while _operand(tokens, at):
        at += 1
        if at >= len(tokens) or tokens[at].kind != "sign" or tokens[at].word not in _SIGNS:
            break
        at += 1
    return at if at > begin + 1 else 0


def _operand(tokens: list[Token], at: int) -> bool:
    """A whole number, or a mark for one beside a sign."""
    if at >= len(tokens):
        return False
    token = tokens[at]
    if token.word == _OPEN:
        beside = (*tokens[max(at - 1, 0) : at], *tokens[at + 1 : at + 2])
        return any(x.kind == "sign" and x.word in _SIGNS for x in beside)
    return token.kind == "number" and isinstance(token.value, float) and token.value.is_integer()


def _as_minus(tokens: list[Token], at: int) -> Token:
    """The token there; a minus between numbers with spaces around it may have been taken for a dash."""
    dash = tokens[at].kind == "punct" and tokens[at].raw in ("-", "–", "−")
    minus = dash and 0 < at < len(tokens) - 1 and _operand(tokens, at - 1) and _operand(tokens, at + 1)
    return replace(tokens[at], kind="sign", word="-") if minus else tokens[at]


def _sign(behind: Token) -> Token:
    return replace(behind, kind="sign", word="=", raw="=", value=None)


def _true(shown: list[str]) -> bool:
    """Whether both sides come to the same."""
    one, other = "".join(shown).split("=")
    left, right = value_of(one), value_of(other)
    return left is not None and left == right
