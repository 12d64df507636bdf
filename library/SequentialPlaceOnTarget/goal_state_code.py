"""A goal state of the task sequential-place-on-target."""

from .code import SequentialPlaceOnTarget


class SequentialPlaceOnTargetGoal(SequentialPlaceOnTarget):
    """The start, the way through the stages, and every block in a goal configuration."""

    def _on_reset(self) -> None:
        self.place("blue_block", (0.664731, -0.147861, 0.97), yaw=-1.955817)
        self.place("red_block", (0.528155, 0.23892, 0.97), yaw=-1.2038)
        self.waypoint()
        self.place("blue_block", (0.55, 0.1, 0.97))
        self.place("red_block", (0.6306, -0.2183, 0.97))
        self.waypoint()
        self.place("blue_block", (0.55, 0.1, 0.97))
        self.place("red_block", (0.55, -0.1, 0.97))
