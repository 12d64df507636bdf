"""Runs of the places of a figure in the order in which it is read: what stands in each of them."""

from __future__ import annotations

from rpg.language.meaning import Absolute
from rpg.passes.schema.resolve.things.world import Scene, refuse


def in_one_run(groups: list[list[int]]) -> bool:
    """Whether a part is a single unit whose places follow each other, a row: its looks may be there in any order."""
    places = sorted(groups[0]) if len(groups) == 1 else []
    return len(places) > 1 and places == [*range(places[0], places[0] + len(places))]


def runs(
    held: dict[int, str], mixed: dict[int, int], names: tuple[str, ...], scene: Scene, item: Absolute
) -> tuple[tuple[str, ...], ...]:
    """Runs of blocks that look alike, in the order in which the figure is read; the free ones fill what is left.

    `mixed`: places of parts with several looks, which are in no order there.
    """
    free = [n for n in names if n not in held.values()]
    looks = {look(n, scene) for n in free}
    found: list[tuple[object, list[str]]] = []
    spare = iter(free)
    for k in range(len(names)):
        name = held.get(k)
        kind: object = "free" if name is None else mixed[k] if k in mixed else look(name, scene)
        if not found or found[-1][0] != kind:
            found.append((kind, []))
        found[-1][1].append(name if name is not None else next(spare))
    if sum(kind == "free" for kind, _ in found) > 1:
        if looks == {(None, None, None, None)}:
            for name in free:
                scene.things[name].scheme = scene.things[name].scheme or "same"
        elif len(looks) > 1:
            raise refuse("ambiguous", "it is not said how the other blocks are laid out", item.span,
                         "say how they are, or use one colour for them")  # fmt: skip
    return tuple(tuple(run) for _, run in found)


def look(name: str, scene: Scene) -> tuple[object, ...]:
    """What tells a block apart from others."""
    thing = scene.things[name]
    return thing.color, thing.label, thing.size, thing.kind
