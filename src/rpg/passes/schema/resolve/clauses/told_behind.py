"""Facts behind an order: "Swap red and blue. Red is on the patch" may be of before or after; "Move the block that is on
blue. Red is on blue" says which block that is."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Traits, parts_of, replace
from rpg.passes.schema.resolve.things.world import refuse

_WHEN = re.compile(
    r"\b(?:must|should|shall|has to|have to|needs? to|will|end|final|finally|then|afterwards|start|initially|now|"
    r"at first|currently|already|result|so that)\b",
    re.IGNORECASE,
)


def told_behind(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences with a fact that says which block an order before it is about told of the start."""
    found = list(chains)
    for n, chain in enumerate(chains[1:], 1):
        before = chains[n - 1].clauses[-1]
        if not all(isinstance(c, Clause) and (c.lemma, c.mode) == ("fact", "goal") for c in chain.clauses):
            continue
        if _WHEN.search(text[before.span[1] : chain.span[1]]) is not None:
            continue
        swap = isinstance(before, Clause) and (before.verb, before.mode) == ("swap", "command")
        named = {color for part in parts_of(before) if isinstance(part, Noun) for color in part.traits.colors}
        for fact in chain.clauses:
            theme = fact.theme if isinstance(fact, Clause) else None
            if swap and isinstance(theme, Noun) and named.intersection(theme.traits.colors):
                raise refuse("ambiguous", "is this so before they are swapped, or afterwards?", fact.span,
                             "say 'at the start' or 'in the end'")  # fmt: skip
        clauses = tuple(_begun(fact, chains[:n]) for fact in chain.clauses)
        found[n] = replace(chain, clauses=clauses) if clauses != chain.clauses else chain
    return tuple(found)


def _begun(fact: Meaning, before: tuple[Chain, ...]) -> Meaning:
    place = fact.adjuncts[0] if isinstance(fact, Clause) and len(fact.adjuncts) == 1 and not fact.negated else None
    told = fact.theme if isinstance(fact, Clause) else None
    if not isinstance(place, Loc) or not isinstance(told, Noun) or told.traits == Traits():
        return fact
    which = (part for chain in before for part in parts_of(chain) if isinstance(part, Noun) and part.conditions)
    same = any(
        noun.traits == Traits() and noun.det == "the" and _same(condition, place)
        for noun in which
        for condition in noun.conditions
    )
    return replace(fact, mode="start") if same and isinstance(fact, Clause) else fact


def _same(condition: Meaning, place: Loc) -> bool:
    """Whether a relative clause says of a block what the fact says."""
    marks = [x.landmark if isinstance(x, Loc) else None for x in (condition, place)]
    looks = [(x.head == "patch", x.traits) if isinstance(x, Noun) else None for x in marks]
    return isinstance(condition, Loc) and condition.rel == place.rel and looks[0] is not None and looks[0] == looks[1]
