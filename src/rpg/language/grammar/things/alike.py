"""What all blocks look like, behind what is built of them: "..., all five of them white"; "Colour: blue."."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import adjectives, colors
from rpg.language.meaning import Amount, Clause, Noun, Pronoun, Quality, Structure, Traits, parts_of

_OF_THEM = ("of them", "of these", "of the blocks", "of the cubes", "the blocks", "the cubes", "blocks", "cubes")
_EVERY = {
    "each of them": None, "every one of them": None, "each one": None, "each block": None, "every block": None,
    "each cube": None, "every cube": None, "they are all": None, "these are all": None, "both of them": 2, "both": 2,
    "everything": None, "all of it": None, "the whole thing": None,
}  # fmt: skip
_ARE = ("are", "is", "being", "should be", "must be", "have to be", "has to be", "in")
_STOPS = frozenset({",", ";", "and"})


@rule
def all_alike(p: Parser, i: int) -> Results[Clause]:
    """ "all five of them white", "all are green", "every one of them a 5 cm cube"."""
    yield from color_named(p, i)
    for many, j in _all(p, i):
        k = p.any_of(j, _ARE) or j
        for marks, end in adjectives(p, p.opt(k, "a")):
            end = p.opt(end, *lexicon.BLOCK, "ones")
            if not marks or not marks.keys() <= {"colors", "edge", "size"} or len(marks.get("colors", ())) > 1:
                continue
            if end < p.end and p.words[end] not in _STOPS:
                continue
            amount = Amount(many, many) if many else None
            them = Noun(head="block", det="all", plural=True, amount=amount, span=p.span(i, j))
            quality = Quality(traits=Traits(**marks), span=p.span(j, end))
            yield Clause(verb="be", theme=them, adjuncts=(quality,), mode="goal", span=p.span(i, end), cost=1), end


_COLOR_IS = Patterns(
    "the|their|its|block|cube? color|colors of|for? the|all|each|every? "
    "blocks|cubes|bricks|block|cube|row|line|tower|stack|pyramid|wall|grid|square|circle? "
    "is|are|:|being|shall_be|should_be|must_be|has_to_be|will_be|to_be?",
    "all|each? of? the|these? blocks|cubes|bricks|block|cube should|must|shall? have|has the? color",
)


@choice
def color_named(p: Parser, i: int) -> Results[Clause]:
    """ "Colour is brown.", "..., the colour should be red", ", colour: blue": that of the blocks spoken of.

    What has the colour is named by nothing but "its", so that it is asked where this could be a patch as well.
    """
    for j in _COLOR_IS.matches(p, i):
        for (named, either), k in colors(p, j):
            if len(named) > 1 or either or (k < p.end and p.words[k] not in _STOPS):
                continue
            span = p.span(i, k)
            them = Noun(head="block", det="all", plural=True, span=p.span(i, j))
            said = () if {*p.words[i:j]} & {"their", "blocks", "cubes", "bricks", "all"} else ("it",)
            for theme in (them, *(Pronoun(word=word, span=them.span) for word in said)):
                quality = Quality(traits=Traits(colors=named), span=p.span(j, k))
                yield Clause(verb="be", theme=theme, adjuncts=(quality,), mode="goal", span=span, cost=1), k


def color_at_last(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "a staircase, three steps, going up to the right, green", "a row of four blocks, brown": a colour at the end is
    that of all of it."""
    shape, start = before.theme, p.one(i, ",")
    if not start or not isinstance(shape, Structure) or before.verb != "build" or shape.traits.colors:
        return
    if shape.members is not None and not (isinstance(shape.members, Noun) and shape.members.traits == Traits()):
        return
    if any(isinstance(x, Noun) and x.traits.colors for x in parts_of(before)):
        return
    for (named, either), j in colors(p, p.any_of(start, ("all", "in", "all in", "all of it")) or start):
        end = p.opt(j, "blocks", "cubes", "bricks")
        if end >= p.end and len(named) == 1 and not either:
            them = Noun(head="block", det="all", plural=True, span=p.span(start, end))
            quality = Quality(traits=Traits(colors=named), span=p.span(start, end))
            yield Clause(verb="be", theme=them, adjuncts=(quality,), mode="goal", span=p.span(start, end), cost=1), end


def _all(p: Parser, i: int) -> Results[int]:
    """ "all", "all five of them", "each of them", "both": how many that are, 0 where it is not said."""
    for phrase, j in p.standing(i, _EVERY):
        yield _EVERY[phrase] or 0, j
    if j := p.one(i, "all"):
        yield 0, p.any_of(j, _OF_THEM) or j
        for many, k in amounts.count(p, j):
            yield many, p.any_of(k, _OF_THEM) or k
