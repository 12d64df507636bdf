"""Pass 2: from a task schema to code that a person enjoys reading."""

from rpg.passes.codegen.goal_state import lower_goal, read_goal
from rpg.passes.codegen.lower import lower
from rpg.passes.codegen.naming import class_name

__all__ = ["class_name", "lower", "lower_goal", "read_goal"]
