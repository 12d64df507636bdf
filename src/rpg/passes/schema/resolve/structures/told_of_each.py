"""What is told behind structures of each of them, "a red and a blue tower, each three high", or of their blocks."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Meaning,
    Noun,
    Size,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_EACH = frozenset({"each", "both", "apiece"})
_LINES = ("row", "line", "column", "stack")
_MADE = ("build", "exist")


def told_of_each(chain: Chain, text: str) -> Chain:
    """The sentence with the size, and what is at an end, told of every one."""
    clauses: list[Meaning] = []
    for c in chain.clauses:
        before = clauses[-1] if clauses else None
        clauses.append(_by_looks(_of_each(_one_like_it(before, c), text)) if isinstance(c, Clause) else c)
    return replace(chain, clauses=tuple(clauses))


def _one_like_it(before: Meaning | None, said: Clause) -> Clause:
    """ "A red tower, three high, and a blue one, two high": a blue tower."""
    shape = before.theme if isinstance(before, Clause) and before.verb == "build" else None
    theme = said.theme
    sized = bool(said.adjuncts) and all(isinstance(a, Size) for a in said.adjuncts) and said.verb == "be"
    if not sized or not isinstance(shape, Structure) or shape.plural or shape.kind not in _LINES or shape.members:
        return said
    if not isinstance(theme, Noun) or (theme.head, theme.det, theme.amount) != ("any", "a", Amount(1, 1)):
        return said
    if theme.traits != Traits(colors=theme.traits.colors[:1]) or not theme.traits.colors or not shape.traits.colors:
        return said
    other = Structure(kind=shape.kind, det="a", amount=shape.amount, traits=theme.traits, span=theme.span)
    return replace(said, verb="build", theme=other)


def _by_looks(said: Clause) -> Clause:
    """ "Five cubes in a row, two red, two blue and one yellow, mirrored": just these are the five."""
    into = next((a for a in said.adjuncts if isinstance(a, Into)), None)
    shape, theme = into.structure if into is not None else None, said.theme
    lots = shape.members.items if isinstance(shape, Structure) and isinstance(shape.members, Coord) else ()
    bare = isinstance(theme, Noun) and theme.traits == Traits() and theme.det == "bare" and not theme.conditions
    if not lots or not bare or not isinstance(theme, Noun) or theme.amount is None or theme.part_of is not None:
        return said
    counts = [x.amount.low for x in lots if isinstance(x, Noun) and x.amount is not None]
    many = sum(counts)
    if not isinstance(shape, Structure) or into is None or len(counts) < len(lots):
        return said
    if theme.amount != Amount(many, many):
        raise refuse("count-mismatch", f"{many} are told of here", theme.span, "count as many as are told of")
    plain = replace(into, structure=replace(shape, members=None))
    return replace(said, theme=shape.members, adjuncts=tuple(plain if a is into else a for a in said.adjuncts))


def _of_each(said: Clause, text: str) -> Clause:
    sizes = tuple(a for a in said.adjuncts if isinstance(a, Size) and a.what not in ("total", "columns"))
    theme = said.theme
    if said.verb not in _MADE:
        return said
    if isinstance(theme, Structure):
        _not_of_one(theme, sizes, text)
        return said
    shapes = theme.items if isinstance(theme, Coord) and theme.op == "and" else ()
    lines = [x for x in shapes if isinstance(x, Structure) and not x.plural and x.kind in _LINES]
    if not isinstance(theme, Coord) or len(lines) < len(shapes) or len(lines) < 2:
        return said
    last = lines[-1]
    behind = text[last.sizes[0].span[1] : said.span[1] + 6].lower().replace(",", " ").split()[:1] if last.sizes else []
    if not sizes and not _EACH.isdisjoint(behind):  # "a red tower and a blue tower of height four each"
        sizes, lines = last.sizes, [*lines[:-1], replace(last, sizes=())]
    if not sizes or any(x.sizes or _counted(x.members) for x in lines):
        return said
    at = next((n for n, a in enumerate(said.adjuncts) if a in sizes), 0)
    ends = tuple(a for a in said.adjuncts[at:] if isinstance(a, Absolute) and isinstance(a.adjuncts[0], At))
    rest = tuple(a for a in said.adjuncts if a not in sizes and a not in ends)
    made = tuple(replace(x, sizes=sizes, details=(*x.details, *ends)) for x in lines)
    return replace(said, theme=replace(theme, items=made), adjuncts=rest)


def _not_of_one(shape: Structure, sizes: tuple[Size, ...], text: str) -> None:
    """Refuse what is told of each where a structure alone would take it: it is told of those before it as well."""
    for size in sizes:
        words = text[size.span[0] : size.span[1]].lower().split()
        if shape.det == "a" and not shape.plural and shape.kind in _LINES and not _EACH.isdisjoint(words):
            raise refuse("ambiguous", "this is said of each, and this is one", size.span, "say it of each by itself")


def _counted(members: Meaning | None) -> bool:
    return isinstance(members, Noun) and members.amount is not None


def check_top(shape: Structure, tops: list[Absolute]) -> None:
    """Refuse "a red tower, three high, with a white top": is it the third of them, or a fourth one?"""
    high = next((z for z in shape.sizes if z.what == "high"), None)
    colors = shape.traits.colors or (shape.members.traits.colors if isinstance(shape.members, Noun) else ())
    for item in tops if high is not None and len(colors) == 1 and shape.kind == "stack" else ():
        place, theme = item.adjuncts[0], item.theme
        other = isinstance(theme, Noun) and len(theme.traits.colors) == 1 and theme.traits.colors != colors
        if other and isinstance(place, At) and place.side == "top" and isinstance(theme, Noun) and theme.det != "the":
            raise refuse("ambiguous", "is this one of so many, or one more on top of them?", item.span,
                         "say how many of each colour the tower has")  # fmt: skip
