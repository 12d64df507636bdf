"""How each of several structures is made: "one red and one blue", "the left one red on yellow"."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.structures.along import listed_along
from rpg.language.grammar.structures.part_words import IS
from rpg.language.grammar.structures.parts import part
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.labels import literal
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.strangers import STRANGERS
from rpg.language.later import later
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Structure, Toward, Traits

if TYPE_CHECKING:
    from rpg.language.grammar.places.onto import one_on_another
else:
    (one_on_another,) = later(__name__, "rpg.language.grammar.places.onto", "one_on_another")

_HAVING = (
    "from", "with", "having", "should have", "has to have", "must have", "made from", "out of", "made out of", "has",
    "of", "consists of", "consisting of", "contains", "gets", "built from", "built of", "which has", "made up of",
    "holds", "should hold", "must hold", "shall hold", "should contain", "must contain", "shall have", "is made of",
)  # fmt: skip
_UNITS = ("row", "tower", "stack", "column", "line", "group", "pile", "heap", "bunch", "cluster")
_ONES = (
    "one of them", "one", "the other one", "the other", "other", "another one", "another", "a second one",
    "a third one", "the first one", "the second one", "the third one", "the first", "the second", "the third",
    *(f"the {nth} {unit}" for nth in ("first", "second", "third") for unit in ("group", "pile", "heap", "bunch")),
    *(f"{one} {unit}" for one in ("one", "the other", "another", "a second", "a third") for unit in _UNITS),
    *(f"{noun} {n}" for noun in ("tower", "stack") for n in ("one", "two", "three", "four", "1", "2", "3", "4")),
)  # fmt: skip
_BY_HEIGHT = {
    f"the {word}{one}": tall
    for words, tall in (
        (("taller", "tallest", "higher", "highest", "bigger", "biggest"), True),
        (("shorter", "shortest", "lower", "lowest", "smaller", "smallest"), False),
    )
    for word in words
    for one in ("", " one", " tower", " stack")
}
"""One of several towers, by whether it is higher than the others or lower than they."""
_TOWERS = {f"{noun} {n}": k for k, ns in enumerate((("one", "1"), ("two", "2"), ("three", "3"), ("four", "4")), 1)
           for n in ns for noun in ("tower", "stack")}  # fmt: skip
_TURNS = _TOWERS | {
    f"the {nth}{one}": n
    for n, nth in enumerate(("first", "second", "third"), 1)
    for one in ("", " one", " group", " pile", " heap", " bunch")
}
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
        yield from _piles(p, i, start)
        yield from _strange_lots(p, i, start) if p.anywhere(_GROUPS) else ()
        for found, j in _wholes(p, i, start, ()):
            if len(found.items) > 1 and _heights_fit(p, found):
                yield _all_in_color(p, found, j), j
                yield from _taller_there(p, found, j)


def _taller_there(p: Parser, found: Coord, j: int) -> Results[Coord]:
    """ "(one three high and one two high), the taller one on the left": where each of two stands."""
    told = [x for x in found.items if isinstance(x, Absolute)]
    heights = [x.theme.amount.low if isinstance(x.theme, Noun) and x.theme.amount is not None else 0 for x in told]
    places = [x.adjuncts[0] for x in told]
    open_ = len(told) == _TWO and all(isinstance(x, Places) and x.side == "one" for x in places)
    start = p.any_of(j, ("with", ", with", ",", "and", ", and", ", so that", "so that"))
    if not open_ or not start or 0 in heights or heights[0] == heights[1]:
        return
    for phrase, k in p.standing(start, _BY_HEIGHT):
        k = p.any_of(k, IS) or p.any_of(k, ("standing", "stands", "being")) or k
        for side, end in p.standing(k, _WHERE):
            here, there = _WHERE[side], _OPPOSITE[_WHERE[side]]
            sides = (here, there) if (heights[0] > heights[1]) is _BY_HEIGHT[phrase] else (there, here)
            placed = [replace(at, side=s) for at, s in zip(places, sides, strict=True) if isinstance(at, Places)]
            items = tuple(replace(x, adjuncts=(at,)) for x, at in zip(told, placed, strict=True))
            yield replace(found, items=items, span=(found.span[0], p.char(end - 1, 1))), end


_TWO = 2
_OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front"}


def _all_in_color(p: Parser, found: Coord, j: int) -> Coord:
    """ "one 2 high, one 3 high, pink": set off from heights alone, a colour is that of all of them."""
    themes = [x.theme for x in found.items if isinstance(x, Absolute) and isinstance(x.theme, Noun)]
    looks = [theme.traits for theme in themes if theme.amount is not None]
    named = j - 1 if p.stands(j - 1, ("blocks", "cubes")) else j
    if len(looks) < len(found.items) or not p.stands(named - 2, (",", "all")) or not looks[-1].colors:
        return found
    if any(look != Traits() for look in looks[:-1]):
        return found
    painted = [replace(x, theme=replace(y, traits=looks[-1])) for x, y in zip(found.items, themes, strict=True)
               if isinstance(x, Absolute)]  # fmt: skip
    return replace(found, items=tuple(painted))


def _piles(p: Parser, i: int, at: int) -> Results[Coord]:
    """ ": red on blue, and green on yellow": one pile for each of several towers."""
    had: list[Absolute] = []
    while len(had) < 6:
        piled = max(one_on_another(p, at), key=lambda x: x[1], default=None)
        if piled is None:
            return
        order, end = piled
        items = order.items if order.first == "top" else order.items[::-1]
        whole = Coord(op="piled", items=items, span=p.span(at, end))
        place = Places(side="one", unit="whole", span=whole.span)
        had.append(Absolute(theme=whole, adjuncts=(place,), span=whole.span))
        if len(had) > 1:
            yield Coord(op="absolutes", items=tuple(had), span=p.span(i, end)), end
        at = p.any_of(end, (", and", ",", "and", ";"))
        if not at:
            return


@rule
def wholes_told(p: Parser, i: int) -> Results[Coord]:
    """In a sentence of its own: "one is red", "in the left one red sits on yellow, in the right one blue on green"."""
    yield from ((found, j) for found, j in _wholes(p, i, i, ()) if _heights_fit(p, found))


def _heights_fit(p: Parser, found: Coord) -> bool:
    """Whether "the taller one" of several is told to be higher than each of the others, and the shorter one lower."""
    told = [x for x in found.items if isinstance(x, Absolute)]
    heights = [x.theme.amount.low if isinstance(x.theme, Noun) and x.theme.amount is not None else None for x in told]
    for k, one in enumerate(told):
        at = next((n for n, token in enumerate(p.tokens) if token.span[0] == one.adjuncts[0].span[0]), -1)
        tall = next((_BY_HEIGHT[phrase] for phrase, _ in p.standing(at, _BY_HEIGHT)), None) if at >= 0 else None
        others = heights[:k] + heights[k + 1 :]
        mine = heights[k]
        if tall is not None and (mine is None or None in others or not others):
            return False
        if tall is not None and any((h < mine) != tall or h == mine for h in others if h is not None and mine):
            return False
    return True


def _whole(place: Meaning) -> Places | None:
    """The one of several structures that a place names."""
    if isinstance(place, At):
        return Places(side=place.side, unit="whole", span=place.span)
    return place if isinstance(place, Places) and place.unit in ("whole", "row", "column") else None


_WHOLLY = ("just", "simply", "merely",
           "entirely", "completely", "purely", "solely", "wholly", "all", "only", "fully", "exclusively",
           "made entirely of", "all in")  # fmt: skip
_TALL = ("high", "tall", "in height")


def _colored_and_tall(p: Parser, j: int) -> Results[Noun]:
    """ "blue and three high", "three blocks high and blue", "three blue blocks high"."""
    number = p.number(j)
    if number is not None:
        k = p.any_of(p.opt(j + 1, "blocks", "cubes", "block"), _TALL)
        of = p.any_of(p.opt(k, ","), _IN_COLOR) or p.opt(k, ",") if k else j + 1
        for named, end in color(p, of):
            last = p.opt(end, "blocks", "cubes")
            last = last if k else p.any_of(last, _TALL) if last > end else 0
            if last:
                yield _so_many(number, named, p.span(j, last)), last
    for named, end in color(p, j + 1) if number is not None else ():
        if end >= p.end or p.stands(end, (",", ";", "and", "but")):
            yield _so_many(number or 0, named, p.span(j, end)), end
    for named, end in color(p, j):
        k = p.any_of(end, ("and", ","))
        tall = p.number(k) if k else None
        last = p.any_of(p.opt(k + 1, "blocks", "cubes", "block"), _TALL) if tall is not None else 0
        if tall is not None and last:
            yield _so_many(tall, named, p.span(j, last)), last


_IN_COLOR = ("and all", "and", "of", "all", "in", "and in", "all in", "and all in", "made of", "and made of")
_OF_SO_MANY = frozenset({"of", "with", "has", "having", "contains", "gets"})
_ENDS = {
    **dict.fromkeys(("at the bottom", "below", "underneath", "at the base", "lowest", "at the very bottom"), 2),
    **dict.fromkeys(("in the middle", "in between", "between them", "in the center"), 1),
    **dict.fromkeys(("on top", "at the top", "above", "on the top", "highest", "at the very top"), 0),
}  # fmt: skip


def _by_ends(p: Parser, j: int) -> Results[Coord]:
    """ "red at the bottom and blue on top": a pile told by its places."""
    held: dict[int, Noun] = {}
    at = j
    while at and len(held) < 3:
        theme, k = next(
            ((x, k) for x, k in simple(p, at) if isinstance(x, Noun) and p.stands(k, _END_WORDS)), (None, 0)
        )
        place, end = max(p.standing(k, _ENDS), key=lambda found: found[1], default=("", 0)) if theme else ("", 0)
        if theme is None or not end or _ENDS[place] in held or theme.amount not in (None, Amount(1, 1)):
            return
        held[_ENDS[place]] = theme
        if set(held) >= {0, 2}:
            yield Coord(op="piled", items=tuple(held[n] for n in sorted(held)), span=p.span(j, end)), end
        at = p.any_of(end, (", and", ",", "and"))


_UPON = ("on top", "on top of it", "at the top", "on it")


def _topped(p: Parser, j: int) -> Results[Coord]:
    """ "(the left one is) red with blue on top": two blocks, one on the other."""
    for below, k in simple(p, j):
        top = p.any_of(k, ("with", ", with", "and has", "topped with", "topped by"))
        for above, end in simple(p, top) if top and isinstance(below, Noun) and _one_look(below) else ():
            last = p.any_of(end, _UPON) or (end if p.words[top - 2] == "topped" else 0)
            if last and isinstance(above, Noun) and _one_look(above):
                yield Coord(op="piled", items=(above, below), span=p.span(j, last)), last


def _along(p: Parser, j: int) -> Results[Coord]:
    """ "red, white, red from bottom to top": the blocks of a tower one by one."""
    for items, k in listed(p, j):
        for way, end in toward(p, p.opt(k, ",")):
            if isinstance(way, Toward) and way.first in ("top", "bottom") and all(map(_one_of_them, items)):
                falling = items if way.first == "top" else items[::-1]
                yield Coord(op="piled", items=falling, span=p.span(j, end)), end
    for order, end in listed_along(p, j):
        if order.first in ("top", "bottom") and all(map(_one_of_them, order.items)):
            falling = order.items if order.first == "top" else order.items[::-1]
            yield Coord(op="piled", items=falling, span=p.span(j, end)), end


def _one_of_them(item: Meaning) -> bool:
    return isinstance(item, Noun) and _one_look(item)


def _one_look(theme: Noun) -> bool:
    one = theme.amount in (None, Amount(1, 1)) and not theme.plural and theme.head != "patch"
    return one and len(theme.traits.colors + theme.traits.labels) == 1 and theme.part_of is None


_END_WORDS = frozenset(phrase.split()[0] for phrase in _ENDS)


def _so_many(number: int, named: str, span: Span) -> Noun:
    amount = Amount(number, number)
    return Noun(head="block", amount=amount, plural=number > 1, traits=Traits(colors=(named,)), span=span)


def _kind_of(p: Parser, j: int) -> Results[Meaning]:
    """What one of several structures is made of: a colour, a number of blocks, a word, or one block on another."""
    j = p.any_of(j, _WHOLLY) or j
    yield from _colored_and_tall(p, j)
    yield from _by_ends(p, p.opt(j, "with"))
    yield from _topped(p, j)
    yield from _along(p, j)
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
    counted_ = p.opt(j + 1, "block", *_UNIT_WORDS) if number else j
    high = p.any_of(counted_, ("high", "tall")) if number else 0
    if number and not high and p.follows(j, _OF_SO_MANY):  # "one has two floors and one has 4"
        last = j + 1 >= p.end and p.anywhere(_UNIT_WORDS)
        high = counted_ if last or p.stands(j + 1, _AFTER_NUMBERS) else 0
    if number and high:
        amount = Amount(number, number)
        yield Noun(head="block", amount=amount, plural=number > 1, span=p.span(j, high)), high
    for theme, k in simple(p, p.opt(j, "with")):
        if not isinstance(theme, Noun) or theme.part_of is not None or theme.head == "patch" or theme.conditions:
            continue
        if "all" in p.words[j + 1 : k]:  # "one of two and one of four blocks, all brown": all of both
            continue
        colors, marks = theme.traits.colors, theme.traits
        plain = marks == Traits(colors=colors) and len(colors) < 2
        counted = theme.amount is not None and (theme.det == "bare" or (theme.det == "the" and bool(colors)))
        labelled = len(marks.labels) > 1 and marks == Traits(labels=marks.labels, kind=marks.kind)
        labelled = labelled and theme.det in (("bare", "the") if p.anywhere(_GROUPS) else ("bare",))
        if (plain and (counted or (colors and theme.amount is None))) or labelled:
            yield theme, k
        a_class = marks == Traits(kind=marks.kind, quality=marks.quality) != Traits() and theme.plural
        a_class = a_class and theme.amount is None and theme.det in ("bare", "the") and not p.stands(k, ("in",))
        if a_class and p.anywhere(_GROUPS):
            yield theme, k
        in_turn = marks == Traits(colors=colors) and len(colors) > 1 and theme.amount is None and theme.det == "bare"
        if in_turn and (theme.head == "any" or not p.words[k - 1].endswith("s")):
            yield theme, k


_UNIT_WORDS = frozenset({"blocks", "cubes", "floors", "levels", "layers", "stories", "storeys", "floor", "level"})
_AFTER_NUMBERS = _UNIT_WORDS | {"and", ","}
_GROUPS = frozenset({"group", "groups", "bunch", "bunches", "pile", "piles", "cluster", "clusters", "heap", "heaps"})


def with_stranger(p: Parser, j: int) -> Results[Coord]:
    """ "four red ones with a blue stranger": blocks of one look, and so many of another among them."""
    for most, k in simple(p, j):
        lead = p.any_of(k, _AMID) if isinstance(most, Noun) and most.amount is not None else 0
        for strange, end in simple(p, p.opt(lead, "exactly", "only", "just")) if lead else ():
            told = p.any_of(end, _INSIDE) or (end if p.stands(end - 1, STRANGERS) else 0)
            looks = [x for x in (most, strange) if isinstance(x, Noun) and x.amount and len(x.traits.colors) == 1]
            if told and len(looks) == 2 and looks[0].traits != looks[1].traits:
                yield Coord(op="lot", items=tuple(looks), span=p.span(j, told)), told


_AMID = ("with", "including", "and", "plus", "but with", "but")
_INSIDE = ("in it", "among them", "in them", "in between", "inside", "inside it", "amongst them", "as a stranger")
"""Where a stranger is."""


def _strange_lots(p: Parser, i: int, at: int) -> Results[Coord]:
    """ ": four reds with one blue stranger, four blues with one red stranger": what each of several groups has."""
    had: list[Absolute] = []
    while at and (found := next(iter(with_stranger(p, at)), None)) is not None:
        place = Places(side="one", unit="whole", span=found[0].span)
        had.append(Absolute(theme=found[0], adjuncts=(place,), span=found[0].span))
        if len(had) > 1:
            yield Coord(op="absolutes", items=tuple(had), span=p.span(i, found[1])), found[1]
        at = p.any_of(found[1], _AND)


def _lot(p: Parser, j: int) -> Results[Coord]:
    """ "three red blocks and one blue one": blocks of several looks that one of them has."""
    yield from with_stranger(p, p.opt(j, "with")) if p.anywhere(_GROUPS) else ()
    for theme, k in noun_phrase(p, p.opt(j, "with")):
        items = theme.items if isinstance(theme, Coord) and theme.op == "and" else ()
        counted = [x for x in items if isinstance(x, Noun) and x.amount is not None and x.det in ("a", "bare")]
        looks = {x.traits for x in counted if x.head != "patch" and not x.conditions and x.part_of is None}
        if len(items) == len(counted) == len(looks) > 1:
            yield Coord(op="lot", items=items, span=p.span(j, k)), k


def _one(p: Parser, at: int) -> Results[Places]:
    """Which of them: "one", "the other", "the left one", "(in) the far row"."""
    for phrase, k in p.standing(at, _ONES):
        turn = _TURNS.get(phrase)
        side = "one" if turn is None else "first"
        unit = "whole stack" if {"tower", "stack"} & {*phrase.split()} else "whole"
        yield Places(side=side, unit=unit, index=turn, span=p.span(at, k)), k
    for _, k in p.standing(at, _BY_HEIGHT):
        yield Places(side="one", unit="whole stack", span=p.span(at, k)), k
    for found, k in part(p, at, "whole"):
        if (one := _whole(found)) is not None:
            yield one, k


def _told(p: Parser, at: int) -> Results[Absolute]:
    """One of them with what it is made of, either first: "the left one red", "three red blocks in one"."""
    start = p.one(at, "in") or at
    for place, j in _one(p, start):
        made = p.opt(j, ",") if start > at else p.any_of(j, _HAVING) or p.any_of(j, IS) or j
        made = p.any_of(made, ("there is", "there are")) or made if start > at else made
        letter = [made - 1] if made > j and p.words[made - 1] == "a" and p.tokens[made - 1].raw == "A" else []
        for k in (*letter, made):  # "the first is A on B"
            for theme, end in [*_kind_of(p, k), *(_lot(p, k) if k > j or start > at else ())]:
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(at, end)), end
    for theme, j in [*_kind_of(p, at), *_word(p, at), *_lot(p, at)]:
        if (lead := p.one(j, "in")) and p.stands(lead, ("the", "one", "another", "a")):
            for place, k in _one(p, lead):
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(at, k)), k
        for phrase, k in p.standing(j, _WHERE) if not isinstance(theme, Coord) or theme.op == "piled" else ():
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
        yield from _wholes(p, i, p.any_of(k, _AND) or k, whole) if len(whole) < 9 else ()
