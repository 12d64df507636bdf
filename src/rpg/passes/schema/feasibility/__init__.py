"""Feasibility of a task before anything runs, in four steps.

    inventory      asset analysis: what blocks there are, what they show, which limits they are beyond
    requirements   requirement extraction: what the goal needs of room, distances, symbols, sight and the hand
    conflicts      the check: which of that cannot be, with the number that breaks it
    repairs        repair suggestion: the smallest change that would help, made where it changes nothing asked for

Only what follows from numbers and names is decided here; whether blocks can be arranged so is for the arrangement
solver to find out, before any code is written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from rpg.blocks.equivalence import equivalent
from rpg.core.diagnostics import Diagnostic, Refusal, Span
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.feasibility.conflicts import Conflict, conflicts
from rpg.passes.schema.feasibility.inventory import Inventory, take_stock
from rpg.passes.schema.feasibility.repairs import Repair, RepairKind, repairs
from rpg.passes.schema.feasibility.requirements import Requirement, requirements

__all__ = [
    "Conflict",
    "Feasibility",
    "Inventory",
    "Repair",
    "RepairKind",
    "Repairable",
    "Requirement",
    "examine",
    "suggestions",
]

Reader = Callable[[str], TaskSchema | None]
NOTHING_OPEN: Mapping[str, str] = MappingProxyType({})
MOST_REPAIRS = 8
"""Silent repairs that are made in one task."""


@dataclass(frozen=True)
class Feasibility:
    """What the four steps found about `task`, which has the silent repairs made in it.

    `chosen`: the objects whose colour the instruction left open.
    """

    task: TaskSchema
    stock: Inventory
    needs: tuple[Requirement, ...]
    conflicts: tuple[Conflict, ...]
    made: tuple[Repair, ...] = ()
    chosen: frozenset[str] = frozenset()

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What was repaired."""
        return tuple(
            Diagnostic(
                code="adapted",
                severity="note",
                message=repair.text,
                facts={"repair": repair.kind},
                origin="feasibility",
            )
            for repair in self.made
        )


class Repairable(Refusal):
    """A refusal with the repairs that might help, for each of its diagnostics, likeliest first."""

    def __init__(self, diagnostics: Iterable[Diagnostic], remedies: Iterable[Iterable[Repair]]) -> None:
        super().__init__(diagnostics)
        self.remedies = tuple(remedies)

    def blaming(self, code: str, span: Span | None) -> Repairable:
        """The same refusal, where diagnostics of this code are about these words."""
        told = (d.model_copy(update={"span": span or d.span}) if d.code == code else d for d in self.diagnostics)
        return Repairable(told, self.remedies)


def examine(task: TaskSchema, open_: Mapping[str, str] = NOTHING_OPEN) -> Feasibility:
    """The four steps over a task. `open_`: blocks whose symbol was left open, with the symbols they may show.

    Raises Repairable where the task is not possible as it is asked for.
    """
    made: tuple[Repair, ...] = ()
    while True:
        found = replace(_checked(task, open_), made=made)
        if not found.conflicts:
            return found
        silent = next((r for c in found.conflicts for r in repairs(task, found.stock, c) if r.silent), None)
        if silent is None or len(made) == MOST_REPAIRS:
            remedies = [repairs(task, found.stock, conflict) for conflict in found.conflicts]
            raise Repairable((conflict.diagnostic for conflict in found.conflicts), remedies)
        notes = dict.fromkeys((*silent.task.assumptions, silent.text))
        task = silent.task.model_copy(update={"assumptions": tuple(notes)})
        made = (*made, silent)


def suggestions(refusal: Repairable, read: Reader) -> tuple[Diagnostic, ...]:
    """The diagnostics of a refusal, each with the repair that would help, in words that `read` takes for that task."""
    return tuple(_with_suggestion(*pair, read) for pair in zip(refusal.diagnostics, refusal.remedies, strict=True))


def _checked(task: TaskSchema, open_: Mapping[str, str]) -> Feasibility:
    stock = take_stock(task, open_)
    needs = requirements(task, stock)
    return Feasibility(task, stock, needs, conflicts(task, stock, needs))


def _with_suggestion(problem: Diagnostic, remedies: Iterable[Repair], read: Reader) -> Diagnostic:
    for repair in remedies:
        if _checked(repair.task, NOTHING_OPEN).conflicts:
            continue
        for text in repair.instructions():
            understood = read(text)
            if understood is not None and equivalent(repair.task, understood):
                hint = f'{problem.hint}, or say "{text}"'
                facts = {**problem.facts, "repair": repair.kind, "keeps": repair.text, "instruction": text}
                return problem.model_copy(update={"hint": hint, "facts": facts})
    return problem
