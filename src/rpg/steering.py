"""Steering end to end: a request about a task on disk -> a validated version with its proof, beside its reference."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from rpg.core.diagnostics import Diagnostic, Refusal, UsageError
from rpg.core.digest import sha256
from rpg.ir.edits import Edit, Overwrite
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen import lower
from rpg.passes.validate import read_log
from rpg.pipeline import CompileOptions, Outcome, compile_schema, load_program, phrased, prepared
from rpg.publishing import content_of, publish_version, summary
from rpg.steer.history import History, Past
from rpg.steer.interpret import Interpretation, interpret
from rpg.steer.proof.classify import Verdict, classify
from rpg.steer.proof.compare import Witness
from rpg.steer.proof.proof import Proof, prove
from rpg.store import Family, SteeringMeta, Version, Written, set_head, verify_lineage


@dataclass(frozen=True)
class Steered:
    """What became of a request.

    `outcome` is that of the compile of the result; where the request only went back to a version (`reverted`), what was
    found when that one was compiled. `same_as`: the number of an earlier version with the very same code, whose
    validation was reused.
    """

    request: str
    status: str
    outcome: Outcome | None = None
    place: Written | Path | None = None
    interpretation: Interpretation | None = None
    verdict: Verdict | None = None
    proof: Proof | None = None
    witnesses: tuple[Witness, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()
    same_as: int | None = None

    @property
    def version(self) -> Version | None:
        """The version that is current now, if the request was carried out."""
        return self.place.version if isinstance(self.place, Written) else None

    @property
    def reverted(self) -> bool:
        """Whether the request only went back to a version."""
        return self.status == "admitted" and self.interpretation is not None and self.interpretation.reverts


def steer(version: Version, request: str, options: CompileOptions | None = None) -> Steered:
    """Carry out `request` on `version`, as if that were the current one. A refused request changes nothing."""
    options, request = options or CompileOptions(), request.replace("\r", " ")
    versions = Family(version.directory.parent).versions()
    _require_sound(version)
    options.listen("steer", "read")
    try:
        understood = interpret(request, history_of(versions, version), reader(options))
    except Refusal as refusal:
        return Steered(request, "refused", diagnostics=refusal.diagnostics)
    if understood.reverts:
        return _gone_back(next(v for v in versions if v.number == understood.reference), understood)
    return _built(versions, version, understood, options)


def _gone_back(version: Version, understood: Interpretation) -> Steered:
    """Make a version the current one again. Against itself as the reference nothing has changed."""
    _require_sound(version)
    proof, _ = prove(version.schema, version.schema)
    set_head(version)
    return Steered(
        request=understood.request,
        status="admitted",
        outcome=_as_compiled(version),
        place=Written(version, existed=True),
        interpretation=understood,
        verdict=classify(version.schema, version.schema, proof, understood.intent),
        proof=proof,
    )


def _require_sound(version: Version) -> None:
    """Nothing is built upon files that are not those which were written, nor upon a lineage with a gap: the hash of the
    result would vouch for what is not there."""
    problems = verify_lineage(version)
    if problems:
        own = problems[0].facts["path"].split("/")[1] == version.directory.name
        mend = "" if own else f"put {problems[0].facts['path']} back as it was, or go on without its history: "
        hint = f"{mend}rpg compile --from {version.directory}/task.yaml makes a task of its own of what is there now"
        raise UsageError(f"{version} is not steered: {problems[0].message}; {hint}")


def reader(options: CompileOptions) -> Callable[[str], tuple[TaskSchema | None, tuple[Diagnostic, ...]]]:
    """The front end as a function of the text alone."""
    from rpg.passes.schema.frontend import BuiltinFrontEnd

    front_end = options.front_end or BuiltinFrontEnd()
    return lambda text: front_end.read(text, name=None, seed=options.seed, author=options.author)


def history_of(versions: Sequence[Version], current: Version) -> History:
    """The versions of a family as requests refer to them."""
    numbers = {version.hash: version.number for version in versions}
    past = []
    for version in versions:
        steering = version.snapshot.steering
        parent = numbers.get(steering.parent) if steering else None
        focus = tuple(steering.parameters.get("focus", ())) if steering else ()
        past.append(Past(version.number, version.schema, parent, focus))
    return History(tuple(past), current.number)


def _built(
    versions: Sequence[Version], current: Version, understood: Interpretation, options: CompileOptions
) -> Steered:
    """Compile, prove and classify the result; write it where it passes."""
    reference = current
    if understood.reference is not None:
        reference = next(v for v in versions if v.number == understood.reference)
        _require_sound(reference)
    outcome, twin = _compiled(versions, understood.task, options)
    if outcome.status == "refused" or outcome.program is None:
        return Steered(
            understood.request, "refused", outcome, interpretation=understood, diagnostics=outcome.diagnostics
        )
    options.listen("steer", "prove")
    try:
        proof, witnesses = prove(reference.schema, outcome.program.task)
    except Refusal as refusal:
        return Steered(
            understood.request, "refused", outcome, interpretation=understood, diagnostics=refusal.diagnostics
        )
    verdict = classify(reference.schema, outcome.program.task, proof, understood.intent)
    if verdict.category != "FRESH":
        understood = replace(understood, reference=reference.number)  # what keeps blocks of a version is made from it
    edits = recorded_edits(understood, outcome)
    steering = steering_of(understood, edits, verdict, proof, reference)
    return Steered(
        request=understood.request,
        status=outcome.status,
        outcome=outcome,
        place=publish_version(outcome, Family(current.directory.parent), content_of(outcome, steering)),
        interpretation=understood,
        verdict=verdict,
        proof=proof,
        witnesses=witnesses,
        diagnostics=outcome.diagnostics,
        same_as=twin,
    )


def _compiled(versions: Sequence[Version], schema: TaskSchema, options: CompileOptions) -> tuple[Outcome, int | None]:
    """Compile a schema, or take over the validation of a version of the family with the very same code."""
    schema = phrased(schema, options)
    try:
        task = prepared(schema)
    except Refusal as refusal:
        return Outcome("refused", schema.instruction, diagnostics=refusal.diagnostics), None
    for version in versions:
        if version.schema == task and version.snapshot.snapshot.code_hash == sha256(lower(task)):
            outcome = _as_compiled(version)
            return (outcome if options.pictures else replace(outcome, pictures={})), version.number
    return compile_schema(schema, options), None


def _as_compiled(version: Version) -> Outcome:
    """What the compile of a version came to, as its files have it."""
    return Outcome(
        status="admitted",
        instruction=version.schema.instruction,
        program=load_program(version.directory, version.schema),
        gates=read_log(version.log),
        goal_text=version.snapshot.snapshot.goal_summary,
        log=version.log,
        pictures=_pictures_of(version),
    )


def _pictures_of(version: Version) -> dict[str, bytes]:
    return {
        name: (version.directory / name).read_bytes()
        for name in ("initial.png", "goal.png")
        if (version.directory / name).is_file()
    }


def recorded_edits(understood: Interpretation, outcome: Outcome) -> tuple[Edit, ...]:
    """The edits that lead to what was compiled: those of the request, with the words that were found for the result. A
    task that had to be repaired is recorded whole."""
    task = outcome.program.task if outcome.program else understood.task
    if outcome.attempts:
        return (Overwrite(task=task),)
    *others, last = understood.edits
    found = {"paraphrases": task.paraphrases}
    if isinstance(last, Overwrite):
        return (*others, last.model_copy(update={"task": last.task.model_copy(update=found)}))
    return (*others, last.model_copy(update=found))


def steering_of(
    understood: Interpretation, edits: tuple[Edit, ...], verdict: Verdict, proof: Proof, reference: Version
) -> SteeringMeta:
    """What a version records about how it came about."""
    parameters: dict[str, Any] = {**understood.parameters, "focus": list(understood.focus)}
    if verdict.reason:
        parameters["reclassified"] = verdict.reason
    return SteeringMeta(
        request=" ".join(understood.request.split()),
        intent=verdict.category,
        parameters=parameters,
        reference=None if verdict.category == "FRESH" else reference.number,
        preserve_assets=verdict.preserve.assets,
        preserve_positions=verdict.preserve.positions,
        preserve_goals=verdict.preserve.goals,
        parent=reference.hash,
        edits=tuple(edit.model_dump(mode="json", exclude_defaults=False) for edit in edits),
        proof=proof.model_dump(mode="json"),
    )


def steered_summary(steered: Steered) -> dict[str, Any]:
    """A steer as one JSON document: a compile's, and what is known about the change."""
    outcome = steered.outcome or Outcome("refused", steered.request)
    document = summary(replace(outcome, diagnostics=steered.diagnostics), steered.place)
    document["status"] = steered.status
    verdict, proof, understood = steered.verdict, steered.proof, steered.interpretation
    document["category"] = verdict.category if verdict else None
    document["reference"] = (
        None if verdict and verdict.category == "FRESH" else understood.reference if understood else None
    )
    document["preserve"] = verdict.preserve.model_dump() if verdict else None
    document["proof"] = proof.model_dump(mode="json") if proof else None
    document["axes"] = list(proof.axes) if proof else []
    document["reason"] = verdict.reason or None if verdict else None
    document["parameters"] = understood.parameters if understood else {}
    document["reverted"] = steered.reverted
    document["same_as"] = steered.same_as
    return document


@dataclass(frozen=True)
class Compared:
    """Two versions side by side."""

    a: Version
    b: Version
    proof: Proof
    witnesses: tuple[Witness, ...]

    def document(self, pictures: dict[str, Path]) -> dict[str, Any]:
        """The comparison as one JSON document; `pictures`: which goal accepts the state -> where it is drawn."""
        return {
            "a": {"version": str(self.a), "hash": self.a.hash},
            "b": {"version": str(self.b), "hash": self.b.hash},
            **self.proof.model_dump(mode="json"),
            "witnesses": [witness_data(witness, pictures.get(witness.accepted_by)) for witness in self.witnesses],
        }


def compared(a: Version, b: Version) -> Compared:
    """Compare two versions, of one family or of two."""
    return Compared(a, b, *prove(a.schema, b.schema))


def witness_data(witness: Witness, picture: Path | None = None) -> dict[str, Any]:
    """A witness state as `rpg check` takes it."""
    state = witness.state
    objects = {
        name: {"position": list(state.position[name]), "orientation": list(state.orientation[name])}
        for name in state.position
    }
    return {
        "accepted_by": witness.accepted_by,
        "source": witness.source,
        "fails": list(witness.fails),
        "objects": objects,
        "picture": str(picture) if picture else None,
    }


def draw_witnesses(found: Compared, directory: Path) -> dict[str, Path]:
    """Draw every witness state into `directory`."""
    from rpg.blocks.picture import draw
    from rpg.store import replace_file

    directory.mkdir(parents=True, exist_ok=True)
    paths = {}
    for witness in found.witnesses:
        path = directory / f"accepted-by-{witness.accepted_by}.png"
        replace_file(path, draw(witness.state))
        paths[witness.accepted_by] = path
    return {str(side): path for side, path in paths.items()}
