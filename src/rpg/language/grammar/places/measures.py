"""Distances: "5 cm from", "at least 10 cm to the left of", "with 5 cm between them"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.far_aside import to_a_side
from rpg.language.grammar.places.free_room import behind_room
from rpg.language.grammar.places.limits import AROUND, GIVE, LIMITS, OR_LESS, OR_MORE
from rpg.language.grammar.places.their_ends import their_ends
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import block_widths, edge_lengths, length
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Loc, Meaning, Pronoun, replace

_KINDS = ("blocks", "cubes", "bricks", "ones", "letters", "digits", "numbers", "signs", "symbols")
NEXT = tuple(
    f"{which}{next_}{what}"
    for which in ("", "two ", "the ", "any two ", "every two ", "each two ", "each pair of ", "every pair of ")
    for next_, whats in (("", ("neighbors", *_KINDS)), ("neighboring ", _KINDS), ("adjacent ", _KINDS),
                         ("consecutive ", _KINDS), ("successive ", _KINDS))
    for what in whats
)  # fmt: skip
"""What stands side by side in a line."""
_GROUPS = tuple(
    f"{which}{groups}" for which in ("", "the ", "the two ", "the three ", "both ", "any two ", "every two ")
    for groups in ("groups", "piles", "clusters", "bunches", "heaps")
)  # fmt: skip
_ENDS_OF = ("", " of the blocks", " of the cubes", " of them", *(f" of {next_}" for next_ in NEXT))
AMONG = (
    *(f"between {next_}" for next_ in NEXT),
    "between them", "between each other", "in between them", "in between", "between the two",
    *(f"between each{what}" for what in ("", " pair", " of them", " of the blocks", *(f" {x[:-1]}" for x in _KINDS))),
)  # fmt: skip


def _other_bound(p: Parser, i: int, first: str) -> Results[float]:
    """ "at least 5 cm but at most 10 cm", "at most 10 cm and at least 5 cm": the other end of the range."""
    j = p.any_of(p.opt(i, ","), ("but", "and", "yet"))
    for phrase, k in p.standing(j, LIMITS) if j else ():
        if LIMITS[phrase] != first:
            yield from length(p, k)


def _last_figure(p: Parser, i: int, j: int) -> float | None:
    """The last number before a place: that of a length which ends there."""
    return next((found for n in range(j - 1, i, -1) if (found := p.figure(n)) is not None), None)


@rule
def room(p: Parser, i: int) -> Results[tuple[float | None, float | None]]:
    """A gap as a range, told by the blocks that it has room for: "one block", "at least two cubes"."""
    for wide, j in block_widths(p, i):
        yield (round(wide - 0.01, 6), round(wide + 0.01, 6)), j
    for phrase, bound in p.standing(i, LIMITS):
        for wide, j in block_widths(p, bound):
            yield ((wide, None) if LIMITS[phrase] == "low" else (None, wide)), j


@rule
def bounds(p: Parser, i: int) -> Results[tuple[float | None, float | None]]:
    """A length as a range: "5 cm" is ±1 cm, "about 5 cm" ±25 %, "at least 5 cm", "no more than 5 cm"."""
    for phrase, j in p.standing(i, LIMITS):
        for metres, k in length(p, j):
            yield ((metres, None) if LIMITS[phrase] == "low" else (None, metres)), k
            for other, end in _other_bound(p, k, LIMITS[phrase]):
                yield ((metres, other) if LIMITS[phrase] == "low" else (other, metres)), end
        if (least := p.figure(j)) is not None and p.stands(j + 1, ("but", "and", ",")):  # one unit for both
            for other, end in _other_bound(p, j + 1, LIMITS[phrase]):
                metres = round(least * other / (_last_figure(p, j + 1, end) or other), 6)
                yield ((metres, other) if LIMITS[phrase] == "low" else (other, metres)), end
    for word, j in p.standing(i, AROUND):
        for metres, k in length(p, j):
            slack = metres * AROUND[word] if AROUND[word] else 0.01
            yield (round(max(0.0, metres - slack), 6), round(metres + slack, 6)), k
    if j := p.one(i, "between"):
        low = p.figure(j)
        after = p.one(j + 1, "and") if low is not None else 0
        for metres, k in length(p, after) if after else ():
            factor = metres / (p.figure(after) or 1.0)
            yield (round(float(low or 0) * factor, 6), metres), k
        for least, after in length(p, j):
            for metres, k in length(p, after + 1) if p.one(after, "and") else ():
                yield (least, metres), k
    for metres, k in length(p, i):
        if end := p.any_of(k, OR_MORE):
            yield (metres, None), end
        if end := p.any_of(k, OR_LESS):
            yield (None, metres), end
        for slack, end in _tolerance(p, k):
            yield (round(max(0.0, metres - slack), 6), round(metres + slack, 6)), end
        yield (round(max(0.0, metres - 0.01), 6), round(metres + 0.01, 6)), k


@choice
def _tolerance(p: Parser, i: int) -> Results[float]:
    """ "plus or minus 5 mm" behind a length."""
    if j := p.any_of(p.opt(i, ","), GIVE):
        yield from length(p, j)


MEASURED_BETWEEN = {"center to center": "centres", "from center to center": "centres", "between centers": "centres",
         "measured center to center": "centres", "measured between centers": "centres", "face to face": "faces",
         "from face to face": "faces", "between faces": "faces", "between the centers": "centres",
         "measured from center to center": "centres", "measured face to face": "faces",
         **{f"{measured}{between} {the}{ends}": way
            for measured in ("", "measured ") for between in ("between", "from") for the in ("", "the ", "their ")
            for ends, way in (("faces", "faces"), ("sides", "faces"), ("edges", "faces"), ("centers", "centres"),
                              ("middles", "centres"))},
         "edge to edge": "faces", "middle to middle": "centres", "from middle to middle": "centres",
         "measured from middle to middle": "centres", "measured middle to middle": "centres",
         "from edge to edge": "faces", "measured from face to face": "faces",
         "measured from edge to edge": "faces"}  # fmt: skip
"""Between what a distance is measured."""


def measured_so(p: Parser, far: Loc, i: int, j: int) -> Results[Loc]:
    """The distance, with what is said behind it of how it is measured: ", centre to centre, tolerance 5 mm"."""
    yield far, j
    ways = [
        (replace(far, measure=MEASURED_BETWEEN[phrase]), k)
        for phrase, k in p.standing(p.opt(j, ",", "("), MEASURED_BETWEEN)
    ]
    for said, k in [*ways, (far, j)]:
        k = p.opt(k, ")") if k > j else k
        if k > j:
            yield replace(said, span=p.span(i, k)), k
        middle = ((said.low or 0.0) + (said.high or 0.0)) / 2
        for slack, end in _tolerance(p, k) if said.low is not None and said.high is not None else ():
            low, high = round(max(0.0, middle - slack), 6), round(middle + slack, 6)
            yield replace(said, low=low, high=high, span=p.span(i, end)), end


def _as_far(p: Parser, i: int) -> int:
    """ "(move it) to within 5 cm of": where the length begins."""
    return i + 1 if p.words[i : i + 2] == ["to", "within"] else i


@choice
def measured(p: Parser, i: int) -> Results[Meaning]:
    """ "5 cm from the red block", "at least 10 cm to the left of it", "within 3 cm of ..."."""
    start = p.any_of(i, ("at a distance of", "with a distance of", "a distance of")) or (
        i + 1 if p.words[i] == "at" and p.words[i + 1] not in ("least", "most") else _as_far(p, i)
    )
    for (low, high), j in bounds(p, start):
        to = (
            p.one(j, "to")
            if p.words[start] in ("closer", "nearer") or p.words[start + 1] in ("closer", "nearer")
            else 0
        )
        if k := to or p.any_of(j, ("away from", "from", "of", "apart from", "far from", "distance from")):
            for landmark, end in noun_phrase(p, k):
                far = Loc(rel="distance", landmark=landmark, low=low, high=high, span=p.span(i, end))
                yield from measured_so(p, far, i, end)
                for most, last in _other_bound(p, end, "low") if low is not None and high is None else ():
                    yield replace(far, high=most, span=p.span(i, last)), last
        for side, k in p.standing(p.any_of(j, ("to its", "on its")), ("left", "right")) if p.stands(j, _AT) else ():
            far = Loc(rel=side, landmark=Pronoun(word="it", span=p.span(j, k)), low=low, high=high, span=p.span(i, k))
            yield from measured_so(p, far, i, k)
        for far, end in to_a_side(p, i, j, low, high):
            yield from measured_so(p, far, i, end)
            for most, last in _other_bound(p, end, "low") if low is not None and high is None else ():
                yield replace(far, high=most, span=p.span(i, last)), last
    for metres, j in edge_lengths(p, start):
        yield from to_a_side(p, i, j, round(metres - 0.01, 6), round(metres + 0.01, 6))
    if j := p.any_of(i, ("with a gap of", "leaving a gap of", "a gap of")):
        for (low, high), k in bounds(p, j):
            if k := p.any_of(k, ("from", "to")):
                for landmark, end in noun_phrase(p, k):
                    span = p.span(i, end)
                    yield Loc(rel="distance", landmark=landmark, low=low, high=high, measure="faces", span=span), end


_AT = frozenset({"to", "on"})
_CLOSER = ("closer to", "nearer to")
_FARTHER = ("farther from", "further from", "farther away from", "further away from")
_NO_CLOSER = ("no closer to", "not closer to", "no nearer to", "not nearer to", "never closer to")
_NO_FARTHER = ("no farther from", "no further from", "not farther from", "not further from", "no farther away from",
               "no further away from", "not farther away from", "not further away from")  # fmt: skip
_CLOSER_THAN, _FARTHER_THAN = (
    tuple(dict.fromkeys(" ".join(x.split()[:2]) + " than" for x in phrases)) for phrases in (_NO_CLOSER, _NO_FARTHER)
)


_NEAR = ("near to", "near", "close to")
_WITHIN = ("that is within", "that is , within", "within", "at most", "no more than")


@choice
def limited(p: Parser, i: int) -> Results[Meaning]:
    """ "no closer to it than 10 cm", "no farther than 8 cm from the blue one", "near it, within 8 cm": a bound on a
    distance."""
    if j := p.any_of(i, _NEAR):
        for landmark, k in noun_phrase(p, j):
            told = p.any_of(p.opt(k, ","), _WITHIN)
            for metres, end in length(p, told) if told else ():
                yield _bound(p, i, end, landmark, metres, least=False), end
    for phrases, leads, least in ((_NO_CLOSER, _CLOSER_THAN, True), (_NO_FARTHER, _FARTHER_THAN, False),
                                  (_CLOSER, (), False), (_FARTHER, (), True)):  # fmt: skip
        if j := p.any_of(i, phrases):
            for landmark, k in noun_phrase(p, j):
                for metres, end in length(p, p.one(k, "than")) if p.one(k, "than") else ():
                    yield _bound(p, i, end, landmark, metres, least), end
        if j := p.any_of(i, leads) if leads else 0:
            for metres, k in length(p, j):
                to = p.any_of(k, ("to", "from", "away from"))
                for landmark, end in noun_phrase(p, to) if to else ():
                    yield _bound(p, i, end, landmark, metres, least), end


def _bound(p: Parser, i: int, end: int, landmark: Meaning, metres: float, least: bool) -> Loc:
    low, high = (metres, None) if least else (None, metres)
    return Loc(rel="distance", landmark=landmark, low=low, high=high, span=p.span(i, end))


_WHOSE = ("", "the ", "their ", "block ", "neighboring ", "adjacent ")
_OF_CENTERS = (
    "from center to center", "center to center",
    *(f"{between} {their}centers{of}" for between in ("between", "from") for their in _WHOSE for of in _ENDS_OF),
)  # fmt: skip
_BETWEEN_CENTERS = (
    *_OF_CENTERS,
    "apart from each other", "from each other", "away from each other", "apart", "from one another", "of each other",
    *(f"{away}from the next{one}" for away in ("", "away ") for one in ("", " one")),
    "of one another", "away", "to each other", "to one another", "center to center", "from center to center",
    "between centers", "apart from one another",
)  # fmt: skip
_BETWEEN_FACES = (
    *(f"between {next_}" for next_ in NEXT),
    *(f"between {their}{ends}{of}" for their in ("", "the ", "their ") for ends in ("faces", "sides")
      for of in _ENDS_OF),
    "between them", "between each other", "in between them", "in between", "between the two",
    "between each", "between each block",
    "between the blocks",
    *(f"between {groups}" for groups in _GROUPS),
)  # fmt: skip
_ROOM = ("gap", "gaps", "spaces", "of space", "of free space", "space", "wide gap", "spacing", "distance",
         "of distance")  # fmt: skip
_NOTED = ("spacing", "gap", "gaps", "distance", "with spacing", "with gaps", "center distance",
          "with a center distance", "center to center distance")  # fmt: skip
_GAPS_OF = (
    "with a gap of", "with gaps of", "leaving a gap of", "with a spacing of", "leaving gaps of", "at intervals of",
    "with a distance of", "with spacing of", "with a space of", "leaving a space of", "with spaces of",
    "with a separation of", "leaving a distance of",
)  # fmt: skip


_NEARER = ("closer than", "nearer than", "no closer than", "no nearer than", "not closer than", "farther than",
           "further than", "no farther than", "no further than", "not farther than", "not further than")  # fmt: skip
"""What blocks are to each other where nothing else is named."""


_SPACED_AT = ("at", "by", "at intervals of", "at a distance of", "every", "with intervals of")
_SPACED = ("spaced", *(f"spaced {at}" for at in _SPACED_AT))
_APART = ("apart", "apart from each other", "away from each other", "from each other", "apart from one another")


@choice
def measured_bare(p: Parser, i: int) -> Results[Meaning]:
    """ "5 cm apart", "with 5 cm between them", "with a gap of 2 cm"."""
    spaced = p.any_of(i, _SPACED) or (p.any_of(i, _SPACED_AT) if p.follows(i, ("spaced",)) else 0)
    start = spaced or p.any_of(i, ("at a distance of", "separated by", "with", "placed", "pairwise")) or i
    start = _as_far(p, i) if start == i else start
    groups = p.any_of(p.opt(i, "with", ","), _GROUPS)
    for measure, k in (*their_ends(p, p.opt(i, "with", ",")), *((("centres", groups),) if groups else ())):
        for (low, high), j in bounds(p, p.opt(k, "being")):
            if end := p.any_of(j, ("apart", "from each other", "apart from each other")):
                yield _each_other(p, i, end, low, high, measure), end
    for (low, high), j in bounds(p, start):
        end, measure = p.any_of(j, _BETWEEN_CENTERS), "centres"
        if not end:
            end, measure = p.any_of(behind_room(p, j), _BETWEEN_FACES), "faces"
        if not end and spaced:
            end, measure = j, "centres"
        if not end and p.words[start - 1 : start] == ["by"]:
            end, measure = j, "faces"
        if not end and (j >= p.end or p.words[j] in (",", "and")) and (p.words[i] == "at" or p.any_of(i, _NEARER)):
            end, measure = (j if start > i or p.words[i] != "at" else 0), "centres"
        if end:
            yield from measured_so(p, _each_other(p, i, end, low, high, measure), i, end)
    at = p.any_of(i, ("at", "spaced at", "placed at"))
    for (low, high), j in bounds(p, at) if at and not p.stands(at, ("least", "most")) else ():
        if end := p.any_of(j, _OF_CENTERS):  # "evenly spaced at 6 cm center to center"
            yield _each_other(p, i, end, low, high, "centres"), end
    for (low, high), j in room(p, start):
        if (end := p.any_of(j, _APART)) and not p.stands(end, ("from",)):
            yield _each_other(p, i, end, low, high, "faces"), end
    noted = p.any_of(i, _NOTED)
    for (low, high), j in bounds(p, p.opt(noted, "of", ":")) if noted else ():
        end = p.opt(j, "gap", "gaps")
        measure = "faces" if end > j or p.words[noted - 1] in ("gap", "gaps") else "centres"
        end = p.any_of(end, AMONG) or end
        yield replace(_each_other(p, i, end, low, high, measure), cost=1), end
    yield from _moved(p, i)
    yield from _spaced(p, i)


_FROM_HERE = Patterns(
    "with_respect_to|relative_to|compared_to where it is|stands|lies|was|starts|started|begins|began",
    "with_respect_to|relative_to|compared_to its|their|the current|original|initial|start|starting "
    "place|position|location|spot",
    "away? from where it is|stands|lies|sits|was|starts|started|begins|began now|currently|standing|lying?",
    "away? from where it currently|now|originally|initially is|stands|lies|sits|was",
    "away? from its|their|the current|present|original|initial|start|starting|old|first? place|position|location|spot",
)
"""From where a block is found."""


_ELSEWHERE = Patterns(
    "to|at|in|on? somewhere|someplace|anywhere else on? the? table?",
    "to? elsewhere on? the? table?",
    "aside|to_the_side|to_one_side|out_of_the_way",
    "to|at|in|on another|a_different|some_other|a_new|any_other place|spot|position|location on? the? table?",
)
"""Not where a block is found."""


_ROOM_FOR = ("with room for", "with space for", "leaving room for", "leaving space for", "room for", "space for",
             "with enough room for", "with just enough room for")  # fmt: skip
_BY_FACES = frozenset({"gap", "gaps", "space", "spaces"})


@choice
def _spaced(p: Parser, i: int) -> Results[Meaning]:
    """ "leaving a 2 cm gap between them", "with gaps of 2 cm"."""
    if j := p.any_of(i, ("with a", "leaving a", "with", "leaving", "at a", "keeping a")) or (
        i if p.follows(i, (",",)) else 0
    ):
        for (low, high), k in bounds(p, j):
            if gap := p.any_of(k, _ROOM):
                end = p.any_of(gap, AMONG) or gap
                measure = "centres" if p.words[gap - 1] in ("spacing", "distance") else "faces"
                yield from measured_so(p, _each_other(p, i, end, low, high, measure), i, end)
            if end := p.any_of(k, _OF_CENTERS):
                yield _each_other(p, i, end, low, high, "centres"), end
    if j := p.any_of(i, _GAPS_OF):
        measure = "centres" if _BY_FACES.isdisjoint(p.words[i:j]) else "faces"
        for (low, high), k in [*bounds(p, j), *(room(p, j) if measure == "faces" else ())]:
            end = p.any_of(k, _BETWEEN_FACES) or (p.any_of(k, _OF_CENTERS) if measure == "centres" else 0) or k
            yield from measured_so(p, _each_other(p, i, end, low, high, measure), i, end)
    if j := p.any_of(i, _ROOM_FOR):
        for (low, high), k in room(p, j):
            end = p.any_of(k, _BETWEEN_FACES) or k
            yield _each_other(p, i, end, low, high, "faces"), end


def _each_other(p: Parser, i: int, end: int, low: float | None, high: float | None, measure: str) -> Loc:
    """A distance of the blocks spoken of to each other; "mutual" where it says so, and is not one of neighbours."""
    span = p.span(i, end)
    each = Pronoun(word="each other", span=span)
    mods = ("mutual",) if p.stands(end - 1, _MUTUAL) or p.words[i] == "pairwise" else ()
    return Loc(rel="distance", landmark=each, mods=mods, low=low, high=high, measure=measure, span=span)


_MUTUAL = frozenset({"other", "another"})


@choice
def _moved(p: Parser, i: int) -> Results[Meaning]:
    """ "by at least 10 cm": how far something moves."""
    if away := max(_FROM_HERE.matches(p, i), default=0):
        yield Loc(rel="moved", low=0.05, mods=("here",), span=p.span(i, away)), away
        for (low, high), j in bounds(p, p.opt(away, ",")):
            again = max(_FROM_HERE.matches(p, j), default=j)
            if high is None:
                yield Loc(rel="moved", low=low, high=high, span=p.span(i, again)), again
    if other := max(_ELSEWHERE.matches(p, i), default=0):
        mods = ("else", "aside") if p.words[other - 1] == "side" else ("else",)
        yield Loc(rel="moved", low=0.05, mods=mods, span=p.span(i, other)), other
        for (low, high), j in bounds(p, p.opt(other, ",")):
            if high is None and (here := max(_FROM_HERE.matches(p, j), default=0)):
                yield Loc(rel="moved", low=low, mods=("else",), span=p.span(i, here)), here
    far = p.one(i, "by") or i
    for (low, high), j in bounds(p, far):
        if (here := max(_FROM_HERE.matches(p, j), default=0)) and high is None:
            yield Loc(rel="moved", low=low, high=high, span=p.span(i, here)), here
        if high is None or far > i:
            yield Loc(rel="moved", low=low, high=high, span=p.span(i, j), cost=1), j
