"""Frames and sizes of the block domain, in metres and radians.

World frame: x away from the robot, y to the robot's left, z up. Quaternions are (w, x, y, z).
"""

from __future__ import annotations

TABLE_Z = 0.95
"""Height of the table top."""
WORKSPACE_X = (0.40, 0.70)
WORKSPACE_Y = (-0.25, 0.25)
"""Where the centres of movable blocks start, and where they are in every goal state."""

CONTROL_HZ = 20
TIMESTEP = 0.005
SUBSTEPS = round(1 / (CONTROL_HZ * TIMESTEP))
"""Physics steps per control step."""

REST_SPEED = 0.05
"""A block slower than this (m/s) is at rest."""
SUPPORT_GAP = 0.01
"""A block whose bottom is within this of what is under it rests on it."""

HAND = 0.08
"""The widest block that the arm's hand can reach around, and so the widest that can be lifted."""

TABLE_X = 0.55
TABLE_SIZE = (0.84, 1.30, 0.04)
"""The table's centre along x, and its extents."""
PATCH_THICKNESS = 0.001
"""Height of a patch's drawn slab, half of it above the table."""
