"""Chains of clauses: and, or, sequences in time; and what is settled once all are read."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.passes.schema.meaning import Chain, Clause
from rpg.passes.schema.resolve.clauses import clause_goals
from rpg.passes.schema.resolve.conflicts import undoes
from rpg.passes.schema.resolve.loose import settle
from rpg.passes.schema.resolve.relations import conj, disj
from rpg.passes.schema.resolve.world import Scene

Goals = list[g.Goal]


def chain_goals(chain: Chain, scene: Scene, start: bool = False) -> Goals:
    """The goals of a chain of clauses; those about the start go to the scene instead."""
    stages: list[Goals] = [[]]
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        if not isinstance(clause, Clause):
            continue
        starts = start or clause.mode in ("start", "given")
        goals = clause_goals(clause, scene, starts)
        goals = [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
        if starts and clause.verb != "exist":
            scene.start_goals += goals
            continue
        _append(stages, link, goals)
    return _sequence(stages, scene, chain)


def _append(stages: list[Goals], link: str, goals: Goals) -> None:
    if not goals:
        return
    match link:
        case "then" | "before":
            if stages[-1]:
                stages.append([])
            stages[-1] += goals
        case "after":
            stages.insert(max(0, len(stages) - 1), goals)
        case "or" if stages[-1]:
            last = stages[-1].pop()
            options = list(last.goals) if isinstance(last, g.Any) else [last]
            stages[-1].append(disj([*options, conj(goals)]))
        case _:
            stages[-1] += goals


def _sequence(stages: list[Goals], scene: Scene, chain: Chain) -> Goals:
    stages = [stage for stage in stages if stage]
    if len(stages) < 2:
        return stages[0] if stages else []
    goals = [conj(stage) for stage in stages]
    made = []
    for index, goal in enumerate(goals):
        later = goals[index + 1 :]
        made.append(g.Stage(goal=goal, undone=any(undoes(after, goal) for after in later)))
    return [g.Sequence(stages=tuple(made), span=chain.span)]


def join(sentences: list[tuple[str, Goals]], scene: Scene, span: tuple[int, int]) -> g.Goal:
    """The goals of all sentences; those that begin with "then" follow the ones before in time."""
    stages: list[g.Stage] = []
    now: Goals = []
    for link, goals in sentences:
        if link == "then" and goals:
            stages += _stages(now)
            now = []
        now += goals
    stages += _stages(now)
    if len(stages) > 1:
        fixed = []
        for index, stage in enumerate(stages):
            undone = any(undoes(after.goal, stage.goal) for after in stages[index + 1 :])
            fixed.append(g.Stage(goal=stage.goal, undone=undone))
        return settle(g.Sequence(stages=tuple(fixed), span=span), scene)
    goals = [stages[0].goal] if stages else []
    return settle(conj(goals, span) if goals else g.All(goals=()), scene)


def _stages(goals: Goals) -> list[g.Stage]:
    if len(goals) == 1 and isinstance(goals[0], g.Sequence):
        return list(goals[0].stages)
    return [g.Stage(goal=conj(goals))] if goals else []
