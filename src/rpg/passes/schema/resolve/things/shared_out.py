""" "Divide the six blocks equally between the two patches": so many of them on each."""

from __future__ import annotations

from rpg.language.grammar.clauses.shared import SHARE
from rpg.language.meaning import Amount, Chain, Clause, Coord, Loc, Meaning, Noun, Traits, replace
from rpg.passes.schema.resolve.things.world import Scene, refuse

EACH, PATCHES = 2, 2
"""Blocks on each patch, and patches, where their number is open."""


def shared_out(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences with so many on each patch for what is shared."""
    return tuple(
        replace(chain, clauses=tuple(_on_each(c, scene) if _shares(c) else c for c in chain.clauses))
        if any(map(_shares, chain.clauses))
        else chain
        for chain in chains
    )


def _shares(clause: Meaning) -> bool:
    return isinstance(clause, Clause) and clause.lemma == SHARE


def _on_each(clause: Meaning, scene: Scene) -> Meaning:
    on = clause.adjuncts[0] if isinstance(clause, Clause) else None
    if not isinstance(clause, Clause) or not isinstance(on, Loc) or on.landmark is None:
        return clause
    among = _how_many(on.landmark) or PATCHES
    whole, many = clause.theme, _how_many(clause.theme)
    if not many and isinstance(whole, Noun):
        many = EACH * among
        whole = replace(whole, det="the", amount=Amount(many, many))
        colors = "".join(f"{color} " for color in whole.traits.colors)
        scene.assume(f"the number of {colors}blocks is not said: {many}")
    if many % among:
        raise refuse("count-mismatch", f"{many} blocks cannot be shared equally by {among} patches", clause.span,
                     f"say how many are on each, or share {many - many % among or among}")  # fmt: skip
    each = Amount(many // among, many // among)
    some = Noun(head="block", det="some", amount=each, plural=each.low > 1, part_of=whole, span=clause.span)
    marks = on.landmark
    if isinstance(marks, Noun) and marks.amount is None and not marks.traits.colors:
        marks = replace(marks, amount=Amount(among, among))
    every = Noun(head="patch", det="each", plural=True, part_of=marks, span=marks.span)
    return replace(clause, lemma="put", theme=some, adjuncts=(replace(on, landmark=every),))


def _how_many(theme: Meaning | None) -> int:
    """How many there are; 0 where it is not said."""
    if isinstance(theme, Coord):
        return sum(_how_many(item) or 1 for item in theme.items)
    if not isinstance(theme, Noun):
        return 0
    if theme.amount is not None:
        return theme.amount.low if theme.amount.low == theme.amount.high else 0
    look = theme.traits
    return len(look.labels or look.colors) if look != Traits() and len(look.labels or look.colors) > 1 else 0
