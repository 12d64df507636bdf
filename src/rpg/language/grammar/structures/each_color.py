"""Colours told of as such: "stack each colour", "keep the colours apart", "each colour gets a tower of its own".

Whatever is said of each colour is said of the blocks of that colour: they are stacked, or grouped, by colour.
"""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.grammar.things.strangers import strangers
from rpg.language.grammar.things.theirs import THEIRS
from rpg.language.meaning import Clause, Loc, Noun, OrderBy, Traits, replace

_COLORS = Patterns(
    "each|every single|different? color",
    "each|every pair",
    "each|every|each_one|all of the two|three|four? colors",
    "the|all|all_the different|two|three|four? colors",
    "same|equal|like|matching|identical|different colors",
    "all|all_the|the|the_same? blocks|cubes|ones|pieces of|in each|every|one|the_same|a_single|equal|a color",
    "all|all_the|the blocks|cubes of|in the_same|like|equal|identical color|colors",
    "what|everything that_has|of|in the_same|one color",
)
_PLURAL = Patterns("colors")
"""Bare, behind a verb that can be said of nothing else: "sort colours into separate piles"."""
_OWN = ("its_own|its_own_separate|their_own|their_own_separate|a_separate|a_single|one|one_single|a_different|a|an|"
        "separate|single|own|different|individual|distinct|one_separate|its_separate|its_own_little|a_little|its_own_small|"
        "a_small")  # fmt: skip
_TOWERS = Patterns(
    f"into|in|to|onto|on|as|up_into|up_in {_OWN}? tower|towers|stack|stacks of_its_own|of_their_own|each|apiece?",
)
_GROUPS = Patterns(
    f"into|in|to|as|together_in|together_into {_OWN}? group|groups|cluster|clusters|bunch|bunches|"
    "pile|piles|heap|heaps of_its_own|of_their_own|each|apiece?",
)
_HAS = (
    "gets|should_get|must_get|has|should_have|must_have|forms|should_form|must_form|makes|makes_up|should_make|becomes|"
    "should_become|is|should_be|must_be|get|form|make|have|becoming|forming|making|is_to_form|are_to_form|needs "
    "a|an|its|their|one|just_one separate|single|own|different?"
)
_GETS = Patterns(f"{_HAS} tower|stack of_its_own|of_their_own?")
_GROUPED = Patterns(f"{_HAS} group|cluster|bunch of_its_own|of_their_own?")
_SHALL = "should_be|must_be|shall_be|is_to_be|are_to_be|has_to_be|have_to_be|need_to_be|needs_to_be"
_GOES = Patterns(
    f"{_SHALL} put|placed|sorted|grouped|collected|gathered|set|laid up?",
    "goes|should_go|must_go|is|should_be|must_be|belongs|ends_up|should_end_up|comes|is_to_go|go|are|should_all_be|"
    "have_to_be|must_all_be|should_stay|must_stay|need_to_be",
)
_LIES = Patterns(
    "is|are|should_be|must_be|goes|go|come|comes|stays|stay|should_stay|belong|belongs "
    "together|grouped|gathered|clustered"
)
_STACKED = Patterns(
    f"is|are|gets|get|ends_up|end_up|{_SHALL} stacked|piled_up|stacked_up|piled|built|built_up "
    "separately|by_itself|on_its_own?"
)
_SEPARATELY = Patterns(
    "separately|by_itself|on_its_own|by_themselves|on_their_own|apart|up_separately|"
    "individually|from_each_other|from_one_another"
)
_TOGETHER = Patterns(
    "together in_its_own_group|in_one_group|in_a_group|in_groups|in_their_own_groups|in_separate_groups?",
    "apart|separate|separated|apart_from_each_other|separate_from_each_other",
    "apart|separate in separate? groups",
)
_STACK = ("stack", "stack up", "pile up", "build up", "put up")
_SORT = ("sort", "group", "gather", "cluster", "collect", "separate", "split up", "divide", "bring")
_PUT = ("put", "place", "keep", "set", "lay", "bring", "move", "arrange", "gather", "collect", "sort", "stack", "group",
        "separate", "split", "assemble", "organize", "organise", "distribute")  # fmt: skip
_PLACE = ("put", "place", "move", "bring", "set", "lay", "get")
_FOR_EACH = Patterns("for|per|of|from|out_of|in each|every single? color", "per|a color", "each|apiece")
_ALL_OF_IT = Patterns(
    ",? with|containing|made_of|from|holding all the? blocks|cubes|ones of|in that|the_same|its color in_it|inside?"
)
_MAKE = Patterns(
    "build|make|create|form|put_up|assemble|set_up|there_should_be|there_must_be|i_want|i_would_like|we_want|we_need|"
    "i_need|there_is|give_me|have",
)
_ONE = Patterns("a|one|exactly_one|just_one|a_single|one_single|a_separate|its_own")


@choice
def of_each_color(p: Parser, i: int) -> Results[Clause]:
    """A clause that says of each colour how its blocks are put together."""
    yield from _on_patches(p, i)
    told = [(verb, j, 0) for verb, j in (*_commanded(p, i), *_stated(p, i))]
    for verb, j, cost in (*told, *((verb, j, 1) for verb, j in _one_for_each(p, i))):
        span = p.span(i, j)
        blocks = Noun(head="block", det="the", plural=True, span=span)
        by = OrderBy(by="attribute", span=span)
        word = p.span(i, i + 1)
        said = Clause(verb=verb, lemma=verb, theme=blocks, adjuncts=(by,), mode="goal", span=span, word=word, cost=cost)
        # What is said of each behind this is said of the stacks or groups, of which this names none.
        if "pair" not in p.words[i:j] and not p.seq(j, ", each"):
            yield said, j
        for strange, k in strangers(p, j) if verb == "sort" else ():
            yield replace(said, adjuncts=(by, strange), span=p.span(i, k)), k
        for found, k in loc(p, j) if verb == "stack" or p.words[j : j + 1] == ["on"] else ():
            mark = found.landmark if isinstance(found, Loc) else None
            if (
                isinstance(mark, Noun)
                and mark.head == "patch"
                and isinstance(found, Loc)
                and (mark.traits.matching or (_own(mark) and not mark.traits.colors))
            ):
                marks = replace(mark.traits, matching=True, scheme=None)
                spot = replace(mark, det="the", amount=None, plural=True, traits=marks)
                where = replace(found, landmark=spot)
                yield replace(said, adjuncts=(by, where), span=p.span(i, k)), k


def _commanded(p: Parser, i: int) -> Results[str]:
    """ "stack each colour separately", "sort the colours into towers", "keep the colours apart"."""
    for lead, verb in ((_STACK, "stack"), (_SORT, "sort"), (_PUT, "")):
        k = p.any_of(i, lead)
        for j in {*_COLORS.matches(p, k), *(_PLURAL.matches(p, k) if verb else ())} if k else ():
            yield from _parted(p, j)
            for end in (j, *_SEPARATELY.matches(p, j)):
                if verb == "stack" or (verb and p.words[k:j][-1:] == ["colors"]):
                    yield verb, end
            if not verb or verb == "sort":
                yield from (("sort", end) for end in _TOGETHER.matches(p, j))


def _parted(p: Parser, j: int) -> Results[str]:
    """ "into a tower of its own", "in separate groups"."""
    yield from (("stack", end) for end in _TOWERS.matches(p, j))
    yield from (("sort", end) for end in _GROUPS.matches(p, j))


def _on_patches(p: Parser, i: int) -> Results[Clause]:
    """ "each colour goes on its own patch", "match each cube with the mat of its colour"."""
    for j in _COLORS.matches(p, i):
        theme = Noun(head="block", det="all", plural=True, span=p.span(i, j))
        for k in (j, *_GOES.matches(p, j)):
            yield from _matched(p, i, p.any_of(k, ("on", "onto", "to", "in", "into", "gets", "has")), theme)
    put = p.any_of(i, _PLACE)
    for j in _COLORS.matches(p, put) if put else ():
        theme = Noun(head="block", det="all", plural=True, span=p.span(put, j))
        yield from _matched(p, i, p.any_of(j, ("on", "onto", "to")), theme)
    match = p.any_of(i, ("match", "pair", "pair up", "match up"))
    for blocks, j in simple(p, match) if match else ():
        if isinstance(blocks, Noun) and blocks.head == "block" and (blocks.plural or blocks.det == "each"):
            yield from _matched(p, i, p.any_of(j, ("with", "to", "and", "onto", "up with")), replace(blocks, det="all"))


def _matched(p: Parser, i: int, j: int, blocks: Noun) -> Results[Clause]:
    """Blocks on the patches of their colours, said of a phrase for patches at `j`."""
    for patch, k in simple(p, j) if j else ():
        end = p.any_of(k, _BY_COLOR)
        if not isinstance(patch, Noun) or patch.head != "patch" or patch.traits.colors:
            continue
        if end or patch.traits.matching or _own(patch):
            marks = Traits(matching=True, shape=patch.traits.shape)
            spot = replace(patch, det="the", amount=None, plural=True, traits=marks, cost=0)
            on = Loc(rel="on", landmark=spot, span=p.span(j, k))
            them = replace(blocks, plural=True, amount=blocks.amount if blocks.plural else None)
            yield Clause(verb="be", theme=them, adjuncts=(on,), mode="goal", span=p.span(i, end or k)), end or k


def _own(patch: Noun) -> bool:
    """ "its own patch", "a patch of its own", "the patch of that colour"."""
    return patch.det == "its" or patch.traits.scheme in ("different", THEIRS)


_BY_COLOR = ("by color", "by their color", "by colors", "according to color", "according to their color", "in color")


def _stated(p: Parser, i: int) -> Results[str]:
    """ "each colour gets its own tower", "every colour in a group of its own", "same colours are stacked"."""
    for j in _COLORS.matches(p, i):
        yield from (("stack", end) for told in (_GETS, _STACKED) for end in told.matches(p, j))
        yield from (("sort", end) for told in (_GROUPED, _LIES) for end in told.matches(p, j))
        for k in (j, *_GOES.matches(p, j), *_STACKED.matches(p, j)):
            yield from _parted(p, k)
            yield from (("sort", end) for end in _TOGETHER.matches(p, k) if k > j)
        yield from (("sort", end) for end in _TOGETHER.matches(p, j))


def _one_for_each(p: Parser, i: int) -> Results[str]:
    """ "for each colour build a tower", "make one tower out of each colour", "one group per colour"."""
    for start in (i, *_MAKE.matches(p, i)):
        for k in _ONE.matches(p, start):
            for noun, verb in ((_TOWER, "stack"), (_GROUP, "sort")):
                if j := p.any_of(k, noun):
                    ends = _FOR_EACH.matches(p, j)
                    yield from ((verb, last) for end in ends for last in (end, *_ALL_OF_IT.matches(p, end)))
    if p.words[i] == "for":
        for j in _FOR_EACH.matches(p, i):
            for start in _MAKE.matches(p, p.opt(j, ",")):
                for k in _ONE.matches(p, start):
                    yield from ((verb, end) for noun, verb in ((_TOWER, "stack"), (_GROUP, "sort"))
                                for end in {p.any_of(k, noun)} - {0})  # fmt: skip


_TOWER = ("tower", "stack")
_GROUP = ("group", "cluster", "bunch")
