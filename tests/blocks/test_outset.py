"""What is said of every start is so in those that are drawn."""

from __future__ import annotations

import pytest

from rpg.blocks.evaluate import evaluate
from rpg.blocks.initial import sample_start
from rpg.blocks.outset import at_every_start
from rpg.blocks.state import World
from rpg.blocks.waypoints import always_ahead
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.assets import ColoredCube, GoalPatch
from rpg.ir.schema import InitialState, Start

WORLD = World(
    [
        GoalPatch(name="mat", color="green", position=(0.5, 0.1)),
        *(ColoredCube(name=name, color="red") for name in ("one", "other", "third")),
    ]
)
ON_MAT = r.OnPatch(a=("one",), patch="mat")
TOWER = r.On(a=("one",), b=("other",))
APART = r.OnTable(a=("one", "other"))
BACK = r.Stayed(a=("one",))
POSED = InitialState(poses=(Start(block="one", position=(0.5, 0.1)),))
LOOSE = InitialState()
BUILT = InitialState(arranged=(ON_MAT,))
STACKED = InitialState(arranged=(g.All(goals=(TOWER, r.OnPatch(a=("other", "third"), patch="mat"))),))


@pytest.mark.parametrize("init", [LOOSE, POSED, BUILT, STACKED])
@pytest.mark.parametrize(
    "goal",
    [
        ON_MAT,
        TOWER,
        APART,
        BACK,
        r.Moved(a=("one",)),
        r.LeftOf(a=("one",), b=("other",)),
        *(g.Not(goal=part) for part in (ON_MAT, TOWER, APART)),
        g.All(goals=(APART, g.Not(goal=ON_MAT))),
        g.All(goals=(TOWER, r.LeftOf(a=("one",), b=("other",)))),
        g.Any(goals=(TOWER, BACK)),
        g.Any(goals=(TOWER, ON_MAT)),
        r.Above(a=("one",), b=("other",)),
        r.Empty(patch="mat"),
        r.OnPatch(a=("third",), patch="mat"),
        r.OnTable(a=("third",)),
    ],
)
def test_what_holds_at_every_start_does_in_each(goal: g.Goal, init: InitialState) -> None:
    told = at_every_start(goal, init)
    starts = (sample_start(init, WORLD, 0, attempt) for attempt in range(20))
    seen = {evaluate(goal, start.since(start)).value for start in starts}
    assert told is None or seen == {told}


def test_what_is_seen_of_starts() -> None:
    assert at_every_start(g.All(goals=(APART, g.Not(goal=ON_MAT))), LOOSE)
    assert at_every_start(g.Any(goals=(TOWER, ON_MAT)), LOOSE) is False
    assert at_every_start(ON_MAT, POSED) is None
    assert at_every_start(APART, InitialState(arranged=(TOWER,))) is None


def test_what_is_built_holds_at_every_start() -> None:
    assert at_every_start(g.All(goals=(ON_MAT, g.Not(goal=r.Empty(patch="mat")))), BUILT)
    assert at_every_start(TOWER.model_copy(update={"span": (3, 9)}), STACKED)
    assert at_every_start(r.OnPatch(a=("third",), patch="mat"), STACKED)
    assert at_every_start(r.OnPatch(a=("third",), patch="mat"), BUILT) is False
    assert at_every_start(r.Above(a=("other",), b=("one",)), STACKED) is None
    assert at_every_start(ON_MAT, InitialState(arranged=(ON_MAT,), heaps=(("other", "third"),))) is None


def test_a_later_stage_that_always_holds() -> None:
    there_and_back = g.Sequence(stages=(g.Stage(goal=ON_MAT, undone=True), g.Stage(goal=BACK)))
    assert always_ahead(g.All(goals=(there_and_back,)), LOOSE)
    again = g.Sequence(stages=(g.Stage(goal=r.Empty(patch="mat"), undone=True), g.Stage(goal=ON_MAT)))
    assert always_ahead(again, BUILT) and not always_ahead(again, LOOSE)
    assert not always_ahead(g.Sequence(stages=(g.Stage(goal=BACK), g.Stage(goal=ON_MAT))), LOOSE)
