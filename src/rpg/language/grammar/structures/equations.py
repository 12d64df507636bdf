"""Equations in signs and in words: "2+3=5", "two plus three equals five"."""

from __future__ import annotations

import re
from fractions import Fraction

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns

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


_SOLVE = Patterns(
    "please? solve|compute|calculate|evaluate|work_out|figure_out|complete the? "
    "task|exercise|problem|sum|equation|calculation|product|expression?",
    "show|give|tell|lay_out|build|spell|make|find me|us? the result|answer|solution|outcome of|to|for",
    "show|give|tell|lay_out|build me|us? what",
)
"""What a calculation follows whose result is to be found, and shown with it."""


@rule
def solved(p: Parser, i: int) -> Results[str]:
    """ "solve 8/2", "work out six minus two": the equation with its result, if that is a whole number."""
    for j in _SOLVE.matches(p, i):
        side, k = operation(p, p.opt(j, ":", "of"))
        result = value_of(side) if k else None
        if result is not None and result.denominator == 1 and result >= 0:
            yield f"{side}={result}", p.opt(p.opt(k, "is", "equals", "gives", "makes", "="), "?")


_SIGNS = {"+": "+", "-": "-", "–": "-", "−": "-", "*": "*", "×": "*", "/": "/", "÷": "/"}


NAMED = {"sum": "+", "total": "+", "product": "*", "difference": "-", "quotient": "/"}
"""Calculations that are called by their names."""


def _of_two(p: Parser, i: int) -> tuple[str, int]:
    """ "the sum of 2 and 3": the text of that, and the position after it."""
    sign = p.lex(i, NAMED)
    j = p.any_of(i + 1, ("of", "between")) if sign else 0
    one, two = (p.number(j), p.number(j + 2)) if j and p.stands(j + 1, ("and",)) else (None, None)
    return (f"{one}{sign}{two}", p.reach(j + 3)) if one is not None and two is not None else ("", 0)


def operation(p: Parser, i: int) -> tuple[str, int]:
    """ "6 - 2", "three plus five", "the sum of 2 and 3": the text of a calculation, and the position after it."""
    if (named := _of_two(p, p.opt(i, "the")))[1]:
        return named
    text, at = "", i
    token = p.token(at)
    if token is not None and token.kind == "equation" and re.fullmatch(r"\d+([-+*/]\d+)+=?", str(token.value)):
        return str(token.value).removesuffix("="), p.reach(at + 1)
    if token is not None and token.kind == "dims" and isinstance(token.value, tuple) and len(token.value) == 2:
        return "{}*{}".format(*token.value), p.reach(at + 1)
    while (number := p.number(at)) is not None:
        text, at = text + str(number), at + 1
        found = next(((s, j) for w, s in _WORD_SIGNS.items() if (j := p.seq(at, w))), None)
        sign = p.tokens[at].raw if at < p.end else ""
        if found is None and sign in _SIGNS and p.number(at + 1) is not None:
            found = (_SIGNS[sign], p.reach(at + 1))
        if found is None:
            return (text, at) if re.search(r"[-+*/]", text) else ("", 0)
        text, at = text + found[0], found[1]
    return "", 0


def value_of(side: str) -> Fraction | None:
    """The value of a chain of operations, products first."""
    total = Fraction(0)
    for sign, term in re.findall(r"([-+]?)(\d+(?:[*/]\d+)*)", side):
        value = Fraction(1)
        for operator, number in re.findall(r"([*/]?)(\d+)", term):
            if operator == "/" and not int(number):
                return None
            value = value / int(number) if operator == "/" else value * int(number)
        total += -value if sign == "-" else value
    return total


_RESULT_ALONE = (
    "with the result", "with a result of", "with the result of", "with the answer", "whose result is",
    "whose answer is", "that gives", "that makes", "that equals", "that adds up to", "that comes to", "which gives",
    "which makes", "which equals", "giving", "with the sum", "whose sum is",
)  # fmt: skip
_AS_RESULT = tuple(
    f"as {its} {result}" for its in ("the", "its", "a") for result in ("result", "answer", "sum", "outcome", "total")
)


@rule
def result_alone(p: Parser, i: int) -> Results[int]:
    """ "(an addition) with the result 8", "(an equation) with an 8 as the result": no more is told of it than that."""
    told = p.any_of(i, _RESULT_ALONE)
    if told and (result := p.number(told)) is not None:
        yield result, told + 1
    shown = p.opt(p.opt(p.one(i, "with"), "a", "an", "the"), "number", "digit") if p.stands(i, ("with",)) else 0
    if shown and (result := p.number(shown)) is not None and (end := p.any_of(shown + 1, _AS_RESULT)):
        yield result, end


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
