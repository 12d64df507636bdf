"""The validate-repair loop: bounded, never twice in the same state, never weaker than what was asked."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from rpg.core.diagnostics import Diagnostic
from rpg.core.passes import Listener, silent
from rpg.ir.artifact import FAILURE_CLASSES, FailureClass, GateReport, Program, failure_class
from rpg.ir.goal import Goal
from rpg.passes.repair.agents import AGENTS
from rpg.passes.repair.guard import dropped
from rpg.passes.repair.record import Agent, Attempt, Case, Proposal, Tools, digest

MOST_CYCLES = 5
MOST_ATTEMPTS = 3
"""Cycles of repair and validation in all, and of one agent."""


@dataclass(frozen=True)
class Repaired:
    """The best program that was found, its reports, and every attempt on the way."""

    program: Program
    reports: tuple[GateReport, ...]
    attempts: tuple[Attempt, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass
class _History:
    asked: Goal
    seen: set[str]
    attempts: list[Attempt] = field(default_factory=list)
    tries: Counter[str] = field(default_factory=Counter)

    def failed(self, agent: str, strategy: str) -> bool:
        """Is this a strategy that has not helped before?"""
        return any((a.agent, a.strategy) == (agent, strategy) for a in self.attempts)


def repair(
    program: Program, reports: tuple[GateReport, ...], asked: Goal, tools: Tools, listen: Listener = silent
) -> Repaired:
    """Mend a program that failed validation; the best state that was found where it cannot be mended."""
    history = _History(asked, {digest(program)})
    best = Case(program, reports, asked)
    while not _whole(best) and sum(history.tries.values()) < MOST_CYCLES:
        found = _next(best, history, tools)
        if found is None:
            break
        agent, proposal = found
        listen("repair", f"{agent.name}: {proposal.strategy}")
        history.tries[agent.name] += 1
        history.seen.add(digest(proposal.program))
        case = Case(proposal.program, tools.validate(proposal.program), asked)
        better = _whole(case) or _passed(case) > _passed(best)
        history.attempts.append(Attempt(agent.name, proposal.strategy, _passed(case), better))
        best = case if better else best
    return Repaired(best.program, best.reports, tuple(history.attempts), _told(best, history))


def _next(case: Case, history: _History, tools: Tools) -> tuple[Agent, Proposal] | None:
    """The first proposal worth trying, from the agents of the classes that failed."""
    by_class: dict[FailureClass, list[Diagnostic]] = {}
    for diagnostic in case.gate.failures:
        by_class.setdefault(failure_class(diagnostic), []).append(diagnostic)
    for kind in sorted(by_class, key=FAILURE_CLASSES.index):
        agent = AGENTS[kind]
        if history.tries[agent.name] >= MOST_ATTEMPTS:
            continue
        for proposal in agent.propose(case, tuple(by_class[kind]), tools):
            if history.failed(agent.name, proposal.strategy) or digest(proposal.program) in history.seen:
                continue
            lost = dropped(history.asked, proposal.program.task)
            if lost:
                reason = f"it would drop {len(lost)} of the conditions that were asked for: {lost[0].kind}"
                history.attempts.append(Attempt(agent.name, proposal.strategy, refused=reason))
                continue
            return agent, proposal
    return None


def _passed(case: Case) -> int:
    return sum(report.passed for report in case.reports)


def _whole(case: Case) -> bool:
    return case.gate.passed


def _told(best: Case, history: _History) -> tuple[Diagnostic, ...]:
    """What was done to the task, and what was refused, as notes."""
    found = []
    for attempt in history.attempts:
        if attempt.refused:
            message = f"{attempt.agent} refused to {attempt.strategy}: {attempt.refused}"
            found.append(Diagnostic(code="repair-refused", severity="note", message=message, origin="repair"))
        elif attempt.kept:
            message = f"{attempt.agent} mended the task: {attempt.strategy}"
            found.append(Diagnostic(code="repaired", severity="warning", message=message, origin="repair"))
    return tuple(found)
