"""The clauses of a text: commands, statements, and what is told without a verb; all ways to read the whole."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from rpg.language import lexicon
from rpg.language.compose.items import FIGURES, RANK
from rpg.language.compose.places import Places
from rpg.language.compose.syntax import (
    Bears,
    Chain,
    Clause,
    Either,
    Holds,
    Label,
    Looks,
    Made,
    Noun,
    Phrase,
    Place,
    Predicate,
    Pronoun,
)
from rpg.language.compose.words import Ways, remembered

_LEADS = (
    "i want you to", "i want to see", "i would like you to", "i would like to see", "i would like", "i should like",
    "i want", "i need", "we need", "we want", "i would love", "you have", "you got", "we have", "i have", "there is",
    "there are", "there should be", "there must be", "give me", "gimme", "let us have", "let me see", "let there be",
    "can you", "could you", "would you", "will you", "show me", "get me", "let us", "let", "try to", "the goal is to",
    "the task is to", "you should", "hey", "yo", "hi", "hello", "goal :", "task :", "goal", "make sure that",
    "make sure", "see to it that", "make it so that", "need", "at the end", "in the end",
    "i have got", "you have got", "got", "have", "u got", "here is", "here are", "take", "use", "we got",
)  # fmt: skip
_BUILD = frozenset({
    "build", "make", "construct", "create", "form", "assemble", "lay", "arrange", "set", "erect", "produce",
    "prepare", "put", "stack", "stand", "place", "raise", "draw", "compose",
})  # fmt: skip
_BUILD_ME = ("me", "up", "out", "down", "together")
_PUT = frozenset({
    "put", "place", "set", "move", "lay", "stand", "bring", "position", "add", "stack", "get", "drop", "rest",
    "slide", "push", "shift", "transfer", "pile", "seat", "sit",
})  # fmt: skip
_LINED = (
    "lined up", "lined up from left to right", "lined up left to right", "in a row from left to right",
    "in a line from left to right", "from left to right", "left to right",
)  # fmt: skip
_STACK = frozenset({"stack", "pile"})
_TOWER = Noun(det="a", noun="tower")
_INTO = ("as", "in", "into", "in the shape of", "out as")
_THERE = ("there is", "there are", "you have", "we have", "i have", "here is", "here are")
_THEN = (
    ", finally", ", and finally", ". finally", "; finally", "and finally", ". lastly", ", then",
    ". then", "; then", "and then", ", and then", ". after that", ", after that", "and after that",
    ". afterwards", ". next", ", and after that", ", next",
)  # fmt: skip
_START = ("at the start", "at the beginning", "initially", "to begin with", "in the beginning", "at start", "at first")
_FRONTED = (",", "is", "are", "goes", "go", "stands", "stand", "there is", "there are", "there should be", "sits",
            "lies", ", there is", ", there are", "must be", "should be", "place", "put", ", put", ", place", "i want",
            "comes", "build", ", build")  # fmt: skip
_AUX = (
    "must", "should", "shall", "has to", "have to", "needs to", "need to", "is to", "are to", "may", "can", "will",
    "ought to", "is supposed to", "are supposed to", "does", "do", "has got to", "will have to", "would",
)  # fmt: skip
_BE = (
    "be", "is", "are", "sits", "sit", "stands", "stand", "lies", "lie", "rests", "rest", "goes", "go", "belongs",
    "belong", "stays", "stay", "remains", "remain", "ends up", "end up", "comes", "come", "gets", "get", "standing",
    "sitting", "lying", "resting", "being", "lands", "land", "ends", "end",
)  # fmt: skip
_DONE = frozenset({
    "placed", "put", "located", "positioned", "set", "laid", "stood", "left", "found", "moved", "kept",
    "sitting", "standing", "lying", "resting", "seated", "situated", "brought",
})  # fmt: skip
_FORM = ("form", "forms", "make", "makes", "become", "becomes", "make up", "makes up", "build", "constitute",
         "are arranged in", "are arranged as", "is arranged in", "are arranged into", "be arranged in",
         "be arranged as", "are in", "be in", "stand in", "lie in", "go in", "go into", "are stacked into",
         "stacked into", "turn into", "are built into", "is", "are")  # fmt: skip
_BEAR = ("carry", "carries", "support", "supports", "bear", "bears", "has", "have", "get", "gets", "hold", "holds",
         "carrying", "bearing", "supporting", "holding")  # fmt: skip
_SEPARATORS = (
    ", and then there is", ", and there is", ", and", ", but", ", while", ", with", ", plus", ", whereas", ", so that",
    "; and", ", leaving", ",", ";", ".", "!", "?", ":", "and", "but", "while", "plus", "with", "whereas", "so that",
)  # fmt: skip

_WITH = frozenset({", with", "with", ", leaving", "so that", ", so that"})
"""Behind these stands what is so of a thing that is told of, not a further thing."""


_STOPS = frozenset({".", "!", "?", ",", ";"})


class Step(NamedTuple):
    """A clause, where the next one begins, and of that: whether it has to say something, is of later, and is joined to
    this one, so that its verb may be the verb of both."""

    clause: Clause
    at: int
    said: bool = False
    later: bool = False
    joined: bool = False


class Reader(Places):
    """Reads the clauses of a text."""

    def steps(self, at: int, *, said: bool = False) -> Iterator[Step]:
        """The clauses that a text may go on with, the longest first. `said`: something has to be said in it."""
        for clause, end in sorted(self.clause(at), key=lambda way: -way[1]):
            if said and not clause.predicates:
                continue
            if clause.mood == "in":
                yield Step(clause, end + (self.text(end) == ","))
                continue
            if end >= len(self.items):
                yield Step(clause, end)
            for words in _SEPARATORS:
                if start := self.past_any(end, words):
                    yield Step(clause, self._begin(start), said=words in _WITH, joined=words not in _STOPS)
            for words in _THEN:
                if start := self.past_any(end, words):
                    yield Step(clause, self._begin(start), later=True)

    def _begin(self, at: int) -> int:
        """Where the next clause begins."""
        while self.text(at) in _STOPS:
            at += 1
        return at

    @remembered
    def clause(self, at: int) -> Ways[Clause]:
        """One clause; one that says several things at once is told as several."""
        found: Ways[Clause] = []
        if self.text(at) == "which":
            found += [(Clause(Pronoun("which"), said, "must"), end) for said, end in self.verbs(at + 1)]
        if begin := self.past_any(at, *_START, *(f"{start} ," for start in _START), "start :"):
            found += [(replace(said, mood="start"), end) for said, end in self.clause(begin)]
        if first := self.past_any(at, "first", "first ,", "first of all ,"):
            found += [(replace(said, first=True), end) for said, end in self.clause(first)]
        for start in self._leads(at):
            there = start > at and any(self.past(at, lead.split()) == start for lead in _THERE)
            found += self._command(start)
            found += self._fronted(start)
            if self.text(start) in {"spell", "write"}:
                found += self._spelled(start + 1)
            found += self._statement(start)
            found += [(Clause(what, said, "there" if there else ""), end) for what, said, end in self._existing(start)]
        if either := self.past_any(at, "either"):
            for one, end in self.clause(either):
                if one.predicates and one.other is None and (start := self.past_any(end, "or", ", or")):
                    found += [(replace(one, other=other), stop) for other, stop in self.clause(start) if _says(other)]
        if end := self.past_any(at, "nothing on", "none on", "nothing on top of", "nothing is on", "nothing may be on"):
            found += [(Clause(what, (Bears(None),)), stop) for what, stop in self.phrase(end)]
        late = [(said, start) for said, end in found if (start := self.past_any(end, *_START)) and said.predicates]
        found += [(replace(said, mood="start"), end) for said, end in late]
        return found

    def _leads(self, at: int) -> list[int]:
        """Where the clause itself may begin."""
        starts, new = [at], [at]
        while new:
            behind = {self.past_any(start, lead, f"{lead} ,") for start in new for lead in _LEADS} - {0}
            behind = {start for start in behind if self.text(start) not in {"it", "them"}}
            new = sorted(behind - set(starts))
            starts += new
        return starts

    def _command(self, at: int) -> Ways[Clause]:
        no = self.past_any(at, "do not", "never")
        verb = self.text(no or at)
        start = self.past_any((no or at) + 1, *_BUILD_ME) or (no or at) + 1
        found: Ways[Clause] = []
        if verb in _BUILD and not no:
            found += self._built(start, laid=verb in _PUT)
        if verb in _PUT or verb in _BUILD:
            for what, end in self.phrase(start):
                for said, stop in self._predicates(end):
                    if isinstance(said[0], Place):
                        if verb in _STACK and several(what):
                            said = (Made(_TOWER), *said)
                        found.append((Clause(what, said, "put"), stop))
        if verb in _STACK and not no:
            found += [(Clause(what, (Made(_TOWER),), "build"), end) for what, end in self.phrase(start)]
        if no:
            denied = [(replace(clause, predicates=_denied(clause.predicates)), end) for clause, end in found]
            found = [(clause, end) for clause, end in denied if clause.predicates]
        return found

    def _built(self, start: int, *, laid: bool) -> Ways[Clause]:
        """What is to be built, with what is said of it, or of what it is built; only figures are `laid` so."""
        found: Ways[Clause] = []
        for what, end in self.phrase(start):
            if not laid or (isinstance(what, Noun) and what.noun in FIGURES):
                found.append((Clause(what, (), "build"), end))
                found += [(Clause(what, said, "build"), stop) for said, stop in self._rest(end)]
            for into in {self.past_any(end, way) for way in _INTO} - {0}:
                for figure, stop in self.single(into):
                    if isinstance(figure, Noun) and figure.noun in FIGURES:
                        found.append((Clause(what, (Made(figure),), "build"), stop))
                        found += [
                            (Clause(what, (Made(figure), *said), "build"), last) for said, last in self._rest(stop)
                        ]
        return found

    def _existing(self, at: int) -> list[tuple[Phrase, tuple[Predicate, ...], int]]:
        """What is told without a verb: "a tower of two on the patch"."""
        found: list[tuple[Phrase, tuple[Predicate, ...], int]] = []
        for what, end in self.phrase(at):
            found.append((what, (), end))
            found += [(what, said, stop) for said, stop in self._rest(end)]
        return found

    def _spelled(self, at: int) -> Ways[Clause]:
        """ "spell CAT in a row"."""
        start = self.past_any(at, "the word", "out") or at
        word = self.items[start].value if start < len(self.items) else ""
        if not word.isalpha():
            return []
        end = self.past_any(start + 1, "in a row", "in a line") or start + 1
        what = Noun(det="a", noun="word", word=word)
        return [(Clause(what, (), "build"), end), *((Clause(what, s, "build"), e) for s, e in self._predicates(end))]

    def _fronted(self, at: int) -> Ways[Clause]:
        """ "behind it another row", "between both is the digit 0", "beside this stack goes a tower"."""
        found: Ways[Clause] = []
        if within := self.past_any(at, "in", "of"):
            found += [(Clause(what, (), "in"), end) for what, end in self.single(within) if isinstance(what, Noun)]
        for place, end in self.place(at):
            starts = {self.past_any(end, way) for way in _FRONTED} | {end}
            for start in starts - {0}:
                found += [(Clause(what, (place,)), stop) for what, stop in self.single(start)]
        return found

    def _statement(self, at: int) -> Ways[Clause]:
        found: Ways[Clause] = []
        for what, stop in self.phrase(at):
            for aside, start in ((None, stop), *self._aside(stop)):
                mood = "must" if self.past_any(start, *_AUX, "not") else "so"
                found += [(Clause(what, said, mood, aside), end) for said, end in self.verbs(start)]
        return found

    def _aside(self, at: int) -> Ways[Clause]:
        """ ", with Q on top,": between a subject and its verb."""
        found: Ways[Clause] = []
        if start := self.past_any(at, ", with", "with"):
            for what, end in self.single(start):
                for place, stop in self.place(end):
                    if place.of is None:
                        found.append((Clause(what, (place,), "must"), stop + (self.text(stop) == ",")))
        return found

    def _rest(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """What may be said of a thing that is told of without a verb, or behind a comma."""
        start = self.past_any(at, ", which") or (
            at + 1 if self.past_any(at + 1, *_LINED) and self.text(at) == "," else at
        )
        looks: Ways[tuple[Predicate, ...]] = [((Looks(how),), end) for how, end in self._ordered(start)]
        if color := lexicon.COLOR.get(self.text(start)):
            looks.append(((Looks(Noun(color=color)),), start + 1))
        if end := self.past_any(start, *_LINED):
            row = Noun(
                det="a", noun="row", ranks=("left",) if "left" in [i.text for i in self.items[start:end]] else ()
            )
            looks.append(((Made(row),), end))
        verbs = self.verbs(start) if start > at or self.text(start).endswith("ing") else []
        return [*looks, *self._predicates(start), *verbs]

    def _ordered(self, at: int) -> Ways[Phrase]:
        """ "red on green", "pink on blue and blue on pink": what is told of stacks."""
        return [*((how, end) for how, end in self.single(at) if isinstance(how, Chain)), *self._listing(at)]

    @remembered
    def _predicates(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """Places, one after the other: "on the patch and left of A", "off the mat but not on the table"."""
        found: Ways[tuple[Predicate, ...]] = []
        for into in {self.past_any(at, way) for way in ("in", "into", "as")} - {0}:
            for figure, end in self.single(into):
                if isinstance(figure, Noun) and figure.noun in FIGURES and figure.det in {"a", ""}:
                    found.append(((Made(figure),), end))
        found += self._either(at)
        for place, end in self.place(at):
            found.append(((place,), end))
            for more, stop in self.place(end):
                if more.of is None and more.relation in {"flat", "side by side", "touching"}:
                    found.append(((place, more), stop))
            ways = {self.past_any(end, way) for way in ("and", "but", ", but", ", and", ",")} - {0}
            ways -= set() if place.no else {self.past_any(end, "but"), self.past_any(end, ", but")}
            ways -= {self.past_any(end, "and"), self.past_any(end, ", and")} if place.no else set()
            for start in ways:
                more_said = [*self._predicates(start), *(self.verbs(start) if self.text(start - 1) != "," else ())]
                found += [((place, *more), stop) for more, stop in more_said]
        return found

    def _either(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "on the patch or next to it", "to the left or right of the block"."""
        found: Ways[tuple[Predicate, ...]] = []
        start = self.past_any(at, "either") or at
        for place, end in [*self.place(start), *self.shared(start)]:
            if behind := self.past_any(end, "or", ", or"):
                if (side := RANK.get(self.text(behind), "")) in {"left", "right"} and place.relation in {
                    "left",
                    "right",
                }:
                    found.append(((Either((place, replace(place, relation=side))),), behind + 1))
                for other, stop in self.place(behind):
                    one = place if place.of is not None else replace(place, of=other.of)
                    if not one.no and not other.no:
                        found.append(((Either((one, other)),), stop))
        return found

    @remembered
    def verbs(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """A verb with what belongs to it, and more of such."""
        found: Ways[tuple[Predicate, ...]] = []
        for said, end in self._verb(at):
            found.append((said, end))
            for start in {self.past_any(end, way) for way in ("and", "but", ", but", ", and")} - {0}:
                found += [((*said, *more), stop) for more, stop in self.verbs(start)]
        return found

    def _verb(self, at: int) -> Ways[tuple[Predicate, ...]]:
        found: Ways[tuple[Predicate, ...]] = []
        aux = self.past_any(at, *_AUX) or at
        no = self.past_any(aux, "not") or aux
        denied = no > aux
        start = no + (self.text(no) in {"both", "all"} and not denied)
        if self.text(at) in {"may", "can"} and not denied:
            return found
        ends = {end + (self.text(end) in {"both", "all"}) for way in _BE if (end := self.past_any(start, way))}
        for end in sorted(ends | {end + 1 for end in ends if self.text(end) in _DONE}):
            not_there = self.past_any(end, "not") or end
            here = list(self._predicates(not_there))
            here += [((Looks(like),), stop) for like, stop in self.single(not_there)]
            here += [((Looks(like),), stop) for like, stop in self._listing(not_there)]
            if denied or not_there > end:  # what is joined to it may be denied, too, or not
                here = [(opposite, stop) for said, stop in here if (opposite := _denied(said))]
            found += here
        for end in {self.past_any(start, way) for way in _FORM} - {0}:
            for figure, stop in self.single(end):
                if isinstance(figure, Noun) and figure.noun in FIGURES and not denied:
                    found.append(((Made(figure),), stop))
                    that = self.past_any(stop, "that", "which") or stop
                    found += [((Made(figure), *more), last) for more, last in self.verbs(that)]
                    found += [((Made(figure), *more), last) for more, last in self._predicates(stop)]
        for end in {self.past_any(start, way) for way in _BEAR} - {0}:
            if nothing := self.past_any(end, "nothing on top", "nothing on it", "nothing"):
                found.append(((Bears(None),), nothing))
            if denied:
                continue
            for what, stop in self.phrase(end):
                found.append(((Bears(what),), stop))
                found += self._borne(what, stop)
        if (end := self.past_any(start, "contain", "contains", "include", "includes")) and not denied:
            found += [((Holds(what),), stop) for what, stop in self.single(end)]
        if end := self.past_any(start, "touch", "touches", "touching"):
            found += [((Place("touch", of, no=denied),), stop) for of, stop in self.phrase(end)]
            if each := self.past_any(end, "each other", "one another"):
                found.append(((Place("touching", no=denied),), each))
        return found

    def _borne(self, what: Phrase, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "a red block on its middle and a blue one on each end"."""
        found: Ways[tuple[Predicate, ...]] = []
        for place, end in self.place(at):
            found.append(((Bears(what, place),), end))
            if start := self.past_any(end, "and", ", and", ","):
                for more, stop in self.single(start):
                    found += [((Bears(what, place), *rest), last) for rest, last in self._borne(more, stop)]
        return found


def _says(clause: Clause) -> bool:
    """Whether a clause says one thing, and by itself."""
    return bool(clause.predicates) and clause.other is None and clause.aside is None


def several(phrase: Phrase) -> bool:
    """Whether more than one block is told."""
    return not isinstance(phrase, Label | Noun) or (isinstance(phrase, Noun) and (phrase.many or phrase.count > 1))


def _denied(said: tuple[Predicate, ...]) -> tuple[Predicate, ...]:
    """The opposite of one place that is said; nothing of more, and of what forms or looks so."""
    return tuple(replace(one, no=not one.no) for one in said if isinstance(one, Place)) if len(said) == 1 else ()
