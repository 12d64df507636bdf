"""Several things told in one phrase: "the red, green and blue patches", "the digits 1 to 4", "every other block"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.heads import Heads
from rpg.language.compose.items import FIGURE, PATCH, RANK
from rpg.language.compose.syntax import Both, Clause, Label, Noun, Phrase, Place

_MOST = 10
_COUNTING = ("counting from the", "counted from the", "counting from", "count from the", "count from", "from the")


class Series(Heads):
    """Reads series."""

    def series(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """All ways to read one that begins here."""
        yield from self._colors(at)
        yield from self._range(at)

    def _colors(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the red, green and blue patches": one of each colour."""
        colors, start = self.color_list(at + (self.text(at) == "the"))
        noun = self.text(start)
        kind = "patch" if noun in PATCH else FIGURE.get(noun, "block" if noun == "block" else "")
        if colors and kind and self.items[start].many:
            yield Both(tuple(Noun(det="the", color=color, noun=kind) for color in colors)), start + 1

    def color_list(self, at: int) -> tuple[list[str], int]:
        """ "red, green and blue": several colours, and where they end."""
        colors: list[str] = []
        start = end = at
        while start and (color := lexicon.COLOR.get(self.text(start))):
            colors.append(color)
            end = start + 1
            start = self.past_any(end, "and", ", and", ",") or end
        return (colors, end) if len({*colors}) == len(colors) > 1 else ([], at)

    def _range(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "1 to 4", "A through E"."""
        first, start = self.label(at), self.past_any(at + 1, "to", "through", "up to")
        last = self.label(start) if start else ""
        if first and last and first.isdigit() == last.isdigit() and 0 < ord(last) - ord(first) < _MOST:
            yield Both(tuple(Label(chr(code)) for code in range(ord(first), ord(last) + 1))), start + 1

    def counting(self, at: int) -> Iterator[tuple[str, int]]:
        """ "counting from the left,": from where the places are counted that the clause tells of."""
        end = self.past_any(at, *_COUNTING)
        side = RANK.get(self.text(end), "") if end else ""
        if side in {"left", "right", "top", "bottom"} and (begin := self.past_any(end + 1, ",", ", and", "and")):
            yield side, begin


def counted(clause: Clause, side: str) -> Clause:
    """ "The second and the fourth carry a block", "put a block on the third": counted from a side."""
    said = [
        replace(one, of=_counted(one.of, side)) if isinstance(one, Place) and one.of is not None else one
        for one in clause.predicates
    ]
    return replace(clause, subject=_counted(clause.subject, side), predicates=tuple(said))


def _counted(phrase: Phrase, side: str) -> Phrase:
    if isinstance(phrase, Both):
        return replace(phrase, parts=tuple(_counted(part, side) for part in phrase.parts))
    return replace(phrase, ranks=(side,)) if isinstance(phrase, Noun) and phrase.nth and not phrase.ranks else phrase
