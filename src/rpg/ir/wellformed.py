"""What a goal may say of which objects: a patch is not stacked, a block is no place, nothing relates to itself."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any as AnyType

from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.walk import atoms, children, instances

PLACES = frozenset(
    {
        "left_of",
        "right_of",
        "in_front_of",
        "behind",
        "near",
        "apart",
        "distance",
        "beside",
        "adjacent",
        "between",
        "closer",
        "equidistant",
        "approached",
        "receded",
    }
)
"""Relations that patches may stand in; of all others, only the fields `patch` and `matching` name patches."""
LEVEL = frozenset({"beside", "adjacent"})
"""Of these, the ones that a patch may stand in only with blocks."""


def problems(goal: g.Goal, patches: Collection[str]) -> Iterator[str]:
    """Why a goal cannot be meant, in words; nothing for a goal that is well formed. `patches`: their names."""
    yield from _empty(goal)
    for atom in _all_atoms(goal):
        yield from _operands(atom, frozenset(patches))


def _empty(goal: g.Goal) -> Iterator[str]:
    """Connectives with nothing in them."""
    if isinstance(goal, g.Count) and not goal.over:
        yield "count: over names nothing"
    if isinstance(goal, g.Sequence) and not goal.stages:
        yield "sequence: has no stages"
    for inner in children(goal):
        if isinstance(inner, g.All | g.Any) and not inner.goals:
            yield f"{goal.kind}: asks for nothing in one of its parts"
        yield from _empty(inner)


def _all_atoms(goal: g.Goal) -> Iterator[g.Atom]:
    """The atoms of a goal, counted ones with a block in place of their variable."""
    for part in _parts(goal):
        yield from atoms(part)


def _parts(goal: g.Goal) -> Iterator[g.Goal]:
    match goal:
        case g.Count():
            for instance in instances(goal)[:1]:
                yield from _parts(instance)
        case g.All() | g.Any():
            for inner in goal.goals:
                yield from _parts(inner)
        case g.Not() | g.Always():
            yield from _parts(goal.goal)
        case g.Sequence():
            for stage in goal.stages:
                yield from _parts(stage.goal)
        case _:
            yield goal


def _operands(atom: g.Atom, patches: frozenset[str]) -> Iterator[str]:
    fields = vars(atom)
    for field in ("a", "b", "c", "block", "blocks", "groups"):
        value = fields.get(field)
        if value is None:
            continue
        listed = _listed(value)
        if not listed:
            yield f"{atom.kind}: {field} names nothing"
        elif len(set(listed)) < len(listed):
            twice = next(name for name in listed if listed.count(name) > 1)
            yield f"{atom.kind}: {field} names {twice!r} twice"
        found = [name for name in listed if name in patches]
        if found and (atom.kind not in PLACES or isinstance(value, Lowest | Highest)):
            yield f"{atom.kind}: {field} names {found[0]!r}, which is a patch, not a block"
    for field in ("patch", "matching"):
        for name in _listed(fields.get(field) or ()):
            if name not in patches:
                yield f"{atom.kind}: {field} names {name!r}, which is a block, not a patch"
    yield from _together(atom, patches)


def _together(atom: g.Atom, patches: frozenset[str]) -> Iterator[str]:
    """What two operands may not be at once."""
    fields = vars(atom)
    a, b, c = (_listed(fields.get(field) or ()) for field in "abc")
    if a and b and len(a) == len(b) == 1 and a == b:
        yield f"{atom.kind}: a and b are both {a[0]!r}"
    if c and (set(c) & set(a) or set(c) & set(b)):
        yield f"{atom.kind}: {c[0]!r} is named twice"
    if atom.kind in LEVEL and patches.intersection(a) and patches.intersection(b):
        yield f"{atom.kind}: both sides name patches; say left_of, right_of, in_front_of, behind, near or apart"
    if atom.kind == "group_by" and fields["outliers"] and fields["by"] is None:
        yield "group_by: outliers needs by, to say in what they differ"
    if atom.kind in ("swapped", "took_place") and len(a) != len(b):
        yield f"{atom.kind}: a has {len(a)} blocks and b {len(b)}; they change places one for one"


def _listed(value: AnyType) -> tuple[str, ...]:
    """The names in an operand or a list of groups."""
    if isinstance(value, tuple) and value and all(isinstance(item, tuple) for item in value):
        return tuple(name for item in value for name in item)
    return tuple(members(value))
