"""How the versions of a family came from each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.store.layout import Family, Version

if TYPE_CHECKING:
    import networkx as nx


def graph(family: Family) -> nx.DiGraph[str]:
    """The family as a graph: a node per snapshot hash with its `version`, an edge from each parent to its child."""
    import networkx as nx

    found: nx.DiGraph[str] = nx.DiGraph()
    for version in family.versions():
        found.add_node(version.hash, version=version)
    for version in family.versions():
        parent = version.snapshot.parent
        if parent and parent in found:
            found.add_edge(parent, version.hash)
    return found


def ancestors(version: Version) -> tuple[Version, ...]:
    """`version`, its parent, and so on to the base; stops where a parent is missing."""
    known = {other.hash: other for other in Family(version.directory.parent).versions()}
    chain: list[Version] = []
    at: Version | None = version
    while at is not None and at not in chain:
        chain.append(at)
        at = known.get(at.snapshot.parent or "")
    return tuple(chain)
