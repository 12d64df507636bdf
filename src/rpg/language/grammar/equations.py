"""Equations in signs and in words: "2+3=5", "two plus three equals five"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule

_WORD_SIGNS = {"plus": "+", "minus": "-", "times": "*", "multiplied by": "*", "divided by": "/", "x": "*"}


_WORD_EQUALS = ("is equal to", "equals", "equal", "is", "makes", "gives", "equals to")


@rule
def equation(p: Parser, i: int) -> Results[str]:
    """ "2+3=5", "two plus three equals five"."""
    token = p.token(i)
    if token is not None and token.kind == "equation" and isinstance(token.value, str):
        yield token.value, p.reach(i + 1)
    text, at, equals, signs = "", i, 0, 0
    while True:
        number = p.number(at)
        if number is None:
            break
        text, at = text + str(number), at + 1
        if equals and signs:
            yield text, at
        sign = next(((s, j) for w, s in _WORD_SIGNS.items() if (j := p.seq(at, w))), None)
        token = p.token(at)
        if sign is None and token is not None and token.kind == "sign" and token.word in "+-*/":
            sign = (token.word, p.reach(at + 1))
        if sign is not None:
            text, at, signs = text + sign[0], sign[1], signs + 1
            continue
        j = p.one(at, "=") or p.any_of(at, _WORD_EQUALS)
        if not j or equals:
            break
        text, at, equals = text + "=", j, 1


@rule
def unequal(p: Parser, i: int) -> Results[str]:
    """What stands where an equation should, and is none: "2+3", "2=2=2"."""
    text, at, signs = "", i, 0
    while at < p.end:
        number = p.number(at)
        found = next(((s, j) for w, s in (*_WORD_SIGNS.items(), ("equals", "=")) if (j := p.seq(at, w))), None)
        if number is not None:
            text, at = text + str(number), at + 1
        elif found is not None:
            text, at, signs = text + found[0], found[1], signs + 1
        elif (token := p.token(at)) is not None and token.kind in ("sign", "equation") and token.word:
            text, at, signs = text + str(token.value or token.word), p.reach(at + 1), signs + 1
        else:
            break
    if signs and at > max((j for _, j in equation(p, i)), default=0):
        yield text, at


_RESULTS = (
    "that equals", "that gives", "that makes", "that yields", "that adds up to", "with the result", "with a result of",
    "with a product that gives", "with a sum that gives", "with a product of", "whose result is", "giving", "equal to",
    "that comes to", "that is equal to", "resulting in", "which equals", "which gives", "for",
)  # fmt: skip


@rule
def promised(p: Parser, i: int) -> Results[str]:
    """ "(the sum) that equals seven: 3 + 4 = 7": an equation with the result that was said."""
    j = p.any_of(i, _RESULTS)
    result = p.number(j) if j else None
    for text, k in equation(p, p.opt(j + 1, ":", ",")) if result is not None else ():
        if str(result) in text.split("="):
            yield text, k
