"""What objects are called: "red block", "A block", "5 cm green block", "blue patch"; small numbers and lists."""

from __future__ import annotations

import math

from rpg.blocks.state import World
from rpg.ir.assets import EDGE, FACES, Block, GoalPatch, SemanticCube

NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
SIGNS = {"+": "plus", "-": "minus", "*": "times", "/": "divide", "=": "equals"}


def number(count: int) -> str:
    """A small number in words, a larger one in digits."""
    return NUMBERS[count] if count < len(NUMBERS) else str(count)


def article(noun: str) -> str:
    """ "a" or "an"; letters by their names, and an 8."""
    vowel = noun[0] in "aeio8" or (len(noun.split()[0]) == 1 and noun[0] in "AEFHILMNORSX")
    return "an" if vowel else "a"


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
    shown = block.label or "/".join(dict.fromkeys(filter(None, (block.symbol(face) for face in FACES))))
    return color + shown


def _size(block: Block) -> str:
    return "" if math.isclose(block.size, EDGE) else f"{round(block.size * 100, 2):g} cm "
