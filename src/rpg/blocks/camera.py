"""The one fixed camera of all tasks: on the robot's side, looking along +x and down. It is the viewer.

Relation words are the viewer's: left +y, right -y, in front of = nearer = -x, behind = farther = +x.
"""

from __future__ import annotations

import math

from rpg.blocks.state import Vec3

NAME = "viewer"
POSITION: Vec3 = (-0.18, 0.0, 1.64)
TARGET: Vec3 = (0.555, 0.0, 1.02)
FOVY = 33.0
"""Vertical field of view in degrees."""
WIDTH, HEIGHT = 640, 480


def axes() -> tuple[Vec3, Vec3, Vec3]:
    """Right, up and forward of the camera in the world, unit length."""
    dx, dz = TARGET[0] - POSITION[0], TARGET[2] - POSITION[2]
    length = math.hypot(dx, dz)
    forward = (dx / length, 0.0, dz / length)
    return (0.0, -1.0, 0.0), (-forward[2], 0.0, forward[0]), forward
