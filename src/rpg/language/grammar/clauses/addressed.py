""" "Red block, go and sit on the blue one!": a block that is told itself where to be."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import At, Clause, In, Loc, Noun, replace

_GO = Patterns(
    ",? please|now|you? please|must|should? go|jump|hop|climb|fly|walk|come|run|leap|crawl|travel|march "
    "over|up|down|back|away|and? sit|stand|lie|rest|settle|land|stay|wait? down|yourself?",
    ", please|now? go|move|sit|stand|lie|rest|settle|land|get|slide|stay yourself|over|down|up|back?",
    ", please|now? put|place|position|seat|set|park yourself",
)
"""What it is told to do, before the place."""
_VERBS = frozenset({"go", "jump", "hop", "climb", "fly", "walk", "come", "run", "leap", "crawl", "travel",
                    "march", "move", "sit", "stand", "lie", "rest", "settle", "land", "get", "slide", "stay",
                    "yourself"})  # fmt: skip


@rule
def addressed(p: Parser, i: int) -> Results[Clause]:
    """A block by its look, and where it has to go."""
    if not p.rarely(_VERBS):
        return
    for theme, j in simple(p, i):
        if not isinstance(theme, Noun) or theme.head == "patch" or theme.det not in ("bare", "the"):
            continue
        if theme.plural or theme.amount is not None or not (theme.traits.colors or theme.traits.labels):
            continue
        for k in _GO.matches(p, j):
            for found, end in adjuncts(p, k):
                crossed = p.words[k] == "over" and isinstance(found[0], Loc) if found else True
                if not crossed and all(isinstance(x, Loc | In | At) for x in found):
                    told = replace(theme, det="the")
                    yield Clause(verb="place", lemma="put", theme=told, adjuncts=found, span=p.span(i, end)), end
