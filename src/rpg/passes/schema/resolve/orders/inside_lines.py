"""Where one of its blocks is in a line, told before the line: "red is at the left end of the row of red and blue"."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    At,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    PartOf,
    Structure,
    Traits,
    replace,
)

_LINES = {
    "stack": ("top", "bottom", "middle"),
    "row": ("left", "right", "middle"),
    "line": ("left", "right", "front", "back", "middle"),
    "column": ("front", "back", "middle"),
}


def in_a_line(clause: Clause) -> tuple[Clause, ...]:
    """The clauses that build the line and say where the block is in it; none where this is not said."""
    theme = clause.theme
    if clause.verb not in ("be", "place") or clause.mode == "start" or not isinstance(theme, Noun):
        return ()
    line, at_ = _place(clause)
    if line is None or at_ is None or line.plural or theme.plural or _look(theme) is None:
        return ()
    if at_.side not in _LINES.get(line.kind, ()):
        return ()
    if not _unlooked(line) and _look(theme) not in [_look(item) for item in _items(line.members)]:
        return ()
    line = replace(line, det="a")
    if not (clause.negated or any(getattr(place, "negated", False) for place in clause.adjuncts)):
        within = Absolute(theme=theme, adjuncts=(at_,), span=clause.span)
        return (Clause(verb="build", theme=line, adjuncts=(within,), mode="goal", span=clause.span),)
    said = replace(clause, verb="be", lemma="", theme=replace(theme, det="the"), adjuncts=(at_,), negated=True)
    return Clause(verb="build", theme=line, mode="goal", span=line.span), said


def _place(clause: Clause) -> tuple[Structure | None, At | None]:
    """The line, and the place in it that is meant: "in the middle of a row of three", "in the middle, in a row of
    three", "center it in a row of three"."""
    into = [a.structure for a in clause.adjuncts if isinstance(a, Into) and isinstance(a.structure, Structure)]
    places = [a for a in clause.adjuncts if isinstance(a, At | Loc)]
    if len(into) + len(places) < len(clause.adjuncts) or len(into) > 1:
        return None, None
    if into and _unlooked(into[0]):
        if clause.lemma == "center" and not places:
            return into[0], At(side="middle", span=clause.span)
        at_ = places[0] if len(places) == 1 else None
        return into[0], at_ if isinstance(at_, At) and at_ == At(side=at_.side, span=at_.span) else None
    place = places[0] if len(places) == 1 and not into else None
    if not isinstance(place, Loc) or place.second is not None or place.mods or place.low is not None:
        return None, None
    line, side = _part(place)
    if line is not None and place.rel == "on" and _unlooked(line):
        return None, None  # "on top of a tower of three": a fourth one
    return line, At(side=side, span=place.span)


def _part(place: Loc) -> tuple[Structure | None, str]:
    """The line, and the part of it that is meant."""
    mark = place.landmark
    if isinstance(mark, PartOf) and place.rel == "in" and isinstance(mark.whole, Structure):
        return mark.whole, mark.part
    if isinstance(mark, Structure) and place.rel == "between":
        return mark, "middle"
    if isinstance(mark, Structure) and mark.kind == "stack" and place.rel == "on":
        return mark, "top"
    return None, ""


def _unlooked(line: Structure) -> bool:
    """ "a row of three": of its blocks no more is said than how many they are."""
    blocks = line.members
    if blocks is None:
        return line.size is not None and line.traits == Traits() and not line.details
    plain = isinstance(blocks, Noun) and blocks.traits == Traits() and blocks.det == "bare" and not blocks.part_of
    return plain and isinstance(blocks, Noun) and blocks.amount is not None


def _items(members: Meaning | None) -> tuple[Meaning, ...]:
    if isinstance(members, Coord):
        return members.items if members.op == "and" else ()
    if isinstance(members, Noun) and len(members.traits.colors) > 1 and not members.traits.either:
        return tuple(replace(members, traits=Traits(colors=(one,))) for one in members.traits.colors)
    if isinstance(members, Noun) and len(members.traits.labels) > 1:
        return tuple(replace(members, traits=Traits(labels=(one,))) for one in members.traits.labels)
    return ()


def _look(item: Meaning) -> tuple[tuple[str, ...], tuple[str, ...]] | None:
    """A single colour or symbol, and nothing else."""
    if not isinstance(item, Noun) or (item.amount is not None and item.amount != (1, 1, False)):
        return None
    look = (item.traits.colors, item.traits.labels)
    plain = item.traits == Traits(colors=look[0], labels=look[1]) and sum(map(len, look)) == 1
    return look if plain and item.part_of is None and not item.conditions else None


def between_in_line(clause: Clause) -> Clause:
    """ "(Put) a black cube between two white ones in a row": a row of the three, with the black one in the middle."""
    into, place = (next((a for a in clause.adjuncts if isinstance(a, kind)), None) for kind in (Into, Loc))
    line = into.structure if isinstance(into, Into) else None
    if clause.verb not in ("be", "place") or clause.negated or not isinstance(line, Structure) or line.kind == "stack":
        return clause
    if not isinstance(place, Loc) or place.rel != "between" or place.negated or place.mods or len(clause.adjuncts) != 2:
        return clause
    bare = line.kind in _LINES and not (line.plural or line.members or line.sizes or line.details)
    ends = place.landmark.items if isinstance(place.landmark, Coord) else (place.landmark, place.second)
    theme, blocks = clause.theme, [x for x in ends if x is not None]
    if len(blocks) < 2 and getattr(blocks[0], "amount", None) != (2, 2, False):
        return clause
    if not bare or not isinstance(theme, Noun) or theme.plural or not all(map(_named_blocks, (theme, *blocks))):
        return clause
    inside = Absolute(theme=replace(theme, det="the", amount=None), adjuncts=(At(side="middle", span=place.span),),
                      span=clause.span)  # fmt: skip
    whole = Coord(op="and", items=(theme, *blocks), span=clause.span)
    return replace(clause, verb="build", lemma="", theme=replace(line, members=whole), adjuncts=(inside,))


def _named_blocks(item: Meaning) -> bool:
    """Blocks of which a colour or a symbol is said."""
    named = isinstance(item, Noun) and item.head != "patch" and bool(item.traits.colors or item.traits.labels)
    return named and isinstance(item, Noun) and item.part_of is None and not item.conditions


_BOARDS = ("grid", "square", "rectangle")


def as_a_grid(clause: Clause) -> Clause:
    """ "three columns of two in a grid", "(put them) in two rows of three as a grid": a grid of so many by so many."""
    intos = [a for a in clause.adjuncts if isinstance(a, Into)]
    told = intos[0] if len(intos) == 2 else None
    into = intos[-1].structure if len(intos) == 1 or told is not None else None
    lines = clause.theme if told is None else told.structure
    if not isinstance(lines, Structure) or not isinstance(into, Structure) or into.kind not in _BOARDS:
        return clause
    if lines.kind not in ("row", "column") or not lines.plural or lines.amount is None or lines.details:
        return clause
    size = lines.size if lines.size is not None else getattr(lines.members, "amount", None) if lines.each_size else None
    plain = not (into.plural or into.members or into.details or into.sizes) and into.filled is not False
    plain = plain and all(z.what != f"{lines.kind}s" for z in lines.sizes)  # "three rows and four rows in a grid"
    if not plain or size is None or size.low != size.high or lines.amount.low != lines.amount.high:
        return clause
    many, long = lines.amount.low, size.low
    dims = (many, long) if lines.kind == "row" else (long, many)
    if into.dims not in ((), dims) or (into.kind == "square" and many != long):
        return clause
    members = replace(lines.members, amount=None) if isinstance(lines.members, Noun) else lines.members
    grid = replace(lines, kind="grid", det="a", plural=False, amount=None, sizes=(), members=members, each_size=False,
                   dims=dims)  # fmt: skip
    kept = tuple(a for a in clause.adjuncts if a is not intos[-1])
    if told is not None:
        return replace(clause, adjuncts=tuple(replace(told, structure=grid) if a is told else a for a in kept))
    return replace(clause, theme=grid, adjuncts=kept)
