"""Towers in a row that are told by their heights: "three towers in one row, 2, 4 and 2 high from left to right"."""

from __future__ import annotations

from typing import NamedTuple

from rpg.language import lexicon
from rpg.language.compose.changes import Changes
from rpg.language.compose.items import FIGURE, RANK
from rpg.language.compose.looking import FROM_LEFT
from rpg.language.compose.syntax import Clause, InLine, Listing, Made, Noun, Place, Predicate
from rpg.language.compose.words import Ways

_IN_ROW = tuple(f"{row}{line}" for row in ("in a ", "in one ", "in a plain ") for line in ("row", "line"))
_BACK = ("from right to left", "counted from the right", "from the right", "right to left")
_MADE_OF = ("made of", "made from", "made out of", "built of", "built from", "out of", "from", "using", "of")
_IDLE = frozenset({",", "and", "with", "that", "which", "are", "stand", "standing", "is", "all", "being"})
_SORTED = {"left": ("on the left", "at the left", "at the left end"), "right": ("on the right", "at the right",
           "at the right end"), "middle": ("in the middle", "in the center")}  # fmt: skip


class _Told(NamedTuple):
    """What was read of them so far."""

    heights: tuple[int, ...] = ()
    color: str = ""
    total: int = 0
    row: bool = False
    way: str = ""
    places: tuple[tuple[str, str], ...] = ()
    rising: Place | None = None


class Heights(Changes):
    """Reads them."""

    def towers_in_line(self, at: int, *, lined: bool = False) -> Ways[Clause]:
        """ "three towers in a row from left to right, 2, 4 and 2 high, made of eight gray blocks": in any order.
        `lined`: they are told to be in a row."""
        count = self.number(at)
        start = at + bool(count)
        color = lexicon.COLOR.get(self.text(start), "")
        start += bool(color)
        if FIGURE.get(self.text(start)) != "tower" or self.text(start) == "pair" or not self.items[start].many:
            return []
        found: Ways[Clause] = []
        told, end = _Told(color=color, row=lined), start + 1
        while (more := self._piece(told, end)) is not None:
            told, end = more
            fits = count in {0, len(told.heights)} and told.total in {0, sum(told.heights)}
            fits &= bool(told.way or told.places or told.rising)  # else in this order, or in any
            if told.row and len(told.heights) > 1 and fits:
                found.append((_clause(told), end))
        return found

    def _piece(self, told: _Told, at: int) -> tuple[_Told, int] | None:
        """One more thing that is said of them, and where it ends."""
        while self.text(at) in _IDLE:
            at += 1
        if not told.heights:
            heights, end = self.heights(at)
            if not heights and self.text(at) == "of":
                heights, end = self._counts(at + 1)
            elif not heights and self.text(at - 1) == "with":
                heights, end = self._counts(at)
                heights = heights if self.text(end - 1) == "block" else []
            if heights:
                return told._replace(heights=tuple(heights)), end
        if not told.row and (end := self.past_any(at, *_IN_ROW, "side by side in a row")):
            return told._replace(row=True), end
        for way, words in (("right", FROM_LEFT), ("left", _BACK)):
            if not told.way and (end := self.past_any(at, *words)):
                return told._replace(way=way, row=True), end
        if not told.color and not told.total and (made := self._made_of(told, at)):
            return made
        rank = RANK.get(self.text(at + (self.text(at) == "the")), "")
        behind = at + 1 + (self.text(at) == "the") + (self.text(at + 1 + (self.text(at) == "the")) == "one")
        for side, ways in _SORTED.items() if rank in {"tall", "short", "top", "bottom"} else ():
            if end := self.past_any(behind, *ways):
                rank = {"top": "tall", "bottom": "short"}.get(rank, rank)
                return told._replace(places=(*told.places, (rank, side))), end
        rising = next(iter(self._by_height(at)), None) if told.rising is None else None
        return (told._replace(rising=rising[0]), rising[1]) if rising else None

    def _counts(self, at: int) -> tuple[list[int], int]:
        """ "(of) 2, 3 and 4 blocks"."""
        found: list[int] = []
        end = at
        while self.number(at):
            found.append(self.number(at))
            end = at + 1
            at = self.past_any(end, "and", ", and", ",") or -1
        return (found, end + (self.text(end) == "block")) if len(found) > 1 else ([], 0)

    def _made_of(self, told: _Told, at: int) -> tuple[_Told, int] | None:
        """ "made of eight gray blocks", "of gray blocks", "gray"."""
        start = self.past_any(at, *_MADE_OF) or at
        total = self.number(start)
        color = lexicon.COLOR.get(self.text(start + bool(total)), "")
        end = start + bool(total) + bool(color)
        block = self.text(end) == "block"
        if not color or (start > at and not block) or (total and start == at):
            return None
        return told._replace(color=color, total=total), end + block


_RISES = {("short", "left"): "right", ("tall", "right"): "right", ("tall", "left"): "left", ("short", "right"): "left"}
"""To which side heights rise, by which one is at an end."""


def _clause(told: _Told) -> Clause:
    """Towers of such heights in a row."""
    heights = told.heights[::-1] if told.way == "left" else told.heights
    parts = tuple(Noun(count=n, color=told.color, noun="block", many=True) for n in heights)
    towers = Noun(count=len(parts), noun="tower", many=True, content=Listing(parts), made="of")
    if told.rising is not None and not told.rising.side and len(told.places) == 1:  # "by height, shortest on the left"
        side = _RISES.get(told.places[0])
        told = told._replace(places=() if side else told.places, rising=Place("rising", side=side or ""))
    listed = bool(told.way) and not told.places and told.rising is None
    said: tuple[Predicate, ...] = (Made(Noun(det="a", noun="row", ranks=("left",) if listed else ())),)
    said += (InLine(told.places),) if told.places else ()
    said += (told.rising,) if told.rising is not None else ()
    return Clause(towers, said, "build")
