"""What the blocks spoken of look like, all of them or none: ", all four of them green", ", none of them red"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.adjectives import colors
from rpg.language.grammar.things.amounts import count
from rpg.language.meaning import Amount, Clause, Meaning, Noun, Pronoun, Quality, Traits

_ALL = ("all of them", "all of these", "every one of them", "each of them", "both of them", "all", "both", "each")
_NONE = ("none of them", "none of these", "none of the cubes", "none of the blocks", "none")
_ARE = ("are", "is", "being", "should be", "must be", "may be", "in")


@choice
def all_colored(p: Parser, i: int) -> Results[Meaning]:
    """ "..., all four of them green", ", both red", ", none of them red or blue", said behind it all."""
    theme: Meaning | None = None
    j = p.any_of(i, ("all", "all of the", "all the"))
    for many, k in count(p, j) if j else ():
        j = p.any_of(k, ("of them", "blocks", "cubes")) or k
        theme = Noun(head="block", det="all", amount=Amount(many, many), plural=True, span=p.span(i, j))
    if theme is None and (j := p.any_of(i, _ALL)):
        told = any(word in lexicon.COLOR for word in p.words[:i]) or p.words[i] != "all"
        theme = Pronoun(word="them" if told else "everything", span=p.span(i, j))
    none = p.any_of(i, _NONE) if theme is None else 0
    j, theme = (none, Pronoun(word="them", span=p.span(i, none))) if none else (j, theme)
    if theme is None:
        return
    for (listed, either), k in colors(p, p.any_of(j, _ARE) or j):
        if (none or (len(listed) == 1 and not either)) and (k >= p.end or p.words[k] in (",", ";")):
            quality = Quality(traits=Traits(colors=listed), span=p.span(j, k))
            yield (
                Clause(verb="be", theme=theme, adjuncts=(quality,), negated=bool(none), mode="goal", span=p.span(i, k),
                       cost=2),
                k,
            )  # fmt: skip
