"""Which blocks a turn is said of: every one, so many of them, either, all but one, and which are not turned then."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from math import comb

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.language.meaning import Amount, Coord, Meaning, replace
from rpg.passes.schema.resolve.goals.logic import conj, disj, negation
from rpg.passes.schema.resolve.things.world import Ref, refuse

Atom = Callable[[str], g.Goal]
MOST_CHOICES = 30
"""Of symbols that differ, so many choices of some of them are told one by one."""


def turned_of(theme: Ref, atom: Atom, span: Span, *, done: bool) -> list[g.Goal]:
    """`atom` of every, any, or so many of the theme's blocks. `done`: it is a turn that is made, so that what is left
    out of it is not turned at all."""
    if theme.quant is not None:
        return [_so_many(theme.names, theme.quant, atom, span)]
    if theme.op in ("or", "xor"):
        parts = [conj(turned_of(part, atom, span, done=done), span) for part in theme.parts]
        both = [g.Not(goal=g.All(goals=tuple(parts), span=span), span=span)] if theme.op == "xor" else []
        return [disj(parts, span), *both]
    if theme.op == "nor":
        return negation([atom(name) for name in theme.names], span)
    if theme.op == "except":
        inside, out = theme.parts
        kept = [unturned(n, span) if done else g.Not(goal=atom(n), span=span) for n in out.names]
        return [*turned_of(inside, atom, span, done=done), *kept]
    if theme.mixed:
        return [goal for part in theme.parts for goal in turned_of(part, atom, span, done=done)]
    return [atom(name) for name in theme.names]


def unturned(name: str, span: Span) -> r.Turned:
    """A block that lies as it did at the start."""
    return r.Turned(block=name, degrees=0.0, span=span)


def _so_many(names: tuple[str, ...], quant: Amount, atom: Atom, span: Span) -> g.Goal:
    low, high = quant.low, len(names) if quant.high is None else quant.high
    whichever = atom(names[0])
    if high == 0:
        return conj(negation([atom(name) for name in names], span), span)
    if low == len(names):
        return conj([atom(name) for name in names], span)
    if isinstance(whichever, r.Turned):
        each = whichever.model_copy(update={"block": EACH})
        return g.Count(over=names, at_least=low, at_most=quant.high, goal=each, span=span)
    if comb(len(names), low) + comb(len(names), min(high + 1, len(names))) > MOST_CHOICES:
        raise refuse("ambiguous", "these are too many to choose from", span, "name the blocks that are turned")
    enough = [conj([atom(n) for n in some], span) for some in combinations(names, low)] if low else []
    too_many = [conj([atom(n) for n in some], span) for some in combinations(names, high + 1)]
    parts: list[g.Goal] = [disj(enough, span)] if enough else []
    return conj([*parts, *(g.Not(goal=goal, span=span) for goal in too_many)], span)


def is_none(theme: Ref) -> bool:
    """ "neither A nor B", "none of them": what is said is so of none."""
    return theme.op == "nor" or (theme.quant is not None and theme.quant.high == 0)


def neither(told: Meaning | None) -> Meaning | None:
    """ "without turning A or B", "do not move A or B": neither of them."""
    return replace(told, op="and") if isinstance(told, Coord) and told.op == "or" else told
