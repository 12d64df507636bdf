"""BlockTask: the one class that tasks extend. It samples starts, runs the physics, and judges the goal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property, partial
from random import Random
from typing import cast

import mujoco
import numpy as np

from rpg.blocks.alike import Judge
from rpg.blocks.english import clause
from rpg.blocks.evaluate import settled
from rpg.blocks.judgement import Conditions, Judgement
from rpg.blocks.namings import all_namings
from rpg.blocks.physics import Physics, left
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import Cells
from rpg.blocks.verdict import FALSE, Verdict, as_verdict, between
from rpg.blocks.verdicts import Looked, Verdicts, counted
from rpg.blocks.waypoints import fixes, leaves_room
from rpg.env import told
from rpg.env.drawing import Drawing, drawn_start
from rpg.env.embodiment import ACTION_SIZE, Action, Embodiment, Robot
from rpg.env.models import model_for
from rpg.env.progress import Memory
from rpg.env.relations import Relations
from rpg.env.setup import Setup
from rpg.env.structures import Structures
from rpg.env.told import Asked
from rpg.ir import goal as g
from rpg.ir.node import Node
from rpg.ir.schema import InitialState

MANY = 6
"""So many namings of look-alikes are judged all at once, where the goal does not remember the episode."""
AT_REST = "every block is at rest, released and supported"
HOLD: Action = np.zeros(ACTION_SIZE)
NOTHING: frozenset[str] = frozenset()


class BlockTask(Relations, Structures, Setup):
    """A manipulation task: assets, a distribution of starts, and a goal that is judged after every control step.

    Subclasses give `instruction` and the hooks; `interchangeable` lists, for look-alike blocks that the goal tells
    apart, the cells of blocks that it uses alike. Steps are control steps of 1/20 s.
    """

    instruction: str = ""
    interchangeable: Cells = ()

    def __init__(self, embodiment: Embodiment | None = None, *, textures: bool = False) -> None:
        Relations.__init__(self)
        Setup.__init__(self)
        self._embodiment, self._textures = embodiment, textures
        self._initialize_env()
        self.world = World(self._assets)
        self._namings = all_namings(tuple(tuple(map(tuple, group)) for group in self.interchangeable))
        self._at_once = len(self._namings) >= MANY and type(self)._fail is BlockTask._fail
        self._memories: list[Memory] = []
        self._memory = Memory()
        self._state: BlockState | None = None
        self._judgement: Judgement | None = None
        self._solved: bool | None = None
        self._physics: Physics | None = None
        self._robot: Robot | None = None
        self._lender: BlockTask | None = None
        self._written: BlockState | None = None
        self._rest = FALSE
        self._unread = False
        self._looks_back: bool | None = None
        self._judge: Judge | None = None
        self._drawn: tuple[int, InitialState, BlockState] | None = None
        self._drawing: Drawing | None = None
        self._hooked = type(self)._on_step is not BlockTask._on_step
        self._names_of_conditions: dict[int, str] = {}
        self.seed = 0

    # Hooks

    def _initialize_env(self) -> None:
        """Add the task's blocks and patches."""
        raise NotImplementedError

    def _on_reset(self) -> None:
        """Say how an episode starts."""

    def _on_step(self) -> None:
        """Called after every control step."""

    def _success(self) -> Verdict:
        """Does the goal hold in the current state?"""
        raise NotImplementedError

    def _fail(self) -> Verdict:
        """Is the episode lost for good?"""
        return FALSE

    # Connectives and memory, for `_success` and `_fail`

    def at_rest(self) -> Verdict:
        """Every block is slower than 5 cm/s, released, and supported."""
        if self._asked is Asked.ONE_NAMING:
            return self._rest
        if self._asked is Asked.ALL_NAMINGS:
            return cast(Verdict, Verdicts.same(self._rest, len(self._namings)))
        return cast(Verdict, told.Told(g.All(goals=()), waits=True))

    def count(self, verdicts: Iterable[Verdict], *, at_least: int = 0, at_most: int | None = None) -> Verdict:
        """At least / at most so many of the verdicts hold."""
        if self._asked is Asked.ONE_NAMING:
            return between(at_least, at_most, verdicts)
        if self._asked is Asked.ALL_NAMINGS:
            return cast(Verdict, counted(at_least, at_most, verdicts, len(self._namings)))
        return cast(Verdict, told.counted(at_least, at_most, verdicts))

    def in_order(self, *stages: Verdict, undone: Sequence[int] = (), passed: Sequence[int] = ()) -> Verdict:
        """The stages were met one after the other; at the end all hold but those that a later one had to undo.

        `passed`: stages that are met on the way to the one in front of them, which is no fault."""
        if self._asked is Asked.TOLD:
            return cast(Verdict, told.in_order(stages, undone))
        return self._remembered().in_order(stages, undone, passed)

    def always(self, condition: Verdict) -> Verdict:
        """The condition holds now and held at every step before."""
        if self._asked is Asked.TOLD:
            return cast(Verdict, told.always(condition))
        return self._remembered().always(condition)

    def out_of_order(self) -> Verdict:
        """A stage was met before the one in front of it."""
        return self._remembered().out_of_order()

    def lapsed(self) -> Verdict:
        """A condition that must always hold did not at some step."""
        return self._remembered().lapsed()

    # Running a task

    def reset(self, seed: int = 0) -> BlockState:
        """Begin the episode of `seed`: a start where the goal is still ahead, the same to the bit for the same seed."""
        self.seed = seed
        self._forget()
        self._on_reset()
        scenes = self._placed_states()
        if scenes:
            self._begin(scenes[0])
            for scene in scenes[1:]:
                self._observe(scene.since(scenes[0]))
        else:
            self._draw(seed)
        return self.state()

    def step(self, control_steps: int = 1, action: Action = HOLD) -> None:
        """Advance; without an action the robot holds still. The goal is judged after every control step."""
        physics = self.physics
        if self._nobody_looks():
            physics.step(control_steps)
            self._unread = True
            return
        robot, data = self._robot, physics.data
        for _ in range(control_steps):
            if robot is not None:
                robot.command(data, action)
            physics.step()
            self._look(physics, robot.held(data) if robot is not None else NOTHING)
            if self._hooked:
                self._on_step()
                self._judgement = None

    def state(self) -> BlockState:
        """Where every block is now."""
        if self._state is None:
            raise RuntimeError("the task has no state yet: call reset() first")
        if self._unread:
            self._unread = False
            self._look(self.physics, NOTHING)
        return self._state

    def judge(self) -> Judgement:
        """Success, failure, stage and conditions in the current state."""
        if self._judgement is None or self._unread:
            state = self.state()
            if self._judgement is None:
                self._judgement = self._judged(state)
        return self._judgement

    def solved(self) -> bool:
        """Does the goal hold in the current state?"""
        if self._judge is None:
            return self.judge().success.value
        state = self.state()
        if self._solved is None:
            self._solved = self._judge.any_name(state)
        return self._solved

    def judge_states(self, states: Iterable[BlockState], start: BlockState | None = None) -> list[Judgement]:
        """Judge an episode that is given by its states, without physics; it began with `start`, else the first one."""
        found: list[Judgement] = []
        for state in states:
            if start is None:
                start = state
                self._begin(start)
            else:
                if not found:
                    self._begin(start)
                self._observe(state.since(start))
            found.append(self.judge())
        self._state = self._judgement = None
        return found

    @property
    def physics(self) -> Physics:
        """The simulation, with the blocks where the episode has them."""
        if self._physics is None:
            model = model_for(tuple(self.world.assets.values()), self._embodiment, self._textures)
            lent = self._lender.physics if self._lender is not None else None
            self._physics = Physics(self.world, model, lent.data if lent and lent.model is model else left(model))
            if self._embodiment is not None:
                self._robot = self._embodiment.bind(model, tuple(self.world.blocks))
        if self._written is not None:
            self._physics.write(self._written)
            if self._robot is not None:
                self._robot.reset(self._physics.data)
            self._written = None
        return self._physics

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model of the scene."""
        return self.physics.model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's state of the scene."""
        return self.physics.data

    @property
    def robot(self) -> Robot | None:
        """The robot, where the task was made with one."""
        return self._robot if self.physics else None

    # Inside

    def _draw(self, seed: int) -> None:
        """Draw starts until the goal is ahead: not satisfied, not lost, and no stage met, if possible no later one; and
        until what must stay where it is leaves room for it."""
        init = self._initial_state()
        if self._drawn is None or self._drawn[:2] != (seed, init):
            self._drawn = seed, init, drawn_start(self, seed, init)
        else:
            self._begin(self._drawn[2])

    def _plainly(self) -> Physics | None:
        """The simulation, where it has nothing but the blocks in it; the episode has no start yet."""
        self._written = None
        return self.physics if self._embodiment is None and not self._textures else None

    def _begin(self, start: BlockState) -> None:
        """An episode begins with `start`."""
        start = start.since(None)
        self._memories = [Memory()] if self._at_once else [Memory() for _ in range(len(self._namings))]
        self._written = start
        self._observe(start.since(start))

    def _observe(self, state: BlockState) -> None:
        """The episode is now in `state`."""
        if self._written is not None:
            self._written = state
        self._state, self._judgement, self._solved, self._unread = state, None, None, False
        if self._looks_back is not False:
            self.judge()
            self._looks_back = self._memories[0].used

    def _look(self, physics: Physics, held: frozenset[str]) -> None:
        """Read the state from the physics, unless it is still what it was."""
        before = self._state
        if before is None or before.moving or held != before.held or not physics.unchanged():
            self._observe(physics.read(before.start if before is not None else None, held))

    def _nobody_looks(self) -> bool:
        """May steps pass without a look at each of them? The state is then read when somebody asks for it."""
        return self._robot is None and not self._hooked and self._state is not None and not self._looks_back

    def _judged(self, state: BlockState) -> Judgement:
        """The judgement under the naming of look-alikes that comes closest to success."""
        at_rest = self._rest = settled(state)
        self._look_at(state)
        judged = self._judged_at_once(at_rest) if self._at_once else None
        if judged is not None:
            return judged
        best: tuple[tuple[bool, bool, int, float], Verdict, list[tuple[Node, Verdict]]] | None = None
        lost = True
        for number, memory in enumerate(self._memories):
            self._begin_naming(number)
            self._memory = memory
            memory.begin(at_rest.value)
            success = as_verdict(self._success())
            failed = as_verdict(self._fail()).value
            lost = lost and failed
            rank = (success.value, not failed, memory.stage, success.margin)
            if best is None or rank > best[0]:
                best = rank, success, self._noted
        self._begin_naming(0)
        assert best is not None
        (_, _, stage, _), success, noted = best
        return Judgement(success, lost, stage, partial(self._conditions, noted, at_rest))

    def _judged_at_once(self, at_rest: Verdict) -> Judgement | None:
        """The same, all namings at once; None where the goal remembers the episode, or its code looks at verdicts."""
        self._closely = self._passed_over = False
        success, noted = self._answer(Asked.ALL_NAMINGS)
        if isinstance(success, Verdicts) and self._passed_over and not success.any():
            self._closely = True
            success, noted = self._answer(Asked.ALL_NAMINGS)
        if not isinstance(success, Verdicts):
            self._at_once = False
            self._memories = [Memory() for _ in range(len(self._namings))]
            return None
        best = success.best()
        return Judgement(success.of(best), False, 0, partial(self._conditions, noted, at_rest, best))

    def _answer(self, asked: Asked) -> tuple[object, list[tuple[Node, Verdict]]]:
        """What the code makes of being asked in another way than under one naming, and the atoms that it asked for."""
        self._begin_naming(0, asked)
        try:
            answer: object = self._success()
        except Exception:  # it looks at verdicts; or what is wrong with it shows when it judges one naming by itself
            answer = None
        noted = self._noted
        self._begin_naming(0)
        return answer, noted

    def _past(self) -> bool:
        """Is the goal met, or a stage of it, or is the episode lost?"""
        return self.solved() or (self._judge is None and (self.judge().failed or self.judge().stage > 0))

    def _leaves_room(self, start: BlockState, draw: str) -> bool:
        """Can the goal be reached from `start`, though it fixes where some blocks are at the end?"""
        return not self._fixes or self._told is None or leaves_room(self._told.goal, self.world, start, Random(draw))

    @cached_property
    def _told(self) -> told.Told | None:
        """The goal as the code tells it; None where it does not."""
        answer, _ = self._answer(Asked.TOLD)
        return answer if isinstance(answer, told.Told) else None

    @cached_property
    def _fixes(self) -> bool:
        """Does the goal fix where some blocks are at the end by where they start?"""
        return self._told is not None and fixes(self._told.goal)

    def _remembered(self) -> Memory:
        """What is remembered of the episode under the naming at hand: to each its own."""
        if self._asked is not Asked.ONE_NAMING:
            raise Looked
        return self._memory

    def _conditions(self, noted: list[tuple[Node, Verdict]], at_rest: Verdict, naming: int = 0) -> Conditions:
        """`noted` in words; `naming`: the one that counts, where they are noted for all namings."""
        found = {self._condition(n): v.of(naming) if isinstance(v, Verdicts) else v for n, v in noted}
        return (*found.items(), (AT_REST, at_rest))

    def _condition(self, node: Node) -> str:
        """The condition in words."""
        name = self._names_of_conditions.get(id(node))
        if name is None:
            name = self._names_of_conditions[id(node)] = clause(node, self.world)  # type: ignore[arg-type]
        return name
