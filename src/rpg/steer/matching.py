"""What an object looks like against what a phrase says of it: its colour, its symbol, its kind, its size."""

from __future__ import annotations

from rpg.blocks.traits import kind_of, symbol_of, symbols_of
from rpg.steer.requests.language import m
from rpg.steer.view import View


def matches(view: View, name: str, traits: m.Traits) -> bool:
    """Whether an object has the colours, labels, kind and size that a phrase says."""
    asset = view.world.assets[name]
    if traits.colors and asset.color not in traits.colors:
        return False
    if name in view.world.patches:
        return traits.shape is None or getattr(asset, "shape", None) == traits.shape
    symbol = symbol_of(view.world, name)
    if traits.labels and symbol not in traits.labels:
        return False
    if traits.kind is not None and kind_of(symbol) != traits.kind and not (traits.kind == "symbol" and symbol):
        return False
    if traits.scheme == "some" and symbol:
        return False
    if traits.quality and (not symbol or symbol not in symbols_of(traits.quality)):
        return False
    edge = view.world.edge[name]
    if traits.edge is not None and abs(edge - traits.edge) > 1e-6:
        return False
    edges = view.world.edge.values()
    if traits.size == "big":
        return edge == max(edges) > min(edges) or edge > 0.04
    if traits.size == "small":
        return edge == min(edges) < max(edges) or edge < 0.04
    return True
