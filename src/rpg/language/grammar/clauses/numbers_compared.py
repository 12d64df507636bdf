"""Two numbers of blocks compared: "more red than blue blocks on the mat", "as many blocks on the red mat as on the blue
one"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.clauses.adjuncts import adjunct
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.regions import named_regions
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Coord, In, Loc, Manner, Meaning, Noun, Pronoun, replace

COMPARED = "compare numbers"
"""The verb of such a clause."""
SOME_OF_THEM = "some of them"
"""Its lemma where it may be said of a part of the blocks that there are."""
_TELLING = frozenset({"more", "fewer", "less", "many", "number", "amount", "numbers"})
_LEADS = Patterns(
    "put|place|set|lay|bring|get|have|leave|move|use|let",
    "let there be", "there is|are|must_be|should_be|shall_be|has_to_be|have_to_be|need_to_be|will_be",
)  # fmt: skip
_RELATIONS = {
    "more": Patterns("more|a_larger_number_of|a_greater_number_of"),
    "fewer": Patterns("fewer|less|a_smaller_number_of"),
    "at least": Patterns("at_least as many"),
    "same": Patterns(
        "just|exactly|precisely|equally? as many", "the|an exact|exactly? same|equal number|amount of",
        "equally many", "equal numbers of", "the|an exact|exactly? same|equal number|amount",
    ),
    "twice": Patterns("exactly? twice|two_times as many", "double the number of"),
}  # fmt: skip
_BE = Patterns(
    "must|should|shall|have_to|has_to|need_to|ought_to be|lie|go|stand|end_up|sit|rest|be_placed|be_put|stay",
    "are|is|lie|lies|go|goes|belong|stand|sit|sits|rest|end_up|ends_up",
)
_HAVE = Patterns(
    "must|should|shall|has_to|needs_to|is_to have|hold|carry|contain|get|end_up_with",
    "has|holds|carries|contains|gets",
)  # fmt: skip


@rule
def numbers_compared(p: Parser, i: int) -> Results[Clause]:
    """The two lots of blocks, or the one that all of it is about, and the place or the two places of both."""
    if not p.rarely(_TELLING):
        return
    for start in (i, *_LEADS.matches(p, i)):
        for rel, by, j in _relation(p, start):
            for lots, spots, end in _compared(p, j, rel):
                yield _clause(p, i, end, rel, by, lots, spots), end
    for spot, j in _places(p, i) if p.stands(i, _ON) else ():
        for start in (j, *_LEADS.matches(p, p.opt(j, ",")), *_BE.matches(p, j)):
            for rel, by, k in _relation(p, start):
                for lots, end in _two_lots(p, k, rel):
                    yield _clause(p, i, end, rel, by, lots, (spot,)), end
                for one, m in _lot(p, k):
                    for other, end in _places(p, joint) if (joint := _joint(p, m, rel)) else ():
                        yield _clause(p, i, end, rel, by, (one,), (spot, other)), end
    yield from _holding(p, i)


_ON = frozenset({"on", "in", "onto"})


def _relation(p: Parser, i: int) -> Iterator[tuple[str, int, int]]:
    """ "more", "two more", "as many": how the numbers compare, and by how many they differ."""
    by = p.number(i) or 0
    j = i + 1 if by else i
    for rel, pattern in _RELATIONS.items():
        if not by or rel in ("more", "fewer"):
            yield from ((rel, by, k) for k in pattern.matches(p, j))


def _joint(p: Parser, i: int, rel: str) -> int:
    return p.one(i, "than" if rel in ("more", "fewer") else "as")


def _lot(p: Parser, i: int) -> Results[Noun]:
    """ "red blocks", "reds", "red"; nothing where just places follow."""
    for blocks, j in simple(p, i):
        plain = isinstance(blocks, Noun) and blocks.head != "patch" and blocks.part_of is None and not blocks.conditions
        if not plain or not isinstance(blocks, Noun) or blocks.det not in ("bare", "the") or blocks.amount is not None:
            continue
        one = p.follows(i, ("more", "fewer")) and i > 1 and p.number(i - 2) == 1  # "one more block than ..."
        if blocks.plural or one or (blocks.head == "any" and len(blocks.traits.colors) == 1):
            yield blocks, j


def _two_lots(p: Parser, i: int, rel: str) -> Iterator[tuple[tuple[Noun, ...], int]]:
    """ "red than blue blocks"; of equal numbers also "red and blue blocks"."""
    for one, j in _lot(p, i):
        joint = _joint(p, j, rel) or (p.one(j, "and") if rel == "same" and p.words[i - 1] == "of" else 0)
        for other, k in _lot(p, joint) if joint else ():
            yield (one, other), k
        hues = one.traits.colors
        if rel == "same" and p.words[i - 1] == "of" and len(hues) == 2 and not one.traits.either:
            yield tuple(replace(one, traits=replace(one.traits, colors=(hue,))) for hue in hues), j


def _places(p: Parser, i: int) -> Results[Loc | In]:
    """ "on the mat", "in the left half"."""
    for place, j in adjunct(p, i):
        if isinstance(place, In) and not place.negated:
            yield place, j
        if isinstance(place, Loc) and place.rel in ("on", "in") and not (place.negated or place.mods):
            mark = place.landmark
            if isinstance(mark, Noun) and mark.head in ("patch", "any") and not mark.plural:
                yield place, j


def _compared(p: Parser, i: int, rel: str) -> Iterator[tuple[tuple[Noun, ...], tuple[Loc | In, ...], int]]:
    """What follows the word that compares."""
    for lots, j in _two_lots(p, i, rel):
        for at in (j, *_BE.matches(p, j)):
            yield from ((lots, (spot,), end) for spot, end in _places(p, at))
    bare = p.any_of(i, _OF_THEM) or i
    for lot, j in [*((((one,)), k) for one, k in _lot(p, i)), ((), bare)]:
        for at in (j, *_BE.matches(p, j)):
            for spot, k in _places(p, at):
                joint = _joint(p, k, rel)
                for other, end in _places(p, joint) if joint else ():
                    yield lot, (spot, other), end
                for one, end in _lot(p, joint) if joint and lot else ():
                    yield (*lot, one), (spot,), end


_OF_THEM = ("of them", "of these", "of those", "of the blocks", "of the cubes")
_ON_IT = ("on it", "on top", "in it", "on them")


def _holders(p: Parser, i: int) -> Iterator[tuple[Loc | In, int]]:
    """A patch or a part of the table as what has blocks: "the red patch", "the left half"."""
    for name, j in named_regions(p, p.opt(i, "the")):
        yield In(region=name, span=p.span(i, j)), j
    for one, j in simple(p, i):
        if not isinstance(one, Noun) or one.plural or one.part_of is not None:
            continue
        if one.head == "patch" or (one.head == "any" and one.traits.colors):
            yield Loc(rel="on", landmark=one, span=one.span), j


def _holding(p: Parser, i: int) -> Results[Clause]:
    """ "the red patch has more blocks on it than the blue patch"."""
    for one, j in _holders(p, i):
        for start in _HAVE.matches(p, j):
            for rel, by, k in _relation(p, start):
                for lot, m in _lot(p, k):
                    joint = _joint(p, p.any_of(m, _ON_IT) or m, rel)
                    for other, end in _holders(p, joint) if joint else ():
                        if type(other) is type(one):
                            yield _clause(p, i, end, rel, by, (lot,), (one, other)), end


def _clause(
    p: Parser, i: int, end: int, rel: str, by: int, lots: tuple[Noun, ...], spots: tuple[Meaning, ...]
) -> Clause:
    span = p.span(i, end)
    theme: Meaning = Coord(op="and", items=lots, span=span) if len(lots) > 1 else lots[0] if lots else _them(span)
    how = Manner(kind=rel, value=float(by), span=span)
    some = SOME_OF_THEM if not lots and "of" in p.words[:end] else ""
    return Clause(verb=COMPARED, lemma=some, theme=theme, adjuncts=(*spots, how), mode="goal", span=span)


def _them(span: tuple[int, int]) -> Pronoun:
    return Pronoun(word="everything", span=span)
