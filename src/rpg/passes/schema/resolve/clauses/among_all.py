""" "No block touches another", "no two blocks may touch": none of all that there are, or of those spoken of."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    That,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.counted import put

_ANOTHER = frozenset({"another", "any other", "any other one", "any of the others", "the others", "each other"})
_MUTUAL = frozenset({"touching", "beside", "adjacent", "side_by_side", "near", "on", "above", "heaped"})
"""Relations that no two blocks are in if none of them is in it with another."""
TWO = Amount(2, 2)


def among_all(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with "none of the blocks ... each other" for this; where no block is spoken of, of all blocks."""
    denials = [x for chain in chains for x in parts_of(chain) if isinstance(x, Clause) and _of_every_two(x)]
    themes = [clause.theme for clause in denials]
    marks = [x.landmark for clause in denials for x in clause.adjuncts if isinstance(x, Loc)]
    others = [
        x for chain in chains for x in parts_of(chain) if x not in themes and x not in marks and _brings_blocks(x)
    ]
    for clause in denials:
        theme = clause.theme
        if not isinstance(theme, Noun):
            continue
        said = tuple(_each_other(x) if isinstance(x, Loc) else x for x in clause.adjuncts)
        whole = Noun(head="block", det="the", plural=True, traits=theme.traits, span=theme.span)
        none = replace(theme, plural=True, amount=TWO)
        if not others:
            none = replace(none, amount=None, traits=Traits(), part_of=whole)
        denied = replace(clause, theme=none, adjuncts=said)
        chains = tuple(put(chain, clause, denied) for chain in chains)
    return tuple(replace(chain, clauses=tuple(map(_only_apart, chain.clauses))) for chain in chains)


def _only_apart(clause: Meaning) -> Meaning:
    """ "Separate the blocks so that no two touch": this is all that is asked for, and nothing is sorted."""
    if (
        not isinstance(clause, Clause)
        or (clause.verb, clause.lemma) != ("sort", "separate")
        or len(clause.adjuncts) != 1
    ):
        return clause
    so = clause.adjuncts[0]
    told = so.clauses.clauses if isinstance(so, That) and isinstance(so.clauses, Chain) else ()
    apart = len(told) == 1 and isinstance(told[0], Clause) and _no_two(told[0])
    return replace(clause, verb="arrange", lemma="arrange") if apart else clause


def _no_two(clause: Clause) -> bool:
    none = isinstance(clause.theme, Noun) and clause.theme.det == "no"
    marks = [getattr(x, "landmark", None) for x in clause.adjuncts]
    return (none or clause.negated) and [getattr(mark, "word", "") for mark in marks] == ["each other"]


def _of_every_two(clause: Clause) -> bool:
    """ "No block" or "no two blocks", and a relation between them."""
    theme, places = clause.theme, [x for x in clause.adjuncts if isinstance(x, Loc)]
    if not isinstance(theme, Noun) or (theme.head, theme.det, theme.part_of) != ("block", "no", None) or clause.negated:
        return False
    look = theme.traits
    plain = theme.amount in (None, TWO) and not theme.conditions and look == Traits(colors=look.colors[:1])
    if not plain or len(places) != 1 or places[0].negated or places[0].rel not in _MUTUAL:
        return False
    if places[0].rel in _UPRIGHT and look != Traits():
        return False
    return _other(places[0].landmark, look) and (look == Traits() or theme.amount is None)


def _other(mark: Meaning | None, look: Traits) -> bool:
    if isinstance(mark, Noun):
        one = mark.det == "another" and not mark.plural and mark.part_of is None and mark.amount in (None, Amount(1, 1))
        alike = mark.traits == look or (mark.head == "any" and mark.traits == Traits())
        return one and mark.head in ("any", "block") and alike  # "no blue block touches another block" is of all others
    return isinstance(mark, Pronoun) and mark.word in _ANOTHER


def _each_other(place: Loc) -> Loc:
    """ "Touching another" is touching each other; of a tower it is told of one block and another."""
    mark = place.landmark
    span = mark.span if mark is not None else place.span
    if place.rel in _UPRIGHT:
        return replace(place, rel="on", landmark=Pronoun(word="another", span=span))
    return replace(place, landmark=Pronoun(word="each other", span=span))


_UPRIGHT = frozenset({"on", "above", "heaped"})


def _brings_blocks(part: Meaning) -> bool:
    return isinstance(part, Structure) or (isinstance(part, Noun) and part.head != "patch")
