""" "Red on blue. Move red to the mat.": what is told without a verb, and is moved at once, is so at the start."""

from __future__ import annotations

from typing import TypeGuard

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Pronoun, Structure, parts_of, replace
from rpg.passes.schema.resolve.clauses.begun_upwards import begun_upwards

_MOVES = frozenset({"move", "take", "remove", "lift", "swap", "exchange", "trade", "reverse", "unstack", "shift",
                    "transfer", "push", "slide", "carry", "pull"})  # fmt: skip
"""What is done with blocks that are somewhere already."""


def bare_starts(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, the first of them told of the start where the second moves what it speaks of."""
    chains = tuple(_there(begun_upwards(chain)) for chain in chains)
    if len(chains) < 2 or len(chains[0].clauses) != 1:
        return chains
    first, then = chains[0].clauses[0], chains[1].clauses[0]
    if not isinstance(first, Clause) or not isinstance(then, Clause) or not _bare(first):
        return chains
    moved = then.mode == "command" and not then.negated and then.lemma in _MOVES
    if not moved or then.theme is None or not any(_of_them(x, first) for x in parts_of(then.theme)):
        return chains
    built = isinstance(first.theme, Structure)
    begun = replace(first, verb="exist", mode="given") if built else replace(first, mode="start")
    return (replace(chains[0], clauses=(begun,)), *chains[1:])


def _there(chain: Chain) -> Chain:
    """ "The episode starts with two towers of three": structures that are told of the start without a verb are what
    there is, as in "at the start there are two towers"."""
    told = [
        replace(c, verb="exist", lemma="begun", mode="given", cost=0) if _begun_structure(c) else c
        for c in chain.clauses
    ]
    return chain if told == [*chain.clauses] else replace(chain, clauses=tuple(told))


def _begun_structure(clause: Meaning) -> TypeGuard[Clause]:
    """Whether a clause brings up structures of the start, and tells of no place."""
    if not isinstance(clause, Clause) or (clause.verb, clause.mode, clause.lemma) != ("build", "start", ""):
        return False
    new = isinstance(clause.theme, Structure) and clause.theme.det in ("a", "bare")
    return new and not clause.negated


def _bare(clause: Clause) -> bool:
    """A structure, or blocks and where they are, told without a verb."""
    told = clause.mode == "goal" and not (clause.lemma or clause.word or clause.negated)
    if not told or clause.verb not in ("be", "build"):
        return False
    if isinstance(clause.theme, Structure):
        return clause.theme.det == "a" and not clause.theme.plural
    return bool(clause.adjuncts) and all(isinstance(a, Loc) for a in clause.adjuncts)


def _of_them(moved: Meaning, told: Clause) -> bool:
    """Whether what is moved is of what was told: by its look, by where it stands in a structure, or as "it"."""
    if isinstance(moved, Pronoun):
        return moved.word in ("it", "them") and isinstance(told.theme, Structure)
    if not isinstance(moved, Noun) or moved.det == "a" or told.theme is None:
        return False
    if moved.traits.rank is not None and isinstance(told.theme, Structure):
        return True
    looks = {*moved.traits.colors, *moved.traits.labels}
    known = {x for part in parts_of(told.theme) if isinstance(part, Noun) for x in _looks(part)}
    return bool(looks) and looks <= known


def _looks(noun: Noun) -> tuple[str, ...]:
    return (*map(str, noun.traits.colors), *noun.traits.labels)
