""" "A row of red, blue and yellow with no block to the left of the yellow one": yellow is at the left end."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    That,
    Traits,
    replace,
)

_ENDS = {"left": "left", "right": "right", "front": "front", "behind": "back", "under": "bottom"}
_ALONG = {"row": ("left", "right"), "line": ("left", "right"), "column": ("front", "back"), "stack": ("bottom",)}


def at_that_end(clause: Clause) -> Clause:
    """The clause with the end at which the block is, where nothing of the line is beyond it."""
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    shape = clause.theme if isinstance(clause.theme, Structure) else shapes[0] if len(shapes) == 1 else None
    kind = shape.kind if isinstance(shape, Structure) else "stack" if clause.verb == "stack" else ""
    if clause.negated or kind not in _ALONG or (isinstance(shape, Structure) and shape.plural):
        return clause
    adjuncts = tuple(_ended(a, _ALONG[kind]) for a in clause.adjuncts)
    theme = clause.theme
    if isinstance(theme, Structure):
        theme = replace(theme, details=tuple(_ended(a, _ALONG[kind]) for a in theme.details))
    same = adjuncts == clause.adjuncts and theme == clause.theme
    return clause if same else replace(clause, theme=theme, adjuncts=adjuncts)


def _ended(part: Meaning, ends: tuple[str, ...]) -> Meaning:
    if isinstance(part, Coord) and part.op == "absolutes":
        return replace(part, items=tuple(_ended(x, ends) for x in part.items))
    if isinstance(part, That) and (inside := _in_which(part)) is not None:
        found = _ended(inside, ends)
        return part if found is inside else found
    place = part.adjuncts[0] if isinstance(part, Absolute) and len(part.adjuncts) == 1 else None
    if not isinstance(part, Absolute) or not isinstance(place, Loc) or place.negated or place.low or place.high:
        return part
    end, mark = _ENDS.get(place.rel, ""), place.landmark
    if end not in ends or not _nothing(part.theme) or not isinstance(mark, Noun) or mark.head == "patch":
        return part
    return replace(part, theme=mark, adjuncts=(At(side=end, span=place.span),))


def _in_which(part: That) -> Absolute | None:
    """ "(A row) in which nothing is to the left of the yellow one": as "with nothing to the left of it"."""
    inside = part.clauses.clauses if part.kind == "so" and isinstance(part.clauses, Chain) else ()
    told = inside[0] if len(inside) == 1 else None
    if not isinstance(told, Clause) or told.verb != "be" or told.negated or told.theme is None:
        return None
    return Absolute(theme=told.theme, adjuncts=told.adjuncts, span=part.span)


def _nothing(theme: Meaning) -> bool:
    if isinstance(theme, Pronoun):
        return theme.word in ("nothing", "nothing else")
    plain = isinstance(theme, Noun) and theme.det == "no" and theme.head != "patch"
    return plain and isinstance(theme, Noun) and theme.traits == Traits() and theme.part_of is None
