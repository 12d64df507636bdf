""" "A row of five red blocks, but the middle one is blue", "... The top one is blue instead.": a part that is not as
all are said to be."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Meaning,
    Noun,
    Places,
    Size,
    Structure,
    Traits,
    replace,
)

_LINES = ("stack", "row", "line", "column")
_BUT = re.compile(r"\b(?:but|except|only|save|though|however|instead)\b", re.IGNORECASE)


def but_a_part(links: list[str], chains: tuple[Chain, ...], text: str) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with the line as one of so many blocks, this part so and the others as all were said to be."""
    told, found = list(links), list(chains)
    for n, chain in enumerate(chains):
        first, rest = chain.clauses[0], chain.clauses[1:]
        if isinstance(first, Clause) and (whole := _excepted(first, text)) is not None:
            found[n] = replace(chain, clauses=(whole, *rest))
        last = chains[n - 1].clauses[-1] if n else None
        if isinstance(last, Clause) and isinstance(first, Clause) and first.verb == "part" and links[n] == "and":
            joined = replace(last, adjuncts=(*last.adjuncts, *first.adjuncts), span=(last.span[0], first.span[1]))
            if first.theme is None and not rest and (whole := _excepted(joined, text)) is not None:
                found[n - 1] = replace(found[n - 1], clauses=(*found[n - 1].clauses[:-1], whole))
                return told[:n] + told[n + 1 :], tuple(found[:n] + found[n + 1 :])
    return told, tuple(found)


def _excepted(clause: Clause, text: str) -> Clause | None:
    shape, part = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if isinstance(part, Coord) and part.op == "absolutes" and len(part.items) == 1:
        part = part.items[0]
    if not isinstance(shape, Structure) or shape.kind not in _LINES or shape.plural or not isinstance(part, Absolute):
        return None
    blocks, place = shape.members, part.adjuncts[0]
    if not isinstance(blocks, Noun) or shape.details or shape.sizes or clause.negated or clause.verb != "build":
        return None
    color = shape.traits.colors or blocks.traits.colors
    plain = {replace(x, colors=()) for x in (shape.traits, blocks.traits)} == {Traits()}
    alone = blocks.det == "bare" and blocks.amount is not None and blocks.amount.low == blocks.amount.high
    if not plain or not alone or len(color) != 1 or not _other_look(part.theme, color[0]):
        return None
    said = isinstance(place, At) or (isinstance(place, Places) and place.side != "rest")
    if not said or _BUT.search(text[shape.span[1] : clause.span[1]]) is None:
        return None
    others = Noun(head="any", traits=Traits(colors=color), span=blocks.span)
    rest = Absolute(theme=others, adjuncts=(Places(side="rest", unit="block", span=blocks.span),), span=blocks.span)
    size = Size(what="size", amount=blocks.amount, span=blocks.span)
    bare = replace(shape, members=None, traits=Traits(), sizes=(size,))
    return replace(clause, theme=bare, adjuncts=(part, rest))


def _other_look(look: Meaning, color: str) -> bool:
    if not isinstance(look, Noun) or look.det not in ("bare", "some") or look.amount is not None:
        return False
    return look.traits == Traits(colors=look.traits.colors[:1]) and look.traits.colors not in ((), (color,))
