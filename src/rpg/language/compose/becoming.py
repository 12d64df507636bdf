"""What there is at the start, and what becomes of it: "start from a tower", "turn it into a row", "reverse it"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.syntax import Clause, Made, Noun, Pronoun, is_figure
from rpg.language.compose.verbs import Verbs
from rpg.language.compose.words import Ways

_START_FROM = tuple(f"{start} {with_}" for start in ("start", "begin", "starting", "beginning", "start out")
                    for with_ in ("from", "with"))  # fmt: skip
_STARTS_AS = ("starts as", "starts out as", "begins as", "starts off as", "is at the start")
_TURN = frozenset({"turn", "rebuild", "change", "convert", "transform", "make", "rearrange", "build", "stack"})
_REVERSED = ("in the reverse order", "in reverse order", "in reversed order", "in the opposite order",
             "the other way round", "the other way around", "in reverse")  # fmt: skip
_ORDER_TURNED = tuple(
    f"{verb} {the} order{behind}"
    for verb, ways in (("turn", (" round", " around")), ("flip", ("",)), ("reverse", ("",)), ("invert", ("",)))
    for the in ("the", "its", "their") for behind in ways
)  # fmt: skip


class Becoming(Verbs):
    """Reads what there is first, and what it is turned into."""

    def begun(self, at: int) -> Ways[Clause]:
        """ "start from a row of A and B", "the tower starts as red, blue, red from bottom to top"."""
        found: Ways[Clause] = []
        if start := self.past_any(at, *_START_FROM):
            found += [(Clause(what, (), "start"), end) for what, end in self.single(start) if is_figure(what)]
        for what, end in self.single(at):
            start = self.past_any(end, *_STARTS_AS)
            if start and isinstance(what, Noun) and what.det == "the" and what == Noun(det="the", noun=what.noun):
                told = self.in_turn(replace(what, det="a"), start)
                found += [(Clause(figure, (), "start"), stop) for figure, stop in told]
        return found

    def turned(self, at: int) -> Ways[Clause]:
        """ "turn it into a tower", "rebuild it in reverse order": what there is becomes something else."""
        found: Ways[Clause] = []
        for what, end in self.single(at + 1) if self.text(at) in _TURN else ():
            found += [(Clause(what, (Made(figure),), "build"), stop) for figure, stop in self.into(end)]
            ways = (("one", self.past_any(end, *_REVERSED)), ("tower", self.past_any(end, "upside down")))
            back = [(Made(Noun(det="a", noun=noun, order="reversed")), stop) for noun, stop in ways if stop]
            found += [(Clause(what, (said,), "build"), stop) for said, stop in back]
        reverse = Made(Noun(det="a", noun="one", order="reversed"))
        if turned := self.past_any(at, *_ORDER_TURNED):
            found.append((Clause(Pronoun("it"), (reverse,), "build"), turned))
        if self.text(at) == "reverse":
            found += [(Clause(what, (reverse,), "build"), end) for what, end in self.single(at + 1)]
        return found
