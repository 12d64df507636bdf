"""A goal state of the task arrange-shapes."""

from .code import ArrangeShapes


class ArrangeShapesGoal(ArrangeShapes):
    """Every block stands in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("red_block", (0.6183, 0.0205, 0.97))
        self.place("blue_block", (0.5947, -0.0363, 0.97), yaw=-0.785397)
        self.place("green_block", (0.5379, -0.0599, 0.97))
        self.place("yellow_block", (0.4811, -0.0363, 0.97), yaw=0.785397)
        self.place("purple_block", (0.4575, 0.0205, 0.97))
        self.place("orange_block", (0.4811, 0.0773, 0.97), yaw=-0.785397)
        self.place("cyan_block", (0.5379, 0.1009, 0.97))
        self.place("pink_block", (0.5947, 0.0773, 0.97), yaw=0.785397)
