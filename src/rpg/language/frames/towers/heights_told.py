"""Several towers whose heights are compared, or which stand in an order: "two towers of five blocks, the taller one on
the left", "a red tower that is one block higher than the blue one". They are told again with the height of each."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, permutations

from rpg.language.frames.groups.shared import listed
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.heights_found import Towers, Way, ways
from rpg.language.frames.towers.heights_gathered import Besides, gathered
from rpg.language.frames.towers.heights_words import PATTERNS

__all__ = ["PATTERNS", "told"]

_THERE = re.compile("^there (?:is|are)$")
_TOGETHER = frozenset({"compared", "unequal", "bound", "side", "middle", "rel", "heights", "group"})
"""What is told of towers by the others."""
_DONE = re.compile(r"\b(?:put|place|set|make|build|arrange|turn|bring|stack|lay)\b")
_TOWER = re.compile(r"\b(?:tower|stack|pillar|pile|column|high|tall|taller|higher|shorter|tallest|highest|shortest)")
_LAST = {"left": "right", "front": "back"}
_BEFORE = {"left": "to the left of", "front": "in front of"}


def told(pieces: Sequence[Piece]) -> str:
    """The towers in plain sentences.

    Raises:
        Unclear: it does not follow how high each of them is, or where it stands.
    """
    if (
        _begun(pieces)
        or _no_tower(pieces)
        or _each_or_all(pieces)
        or _colors_known(pieces)
        or _heights_of_one(pieces)
        or _TOGETHER.isdisjoint(piece.kind for piece in pieces)
    ):
        raise Unclear
    found, besides = gathered(pieces)
    possible = ways(found)
    if not possible and besides.spare:
        found = replace(found, all_used=False)
        possible = ways(found)
    kinds = {tuple(sorted(zip(found.looks, way.heights, strict=True))) for way in possible}
    if len(kinds) != 1 or pieces[0].words in ("is", "are"):
        raise Unclear
    return _said(found, possible, besides)


def _no_tower(pieces: Sequence[Piece]) -> bool:
    """ "Two white and two green blocks; the green one behind the white one" tells of no towers."""
    return not any(_TOWER.search(piece.words) for piece in pieces if piece.kind != "glue")


def _begun(pieces: Sequence[Piece]) -> bool:
    """ "There is a tower of two", "..., put it ...": what there is may be there at the start."""
    there = [n for n, (a, b) in enumerate(pairwise(pieces)) if _THERE.search(a.words) and b.kind in ("tower", "towers")]
    return there[:1] == [0] or (bool(there) and any(_DONE.search(piece.words) for piece in pieces[there[0] :]))


def _colors_known(pieces: Sequence[Piece]) -> bool:
    """ "Two towers of three blocks. The red one ...": a tower, or a block in one of them?"""
    named = [piece.named for piece in pieces if piece.kind == "tower" and piece.named.get("color")]
    several = any(piece.kind == "towers" for piece in pieces)
    return (
        several
        and bool(named)
        and all(one.get("det") == "the" for one in named)
        and not any(
            piece.kind == "looks" or (piece.kind in ("towers", "many") and piece.named.get("color")) for piece in pieces
        )
    )


def _heights_of_one(pieces: Sequence[Piece]) -> bool:
    """ "A tower of 2, 3 and 4 blocks": one tower has one height."""
    kinds = [piece.kind for piece in pieces]
    return any(
        a == "tower" and "heights" in (b, c) for a, b, c in zip(kinds, kinds[1:], [*kinds[2:], ""], strict=False)
    )


def _each_or_all(pieces: Sequence[Piece]) -> bool:
    """ "Two towers of eight blocks, one as tall as the other": eight each, or four each?"""
    of_so_many = any(
        (towers.kind, of.words, many.kind) == ("towers", "of", "many") and "each" not in many.named
        for towers, of, many in zip(pieces, pieces[1:], pieces[2:], strict=False)
    )
    return of_so_many and any(piece.kind == "compared" and piece.value == ("times", 1) for piece in pieces)


Item = tuple[str, int]
"""A tower: the colour of its blocks, and how many they are."""


def _said(found: Towers, possible: Sequence[Way], besides: Besides) -> str:
    """The towers and where they stand."""
    items = [*zip(found.looks, possible[0].heights, strict=True)]
    lines = {tuple((found.looks[n], way.heights[n]) for n in way.order) for way in possible}
    line = " The towers stand in a row." if besides.line else ""
    line += " The towers are next to each other." if besides.mutual else ""
    alike = len(set(found.looks)) == 1
    if alike and len(lines) == 1 and not found.rels:
        heights = [str(height) for _, height in (min(lines) if found.first else items)]
        look = f"{found.looks[0]} " if found.looks[0] else ""
        way = f" from {found.first} to {_LAST[found.first]}" if found.first else ""
        return f"Build {len(items)} {look}towers of heights {listed(heights)}{way}.{line}"
    if besides.behind and len(lines) > 1:
        raise Unclear
    names = _names(items)
    of_stock = {look: "of the " for look in found.stock if look and not found.all_used}
    blocks = [
        f"a tower of {height} {of_stock.get(look, '')}{f'{look} ' if look else ''}blocks" for look, height in items
    ]
    there = [f"{many} {look} block{'s' if many > 1 else ''}" for look, many in found.stock.items() if look in of_stock]
    text = f"There are {listed(there)}. " if there else ""
    text += f"Build {listed(blocks)}."
    if found.first:
        text += "".join(_places(items, lines, found.first, names))
    return text + _related(found, possible, items, names) + line


def _names(items: Sequence[Item]) -> dict[Item, str]:
    """What each tower is called where it is spoken of again.

    Raises:
        Unclear: two of them are alike.
    """
    looks, heights = {look for look, _ in items}, {height for _, height in items}
    if len(looks) == len(items) and "" not in looks:
        return {item: f"the {item[0]} tower" for item in items}
    if len(heights) < len(items):
        raise Unclear
    return {item: f"the tower of {item[1]}" for item in items}


def _places(
    items: Sequence[Item], lines: Collection[tuple[Item, ...]], first: str, names: dict[Item, str]
) -> Iterator[str]:
    """Where the towers stand, one by one.

    Raises:
        Unclear: that can't be told of one after the other.
    """
    if len(lines) == 1:
        yield from (f" {names[a].capitalize()} is {_BEFORE[first]} {names[b]}." for a, b in pairwise(*lines))
        return
    before = [(a, b) for a, b in permutations(items, 2) if all(x.index(a) < x.index(b) for x in lines)]
    if {x for x in permutations(items) if all(x.index(a) < x.index(b) for a, b in before)} == {*lines}:
        yield from (f" {names[a].capitalize()} is {_BEFORE[first]} {names[b]}." for a, b in before)
        return
    amid = {x[1] for x in lines}
    if len(items) != 3 or len(lines) != 2 or len(amid) > 1:
        raise Unclear
    one, other = (names[item] for item in items if item not in amid)
    yield f" {names[amid.pop()].capitalize()} is between {one} and {other}."


def _related(found: Towers, possible: Sequence[Way], items: Sequence[Item], names: dict[Item, str]) -> str:
    """How two towers stand to each other, nearer than that one is before the other."""
    text = ""
    for one, other, rel in found.rels:
        pairs = {(way.number(one), way.number(other)) for way in possible}
        (a, b), *more = pairs
        if more or a is None or b is None or a == b:
            raise Unclear
        text += f" {names[items[a]].capitalize()} is {rel} {names[items[b]]}."
    return text
