"""Goals over time: what a task must remember of an episode for stages and standing conditions."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.verdict import FALSE, Verdict, every, holds


class Stages:
    """How far a sequence has come. A stage counts as met only in a settled state."""

    def __init__(self) -> None:
        self.met = 0
        self.broken = False
        self._before: list[bool] | None = None

    def advance(self, stages: Sequence[Verdict], settled: bool, passed: Sequence[int] = ()) -> None:
        """Take the next state into account: the first one is the start of the episode. `passed`: stages that may be met
        early."""
        values = [stage.value for stage in stages]
        if not settled or self.broken:
            return
        met = self.met
        while met < len(values) and values[met]:
            met += 1
        early = range(met + 1, len(values)) if self._before is not None else ()
        self.broken = any(values[k] and not (self._before or [])[k] for k in early if k not in passed)
        self.met = self.met if self.broken else met
        self._before = values

    def copy(self) -> Stages:
        """The same, to go on from."""
        made = Stages()
        made.met, made.broken, made._before = self.met, self.broken, self._before
        return made

    @property
    def ahead(self) -> bool:
        """Does the goal of a later stage hold already?"""
        return any((self._before or [])[self.met + 1 :])


class Memory:
    """What is remembered under one naming of look-alikes. Entries are known by the order of the calls in `_success`."""

    def __init__(self) -> None:
        self.sequences: list[Stages] = []
        self.lapses: list[bool] = []
        self._sequence = self._always = 0
        self._settled = False

    def begin(self, settled: bool) -> None:
        """A new state is about to be judged."""
        self._sequence = self._always = 0
        self._settled = settled

    def in_order(self, stages: Sequence[Verdict], undone: Sequence[int], passed: Sequence[int] = ()) -> Verdict:
        """All stages were met in turn, and hold but for those that are `undone`; those `passed` on the way to the one
        in front of them may be met before it as well."""
        if self._sequence == len(self.sequences):
            self.sequences.append(Stages())
        record = self.sequences[self._sequence]
        self._sequence += 1
        record.advance(stages, self._settled, passed)
        if record.broken:
            return FALSE
        now = every(stage for k, stage in enumerate(stages) if k not in undone)
        if record.met == len(stages):
            return now
        return Verdict(False, min(now.margin, (record.met - len(stages)) / len(stages)))

    def always(self, condition: Verdict) -> Verdict:
        """The condition holds, and held at every step so far."""
        if self._always == len(self.lapses):
            self.lapses.append(False)
        self.lapses[self._always] |= not condition.value
        lapsed = self.lapses[self._always]
        self._always += 1
        return FALSE if lapsed else condition

    def copy(self) -> Memory:
        """The same, to go on from."""
        made = Memory()
        made.sequences, made.lapses = [stages.copy() for stages in self.sequences], list(self.lapses)
        return made

    @property
    def stage(self) -> int:
        """Stages met so far, of all sequences together."""
        return sum(record.met for record in self.sequences)

    @property
    def ahead(self) -> bool:
        """Does the goal of a stage hold that is not up yet?"""
        return any(record.ahead for record in self.sequences)

    @property
    def used(self) -> bool:
        """Does the goal look over time at all?"""
        return bool(self.sequences or self.lapses)

    def out_of_order(self) -> Verdict:
        """Was a stage met before the one in front of it?"""
        return holds(1.0 if any(record.broken for record in self.sequences) else -1.0)

    def lapsed(self) -> Verdict:
        """Did a standing condition fail at some step?"""
        return holds(1.0 if any(self.lapses) else -1.0)
