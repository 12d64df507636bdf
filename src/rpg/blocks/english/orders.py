"""Orders, directions and patterns in words."""

from __future__ import annotations

from rpg.blocks.english.speaker import Speaker
from rpg.ir.order import Attribute, Order, Pattern, Side

TO = {"left": "right", "right": "left", "front": "back", "back": "front", "top": "bottom", "bottom": "top"}
ATTRIBUTES: dict[Attribute, str] = {
    "color": "color",
    "kind": "kind",
    "label": "label",
    "vowel": "vowels and consonants",
    "parity": "odd and even",
    "size": "size",
}


def from_to(first: Side | None) -> str:
    """A direction: "from left to right"; nothing where either end may be the beginning."""
    return f" from {first} to {TO[first]}" if first else ""


def ordered(order: Order, say: Speaker) -> str:
    """An order with its direction, as it follows "in a row" or "in a stack"."""
    way = from_to(order.first)
    match order.by:
        case "any":
            return way
        case "given":
            return f"{way} in the order {_ranks(order, say)}"
        case "label":
            return f"{way} in {'reverse ' if order.descending else ''}alphabetical order"
        case "number":
            return f"{way} in {'descending' if order.descending else 'ascending'} numerical order"
        case "rainbow":
            return f"{way} in {'reverse ' if order.descending else ''}rainbow order"
        case "size":
            return f"{way} by {'decreasing' if order.descending else 'increasing'} size"
        case "alternating":
            return f"{way} with alternating {_values(order.attribute)}"
        case "mirrored":
            return f"{way} with mirrored {_values(order.attribute)}"
        case "together":
            return f"{way} with blocks of the same {ATTRIBUTES[order.attribute]} next to each other"


def _values(attribute: Attribute) -> str:
    return {"color": "colors", "kind": "kinds", "label": "labels", "size": "sizes"}.get(
        attribute, ATTRIBUTES[attribute]
    )


def _ranks(order: Order, say: Speaker) -> str:
    if order.match == "name":
        return ", then ".join(say.the(rank) for rank in order.ranks)
    if all(len(rank) == 1 for rank in order.ranks):
        return ", ".join(say.one(rank[0]) for rank in order.ranks)
    return ", then ".join(say.the(rank) for rank in order.ranks)


def patterned(pattern: Pattern | None, say: Speaker) -> str:
    """A pattern, as it follows the figure's noun."""
    if pattern is None:
        return ""
    match pattern.kind:
        case "checkerboard":
            return " in a checkerboard pattern"
        case "reading":
            return ordered(pattern.order, say)
        case line:
            return f" where each {line} has a different {ATTRIBUTES[pattern.attribute]}"
