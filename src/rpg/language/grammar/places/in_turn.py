"""Parts told one after the other: "then blue, green on top"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, replace

_ENDS = frozenset({"left", "right", "front", "back", "top", "bottom"})


def one_by_one(p: Parser, part: Absolute) -> tuple[Absolute, ...]:
    """ "then blue, green on top": blue comes next, and green alone is on top. Nothing for a single block."""
    theme, place = part.theme, part.adjuncts[0]
    if not isinstance(place, At) or place.side not in _ENDS:
        return ()
    if isinstance(theme, Coord) and theme.op == "and" and all(map(_single, theme.items)):
        return (*map(_next, theme.items[:-1]), replace(part, theme=theme.items[-1]))
    if not isinstance(theme, Noun) or theme.amount is not None:
        return ()
    looks = [replace(theme.traits, colors=(color,)) for color in theme.traits.colors]
    if len(theme.traits.labels) > 1:
        looks = [replace(theme.traits, labels=(label,)) for label in theme.traits.labels]
    if len(looks) < 2:
        return ()
    named = [t.span for t in p.tokens if theme.span[0] <= t.span[0] < theme.span[1] and t.word not in (",", "and")]
    if len(named) != len(looks):
        return ()
    single = [
        replace(theme, traits=look, plural=False, head="any", span=span)
        for look, span in zip(looks, named, strict=True)
    ]
    return (*map(_next, single[:-1]), replace(part, theme=single[-1]))


def in_turn(part: Absolute) -> tuple[Absolute, ...]:
    """ "two purple ones, then an orange one last": the last thing is there, and what is named before it comes next."""
    theme, place = part.theme, part.adjuncts[0]
    if not isinstance(theme, Coord) or theme.op != "then" or not isinstance(place, At) or place.side == "middle":
        return ()
    return (*map(_next, theme.items[:-1]), replace(part, theme=theme.items[-1]))


def _next(one: Meaning) -> Absolute:
    return Absolute(theme=one, adjuncts=(At(side="next", span=one.span),), span=one.span)


def _single(one: Meaning) -> bool:
    """A single look without a number."""
    looks = one.traits.colors + one.traits.labels if isinstance(one, Noun) else ()
    return isinstance(one, Noun) and len(looks) == 1 and one.amount in (None, Amount(1, 1)) and not one.plural
