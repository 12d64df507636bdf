""" "A wall with four layers, each a different colour", "three towers of two, each a different colour": "each" is of
what is told right before it, and not of every block."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Quality, Structure
from rpg.passes.schema.resolve.things.world import refuse

_PARTS = frozenset({"layers", "rows", "columns"})


def check_each(chains: tuple[Chain, ...], text: str) -> None:
    """Refuse a reading that gives each block a colour where "each" is of layers, rows, columns or towers."""
    for clause in (part for chain in chains for part in chain.clauses if isinstance(part, Clause)):
        theme = clause.theme
        told = next((a for a in clause.adjuncts if isinstance(a, Quality) and a.traits.scheme == "different"), None)
        if told is None or not isinstance(theme, Structure):
            continue
        if "each" not in text[theme.span[1] : told.span[1]].lower().split():
            continue
        last = max(theme.sizes, key=lambda size: size.span, default=None)
        if last is not None and last.what in _PARTS:
            raise refuse("misplaced", "this is said of each of the parts", told.span, "say 'each block'")
        if theme.plural and theme.kind == "stack":
            raise refuse("ambiguous", "each of the blocks, or each of the towers?", told.span,
                         "say 'each tower' or 'each block'")  # fmt: skip
