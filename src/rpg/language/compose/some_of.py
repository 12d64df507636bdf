"""Noun phrases for some of several: "two of the three", "the rest", "the second from the left"."""

from __future__ import annotations

from abc import ABC
from collections.abc import Iterator
from dataclasses import replace

from rpg.language.compose.contents import Contents
from rpg.language.compose.items import RANK, shows
from rpg.language.compose.syntax import Both, Label, Noun, Phrase
from rpg.language.compose.words import Ways

_SAME = ("the same thing again", "the same again", "the same {} again", "an identical {}", "another identical {}",
         "another {} just like it", "another {} exactly like it", "another {} like it", "a second {} just like it",
         "one more of the same", "a copy of it", "an exact copy of it")  # fmt: skip
"""How a further figure is told that is like the one ahead of it."""
_ALL_ELSE = ("everything else", "all else", "all other block", "all the other block", "every other block there is")


class SomeOf(Contents, ABC):
    """Reads them."""

    def _some_of(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "two of the three red blocks", "each of them", "none of the towers", "both of these"."""
        ways = list(self._amount(at))
        if self.text(at) in {"each", "all", "both", "none", "neither", "any", "either"}:
            det = {"none": "no", "neither": "no", "either": "any"}.get(self.text(at), self.text(at))
            ways.append((Noun(det=det), at + 1))
        if self.past_any(at, "all but", "all except") and (left_out := self.number(at + 2)):
            ways.append((Noun(det="but", count=left_out), at + 3))
            yield Noun(det="but", count=left_out), at + 3
        if but := self.past_any(at, "all but", "all except", "each but", "every one but"):
            yield from self._all_but(but)
        if self.text(at) == "half":
            ways.append((Noun(det="half"), at + 1))
        for some, end in ways:
            if of := self.past_any(end, "of", "from", "out of"):
                wholes = [*self.simple(of), *self.series(of)]
                yield from ((replace(some, of=whole), stop) for whole, stop in wholes)
                yield from ((replace(some, of=whole), stop) for whole, stop in self._with_others(some.count, wholes))
                told = [(all_, stop) for all_, stop in self.phrase(of) if labelled(all_, "")]
                yield from ((replace(some, of=whole), stop) for whole, stop in told)
            elif some.det in {"all", "both"}:
                yield from ((replace(some, of=whole), stop) for whole, stop in self._noun(end))

    def _with_others(self, some: int, wholes: Ways[Phrase]) -> Iterator[tuple[Phrase, int]]:
        """ "(one of) the green blocks ... the other green block": how many they are is told with the others."""
        for whole, end in wholes:
            if not some or not isinstance(whole, Noun) or not whole.color or whole.count:
                continue
            if replace(whole, color="") != Noun(det="the", noun="block", many=True):
                continue
            for at in range(end, len(self.items)):
                left = list(self._others(at)) if self.text(at) == "the" else []
                told = [noun for noun, _ in left if isinstance(noun, Noun) and noun.color in {"", whole.color}]
                counts = {noun.count or 1 for noun in told if noun.noun in {"", "block", "one"} and not noun.of}
                many = any(noun.many and not noun.count for noun in told)
                if len(counts) == 1 and not many:
                    yield replace(whole, count=some + counts.pop()), end
                    break

    def _all_but(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "(all but) the middle block of the row": each of its blocks but this."""
        for part, end in self.simple(at):
            if isinstance(part, Noun) and part.of is not None and (part.ranks or part.nth):
                yield Noun(det="each", noun="block", of=part.of, but=replace(part, of=None)), end

    def _others(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the other two", "the rest", "the remaining blocks", "the third one", "the other tower"."""
        for two in ("", " of the two", " of them", " of these"):
            if end := self.past_any(at, f"whichever{two} is left", f"whichever{two} is left over"):
                yield Noun(det="other", count=1), end
        for word in ("one", "tower", "stack", "row"):
            if end := self.past_any(at, *(way.format(word) for way in _SAME)):
                yield Noun(det="another", noun="one", word="same"), end
        if end := self.past_any(at, *_ALL_ELSE):
            yield Noun(det="other", many=True, word="else"), end
        start = self.past_any(at, "the", "all the")
        if not start:
            return
        if self.text(start) == "rest":
            yield Noun(det="other", many=True), start + 1
            return
        if end := self.past_any(start, "other half", "second half", "remaining half"):
            yield Noun(det="other", many=True), end
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

    def _whole(self, at: int) -> Ways[Phrase]:
        """ "of the row", "of it": what something is a part of."""
        end = self.past_any(at, "of", "in", "from")
        if not end:
            return []
        listed = self.phrase(end) if self.text(at) == "of" else []  # "the letters from A to D" may be in this order
        return [*self.simple(end), *((told, stop) for told, stop in listed if labelled(told, ""))]

    def _counted_from(self, noun: Noun, at: int) -> Ways[Phrase]:
        """ "the second block from the left"."""
        several = noun.ranks in {("first",), ("last",)}
        if not (noun.nth or several) or not (end := self.past_any(at, "from the", "from")):
            return []
        if (rank := RANK.get(self.text(end))) not in {"left", "right", "top", "bottom"}:
            return []
        if noun.ranks == ("last",):
            rank = {"left": "right", "right": "left", "top": "bottom", "bottom": "top"}[rank]
        counted = replace(noun, ranks=(rank,) if several else (*noun.ranks, rank))
        return [(counted, end + 1), *((replace(counted, of=w), stop) for w, stop in self._whole(end + 1))]


def labelled(phrase: Phrase, kind: str) -> bool:
    """Whether blocks are told by their symbols, which are of a kind where this is said."""
    labels = [part.label for part in phrase.parts if isinstance(part, Label)] if isinstance(phrase, Both) else []
    fits = not kind or all(shows(label, kind) for label in labels)
    return isinstance(phrase, Both) and len(labels) == len(phrase.parts) and fits
