""" "Here is the red block behind the green one. It must end up on the mat": what is shown first, and what is asked."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, That
from rpg.passes.schema.resolve.clauses.joined_facts import asked_of, same_one

_HERE = re.compile(r"\W*(?:it|this|that|here)(?: is|\'s| are)\W*", re.IGNORECASE)
_SHOWN = re.compile(
    r"(?:^|[.;:!?]|\bnow\b|\bwell\b|,)\s*(?:here(?: is| are|'s)|(?:you|we|i)(?: can| will)? see|look,?|behold,?)"
    r"(?: that)?(?: the| a| an| your| our)?\W*$",
    re.IGNORECASE,
)


_IMAGINED = re.compile(
    r"\W*(?:(?:please|just|now|so|do|can|you)\W+)*(?:imagine|picture|think of|consider|see)\W+(?:that\W+|this\W+)?"
    r"(?:(?:the|a|an)\W*)?",
    re.IGNORECASE,
)


def presented(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    """ "This is a tower of three red blocks. Put a blue block on it.": it is there before anything is done; and so is
    what is imagined, unless it is that which is to be built."""
    before = text[chains[n - 1].span[1] if n else 0 : chains[n].clauses[0].span[0]]
    imagined = _IMAGINED.fullmatch(before) is not None and _is_changed(chains[n + 1 :])
    return (imagined or _HERE.fullmatch(before) is not None) and not any(
        getattr(c, "lemma", "") == "tally" for c in chains[n].clauses
    )


def _is_changed(later: tuple[Chain, ...]) -> bool:
    """Whether something is put somewhere, or taken off it, in the next sentence."""
    order = later[0].clauses[0] if later else None
    return isinstance(order, Clause) and order.mode == "command" and order.verb != "build"


def shown(chain: Chain, text: str) -> bool:
    """ "You see the red block on the green one": how it is, without a verb of its own."""
    fact = chain.clauses[0]
    if len(chain.clauses) > 1 or not isinstance(fact, Clause) or (fact.verb, fact.mode) != ("be", "goal"):
        return False
    placed = not fact.negated and any(isinstance(a, Loc | In) for a in fact.adjuncts)
    return placed and _SHOWN.search(text[: fact.span[0]]) is not None


def wanted_elsewhere(before: Chain, after: Chain, demanded: bool) -> bool:
    """Whether the very block of which something was told is to be somewhere else by the next sentence.

    `demanded`: that is headed as what is to be reached, "Goal: it is on the mat".
    """
    fact, order = before.clauses[-1], asked_of(after)
    if not isinstance(fact, Clause) or not isinstance(order, Clause) or order.negated:
        return False
    said = [order] if demanded or order.lemma != "fact" else []
    said += _results(order) if order.mode == "command" else []
    return any(same_one(fact, x) and _places(x) and _places(x) != _places(fact) for x in said if not x.negated)


def _results(order: Clause) -> list[Clause]:
    """ "Rearrange things so that it is on the mat": what comes of it."""
    chains = [a.clauses for a in order.adjuncts if isinstance(a, That) and a.kind == "so"]
    return [c for chain in chains if isinstance(chain, Chain) for c in chain.clauses if isinstance(c, Clause)]


def _places(clause: Clause) -> tuple[Meaning, ...]:
    return tuple(a for a in clause.adjuncts if isinstance(a, Loc | In))
