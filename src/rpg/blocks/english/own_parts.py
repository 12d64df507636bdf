"""Figures told by their own parts: "with the corner red and the rest blue"."""

from __future__ import annotations

from rpg.blocks.english.speaker import Speaker
from rpg.blocks.figure_parts import own_parts
from rpg.blocks.nouns import join
from rpg.ir.structures import Cells


def by_parts(node: Cells, say: Speaker) -> str:
    """The parts of one look each, and what is left; nothing where parts do not tell all of it."""
    if node.pattern is None or not node.pattern.own or node.pattern.order.match != "look":
        return ""
    looks = [look for rank in node.pattern.order.ranks for look in say.short(rank)]
    if len(looks) != len(node.blocks):
        return ""
    parts = own_parts(node, len(looks))
    told = next((found for name in parts if (found := _told(looks, {name: parts[name]}))), _told(looks, parts))
    return f" with {join([f'{part} {look}' for part, look in told.items()])}" if told else ""


def _told(looks: list[str], parts: dict[str, tuple[int, ...]]) -> dict[str, str]:
    """The look of each part and of the rest; nothing where these are not all."""
    told: dict[str, str] = {}
    left = set(range(len(looks)))
    for name, places in parts.items():
        if left.issuperset(places) and len(places) < len(left) and len({looks[k] for k in places}) == 1:
            told[name] = looks[places[0]]
            left -= set(places)
            if len({looks[k] for k in left}) == 1 and looks[min(left)] not in told.values():
                return told | {"the rest": looks[min(left)]}
    return {}
