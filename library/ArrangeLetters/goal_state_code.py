"""A goal state of the task arrange-letters."""

from .code import ArrangeLetters


class ArrangeLettersGoal(ArrangeLetters):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("A_block", (0.5818, 0.0079, 0.97))
        self.place("B_block", (0.5818, -0.0421, 0.97))
        self.place("C_block", (0.5818, -0.0921, 0.97))
        self.place("D_block", (0.5818, -0.1421, 0.97))
        self.place("E_block", (0.5818, -0.1921, 0.97))
