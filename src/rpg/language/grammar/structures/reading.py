"""Lists that a line is to read: "to read C, A, B", "a tower that reads 3, 1, 2", ", reading X Y Z"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Meaning, Noun, OrderBy, Toward
from rpg.language.phrases import Classes

_READERS = Classes(
    {
        "reader": (
            "they|it|you|i|one|we|people|everyone|anyone|somebody|the_letters|the_cubes|the_blocks|the_digits",
            "the_numbers|the_row|the_line|the_tower|the_stack|the_viewer|the_camera",
        ),
        "may": ("can|could|should|must|shall|will|may|has_to",),
    }
)
_LED = Patterns("that|which|and", "so|so_that|such_that|where|in_which <reader>", classes=_READERS)
_READ = Patterns("<may>? read|reads", classes=_READERS)
_SHOW = Patterns("<may>? go|goes|run|runs|show|shows|has", classes=_READERS)
_GO = Patterns(
    ",? where|in_which|whose|so_that|such_that|so|with the|its|their? colors|blocks|cubes|letters|digits|numbers|order|"
    "sequence go|goes|going|run|runs|running",
)
"""What a list of all the blocks of a line follows, in their order."""
_BARE = frozenset({"reading", "spelling"})
_SAYING = frozenset({"read", "reads", "go", "goes", "going", "run", "runs", "running", "show",
                     "shows", "has"})  # fmt: skip
_LINES = frozenset({"row", "line", "tower", "stack", "column", "pile", ",", "-", "(", "order"})
"""Behind these "reading" is said of the line; "cubes reading A, B, C" tells what each of them shows."""


@rule
def read_out(p: Parser, i: int) -> Results[OrderBy]:
    """What is to be read, from the side where reading begins, or from one that is named."""
    comma = p.opt(i, ",")
    if (j := p.one(comma, _BARE)) and (p.words[j - 2] in _LINES or "of" in p.words[max(0, i - 3) : i]):
        yield from _told(p, i, j, "read")
    if (j := p.seq(i, "to read")) or not p.anywhere(_SAYING):
        yield from _told(p, i, j, "read") if j else ()
        return
    for j in _GO.matches(p, i):
        yield from _told(p, i, j, "given")
    for lead in _LED.matches(p, i):
        for first, j in [(None, lead), *_set_off(p, lead)]:
            for k in _READ.matches(p, j):
                yield from _told(p, i, k, "read", first)
            for k in _SHOW.matches(p, j) if p.follows(i, _LINES) else ():
                yield from _told(p, i, k, "given", first)


def _set_off(p: Parser, i: int) -> Results[str | None]:
    """ "(that), from top to bottom, (reads ...)"."""
    comma = p.one(i, ",")
    for way, j in toward(p, comma) if comma else ():
        if isinstance(way, Toward) and (end := p.one(j, ",")):
            yield way.first, end


def _told(p: Parser, i: int, j: int, by: str, first: str | None = None) -> Results[OrderBy]:
    j = p.opt(j, ":")
    for items, end in _alike(p, j):
        yield OrderBy(by=by, items=items, first=first, span=p.span(i, end)), end
    if first is not None:
        return
    for way, k in toward(p, p.opt(j, ",")):
        if isinstance(way, Toward) and way.first is not None:
            for items, end in _alike(p, p.opt(k, ",", ":")):
                yield OrderBy(by=by, items=items, first=way.first, span=p.span(i, end)), end


def _alike(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """Symbols alone, or colours alone: all of them, not the first few."""
    found = [(items, j) for items, j in listed(p, i) if _bare(items, "labels") or _bare(items, "colors")]
    last = max((j for _, j in found), default=0)
    yield from [one for one in found if one[1] == last][:1]


def _bare(items: tuple[Meaning, ...], what: str) -> bool:
    return all(isinstance(x, Noun) and len(getattr(x.traits, what)) == 1 and x.det == "bare" for x in items)
