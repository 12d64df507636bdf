"""Blocks that are counted, and told one by one behind a comma: "stack the two cubes, blue on yellow"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.core.diagnostics import Refusal
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import Scene, refuse

DOUBTED = (
    "the blocks that are counted may be those that are described",
    "it is not clear which blocks the structure is made of",
    "could be the last ones, or all those spoken of before",
)
"""How blocks are refused that may be the ones that are named beside them."""
_TOLD_BEHIND = re.compile(r"[,:(;–—-]\s*(?!and\b|then\b|but\b|also\b|plus\b|while\b|next\b|after)", re.IGNORECASE)


def told_one_by_one(
    links: list[str], chains: tuple[Chain, ...], refusal: Refusal, text: str
) -> tuple[list[str], tuple[Chain, ...]] | None:
    """The sentences with the blocks that are named said to be all there are, where just so many were counted before.

    What is told behind a comma or a colon tells of the blocks in front of it; "and" would bring further ones.
    """
    if not any(told in refusal.diagnostics[0].message for told in DOUBTED):
        return None
    told = _told_behind(chains, text)
    if told is None or len(told[2]) != told[1]:
        return None
    span = told[0].span
    items = tuple(Noun(head="block", det="a", amount=Amount(1, 1), traits=look, span=span) for look in told[2])
    there = Clause(verb="exist", theme=Coord(op="and", items=items, span=span), mode="given", span=span)
    return ["and", *links], (Chain(clauses=(there,), links=("and",), span=span), *chains)


def check_counted(chains: tuple[Chain, ...], scene: Scene, text: str) -> None:
    """Refuse "build a tower of three blocks, red on white" where these two came on top of the three."""
    told = _told_behind(chains, text)
    blocks = [t for t in scene.things.values() if not t.patch and not t.extra]
    if told is None or sum(not (t.color or t.label or t.kind) for t in blocks) < told[1]:
        return
    parts = [part for chain in chains if told[0] in parts_of(chain) for part in parts_of(chain)]
    if not any(isinstance(x, Pronoun) for x in parts) and all(x.det == "bare" for x in _looks(parts)):
        raise refuse("ambiguous", DOUBTED[0], told[0].span, "say what all of these look like, or name further ones by "
                     "'another'")  # fmt: skip


def _told_behind(chains: tuple[Chain, ...], text: str) -> tuple[Meaning, int, list[Traits]] | None:
    """Blocks of no look, how many they are, and the looks that are told behind them in the same sentence."""
    counted = [(x, n, chain) for chain in chains for x in parts_of(chain) if (n := _count(x))]
    if len({x.span for x, _, _ in counted}) != 1:
        return None
    whole, many, home = counted[0]
    looks = _looks(parts_of(home))
    named = _each(looks)
    if any(isinstance(x, Structure) and x.plural for x in parts_of(home)):
        return None
    if not looks or named is None:
        return None
    behind = text[whole.span[1] : min(x.span[0] for x in looks)]
    return (whole, many, named) if _TOLD_BEHIND.search(behind) else None


def _looks(parts: Sequence[Meaning]) -> list[Noun]:
    """The blocks that are named by a colour or a symbol."""
    return [x for x in parts if isinstance(x, Noun) and x.head != "patch" and (x.traits.colors or x.traits.labels)]


def _count(part: Meaning) -> int:
    """How many blocks of no look a phrase speaks of; 0 if it is no such phrase."""
    amount = None
    if isinstance(part, Noun) and part.head == "block" and part.det in ("the", "bare", "both") and not part.part_of:
        amount = part.amount if part.traits == Traits() and not part.conditions else None
    if isinstance(part, Structure) and part.members is None and not part.plural and part.traits == Traits():
        amount = part.size if part.letter is None and len(part.sizes) == 1 else None
    return amount.low if amount is not None and amount.low == amount.high and amount.low > 1 else 0


def _each(looks: list[Noun]) -> list[Traits] | None:
    """The looks of blocks that are named one at a time, each once; None where there are more of one look."""
    found: dict[Traits, None] = {}
    for noun in looks:
        if noun.det not in ("bare", "the") or noun.amount is not None or noun.traits.either or noun.traits.extra:
            return None
        marks = replace(noun.traits, rank=None)
        if marks not in (Traits(colors=marks.colors), Traits(labels=marks.labels)):
            return None
        found.update(dict.fromkeys(Traits(colors=(c,)) for c in marks.colors))
        found.update(dict.fromkeys(Traits(labels=(x,)) for x in marks.labels))
    return list(found)
