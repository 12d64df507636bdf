"""Equations out of single symbols: are they true, and which true one can given symbols form. Exact arithmetic."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice

OPERATORS = "+-*/"
SIGNS = str.maketrans({"×": "*", "x": "*", "X": "*", "·": "*", "÷": "/", ":": "/", "−": "-", "–": "-"})
MAX_TRIALS = 200_000
"""Arrangements of the symbols that a search looks at before it gives up."""


def plain(text: str) -> str:
    """`text` with ASCII operators and no spaces."""
    return "".join(text.split()).translate(SIGNS)


def is_true(text: str, longer: bool = False) -> bool:
    """Is `text` a true equation with one equals sign? Numbers have one digit, or no leading zero if `longer`."""
    sides = text.split("=")
    if len(sides) != 2:
        return False
    values = [value_of(side, longer) for side in sides]
    return None not in values and values[0] == values[1]


def value_of(text: str, longer: bool = False) -> Fraction | None:
    """The value of a sum of products without unary signs; None where `text` is none, or divides by zero."""
    tokens = _tokens(text, longer)
    if not tokens or len(tokens) % 2 == 0:
        return None
    total, sign = Fraction(0), 1
    product = Fraction(tokens[0])
    for operator, number in zip(tokens[1::2], tokens[2::2], strict=True):
        if operator == "*":
            product *= int(number)
        elif operator == "/":
            if int(number) == 0:
                return None
            product /= int(number)
        else:
            total += sign * product
            sign, product = (1 if operator == "+" else -1), Fraction(number)
    return total + sign * product


def _tokens(text: str, longer: bool) -> list[str] | None:
    """Numbers and operators in turn, or None."""
    tokens: list[str] = []
    for symbol in text:
        if symbol.isdigit():
            if len(tokens) % 2 == 0:
                tokens.append(symbol)
            elif longer and tokens[-1] != "0":
                tokens[-1] += symbol
            else:
                return None
        elif symbol in OPERATORS and len(tokens) % 2:
            tokens.append(symbol)
        else:
            return None
    return tokens


def same_equation(one: str, two: str) -> bool:
    """Are two equations the same, either side first?"""
    return one == two or (one.count("=") == 1 and "=".join(one.split("=")[::-1]) == two)


def solutions(symbols: Sequence[str], longer: bool = False) -> Iterator[str]:
    """The true equations that use every symbol once, in a fixed order; those that end in a single number first."""
    pool = sorted(symbols)
    found: list[str] = []
    for text in islice(_arrangements(pool, longer), MAX_TRIALS):
        if is_true(text, longer):
            if text[-2] == "=" or (longer and text.split("=")[1].isdigit()):
                yield text
            else:
                found.append(text)
    yield from found


def _arrangements(pool: list[str], longer: bool) -> Iterator[str]:
    """Distinct arrangements of the symbols in which numbers and operators take turns and one sign is an equals sign."""
    counts: dict[str, int] = {}
    for symbol in pool:
        counts[symbol] = counts.get(symbol, 0) + 1
    if counts.get("=", 0) != 1:
        return
    chosen: list[str] = []

    def extend(number_next: bool, numbers_left: int, others_left: int) -> Iterator[str]:
        if not numbers_left and not others_left:
            yield "".join(chosen)
            return
        if not longer and numbers_left - others_left != (1 if number_next else 0):
            return
        for symbol in counts:
            digit = symbol.isdigit()
            if not counts[symbol] or (not digit and number_next) or (digit and not number_next and not longer):
                continue
            if not digit and not numbers_left:
                continue
            counts[symbol] -= 1
            chosen.append(symbol)
            yield from extend(not digit, numbers_left - digit, others_left - (not digit))
            chosen.pop()
            counts[symbol] += 1

    digits = sum(count for symbol, count in counts.items() if symbol.isdigit())
    yield from extend(True, digits, len(pool) - digits)
