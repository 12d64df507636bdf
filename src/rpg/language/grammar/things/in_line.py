"""Blocks told by where they stand in a line: "the second one from the left", "the one in the middle"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results
from rpg.language.later import later
from rpg.language.lexicon import BLOCK
from rpg.language.meaning import Noun, Structure, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.structures.structures import structure
    from rpg.language.grammar.things.at_places import brought_up
else:
    (brought_up,) = later(__name__, "rpg.language.grammar.things.at_places", "brought_up")
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")

_FROM = {f"from {the}{side}": way for way, sides in {
    "left": ("left",), "right": ("right",), "bottom": ("bottom",), "top": ("top",), "front": ("front", "near end"),
    "back": ("back", "far end"),
}.items() for side in sides for the in ("the ", "")}  # fmt: skip
_THERE = {
    **{f"in the {middle}": "middle" for middle in ("middle", "very middle", "center", "very center")},
    **{f"{at} the {side}": way
       for side, way in {"left end": "left", "right end": "right", "near end": "front", "far end": "back",
                         "front end": "front", "back end": "back", "very left": "left", "very right": "right",
                         "far left": "left", "far right": "right", "left": "left", "right": "right",
                         "very top": "top", "very bottom": "bottom", "top": "top", "bottom": "bottom"}.items()
       for at in ("at", "on")},
    "on top": "top",
}  # fmt: skip
_SEVERAL_THERE = {
    **_THERE,
    **{f"{at} {ends}": "outer" for ends in ("the ends", "the two ends", "both ends", "either end", "its ends")
       for at in ("at", "on")},
    "on the outside": "outer",
}  # fmt: skip
OF_LINE = ("of it", "of them", "of these", "of those", "of which", "of the row", "of the line", "of the column",
            "of that row", "in the row", "in the line", "of the word", "of this row",
            "of the letters", "of the blocks", "of the cubes")  # fmt: skip
_ENDS_THERE = frozenset({"of", "half", "side", "corner", "hand", "edge", "block", "cube", "one"})
_TOLD_SIDES = frozenset({"left", "right", "front", "back", "bottom", "top", "middle", "last"})


def in_line(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """The noun with its place in the line that was spoken of."""
    rank = noun.traits.rank
    if rank is not None and (rank in _UPRIGHT or rank.isdigit()) and (of := p.one(j, ("of", "in"))):
        for whole, end in structure(p, of) if noun.head != "patch" and noun.amount is None else ():
            known = isinstance(whole, Structure) and whole.kind == "stack" and whole.det == "the" and not whole.plural
            if known and (p.words[j] == "of" or getattr(whole, "members", None) is None):
                yield replace(noun, part_of=whole, span=p.span(i, end)), end
    if noun.plural and noun.amount is not None:
        yield from _several(p, i, j, noun)
    if noun.plural or noun.head == "patch" or noun.det not in ("the", "its"):
        return
    if rank is not None and noun.amount is None and (of := p.one(j, ("of", "in"))):
        for whole, end in brought_up(p, of):
            yield replace(noun, part_of=whole, span=p.span(i, end)), end
    if rank is None and noun.traits == Traits() and noun.amount is None and p.stands(j - 1, _ONE):
        for phrase, k in p.standing(j, _THERE):
            end = p.any_of(k, OF_LINE) or k
            if end > k or not p.stands(k, _ENDS_THERE):
                yield replace(noun, traits=Traits(rank=_THERE[phrase]), span=p.span(i, end)), end
    elif rank is not None and rank.isdigit():
        for phrase, k in p.standing(j, _FROM):
            end = p.any_of(k, OF_LINE) or k
            told = replace(noun, traits=replace(noun.traits, rank=f"{rank} {_FROM[phrase]}"), span=p.span(i, end))
            yield told, end
            for whole, last in brought_up(p, of) if (of := p.one(k, ("of", "in"))) else ():
                yield replace(told, part_of=whole, span=p.span(i, last)), last
    if rank is not None and (rank in _TOLD_SIDES or rank.isdigit()) and (end := p.any_of(j, OF_LINE)):
        yield replace(noun, span=p.span(i, end)), end


def _several(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "The two on the left", "the three blocks at the top", "the two at the ends": as many from there on."""
    plain = noun.det in ("the", "its") and noun.head != "patch" and noun.traits == Traits() and noun.part_of is None
    for phrase, k in p.standing(j, _SEVERAL_THERE) if plain and not noun.conditions else ():
        end = p.any_of(k, OF_LINE) or k
        if end > k or not p.stands(k, _ENDS_THERE):
            rank = Traits(rank=_SEVERAL_THERE[phrase])
            yield replace(noun, head="block", traits=rank, span=p.span(i, end)), end


_UPRIGHT = frozenset({"bottom", "top", "middle", "last"})


def unnamed_ends(p: Parser, j: int) -> tuple[str, ...]:
    """Places of a tower that say nothing without a noun, but in "the top and bottom blocks"."""
    k = p.one(j, "and")
    k = p.opt(k, "the") if k else 0
    two = k and p.stands(k, _UPRIGHT) and (p.stands(k + 1, ("one", "ones")) or p.lex(k + 1, BLOCK) is not None)
    return () if two else ("top", "bottom", "middle")


_ONE = frozenset({"one", "block", "cube", "brick", "letter", "digit"})
