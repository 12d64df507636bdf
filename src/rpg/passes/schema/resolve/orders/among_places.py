"""The blocks at some places of what was built: "each end block", "the second and the third", "its far left corner"."""

from __future__ import annotations

from typing import cast

from rpg.core.diagnostics import Span
from rpg.ir.structures import Cells
from rpg.ir.walk import names as names_in
from rpg.language.meaning import At, PartOf, Places
from rpg.passes.schema.resolve.orders.parts import cells_of, groups_in
from rpg.passes.schema.resolve.orders.positions import SIDES, SYMMETRIC, line_groups, places_of
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse, which_one


def blocks_at(part: PartOf, of: Ref | None, scene: Scene, scope: Scope) -> Ref:
    """The blocks that stand at these places `of` a structure; where all look alike, any of them, which are then said to
    stand there."""
    found = list(of.built) if of is not None else wholes(scene)
    if len(found) != 1:
        raise refuse("ambiguous" if found else "no-referent", "it is not clear of what these are parts", part.span,
                     "say of what")  # fmt: skip
    whole, places = found[0], part.places
    if not isinstance(places, At | Places):
        return Ref(names=whole.members, plural=True, span=part.span)
    left_alike(scene, scope)
    if whole.ordered and (members := _from_the_first(whole, places)):
        names = tuple(members[k] for k in _indices(places, whole, part.span, scene))
        return Ref(names=names, plural=len(names) > 1, span=part.span)
    return standing_there(places, whole, part.span, scene)


def named_part(part: str, built: Built) -> Ref | None:
    """The middle, the bottom or an end of a line that is told in order."""
    members = built.members
    if part == "middle" and len(members) % 2:
        return Ref(names=(members[len(members) // 2],))
    if (built.kind == "stack" and part == "bottom") or (built.side is not None and part == built.side):
        return Ref(names=members[:1])
    return Ref(names=members[-1:]) if (built.side, part) in (("left", "right"), ("front", "back")) else None


def one_on_each(part: PartOf, scene: Scene, scope: Scope) -> bool:
    """ "(A red block) on both end blocks": one on each, for none lies across blocks that are so far from each other."""
    now = [m.ref for m in scene.mentions if m.clause == scene.clause and m.role == "theme"]
    single = bool(now) and len(now[-1].names) == 1 and now[-1].det == "a"
    return part.part == "blocks" and part.places is not None and scope.rel == "on" and single


def _from_the_first(whole: Built, places: At | Places) -> tuple[str, ...]:
    """The blocks of a line from the side that places are counted from; none where it may lie either way round."""
    if whole.kind not in SIDES or (whole.side is None and places.side not in SYMMETRIC and whole.kind != "stack"):
        return ()
    return whole.members[::-1] if whole.side == SIDES[whole.kind][1] else whole.members


def _indices(places: At | Places, whole: Built, span: Span, scene: Scene) -> list[int]:
    """The places by number, from the first side of a line, or in the order in which a figure is read."""
    total = len(whole.members)
    if whole.kind in SIDES and isinstance(places, At):
        found = places_of(places, total, 1, SIDES[whole.kind], whole.kind)
    elif whole.kind in SIDES:
        found = [k for group in line_groups(places, total, whole.kind) for k in group]
    else:
        found = _cells(places, whole, scene)
    if not found:
        raise refuse("misplaced", "the structure has no such part", span, "name its blocks")
    return found


def _cells(places: At | Places, whole: Built, scene: Scene) -> list[int]:
    node, total = whole.form, len(whole.members)
    cells = cells_of(cast(Cells, node), total) if node is not None and hasattr(node, "pattern") else ()
    return [k for group in groups_in(places, cast(Cells, node), cells, scene) for k in group] if cells else []


def standing_there(places: At | Places, whole: Built, span: Span, scene: Scene) -> Ref:
    """Any blocks of a structure of blocks that look alike, which are said to stand at these places."""
    there = pinned(whole, scene)
    if there is None or whole.ordered or not all_alike(whole, scene, *there.values()):
        raise refuse("no-referent", "it is not clear which blocks these are", span, "name their colors or labels")
    if any({*whole.members} <= {*names_in(fact)} for fact in scene.start_goals):
        raise which_one("blocks that look alike are not told apart by where they are at the start", span,
                        "give them colours, or say what is where at the end")  # fmt: skip
    indices = _indices(places, whole, span, scene)
    free = iter([name for name in whole.members if name not in there.values()])
    named = {k: there.get(k) or next(free) for k in indices}
    new = [k for k in indices if k not in there]
    if new and whole.kind in SIDES:
        for k in new:
            one = places if isinstance(places, At) else _nth(k, places, whole)
            scene.loose.append((Ref(names=(named[k],), span=span), one, span))
    elif len(new) == len(indices):
        scene.loose.append((Ref(names=tuple(named.values()), span=span), places, span))
    elif new:
        raise refuse("ambiguous", "some of these were told before", span, "tell of each place once")
    return Ref(names=tuple(named.values()), plural=len(named) > 1, span=span)


def _nth(k: int, places: Places, whole: Built) -> At:
    """A place of a line by its number: from its first side, if the places are counted from a side."""
    sides = SIDES[whole.kind]
    if places.side in sides:
        return At(side=sides[0] if places.side in sides[:2] else "front", index=k + 1, span=places.span)
    return At(side="first", index=-1 if k == len(whole.members) - 1 else k + 1, span=places.span)


def pinned(whole: Built, scene: Scene) -> dict[int, str] | None:
    """Which blocks of a structure are said to stand where; None where other things are still to be placed."""
    found: dict[int, str] = {}
    for ref, places, _ in scene.loose:
        if not isinstance(places, At | Places) or not {*ref.names} < {*whole.members}:
            return None
        indices = _indices(places, whole, places.span, scene)
        if len(indices) != len(ref.names):
            return None
        found.update(zip(indices, ref.names, strict=True))
    return found


def all_alike(built: Built, scene: Scene, *told: str) -> bool:
    """Whether the blocks of a structure are known to look alike, and nothing but on those `told` is on them yet."""
    things = [scene.things[n] for n in built.members]
    looks = {(t.color, t.label, t.kind, t.size) for t in things}
    return (
        len(looks) == 1
        and (bool(things[0].color or things[0].label) or {t.scheme for t in things} == {"same"})
        and not any(n in scene.on_top for n in built.members if n not in told)
    )


def left_alike(scene: Scene, scope: Scope) -> None:
    """Where something is put at "the middle one" of blocks of which no look is told, these look alike."""
    found = wholes(scene) if scope.role == "landmark" else []
    things = [scene.things[n] for n in found[0].members] if len(found) == 1 else []
    if things and all(t.scheme is None and not (t.color or t.label or t.kind or t.size) for t in things):
        for thing in things:
            thing.scheme = "same"


def wholes(scene: Scene) -> list[Built]:
    """What is built, without the piles that arise where a block is put on one of what is there already."""
    flat = [set(b.members) for b in scene.built if b.kind != "stack"]
    return [b for b in scene.built if b.kind != "stack" or not any(there & set(b.members) for there in flat)]
