"""The noun phrases and places of a text: all ways to read one that begins at a word, with where it ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.heads import NAMED, RELATIONS, TOLD_BY
from rpg.language.compose.items import FIGURES, PARTS, PATCH, SYMBOL, SYMBOL_KINDS
from rpg.language.compose.limbs import LETTERS
from rpg.language.compose.relatives import Relatives
from rpg.language.compose.some_of import labelled
from rpg.language.compose.syntax import (
    NOTHING,
    OWN,
    Both,
    Chain,
    Listing,
    Noun,
    Phrase,
    Pronoun,
    counted,
    is_figure,
)
from rpg.language.compose.words import Ways, remembered

_PRONOUNS = frozenset({"it", "they", "them", "this", "that", "these", "those", "both", "neither", "each"})
_SIGNS = {"plus": "+", "minus": "-", "equals": "=", "times": "*", "equal": "="}
_DETS = {
    "a": "a", "an": "a", "the": "the", "each": "each", "every": "each", "all": "all", "both": "both", "no": "no",
    "another": "another", "any": "any", "this": "the", "that": "the", "these": "the", "those": "the", "my": "the",
    "our": "the", "whichever": "the", "either": "each", "second": "another", "further": "another",
}  # fmt: skip
_STANDS = ("is", "comes", "stands")
_FLAT = ("on the table", "lying on the table", "flat on the table", "lying flat on the table")
"""Letters of blocks lie there anyway."""
_NOTHING = ("nothing", "nothing else", "none", "none other", "no other block", "no block", "not a block")
_THAT_STANDS = ("that is", "which is", "that stands", "which stands")


_IN_TURN = ("of", ":", ",", ", of", ".", "?", "that goes", "which goes", "going", "that reads")


class Phrases(Relatives):
    """Reads noun phrases."""

    @remembered
    def phrase(self, at: int) -> Ways[Phrase]:
        """One noun phrase, or several joined by commas and "and"."""
        found: Ways[Phrase] = []
        many = at + (self.text(at) == "the")
        named = self.past_any(many + 1, *NAMED) or many + 1
        if self.text(many) in TOLD_BY and self.items[many].many and self.label(named):
            kind = SYMBOL.get(self.text(many), "")
            found += [(both, end) for both, end in self.phrase(named) if labelled(both, kind)]
        found += self.series(at)
        for part, end in self.single(at):
            found.append((part, end))
            found += [(Both(_headed((part, *rest))), stop) for rest, stop in self._joined(end, "and", ", and", "plus")]
            found += [
                (Both(_headed((part, *rest)), either=True), stop) for rest, stop in self._joined(end, "or", ", or")
            ]
        if self.text(at) == "both" and "not" not in (item.text for item in self.items[max(0, at - 6) : at]):
            for pair, end in self.phrase(at + 1):
                if isinstance(pair, Both) and len(pair.parts) == 2:
                    again = any(isinstance(part, Noun) and part.det == "both" for part in pair.parts)
                    found += [] if again else [(pair, end)]  # "both orange and both white blocks" are four
        for first, end in self.single(at + 1) if self.text(at) == "neither" else ():
            nor = self.past_any(end, "nor", ", nor")
            both = [(_headed((first, second)), stop) for second, stop in self.single(nor)] if nor else []
            found += [(Both(parts, no=True), stop) for parts, stop in both]
        if either := self.past_any(at, "either", "either one of", "one of"):
            found += [way for way in self.phrase(either) if isinstance(way[0], Both) and way[0].either]
        return found

    def _joined(self, at: int, *words: str) -> Ways[tuple[Phrase, ...]]:
        """What is joined to a noun phrase: ", B and C"."""
        found: Ways[tuple[Phrase, ...]] = []
        if last := self.past_any(at, *words):
            found += [((part,), end) for part, end in self.single(last)]
        elif self.text(at) == ",":
            for part, end in self.single(at + 1):
                found += [((part, *rest), stop) for rest, stop in self._joined(end, *words)]
        return found

    @remembered
    def single(self, at: int) -> Ways[Phrase]:
        """One noun phrase, not joined to others; "blue over red" counts as one."""
        found = self.simple(at)
        chains: Ways[Phrase] = []
        for part, end in found:
            if over := self.past_any(end, "over", "on top of", "on"):
                for under, stop in self.single(over):
                    parts = under.parts if isinstance(under, Chain) else (under,)
                    chains.append((Chain((part, *parts)), stop))
        return [*found, *chains]

    @remembered
    def simple(self, at: int) -> Ways[Phrase]:
        found: Ways[Phrase] = list(self._labels(at))
        if nothing := self.past_any(at, *_NOTHING):
            other = self.text(nothing - 1) in {"else", "other"} or self.text(at + 1) == "other"
            found.append((replace(NOTHING, word="else" if other else ""), nothing))
        if one := self.past_any(at, "that one", "this one"):
            found.append((Pronoun("that one"), one))
        if two := self.past_any(at, "the two", "those two", "these two"):
            found.append((Pronoun("both"), two))
        if self.text(at) in _PRONOUNS:
            found.append((Pronoun(self.text(at)), at + 1))
        if self.text(at) == "which" and self._behind_comma(at):
            found.append((Pronoun("which"), at + 1))
        found += self._sign(at)
        found += self._everything(at)
        found += self._owned(at)
        found += self._some_of(at)
        found += self._others(at)
        found += self._noun(at)
        found += self._whichever(at)
        found += self._that(found)
        found += self._besides(found)
        return [*found, *self._but(found)]

    def _everything(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "everything red", "all that is blue": all such blocks, as many as the text says anywhere."""
        start = self.past_any(at, "everything", "everything that is", "all that is", "everything which is")
        color = lexicon.COLOR.get(self.text(start), "") if start else ""
        if color:
            counts = {
                self.items[n].number
                for n in range(len(self.items) - 2)
                if self.number(n) > 1 and lexicon.COLOR.get(self.text(n + 1)) == color
            }
            count = counts.pop() if len(counts) == 1 else 0
            yield Noun(det="all", count=count, color=color, noun="block", many=True), start + 1

    def _behind_comma(self, at: int) -> bool:
        """Whether a word stands behind a comma and a relation: ", on which"."""
        ahead = (at - len(words) for words, _ in RELATIONS if self.past(at - len(words), words) == at)
        return any(self.text(begin - 1) == "," for begin in ahead)

    def _owned(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "its two ends", "the pyramid's top block"."""
        owners: Ways[Phrase] = []
        if self.text(at) == "whose":
            owners.append((Pronoun("it"), at + 1))
        if self.text(at) in {"its", "their"}:
            owners.append((Pronoun("it" if self.text(at) == "its" else "them"), at + 1))
        owners += [(noun, end + 1) for noun, end in self._plain(at) if self._owns(end)]
        for owner, end in owners:
            starts = [(Noun(det="the"), end)]
            starts += [(replace(amount, det="the"), stop) for amount, stop in self._amount(end)]
            for start, behind in starts:
                yield from ((replace(noun, of=owner), stop) for noun, stop in self._head(behind, start))

    def _sign(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the plus", "the minus sign of the equation"."""
        sign = _SIGNS.get(self.text(at + 1), "") if self.text(at) == "the" else ""
        if sign:
            end = at + 2 + (self.text(at + 2) in {"sign", "symbol"})
            noun = Noun(det="the", noun="sign", word=sign)
            yield noun, end
            yield from ((replace(noun, of=whole), stop) for whole, stop in self._whole(end))

    def _owns(self, at: int) -> bool:
        """Whether a word is the "'s" behind an owner."""
        return at < len(self.items) and self.items[at].raw.lower() in {"'s", "'", "’s", "’"}

    @remembered
    def _plain(self, at: int) -> Ways[Phrase]:
        """A noun phrase of which something may be said to be a part."""
        det = _DETS.get(self.text(at))
        if det not in {"the", "each"}:
            return []
        return [(noun, end) for noun, end in self._head(at + 1, Noun(det=det))]

    @remembered
    def _noun(self, at: int) -> Ways[Phrase]:
        """A determiner, a number, adjectives, a noun, and what stands behind it."""
        starts: Ways[Noun] = [(Noun(), at)]
        det = _DETS.get(self.text(at))
        if det:
            starts.append((Noun(det=det, near=self.text(at) in {"these", "those"}), at + 1))
            if det == "all" and self.text(at + 1) == "the":
                starts.append((Noun(det="all"), at + 2))
            if self.text(at) == "the" and self.text(at + 1) == "only":
                starts.append((Noun(det="the"), at + 2))
            if self.text(at) == "a" and self.text(at + 1) in {"second", "third", "further", "fourth"}:
                starts.append((Noun(det="another"), at + 2))
        found: Ways[Phrase] = []
        if other := self.past_any(at, "every other", "every second", "each second"):
            starts.append((Noun(det="each", ranks=("alternate",)), other))
        if self.text(at) == "another":
            found += self._behind(Noun(det="another", noun="one"), at + 1)
        for start, end in list(starts):
            for amount, stop in self._amount(end):
                if not start.det and amount.count > 1:
                    found.append((amount, stop))  # "put two on the mat"
                if not start.det or not amount.bound:
                    starts.append((replace(amount, det=start.det, near=start.near), stop))
        for start, end in starts:
            found += self.told_apart(start, end)
            if start.det == "the" and start.count > 2:
                found.append((start, end))  # "none of the four"
            if start.det == "the" and start.count > 1:
                found += self._at_a_part(replace(start, noun="one", many=True), end)  # "the two in the middle"
            for noun, stop in self._head(end, start):
                found += self._behind(noun, stop)
        return found

    def _behind(self, noun: Noun, at: int) -> Ways[Phrase]:
        """What stands behind a noun: what it is made of, what it is a part of, how high it is."""
        found: Ways[Phrase] = [(noun, at)]
        if noun.noun in FIGURES and self.text(at) == "in" and (color := lexicon.COLOR.get(self.text(at + 1))):
            found.append((replace(noun, color=color), at + 2))
        if noun.noun in FIGURES or (noun.noun == "one" and noun.det in {"a", "another"}):
            figures = self._sized_and_filled(noun, at)
            if noun.noun in {"row", "line"} and not noun.many and noun.det:
                parts, end, _ = self.parts_in_turn(at)
                listed = Chain(tuple(parts[::-1]))
                found += [(replace(noun, content=listed, made="of", order="listed"), end)] if len(parts) > 2 else []
            found += [*figures[1:], *(way for figure, end in figures for way in self.ordered(figure, end))]
            plain = [(one, end) for one, end in figures if one.content is None or counted(one.content)]
            found += [way for figure, end in plain for way in self.one_by_one(figure, end)]
            if noun.noun in {"row", "column"} and noun.det == "the" and (noun.ranks or noun.nth):
                found += [(replace(noun, of=whole), stop) for whole, stop in self._whole(at) if is_figure(whole)]
        elif noun.noun != "table":
            if not noun.color and (end := self._own_color(at)):
                found.append((replace(noun, color=OWN), end))
            found += self.told_apart(noun, at)
            found += [(replace(noun, of=whole), stop) for whole, stop in self._whole(at)]
            found += self._counted_from(noun, at)
            if noun.noun in {"block", "one", *SYMBOL_KINDS} and noun.det == "the" and not noun.ranks:
                found += self._at_a_part(noun, at)
        return found

    def _own_color(self, at: int) -> int:
        """Where "of its own color", "of the mat's color", "of the same color" ends."""
        if self.text(at) not in {"of", "in"}:
            return 0
        if same := self.past_any(at + 1, "the same color", "that color", "its color", "its plain color", "their color"):
            return same
        owned = at + 3 + (at + 3 < len(self.items) and self._owns(at + 3)) if self.text(at + 1) == "the" else 0
        owner = owned and self._owns(at + 3) and self.text(at + 2) in {"block", *PATCH}
        return self.past_any(owned, "plain color", "color") if owner else 0

    def _sized_and_filled(self, noun: Noun, at: int) -> Ways[Noun]:
        """A figure with its size and what it is made of: "of two red blocks", "three high"."""
        starts: Ways[Noun] = [(noun, at), *self.measured(noun, at)]
        drawn = noun.noun in LETTERS and noun.det in {"a", ""}
        if drawn:  # "an L, open at the back, of five blocks", "a T on the table of five blocks"
            starts += self.ordered(noun, at)
            starts += [(noun, flat)] if (flat := self.past_any(at, *_FLAT)) else []
        figures: Ways[Noun] = []
        for measured, end in starts:
            filled = list(self._filled(measured, end))
            figures += [(measured, end), *filled]
            if start := self.past_any(end, *_IN_TURN) or end * (self.text(end) in lexicon.COLOR):
                figures += self.in_turn(measured, start)
            for figure, stop in filled if noun.noun in {"row", "tower"} else ():
                if (
                    figure.content is not None and counted(figure.content) and self.text(stop) in {",", ":"}
                ):  # "a row of four, red blue red blue ..."
                    turns = self.in_turn(measured, stop + 1)
                    figures += [way for way in turns if _as_many(way[0].content, figure.content)]
        laid = [(figure, flat) for figure, end in figures if drawn and (flat := self.past_any(end, *_FLAT))]
        return [*figures, *laid]

    def _filled(self, noun: Noun, at: int) -> Iterator[tuple[Noun, int]]:
        """What figures are made of; what "four" are may be told behind it: "of four, out of two red and two blue"."""
        apart = at + (self.text(at) == ",")
        of_each = self.text(apart) in {"each", "both"} or self.text(apart + 2) == "both" or self.each_has(at) > 0
        made = "of" if self.text(at) in {"of", ",", ":"} else "from"
        made = "from the" if made == "from" and self.text(at + 1) == "the" else made
        for of, stop in self._content(at):
            if noun.noun == "staircase" and isinstance(of, Noun) and of.noun == "tower":
                of = replace(of, noun="block")  # stacks of such blocks are its steps
            if isinstance(of, Chain | Listing) and not (noun.det or noun.count or noun.many):
                continue  # "stack red on blue" is no stack that is spoken of
            each = stop + 1 if self.text(stop) == "each" else stop
            alike = noun.count > 1 and self.text(at) == "of" and isinstance(of, Chain)
            listed = isinstance(of, Listing)
            told = "each" if each > stop or of_each or alike else "of" if listed else made
            full = replace(noun, content=of, made=told)
            yield full, each
            yield from self.measured(full, each)
            if listed and self.text(each) == ",":
                yield full, each + 1
            if isinstance(of, Noun) and counted(of) and not noun.size and (noun.count < 2 or made in {"of", "each"}):
                more = self.text(each) if self.text(each) not in {"of", "in"} else ""
                yield from self._filled(replace(noun, size=(of.count,)), each) if more else ()

    def _at_a_part(self, noun: Noun, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "the one at the far right corner", "the block at the other end", "the letter that is in the middle"."""
        whichever = self.text(at - 2) == "whichever"  # "whichever letter is in the middle"
        lead = self.past_any(at, *(_STANDS if whichever else _THAT_STANDS))
        own = self.past_any(lead or at, "at its", "in its")
        start = own or self.past_any(lead or at, "at the", "in the", "on the")
        other = self.text(start) == "other" if start else False
        for part, end in self._head(start + other, noun) if start else ():
            if part.noun in PARTS:
                told = replace(part, det="other" if other else "the", of=Pronoun("it") if own else None)
                if part.noun == "end":  # a block, so that it is on top of it that something lies
                    told = replace(told, noun=noun.noun, ranks=(*part.ranks, "end"))
                yield told, end
                yield from ((replace(told, of=whole), stop) for whole, stop in self._whole(end))


def _as_many(listed: Phrase | None, said: Phrase | None) -> bool:
    """Whether as many blocks are listed as were said."""
    return isinstance(listed, Chain) and isinstance(said, Noun) and len(listed.parts) == said.count


def _headed(parts: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """ "The red or the blue block": the noun of the last one is that of all of them. Plurals are read as series."""
    last = parts[-1]
    if not isinstance(last, Noun) or last.noun not in {"block", "patch", "one"} or last.det not in {"the", "a"}:
        return parts
    bare = [part for part in parts[:-1] if isinstance(part, Noun) and part.color and not part.noun]
    if last.many or last.count or not last.color or len(bare) < len(parts) - 1:
        return parts
    if any(part.det not in {last.det, ""} or part.many or part.count for part in bare):
        return parts
    return (*(replace(part, det=last.det, noun=last.noun) for part in bare), last)
