"""Sessions of edits, read from YAML, run turn by turn and compared with what they have to mean."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import yaml

from rpg.ir.edits import EDIT, apply
from rpg.pipeline import compile_instruction, prepared
from rpg.publishing import publish
from rpg.steering import Steered, steer
from rpg.store import Family, Workspace, Written, dump_schema
from tests.corpus.entries import LOADER, Entry
from tests.corpus.judge import _disagreement

FOLDER = Path(__file__).parent / "sessions"
KEYS = {"edit", "class", "from", "assets", "hold", "miss", "same", "refuse", "back"}
Score = Literal["right", "refused", "wrong"]


@dataclass(frozen=True)
class Script:
    """A base instruction and its turns, as the file has them."""

    file: str
    number: int
    base: str
    turns: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Mark:
    """How one turn came out, and why it is not right."""

    script: Script
    edit: str
    score: Score
    why: str = ""


def scripts(split: str) -> list[Script]:
    """Every session of a split."""
    found = []
    for path in sorted((FOLDER / split).glob("*.yaml")):
        for number, data in enumerate(yaml.load(path.read_text(encoding="utf-8"), Loader=LOADER)):
            for turn in data["turns"]:
                assert not set(turn) - KEYS, f"{path}: unknown keys in {turn}"
            found.append(Script(f"{split}/{path.stem}", number, data["base"], tuple(data["turns"])))
    return found


def play(script: Script, root: Path) -> Iterator[Mark]:
    """Run a session in a workspace; a turn that went wrong ends it, as the next ones build on it."""
    outcome = compile_instruction(script.base)
    place = publish(outcome, Workspace(root))
    if not isinstance(place, Written):
        yield Mark(script, script.base, "refused", "; ".join(d.message for d in outcome.diagnostics))
        return
    family = Family(place.version.directory.parent)
    for turn in script.turns:
        before = family.head().number, len(family.versions())
        done = steer(family.head(), turn["edit"])
        why, score = _why(turn, done, family, before)
        yield Mark(script, turn["edit"], score, why)
        if score != "right":
            return


def _why(turn: dict[str, Any], done: Steered, family: Family, before: tuple[int, int]) -> tuple[str, Score]:
    head, count = before
    if done.status != "admitted":
        said = "; ".join(f"{d.code}: {d.message}" for d in done.diagnostics if d.severity == "error")
        if (family.head().number, len(family.versions())) != before:
            return f"refused, but something changed ({said})", "wrong"
        expected = turn.get("refuse", False)
        if expected is True or (expected and any(d.code in expected for d in done.diagnostics)):
            return "", "right"
        return said, "refused"
    if turn.get("refuse"):
        goal = done.outcome.goal_text if done.outcome else "went back"
        return f"was carried out: {goal}", "wrong"
    if "back" in turn:
        fine = family.head().number == turn["back"] and len(family.versions()) == count
        return ("", "right") if fine else (f"went to {family.head().number}", "wrong")
    if done.reverted:
        return "only went back", "wrong"
    return _differs(turn, done, head)


def _differs(turn: dict[str, Any], done: Steered, head: int) -> tuple[str, Score]:
    assert done.verdict and done.outcome and done.outcome.program and done.interpretation and done.proof
    classes = turn.get("class", [])
    classes = [classes] if isinstance(classes, str) else classes
    if classes and done.verdict.category not in classes:
        return f"class {done.verdict.category} ({done.verdict.reason})", "wrong"
    reference = done.interpretation.reference
    # What may be fresh but keeps blocks all the same is made from the version it was asked of.
    fresh = "FRESH" in classes and turn.get("from", head) is None
    if done.verdict.category != "FRESH" and reference != (head if fresh else turn.get("from", head)):
        return f"from version {reference}", "wrong"
    schema = done.outcome.program.task
    if not _replays(done):
        return "its edits do not lead to it again", "wrong"
    looks = {block.name: _look(block) for block in schema.blocks}
    untouched = {looks[name] for name in done.proof.positions.blocks}
    for look in turn.get("same", []):
        if look not in untouched or any(looks[name] == look for name in done.proof.positions.moved):
            return f"the start of {look} is not kept", "wrong"
    states = {key: tuple(_trajectory(state) for state in turn.get(key, ())) for key in ("hold", "miss")}
    entry = Entry("", "", turn["edit"], assets=turn.get("assets"), hold=states["hold"], miss=states["miss"])
    why = _disagreement(entry, schema)
    return (why, "wrong") if why and not why.endswith("start in a heap") else ("", "right")


def _look(block: Any) -> str:
    """A block as the files name it: by its colour, or by its symbol and the colour of its body."""
    label = getattr(block, "label", "")
    return f"{block.color}:{label}" if label and block.color != "ivory" else label or block.color


def _trajectory(state: str | list[str]) -> tuple[str, ...]:
    return tuple(state) if isinstance(state, list) else (str(state),)


def _replays(done: Steered) -> bool:
    """Whether the recorded edits, applied to the version they started from, give the recorded task."""
    assert done.version is not None
    steering = done.version.snapshot.steering
    assert steering is not None
    family = Family(done.version.directory.parent)
    parent = next(version for version in family.versions() if version.hash == steering.parent)
    edits = [EDIT.validate_python(edit) for edit in steering.edits]
    again = prepared(apply(parent.schema, edits))
    return dump_schema(again).encode() == (done.version.directory / "task.yaml").read_bytes()
