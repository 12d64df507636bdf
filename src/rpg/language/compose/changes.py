"""Commands that change what is there: take out, swap, move to an end, replace, add, take apart."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.items import PATCH
from rpg.language.compose.lying import Lying
from rpg.language.compose.syntax import Change, Clause, Label, Noun, Phrase, Pronoun, several
from rpg.language.compose.words import Ways, remembered

_OUT = ("out", "off", "away", "down", "out again", "off again", "away again")
_FROM = ("of", "from", "off", "out of", "from the top of", "off of")
_TAKE = frozenset({"take", "lift", "pull", "get", "bring", "pick"})
_MOVE = frozenset({"move", "bring", "put", "shift", "slide", "place", "take", "get", "transfer", "carry", "set"})
_PUT = ("put", "place", "set", "lay", "move", "stack")
_SWAP = frozenset({"swap", "exchange", "switch"})
_PLACES = ("places", "place", "positions", "position", "their places", "their positions")
_SWAPPED = tuple(f"{swap} {places}" for swap in _SWAP | {"change", "trade"} for places in _PLACES)
_ENDS: dict[str, tuple[str, ...]] = {
    "left": ("left end", "far left"), "right": ("right end", "far right"), "first": ("beginning", "start", "front"),
    "last": ("end", "back"), "top": ("top", "very top"), "bottom": ("bottom", "very bottom"),
    "middle": ("middle", "center"), "other": ("other end", "opposite end"), "near": ("front end",),
    "far": ("back end",),
}  # fmt: skip
_END_WITH = ("end with", "finish with")
_OF_IT = ("of it", "of the row", "of the line", "of the tower", "of the stack", "of the word", "of the column")
_DIRECTIONS = {"to the left": "left", "to the right": "right", "up": "up", "down": "down", "left": "left",
               "right": "right"}  # fmt: skip
_ORDER = tuple(f"in {the} order" for the in ("", "the same", "their", "the original", "this", "their old"))
_KEPT = ("as a tower", "as a stack", "stacked", "in a tower", "on top of each other", *_ORDER)
_TOGETHER = ("back together", "together again", "together", "back on top of each other")


class Changes(Lying):
    """Reads them."""

    @remembered
    def changed(self, at: int) -> Ways[Clause]:
        """All changes that begin there."""
        text = self.text(at)
        found: Ways[Clause] = []
        if text in _TAKE or text == "remove":
            found += self._taken(at)
            found += self._taken_and_put(at)
        if text in _SWAP:
            found += self._swapped(at)
        if text in _MOVE:
            found += self._moved(at)
        if text in {"replace", "exchange", "swap"}:
            found += self._replaced(at)
        if text in {"add", "append", "attach", "put", "place"}:
            found += self._added(at)
        if text in {"take", "unstack", "pull", "dismantle", "split"}:
            found += self._apart(at)
        if end := self.past_any(at, "close the gap", "close the gaps", "close up the gap", "close up the gaps",
                                "close up", "push the others together", "push the rest together"):  # fmt: skip
            found.append((Clause(Pronoun("it"), (Change("close"),), "change"), end))
        found += self._kept(at)
        if text == "only":
            found += self._alone(at + 1)
        if with_ := self.past_any(at, *_END_WITH):
            found += self._of_them(with_)
        if text in {"the", "a"} or self.label(at) or len(text) > 2:
            found += self._of_them(at)
        return found

    def _change(self, what: Phrase, change: Change, end: int) -> tuple[Clause, int]:
        return Clause(what, (change,), "change"), end

    def _things(self, at: int) -> Ways[Phrase]:
        """What is changed: "both", "everything", "the second and the fourth letter"."""
        if all_ := self.past_any(at, "everything", "everything else", "all of it"):
            return [(Noun(det="all", noun="block"), all_)]
        return self.phrase(at)

    def _taken(self, at: int) -> Ways[Clause]:
        """ "take the middle one out", "remove the last letter from the row", "take only the top block off"."""
        found: Ways[Clause] = []
        ahead = self.past_any(at, *(f"{verb} {out}" for verb in ("take", "lift", "pull", "get") for out in _OUT[:3]))
        ahead = ahead or (at + 1 if self.text(at) == "remove" else 0)
        start = ahead or at + 1
        only = self.text(start) in {"only", "just"} and not self.number(start + 1)
        for what, end in self._things(start + only):
            out = self.past_any(end, *_OUT)
            if ahead or out:
                found.append(self._change(what, Change("out", only=only), out or end))
            starts = {self.past_any(begin, *_FROM) for begin in (out, end) if begin} - {0}
            for begin in starts:
                wholes = [way for way in self.single(begin) if not self._on_table(way[0])]
                found += [self._change(what, Change("out", whole, only=only), stop) for whole, stop in wholes]
        return found

    def _taken_and_put(self, at: int) -> Ways[Clause]:
        """ "take the rightmost one and put it on the leftmost one"."""
        found: Ways[Clause] = []
        start = self.past_any(at + 1, "up", "off", "out", "away") or at + 1
        for what, end in self.single(start):
            end = self.past_any(end, *_OUT) or end
            put = self.past_any(end, *(f"{and_} {put}" for and_ in ("and", ", and", "and then") for put in _PUT))
            if put and self.text(put) in {"it", "them"} and (self.text(put) == "them") == several(what):
                found += [(Clause(what, said, "put"), stop) for said, stop in self.predicates(put + 1)]
        return found

    def _on_table(self, phrase: Phrase) -> bool:
        return isinstance(phrase, Noun) and phrase.noun in {"table", "patch", *PATCH}

    def _swapped(self, at: int) -> Ways[Clause]:
        """ "swap the first and the last", "exchange A with B"."""
        found: Ways[Clause] = []
        places = self.past_any(at + 1, "the places of", "the positions of", "places of")
        start = places or at + 1
        start += self.text(start) in {"only", "just"}
        only = self.text(start - 1) in {"only", "just"}
        for what, end in self.phrase(start):
            found.append(self._change(what, Change("swap", only=only), self.past_any(end, "round", "around") or end))
            if self.text(end) == "with" and self.text(at) != "replace":
                found += [self._change(what, Change("swap", of), stop) for of, stop in self.single(end + 1)]
        return found

    def _of_them(self, at: int) -> Ways[Clause]:
        """ "red and green swap places", "the last one becomes the first"."""
        found: Ways[Clause] = []
        for what, end in self.phrase(at):
            aux = self.past_any(end, "should", "must", "have to", "shall", "are to") or end
            if stop := self.past_any(aux, *_SWAPPED):
                found.append(self._change(what, Change("swap"), stop))
            swapped = self.past_any(end, "swapped", "exchanged") if self.past_any(at - 2, *_END_WITH) else 0
            if stop := swapped:
                found.append(self._change(what, Change("swap"), stop))
            if becomes := self.past_any(end, "becomes the", "should become the", "must become the"):
                side = {"first": "first", "last": "last"}.get(self.text(becomes), "")
                stop = becomes + 1 + (self.text(becomes + 1) == "one")
                found += [self._change(what, Change("to", side=side), stop)] if side else []
        return found

    def _alone(self, at: int) -> Ways[Clause]:
        """ "(only) red has to come off", "(only) the top block is to be moved"."""
        found: Ways[Clause] = []
        for what, end in self.phrase(at):
            if stop := self.past_any(end, "has to come off", "must come off", "comes off", "should come off"):
                found.append(self._change(what, Change("out", only=True), stop))
            if stop := self.past_any(end, "is to be moved", "is moved", "has to be moved", "must be moved"):
                found.append(self._change(what, Change("move", only=True), stop))
        return found

    def _moved(self, at: int) -> Ways[Clause]:
        """ "bring the right one round to the left end", "move it two places to the left", "move only the top block"."""
        found: Ways[Clause] = []
        only = self.text(at + 1) in {"only", "just"} and not self.number(at + 2)
        for what, end in self.phrase(at + 1 + only):
            if only and self.text(at) == "move":
                found.append(self._change(what, Change("move", only=True), end))
            start = self.past_any(end, "round", "around", "over", "back") or end
            for change, stop in self._to(start):
                found.append(self._change(what, replace(change, only=only), stop))
        return found

    def _to(self, at: int) -> Ways[Change]:
        """ "to the left end of the row", "one place to the right", "before the A"."""
        found: Ways[Change] = []
        if start := self.past_any(at, "to the", "at the", "on the", "into the", "in the", "to its", "at its"):
            for side, ways in _ENDS.items():
                for end in {self.past_any(start, way) for way in ways} - {0}:
                    found.append((Change("to", side=side), end))
                    if of := self.past_any(end, *_OF_IT):
                        found.append((Change("to", side=side), of))
        by = at + (self.text(at) == "by")
        for steps, begin in [(self.number(by), by + 1), (1, by)]:
            unit = self.past_any(begin, "place", "places", "position", "positions", "spot", "spots", "step")
            for words, side in _DIRECTIONS.items() if steps and (unit or steps == 1) else ():
                if unit and (end := self.past(unit, words.split())):
                    found.append((Change("to", side=side, steps=steps), end))
                ahead = self.past(at, words.split())
                ahead += self.text(ahead) == "by" if ahead else 0
                if ahead and self.number(ahead) and (end := self.past_any(ahead + 1, "place", "places", "position",
                                                                         "positions", "spot", "spots")):  # fmt: skip
                    found.append((Change("to", side=side, steps=self.number(ahead)), end))
        for words, side in (("before", "before"), ("right before", "before"), ("in front of", "before"),
                            ("right after", "after"), ("after", "after")):  # fmt: skip
            if start := self.past_any(at, words):
                found += [(Change("to", of, side), end) for of, end in self.single(start)]
        return found

    def _replaced(self, at: int) -> Ways[Clause]:
        """ "replace the middle one with a yellow one"."""
        found: Ways[Clause] = []
        for what, end in self.phrase(at + 1):
            wide = self.past_any(end, *_OF_IT, "in it", "in the row", "in the tower") or end
            ways = ("with", "by") if self.text(at) == "replace" else ("for",)
            if start := self.past_any(wide, *ways):
                found += [self._change(what, Change("replace", of), stop) for of, stop in self._further(start)]
        return found

    def _further(self, at: int) -> Ways[Phrase]:
        """ "an S", "a yellow one": what comes to what is there."""
        found = self.phrase(at)
        if self.text(at) in {"a", "an", "another"} and (label := self.label(at + 1)):
            found = [*found, (Label(label), at + 2)]
        return found

    def _added(self, at: int) -> Ways[Clause]:
        """ "add an S at the end", "put the green block at its left end"."""
        found: Ways[Clause] = []
        for what, end in self._further(at + 1):
            start = self.past_any(end, *(f"to the {figure}" for figure in ("row", "line", "word", "tower", "stack")))
            for change, stop in self._to(start or end):
                if not change.steps and change.of is None:
                    found.append(self._change(what, replace(change, how="add"), stop))
        return found

    def _apart(self, at: int) -> Ways[Clause]:
        """ "take the tower apart", "unstack everything"."""
        found: Ways[Clause] = []
        for what, end in self._things(at + 1):
            if self.text(at) in {"unstack", "dismantle"}:
                found.append(self._change(what, Change("apart"), end))
            elif stop := self.past_any(end, "apart", "apart again", *(("down",) if self.text(at) == "take" else ())):
                found.append(self._change(what, Change("apart"), stop))
        return found

    def _kept(self, at: int) -> Ways[Clause]:
        """ "keep the other two in order", "leave the other two as a tower", "put the two red ones back together"."""
        found: Ways[Clause] = []
        verb = self.text(at)
        if verb in {"keep", "leave", "put", "push", "stack", "with"}:
            ways = _TOGETHER if verb in {"put", "push", "stack"} else _KEPT
            for what, end in self.phrase(at + 1):
                if stop := self.past_any(end, *ways):
                    found.append(self._change(what, Change("keep", side=self.text(stop - 1)), stop))
        left = self.items[at + 1].raw if verb == "leave" and at + 1 < len(self.items) else ""
        if left.isalpha() and left.isupper() and len(left) > 1:
            word = Noun(det="a", noun="word", word=left)
            found.append(self._change(word, Change("close"), at + 2))
        if verb == "the":
            for what, end in self.phrase(at):
                kept = self.past_any(end, "keep", "stay", "must keep", "must stay", "remain") or (
                    end if self.past_any(end, "in the same order") else 0
                )
                order = self.past_any(kept, "their order", "the same order", *_ORDER) if kept else 0
                found += [self._change(what, Change("keep", side="order"), order)] if order else []
        return found
