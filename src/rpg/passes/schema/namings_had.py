"""Look-alikes with so many different duties that a task cannot be judged: the text may be told otherwise."""

from __future__ import annotations

from collections import Counter
from math import factorial

from rpg.blocks.namings import all_namings
from rpg.blocks.state import World, look_of
from rpg.blocks.symmetry import MAX_NAMINGS, interchangeable, link
from rpg.ir.schema import TaskSchema


def check_namings(task: TaskSchema) -> None:
    """Refuse a task with more ways to deal look-alikes to its duties than can be judged."""
    many = max(Counter(map(look_of, task.blocks)).values(), default=0)
    if factorial(many) > MAX_NAMINGS:
        world = World(task.assets)
        all_namings(interchangeable(link(task.goal, world), world))
