""" "Start with brown on the mat, and after that put ...": the first thing to do, or how it is at the start."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.meaning import Chain, Clause, In, Loc, Manner, Noun, TableTop, replace
from rpg.passes.schema.resolve.clauses.joined_facts import same_one
from rpg.passes.schema.resolve.things.world import refuse

_START_WITH = re.compile(
    r"(?:^|[.!;:,]\s*)(?:please |now |just )?(?:start|begin)(?: off| out)? with\s*$", re.IGNORECASE
)

_TO_BEGIN = re.compile(r"\b(?:to (?:begin|start) with|at first)\b", re.IGNORECASE)
"""What may be said of a first step as well, where no verb tells."""


def check_begun_or_first(links: Sequence[str], chains: tuple[Chain, ...], text: str) -> None:
    """Ask which one is meant where something else is done "then". What moves the same block says that it is there."""
    said = [
        (links[n] if k == 0 and n < len(links) else link, clause)
        for n, chain in enumerate(chains)
        for k, (link, clause) in enumerate(zip(chain.links, chain.clauses, strict=True))
    ]
    for n, (_, clause) in enumerate(said[:-1]):
        link, after = said[n + 1]
        theme = clause.theme if isinstance(clause, Clause) and (clause.mode == "start" or _to_begin(clause)) else None
        if link != "then" or not isinstance(clause, Clause) or not isinstance(theme, Noun) or not _somewhere(clause):
            continue
        put = isinstance(after, Clause) and after.verb in ("place", "stack", "be") and not after.negated
        later = [c for _, c in said[n + 1 :] if isinstance(c, Clause)]
        verbless = (clause.verb, clause.lemma) == ("be", "") and _TO_BEGIN.search(text[: after.span[0]]) is not None
        led = _START_WITH.search(text[: theme.span[0]]) and not any(_of_it(clause, c) for c in later)
        if put and (led or verbless):
            raise refuse("ambiguous", "is this the first thing to do, or how it is at the start?", clause.span,
                         "say 'first put ...', or 'at the start it is ...'")  # fmt: skip


def _to_begin(clause: Clause) -> bool:
    """ "Red onto the mat to begin with"."""
    verbless = (clause.verb, clause.lemma, clause.mode) == ("be", "", "goal")
    return verbless and any(isinstance(a, Manner) and (a.kind, a.value) == ("start", "first") for a in clause.adjuncts)


def _somewhere(clause: Clause) -> bool:
    """Whether it says of a block that it lies on another one or a patch: it is on the table anyway."""
    placed = clause.adjuncts and all(isinstance(a, Loc | In | Manner) for a in clause.adjuncts)
    return bool(placed) and not any(isinstance(a, Loc) and isinstance(a.landmark, TableTop) for a in clause.adjuncts)


def _of_it(fact: Clause, later: Clause) -> bool:
    """Whether a clause is about the same block, or about what bears it."""
    bases = [a.landmark for a in fact.adjuncts if isinstance(a, Loc)]
    moved = any(same_one(replace(fact, theme=base), later) for base in bases)
    return moved or same_one(fact, later) or later.verb not in ("place", "stack", "be", "exist")
