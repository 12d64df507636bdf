"""The one fixed camera of all tasks: on the robot's side, looking along +x and down. It is the viewer.

Relation words are the viewer's: left +y, right -y, in front of = nearer = -x, behind = farther = +x.
"""

from __future__ import annotations

import math

from rpg.blocks.state import Quat, Vec3

NAME = "viewer"
POSITION: Vec3 = (-0.18, 0.0, 1.64)
TARGET: Vec3 = (0.55, 0.0, 0.955)
FOVY = 27.0
"""Vertical field of view in degrees: the workspace from side to side, and a tower of five at its far edge."""
WIDTH, HEIGHT = 640, 480


ELEVATION = math.degrees(math.atan2(TARGET[2] - POSITION[2], TARGET[0] - POSITION[0]))
"""Angle in degrees over the horizon in which the camera looks; negative is down."""


def orientation(elevation: float = ELEVATION) -> Quat:
    """The camera's quaternion when it looks along +x at an angle of `elevation` degrees over the horizon.

    A camera looks along its own -z with its +y up: turned upright and towards +x, then raised.
    """
    half = math.radians(elevation) / 2
    c, s = math.cos(half) / 2, math.sin(half) / 2
    return (c - s, c + s, -c - s, s - c)
