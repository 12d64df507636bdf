"""Clauses that tell what to do: build, put, stack, line up."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.items import FIGURES
from rpg.language.compose.measures import IN_CUBES
from rpg.language.compose.stated import LINE, Stated
from rpg.language.compose.syntax import (
    TOWER,
    Bears,
    Clause,
    Made,
    Noun,
    Place,
    Predicate,
    Pronoun,
    is_figure,
    several,
)
from rpg.language.compose.verbs import opposite_of
from rpg.language.compose.words import Ways

_BUILD = frozenset({
    "build", "make", "construct", "create", "form", "assemble", "lay", "arrange", "set", "erect", "produce",
    "prepare", "put", "stack", "stand", "place", "raise", "draw", "compose", "show", "write", "do",
})  # fmt: skip

_BUILD_ME = ("me", "up", "out", "down", "together")

_PUT = frozenset({
    "put", "place", "set", "move", "lay", "stand", "bring", "position", "add", "stack", "get", "drop", "rest",
    "slide", "push", "shift", "transfer", "pile", "seat", "sit",
})  # fmt: skip

_STACK = frozenset({"stack", "pile"})

_CAP = frozenset({"cap", "top", "crown"})

_PILED_AT = frozenset({"on", "in", "off", "under", "region", "top", "table"})
"""Where one may stack things; what is stacked beside something, or between, need not stand on the table."""


class Commands(Stated):
    """Reads commands."""

    def _command(self, at: int) -> Ways[Clause]:
        found: Ways[Clause] = []
        if (lined := self.past_any(at, "line up")) or self.text(at) in _BUILD:
            found += self.towers_in_line(lined or self.past_any(at + 1, *_BUILD_ME) or at + 1, lined=bool(lined))
        no = self.past_any(at, "do not", "never")
        verb = self.text(no or at)
        start = self.past_any((no or at) + 1, *_BUILD_ME) or (no or at) + 1
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
            found += [(Clause(what, (Made(LINE),), "build"), end) for what, end in apart]
        if lined := self.past_any(at, "line up"):
            lined_up = [way for way in self._existing(lined) if not is_figure(way[0], but="tower")]
            found += [
                (Clause(what, said if _lined(said) else (Made(LINE), *said), "build"), end)
                for what, said, end in lined_up
            ]
            rows = [(what, way) for what, end in self.phrase(lined) for way in self.ordered(LINE, end)]
            found += [(Clause(what, (Made(row),), "build"), end) for what, (row, end) in rows]
        return found

    def _until(self, start: int) -> Ways[Clause]:
        """ "(bring) the two over so that both are next to it": where they are to be is told behind."""
        found: Ways[Clause] = []
        for what, end in self.phrase(start):
            so = self.past_any(end + (self.text(end) in {"over", ","}), "so that", "such that", "until")
            for clause, stop in self._statement(so) if so else ():
                same = isinstance(clause.subject, Pronoun) and (clause.subject.word == "it") != several(what)
                if same and clause.mood in {"so", "must"} and says(clause):
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

    def _spelled(self, at: int) -> Ways[Clause]:
        """ "spell CAT in a row"."""
        start = self.past_any(at, "the word", "out") or at
        word = self.items[start].value if start < len(self.items) else ""
        if not word.isalpha():
            return []
        end = self.past_any(start + 1, "in a row", "in a line", *IN_CUBES) or start + 1
        what = Noun(det="a", noun="word", word=word)
        return [(Clause(what, (), "build"), end), *((Clause(what, s, "build"), e) for s, e in self.predicates(end))]


def says(clause: Clause) -> bool:
    """Whether a clause says one thing, and by itself."""
    return bool(clause.predicates) and clause.other is None and clause.aside is None


def _lined(said: tuple[Predicate, ...]) -> bool:
    """ "(Line up the blocks) from left to right": the line is told already."""
    return bool(said) and isinstance(said[0], Made) and said[0].figure != TOWER
