"""The things of which it is "each", named one by one: "each of the red cube and the blue cube", "each of A and B"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.joined import more
from rpg.language.later import later
from rpg.language.meaning import Coord, Meaning, Noun, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")


def listed(p: Parser, i: int, det: str) -> Results[Noun]:
    """Several named blocks as the ones that they are together, where "each" of them, both or none is meant."""
    if det not in ("each", "both", "no", "any", "all"):
        return
    for first, j in simple(p, i):
        if isinstance(first, Noun) and _bare(first) and _several(first) and not _goes_on(p, j):
            yield replace(first, det="the", plural=True, cost=0), j
        for found, end in more(p, i, (first,), j, None) if _named(first) else ():
            whole = _together(found) if isinstance(found, Coord) and found.op == "and" else None
            if whole is not None and not _goes_on(p, end):
                yield whole, end


def _goes_on(p: Parser, j: int) -> bool:
    """Whether more is listed: "each of the red, green and blue cubes" are not the first two of them."""
    at = p.opt(p.opt(j, ","), "and")
    return at > j and (p.words[at] in lexicon.COLOR or p.words[at] == "the" or len(p.words[at]) == 1)


def _bare(noun: Noun) -> bool:
    """ "A and B", "red and blue": by these alone."""
    return noun.det == "bare" and noun.amount is None and noun.head == "any" and noun.part_of is None


def _several(noun: Noun) -> bool:
    return len(noun.traits.labels + noun.traits.colors) > 1


def _named(item: Meaning) -> bool:
    """One block by its colour or by its label, and by nothing else."""
    if not isinstance(item, Noun) or item.plural or item.amount is not None or item.part_of or item.conditions:
        return False
    marks = item.traits
    told = replace(marks, colors=(), labels=()) == Traits() and len(marks.colors + marks.labels) == 1
    return told and item.det in ("the", "bare")


def _together(found: Coord) -> Noun | None:
    items = [item for item in found.items if isinstance(item, Noun) and _named(item)]
    heads = {item.head for item in items} - {"any"}
    colors = tuple(color for item in items for color in item.traits.colors)
    labels = tuple(label for item in items for label in item.traits.labels)
    if len(items) < len(found.items) or len(heads) > 1 or (colors and labels):
        return None
    if len({*colors, *labels}) < len(items):
        return None
    marks = Traits(colors=colors, labels=labels)
    return Noun(head=heads.pop() if heads else "any", det="the", plural=True, traits=marks, span=found.span)
