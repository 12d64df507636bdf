""" "Take apart the tower of two red blocks and the tower of two blue ones and build one tower": of these blocks. "Take
the white ones and make a tower": of these as well."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse


def rebuilt_of(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with what is built behind that made of the blocks of what is taken apart.

    Raises:
        Refusal: something is built of structures of which it is not told that they are there.
    """
    known = False
    found = []
    chains = _there_first(chains)
    for chain in chains:
        for clause in chain.clauses:
            known = known or (isinstance(clause, Clause) and clause.mode in ("given", "start"))
            _check_used(clause, known=known)
        clauses = list(chain.clauses)
        for n, (taken, made) in enumerate(pairwise(chain.clauses), 1):
            if (
                isinstance(taken, Clause)
                and isinstance(made, Clause)
                and (_apart(taken) or _taken(taken))
                and _open(made)
            ):
                them = Pronoun(word="them", span=made.span)
                clauses[n] = replace(made, adjuncts=(Using(members=them, span=made.span), *made.adjuncts))
        found.append(chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def _there_first(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Take the tower of four apart and build two towers of two": with the tower told to be there, for something is
    built of so many blocks behind it."""
    told = [(n, k, c) for n, chain in enumerate(chains) for k, c in enumerate(chain.clauses) if isinstance(c, Clause)]
    at = next(
        (m for m, (_, _, c) in enumerate(told) if c.verb == "unstack" and not c.negated and _counted(c.theme)), -1
    )
    if at < 0 or not any(_made(c) for _, _, c in told[at + 1 :]) or any(c.mode in _GIVEN for _, _, c in told[:at]):
        return chains
    n, k, taken = told[at]
    whole = taken.theme
    assert isinstance(whole, Structure)
    begun = replace(whole, det="bare" if whole.plural else "a", amount=whole.amount or Amount(1, 1))
    there = Clause(verb="exist", lemma="begun", theme=begun, mode="given", span=whole.span)
    taken = replace(taken, theme=Pronoun(word="them", span=whole.span))
    chain, (after, _, made) = chains[n], told[at + 1]
    at_once = after == n and chain.links[k + 1] == "and" and _of_these(made, whole)  # "turn it into two towers"
    clauses = (*chain.clauses[:k], there, *(() if at_once else (taken,)), *chain.clauses[k + 1 :])
    links = (*chain.links[: k + 1], *(() if at_once else ("and",)), *chain.links[k + 1 :])
    return (*chains[:n], replace(chain, clauses=clauses, links=links), *chains[n + 1 :])


_GIVEN = ("given", "start")


def _of_these(made: Clause, whole: Structure) -> bool:
    """Whether what is built has no other looks than what is taken apart."""
    looks = {x.traits for x in parts_of(whole) if isinstance(x, Noun | Structure)} | {Traits()}
    return all(x.traits in looks for x in parts_of(made) if isinstance(x, Noun | Structure))


def _counted(whole: Meaning | None) -> bool:
    """Whether so many blocks are said to be in a structure, and no more of them than their look."""
    if not isinstance(whole, Structure) or whole.det != "the" or whole.details or whole.letter:
        return False
    members = whole.members
    size = members.amount if isinstance(members, Noun) else whole.size if members is None else None
    return size is not None and size.low == size.high


def _made(clause: Clause) -> bool:
    """Whether new structures of so many blocks are built, of which nothing else is said."""
    shapes = clause.theme.items if isinstance(clause.theme, Coord) else (clause.theme,)
    used = any(isinstance(x, Using) for x in clause.adjuncts)
    return clause.verb == "build" and not clause.negated and not used and all(map(_sized, shapes))


def _sized(shape: Meaning | None) -> bool:
    members = shape.members if isinstance(shape, Structure) else None
    lots = members.items if isinstance(members, Coord) else (members,)
    told = all(getattr(x, "amount", None) is not None for x in lots) or getattr(shape, "size", None) is not None
    return isinstance(shape, Structure) and shape.det in ("a", "bare") and told


def _check_used(clause: object, *, known: bool) -> None:
    """Refuse "take the tower of two red blocks and build a row": is that tower there, or to be built?"""
    for using in clause.adjuncts if isinstance(clause, Clause) and clause.verb == "build" else ():
        wholes = [x for x in parts_of(using) if isinstance(x, Structure)] if isinstance(using, Using) else []
        if not known and any(x.det == "the" and (x.members or x.sizes) for x in wholes):
            raise refuse("ambiguous", "these are structures of the start or of the end", using.span,
                         "say what there is at the start, then what to build")  # fmt: skip


def _apart(taken: Clause) -> bool:
    """Whether several structures are taken apart that are told with their blocks."""
    wholes = [x for x in parts_of(taken.theme) if isinstance(x, Structure)] if taken.theme is not None else []
    return taken.verb == "unstack" and not taken.negated and len(wholes) > 1 and all(x.members for x in wholes)


def _taken(taken: Clause) -> bool:
    """Whether some of the blocks are taken up: "take the white ones (and make a tower)"."""
    some = isinstance(taken.theme, Noun) and bool(taken.theme.traits.colors)
    from_them = all(isinstance(x, Using) for x in taken.adjuncts)
    return taken.verb in ("pick", "use") and not taken.negated and from_them and some


def _open(made: Clause) -> bool:
    """Whether a structure is built of which nothing tells the blocks."""
    shape = made.theme if made.verb == "build" and not made.negated else None
    used = any(isinstance(x, Using) for x in made.adjuncts)
    bare = isinstance(shape, Structure) and shape.members is None and shape.traits == Traits() and not shape.sizes
    return bare and isinstance(shape, Structure) and not (shape.plural or shape.dims or used)
