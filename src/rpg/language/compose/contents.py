"""What figures are made of, and how large they are."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.items import FIGURE, RANK
from rpg.language.compose.storeys import Storeys
from rpg.language.compose.syntax import Both, Chain, Clause, Label, Listing, Noun, Phrase, Place, Predicate
from rpg.language.compose.words import Ways

_MADE_OF = (
    "of", "from", "which is made of", "that is made of", "which consists of", "each comprising", "each of",
    "each made of", "made of", "made from", "made out of", "consisting of", "comprising", "containing", "made up of",
    "built from", "built of", "out of", "with", "in",
)  # fmt: skip
_OF_EACH = tuple(
    f"{each}{of}"
    for each in ("each", "each one", "each of them", "both", "both of them", "that are both", "which are both")
    for of in ("", " with", " of", " made of", " consisting of", " being", " is")
)
"""Behind these stands what each of several figures is made of."""
_ONE_OF_EACH = tuple(
    f"one {of} {color}{are}"
    for of, color in (("for each of the", "colors"), ("in each of the", "colors"), ("of each of the", "colors"),
                      ("for each", "color"), ("in each", "color"), ("per", "color"), ("of each", "color"))
    for are in ("", " :", " ,")
)  # fmt: skip
_AT_SIDE: dict[str, tuple[str, ...]] = {
    "far": ("at the back", "in the back", "in back", "behind", "at the rear"),
    "near": ("at the front", "in the front", "in front"),
    "left": ("on the left", "at the left", "to the left", "left"),
    "right": ("on the right", "at the right", "to the right", "right"),
    "middle": ("in the middle", "in between", "in the center"),
}


class Contents(Storeys, ABC):
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
    def simple(self, at: int) -> Ways[Phrase]:
        """A noun phrase that is no chain of what lies on what."""

    @abstractmethod
    def _noun(self, at: int) -> Ways[Phrase]:
        """A noun with all that belongs to it."""

    def _content(self, at: int) -> Ways[Phrase]:
        """ "of three red blocks", ", blue over red", ", one of two red blocks and one of three blue ones"."""
        found: Ways[Phrase] = []
        aside = self.text(at) == ","
        if each := self.past_any(at + aside, *_OF_EACH):
            found += [(chain, end) for chain, end in self.single(each) if isinstance(chain, Chain)]
            if found:
                return found
        if has := self.each_has(at):
            found += self.phrase(has)
            if self.number(has) and self.text(has + 1) != "block":
                found.append((Noun(count=self.number(has), noun="block", many=True), has + 1))
        if end := self.past_any(at + aside, *_MADE_OF):
            if aside:
                return [(noun, stop + (self.text(stop) == ",")) for noun, stop in self.phrase(end)]
            found += self.phrase(end)
            if self.number(end) and self.text(end + 1) != "block":
                found.append((Noun(count=self.number(end), noun="block", many=True), end + 1))
        start = at + (self.text(at) in {",", ":"})
        found += [(chain, end) for chain, end in self.single(start) if isinstance(chain, Chain)]
        found += self.storeys(start)
        found += self._listing(start)
        if start > at:
            found += self._heights(start)
        if one := self.past_any(start, *_ONE_OF_EACH):
            colors, end = self.color_list(one + (self.text(one) in {",", ":"}))
            found += [(Listing(tuple(Noun(color=c, noun="block", many=True) for c in colors)), end)] if colors else []
        if self.text(at) == "of" and (numbers := self._numbers(at + 1))[0]:
            found.append((Listing(numbers[0]), numbers[1]))
        return found

    def each_has(self, at: int) -> int:
        """ "(three towers,) and every tower has (two white blocks)": where it is told what each is made of; else 0."""
        start = self.past_any(at, "and", ", and", ",", ".", ";", ":")
        if not start or self.text(start) not in {"each", "every", "both"}:
            return 0
        of = self.past_any(start + 1, "of them", "one", "of these") or start + 1 + (self.text(start + 1) in FIGURE)
        return self.past_any(of, "has", "have", "is of", "is made of", "consists of", "contains", "is made from")

    def _numbers(self, at: int) -> tuple[tuple[Noun, ...], int]:
        """ "two, three and four red blocks": of how many blocks each of several towers is."""
        counts: list[int] = []
        while self.number(at):
            counts.append(self.number(at))
            at = self.past_any(at + 1, "and", ", and", ",") or at + 1
        color = lexicon.COLOR.get(self.text(at), "")
        if len(counts) < 2 or self.text(at + bool(color)) != "block":
            return (), at
        return tuple(Noun(count=n, color=color, noun="block", many=True) for n in counts), at + bool(color) + 1

    def _heights(self, at: int) -> Ways[Phrase]:
        """ "two, three and four blocks high"."""
        heights, end = self.heights(at)
        return [(Listing(tuple(Noun(count=n, noun="block", many=True) for n in heights)), end)] if heights else []

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
        found += self.storeys(at)
        start = at + (self.text(at) in {"a", "one"})
        start += self.text(start) == "all" and start > at
        if (color := lexicon.COLOR.get(self.text(start))) and start > at:
            end = start + 1 + (self.text(start + 1) == "one")
            found.append((Noun(color=color, noun="block", many=True), end))
        if one := self.past_any(at, "one of them", "one", "the other one", "the other", "another"):
            at = one - 1
            of = self.past_any(at + 1, "of", "with", "made of", "is", "has")
            found += [(chain, end) for chain, end in self.single(of or at + 1) if isinstance(chain, Chain)]
            found += self.storeys(of or at + 1)
            if of:
                found += [
                    (noun, end) for noun, end in self._noun(of) if isinstance(noun, Noun) and noun.noun == "block"
                ]
                if self.number(of) and self.text(of + 1) != "block":
                    found.append((Noun(count=self.number(of), noun="block", many=True), of + 1))
            many, high = self.number(at + 1), at + 2 + (self.text(at + 2) == "block")
            if many and self.text(high) in {"high", "tall"}:
                found.append((Noun(count=many, noun="block", many=True), high + 1))  # "one three high"
        return found

    def one_by_one(self, noun: Noun, at: int) -> Ways[Phrase]:
        """ "two rows: a back row of three and a front row of two", "two rows, blue behind and red in front"."""
        if self.text(at) not in {":", ","} or noun.count < 2:
            return []
        told = [(both, end) for both, end in self.phrase(at + 1) if isinstance(both, Both)]
        named = [
            (both, end) for both, end in told
            if len(both.parts) == noun.count
            and all(isinstance(part, Noun) and part.noun == noun.noun and part.det == "a" for part in both.parts)
        ]  # fmt: skip
        size = noun.size or ((noun.content.count,) if isinstance(noun.content, Noun) else ())
        one = Noun(det="a", noun=noun.noun, size=size)
        begun: Ways[tuple[Phrase, ...]] = [((), at + 1)]
        for _ in range(noun.count):
            begun = [((*parts, part), end) for parts, start in begun for part, end in self._at_a_side(one, start)]
            last = [(Both(parts), end) for parts, end in begun if len(parts) == noun.count]
            begun = [(parts, self.past_any(end, "and", ", and", ",", ";")) for parts, end in begun]
            begun = [(parts, start) for parts, start in begun if start]
        return [*named, *last]

    def _at_a_side(self, one: Noun, at: int) -> Ways[Noun]:
        """ "blue at the back", "A, B and C on the left", "the right one red": one of several figures."""
        found: Ways[Noun] = []
        start = at + (self.text(at) in {"the", "a", "one"})
        if color := lexicon.COLOR.get(self.text(start)):
            end = start + 1 + (self.text(start + 1) == "one")
            found += [(replace(one, color=color, ranks=(side,)), stop) for side, stop in self._side(end)]
        for what, end in self.phrase(at):
            if isinstance(what, Both) and all(isinstance(part, Label) for part in what.parts):
                found += [(replace(one, content=what, ranks=(side,)), stop) for side, stop in self._side(end)]
        side = RANK.get(self.text(at + 1), "") if self.text(at) == "the" else ""
        end = at + 2 + (self.text(at + 2) in {"one", one.noun})
        end += self.text(end) in {"is", "being", "in"}
        if side in _AT_SIDE and (color := lexicon.COLOR.get(self.text(end))):
            found.append((replace(one, color=color, ranks=(side,)), end + 1))
        return found

    def _side(self, at: int) -> list[tuple[str, int]]:
        return [(side, end) for side, ways in _AT_SIDE.items() if (end := self.past_any(at, *ways))]

    def parts_in_turn(self, at: int) -> tuple[list[Phrase], int, bool]:
        """ "red, white, black", "red then green then blue on top", "1 2 3 4": blocks one after the other, where they
        stop, and whether the last one is said to be on top."""
        parts: list[Phrase] = []
        start = end = at
        while True:
            begin = start + (self.text(start) in {"a", "the"} and not self.items[start].raw.isupper())
            label, color = self.label(begin), lexicon.COLOR.get(self.text(begin), "")
            if not (label or color) or self.items[begin].many:
                break
            parts.append(Label(label) if label else Noun(color=color))
            end = begin + 1 + (self.text(begin + 1) in {"block", "one"})
            start = self.past_any(end, "and", ", and", ",", ", then", "then", "and then", ", and then")
            if not start:
                if not (label and self.label(end)):
                    break
                start = end
        top = self.past_any(end, "on top", "at the top") if parts else 0
        return parts, top or end, bool(top)

    def told_apart(self, noun: Noun, at: int) -> Ways[Phrase]:
        """ "two patches, a yellow and a gray one", "three: black, orange and gray": of each colour one."""
        if self.text(at) not in {",", ":"} or noun.count < 2 or noun.color or noun.noun not in {"", "block", "patch"}:
            return []
        colors: list[str] = []
        end = at + 1
        while True:
            end += self.text(end) in {"a", "one"}
            color = lexicon.COLOR.get(self.text(end))
            if color is None:
                return []
            colors.append(color)
            end += 1 + (self.text(end + 1) in {"one", "block", "patch"})
            if len(colors) == noun.count:
                break
            end = self.past_any(end, ", and", "and", ",")
            if not end:
                return []
        more = self.past_any(end, ", and", "and", ",")
        more += self.text(more) in {"a", "one"} if more else 0
        if len({*colors}) < len(colors) or (more and self.text(more) in lexicon.COLOR):
            return []  # there are more of them than was said
        return [(Both(tuple(Noun(det="a", color=color, noun=noun.noun or "block") for color in colors)), end)]

    def last_at(self, what: Phrase, at: int) -> Ways[Clause]:
        """ "(a plus of four red blocks and a blue one) in the middle": where the last of its blocks is."""
        content = what.content if isinstance(what, Noun) else None
        last = content.parts[-1] if isinstance(content, Both) else None
        if not isinstance(last, Noun) or not last.color or last.count > 1 or last.many:
            return []
        one = Noun(det="the", color=last.color, noun="block")
        return [(Clause(one, (place,), "must"), end) for place, end in self.place(at) if place.of is None]
