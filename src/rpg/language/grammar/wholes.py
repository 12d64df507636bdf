"""How each of several structures is made: "one red and one blue", "the left one red on yellow"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.labels import literal
from rpg.language.grammar.nouns import simple
from rpg.language.grammar.parts import IS, part
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Structure, Traits

_HAVING = (
    "with", "having", "should have", "has to have", "must have", "made from", "out of", "made out of", "has", "of",
    "consists of", "consisting of", "contains", "gets", "built from", "built of", "which has", "made up of",
)  # fmt: skip
_UNITS = ("row", "tower", "stack", "column", "line", "group", "pile")
_ONES = (
    "one of them", "one", "the other one", "the other", "other", "another one", "another", "a second one",
    "a third one", "the first one", "the second one", "the third one",
    *(f"{one} {unit}" for one in ("one", "the other", "another", "a second", "a third") for unit in _UNITS),
)  # fmt: skip
_TURNS = {"the first one": 1, "the second one": 2, "the third one": 3}
_WHERE = {
    "behind": "back", "in front": "front", "at the back": "back", "in the back": "back", "at the front": "front",
    "in the front": "front", "on the left": "left", "on the right": "right", "to the left": "left",
    "to the right": "right", "nearer": "front", "nearest": "front", "farther away": "back", "left": "left",
    "right": "right",
}  # fmt: skip
"""Where one of several structures stands among them."""
_SPELLS = ("spells", "spelling", "reads", "reading", "says", "saying", "should spell", "should read", "must spell",
           "must read", "is the word", "being the word", "the word", "has the word")  # fmt: skip
_AND = (", and", ",", "and", ";", "but", ", but", ", while", "while", ", whereas")


@rule
def wholes(p: Parser, i: int) -> Results[Coord]:
    """ ", one red and one blue": how each of several structures looks; "the left one red and the right one blue"."""
    start = p.any_of(i, (",", ":", "with", "where", ", with", ", where", "of which", ", of which"))
    if start:
        for found, j in _wholes(p, i, start, ()):
            if len(found.items) > 1:
                yield found, j


@rule
def wholes_told(p: Parser, i: int) -> Results[Coord]:
    """In a sentence of its own: "one is red", "in the left one red sits on yellow, in the right one blue on green"."""
    yield from _wholes(p, i, i, ())


def _whole(place: Meaning) -> Places | None:
    """The one of several structures that a place names."""
    if isinstance(place, At):
        return Places(side=place.side, unit="whole", span=place.span)
    return place if isinstance(place, Places) and place.unit in ("whole", "row", "column") else None


def _kind_of(p: Parser, j: int) -> Results[Meaning]:
    """What one of several structures is made of: a colour, a number of blocks, a word, or one block on another."""
    from rpg.language.grammar.onto import one_on_another

    piled = list(one_on_another(p, p.opt(j, "with")))
    for order, end in piled:
        items = order.items if order.first == "top" else order.items[::-1]
        yield Coord(op="piled", items=items, span=p.span(j, end)), end
    if piled:
        return
    spelt = p.any_of(j, _SPELLS)
    if spelt and (text := literal(p, spelt)) is not None:
        yield Structure(kind="word", det="the", letter=text, span=p.span(j, spelt + 1)), spelt + 1
    number = p.number(j)
    high = p.any_of(p.opt(j + 1, "blocks", "cubes", "block"), ("high", "tall")) if number else 0
    if number and high:
        amount = Amount(number, number)
        yield Noun(head="block", amount=amount, plural=number > 1, span=p.span(j, high)), high
    for theme, k in simple(p, p.opt(j, "with")):
        if not isinstance(theme, Noun) or theme.part_of is not None or theme.head == "patch" or theme.conditions:
            continue
        colors, marks = theme.traits.colors, theme.traits
        plain = marks == Traits(colors=colors) and len(colors) < 2
        counted = theme.amount is not None and theme.det == "bare"
        labelled = len(marks.labels) > 1 and marks == Traits(labels=marks.labels, kind=marks.kind)
        if (plain and (counted or (colors and theme.amount is None))) or (labelled and theme.det == "bare"):
            yield theme, k


def _one(p: Parser, at: int) -> Results[Places]:
    """Which of them: "one", "the other", "the left one", "(in) the far row"."""
    for phrase, k in p.standing(at, _ONES):
        turn = _TURNS.get(phrase)
        side = "one" if turn is None else "first"
        yield Places(side=side, unit="whole", index=turn, span=p.span(at, k)), k
    for found, k in part(p, at, "whole"):
        if (one := _whole(found)) is not None:
            yield one, k


def _told(p: Parser, at: int) -> Results[Absolute]:
    """One of them with what it is made of, either first: "the left one red", "three red blocks in one"."""
    start = p.one(at, "in") or at
    for place, j in _one(p, start):
        made = p.opt(j, ",") if start > at else p.any_of(j, _HAVING) or p.any_of(j, IS) or j
        made = p.any_of(made, ("there is", "there are")) or made if start > at else made
        for theme, k in _kind_of(p, made):
            yield Absolute(theme=theme, adjuncts=(place,), span=p.span(at, k)), k
    for theme, j in [*_kind_of(p, at), *_word(p, at)]:
        if (lead := p.one(j, "in")) and p.stands(lead, ("the", "one", "another", "a")):
            for place, k in _one(p, lead):
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(at, k)), k
        for phrase, k in p.standing(j, _WHERE):
            where = Places(side=_WHERE[phrase], unit="whole", span=p.span(j, k))
            told = isinstance(theme, Noun) and (theme.amount is not None or bool(theme.traits.labels))
            if told or not isinstance(theme, Noun):
                yield Absolute(theme=theme, adjuncts=(where,), span=p.span(at, k)), k


def _word(p: Parser, at: int) -> Results[Meaning]:
    """ "SUN (in the far row)"."""
    text = literal(p, at)
    if text is not None and len(text) > 1 and text.isalpha():
        yield Structure(kind="word", det="the", letter=text, span=p.span(at, at + 1)), at + 1


def _wholes(p: Parser, i: int, at: int, had: tuple[Absolute, ...]) -> Results[Coord]:
    for told, k in _told(p, at):
        whole = (*had, told)
        yield Coord(op="absolutes", items=whole, span=p.span(i, k)), k
        again = p.any_of(k, _AND) or k
        if len(whole) < 9:
            yield from _wholes(p, i, again, whole)
