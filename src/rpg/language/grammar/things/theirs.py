"""Patches told by the colours of the blocks: "mats in both colours", "a patch for each of them", "mats to match"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import Marks
from rpg.language.grammar.things.patch_sides import side_behind
from rpg.language.meaning import Amount, Noun

THEIRS = "theirs"
"""The scheme of patches of which there is one in every colour of the blocks."""
_COLORS = Patterns(
    "in|of|for|with both|these|those|the_same|all_these|all_of_these|all_those|each_of_these|each_of_those|each_of_the|"
    "both_of_these|each_of_the_same|each_of_those_same|all_the_same|the|identical|these_two|these_three|these_same "
    "colors",
    "in|of|for|per each|every|either? color",
    "to match the_blocks|the_cubes|them|in_color|their_color|their_colors?",
    "for each_of_them|each_one|each_block|each_cube|every_block|every_cube|every_one_of_them|each_of_the_blocks|"
    "each_of_the_cubes|each|all_of_them of|in|with|having the_same|its|its_own|that|the_matching|matching? color?",
    "in the_color|the_same_color|the_colors of each_of_them|each_one|each_block|each_cube|the_blocks|the_cubes|them",
    "in|of matching colors",
    "that|which match them|the_blocks|the_cubes|their_color|their_colors",
)


@choice
def in_their_colors(p: Parser, j: int) -> Results[Marks]:
    """What follows a patch and tells its colour by those of the blocks."""
    if not p.anywhere(_WORDS):
        return
    for k in _COLORS.matches(p, j):
        if p.words[k - 1] in _WORDS:
            yield Marks({"scheme": THEIRS}), k


_WORDS = frozenset({"color", "colors", "match", "each", "them", "block", "cube", "blocks", "cubes", "one"})


def of_patch(p: Parser, j: int) -> Results[Mapping[str, Any]]:
    """What may tell a patch behind the noun: "the mats of their colours", "the mat on the left"."""
    yield from in_their_colors(p, j)
    yield from side_behind(p, j)


def as_many_colors(p: Parser, j: int, noun: Noun) -> int:
    """The position after "of five different colours" behind five blocks."""
    of = p.one(j, ("of", "in", "with"))
    many = p.number(of) if of else None
    if many is None or noun.amount is None or noun.amount != Amount(many, many, noun.amount.strict) or many < 2:
        return 0
    return p.any_of(of + 1, ("different colors", "distinct colors", "colors", "unique colors", "separate colors"))
