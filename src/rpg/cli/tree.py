"""Trees as people read them: a family's versions, a goal's parts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.text import Text
from rich.tree import Tree

if TYPE_CHECKING:
    from rpg.blocks.state import World
    from rpg.ir.goal import Goal
    from rpg.store import Version


def lineage_tree(family: str, versions: Sequence[Version], head: Version) -> Tree:
    """The versions of a family, each below the one that it came from; HEAD is marked."""
    root = Tree(Text(family, "bold"))
    known = {version.hash for version in versions}
    nodes: dict[str, Tree] = {}
    for version in versions:
        parent = version.snapshot.parent
        place = nodes.get(parent, root) if parent in known else root
        nodes[version.hash] = place.add(_line(version, version == head))
    return root


def _line(version: Version, current: bool) -> Text:
    snapshot = version.snapshot
    steering = snapshot.steering
    line = Text.assemble((f"v{version.number}", "bold cyan"), (f" {version.short_hash} ", "dim"))
    if steering:
        line.append(f"{steering.intent} ", "magenta")
        line.append(f"“{steering.request}” ")
    line.append(snapshot.snapshot.goal_summary)
    if current:
        line.append("  ← HEAD", "bold green")
    return line


def goal_tree(goal: Goal, world: World) -> Tree:
    """A goal as the tree that its connectives make of its conditions."""
    from rpg.ir.walk import children

    tree = Tree(Text(label(goal, world)))
    tree.children.extend(goal_tree(part, world) for part in children(goal))
    return tree


def label(goal: Goal, world: World) -> str:
    """One node of a goal in a few words, its parts left aside."""
    from rpg.blocks.predicates import PREDICATES
    from rpg.ir import goal as g

    match goal:
        case g.All():
            return "all of"
        case g.Any():
            return "any of"
        case g.Not():
            return "not"
        case g.Always():
            return "at every step"
        case g.Sequence():
            return "one after the other"
        case g.Count():
            most = "" if goal.at_most is None else f"{goal.at_least} to {goal.at_most}"
            exact = f"exactly {goal.at_least}" if goal.at_least == goal.at_most else most
            return f"{exact or f'at least {goal.at_least}'} of {', '.join(goal.over)} ({goal.var})"
    return PREDICATES[goal.kind].english(goal, world)


def clause(goal: Goal, world: World) -> str:
    """A goal in one line."""
    from rpg.ir.walk import children

    parts = children(goal)
    if not parts:
        return label(goal, world)
    return f"{label(goal, world)} ({'; '.join(clause(part, world) for part in parts)})"
