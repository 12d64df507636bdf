"""Outlines: what makes a figure one, and the blocks along its sides: "three red blocks along each side"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import color
from rpg.language.meaning import Size, Structure, replace

_BLOCKS = "blocks|cubes|bricks|ones|of_them? long?"
_SHARED = (
    ",|(|and? with|where|counting|include|including|sharing? the? corners|corner_blocks|corner_cubes are|being? "
    "shared|counted|include|included|counted_twice|belonging_to_both|belong_to_both? )?"
)
A_SIDE = Patterns(
    f"{_BLOCKS} per|a side|edge",
    f"{_BLOCKS} on|along|to|for|at|in|by a|each|every|each_of_the|each_of_its|all|all_its|all_the|all_four|all_three "
    "side|sides|edge|edges",
    f"{_BLOCKS} per|a side|edge {_SHARED}",
    f"{_BLOCKS} on|along|to|for|at|in|by a|each|every|each_of_the|each_of_its|all|all_its|all_the|all_four|all_three "
    f"side|sides|edge|edges {_SHARED}",
)
"""Of how many blocks a side of an outline is."""
_ON = "on|along|to|for|at|in the|each|every|both|its|a|each_of_the|both_of_the"
_LONG = Patterns(f"{_BLOCKS} {_ON} long|longer|longest|larger side|sides|edge|edges")
_SHORT = Patterns(f"{_BLOCKS} {_ON} short|shorter|shortest|smaller side|sides|edge|edges")
HOLLOW = Patterns(
    "with|but|leaving|keeping? nothing|no_block|no_blocks|no_cube|no_cubes in|inside|within the|its|it? "
    "middle|center|inside|interior?",
    "with|leaving|keeping? a|an empty|hollow|free|open middle|center|inside|interior",
    "with? a? hole in the|its middle|center|inside",
    "with|leaving|keeping|while|where? the|its middle|center|inside|interior is|stays|remains|being|left? "
    "empty|free|open|hollow",
    "with|leaving|keeping|where the|its middle|center|central cell|place|spot|position|field is|stays|remains|being? "
    "left? empty|free|open",
    "with the|its middle|center|central cell|place|spot|position|field|block|cube|one is? missing|left_out|omitted",
    "whose middle|center|inside|interior is|stays|remains left? empty|free|open|hollow",
    "without the|its|a middle|center|central block|cube|one",
    "around|surrounding|enclosing an|the empty|free|open middle|center|inside|interior|space",
    "around nothing",
    "that_is|which_is|it_is? left? hollow inside|within?",
    "that_is|which_is|it_is? left? empty|free|open inside|within",
    "hollow|empty|free|open in|at the|its middle|center|inside|interior",
    "in the|its middle|center|inside|interior it|that is|stays empty|hollow|free",
    "just|only|as? the|an|its? outline only?",
    "not filled",
)
"""What makes a figure an outline."""
_LEADS = ("with", ",", ", with", ":", "having", "that has", "which has", "and")
_AND = ("and", ", and", ",", "but", ", but")


def rim_of(p: Parser, i: int, j: int, base: Structure) -> Structure:
    """ "A 3x3 grid with the center empty", "a 3x3 ring": the rim of a square, but no grid that has a hole."""
    grid = base.kind == "grid" and "hole" not in p.words[i:j]
    return replace(base, kind="square") if base.dims == (3, 3) and (grid or base.kind == "circle") else base


def along_sides(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    """An outline with what is said of its sides."""
    for size, k in _long_and_short(p, j) if base.kind == "rectangle" else ():
        yield replace(base, sizes=(*base.sizes, size), filled=base.filled or False, span=p.span(i, k)), k
    plain = base.members is None and not base.traits.colors
    for (size, named), k in _colored(p, j) if plain and base.kind in _OUTLINED else ():
        painted = replace(base.traits, colors=(named,))
        yield replace(base, sizes=(*base.sizes, size), traits=painted, span=p.span(i, k)), k


_OUTLINED = ("square", "triangle")


def _long_and_short(p: Parser, i: int) -> Results[Size]:
    """ "(a rectangle,) four blocks along the long side and three along the short side": its extents."""
    start = p.any_of(i, _LEADS)
    for first, second in ((_LONG, _SHORT), (_SHORT, _LONG)) if start else ():
        for one, j in amounts.count(p, start):
            for k in first.matches(p, j):
                for other, m in amounts.count(p, both) if (both := p.any_of(k, _AND)) else ():
                    dims = (one, other) if first is _LONG else (other, one)
                    for end in second.matches(p, m) if dims[0] > dims[1] else ():
                        yield Size(what="dims", dims=dims, span=p.span(i, end)), end


def _colored(p: Parser, i: int) -> Results[tuple[Size, str]]:
    """ "(a square) with three red blocks along each side"."""
    start = p.any_of(i, _LEADS)
    for found, j in amounts.amount(p, start) if start else ():
        for named, k in color(p, j):
            for end in A_SIDE.matches(p, k):
                yield (Size(what="side", amount=found, span=p.span(i, end)), named), end
