"""What figures are made of, and how large they are."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import replace

from rpg.language.compose.heads import Heads
from rpg.language.compose.syntax import Chain, Listing, Noun, Phrase, Place, Predicate
from rpg.language.compose.words import Ways

_MADE_OF = (
    "of", "from", "which is made of", "that is made of", "which consists of", "each comprising", "each of",
    "each made of", "made of", "made from", "made out of", "consisting of", "comprising", "containing", "made up of",
    "built from", "built of", "out of", "with", "in",
)  # fmt: skip


class Contents(Heads, ABC):
    """Reads what stands behind the noun for a figure."""

    @abstractmethod
    def place(self, at: int) -> Ways[Place]:
        """A place that begins there."""

    @abstractmethod
    def verbs(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """A verb that begins there, with what belongs to it."""

    @abstractmethod
    def phrase(self, at: int) -> Ways[Phrase]:
        """A noun phrase that begins there, or several that are joined."""

    @abstractmethod
    def single(self, at: int) -> Ways[Phrase]:
        """A noun phrase that is not joined to others."""

    @abstractmethod
    def _noun(self, at: int) -> Ways[Phrase]:
        """A noun with all that belongs to it."""

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
        start = at + (self.text(at) in {",", ":"})
        found += [(chain, end) for chain, end in self.single(start) if isinstance(chain, Chain)]
        found += self._listing(start)
        if start > at:
            found += self._heights(start)
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
        if one := self.past_any(at, "one of them", "one", "the other one", "the other", "another"):
            at = one - 1
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
