""" "A tower of five with the red block at the bottom and blue blocks above it": all the others are blue."""

from __future__ import annotations

from rpg.language.meaning import Absolute, At, Clause, Coord, Loc, Meaning, Noun, Places, Pronoun, Structure, replace

_ENDS = {"bottom": ("top", ("on", "above")), "top": ("bottom", ("under",)), "left": ("right", ("right",)),
         "right": ("left", ("left",)), "front": ("back", ("behind",)), "back": ("front", ("front",))}  # fmt: skip
_LINES = ("stack", "row", "line", "column")


def others_beyond(clause: Clause) -> Clause:
    """The clause with "the others blue", where one block stands at an end of so many and blue ones beyond it."""
    shape = clause.theme
    if clause.verb not in ("build", "part", "arrange") or not isinstance(shape, Structure) or shape.kind not in _LINES:
        return clause
    if shape.plural or shape.members is not None or shape.size is None or shape.size.low != shape.size.high:
        return clause
    told = [x for x in (*_flat(shape.details), *_flat(clause.adjuncts)) if isinstance(x, Absolute)]
    first, second = told if len(told) == 2 else (None, None)
    if first is None or second is None or not _beyond(first, second):
        return clause
    rest = replace(second, adjuncts=(Places(side="rest", unit="block", span=second.adjuncts[0].span),))
    details = tuple(rest if x is second else x for x in _flat(shape.details))
    adjuncts = tuple(rest if x is second else x for x in _flat(clause.adjuncts))
    return replace(clause, theme=replace(shape, details=details), adjuncts=adjuncts)


def _flat(adjuncts: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """The adjuncts, with those that are told of parts together one by one."""
    return tuple(
        x for a in adjuncts for x in (a.items if isinstance(a, Coord) and a.op == "absolutes" else (a,))
    )  # fmt: skip


def _beyond(first: Absolute, second: Absolute) -> bool:
    end = first.adjuncts[0] if len(first.adjuncts) == 1 else None
    place = second.adjuncts[0] if len(second.adjuncts) == 1 else None
    one, many = first.theme, second.theme
    if not isinstance(end, At) or end.side not in _ENDS or end.index not in (None, 1):
        return False
    if not isinstance(one, Noun) or one.plural or not isinstance(many, Noun) or not many.plural:
        return False
    open_ = many.det == "bare" and many.amount is None and many.head != "patch" and len(many.traits.colors) == 1
    opposite, ways = _ENDS[end.side]
    if isinstance(place, At):
        return open_ and place.side == opposite and place.index is None
    of_it = isinstance(place, Loc) and place.rel in ways and isinstance(place.landmark, Pronoun)
    return open_ and of_it and isinstance(place, Loc) and not place.negated and place.low is place.high is None
