"""What is between the ends of a line of listed blocks of which only the ends are told, or one of a range."""

from __future__ import annotations

import re
from collections.abc import Collection

from rpg.language import lexicon
from rpg.language.meaning import Meaning, Noun, parts_of
from rpg.passes.schema.resolve.things.world import Scene, refuse

Ranks = tuple[tuple[str, ...], ...]
FEWEST = 4
"""Blocks from which on more than one is between the ends."""
_FEWEST_OF_RANGE = 3
_WORDS = re.compile(r"[a-z]+|\d+")


def by_symbols(ranks: Ranks, names: tuple[str, ...], scene: Scene) -> Ranks:
    """ "Stack A, B, C and D with A at the bottom and D on top": symbols that are listed in their order, from one of the
    ends that are told to the other, stand in it; and those of a range."""
    listed = _listed(ranks, names)
    symbols = [scene.things[n].label or "" for n in listed]
    if all(symbols) and symbols and sorted(set(symbols)) in (symbols, symbols[::-1]):
        return _in_turn(listed, scene)
    return of_a_range(ranks, names, scene)


def of_a_range(ranks: Ranks, names: tuple[str, ...], scene: Scene) -> Ranks:
    """ "Letters A to E, A at the far end": those of a range follow one another where its first or last is at an end and
    no other has a place where it would not be by this; unless any order is asked for."""
    symbols = tuple(scene.things[n].label or "" for n in names)
    if symbols not in scene.ranges or frozenset(names) in scene.in_any_order:
        return ranks
    free = scene.free_runs.get(ranks, tuple(k for k, rank in enumerate(ranks) if len(rank) > 1))
    ends = {ranks[k][0] for k in (0, len(ranks) - 1) if k not in free and len(ranks[k]) == 1}
    ways = (names, names[::-1]) if not ends.isdisjoint((names[0], names[-1])) else ()
    return next((_in_turn(way, scene) for way in ways if _fits(way, ranks, free)), ranks)


def _in_turn(listed: tuple[str, ...], scene: Scene) -> Ranks:
    scene.assume("the order between the ends is the one in which the blocks are listed")
    return tuple((n,) for n in listed)


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


def _fits(listed: tuple[str, ...], ranks: Ranks, free: Collection[int]) -> bool:
    at = 0
    for k, rank in enumerate(ranks):
        if k not in free and {*listed[at : at + len(rank)]} != {*rank}:
            return False
        at += len(rank)
    return True


def told_as_ranges(chains: Collection[Meaning], text: str) -> frozenset[tuple[str, ...]]:
    """The symbols that are told by the first and the last of them, or by how many they are: "A to E", "the first five
    letters of the alphabet"; no list in which each is named."""
    nouns = (part for chain in chains for part in parts_of(chain) if isinstance(part, Noun))
    told = {(noun.traits.labels, noun.span) for noun in nouns if len(noun.traits.labels) >= _FEWEST_OF_RANGE}
    return frozenset(labels for labels, span in told if _is_range(labels, text[slice(*span)].lower()))


def _is_range(labels: tuple[str, ...], said: str) -> bool:
    rising = tuple(sorted(set(labels)))
    if labels not in (rising, rising[::-1]) or ord(rising[-1]) - ord(rising[0]) != len(labels) - 1:
        return False
    shown = {str(lexicon.NUMBER.get(word, word)).upper() for word in _WORDS.findall(said)}
    inside = shown.intersection(labels) - {labels[0], labels[-1]}
    return not inside and ("ALPHABET" in shown or {labels[0], labels[-1]} <= shown)
