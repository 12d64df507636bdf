"""Probes of this machine. Each is harmless, needs no network, and cannot take the process down with it."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

KEYS = ("ANTHROPIC_API_KEY", "OPENAI_API_KEY", "GEMINI_API_KEY", "MISTRAL_API_KEY", "OPENROUTER_API_KEY")
BACKENDS = {"egl": "apt install libegl1 libgl1-mesa-dri", "osmesa": "apt install libosmesa6"}
OFF = frozenset({"disable", "disabled", "off", "false", "0"})
"""What MUJOCO_GL is set to where OpenGL is not wanted."""
DRAWS = """
import mujoco
model = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
with mujoco.Renderer(model, 32, 32) as renderer:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data)
    renderer.render()
"""


@dataclass(frozen=True)
class Finding:
    """One thing that was looked at. `needed`: nothing works without it."""

    name: str
    ok: bool
    detail: str
    hint: str = ""
    needed: bool = False


def findings() -> tuple[Finding, ...]:
    """Everything there is to know about this machine."""
    return tuple(_findings())


def _findings() -> Iterator[Finding]:
    yield Finding(
        "python", sys.version_info >= (3, 11), f"{platform.python_version()} on {platform.machine()}", needed=True
    )
    yield _mujoco()
    yield _graphics()
    yield _viewer()
    yield _sandbox()
    yield _models()
    yield _robot()


def _mujoco() -> Finding:
    try:
        return Finding("mujoco", True, metadata.version("mujoco"), needed=True)
    except metadata.PackageNotFoundError:
        return Finding("mujoco", False, "not installed", "pip install mujoco", needed=True)


def _graphics() -> Finding:
    """Whether OpenGL draws off-screen. A backend whose library is missing breaks the import: another process tries."""
    wanted = os.environ.get("MUJOCO_GL", "").lower().strip()
    if wanted in OFF:
        detail = f"pictures are drawn by casting rays, as MUJOCO_GL={wanted} asks for"
        return Finding("graphics", False, detail, "for OpenGL where there is one: unset MUJOCO_GL")
    for backend in (wanted,) if wanted in BACKENDS else tuple(BACKENDS):
        if _draws(backend):
            return Finding("graphics", True, f"pictures are drawn by OpenGL ({backend})")
    hint = "for faster ones: " + " or ".join(BACKENDS.values())
    return Finding("graphics", False, "no OpenGL; pictures are drawn by casting rays", hint)


def _draws(backend: str) -> bool:
    environment = {**os.environ, "MUJOCO_GL": backend, "PYOPENGL_PLATFORM": backend}
    try:
        done = subprocess.run([sys.executable, "-c", DRAWS], env=environment, capture_output=True, timeout=30)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


def _viewer() -> Finding:
    if has_display():
        return Finding("viewer", True, "a display for rpg view")
    return Finding("viewer", False, "no display", "rpg view needs a desktop (DISPLAY or WAYLAND_DISPLAY)")


def has_display() -> bool:
    """Whether a window can be opened."""
    return sys.platform in ("darwin", "win32") or any(os.environ.get(k) for k in ("DISPLAY", "WAYLAND_DISPLAY"))


def _sandbox() -> Finding:
    from rpg.core.isolate import probe

    layers = probe()
    held = [name for name, on in (("rlimits", layers.rlimits), ("seccomp", layers.seccomp)) if on]
    if layers.landlock:
        held.append(f"Landlock (ABI {layers.landlock})")
    detail = "code is confined by " + ", ".join(held) if held else "this kernel confines nothing"
    hint = (
        "" if layers.enough else "code that a model wrote is refused here; a Linux kernel of 5.13 or newer confines it"
    )
    return Finding("sandbox", layers.enough, detail, hint)


def _models() -> Finding:
    keys = [key for key in KEYS if os.environ.get(key)]
    if not keys:
        return Finding("models", False, f"no key among {', '.join(KEYS)}; compiling needs none")
    if find_spec("litellm") is None:
        return Finding("models", False, ", ".join(keys), "pip install 'roboplayground[llm]'")
    return Finding("models", True, ", ".join(keys))


def _robot() -> Finding:
    root = os.environ.get("MENAGERIE_ROOT")
    if root and (Path(root) / "franka_emika_panda" / "panda.xml").is_file():
        return Finding("robot", True, f"Franka Panda in {root}")
    return Finding("robot", False, "no arm's assets in MENAGERIE_ROOT; a free-flying gripper is used")
