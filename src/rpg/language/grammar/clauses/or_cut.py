""" "Put A on B or C and D near both": what stands behind "or" is one more that the clause before may be of."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, replace

_OF_TWO = ("both", "both of them", "neither of them")


def cut_by_or(p: Parser, j: int, before: Clause, item: Meaning) -> Meaning | None:
    """ "(A on B or) C and D near both": no clause of its own, for C is one of the two; "(A on B or) C and D on E": as
    likely as that C is what A may be on."""
    theme = item.theme if isinstance(item, Clause) else None
    if not isinstance(item, Clause) or theme is None or theme.span[0] != p.char(j, 0) or not _listed(p, theme):
        return item
    if p.words[j - 2] == ",":
        return item
    last = before.adjuncts[-1] if before.adjuncts else None
    mark = last.landmark if isinstance(last, Loc) else None
    if not isinstance(mark, Noun) or mark.head == "patch" or mark.plural or mark.span[1] != before.span[1]:
        return item
    if any(_of_two(a.landmark) for a in item.adjuncts if isinstance(a, Loc)):
        return None
    return replace(item, cost=item.cost + 1) if isinstance(theme, Noun) else item


def _listed(p: Parser, theme: Meaning) -> bool:
    """Whether blocks are told one by one: "C and D"."""
    told = isinstance(theme, Coord) or (isinstance(theme, Noun) and len(theme.traits.labels) > 1)
    begin, end = theme.span
    return told and any(t.word == "and" and begin < t.span[0] < end for t in p.tokens)


def _of_two(mark: Meaning | None) -> bool:
    """Whether this is both of two that were told before, or neither of them."""
    if isinstance(mark, Noun):
        return mark.det in ("both", "no") and mark.head == "any" and not (mark.traits.colors or mark.traits.labels)
    return isinstance(mark, Pronoun) and mark.word in _OF_TWO
