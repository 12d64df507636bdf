"""The parts of letters: "its bar three long, its stem pointing towards me", "the long arm runs away from me"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from rpg.language.compose.items import RANK
from rpg.language.compose.words import Text

_PARTS: dict[str, dict[str, tuple[str, ...]]] = {
    "T": {"bar": ("bar", "crossbar", "cross bar", "crosspiece", "top bar"),
          "stem": ("stem", "upright", "post", "tail")},
    "L": {"long": ("long arm", "longer arm", "long side", "long leg", "long bar", "long part", "stem", "upright",
                   "line"),
          "foot": ("foot", "short arm", "shorter arm", "short side", "short leg", "short bar")},
    "U": {"arm": ("arm", "side", "leg"), "base": ("base", "bottom", "bar", "bottom bar")},
}  # fmt: skip
LETTERS = frozenset(_PARTS)
"""Those of which the parts are told."""
_LEADS = ("its", "the", "a", "whose", "with its", "with the", "with a", "with", "its two", "the two", "two", "both",
          "each", "in its", "an")  # fmt: skip
_LONG = ("long", "high", "wide", "deep", "across", "each", "tall")
_OF = ("of", "is", "are", "with", "has", "which is", "that is", "made of", "is made of", "being", "have", "which has")
_RUN = tuple(
    f"{which}{run}"
    for which in ("", "and ", ", ", "which ", "that ", ", which ", "it ")
    for run in ("point", "points", "pointing", "is pointing", "run", "runs", "running", "go", "goes", "going", "come",
                "comes", "coming", "extend", "extends", "extending", "lead", "leads", "leading", "stick out",
                "sticks out", "continues", "facing", "faces", "lies", "is")
)  # fmt: skip
_FROM = tuple(
    f"{line}{out}{middle}"
    for line in ("", "in a line ", "straight ", "down ")
    for out in ("from ", "out of ", "from the ", "out of the ")
    for middle in ("its middle", "its center", "middle of it", "middle of the bar", "center of the bar", "middle one",
                   "middle", "the middle of it", "the middle of the bar")
)  # fmt: skip
_TO_ME = tuple(f"{to} {me}" for to in ("towards", "toward", "to") for me in ("me", "us", "the viewer", "the camera"))
_AWAY = tuple(
    f"{away} from {me}" for away in ("away", "straight away") for me in ("me", "us", "the viewer", "the camera")
)
_LAST = tuple(
    f"the {which}{one}" for one in (" one", "") for which in ("fourth", "fifth", "sixth", "last", "remaining", "other")
)
_JOINS = (
    "in the middle", "between them", "in between", "connecting them", "joining them",
    *(f"{that} {joins} {them}" for that in ("that", "which") for joins in ("connects", "connect", "joins", "join")
      for them in ("them", "the two", "both")),
)  # fmt: skip
"""What is said of the base of a U between its arms."""
_BESIDE = tuple(
    f"to the {{}} of the {near}{one}" for near in ("nearest", "near", "front") for one in (" one", " block", "")
)
_SIDES = frozenset({"left", "right", "near", "far"})
_AT = ("on the", "at the", "along the", "to the", "towards the", "toward the", "in the", "is on the", "is at the",
       "lies on the", "lies at the", "on its", "at its", "and on the", "and at the")  # fmt: skip
_ACROSS = ("from left to right", "left to right", "from right to left")
_MOST = 4
"""So many parts of a letter are told at most."""


@dataclass(frozen=True, slots=True)
class Limb:
    """A part of a letter: which one, of how many blocks; where it runs, and on which side it is."""

    part: str
    count: int = 0
    way: str = ""
    side: str = ""
    across: bool = False
    inner: bool = False


class Limbs(Text):
    """Reads the parts of letters."""

    def limbs(self, kind: str, at: int) -> Iterator[tuple[tuple[Limb, ...], int]]:
        """ ", its bar three long and its stem pointing towards me", in this sentence or in the next ones."""
        found: tuple[Limb, ...] = ()
        while len(found) < _MOST:
            one = next(self._limb(kind, self._past_marks(at)), None)
            if one is None:
                return
            found, at = (*found, one[0]), one[1]
            yield found, at

    def _past_marks(self, at: int) -> int:
        for _ in range(2):
            at += self.text(at) in {",", "and", ".", ";", ":", "with", "?", "!"}
        return at

    def _limb(self, kind: str, at: int) -> Iterator[tuple[Limb, int]]:
        """One part with its length, and where it runs or lies; one of which nothing is told is none."""
        for limb, start in self._limb_named(kind, at):
            told, end = self._limb_told(limb, start)
            if told.count or told.way or told.side:
                yield told, end
        for limb, start in self._limb_counted(kind, at):
            told, end = self._limb_told(limb, start)
            if part := told.part or _which(kind, told, beside=self.past(end - 1, ["them"]) > 0):
                yield replace(told, part=part), end

    def _limb_named(self, kind: str, at: int) -> Iterator[tuple[Limb, int]]:
        """ "its bar", "a stem of two", "the long arm is three blocks long"."""
        start = self.past_any(at, *_LEADS) or at
        for part, names in _PARTS[kind].items():
            if end := self.past_any(start, *names):
                yield self._limb_long(Limb(part), end)

    def _limb_long(self, limb: Limb, at: int) -> tuple[Limb, int]:
        """How long it is, if this is told behind it."""
        start = self.past_any(at, *_OF) or at
        if not (count := self.number(start)):
            return limb, at
        end = start + 1 + (self.text(start + 1) == "block")
        end = self.past_any(end, *_LONG) or end
        return replace(limb, count=count), end

    def _limb_counted(self, kind: str, at: int) -> Iterator[tuple[Limb, int]]:
        """ "two more blocks", "three blocks for the bar", "one foot block", "the last one"."""
        if last := self.past_any(at, *_LAST):
            yield Limb("", 1), last
        if not (count := self.number(at)):
            return
        end = at + 1 + (self.text(at + 1) in {"more", "other", "further"})
        names = [(part, name) for part, ways in _PARTS[kind].items() for name in ways]
        if own := next(((part, stop) for part, name in names if (stop := self.past_any(end, f"{name} block"))), None):
            yield Limb(own[0], count), own[1]
            return
        end += self.text(end) == "block"
        named = self.past_any(end, "for the", "for its", "as the", "as its")
        if own := next(((part, stop) for part, name in names if named and (stop := self.past_any(named, name))), None):
            yield Limb(own[0], count), own[1]
            return
        yield Limb("", count), end

    def _limb_told(self, limb: Limb, at: int) -> tuple[Limb, int]:
        """Where it runs and where it lies."""
        while True:
            start = self.past_any(at, *_RUN) or at
            middle = self.past_any(start, *_FROM)
            way, end = self._limb_way(self.past_any(middle, *_RUN) or middle or start)
            side, stop = self._limb_side(start)
            if beside := next(
                (s for s in ("left", "right") if self.past_any(start, *(b.format(s) for b in _BESIDE))), ""
            ):
                limb = replace(limb, way=beside, side="near")
                at = self.past_any(start, *(b.format(beside) for b in _BESIDE))
            elif way and not limb.way and (start > at or middle):
                limb, at = replace(limb, part=limb.part or ("stem" if middle else ""), way=way), end
            elif side and not limb.side:
                limb, at = replace(limb, side=side), stop
            elif side in {"left", "right"} and not limb.way:
                limb, at = replace(limb, way=side), stop
            elif (across := self.past_any(at, *_ACROSS)) and not limb.across:
                limb, at = replace(limb, across=True), across
            elif not limb.part and (inner := self.past_any(at, *_JOINS)):
                limb, at = replace(limb, inner=True), inner
            else:
                return limb, at

    def _limb_way(self, at: int) -> tuple[str, int]:
        if end := self.past_any(at, *_TO_ME):
            return "near", end
        if end := self.past_any(at, *_AWAY):
            return "far", end
        start = self.past_any(at, "to the", "towards the", "toward the", "to", "towards")
        side = RANK.get(self.text(start or at), "")
        told = side in _SIDES and (start or self.text(at) in {"left", "right"})
        return (side, (start or at) + 1) if told else ("", at)

    def _limb_side(self, at: int) -> tuple[str, int]:
        """ "on the far side", "at the back"."""
        start = self.past_any(at, *_AT)
        side = RANK.get(self.text(start), "") if start else ""
        if side not in _SIDES:
            return "", at
        end = start + 1
        end += self.text(end) in {"side", "end", "edge"}
        return side, self.past_any(end, "of it", "of them") or end


def _which(kind: str, limb: Limb, *, beside: bool) -> str:
    """Which part blocks are of which this is not said: of an L what runs along, and the one at an end of that; of a U
    those on the left and on the right, and what joins them. None where they may be further blocks."""
    if kind == "L":
        beside = beside or bool(limb.side and limb.way)
        return "long" if limb.way == "far" and limb.count > 1 else "foot" if limb.count == 1 and beside else ""
    if kind == "U":
        return "inner" if limb.inner else limb.side if limb.side in {"left", "right"} and not limb.way else ""
    return ""
