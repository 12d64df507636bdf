"""A task in MuJoCo's interactive viewer, seen from where pictures are taken."""

from __future__ import annotations

import signal
import sys
import threading
import time

import mujoco
import mujoco.viewer

from rpg.blocks import camera
from rpg.env import BlockTask

STEPS = 4
"""Physics steps between two pictures."""
PATIENCE = 5.0
"""Seconds in which a window has to close."""


def show(task: BlockTask) -> None:
    """Run `task` in a window, at the pace of the clock, until the window is closed."""
    if sys.platform == "darwin":
        # Only the viewer that runs by itself opens there, and it does not return to Python for Ctrl-C.
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        mujoco.viewer.launch(task.model, task.data)
        return
    others, stopped = set(threading.enumerate()), threading.Event()
    # An interrupt must not break off what the window's thread waits for: the loop ends itself.
    before = signal.signal(signal.SIGINT, lambda *_: stopped.set())
    try:
        with mujoco.viewer.launch_passive(task.model, task.data, show_left_ui=False, show_right_ui=False) as window:
            _run(task, window, stopped)
        # The process would crash if it ended while that thread still reads the model.
        for thread in set(threading.enumerate()) - others:
            thread.join(PATIENCE)
    finally:
        signal.signal(signal.SIGINT, before)
    if stopped.is_set():
        raise KeyboardInterrupt


def _run(task: BlockTask, window: mujoco.viewer.Handle, stopped: threading.Event) -> None:
    """Step and draw until the window is closed, or `stopped` is set."""
    with window.lock():
        _look(window.cam)
    while window.is_running() and not stopped.is_set():
        due = time.monotonic() + task.model.opt.timestep * STEPS
        mujoco.mj_step(task.model, task.data, STEPS)
        window.sync()
        time.sleep(max(0.0, due - time.monotonic()))


def _look(view: mujoco.MjvCamera) -> None:
    """Look from the fixed camera; the mouse turns the view from there."""
    away = (b - a for a, b in zip(camera.POSITION, camera.TARGET, strict=True))
    view.lookat[:] = camera.TARGET
    view.distance = sum(d * d for d in away) ** 0.5
    view.azimuth, view.elevation = 0.0, camera.ELEVATION
