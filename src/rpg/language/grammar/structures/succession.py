"""Lines told one after the other: "the row begins with red, goes on with green and ends with blue".

Also "in the row, red comes first, then blue", "red is followed by blue", "from left to right there comes first ...".
"""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Meaning, Noun, OrderBy, Structure, Toward

_LINES = {"row": "row", "line": "line", "column": "column", "tower": "stack", "stack": "stack", "queue": "line"}
_MARKS = frozenset({"first", "then", "followed", "next", "last", "begins", "starts", "begin", "start", "ends", "end",
                    "before", "after", "finally", "starting", "beginning", "follows", "lastly"})  # fmt: skip
_BUILD = ("make", "build", "form", "lay", "lay out", "arrange", "there is", "i want", "set up")
_HAS = ("that starts with", "that begins with", "which starts with", "which begins with", "starting with",
        "beginning with", "begins with", "starts with", "should start with", "should begin with", "must start with",
        "must begin with", "has to start with", "has to begin with", "starts", "begins", "starts with the",
        ": first", ", first", "with first", "has first", "is first", ":", "has", "with", "goes", "runs", "goes from",
        ", with", "where", ", where", "in which", ", in which", "so that", "such that")  # fmt: skip
_THERE = ("there comes first", "there come first", "there comes", "there come", "comes first", "comes", "come", "first",
          "put", "first comes", "first come", "first there is", "there is first", "place", "i want first", "first put",
          ": first", "there is", "you see first", "you first see")  # fmt: skip
_NEXT = tuple(
    f"{comma}{link}"
    for comma in ("", ", ")
    for link in ("then", "and then", "then comes", "then come", "and then comes", "and then come", "followed by",
                 "and followed by", "is followed by", "are followed by", "followed by the", "which is followed by",
                 "next", "and next", "next comes", "next come", "next is", "and next comes", "after it", "after that",
                 "after those", "after them", "after which comes", "after which come", "and after it", "and after that",
                 "and after those", "finally", "and finally", "and finally comes", "and finally come", "last",
                 "and last",
                 "and last comes", "and last come", "and at last", "lastly", "and lastly", "goes on with",
                 "continues with", "continue with", "and continues with", "and goes on with", "and ends with",
                 "and ends in", "and finishes with", "ends with", "and end with", "end with", "finish with",
                 "and finish with", "and is closed by", "then it has", "then follows", "then follow", "comes before",
                 "and then follows", "before", "is before", "ending with", "and ending with", "and the last is",
                 "and the last one is", "and at the end", "and then there is", "then there is", "come before")
)  # fmt: skip
_PLAIN = (", and", ",", "and")
"""What may stand between two more of them, where it is told by other words that they follow each other."""
_AFTER_ITEM = ("comes first", "come first", "is first", "goes first", "first", "comes next", "comes last", "come last",
               "is last", "goes last", "last", "second", "third", "comes second", "comes third", "is next", "follows",
               "are first", "are last", "stands first", "stands last")  # fmt: skip
_PLACES = frozenset({"first", "second", "third", "last"})
_IN_LINE = tuple(f"{comma}{all_}in {a} {line}" for comma in (", ", "; ", "") for all_ in ("", "all ", "standing ")
                 for a in ("a", "one", "the") for line in ("row", "line"))  # fmt: skip
_MOST = 12


@rule
def succession(p: Parser, i: int) -> Results[Clause]:
    """The order of all blocks of a line, from its beginning on."""
    if not p.anywhere(_MARKS) or not (p.anywhere(_NAMED) or p.anywhere(_ENDS)):
        return
    for kind, way, j in _openings(p, i):
        for items, marked, k in _items(p, j):
            if marked or p.words[j - 1] == "first":
                yield from _whole(p, i, k, items, kind, way)
    for items, marked, k in _items(p, i):
        if marked and (end := p.any_of(k, _IN_LINE)):
            yield from _whole(p, i, end, items, _LINES[p.words[end - 1]], None)
        elif marked and (end := p.one(k, (",", ";"))):
            for told, last in toward(p, end):
                if isinstance(told, Toward) and told.first is not None:
                    yield from _whole(p, i, last, items, "row" if told.axis == "y" else "line", told)


_NAMED = frozenset(_LINES)
_ENDS = frozenset({"left", "right"})


def _openings(p: Parser, i: int) -> Iterator[tuple[str, Toward | None, int]]:
    """The line, which way it goes where that is said, and where its blocks begin."""
    inside = p.one(i, "in")
    start = p.any_of(i, _BUILD) or i
    named = p.opt(inside or start, "a", "the", "one")
    if p.peek(named, _LINES):
        kind, j = _LINES[p.words[named]], p.reach(named + 1)
        for way, k in ((None, j), *((w, e) for w, e in toward(p, p.opt(j, ",")) if isinstance(w, Toward))):
            lead = p.any_of(k, _THERE if inside else _HAS)
            set_off = p.one(k, (",", ":"))
            for at in dict.fromkeys((lead, p.any_of(set_off, _THERE) if set_off else 0, set_off)):
                if at:
                    yield kind, way, at
    for led, j in toward(p, i):
        if isinstance(led, Toward) and led.first is not None and (at := p.any_of(p.opt(j, ",", ":"), _THERE)):
            yield {"y": "row", "z": "stack"}.get(led.axis or "", "line"), led, at


def _whole(
    p: Parser, i: int, k: int, items: tuple[Meaning, ...], kind: str, way: Toward | None
) -> Iterator[tuple[Clause, int]]:
    ways: list[tuple[Toward | None, int]] = [(way, k)]
    if way is None:
        ways += [(w, e) for w, e in toward(p, p.opt(k, ",", ";")) if isinstance(w, Toward) and w.first]
    for told, end in ways:
        order = OrderBy(by="named", items=items, first=told.first if told else None, span=p.span(i, end))
        line = Structure(kind=kind, det="the", span=p.span(i, end))
        yield Clause(verb="part", theme=line, adjuncts=(order,), mode="goal", span=p.span(i, end), cost=1), end


def _items(p: Parser, i: int) -> Iterator[tuple[tuple[Meaning, ...], bool, int]]:
    """At least two things one after the other, and whether a word tells that they follow each other."""
    for found, joints, k in _more(p, i, (), frozenset()):
        if not {"listed", "before"} <= joints:  # "A and B come before C and D": nothing is said of A and B
            yield found, bool(joints - {"listed"}), k


def _more(
    p: Parser, i: int, had: tuple[Meaning, ...], joints: frozenset[str], taken_up: bool = False
) -> Iterator[tuple[tuple[Meaning, ...], frozenset[str], int]]:
    """`joints`: how they are told: "listed" with no more than a comma or an "and" between them, "before", or "then"."""
    for item, j in simple(p, i):
        if not isinstance(item, Noun) or not _told(item):
            continue
        k = p.any_of(j, _AFTER_ITEM) or j
        if taken_up and isinstance(had[-1], Noun) and had[-1].traits == item.traits:
            if then := p.any_of(k, _NEXT):  # "red before blue and blue before green"
                yield from _more(p, then, had, joints | {_joint(p, then)})
            continue
        place = _PLACES.intersection(p.words[j:k])
        found, sure = (*had, item), joints | ({"then"} if k > j else {"listed"} if taken_up else set())
        if place - {("first", "second", "third")[min(len(had), 2)], "last"} or ("last" in place and not had):
            continue
        if len(found) > 1:
            yield found, sure, k
        if len(found) == _MOST or "last" in place:
            continue
        then = p.any_of(k, _NEXT)
        if then:
            yield from _more(p, p.any_of(then, _THERE) or then, found, sure | {_joint(p, then)})
        elif plain := p.any_of(k, _PLAIN):
            yield from _more(p, plain, found, sure, True)


def _joint(p: Parser, end: int) -> str:
    return "before" if p.words[end - 1] == "before" else "then"


def _told(item: Noun) -> bool:
    """Blocks of one look."""
    marks = item.traits
    one = len(marks.colors) + len(marks.labels) == 1 and not marks.either and marks.rank is None and not marks.extra
    one = one and not (marks.labels and item.plural and item.amount is None)  # "the vowels A (and E)" begins a list
    return one and item.head != "patch" and item.part_of is None and not item.conditions and item.det != "no"
