"""Random goals: each becomes an admitted task with a full mutation score, or is refused with a reason."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from rpg.ir.assets import GoalPatch
from rpg.ir.goal import GOAL
from rpg.passes.validate import Measures
from rpg.pipeline import CompileOptions, compile_schema
from tests.passes.tasks import cube, letters, task

QUICK = CompileOptions(measures=Measures(resets=2, other_goals=1))
PATCHES = (GoalPatch(name="blue_patch", color="blue"), GoalPatch(name="red_patch", color="red", shape="circle"))
BLOCKS = (cube("red", "red_block_1"), cube("red", "red_block_2"), cube("blue"), cube("green"), *letters("AB"))
PAIRS = ("on", "above", "beside", "adjacent", "touching", "near")
SIDES = ("left_of", "right_of", "in_front_of", "behind")
SINGLES = ("on_table", "clear", "stayed", "moved")
REGIONS = ("left_half", "right_half", "near_half", "far_half", "middle", "corner", "edge", "far_left_corner")
ROWS: tuple[dict[str, Any], ...] = (
    {},
    {"axis": "x"},
    {"axis": "y", "evenly": True},
    {"touching": True},
    {"spacing": 0.08},
)
GOALS = 90
BATCHES = 6


def condition(rng: Random, blocks: list[str]) -> dict[str, Any]:
    """A random atom, or a count, over some of `blocks`."""
    a, b, c = rng.sample(blocks, 3)
    patch = rng.choice(PATCHES).name
    number = {"at_least": rng.choice((1, 2)), "at_most": rng.choice((None, 2))}
    length = rng.choice((0.06, 0.1, 0.15))
    some: list[dict[str, Any]] = [
        *({"kind": kind, "a": a, "b": b} for kind in PAIRS),
        *({"kind": kind, "a": a, "b": b, "somewhere": rng.random() < 0.3} for kind in SIDES),
        *({"kind": kind, "a": rng.choice((a, [a, b]))} for kind in SINGLES),
        {"kind": "apart", "a": a, "b": b, "distance": length + 0.05},
        {"kind": "distance", "a": a, "b": b, "minimum": length, "maximum": length + 0.02},
        {"kind": "on_patch", "a": rng.choice((a, [a, b])), "patch": patch},
        {"kind": "empty", "patch": patch},
        {"kind": "between", "a": a, "b": b, "c": c},
        {"kind": "in_region", "a": a, "region": rng.choice(REGIONS)},
        {"kind": "stack", "blocks": [a, b, c], "exact": rng.random() < 0.5},
        {"kind": "stack", "blocks": [a, b, c], "order": {"by": "given", "ranks": [a, b, c]}},
        {"kind": "row", "blocks": [a, b, c], **rng.choice(ROWS)},
        {"kind": "group_by", "groups": [[a, b], [c]]},
        {"kind": "grid", "blocks": rng.sample(blocks, 4), "rows": 2, "columns": 2},
        {"kind": "turned", "block": a, "degrees": rng.choice((45.0, 90.0, -90.0))},
        {"kind": "swapped", "a": a, "b": b},
        {"kind": "took_place", "a": a, "b": b},
        {"kind": "shifted", "a": rng.choice((a, [a, b])), "toward": rng.choice(("left", "right", "front", "back"))},
        {"kind": rng.choice(("approached", "receded")), "a": a, "b": b},
        {"kind": "count", "over": [a, b, c], **number, "goal": {"kind": "on_patch", "a": "each", "patch": patch}},
    ]
    return rng.choice(some)


def composed(rng: Random, parts: list[dict[str, Any]]) -> dict[str, Any]:
    """Parts together, one of them, one without the others, or one after the other."""
    shape = rng.random()
    if shape < 0.7:
        return {"kind": "all", "goals": parts}
    if shape < 0.8:
        return {"kind": "any", "goals": parts}
    if shape < 0.9:
        return {"kind": "all", "goals": [parts[0], *({"kind": "not", "goal": part} for part in parts[1:])]}
    return {"kind": "sequence", "stages": [{"goal": part} for part in parts]}


@pytest.mark.parametrize("batch", range(BATCHES))
def test_every_goal_is_admitted_or_refused(batch: int) -> None:
    admitted = 0
    for number in range(batch, GOALS, BATCHES):
        rng = Random(f"goal {number}")
        blocks = rng.sample(BLOCKS, rng.choice((4, 5, 6)))
        parts = [condition(rng, [block.name for block in blocks]) for _ in range(rng.choice((1, 2, 2, 3)))]
        schema = task("random", (*blocks, *PATCHES), GOAL.validate_python(composed(rng, parts)))
        outcome = compile_schema(schema, QUICK)
        assert outcome.status in ("admitted", "refused"), (number, outcome.log)
        assert outcome.attempts == (), (number, outcome.attempts)
        if outcome.status == "admitted":
            admitted += 1
            assert outcome.mutation_score == 1.0
        else:
            assert any(d.severity == "error" and d.message for d in outcome.diagnostics), number
    assert admitted >= 8
