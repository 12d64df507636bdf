"""A goal state of the task rotate-cube."""

from .code import RotateCube


class RotateCubeGoal(RotateCube):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("R_block", (0.55, 0.0, 0.97), yaw=3.141593)
