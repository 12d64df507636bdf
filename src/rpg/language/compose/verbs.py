"""What is said of things: verbs with what belongs to them, and places one after the other."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.items import FIGURES, PARTS, RANK
from rpg.language.compose.looking import Looking
from rpg.language.compose.syntax import (
    STAY,
    TOWER,
    Bears,
    Chain,
    Either,
    Holds,
    Looks,
    Made,
    NotBoth,
    Noun,
    Phrase,
    Place,
    Predicate,
    Same,
    Shares,
)
from rpg.language.compose.words import Ways, remembered

AUX = (
    "must", "should", "shall", "has to", "have to", "needs to", "need to", "is to", "are to", "may", "can", "will",
    "ought to", "is supposed to", "are supposed to", "does", "do", "has got to", "will have to", "would",
)  # fmt: skip
_BE = (
    "be", "is", "are", "sits", "sit", "stands", "stand", "lies", "lie", "rests", "rest", "goes", "go", "belongs",
    "belong", "stays", "stay", "remains", "remain", "ends up", "end up", "comes", "come", "gets", "get", "standing",
    "sitting", "lying", "resting", "being", "lands", "land", "ends", "end",
)  # fmt: skip
_DONE = frozenset({
    "placed", "put", "located", "positioned", "set", "laid", "stood", "left", "found", "moved", "kept", "sitting",
    "standing", "lying", "resting", "seated", "situated", "brought", "touched", "displaced", "written", "spelled",
    "spelt", "built", "erected", "shown", "displayed",
})  # fmt: skip
_FORM = ("form", "forms", "make", "makes", "become", "becomes", "make up", "makes up", "build", "constitute",
         "are arranged in", "are arranged as", "is arranged in", "are arranged into", "be arranged in",
         "be arranged as", "are in", "be in", "stand in", "lie in", "go in", "go into", "are stacked into",
         "stacked into", "turn into", "are built into", "is", "are")  # fmt: skip
_FORMING = frozenset({"form", "forms", "make", "makes", "become", "becomes", "build"})
_BEAR = ("carry", "carries", "support", "supports", "bear", "bears", "has", "have", "get", "gets", "hold", "holds",
         "carrying", "bearing", "supporting", "holding")  # fmt: skip
STAYS = ("where it is", "where they are", "as it is", "as they are", "untouched", "in place", "unmoved")
BUILT = tuple(
    f"{must} {be} {done}"
    for must, be in (("are to", "be"), ("is to", "be"), ("must", "be"), ("should", "be"), ("shall", "be"))
    for done in ("built", "made", "formed", "constructed", "assembled", "set up")
)
_MOVED = frozenset({"moved", "touched", "displaced"})
_NOT_BOTH = tuple(f"{but} not both{of}" for but in ("but", ", but") for of in ("", " of them"))
_OTHER = tuple(f"{also} {other}" for also in ("and", ", and", ",") for other in ("one", "the other", "the other one"))
_INTO = ("in", "into", "as", "to form", "to make", "in the shape of", "out as")
_MUST = ("must", "should", "shall", "has to", "have to", "needs to", "need to", "is to", "are to")
_END = frozenset({"", ",", ".", ";", "!", "?"})
_ONE_ON_OTHER = tuple(f"one {stacked}{on} {other}" for stacked in ("", "stacked ", "placed ", "standing ")
                      for on in ("on", "on top of", "atop") for other in ("the other", "another"))  # fmt: skip
_PILED = frozenset({"stacked", "piled"})
_FLAT = frozenset({"patch", "table"})


class Verbs(Looking):
    """Reads what is said of a thing."""

    def _ordered(self, at: int) -> Ways[Phrase]:
        """ "red on green", "pink on blue and blue on pink": what is told of stacks."""
        chains: Ways[Phrase] = [(how, end) for how, end in self.single(at) if isinstance(how, Chain)]
        return [*chains, *self._listing(at), *self.storeys(at), *self.reversed_so(at)]

    @remembered
    def predicates(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """Places, one after the other: "on the patch and left of A", "off the mat but not on the table"."""
        found: Ways[tuple[Predicate, ...]] = []
        found += [((Made(figure),), end) for figure, end in self.into(at)]
        formed = [(figure, way) for figure, end in self.into(at) for way in self.predicates(end)]
        found += [((Made(figure), *more), stop) for figure, (more, stop) in formed]
        found += self._either(at)
        found += self._one_on_other(at)
        found += self.shares(at)
        for place, end in self.place(at):
            found.append(((place,), end))
            if in_turn := self.past_any(end, "respectively", ", respectively"):
                found.append(((replace(place, how="respectively"),), in_turn))
            found += [((place, *shared), stop) for shared, stop in self.shares(end + (self.text(end) == ","))]
            if both := self.past_any(end, *_NOT_BOTH):
                found.append(((place, NotBoth()), both))
            for more, stop in self.place(end):
                if more.of is None and more.relation in {"flat", "side by side", "touching"}:
                    found.append(((place, more), stop))
            if self.text(end) == ",":
                found += [((place, *piled), stop) for piled, stop in self._one_on_other(end + 1)]
            ways = {self.past_any(end, way) for way in ("and", "but", ", but", ", and", ",")} - {0}
            ways -= set() if place.no else {self.past_any(end, "but"), self.past_any(end, ", but")}
            ways -= {self.past_any(end, "and"), self.past_any(end, ", and")} if place.no else set()
            lifted = place.relation in {"on", "between"} and not (isinstance(place.of, Noun) and place.of.noun in _FLAT)
            denied = self.text(end + 1) == "not" or self.text(end + 2) in {"neither", "none"}
            if lifted and self.text(end) == "," and not denied:
                ways -= {end + 1}  # what is beside it may be the whole
            for start in ways:
                more_said = [*self.predicates(start), *(self.verbs(start) if self.text(start - 1) != "," else ())]
                found += [((place, *more), stop) for more, stop in more_said]
        return found

    def into(self, at: int) -> Ways[Noun]:
        """ "in one tower", "in another", "as a row", "in the front row"."""
        found: Ways[Noun] = []
        for into in {self.past_any(at, way) for way in _INTO} - {0}:
            for what, end in self.single(into):
                if isinstance(what, Noun) and (what.noun in FIGURES or what.noun == "one") and not what.many:
                    another = what.det in {"another", "other"} or (what.det == "the" and len(what.ranks) == 1)
                    if another or (what.det in {"a", ""} and what.noun in FIGURES):
                        found.append((what, end))
        return found

    def shares(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "one on its left and one on its right", "one to the left and the other to the right of it"."""
        found: Ways[tuple[Predicate, ...]] = []
        for first, end in self.place(at + 1) if self.text(at) == "one" else ():
            for second, stop in self.place(other) if (other := self.past_any(end, *_OTHER)) else ():
                one = replace(first, of=first.of or second.of)
                if one.of is not None and second.of is not None:
                    found.append(((Shares((one, second)),), stop))
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
                    one = place if place.of is not None else _of_same(place, other)
                    if not one.no and not other.no:
                        found.append(((Either((one, other)),), stop))
        return found

    @remembered
    def verbs(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """A verb with what belongs to it, and more of such."""
        found: Ways[tuple[Predicate, ...]] = []
        starts = {at, self.past_any(at, *AUX) or at}  # "are to be", and "are to the left of it"
        for said, end in (way for start in sorted(starts) for way in self._verb(start)):
            found.append((said, end))
            for start in {self.past_any(end, way) for way in ("and", "but", ", but", ", and")} - {0}:
                found += [((*said, *more), stop) for more, stop in self.verbs(start)]
        return found

    def _verb(self, at: int) -> Ways[tuple[Predicate, ...]]:
        found: Ways[tuple[Predicate, ...]] = []
        no = self.past_any(at, "not") or at
        denied = no > at
        start = no + (self.text(no) in {"both", "all", "each"} and not denied)
        ends = {end + (self.text(end) in {"both", "all"}) for way in _BE if (end := self.past_any(start, way))}
        for end in sorted(ends | {end + 1 for end in ends if self.text(end) in _DONE}):
            not_there = self.past_any(end, "not") or end
            here = list(self.predicates(not_there))
            here += [((Looks(like),), stop) for like, stop in self.single(not_there)]
            here += [((Looks(like),), stop) for like, stop in self._listing(not_there)]
            here += [((Looks(like),), stop) for like, stop in self.storeys(not_there)]
            here += [((Looks(like),), stop) for like, stop in self.reversed_so(not_there)]
            here += [(looks, stop) for looks, stop in self.colored(not_there)]
            here += self._neither(end)
            if self.text(end) in _PILED:
                here += [((Made(TOWER), *said), stop) for said, stop in self.predicates(end + 1)]
                kept = self.text(end - 1) in {"stay", "stays", "remain", "remains"}
                here.append(((Made(replace(TOWER, order="kept") if kept else TOWER),), end + 1))
            if stays := self.past_any(end, *STAYS):
                here.append(((STAY,), stays))
            if denied and self.text(end - 1) in _MOVED:
                found.append(((STAY,), end))  # "must not be moved"
            if denied or not_there > end:  # what is joined to it may be denied, too, or not
                here = [(opposite, stop) for said, stop in here if (opposite := opposite_of(said))]
            found += here
        for end in {self.past_any(start, way) for way in _FORM} - {0}:
            for figure, stop in self.single(end):
                another = figure == Noun(det="another", noun="one") and self.text(start) in _FORMING
                if isinstance(figure, Noun) and (figure.noun in FIGURES or another) and not denied:
                    found += self.formed(figure, stop)
        for end in {self.past_any(start, way) for way in _BEAR} - {0}:
            if nothing := self.past_any(end, "nothing on top", "nothing on it", "nothing"):
                found.append(((Bears(None),), nothing))
            if denied:
                continue
            found += [((Looks(like),), stop) for like, stop in self.storeys(end)]
            for what, stop in self.phrase(end):
                of_each = self.text(stop) == "each"
                found.append(((Bears(what, each=of_each or self.text(start - 1) == "each"),), stop + of_each))
                found += self._borne(what, stop)
        if (end := self.past_any(start, "contain", "contains", "include", "includes")) and not denied:
            found += [((Holds(what),), stop) for what, stop in self.single(end)]
        found += self._same(at)
        if end := self.past_any(start, "touch", "touches", "touching"):
            found += [((Place("touch", of, no=denied),), stop) for of, stop in self.phrase(end)]
            if each := self.past_any(end, "each other", "one another"):
                found.append(((Place("touching", no=denied),), each))
        return found

    def formed(self, figure: Noun, at: int) -> Ways[tuple[Predicate, ...]]:
        """What is formed, with what is said of it behind."""
        found: Ways[tuple[Predicate, ...]] = [((Made(figure),), at)]
        that = self.past_any(at, "that", "which") or at
        found += [((Made(figure), *more), last) for more, last in self.verbs(that)]
        found += [((Made(figure), *more), last) for more, last in self.predicates(at)]
        return found

    def _same(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "must be", "must not": what was said ahead."""
        aux = self.past_any(at, *_MUST)
        no = self.past_any(aux, "not") if aux else 0
        found: Ways[tuple[Predicate, ...]] = []
        for end in {no or aux, self.past_any(no or aux, "be")} - {0}:
            if self.text(end) in _END:
                found.append(((Same(no > 0),), end))
                found += [((Same(), *piled), stop) for piled, stop in self._one_on_other(end + 1) if not no]
        return found

    def _one_on_other(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "one on top of the other"."""
        end = self.past_any(at, *_ONE_ON_OTHER)
        return [((Made(TOWER),), end)] if end else []

    def _neither(self, at: int) -> Ways[tuple[Predicate, ...]]:
        """ "neither at its top nor at its bottom"."""
        found: Ways[tuple[Predicate, ...]] = []
        for place, end in self.place(at + 1) if self.text(at) == "neither" else ():
            if nor := self.past_any(end, "nor"):
                for other, stop in self.place(nor):
                    if not place.no and not other.no:
                        found.append(((replace(place, no=True), replace(other, no=True)), stop))
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


def _of_same(place: Place, other: Place) -> Place:
    """ "at the top" of "at the top or at the bottom of the tower", "to the left" of "to the left or right of it"."""
    part = other.of
    if other.relation != "in" or not isinstance(part, Noun) or part.noun not in PARTS:
        return replace(place, of=part)
    sided = place.relation in {"left", "right"}
    noun, ranks = ("end", (place.relation,)) if sided else (place.relation, ())
    return replace(other, of=replace(part, noun=noun, ranks=ranks))


def opposite_of(said: tuple[Predicate, ...]) -> tuple[Predicate, ...]:
    """The opposite of one place that is said; nothing of more, and of what forms or looks so."""
    return tuple(replace(one, no=not one.no) for one in said if isinstance(one, Place)) if len(said) == 1 else ()
