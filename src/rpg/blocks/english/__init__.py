"""Tasks and goals read back as English."""

from rpg.ir.schema import TaskSchema


def describe(schema: TaskSchema) -> str:
    """The goal of a task in words."""
    return schema.instruction.strip().rstrip(".") + "."
