"""Which blocks and patches of a task a look of the corpus stands for."""

from __future__ import annotations

import re
from itertools import permutations

from rpg.ir.assets import EDGE, Block, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.schema import TaskSchema

RAINBOW = ["red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white"]
OPEN = ("letter", "digit", "plain", "any")
"""Looks that leave something open, the more telling ones first."""


class Mismatch(Exception):
    """The task has not the blocks that an entry expects."""


class Binding:
    """The blocks and patches of `schema` by the looks that an entry's `assets` name; each belongs to one look."""

    def __init__(self, schema: TaskSchema, expected: dict[str, int | str] | None) -> None:
        self.schema = schema
        self.expected = {str(look): str(count) for look, count in (expected or {}).items()}
        self._free = list(schema.blocks)
        self.members: dict[str, list[str]] = {}
        colours = [look for look in self.expected if re.fullmatch(r"c\d", look)]
        named = [look for look in self.expected if look not in OPEN and look not in colours and not _is_patch(look)]
        for look in named:
            self._claim(look)
        self._claim_colours(colours)
        for look in OPEN:
            if look in self.expected:
                self._claim(look)

    def check(self) -> None:
        """Raise Mismatch unless the task has exactly the expected assets."""
        if not self.expected:
            return
        for look, count in self.expected.items():
            found = len(self.patches(look)) if _is_patch(look) else len(self.members[look])
            low = int(count.removeprefix(">="))
            if found < low or (found > low and not count.startswith(">=")):
                raise Mismatch(f"{look}: {found} instead of {count}")
        if self._free:
            raise Mismatch(f"not called for: {', '.join(b.name for b in self._free)}")
        wanted = [count for look, count in self.expected.items() if _is_patch(look)]
        total = sum(int(count.removeprefix(">=")) for count in wanted)
        loose = any(look in OPEN or re.fullmatch(r"c\d", look) for look in self.expected) and not wanted
        if len(self.schema.patches) != total and not loose and not any(">" in count for count in wanted):
            raise Mismatch(f"{len(self.schema.patches)} patches instead of {total}")

    def blocks(self, look: str) -> list[str]:
        """Names of the blocks of that look, in the order in which a picture takes them."""
        if look in self.members:
            return self.members[look]
        if re.fullmatch(r"c\d", look):
            self._claim_colours([look])
            return self.members[look]
        return [b.name for b in _sorted(look, [b for b in self.schema.blocks if _matches(look, b)])]

    def patches(self, look: str) -> list[GoalPatch]:
        """The patches of that look."""
        stem, _, trait = look.rstrip("}").partition("{")
        colour = stem.removesuffix("patch").rstrip("_")
        if re.fullmatch(r"c\d", colour):
            names = self.blocks(colour)
            colour = next(b.color for b in self.schema.blocks if b.name == names[0])
        found = [p for p in self.schema.patches if colour in ("", p.color)]
        if trait == "long":
            return [p for p in found if max(p.size) >= 2 * min(p.size) - 1e-9]
        return [p for p in found if trait in ("", p.shape)]

    def _claim(self, look: str) -> None:
        mine = [b for b in self._free if _matches(look, b)]
        self.members[look] = [b.name for b in _sorted(look, mine)]
        self._free = [b for b in self._free if b not in mine]

    def _of_open_looks(self) -> list[ColoredCube]:
        """Blocks counted as "plain" or "any" that no colour left open stands for yet."""
        counted = {n for look in OPEN for n in self.members.get(look, ())}
        taken = {n for look, names in self.members.items() if re.fullmatch(r"c\d", look) for n in names}
        return [b for b in self.schema.blocks if isinstance(b, ColoredCube) and b.name in counted - taken]

    def _claim_colours(self, looks: list[str]) -> None:
        if not looks:
            return
        plain = [b for b in self._free if isinstance(b, ColoredCube)] or self._of_open_looks()
        colours = sorted({b.color for b in plain}, key=RAINBOW.index)
        counts = {c: sum(b.color == c for b in plain) for c in colours}
        for chosen in permutations(colours, len(looks)):
            if all(
                str(counts[c]) == self.expected.get(look, str(counts[c])) for look, c in zip(looks, chosen, strict=True)
            ):
                break
        else:
            raise Mismatch(f"colours {counts} where {len(looks)} were expected")
        for look, colour in zip(looks, chosen, strict=True):
            self.members[look] = [b.name for b in plain if b.color == colour]
        self._free = [b for b in self._free if not (isinstance(b, ColoredCube) and b.color in chosen)]


def _is_patch(look: str) -> bool:
    return "patch" in look


def _sorted(look: str, blocks: list[Block]) -> list[Block]:
    if look == "plain":
        return sorted(blocks, key=lambda b: RAINBOW.index(b.color))
    if look in ("letter", "digit"):
        return sorted(blocks, key=_symbol)
    return blocks


def _symbol(block: Block) -> str:
    return block.symbol("top") if isinstance(block, SemanticCube) else ""


def _matches(look: str, block: Block) -> bool:
    stem, _, size = look.rstrip("}").partition("{")
    if not _fits(size, block.size, open_size=stem in OPEN):
        return False
    symbol = _symbol(block)
    colour, _, label = stem.rpartition(":")
    if colour:
        return block.color == colour and symbol == label
    match stem:
        case "any":
            return True
        case "plain":
            return isinstance(block, ColoredCube)
        case "letter":
            return symbol.isalpha()
        case "digit":
            return symbol.isdigit()
    if stem in RAINBOW:
        return isinstance(block, ColoredCube) and block.color == stem
    return isinstance(block, SemanticCube) and symbol == stem and block.color == "ivory"


def _fits(size: str, edge: float, *, open_size: bool) -> bool:
    match size:
        case "":
            return open_size or abs(edge - EDGE) < 1e-6
        case "big":
            return edge > EDGE + 1e-6
        case "small":
            return edge < EDGE - 1e-6
    return abs(edge - float(size) / 100) < 1e-6
