"""Drawing with OpenGL, off-screen, where the machine can: EGL or OSMesa on Linux, the system's own elsewhere."""

from __future__ import annotations

import atexit
import ctypes
import importlib
import os
import sys
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

LIBRARIES = {"egl": "libEGL.so.1", "osmesa": "libOSMesa.so.8"}
"""The shared library that each back end of a headless Linux machine needs."""
LARGEST = 2048
"""Side of the off-screen buffer that contexts are made with, at most (pixels)."""


def backend() -> str | None:
    """The OpenGL back end that works in this process, or None. MUJOCO_GL chooses one, or none with "disable"."""
    found = _context()
    return found[0] if found else None


def _context() -> tuple[str, Any] | None:
    """This process's OpenGL context; none in a child of a process that has one, where a driver may hang."""
    process, found = _opened()
    return found if process == os.getpid() else None


@lru_cache(maxsize=1)
def _opened() -> tuple[int, tuple[str, Any] | None]:
    """The process that tried first, and what it got."""
    return os.getpid(), _open()


def _open() -> tuple[str, Any] | None:
    for name in _candidates():
        try:
            context = importlib.import_module(f"mujoco.{name}").GLContext(LARGEST, LARGEST)
            context.make_current()
            atexit.register(context.free)
        except Exception:  # whatever a driver throws, the next back end may work
            if os.environ.get("PYOPENGL_PLATFORM") == name:
                del os.environ["PYOPENGL_PLATFORM"]
            continue
        return name, context
    return None


def _candidates() -> list[str]:
    wanted = os.environ.get("MUJOCO_GL", "").lower().strip()
    if wanted in ("disable", "disabled", "off", "false", "0"):
        return []
    if sys.platform == "darwin":
        return ["cgl"]
    if sys.platform == "win32":
        return ["glfw"]
    names = [wanted] if wanted in LIBRARIES else list(LIBRARIES)
    return [name for name in names if _loads(LIBRARIES[name])]


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


class Canvas:
    """Draws one model at one size (pixels). Close it to free the graphics memory."""

    def __init__(self, model: mujoco.MjModel, width: int, height: int) -> None:
        found = _context()
        if found is None:
            raise RuntimeError("no OpenGL back end works here")
        self._gl = found[1]
        self._model = model
        self._gl.make_current()
        model.vis.global_.offwidth, model.vis.global_.offheight = width, height
        self._rect = mujoco.MjrRect(0, 0, width, height)
        self._scene = mujoco.MjvScene(model, maxgeom=1000)
        self._option = mujoco.MjvOption()
        self._context: mujoco.MjrContext | None = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        self._camera = mujoco.MjvCamera()
        self._camera.type = mujoco.mjtCamera.mjCAMERA_FIXED.value

    def draw(self, data: mujoco.MjData, camera: str) -> NDArray[np.uint8]:
        """What a camera sees: RGB pixels, top row first."""
        self._gl.make_current()
        self._camera.fixedcamid = self._model.camera(camera).id
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(self._model, data, self._option, None, self._camera, everything, self._scene)
        mujoco.mjr_render(self._rect, self._scene, self._context)
        pixels = np.empty((self._rect.height, self._rect.width, 3), dtype=np.uint8)
        mujoco.mjr_readPixels(pixels, None, self._rect, self._context)
        return np.flipud(pixels).copy()

    def close(self) -> None:
        """Free the graphics memory."""
        if self._context is not None:
            self._gl.make_current()
            self._context.free()
            self._context = None
