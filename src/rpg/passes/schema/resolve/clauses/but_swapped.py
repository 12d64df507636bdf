""" "Leave the row as it is, but swap its ends": all of it stays but for what changes places."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Amount, Chain, Clause, Coord, Manner, Meaning, Noun, Structure, replace


def but_swapped(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with the blocks of it that are swapped excepted from what stays."""
    found = tuple(map(_told, chains))
    first = found[0].clauses[0] if found and found[0] != chains[0] else None
    theme = first.theme if isinstance(first, Clause) else None
    row = theme.items[0] if isinstance(theme, Coord) and theme.op == "except" else None
    if not isinstance(row, Structure) or row.kind == "stack":
        return found
    there = replace(row, det="a", amount=Amount(1, 1))  # nobody told of it before, and it is there
    given = Clause(verb="exist", mode="given", theme=there, span=row.span)
    ahead = replace(found[0], clauses=(given, *found[0].clauses), links=("and", *found[0].links))
    return (ahead, *found[1:])


def _told(chain: Chain) -> Chain:
    kept: list[Meaning] = list(chain.clauses)
    for n, (stays, swaps) in enumerate(pairwise(chain.clauses)):
        swapped = swaps.theme if isinstance(swaps, Clause) and swaps.verb == "swap" else None
        if chain.links[n + 1] == "and" and swapped is not None and _of_a_line(stays) and _places(swapped):
            assert isinstance(stays, Clause) and stays.theme is not None
            kept[n] = replace(stays, theme=Coord(op="except", items=(stays.theme, swapped), span=stays.theme.span))
    return replace(chain, clauses=tuple(kept)) if tuple(kept) != chain.clauses else chain


def _of_a_line(said: Meaning) -> bool:
    """ "Leave the row as it is"."""
    if not isinstance(said, Clause) or said.verb != "keep" or said.negated or not isinstance(said.theme, Structure):
        return False
    stay = any(isinstance(a, Manner) and a.kind == "stay" for a in said.adjuncts)
    return said.theme.det == "the" and not said.theme.plural and stay


def _places(theme: Meaning) -> bool:
    """ "Its two ends", "the red block and the third one", "the top two"."""
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    return all(isinstance(item, Noun) for item in items)
