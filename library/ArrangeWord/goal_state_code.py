"""A goal state of the task arrange-word."""

from .code import ArrangeWord


class ArrangeWordGoal(ArrangeWord):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("R_block", (0.5149, 0.0126, 0.97))
        self.place("O_block_1", (0.5149, -0.0374, 0.97))
        self.place("B_block", (0.5149, -0.0874, 0.97))
        self.place("O_block_2", (0.5149, -0.1374, 0.97))
        self.place("T_block", (0.5149, -0.1874, 0.97))
