"""A goal state of the task arrange-equation."""

from .code import ArrangeEquation


class ArrangeEquationGoal(ArrangeEquation):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("2_block", (0.5149, 0.0126, 0.97))
        self.place("3_block", (0.5149, -0.0874, 0.97))
        self.place("5_block", (0.5149, -0.1874, 0.97))
        self.place("plus_block", (0.5149, -0.0374, 0.97))
        self.place("equals_block", (0.5149, -0.1374, 0.97))
