"""Clauses of a list with "or" ahead of the last one, of which one is to be so: "A is on B, B is on C, or C is on D",
"red is on blue, on green, or on white"."""

from __future__ import annotations

from itertools import pairwise

from rpg.core.diagnostics import Diagnostic
from rpg.language.grammar.core import Parser
from rpg.language.meaning import Absolute, Chain, Clause, Coord, Loc, replace

_OR = ([",", "or"], ["or"])


def or_listed(p: Parser, chain: Chain) -> Chain | None:
    """The chain with "or" between all of them, where nothing but commas stands between those ahead of the last one;
    None where it is not clear whether one of all these is to be so, or of the last two."""
    clauses = [clause for clause in chain.clauses if isinstance(clause, Clause)]
    at = chain.links.index("or") if "or" in chain.links[1:] else 0
    if at == 0 or len(clauses) < len(chain.clauses):
        return chain
    told = [_between(p, one.span[1], two.span[0]) for one, two in pairwise(clauses)]
    if told[at - 1] not in _OR:
        return chain
    themes = [clause.theme and clause.theme.span for clause in clauses]
    ways = _in_ways(p, clauses[at - 1], clauses[at]) if themes[at] == themes[at - 1] else []
    if ways is None or _listed_inside(p, clauses[at - 1]):
        return None
    if ways and (beside := _beside_it(ways[0], [*ways[1:], clauses[at]])) is not None:
        return replace(chain, clauses=(*clauses[: at - 1], beside, *clauses[at + 1 :]),
                       links=(*chain.links[:at], *chain.links[at + 1 :]))  # fmt: skip
    if ways:
        links = (*chain.links[:at], *("or" for _ in ways[1:]), *chain.links[at:])
        return replace(chain, clauses=(*clauses[: at - 1], *ways, *clauses[at:]), links=links)
    begun = at - 1
    while begun > 0 and chain.links[begun] == "and" and told[begun - 1] == [","]:
        begun -= 1
    paired = at > 1 and told[at - 2] == ["and"] and told[at - 1] == [",", "or"]
    shared = len(set(themes[begun : at + 1])) == 1
    if not (begun < at - 1 or paired) or (themes[at] == themes[at - 1] and not shared):
        return chain  # "A on B, C on D or on E": what the last one leaves out is that of the one before it
    if paired or (told[at - 1] == ["or"] and not shared and not p.stands(0, ("either",))):
        return None
    return replace(chain, links=(*chain.links[: begun + 1], *("or" for _ in range(begun, at)), *chain.links[at + 1 :]))


def _in_ways(p: Parser, first: Clause, last: Clause) -> list[Clause] | None:
    """ "(Red is) on blue, on green(, or on white)": a clause for each place; none where it tells of one place."""
    verb = first.word[1] if first.word else first.theme.span[1] if first.theme else first.span[0]
    inside = _between(p, verb, first.span[1])
    if "," not in inside or not {"and", "but", "then"}.isdisjoint(inside):
        return []
    gaps = [_between(p, one.span[1], two.span[0]) for one, two in pairwise(first.adjuncts)]
    if not gaps or inside.count(",") > len(gaps) or any(gap != [","] for gap in gaps):
        return None
    return [replace(first, adjuncts=first.adjuncts[:1]), *(replace(last, adjuncts=(x,)) for x in first.adjuncts[1:])]


def _beside_it(first: Clause, sides: list[Clause]) -> Clause | None:
    """ "(Red is) next to blue, on its left or on its right": on one side or the other, and next to it in any case."""
    places = [side.adjuncts[0] for side in sides if len(side.adjuncts) == 1]
    close = isinstance(near := first.adjuncts[0], Loc) and near.rel in _NEAR
    its = all(isinstance(x, Loc) and x.rel in _ACROSS and getattr(x.landmark, "word", "") == "it" for x in places)
    if not close or not its or len(places) < len(sides):
        return None
    either = Coord(op="or", items=tuple(places), span=(places[0].span[0], places[-1].span[1]))
    return replace(first, adjuncts=(near, either))


_NEAR = frozenset({"beside", "adjacent", "touching", "near", "distance"})
_ACROSS = frozenset({"left", "right", "front", "behind"})


def _listed_inside(p: Parser, first: Clause) -> bool:
    """ "A is on B, B on C (or C is on D)" with what stands behind the comma as a part of the first clause."""
    parts = first.adjuncts if first.verb in ("be", "place") else ()
    gaps = [_between(p, one.span[1], two.span[0]) for one, two in pairwise(parts)]
    return any(gap == [","] and isinstance(part, Absolute) for gap, part in zip(gaps, parts[1:], strict=True))


def one_of_which(p: Parser) -> Diagnostic:
    """What is to be said of a sentence with no other reading."""
    return Diagnostic(
        code="ambiguous", message="it is not clear whether one of all these is to be so, or of the last two",
        span=p.span(0, p.end), hint="say 'either ... or ...' in a sentence of its own", origin="schema",
    )  # fmt: skip


def _between(p: Parser, begin: int, end: int) -> list[str]:
    """The words between two places of the text."""
    return [token.word for token in p.tokens if begin <= token.span[0] and token.span[1] <= end]
