""" "Red is on blue, I want it on the mat", "red is on blue but should be on the mat": in one sentence how it is, and
how it is to be."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Noun, Pronoun, replace
from rpg.passes.schema.resolve.clauses.joined_facts import BESIDES, same_one
from rpg.passes.schema.resolve.clauses.same_at_the_end import of_these
from rpg.passes.schema.resolve.things.world import refuse

_WISHED = re.compile(
    r"\b(?:i|we|you)\b.*\b(?:want|wants|need|needs|like|wish|prefer)\b|\b(?:can|could|would|will) you\b|\bplease\b",
    re.IGNORECASE,
)
_ENDED = re.compile(r"\b(?:end|final|finally|goal|want|should|must|sure|result|done)\b", re.IGNORECASE)
"""In front of a fact these say that it is to come about."""
_BUT = re.compile(r"\b(?:but|yet|instead)\b", re.IGNORECASE)


def told_then_asked(chain: Chain, text: str) -> Chain:
    """The sentence, with the facts in front told of the start where what is said behind them is of the same thing."""
    for n in range(1, len(chain.clauses)):
        facts, order = chain.clauses[:n], chain.clauses[n]
        if chain.links[n] != "and" or not isinstance(order, Clause) or not all(map(_fact, facts)):
            return chain
        fact, own = facts[-1], re.split(r"[.;!?]", text[: facts[0].span[0]])[-1]
        assert isinstance(fact, Clause)
        joint = text[fact.span[1] : order.theme.span[0]] if order.theme is not None else ""
        between = text[fact.span[1] : order.span[1]]
        if order.negated or not _places(order) or BESIDES.search(between) or _ENDED.search(own):
            continue
        but = _BUT.search(joint) is not None and order.lemma != "fact"
        wished = _WISHED.search(joint or between) is not None or but
        wished = wished or (order.mode == "command" and order.verb in ("place", "stack"))
        if not wished:
            continue
        if same_one(fact, order) and _places(order) != _places(fact):
            told = (replace(x, mode="start") if isinstance(x, Clause) else x for x in facts)
            return replace(chain, clauses=(*told, *chain.clauses[n:]))
        if _BUT.search(joint) and _same_place(fact, order):
            raise refuse("ambiguous", "is what lies there now to stay, or to make room?", order.span,
                         "say in a sentence of its own where it should be")  # fmt: skip
    return chain


def _fact(fact: Meaning) -> bool:
    told = isinstance(fact, Clause) and (fact.lemma, fact.mode, fact.negated) == ("fact", "goal", False)
    return told and isinstance(fact, Clause) and isinstance(fact.theme, Noun) and bool(_places(fact))


def _places(clause: Clause) -> tuple[Meaning, ...]:
    return tuple(x for x in clause.adjuncts if isinstance(x, Loc | In))


def _same_place(fact: Clause, order: Clause) -> bool:
    """Whether another thing is to be where this is: "the red block is on the mat, but I want the blue one there"."""
    marks = [x.landmark for x in (*fact.adjuncts, *order.adjuncts) if isinstance(x, Loc) and x.rel in ("on", "in")]
    if len(marks) != 2 or of_these(order, fact):
        return False
    named = [x for x in marks if isinstance(x, Noun)]
    there = isinstance(marks[1], Pronoun) and marks[1].word in ("there", "it")
    return there or (len(named) == 2 and (named[0].head, named[0].traits) == (named[1].head, named[1].traits))
