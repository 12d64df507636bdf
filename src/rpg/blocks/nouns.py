"""Objects in English: "the red block", "both blue blocks", "two of the three red blocks", "the green patch"."""

from __future__ import annotations

import math

from rpg.blocks.state import World
from rpg.ir.assets import EDGE, Block, GoalPatch, SemanticCube
from rpg.ir.node import Highest, Lowest, Operand, members

NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
SIGNS = {"+": "plus", "-": "minus", "*": "times", "/": "divide", "=": "equals"}


def number(count: int) -> str:
    """A small number in words, a larger one in digits."""
    return NUMBERS[count] if count < len(NUMBERS) else str(count)


def join(parts: list[str], word: str = "and") -> str:
    """ "a", "a and b", "a, b and c"."""
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} {word} {parts[-1]}"


def bare(name: str, world: World) -> str:
    """What an object is called without article or number: "red block", "letter A block", "blue patch"."""
    asset = world.assets[name]
    if isinstance(asset, GoalPatch):
        return f"{asset.color} patch"
    return f"{_size(asset)}{_described(asset)} block"


def _described(block: Block) -> str:
    if not isinstance(block, SemanticCube):
        return block.color
    color = "" if block.color == "ivory" else f"{block.color} "
    symbol = block.label or block.symbol("top")
    return color + SIGNS.get(symbol, symbol)


def _size(block: Block) -> str:
    return "" if math.isclose(block.size, EDGE) else f"{round(block.size * 100, 2):g} cm "


def phrase(operand: Operand | str, world: World) -> str:
    """A noun phrase for one or several objects."""
    if isinstance(operand, Highest):
        return f"the top of the tower of {phrase(operand.highest, world)}"
    if isinstance(operand, Lowest):
        return f"the tower of {phrase(operand.lowest, world)}"
    chosen: dict[str, int] = {}
    for name in members(operand):
        noun = bare(name, world)
        chosen[noun] = chosen.get(noun, 0) + 1
    return join([_counted(noun, count, world) for noun, count in chosen.items()])


def _counted(noun: str, count: int, world: World) -> str:
    there = sum(bare(name, world) == noun for name in world.assets)
    if there == count:
        return f"the {noun}" if count == 1 else f"{'both' if count == 2 else f'all {number(count)}'} {noun}s"
    return f"a {noun}" if count == 1 else f"{number(count)} {noun}s"


def verb(operand: Operand | str, one: str = "is", many: str = "are") -> str:
    """The verb's form that agrees with an operand."""
    return one if isinstance(operand, Lowest | Highest) or len(members(operand)) == 1 else many
