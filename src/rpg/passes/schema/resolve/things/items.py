"""The items of an order, one by one: which blocks they stand for."""

from __future__ import annotations

import string

from rpg.language.meaning import Coord, Meaning, Noun, Traits
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import give, matching, open_to
from rpg.passes.schema.resolve.things.world import Scene, Scope


def claims(items: tuple[Meaning, ...], names: tuple[str, ...], scene: Scene) -> bool:
    """ "four cubes in a row: cyan, cyan, brown, brown", "the letters as P A P E R": as many looks as there are blocks
    of which none is said."""
    plain = all(isinstance(x, Noun) and x.det in ("a", "bare") and not x.plural and _one_look(x.traits) for x in items)
    things = [scene.things[n] for n in names]
    looks = [x.traits for x in items if isinstance(x, Noun)]
    labels = {label for look in looks for label in look.labels}
    kinds = {"letter": string.ascii_uppercase, "digit": string.digits}
    kind = next((kind for kind, known in kinds.items() if labels and labels <= {*known}), None)
    return (
        plain
        and len(items) == len(names)
        and len({(look.colors, look.labels) for look in looks}) < len(looks)
        and all(t.color is None and t.label is None and t.kind in (None, kind) for t in things)
    )


def _one_look(traits: Traits) -> bool:
    """Whether no more is said than one colour or one label."""
    only = Traits(labels=traits.labels) if traits.labels else Traits(colors=traits.colors)
    return traits == only and len(traits.labels or traits.colors) == 1


def claimed(item: Meaning, names: tuple[str, ...], scene: Scene) -> tuple[str, ...]:
    """The next of the blocks takes the look of an item."""
    for thing in (scene.things[n] for n in names):
        if isinstance(item, Noun) and open_to(thing, item.traits):
            give(thing, item.traits)
            return (thing.name,)
    return ()


def by_look(item: Meaning, names: tuple[str, ...], had: set[str], scene: Scene) -> tuple[str, ...]:
    """The blocks among `names` that an item of an order stands for; `had`: those that stood in the list before."""
    return _looked(item, names, had, scene) or _item(item, names, scene)


def _looked(item: Meaning, names: tuple[str, ...], had: set[str], scene: Scene) -> tuple[str, ...]:
    """ "a red block", "two red ones": the next of the blocks to be ordered that look so, where there are more."""
    if isinstance(item, Coord) and item.op == "and":
        found: list[str] = []
        for part in item.items:
            more = _looked(part, names, had.union(found), scene) or _item(part, names, scene)
            found += [name for name in more if name not in found]
        return tuple(found)
    if not isinstance(item, Noun) or item.det not in ("a", "bare") or item.part_of is not None or item.conditions:
        return ()
    count = 1 if item.amount is None else item.amount.low
    if (item.amount is None and item.plural) or (item.amount is not None and item.amount != (count, count, False)):
        return ()
    known = [t.name for t in matching(item.traits, scene, False) if t.name in names]
    looks = {(scene.things[n].color, scene.things[n].label, scene.things[n].size) for n in known}
    free = [name for name in known if name not in had]
    marked = len(item.traits.colors) + len(item.traits.labels) == 1 and not item.traits.rank
    return tuple(free[:count]) if marked and len(looks) == 1 and len(free) >= count else ()


def _item(item: Meaning, names: tuple[str, ...], scene: Scene) -> tuple[str, ...]:
    found = refer(item, scene, Scope(pool=names)).names
    scene.mentions.pop()
    return found
