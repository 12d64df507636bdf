"""Several corners of the table, one after another: "red in the far left corner and blue in the near right"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.regions import EACH_CORNER, EVERY_CORNER, of_table
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Chain, Clause, In, Meaning, Noun, Pronoun, Structure, That, replace

Told = tuple[Meaning, str]
_CORNER = frozenset({"corner", "corners"})
_DEPTHS = {"near": "near", "front": "near", "far": "far", "back": "far", "rear": "far", "top": "far", "bottom": "near",
           "upper": "far", "lower": "near"}  # fmt: skip
_WIDTHS = {"left": "left", "right": "right"}
_COMMANDS = ("put", "place", "set", "have", "move", "i want", "we want", "i would like", "bring", "there is")
_AT = (
    "goes in the", "goes to the", "goes into the", "is in the", "should be in the", "must be in the", "lies in the",
    "in the", "at the", "into the", "to the", "on the", "goes", ":", "=", ",", "is", "sits in the", "stands in the",
)  # fmt: skip
_HOLDS = ("has", "gets", "holds", "contains", "takes", "is for", "should have", "must have", "should hold", "must hold",
          "is", ":", "=", "there is", "belongs to", "should get", "must contain", "should contain")  # fmt: skip
_HOLD = ("have", "get", "hold", "contain", "take", "should have", "must have", "should hold", "must hold", "should get",
         "must get", "are for", "must contain", "should contain")  # fmt: skip
_JOINT = (", and", "and", ",", "; and", ";", ", then")
_ONE = ("one block", "a block", "one cube", "a cube", "one", "one brick", "exactly one block", "exactly one cube")
_HEADS = ("corners", "the corners", "the four corners", "four corners", "in the corners", "in the four corners")
_ALL = 4


@rule
def cornered(p: Parser, i: int) -> Results[Clause]:
    """What lies in which corner; the word itself is said once."""
    if not p.anywhere(_CORNER):
        return
    start = p.any_of(i, _COMMANDS) or i
    yield from _every(p, i, start)
    one = p.any_of(start, _ONE)
    each = p.any_of(one or start, EACH_CORNER) if one or p.stands(start, ("per", "one", "in")) else 0
    heading = each and (of_table(p, each) or each)
    heading = heading or (p.any_of(start, _HEADS) if start == i else 0)
    colon = p.one(heading, (":", ",", "-")) if heading else 0
    for told, j in _list(p, colon or start, ()) if colon or not heading else ():
        least = _ALL if colon else 2
        if p.all.isdisjoint(_CORNER) or not least <= len({region for _, region in told}) == len(told):
            continue
        clauses = tuple(
            Clause(verb="build" if isinstance(theme, Structure) else "be", theme=theme, mode="goal", span=theme.span,
                   adjuncts=(In(region=region, vague=True, span=theme.span),))
            for theme, region in told
        )  # fmt: skip
        rest = Chain(clauses=clauses[1:], links=("and",) * (len(clauses) - 1), span=p.span(i, j))
        so = That(kind="so", clauses=rest, span=rest.span)
        yield replace(clauses[0], adjuncts=(*clauses[0].adjuncts, so), span=p.span(i, j)), j


def _every(p: Parser, i: int, start: int) -> Results[Clause]:
    """ "each corner has one white block", "all corners get a block each"."""
    corners = p.any_of(start, EVERY_CORNER)
    table = of_table(p, corners) if corners else 0
    holds = p.any_of(table or corners, _HOLDS) if corners else 0
    several = p.any_of(table or corners, _HOLD) if corners else 0
    for theme, j in simple(p, holds or several) if holds or several else ():
        if isinstance(theme, Noun) and theme.head != "patch" and (holds or not theme.plural):
            j = p.opt(j, "each", "apiece") if several else j
            place = In(region="each_corner" if table else "each_corner?", span=p.span(i, holds or several))
            yield Clause(verb="be", theme=theme, adjuncts=(place,), mode="goal", span=p.span(i, j)), j


def _list(p: Parser, i: int, had: tuple[Told, ...]) -> Results[tuple[Told, ...]]:
    if len(had) >= _ALL:
        return
    for one, j in _item(p, i):
        yield (*had, one), j
        if k := p.any_of(j, _JOINT):
            yield from _list(p, k, (*had, one))


def _item(p: Parser, i: int) -> Results[Told]:
    """ "red (in the) far left (corner)", "the far left corner gets the red block"."""
    lead = p.any_of(i, ("in the", "at the", "the", "in", "at")) or i
    for region, j in _corner(p, lead):
        for theme, k in simple(p, p.any_of(j, _HOLDS) or j):
            if _placeable(theme):
                yield (theme, region), k
    for theme, j in simple(p, i):
        if _placeable(theme):
            yield from (((theme, region), k) for region, k in _corner(p, p.any_of(j, _AT) or j))


def _placeable(theme: Meaning) -> bool:
    plain = isinstance(theme, Noun) and theme.head != "patch" and bool(theme.traits.colors or theme.traits.labels)
    return plain or isinstance(theme, Structure) or (isinstance(theme, Pronoun) and theme.word == "it")


def _corner(p: Parser, i: int) -> Results[str]:
    """ "far left", "left front corner", "near right one"."""
    for one, other in ((_DEPTHS, _WIDTHS), (_WIDTHS, _DEPTHS)):
        first = p.peek(i, one)
        second = p.peek(i + 1, other) if first else None
        if first and second:
            depth, width = (first, second) if other is _WIDTHS else (second, first)
            j = p.opt(p.reach(i + 2), "corner", "one")
            yield f"{depth}_{width}_corner", of_table(p, j) or j
