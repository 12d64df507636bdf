""" "Red was placed on blue, and yellow next to green": what has no verb of its own is told in the tense of what stands
before it, so that no sentence is half of the start and half of the end."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, In, Into, Loc, Meaning, replace

_PAST = re.compile(r"\b(?:was|were|had been)\b", re.IGNORECASE)
_OWN = re.compile(
    r"\b(?:is|are|be|was|were|been|has|have|had|must|should|shall|will|would|can|may|might|needs?|ought|lets?|wants?|"
    r"now|currently|finally|eventually|afterwards|later|goal|end|ends|finish|result|instead|touch(?:es)?|goes|comes|"
    r"stays?|stands?|lies|sits|faces?)\b",
    re.IGNORECASE,
)
"""Words by which a clause tells its own time."""
_JOINED = re.compile(r"\s*[;,]\s*(?:and\s+)?", re.IGNORECASE)


def in_one_tense(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with what goes on from the past without a verb told of the start as well; a semicolon joins."""
    found: list[Chain] = []
    for chain in chains:
        joined = found and _JOINED.fullmatch(text[found[-1].span[1] : chain.span[0]]) is not None
        before = found[-1].clauses[-1] if joined else None
        past = False
        told: list[Meaning] = []
        for clause in chain.clauses:
            goes_on = (past or _past(before, text)) and _goes_on(before, clause, text)
            past = goes_on or (past and getattr(clause, "mode", "") == "start") or _past(clause, text)
            told.append(replace(clause, mode="start") if goes_on and isinstance(clause, Clause) else clause)
            before = told[-1]
        found.append(replace(chain, clauses=tuple(told)) if tuple(told) != chain.clauses else chain)
    return tuple(found)


def _past(before: Meaning | None, text: str) -> bool:
    """Whether a clause has a verb in the past tense."""
    return isinstance(before, Clause) and before.mode == "start" and bool(_PAST.search(text[slice(*before.span)]))


def _goes_on(before: Meaning | None, clause: Meaning, text: str) -> bool:
    """Whether a clause says where something is, with no verb of its own."""
    if not isinstance(before, Clause) or not isinstance(clause, Clause) or before.negated:
        return False
    own = clause.word is not None or clause.mode != "goal" or clause.lemma or clause.negated
    placed = clause.verb == "build" or any(isinstance(a, Loc | In | Into) for a in clause.adjuncts)
    bare = clause.verb in ("be", "build", "arrange") and placed and not own
    return bare and _OWN.search(text[before.span[1] : clause.span[1]]) is None
