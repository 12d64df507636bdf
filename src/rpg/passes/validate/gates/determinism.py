"""Gate 9: the same seed gives the same state, to the bit, in a process that has done nothing else before."""

from __future__ import annotations

from dataclasses import dataclass

from rpg.core.nursery import Gone
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure


@dataclass(frozen=True)
class DeterminismGate:
    """Compare the states that the other gates saw with those of a fresh process."""

    name: str = "determinism"
    cost: int = 3

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Resets of the sampled seeds, and the state after the smoke steps."""
        if bench.elsewhere is None:
            return GateReport(name=self.name, passed=True)
        try:
            theirs = bench.elsewhere()
        except Gone:
            theirs = {}
        compared = sorted(set(bench.prints) | set(theirs))
        differing = [key for key in compared if bench.prints.get(key) != theirs.get(key)]
        found = []
        if differing:
            message = f"a fresh process comes to other states: {', '.join(differing)}"
            found.append(failure(self.name, "not-deterministic", "runtime", message, states=differing))
        return GateReport.of(self.name, found, states=len(compared), differing=len(differing))
