"""Look-alikes: a task judges as the plain definition does, which looks at every naming of a renamed state in full."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
import pytest

from rpg.blocks.arrange.solve import Solver
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.near_miss import near_misses
from rpg.blocks.predicates.order import agrees
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import interchangeable, link, namings, rename_state
from rpg.blocks.traits import Traits
from rpg.blocks.verdict import Verdict, between, every, some
from rpg.blocks.verdicts import Verdicts, counted
from rpg.env import BlockTask
from rpg.env.progress import Memory
from rpg.ir import goal as g
from rpg.ir.assets import ColoredCube
from rpg.ir.order import Order, Pattern
from rpg.ir.walk import instances
from tests.blocks.random_goals import random_atom, random_state, random_world


def told(task: BlockTask, goal: g.Goal) -> Verdict:
    """The goal as the calls that generated code makes."""
    match goal:
        case g.All():
            return _fold(goal.goals, task, all_of=True)
        case g.Any():
            return _fold(goal.goals, task, all_of=False)
        case g.Not():
            return ~told(task, goal.goal)
        case g.Always():
            return task.always(told(task, goal.goal))
        case g.Count():
            verdicts = [told(task, part) for part in instances(goal)]
            return task.count(verdicts, at_least=goal.at_least, at_most=goal.at_most)
        case g.Sequence():
            undone = [k for k, stage in enumerate(goal.stages) if stage.undone]
            return task.in_order(*[told(task, stage.goal) for stage in goal.stages], undone=undone)
    fields: dict[str, Any] = {field: getattr(goal, field) for field in type(goal).model_fields}
    method = getattr(task, fields.pop("kind"))
    del fields["span"]
    verdict: Verdict = method(**fields)
    return verdict


def _fold(goals: Sequence[g.Goal], task: BlockTask, *, all_of: bool) -> Verdict:
    first, *rest = [told(task, goal) for goal in goals]
    for verdict in rest:
        first = first & verdict if all_of else first | verdict
    return first


def task_of(goal: g.Goal, world: World) -> BlockTask:
    class Asked(BlockTask):
        interchangeable = interchangeable(goal, world)

        def _initialize_env(self) -> None:
            for asset in world.assets.values():
                self.add(asset)

        def _success(self) -> Verdict:
            return told(self, goal) & self.at_rest()

        def _fail(self) -> Verdict:
            return self.out_of_order() | self.lapsed()

    return Asked()


class Plain:
    """The definition: every naming by itself, on a state in which the blocks have changed their names."""

    def __init__(self, goal: g.Goal, world: World) -> None:
        self.goal = goal
        self.namings = namings(interchangeable(goal, world))
        self.memories = [Memory() for _ in self.namings]

    def judge(self, state: BlockState) -> tuple[Verdict, bool, int]:
        found, lost = [], True
        rest = settled(state)
        for naming, memory in zip(self.namings, self.memories, strict=True):
            memory.begin(rest.value)
            success = self._value(self.goal, rename_state(state, naming), memory) & rest
            failed = (memory.out_of_order() | memory.lapsed()).value
            lost = lost and failed
            found.append((success.value, not failed, memory.stage, success.margin))
        value, _, stage, margin = max(found)
        return Verdict(value, margin), lost, stage

    def _value(self, goal: g.Goal, state: BlockState, memory: Memory) -> Verdict:
        match goal:
            case g.Sequence():
                stages = [evaluate(stage.goal, state) for stage in goal.stages]
                return memory.in_order(stages, [k for k, stage in enumerate(goal.stages) if stage.undone])
            case g.Always():
                return memory.always(evaluate(goal.goal, state))
            case g.All() if goal.goals:
                first, *rest = [self._value(part, state, memory) for part in goal.goals]
                for verdict in rest:
                    first &= verdict
                return first
        return evaluate(goal, state)


def random_goal(world: World, rng: Random) -> g.Goal:
    """One to four conditions, now and then with "not", "or", a count, a sequence or what always holds around them."""
    parts: list[g.Goal] = [random_atom(world, rng) for _ in range(rng.randint(1, 4))]
    shape = rng.random()
    if shape < 0.2:
        parts[0] = g.Not(goal=parts[0])
    elif shape < 0.4:
        parts[0] = g.Any(goals=(parts[0], random_atom(world, rng)))
    elif shape < 0.55:
        inner = g.OnTable(a=("each",))
        parts[0] = g.Count(over=tuple(world.blocks), at_least=1, at_most=rng.choice((None, 2)), goal=inner)
    elif shape < 0.75:
        stages = tuple(g.Stage(goal=random_atom(world, rng), undone=rng.random() < 0.3 and k == 0) for k in range(2))
        parts.append(g.Sequence(stages=stages))
    elif shape < 0.9:
        parts.append(g.Always(goal=random_atom(world, rng)))
    return link(g.All(goals=tuple(parts)), world)


@pytest.mark.parametrize("block", range(6))
def test_a_task_judges_look_alikes_as_the_definition_does(block: int) -> None:
    several = 0
    for seed in range(60 * block, 60 * (block + 1)):
        rng = Random(seed)
        world = random_world(rng)
        goal = random_goal(world, rng)
        task, plain = task_of(goal, world), Plain(goal, world)
        if len(plain.namings) > 200:
            continue
        several += len(plain.namings) > 1
        start = random_state(world, rng)
        states = [replace(random_state(world, rng), start=start, _axes={}) for _ in range(4)]
        states.append(replace(states[0], held=frozenset({rng.choice(list(world.blocks))})))
        plain.judge(replace(start, start=start))
        for state, judged in zip(states, task.judge_states(states, start), strict=True):
            success, failed, stage = plain.judge(state)
            assert (judged.success.value, judged.failed, judged.stage) == (success.value, failed, stage), goal
            assert judged.success.margin == pytest.approx(success.margin, abs=1e-9), goal
    assert several > 10


def _names(*numbers: int) -> tuple[str, ...]:
    return tuple(f"red_{k}" for k in numbers)


def _of(*numbers: int, **fields: Any) -> dict[str, Any]:
    return {"blocks": _names(*numbers), **fields}


STRUCTURES: dict[str, tuple[int, g.Goal]] = {
    "three rows of two, not one of six": (
        6,
        g.All(
            goals=(
                *(g.Row(**_of(k, k + 1, axis="y")) for k in (1, 3, 5)),
                g.Not(goal=g.Row(**_of(1, 2, 3, 4, 5, 6, axis="y"))),
            )
        ),
    ),
    "two towers of two and a row of two": (
        6,
        g.All(
            goals=(
                g.Stack(**_of(1, 2, exact=True)),
                g.Stack(**_of(3, 4, exact=True)),
                g.Row(**_of(5, 6)),
                g.Beside(a="red_1", b="red_3", gap_edges=2.0),
            )
        ),
    ),
    "a tower of three and an L or a row of three": (
        6,
        g.All(
            goals=(
                g.Stack(**_of(1, 2, 3)),
                g.Any(goals=(g.Figure(**_of(4, 5, 6, shape="L")), g.Row(**_of(4, 5, 6, evenly=True)))),
            )
        ),
    ),
    "pairs on the table, at least two of the others on them": (
        5,
        g.All(
            goals=(
                g.OnTable(a=("red_1", "red_2")),
                g.Near(a="red_1", b="red_2"),
                g.Count(over=("red_3", "red_4", "red_5"), at_least=2, goal=g.Above(a="each", b="red_1")),
            )
        ),
    ),
    "a row with something on its middle block": (
        4,
        g.All(
            goals=(
                g.Row(
                    **_of(1, 2, 3, axis="y"),
                    order=Order(by="given", ranks=("red_2", "red_1", "red_3"), first="left", match="name"),
                ),
                g.On(a="red_4", b="red_1"),
            )
        ),
    ),
    "two rows": (
        7,
        g.All(goals=(g.Row(**_of(1, 2, 3, axis="y")), g.Row(**_of(4, 5, 6, 7, axis="y")))),
    ),
    "a grid with something on its middle block": (
        10,
        g.All(
            goals=(
                g.Grid(
                    **_of(2, 3, 4, 5, 1, 6, 7, 8, 9, rows=3, columns=3),
                    pattern=Pattern(
                        kind="reading",
                        order=Order(
                            by="given",
                            ranks=(_names(2, 3, 4, 5), ("red_1",), _names(6, 7, 8, 9)),
                            match="single",
                        ),
                    ),
                ),
                g.On(a="red_10", b="red_1"),
            )
        ),
    ),
    "two groups": (5, g.GroupBy(groups=(("red_1", "red_2", "red_3"), ("red_4", "red_5")))),
}


@pytest.mark.parametrize("told_as", STRUCTURES)
def test_structures_of_look_alikes_are_judged_as_the_definition_does(told_as: str) -> None:
    count, goal = STRUCTURES[told_as]
    world = World([ColoredCube(name=f"red_{k}", color="red") for k in range(1, count + 1)])
    task, plain, rng = task_of(goal, world), Plain(goal, world), Random(told_as)
    assert len(plain.namings) > 5
    states = [random_state(world, rng) for _ in range(5)]
    for _ in range(2):
        arranged = Solver(goal, world, None).solve(rng, vary=True)
        assert arranged is not None
        names = list(world.blocks)
        shuffled = dict(zip(names, rng.sample(names, count), strict=True))
        states += [rename_state(state, shuffled) for state in (arranged, *_some(goal, arranged, rng))]
    for state in states:
        (judged,) = task.judge_states([state])
        success, _, _ = plain.judge(state)
        assert judged.success.value == success.value
        assert judged.success.margin == pytest.approx(success.margin, abs=1e-9)
    assert any(task.judge_states([state])[0].success for state in states)


def test_only_blocks_of_their_own_rank_are_compared_by_name() -> None:
    world = World([ColoredCube(name=f"red_{k}", color="red") for k in range(1, 10)])
    ranks = (_names(2, 3, 4, 5), ("red_1",), _names(6, 7, 8, 9))
    order = Order(by="given", ranks=ranks)
    pattern = Pattern(kind="reading", order=order)
    grid = g.Grid(**_of(*range(1, 10), rows=3, columns=3), pattern=pattern)
    linked = link(g.All(goals=(grid, g.OnTable(a=("red_1",)))), world)
    assert isinstance(linked, g.All) and isinstance(linked.goals[0], g.Grid) and linked.goals[0].pattern is not None
    assert linked.goals[0].pattern.order.match == "single"
    assert len(namings(interchangeable(linked, world))) == 9
    traits, single = Traits(world), order.model_copy(update={"match": "single"})
    assert agrees(single, [f"red_{k}" for k in (9, 8, 7, 6, 1, 2, 3, 4, 5)], traits)
    assert not agrees(single, [f"red_{k}" for k in (1, 2, 3, 4, 5, 6, 7, 8, 9)], traits)
    by_name = order.model_copy(update={"match": "name"})
    assert not agrees(by_name, [f"red_{k}" for k in (9, 8, 7, 6, 1, 2, 3, 4, 5)], traits)
    # where two blocks of one rank are told apart as well, all are compared by name
    apart = link(g.All(goals=(grid, g.OnTable(a=("red_1",)), g.Above(a="red_2", b="red_3"))), world)
    assert isinstance(apart, g.All) and isinstance(apart.goals[0], g.Grid) and apart.goals[0].pattern is not None
    assert apart.goals[0].pattern.order.match == "name"


def _some(goal: g.Goal, state: BlockState, rng: Random) -> list[BlockState]:
    found = [miss.state for miss in near_misses(goal, state, rng)]
    return rng.sample(found, min(5, len(found)))


def test_verdicts_combine_under_all_namings_as_they_do_under_each() -> None:
    rng = Random(5)
    for _ in range(300):
        several = [[_verdict(rng) for _ in range(7)] for _ in range(rng.randint(1, 5))]
        vectors = [Verdicts.spread(column, np.arange(7)) for column in several]
        least, most = rng.randint(0, 5), rng.choice((None, 0, 1, 3))
        joined, either = vectors[0], vectors[0]
        for vector in vectors[1:]:
            joined, either = joined & vector, either | vector
        enough = counted(least, most, vectors, 7)
        for k in range(7):
            column = [verdicts[k] for verdicts in several]
            assert joined.of(k) == every(column)
            assert either.of(k) == some(column)
            assert (~vectors[0]).of(k) == ~column[0]
            assert enough.of(k) == between(least, most, column)
        best = max(range(7), key=lambda k: joined.of(k))
        assert joined.of(joined.best()) == joined.of(best)


def _verdict(rng: Random) -> Verdict:
    value = rng.random() < 0.5
    margin = rng.choice((0.0, 0.25, rng.random()))
    return Verdict(value, margin if value else -margin)


def test_code_that_looks_at_single_verdicts_is_asked_about_every_naming_in_turn() -> None:
    world = World([ColoredCube(name=f"red_{k}", color="red") for k in range(1, 5)])
    goal = g.All(goals=(g.On(a="red_1", b="red_2"), g.On(a="red_3", b="red_1")))

    class Looking(task_of(goal, world).__class__):  # type: ignore[misc]
        def _success(self) -> Verdict:
            if self.on("red_1", "red_2") and self.on("red_1", "red_2").margin >= 0.0:
                return self.on("red_3", "red_1") & self.at_rest()
            return self.on("red_1", "red_2") & self.at_rest()

    task, other = Looking(), task_of(goal, world)
    start = random_state(world, Random(1))
    up = {f"red_{k}": ((0.5, 0.0, 0.97 + 0.04 * z), (1.0, 0.0, 0.0, 0.0)) for k, z in ((4, 0), (2, 1), (3, 2))}
    for state in (start, start.moved(up)):
        assert [j.success.value for j in task.judge_states([state])] == [
            j.success.value for j in other.judge_states([state])
        ]
    assert task.judge_states([start.moved(up)])[0].success


def test_the_order_in_which_blocks_are_listed_says_nothing_where_namings_take_it_for_nothing() -> None:
    for seed in range(200):
        rng = Random(seed)
        world = random_world(rng)
        state = random_state(world, rng)
        blocks = tuple(world.blocks)
        shuffled = tuple(rng.sample(blocks, len(blocks)))
        for kind in (g.Row, g.Towers, g.OnTable, g.Clear):
            field = "a" if kind in (g.OnTable, g.Clear) else "blocks"
            told, other = (evaluate(kind(**{field: listed}), state) for listed in (blocks, shuffled))
            assert (told.value, told.margin) == (other.value, pytest.approx(other.margin, abs=1e-9))
