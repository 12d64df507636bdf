""" "Take apart the tower of two red blocks and the tower of two blue ones and build one tower": of these blocks. "Take
the white ones and make a tower": of these as well."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Chain, Clause, Noun, Pronoun, Structure, Traits, Using, parts_of, replace
from rpg.passes.schema.resolve.things.world import refuse


def rebuilt_of(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with what is built behind that made of the blocks of what is taken apart.

    Raises:
        Refusal: something is built of structures of which it is not told that they are there.
    """
    known = False
    found = []
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
