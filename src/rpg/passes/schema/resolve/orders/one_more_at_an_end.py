""" "Put three red blocks in a row and a white one at the right end of it": one more block in the line that was told."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Clause,
    Into,
    Loc,
    Meaning,
    Noun,
    PartOf,
    Places,
    Pronoun,
    Structure,
    replace,
)

_LINES = ("row", "line", "column")
_ENDS = ("left", "right", "front", "back", "end")


def at_its_end(clause: Clause, built: Clause | None) -> Clause:
    """The clause as one about a part of the line, if it puts one block of another look at an end of it."""
    place = _end(clause.adjuncts[0]) if len(clause.adjuncts) == 1 else None
    theme = clause.theme
    new = clause.verb in ("place", "be", "exist") and clause.mode in ("command", "goal") and not clause.negated
    if place is None or not new or not isinstance(theme, Noun) or built is None:
        return clause
    single = theme.amount in (None, Amount(1, 1)) and not theme.plural and theme.head != "patch" and not theme.part_of
    own = _members(built)
    if not single or own is None or not theme.traits.colors or {*own.traits.colors} & {*theme.traits.colors}:
        return clause
    part = Absolute(theme=theme, adjuncts=(place,), span=clause.span)
    return replace(clause, verb="part", lemma="", theme=None, adjuncts=(part,), mode="goal")


def _end(place: Meaning) -> At | Places | None:
    """The end of a line that is spoken of, and surely not that of the table."""
    if isinstance(place, At) and place.side in _ENDS and place.index is None:
        sure = place.whole in _LINES or place.side == "end"
        one = Places(side="ends", unit="block", several=1, span=place.span)
        return (one if place.side == "end" else replace(place, whole=None)) if sure else None
    part = place.landmark if isinstance(place, Loc) and not place.negated and place.rel in ("in", "at") else None
    if not isinstance(part, PartOf) or part.part not in _ENDS:
        return None
    whole = part.whole
    it = isinstance(whole, Pronoun) and whole.word == "it"
    line = isinstance(whole, Structure) and whole.kind in _LINES and whole.det == "the" and not whole.members
    return _end(At(side=part.part, whole="row", span=part.span)) if it or line else None


def _members(built: Clause) -> Noun | None:
    """The blocks of the one line that a clause builds, if they are counted and of one look."""
    shapes = [built.theme, *(a.structure for a in built.adjuncts if isinstance(a, Into))]
    lines = [x for x in shapes if isinstance(x, Structure)]
    if len(lines) != 1 or lines[0].kind not in _LINES or lines[0].plural or lines[0].details:
        return None
    if built.negated or built.mode in ("start", "given") or not all(isinstance(a, Into) for a in built.adjuncts):
        return None
    own = lines[0].members if lines[0] is built.theme else built.theme
    counted = isinstance(own, Noun) and own.amount is not None and len(own.traits.colors) == 1
    return own if counted and isinstance(own, Noun) else None
