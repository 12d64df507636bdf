"""Pronouns and the little phrases that stand for what was spoken of before."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.left_alone import left_alone
from rpg.language.meaning import Amount, Meaning, Noun, Pronoun

_NOUNS = frozenset(
    {*lexicon.BLOCK, *lexicon.COLOR, *lexicon.PATCH, *lexicon.LETTER, *lexicon.DIGIT, *lexicon.STRUCTURE}
)
_PRONOUNS = frozenset({"it", "them", "they", "itself", "themselves"})


_FINITE = frozenset({"should", "must", "may", "can", "is", "are", "shall", "touches", "lies", "stands", "has", "ought",
                     "will", "rests", "sits", "goes", "needs", "touch", "be"})  # fmt: skip
"""What follows "neither" where that is the subject by itself."""
_BEFORE_WHICH = frozenset({"on", "onto", "above", "below", "under", "behind", "beside", "to", "beneath"})
"""Prepositions, or what ends one, behind which "which" is what was spoken of last."""
_ON = frozenset({"on", "onto"})
_OR = frozenset({"or", "like", "make", "build"})
"""Behind these "something" is no block."""
_CLOSED = frozenset({".", ",", ";"})
_NONE_THERE = _FINITE | {"on", "in", "off", "inside", "touching", "next", "stacked", "left"}
_JUST_ONE = ("exactly one", "precisely one")
"""One of them, and no more."""
_OF_THEM = ("of them", "of these", "of those")


def _all_three(p: Parser, i: int, j: int) -> Results[Meaning]:
    """ "all three", "all three of them", "these three": so many that were told together."""
    many = p.number(j)
    if many is None or many < 2 or p.words[j + 1] in _NOUNS or not (p.token(j + 1) is None or p.words[j + 1]):
        return
    end = p.any_of(j + 1, _OF_THEM) or j + 1
    yield Noun(head="any", det="the", amount=Amount(many, many), plural=True, span=p.span(i, end)), end


def pronoun(p: Parser, i: int) -> Results[Meaning]:
    """ "it", "the others", "each of them", "the latter"."""
    if j := p.any_of(i, ("they all", "them all", "these all")):
        yield Pronoun(word="all of them", span=p.span(i, j)), j
    elif j := p.one(i, _PRONOUNS):
        yield Pronoun(word=p.words[i], span=p.span(i, j)), j
    if (j := p.one(i, "rest")) and p.stands(j, _STAYS):
        yield Pronoun(word="the rest", span=p.span(i, j)), j
    if p.follows(i, _BEFORE_WHICH) and (j := p.one(i, "which")):  # "..., on which the green one is to be put"
        yield Pronoun(word="which", span=p.span(i, j), cost=1), j
    if j := p.one(i, ("all", "these", "those")):
        yield from _all_three(p, i, j)
    if (j := p.any_of(i, ("neither", "neither one", "neither of the two"))) and p.stands(j, _NONE_THERE):
        yield Pronoun(word="neither of them", span=p.span(i, j)), j
    if j and p.follows(i, _ON) and (j >= p.end or p.stands(j, _CLOSED)):
        them = Pronoun(word="them", span=p.span(i, j))
        yield Noun(head="any", det="no", amount=Amount(2, 2, True), plural=True, part_of=them, span=them.span), j
    if (j := p.one(i, "none")) and p.stands(j, _NONE_THERE):
        yield Pronoun(word="none of them", span=p.span(i, j)), j
    if (j := p.any_of(i, ("something", "something else"))) and not p.follows(i, _OR):
        yield Noun(head="block", det="a", amount=Amount(1, 1), span=p.span(i, j), cost=1), j
    if j := p.any_of(i, _ALL_THAT):
        yield Pronoun(word="everything", span=p.span(i, j)), j
    if j := p.one(i, ("him", "her", "he", "she")):
        yield Pronoun(word="it", span=p.span(i, j)), j
    if (j := p.any_of(i, ("the pair", "that pair"))) and not p.stands(j, ("of",)):
        yield Pronoun(word="both of them", span=p.span(i, j)), j
    for _, j in p.standing(
        i, ("them both", "the pair of them", "this pair", "the two of them",
        "the same blocks", "the same cubes", "the same letters", "the same ones",
        "the same bricks", "the same digits", "their up faces", "their top faces", "their upper faces",
        "their faces", "their letters", "the up faces",
            "the top faces", "their symbols", "the letters on top", "their numbers", "the up facing faces")
    ):  # fmt: skip
        yield Pronoun(word="them", span=p.span(i, j), cost=int(p.words[j - 1] == "faces")), j
    if j := p.any_of(i, ("the rest of them", "the rest of these", "the rest of those")):
        yield Pronoun(word="the rest", span=p.span(i, j)), j
    if (j := p.any_of(i, _JUST_ONE)) and p.stands(j, _NONE_THERE):
        them = Pronoun(word="them", span=p.span(i, j))
        yield Noun(head="any", amount=Amount(1, 1, True), part_of=them, span=them.span), j
    if p.follows(i, _BEFORE_WHICH) and (j := p.any_of(i, ("each of which", "both of which"))):
        yield Pronoun(word="each of them" if p.words[i] == "each" else "them", span=p.span(i, j)), j
    if j := left_alone(p, i):
        yield Pronoun(word="all the others", span=p.span(i, j)), j
    for phrase, j in p.standing(i, ("each other", "one another", "the other ones", "the other one", "the others",
                   "the rest", "others",
                   "the other two",
                   "the other half", "the other third", "the latter", "the former", "everything else",
                   "both of them", "all of them",
                   "everything", "both",
                   "all of it", "the first one", "the second one", "the remaining ones", "the remainder",
                   "the other", "one", "nothing else", "nothing", "anything else",
                   "anything", "either of them", "neither of them", "each of them",
                   "none of them", "that", "this", "those", "these", "each one", "any other one", "any other",
                   "any of the others", "each", "all others", "all the others", "all the rest",
                   "all")):  # fmt: skip
        if phrase == "the other" and p.number(j) is not None:
            continue  # "the other four"
        yield Pronoun(word=phrase, span=p.span(i, j), cost=int(phrase in ("none of them", "either of them"))), j
    yield from _another(p, i)


def _another(p: Parser, i: int) -> Results[Meaning]:
    """ "A red block on A and another on B": one more of that look; of a tower it is another tower."""
    j = p.one(i, "another")
    if not j:
        return
    begins = p.words[i - 1] in _AND and i > 0 and lexicon.STRUCTURE.keys().isdisjoint(p.words[:i])
    if begins:
        yield Noun(head="any", det="another", amount=Amount(1, 1), span=p.span(i, j)), j
    yield Pronoun(word="another", span=p.span(i, j), cost=int(begins)), j


_AND = frozenset({",", "and", "while", "but", ";"})
_ALL_THAT = tuple(
    f"{all_}{stuff}" for all_ in ("the ", "all the ", "all this ", "this ", "that ", "all that ", "your ", "my ")
    for stuff in ("junk", "stuff", "rubbish", "clutter", "trash", "garbage")
)  # fmt: skip
"""What people call all that lies there."""
_STAYS = frozenset({"stays", "remains", "goes", "is"})
"""Before these "rest" is no verb."""
