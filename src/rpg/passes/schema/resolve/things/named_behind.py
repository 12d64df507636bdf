""" "Arrange the blocks so that A is on B and B is on C": the blocks are those that are named behind."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, In, Loc, Meaning, Noun, Pronoun, TableTop, That, Traits, parts_of
from rpg.passes.schema.resolve.things.world import Scene

_LAID = frozenset({"arrange", "place"})


def named_behind(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences without "arrange the blocks so that", where all that follows tells where named blocks are."""
    laid = [(chain, c) for chain in chains for c in chain.clauses if isinstance(c, Clause) and _of_the_blocks(c)]
    if len(laid) != 1:
        return chains
    home, clause = laid[0]
    so = clause.adjuncts[0]
    inner = so.clauses if isinstance(so, That) else None
    others = [c for chain in chains for c in chain.clauses if c is not clause]
    if not isinstance(inner, Chain) or not all(_of_named(c) for c in (*inner.clauses, *others)):
        return chains
    named = [x for c in (*inner.clauses, *others) for x in parts_of(c) if isinstance(x, Noun) and x.head != "patch"]
    if len({look for x in named for look in (*x.traits.colors, *x.traits.labels)}) < _FEW:
        return chains
    scene.assume("the blocks are those that are named")
    return tuple(_spliced(chain, clause, inner) if chain is home else chain for chain in chains)


_FEW = 2
"""One block alone would be among others that are not named."""


def _of_the_blocks(clause: Clause) -> bool:
    """ "Arrange the blocks so that ...", and no more."""
    theme, so = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    plain = isinstance(theme, Noun) and (theme.head, theme.det, theme.plural) == ("block", "the", True)
    bare = plain and isinstance(theme, Noun) and theme.traits == Traits() and theme.amount is None
    free = bare and isinstance(theme, Noun) and theme.part_of is None and not theme.conditions
    ordered = clause.verb in _LAID and clause.mode == "command" and not clause.negated
    return free and ordered and isinstance(so, That) and so.kind == "so"


def _of_named(clause: Meaning) -> bool:
    """Whether a clause tells where a block is, or goes, that is named, beside others that are named."""
    if not isinstance(clause, Clause) or not clause.adjuncts:
        return False
    if (clause.verb, clause.mode) not in (("be", "goal"), ("place", "command")):
        return False
    nothing = isinstance(clause.theme, Pronoun) and clause.theme.word == "nothing"
    things = [clause.theme, *(x.landmark for x in clause.adjuncts if isinstance(x, Loc))]
    things += [x.second for x in clause.adjuncts if isinstance(x, Loc) and x.second is not None]
    things = [y for x in things for y in (x.items if isinstance(x, Coord) and x.op == "and" else (x,))]
    placed = all(isinstance(x, Loc | In) for x in clause.adjuncts)
    return placed and all(isinstance(x, TableTop) or (isinstance(x, Noun) and _is_named(x)) for x in things[nothing:])


def _is_named(noun: Noun) -> bool:
    plain = noun.det in ("the", "bare") and noun.amount is None and noun.part_of is None and not noun.conditions
    looks = noun.traits in (Traits(colors=noun.traits.colors), Traits(labels=noun.traits.labels))
    return plain and looks and noun.traits != Traits()


def _spliced(chain: Chain, clause: Clause, inner: Chain) -> Chain:
    at = chain.clauses.index(clause)
    clauses = (*chain.clauses[:at], *inner.clauses, *chain.clauses[at + 1 :])
    links = (*chain.links[: at + 1], *inner.links[1:], *chain.links[at + 1 :])
    return Chain(clauses=clauses, links=links, span=chain.span)
