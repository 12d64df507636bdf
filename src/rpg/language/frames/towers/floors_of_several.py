"""Several towers of which each is told floor by floor, or all at once, and how they stand to each other."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from rpg.language.frames.groups.shared import listed
from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floors_listed import looks_of

_NTH = ("first", "second", "third", "fourth", "fifth")
_SIDES = (("left", "right"), ("left", "middle", "right"))
_SHARED = frozenset({"towers", "size", "near", "line", "across", "relation"})
"""What is told of all towers, wherever it stands."""
_ORDINAL = re.compile(rf"(?:the )?({'|'.join(_NTH)})(?: one)?")
_RELATIONS = {"beside": "next to", "to its left": "left of", "to its right": "right of"}
_AMID = re.compile("the (?:middle|central|center) one")


@dataclass
class _Tower:
    """What is told of one of them. `name`: how it is called; `side`: where it is; `rel`: how it is to the last one, and
    `onward`: to the next one."""

    name: str
    side: str | None = None
    rel: str | None = None
    onward: str | None = None
    pieces: list[Piece] = field(default_factory=list)


def towers_told(pieces: Sequence[Piece]) -> str:
    """The towers in plain sentences.

    Raises:
        Unclear: it does not follow which blocks each of them has, or where it is.
    """
    counts = {piece.value[0] for piece in pieces if piece.kind == "towers" and piece.value[0]}
    sizes = {piece.value[1] for piece in pieces if piece.kind == "towers" and piece.value[1]}
    sizes |= {piece.value for piece in pieces if piece.kind == "size"}
    if len(counts) > 1 or len(sizes) > 1:
        raise Unclear
    count, size = next(iter(counts), None), next(iter(sizes), None)
    if any(piece.words == "line up" for piece in pieces):
        raise Unclear  # the towers, or the blocks of the first?
    way = one(pieces, "way")
    header, towers = _parted(pieces, count)
    if not towers:
        towers = _alike(header, count, size)
    elif any(piece.kind in ("item", "total", "where", "side", "rel") for piece in header):
        raise Unclear
    if len(towers) != (count or len(towers)) or not 1 < len(towers) <= len(_NTH):
        raise Unclear
    chains: list[list[str]] = []
    for tower in towers:
        if any(piece.kind == "reversed" for piece in tower.pieces):
            if len(chains) != 1 or any(piece.kind in ("item", "part", "total") for piece in tower.pieces):
                raise Unclear
            chains.append(chains[0][::-1])
        else:
            chains.append(looks_of(tower.pieces, way, size)[::-1])
    told = [" on ".join(look if len(look) == 1 else f"1 {look} block" for look in chain) for chain in chains]
    return f"Build {len(towers)} towers: {listed(told)}." + _placed(pieces, towers)


def _parted(pieces: Sequence[Piece], count: int | None) -> tuple[list[Piece], list[_Tower]]:
    """What is told ahead of the first of the towers, and each of these.

    Raises:
        Unclear: one of them is told of twice, or a place of all of them behind the last one.
    """
    kinds = [piece.kind for piece in pieces]
    by_side = "slot" not in kinds and kinds.count("side") > 1
    amid = by_side and count == len(_SIDES[1])
    header: list[Piece] = []
    towers: list[_Tower] = []
    rel = ahead = None
    said = [piece for piece in pieces if piece.kind not in ("glue", "break")]
    if any(one.kind in ("towers", "same") and two.kind == "where" for one, two in pairwise(said)):
        raise Unclear
    for piece in pieces:
        if piece.kind in _SHARED:
            continue
        if amid and _AMID.fullmatch(piece.words):
            piece = replace(piece, kind="side", value="middle")
        numbered = piece.kind == "nth" and "towers" in kinds and _ORDINAL.fullmatch(piece.words)
        if piece.kind == "slot" or numbered or (by_side and piece.kind == "side"):
            name = numbered[1] if numbered else str(piece.value)
            towers.append(_Tower(name, piece.value if by_side else None, rel))
            rel = ahead if len(towers) == 1 else None
        elif piece.kind == "ahead" and not towers:
            ahead = piece.value  # "next to a tower of ... build a tower of ..."
        elif piece.kind == "ahead":
            towers[-1].onward = piece.value
        elif piece.kind == "side" and towers:
            if towers[-1].side:
                raise Unclear
            towers[-1].side = piece.value
        elif piece.kind == "rel":
            if not towers or rel or towers[-1].rel:
                raise Unclear
            if {"item", "part"} & {p.kind for p in towers[-1].pieces} and _leads(pieces, piece):
                rel = piece.value
            else:
                towers[-1].rel = piece.value
        elif towers:
            towers[-1].pieces.append(piece)
        else:
            header.append(piece)
    if rel or len({tower.name for tower in towers if tower.name in _NTH}) < sum(t.name in _NTH for t in towers):
        raise Unclear
    return header, towers


def _leads(pieces: Sequence[Piece], rel: Piece) -> bool:
    """Whether what a relation is told of stands behind it: "and behind it another tower".

    Raises:
        Unclear: it may be the one before as well as the one behind.
    """
    at = next(n for n, piece in enumerate(pieces) if piece is rel)
    before, behind = pieces[at - 1 :: -1], pieces[at + 1 :]
    told = [piece.kind for piece in behind if piece.kind not in ("glue", "break")]
    if before[0].kind != "break" or not told or told[0] not in ("slot", "whole"):
        return False
    ahead = next(n for n, piece in enumerate(before) if piece.kind != "break")
    after = next(n for n, piece in enumerate(behind) if piece.kind != "glue")
    if behind[after].kind == "break" and not any(piece.words == "and" for piece in before[:ahead]):
        raise Unclear
    return True


def _alike(header: Sequence[Piece], count: int | None, size: int | None) -> list[_Tower]:
    """Towers that are told all at once.

    Raises:
        Unclear: it may be one of them, or one for each.
    """
    same = any(piece.kind == "same" for piece in header)
    places = any(piece.kind in ("part", "nth", "upon", "under", "then", "way") for piece in header)
    if count is None or not (same or size) or not places or any(p.kind in ("where", "side", "rel") for p in header):
        raise Unclear
    return [_Tower("", pieces=list(header)) for _ in range(count)]


def _placed(pieces: Sequence[Piece], towers: Sequence[_Tower]) -> str:
    """How they stand to each other, and where.

    Raises:
        Unclear: some are told by their sides only, or it is told twice.
    """
    names = [f"the {_NTH[n]} tower" for n in range(len(towers))]
    sides = [tower.side for tower in towers]
    text = ""
    if any(sides):
        order = next((way for way in _SIDES if len(way) == len(towers)), ())
        if len(towers) == len(_SIDES[0]) and sides.count(None) == 1:
            known = sides[0] or sides[1]
            sides = [side or next(other for other in _SIDES[0] if other != known) for side in sides]
        if sorted(map(str, sides)) != sorted(order) or any(tower.rel for tower in towers):
            raise Unclear
        in_line = [names[sides.index(side)] for side in order]
    else:
        in_line = names if any(piece.kind == "across" for piece in pieces) else []
    text += "".join(f" {a.capitalize()} is left of {b}." for a, b in pairwise(in_line))
    for n, tower in enumerate(towers):
        if tower.rel:
            rel = _RELATIONS.get(tower.rel, tower.rel)
            text += f" {names[n].capitalize()} is {rel} {names[n - 1]}."
        if tower.onward:
            text += f" {names[n].capitalize()} is {_RELATIONS.get(tower.onward, tower.onward)} {names[n + 1]}."
        where = one(tower.pieces, "where")
        text += f" {names[n].capitalize()} must be {where.value}." if where else ""
    called = {tower.name: name for tower, name in zip(towers, names, strict=True)}
    for piece in pieces:
        if piece.kind == "relation":
            a, rel, b = piece.value
            if a == b or a not in called or b not in called:
                raise Unclear
            text += f" {called[a].capitalize()} is {_RELATIONS.get(rel, rel)} {called[b]}."
    text += " The towers stand in a row." if any(piece.kind == "line" for piece in pieces) else ""
    near = one(pieces, "near")
    if near:
        text += f" The towers {'are ' if near.value.startswith(('next', 'near')) else ''}{near.value}."
    return text
