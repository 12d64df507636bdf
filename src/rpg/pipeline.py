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
from rpg.blocks.namings import all_namings
from rpg.blocks.patches import place_patches
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import interchangeable, link
from rpg.blocks.waypoints import waypoints
from rpg.core.codes import ROOMS
from rpg.core.diagnostics import Diagnostic, UsageError
from rpg.core.passes import Context, Listener, Manager, Pass, Report, silent
from rpg.ir.artifact import GateReport, Program, Scene
from rpg.ir.goal import Goal
from rpg.ir.reconcile import reconcile, reconciled
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen import lower, lower_goal, read_goal
from rpg.passes.repair import Attempt, Repaired, Tools, repair
from rpg.passes.repair.placing import scene_of
from rpg.passes.validate import Measures, admitted, render_log, validate

Status = Literal["admitted", "refused", "failed"]
OF_PROGRAMS = frozenset(code.id for code in ROOMS["validate"])
"""Codes of what can be wrong with a program; all other ones are about what was asked for."""


class FrontEnd(Protocol):
    """Reads an instruction: a schema, or nothing and the reasons."""

    def read(
        self, text: str, *, name: str | None, seed: int, author: str | None
    ) -> tuple[TaskSchema | None, tuple[Diagnostic, ...]]: ...


@dataclass(frozen=True)
class CompileOptions:
    """What a compile may be told. `front_end` is the built-in one unless given; `listen` hears of progress.

    `paraphrases`: so many other wordings are looked for at most; reading each back costs as much as the instruction.
    """

    name: str | None = None
    seed: int = 0
    author: str | None = None
    pictures: bool = False
    measures: Measures = field(default_factory=Measures)
    front_end: FrontEnd | None = None
    listen: Listener = silent
    paraphrases: int = 2

    def __post_init__(self) -> None:
        if self.seed < 0:
            raise ValueError(f"a seed is a whole number from 0 on, not {self.seed}")


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
    options, text = options or CompileOptions(), text.replace("\r", " ")
    return _run(text, text, (SchemaPass(options), *_PASSES), options)


def compile_schema(schema: TaskSchema, options: CompileOptions | None = None) -> Outcome:
    """The passes from a schema on."""
    return _run(schema, schema.instruction, _PASSES, options or CompileOptions())


def repair_program(program: Program, asked: Goal | None = None, options: CompileOptions | None = None) -> Outcome:
    """Validate a program and repair it where it fails; `asked` is what no repair may lose (the schema's goal)."""
    return _run(program, program.task.instruction, (ValidatePass(asked),), options or CompileOptions())


def _run(item: object, instruction: str, passes: tuple[Pass, ...], options: CompileOptions) -> Outcome:
    run = Manager(passes, verify).run(item, Context(options.listen, options.measures))
    mended: Repaired | None = run.records[-1].report.found
    if run.item is None or mended is None:
        return Outcome("refused", instruction, diagnostics=run.diagnostics)
    program, reports = mended.program, mended.reports
    whole = admitted(reports)
    return Outcome(
        status="admitted" if whole else "refused" if _asked_for(reports) else "failed",
        instruction=instruction,
        program=program,
        gates=reports,
        diagnostics=run.diagnostics,
        attempts=mended.attempts,
        goal_text=describe(program.task),
        log=render_log(program, reports),
        pictures=_pictures(program, options) if options.pictures and whole else {},
    )


def _asked_for(reports: tuple[GateReport, ...]) -> bool:
    """Is what failed the task itself, however it is written? It may have no start from which its goal is ahead."""
    return all(diagnostic.code not in OF_PROGRAMS for diagnostic in reports[-1].failures)


@dataclass(frozen=True)
class SchemaPass:
    """Text to schema, by the front end that the options name."""

    options: CompileOptions
    name: str = "schema"

    def run(self, item: str, context: Context) -> tuple[TaskSchema | None, Report]:
        """The schema, or nothing and the reasons."""
        options = self.options
        reader = options.front_end or _builtin()
        schema, diagnostics = reader.read(item, name=options.name, seed=options.seed, author=options.author)
        if schema is None and options.front_end is None:
            from rpg.passes.schema.pinpoint import pinpointed

            diagnostics = tuple(
                pinpointed(item, one, lambda text: _read_plainly(text) is not None) for one in diagnostics
            )
        return (schema and phrased(schema, options)), Report(diagnostics)


@dataclass(frozen=True)
class FeasibilityPass:
    """Can the task be at all? The built-in front end asks that of each of its readings, a file of nobody."""

    name: str = "feasibility"

    def run(self, item: TaskSchema, context: Context) -> tuple[TaskSchema | None, Report]:
        """The task, adapted where that changes nothing asked for; or nothing, with what would make it possible."""
        from rpg.passes.schema.feasibility import Repairable, examine, suggestions

        try:
            found = examine(item)
        except Repairable as refusal:
            return None, Report(suggestions(refusal, _read_plainly))
        return found.task, Report(found.notes, found)


@dataclass(frozen=True)
class ArrangePass:
    """What the compiler decides where the instruction leaves it open: places of patches, and a goal state."""

    name: str = "arrange"

    def run(self, item: TaskSchema, context: Context) -> tuple[tuple[TaskSchema, tuple[Scene, ...]], Report]:
        """A schema with nothing open, and the scenes that lead to its goal."""
        task = prepared(item)
        return (task, goal_path(task, Random(f"goal {task.seed}"))), Report()


@dataclass(frozen=True)
class CodegenPass:
    """Schema and scenes to code."""

    name: str = "codegen"

    def run(self, item: tuple[TaskSchema, tuple[Scene, ...]], context: Context) -> tuple[Program, Report]:
        """The program, word for word its schema's lowering."""
        task, path = item
        return Program(task=task, path=path, code=lower(task), goal_code=lower_goal(task, path)), Report()


@dataclass(frozen=True)
class ValidatePass:
    """The gates, and repair where one fails.

    `asked`: what no repair may lose, the schema's goal unless given. `lowered`: the program comes from the lowering.
    """

    asked: Goal | None = None
    lowered: bool = False
    name: str = "validate"

    def run(self, item: Program, context: Context) -> tuple[Program, Report]:
        """The best program that was found; the report holds its gates and the attempts at repair."""
        trusted = self.lowered or is_lowered(item)
        reports = validate(item, trusted=trusted, measures=context.options, listen=context.listen)
        mended = Repaired(item, reports)
        if not admitted(reports):
            tools = Tools(lower, lower_goal, read_goal, goal_path, _validator(context))
            mended = repair(item, reports, self.asked or item.task.goal, tools, context.listen)
        found = tuple(diagnostic for report in mended.reports for diagnostic in report.diagnostics)
        return mended.program, Report((*mended.diagnostics, *found), mended)


_PASSES: tuple[Pass, ...] = (FeasibilityPass(), ArrangePass(), CodegenPass(), ValidatePass(lowered=True))


def verify(name: str, item: object) -> None:
    """What crosses a boundary is whole: a schema's references hold, a program has a scene for every block."""
    if isinstance(item, TaskSchema):
        TaskSchema.model_validate(item.model_dump())
    elif isinstance(item, Program) and item.path:
        placed = [placement.block for placement in item.path[-1]]
        if sorted(placed) != sorted(block.name for block in item.task.blocks):
            raise AssertionError(f"the pass {name} left blocks out of the goal scene")


def prepared(schema: TaskSchema) -> TaskSchema:
    """The schema with what the compiler decides: where patches lie, how orders name look-alikes, which turns win.

    Raises Refusal where the patches find no place, or look-alikes have too many different duties.
    """
    placed = place_patches(schema)
    world = World(placed.assets)
    goal = reconcile(link(placed.goal, world))
    all_namings(interchangeable(goal, world))
    start = reconciled(placed.init.arranged)
    if goal is placed.goal and start == placed.init.arranged:
        return placed
    init = placed.init.model_copy(update={"arranged": start})
    return placed.model_copy(update={"goal": goal, "init": init})


def phrased(schema: TaskSchema, options: CompileOptions) -> TaskSchema:
    """The schema with paraphrases: wordings that the front end reads as the same task."""
    from rpg.passes.schema.paraphrase import paraphrases

    reader = options.front_end or _builtin()

    def read(text: str) -> TaskSchema | None:
        return reader.read(text, name=schema.name, seed=schema.seed, author=schema.author)[0]

    return schema.model_copy(update={"paraphrases": paraphrases(schema, read, options.paraphrases)})


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


def _validator(context: Context) -> Callable[[Program], tuple[GateReport, ...]]:
    return lambda program: validate_program(program, context.options, context.listen)


def _read_plainly(text: str) -> TaskSchema | None:
    return _builtin().read(text, name=None, seed=0, author=None)[0]


def _builtin() -> FrontEnd:
    from rpg.passes.schema.frontend import BuiltinFrontEnd

    return BuiltinFrontEnd()


def _pictures(program: Program, options: CompileOptions) -> dict[str, bytes]:
    """initial.png and goal.png. Pictures come last: a task is admitted without them."""
    from rpg.blocks.picture import draw

    options.listen("pictures", "draw")
    world = World(program.task.assets)
    start, goal = _start(program, world), _goal(program, world)
    return {"initial.png": draw(start, beside=(goal,)), "goal.png": draw(goal, beside=(start,))}


def _start(program: Program, world: World) -> BlockState:
    from rpg.passes.validate.load import load

    return load(program.code, program.goal_code)[0]().reset(program.task.seed)


def _goal(program: Program, world: World) -> BlockState:
    from rpg.passes.repair.placing import state_of

    return state_of(program.path[-1], world)
