"""Blocks of which most are told, and the one that is left in passing: "four in a row, three are white, and the black
one is the third"."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Coord, Noun, Traits, replace


def tally_filled(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with that one told beside the others."""
    clauses = [c for chain in chains for c in chain.clauses if isinstance(c, Clause)]
    for n, said in enumerate(clauses):
        if (last := _last_one(clauses[:n], said, clauses[n + 1 :])) is not None and said.theme is not None:
            whole = replace(said, theme=Coord(op="and", items=(said.theme, last), span=said.theme.span))
            return tuple(
                replace(chain, clauses=tuple(whole if c is said else c for c in chain.clauses)) for chain in chains
            )
    return chains


def _last_one(before: list[Clause], said: Clause, behind: list[Clause]) -> Noun | None:
    """The one block of another colour, where all but one of those that were counted are told."""
    told = said.theme if said.verb == "exist" and said.lemma == "tally" else None
    counts = [c.theme.amount for c in before if isinstance(c.theme, Noun) and _plain(c.theme)]
    if len(counts) != 1 or not isinstance(told, Noun) or told.amount is None or counts[0] is None or not behind:
        return None
    many = counts[0].low - 1
    if told.amount != Amount(many, many) or told.traits != Traits(colors=told.traits.colors[:1]) or many < 1:
        return None
    one = behind[0].theme
    if not isinstance(one, Noun) or one.det not in ("the", "bare") or one.plural or one.amount or one.part_of:
        return None
    other = len(one.traits.colors) == 1 and one.traits == Traits(colors=one.traits.colors)
    if not other or one.traits.colors == told.traits.colors or one.head == "patch":
        return None
    return replace(one, head="block", det="a", amount=Amount(1, 1))


def _plain(theme: Noun) -> bool:
    exact = theme.amount is not None and theme.amount.low == theme.amount.high and theme.det == "bare"
    return exact and theme.head == "block" and theme.traits == Traits() and theme.part_of is None
