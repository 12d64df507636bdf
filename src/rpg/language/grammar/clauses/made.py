"""What is made, or covered, in the passive: "a tower shall be formed by the red block on the blue one", "a grid is to
be laid out in white", "the red cube must be topped by the white one". What stands behind the participle of what is made
is read as it is read right behind the noun."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.structures.makeup import sized_members
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, Structure, replace

MADE = frozenset({"build", "arrange", "stack"})
"""Senses of verbs by which structures come about."""
_OF = frozenset({"by", "of", "from", "out", "in", "with", "that", "which", "whose", "consisting", ","})
_SAID = frozenset({"of", "from", "out", "in", "with"})
"""Words with which what a structure is made of may begin; behind these what follows is also read in other ways."""


def made(p: Parser, i: int, j: int, theme: Meaning, told: Clause) -> Results[Clause]:
    """The clause from i on, of which all is told but what follows its participle, which ends before `j`."""
    if not isinstance(theme, Structure) or (theme.members is not None and not p.stands(j, ("with",))):
        return
    yield from _built(p, i, j, theme, (), told)
    for found, k in adjuncts(p, j) if p.rarely(_BY) and theme.members is None else ():
        if found and p.stands(k, _BY):
            yield from _built(p, i, k, theme, found, told)


_BY = frozenset({"by"})


_MODAL = frozenset({"shall", "must", "should", "will", "is", "are", "has", "have", "needs", "need"})
_TO_BE = Patterns(
    "shall|must|should|will|has_to|have_to|needs_to|need_to|is_to|are_to be|finally_be|also_be|have_been",
    "is|are|has_been|have_been",
)
_PARTICIPLES = frozenset(word for word, senses in lexicon.VERB.items() if any(s in MADE and form == "past"
                         for s, _, form in senses))  # fmt: skip


def told_before(p: Parser, i: int, mode: str) -> Results[Clause]:
    """ "A row of six blocks in alternating colours shall be formed": what is said of it stands before the verb."""
    if not p.rarely(_PARTICIPLES):
        return
    for theme, j in simple(p, i):
        shape = isinstance(theme, Structure) and theme.det in ("a", "bare") and not p.stands(j, _MODAL)
        for found, k in adjuncts(p, j) if shape else ():
            for at in _TO_BE.matches(p, p.opt(k, ",")) if found else ():
                for sense, lemma, form in p.lex(at, lexicon.VERB) or ():
                    out = p.opt(at + 1, "up", "out")
                    for more, end in adjuncts(p, out) if form == "past" and sense in MADE else ():
                        said = Clause(verb="build", lemma=lemma, theme=theme, mode=mode, span=p.span(i, end))
                        yield replace(said, adjuncts=(*found, *more), word=p.span(at, at + 1)), end


_COVERED = Patterns("topped|crowned|covered|capped directly|immediately? by|with")


def under(p: Parser, i: int, j: int, theme: Meaning, told: Clause) -> Results[Clause]:
    """The clause from i on of a block that is "covered by" another, which is told at j."""
    single = isinstance(theme, Pronoun | Coord) or (isinstance(theme, Noun) and theme.head != "patch")
    for k in _COVERED.matches(p, j) if single else ():
        for above, end in noun_phrase(p, k):
            if isinstance(above, Noun | Pronoun | Coord):
                on = Loc(rel="on", landmark=theme, span=p.span(i, k))
                yield replace(told, theme=above, adjuncts=(on,), span=p.span(i, end)), end


_DRAWN = {"outlined": False, "filled": True}


def drawn(p: Parser, i: int, j: int, theme: Meaning, told: Clause) -> Results[Clause]:
    """ "A rectangle shall be outlined in blue", "a square is to be filled by nine cubes", with its participle at j."""
    filled = p.peek(j, _DRAWN)
    if filled is None or not isinstance(theme, Structure) or theme.filled is not None:
        return
    whole = replace(theme, filled=filled)
    yield from made(p, i, p.reach(j + 1), whole, told)
    for found, end in adjuncts(p, j + 1) if theme.members is not None else ():
        yield replace(told, theme=whole, adjuncts=found, span=p.span(i, end)), end


def _built(p: Parser, i: int, j: int, theme: Structure, before: tuple[Meaning, ...], told: Clause) -> Results[Clause]:
    if not p.stands(j, _OF) or (p.stands(j, (",",)) and not theme.plural):
        return
    cost = 2 * (not p.stands(j, (",",)) and p.stands(j, _SAID) and not p.stands(j + 1, ("which",)))
    for whole, k in sized_members(p, i, j, theme, p.stands(j, _BY)):
        if not isinstance(whole, Structure) or (theme.members is not None and whole.members != theme.members):
            continue
        several = theme.plural and not whole.each_size and len(whole.sizes) == len(theme.sizes)
        for more, end in adjuncts(p, k) if k > j and not several else ():  # "two towers built of six blocks": in all?
            yield replace(told, theme=whole, adjuncts=(*before, *more), span=p.span(i, end), cost=cost), end
