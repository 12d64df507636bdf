"""Typed edits of a task: every version is its reference with a list of these applied, and applying them again gives
the same schema.

Edits name objects as the schema calls them at that point of the list. `apply` checks the result once, at the end, so
that a list may pass through states that are not tasks.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter

from rpg.ir import goal as g
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.base import Record
from rpg.ir.schema import InitialState, TaskSchema, Vacancy
from rpg.ir.shrink import close, without
from rpg.ir.walk import children, rebuild, rename, transform
from rpg.ir.walk import names as mentioned

Path = tuple[int, ...]
"""A place in a goal: which child to take at each level, from the root down."""


class EditError(Exception):
    """An edit that the schema has no place for; the message says why."""


class AddAsset(Record):
    """A new object, after all others."""

    edit: Literal["add_asset"] = "add_asset"
    asset: Asset


class RemoveAsset(Record):
    """An object leaves the task, its goal and its start. What stood on it stands on what it stood on."""

    edit: Literal["remove_asset"] = "remove_asset"
    name: str


class Exchange(Record):
    """The object `name` becomes `asset` (recoloured, relabelled, resized, or another one) and takes over its place."""

    name: str
    asset: Asset


class ReplaceAssets(Record):
    """Several objects change at once, so that two of them may swap names."""

    edit: Literal["replace_assets"] = "replace_assets"
    exchanges: tuple[Exchange, ...] = Field(min_length=1)


class Permute(Record):
    """Objects take each other's parts in the goal: `parts` maps each name to the one whose part it takes over."""

    edit: Literal["permute"] = "permute"
    parts: dict[str, str]


class SetGoal(Record):
    """Another goal for the same objects."""

    edit: Literal["set_goal"] = "set_goal"
    goal: g.Goal


class AddCondition(Record):
    """The goal asks for `goal` as well."""

    edit: Literal["add_condition"] = "add_condition"
    goal: g.Goal


class DropCondition(Record):
    """The goal no longer asks for what stands at `at`."""

    edit: Literal["drop_condition"] = "drop_condition"
    at: Path


class ChangeCondition(Record):
    """What stands at `at` in the goal becomes `to`."""

    edit: Literal["change_condition"] = "change_condition"
    at: Path
    to: g.Goal


class SetField(Record):
    """One field of the goal node at `at`: a tolerance, a spacing, an order, a number of rows."""

    edit: Literal["set_field"] = "set_field"
    at: Path
    field: str
    value: Any


class SetStart(Record):
    """Another distribution of starts."""

    edit: Literal["set_start"] = "set_start"
    init: InitialState


class SetText(Record):
    """The words of the task: its canonical instruction, its assumptions, its paraphrases."""

    edit: Literal["set_text"] = "set_text"
    instruction: str
    assumptions: tuple[str, ...] = ()
    paraphrases: tuple[str, ...] = ()


class Overwrite(Record):
    """A whole new task under the family's name."""

    edit: Literal["overwrite"] = "overwrite"
    task: TaskSchema


Edit = Annotated[
    AddAsset
    | RemoveAsset
    | ReplaceAssets
    | Permute
    | SetGoal
    | AddCondition
    | DropCondition
    | ChangeCondition
    | SetField
    | SetStart
    | SetText
    | Overwrite,
    Field(discriminator="edit"),
]
EDIT: TypeAdapter[Edit] = TypeAdapter(Edit)


def apply(schema: TaskSchema, edits: Iterable[Edit]) -> TaskSchema:
    """`schema` with every edit applied in turn, checked. Raises EditError, TooSmall, or pydantic's ValidationError."""
    for edit in edits:
        schema = step(schema, edit)
    return TaskSchema.model_validate(schema.model_dump())


def key(asset: Asset) -> str:
    """What an object is known by through all versions: the name under which it came into the task."""
    return asset.name if isinstance(asset, GoalPatch) else asset.origin or asset.name


def at(goal: g.Goal, path: Path) -> g.Goal:
    """The node of `goal` at `path`."""
    for index in path:
        inner = children(goal)
        if index >= len(inner):
            raise EditError(f"the goal has no part at {list(path)}")
        goal = inner[index]
    return goal


def put(goal: g.Goal, path: Path, new: g.Goal) -> g.Goal:
    """`goal` with `new` at `path`."""
    if not path:
        return new
    inner = list(children(goal))
    inner[path[0]] = put(inner[path[0]], path[1:], new)
    return rebuild(goal, tuple(inner))


def conjoin(goal: g.Goal, more: g.Goal) -> g.Goal:
    """Both goals, in one flat conjunction."""
    parts = [part for side in (goal, more) for part in (side.goals if isinstance(side, g.All) else (side,))]
    return g.All(goals=tuple(parts))


def step(schema: TaskSchema, edit: Edit) -> TaskSchema:
    """`schema` with one edit applied, unchecked."""
    match edit:
        case AddAsset():
            return _copy(schema, assets=(*schema.assets, _fresh(schema, edit.asset)))
        case RemoveAsset():
            return _remove(schema, edit.name)
        case ReplaceAssets():
            return _replace(schema, {exchange.name: exchange.asset for exchange in edit.exchanges})
        case Permute():
            return _copy(schema, goal=rename(schema.goal, {part: name for name, part in edit.parts.items()}))
        case SetGoal():
            return _copy(schema, goal=edit.goal)
        case AddCondition():
            return _copy(schema, goal=conjoin(schema.goal, edit.goal))
        case DropCondition():
            return _copy(schema, goal=_dropped(schema.goal, edit.at))
        case ChangeCondition():
            at(schema.goal, edit.at)
            return _copy(schema, goal=put(schema.goal, edit.at, edit.to))
        case SetField():
            return _copy(schema, goal=_with_field(schema.goal, edit))
        case SetStart():
            return _copy(schema, init=edit.init)
        case SetText():
            return _retold(schema, edit)
        case Overwrite():
            return _copy(edit.task, name=schema.name)


def _copy(schema: TaskSchema, **update: Any) -> TaskSchema:
    return schema.model_copy(update=update)


def _fresh(schema: TaskSchema, asset: Asset) -> Asset:
    """`asset` with an origin that no object has or had."""
    if isinstance(asset, GoalPatch):
        return asset
    taken = {key(other) for other in schema.assets} | {vacancy.origin for vacancy in schema.init.vacant}
    origin, number = key(asset), 2
    while origin in taken:
        origin, number = f"{key(asset)}#{number}", number + 1
    return asset.model_copy(update={"origin": None if origin == asset.name else origin})


def _remove(schema: TaskSchema, name: str) -> TaskSchema:
    names = [asset.name for asset in schema.assets]
    if name not in names:
        raise EditError(f"the task has no {name!r} to remove")
    goal = without(close(schema.goal, name), {name})
    if goal is None:
        raise EditError(f"nothing would be left of the goal without {name!r}")
    assets = tuple(asset for asset in schema.assets if asset.name != name)
    return _copy(schema, assets=assets, goal=goal, init=_start_without(schema, names.index(name)))


def _start_without(schema: TaskSchema, index: int) -> InitialState:
    """The start without the object at `index`; a place that was drawn for it stays empty."""
    asset, init = schema.assets[index], schema.init
    arranged = tuple(part for part in (without(goal, {asset.name}) for goal in init.arranged) if part is not None)
    heaps = tuple(h for h in (tuple(n for n in heap if n != asset.name) for heap in init.heaps) if h)
    poses = tuple(start for start in init.poses if start.block != asset.name)
    following = schema.assets[index + 1].name if index + 1 < len(schema.assets) else None
    left = None
    if not isinstance(asset, GoalPatch) and _scattered(init, asset.name):
        left = Vacancy(origin=key(asset), size=asset.size)
    vacant = _vacated(init.vacant, asset.name, following, left)
    return InitialState(arranged=arranged, heaps=heaps, poses=poses, vacant=vacant)


def _vacated(
    vacant: tuple[Vacancy, ...], name: str, following: str | None, left: Vacancy | None
) -> tuple[Vacancy, ...]:
    """The places kept free once the object `name` is not drawn any more, in the order in which they are drawn.

    Places that nothing is drawn after need not be kept.
    """
    if following is None:
        return tuple(vacancy for vacancy in vacant if vacancy.before != name)
    mine = [vacancy for vacancy in vacant if vacancy.before == name] + ([left] if left else [])
    others = [vacancy for vacancy in vacant if vacancy.before != name]
    place = next((i for i, vacancy in enumerate(others) if vacancy.before == following), len(others))
    others[place:place] = [vacancy.model_copy(update={"before": following}) for vacancy in mine]
    return tuple(others)


def _replace(schema: TaskSchema, new: Mapping[str, Asset]) -> TaskSchema:
    missing = sorted(set(new) - {asset.name for asset in schema.assets})
    if missing:
        raise EditError(f"the task has no {missing[0]!r} to change")
    for name, asset in new.items():
        schema = _drawn_last(schema, name, asset)
    names = {name: asset.name for name, asset in new.items()}
    assets = tuple(_heir(asset, new[asset.name]) if asset.name in new else asset for asset in schema.assets)
    init = schema.init
    return _copy(
        schema,
        assets=assets,
        goal=rename(schema.goal, names),
        init=InitialState(
            arranged=tuple(rename(goal, names) for goal in init.arranged),
            heaps=tuple(tuple(names.get(name, name) for name in heap) for heap in init.heaps),
            poses=tuple(s.model_copy(update={"block": names.get(s.block, s.block)}) for s in init.poses),
            vacant=tuple(v.model_copy(update={"before": names.get(v.before or "", v.before)}) for v in init.vacant),
        ),
    )


def _drawn_last(schema: TaskSchema, name: str, new: Asset) -> TaskSchema:
    """The schema with the block `name` drawn after all others if `new` has another size, so that it moves alone."""
    index = next(i for i, asset in enumerate(schema.assets) if asset.name == name)
    old = schema.assets[index]
    last = index + 1 == len(schema.assets)
    if isinstance(old, GoalPatch) or isinstance(new, GoalPatch) or old.size == new.size or last:
        return schema
    left = Vacancy(origin=key(old), size=old.size) if _scattered(schema.init, name) else None
    vacant = _vacated(schema.init.vacant, name, schema.assets[index + 1].name, left)
    assets = (*schema.assets[:index], *schema.assets[index + 1 :], old)
    return _copy(schema, assets=assets, init=schema.init.model_copy(update={"vacant": vacant}))


def _scattered(init: InitialState, name: str) -> bool:
    """Whether a block starts anywhere on the table rather than at a certain place."""
    placed = {start.block for start in init.poses} | {other for heap in init.heaps for other in heap}
    return name not in placed and all(name not in mentioned(goal) for goal in init.arranged)


def _heir(old: Asset, new: Asset) -> Asset:
    """`new` in the place of `old`: its start is drawn as the old one's was."""
    if isinstance(new, GoalPatch) or isinstance(old, GoalPatch):
        return new
    return new.model_copy(update={"origin": None if key(old) == new.name else key(old)})


def _dropped(goal: g.Goal, path: Path) -> g.Goal:
    """`goal` without the node at `path`; connectives that it leaves empty or alone go with it."""
    if not path:
        raise EditError("nothing would be left of the goal")
    parent = at(goal, path[:-1])
    at(goal, path)
    kept = tuple(child for index, child in enumerate(children(parent)) if index != path[-1])
    if not kept:
        return _dropped(goal, path[:-1])
    if isinstance(parent, g.Sequence):
        stages = tuple(stage for index, stage in enumerate(parent.stages) if index != path[-1])
        return put(goal, path[:-1], parent.model_copy(update={"stages": stages}) if len(kept) > 1 else kept[0])
    new = kept[0] if len(kept) == 1 and isinstance(parent, g.All | g.Any) else rebuild(parent, kept)
    return put(goal, path[:-1], new)


def _with_field(goal: g.Goal, edit: SetField) -> g.Goal:
    node = at(goal, edit.at)
    if edit.field not in type(node).model_fields or edit.field in ("kind", "span"):
        raise EditError(f"a {node.kind.replace('_', ' ')} has no {edit.field!r} to change")
    changed = g.GOAL.validate_python({**node.model_dump(), edit.field: edit.value})
    return put(goal, edit.at, changed)


def _retold(schema: TaskSchema, edit: SetText) -> TaskSchema:
    """The schema in other words; places in the old words mean nothing any more."""

    def bare(node: g.Goal) -> g.Goal:
        return node.model_copy(update={"span": None})

    arranged = tuple(transform(goal, bare) for goal in schema.init.arranged)
    return _copy(
        schema,
        instruction=edit.instruction,
        assumptions=edit.assumptions,
        paraphrases=edit.paraphrases,
        goal=transform(schema.goal, bare),
        init=schema.init.model_copy(update={"arranged": arranged}),
    )
