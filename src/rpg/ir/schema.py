"""TaskSchema: everything a task is, disambiguated, before anything runs. Its YAML form is task.yaml."""

from __future__ import annotations

import re
from typing import Literal

from pydantic import Field, model_validator

from rpg.ir.assets import Asset, Block, GoalPatch
from rpg.ir.base import Names, Record
from rpg.ir.goal import Goal
from rpg.ir.walk import names
from rpg.ir.wellformed import problems

FORMAT: Literal[1] = 1
MAX_NAME = 60
NAME = r"^[a-z0-9]+(-[a-z0-9]+)*$"
"""What the name of a task looks like: lower-case words and numbers joined by hyphens."""
MAX_BLOCKS = 30
MAX_LETTERS = 26
MAX_DIGITS = 10
COLORS_UNSAID = "the colours of the blocks are not said"
COLORS_BARRED = "blocks are said to have none of these colours"
SYMBOLS_UNSAID = "the symbols are not said"
"""How assumptions begin that chose the looks of blocks."""
REPLACED = "a block that is replaced goes anywhere else"
"""How the place of a block is told that gives its own to another."""
NONE_BESIDES = "there is no other block that could be there"
"""What it comes to that a block is alone where it is, in a task that has no other."""
EXCHANGED = "the two are exchanged when what is told of the start is so the other way round"
EXCHANGED_LATER = "the two are exchanged when what is built first is so with each in the place of the other"


def slug(text: str) -> str:
    """`text` as a family's name: lower-case words and numbers joined by hyphens; empty where it has none."""
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", text).lower()
    return shortened(re.sub(r"[^a-z0-9]+", "-", words).strip("-"), MAX_NAME, "-")


def shortened(name: str, longest: int, joint: str) -> str:
    """`name` cut to at most `longest` characters, between two of the words that `joint` joins where there is one."""
    if len(name) <= longest:
        return name
    whole, _, _ = name[: longest + 1].rpartition(joint)
    return (whole or name[:longest]).rstrip(joint)


class Start(Record):
    """A block that starts at a pose: centre (x, y) in metres, yaw in radians, uniform jitter in metres around it."""

    block: str
    position: tuple[float, float]
    yaw: float = 0.0
    jitter: float = Field(0.0, ge=0.0)


class Vacancy(Record):
    """The place of a removed block: drawn like a block's, before the asset `before` (None: last), and left empty.

    It keeps the starts of the other blocks where they were. `size` is the removed block's edge in metres.
    """

    origin: str
    size: float
    before: str | None = None


class InitialState(Record):
    """The distribution rho_0 that a seed samples.

    `arranged`: goals that hold at the start (stacked, in a region, already a structure). `heaps`: blocks that start in
    a settled heap. `poses`: blocks at given places. Every other block is scattered flat on the table. `vacant`: places
    that are kept free.
    """

    arranged: tuple[Goal, ...] = ()
    heaps: tuple[Names, ...] = ()
    poses: tuple[Start, ...] = ()
    vacant: tuple[Vacancy, ...] = ()


class TaskSchema(Record):
    """A task: assets A, initial-state distribution rho_0, success predicate G, instruction l and paraphrases V."""

    format: Literal[1] = FORMAT
    name: str = Field(pattern=NAME, max_length=MAX_NAME)
    instruction: str
    author: str | None = None
    seed: int = Field(0, ge=0)
    assets: tuple[Asset, ...] = Field(min_length=1)
    init: InitialState = InitialState()
    goal: Goal
    assumptions: tuple[str, ...] = ()
    paraphrases: tuple[str, ...] = ()

    @property
    def blocks(self) -> tuple[Block, ...]:
        return tuple(a for a in self.assets if not isinstance(a, GoalPatch))

    @property
    def patches(self) -> tuple[GoalPatch, ...]:
        return tuple(a for a in self.assets if isinstance(a, GoalPatch))

    @model_validator(mode="after")
    def _names_exist(self) -> TaskSchema:
        known = [asset.name for asset in self.assets]
        doubled = sorted({name for name in known if known.count(name) > 1})
        if doubled:
            raise ValueError(f"two assets are called {doubled[0]!r}; every asset needs a name of its own")
        mentioned = set(names(self.goal))
        for goal in self.init.arranged:
            mentioned.update(names(goal))
        mentioned.update(name for heap in self.init.heaps for name in heap)
        mentioned.update(start.block for start in self.init.poses)
        unknown = sorted(mentioned - set(known))
        if unknown:
            raise ValueError(f"the task mentions {unknown[0]!r}, but its assets are {', '.join(known)}")
        patches = [patch.name for patch in self.patches]
        for goal in (self.goal, *self.init.arranged):
            for problem in problems(goal, patches):
                raise ValueError(problem)
        return self

    def assumed(self, what: str) -> bool:
        """Was an assumption made that begins so?"""
        return any(told.startswith(what) for told in self.assumptions)
