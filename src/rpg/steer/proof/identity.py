"""Which objects of two versions are the same object, whatever each version calls it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.edits import key
from rpg.ir.schema import TaskSchema


@dataclass(frozen=True)
class Identity:
    """The objects of two versions by key: the name under which each came into the family."""

    old: TaskSchema
    new: TaskSchema

    @cached_property
    def before(self) -> dict[str, Asset]:
        return {key(asset): asset for asset in self.old.assets}

    @cached_property
    def after(self) -> dict[str, Asset]:
        return {key(asset): asset for asset in self.new.assets}

    @property
    def shared(self) -> tuple[str, ...]:
        """Keys of the objects that both versions have, in the order of the new one."""
        return tuple(k for k in self.after if k in self.before and _alike(self.before[k], self.after[k]))

    @property
    def added(self) -> tuple[str, ...]:
        return tuple(k for k in self.after if k not in self.shared)

    @property
    def removed(self) -> tuple[str, ...]:
        return tuple(k for k in self.before if k not in self.shared)

    @property
    def untouched(self) -> tuple[str, ...]:
        """Keys of shared blocks of one size in both versions: whatever their looks, their starts must not change."""
        both = ((k, self.before[k], self.after[k]) for k in self.shared)
        return tuple(k for k, old, new in both if not _patch(new) and old.size == new.size)

    @property
    def names(self) -> dict[str, str]:
        """Old name -> new name of every shared object."""
        return {self.before[k].name: self.after[k].name for k in self.shared}


def look(asset: Asset) -> dict[str, object]:
    """Everything about an object but what it is called and where it is."""
    return asset.model_dump(mode="json", exclude={"name", "origin", "position"})


def _patch(asset: Asset) -> bool:
    return isinstance(asset, GoalPatch)


def _alike(a: Asset, b: Asset) -> bool:
    """A patch is never the same object as a block."""
    return _patch(a) == _patch(b)
