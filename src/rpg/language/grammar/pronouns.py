"""Pronouns and the little phrases that stand for what was spoken of before."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Meaning, Pronoun

_PRONOUNS = frozenset({"it", "them", "they", "itself", "themselves"})


def pronoun(p: Parser, i: int) -> Results[Meaning]:
    """ "it", "the others", "each of them", "the latter"."""
    if j := p.one(i, _PRONOUNS):
        yield Pronoun(word=p.words[i], span=p.span(i, j)), j
    if j := p.one(i, frozenset({"him", "her", "he", "she"})):
        yield Pronoun(word="it", span=p.span(i, j)), j
    for _, j in p.standing(
        i, ("them all", "them both", "these all", "their up faces", "their top faces", "their upper faces",
        "their faces", "their letters", "the up faces",
            "the top faces", "their symbols", "the letters on top", "their numbers", "the up facing faces")
    ):  # fmt: skip
        yield Pronoun(word="them", span=p.span(i, j), cost=int(p.words[j - 1] == "faces")), j
    for phrase, j in p.standing(i, ("each other", "one another", "the other ones", "the other one", "the others",
                   "the rest", "others",
                   "the other two",
                   "the other half", "the other third", "the latter", "the former", "everything else",
                   "both of them", "all of them",
                   "everything", "both",
                   "all of it", "the first one", "the second one", "the remaining ones", "the remainder", "another",
                   "the other", "one", "nothing else", "nothing", "anything else",
                   "anything", "either of them", "neither of them", "each of them",
                   "none of them", "that", "this", "those", "these", "each one", "any other one", "any other",
                   "any of the others", "each", "all others", "all the others", "all the rest",
                   "all")):  # fmt: skip
        yield Pronoun(word=phrase, span=p.span(i, j)), j
