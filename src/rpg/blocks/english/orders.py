"""Orders, directions and patterns in words."""

from __future__ import annotations

from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import join
from rpg.ir.order import Attribute, Order, Pattern, Side

TO: dict[Side, Side] = {
    "left": "right", "right": "left", "front": "back", "back": "front", "top": "bottom", "bottom": "top",
}  # fmt: skip
ATTRIBUTES: dict[Attribute, str] = {
    "color": "color",
    "kind": "kind",
    "label": "label",
    "vowel": "vowels and consonants",
    "parity": "odd and even",
    "size": "size",
}


_TURNS: dict[Attribute, str] = {
    "parity": "odd and even digits alternating",
    "vowel": "vowels and consonants alternating",
}


def from_to(first: Side | None) -> str:
    """A direction: "from left to right"; nothing where either end may be the beginning."""
    return f" from {first} to {TO[first]}" if first else ""


def ordered(order: Order, say: Speaker) -> str:
    """An order with its direction, as it follows "in a stack"."""
    way = from_to(order.first)
    match order.by:
        case "any":
            return way
        case "given":
            return _at_the_ends(order, say) or f"{way} in the order {said_in_turn(order, say)}"
        case "label":
            return f"{way} in {'reverse ' if order.descending else ''}alphabetical order"
        case "number":
            return f"{way} in {'descending' if order.descending else 'ascending'} numerical order"
        case "rainbow":
            return f"{way} in {'reverse ' if order.descending else ''}rainbow order"
        case "size":
            return f"{way} by {'decreasing' if order.descending else 'increasing'} size"
        case "alternating":
            return f"{way} with {_TURNS.get(order.attribute) or f'alternating {_values(order.attribute)}'}"
        case "mirrored":
            return f"{way} with mirrored {_values(order.attribute)}"
        case "together":
            return f"{way} with blocks of the same {ATTRIBUTES[order.attribute]} together"


def along(order: Order, say: Speaker) -> str:
    """An order along a line on the table, which may have its beginning at either end."""
    free = order.first is None and order.by in ("given", "label", "number", "rainbow", "size")
    order = order.model_copy(update={"descending": False}) if free else order
    return ordered(order, say) + (" in either direction" if free else "")


def _values(attribute: Attribute) -> str:
    return {"color": "colors", "kind": "kinds", "label": "labels", "size": "sizes"}.get(
        attribute, ATTRIBUTES[attribute]
    )


PLACES: dict[Side, str] = {
    "left": "at the left end", "right": "at the right end", "front": "at the front end", "back": "at the back end",
    "bottom": "at the bottom", "top": "on top",
}  # fmt: skip


def _at_the_ends(order: Order, say: Speaker) -> str:
    """An order that only says which block is at an end, or which are at both: "with the red block at the left end"."""
    free = [k for k, rank in enumerate(order.ranks) if len(rank) > 1]
    if order.first is None or order.match != "look" or len(free) != 1 or len(order.ranks) not in (2, 3):
        return ""
    if len(order.ranks) == 3 and free != [1]:
        return ""
    if any(len(rank) == 1 and not say.unique(rank[0]) for rank in order.ranks):
        return ""
    ends = [(order.ranks[0], order.first), (order.ranks[-1], TO[order.first])]
    told = [f"{say.the(rank)} {PLACES[side]}" for rank, side in ends if len(rank) == 1]
    return f" with {' and '.join(told)}"


def said_in_turn(order: Order, say: Speaker) -> str:
    """ "red, blue, red", "the red block, the A block", "a red block, then two blue blocks"."""
    single = all(len(rank) == 1 for rank in order.ranks)
    if order.match != "look":
        with say.strictly():
            return (", " if single else ", then ").join(_rank(rank, True, say) for rank in order.ranks)
    if single and (short := say.short(rank[0] for rank in order.ranks)):
        return ", ".join(short)
    joint = ", " if single else ", then "
    return joint.join(_rank(rank, False, say) for rank in order.ranks)


def _rank(rank: tuple[str, ...], by_name: bool, say: Speaker) -> str:
    parts = [say.the(rank)] if by_name or all(map(say.unique, rank)) else say.like(rank)
    mixed = len(rank) > 1 and (by_name or len({say.noun(name) for name in rank}) > 1)
    return join(parts) + (" in no fixed order" if mixed else "")


def patterned(pattern: Pattern | None, say: Speaker, *, upright: bool = False, in_rows: bool = False) -> str:
    """A pattern, as it follows the figure's noun; `upright`: the figure has layers; `in_rows`: it has rows."""
    if pattern is None:
        return ""
    match pattern.kind:
        case "checkerboard":
            return " in a checkerboard pattern"
        case "reading":
            return _reading(pattern, upright, in_rows, say)
        case line:
            return f" where each {line} has a different {ATTRIBUTES[pattern.attribute]}"


def _reading(pattern: Pattern, upright: bool, in_rows: bool, say: Speaker) -> str:
    """How cells are filled one after the other, as a page is read."""
    order = pattern.order
    if order.by == "any":
        return ""
    way = (
        " from its first drawn place on"
        if pattern.own
        else " from bottom to top"
        if pattern.upward
        else " from top to bottom"
        if upright
        else " row by row"
        if in_rows
        else ""
    )
    return f"{way}{ordered(order, say)}"
