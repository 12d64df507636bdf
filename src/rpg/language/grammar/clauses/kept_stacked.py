""" "Keep the two red blocks stacked": a tower in the end, whatever else is done."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Clause, Meaning, Structure

_STACKED = Patterns(
    "stacked|piled up|together?", "in|as a|one|their|its stack|tower|pile", "on_top_of each_other|one_another"
)


def kept_stacked(p: Parser, i: int, k: int, theme: Meaning, lemma: str) -> Results[Clause]:
    """Said of blocks: a tower that is kept stands already."""
    if lemma not in ("keep", "leave", "have") or isinstance(theme, Structure):
        return
    for j in _STACKED.matches(p, k):
        for found, end in adjuncts(p, j):
            span, word = p.span(i, end), p.span(k, j)
            yield (
                Clause(verb="stack", lemma="stack", theme=theme, adjuncts=found, mode="goal", span=span, word=word),
                end,
            )
