"""The clauses of a text: commands, statements, and what is told without a verb; all ways to read the whole."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from rpg.language import lexicon
from rpg.language.compose.becoming import Becoming
from rpg.language.compose.items import FIGURES
from rpg.language.compose.series import counted
from rpg.language.compose.syntax import (
    STAY,
    TOWER,
    Among,
    Bears,
    Both,
    Clause,
    Label,
    Looks,
    Made,
    Noun,
    Phrase,
    Place,
    Predicate,
    Pronoun,
    is_figure,
)
from rpg.language.compose.verbs import AUX, BUILT, STAYS, opposite_of
from rpg.language.compose.words import Ways, remembered

_LEADS = (
    "i want you to", "i want to see", "i would like you to", "i would like to see", "i would like", "i should like",
    "i want", "i need", "we need", "we want", "i would love", "you have", "you got", "we have", "i have", "there is",
    "there are", "there is to be", "there are to be",
    "there should be", "there must be", "give me", "gimme", "let us have", "let me see", "let there be",
    "can you", "could you", "would you", "will you", "show me", "get me", "let us", "let", "try to", "the goal is to",
    "the task is to", "you should", "hey", "yo", "hi", "hello", "goal :", "task :", "goal", "make sure that",
    "make sure", "see to it that", "make it so that", "need", "at the end", "in the end",
    "i have got", "you have got", "got", "have", "u got", "here is", "here are", "take", "use", "we got",
)  # fmt: skip
_BUILD = frozenset({
    "build", "make", "construct", "create", "form", "assemble", "lay", "arrange", "set", "erect", "produce",
    "prepare", "put", "stack", "stand", "place", "raise", "draw", "compose", "show", "write",
})  # fmt: skip
_BUILD_ME = ("me", "up", "out", "down", "together")
_PUT = frozenset({
    "put", "place", "set", "move", "lay", "stand", "bring", "position", "add", "stack", "get", "drop", "rest",
    "slide", "push", "shift", "transfer", "pile", "seat", "sit",
})  # fmt: skip
_LINED = (
    "lined up from left to right", "lined up left to right", "in a row from left to right",
    "in a line from left to right", "from left to right", "left to right",
)  # fmt: skip
_STACK = frozenset({"stack", "pile"})
_CAP = frozenset({"cap", "top", "crown"})
_PILED_AT = frozenset({"on", "in", "off", "under", "region", "top", "table"})
"""Where one may stack things; what is stacked beside something, or between, need not stand on the table."""
_BEHIND_COMMA = frozenset({"in turn", "side by side", "rising", "any order"})
_LINE = Noun(det="a", noun="line")
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
_SEPARATORS = (
    ", and then there is", ", and there is", ", and", ", but", ", while", ", with", ", plus", ", whereas", ", so that",
    ", of which", ", except that", "except that", ", such that", "such that", "in such a way that", ", where", "where",
    "in which", ", in which",
    "; and", ", leaving", ",", ";", ".", "!", "?", ":", "and", "but", "while", "plus", "with", "whereas", "so that",
)  # fmt: skip

_ONE_OF_THEM = ("one of them", "one of which", "one of these", "one")
_TO_BE = ("must be", "has to be", "needs to be", "should be", "shall be", "is to be", "is", "being")
_NOT_TO_BE = ("is not", "is not to be", "must not be", "should not be", "shall not be", "may not be", "can not be")
_NOT_TOGETHER = tuple(
    f"{must}both be {there}"
    for must in ("", "must not ", "should not ", "may not ", "can not ")
    for there in ("there", "on it", "chosen", "among them")
)
_WITH = frozenset({
    ", with", "with", ", leaving", "so that", ", so that", ", except that", "except that", ", such that", "such that",
    "in such a way that", ", where", "where", "in which", ", in which",
})  # fmt: skip
"""Behind these stands what is so of a thing that is told of, not a further thing."""


_STOPS = frozenset({".", "!", "?", ",", ";", ":"})


class Step(NamedTuple):
    """A clause, where the next one begins, and of that: whether it has to say something, is of later, and is joined to
    this one, so that its verb may be the verb of both."""

    clause: Clause
    at: int
    said: bool = False
    later: bool = False
    joined: bool = False


class Reader(Becoming):
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
            for words in (*_SEPARATORS, ""):
                if (start := self.past(end, words.split())) and (words or self.text(end) in {"whose", "without"}):
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
        for side, begin in self.counting(at):
            found += [(counted(said, side), end) for said, end in self.clause(begin)]
        if begin := self.past_any(at, *_START, *(f"{start} ," for start in _START), "start :"):
            found += [(replace(said, mood="start"), end) for said, end in self.clause(begin)]
        if first := self.past_any(at, "first", "first ,", "first of all ,"):
            found += [(replace(said, first=True), end) for said, end in self.clause(first)]
        if of := self.past_any(at, "of which"):
            for amount, begin in self._amount(of):
                some = replace(amount, of=Pronoun("which"))
                found += [(Clause(some, said, "must"), end) for said, end in self.verbs(begin)]
        if which := self.past_any(at, "each of which", "all of which", "both of which", "none of which"):
            some = Noun(det={"none": "no"}.get(self.text(at), self.text(at)), of=Pronoun("which"))
            found += [(Clause(some, said, "must"), end) for said, end in self.verbs(which)]
        for start in self._leads(at):
            there = start > at and any(self.past(at, lead.split()) == start for lead in _THERE)
            found += self._command(start)
            found += self.turned(start)
            found += self._fronted(start)
            if self.text(start) in {"spell", "write"}:
                found += self._spelled(start + 1)
            found += self._statement(start)
            found += [(Clause(what, said, "there" if there else ""), end) for what, said, end in self._existing(start)]
        found += self._left_alone(at)
        found += self.begun(at)
        found += self._narrowed(at)
        if either := self.past_any(at, "either"):
            for one, end in self.clause(either):
                if one.predicates and one.other is None and (start := self.past_any(end, "or", ", or")):
                    found += [(replace(one, other=other), stop) for other, stop in self.clause(start) if _says(other)]
        if end := self.past_any(at, "nothing on", "none on", "nothing on top of", "nothing is on", "nothing may be on"):
            found += [(Clause(what, (Bears(None),)), stop) for what, stop in self.phrase(end)]
        late = [(said, start) for said, end in found if (start := self.past_any(end, *_START)) and said.predicates]
        found += [(replace(said, mood="start"), end) for said, end in late]
        return found

    def _narrowed(self, at: int) -> Ways[Clause]:
        """ "(one of A, B and C,) and it must not be B", "one of which has to be C", "but not both A and B"."""
        starts = [(self.past_any(at, "not"), True), (self.past_any(at, "including", "among them"), False)]
        if who := self.past_any(at, "it", *_ONE_OF_THEM):
            starts.append((self.past_any(who, *_NOT_TO_BE), True))
            starts += [(self.past_any(who, *_TO_BE), False), (who, False)] if self.text(at) == "one" else []
        found: Ways[Clause] = []
        for start, no in starts:
            both = no and self.text(start) == "both"
            for them, end in self.phrase(start + both) if start else ():
                if _several_named(them) if both else isinstance(them, Label | Noun) or not no:
                    found.append((Clause(them, (Among(no),), "must"), end))
        for them, end in self.phrase(self.past_any(at, "do not let") or at):
            if (stop := self.past_any(end, *_NOT_TOGETHER)) and _several_named(them):
                found.append((Clause(them, (Among(no=True),), "must"), stop))
        return found

    def _left_alone(self, at: int) -> Ways[Clause]:
        """ "leave it where it is", "do not move it", "without moving it"."""
        found: Ways[Clause] = []
        if start := self.past_any(at, "leave", "keep", "leaving", "keeping"):
            ends = [(what, self.past_any(stop, *STAYS, "alone")) for what, stop in self.phrase(start)]
            found += [(Clause(what, (STAY,), "put"), end) for what, end in ends if end]
        if start := self.past_any(
            at, "do not move", "do not touch", "never move", "without moving", "without touching"
        ):
            some = [way for way in self.phrase(start) if not isinstance(way[0], Noun) or way[0].det != "a"]
            found += [(Clause(what, (STAY,), "put"), end) for what, end in some]  # "a" may be any of them
        return found

    def led(self, at: int) -> bool:
        """Whether a clause that begins there has words ahead of it such as "at the end"."""
        return len(self._leads(at)) > 1

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
            built = self._built(start, laid=verb in _PUT)
            found += [way for way in built if verb not in _STACK or not is_figure(way[0].subject)]
        if (verb in _PUT or verb in _BUILD) and not no:
            ahead = [way for way in self._rest(start) if isinstance(way[0][0], Made)]
            listed = [(what, said, end) for said, at in ahead for what, end in self.phrase(self._begin(at))]
            found += [(Clause(what, said, "build"), end) for what, said, end in listed]
        if verb in _PUT or verb in _BUILD:
            for what, end in self.phrase(start):
                for said, stop in self.predicates(end):
                    if isinstance(said[0], Place) and (verb not in _STACK or said[0].relation in _PILED_AT):
                        if verb in _STACK and several(what):
                            said = (Made(TOWER), *said)
                        found.append((Clause(what, said, "put"), stop))
        found += self._line_up(at) if not no else []
        if verb in _PUT and not no:
            found += self._until(start)
        if verb in _CAP and not no:
            for what, end in self.phrase(start):
                upper = self.single(end + 1) if self.text(end) == "with" else ()
                found += [(Clause(what, (Bears(one),), "put"), stop) for one, stop in upper]
        if verb in _STACK and not no:
            for what, end in self.phrase(start):
                for tower, stop in ((TOWER, end), *self.ordered(TOWER, end)):
                    found.append((Clause(what, (Made(tower),), "build"), stop))
        if no:
            denied = [(replace(clause, predicates=opposite_of(clause.predicates)), end) for clause, end in found]
            found = [(clause, end) for clause, end in denied if clause.predicates]
        return found

    def _line_up(self, at: int) -> Ways[Clause]:
        """ "line up A, B and C", "line them up"."""
        found: Ways[Clause] = []
        if self.text(at) == "line":
            apart = [(what, end + 1) for what, end in self.single(at + 1) if self.text(end) == "up"]
            found += [(Clause(what, (Made(_LINE),), "build"), end) for what, end in apart]
        if lined := self.past_any(at, "line up"):
            lined_up = [way for way in self._existing(lined) if not is_figure(way[0], but="tower")]
            found += [(Clause(what, (Made(_LINE), *said), "build"), end) for what, said, end in lined_up]
            rows = [(what, way) for what, end in self.phrase(lined) for way in self.ordered(_LINE, end)]
            found += [(Clause(what, (Made(row),), "build"), end) for what, (row, end) in rows]
        return found

    def _until(self, start: int) -> Ways[Clause]:
        """ "(bring) the two over so that both are next to it": where they are to be is told behind."""
        found: Ways[Clause] = []
        for what, end in self.phrase(start):
            so = self.past_any(end + (self.text(end) in {"over", ","}), "so that", "such that", "until")
            for clause, stop in self._statement(so) if so else ():
                same = isinstance(clause.subject, Pronoun) and (clause.subject.word == "it") != several(what)
                if same and clause.mood in {"so", "must"} and _says(clause):
                    found.append((replace(clause, subject=what, mood="put"), stop))
        return found

    def _built(self, start: int, *, laid: bool) -> Ways[Clause]:
        """What is to be built, with what is said of it, or of what it is built; only figures are `laid` so."""
        found: Ways[Clause] = []
        for what, end in self.phrase(start):
            if not laid or (isinstance(what, Noun) and what.noun in FIGURES):
                found.append((Clause(what, (), "build"), end))
                found += [(Clause(what, (), "build", said), stop) for said, stop in self.last_at(what, end)]
                found += [(Clause(what, said, "build"), stop) for said, stop in self._rest(end)]
            sorted_so = [(row.order, at) for row, at in self.ordered(Noun(noun="row"), end)]
            intos = [(order, at + (self.text(at) == ",")) for order, at in [("", end), *sorted_so]]
            for order, figure, stop in ((order, *way) for order, at in intos for way in self.into(at)):
                figure = replace(figure, order=order) if order else figure
                found.append((Clause(what, (Made(figure),), "build"), stop))
                found += [(Clause(what, (Made(figure), *said), "build"), last) for said, last in self._rest(stop)]
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
        return [(Clause(what, (), "build"), end), *((Clause(what, s, "build"), e) for s, e in self.predicates(end))]

    def _fronted(self, at: int) -> Ways[Clause]:
        """ "behind it another row", "between both is the digit 0", "beside this stack goes a tower"."""
        found: Ways[Clause] = []
        if within := self.past_any(at, "in", "of"):
            wholes = [way for way in self.phrase(within) if isinstance(way[0], Noun | Both)]
            found += [(Clause(what, (), "in"), end) for what, end in wholes]
        for place, end in self.place(at):
            starts = {self.past_any(end, way) for way in _FRONTED} | {end}
            for start in starts - {0}:
                listed = [way for way in self.single(start) if self.text(way[1]) == "," and self.label(way[1] + 1)]
                found += [
                    (Clause(what, (place,)), stop) for what, stop in self.single(start) if (what, stop) not in listed
                ]
        return found

    def _statement(self, at: int) -> Ways[Clause]:
        found: Ways[Clause] = []
        for what, stop in self.phrase(at):
            if built := self.past_any(stop, *BUILT):
                found.append((Clause(what, (), "build"), built))
            for aside, start in ((None, stop), *self._aside(stop), *self.last_at(what, stop)):
                mood = self._mood(start)
                found += [(Clause(what, said, mood, aside), end) for said, end in self.verbs(start)]
        return found

    def _mood(self, at: int) -> str:
        """Whether a verb says what is so, what is allowed, what has to be, or what is so at the end."""
        if self.text(at) in {"may", "can"} and self.text(at + 1) != "not":
            return "may"
        aux = self.past_any(at, *AUX)
        if self.past_any(aux or at, "end up", "ends up"):
            return "end"
        return "must" if aux or self.text(at) == "not" else "so"

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
        if self.text(at) == ",":
            looks += [((place,), end) for place, end in self.place(at + 1) if place.relation in _BEHIND_COMMA]
        if color := lexicon.COLOR.get(self.text(start)):
            looks.append(((Looks(Noun(color=color)),), start + 1))
        if end := self.past_any(start, *_LINED):
            looks.append(((Made(Noun(det="a", noun="row", ranks=("left",))),), end))
        sorted_so = self.ordered(Noun(det="a", noun="row"), start)
        looks += [((Made(row),), end) for row, end in sorted_so if self.text(end - 1) == "right"]
        if end := self.past_any(start, "lined up", ", lined up"):
            looks.append(((Made(_LINE),), end))
        verbs = self.verbs(start) if start > at or self.text(start).endswith("ing") else []
        return [*looks, *self.predicates(start), *verbs]


def _says(clause: Clause) -> bool:
    """Whether a clause says one thing, and by itself."""
    return bool(clause.predicates) and clause.other is None and clause.aside is None


def _several_named(phrase: Phrase) -> bool:
    return isinstance(phrase, Both) and not phrase.either


def several(phrase: Phrase) -> bool:
    """Whether more than one block is told."""
    return not isinstance(phrase, Label | Noun) or (isinstance(phrase, Noun) and (phrase.many or phrase.count > 1))
