"""Trees as people read them: a family's versions, a goal's parts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.text import Text
from rich.tree import Tree

if TYPE_CHECKING:
    from rpg.explain import Outline
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
    line = Text.assemble((f"v{version.number}", "bold cyan"), (f" {version.short_hash} ", "dim"))
    if snapshot.steering:
        line.append(f"{snapshot.steering.intent} ", "magenta")
    line.append(f"“{snapshot.snapshot.description}”")
    if current:
        line.append("  ← HEAD", "bold green")
    return line


def goal_tree(goal: Outline) -> Tree:
    """A goal as the tree that its connectives make of its conditions."""
    tree = Tree(Text(goal.text, "cyan" if goal.parts else ""))
    tree.children.extend(goal_tree(part) for part in goal.parts)
    return tree
