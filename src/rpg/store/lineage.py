"""How the versions of a family came from each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.store.layout import Family

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
