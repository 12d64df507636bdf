"""A goal state of the task arrange-numbers."""

from .code import ArrangeNumbers


class ArrangeNumbersGoal(ArrangeNumbers):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("7_block", (0.6069, -0.0476, 0.97))
        self.place("2_block", (0.6069, 0.0524, 0.97))
        self.place("9_block", (0.6069, -0.0976, 0.97))
        self.place("4_block", (0.6069, 0.0024, 0.97))
