"""Colours listed behind a line: "a row in the colours red, white and blue", "a tower of three, coloured red, ..."."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Amount, Coord, Meaning, Noun, OrderBy, Structure, Toward, Traits, replace

_COLORS = tuple(
    f"{lead}{word}{of}"
    for lead in (
        "in ", "in the ", "with ", "with the ", "of ", "of the ", ", ", "", "whose ", "where the ", "with its ",
        "using the ",
    )
    for word in ("colors", "color", "colored", "painted")
    for of in ("", " :", " are", " are :", " being", " of")
)  # fmt: skip
"""What the colours of a line's blocks are listed after."""


def in_colors(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "a row in the colours red, white and blue", "a tower of three blocks coloured red, white and blue"."""
    members = base.members
    lead = p.any_of(k, _COLORS) if base.kind in ("stack", "row", "line", "column") and not base.plural else 0
    if not lead or base.traits.colors or not (members is None or _uncoloured(members)):
        return
    size = base.size or (members_amount(members) if members is not None else None)
    for way, k in toward(p, lead):
        for items, end in listed(p, p.opt(p.any_of(k, ("are", "being", "is")) or k, ":", ",")):
            if isinstance(way, Toward) and _as_many_colors(items, size):
                whole = Coord(op="and", items=items, span=p.span(lead, end))
                given = OrderBy(by="named", items=items, first=way.first, span=p.span(lead, end))
                told = (*base.details, given)
                yield replace(base, members=whole, sizes=(), details=told, span=p.span(i, end)), end
    for items, end in listed(p, lead):
        if _as_many_colors(items, size):
            whole = Coord(op="and", items=items, span=p.span(lead, end))
            yield replace(base, members=whole, sizes=(), span=p.span(i, end)), end


def _as_many_colors(items: tuple[Meaning, ...], size: Amount | None) -> bool:
    """One colour for each block."""
    colored = all(isinstance(x, Noun) and x.traits == Traits(colors=x.traits.colors[:1]) for x in items)
    return colored and (size is None or size.low == size.high == len(items))


def _uncoloured(members: Meaning) -> bool:
    """Blocks of which no look is said."""
    return isinstance(members, Noun) and members.traits == Traits() and members.head == "block" and not members.part_of


def members_amount(members: Meaning) -> Amount | None:
    """The number that a members phrase gives."""
    return getattr(members, "amount", None)
