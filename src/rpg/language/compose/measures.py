"""What is said of a figure behind its noun: how large it is, in which order its blocks stand, where it points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.blocks.figures import pyramid_size, staircase_size
from rpg.language import lexicon
from rpg.language.compose.items import FIGURE, RANK
from rpg.language.compose.limbs import LETTERS, Limb, Limbs
from rpg.language.compose.syntax import Noun

_SHAPED = frozenset({"figure", "form", "arrangement", "structure", "shape"})
_LONG = frozenset({"tower", "row", "line", "column", "one"})
_DRAWN = frozenset({"l", "t", "v", "u"})
_OF_ALL = (", each", "each", ", all", ", both", ", each of them", ", all of them")
_MEASURES = {"high": "high", "tall": "high", "wide": "wide", "long": "wide", "deep": "deep"}
_ORDERS: dict[str, tuple[str, ...]] = {
    "alphabetical": ("in alphabetical order", "alphabetically", "sorted alphabetically", "in alphabetic order"),
    "ascending": ("in ascending order", "in numerical order", "in increasing order", "in numeric order", "ascending"),
    "descending": ("in descending order", "in decreasing order", "descending"),
}  # fmt: skip
_ALTERNATING = (
    "alternating", "with alternating", "in alternating", "alternating between", "that alternate between", "alternately",
    "that alternate", "which alternate between", "of alternating",
)  # fmt: skip
_SHOWN = frozenset({"word", "equation"})
IN_CUBES = ("from left to right", ", from left to right", "left to right", "with letter block", "with block",
             "with the letter block", "out of letter block", "in letter block", "with number block", "in block",
             "with digit block")  # fmt: skip
"""What says no more of what is read than what it is made of, and how it is read."""
_SPACED = frozenset({"row", "line", "column"})
_EVENLY = ("evenly spaced", "spaced evenly", "with even spacing", "equally spaced", "with equal gaps",
           "with equal spacing")  # fmt: skip
_BETWEEN_THEM = tuple(
    f"{between}{the}{them}"
    for between in ("between ", "in between ")
    for the in ("", "the ", "all ", "any two ")
    for them in ("them", "block", "neighbor", "neighbors", "neighboring block", "letter", "digit", "each other")
)
_IN_TURN = tuple(
    f"{comma}{turns}" for comma in ("", ", ")
    for turns in ("alternating colors", "with alternating colors", "in alternating colors", "the colors alternating",
                  "whose colors alternate", "with the colors alternating", "colors alternating", "in turn")
)  # fmt: skip
_UPWARD = frozenset({"from the bottom up", "from bottom to top", "from bottom up", "bottom to top"})
_LAYERS = tuple(f"{with_}{layers}" for with_ in ("", "with ", "in ") for layers in ("layer of", "row of"))
_RUNNING = tuple(f"{run} {way}" for run in ("running", "going", "that runs", "which runs", "extending")
                 for way in ("from front to back", "front to back", "from back to front"))  # fmt: skip
_AS_TOLD = tuple(f"in {this} order{from_} left to right" for this in ("this", "that") for from_ in (" from", ","))
_WAYS: dict[str, tuple[str, ...]] = {
    "staircase": ("rising to", "going up to", "ascending to", "climbing to", "that rises to", "rising towards",
                  "that goes up to", "which goes up to", "that climbs to", "which climbs to", "that ascends to",
                  "that leads up to", "going up towards", "which rises to", "leading up to"),
    "L": ("with its foot to", "with its foot pointing to", "with the foot to", "with the foot pointing to",
          "with the foot on", "with its foot on", "pointing"),
    "U": ("open to", "open at", "open on", "open towards", "opening to", "with its opening to", "which is open to",
          "that opens to"),
}  # fmt: skip


class Measures(Limbs):
    """Reads what a figure is like."""

    def figure_at(self, at: int) -> tuple[str, int]:
        """The kind of figure that words are, and where they end: "plus sign", "L", "L shape", "cube"."""
        at += (self.text(at) in {"capital", "big"}) * self._drawn_letter(at + 1)
        at += (self.text(at) == "letter") * self._drawn_letter(at + 1)
        text = self.text(at)
        if text in _DRAWN and self.text(at + 1) == "shaped" and self.text(at + 2) in _SHAPED:
            return text.upper(), at + 3
        if text in _DRAWN and (self.items[at].raw.isupper() or self.text(at + 1) == "shape"):
            return text.upper(), at + 1 + (self.text(at + 1) == "shape")
        kind = FIGURE.get(text, "")
        return kind, at + 1 + (bool(kind) and self.text(at + 1) in {"sign", "shape"})

    def _drawn_letter(self, at: int) -> bool:
        """Whether it is a letter that may be built of blocks, or "letter" with one behind it."""
        at += self.text(at) == "letter"
        return self.text(at) in _DRAWN and at < len(self.items) and self.items[at].raw.isupper()

    def sized(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """A size ahead of the noun: "2x3", "two by three", "three-block", "three-step"."""
        if self.text(at) == "dims":
            yield replace(noun, size=tuple(int(n) for n in self.items[at].value.split("x"))), at + 1
        if not (number := self.number(at)):
            return
        colored = self.text(at + 2) in lexicon.COLOR  # "a two-block red tower"
        if self.text(at + 1) in {"block", "high"} and self.text(at + 2 + colored) in FIGURE:
            yield replace(noun, size=(number,)), at + 2
        if self.text(at + 1) == "step" and self.text(at + 2) in FIGURE:
            yield replace(noun, size=(staircase_size(number),)), at + 2
        if self.text(at + 1) == "by" and (other := self.number(at + 2)):
            third = self.number(at + 4) if self.text(at + 3) == "by" else 0
            size = (number, other, third) if third else (number, other)
            yield replace(noun, size=size), at + 3 + 2 * bool(third)

    def measured(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "three high", "three wide and two high", "of three steps", "with a base of three blocks"."""
        start = self.past_any(at, *_OF_ALL) or at + (self.text(at) in {",", "which", "that"})
        sizes: dict[str, int] = {}
        while True:
            start += self.text(start) in {"and", "of", "by"} and bool(sizes)
            if not self.number(start):
                break
            end = start + 1 + (self.text(start + 1) == "block")
            measure = _MEASURES.get(self.text(end))
            if measure is None or measure in sizes:
                break
            sizes[measure] = self.number(start)
            start = end + 1
        flat = noun.noun in {"grid", "square"}
        if set(sizes) == ({"wide", "deep"} if flat else {"wide", "high"}):
            yield replace(noun, size=(sizes["deep"], sizes["wide"]) if flat else (sizes["wide"], sizes["high"])), start
        elif noun.noun == "U" and set(sizes) == {"wide", "deep"} and not noun.limbs:
            yield replace(noun, limbs=(Limb("arm", sizes["deep"]), Limb("base", sizes["wide"]))), start
        elif len(sizes) == 1 and noun.noun == "wall":
            yield replace(noun, size=(sizes.get("wide", 0), sizes.get("high", 0))), start
        elif len(sizes) == 1 and noun.noun in ({"tower", "one"} if "high" in sizes else _LONG):
            yield replace(noun, size=tuple(sizes.values())), start
        if noun.noun == "staircase":
            yield from self._rising(noun, at)
        steps = self.past_any(at, "of", "with")
        if noun.noun == "staircase" and self.number(steps) and self.text(steps + 1) == "step":
            yield replace(noun, size=(staircase_size(self.number(steps)),)), steps + 2
        rows = self.past_any(at, "of", "with", ",")
        if noun.noun in {"grid", "wall"} and self.number(rows) and self.text(rows + 1) == "row":
            across = rows + 3 if self.text(rows + 2) in {"and", "of"} else 0
            color = lexicon.COLOR.get(self.text(across + 1), "")
            if self.number(across) and self.text(across + 1 + bool(color)) in {"column", "block"}:
                size = (self.number(rows), self.number(across))
                size = size if noun.noun == "grid" else size[::-1]
                yield replace(noun, size=size, color=color or noun.color), across + 2 + bool(color)
        if noun.noun == "pyramid":
            yield from self._layered(noun, at)
        base = self.past_any(at, "with a base of", "on a base of", "that has a base of")
        if noun.noun == "pyramid" and base and self.number(base):
            yield (
                replace(noun, size=(pyramid_size((self.number(base), 1)),)),
                base + 1 + (self.text(base + 1) == "block"),
            )

    def _layered(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "with layers of 4, 3, 2 and 1": a pyramid by its layers."""
        start = end = self.past_any(at + (self.text(at) == ","), *_LAYERS)
        found: list[int] = []
        while start and self.number(start):
            found.append(self.number(start))
            end = start + 1
            start = self.past_any(end, "and", ",", ", and", ", then", "then")
        if len(found) > 1 and found == list(range(found[0], 0, -1)):
            yield replace(noun, size=(pyramid_size((found[0], 1)),)), end + (self.text(end) == "block")

    def heights(self, at: int) -> tuple[list[int], int]:
        """ "two, three and four blocks high", "heights two and three": the numbers of several, and where that ends."""
        found: list[int] = []
        told = self.past_any(at, "heights", "with heights", "of heights", "with heights of", "heights of", "of height")
        at = told or at
        while self.number(at):
            found.append(self.number(at))
            at = self.past_any(at + 1, "and", ",", ", and") or at + 1
        at += self.text(at) == "block"
        high = self.text(at) in {"high", "tall"}
        return (found, at + high) if len(found) > 1 and (high or told) else ([], 0)

    def _rising(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "one, two and three high from left to right": the steps of a staircase."""
        heights, end = self.heights(at + (self.text(at) in {",", ":"}))
        if heights and list(range(1, len(heights) + 1)) in (heights, heights[::-1]):
            sized = replace(noun, size=(staircase_size(len(heights)),))
            told = self.past_any(end, "from left to right", ", from left to right", "left to right")
            way = "right" if heights[0] == 1 else "left"
            yield (replace(sized, way=way), told) if told else (sized, end)

    def _alternating(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "alternating red and blue": of so many blocks as were told without a colour."""
        start = self.past_any(at + (self.text(at) == ","), *_ALTERNATING)
        if in_turn := self.past_any(at, *_IN_TURN):
            yield replace(noun, order="alternating"), in_turn
        colors = [lexicon.COLOR.get(self.text(at), "") for at in (start, start + 2)] if start else []
        many, content = noun.size, noun.content
        if isinstance(content, Noun) and content == Noun(count=content.count, noun="block", many=True) and not many:
            many, content = (content.count,), None
        if all(colors) and len({*colors}) == 2 and self.text(start + 1) == "and" and content is None and not noun.color:
            end = start + 3 + (self.text(start + 3) == "block")
            yield replace(noun, order="alternating", word=" ".join(colors), size=many, content=None), end

    def sorted_so(self, at: int) -> Iterator[tuple[str, str, int]]:
        """ "ascending from bottom to top": the order, to which side it goes if this is told, and where it ends."""
        for order, ways in _ORDERS.items():
            for end in {self.past_any(at, way) for way in ways} - {0}:
                up, right = self.past_any(end, *_UPWARD), self.past_any(end, "from left to right", "left to right")
                yield order, "top" if up else "right" if right else "", up or right or end

    def _spaced(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "with 3 cm gaps", "with gaps of 3 cm between them", "5 cm apart", "evenly spaced"."""
        if noun.gaps or noun.noun not in _SPACED:
            return
        start = at + (self.text(at) == ",")
        if end := self.past_any(start, *_EVENLY):
            yield replace(noun, gaps=", evenly spaced"), end
        with_ = self.past_any(start, "with", "with a", "with a gap of", "with gaps of", "with a space of", "leaving",
                              "and gaps of", "leaving gaps of", "leaving a gap of", "with spaces of")  # fmt: skip
        told = with_ or start
        if not self.number(told) or self.text(told + 1) not in {"cm", "centimeters", "centimetres"}:
            return
        end, gap = told + 2, f"{self.number(told)} cm"
        if apart := self.past_any(end, "apart", "apart from each other") if not with_ else 0:
            yield replace(noun, gaps=f" {gap} apart"), apart
        elif with_ and (self.text(with_ - 1) == "of" or self.text(end) in {"gap", "gaps", "space", "spaces"}):
            end += self.text(with_ - 1) != "of"
            yield replace(noun, gaps=f" with gaps of {gap}"), self.past_any(end, *_BETWEEN_THEM) or end

    def ordered(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "in alphabetical order", "ascending from left to right", "rising to the right", "open to the left"."""
        yield from self._spaced(noun, at)
        if noun.noun in _SHOWN and (end := self.past_any(at, *IN_CUBES)):
            yield noun, end
        yield from self._alternating(noun, at)
        if noun.noun in LETTERS and not noun.limbs:
            yield from ((replace(noun, limbs=told), end) for told, end in self.limbs(noun.noun, at))
        start = at + (self.text(at) == ",")
        if noun.noun == "column" and (end := self.past_any(start, "going away from me", "away from me")):
            yield noun, end
        if noun.noun in {"row", "line"} and not noun.ranks and (end := self.past_any(start, *_AS_TOLD)):
            yield replace(noun, ranks=("left",)), end
        if noun.noun == "column" and (end := self.past_any(start, *_RUNNING)):
            yield replace(noun, way="far"), end
        for order, way, end in self.sorted_so(start):
            if (way == "top") if noun.noun == "tower" else (way != "top"):
                yield replace(noun, order=order), end
        if end := self.past_any(start, *_WAYS.get(noun.noun, ())):
            end += self.text(end) == "the"
            way = RANK.get(self.text(end), "")
            if way in {"left", "right"} or (way in {"near", "far"} and noun.noun != "staircase"):
                yield replace(noun, way=way), end + 1
