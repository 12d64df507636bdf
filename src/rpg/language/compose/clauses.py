"""The clauses of a text: commands, statements, and what is told without a verb; all ways to read the whole."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from rpg.language.compose.commands import Commands, says
from rpg.language.compose.series import counted
from rpg.language.compose.stated import STOPS
from rpg.language.compose.syntax import (
    NOTHING,
    STAY,
    Among,
    Bears,
    Both,
    Clause,
    Label,
    Noun,
    Phrase,
    Place,
    Pronoun,
    Reads,
)
from rpg.language.compose.verbs import STAYS
from rpg.language.compose.words import Ways, remembered

_LEADS = (
    "i want you to", "i want to see", "i would like you to", "i would like to see", "i would like", "i should like",
    "i want", "i need", "we need", "we want", "i would love", "you have", "you got", "we have", "i have", "there is",
    "there are", "there is to be", "there are to be",
    "there should be", "there must be", "give me", "gimme", "let us have", "let me see", "let there be",
    "is it possible to have", "can we have", "could we have",
    "can you", "could you", "would you", "will you", "show me", "get me", "let us", "let", "try to", "the goal is to",
    "the task is to", "you should", "hey", "yo", "hi", "hello", "goal :", "task :", "goal", "make sure that",
    "make sure", "see to it that", "make it so that", "need", "at the end", "in the end",
    "i have got", "you have got", "got", "have", "u got", "here is", "here are", "take", "use", "we got",
    "how about", "what about",
)  # fmt: skip
_SEEN = tuple(
    f"{seen}{there}"
    for seen in ("i see", "i can see", "we see", "we can see", "you see", "you can see", "one sees", "picture shows",
                 "the picture shows", "my picture shows", "this is", "it shows", "i just see")
    for there in ("", " that there is", " that there are")
)  # fmt: skip
"""Behind these stands what a picture shows."""
_THERE = ("there is", "there are", "you have", "we have", "i have", "here is", "here are")
_THEN = (
    ", finally", ", and finally", ". finally", "; finally", "and finally", ". lastly", ", then",
    ". then", "; then", "and then", ", and then", ". after that", ", after that", "and after that",
    ". afterwards", ". next", ", and after that", ", next",
)  # fmt: skip
_START = ("at the start", "at the beginning", "initially", "to begin with", "in the beginning", "at start", "at first")
_NOW = (
    "now", "right now", "now ,", "right now ,", "currently", "already", "at the moment", "before :", "was :",
    "initial state :", "at first ,", "start state :", "initial condition :", "first state :", "setup :",
)  # fmt: skip
_END = tuple(f"{end}{mark}" for end, marks in (
    ("at the end", ("", " ,")), ("in the end", ("", " ,")), ("afterwards", ("", " ,", " :")), ("finally", ("", " ,")),
    ("end", (" :",)), ("goal", (" :",)), ("after", (" :",)), ("goal state", (" :",)), ("final state", (" :",)),
    ("last state", (" :",)), ("goal condition", (" :",)), ("should be", (" :",)), ("now", ("",)),
) for mark in marks)  # fmt: skip
_NOT_MOVED = ("not moved", *(
    f"{must} not {moved}"
    for must in ("must", "may", "should", "can", "shall", "is to", "are to", "has to", "is", "are")
    for moved in ("move", "be moved", "be touched", "moved", "to be moved", "to be touched")
    if (must in {"is", "are"}) == (moved in {"moved", "to be moved", "to be touched"})
))  # fmt: skip
_TOLD = frozenset({"", "so", "there", "lies", "start"})
"""What may be so now."""
_SEPARATORS = (
    ", and then there is", ", and there is", ", and", ", but", ", while", ", with", ", plus", ", whereas", ", so that",
    ", of which", ", except that", "except that", ", such that", "such that", "in such a way that", ", where", "where",
    "in which", ", in which",
    "; and", ", leaving", ",", ";", ".", "!", "?", ":", "and", "but", "while", "plus", "with", "whereas", "so that",
)  # fmt: skip

_NOTHING_ON = tuple(
    f"{nothing}{is_} {on}"
    for nothing in ("nothing", "none", "no block")
    for is_ in ("", *(f" {verb}" for verb in ("is", "lies", "stands", "sits", "rests", "must be", "should be", "may be",
                                              "may lie", "can be", "shall be", "is to be", "is allowed", "goes")))
    for on in ("on", "on top of")
)  # fmt: skip
_GAP = tuple(f"{leave}a {gap} of" for leave in ("", "leave ", "keep ") for gap in ("gap", "space"))
_NOT_ANYTHING = tuple(f"there {must} not {be}anything" for must, be in (
    ("should", "be "), ("must", "be "), ("may", "be "), ("can", "be "), ("is", ""), ("shall", "be ")
))  # fmt: skip
_READS = tuple(f"{may}{shows}" for may in ("", "must ", "should ", "will ", "can ") for shows in (
    "read", "reads", "spell", "spells", "say", "says", "spell out", "spells out", "spell the word", "spells the word",
    "read the word", "reads the word"
))  # fmt: skip
_UNLIKE = tuple(
    f"{never} two {blocks}of the same color{on}"
    for never in ("never", "no", "but never", "but no")
    for blocks in ("", "block ")
    for on in (" touching", *(f" {directly}{on}" for directly in ("", "directly ", "right ") for on in (
        "on each other", "on top of each other", "on one another", "next to each other", "above each other")))
)  # fmt: skip
_OPENING = frozenset({"whose", "without", "so"})
"""Before these words nothing need part a clause from the one ahead of it."""
_BARE = frozenset({"empty", "free"})
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


class Step(NamedTuple):
    """A clause, where the next one begins, and of that: whether it has to say something, is of later, and is joined to
    this one, so that its verb may be the verb of both."""

    clause: Clause
    at: int
    said: bool = False
    later: bool = False
    joined: bool = False


class Reader(Commands):
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
                if (start := self.past(end, words.split())) and (words or self.text(end) in _OPENING):
                    yield Step(clause, self._begin(start), said=words in _WITH, joined=words not in STOPS)
            for words in _THEN:
                if start := self.past_any(end, words):
                    yield Step(clause, self._begin(start), later=True)

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
        if begin := self.past_any(at, *_NOW):
            found += [(replace(said, mood="start"), end) for said, end in self.clause(begin) if said.mood in _TOLD]
        if begin := self.past_any(at, *_END):
            ends = [(said, end) for said, end in self.clause(begin) if said.mood in {"so", ""} and said.predicates]
            found += [(replace(said, mood="end"), end) for said, end in ends]
        if first := self.past_any(at, "first", "first ,", "first of all ,"):
            found += [(replace(said, first=True), end) for said, end in self.clause(first)]
        if self.text(at) == "only":
            found += [(replace(said, only=True), end) for said, end in self._statement(at + 1) if says(said)]
        if of := self.past_any(at, "of which"):
            for amount, begin in self._amount(of):
                some = replace(amount, of=Pronoun("which"))
                found += [(Clause(some, said, "must"), end) for said, end in self.verbs(begin)]
        if which := self.past_any(at, "each of which", "all of which", "both of which", "none of which"):
            some = Noun(det={"none": "no"}.get(self.text(at), self.text(at)), of=Pronoun("which"))
            found += [(Clause(some, said, "must"), end) for said, end in self.verbs(which)]
        for start in self._leads(at):
            there = start > at and any(self.past(at, lead.split()) == start for lead in _THERE)
            mood = "there" if there else "seen" if start > at and self.past_any(at, *_SEEN) == start else ""
            found += self._command(start)
            found += self.towers_in_line(start)
            found += self.turned(start)
            found += self.changed(start)
            found += self._fronted(start)
            found += self._gap(start)
            if self.text(start) in {"spell", "write"}:
                found += self._spelled(start + 1)
            found += self._statement(start)
            found += [(Clause(what, said, mood), end) for what, said, end in self._existing(start)]
        found += [*self._left_alone(at), *self._unmoved(at), *self._read_off(at)]
        if end := self.past_any(at, *_UNLIKE):
            found.append((Clause(Pronoun("it"), (Place("unlike"),), "must"), end))
        found += self.begun(at)
        found += self.lying(at)
        found += self._narrowed(at)
        if either := self.past_any(at, "either"):
            for one, end in self.clause(either):
                if one.predicates and one.other is None and (start := self.past_any(end, "or", ", or")):
                    found += [(replace(one, other=other), stop) for other, stop in self.clause(start) if says(other)]
        found += self._all_of_it(at)
        if end := self.past_any(at, *_NOT_ANYTHING):
            found += [(Clause(NOTHING, (place,), "must"), stop) for place, stop in self.place(end)]
        if end := self.past_any(at, *_NOTHING_ON):
            found += [(Clause(what, (Bears(None),)), stop) for what, stop in self.phrase(end)]
        late = [(said, start) for said, end in found if (start := self.past_any(end, *_START)) and said.predicates]
        late += [(said, start) for said, end in found if said.mood in {"so", "lies"}
                 and (start := self.past_any(end, *_NOW, *_START))]  # fmt: skip
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

    def _read_off(self, at: int) -> Ways[Clause]:
        """ "so it reads CAT", "the row says DOG": which word is read from blocks."""
        start = self.past_any(at, "so that", "so", "and so") or at
        found: Ways[Clause] = []
        for what, end in self.simple(start) if start > at or self.text(at) in {"the", "it", "they", "together"} else ():
            word_at = self.past_any(end, *_READS)
            item = self.items[word_at] if 0 < word_at < len(self.items) else None
            word = item.value or (item.raw if item.raw.isupper() else "") if item is not None else ""
            if len(word) > 1 and word.isalpha():
                found.append((Clause(what, (Reads(word),), "so"), word_at + 1))
        return found

    def _left_alone(self, at: int) -> Ways[Clause]:
        """ "leave it where it is", "do not move it", "without moving it"."""
        found: Ways[Clause] = []
        if start := self.past_any(at, "leave", "keep", "leaving", "keeping"):
            ends = [(what, self.past_any(stop, *STAYS, "alone")) for what, stop in self.phrase(start)]
            found += [(Clause(what, (STAY,), "put"), end) for what, end in ends if end]
            if self.text(at) in {"leave", "leaving"}:
                bare = [(what, way) for what, stop in self.phrase(start) for way in self.place(stop)]
                found += [(Clause(what, (how,), "put"), end) for what, (how, end) in bare if how.relation in _BARE]
        if start := self.past_any(
            at, "do not move", "do not touch", "never move", "without moving", "without touching"
        ):
            some = [way for way in self.phrase(start) if not isinstance(way[0], Noun) or way[0].det != "a"]
            found += [(Clause(what, (STAY,), "put"), end) for what, end in some]  # "a" may be any of them
        return found

    def _gap(self, at: int) -> Ways[Clause]:
        """ "leave a gap of 6 cm between the red and the blue block"."""
        start = self.past_any(at, *_GAP)
        between = self.past_any(start + 1, "cm between") if self.number(start) else 0
        apart = Place("apart", how="gap", cm=float(self.number(start)))
        return [(Clause(two, (apart,), "put"), end) for two, end in self.phrase(between)] if start and between else []

    def _all_of_it(self, at: int) -> Ways[Clause]:
        """ "(white between red and blue,) all on the table": all that was told of, in which they are no others."""
        many = self.past_any(at, "all", "both", "all of them", "both of them")
        if not many:
            return []
        count = 2 if self.text(at) == "both" else self.number(many)
        start = self.past_any(many + 1, "of them") or many + 1 if self.number(many) else many
        them = Noun(det="all", count=count, of=Pronoun("all blocks"))
        return [(Clause(them, (place,), "must"), end) for place, end in self.place(start)]

    def _unmoved(self, at: int) -> Ways[Clause]:
        """ "the cyan one must not be moved", "(end with) A and D not moved"."""
        found: Ways[Clause] = []
        for what, end in self.phrase(at):
            if not isinstance(what, Noun) or what.det != "a":
                moved = self.past_any(end, *_NOT_MOVED)
                found += [(Clause(what, (STAY,), "put"), moved)] if moved else []
        return found

    def led(self, at: int) -> bool:
        """Whether a clause that begins there has words ahead of it such as "at the end"."""
        return len(self._leads(at)) > 1

    def _leads(self, at: int) -> list[int]:
        """Where the clause itself may begin."""
        starts, new = [at], [at]
        while new:
            behind = {
                self.past_any(start, lead, f"{lead} ,", f"{lead} :") for start in new for lead in (*_LEADS, *_SEEN)
            } - {0}
            behind = {start for start in behind if self.text(start) not in {"it", "them"}}
            new = sorted(behind - set(starts))
            starts += new
        return starts


def _several_named(phrase: Phrase) -> bool:
    return isinstance(phrase, Both) and not phrase.either
