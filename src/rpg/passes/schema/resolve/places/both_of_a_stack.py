""" "Blue on red, and both on top of green": the lower one of them lies on the green block."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Pronoun, replace

_BOTH = frozenset({"both", "both of them", "them", "these"})


def both_of_a_stack(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with the lower one of the first two blocks for "both" that go on a further one behind them."""
    told = [clause for chain in chains for clause in chain.clauses]
    lower = _lower(told[0])
    if lower is None or len(told) == 1 or not _both_on_one(told[1]):
        return chains
    theme = replace(lower, det="the", amount=None)
    return tuple(
        replace(chain, clauses=tuple(replace(c, theme=theme) if c is told[1] and isinstance(c, Clause) else c
                                     for c in chain.clauses))
        for chain in chains
    )  # fmt: skip


def _lower(clause: Meaning) -> Noun | None:
    """The block on which one other is put."""
    place = _on(clause)
    if place is None or not isinstance(clause, Clause) or not _single(clause.theme):
        return None
    return place.landmark if isinstance(place.landmark, Noun) and _single(place.landmark) else None


def _both_on_one(clause: Meaning) -> bool:
    place = _on(clause)
    both = isinstance(clause, Clause) and isinstance(clause.theme, Pronoun) and clause.theme.word in _BOTH
    return both and place is not None and _single(place.landmark)


def _on(clause: Meaning) -> Loc | None:
    """The only thing that a clause says, if it is what something lies on."""
    if not isinstance(clause, Clause) or clause.negated or clause.verb not in ("be", "place", "stack"):
        return None
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    return place if isinstance(place, Loc) and place.rel == "on" and not place.negated and not place.mods else None


def _single(thing: Meaning | None) -> bool:
    """One block with a look of its own."""
    plain = isinstance(thing, Noun) and not thing.plural and thing.head != "patch" and thing.part_of is None
    return plain and isinstance(thing, Noun) and bool(thing.traits.colors or thing.traits.labels)
