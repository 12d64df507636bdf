"""One block in the place of another: "replace the red block with a blue one", "put a blue block in its place"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.its_place import IN_ITS_PLACE
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Loc, Meaning, Noun, Pronoun, TableTop, Using

_REPLACE = ("replace", "substitute", "swap out", "switch out")
_TRADE = ("exchange", "swap", "switch", "trade", "change")
_PUT = ("put", "place", "set")
_TAKE = ("take away", "take out", "take off", "remove", "take", "lift", "pick up")
_AWAY = ("away", "off", "out", "down")
_OFF = ("off", "from", "off of", "away from", "out of")
_INSTEAD = ("in place of", "in the place of", "instead of")
_IS = ("is", "was", "stands", "lies", "sits", "stood", "lay")
_BE = ("should be", "must be", "is to be", "has to be", "shall be", "is", "gets", "will be")
_TAKES = ("takes", "should take", "must take", "has to take", "is to take", "shall take", "will take")
_GOES = ("goes", "should go", "must go", "has to go", "is to go", "shall go", "will go", "comes", "should come")
_REPLACES = ("replaces", "should replace", "must replace", "is to replace", "has to replace", "shall replace")
_ENDS = frozenset({"", ",", ";", ".", ":", "and", "then", "but", "so", "instead"})


def replaced(p: Parser, i: int) -> Results[Clause]:
    """All the ways to tell that one block goes where another is."""
    yield from _with_another(p, i)
    yield from _for_another(p, i)
    yield from _put_there(p, i)
    yield from _taken_away(p, i)
    yield from _of_the_new(p, i)


def _with_another(p: Parser, i: int) -> Results[Clause]:
    """ "Replace the red block by a blue one"; "the red block should be replaced with a blue one"."""
    for old, j in noun_phrase(p, k) if (k := p.any_of(i, _REPLACE)) else ():
        for new, end in simple(p, by) if (by := p.any_of(j, ("with", "by", "for"))) else ():
            told = (new, old) if p.words[i] == "substitute" and p.words[by - 1] == "for" else (old, new)
            if (p.words[by - 1] == "for") == (p.words[i] == "substitute"):
                yield from _clause(p, i, end, *told, p.span(i, k))
    for old, j in noun_phrase(p, i):
        done = p.one(be, "replaced") if (be := p.any_of(j, _BE)) else 0
        for new, end in simple(p, by) if (by := p.any_of(done, ("with", "by")) if done else 0) else ():
            yield from _clause(p, i, end, old, new, p.span(j, done))


def _for_another(p: Parser, i: int) -> Results[Clause]:
    """ "Exchange the red block for a blue one"."""
    for old, j in noun_phrase(p, k) if (k := p.any_of(i, _TRADE)) else ():
        for new, end in simple(p, by) if (by := p.one(j, "for")) else ():
            yield from _clause(p, i, end, old, new, p.span(i, k))


def _put_there(p: Parser, i: int) -> Results[Clause]:
    """ "Put a blue block in place of the red one", "... where the red one is", "... in its place"."""
    for new, j in noun_phrase(p, k) if (k := p.any_of(i, _PUT)) else ():
        yield from _its_place(p, i, j, None, new)
        for old, end in simple(p, of) if (of := p.any_of(j, _INSTEAD)) else ():
            yield from _clause(p, i, end, old, new, p.span(i, k))
        for old, end in simple(p, j + 1) if p.stands(j, ("where",)) else ():
            last = p.any_of(end, _IS)
            yield from _clause(p, i, last, old, new, p.span(i, k)) if last else ()


def _its_place(p: Parser, i: int, j: int, old: Meaning | None, new: Meaning) -> Results[Clause]:
    end = p.any_of(j, IN_ITS_PLACE)
    if end and isinstance(new, Noun):
        yield from _clause(p, i, end, old or Pronoun(word="it", span=p.span(j, end)), new, p.span(i, i + 1))


def _taken_away(p: Parser, i: int) -> Results[Clause]:
    """ "Take the red block away and put a blue one in its place"."""
    for old, j in noun_phrase(p, k) if (k := p.any_of(i, _TAKE)) else ():
        j = p.opt(j, *_AWAY)
        of = p.any_of(j, _OFF)
        j = next((end for mark, end in simple(p, of) if getattr(mark, "head", "") != "patch"), j) if of else j
        joined = p.any_of(j, ("and then", ", then", "and", ", and", "then"))
        for new, m in noun_phrase(p, put) if joined and (put := p.any_of(joined, _PUT)) else ():
            yield from _its_place(p, i, m, old, new)


def _of_the_new(p: Parser, i: int) -> Results[Clause]:
    """ "A blue block should take the place of the red one", "let it take its place"."""
    let = p.any_of(i, ("let", "have"))
    for new, j in noun_phrase(p, let or i):
        goes = p.any_of(j, ("go",) if let else _GOES)
        yield from _its_place(p, i, goes, None, new) if goes else ()
        takes = p.any_of(j, ("take",) if let else _TAKES)
        its = p.any_of(takes, ("its place", "its position")) if takes else 0
        if its and isinstance(new, Noun):
            yield from _clause(p, i, its, Pronoun(word="it", span=p.span(takes, its)), new, p.span(j, takes))
        of = p.any_of(takes, ("the place of", "the position of")) if takes else 0
        if of and "place of" in " ".join(p.words[of:]):
            continue  # "red takes the place of green and green takes the place of red": these are exchanged
        of = of or p.any_of(j, ("replace",) if let else _REPLACES)
        for old, end in simple(p, of) if of else ():
            yield from _clause(p, i, end, old, new, p.span(j, of))


def _on_table(place: Loc) -> bool:
    """ "With a blue one that is on the table": where what is put in its place comes from."""
    return place.rel == "on" and isinstance(place.landmark, TableTop) and not place.negated


def _clause(p: Parser, i: int, end: int, old: Meaning, new: Meaning, word: Span) -> Results[Clause]:
    if end < p.end and p.words[end] not in _ENDS:
        return
    placed = isinstance(new, Noun) and any(isinstance(c, Loc) and not _on_table(c) for c in new.conditions)
    if isinstance(old, Noun | Pronoun) and isinstance(new, Noun) and not placed:
        using = Using(members=new, lead="with", span=new.span)
        yield Clause(verb="replace", lemma="replace", theme=old, adjuncts=(using,), mode="command",
                     span=p.span(i, end), word=word), end  # fmt: skip
