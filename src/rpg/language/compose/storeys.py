"""What stands in line told one after the other: "red, blue, red from bottom to top", "black at the bottom, then white,
and red on top"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.series import Series
from rpg.language.compose.syntax import Chain, Label, Noun, Phrase
from rpg.language.compose.words import Ways

_MIDDLE = ("in the middle", "in between", "in the center")
_AT: dict[str, dict[str, tuple[str, ...]]] = {
    "tower": {
        "bottom": ("at the bottom", "on the bottom", "on bottom", "at bottom", "below", "at the very bottom"),
        "middle": _MIDDLE,
        "top": ("on top", "at the top", "on the top", "at top", "at the very top", "on the very top"),
    },
    "row": {
        "left": ("on the left", "at the left", "at the left end", "on the left end"),
        "middle": _MIDDLE,
        "right": ("on the right", "at the right", "at the right end", "on the right end"),
    },
}
_ENDS = {"tower": ("bottom", "top"), "row": ("left", "right")}
_NEXT = (
    "and", ", and", ",", ", then", "then", "and then", ", and then", "then comes", ", then comes", "and then comes",
    ", and then comes", ", followed by", "followed by", ";",
)  # fmt: skip
_REVERSED = tuple(
    f"{just}{way}"
    for just in ("", "just ", "exactly ")
    for way in ("the other way around", "the other way round", "the opposite", "the reverse", "the reverse of that",
                "the reverse of it")
)  # fmt: skip


class Storeys(Series):
    """Reads them."""

    def in_turn(self, noun: Noun, at: int) -> Ways[Noun]:
        """ "red, blue, red from bottom to top", "A, B and C from left to right": its blocks one after the other."""
        if noun.noun not in _ENDS:
            return []
        placed = self.storeys(at, noun.noun)
        found = [(replace(noun, content=chain, made="of", order="listed"), end) for chain, end in placed]
        parts: list[Phrase] = []
        start = end = at
        while start:
            part, behind = self._storey(start)
            if part is None:
                break
            parts.append(part)
            end = behind
            bare = end if self.text(end) in lexicon.COLOR and not self.items[end].many else 0  # "red blue red blue"
            start = self.past_any(end, "and", ", and", ",", ", then", "then", "and then") or bare
        if noun.noun == "row" and len(parts) > 2 and parts == parts[::-1]:  # the same from either end
            found.append((replace(noun, content=Chain(tuple(parts)), made="of", order="listed"), end))
        end += self.text(end) == ","
        if len(parts) < 2:
            return found
        first, last = _ENDS[noun.noun]
        ahead = self.past_any(end, f"from {first} to {last}", f"from the {first} to the {last}", f"{first} to {last}")
        back = self.past_any(end, f"from {last} to {first}", f"from the {last} to the {first}", f"{last} to {first}")
        listed = Chain(tuple(parts[::-1] if ahead else parts))
        made = "each" if noun.count > 1 else "of"
        told = [(replace(noun, content=listed, made=made, order="listed"), ahead or back)] if ahead or back else []
        return [*found, *told]

    def storeys(self, at: int, kind: str = "tower") -> Ways[Chain]:
        """ "red at the bottom and blue on top", "on the bottom is black, then comes white, and on top red"."""
        parts: list[Phrase] = []
        marks: dict[int, str] = {}
        found: Ways[Chain] = []
        start = at
        while start:
            mark, begin = self._mark(kind, start)
            begin += (self.text(begin) in {"is", "comes", "goes", ","}) if mark else 0
            part, end = self._storey(begin)
            if part is None:
                break
            if not mark:
                mark, end = self._mark(kind, end + (self.text(end) in {"is", "goes", "comes"}), end)
            if mark:
                marks[len(parts)] = mark
                alone = len(parts) - 1 not in marks and self.text(start - 1) == "and" and self.text(start - 2) != ","
                if parts and alone and begin == start:
                    break  # "red at the bottom, blue and green on top": both of them are on top
            parts.append(part)
            if chain := _chain(parts, marks, *_ENDS[kind]):
                found.append((chain, end))
            start = self.past_any(end, *_NEXT)
        return found

    def reversed_so(self, at: int) -> Ways[Chain]:
        """ "just the other way around, blue at the bottom and red on top": as another one that was told."""
        if not (end := self.past_any(at, *_REVERSED)):
            return []
        again = self.storeys(end + (self.text(end) in {",", ":"}))
        return [(Chain((), back=True), end), *((replace(chain, back=True), stop) for chain, stop in again)]

    def _storey(self, at: int) -> tuple[Phrase | None, int]:
        """ "red", "a red one", "the A"."""
        begin = at + (self.text(at) in {"a", "the"})
        label, color = self.label(begin), lexicon.COLOR.get(self.text(begin), "")
        if not (label or color) or self.items[begin].many:
            return None, at
        end = begin + 1 + (self.text(begin + 1) in {"block", "one"})
        return Label(label) if label else Noun(color=color), end

    def _mark(self, kind: str, at: int, otherwise: int = 0) -> tuple[str, int]:
        """ "at the bottom": where it is, and where that ends."""
        for name, ways in _AT[kind].items():
            if end := self.past_any(at, *ways):
                return name, end
        return "", otherwise or at


def _chain(parts: list[Phrase], marks: dict[int, str], first: str, last: str) -> Chain | None:
    """The blocks from the last end to the first, if both ends are told and nothing else but the middle."""
    many = len(parts)
    ends = (marks.get(0), marks.get(many - 1))
    between = {at: mark for at, mark in marks.items() if 0 < at < many - 1}
    if many < 2 or ends not in {(first, last), (last, first)} or between not in ({}, {1: "middle"}):
        return None
    if between and many != 3:
        return None
    return Chain(tuple(parts[::-1] if ends[0] == first else parts))
