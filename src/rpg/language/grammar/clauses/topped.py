""" "A red block with a blue one on top": on top of a single block is on it."""

from __future__ import annotations

from rpg.language.grammar.places.held import SIDES
from rpg.language.meaning import Absolute, At, Clause, In, Loc, Meaning, Noun, Pronoun, replace


def topped(theme: Meaning | None, found: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "a red block with a blue one on top": on it, for a single block has no parts."""
    single = isinstance(theme, Noun) and theme.head != "patch" and not theme.plural and theme.det in ("a", "the")
    return tuple(_on_it(a) for a in found) if single and len(found) == 1 else found


def topped_there(found: Meaning) -> Meaning:
    """ "Red with white on top in the corner", "in the corner, red with white on top": white is on it."""
    if not isinstance(found, Clause) or found.verb not in ("be", "place") or len(found.adjuncts) != 2:
        return found
    theme, tops = found.theme, [x for x in found.adjuncts if isinstance(x, Absolute)]
    placed = [x for x in found.adjuncts if isinstance(x, In) or (isinstance(x, Loc) and x.rel == "on")]
    beside = [x for x in found.adjuncts if isinstance(x, Loc) and x.rel in SIDES]
    placed = placed or [x for x in beside if tops and tops[0].span < x.span]
    one = isinstance(theme, Noun) and theme.head != "patch" and not theme.plural and len(theme.traits.colors) < 2
    lying = [x.landmark for x in placed if isinstance(x, Loc) and x.rel == "on"]
    on_block = [mark for mark in lying if getattr(mark, "head", "patch") != "patch"]
    several = isinstance(theme, Noun) and theme.amount is not None and theme.amount.low != 1
    if not one or several or len(tops) != 1 or len(placed) != 1 or on_block:
        return found
    return replace(found, adjuncts=tuple(_on_it(x) for x in found.adjuncts))


def _on_it(part: Meaning) -> Meaning:
    if not isinstance(part, Absolute) or len(part.adjuncts) != 1:
        return part
    place = part.adjuncts[0]
    if not isinstance(place, At) or (place.side, place.index, place.whole) != ("top", None, None):
        return part
    on = Loc(rel="on", landmark=Pronoun(word="it", span=place.span), span=place.span)
    return replace(part, adjuncts=(on,), cost=0)
