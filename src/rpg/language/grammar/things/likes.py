""" "Letters with letters and digits with digits": kinds that are each put together."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Coord, Noun, OrderBy, replace


def like_with_like(p: Parser, i: int, j: int, lemma: str, word: Span) -> Results[Clause]:
    """The kinds from `j` on, as the theme of the verb at `i`, sorted by what tells them apart."""
    for first, k in _pair(p, j):
        joint = p.one(p.opt(k, ","), "and") or (k + 1 if p.words[k] == "," else 0)
        for second, end in _pair(p, joint) if joint else ():
            attribute = _told_by(first, second)
            if attribute is not None:
                theme = Coord(op="and", items=(first, second), span=p.span(j, end))
                by = OrderBy(by="attribute", attribute=attribute, span=p.span(j, end))
                yield Clause(verb="sort", lemma=lemma, theme=theme, adjuncts=(by,), span=p.span(i, end), word=word), end


def _pair(p: Parser, j: int) -> Results[Noun]:
    """ "letters with letters"."""
    for one, k in simple(p, j):
        again = p.any_of(k, ("with", "to", "with the", "to the", "with other", "with the other"))
        for two, end in simple(p, again) if again and isinstance(one, Noun) and one.plural else ():
            if isinstance(one, Noun) and isinstance(two, Noun) and two.plural and one.traits == two.traits:
                yield replace(one, det="bare" if one.det == "the" else one.det), end


def _told_by(first: Noun, second: Noun) -> str | None:
    """What tells two kinds apart."""
    one, two = first.traits, second.traits
    if one.colors and two.colors and one.colors != two.colors:
        return "color"
    if one.quality and two.quality and one.quality != two.quality:
        return "parity" if "odd" in (one.quality, two.quality) else "vowel"
    return "kind" if one.kind and two.kind and one.kind != two.kind else None
