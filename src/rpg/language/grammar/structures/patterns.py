"""Patterns and spacing: "each row a different colour", "evenly spaced"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import colors
from rpg.language.meaning import Meaning, Pattern, Spacing
from rpg.language.phrases import Classes

_UNITS = {"row": "row", "column": "column", "layer": "layer", "level": "layer", "stack": "stack", "tower": "stack",
    "pile": "pile", "group": "pile",
          "floor": "layer", "line": "row", "bunch": "pile", "tier": "layer", "rows": "row", "columns": "column",
          "layers": "layer", "stacks": "stack",
          "towers": "stack", "piles": "pile", "groups": "pile"}  # fmt: skip


_SAME = ("the same color", "of the same color", "one color", "a single color", "of one color", "a color",
    "of a single color", "single colored", "same colored",
         "of the same colour", "the same colour", "one colour", "a single colour", "in one color",
         "in a single color", "uniform in color", "all one color",
         "the same color throughout", "all the same color", "one solid color", "blocks of the same color",
         "blocks of one color", "only one color",
         "blocks of a single color", "same color", "blocks of only one color")  # fmt: skip


_DIFFERENT = ("a different color", "of a different color", "its own color", "a unique color", "a distinct color",
    "different colors", "in a different color",
              "different in color", "of different colors", "a different colour", "of a different colour",
              "its own colour", "in its own color",
              "a unique colour", "differently colored", "of its own color", "a separate color",
              "different color", "own color", "a color of its own", "one color of its own")  # fmt: skip


_ONE_FOR_EACH = {
    f"{one} {noun} {each}": unit
    for one in ("one", "a")
    for noun, unit in (
        ("tower", "stack"), ("stack", "stack"), ("group", "pile"), ("pile", "pile"), ("bunch", "pile"),
        ("heap", "pile"), ("cluster", "pile"),
    )
    for each in ("per color", "for each color", "for every color", "of each color", "for each", "each", "for each one")
}  # fmt: skip
"""What is said of blocks that are stacked or grouped by colour: one tower, one group for each of them."""


_PER = {
    "one color per row": "row", "one color per column": "column", "one color per layer": "layer",
    "a different color per row": "row", "one color for each row": "row", "one color for each layer": "layer",
    "one color for each column": "column", "a different color for each row": "row",
    "a different color for each column": "column", "a different color per layer": "layer",
    "a different color for each layer": "layer", "a different color for every row": "row",
    "a different color in each row": "row", "a different color in each layer": "layer",
    "a different color per column": "column", "one color per level": "layer",
    "a different color for every layer": "layer", "a different color for every column": "column",
    "one color per stack": "stack", "one color per tower": "stack", "one color per pile": "pile",
    "one color each": "stack", "a single color per row": "row",
}  # fmt: skip
"""What is said of every line, layer or stack."""


@rule
def pattern(p: Parser, i: int) -> Results[Meaning]:
    """ "where each row is a different colour", "one colour per layer", "in a checkerboard pattern"."""
    j = p.any_of(i, ("where", "with", "such that", "so that", "in which", ", where", ", with", "so", "whose")) or i
    j2 = p.any_of(j, ("each", "every", "all", "each of the", "all the")) or (j if p.follows(j, ("whose",)) else 0)
    if j2 and p.stands(j2, _UNITS):
        k = p.reach(j2 + 1)
        unit = _UNITS[p.words[j2]]
        k = p.any_of(k, ("of blocks", "of cubes")) or k
        k = p.any_of(k, ("is made of", "should be", "must be", "consists of", "contains", "should have", "is",
            "being", "has", "having", "in", "are", "be", "made of",
                         "containing", "made up of", "uses", "using", "with", "have", "of")) or k  # fmt: skip
        yield from agree(p, i, k, unit)
    for phrase, k in p.standing(j, _PER):
        yield Pattern(unit=_PER[phrase], span=p.span(i, k)), k
    for phrase, k in p.standing(p.opt(i, ","), _ONE_FOR_EACH):
        if k >= p.end or p.words[k] in (":", ",", ";", "and", "with"):
            yield Pattern(unit=_ONE_FOR_EACH[phrase], span=p.span(i, k)), k
    yield from _checkered(p, i)
    if k := p.any_of(i, ("one per color", "one for each color", "one tower per color", "one stack per color",
        "one tower for each color", "one stack for each color",
                         "one of each color", "one pile per color", "one per colour", "one row per color",
                         "each of a different color", "each in a different color",
                         "each a different color", "each of one color", "each of a single color", "each one color",
                         "each the same color", "each a single color",
                         "each with its own color", "each in its own color", "each in one color",
                         "each of its own color")):  # fmt: skip
        yield Pattern(unit="stack", span=p.span(i, k)), k


_CHECKERED = (
    *(
        f"{lead} {board} {tail}"
        for board in ("checkerboard", "chessboard", "checkered", "checker", "chess", "chess board", "checker board")
        for lead, tail in (("in a", "pattern"), ("with a", "pattern"), ("as a", "pattern"), ("in", "style"),
                           ("in", "fashion"), ("like a", "pattern"))
    ),
    *(
        f"{looks} {board}"
        for looks in ("so that it looks like a", "looking like a", "that looks like a", "so it looks like a",
                      "such that it looks like a", "so that they look like a", "resembling a")
        for board in ("checkerboard", "chessboard", "chess board")
    ),
    *(
        f"{like} {board}"
        for board in ("checkerboard", "chessboard", "chess board", "checker board")
        for like in ("like a", "as a", "as on a", "like on a", "as in a", "like in a", "just like on a",
                     "the way they do on a", "as they do on a", "after the manner of a", "in the manner of a",
                     "in the style of a", "like the squares of a", "like the squares on a", "like the fields of a",
                     "like the cells of a", "so that you get a", "so that it makes a", "so that they make a",
                     "so that they form a", "so that it becomes a")
    ),
    "checkerboard style", "checkered",
    *(f", {board}{tail}" for board in ("checkerboard", "chessboard") for tail in ("", " pattern", " style")),
)  # fmt: skip


DIAGONALS = frozenset({"diagonal", "diagonally", "diagonals", "opposite"})
_SO = ",|:? where|with|so_that|such_that|in_which|and?"
_ON_DIAGONAL = (
    "is|are|being|sit|lie|stand? on_a|on_one|on_the? diagonal|diagonally|diagonals "
    "to|from|opposite|across_from? each_other?"
)
_DIAGONAL = Patterns(
    f"{_SO} the? same|equal|like colors|blocks|cubes|ones {_ON_DIAGONAL}",
    f"{_SO} the? blocks|cubes|ones of_the_same_color|of_equal_color|of_one_color|of_each_color {_ON_DIAGONAL}",
    f"{_SO} each|every color on|along|in a|one|its_own diagonal",
    f"{_SO} opposite|diagonal corners have|having|in|of|are? the same color",
    ",|:? with? both? colors on the diagonals",
)
"""Four blocks of two colours, which makes a checkerboard of two by two."""


@choice
def _checkered(p: Parser, i: int) -> Results[Meaning]:
    """ "in a checkerboard pattern (of red and blue)"."""
    if p.rarely(DIAGONALS) and (j := max(_DIAGONAL.matches(p, i), default=0)):
        yield Pattern(unit="diagonal", span=p.span(i, j)), j
    if j := p.any_of(i, _CHECKERED):
        yield Pattern(unit="checkerboard", span=p.span(i, j)), j
        of = p.any_of(p.opt(j, ","), ("of", "in", "with", "using"))
        for (named, either), k in colors(p, of) if of else ():
            if len(named) == 2 and not either:
                yield Pattern(unit="checkerboard", values=named, span=p.span(i, k)), k


def agree(p: Parser, i: int, k: int, unit: str) -> Results[Meaning]:
    for phrases, different in ((_SAME, False), (_DIFFERENT, True)):
        for _, e in p.standing(k, phrases):
            e = p.opt(e, "each")
            yield Pattern(unit=unit, different=different, span=p.span(i, e)), e


_GAPLESS = Patterns(
    "with|having|leaving|there_being? no|zero|not_any <gap> <between>* at_all|whatsoever?",
    "without a|any? <gap> <between>* at_all|whatsoever?",
    "so|such|so_that|such_that|in_such_a_way_that|and? there is|are|must_be|should_be|shall_be|will_be|may_be|can_be|"
    "has_to_be|have_to_be|remains|remain no <gap> <between>* at_all|whatsoever?",
    ",? tight|tightly|snug|snugly",
    ",? so tight|close that they touch each_other?",
    "flush|packed|pressed|pushed tightly|closely|densely? together",
    "tightly|closely|densely packed|pressed together?",
    "touching each_other",
    "side_by_side and touching",
    "so_that|such_that|so|with|and? each|every one|block|cube|box|brick? touching|touches <next>",
    classes=Classes(
        {
            "between": (
                "left|remaining|visible|allowed|anywhere",
                "in_between|inbetween",
                "between|among them|each_other|one_another|two_of_them|any_two|any_two_of_them|any_of_them",
                "between|among the? neighbors|neighboring_ones",
                "between|among all? the|any|any_two|neighboring|its|their? blocks|cubes|bricks|ones|members|letters",
            ),
            "gap": ("gap|gaps|space|spaces|spacing|holes|hole|empty_space|free_space|air|free_room",),
            "next": (
                "the|its|their? next|neighbor|neighbors|neighboring|adjacent|following|other? "
                "one|block|cube|box|brick?",
            ),
        }
    ),
)
"""No gaps along a line."""
_TOUCH = Patterns(
    "where|so|so_that|such_that|with|in_which|and|while|, all|each|every|their|both? of_them? the? "
    "block|blocks|cube|cubes|box|boxes|brick|bricks|they|one|faces? all|each|both|must|should|just|directly? "
    "touch|touches|touching both|all? their|its|the|each|a? direct|immediate|respective? both? "
    "next|neighbor|neighbors|other_one|next_one|next_block|neighboring_block|neighboring_blocks|adjacent_block|"
    "adjacent_blocks|neighboring_cube|neighboring_cubes|next_cube|one_beside_it|one_next_to_it|ones_beside_it",
    "so|so_that|such_that|with|where|and|, the|all? neighbors|neighboring_blocks|neighboring_cubes|adjacent_blocks|"
    "adjacent_cubes all|just|must|should? touch|touching each_other|one_another?",
    "that|which|who all|both? touch each_other|one_another|their_neighbors",
    ",? with? the|their? faces|sides|cubes|blocks touching",
    ",? touching cubes|blocks|bricks",
)
"""The same, by what touches what."""


_EQUAL_GAPS = Patterns(
    "with|leaving|keeping|having|leave|let|keep|have|and_leave|and_let|and_keep|and_have the|an|always? "
    "same|equal|even|identical|regular gap|gaps|space|spaces|distance|distances|spacing|room "
    "in_between|between_them|between_the_blocks|between_the_cubes|between_the_letters|between_letters|"
    "between_the_digits|between_each_other|between_all_of_them|"
    "between_neighbors|between_the_neighbors|between_each_block|between_each_cube|between_each_of_them?",
    ",? each|every_one|all_of_them at? the|an same|equal distance from|to|apart_from "
    "the_next|the_next_one|its_neighbor|its_neighbors|the_one_before|the_others",
)


@rule
def spacing(p: Parser, i: int) -> Results[Meaning]:
    """ "evenly spaced", "with equal gaps"."""
    if j := max(_TOUCH.matches(p, i), default=0):
        yield Spacing(kind="touching", span=p.span(i, j)), j
    if j := max(_EQUAL_GAPS.matches(p, i), default=0):
        yield Spacing(kind="even", span=p.span(i, j)), j
    if j := p.any_of(i, ("evenly spaced", "equally spaced", "evenly spaced out", "with equal spacing",
        "with even spacing", "spaced evenly", "evenly", "with equal gaps",
                         "spaced equally", "with equal space between them", "at equal distances",
                         "with equal distances between them", "uniformly spaced",
                         "with equal gaps between them", "at even intervals", "at equal intervals",
                         "evenly distributed", "with even gaps", "evenly apart",
                         "with equal distance between them", "equally far apart", "with uniform spacing")):  # fmt: skip
        yield Spacing(kind="even", span=p.span(i, j)), j
    if j := max(_GAPLESS.matches(p, i), default=0):
        yield Spacing(kind="touching", span=p.span(i, j)), j
