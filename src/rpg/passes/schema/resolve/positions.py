"""Places inside a line or a stack: ranks from "with the red block at the bottom"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from rpg.ir.order import Order
from rpg.language.meaning import At, Coord, Meaning, Noun, Pronoun
from rpg.passes.schema.resolve.refer import refer
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.things import matching, open_to
from rpg.passes.schema.resolve.world import Scene, Scope, refuse

SIDES = {"stack": ("bottom", "top"), "row": ("left", "right", "front", "back"),
    "line": ("left", "right", "front", "back"),
         "column": ("front", "back", "left", "right")}  # fmt: skip


MAX_ALTERNATIVES = 60


def alternatives(order: Order, scene: Scene) -> list[Order]:
    """The orders that stand for one whose free places are not all next to each other.

    `ranks` ties the blocks of each free run to that run; unless the free blocks look alike, every way to share them out
    is an order of its own.
    """
    free = scene.free_runs.pop(order.ranks, ()) if order.by == "given" else ()
    if len(free) < 2:
        return [order]
    pool = [n for index in free for n in order.ranks[index]]
    if (
        len({(t.color, t.label, t.size, t.kind) for t in (scene.things[n] for n in pool)}) == 1
        and scene.things[pool[0]].color
    ):
        return [order]
    found = []
    for shares in _share_out(tuple(pool), [len(order.ranks[index]) for index in free]):
        ranks = list(order.ranks)
        for index, share in zip(free, shares, strict=True):
            ranks[index] = share
        found.append(order.model_copy(update={"ranks": tuple(ranks)}))
    if len(found) > MAX_ALTERNATIVES:
        raise refuse("ambiguous", "too many places of this order are left open", None, "name the order of all blocks")
    return found


def _share_out(pool: tuple[str, ...], sizes: list[int]) -> Iterator[tuple[tuple[str, ...], ...]]:
    if not sizes:
        yield ()
        return
    for chosen in combinations(pool, sizes[0]):
        rest = tuple(n for n in pool if n not in chosen)
        yield from ((chosen, *more) for more in _share_out(rest, sizes[1:]))


def positions(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene, scope: Scope) -> list[tuple[str, ...]]:
    """ "with the red block at the bottom": ranks from places inside the structure."""
    places: dict[int, tuple[str, ...]] = {}
    sides = SIDES[kind]
    total = len(names)
    last: int | None = None
    for item in list(spec.absolutes):
        at_ = item.adjuncts[0] if item.adjuncts else None
        if not isinstance(at_, At) or not _belongs(item.theme, names, scene):
            continue
        ref = refer(item.theme, scene, Scope(pool=names))
        if ref.op != "and" or ref.quant is not None:
            raise refuse("ambiguous", "it is not clear which block is here", item.span, "name one block for each place")
        found = ref.names
        if not set(found) <= set(names):
            raise refuse("misplaced", "this is none of the structure's blocks", item.span, "name it among them")
        scene.mentions.pop()
        if at_.side == "next" and last is not None:
            indices = [last + 1 + k for k in range(len(found))]
        else:
            indices = _indices(at_, total, len(found), sides, kind)
        if set(found) >= set(names) or any(not 0 <= i < total for i in indices):
            raise refuse(
                "contradiction", "so many blocks have no room there", item.span, "name fewer blocks", blocks=total
            )
        for index, name in zip(indices, found, strict=False):
            if index in places and places[index] != (name,):
                raise refuse(
                    "contradiction", "two blocks are given the same place", item.span, "give each a place of its own"
                )
            places[index] = (name,)
        last = max(indices) if sides[0] not in ("top",) else None
        spec.absolutes.remove(item)
    return ranks_from(places, names, scene) if places else []


def ranks_from(places: dict[int, tuple[str, ...]], names: tuple[str, ...], scene: Scene) -> list[tuple[str, ...]]:
    """Ranks from the fixed places of some of `names`; the others fill what is between them."""
    taken = {n for rank in places.values() for n in rank}
    remaining = iter([n for n in names if n not in taken])
    ranks: list[tuple[str, ...]] = []
    run: list[str] = []
    for index in range(len(names)):
        if index in places:
            ranks += [tuple(run)] if run else []
            run = []
            ranks.append(places[index])
        else:
            run.append(next(remaining))
    ranks += [tuple(run)] if run else []
    return _free_runs(ranks, places, scene)


def _belongs(theme: Meaning, names: tuple[str, ...], scene: Scene) -> bool:
    """Whether a description can be one of the members: it fits one, or one whose looks are open could take it on."""
    if isinstance(theme, Coord):
        return all(_belongs(item, names, scene) for item in theme.items)
    if isinstance(theme, Pronoun):
        return not theme.word.startswith("=") or set(theme.word[1:].split()) <= set(names)
    if not isinstance(theme, Noun):
        return False
    plain = replace(theme.traits, rank=None, scheme=None)
    if any(t.name in names for t in matching(plain, scene, False)):
        return True
    return any(open_to(scene.things[n], theme.traits) for n in names)


def _free_runs(ranks: list[tuple[str, ...]], places: dict[int, tuple[str, ...]], scene: Scene) -> list[tuple[str, ...]]:
    """Remember which ranks are free, so that `alternatives` can share their blocks out."""
    fixed = set(places.values())
    scene.free_runs[tuple(ranks)] = tuple(i for i, r in enumerate(ranks) if r not in fixed)
    return ranks


def _indices(at_: At, total: int, several: int, sides: tuple[str, ...], kind: str) -> list[int]:
    """Places counted from the first side (bottom, left or front)."""
    backward = {"top": True, "right": True, "back": True}.get(at_.side, False)
    if kind == "stack" and at_.side == "first" and at_.index is not None and at_.index > 0:
        return [at_.index - 1 + k for k in range(several)]
    if at_.side == "middle":
        if (total - several) % 2:
            raise refuse(
                "misplaced",
                f"{total} blocks have no single middle one",
                at_.span,
                "use an odd number of blocks",
                blocks=total,
            )
        start = (total - several) // 2
        return [start + k for k in range(several)]
    if at_.side == "first":
        index = at_.index or 1
        return [total - 1] if index == -1 else [index - 1 + k for k in range(several)]
    if at_.side not in sides:
        raise refuse("misplaced", f"a {kind} has no {at_.side}", at_.span, f"say {sides[0]} or {sides[1]}")
    index = (at_.index or 1) - 1
    places = [index + k for k in range(several)]
    return [total - 1 - k for k in places] if backward else places
