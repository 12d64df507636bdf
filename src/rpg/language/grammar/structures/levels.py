"""Towers told level by level: "at the bottom green, above it two grays, on top purple", "the lowest is A, then B"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.nouns import simple
from rpg.language.later import later
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, OrderBy, Structure, Traits, replace
from rpg.language.tokens import Token

if TYPE_CHECKING:
    from rpg.language.grammar.clauses.clauses import tail
else:
    (tail,) = later(__name__, "rpg.language.grammar.clauses.clauses", "tail")

_ANCHORS = frozenset({
    "bottom", "lowest", "lowermost", "bottommost", "base", "top", "topmost", "uppermost", "highest", "below",
    "underneath", "first", "start", "begin",
})  # fmt: skip
"""Words without one of which no level of a tower is told."""
_OTHERS = frozenset(word for word, kind in lexicon.STRUCTURE.items() if kind != ("stack", False))
"""Other structures, of which this could be told."""
_OF = "of_it|of_the_tower|of_the_stack|of_a_tower|of_a_stack|of_this_tower|of_one_tower|of_the_pile"
_ONE = "block|one|cube|brick|level"
_PLACES = (
    ("bottom", Patterns(f"at|on|in the very? bottom|base|foot {_OF}?", "at|as|for the base|foundation")),
    ("bottom", Patterns("as|being the lowest|bottommost|lowermost|bottom block|one|cube?", "lowest",
                        "as|being|in the lowest place|position|level",
                        "the? lowest|bottommost of_it|of_a_tower|of_the_tower|of_a_stack|of_the_stack?")),
    ("top", Patterns(f"on|at|right_at|right_on the very? top {_OF}?",
                     "on top of_everything|of_all|of_it_all|of_them_all?",
                     "all the way on|at the? top", "topmost", "as|for the? tip|top|peak")),
    ("up", Patterns("directly|right? on|upon|atop it|that|this|those|them|these|that_one|the_two|both",
                    "directly|right? on top of it|that|this|those|them|these|that_one")),
    ("higher", Patterns("directly|right? above|over it|that|this|those|them|these|that_one|the_two|both")),
    ("first", Patterns("first")),
    ("down", Patterns("directly|right? below|under|beneath|underneath it|that|this|those|them|these|that_one")),
    ("above", Patterns("above", "over it all")),
    ("below", Patterns("below", "underneath", "beneath")),
    ("between", Patterns("in_between|between|sandwiched_between|sandwiched_in_between them|those|these|the_two|both?",
                         "in the very|exact? middle|center", "sandwiched")),
)  # fmt: skip
"""Where a level is, as it is said behind its blocks or before them."""
_OWN = (
    ("bottom", Patterns(f"the|its? very? lowest|bottom|bottommost|lowermost {_ONE}? {_OF}?",
                        f"the {_ONE} at|on the very? bottom|base {_OF}?", "the? base|foundation")),
    ("top", Patterns(f"the|its? very? top|topmost|uppermost|highest {_ONE}? {_OF}?",
                     f"the {_ONE} at|on the? very? top {_OF}?")),
    ("between", Patterns("the|its? middle|central block|one|cube|blocks|ones|cubes|two|three|four?",
                         "the block|one|cube|two|three|four|others|rest|ones|blocks|cubes? in_between|in_the_middle|"
                         "between|in_between_them|between_them|between_those")),
    ("next", Patterns("the next one|block|cube?")),
)  # fmt: skip
"""A level as a noun of its own: "the lowest block", "the two in the middle"."""
_COVERING = (
    ("up", Patterns("then|next? cover|top|crown it|that|this|them with", "then|next? put|place|stack on|upon it|that")),
    ("top", Patterns("then|finally|and? finish|end|top off with", "then|finally|and? finish|end with",
                     "then|finally|and? top it off with", "with|and finally?")),
)  # fmt: skip
_THEN = Patterns(
    "and? then|next|after_that|followed_by|afterwards|finally|lastly comes|come|there_is|put|place|follows?"
)
_IS = Patterns(
    "is|are|comes|come|goes|go|sits|sit|lies|lie|stands|stand|being|belongs|belong",
    "should|must|shall|has_to|have_to|is_to|are_to be|go|come|sit|lie",
    "there is|are|comes|come|should_be|must_be|goes", "i want|need|would_like", ":", "put", "place", "we have",
    "you see",
)  # fmt: skip
_LEADS = Patterns("put|place|set|lay|take|use|have|i_want|we_have|there_is|i_need|with|start_with|begin_with",
                  "first ,?",
                  "start|begin with", "first of all ,?", "first put|place|comes|take|use|i_want|there_is")  # fmt: skip
_TOWER = Patterns(",? all two|three|four|five|of_them? in|as one|a|the|the_same? tower|stack|pile")
"""What the blocks of all levels form, said behind them."""
_AND = (", and", ",", "and", "; and", ";", ", but", "but", "-")
_MOST = 10


@dataclass(frozen=True)
class _Level:
    """Where the blocks of a level are, as it was said, and which they are."""

    place: str
    blocks: Meaning
    many: int


@rule
def levels(p: Parser, i: int) -> Results[Clause]:
    """A tower of which every level is told, from one end to the other."""
    if not p.anywhere(_ANCHORS):
        return
    for start in dict.fromkeys((i, *_LEADS.matches(p, i))):
        begins = start > i and bool({"first", "start", "begin"} & {*p.words[i:start]})
        for had, j in _told(p, start, (), begins):
            items, end = in_order(had), j
            j = max(_TOWER.matches(p, j), default=j)
            all_ = next((n for k in range(end, j) if (n := p.number(k) or 0) > 1), None)
            if (
                items
                and all_ in (None, sum(x.many for x in had))
                and tail(p, j) >= p.end
                and _OTHERS.isdisjoint(p.words)
            ):
                order = OrderBy(by="named", items=items, first="bottom", span=p.span(i, j))
                line = Structure(kind="stack", det="the", span=p.span(i, j))
                yield Clause(verb="part", theme=line, adjuncts=(order,), mode="goal", span=p.span(i, j)), j


def _told(
    p: Parser, at: int, had: tuple[_Level, ...], begins: bool, least: int = 2
) -> Iterator[tuple[tuple[_Level, ...], int]]:
    """Levels one after the other, the longest run first."""
    for level, j in _level(p, at, begins and not had):
        found = (*had, level)
        if len(found) < _MOST:
            joint = p.any_of(j, _AND)
            follows = joint or (j if any(_THEN.matches(p, j)) else 0)
            yield from _told(p, follows, found, begins, least) if follows else ()
        if len(found) >= least:
            yield found, j


def _level(p: Parser, at: int, first: bool) -> Iterator[tuple[_Level, int]]:
    """One level: its place and its blocks, either first."""
    for place, patterns in (*_OWN, *_PLACES, *_COVERING):
        for j in patterns.matches(p, at):
            many = p.number(j - 1) or 0 if p.words[j - 1] not in ("one", "ones") else 0
            many = many or next((n for k in range(at, j) if (n := p.number(k)) and p.words[k] != "one"), 0)
            for start in dict.fromkeys((*_IS.matches(p, p.opt(j, ",")), j)):
                yield from ((_with_many(found, place, many), k) for found, k in _blocks(p, start))
    for then in dict.fromkeys((at, *_THEN.matches(p, at))):
        for found, j in _blocks(p, then):
            for k in dict.fromkeys((j, *_IS.matches(p, j))):
                for place, patterns in _PLACES:
                    yield from ((_with_many(found, place, 0), end) for end in patterns.matches(p, k))
            if first or then > at:
                yield _with_many(found, "first" if first else "next", 0), j


def _with_many(found: _Level, place: str, many: int) -> _Level:
    """A level at a place, of as many blocks as the place says."""
    if many > 1 and found.many == 1 and isinstance(found.blocks, Noun):
        looks = Noun(head="block", amount=Amount(many, many), plural=True, traits=found.blocks.traits,
                     span=found.blocks.span)  # fmt: skip
        return _Level(place, looks, many)
    return _Level(place, found.blocks, found.many if many in (0, found.many) else 0)


def _blocks(p: Parser, at: int) -> Iterator[tuple[_Level, int]]:
    """So many blocks of one look, or several of which it is said that their order is free."""
    for theme, j in simple(p, at):
        if isinstance(theme, Noun) and (many := _of_one_look(theme)):
            yield _Level("", theme, many), j
    lead = p.any_of(at, ("any order of", "in any order", "in either order", "in whatever order", "any ordering of"))
    named: list[Meaning] = []
    j = lead or at
    while len(named) < _MOST:
        item, k = next(((x, k) for x, k in simple(p, j) if isinstance(x, Noun) and _of_one_look(x) == 1), (None, 0))
        if item is None:
            look, k = next(iter(color(p, j)), ("", 0))
            item = Noun(head="any", traits=Traits(colors=(look,)), span=p.span(j, k)) if k else None
        if item is None:
            return
        named.append(item)
        free = p.any_of(p.opt(k, ","), ("in any order", "in either order", "in no particular order", "in some order"))
        if len(named) > 1 and (lead or free):
            yield _Level("", Coord(op="and", items=tuple(named), span=p.span(at, k)), len(named)), free or k
        j = p.any_of(k, (", and", ",", "and"))
        if not j:
            return


def _of_one_look(theme: Noun) -> int:
    """How many blocks a phrase names that look alike; 0 where it says something else."""
    marks = theme.traits
    plain = len(marks.colors) + len(marks.labels) == 1 and not marks.either and marks.rank is None and not marks.extra
    if not plain or theme.head == "patch" or theme.part_of is not None or theme.conditions:
        return 0
    if theme.det not in ("a", "the", "bare", "another") or (theme.plural and theme.amount is None):
        return 0
    if theme.amount is None:
        return 1
    return theme.amount.low if theme.amount.low == theme.amount.high and not theme.amount.strict else 0


_RISING = frozenset({"up", "higher", "above", "next"})


def in_order(had: tuple[_Level, ...]) -> tuple[Meaning, ...]:
    """The levels from the bottom up; none where they do not tell one tower from one end to the other.

    Several blocks at the bottom, or right on one block, could lie side by side.
    """
    rising: list[_Level] = []
    falling: list[_Level] = []
    between: list[_Level] = []
    up = had[0].place in ("bottom", "below", "first")
    if not up and had[0].place not in ("top", "above"):
        return ()
    onward, ends = (_RISING, {"top"}) if up else ({"down", "below", "next"}, {"bottom"})
    if had[0].place == "first" and all(level.place == "next" for level in had[1:]):
        return ()
    for level in had[1:]:
        if level.place == "up" and falling and up:  # "gray on top, purple on top of that"
            rising, falling = [*rising, *falling], []
        if level.place == "between":
            between.append(level)
        elif level.place in onward and not falling:
            rising += [*between, level]
            between = []
        elif level.place in ends and not falling:
            falling.append(level)
        else:
            return ()
    if had[-1].place == "between" and rising and not falling and had[-2].place in ("above", "below"):
        falling = [rising.pop()]
    if between and (not falling or len(between) > 1):
        return ()
    line = [had[0], *rising, *between, *falling]
    line = line if up else line[::-1]
    if not all(level.many for level in line) or line[0].many > 1 or len(line) < 2:
        return ()
    plain = len(line) == 2 and (line[1].many == 1 or had[1].place not in ("higher", "above"))
    resting = [x for x in line[1:] if x.many > 1 and x.place == "up" and not isinstance(x.blocks, Coord)]
    if plain or (resting and not falling):
        return ()
    return tuple(level.blocks for level in line)


def in_one(parts: list[list[Token]]) -> list[list[Token]]:
    """ "The top block is red. The bottom block is blue. Two green ones are in between.": one tower in one sentence.

    Only where no other structure than one tower is named, of which these could be parts.
    """
    if len(parts) < 2:
        return parts
    words = [token.word for part in parts for token in part]
    shapes = [lexicon.STRUCTURE[word] for word in words if word in lexicon.STRUCTURE]
    if _ANCHORS.isdisjoint(words) or shapes not in ([], [("stack", False)]):
        return parts
    out: list[list[Token]] = []
    run: list[list[Token]] = []
    for part in [*parts, []]:
        p = Parser(part)
        if part and any(j >= p.end for _, j in _told(p, 0, (), False, 1)):
            run.append(part)
            continue
        whole = [
            token
            for n, told in enumerate(run)
            for token in ([replace(told[0], kind="punct", word=",", raw=",", value=None), *told] if n else told)
        ]
        out += [whole] if len(run) > 1 and levels(Parser(whole), 0) else run
        out += [part] if part else []
        run = []
    return out
