"""Compiled scenes with their robots."""

from __future__ import annotations

from functools import lru_cache

import mujoco

from rpg.blocks.scene import build_spec, compiled
from rpg.env.embodiment import Embodiment
from rpg.ir.assets import Asset


def model_for(assets: tuple[Asset, ...], embodiment: Embodiment | None, textures: bool) -> mujoco.MjModel:
    """The compiled scene with its robot; plain ones are shared, so never modify it."""
    if textures:
        return _build(assets, embodiment, True)
    return compiled(assets) if embodiment is None else _plain(assets, embodiment)


@lru_cache(maxsize=64)
def _plain(assets: tuple[Asset, ...], embodiment: Embodiment) -> mujoco.MjModel:
    return _build(assets, embodiment, False)


def _build(assets: tuple[Asset, ...], embodiment: Embodiment | None, textures: bool) -> mujoco.MjModel:
    spec = build_spec(assets, textures=textures)
    if embodiment is not None:
        embodiment.attach(spec)
    return spec.compile()
