"""What blocks are told apart by: colour, kind, symbol, vowel or consonant, odd or even, edge."""

from __future__ import annotations

from collections.abc import Mapping

from rpg.blocks.state import BlockState, Vec3, World
from rpg.blocks.visibility import reads
from rpg.ir.assets import SemanticCube
from rpg.ir.order import Attribute

GRADIENT = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink")
"""The colours of a gradient or rainbow, in order."""
VOWELS = frozenset("AEIOU")
QUALITIES = {"vowel": "AEIOU", "consonant": "BCDFGHJKLMNPQRSTVWXYZ", "even": "24680", "odd": "13579"}
"""What symbols are called together, and which these are, in the order in which they are chosen."""
UP: Vec3 = (0.0, 0.0, 1.0)
AWAY: Vec3 = (1.0, 0.0, 0.0)
TO_VIEWER: Vec3 = (-1.0, 0.0, 0.0)

Trait = str | float


def symbol_of(world: World, name: str) -> str:
    """The symbol a block shows on all of its faces, or on top as it is made; empty for plain blocks."""
    block = world.blocks[name]
    return block.label or block.symbol("top") if isinstance(block, SemanticCube) else ""


def symbols_shown(state: BlockState, names: tuple[str, ...], normal: Vec3) -> dict[str, str]:
    """The symbol each block shows towards `normal`, where it differs from face to face."""
    blocks = state.world.blocks
    found = {}
    for name in names:
        block = blocks[name]
        if isinstance(block, SemanticCube) and block.labels is not None:
            found[name] = reads(state, name, normal, None)[0]
    return found


def symbols_of(quality: str) -> str:
    """The symbols of a quality, which names them together or lists them: "odd", "789"."""
    return QUALITIES.get(quality, quality)


def kind_of(symbol: str) -> str:
    """Letter, digit, sign or plain."""
    if not symbol:
        return "plain"
    return "letter" if symbol.isalpha() else "digit" if symbol.isdigit() else "sign"


class Traits:
    """The attributes of blocks; `shown` has the symbols of those that show different ones on different faces."""

    def __init__(self, world: World, shown: Mapping[str, str] | None = None) -> None:
        self.world = world
        self.shown = shown or {}

    def symbol(self, name: str) -> str:
        """The symbol that is read on a block; empty for plain ones."""
        shown = self.shown.get(name)
        return symbol_of(self.world, name) if shown is None else shown

    def of(self, name: str, attribute: Attribute) -> Trait:
        """The value of `attribute`; for vowels and parity, blocks that are neither have their kind."""
        if attribute == "color":
            return self.world.blocks[name].color
        if attribute == "size":
            return self.world.edge[name]
        symbol = self.symbol(name)
        if attribute == "label":
            return symbol
        if attribute == "vowel" and symbol.isalpha():
            return "vowel" if symbol in VOWELS else "consonant"
        if attribute == "parity" and symbol.isdigit():
            return "odd" if int(symbol) % 2 else "even"
        return kind_of(symbol)

    def by_value(self, names: tuple[str, ...], attribute: Attribute) -> dict[Trait, list[str]]:
        """The blocks of each value, in order of first mention."""
        found: dict[Trait, list[str]] = {}
        for name in names:
            found.setdefault(self.of(name, attribute), []).append(name)
        return found
