"""A goal state of the task stack-blocks."""

from .code import StackBlocks


class StackBlocksGoal(StackBlocks):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("red_block_1", (0.55, 0.0, 1.01))
        self.place("red_block_2", (0.55, 0.0, 0.97))
