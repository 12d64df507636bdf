"""Blocks that are sorted into groups that are listed: "sort the cubes into a group of three red ones and a group of
three blue ones" tells which cubes there are by its groups."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Into, Meaning, Noun, OrderBy, Structure, Traits, replace


def groups_listed(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, the first of them by its groups alone if no blocks but theirs are spoken of in it."""
    clauses = chains[0].clauses
    sort = clauses[0] if len(clauses) < 3 else None
    if not isinstance(sort, Clause) or sort.verb != "sort" or sort.negated or not _all_there_are(sort.theme):
        return chains
    rest = [a for a in sort.adjuncts if not (isinstance(a, OrderBy) and a.by == "attribute" and not a.items)]
    told = clauses[1] if len(clauses) > 1 else None
    groups: Meaning | None = None
    if told is None and len(rest) == 1 and isinstance(rest[0], Into):
        groups = rest[0].structure
    elif isinstance(told, Clause) and told.verb == "build" and not (rest or told.adjuncts or told.negated):
        groups = told.theme
    if not isinstance(groups, Coord) or groups.op != "and" or not _of_one_look(groups):
        return chains
    built = Clause(verb="build", theme=groups, mode="goal", span=chains[0].span)
    return (replace(chains[0], clauses=(built,), links=("and",)), *chains[1:])


def _all_there_are(theme: Meaning | None) -> bool:
    """ "the cubes", of which nothing else is said."""
    plain = isinstance(theme, Noun) and theme.head == "block" and theme.traits == Traits() and theme.plural
    return plain and isinstance(theme, Noun) and theme.det in ("the", "all") and theme.amount is None


def _of_one_look(groups: Coord) -> bool:
    """ "a group of three red ones and a group of two blue ones": of each group it is said what is in it."""
    looks = []
    for one in groups.items:
        lot = one.members if isinstance(one, Structure) and one.kind == "pile" and not one.plural else None
        if not isinstance(lot, Noun) or lot.amount is None or lot.amount.low != lot.amount.high:
            return False
        looks.append(lot.traits.colors)
    return all(len(colors) == 1 for colors in looks) and len(set(looks)) == len(looks)
