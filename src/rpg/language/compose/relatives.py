"""What stands behind a noun phrase and tells which ones are meant: "that has a red block on top"."""

from __future__ import annotations

from abc import ABC
from collections.abc import Iterator
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.heads import RELATIONS
from rpg.language.compose.some_of import SomeOf
from rpg.language.compose.syntax import Bears, Holding, Holds, Looks, Noun, Owns, Phrase, Predicate, Pronoun
from rpg.language.compose.words import Ways

_HOLDING = ("with", "without", "containing", "having", "including")

_CHOSEN = frozenset({"the", "each", "all", "both"})

_ONES = Noun(det="the", noun="one", many=True)


class Relatives(SomeOf, ABC):
    """Reads relative clauses."""

    def _whichever(self, at: int) -> Iterator[tuple[Phrase, int]]:
        """ "whichever stack has the blue block in it", "whichever of the two A is not on"."""
        start = self.past_any(at, "whichever", "whichever one")
        if not start:
            return
        one = Noun(det="the", noun="one")
        nouns = [(one, start), *self._head(start, Noun(det="the"))]
        if end := self.past_any(start, *(f"of {them}" for them in ("them", "these", "those", "those two", "the two"))):
            nouns = [(replace(one, of=Pronoun("them")), end)]
        for noun, end in nouns:
            yield from ((replace(noun, that=said), stop) for said, stop in [*self.verbs(end), *self._held(end)])

    def _held(self, at: int) -> Iterator[tuple[tuple[Predicate, ...], int]]:
        """ "green is not on": what stands behind a thing that something else is at."""
        for what, end in self.single(at):
            if start := self.past_any(end, "is", "are", "is not", "are not", "sits", "stands", "lies"):
                for words, relation in RELATIONS:
                    if stop := self.past(start, words):
                        yield (Holding(what, relation, no=self.text(start - 1) == "not"),), stop

    def _that(self, found: Ways[Phrase]) -> Iterator[tuple[Phrase, int]]:
        """ "the tower that has a pink block at the bottom", "those without any white", "the one on the patch"."""
        for phrase, end in found:
            noun = _ONES if isinstance(phrase, Pronoun) and phrase.word == "those" else phrase
            if not isinstance(noun, Noun) or noun.det not in _CHOSEN or noun.of or noun.content or noun.noun == "table":
                continue
            if start := self.past_any(end, "that", "which"):
                said = [*self.verbs(start), *self._held(start)]
                yield from ((replace(noun, that=one), stop) for one, stop in said)
                unlike = self.past_any(start, "is not", "are not")
                if unlike and (color := lexicon.COLOR.get(self.text(unlike))):
                    yield replace(noun, that=(Looks(Noun(color=color), no=True),)), unlike + 1
            elif self.text(end) == "whose":
                for part, behind in self._head(end + 1, Noun(det="the")):
                    yield from ((replace(noun, that=(Owns(part, one[0]),)), n) for one, n in self.verbs(behind)
                                if len(one) == 1)  # fmt: skip
            elif start := self.past_any(end, *_HOLDING):
                no = self.text(end) == "without"
                start = self.past_any(start, "any") or start
                yield from ((replace(noun, that=(Holds(what, no),)), stop) for what, stop in self.single(start))
                for what, stop in self.single(start):
                    if not no:
                        yield from ((replace(noun, that=(Bears(what, where),)), n) for where, n in self.place(stop))
            else:
                yield from ((replace(noun, that=(where,)), stop) for where, stop in self.place(end))

    def _besides(self, found: Ways[Phrase]) -> Iterator[tuple[Phrase, int]]:
        """ "the yellow block, which carries the blue one,": what is told of it by the way."""
        for phrase, end in found:
            if isinstance(phrase, Noun) and phrase.det in _CHOSEN and (start := self.past_any(end, ", which", ", who")):
                for said, stop in self.verbs(start):
                    if self.text(stop) == "," and self.text(start) != "is":
                        yield replace(phrase, besides=said), stop
                        yield replace(phrase, besides=said), stop + 1

    def _but(self, found: Ways[Phrase]) -> Iterator[tuple[Phrase, int]]:
        """ "every block of it except the middle one"."""
        for whole, end in found:
            without = self.past_any(end, "except", "but", "except for", "other than", "save", "besides", ", except")
            if without and isinstance(whole, Noun) and whole.det in {"all", "each", "the"}:
                yield from ((replace(whole, but=part), stop) for part, stop in self.simple(without))
