"""What is left open is chosen: colours, labels, sizes, names; then the task is put together."""

from __future__ import annotations

import string
from collections import Counter

from rpg.blocks.traits import QUALITIES, symbols_of
from rpg.ir import goal as g
from rpg.ir.assets import PATCH_SIDE, Asset, ColoredCube, Faces, GoalPatch, SemanticCube
from rpg.ir.goal import Goal
from rpg.ir.schema import COLORS_UNSAID, SYMBOLS_UNSAID
from rpg.ir.walk import rename
from rpg.passes.schema.resolve.things.sized import size_all
from rpg.passes.schema.resolve.things.strangers import no_strangers
from rpg.passes.schema.resolve.things.things import EDGES, PATCH_SCALE
from rpg.passes.schema.resolve.things.world import Scene, Thing, refuse

BLOCK_COLORS = ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink", "brown", "white", "black", "gray")
PATCH_COLORS = ("gray", "blue", "yellow", "red", "purple", "orange", "cyan", "pink", "green")
_SIGNS = {"+": "plus", "-": "minus", "*": "times", "/": "divide", "=": "equals"}
LONG = 2.5
DIGITS = "1234567890"
"""In the order in which they are chosen."""


def label_of(thing: Thing, scene: Scene) -> str:
    """The symbol of a block that shows one; the next free one where it was left open."""
    if thing.label is None:
        taken = Counter(t.label for t in scene.blocks())
        choice = _symbols_for(thing)
        fresh = min(choice, key=lambda symbol: taken[symbol])
        if taken[fresh] and thing.scheme == "different":
            raise refuse(
                "too-many-labels",
                "there are not enough different symbols for so many blocks",
                None,
                f"use at most {len(choice)} blocks of different symbols",
                symbols=len(choice),
            )
        if taken[fresh] and thing.quality and thing.quality not in QUALITIES:
            raise refuse("too-many-labels", f"of such digits there are no more than {', '.join(choice)}", None,
                         "name the cubes, as in 'put 7, 8 and 9 in a row'", symbols=len(choice))  # fmt: skip
        thing.label = fresh
        thing.open = string.ascii_uppercase + DIGITS if thing.kind == "symbol" else choice
        scene.assume(f"{SYMBOLS_UNSAID}: chosen in order")
        if taken[fresh] and thing.kind != "symbol":
            scene.assume("there are more blocks than symbols of their sort: some show the same")
    return thing.label


def _symbols_for(thing: Thing) -> str:
    """The symbols that a block may show, in the order in which they are chosen."""
    if thing.quality:
        return symbols_of(thing.quality)
    return DIGITS if thing.kind == "digit" else string.ascii_uppercase


def choose(scene: Scene) -> set[str]:
    """Give every object the looks that were left open; the things whose colour was."""
    things = list(scene.things.values())
    size_all(scene)
    no_strangers(scene)
    _count_open(things, scene)
    _named_ones(things)
    for thing in things:
        if thing.kind and not thing.patch:
            label_of(thing, scene)
    open_ = [t for t in things if not t.patch and t.color is None and t.kind is None]
    _paint_blocks(open_, scene)
    bare = [thing for thing in things if thing.patch and thing.color is None]
    for thing in bare:
        taken = {t.color for t in things if t.patch}
        thing.color = next((c for c in PATCH_COLORS if c not in taken), None)
        if thing.color is None:
            raise refuse(
                "patches-no-room",
                f"more than {len(PATCH_COLORS)} patches cannot be told apart on the table",
                None,
                f"use at most {len(PATCH_COLORS)} patches",
                patches=sum(t.patch for t in things),
            )
        scene.assume(f"the colour of the patch is not said: {thing.color}")
    return {thing.name for thing in (*open_, *bare)}


def _named_ones(things: list[Thing]) -> None:
    """Refuse blocks of which neither number nor symbols are said where others are named that show such: "a row in
    descending order, 8, 2, 6" could be of these."""
    made_up = [t for t in things if (t.elastic is not None or t.invented) and not t.extra]
    kinds = {t.kind for t in made_up if t.kind and (t.label is None or t.open)}
    named = [t for t in things if t.label and not t.extra and t.kind in kinds and t not in made_up]
    if named:
        labels = ", ".join(dict.fromkeys(t.label for t in named if t.label))
        raise refuse("ambiguous", f"it is not clear whether these are {labels} or further ones", None,
                     "name the blocks where the order is told")  # fmt: skip


def _count_open(things: list[Thing], scene: Scene) -> None:
    """Say how many objects were taken where that was left open."""
    counts: dict[tuple[int, str], int] = {}
    for thing in things:
        if thing.elastic is not None:
            key = (thing.batch, thing.elastic)
            counts[key] = counts.get(key, 0) + 1
    for (_, words), count in counts.items():
        scene.assume(f"the number of {words} is not said: {count}")


def _paint_blocks(open_: list[Thing], scene: Scene) -> None:
    if not open_:
        return
    taken = [t.color for t in scene.blocks() if t.color and not t.kind]
    batches: dict[int, list[Thing]] = {}
    for thing in open_:
        batches.setdefault(thing.batch, []).append(thing)
    chosen: list[str] = []
    if len(batches) > 1 and all(t.scheme is None for t in open_):
        batches = {0: open_}
        open_[0].scheme = "same"
    for batch in batches.values():
        barred = frozenset[str]().union(*(thing.barred for thing in batch))
        palette = [c for c in BLOCK_COLORS if c not in taken and c not in barred]
        if batch[0].scheme == "same":
            color = next(iter([*palette, *(c for c in BLOCK_COLORS if c not in barred)]), BLOCK_COLORS[0])
            for thing in batch:
                thing.color = color
            taken.append(color)
            chosen.append(color)
            continue
        if batch[0].scheme == "different" and len(batch) > len(palette):
            raise refuse(
                "too-many-colors",
                f"there are {len(BLOCK_COLORS)} colours, not {len(batch)}",
                None,
                f"use at most {len(palette)} blocks of different colours",
                asked=len(batch),
                there=len(BLOCK_COLORS),
            )
        palette = palette or [c for c in BLOCK_COLORS if c not in barred] or list(BLOCK_COLORS)
        for index, thing in enumerate(batch):
            thing.color = palette[index % len(palette)]
            taken.append(thing.color)
            chosen.append(thing.color)
    scene.assume(f"{COLORS_UNSAID}: {', '.join(dict.fromkeys(chosen))}")


def _base(thing: Thing) -> str:
    size = f"{thing.size}_" if thing.size else ""
    if thing.patch:
        return f"{thing.color}_patch"
    if thing.label:
        return f"{size}{_SIGNS.get(thing.label, thing.label)}_block"
    return f"{size}{thing.color}_block"


def naming(scene: Scene) -> dict[str, str]:
    """Final names: `red_block`, `red_block_1`, `A_block`, `blue_patch` ..."""
    bases: dict[str, list[str]] = {}
    for thing in scene.things.values():
        bases.setdefault(_base(thing), []).append(thing.name)
    names: dict[str, str] = {}
    for base, members in bases.items():
        for index, name in enumerate(members):
            names[name] = base if len(members) == 1 else f"{base}_{index + 1}"
    return names


def assets(scene: Scene, names: dict[str, str]) -> tuple[Asset, ...]:
    """The task's objects, in the order in which they were brought up."""
    made: list[Asset] = []
    for thing in scene.things.values():
        made.append(_asset(thing, names[thing.name]))
    if all(isinstance(asset, GoalPatch) for asset in made):
        raise refuse("no-goal", "there is no block in this task", None,
                     "name a block and say where it should be, or where it is at the start: 'a red block is on the "
                     "blue patch; clear the blue patch'")  # fmt: skip
    return tuple(made)


def _asset(thing: Thing, name: str) -> Asset:
    if thing.patch:
        width = thing.extent or (PATCH_SIDE, PATCH_SIDE)
        shape = thing.shape if thing.shape in ("square", "rectangle", "circle") else "square"
        if thing.long and thing.extent is None:
            width, shape = (PATCH_SIDE, round(PATCH_SIDE * LONG, 4)), "rectangle"
        elif shape == "rectangle" and thing.extent is None:
            width = (PATCH_SIDE, round(PATCH_SIDE * 1.5, 4))
        scale = PATCH_SCALE.get(thing.size or "", 1.0)
        size = (round(width[0] * scale, 4), round(width[1] * scale, 4))
        return GoalPatch(name=name, color=thing.color or "gray", shape=shape, size=size)  # type: ignore[arg-type]
    edge = thing.edge or EDGES.get(thing.size or "", 0.04)
    if not 0.01 <= edge <= 0.12:
        raise refuse(
            "size-out-of-range",
            f"a block of {edge * 100:g} cm cannot be made",
            None,
            "blocks have edges from 1 to 12 cm",
            edge_m=edge,
        )
    if thing.label is not None and len(thing.label) > 1:
        raise refuse("unknown-symbol", f"no block shows {thing.label}", None, "use a block for each digit or letter")
    if thing.kind:
        faces = Faces(**thing.faces) if thing.faces else None
        body = thing.color or "ivory"
        return SemanticCube(name=name, label="" if faces else thing.label or "", labels=faces, color=body, size=edge)  # type: ignore[arg-type]
    return ColoredCube(name=name, color=thing.color or "red", size=edge)  # type: ignore[arg-type]


def renamed(goal: Goal, names: dict[str, str]) -> Goal:
    """The goal with the final names."""
    return rename(goal, names)


__all__ = ["assets", "choose", "g", "label_of", "naming", "renamed"]
