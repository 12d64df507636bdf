"""What blocks read: "the cubes read CAT", "the mat should say 2+3=5"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.labels import digits_of, label_list, literal
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Loc, Meaning, Noun, Structure, TableTop, Traits, Using


def reads(p: Parser, i: int, j: int, theme: Meaning, mode: str) -> Results[Meaning]:
    """ "The cubes read CAT": of them; "the mat should read CAT": on it; "the table reads CAT": wherever."""
    using: tuple[Meaning, ...] = (Using(members=theme, span=theme.span),)
    if isinstance(theme, Noun) and theme.head == "patch" and not theme.plural:
        using = (Loc(rel="on", landmark=theme, span=theme.span),)
    using = () if isinstance(theme, TableTop) else using
    text = literal(p, j) or digits_of(p, j)
    if text is not None and len(text) > 1:
        word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
        apart = [x for x in adjuncts(p, j + 2) if x[0]] if p.one(j + 1, ",") else []
        for found, end in [*adjuncts(p, j + 1), *apart]:
            yield Clause(verb="spell", theme=word, adjuncts=(*using, *found), mode=mode, span=p.span(i, end)), end
    for (labels, more), k in label_list(p, j, True):
        named = Noun(
            head="block", plural=len(labels) > 1, traits=Traits(labels=labels, open_ended=more), span=p.span(j, k)
        )
        for found, end in adjuncts(p, k):
            yield Clause(verb="read", theme=named, adjuncts=(*using, *found), mode=mode, span=p.span(i, end)), end
    for other, k in noun_phrase(p, j):
        if isinstance(other, Structure) and other.kind in ("word", "equation"):
            for found, end in adjuncts(p, k):
                yield Clause(verb="spell", theme=other, adjuncts=(*using, *found), mode=mode, span=p.span(i, end)), end
