"""What is told of blocks by a participle: "three red blocks stacked on ...", "four cubes, lined up and touching"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.absent import nothing_at_all
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.verbs import PARTICLES
from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Clause, Meaning


def participle(p: Parser, i: int, j: int, theme: Meaning, mode: str) -> Results[Meaning]:
    """ "three red blocks stacked on ...", "four cubes, lined up and touching".

    What is told behind a comma of the last of several that "and" joins may be told of all of them: it is not read.
    """
    if p.follows(i, ("and",)) and p.words[i - 2] != "," and p.opt(j, ",") > j:
        return
    j = p.opt(p.opt(j, ","), "all", "both", "each")
    for sense, lemma, form in p.lex(j, lexicon.VERB) or ():
        if form not in ("past", "ing"):
            continue
        apart = (p.opt(j + 1, ","),) if sense == "stack" else ()
        for at_ in dict.fromkeys((p.opt(j + 1, *PARTICLES), j + 1, *apart)):
            lined = lemma == "line" and p.words[at_ - 1] == "up"
            for found, k in [*adjuncts(p, at_), *(adjuncts(p, p.opt(at_, "and")) if lined else ())]:
                if found or sense == "stack" or lined:
                    told = Clause(verb=sense, lemma=lemma, theme=theme, adjuncts=found, mode=mode, span=p.span(i, k),
                                  word=p.span(j, j + 1), cost=1)  # fmt: skip
                    yield nothing_at_all(told), k
