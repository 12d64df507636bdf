""" "Two towers, three blocks each. The red one must not touch the blue one.": towers, or blocks of theirs?"""

from __future__ import annotations

from rpg.language.meaning import Chain, Noun, Pattern, Structure, parts_of
from rpg.passes.schema.resolve.things.world import refuse


def check_tower_or_block(chains: tuple[Chain, ...]) -> None:
    """Refuse "the red one" behind several towers of which no colours are told: it would be a block in one of them."""
    towers: Structure | None = None
    named: set[str] = set()
    parts = [part for chain in chains for clause in chain.clauses for part in parts_of(clause)]
    if any(isinstance(part, Pattern) and part.unit == "stack" for part in parts):
        return  # "each of one color"
    for part in parts:
        if isinstance(part, Structure) and part.kind == "stack" and part.plural and not _colored(part):
            towers = part
        if not isinstance(part, Noun | Structure) or getattr(part, "head", "") == "patch":
            continue
        one = isinstance(part, Noun) and (part.head, part.det, part.plural) == ("any", "the", False)
        if towers is not None and one and part.traits.colors and not named & {*part.traits.colors}:
            raise refuse("ambiguous", "one of the towers, or a block in one of them?", part.span,
                         "say 'the red block', or which colour each tower has")  # fmt: skip
        named |= {*part.traits.colors}


def _colored(towers: Structure) -> bool:
    """Whether it is told of which colours they are, or their blocks."""
    return any(isinstance(part, Noun | Structure) and part.traits.colors for part in parts_of(towers))
