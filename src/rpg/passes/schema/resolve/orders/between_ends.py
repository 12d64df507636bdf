"""What is between the ends of a line of listed blocks of which only the ends are told."""

from __future__ import annotations

from rpg.passes.schema.resolve.things.world import Scene, refuse

Ranks = tuple[tuple[str, ...], ...]
FEWEST = 4
"""Blocks from which on more than one is between the ends."""


def by_symbols(ranks: Ranks, names: tuple[str, ...], scene: Scene) -> Ranks:
    """ "Stack A, B, C and D with A at the bottom and D on top": symbols that are listed in their order, from one of the
    ends that are told to the other, stand in it."""
    listed = _listed(ranks, names)
    symbols = [scene.things[n].label or "" for n in listed]
    if all(symbols) and symbols and sorted(set(symbols)) in (symbols, symbols[::-1]):
        scene.assume("the order between the ends is the one in which the blocks are listed")
        return tuple((n,) for n in listed)
    return ranks


def between_ends(ranks: Ranks, names: tuple[str, ...], scene: Scene) -> Ranks:
    """The same; of blocks that are listed in another order, or by their colours, it is asked."""
    found = by_symbols(ranks, names, scene)
    looks = {(t.color, t.label) for t in (scene.things[n] for n in _listed(ranks, names)) if t.color or t.label}
    if found is ranks and len(looks) == len(names):
        raise refuse("ambiguous", "in the order in which these are listed, or in any order between the ends?", None,
                     "say 'in this order', or 'in any order'")  # fmt: skip
    return found


def _listed(ranks: Ranks, names: tuple[str, ...]) -> tuple[str, ...]:
    """The blocks from the first rank to the last, as they are listed; none unless these two ends alone are told."""
    listed = names if ranks[0] == names[:1] else names[::-1]
    ends = len(ranks) == 3 and len(names) >= FEWEST and (*ranks[0], *ranks[2]) == (listed[0], listed[-1])
    return listed if ends else ()
