"""Blocks told by what they are not: "all the blocks that are not red", "every block without a letter"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.adjectives import color
from rpg.language.meaning import Coord, Noun, Traits, replace

_ARE_NOT = ("that are not", "which are not", "that is not", "which is not")
_SHOW_NO = (
    "without",
    "with no",
    *(f"{that} {show} no" for that in ("that", "which") for show in ("have", "has", "show", "shows", "bear", "bears")),
)
_KINDS = {"letter": "letter", "letters": "letter", "number": "digit", "numbers": "digit", "digit": "digit",
          "digits": "digit"}  # fmt: skip


def not_so(p: Parser, i: int, whole: Noun, j: int) -> Results[Coord | Noun]:
    """The noun from i on, which ends before j, without those that look as it is told behind it."""
    for marks, end in _looks(p, j):
        out = Noun(head="block", det="all", plural=True, traits=marks, span=p.span(j, end))
        every = replace(whole, det="all", plural=whole.det != "the" or whole.plural)  # "the one that is not red": one
        others = Coord(op="besides", items=(every, out), span=p.span(i, end))
        if whole.det == "no":
            yield Noun(head="block", det="no", plural=True, part_of=others, span=others.span), end
        else:
            yield others, end


def _looks(p: Parser, j: int) -> Results[Traits]:
    """ "that are not red", "that is not a letter", "without letters on them"."""
    k, shown = p.any_of(j, _ARE_NOT), p.any_of(j, _SHOW_NO)
    for named, end in color(p, k) if k else ():
        yield from _nor(p, Traits(colors=(named,)), end)
        yield Traits(colors=(named,)), end
    at = p.opt(k or shown, "a", "an", "any") if k or shown else 0
    if at and p.words[at] in _KINDS:
        end = p.any_of(at + 1, ("on them", "on it")) if shown else p.opt(at + 1, "block", "blocks", "cube", "cubes")
        yield Traits(kind=_KINDS[p.words[at]]), end or at + 1


def _nor(p: Parser, first: Traits, j: int) -> Results[Traits]:
    """ "(that are not red) and not blue (and not green)"."""
    k = p.any_of(j, ("and not",))
    for named, end in color(p, k) if k else ():
        both = replace(first, colors=(*first.colors, named), either=True)
        yield from _nor(p, both, end)
        yield both, end
