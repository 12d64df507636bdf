"""Absolute phrases: "with the red block on top and the blue one below it"."""

from __future__ import annotations

from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.all_but_part import all_but_part
from rpg.language.grammar.places.amid import amid, several
from rpg.language.grammar.places.borne import bearing, borne
from rpg.language.grammar.places.flanked import flanked
from rpg.language.grammar.places.formed import formed
from rpg.language.grammar.places.in_turn import in_turn, one_by_one
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.places.said_inside import said_inside
from rpg.language.grammar.places.sides import SIDES, UTMOST, at
from rpg.language.grammar.structures.apposed import AMID
from rpg.language.grammar.structures.parts import part, part_statement, unit_of
from rpg.language.grammar.things.had_relatives import of_the_nearest, told_of_which
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.printed import shown
from rpg.language.grammar.things.retold import begins_anew
from rpg.language.grammar.things.standby import AS_EXTRAS
from rpg.language.lexicon import COLOR, STRUCTURE
from rpg.language.meaning import (
    Absolute,
    At,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Places,
    Pronoun,
    Structure,
    TableTop,
    Traits,
    replace,
)

_LEADS = (
    "with", "having", "where", "keeping", "whose", "and with", "but with", "crowned by", "crowned with", "topped by",
    "topped with", "that has", "which has", "and has", "that have", "which have", "using",
)  # fmt: skip
_INITIALLY = ("that initially has", "which initially has", "that currently has", "which currently has", "that now has")
"""What is reversed is told as it begins anyway."""
_PART_LEADS = (
    "in which", "of which", "so that", "such that", "except that", "except", "except for", "apart from",
    "save for", "but", "but where", "but whose", "only",
    "and where", "and whose", "with just", "with only", "and", "that has", "which has", "that have", "and has",
)  # fmt: skip
"""What only a statement about a part of the structure follows, beside the others."""
_EXTREMES = {"smallest": "smallest", "largest": "largest", "biggest": "largest"}
STARTING = ("starting with", "beginning with", "starting from", "start with", "begin with")
_THAT = ("that ", "which ", "and ", "so that it ", "and that ")
_STARTS = (*STARTING, *(f"{that}{starts} with" for that in _THAT for starts in ("starts", "begins")))
_ENDING = (
    *("ending with", "ending in", "and ending with", "finishing with", "and finishing with"),
    *(f"{that}{ends} with" for that in _THAT for ends in ("ends", "finishes")),
)


def starting(p: Parser, i: int) -> Results[Meaning]:
    """ "starting with the red one (at the bottom)", "that ends with blue on the right": what is at an end of a line."""
    for first, j in _at_end(p, i, _STARTS):
        yield first, j
        for last, k in _at_end(p, j, _ENDING):
            yield Coord(op="absolutes", items=(first, last), span=p.span(i, k)), k
    yield from _at_end(p, i, _ENDING)


@choice
def _at_end(p: Parser, i: int, leads: tuple[str, ...]) -> Results[Absolute]:
    """What is first, or last, or where it is said to be."""
    j, first = p.any_of(p.opt(i, ","), leads), leads is _STARTS
    for theme, k in simple(p, j) if j else ():
        if not isinstance(theme, Noun) or theme.head == "patch" or not STRUCTURE.keys().isdisjoint(p.words[k : k + 1]):
            continue  # nor "starting with a red tower"
        sides = at(p, k)
        if not sides:
            place = Places(side="first" if first else "last", unit="block", index=1 if first else None, span=theme.span)
            yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, k)), k
        for side, end_ in sides:
            yield Absolute(theme=theme, adjuncts=(side,), span=p.span(i, end_)), end_


@rule
def absolute(p: Parser, i: int) -> Results[Meaning]:
    """ "with the red block on top and the blue one below it"; "the green one on top" after a comma."""
    comma = p.opt(i, ",", ":")
    yield from starting(p, i)
    yield from borne(p, i)
    yield from flanked(p, i)
    yield from all_but_part(p, i)
    yield from _of_parts(p, i, comma)
    j = p.any_of(comma, _LEADS) or (comma if comma > i else 0)
    if not j and (begun := p.any_of(i, _INITIALLY)) and "reverse" in p.all:
        j = begun
    if not j or (p.words[j - 1] == "keeping" and p.follows(i, ("always", "constantly", "permanently"))):
        return
    if p.words[j - 1] in ("by", "with") and p.words[j - 2] in ("crowned", "topped"):
        for theme, k in simple(p, j):
            yield Absolute(theme=theme, adjuncts=(At(side="top", span=p.span(i, j)),), span=p.span(i, k)), k
        return
    if p.words[comma] in ("that", "which") and "with" in p.words[:comma]:
        return  # "red with a blue block to its right that has a white one on it": of the blue one
    for first, end in said_inside(p, j, _one_absolute(p, j)):
        first_place = first.adjuncts[0]
        if j == comma and isinstance(first_place, At) and several(first.theme) and _has_comma(p, first.theme):
            continue  # "red, blue, red leftmost": told of the last one alone
        cost = 2 if _on_the_table(first_place) or (j == comma and isinstance(first_place, Loc)) else 0
        cost += isinstance(first_place, At)
        nearest = of_the_nearest(p, comma, first_place)
        first = replace(first, cost=cost + 2 * shown(p, i, first) + 3 * nearest)
        first = told_of_which(first, p.span(comma, comma + 1)) if nearest else first
        yield first, end
        yield from _absolute_more(p, i, end, (first,))


def _on_the_table(place: Meaning) -> bool:
    return isinstance(place, Loc) and isinstance(place.landmark, TableTop)


def _of_parts(p: Parser, i: int, comma: int) -> Results[Meaning]:
    """ "in which the first row is red and the others blue": statements about parts alone."""
    listed = p.stands(comma, ("and",)) and p.words[comma - 2 : comma - 1] == ["with"] and p.words[comma - 1] in COLOR
    j = p.any_of(comma, _PART_LEADS) if not listed else 0  # "with red and blue in the front row": both are there
    but = p.stands(comma, _EXCEPTING)
    for first, end in [*(part_statement(p, j) if j else ()), *(_excepted(p, comma) if but else ())]:
        first = _not_further(first) if but else first
        yield first, end
        yield from _absolute_more(p, i, end, (first,))


_EXCEPTING = frozenset({"but", "except", "apart", "save", "other", "everywhere", "everything"})
_EXCEPT = tuple(
    f"{lead}{but}{at}"
    for lead in ("", "everywhere ", "everything ")
    for but in ("except", "except for", "apart from", "but", "but for", "save for", "other than", "except only")
    for at in ("", " in", " at")
)
_WHICH = tuple(
    f"{comma}{which} {be}"
    for comma in (", ", "")
    for which in ("which", "that", "where there", "it", "they", "that one")
    for be in ("is", "are", "should be", "must be", "has to be", "shall be")
)


def _excepted(p: Parser, i: int) -> Results[Absolute]:
    """ "(all white) except for the centre, which is red", "everywhere but in the middle, where there is a red one"."""
    j = p.any_of(i, _EXCEPT)
    for place, k in [*part(p, j), *at(p, j)] if j else ():
        look = p.any_of(k, _WHICH)
        for theme, end in simple(p, look) if look else ():
            plain = (
                isinstance(theme, Noun) and theme.head != "patch" and theme.traits == Traits(colors=theme.traits.colors)
            )
            if plain and isinstance(place, At | Places) and len(getattr(theme, "traits", Traits()).colors) == 1:
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end)), end


def _not_further(part_: Absolute) -> Absolute:
    """ "five white blocks, but the ends are red": the ends are among the five, so that these cannot be so."""
    theme, place = part_.theme, part_.adjuncts[0]
    among = isinstance(theme, Noun) and isinstance(place, Places) and theme.det == "bare" and theme.amount is None
    return replace(part_, theme=replace(theme, det="some")) if among and isinstance(theme, Noun) else part_


@rule
def sided(p: Parser, i: int) -> Results[Meaning]:
    """Absolutes about the sides of a structure alone."""
    for found, j in absolute(p, i):
        parts = found.items if isinstance(found, Coord) else (found,)
        if all(isinstance(x, Absolute) and isinstance(x.adjuncts[0], At | Places) for x in parts):
            if isinstance(found, Coord):
                found = replace(found, items=(replace(parts[0], cost=0), *parts[1:]))
            yield replace(found, cost=0), j


_TOUCHING = frozenset({"touching", "adjoining"})
_SIDED = {**SIDES, "lower": "bottom", "upper": "top", "middle": "middle"}
_THE_ONE = ("any", "the", None, Traits())
"""A noun phrase that says nothing of a block."""


def _one_absolute(p: Parser, j: int, unit: str = "") -> Results[Absolute]:
    """ "a red block at the bottom" or "bottom red"."""
    yield from part_statement(p, j, unit)
    for theme, k in noun_phrase(p, j):
        bare = isinstance(theme, Noun) and (theme.head, theme.det, theme.amount, theme.traits) == _THE_ONE
        if bare or (isinstance(theme, Pronoun) and p.stands(k, ("above", "below"))):  # "everything above" is the rest
            continue
        yield from bearing(p, j, k, theme)
        if p.stands(k, ("left", "right")) and (not p.stands(k + 1, ("of",)) or p.stands(k + 2, _MARKS)):
            yield from ((Absolute(theme=theme, adjuncts=x, span=p.span(j, end)), end) for x, end in _places(p, k))
        for shape, end in formed(p, k, theme):
            spots = [(x, e) for x, e in _places(p, end) if isinstance(x[0], Loc)]
            yield from ((Absolute(theme=shape, adjuncts=x, span=p.span(j, e)), e) for x, e in spots)
        k = p.opt(_again(p, k), "is", "are", "being", "goes", "should", "lying", "standing", "left")
        k = p.opt(p.opt(k, "be"), "placed", "sitting", "standing", "resting", "positioned", "located", "put", "lying")
        for found, end in _places(p, k):
            if not (isinstance(found[0], At) and begins_anew(theme)):
                yield Absolute(theme=theme, adjuncts=found, span=p.span(j, end)), end
            for again, last in _places(p, end) if _on_the_table(found[0]) else ():
                if isinstance(again[0], Loc):  # "with a green one on the table to the right of them"
                    yield Absolute(theme=theme, adjuncts=(*again, *found), span=p.span(j, last)), last
            more = p.one(end, "and") if isinstance(found[0], Loc) and p.stands(end + 1, _TOUCHING) else 0
            for again, last in _places(p, more) if more else ():  # "standing behind the gray one and touching it"
                yield Absolute(theme=theme, adjuncts=(*found, *again), span=p.span(j, last), cost=-1), last
    if rank := p.peek(j, _EXTREMES):
        best = Noun(head="any", det="the", traits=Traits(rank=rank), span=p.span(j, j + 1))
        yield from ((Absolute(theme=best, adjuncts=x, span=p.span(j, e)), e) for x, e in _places(p, p.reach(j + 1)))
    the = p.opt(j, "the", "whose")
    the = p.opt(the, "the")
    if side := p.peek(the, _SIDED):
        k = p.opt(p.reach(the + 1), "one", "block", "cube", "layer")
        k = p.opt(p.opt(k, "is", "being", ":", "should"), "be")
        for theme, end in simple(p, k):
            if isinstance(theme, Noun) and theme.traits.rank is None:  # nor "the front left one"
                own = the > j or p.follows(j, ("whose",))
                place = At(side=side, own=own, utmost=p.words[the] in UTMOST, span=p.span(j, k))
                yield Absolute(theme=theme, adjuncts=(place,), span=p.span(j, end), cost=1), end


def _absolute_more(p: Parser, i: int, at_: int, had: tuple[Meaning, ...]) -> Results[Meaning]:
    """ "... and blue on top", "... then green": further ones, in one record."""
    j = p.opt(at_, ",")
    then = p.any_of(j, ("and then", "then", "followed by"))
    j = then or p.any_of(j, ("and", "but", "while", ";")) or j
    if j == at_ or len(had) > 12:
        return
    j = p.any_of(j, ("with", "where", "whose", "having")) or j
    unit = unit_of(had[-1]) if isinstance(had[-1], Absolute) else ""
    more = list(_one_absolute(p, j, unit))
    more += [*_besides_these(p, j, had), *_there_too(p, j, had[-1])] if not then else ()
    more = list(amid(p, j, had)) or more
    if then:
        more = [(one, end) for one, end in more if not _relative_to_it(one)]
        more += [
            (Absolute(theme=t, adjuncts=(At(side="next", span=t.span),), span=t.span), _past_it(p, k, had))
            for t, k in simple(p, j)
            if isinstance(t, Noun) or (isinstance(t, Pronoun) and t.word == "one")
        ]
    for one, end in more:
        if then and len(getattr(one.theme, "items", ())) > 1:
            one = replace(one, cost=one.cost + 1)
        turns = in_turn(one)
        apart = turns or (one_by_one(p, one) if then or _comes_next(had[-1]) else ())
        told = [apart] if turns or (apart and _has_comma(p, one.theme)) else [(one,), apart] if apart else [(one,)]
        for parts in told:
            whole = (*had, *parts)
            yield Coord(op="absolutes", items=whole, span=p.span(i, end)), end
            yield from _absolute_more(p, i, end, whole)


def _there_too(p: Parser, i: int, last: Meaning) -> Results[Absolute]:
    """ "(red in the corners) and in the middle": the same look in a further place."""
    look = last.theme if isinstance(last, Absolute) else None
    if isinstance(look, Noun) and look.amount is None and look.det == "bare" and p.stands(i, ("in", "at", "on")):
        places = dict.fromkeys((x, k) for x, k in (*part(p, i + 1), *at(p, i)) if isinstance(x, At | Places))
        yield from ((Absolute(theme=look, adjuncts=(x,), span=p.span(i, k)), k) for x, k in places)


def _besides_these(p: Parser, i: int, had: tuple[Meaning, ...]) -> Results[Absolute]:
    """ "(a tower of three with red at the bottom) and (over it) two white blocks": all others of the whole."""
    if not all(isinstance(x, Absolute) and isinstance(x.adjuncts[0], At) for x in had):
        return
    for theme, k in simple(p, _past_it(p, i, had)):
        if not isinstance(theme, Noun) or theme.det != "bare" or theme.head == "patch" or theme.part_of or theme.cost:
            continue
        look, many = theme.traits, theme.amount
        told = Traits(colors=look.colors, labels=look.labels, kind=look.kind) == look != Traits()
        if many is not None and many.low == many.high and told and (k >= p.end or p.words[k] in (",", ";")):
            rest = Places(side="rest", unit="block", several=many.low, span=p.span(i, k))
            yield Absolute(theme=replace(theme, amount=None), adjuncts=(rest,), span=rest.span), k


_ONWARD = {
    "top": ("below it", "under it", "beneath it", "underneath it", "below that", "under that", "beneath that"),
    "bottom": ("above it", "on it", "on top of it", "above that", "on that", "over it"),
}  # fmt: skip
"""What is said of the one that comes next, from the top or from the bottom on."""


def _past_it(p: Parser, i: int, had: tuple[Meaning, ...]) -> int:
    """ "red on top, then yellow below it": the words after what comes next, where they say no more than that."""
    first = had[0].adjuncts[0] if isinstance(had[0], Absolute) else None
    side = first.side if isinstance(first, At) else ""
    return p.any_of(i, _ONWARD.get(side, ())) or _again(p, i)


def _again(p: Parser, i: int) -> int:
    """ "black, then white, then black again": behind a look that was named before."""
    return p.opt(i, "again") if p.words[i - 1] in p.words[: i - 1] else i


def _relative_to_it(part: Absolute) -> bool:
    """Whether a part is told by what "it" is, which may be the part before or the whole."""
    places = (place.landmark for place in part.adjuncts if isinstance(place, Loc))
    return any(isinstance(mark, Pronoun) and mark.word in ("it", "that") for mark in places)


def _comes_next(part: Meaning) -> bool:
    return isinstance(part, Absolute) and isinstance(part.adjuncts[0], At) and part.adjuncts[0].side == "next"


def _has_comma(p: Parser, theme: Meaning | None) -> bool:
    span = theme.span if theme is not None else (0, 0)
    return any(token.word == "," for token in p.tokens if span[0] <= token.span[0] < span[1])


_ON_THEM = (
    *(
        f"{lies}{them}"
        for lies in ("", "resting ", "lying ", "sitting ", "standing ")
        for them in ("on both", "on both of them", "on them", "of them", "of both", "of those")
    ),
    "bridging them", "bridging both", "spanning both", "bridging the two", "on the two", "across both", "across them",
)  # fmt: skip
"""What is said of the one on top of several, and adds nothing to that."""
_RESTING = tuple(x for x in _ON_THEM if not x.endswith(("of them", "of both", "of those", "on them")))
"""By itself it tells that a block is on top."""


@rule
def one_more(p: Parser, i: int) -> Results[Absolute]:
    """ "(with a base of two blocks and) one block on top": a part after the size."""
    yield from ((x, k) for x, k in _one_absolute(p, i) if isinstance(x.adjuncts[0], At | Places))


@rule
def part_list(p: Parser, i: int) -> Results[Meaning]:
    """ "yellow at the bottom and red on top": statements about sides and other parts alone."""
    for first, j in one_more(p, i):
        yield first, j
        for whole, k in _absolute_more(p, i, j, (first,)):
            items = whole.items if isinstance(whole, Coord) else ()
            if all(isinstance(x, Absolute) and isinstance(x.adjuncts[0], At | Places) for x in items):
                yield whole, k


def more_parts(p: Parser, i: int, at_: int, first: Absolute) -> Results[Meaning]:
    """Further statements about parts after the first one."""
    yield from _absolute_more(p, i, at_, (first,))


def _no_place(mark: Meaning | None) -> bool:
    """ "vowels in one group", "the rest in another": told of members, not of where something lies."""
    return isinstance(mark, Structure) or (isinstance(mark, Pronoun) and mark.word not in ("it", "them"))


_LINES = frozenset({"row", "line"})
_PYRAMID = frozenset({"pyramid", "pyramids"})
_MARKS = frozenset({"it", "them", "that", "this", "the", "those", "both"})


_CLOSED = ("", ",", ";", ":", "and", ".")
_VERTICAL = (*((below, "bottom") for below in ("below", "underneath", "beneath", "under")), ("above", "top"))


@choice
def _places(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    for found, k in loc(p, i):
        if isinstance(found, Loc) and found.rel == "in" and _no_place(found.landmark):
            continue
        if isinstance(found, In) and "corner" in found.region and "table" not in p.words[i:k]:
            found = replace(found, cost=1)  # that of the structure, if it has one
        yield (found,), k
        if isinstance(found, Loc) and not isinstance(found.landmark, TableTop):
            yield from (
                ((found, side), end)
                for side, end in at(p, k)
                if isinstance(side, At) and side.side in ("left", "right", "front", "back")
            )
    for found, k in at(p, i):
        if isinstance(found, At) and found.side in ("end", "ends") and any(end == k for _, end in part(p, i + 1)):
            continue
        yield (found,), k
        pyramid = p.anywhere(_PYRAMID)
        if isinstance(found, At) and found.side == "top":
            on_them = p.any_of(p.opt(k, ","), _ON_THEM) or (p.any_of(p.opt(k, ","), AMID) if pyramid else 0)
            yield from (((found,), end) for end in (on_them,) if end)
    if k := p.any_of(i, _RESTING):
        yield (At(side="top", span=p.span(i, k)),), k
    for found, k in manner(p, i):
        if isinstance(found, Manner) and found.kind in ("turn", "facing", "by", "by?"):
            yield (found,), k
    behind = (("behind", "back"),) if p.stands(i, ("behind",)) and p.words[i + 1] in _CLOSED else ()
    for phrase, side in (*_VERTICAL, *behind):
        if k := p.one(i, phrase):
            yield (At(side=side, span=p.span(i, k)),), k
    if p.stands(i, ("left", "right")) and p.words[i + 1] in ("", ",", ";", "and", ".") and p.anywhere(_LINES):
        yield (At(side=p.words[i], span=p.span(i, i + 1)),), p.reach(i + 1)
    if p.words[i : i + 1] in (["first"], ["last"]):
        yield (At(side="first", index=1 if p.words[i] == "first" else -1, span=p.span(i, i + 1)),), p.reach(i + 1)
    for k in {p.any_of(i, ("lying around", "lying on the table")), *AS_EXTRAS.matches(p, i)} - {0}:
        yield (Manner(kind="extra", span=p.span(i, k)),), k
