"""Where a block lies that is picked up: "pick up the red block on the blue one and put it on the mat"."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Pronoun, replace
from rpg.passes.schema.resolve.clauses.joined_facts import same_one

_TAKING = ("pick", "use")
_SEEN = re.compile(r"\byou(?: will|'ll| can| may| should)?(?: also)?\s*$", re.IGNORECASE)
"""What stands before "find" where nobody is told to look for it."""


def lifted(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with the places of what is picked up or found told of the start."""
    told = []
    for n, chain in enumerate(chains):
        clauses: list[Meaning] = []
        links: list[str] = []
        after = [*chain.clauses[1:], *(chains[n + 1].clauses[:1] if n + 1 < len(chains) else ())]
        for m, (link, clause) in enumerate(zip(chain.links, chain.clauses, strict=True)):
            parts: tuple[Meaning, ...] = (clause,)
            if isinstance(clause, Clause) and _lies_on(clause, text):
                there = replace(clause, verb="be", lemma="fact", mode="start")
                if _found(clause, chain, text):
                    parts = (there,)
                elif m < len(after) and _put_elsewhere(clause, after[m]):
                    parts = (there, replace(clause, adjuncts=()))
            clauses += parts
            links += [link, "and"][: len(parts)]
        told.append(replace(chain, clauses=tuple(clauses), links=tuple(links)))
    return tuple(told)


def _lies_on(clause: Clause, text: str) -> bool:
    """ "(pick up the red block) on the blue one", and not "onto" it or "to" it."""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    taken = clause.verb in _TAKING and clause.mode == "command" and not clause.negated and clause.theme is not None
    if not taken or not isinstance(place, Loc | In) or place.negated or isinstance(clause.theme, Pronoun):
        return False
    return text[place.span[0] :].lower().startswith(("on ", "on top of ", "in ")) and (
        isinstance(place, In) or place.rel in ("on", "in")
    )


def _found(clause: Clause, chain: Chain, text: str) -> bool:
    """ "You will find the red block on the blue one"."""
    before = text[chain.span[0] : clause.word[0]] if clause.word is not None else ""
    return clause.lemma == "find" and _SEEN.search(before) is not None


def _put_elsewhere(taken: Clause, after: Meaning) -> bool:
    """Whether the next clause says where that very block goes."""
    if not isinstance(after, Clause) or after.negated or not any(isinstance(a, Loc | In) for a in after.adjuncts):
        return False
    asked = (after.mode == "command" and after.verb in ("place", "stack")) or (
        after.mode == "goal" and after.verb in ("place", "be")
    )
    return asked and same_one(taken, after)
