"""rpg view: a window from where pictures are taken, in which the task runs until it is closed."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

import mujoco
import mujoco.viewer
import pytest

from rpg.blocks import camera
from tests.cli.conftest import Rpg


class Window:
    """Stands for the viewer's window: closed after so many pictures."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, pictures: int) -> None:
        self.model, self.data, self.left = model, data, pictures
        self.cam = mujoco.MjvCamera()

    def lock(self) -> nullcontext[None]:
        return nullcontext()

    def is_running(self) -> bool:
        return self.left > 0

    def sync(self) -> None:
        self.left -= 1


@pytest.mark.parametrize("goal", [False, True])
def test_the_task_runs_in_the_window_until_it_is_closed(
    goal: bool, rpg: Rpg, compiled: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[Window] = []

    @contextmanager
    def launch(model: mujoco.MjModel, data: mujoco.MjData, **_: Any) -> Iterator[Window]:
        opened.append(Window(model, data, pictures=3))
        yield opened[-1]

    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(mujoco.viewer, "launch_passive", launch)
    result = rpg("view", "red-on-blue", "--tasks", compiled, *(["--goal"] if goal else []))
    assert result.status == 0, result.err
    (window,) = opened
    assert window.data.time > 0.0
    assert list(window.cam.lookat) == list(camera.TARGET)
    assert window.cam.azimuth == 0.0
    red, blue = (window.data.body(f"{name}_block").xpos for name in ("red", "blue"))
    assert bool(red[2] - blue[2] > 0.03) is goal


@pytest.mark.skipif(shutil.which("Xvfb") is None, reason="no virtual display here")
def test_a_real_window_opens_and_ctrl_c_closes_it(compiled: Path) -> None:
    read, write = os.pipe()
    display = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "800x600x24"], pass_fds=[write], stderr=subprocess.DEVNULL
    )
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()
        command = [sys.executable, "-m", "rpg", "view", "red-on-blue", "--tasks", str(compiled), "--json"]
        viewer = subprocess.Popen(
            command,
            env={**os.environ, "DISPLAY": f":{number}"},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert viewer.stdout is not None
        assert '"goal": false' in "".join(viewer.stdout.readline() for _ in range(5))
        time.sleep(3.0)
        assert viewer.poll() is None, viewer.communicate()
        viewer.send_signal(signal.SIGINT)
        _, said = viewer.communicate(timeout=20)
        assert viewer.returncode == 130
        assert "Traceback" not in said
    finally:
        display.terminate()
        display.wait()
        os.close(read)
