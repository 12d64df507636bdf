"""Importing MuJoCo without a window system behind it."""

from __future__ import annotations

import os


def load_mujoco() -> None:
    """Import MuJoCo with no OpenGL, which is sooner done by half and starts no helper process.

    MUJOCO_GL may also name a back end that is missing here: only drawing needs one, and finds it by itself.
    """
    wanted = os.environ.get("MUJOCO_GL")
    os.environ["MUJOCO_GL"] = "disable"
    try:
        import mujoco  # noqa: F401
    finally:
        del os.environ["MUJOCO_GL"]
        if wanted is not None:
            os.environ["MUJOCO_GL"] = wanted
