"""The composition root: text -> schema -> code -> validated program, with repair where a gate fails.

Pure: nothing is written to disk. The store writes what an `Outcome` holds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Literal, Protocol

from rpg.blocks.english import describe
from rpg.blocks.patches import place_patches
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import link
from rpg.blocks.waypoints import waypoints
from rpg.core.diagnostics import Diagnostic, Refusal, UsageError
from rpg.core.passes import Listener, silent
from rpg.ir.artifact import GateReport, Program, Scene
from rpg.ir.goal import Goal
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen import lower, lower_goal, read_goal
from rpg.passes.repair import Attempt, Tools, repair
from rpg.passes.repair.placing import scene_of
from rpg.passes.validate import Measures, admitted, render_log, validate

Status = Literal["admitted", "refused", "failed"]
FILES = ("task.yaml", "code.py", "goal_state_code.py", "validation.log")


class FrontEnd(Protocol):
    """Reads an instruction: a schema, or nothing and the reasons."""

    def read(
        self, text: str, *, name: str | None, seed: int, author: str | None
    ) -> tuple[TaskSchema | None, tuple[Diagnostic, ...]]: ...


@dataclass(frozen=True)
class CompileOptions:
    """What a compile may be told. `front_end` is the built-in one unless given; `listen` hears of progress."""

    name: str | None = None
    seed: int = 0
    author: str | None = None
    pictures: bool = False
    measures: Measures = field(default_factory=Measures)
    front_end: FrontEnd | None = None
    listen: Listener = silent


@dataclass(frozen=True)
class Outcome:
    """The result of a compile.

    "admitted": every gate is passed. "refused": the instruction cannot become a task; the diagnostics say why.
    "failed": it became a program that could not be brought through the gates.
    """

    status: Status
    instruction: str
    program: Program | None = None
    gates: tuple[GateReport, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()
    attempts: tuple[Attempt, ...] = ()
    goal_text: str = ""
    log: str = ""
    pictures: dict[str, bytes] = field(default_factory=dict)

    @property
    def schema(self) -> TaskSchema | None:
        """The task as it was understood."""
        return self.program.task if self.program else None

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What the instruction left open and a default decided."""
        return self.program.task.assumptions if self.program else ()

    @property
    def mutation_score(self) -> float | None:
        """The share of near-misses that the goal tells from the goal state; None where that gate was not reached."""
        return next((gate.figures.get("score") for gate in self.gates if gate.name == "mutation"), None)


def compile_instruction(text: str, options: CompileOptions | None = None) -> Outcome:
    """All four passes over an instruction."""
    options = options or CompileOptions()
    options.listen("schema", "read")
    reader = options.front_end or _builtin()
    schema, diagnostics = reader.read(text, name=options.name, seed=options.seed, author=options.author)
    if schema is None:
        return Outcome("refused", text, diagnostics=diagnostics)
    return compile_schema(schema, options, notes=diagnostics)


def compile_schema(
    schema: TaskSchema, options: CompileOptions | None = None, notes: tuple[Diagnostic, ...] = ()
) -> Outcome:
    """The passes from a schema on. `notes` are diagnostics of the schema itself."""
    options = options or CompileOptions()
    options.listen("schema", "arrange")
    try:
        task = prepared(schema)
        path = goal_path(task, Random(f"goal {task.seed}"))
    except Refusal as refusal:
        return Outcome("refused", schema.instruction, diagnostics=(*notes, *refusal.diagnostics))
    options.listen("codegen", "lower")
    program = Program(task=task, path=path, code=lower(task), goal_code=lower_goal(task, path))
    return _validated(program, options, notes)


def prepared(schema: TaskSchema) -> TaskSchema:
    """The schema with what the compiler decides: where patches lie, how orders name look-alikes.

    Raises Refusal where the patches find no place.
    """
    placed = place_patches(schema)
    goal = link(placed.goal, World(placed.assets))
    return placed if goal is placed.goal else placed.model_copy(update={"goal": goal})


def goal_path(task: TaskSchema, rng: Random) -> tuple[Scene, ...]:
    """Scenes to a goal state of a prepared schema. Raises Refusal where there is none."""
    scenes = waypoints(task.goal, task.init, World(task.assets), rng)
    return tuple(scene_of(scene) for scene in scenes)


def load_program(directory: Path, task: TaskSchema) -> Program:
    """The program in a version's directory; its schema is given, as the store reads it."""
    try:
        code, goal_code = (
            (directory / name).read_bytes().decode("utf-8") for name in ("code.py", "goal_state_code.py")
        )
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"{directory} holds no readable task: {error}") from error
    return Program(task=task, path=read_goal(goal_code) or (), code=code, goal_code=goal_code)


def is_lowered(program: Program) -> bool:
    """Is the code, byte for byte, what the schema and the goal scenes lower to?"""
    if not program.path or program.code != lower(program.task):
        return False
    return program.goal_code == lower_goal(program.task, program.path)


def validate_program(
    program: Program, measures: Measures | None = None, listen: Listener = silent
) -> tuple[GateReport, ...]:
    """The gates over a program; code that is not our own lowering is confined."""
    return validate(program, trusted=is_lowered(program), measures=measures, listen=listen)


def repair_program(program: Program, asked: Goal | None = None, options: CompileOptions | None = None) -> Outcome:
    """Validate a program and repair it where it fails; `asked` is what no repair may lose (the schema's goal)."""
    return _validated(program, options or CompileOptions(), (), asked)


def _validated(
    program: Program, options: CompileOptions, notes: tuple[Diagnostic, ...], asked: Goal | None = None
) -> Outcome:
    reports = validate_program(program, options.measures, options.listen)
    attempts: tuple[Attempt, ...] = ()
    if not admitted(reports):
        tools = Tools(lower, lower_goal, read_goal, goal_path, _validator(options))
        mended = repair(program, reports, asked or program.task.goal, tools, options.listen)
        program, reports, attempts = mended.program, mended.reports, mended.attempts
        notes = (*notes, *mended.diagnostics)
    found = tuple(diagnostic for report in reports for diagnostic in report.diagnostics)
    return Outcome(
        status="admitted" if admitted(reports) else "failed",
        instruction=program.task.instruction,
        program=program,
        gates=reports,
        diagnostics=(*notes, *found),
        attempts=attempts,
        goal_text=describe(program.task),
        log=render_log(program, reports),
        pictures=_pictures(program, options) if options.pictures and admitted(reports) else {},
    )


def _validator(options: CompileOptions) -> Callable[[Program], tuple[GateReport, ...]]:
    return lambda program: validate_program(program, options.measures, options.listen)


def _builtin() -> FrontEnd:
    from rpg.passes.schema.frontend import BuiltinFrontEnd

    return BuiltinFrontEnd()


def _pictures(program: Program, options: CompileOptions) -> dict[str, bytes]:
    """initial.png and goal.png. Pictures come last: a task is admitted without them."""
    from rpg.blocks.picture import draw

    options.listen("pictures", "draw")
    world = World(program.task.assets)
    return {"initial.png": draw(_start(program, world)), "goal.png": draw(_goal(program, world))}


def _start(program: Program, world: World) -> BlockState:
    from rpg.passes.validate.load import load

    return load(program.code, program.goal_code)[0]().reset(program.task.seed)


def _goal(program: Program, world: World) -> BlockState:
    from rpg.passes.repair.placing import state_of

    return state_of(program.path[-1], world)
