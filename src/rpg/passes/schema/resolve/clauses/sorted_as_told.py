""" "Sort the letters so that the vowels are in one group and the consonants in another": what follows tells of the
groups, and the verb which blocks there are."""

from __future__ import annotations

from itertools import zip_longest

from rpg.language.meaning import Chain, Clause, Coord, In, Into, Loc, Meaning, Noun, Structure, That, replace

_SORTS = frozenset({"sort", "group", "cluster", "separate", "divide", "split", "partition", "segregate"})
_MANY = 2
"""Groups, at least, that are told of."""


def sorted_as_told(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with the blocks that are to be sorted just there, where their groups are told one by one."""
    return tuple(_as_told(chain, after) for chain, after in zip_longest(chains, chains[1:]))


def _as_told(chain: Chain, after: Chain | None) -> Chain:
    clause = chain.clauses[0]
    plain = isinstance(clause, Clause) and clause.verb == "sort" and clause.lemma in _SORTS and not clause.negated
    if not isinstance(clause, Clause) or not plain or len(chain.clauses) > 1 or not _listed(clause.theme):
        return chain
    there = Clause(verb="exist", theme=clause.theme, mode="given", span=clause.span)
    if not clause.adjuncts and after is not None and _of_groups(after):
        return replace(chain, clauses=(there,))
    so = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if isinstance(so, That) and so.kind == "so" and isinstance(so.clauses, Chain) and _of_groups(so.clauses):
        return replace(so.clauses, clauses=(there, *so.clauses.clauses), links=("and", *so.clauses.links))
    return chain


def _listed(theme: Meaning | None) -> bool:
    """Whether the blocks are named or counted."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(map(_listed, theme.items))
    return isinstance(theme, Noun) and theme.head != "patch" and (bool(theme.traits.labels) or theme.amount is not None)


def _of_groups(told: Chain) -> bool:
    """Whether all that is said is which blocks are together, and where."""
    clauses = [x for x in told.clauses if isinstance(x, Clause)]
    told_all = len(clauses) == len(told.clauses) >= _MANY and set(told.links) == {"and"}
    return told_all and all(_of_a_group(x) and any(map(_together, x.adjuncts)) for x in clauses)


def _of_a_group(clause: Clause) -> bool:
    places = clause.adjuncts
    grouped = bool(places) and all(isinstance(x, In | Loc) or _pile(x) for x in places)
    return clause.verb in ("be", "place") and not clause.negated and isinstance(clause.theme, Noun) and grouped


def _together(place: Meaning) -> bool:
    return (isinstance(place, Loc) and place.rel == "together") or _pile(place)


def _pile(into: Meaning) -> bool:
    return isinstance(into, Into) and isinstance(into.structure, Structure) and into.structure.kind in ("pile", "again")
