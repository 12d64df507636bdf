""" "For each cube, if it has a letter put it on the left patch, if it has a digit put it on the right patch": each of a
kind goes to its place, which depends on nothing that may change."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjunct
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Noun, That, Traits, parts_of, replace

_IF = frozenset({"if", "when", "whenever"})
_CUBES = ("cube", "block", "box", "one of them", "one of the cubes", "one of the blocks", "of the cubes",
          "of the blocks")  # fmt: skip
_EACH = tuple(f"{each} {cube}" for each in ("for each", "for every", "for any", "with each", "take each")
              for cube in _CUBES)  # fmt: skip
_ANY = tuple(f"{a} {cube}" for a in ("a", "any", "each", "every") for cube in ("cube", "block", "box"))
_IT = ("it", "the cube", "the block", *_ANY)
_HAS = frozenset({"has", "shows", "bears", "carries", "displays"})
_ON_IT = ("on it", "printed on it", "written on it", "on its faces", "on its sides")
_PUT = ("put", "place", "move", "bring", "set", "lay", "push")
_THEM = ("it", "that one", "this one", "that cube", "the cube", "that block", "the block")
_JOINTS = (", and", "and", ",", ", but", "but")


@choice
def each_kind(p: Parser, i: int) -> Results[Clause]:
    """Each of the kinds that are told, with its place."""
    if not p.rarely(_IF):
        return
    lead = p.any_of(i, _EACH)
    start = p.opt(lead, ",", ":") if lead else i
    for told, end in _told(p, start, _IT if lead else _ANY):
        first, *rest = told
        if rest:
            chain = Chain(clauses=tuple(rest), links=("and",) * len(rest), span=rest[0].span)
            first = replace(first, adjuncts=(*first.adjuncts, That(kind="so", clauses=chain, span=chain.span)))
        yield replace(first, span=p.span(i, end)), end


def _told(p: Parser, i: int, whom: tuple[str, ...]) -> Results[tuple[Clause, ...]]:
    """What is told of one kind, and of those behind it."""
    subject = p.any_of(p.one(i, _IF), whom)
    for traits, j in _looks(p, subject) if subject else ():
        put = p.any_of(p.opt(p.opt(j, ","), "then"), _PUT)
        moved = p.any_of(put, _THEM) if put else 0
        for place, end in adjunct(p, moved) if moved else ():
            if not _is_place(place):
                continue
            theme = Noun(head="block", det="each", traits=traits, span=p.span(subject, j))
            word, span = p.span(put - 1, put), p.span(i, end)
            one = Clause(verb="place", lemma="put", theme=theme, adjuncts=(place,), span=span, word=word)
            yield (one,), end
            yield from (((one, *more), k) for more, k in _told(p, p.any_of(end, _JOINTS) or end, _IT))


def _looks(p: Parser, i: int) -> Results[Traits]:
    """ "has a letter on it", "is a digit", "is red": what tells a kind."""
    if (begun := p.one(i, "is")) and (color := p.lex(begun, lexicon.COLOR)) is not None:
        yield Traits(colors=(color,)), begun + 1
    for shown, j in simple(p, p.one(i, _HAS) or begun) if begun or p.stands(i, _HAS) else ():
        marks = shown.traits if isinstance(shown, Noun) else Traits()
        kind = isinstance(shown, Noun) and shown.head == "block" and shown.det == "a"
        if kind and marks.kind and marks == Traits(kind=marks.kind, quality=marks.quality):
            yield marks, p.any_of(j, _ON_IT) or j


def _is_place(place: Meaning) -> bool:
    """A place that does not depend on where the block is."""
    named = [x for x in parts_of(place) if not isinstance(x, Loc | In | Noun)]
    return isinstance(place, Loc | In) and not named
