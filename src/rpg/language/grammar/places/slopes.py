"""Lines from one corner of the table towards the opposite one: "diagonally", "from the near left to the far right".

A line from corner to corner would reach across all of the table: such lines are not told here.
"""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Toward

DIAGONAL = "diagonal"
"""The axis of a line that may lie along either of them."""
_BEGINS = {("front", "left"): "rising", ("back", "right"): "rising",
           ("back", "left"): "falling", ("front", "right"): "falling"}  # fmt: skip
"""Which of them begins there."""
_DEPTHS = {"near": "front", "front": "front", "bottom": "front", "lower": "front",
           "far": "back", "back": "back", "rear": "back", "top": "back", "upper": "back"}  # fmt: skip
_ACROSS = ("left", "right")
_ENDS = ("end", "side")
_OF_TABLE = ("of the table", "of it")
_RUNNING = Patterns("that|which? runs|goes|leads|running|going|leading|stretching|extending|reaching")
_ALONG = Patterns("diagonally across_the_table|on_the_table?", "along|on|in|into|as|across a diagonal of_the_table?")


def slope(p: Parser, i: int) -> Results[Toward]:
    """ "diagonally", "running from the far left to the near right"."""
    yield from ((Toward(axis=DIAGONAL, span=p.span(i, k)), k) for k in _ALONG.matches(p, i))
    for begin in (i, *_RUNNING.matches(p, i)):
        start, j = _corner(p, p.one(begin, "from"))
        end, k = _corner(p, p.one(j, ("to", "towards", "toward"))) if j else (None, 0)
        if start and end and k and start[0] != end[0] and start[1] != end[1]:
            k = p.any_of(k, _OF_TABLE) or k
            yield Toward(first=start[1], axis=_BEGINS[start], span=p.span(i, k)), k


def _corner(p: Parser, i: int) -> tuple[tuple[str, str] | None, int]:
    """ "the far left end"; a corner is where the line would have to end."""
    j = p.opt(i, "the") if i else 0
    for depth, across in ((j, j + 1), (j + 1, j)) if j else ():
        told = _DEPTHS.get(p.words[depth]), p.words[across]
        if told[0] and told[1] in _ACROSS:
            k = p.opt(p.reach(j + 2), *_ENDS)
            return (None, 0) if p.stands(k, ("corner",)) else ((told[0], told[1]), k)
    return None, 0
