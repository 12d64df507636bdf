"""Cubes told by what is known of their symbols: "the letters of LAMP", "the answer to 2 + 3", "the larger of 3 and 7",
"the first letter of the alphabet", "those greater than 4"."""

from __future__ import annotations

import string

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.structures.equations import operation, value_of
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import label_list, literal
from rpg.language.grammar.things.values import by_value, digits_that
from rpg.language.meaning import Noun, Traits

_CUBE = "block|cube|brick|digit|number|number_cube|number_block|digit_cube|digit_block|one"
_SHOWS = "that|which shows|is|has|gives|contains|displays|reads"
_ANSWER = "answer|result|solution|sum|outcome"
_RIGHT = "correct|right"
_OF_IT = "to|of|for|from the? sum|problem|question|calculation|task|equation?"
_LARGEST = frozenset({"larger", "bigger", "greater", "higher", "largest", "biggest", "greatest", "highest"})
_OF_TWO = frozenset({"larger", "bigger", "greater", "higher", "smaller", "lower", "lesser"})
_RANKS = "larger|bigger|greater|higher|largest|biggest|greatest|highest|smaller|lower|lesser|smallest|lowest"
_LETTERS = ("the letters of", "letters of", "all letters of", "all the letters of", "the letters in")
_NAMED = ("the word", "the name", "word")
_THE_ANSWER = Patterns(
    f"the {_RIGHT}? {_ANSWER} {_OF_IT}",
    f"the|a {_CUBE} with|showing|for the {_RIGHT}? {_ANSWER} {_OF_IT}",
    f"the|a {_CUBE} {_SHOWS} the {_RIGHT}? {_ANSWER} {_OF_IT}",
    f"the|a {_CUBE} {_SHOWS} how_much|what",
)
_WHOSE_VALUE = Patterns(
    f"the|a {_CUBE} {_SHOWS}|equals|is_equal_to",
    f"the|a {_CUBE} equal to",
    f"the|a {_CUBE} with|showing the? value|number? of?",
)
_IS = ("is", "makes", "gives", "equals", "are", "make", "comes to")
_LARGER = Patterns(f"the {_RANKS} number|digit|one|cube|block|number_cube|value? of|out_of|among|from the? "
                   "two|three|four? numbers|digits|cubes|number_cubes|digit_cubes|blocks?")  # fmt: skip
_HIGHEST = Patterns("the highest|lowest number|digit|number_cube|number_block|digit_cube|digit_block")
_ALPHABET = ("of the alphabet", "in the alphabet", "of the abc", "in the abc", "from the alphabet")
_THE = frozenset({"the"})
_LETTER = frozenset({"letter", "letters"})
_THOSE = ("those", "all those", "all of those", "all", "the ones", "all the ones")
_MULTIPLES = ("multiples of", "the multiples of", "all multiples of", "all the multiples of", "a multiple of",
              "every multiple of")  # fmt: skip


def told_symbols(p: Parser, i: int) -> Results[Noun]:
    """The cubes that are told so at i."""
    yield from _letters_of(p, i)
    yield from _answer(p, i)
    yield from _larger(p, i)
    yield from _highest(p, i)
    yield from _of_alphabet(p, i)
    yield from _those(p, i)
    yield from _multiples(p, i)


@choice
def _letters_of(p: Parser, i: int) -> Results[Noun]:
    """ "the letters of the word LAMP": those letters, in no order yet."""
    j = p.any_of(i, _LETTERS)
    k = p.any_of(j, _NAMED) or j if j else 0
    text = literal(p, k) if k else None
    if text is not None and len(text) > 1 and text.isalpha():
        marks = Traits(labels=tuple(text), kind="letter")
        yield Noun(head="block", det="the", plural=True, traits=marks, span=p.span(i, k + 1)), k + 1


@choice
def _answer(p: Parser, i: int) -> Results[Noun]:
    """ "the answer to 2 + 3", "the cube that shows what 4 - 1 is": the cube with that digit."""
    for j in _THE_ANSWER.matches(p, i):
        side, k = operation(p, j)
        result = value_of(side) if k else None
        if p.follows(j, ("much", "what")) and k:
            k = p.any_of(k, _IS)
        if k and result is not None and result.denominator == 1 and 0 <= result <= 9:
            yield _digit(p, i, k, str(result)), k
    for j in (i, *_WHOSE_VALUE.matches(p, i)):
        side, k = operation(p, j) if j > i or p.stands(i, _THE) else ("", 0)
        result = value_of(side) if k else None
        if result is not None and result.denominator == 1 and 0 <= result <= 9:
            yield _digit(p, i, k, str(result)), k


def _digit(p: Parser, i: int, k: int, label: str) -> Noun:
    """The cube with a digit, told from i to k."""
    return Noun(head="block", det="the", traits=Traits(labels=(label,), kind="digit"), span=p.span(i, k))


@choice
def _larger(p: Parser, i: int) -> Results[Noun]:
    """ "the larger of 3 and 7", "the smallest of the digits 2, 5 and 8": one of the cubes that are listed."""
    for j in _LARGER.matches(p, i):
        rank = p.words[i + 1]
        for (labels, more), k in label_list(p, j, True):
            two = len(labels) == 2 or (rank not in _OF_TWO and len(labels) > 2)
            if more or not two or not "".join(labels).isdigit() or len({*labels}) < len(labels):
                continue
            found = max(labels) if rank in _LARGEST else min(labels)
            whole = Noun(head="block", det="the", plural=True, traits=Traits(labels=labels), span=p.span(j, k))
            marks = Traits(kind="digit", quality=found)
            yield Noun(head="block", det="the", part_of=whole, traits=marks, span=p.span(i, k)), k


@choice
def _highest(p: Parser, i: int) -> Results[Noun]:
    """ "the highest number": the largest one, where it is not the one on top."""
    for j in _HIGHEST.matches(p, i):
        marks = Traits(kind="digit", rank=p.words[i + 1])
        yield Noun(head="block", det="the", traits=marks, span=p.span(i, j), cost=1), j


@choice
def _of_alphabet(p: Parser, i: int) -> Results[Noun]:
    """ "the first letter of the alphabet", "the last three letters of the alphabet"."""
    start = p.one(i, _THE)
    last = p.one(start, "last") if start else 0
    rank = (p.lex(start, lexicon.ORDINAL) or 0) if start else 0
    j = last or (start + 1 if rank else 0)
    many = p.number(j) if j else None
    k = p.one(j + (many is not None), _LETTER) if j else 0
    end = p.any_of(k, _ALPHABET) if k else 0
    if not end or rank > len(string.ascii_uppercase) or (many is not None and rank > 1):
        return
    row = string.ascii_uppercase
    labels = row[-(many or 1) :] if last else row[: many or 1] if rank == 1 else row[rank - 1]
    marks = Traits(labels=tuple(labels), kind="letter")
    yield Noun(head="block", det="the", plural=len(labels) > 1, traits=marks, span=p.span(i, end)), end


@choice
def _those(p: Parser, i: int) -> Results[Noun]:
    """ "(of the digits 1 to 6,) those greater than 4"."""
    if j := p.any_of(i, _THOSE):
        those = Noun(head="any", det="the", plural=True, span=p.span(i, j))
        yield from by_value(p, i, j, those)


@choice
def _multiples(p: Parser, i: int) -> Results[Noun]:
    """ "the multiples of 3"."""
    j = p.any_of(i, _MULTIPLES)
    many = p.number(j) if j else None
    symbols = digits_that("|", many) if many is not None else ""
    if symbols:
        first = p.words[i]
        det = first if first in ("all", "the", "a") else "each" if first == "every" else "bare"
        one = first in ("a", "every")
        marks = Traits(kind="digit", quality=symbols)
        yield Noun(head="block", det=det, plural=not one, traits=marks, span=p.span(i, j + 1)), j + 1


_PARITIES = frozenset({"odd", "even"})
_NOUNS = frozenset(
    {*lexicon.BLOCK, *lexicon.DIGIT, "one", "ones", "number", "position", "positions", "place", "places"}
)


def both_parities(p: Parser, i: int) -> int:
    """ "(odd numbers on the left,) even on the right": with no noun of its own, where both are spoken of."""
    j = p.one(i, _PARITIES)
    return j if j and p.words[j] not in _NOUNS and p.all >= _PARITIES else 0
