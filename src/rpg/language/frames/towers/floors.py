"""A tower that is told floor by floor: from one end to the other, by what lies on what, or by which floor has what."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floor_parts import Item, Run, Tower, item_of
from rpg.language.frames.towers.floors_settled import settled

_PARTS = frozenset({
    "item", "part", "ends", "half", "nth", "upon", "under", "over", "below", "between", "then", "rest",
    "every",
})  # fmt: skip

_ONE = re.compile(r"\b(?:block|cube|one|piece|element|floor|level|layer)\b")


def floors(pieces: Sequence[Piece], way: str | None, total: int | None) -> list[str]:
    """The looks of the blocks of one tower, from bottom to top. `way`: in which direction it is told, if that is told
    of it; `total`: how many blocks it has.

    Raises:
        Unclear: it does not follow what is where.
    """
    tower = Tower(way, total, alternating=any(piece.kind == "alternating" for piece in pieces))
    kinds = [piece.kind for piece in pieces]
    if "every" in kinds and "except" not in kinds:
        raise Unclear  # "all of its blocks are red": so nothing else can be
    for clause, joined in clauses_of(pieces):
        if joined == "except":
            _but(tower)
        if joined == "and" and _shares(tower, clause):
            raise Unclear  # "red and blue at the bottom": both, or the blue one?
        _told(tower, clause)
    return settled(tower)


def _but(tower: Tower) -> None:
    """ "Five red blocks except the top one": five in all."""
    if not tower.bare or (count := tower.bare[-1].count) is None:
        return
    if tower.total not in (None, count):
        raise Unclear
    tower.total = count
    tower.bare[-1] = replace(tower.bare[-1], count=None, plural=True)


def _shares(tower: Tower, clause: Sequence[Piece]) -> bool:
    """Whether the place of a clause may be that of the blocks before an "and", too."""
    part = next((piece.value[0] for piece in clause if piece.kind == "part"), "")
    if tower.bare and tower.runs and {"upon", "under"} & {piece.kind for piece in clause}:
        return True
    if not tower.bare or not ({"part", "half", "above", "below"} & {piece.kind for piece in clause}):
        return False
    own = all({"det", "count"} & piece.named.keys() for piece in clause if piece.kind == "item")
    return part != "top" or not own or tower.bare[-1].count is None


def clauses_of(pieces: Sequence[Piece]) -> Iterator[tuple[list[Piece], str]]:
    """What stands between two breaks, and the break ahead of it; what only leads to blocks, "then, " or "on top: ",
    goes with these."""
    clause: list[Piece] = []
    joined = ""
    for piece in pieces:
        kinds = {one.kind for one in clause}
        if piece.kind == "then" and "item" in kinds:
            yield clause, joined
            clause, kinds, joined = [], set(), ""
        if piece.kind in _PARTS:
            clause.append(piece)
        leads = kinds == {"then"} or (piece.words == ":" and not kinds & {"item", "rest"})
        if piece.kind in ("break", "except") and clause and not leads:
            yield clause, joined
            clause, joined = [], piece.words if piece.kind == "break" else "except"
        elif piece.kind in ("break", "except") and not clause:
            joined = "except" if "except" in (piece.kind, joined) else ""
    if clause:
        yield clause, joined


def _told(tower: Tower, clause: list[Piece]) -> None:
    """What a clause tells of a tower."""
    follows = any(piece.kind == "then" for piece in clause)
    said = [piece for piece in clause if piece.kind != "then"]
    kinds = [piece.kind for piece in said]
    places = [piece for piece in said if piece.kind in ("part", "nth", "ends", "half")]
    items = [item_of(piece) for piece in said if piece.kind == "item"]
    if {"rest", "every"} & {*kinds}:
        _rest(tower, said, items, places)
    elif kinds == ["item", "between", "item"]:
        _between(tower, *items)
        tower.related = True
    elif {"over", "below"} & {*kinds}:
        _related(tower, said, items, places)
        tower.related = True
    elif any(map(tower.again, items)):
        raise Unclear  # "red on blue, and blue at the bottom"
    elif {"upon", "under"} & {*kinds}:
        if len(items) != 1 or len(places) > 1 or len(said) != 2 + len(places):
            raise Unclear
        tower.extend(items[0], up="upon" in kinds)
        _anchored(tower, places)
    elif len(items) == 1 and len(places) == len(said) - 1 <= 1:
        _alone(tower, items[0], places, follows=follows)
    elif not places and items and not follows:
        raise Unclear  # "red blue": which is where?
    elif len(items) == len(places) and kinds[::2] in (["item"] * len(items), [p.kind for p in places]):
        for item, place in zip(items, places, strict=True):
            _alone(tower, item, [place], follows=False)
    else:
        raise Unclear


def _alone(tower: Tower, item: Item, places: list[Piece], *, follows: bool) -> None:
    """Blocks with or without a place of their own."""
    listed = follows or (tower.way is not None and not places)
    if listed and tower.last is None and not tower.bare and not tower.runs:
        tower.begin(item)
        tower.downward = tower.way == "down"
        _anchored(tower, places)
        return
    if listed and tower.last is None and len(tower.bare) == 1 and not tower.runs:
        tower.begin(tower.bare.pop())  # "a red one, then a blue one"
    if listed and (tower.last is None or tower.last.amid):
        raise Unclear  # "a red one, then a blue one": up or down?
    if listed:
        tower.extend(item, up=not tower.downward)
        _anchored(tower, places)
    elif not places:
        ends = {(run.low, run.high) for run in tower.runs}
        if {low for low, _ in ends} & {0} and {high for _, high in ends} & {0}:
            raise Unclear  # blocks beside a tower that is told already
        tower.bare.append(item)
    else:
        _placed(tower, item, places[0])


def _placed(tower: Tower, item: Item, place: Piece) -> None:
    """Blocks at a part of the tower, or on one of its floors.

    Raises:
        Unclear: they may be some that are told already, or it is not told how many or where they are.
    """
    if tower.unplaced(item):
        raise Unclear
    if place.kind == "ends":
        if tower.ends or item.count not in (None, 2, 1 if "end" in place.words else 2):
            raise Unclear
        tower.ends = item.look
        return
    if place.kind == "nth":
        nth, end = place.value
        end = end or {"up": "bottom", "down": "top"}.get(tower.way or "")
        end = end or ("bottom" if 2 * nth - 1 == tower.total else None)  # from both ends it is the same one
        if end is None or item.count not in (None, 1):
            raise Unclear
        run = tower.begin(item)
        run.low, run.high = (nth - 1, None) if end == "bottom" else (None, nth - 1)
        return
    part, count = place.value
    if place.kind == "half":
        if not tower.total or tower.total % 2:
            raise Unclear
        count = tower.total // 2
    if part == "middle" and count is None and item.count is None:
        _others(tower, replace(item, plural=True))
        tower.inner = True
        return
    if item.plural and item.known and item.count is None and count == 1:
        item, count = _those(tower, item), None
    elif not tower.alternating and _one_of_several(tower, item, place):
        raise Unclear  # "two red blocks, the red one at the bottom"
    several = item.count is not None and item.count > 1 and count == 1
    run = tower.begin(item, None if several else count)
    _anchor(run, part)
    tower.downward = part == "top"


def _one_of_several(tower: Tower, item: Item, place: Piece) -> bool:
    """Whether one block may be any of those that are told ahead, or all of them; "the bottom block" is one of them."""
    ahead = any(other.look == item.look and (other.count or 0) > 1 for other in tower.bare)
    return ahead and item.known and item.count in (None, 1) and not _ONE.search(place.words)


def _those(tower: Tower, item: Item) -> Item:
    """ "The red ones", with their number as it was told ahead.

    Raises:
        Unclear: it was not.
    """
    same = [other for other in tower.bare if other.look == item.look and other.count]
    if len(same) != 1 or any(item.look in run.looks for run in tower.runs):
        raise Unclear
    return same[0]


def _between(tower: Tower, item: Item, around: Item) -> None:
    """ "The blue block between the two red ones"."""
    if around.count not in (None, 2) or not around.plural or item.look == around.look or tower.runs:
        raise Unclear
    tower.begin(replace(around, count=1))
    tower.extend(item, up=True)
    tower.extend(replace(around, count=1), up=True)


def _anchored(tower: Tower, places: Sequence[Piece]) -> None:
    """What was told as the next one is at a part of the tower, too."""
    for place in places:
        if place.kind != "part" or tower.last is None or place.value[0] == "middle":
            raise Unclear
        _anchor(tower.last, place.value[0])


def _anchor(run: Run, part: str) -> None:
    if part == "bottom":
        run.low = 0
    elif part == "top":
        run.high = 0
    else:
        run.amid = True


def _related(tower: Tower, said: list[Piece], items: list[Item], places: list[Piece]) -> None:
    """ "Above it a red one", "the red one on a blue one", "red on blue on green"."""
    kinds = [piece.kind for piece in said if piece.kind not in ("part", "nth", "ends")]
    if len(kinds) == 2 and len(items) == 1 and not places:
        if kinds[0] != "item":
            raise Unclear  # "the red one is under the blue one and above the green one"
        if tower.runs:
            tower.extend(items[0], up="over" in kinds)
        else:  # "red below and blue above"
            _anchor(tower.begin(items[0]), "bottom" if kinds[1] == "below" else "top")
        return
    if kinds == ["over", "item", "item"] and items[0].known:
        kinds, items = ["item", "over", "item"], items[::-1]
    if places or len(items) < 2 or kinds[::2] != ["item"] * len(items) or len({*kinds[1::2]}) != 1:
        raise Unclear
    upward = items if kinds[1] == "below" else items[::-1]
    low, high = tower.found(upward[0], up=True), tower.found(upward[-1], up=False)
    if low and not high:
        tower.last = low
        for item in upward[1:]:
            tower.extend(item, up=True)
    elif high and not low:
        tower.last = high
        for item in upward[-2::-1]:
            tower.extend(item, up=False)
    elif not (low or high or tower.runs):
        tower.begin(upward[0])
        for item in upward[1:]:
            tower.extend(item, up=True)
    else:
        raise Unclear
    tower.last = None if len(items) > 2 else tower.last


def _rest(tower: Tower, said: list[Piece], items: list[Item], places: list[Piece]) -> None:
    """ "The others are blue"."""
    amid = all(place.kind == "part" and place.value[0] == "middle" for place in places)
    if len(items) != 1 or len(places) > 1 or not amid or len(said) != 2 + len(places):
        raise Unclear
    if items[0].count is not None and not items[0].plural:
        raise Unclear
    told = next(piece.value for piece in said if piece.kind in ("rest", "every"))
    if told and items[0].count not in (None, told):
        raise Unclear
    _others(tower, replace(items[0], count=told or items[0].count, plural=True))


def _others(tower: Tower, item: Item) -> None:
    """What all blocks are like that are not told one by one.

    Raises:
        Unclear: it is told already.
    """
    if tower.rest:
        raise Unclear
    tower.rest = item
