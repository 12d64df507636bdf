"""Groups that are told apart: "separate the vowels of the consonants", "keep the red blocks separate from the blue"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, Meaning, Noun, Using, replace

KEEPING = frozenset({"keep", "place", "build"})
"""The verbs that blocks may be separate after: "keep", "put", "have" them so."""
_APART = tuple(
    f"{how}{apart}" for how in ("", "strictly ", "neatly ", "clearly ", "well ") for apart in ("separate", "separated")
)


def separated(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "separate the vowels of the consonants"."""
    of = p.one(k, "of")
    for other, end in noun_phrase(p, of) if of else ():
        using = Using(members=other, span=p.span(k, end))
        said = Clause(verb="sort", lemma="separate", theme=theme, adjuncts=(using,), span=p.span(i, end))
        yield replace(said, word=p.span(i, i + 1)), end


def kept_separate(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "keep the red blocks separate from the blue ones", "keep the red and the blue blocks separate"."""
    j = p.any_of(k, _APART)
    for found, end in adjuncts(p, j) if j else ():
        others = bool(found) and isinstance(found[0], Using) and found[0].lead == "from"
        if others or (not found and _several(theme)):
            word = p.span(k, j)
            yield (
                Clause(verb="sort", lemma="separate", theme=theme, adjuncts=found, span=p.span(i, end), word=word),
                end,
            )


def _several(theme: Meaning) -> bool:
    """ "two red and two blue blocks", "the red and the blue ones": things that are told from each other."""
    listed = isinstance(theme, Noun) and max(len(theme.traits.colors), len(theme.traits.labels)) > 1
    return listed or (isinstance(theme, Coord) and theme.op == "and")
