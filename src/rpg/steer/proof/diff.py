"""What differs between two versions of a task: assets, start, goal, language."""

from __future__ import annotations

from typing import Any

from rpg.blocks.english import clause
from rpg.blocks.nouns import bare
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.base import Record
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import conjuncts, rename, transform
from rpg.steer.proof.identity import Identity, look


class AssetChange(Record):
    """One object in both versions; `fields` maps what changed to its old and new value."""

    before: str
    after: str
    fields: dict[str, tuple[Any, Any]]


class Diff(Record):
    """The differences, by the names that each version uses. Conditions and starts are English clauses."""

    assets_added: tuple[str, ...] = ()
    assets_removed: tuple[str, ...] = ()
    assets_changed: tuple[AssetChange, ...] = ()
    starts_added: tuple[str, ...] = ()
    starts_removed: tuple[str, ...] = ()
    conditions_added: tuple[str, ...] = ()
    conditions_removed: tuple[str, ...] = ()
    conditions_kept: tuple[str, ...] = ()
    instruction: tuple[str, str] | None = None

    @property
    def empty(self) -> bool:
        """Whether the versions are the same task in the same words."""
        kept = {"conditions_kept"}
        return all(not getattr(self, field) for field in type(self).model_fields if field not in kept)


def diff(identity: Identity) -> Diff:
    """Compare two versions part by part."""
    old, new = identity.old, identity.new
    before, after = identity.before, identity.after
    changes = (
        AssetChange(before=before[k].name, after=after[k].name, fields=_fields(identity, k)) for k in identity.shared
    )
    goals = _goals(identity)
    starts_old, starts_new = _starts(old, identity.names), _starts(new, {})
    return Diff(
        assets_added=tuple(after[k].name for k in identity.added),
        assets_removed=tuple(before[k].name for k in identity.removed),
        assets_changed=tuple(change for change in changes if change.fields),
        starts_added=tuple(text for known, text in starts_new.items() if known not in starts_old),
        starts_removed=tuple(text for known, text in starts_old.items() if known not in starts_new),
        conditions_added=goals[0],
        conditions_removed=goals[1],
        conditions_kept=goals[2],
        instruction=None if old.instruction == new.instruction else (old.instruction, new.instruction),
    )


def _fields(identity: Identity, k: str) -> dict[str, tuple[Any, Any]]:
    before, after = look(identity.before[k]), look(identity.after[k])
    return {
        field: (before.get(field), after.get(field))
        for field in sorted({*before, *after})
        if before.get(field) != after.get(field)
    }


def _goals(identity: Identity) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Conditions added, removed, kept; those about renamed objects are the same conditions."""
    old_world, new_world = World(identity.old.assets), World(identity.new.assets)
    old = {_bare(rename(part, identity.names)): clause(part, old_world) for part in conjuncts(identity.old.goal)}
    new = {_bare(part): clause(part, new_world) for part in conjuncts(identity.new.goal)}
    added = tuple(text for known, text in new.items() if known not in old)
    removed = tuple(text for known, text in old.items() if known not in new)
    kept = tuple(text for known, text in new.items() if known in old)
    return added, removed, kept


def _starts(schema: TaskSchema, names: dict[str, str]) -> dict[str, str]:
    """Every special start, as data in the new version's names -> as a clause."""
    world = World(schema.assets)
    found: dict[str, str] = {}
    for goal in schema.init.arranged:
        found[_bare(rename(goal, names))] = clause(goal, world)
    for heap in schema.init.heaps:
        found[repr(sorted(names.get(n, n) for n in heap))] = f"a heap of {len(heap)} blocks"
    for start in schema.init.poses:
        moved = start.model_copy(update={"block": names.get(start.block, start.block)})
        x, y = start.position
        found[moved.model_dump_json()] = f"the {bare(start.block, world)} at ({x:.3f}, {y:.3f}) m"
    return found


def _bare(goal: g.Goal) -> str:
    """A goal as text without its places in the instruction."""
    return transform(goal, lambda node: node.model_copy(update={"span": None})).model_dump_json()
