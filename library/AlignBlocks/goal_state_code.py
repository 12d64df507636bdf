"""A goal state of the task align-blocks."""

from .code import AlignBlocks


class AlignBlocksGoal(AlignBlocks):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("red_block", (0.6075, -0.0265, 0.97))
        self.place("blue_block", (0.6075, -0.0765, 0.97))
        self.place("green_block", (0.6075, -0.1265, 0.97))
        self.place("yellow_block", (0.6075, -0.1765, 0.97))
        self.place("purple_block", (0.6075, -0.2265, 0.97))
