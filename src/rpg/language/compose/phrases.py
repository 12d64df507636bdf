"""The noun phrases and places of a text: all ways to read one that begins at a word, with where it ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.items import FIGURE, FIGURES, PART, PARTS, PATCH, RANK, SYMBOL, TABLE
from rpg.language.compose.syntax import Both, Chain, Label, Listing, Noun, Phrase, Pronoun
from rpg.language.compose.words import Text, Ways, remembered

_PRONOUNS = frozenset({"it", "they", "them", "this", "that", "these", "those", "both"})
_TOLD_BY = frozenset({"block", *SYMBOL})
"""What stands ahead of a symbol: "the cube Q", "the letters A and B"."""
_DETS = {
    "a": "a", "an": "a", "the": "the", "each": "each", "every": "each", "all": "all", "both": "both", "no": "no",
    "another": "another", "any": "any", "this": "the", "that": "the", "these": "the", "those": "the", "my": "the",
    "our": "the", "either": "each", "second": "another", "further": "another",
}  # fmt: skip
_MADE_OF = (
    "of", "from", "which is made of", "that is made of", "which consists of", "each comprising", "each of",
    "each made of", "made of", "made from", "made out of", "consisting of", "comprising", "containing", "made up of",
    "built from", "built of", "out of", "with", "in",
)  # fmt: skip


class Phrases(Text):
    """Reads noun phrases."""

    @remembered
    def phrase(self, at: int) -> Ways[Phrase]:
        """One noun phrase, or several joined by commas and "and"."""
        found: Ways[Phrase] = []
        many = at + (self.text(at) == "the")
        if self.text(many) in _TOLD_BY and self.items[many].many and self.label(many + 1):
            kind = SYMBOL.get(self.text(many), "")
            found += [(both, end) for both, end in self.phrase(many + 1) if _labelled(both, kind)]
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
        found += self._owned(at)
        found += self._some_of(at)
        found += self._others(at)
        found += self._noun(at)
        return [*found, *self._but(found)]

    def _but(self, found: Ways[Phrase]) -> Iterator[tuple[Phrase, int]]:
        """ "every block of it except the middle one"."""
        for whole, end in found:
            without = self.past_any(end, "except", "but", "except for", "other than", "save", "besides", ", except")
            if without and isinstance(whole, Noun) and whole.det in {"all", "each", "the"}:
                yield from ((replace(whole, but=part), stop) for part, stop in self._simple(without))

    def _owned(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "its two ends", "the pyramid's top block"."""
        owners: Ways[Phrase] = []
        if self.text(at) in {"its", "their"}:
            owners.append((Pronoun("it" if self.text(at) == "its" else "them"), at + 1))
        owners += [(noun, end + 1) for noun, end in self._plain(at) if self.text(end) in {"'s", "'"}]
        for owner, end in owners:
            starts = [(Noun(det="the"), end)]
            starts += [(replace(amount, det="the"), stop) for amount, stop in self._amount(end)]
            for start, behind in starts:
                yield from ((replace(noun, of=owner), stop) for noun, stop in self._head(behind, start))

    @remembered
    def _plain(self, at: int) -> Ways[Phrase]:
        """A noun phrase of which something may be said to be a part."""
        det = _DETS.get(self.text(at))
        if det not in {"the", "each"}:
            return []
        return [(noun, end) for noun, end in self._head(at + 1, Noun(det=det))]

    def _labels(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "A", "the cube Q", "the letter K", "the 4 block", "the block numbered 4"."""
        start = at + 1 if self.text(at) == "the" else at
        color = lexicon.COLOR.get(self.text(start), "")
        start += bool(color)
        said = self.text(start) in _TOLD_BY
        named = start + said
        named = (
            self.past_any(named, "labelled", "labeled", "numbered", "bearing the number", "with the letter") or named
        )
        if said and (color or self.items[start].many):
            return  # "the green cube 3" may be counted; several are told by `phrase`
        if label := self.label(named):
            yield Label(label, color), named + 1
            if not said and self.text(named + 1) == "block" and not self.items[named + 1].many:
                yield Label(label, color), named + 2

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
        for words, bound, more in BOUNDS:
            if (end := self.past(at, words)) and self.number(end):
                yield Noun(bound=bound, count=self.number(end) + more), end + 1
        if self.number(at):
            yield Noun(count=self.number(at)), at + 1

    def _some_of(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "two of the three red blocks", "each of them", "none of the towers", "both of these"."""
        ways = list(self._amount(at))
        if self.text(at) in {"each", "all", "both", "none", "neither", "any", "either"}:
            det = {"none": "no", "neither": "no", "either": "any"}.get(self.text(at), self.text(at))
            ways.append((Noun(det=det), at + 1))
        if self.past_any(at, "all but", "all except") and (left_out := self.number(at + 2)):
            ways.append((Noun(det="but", count=left_out), at + 3))
            yield Noun(det="but", count=left_out), at + 3
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
        if end := self.past_any(start, "one that is left", "one left", "one that is left over", "one left over"):
            yield Noun(det="other", count=1), end
            return
        other = self.past_any(start, "other", "others", "remaining", "leftover", "two other", "two others")
        count = 0
        if self.text(start) == "two" and other:
            count = 2
        if not other and self.number(start):
            other = self.past_any(start + 1, "other", "others", "remaining")
            count = self.number(start)
        if not other:
            return
        many = self.text(other - 1) == "others"
        if self.number(other) and self.text(other) != "one":
            count, other = self.number(other), other + 1
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
        found: Ways[Phrase] = []
        if self.text(at) == "another":
            found += self._behind(Noun(det="another", noun="one"), at + 1)
        for start, end in list(starts):
            for amount, stop in self._amount(end):
                if not start.det or not amount.bound:
                    starts.append((replace(amount, det=start.det), stop))
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
        if text in lexicon.COLOR and not noun.color:
            with_color = replace(noun, color=lexicon.COLOR[text], many=item.many)
            yield with_color, at + 1
            yield from self._head(at + 1, replace(with_color, many=False))
        if text in RANK:
            yield from self._head(at + 1, replace(noun, ranks=(*noun.ranks, RANK[text])))
            if noun.det == "the" and RANK[text] in {"tall", "short", "former", "latter", "last"}:
                yield replace(noun, ranks=(*noun.ranks, RANK[text]), noun="one"), at + 1
        if text in lexicon.ORDINAL and noun.det != "a":
            nth = lexicon.ORDINAL[text]
            yield replace(noun, nth=nth, noun="one"), at + 1
            yield from self._head(at + 1, replace(noun, nth=nth))
        if text in {"plain", "such", "full", "filled", "more"}:
            yield from self._head(at + 1, noun)
        if text == "dims":
            size = tuple(int(n) for n in item.value.split("x"))
            yield from self._head(at + 1, replace(noun, size=size))
        if item.number and self.text(at + 1) in {"block", "high"} and self.text(at + 2) in FIGURE:
            yield from self._head(at + 2, replace(noun, size=(item.number,)))
        if item.number and self.text(at + 1) == "by" and (other := self.number(at + 2)):
            yield from self._head(at + 3, replace(noun, size=(item.number, other)))
        kind = FIGURE.get(text) or PART.get(text) or ("block" if text == "block" else "") or SYMBOL.get(text, "")
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
        if noun.noun in FIGURES and self.text(at) == "in" and (color := lexicon.COLOR.get(self.text(at + 1))):
            found.append((replace(noun, color=color), at + 2))
        if noun.noun in FIGURES or (noun.noun == "one" and noun.det in {"a", "another"}):
            sizes = self._measured(noun, at) if noun.noun not in {"grid", "square"} else ()
            for measured, end in [(noun, at), *sizes]:
                if end != at:
                    found.append((measured, end))
                made = "of" if self.text(end) in {"of", ",", ":"} else "from"
                for of, stop in self._content(end):
                    each = stop + 1 if self.text(stop) == "each" else stop
                    told = "of" if each > stop or isinstance(of, Listing) else made
                    full = replace(measured, content=of, made=told)
                    found.append((full, each))
                    found += self._measured(full, each)
        elif noun.noun != "table":
            found += [(replace(noun, of=whole), stop) for whole, stop in self._whole(at)]
            found += self._counted_from(noun, at)
            if noun.noun in {"block", "one"} and noun.det == "the" and not noun.ranks:
                found += self._at_a_part(noun, at)
        return found

    def _at_a_part(self, noun: Noun, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the one at the far right corner", "the block at the other end"."""
        start = self.past_any(at, "at the", "in the", "on the")
        other = self.text(start) == "other" if start else False
        for part, end in self._head(start + other, noun) if start else ():
            if part.noun in PARTS:
                told = replace(part, det="other" if other else "the")
                yield told, end
                yield from ((replace(told, of=whole), stop) for whole, stop in self._whole(end))

    def _content(self, at: int) -> Ways[Phrase]:
        """ "of three red blocks", ", blue over red", ", one of two red blocks and one of three blue ones"."""
        found: Ways[Phrase] = []
        aside = self.text(at) == ","
        if end := self.past_any(at + aside, *_MADE_OF):
            if aside:
                return [(noun, stop + (self.text(stop) == ",")) for noun, stop in self.phrase(end)]
            found += self.phrase(end)
            if self.number(end) and self.text(end + 1) != "block":
                found.append((Noun(count=self.number(end), noun="block", many=True), end + 1))
        if self.text(at) in {",", ":"}:
            found += [(chain, end) for chain, end in self.single(at + 1) if isinstance(chain, Chain)]
            found += self._listing(at + 1)
            found += self._heights(at + 1)
        return found

    def _heights(self, at: int) -> Ways[Phrase]:
        """ "two, three and four blocks high"."""
        heights: list[int] = []
        while self.number(at):
            heights.append(self.number(at))
            at = self.past_any(at + 1, "and", ",", ", and") or at + 1
        at += self.text(at) == "block"
        if len(heights) < 2 or self.text(at) not in {"high", "tall"}:
            return []
        return [(Listing(tuple(Noun(count=n, noun="block", many=True) for n in heights)), at + 1)]

    def _listing(self, at: int) -> Ways[Phrase]:
        """What each of several figures is made of, one after the other."""
        found: Ways[Phrase] = []
        for first, end in self._listed(at):
            following: Ways[tuple[Phrase, ...]] = [((first,), end)]
            while following:
                more: Ways[tuple[Phrase, ...]] = []
                for parts, stop in following:
                    if len(parts) > 1:
                        found.append((Listing(parts), stop))
                    if start := self.past_any(stop, "and", ", and", ",", ";", "; and"):
                        more += [((*parts, part), last) for part, last in self._listed(start)]
                following = more
        return found

    def _listed(self, at: int) -> Ways[Phrase]:
        """ "one red on blue", "one of three red blocks", "green on yellow"."""
        found: Ways[Phrase] = [(chain, end) for chain, end in self.single(at) if isinstance(chain, Chain)]
        if self.text(at) == "one":
            of = self.past_any(at + 1, "of", "with", "made of", "is", "has")
            found += [(chain, end) for chain, end in self.single(of or at + 1) if isinstance(chain, Chain)]
            if of:
                found += [
                    (noun, end) for noun, end in self._noun(of) if isinstance(noun, Noun) and noun.noun == "block"
                ]
                if self.number(of) and self.text(of + 1) != "block":
                    found.append((Noun(count=self.number(of), noun="block", many=True), of + 1))
        return found

    def _measured(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """ "three high", "three wide and two high", "two blocks high and three wide"."""
        start = at + (self.text(at) in {",", "which", "that"})
        sizes: dict[str, int] = {}
        while True:
            start += self.text(start) in {"and", "of"} and bool(sizes)
            if not self.number(start):
                break
            end = start + 1 + (self.text(start + 1) == "block")
            measure = {"high": "high", "tall": "high", "wide": "wide", "long": "wide"}.get(self.text(end))
            if measure is None:
                break
            sizes[measure] = self.number(start)
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


BOUNDS = [
    (words.split(), bound, more)
    for ways, bound, more in (
        ("exactly|one and only", "exactly", 0), ("at least|no fewer than|not fewer than|no less than", "least", 0),
        ("at most|no more than|not more than", "most", 0), ("more than", "least", 1), ("fewer than", "most", -1),
        ("only", "exactly", 0),
    )
    for words in ways.split("|")
]  # fmt: skip


def _labelled(phrase: Phrase, kind: str) -> bool:
    """Whether blocks are told by their symbols, which are letters or digits where this is said."""
    labels = [part.label for part in phrase.parts if isinstance(part, Label)] if isinstance(phrase, Both) else []
    fits = not kind or all(label.isdigit() == (kind == "digit") for label in labels)
    return isinstance(phrase, Both) and len(labels) == len(phrase.parts) and fits
