"""Wishes about letters and numbers that are often typed and cannot be read: what is wrong with them, and what works."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rpg.language.grammar.structures.equations import value_of
from rpg.passes.schema.hints.wish import Wish

_STRAY = frozenset({"stray-character"})
"""What else a refusal says of a sign that no cube shows."""
_LARGE = "greater|larger|bigger|higher|more"
_ABOUT_SIGNS = (
    Wish(
        re.compile(r"\d\s*[<>≤≥≠]\s*\d"),
        "no cube shows such a sign: there are + - * / and =",
        "write an equation, as in 'make 3 + 4 = 7'",
    ),
    Wish(
        re.compile(
            r"\b\d{1,2}:\d{2}\b|\b\d+\.\d+\.|\d\s?[$€£%]|[$€£]\s?\d|\b(?:date|price|dollars?|euros?|percent)\b", re.I
        ),
        "no cube shows a point, a colon or the sign of a currency",
        "write its digits alone, as in 'write the number 1230'",
    ),
    Wish(
        re.compile(r"\b(?:phone|telephone|zip|postal|pin|house|birth|lucky|favou?rite) (?:number|code)\b", re.I),
        "what number this is does not matter here",
        "say the number alone, as in 'write the number 1230'",
    ),
    Wish(
        re.compile(r"\bturn\b.*\b(?:into an? [\dA-Z]\b|(?:reads?|looks? like|shows?|becomes?) (?:an? )?[\dA-Z]\b)"),
        "a cube that is turned still shows the same symbol",
        "say how it is turned, as in 'turn the 6 upside down'",
        frozenset({"misplaced", "unused-block", "ambiguous"}),
    ),
    Wish(
        re.compile(r"\badds? up to\b|\bthe sum of (?:each|every|the|two|three)\b", re.I),
        "it is not said which numbers these are",
        "name them, as in 'put 4 and 6 on the yellow patch', or write an equation, as in 'make 4 + 6 = 10'",
    ),
    Wish(
        re.compile(rf"\b(?:numbers?|digits?)\b.*\b(?:{_LARGE}) than (?:the )?(?:9|\d\d+)\b", re.I),
        "no digit is so large: cubes show 0 to 9",
        "say for example 'put the numbers greater than 5 on the patch'",
    ),
    Wish(
        re.compile(
            r"^(?!.*\d.*\d).*\b(?:make|build|form|create)\b.*\b(?:largest|biggest|highest|greatest|smallest|lowest)\b.*\bnumber\b",
            re.I,
        ),
        "it is not said which digits there are",
        "name them, as in 'make the largest number with 3, 5 and 8'",
        frozenset({"no-referent"}),
    ),
    Wish(
        re.compile(r"\bmake \d+[.!]?$|^make \d+\b", re.I),
        "as one number, or as the result of a sum?",
        "say 'write the number 12', or 'make 5 + 7 = 12'",
    ),
    Wish(
        re.compile(r"\b\d+[- ]?(?:degrees?|°) angle\b|\b(?:at|in) an angle of \d+", re.I),
        "it is not said from where the angle is measured",
        "say by how much it is turned, as in 'turn the blue block by 45 degrees'",
    ),
)
SYMBOLS = (
    *(wish._replace(also=wish.also | _STRAY) for wish in _ABOUT_SIGNS),
    Wish(
        re.compile(r"^(?!.*\d ?[-+*/=]).*\b(?:sum|equation|calculation) (?:that|which|with|whose)\b", re.I),
        "it is not said which numbers the equation is made of",
        "say all of it, as in 'make 4 + 6 = 10'",
    ),
)
_ANSWER = re.compile(r"\b(?:answer|result|solution)\b", re.I)
_SUM = re.compile(r"(\d+)\s*([-+*/])\s*(\d+)")


def no_digit(text: str) -> Iterator[Wish]:
    """ "Put the answer to 7 + 8 on the patch": of what comes to no digit there is no cube."""
    told = _SUM.search(text) if _ANSWER.search(text) else None
    result = value_of("".join(told.groups())) if told is not None else None
    if told is not None and not (result is not None and result.denominator == 1 and 0 <= result <= 9):
        message = "a cube shows a single digit, and this comes to none"
        yield Wish(_ANSWER, message, "write the whole equation, as in 'make 4 + 6 = 10'", _STRAY)
