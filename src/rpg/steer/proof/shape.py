"""The shape of a goal: what it asks for, without the parameters that a tweak may change."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from rpg.ir import goal as g
from rpg.ir.shrink import TooSmall, without
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import atoms, conjuncts, names, rename, transform
from rpg.steer.proof.identity import Identity, look

STRUCTURES = frozenset(
    {"stack", "towers", "row", "grid", "pyramid", "staircase", "figure", "group_by", "spells", "equation"}
)


_LASTING = frozenset({"on_patch", "in_region", "facing", "turned", "stayed", "empty"})


def lasts(part: g.Goal) -> bool:
    """Whether a condition is about where blocks are on the table and how they are turned, whatever they form."""
    return all(atom.kind in _LASTING for atom in atoms(part)) and not isinstance(part, g.Sequence)


def gives_up_places(old: g.Goal, new: g.Goal) -> bool:
    """Whether blocks that form something have to be at a place, and those of another goal form something anywhere."""
    placed = any(
        atom.kind in ("on_patch", "in_region") or getattr(atom, "patch", None) is not None for atom in atoms(new)
    )
    told = [lasts(part) for part in conjuncts(old)]
    return not placed and (
        (any(told) and not all(told)) or any(getattr(a, "patch", None) for a in atoms(old) if a.kind in STRUCTURES)
    )


def shape(goal: g.Goal) -> Any:
    """Nested kinds and qualities; numbers, names and repetitions are left out."""
    match goal:
        case g.All() | g.Any():
            return goal.kind, tuple(sorted({repr(shape(part)) for part in goal.goals}))
        case g.Not() | g.Always():
            return goal.kind, shape(goal.goal)
        case g.Count():
            return goal.kind, shape(goal.goal)
        case g.Sequence():
            return goal.kind, tuple((shape(stage.goal), stage.undone) for stage in goal.stages)
        case _:
            return goal.kind, _qualities(goal)


def duties(goal: g.Goal) -> Any:
    """Nested kinds, qualities and names; numbers are left out."""
    match goal:
        case g.All() | g.Any():
            return goal.kind, tuple(sorted(repr(duties(part)) for part in goal.goals))
        case g.Not() | g.Always() | g.Count():
            return goal.kind, duties(goal.goal)
        case g.Sequence():
            return goal.kind, tuple((duties(stage.goal), stage.undone) for stage in goal.stages)
        case _:
            return goal.kind, _qualities(goal), repr(_named(goal))


def same_shape(identity: Identity) -> bool:
    """Whether two goals differ in parameters alone, whichever blocks they are about."""
    return bool(_flat(shape(_aligned(identity))) == _flat(shape(identity.new.goal)))


def _aligned(identity: Identity) -> g.Goal:
    """The old goal in new names. Where look-alikes had no order because none could be told, it has the new one's."""
    looks = {asset.name: repr(look(asset)) for asset in identity.old.assets}
    orders = {
        (node.kind, frozenset(node.blocks)): node.order
        for node in atoms(identity.new.goal)
        if isinstance(node, Stack | Row)
    }

    def align(node: g.Goal) -> g.Goal:
        if not isinstance(node, Stack | Row) or node.order.by != "any" or len({looks[n] for n in node.blocks}) > 1:
            return node
        members = frozenset(identity.names.get(name, name) for name in node.blocks)
        order = orders.get((node.kind, members))
        if order is None or order.by != "given":
            return node
        back = {new: old for old, new in identity.names.items()}
        ranks = tuple(tuple(back.get(name, name) for name in rank) for rank in order.ranks)
        return node.model_copy(update={"order": order.model_copy(update={"ranks": ranks})})

    return rename(transform(identity.old.goal, align), identity.names)


def same_duties(identity: Identity) -> bool:
    """Whether every shared block has the part in the new goal that it had in the old one."""
    old = _aligned(identity)
    kept = set(identity.names.values())
    try:
        before = without(old, set(names(old)) - kept)
        after = without(identity.new.goal, set(names(identity.new.goal)) - kept)
    except TooSmall:
        return True
    if before is None or after is None:
        return before is None and after is None
    return bool(_flat(duties(before)) == _flat(duties(after)))


def structures(goal: g.Goal) -> frozenset[str]:
    """What blocks form together in a goal: kinds of structures, and "stack" for towers written as "a on b"."""
    found = {part.kind for part in atoms(goal)}
    return frozenset((found & STRUCTURES) | ({"stack"} if found & {"on", "above"} else set()) or found)


def _flat(found: Any) -> Any:
    """A conjunction of one is that one."""
    if found[0] == "all" and len(found[1]) == 1:
        return found[1][0]
    return found if found[0] == "all" else repr(found)


def same_structure(old: g.Goal, new: g.Goal) -> bool:
    """Whether two goals build one figure of the same kind and size, perhaps of other blocks in another order."""
    before, after = list(atoms(old)), list(atoms(new))
    if len(before) != 1 or len(after) != 1 or before[0].kind not in STRUCTURES:
        return False
    return before[0].kind == after[0].kind and _frame(before[0]) == _frame(after[0])


def _frame(atom: g.Goal) -> dict[str, Any]:
    """The fields of a structure that say what is built; not of which blocks, nor in which order."""
    told = atom.model_dump(exclude={"span", "blocks", "groups", "order", "pattern", "readable", "word", "text"})
    return {**told, "blocks": len(getattr(atom, "blocks", ()))}


def _qualities(atom: g.Goal) -> tuple[tuple[str, str], ...]:
    """Fields of an atom that are words or truth values; a field at its default and one left out are the same."""
    kept = []
    for field, info in type(atom).model_fields.items():
        value = getattr(atom, field)
        if field in ("kind", "span") or value == info.default:
            continue
        quality = _quality(value, field)
        if quality:
            kept.append((field, quality))
    return tuple(kept)


def _quality(value: Any, field: str) -> str:
    match value:
        case bool():
            return str(value)
        case int() | float() | None | tuple():
            return ""
        case str():
            return "" if field in ("a", "b", "c", "block", "patch", "word", "text", "label") else value
        case BaseModel():
            inner = ((name, _quality(getattr(value, name), name)) for name in type(value).model_fields)
            return " ".join(f"{name}={text}" for name, text in inner if text)
    return ""


def _named(atom: g.Goal) -> tuple[Any, ...]:
    """What an atom says of whom; members of a structure without an order are a set."""
    order = getattr(atom, "order", None)
    ranks = getattr(order, "ranks", ())
    fields = []
    for field in ("a", "b", "c", "block", "patch"):
        value = getattr(atom, field, None)
        if value is not None:
            fields.append((field, value.model_dump(mode="json") if isinstance(value, BaseModel) else value))
    members = tuple(sorted(getattr(atom, "blocks", ())))
    groups = tuple(sorted(tuple(sorted(group)) for group in getattr(atom, "groups", ())))
    return (tuple(fields), members, groups, ranks)
