"""Runs the gates over a program: in this process where its code is our own lowering, else shut in."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any

from rpg.core.diagnostics import Diagnostic
from rpg.core.isolate import Answer, Child, Limits, Send
from rpg.core.nursery import Gone, Nursery
from rpg.core.passes import Listener, silent
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench, Gate, Measures
from rpg.passes.validate.findings import failure
from rpg.passes.validate.gates import GATES
from rpg.passes.validate.prints import prints_of

Reports = tuple[GateReport, ...]


def validate(
    program: Program,
    *,
    trusted: bool,
    measures: Measures | None = None,
    limits: Limits | None = None,
    listen: Listener = silent,
) -> Reports:
    """The reports of the gates, up to the first that fails.

    `trusted`: the code is, byte for byte, what the schema lowers to. Any other code is read by the text gate and then
    runs in confined processes alone.
    """
    measures = measures or Measures()
    if trusted:
        return _here(program, measures, limits or Limits(), listen)
    return _confined(program, measures, limits or Limits(), listen)


def admitted(reports: Sequence[GateReport]) -> bool:
    """Has every gate been passed?"""
    return len(reports) == len(GATES) and all(report.passed for report in reports)


def _here(program: Program, measures: Measures, limits: Limits, listen: Listener) -> Reports:
    nursery, number = _asked([program.code, program.goal_code, measures.resets, measures.smoke_steps])
    bench = Bench(program, measures, trusted=True, elsewhere=lambda: nursery.answer(number, limits.seconds) or {})
    try:
        return tuple(_until_failure(GATES, bench, listen))
    finally:
        nursery.drop(number)


def _asked(request: list[Any]) -> tuple[Nursery, int]:
    """A request under way in the nursery of this process; in a new one where the old one has ended."""
    nursery = _nursery(os.getpid())
    try:
        return nursery, nursery.ask(request)
    except Gone:
        _nursery.cache_clear()
        nursery = _nursery(os.getpid())
        return nursery, nursery.ask(request)


@lru_cache(maxsize=1)
def _nursery(_process: int) -> Nursery:
    """One for each process: a fork must not share its parent's."""
    return Nursery(lambda request: prints_of(*request))


def _confined(program: Program, measures: Measures, limits: Limits, listen: Listener) -> Reports:
    bench = Bench(program, measures)
    text, inside, last = GATES[:1], GATES[1:-1], GATES[-1:]
    reports = list(_until_failure(text, bench, listen))
    if not reports[-1].passed:
        return tuple(reports)
    listen("validate", "confined")

    def work(send: Send) -> None:
        for report in _until_failure(inside, bench, silent):
            send(report.model_dump(mode="json"))
        send(bench.prints)

    answer = Child(work, confined=True, limits=limits).answer()
    reports += [GateReport.model_validate(message) for message in answer.messages[: len(inside)] if "passed" in message]
    if answer.end != "done":
        gate = inside[min(len(reports) - 1, len(inside) - 1)]
        return (*reports, GateReport(name=gate.name, passed=False, diagnostics=(_ended(gate.name, answer, limits),)))
    if not reports[-1].passed:
        return tuple(reports)
    bench.prints = dict(answer.messages[-1])
    bench.elsewhere = lambda: _printed(program, measures, limits)
    return (*reports, *_until_failure(last, bench, listen))


def _until_failure(gates: Sequence[Gate], bench: Bench, listen: Listener) -> Iterator[GateReport]:
    for gate in gates:
        listen("validate", gate.name)
        report = gate.check(bench.program, bench)
        yield report
        if not report.passed:
            return


def _printed(program: Program, measures: Measures, limits: Limits) -> dict[str, str]:
    """What a fresh confined process measures; nothing where it does not get that far."""

    def work(send: Send) -> None:
        send(prints_of(program.code, program.goal_code, measures.resets, measures.smoke_steps))

    answer = Child(work, confined=True, limits=limits).answer()
    return dict(answer.messages[0]) if answer.end == "done" and answer.messages else {}


def _ended(gate: str, answer: Answer, limits: Limits) -> Diagnostic:
    """Why a confined process did not get through its gates."""
    if answer.end == "timeout":
        message = f"the code does not come to an end within {limits.seconds:g} s"
        return failure(gate, "code-times-out", "runtime", message, seconds=limits.seconds)
    if answer.end == "unconfined":
        message = "this code is not the lowering of its task.yaml, and this kernel has no means to confine it"
        hint = "run it where Linux has seccomp or Landlock, or compile the task.yaml again"
        return failure(gate, "code-not-confined", "runtime", message, hint=hint)
    message = f"the process of the code broke down: {answer.detail.strip().splitlines()[-1]}"
    return failure(gate, "code-crashes", "runtime", message)
