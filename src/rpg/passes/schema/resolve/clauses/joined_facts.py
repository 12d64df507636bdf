"""How what is told is joined to what is asked for behind it: "also", "make sure", of the same block."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Noun, Pronoun

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
    named = isinstance(theme, Noun) and theme.det == "the" and same
    return named or (isinstance(theme, Pronoun) and theme.word in ("it", "them", "they", "same", "both", "both of them"))
