"""The places of a text: relations to what a noun phrase tells, and bare ones such as "on top"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language.compose.heads import BOUNDS, RELATIONS
from rpg.language.compose.items import RANK
from rpg.language.compose.phrases import Phrases
from rpg.language.compose.syntax import Place, Pronoun
from rpg.language.compose.words import Ways, remembered

_BARE: dict[str, tuple[str, ...]] = {
    "top": ("on top", "on the top", "on its top", "at the top", "at the very top", "on the very top"),
    "bottom": ("at the bottom", "on the bottom", "below"),
    "middle": ("in the middle", "in between", "between them", "in the center", "in the centre", "at the center"),
    "left": ("on the left", "to the left", "at the left", "at the left end"),
    "right": ("on the right", "to the right", "at the right", "at the right end"),
    "front": ("in front",),
    "behind": ("behind", "in back", "at the back"),
    "free": ("free", "clear", "uncovered", "bare"),
    "empty": ("empty",),
    "table": ("on the table", "on the ground"),
    "flat": ("without being stacked", "not stacked", "flat on the table", "unstacked"),
    "side by side": ("side by side", "next to each other", "beside each other", "next to one another"),
    "touching": ("touching", "touching each other", "in contact"),
    "apart": ("apart", "apart from each other", "away from each other"),
    "any order": (
        "in any order",
        "in whatever order",
        "in either order",
        "however you like",
        "in any order you like",
        "in no particular order",
        "in whichever order",
        "each in any order",
        "both in any order",
    ),
    "in turn": ("one behind the other", "one behind another"),
    "alone": ("alone", "by themselves", "on their own", "on its own"),
}
BARE = sorted(((words.split(), place) for place, ways in _BARE.items() for words in ways), key=lambda way: -len(way[0]))
_RISING = ("in order of height", "by height", "sorted by height", "ordered by height",
           *(f"from {the}short{er} to {the}tall{er}" for the in ("", "the ") for er in ("", "er", "est")))  # fmt: skip
_FALLING = tuple(f"from {the}tall{er} to {the}short{er}" for the in ("", "the ") for er in ("", "er", "est"))
_TO_RISE = ("the heights rising", "heights rising", "rising", "rising in height", "the heights increasing",
            "increasing in height", "getting taller", "growing taller")  # fmt: skip
_IN_LINE = frozenset({"top", "bottom", "middle", "left", "right"})
"""Where something is a part of what it is told of, if it is said to be "at" it."""
_HOW = {
    "directly": "directly", "right": "immediately", "immediately": "immediately", "straight": "directly",
    "just": "immediately", "flat": "flat", "somewhere": "somewhere", "anywhere": "somewhere",
}  # fmt: skip
_INTO_REGION = ("in the", "on the", "at the", "to the", "into the", "in", "onto the", "near the")
_SIDES = frozenset({"left", "right", "near", "far"})
_UNITS = {"cm": 1.0, "centimeters": 1.0, "centimetres": 1.0, "centimeter": 1.0, "mm": 0.1}


def _top(words: list[str]) -> str:
    """Whether it is said that something is on top, not only on."""
    return "top" if words[:2] == ["on", "top"] or words == ["atop"] else ""


class Places(Phrases):
    """Reads places."""

    @remembered
    def place(self, at: int) -> Ways[Place]:
        """A relation with what it is to, or a bare one."""
        found: Ways[Place] = []
        for words, name in BARE:
            if end := self.past(at, words):
                found.append((Place(name, how="at" if words[0] in {"at", "in"} and name in _IN_LINE else ""), end))
        for how, start in self._how(at):
            side = self.past_any(start, "to its", "on its", "at its", "in its")
            name = {"left": "left", "right": "right", "front": "front"}.get(self.text(side), "") if side else ""
            end = side + 1 + (self.text(side + 1) == "side")
            found += [(replace(how, relation=name, of=Pronoun("its")), end)] if name else []
        found += [(Place("sorted", how=order, side=side), end) for order, side, end in self.sorted_so(at)]
        found += self._by_height(at)
        found += self._region(at)
        for how, start in self._how(at):
            if how.cm and (end := self.past_any(start, "apart", "apart from each other", "away from each other")):
                found.append((replace(how, relation="apart"), end))
        no = self.past_any(at, "not") or at
        for how, start in self._how(no):
            for words, relation in RELATIONS:
                if end := self.past(start, words):
                    found += [
                        (replace(how, relation=relation, of=thing, no=no > at, how=how.how or _top(words)), stop)
                        for thing, stop in self.phrase(end)
                    ]
        return found

    def _by_height(self, at: int) -> Iterator[tuple[Place, int]]:
        """ "the heights rising to the right", "from shortest to tallest"."""
        if end := self.past_any(at, *_RISING):
            yield Place("rising"), end
        if end := self.past_any(at, *_FALLING):
            yield Place("rising", side="fall"), end
        for side in ("left", "right"):
            end = self.past_any(at, *(f"{rise} {to} the {side}" for rise in _TO_RISE for to in ("to", "towards")))
            if end:
                yield Place("rising", side=side), end

    def shared(self, at: int) -> Ways[Place]:
        """ "to the left" of "to the left or right of it": what it is to is told behind."""
        ends = [
            (end, relation)
            for words, relation in RELATIONS
            for end in (self.past(at, words), self.past(at, words[:-1]))
        ]
        return [(Place(relation), end) for end, relation in ends if end and self.text(end) in {"or", ","}]

    def _region(self, at: int) -> Iterator[tuple[Place, int]]:
        """ "in the left half of the table", "at the far edge of the table"."""
        start = self.past_any(at, *_INTO_REGION)
        ranks: list[str] = []
        while start and (rank := RANK.get(self.text(start))) in _SIDES:
            ranks.append(str(rank))
            start += 1
        if not start:
            return
        part = {"side": "half", "center": "middle"}.get(self.text(start), self.text(start))
        end = self.past_any(start + 1, "of the table", "of table")
        if part == "middle" and end and not ranks:
            yield Place("region", how="in the middle"), end
        elif part == "half" and len(ranks) == 1:
            yield Place("region", how=f"in the {ranks[0]} half"), end or start + 1
        elif part == "edge" and len(ranks) == 1 and end:
            yield Place("region", how=f"at the {ranks[0]} edge"), end
        elif part == "corner" and len(ranks) == 2:
            deep = [rank for rank in ranks if rank in {"near", "far"}]
            wide = [rank for rank in ranks if rank in {"left", "right"}]
            if deep and wide:
                corner = f"in the {deep[0]} {wide[0]} corner"
                yield Place("region", how=corner, side="" if end else "bare"), end or start + 1

    def _how(self, at: int) -> Iterator[tuple[Place, int]]:
        """ "directly", "somewhere", "at least 10 cm", and nothing."""
        yield Place(""), at
        if how := _HOW.get(self.text(at)):
            yield Place("", how=how), at + 1
        start = at
        bound = ""
        for words, sense, _ in BOUNDS:
            if end := self.past(at, words):
                start, bound = end, sense
        if self.items[start : start + 1] and self.items[start].number and (unit := _UNITS.get(self.text(start + 1))):
            yield Place("", cm=self.items[start].number * unit, bound=bound), start + 2
