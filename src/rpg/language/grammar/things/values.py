"""Numbers told by how large they are: "the digits greater than 4", "all number cubes of 5 or more"; and letters by
where they stand in the alphabet: "the letters after M"."""

from __future__ import annotations

import string
from collections.abc import Callable
from operator import ge, gt, le, lt

from rpg.blocks.traits import symbols_of
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.labels import symbol
from rpg.language.meaning import Noun, replace

_ARE = "that_are|which_are|that_is|which_is"
_SHOW = "with|showing|bearing|having|that_have|that_has|that_show|which_show|which_have|that_shows"
_NUMBER = "a|the? number|numbers|digit|digits|value|values"
_LEADS = (f"{_ARE}? ", f"{_SHOW} {_NUMBER} {_ARE}? ")
_MORE = Patterns(
    *(f"{lead}greater|larger|bigger|higher|more than the|number?" for lead in _LEADS),
    *(f"{lead}above|over" for lead in _LEADS),
)
_LESS = Patterns(
    *(f"{lead}smaller|lower|less|littler|fewer than the|number?" for lead in _LEADS),
    *(f"{lead}below|under" for lead in _LEADS),
)
_LEAST = Patterns(*(f"{lead}of? at_least" for lead in _LEADS))
_MOST = Patterns(*(f"{lead}of? at_most" for lead in _LEADS))
_PARTED = Patterns(*(f"{lead}divisible by the|number?" for lead in _LEADS))
_COMPARED = ((_MORE, ">"), (_LESS, "<"), (_LEAST, ">="), (_MOST, "<="), (_PARTED, "|"))
_COME = "that_come|which_come|coming"
_AFTER, _BEFORE = Patterns(f"{_COME}? after"), Patterns(f"{_COME}? before")
_OF = Patterns("of", _ARE, f"{_SHOW} {_NUMBER} of?")
_OR_MORE = ("or more", "or greater", "or larger", "or bigger", "or higher", "and up", "and more", "and higher",
            "and greater", "and larger", "and bigger", "and upwards")  # fmt: skip
_OR_LESS = ("or less", "or smaller", "or lower", "or fewer", "and less", "and smaller", "and lower")
_SHOWING = frozenset(_SHOW.replace("_", "|").split("|"))
_IN = frozenset({"in"})
_DIGITS = "1234567890"


@choice
def by_value(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """The noun from i on, which ends before j, with what follows it of its numbers; cubes that are not said to be
    number cubes are "with a number greater than 4"."""
    marks = noun.traits
    if marks.kind == "letter" and noun.plural and not marks.labels and noun.part_of is None and not marks.quality:
        for letters, end in _in_alphabet(p, j):
            yield replace(noun, traits=replace(marks, quality=letters), span=p.span(i, end)), end
    if noun.head == "patch" or marks.labels or noun.part_of is not None or marks.kind not in (None, "digit"):
        return
    if marks.kind is None and noun.head == "block" and not p.stands(j, _SHOWING):
        return
    for symbols, end in _told(p, j):
        had = symbols_of(marks.quality) if marks.quality else symbols
        if both := "".join(symbol for symbol in symbols if symbol in had):
            told = replace(marks, kind="digit", quality=both)
            yield replace(noun, head="block", traits=told, span=p.span(i, end)), end


def _told(p: Parser, j: int) -> Results[str]:
    """ "greater than 4", "of 5 or more", "divisible by 3": the digits of which this is so."""
    for patterns, sign in _COMPARED:
        for k in patterns.matches(p, j):
            many = p.number(k)
            if many is not None and not _measured(p, k):
                yield digits_that(sign, many), k + 1
    for k in (*_OF.matches(p, j), j):
        many = p.number(k)
        for told, sign in ((_OR_MORE, ">="), (_OR_LESS, "<=")) if many is not None else ():
            if end := p.any_of(k + 1, told):
                yield digits_that(sign, many or 0), end


def _in_alphabet(p: Parser, j: int) -> Results[str]:
    """ "(the letters) after M", "that come before M"; "(stack the letters) after A is on the mat" is told of a time."""
    for patterns, sign in ((_AFTER, ">"), (_BEFORE, "<")):
        for k in patterns.matches(p, j):
            shown = symbol(p, k)
            if shown is not None and shown.isalpha() and not p.stands(k + 1, _HAPPENS):
                told = "".join(letter for letter in string.ascii_uppercase if _SO[sign](ord(letter), ord(shown)))
                yield told, k + 1


_HAPPENS = frozenset({"is", "has", "was", "and"})


def _measured(p: Parser, k: int) -> bool:
    """ "cubes bigger than 4 cm", "rows longer than 3 blocks": no value of theirs."""
    inches = p.stands(k + 1, _IN)  # "greater than 4 in ascending order"
    return any(not inches for _ in length(p, k)) or p.stands(k + 1, lexicon.BLOCK)


def digits_that(sign: str, many: int) -> str:
    """The digits greater or smaller than a number, or divisible by it; 0, which all numbers divide, is not meant."""
    so = _SO[sign]
    return "".join(digit for digit in _DIGITS if so(int(digit), many))


_SO: dict[str, Callable[[int, int], bool]] = {
    ">": gt,
    "<": lt,
    ">=": ge,
    "<=": le,
    "|": lambda n, many: n > 0 and many > 0 and n % many == 0,
}
