""" "Two blue cubes are next to each other, the red one lies on the left one": they stand in a row, of which that is one
end."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Into, Loc, Meaning, Noun, Pronoun, Structure, parts_of, replace

_SIDES = frozenset({"@left", "@right", "left", "right"})
_TWO = Amount(2, 2)


def left_of_two(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with a row for two alike that stand next to each other, where the left one of them is spoken of."""
    told = [clause for chain in chains for clause in chain.clauses]
    pair, rest = told[0], told[1:]
    things = [thing for clause in rest for thing in parts_of(clause)]
    patches = any(isinstance(thing, Noun) and thing.head == "patch" for thing in things)
    if not isinstance(pair, Clause) or not _side_by_side(pair) or patches or not any(map(_one_side, things)):
        return chains
    place = pair.adjuncts[0]
    row = Into(structure=Structure(kind="row", amount=Amount(1, 1), span=place.span), span=place.span)
    lined = replace(pair, adjuncts=(replace(place, rel="side_by_side"), row))
    return (replace(chains[0], clauses=(lined, *chains[0].clauses[1:])), *chains[1:])


def _side_by_side(clause: Clause) -> bool:
    theme, place = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    two = isinstance(theme, Noun) and theme.amount == _TWO and theme.head != "patch" and bool(theme.traits.colors)
    mutual = isinstance(place, Loc) and isinstance(place.landmark, Pronoun) and place.landmark.word == "each other"
    beside = isinstance(place, Loc) and place.rel in ("beside", "side_by_side") and not (place.negated or place.mods)
    return (
        two and mutual and beside and not clause.negated and clause.mode != "start" and clause.verb in ("be", "place")
    )


def _one_side(thing: Meaning) -> bool:
    return isinstance(thing, Noun) and thing.traits.rank in _SIDES and thing.part_of is None and thing.head != "patch"
