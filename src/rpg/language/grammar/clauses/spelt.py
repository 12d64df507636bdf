"""Words that are to be spelt: "spell CAT with letter blocks", "make the words CAT and DOG"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.reversed_word import told_reversed
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.formed import beside_word
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import digits_of, literal
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Into, Meaning, Noun, Structure

_WORDS = Patterns("the|these|both? two|three|four? words|names :?", ":")


def spelling(p: Parser, i: int, j: int, sense: str, lemma: str) -> Results[Clause]:
    """What a verb at i spells or builds of letters: "build CAT out of letter cubes", "make words: CAT and DOG"."""
    if sense == "spell" or (sense == "build" and j < p.end and p.tokens[j].kind == "literal"):
        yield from spell(p, i, j, lemma)
    for k in _WORDS.matches(p, j) if sense in ("spell", "build") else ():
        if k < p.end and p.tokens[k].kind == "literal" and _so_many(p, j, k):
            yield from spell(p, i, k, lemma)


def _so_many(p: Parser, j: int, k: int) -> bool:
    """Whether there are as many words from k on as are counted between j and k, if they are."""
    told = [many for n in range(j, k) if (many := p.number(n)) is not None]
    return told in ([], [sum(literal(p, n) is not None for n in range(k, p.end))])


def spell(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "spell CAT with letter blocks", "spell the word 'ROBOT'", "spell a word"."""
    j = p.opt(j, "out")
    themes: list[tuple[Meaning, int]] = [*word_named(p, j)]
    if (text := digits_of(p, j)) is not None:
        themes.append((Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1)), j + 1))
    themes += [(t, k) for t, k in noun_phrase(p, j) if isinstance(t, Structure) and t.kind in ("word", "equation")]
    themes += [(t, end) for t, k in themes if (end := _not_another(p, k)) > k]
    if lemma == "write":
        yield from _written(p, i, j)
    for theme, k in themes:
        beside = [((word, *more), e) for word, m in beside_word(p, k) for more, e in adjuncts(p, m)]
        letters = theme.letter if isinstance(theme, Structure) else None
        ways = [*adjuncts(p, k), *beside]
        turned = [(found, told) for found, end in ways if letters for told in told_reversed(p, end, letters, found)]
        more = [(a, b, e) for a, told in turned for n in {told, p.opt(told, ",")} for b, e in adjuncts(p, n)]
        for found, end in [((*a, *b), e) for a, b, e in more] or ways:
            span, word = p.span(i, end), p.span(i, i + 1)
            yield Clause(verb="spell", lemma=lemma, theme=theme, adjuncts=found, span=span, word=word), end


def word_named(p: Parser, j: int) -> Results[Structure]:
    """ "CAT", "another CAT"."""
    again = p.any_of(j, ("another", "a second"))
    text = literal(p, again or j)
    end = (again or j) + 1
    if text is not None:
        yield Structure(kind="word", det="a" if again else "the", letter=text, span=p.span(j, end)), end


def _not_another(p: Parser, j: int) -> int:
    """The position behind ", not DOG" in "spell CAT, not DOG", which says no more."""
    other = p.any_of(p.opt(j, ","), ("and not", "but not", "not"))
    named = p.any_of(other, ("the word",)) or other
    return named + 1 if other and literal(p, named) is not None else j


def _written(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "write the digits 1 to 9 into a 3x3 grid": symbols that are put there."""
    for theme, k in noun_phrase(p, j):
        if not isinstance(theme, Noun) or len(theme.traits.labels) < 2:
            continue
        for found, end in adjuncts(p, k):
            if any(isinstance(x, Into) for x in found):
                word = p.span(i, i + 1)
                yield Clause(verb="arrange", theme=theme, adjuncts=found, span=p.span(i, end), word=word), end
