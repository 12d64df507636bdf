"""Words for blocks that are only there: "as distractors on the table", "that play no role", "just to distract"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.adjectives import Marks, colors
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.wishes import Patterns
from rpg.language.meaning import Absolute, Coord, Meaning, Noun, Size, Using

_ROLES = "distractor|distractors|distraction|distractions|decoration|decorations|decoy|decoys"
_SPOTS = "somewhere|anywhere|on_the_table|on_it|in_the_scene|around|nearby|somewhere_on_the_table|by|there|about|aside"
_THIS = "it|this|that|the_task|this_task|the_tower|the_row|the_structure|the_goal|the_game|the_puzzle|the_job"

AS_EXTRAS = Patterns(
    "present|lying|standing|sitting|placed|as_well|too? there|around|present|lying_around|lying_about|standing_around|"
    "standing_by|on_the_table|somewhere|somewhere_on_the_table|nearby|in_the_scene|by|on_the_side|to_the_side? ,? "
    f"just|only|merely|simply|purely? as|for|to_serve_as|serving_as|acting_as|to_act_as a|an|some|mere|pure? {_ROLES} "
    f"{_SPOTS}?",
    "there|around|present|lying_around|on_the_table? ,? just|only|merely|simply|purely|solely? to "
    "distract|confuse|mislead you|us|the_robot|from_it|from_the_task?",
)
"""Behind blocks, or behind what is said of where they are."""
THAT_EXTRAS = Patterns(
    "play|plays no role|part here|in_this|in_it|at_all?",
    f"have|has nothing to_do with {_THIS}",
    f"are|is not|no part of {_THIS}",
    "can|should|must|may|are_to|is_to|has_to|have_to be ignored|disregarded|left_out|left_aside|left_unused",
    "you|we|i|the_robot|one do|does|should|must|need|needs|may|can not need|use|care_about|have_to_use|need_to_use|"
    "to_use here|for_this|at_all?",
    "nobody|no_one needs|uses",
    "just|only|merely|simply are|is|lie|lies|stand|stands|sit|sits around|there|about|by|lying_around|standing_around",
    "are|is|lie|lies|stand|stands|sit|sits just|only|merely|simply around|there|about|by|lying_around|standing_around|"
    "lying_there|for_show|in_the_way|along_for_the_ride",
    "only|just|merely? distract|distracts|confuse|confuses",
    "are|is there|around|present|on_the_table? only|just|merely|simply to distract|confuse|mislead you|us|the_robot?",
)
"""What is said of such blocks."""


def all_extra(meaning: Meaning) -> bool:
    """Whether a phrase speaks of distractors alone."""
    if isinstance(meaning, Coord):
        return meaning.op == "and" and all(map(all_extra, meaning.items))
    return isinstance(meaning, Noun) and meaning.traits.extra


def leads(p: Parser, j: int, first: Meaning) -> bool:
    """Whether an adjunct may stand before its clause, which begins at `j`: it says nothing of parts, and takes no noun
    from it ("with three brown | cubes on the table")."""
    if isinstance(first, Using):
        return not p.stands(j, lexicon.BLOCK)
    if isinstance(first, Absolute):
        return all_extra(first.theme)
    return not isinstance(first, Size) and not (isinstance(first, Coord) and first.op == "absolutes")


@choice
def further_extras(p: Parser, j: int, noun: Noun) -> Results[Marks]:
    """Behind distractors: "in other colours", which are open anyway; ": green and white", which tells them."""
    if not noun.traits.extra or noun.traits.colors or noun.traits.labels:
        return
    if k := p.any_of(j, _OTHERWISE):
        yield Marks(), k
    opened = p.one(j, frozenset({":", ",", "("})) or j
    for (listed, either), k in colors(p, p.opt(opened, "namely", "one")) if opened > j else ():
        closed = p.one(k, ")") if p.words[j] == "(" else k
        many = noun.amount.low if noun.amount is not None else len(listed) if noun.plural else 1
        if closed and not either and many == len(listed) and (p.words[j] == "(" or k >= p.end):
            yield Marks({"colors": listed}), closed


_OTHERWISE = tuple(
    f"{of}{other} {color}"
    for of in ("in ", "of ", "with ", "in a ", "of a ", "with a ", "in some ", "of some ")
    for other in ("other", "any other", "another", "different", "some other", "random", "arbitrary")
    for color in ("color", "colors")
)
