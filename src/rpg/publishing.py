"""From what a compile yielded to what is on disk, and to what scripts are told about it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rpg.ir.artifact import GateReport
from rpg.loading import Task
from rpg.pipeline import Outcome
from rpg.store import (
    Content,
    Family,
    SteeringMeta,
    Workspace,
    Written,
    dump_schema,
    replace_file,
    write_base,
    write_rejected,
    write_version,
)


def content_of(outcome: Outcome, steering: SteeringMeta | None = None) -> Content:
    """The files and the description of a compiled task, as the store wants them."""
    program = outcome.program
    if program is None:
        raise ValueError("only a compile that yielded a program has content")
    return Content(
        files=files_of(outcome),
        description=" ".join((steering.request if steering else outcome.instruction).split()),
        assets_used=tuple(asset.name for asset in program.task.assets),
        goal_summary=outcome.goal_text,
        pictures=outcome.pictures,
        steering=steering,
    )


def publish(outcome: Outcome, workspace: Workspace, *, explicit: bool = False) -> Written | Path | None:
    """Write an admitted task as version 0 of its family, a failed one below .rejected/; a refused one leaves nothing.

    `explicit`: the user chose the name, so that it must not be taken by another task.
    """
    if outcome.status == "refused" or outcome.program is None:
        return None
    name = outcome.program.task.name
    if outcome.status == "failed":
        return write_rejected(workspace, name, files_of(outcome))
    return write_base(workspace, name, content_of(outcome), explicit=explicit)


def publish_version(outcome: Outcome, family: Family, content: Content) -> Written | Path:
    """Write an admitted task as the next version of `family`, a failed one below .rejected/."""
    if outcome.status == "failed":
        return write_rejected(Workspace(family.directory.parent), family.name, files_of(outcome))
    return write_version(family, content)


def write_pictures(task: Task, directory: Path, seed: int) -> tuple[Path, ...]:
    """Draw the start of `seed` and a goal state into `directory`; the files written."""
    from rpg.blocks.picture import draw

    states = {"initial.png": task.task_class().reset(seed), "goal.png": task.goal_class().reset(seed)}
    directory.mkdir(parents=True, exist_ok=True)
    for name, state in states.items():
        replace_file(directory / name, draw(state, beside=tuple(states.values())))
    return tuple(directory / name for name in states)


def summary(outcome: Outcome, place: Written | Path | None) -> dict[str, Any]:
    """A compile as one JSON document."""
    version = place.version if isinstance(place, Written) else None
    directory = version.directory if version else place
    return {
        "status": outcome.status,
        "family": version.family if version else None,
        "version": version.number if version else None,
        "hash": version.hash if version else None,
        "directory": str(directory) if directory else None,
        "goal_text": outcome.goal_text or None,
        "assumptions": list(outcome.assumptions),
        "gates": [gate_data(gate) for gate in outcome.gates],
        "diagnostics": [diagnostic.model_dump(mode="json") for diagnostic in outcome.diagnostics],
        "mutation_score": outcome.mutation_score,
    }


def gate_data(gate: GateReport) -> dict[str, Any]:
    """A gate's report with its figures beside its name."""
    return {"name": gate.name, "passed": gate.passed, **gate.model_dump(mode="json")["figures"]}


def files_of(outcome: Outcome) -> dict[str, bytes]:
    """The hashed files of a compile that yielded a program, by name."""
    program = outcome.program
    assert program is not None
    texts = {
        "task.yaml": dump_schema(program.task),
        "code.py": program.code,
        "goal_state_code.py": program.goal_code,
        "validation.log": outcome.log,
    }
    return {name: text.encode() for name, text in texts.items()}
