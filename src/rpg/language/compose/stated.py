"""Clauses that tell what is so, or what there is, with a verb or without one."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.facing import SIDED
from rpg.language.compose.heights import Heights
from rpg.language.compose.items import FIGURES, RANK, Item
from rpg.language.compose.looking import FROM_LEFT
from rpg.language.compose.syntax import (
    Both,
    Chain,
    Clause,
    Label,
    Looks,
    Made,
    Noun,
    Phrase,
    Predicate,
    Pronoun,
    is_figure,
)
from rpg.language.compose.verbs import AUX, BUILT
from rpg.language.compose.words import Ways

_LINED = (
    "lined up from left to right", "lined up left to right", "in a row from left to right",
    "in a line from left to right", "from left to right", "left to right",
)  # fmt: skip

_READ = tuple(f"{reads}{the}" for reads in ("reads", "spells", "says") for the in ("", " the word"))
_DOWN = ("from top to bottom", "from the top to the bottom", "downwards", "downward", "from the top down",
         "top to bottom")  # fmt: skip
_UP = ("from bottom to top", "from the bottom to the top", "upwards", "upward", "from the bottom up", "bottom to top")

_BEHIND_COMMA = frozenset({"in turn", "side by side", "rising", "any order"})

LINE = Noun(det="a", noun="line")

_ALONE = ("alone", "all alone", "on its plain", "all on its plain")
_FRONTED = (":", ",", "is", "are", "goes", "go", "stands", "stand", "there is", "there are", "there should be", "sits",
            "lies", ", there is", ", there are", "must be", "should be", "place", "put", ", put", ", place", "i want",
            "comes", "build", ", build")  # fmt: skip

_ASKING = frozenset({"could", "can", "should", "must", "shall", "will", "may"})
_STARTS = tuple(
    f"{verb}{word}"
    for verbs, more in (
        (("start", "begin", "starts", "begins", "started"), ("", " out", " off")),
        (("is", "are", "lies", "lie", "stands", "stand", "sits", "sit"),
         (" already", " now", " currently", " at first")),
    )
    for verb in verbs for word in more
)  # fmt: skip
"""What is so at the start."""

STOPS = frozenset({".", "!", "?", ",", ";", ":"})


class Stated(Heights):
    """Reads what is told."""

    def _begin(self, at: int) -> int:
        """Where the next clause begins."""
        while self.text(at) in STOPS:
            at += 1
        return at

    def _existing(self, at: int) -> list[tuple[Phrase, tuple[Predicate, ...], int]]:
        """What is told without a verb: "a tower of two on the patch"."""
        found: list[tuple[Phrase, tuple[Predicate, ...], int]] = []
        for what, end in self.phrase(at):
            found.append((what, (), end))
            found += [(what, said, stop) for said, stop in self._rest(end)]
        return found

    def _fronted(self, at: int) -> Ways[Clause]:
        """ "behind it another row", "between both is the digit 0", "beside this stack goes a tower"."""
        found: Ways[Clause] = []
        if within := self.past_any(at, "in", "of", "out of"):
            wholes = [way for way in self.phrase(within) if isinstance(way[0], Noun | Both)]
            found += [(Clause(what, (), "in"), end) for what, end in wholes]
        found += self.colors_in_turn(at)
        if self.text(at + 1) == ":" and (side := RANK.get(self.text(at), "")) in SIDED:
            one = [(what, end) for what, end in self.single(at + 2) if isinstance(what, Noun) and what.noun in FIGURES]
            found += [(Clause(replace(what, det="a", ranks=(side,))), end) for what, end in one if not what.ranks]
        if lined := self.past_any(at, *FROM_LEFT):
            begin = self.past_any(lined, *_FRONTED, ":", ", :", "i want :", ", i want", "i want", "there is :") or lined
            listed = [way for way in self.phrase(begin) if isinstance(way[0], Both) and is_figure(way[0])]
            found += [
                (Clause(what, (Made(Noun(det="a", noun="row", ranks=("left",))),)), self.past_any(end, *_ALONE) or end)
                for what, end in listed
            ]
        for place, end in self.place(at):
            starts = {self.past_any(end, way) for way in _FRONTED} | {end}
            for start in starts - {0}:
                listed = [way for way in self.single(start) if self.text(way[1]) == "," and self.label(way[1] + 1)]
                found += [
                    (Clause(what, (place,), fronted=True), stop)
                    for what, stop in self.single(start)
                    if (what, stop) not in listed
                ]
                for what, stop in self.single(start):
                    shared = self.shares(stop + 1) if self.text(stop) == "," else []
                    found += [(Clause(what, (place, *said), fronted=True), last) for said, last in shared]
                if place.relation == "on" and isinstance(place.of, Noun) and place.of.noun == "patch" and start > end:
                    found += [(Clause(both, (place,)), stop) for both, stop in self.phrase(start) if _blocks(both)]
        return found

    def _statement(self, at: int) -> Ways[Clause]:
        found = self._reads(at)
        asked = self.phrase(at + 1) if self.text(at) in _ASKING else []
        passive = [(what, way) for what, stop in asked if self.text(stop) == "be" for way in self.verbs(stop)]
        found += [(Clause(what, said, "must"), end) for what, (said, end) in passive]  # "could it be put there?"
        all_of_them = self.text(at) == "all" and self.text(at + 1) in {"are", "have", "must", "should"}
        them: Ways[Phrase] = [(Pronoun("they"), at + 1)] if all_of_them else []
        for what, stop in [*self.phrase(at), *them]:
            high, end = self.as_high(stop)
            if high and isinstance(what, Noun) and what.noun in FIGURES:
                found.append((Clause(replace(what, size=(high,)), (), "so"), end))
            if built := self.past_any(stop, *BUILT):
                found.append((Clause(what, (), "build"), built))
            for aside, start in ((None, stop), *self._aside(stop), *self.last_at(what, stop)):
                mood = self._mood(start)
                found += [(Clause(what, said, mood, aside), end) for said, end in self.verbs(start)]
                if begun := self.past_any(start, *_STARTS):
                    begun += self.text(begun) in {"stacked", "piled"} and self.text(begun + 1) == "on"
                    found += [(Clause(what, said, "start", aside), end) for said, end in self.predicates(begun)]
            wholly = [(said, end) for said, end in self.verbs(stop) if len(said) == 1 and isinstance(said[0], Looks)]
            found += [(Clause(what, said, "so", but), last) for said, end in wholly for but, last in self.excepted(end)]
        return found

    def _reads(self, at: int) -> Ways[Clause]:
        """ "the row on the blue mat reads DOG", "the tower reads CAT from top to bottom"."""
        found: Ways[Clause] = []
        for noun, behind in self._head(at + 1, Noun(det="the")) if self.text(at) == "the" else ():
            if noun not in (Noun(det="the", noun="row"), Noun(det="the", noun="line"), Noun(det="the", noun="tower")):
                continue
            bare: Ways[tuple[Predicate, ...]] = [((), behind)]
            for said, end in [*bare, *(((place,), end) for place, end in self.place(behind) if place.of is not None)]:
                start = self.past_any(end, *_READ)
                item = self.items[start] if start and start < len(self.items) else Item("", "")
                word = item.value or (item.raw if item.raw.isupper() and len(item.raw) > 1 else "")
                if not word.isalpha():
                    continue
                if noun.noun == "tower":
                    down, up = self.past_any(start + 1, *_DOWN), self.past_any(start + 1, *_UP)
                    letters = Chain(tuple(Label(letter) for letter in (word if down else word[::-1])))
                    tower = replace(noun, content=letters, made="of")
                    found += [(Clause(tower, said, "reads"), down or up)] if down or up else []
                else:
                    stop = self.past_any(start + 1, "from left to right", "left to right") or start + 1
                    found.append((Clause(replace(noun, noun="word", word=word), said, "reads"), stop))
        return found

    def _mood(self, at: int) -> str:
        """Whether a verb says what is so, what is allowed, what has to be, or what is so at the end."""
        if self.text(at) in {"may", "can"} and self.text(at + 1) != "not":
            return "may"
        aux = self.past_any(at, *AUX)
        aux = 0 if self.text(aux) in {"the", "its"} else aux  # "is to the left", which may be so now
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
        looks += [(said, end) for said, end in self.colored(start) if said[0].at]
        hue = start + (self.text(start) == "all")
        if color := lexicon.COLOR.get(self.text(hue)):
            looks.append(((Looks(Noun(color=color)),), hue + 1))
        if end := self.past_any(start, *_LINED):
            looks.append(((Made(Noun(det="a", noun="row", ranks=("left",))),), end))
        sorted_so = self.ordered(Noun(det="a", noun="row"), start)
        looks += [((Made(row),), end) for row, end in sorted_so if self.text(end - 1) == "right"]
        if end := self.past_any(at, "another one"):
            looks += self.formed(Noun(det="another", noun="one"), end)  # the verb is that of the clause ahead
        if end := self.past_any(start, "lined up", ", lined up"):
            looks.append(((Made(LINE),), end))
        verbs = self.verbs(start) if start > at or self.text(start).endswith("ing") else []
        return [*looks, *self.predicates(start), *verbs]


def _blocks(phrase: Phrase) -> bool:
    """Whether this is "a red block and two blue ones", and no figure."""
    parts = phrase.parts if isinstance(phrase, Both) and not phrase.either else ()
    return bool(parts) and all(
        isinstance(part, Label)
        or (isinstance(part, Noun) and part.noun in {"block", "one"} and not (part.of or part.content or part.that))
        for part in parts
    )
