"""Rows told by what is put at their ends: "two red blocks at the ends of a row and three blue ones between them"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Absolute, Amount, Clause, Meaning, Noun, Places, Size, Structure

_PUT = ("put", "place", "have", "set", "lay", "position", "keep")
_GO = ("go", "should go", "must go", "are", "should be", "must be", "stand", "belong", "should stand", "lie", "sit")
_ENDS = Patterns(
    "at|on|to|onto the? both|two|either|left_and_right? the? ends of a|the|one|your|our row|line of|with?",
    "at|on each|either end of a|the|one|your|our row|line of|with?",
)
_JOINT = (", and", "and", ",", ", with", "with", ", while", "while", ";")
_INSIDE = Patterns(
    "somewhere|anywhere? in? between them|it|those|these|the_two|the_ends?",
    "inside|within it|the_row|the_line|them?",
    "in the|its middle|center of_it|of_the_row|of_the_line|of_them?",
    "in the places|spots left|in_between",
)
_MARKED = frozenset({"ends", "end"})
_ROWS = frozenset({"row", "line"})


@choice
def ends_filled(p: Parser, i: int) -> Results[Clause]:
    """What is at both ends, and all that is between them; how many they are in all may be told with the row."""
    if not p.rarely(_MARKED) or not p.anywhere(_ROWS):
        return
    for ends, j in simple(p, p.any_of(i, _PUT) or i):
        for k in _ENDS.matches(p, p.any_of(j, _GO) or j) if _several(ends, 2) else ():
            size = p.number(k) if p.follows(k, ("of", "with")) else None
            if (size is None) == p.follows(k, ("of", "with")):
                continue
            after = k if size is None else p.opt(k + 1, "blocks", "cubes", "in")
            joint = p.any_of(after, _JOINT)
            for rest, end in simple(p, joint) if joint else ():
                inside = max(_INSIDE.matches(p, p.any_of(end, _GO) or end), default=0)
                alike = isinstance(rest, Noun) and len(rest.traits.colors + rest.traits.labels) < 2
                if inside and alike and _several(rest, None if size is None else size - 2):
                    yield _row(p, i, inside, ends, rest, size), inside


def _several(theme: Meaning, many: int | None) -> bool:
    """Blocks of one look, which may be so many."""
    if not isinstance(theme, Noun) or theme.head == "patch" or theme.part_of is not None or theme.conditions:
        return False
    told = theme.amount is None or theme.amount.low == theme.amount.high
    fits = many is None or theme.amount is None or theme.amount.low == many
    return told and fits and bool(theme.traits.colors or theme.traits.labels or theme.traits.kind)


def _row(p: Parser, i: int, j: int, ends: Meaning, rest: Meaning, size: int | None) -> Clause:
    span = p.span(i, j)
    sizes = () if size is None else (Size(what="size", amount=Amount(size, size), span=span),)
    row = Structure(kind="row", det="a", amount=Amount(1, 1), sizes=sizes, span=span)
    parts = tuple(
        Absolute(theme=theme, adjuncts=(Places(side=side, unit="block", span=theme.span),), span=theme.span)
        for theme, side in ((ends, "ends"), (rest, "rest"))
    )
    return Clause(verb="build", theme=row, adjuncts=parts, mode="goal", span=span)
