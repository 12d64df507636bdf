"""Colours that take turns: "alternating red and white", "whose colours alternate", "every other one black"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.never_twice import NEVER_TWICE, TOLD_BY
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.lists import listed
from rpg.language.later import later
from rpg.language.meaning import Meaning, Noun, OrderBy, Traits, parts_of

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_TURNS = Patterns(
    "so|so_that|such_that|where|in_which|while|and? the|their|its? color|colors|blocks|cubes "
    "should|must|will|do|does? alternate|alternates|take_turns",
    "whose|with the|their? color|colors|blocks should|must|will|do|does? alternate|alternates|alternating|taking_turns|"
    "taking_their_turns|changing_every_time|changing_each_time "
    "all_the_way|all_the_way_up|all_the_way_to_the_top|all_the_way_along|throughout|each_time|every_time?",
    "so_that|so|that|which|such_that they|it? should|must|will? alternate|alternates in_color|colors?",
    "taking|take|in turns|turn",
    "by|in turns",
    ",? the|their|its? colors|color alternating",
)
"""The colours of the blocks spoken of alternate."""
_WHERE_NO = "so_that|so|such_that|in_which|where|with|and|but|of_which?"
_NEXT = (
    "neighbors|neighboring_blocks|neighboring_cubes|neighboring_ones|adjacent_blocks|adjacent_cubes|adjacent_ones|"
    "touching_blocks|blocks_next_to_each_other"
)
_TOUCH = "neighbors|next_to_each_other|side_by_side|adjacent|touching|beside_each_other|next_to_one_another"
_APART = Patterns(
    f"{_WHERE_NO} no two {_NEXT} are|is|have|share|with|of|having? may|should|must|can? have|share|be|show? of|in? "
    "the? same|equal color|colors",
    f"{_WHERE_NO} {_NEXT} in|of|with different color|colors",
    f"{_WHERE_NO} no two {_NEXT} are|being|may_be|should_be|must_be? equal|alike|identical|the_same in color|colors",
    f"{_WHERE_NO} no two blocks|cubes|ones? of|in|with the? same|equal|one color|colors are|stand|may|should|must|can? "
    f"be|stand|sit|come|lie|end_up? {_TOUCH}",
    f"{_WHERE_NO} no two blocks|cubes|ones? of|in|with the? same|equal|one color|colors may|should|must|can? touch",
    f"{_WHERE_NO} {_NEXT} should|must|always|all? have|are|be|show|differ of|in? different? color|colors",
)
"""Nowhere along the line do two neighbours agree in colour."""
_SAME_BACK = (
    "the_same from|in|seen_from|read_from|when_read_from|when_it_is_read_from|when_seen_from|when_read_in "
    "both|either|the_left_and_the_right|the_left_and_from_the_right|left_and_right|the_left_as_from_the_right|"
    "left_to_right_and_from_right_to_left|left_to_right_and_right_to_left|left_to_right_as_from_right_to_left "
    "ends|end|sides|side|directions|direction|ways?"
)
_MIRRORED = Patterns(
    f"which|that|so_that_it|so_it|such_that_it? should|must|can_be|to? read|reads|reading|look|looks|is|be "
    f"{_SAME_BACK}",
    "whose|with|so_that|such_that|where|in_which the|its|their? colors|order|pattern|it|they is|are|being|be|reads? "
    "mirror_symmetric|mirror_symmetrical|mirrored|symmetric|symmetrical|palindromic|a_palindrome|a_mirror_image",
    "mirrored|symmetric|symmetrical|symmetrically around|about|to|with_respect_to|in the|its middle|center",
)
_ALONE = Patterns(
    "the|their|its? color|colors|blocks|cubes should|must|will|do|have_to? alternate|take_turns",
    "they|it should|must|will|do|does? alternate|take_turns in_color|colors?",
)
_IT_READS = Patterns(
    "the|their|its colors|order|pattern is|are|must_be|should_be|shall_be|has_to_be|have_to_be "
    "mirrored|symmetric|symmetrical|mirror_symmetric|mirror_symmetrical|palindromic|a_palindrome",
    f"it|the_row|the_line|the_tower|this should|must|has_to? read|reads|look|looks|be|is {_SAME_BACK}",
)
_LINES = frozenset({*lexicon.STRUCTURE, "stack", "pile"})
"""Without a line of blocks, nothing follows of their order where those of a colour do not touch."""
_KEPT_APART = ((_APART, "alternating"), (NEVER_TWICE, "alternating"))
_TWICE = frozenset(
    {
        "never",
        "not",
        "same",
        "equal",
        "identical",
        "two",
        "any",
        "a",
        "color",
        "without",
        "no",
        "neighbors",
        "neighboring",
        "adjacent",
        "the",
        "their",
        "its",
        "they",
        "it",
        "this",
        "colors",
    }
)
_RARE = (
    "alternate", "alternates", "alternating", "alternately", "alternation", "switching", "turn", "turns", "every", "no",
    "neighbors", "neighboring", "adjacent", "touching", "next", "different", "same", "mirrored", "symmetric",
    "symmetrical", "symmetrically", "always", "strictly", "continuously", "constantly", "time", "way", *TOLD_BY,
)  # fmt: skip
_TELLING = frozenset(_RARE)
"""Words without one of which nothing is said of this here."""


@rule
def alternation_alone(p: Parser, i: int) -> Results[OrderBy]:
    """ "The colours alternate.", "No two neighbours have the same colour.": of the line that was built."""
    if p.rarely(_TELLING) and p.stands(i, _TWICE):
        for patterns, by in ((_ALONE, "alternating"), *_KEPT_APART, (_IT_READS, "mirrored")):
            yield from ((_of_colors(p, i, j, by), j) for j in patterns.matches(p, i))


def _of_colors(p: Parser, i: int, j: int, by: str) -> OrderBy:
    return OrderBy(by=by, values=what_alternates(by, p.words[i:j]), span=p.span(i, j))


def what_alternates(by: str, words: Sequence[str]) -> tuple[str, ...]:
    """The colours, where words of an alternation name them; else it is of whatever tells the blocks apart."""
    return ("color",) if by == "alternating" and not _COLORS.isdisjoint(words) else ()


_COLORS = frozenset({"color", "colors"})
_SIZES = Patterns(
    ",|and? alternating|alternate|alternates in|by size|sizes",
    ",? taking|take turns in|by size|sizes",
    "with|of|in alternating sizes",
    ",? whose|with|the|their? size|sizes should|must|will? alternate|alternates|alternating",
)
"""The sizes of the blocks spoken of alternate."""
_BETWEEN = (
    ", alternate", ": alternate", ", alternates",
    "alternating between", "with alternating colors", "in alternating colors ,", "alternating", "alternately",
    "alternately in", "with alternating", "of alternating", "switching between", "that alternates between",
    "that alternates", "which alternates between", "which alternates", "alternates between", "that alternate between",
)  # fmt: skip
"""What two colours follow."""
_AFTER = (
    "alternating",
    "in alternation",
    "alternately",
    "alternate",
    "taking turns",
    "take turns",
    "by turns",
    "in turns",
    "in turn",
)
_CHOSEN = "of_your_choice|of_your_choosing|you_like|that_you_like|you_choose|of_any_kind|whichever|as_you_like"
_ANY_TWO = Patterns(
    f"that|which? alternate|alternates|alternating|switching between? any|some? two|2 different? colors {_CHOSEN}?",
    f"in|with|of|using? two|2? alternating colors {_CHOSEN}",
    "with|in|using|of any|some? two|2 different? colors alternating|that_alternate|which_alternate|in_alternation|"
    "in_turn",
)
"""Two colours, whichever, alternate."""
_WITH = ("alternate with", "alternates with", "take turns with", "are alternating with")
_TURNING = frozenset(phrase.split()[-1] for phrase in _AFTER) | {"alternates"}
_WHERE = ("in which", "where", "with", "so that", "such that", "so", ",")
_ONE = ("every other one", "every second one", "every other block", "every second block", "every other cube",
        "every second cube", "every other", "every second")  # fmt: skip
_REST = ("the rest", "the others", "the other ones", "the remaining ones", "the other blocks", "all others")


@rule
def alternation(p: Parser, i: int) -> Results[Meaning]:
    """Colours that alternate, with the two of them where they are named."""
    if not p.rarely(_TELLING):
        return
    for j in _TURNS.matches(p, i):
        two = p.opt(j, "between", ":", ",")
        if two == j or p.words[j] != "between":
            yield _of_colors(p, i, j, "alternating"), j
        for found, k in _two(p, i, two):  # ", three red and three white" is what there is
            if p.words[j] != "," or not any(isinstance(x, Noun) and x.amount for x in parts_of(found)):
                yield found, k
    for j in _ALWAYS.matches(p, i):
        yield from _in_turn(p, i, j)
    lined = p.anywhere(_LINES)
    for patterns, by in (*_KEPT_APART[: 1 + lined], (_ANY_TWO, "alternating"), (_MIRRORED, "mirrored")):
        start = p.opt(i, ",") if patterns is _ANY_TWO else i
        yield from ((_of_colors(p, i, j, by), j) for j in patterns.matches(p, start))
    yield from ((OrderBy(by="alternating", attribute="size", span=p.span(i, j)), j) for j in _SIZES.matches(p, i))
    if j := p.any_of(i, _BETWEEN):
        yield from _two(p, i, j)
        set_off = p.one(j, (",", ":")) if p.follows(j, ("colors",)) else 0
        for found, k in _two(p, i, set_off) if set_off else ():  # ", 3 black and 3 yellow" is what there is
            if not any(isinstance(x, Noun) and x.amount for x in parts_of(found)):
                yield found, k
    for j in dict.fromkeys((i, p.any_of(i, _WHERE) or i)):
        for items, k in listed(p, j) if p.anywhere(_TURNING) else ():
            if end := p.any_of(k, _AFTER) or p.any_of(p.opt(k, "blocks", "cubes", "bricks", "ones"), _AFTER):
                yield OrderBy(by="alternating", items=items, span=p.span(i, end)), end
        for one, k in simple(p, j) if j > i and p.anywhere(_TURNING) else ():
            m = p.any_of(k, _WITH)
            for other, end in simple(p, m) if m else ():
                yield OrderBy(by="alternating", items=(one, other), span=p.span(i, end)), end
        if k := p.any_of(j, _ONE):
            yield from _one_and_rest(p, i, k)


_ALWAYS = Patterns(",|:? always|strictly|continuously|constantly|each_time|every_time|all_the_way")
_ONE_OF = Patterns("one|a|1 single?")
_THEN_ONE = Patterns("one|block|cube? ,|,_and|and? one|a|1? single?")
_AND_SO_ON = Patterns(
    ",? and? so_on|so_forth|repeating|repeated|over_and_over|again_and_again|all_the_way|all_the_way_up|throughout|"
    "etc|until_the_end|to_the_end|in_turn|in_turns|by_turns",
)


def _in_turn(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """ "(always) one red one white": two colours, and nothing more behind them. "First red, then white" would tell as
    well with which of them the line begins, but not from which side."""
    for one, k in ((named, k) for start in {j, *_ONE_OF.matches(p, j)} for named, k in color(p, start)):
        for m in _THEN_ONE.matches(p, k):
            for other, end in color(p, m):
                end = p.opt(end, "one", "block", "cube")
                end = max(_AND_SO_ON.matches(p, end), default=end)
                if one != other and (end >= p.end or p.stands(end, _OVER)):
                    span = p.span(j, end)
                    both = tuple(Noun(head="any", traits=Traits(colors=(x,)), span=span) for x in (one, other))
                    yield OrderBy(by="alternating", items=both, span=p.span(i, end)), end


_OVER = frozenset({",", ";", "with", "so", "starting", "beginning", "in", "from", ")"})


def _two(p: Parser, i: int, j: int) -> Results[Meaning]:
    for one, k in color(p, j):
        for two, end in color(p, p.one(k, "/")) if p.stands(k, ("/",)) else ():
            both = tuple(Noun(head="any", traits=Traits(colors=(x,)), span=p.span(j, end)) for x in (one, two))
            yield OrderBy(by="alternating", items=both, span=p.span(i, end)), p.opt(end, "blocks", "cubes", "ones")
    for items, k in listed(p, j):
        k = p.opt(k, "blocks", "cubes", "ones")
        looks = [x.traits for x in items if isinstance(x, Noun)]
        turns = len(looks) > 3 and looks[2:] == looks[:-2]  # "red, white, red, white": how they stand
        yield OrderBy(by="named" if turns else "alternating", items=items, span=p.span(i, k)), k


def _one_and_rest(p: Parser, i: int, j: int) -> Results[Meaning]:
    """ "every other one (is) black, the rest (are) white"."""
    j = p.any_of(j, ("is", "should be", "must be", "being", "in")) or j
    for one, k in color(p, j):
        rest = p.any_of(p.opt(p.opt(k, ","), "and"), _REST)
        rest = p.any_of(rest, ("is", "are", "should be", "must be", "being", "in")) or rest if rest else 0
        for two, end in color(p, rest) if rest else ():
            both = (two, one) if "second" in p.words[i:j] else (one, two)
            items = tuple(Noun(head="any", traits=Traits(colors=(x,)), span=p.span(j, end)) for x in both)
            yield OrderBy(by="alternating", items=items, span=p.span(i, end)), end
