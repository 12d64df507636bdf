"""The noun phrases and places of a text: all ways to read one that begins at a word, with where it ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import wraps
from typing import Any, TypeVar

from rpg.language.compose.items import BLOCK, COLOR, FIGURE, ORDINAL, PART, PATCH, RANK, SYMBOL, TABLE, Item
from rpg.language.compose.syntax import Both, Chain, Labels, Noun, Phrase, Place, Pronoun

T = TypeVar("T")
Ways = list[tuple[T, int]]

_PRONOUNS = frozenset(["it", "its", "they", "them", "their", "this", "that", "these", "those", "both"])
_DETS = {
    "a": "a", "an": "a", "the": "the", "each": "each", "every": "each", "all": "all", "both": "both", "no": "no",
    "another": "another", "any": "any", "this": "the", "that": "the", "these": "the", "those": "the", "my": "the",
    "our": "the", "either": "each", "second": "another", "further": "another",
}  # fmt: skip
_WORDS: dict[str, tuple[str, ...]] = {
    "on": ("on top of", "atop", "on to", "onto", "upon", "on"),
    "under": ("under", "underneath", "beneath", "below"),
    "left": ("to the left of", "on the left of", "left of", "to left of"),
    "right": ("to the right of", "on the right of", "right of", "to right of"),
    "front": ("in front of", "to the front of"),
    "behind": ("behind", "in back of", "at the back of"),
    "next": ("next to", "beside", "alongside", "by the side of", "right next to"),
    "near": ("near", "close to"),
    "between": ("in between", "between"),
    "touch": ("touching", "against", "in contact with"),
    "apart": ("away from", "from"),
    "far": ("far from", "far away from", "well away from"),
    "off": ("off of", "off", "outside of", "outside", "not on"),
    "in": ("inside of", "inside", "within", "into", "in", "at", "to"),
    "opposite": ("at the other end of",),
}
RELATIONS = sorted(
    ((words.split(), relation) for relation, ways in _WORDS.items() for words in ways), key=lambda way: -len(way[0])
)
_BARE: dict[str, tuple[str, ...]] = {
    "top": ("on top", "on the top", "at the top", "at the very top", "on the very top"),
    "bottom": ("at the bottom", "on the bottom", "below"),
    "middle": ("in the middle", "in between", "between them", "in the center", "in the centre", "at the center"),
    "left": ("on the left", "to the left", "at the left", "on its left", "to its left", "at the left end"),
    "right": ("on the right", "to the right", "at the right", "on its right", "to its right", "at the right end"),
    "front": ("in front",),
    "behind": ("behind", "in back", "at the back"),
    "free": ("free", "clear", "uncovered", "bare", "empty"),
    "table": ("on the table", "on the ground"),
    "flat": ("without being stacked", "not stacked", "flat on the table", "unstacked"),
    "side by side": ("side by side", "next to each other", "beside each other", "next to one another"),
    "touching": ("touching", "touching each other", "in contact"),
    "apart": ("apart", "apart from each other", "away from each other"),
    "alone": ("alone", "by themselves", "on their own", "on its own"),
}
BARE = sorted(((words.split(), place) for place, ways in _BARE.items() for words in ways), key=lambda way: -len(way[0]))
_HOW = {
    "directly": "directly", "right": "immediately", "immediately": "immediately", "straight": "directly",
    "somewhere": "somewhere", "anywhere": "somewhere",
}  # fmt: skip
_UNITS = {"cm": 1.0, "centimeters": 1.0, "centimetres": 1.0, "centimeter": 1.0, "mm": 0.1}
_MADE_OF = ("of", "from", "made of", "made from", "made out of", "consisting of", "comprising", "containing",
            "made up of", "built from", "built of", "out of", "with", "in")  # fmt: skip
_ENDED = frozenset({".", ";", "!", "?", ":", ","})


def remembered(rule: Callable[..., Ways[T]]) -> Callable[..., Ways[T]]:
    """A rule that is asked once only of what begins at a word."""

    @wraps(rule)
    def asked(self: Phrases, at: int, *more: object) -> Ways[T]:
        key = (rule.__name__, at, *more)
        if key not in self.known:
            self.known[key] = []  # what begins with itself has no reading
            self.known[key] = list(dict.fromkeys(rule(self, at, *more)))
        return self.known[key]

    return asked


class Phrases:
    """The words of one text, and what was found to begin at each."""

    def __init__(self, items: Sequence[Item]) -> None:
        self.items = items
        self.known: dict[Any, list[Any]] = {}

    def text(self, at: int) -> str:
        return self.items[at].text if 0 <= at < len(self.items) else ""

    def past(self, at: int, words: Sequence[str]) -> int:
        """Where these words end, if they begin here; else 0."""
        return at + len(words) if [i.text for i in self.items[at : at + len(words)]] == list(words) else 0

    def past_any(self, at: int, *ways: str) -> int:
        """Where the longest of these ends that begins here; else 0."""
        return max(self.past(at, way.split()) for way in ways)

    @remembered
    def phrase(self, at: int) -> Ways[Phrase]:
        """One noun phrase, or several joined by commas and "and"."""
        found: Ways[Phrase] = []
        for part, end in self.single(at):
            found.append((part, end))
            found += [(Both((part, *rest)), stop) for rest, stop in self._joined(end)]
            if end2 := self.past_any(end, "or"):
                found += [(Both((part, more), either=True), stop) for more, stop in self.single(end2)]
        return found

    def _joined(self, at: int) -> Ways[tuple[Phrase, ...]]:
        """What is joined to a noun phrase: ", B and C"."""
        found: Ways[tuple[Phrase, ...]] = []
        if last := self.past_any(at, "and", ", and", "plus"):
            found += [((part,), end) for part, end in self.single(last)]
        elif self.text(at) == ",":
            for part, end in self.single(at + 1):
                found += [((part, *rest), stop) for rest, stop in self._joined(end)]
        return found

    @remembered
    def single(self, at: int) -> Ways[Phrase]:
        """One noun phrase, not joined to others; "blue over red" counts as one."""
        found = self._simple(at)
        chains: Ways[Phrase] = []
        for part, end in found:
            if over := self.past_any(end, "over", "on top of", "on"):
                for under, stop in self.single(over):
                    parts = under.parts if isinstance(under, Chain) else (under,)
                    chains.append((Chain((part, *parts)), stop))
        return [*found, *chains]

    @remembered
    def _simple(self, at: int) -> Ways[Phrase]:
        found: Ways[Phrase] = list(self._labels(at))
        if self.text(at) in _PRONOUNS:
            found.append((Pronoun(self.text(at)), at + 1))
        found += self._some_of(at)
        found += self._others(at)
        found += self._noun(at)
        return found

    def _labels(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "A", "the cube Q", "the letter K", "the 4 block", "the block numbered 4"."""
        start = at + 1 if self.text(at) == "the" else at
        color = COLOR.get(self.text(start), "")
        start += bool(color)
        said = self.text(start) in BLOCK | set(SYMBOL)
        named = start + said
        named = (
            self.past_any(named, "labelled", "labeled", "numbered", "bearing the number", "with the letter") or named
        )
        if label := self.label(named):
            yield Labels((label,), color), named + 1
            if not said and self.text(named + 1) in BLOCK and not self.items[named + 1].many:
                yield Labels((label,), color), named + 2

    def label(self, at: int) -> str:
        """The symbol that a word is, or nothing."""
        if not 0 <= at < len(self.items):
            return ""
        item = self.items[at]
        if len(item.raw) == 1 and item.raw.isalpha() and (item.raw.isupper() or item.raw not in "ai"):
            return item.raw.upper()
        return item.raw if item.raw.isdigit() and len(item.raw) == 1 else ""

    def _amount(self, at: int) -> Iterator[tuple[Noun, int]]:
        """ "exactly two", "at least one", "three", "half"."""
        for words, bound, more in _BOUNDS:
            if (end := self.past(at, words)) and self.items[end : end + 1] and self.items[end].number:
                yield Noun(bound=bound, count=self.items[end].number + more), end + 1
        if self.items[at : at + 1] and self.items[at].number:
            yield Noun(count=self.items[at].number), at + 1

    def _some_of(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "two of the three red blocks", "each of them", "none of the towers", "both of these"."""
        ways = list(self._amount(at))
        if self.text(at) in {"each", "all", "both", "none", "neither", "any", "either"}:
            det = {"none": "no", "neither": "no", "either": "any"}.get(self.text(at), self.text(at))
            ways.append((Noun(det=det), at + 1))
        if self.text(at) == "half":
            ways.append((Noun(det="half"), at + 1))
        for some, end in ways:
            if of := self.past_any(end, "of"):
                yield from ((replace(some, of=whole), stop) for whole, stop in self._simple(of))
            elif some.det in {"all", "both"}:
                yield from ((replace(some, of=whole), stop) for whole, stop in self._noun(end))

    def _others(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the other two", "the rest", "the remaining blocks", "the third one", "the other tower"."""
        start = self.past_any(at, "the", "all the")
        if not start:
            return
        if self.text(start) == "rest":
            yield Noun(det="other", many=True), start + 1
            return
        other = self.past_any(start, "other", "others", "remaining", "leftover", "two other", "two others")
        count = 0
        if self.text(start) == "two" and other:
            count = 2
        if not other and (self.items[start : start + 1] and self.items[start].number):
            other = self.past_any(start + 1, "other", "others", "remaining")
            count = self.items[start].number
        if not other:
            return
        many = self.text(other - 1) == "others"
        if self.items[other : other + 1] and self.items[other].number and self.text(other) != "one":
            count, other = self.items[other].number, other + 1
        blank = Noun(det="other", count=count, many=many or count > 1)
        yield blank, other
        for noun, end in self._head(other, blank):
            yield noun, end
            yield from ((replace(noun, of=whole), stop) for whole, stop in self._whole(end))

    @remembered
    def _noun(self, at: int) -> Ways[Phrase]:
        """A determiner, a number, adjectives, a noun, and what stands behind it."""
        starts: Ways[Noun] = [(Noun(), at)]
        det = _DETS.get(self.text(at))
        if det:
            starts.append((Noun(det=det), at + 1))
            if self.text(at) == "the" and self.text(at + 1) == "only":
                starts.append((Noun(det="the"), at + 2))
            if self.text(at) == "a" and self.text(at + 1) in {"second", "third", "further", "fourth"}:
                starts.append((Noun(det="another"), at + 2))
        for start, end in list(starts):
            for amount, stop in self._amount(end):
                if not start.det or not amount.bound:
                    starts.append((replace(amount, det=start.det), stop))
        found: Ways[Phrase] = []
        for start, end in starts:
            for noun, stop in self._head(end, start):
                found += self._behind(noun, stop)
        return found

    def _head(self, at: int, noun: Noun) -> Iterator[tuple[Noun, int]]:
        """Adjectives and a noun; a colour or a rank may stand for one."""
        item = self.items[at] if at < len(self.items) else None
        if item is None:
            return
        text = item.text
        if text in COLOR and not noun.color:
            with_color = replace(noun, color=COLOR[text], many=item.many)
            yield with_color, at + 1
            yield from self._head(at + 1, replace(with_color, many=False))
        if text in RANK:
            yield from self._head(at + 1, replace(noun, ranks=(*noun.ranks, RANK[text])))
            if noun.det == "the" and RANK[text] in {"tall", "short", "former", "latter", "last"}:
                yield replace(noun, ranks=(*noun.ranks, RANK[text]), noun="one"), at + 1
        if text in ORDINAL and noun.det != "a":
            nth = ORDINAL[text]
            yield replace(noun, nth=nth, noun="one"), at + 1
            yield from self._head(at + 1, replace(noun, nth=nth))
        if text in {"plain", "such", "full", "filled", "more"}:
            yield from self._head(at + 1, noun)
        if text == "dims":
            size = tuple(int(n) for n in item.value.split("x"))
            yield from self._head(at + 1, replace(noun, size=size))
        if item.number and self.text(at + 1) in {"block", "high", "cube"} and self.text(at + 2) in FIGURE:
            yield from self._head(at + 2, replace(noun, size=(item.number,)))
        if (
            item.number
            and self.past(at + 1, ["by"])
            and (other := self.items[at + 2].number if at + 2 < len(self.items) else 0)
        ):
            yield from self._head(at + 3, replace(noun, size=(item.number, other)))
        kind = FIGURE.get(text) or PART.get(text) or ("block" if text in BLOCK else "") or SYMBOL.get(text, "")
        kind = kind or ("patch" if text in PATCH else "table" if text in TABLE else "one" if text == "one" else "")
        if kind:
            word = self.items[at + 1].value if kind == "word" and at + 1 < len(self.items) else ""
            yield replace(noun, noun=kind, many=noun.many or item.many, word=word), at + 1 + bool(word)
            if kind == "block" and self.text(at + 1) in {"tower", "row"} and noun.count:
                size = (noun.count,)
                figure = replace(noun, count=0, size=size, noun=self.text(at + 1), many=self.items[at + 1].many)
                yield figure, at + 2

    def _behind(self, noun: Noun, at: int) -> Ways[Phrase]:
        """What stands behind a noun: what it is made of, what it is a part of, how high it is."""
        found: Ways[Phrase] = [(noun, at)]
        if noun.noun in FIGURE.values():
            for measured, end in [(noun, at), *self._measured(noun, at)]:
                if end != at:
                    found.append((measured, end))
                made = "of" if self.text(end) in {"of", ","} else "from"
                found += [(replace(measured, content=of, made=made), stop) for of, stop in self._content(end)]
        elif noun.noun != "table":
            found += [(replace(noun, of=whole), stop) for whole, stop in self._whole(at)]
            if nth := self._counted_from(noun, at):
                found += nth
        return found

    def _content(self, at: int) -> Ways[Phrase]:
        """ "of three red blocks", ", blue over red", ", with Q on top" is not."""
        found: Ways[Phrase] = []
        if end := self.past_any(at, *_MADE_OF):
            found += self.phrase(end)  # fmt: skip
            if self.items[end : end + 1] and self.items[end].number and self.text(end + 1) != "block":
                found.append((Noun(count=self.items[end].number, noun="block", many=True), end + 1))
        if self.text(at) == ",":
            found += [(chain, end) for chain, end in self.single(at + 1) if isinstance(chain, Chain)]
        return found

    def _measured(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "three high", "three wide and two high", "two blocks high and three wide"."""
        start = at + (self.text(at) in {",", "which", "that"})
        sizes: dict[str, int] = {}
        while True:
            start += self.text(start) in {"and", "of"} and bool(sizes)
            if not (self.items[start : start + 1] and self.items[start].number):
                break
            end = start + 1 + (self.text(start + 1) == "block")
            measure = {"high": "high", "tall": "high", "wide": "wide", "long": "wide"}.get(self.text(end))
            if measure is None:
                break
            sizes[measure] = self.items[start].number
            start = end + 1
        if "high" in sizes and "wide" in sizes:
            yield replace(noun, size=(sizes["wide"], sizes["high"])), start
        elif sizes:
            yield replace(noun, size=tuple(sizes.values())), start

    def _whole(self, at: int) -> Ways[Phrase]:
        """ "of the row", "of it": what something is a part of."""
        end = self.past_any(at, "of", "in", "from")
        return self._simple(end) if end else []

    def _counted_from(self, noun: Noun, at: int) -> Ways[Phrase]:
        """ "the second block from the left"."""
        if not noun.nth or not (end := self.past_any(at, "from the", "from")):
            return []
        if (rank := RANK.get(self.text(end))) not in {"left", "right", "top", "bottom"}:
            return []
        counted = replace(noun, ranks=(*noun.ranks, rank))
        return [(counted, end + 1), *((replace(counted, of=w), stop) for w, stop in self._whole(end + 1))]

    @remembered
    def place(self, at: int) -> Ways[Place]:
        """A relation with what it is to, or a bare one."""
        found: Ways[Place] = []
        for words, name in BARE:
            if end := self.past(at, words):
                found.append((Place(name), end))
        no = self.past_any(at, "not", "never") or at
        for how, start in self._how(no):
            for words, relation in RELATIONS:
                if end := self.past(start, words):
                    found += [
                        (replace(how, relation=relation, of=thing, no=no > at), stop)
                        for thing, stop in self.phrase(end)
                    ]
        return found

    def _how(self, at: int) -> Iterator[tuple[Place, int]]:
        """ "directly", "somewhere", "at least 10 cm", and nothing."""
        yield Place(""), at
        if how := _HOW.get(self.text(at)):
            yield Place("", how=how), at + 1
        start = at
        bound = ""
        for words, sense, _ in _BOUNDS:
            if end := self.past(at, words):
                start, bound = end, sense
        if self.items[start : start + 1] and self.items[start].number and (unit := _UNITS.get(self.text(start + 1))):
            yield Place("", cm=self.items[start].number * unit, bound=bound), start + 2


_BOUNDS = [
    (words.split(), bound, more)
    for ways, bound, more in (
        ("exactly|one and only", "exactly", 0), ("at least|no fewer than|not fewer than|no less than", "least", 0),
        ("at most|no more than|not more than", "most", 0), ("more than", "least", 1), ("fewer than", "most", -1),
        ("only", "exactly", 0),
    )
    for words in ways.split("|")
]  # fmt: skip
