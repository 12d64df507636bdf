"""Clauses behind what is said of them ahead: "on the left, ...", "in ascending order, the digits shall be stacked"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import colors
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import (
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    Structure,
    Traits,
    replace,
)

WAY = frozenset({"from", "in", "into"})
"""What the way along a line begins with, behind its order or its name and before the clause."""
_TO_BE = Patterns(
    "should|must|shall|will|has_to|have_to|needs_to|need_to|ought_to|is_to|are_to all|each? be|have_been",
    "is|are|has_been|have_been",
)
_SENSES = frozenset({"place", "arrange", "stack", "sort", "build"})
_CLOSED = frozenset({"", ",", ";", ":", "and", "but", "so", "with"})


def done_last(p: Parser, i: int, mode: str) -> Results[Clause]:
    """What is done with what, behind how or where it is to be: "the letters are to be brought"."""
    when = "start" if mode == "start" else "goal"
    for theme, j in noun_phrase(p, i):
        for k in _TO_BE.matches(p, j):
            for sense, lemma, form in p.lex(k, lexicon.VERB) or ():
                end = p.opt(k + 1, "up", "out", "down", "together")
                past = form == "past" or lemma in ("put", "set", "spread", "split")
                if past and sense in _SENSES and p.words[end] in _CLOSED:
                    done = Clause(verb=sense, lemma=lemma, theme=theme, mode=when, span=p.span(i, end))
                    yield replace(done, word=p.span(k, k + 1)), end


_OF_EACH = Patterns("for|in each|every_one of the|these? colors? :?")


def in_each_hue(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """ "For each of the colours red and blue, ...": these, and where the clause begins."""
    for j in _OF_EACH.matches(p, i):
        for (named, either), k in colors(p, j):
            if len(named) > 1 and not either and p.stands(k, (",", ":")):
                yield named, k + 1


def of_hues(found: Meaning, hues: tuple[str, ...]) -> Clause | None:
    """What is told of one structure, of one in each of these colours."""
    shape = found.theme if isinstance(found, Clause) and found.verb == "build" else None
    if not isinstance(found, Clause) or not isinstance(shape, Structure) or shape.plural or shape.det not in _ONE_EACH:
        return None
    blocks = shape.members
    if (blocks is not None and (not isinstance(blocks, Noun) or blocks.traits not in _PLAIN)) or shape.traits.colors:
        return None
    painted = [replace(shape, traits=replace(shape.traits, colors=(hue,))) for hue in hues]
    if isinstance(blocks, Noun):
        painted = [replace(shape, members=replace(blocks, traits=Traits(colors=(hue,)))) for hue in hues]
    return replace(found, theme=Coord(op="and", items=tuple(painted), span=shape.span))


_ONE_EACH = frozenset({"a", "bare", "another"})
_PLAIN = (Traits(), Traits(matching=True), Traits(scheme="same"))
"""What blocks may look like of which each time one colour is told: "of that colour", "of one colour"."""
_OPPOSITES = frozenset({"left", "right"}), frozenset({"front", "behind"})


def goes_with(first: Loc, found: Clause) -> bool:
    """ "In front of A and to the left of B, C shall be found": a further place of it, which may well be at both."""
    others = [a for a in found.adjuncts if isinstance(a, Loc | In)]
    rels = {first.rel, *(a.rel for a in others if isinstance(a, Loc))}
    return len(others) == 1 and len(rels) == 2 and rels not in _OPPOSITES and found.verb in ("be", "place")


def at_place(found: Meaning, place: Meaning) -> Meaning:
    """A clause with a place that was said before it."""
    return replace(found, adjuncts=(*found.adjuncts, place)) if isinstance(found, Clause) else found


def of_a_place(first: Into, found: Meaning) -> Chain | None:
    """ "in a row of red, blue and green, the red one is (not) at the left end": what is where in it."""
    inside = found if isinstance(found, Chain) else Chain(clauses=(found,), links=("and",), span=found.span)
    for one in inside.clauses:
        placed = one.adjuncts if isinstance(one, Clause) and one.verb == "be" else ()
        if not placed or not all(isinstance(a, At) for a in placed):
            return None
    return inside if isinstance(first.structure, Structure) and first.structure.members is not None else None
