"""Names that follow from looks: `red_block` where there is one, else `red_block_1`, `red_block_2` and so on."""

from __future__ import annotations

import re

from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.edits import Exchange, ReplaceAssets
from rpg.steer.draft import Draft
from rpg.steer.operations.make import free_name

_NUMBERED = re.compile(r"_\d+$")


def tidied(draft: Draft) -> None:
    """Give objects that look alike names that are alike, as a compile of the same task would; whom a hand named
    otherwise keeps its name. Who is who does not change: an object is known by the name it came into the task with."""
    alike: dict[str, list[Asset]] = {}
    others: set[str] = set()
    for asset in draft.schema.assets:
        called = _NUMBERED.sub("", asset.name)
        if called == _plain_name(asset):
            alike.setdefault(called, []).append(asset)
        else:
            others.add(asset.name)
    wanted: dict[str, str] = {}
    for name, assets in alike.items():
        numbered = [f"{name}_{k}" for k in range(1, len(assets) + 1)] if len(assets) > 1 else [name]
        if not others & set(numbered):
            wanted |= {asset.name: new for asset, new in zip(assets, numbered, strict=True)}
    changes = tuple(
        Exchange(name=asset.name, asset=asset.model_copy(update={"name": wanted[asset.name]}))
        for asset in draft.schema.assets
        if wanted.get(asset.name, asset.name) != asset.name
    )
    if changes:
        draft.do(ReplaceAssets(exchanges=changes))
        draft.look_at(tuple(wanted.get(name, name) for name in draft.focus))


def _plain_name(asset: Asset) -> str:
    """What an object is called where there is no other like it."""
    if not isinstance(asset, GoalPatch):
        return free_name(asset, ())
    return "patch" if _NUMBERED.sub("", asset.name) == "patch" else f"{asset.color}_patch"
