"""Colours of letter cubes told apart from their letters: "the D in red and the others in blue", "all on red cubes"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Clause, Meaning, Noun, Pronoun, Quality, Structure, Traits

_LEADS = frozenset({"with", "where", "having", "but", "whose", "in"})
_IS = ("is", "are", "being", "should be", "must be", "shall be", "is to be", "are to be", "has to be", "have to be",
       "is all", "are all", "should all be", "must all be", "are both", "should both be", "lies", "lie", "sits",
       "stands", "are written", "is written", "are printed", "is printed", "is shown", "are shown", "appears", "appear",
       ":")  # fmt: skip
_OTHERS = ("the others", "the rest", "the other letters", "the other ones", "the other cubes", "the other two",
           "the other letter", "the remaining letters", "the remaining ones", "the others all", "all others",
           "the other three", "all the others", "the other one", "all the other letters",
           "the other blocks")  # fmt: skip
_ALL = ("all letters", "all the letters", "all of the letters", "the letters", "letters", "every letter",
        "each letter", "all of them", "all the cubes", "all letter cubes", "its letters", "all three letters",
        "all four letters", "all five letters", "both letters", "all its letters", "the word 's letters",
        "all the letter cubes")  # fmt: skip
_BODIES = frozenset({"body", "bodies"})
_CUBES = frozenset({"cube", "cubes", "block", "blocks", "body", "bodies", "brick", "bricks", "one", "ones"})
_PLURAL = frozenset({"cubes", "blocks", "bricks"})
_AND = (", and", ", but", ", while", "and", "but", "while", ",", ";")
_SHOWS = ("word", "equation")


def bodies(p: Parser, i: int, previous: Meaning) -> Results[tuple[Clause, ...]]:
    """Behind a word or an equation: what its cubes look like, a clause for each that is told."""
    if not isinstance(previous, Clause):
        return
    if _said_so(previous) and (on := p.any_of(i, _AND)):
        yield from _told(p, on, ())
    if not isinstance(previous.theme, Structure) or previous.theme.kind not in _SHOWS:
        return
    if (lead := p.one(i, "in")) and previous.verb == "spell":
        yield from (((found,), j) for found, j in _in_one_color(p, i, lead))
        yield from _one_by_one(p, lead, previous.theme.letter or "")
    start = p.one(i, (",", ":", ";")) or i
    start = p.one(start, _LEADS) or (start if start > i else 0)
    if start:
        yield from _told(p, start, ())


def _said_so(previous: Clause) -> bool:
    """Whether a clause said the colour of letter cubes, so that another may follow."""
    marks = previous.theme.traits if isinstance(previous.theme, Noun) else Traits()
    colored = len(previous.adjuncts) == 1 and isinstance(previous.adjuncts[0], Quality)
    return colored and previous.lemma == "fact" and bool(marks.labels or marks.kind)


def _in_one_color(p: Parser, i: int, start: int) -> Results[Clause]:
    """ "(spell CAT) in red": all its letters."""
    for named, k in color(p, start):
        j = p.any_of(k, ("letter cubes", "letter blocks", "letters", "cubes")) or k
        if j >= p.end or (p.stands(j, (",", ";", "and", "from", "along")) and not _more_colors(p, j)):
            everyone = Noun(head="block", det="all", plural=True, traits=Traits(kind="letter"), span=p.span(i, j))
            quality = Quality(traits=Traits(colors=(named,)), span=p.span(i, j))
            said = Clause(verb="be", lemma="fact", theme=everyone, adjuncts=(quality,), mode="goal", span=p.span(i, j))
            yield said, j


def _more_colors(p: Parser, j: int) -> bool:
    """ "in red, blue and white": not all of it is red."""
    return p.lex(p.opt(p.opt(j, ","), "and"), lexicon.COLOR) is not None


_IN_ORDER = (", in this order", ", in that order", "in this order", "in that order", "respectively", ", respectively",
             "letters", "letter cubes", "cubes")  # fmt: skip


def _one_by_one(p: Parser, start: int, word: str) -> Results[tuple[Clause, ...]]:
    """ "(spell BOX) in red, blue and white": a colour for each of its letters."""
    looks: list[str] = []
    at = start
    while (found := next(iter(color(p, at)), None)) is not None:
        looks.append(found[0])
        at = found[1]
        if len(looks) == len(word) == len(set(word)) > 1 and not _more_colors(p, at):
            end = p.any_of(at, _IN_ORDER) or at
            told = (_of_letter(letter, look, p.span(start, end)) for letter, look in zip(word, looks, strict=True))
            yield tuple(told), end
        at = p.opt(p.opt(at, ","), "and")


def _of_letter(letter: str, look: str, span: Span) -> Clause:
    theme = Noun(head="block", det="the", traits=Traits(labels=(letter,)), span=span)
    quality = Quality(traits=Traits(colors=(look,)), span=span)
    return Clause(verb="be", lemma="fact", theme=theme, adjuncts=(quality,), mode="goal", span=span)


def _told(p: Parser, i: int, had: tuple[Clause, ...]) -> Results[tuple[Clause, ...]]:
    for clause, j in body(p, i):
        plain = not clause.adjuncts[0].traits.colors  # type: ignore[attr-defined]
        found = had if plain else (*had, clause)
        yield found, j
        again = p.any_of(j, _AND) if len(found) < 10 else 0
        if again:
            yield from _told(p, p.one(again, "with") or again, found)


def body_clause(p: Parser, i: int) -> Results[Clause]:
    """In a clause of its own, where it can be no place: "the letters are on red cubes", "B is on a red body"."""
    if i == 0 or p.follows(i, _SET_OFF):
        yield from _mere_look(p, i)
    if p.any_of(i, _ALL) or p.rarely(_BODIES):
        for said, j in body(p, i):
            told = p.words[j - 1] in _BODIES or (p.any_of(i, _ALL) and p.words[j - 1] in _PLURAL)
            if told and said.adjuncts[0].traits.colors:  # type: ignore[attr-defined]
                yield said, j


_SET_OFF = frozenset({",", ";", "and"})


@choice
def _mere_look(p: Parser, i: int) -> Results[Clause]:
    """ "The N red, the O white.": of what colour these are, without a verb."""
    start = p.one(i, "the") or i
    token = p.token(start)
    if token is None or len(token.raw) != 1 or not token.raw.isupper() or (start == i and token.raw in "AI"):
        return
    for named, j in color(p, start + 1):
        if j >= p.end or p.stands(j, _SET_OFF | {":"}):
            yield _of_letter(token.raw, named, p.span(i, j)), j


@rule
def body(p: Parser, i: int) -> Results[Clause]:
    """ "the D (is) in red", "all letters on blue cubes", "the other two on white bodies", "both Bs green"."""
    whole = p.any_of(i, _ALL)
    for theme, j in _whose(p, i, whole):
        for look, k in _look(p, p.any_of(j, _IS) or j, bool(whole) or _many(theme)):
            quality = Quality(traits=Traits(colors=(look,) if look else ()), span=p.span(j, k))
            yield Clause(verb="be", lemma="fact", theme=theme, adjuncts=(quality,), mode="goal", span=p.span(i, k)), k


def _whose(p: Parser, i: int, whole: int) -> Results[Meaning]:
    if whole:
        yield Noun(head="block", det="all", plural=True, traits=Traits(kind="letter"), span=p.span(i, whole)), whole
    if j := p.any_of(i, _OTHERS):
        yield Pronoun(word="the others", span=p.span(i, j)), j
        return
    for theme, j in simple(p, i):
        marks = theme.traits if isinstance(theme, Noun) else Traits()
        told = marks.labels or marks.kind in ("letter", "digit", "symbol") or marks.quality
        if isinstance(theme, Noun) and theme.head != "patch" and told and not marks.colors and not theme.conditions:
            yield theme, j


def _many(theme: Meaning) -> bool:
    """Several letters, of which each is on a cube of its own."""
    several = isinstance(theme, Noun) and (theme.plural or theme.amount not in (None, Amount(1, 1)))
    return several or isinstance(theme, Pronoun)


def _look(p: Parser, i: int, several: bool) -> Results[str]:
    """The colour of the cubes: "red", "in red", "in a green cube", "on red bodies"; "on red cubes" of several."""
    prep = p.one(i, ("in", "on", "of"))
    start = p.opt(prep or i, "a", "an", "separate")
    if ivory := p.one(start, "ivory"):  # what letter cubes are anyway
        yield "", p.one(ivory, _CUBES) or ivory
    if p.lex(start, lexicon.COLOR) is None:
        return
    for named, j in color(p, start):
        end = p.one(j, _CUBES)
        if not prep and not end:
            yield named, j
        elif p.words[prep - 1] != "on":
            yield named, end or j
        elif end and (p.words[j] in _BODIES or (several and p.words[j] in _PLURAL and start == prep)):
            yield named, end
