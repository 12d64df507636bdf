"""How what is told is joined to what is asked for behind it: "also", "make sure", of the same block."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Pronoun

BESIDES = re.compile(r"\b(?:also|too|as well|still|both|in addition|additionally)\b", re.IGNORECASE)
_DEMANDED = re.compile(
    r"\b(?:make|ensure|see to it|reach|achieve|get|until|goal|task|aim|want|like|wish|please|must|should|shall|has to|"
    r"have to|needs? to|ought|let|can|could)\b",
    re.IGNORECASE,
)
_KNOWN = re.compile(r"\b(?:sees?|look|imagine|know|note|assume|suppose|say|given)\b", re.IGNORECASE)


def added(before: Chain, after: Chain, text: str) -> bool:
    """ "... Also put green on the mat", "Put green there as well": of other blocks than were spoken of before."""
    fact, order = before.clauses[-1], after.clauses[0]
    if not isinstance(fact, Clause) or not isinstance(order, Clause) or same_one(fact, order):
        return False
    said = text[before.span[1] : order.span[1]] + re.split(r"[,.;!?]", text[order.span[1] :])[0]
    return BESIDES.search(said.replace("both", "")) is not None


def demanded(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    """ "(There is a red block on a blue one.) Reach a state where ...": what is asked for, and not told or pictured as
    well."""
    before = text[chains[n - 1].span[1] if n else 0 : chains[n].clauses[0].span[0]]
    own = re.split(r"[.;!?]", before)[-1]
    return _DEMANDED.search(own) is not None and _KNOWN.search(own) is None


def same_one(fact: Clause, order: Clause) -> bool:
    """Whether an order is about the very block of which something was told."""
    theme = order.theme
    same = isinstance(theme, Noun) and isinstance(fact.theme, Noun) and theme.traits == fact.theme.traits
    named = isinstance(theme, Noun) and theme.det in ("the", "bare") and theme.amount is None and same
    return named or (
        isinstance(theme, Pronoun) and theme.word in ("it", "them", "they", "same", "both", "both of them")
    )


def ends_elsewhere(before: Chain, after: Chain) -> bool:
    """ "The red block sits on the blue one. At the end it is on the mat": what bears a block, and later."""
    fact, end = before.clauses[0], asked_of(after)
    if len(before.clauses) > 1 or not isinstance(fact, Clause) or not isinstance(end, Clause):
        return False
    bases = [[x.landmark for x in c.adjuncts if isinstance(x, Loc) and x.rel == "on"] for c in (fact, end)]
    alone = all(len(base) == 1 for base in bases) and len(fact.adjuncts) == 1 and not end.negated
    return alone and same_one(fact, end) and bases[0] != bases[1]


def asked_of(chain: Chain) -> Meaning:
    """What a sentence asks of a block, behind "take it and ..."."""
    first = chain.clauses[0]
    taken = isinstance(first, Clause) and first.verb == "pick" and not (first.adjuncts or first.negated)
    return chain.clauses[1] if taken and len(chain.clauses) > 1 else first
