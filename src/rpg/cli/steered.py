"""What a request about a task came to, and how two versions differ, as people read them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from rich.padding import Padding
from rich.text import Text

from rpg.cli.report import print_diagnostics
from rpg.cli.summary import gate_table, print_outcome

if TYPE_CHECKING:
    from rich.console import Console

    from rpg.cli.output import Output
    from rpg.steer.proof.compare import Witness
    from rpg.steer.proof.proof import Proof
    from rpg.steering import Steered

RELATIONS = {
    "equal": "both goals accept the same states",
    "implies": "every state that the new goal accepts, the old one accepts too",
    "implied by": "every state that the old goal accepts, the new one accepts too",
    "overlaps": "each goal accepts states that the other does not",
    "disjoint": "no state satisfies both goals",
}
AXES = {"S": "language", "V": "appearance or start", "B": "required behaviour"}


def print_steered(out: Output, done: Steered) -> None:
    """The result on stdout, a refusal on stderr. With --quiet, the directory alone."""
    if out.as_json:
        return
    if done.status == "refused":
        print_diagnostics(out.errors, [d for d in done.diagnostics if d.severity == "error"], done.request)
        return
    version = done.version
    if version is not None and out.quiet:
        out.result.print(str(version.directory), soft_wrap=True)
        return
    if done.reverted:
        assert version is not None
        goal = version.snapshot.snapshot.goal_summary
        out.result.print(Text.assemble(("✓ ", "bold green"), f"back at {version}: ", (goal, "")))
        return
    if done.status == "failed" and done.outcome is not None:
        print_outcome(out, done.outcome, done.place)
        return
    _print_version(out.result, done)


def _print_version(console: Console, done: Steered) -> None:
    version, outcome, verdict, proof = done.version, done.outcome, done.verdict, done.proof
    assert version is not None and outcome is not None and verdict is not None and proof is not None
    reference = "nothing" if verdict.category == "FRESH" else f"version {_reference(done)}"
    title = Text.assemble(
        ("✓ ", "bold green"), (str(version), "bold"), (f"  {version.short_hash}  ", "dim"),
        (verdict.category, "bold magenta"), (f" of {reference}", "dim"),
    )  # fmt: skip
    console.print(title)
    console.print(Text(f"  {version.directory}"), soft_wrap=True)
    if done.same_as is not None:
        console.print(Text(f"  this is version {done.same_as} again; its validation holds"))
    if verdict.reason:
        console.print(Text.assemble(("  ", ""), ("note", "yellow"), f": {verdict.reason}"))
    console.print()
    console.print(Padding.indent(Text(outcome.goal_text), 2))
    console.print()
    for assumption in outcome.assumptions:
        console.print(Text.assemble(("  assumed: ", "yellow"), assumption))
    kept = [name for name, held in verdict.preserve.model_dump().items() if held]
    console.print(Text.assemble(("  preserved: ", "bold"), ", ".join(kept) or "nothing"))
    print_proof(console, proof)
    console.print(Padding.indent(gate_table(outcome.gates), 2))
    if outcome.pictures:
        console.print(Text(f"  pictures: {', '.join(outcome.pictures)}", "dim"))


def _reference(done: Steered) -> str:
    return str(done.interpretation.reference) if done.interpretation else "?"


def print_proof(console: Console, proof: Proof) -> None:
    """How two versions differ in assets, start, goal and language, and what the bank of states says of the goals."""
    diff = proof.diff
    _print_side(console, "-", "red", diff.assets_removed, diff.starts_removed, diff.conditions_removed)
    _print_side(console, "+", "green", diff.assets_added, diff.starts_added, diff.conditions_added)
    for change in diff.assets_changed:
        fields = ", ".join(f"{name} {_plain(a)} → {_plain(b)}" for name, (a, b) in change.fields.items())
        console.print(Text(f"  ~ {change.before} → {change.after}: {fields}", "yellow"))
    goals, positions = proof.goals, proof.positions
    figures = f"{goals.states} states: {goals.both} both, {goals.only_old} old only, {goals.only_new} new only"
    figures += f"; {goals.edge} of these at the edge of tolerances" if goals.edge else ""
    console.print(Text.assemble(("  goals: ", "bold"), f"{RELATIONS[goals.relation]} ", (f"({figures})", "dim")))
    if positions.blocks:
        told = f"the same for {positions.identical} of {positions.seeds} seeds"
        moved = f"; moved: {', '.join(positions.moved)}" if positions.moved else ""
        console.print(Text.assemble(("  starts of blocks that keep their size: ", "bold"), told + moved))
    axes = ", ".join(f"{axis} ({AXES[axis]})" for axis in proof.axes)
    console.print(Text.assemble(("  changed: ", "bold"), axes or "nothing"))
    console.print()


def _print_side(
    console: Console, sign: str, style: str, assets: Iterable[str], starts: Iterable[str], conditions: Iterable[str]
) -> None:
    """What only one of the versions has."""
    for line in (*(f"object {name}" for name in assets), *(f"start: {text}" for text in starts), *conditions):
        console.print(Text(f"  {sign} {line}", style))


def _plain(value: object) -> str:
    return "none" if value is None else str(value)


def print_witnesses(console: Console, witnesses: Iterable[Witness], pictures: dict[str, Path]) -> None:
    """For each goal a state that it alone accepts: what the other one misses in it, and where its picture is."""
    for witness in sorted(witnesses, key=lambda each: each.accepted_by, reverse=True):
        other = "new" if witness.accepted_by == "old" else "old"
        fails = f"; there the {other} one misses: {', '.join(witness.fails)}" if witness.fails else ""
        console.print(Text(f"  a state that only the {witness.accepted_by} goal accepts{fails}"))
        if witness.accepted_by in pictures:
            console.print(Text(f"    {pictures[witness.accepted_by]}", "dim"), soft_wrap=True)
