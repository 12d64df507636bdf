"""A goal state of the task stack-blocks-on-target."""

from .code import StackBlocksOnTarget


class StackBlocksOnTargetGoal(StackBlocksOnTarget):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("red_block", (0.55, 0.0, 0.97))
        self.place("blue_block", (0.55, 0.0, 1.01))
        self.place("green_block", (0.55, 0.0, 1.05))
