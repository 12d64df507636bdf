"""What is placed: blocks, rows, words, towers, grids and patches, each with how it is called."""

from __future__ import annotations

from dataclasses import dataclass

from tests.madeup.chance import NUMBERS, Chance, a

PITCH = 1.25
"""How far apart the cells of a picture are, in edges."""
_WORDS = ("DEB", "KED", "FED", "BED", "LED", "TEN", "PEN", "HEN", "MET")


@dataclass(frozen=True, eq=False)
class Thing:
    """`cells`: rows from far to near of cells from left to right, each a stack from bottom to top. `again`: how it is
    called where it is spoken of once more. `parts`: names of its parts, with the cell of each; None is the top."""

    cells: list[list[list[str]]]
    shape: str
    phrase: str
    again: list[str]
    parts: tuple[tuple[str, int | None], ...] = ()

    @property
    def depth(self) -> float:
        return (len(self.cells) - 1) * PITCH if self.shape != "patch" else 2.2

    @property
    def width(self) -> float:
        return (len(self.cells[0]) - 1) * PITCH if self.shape != "patch" else 2.2


def one(chance: Chance) -> Thing:
    """A block of a colour or with a letter."""
    if chance.often(0.3):
        (letter,) = chance.letters(1)
        phrase = chance.of(f"the {letter}", f"the letter {letter}", f"the {letter} {chance.block}")
        return Thing([[[letter]]], "one", phrase, [f"the {letter}"])
    (color,) = chance.colors(1)
    block = chance.block
    phrase = chance.of(f"{a(color)} {block}", f"the {color} {block}")
    return Thing([[[color]]], "one", phrase, [f"the {color} {block}", f"the {color} one"])


def row(chance: Chance) -> Thing:
    """A row of one colour, with its parts."""
    (color,), count, kind = chance.colors(1), chance.number(3, 4), chance.of("row", "line")
    parts: list[tuple[str, int | None]] = [
        ("the leftmost block of", 0), ("the rightmost block of", count - 1), ("the left end of", 0),
        ("the right end of", count - 1), ("the second block from the left of", 1),
        ("the first block from the left in", 0),
    ]  # fmt: skip
    parts += [("the middle block of", 1), ("the middle of", 1)] if count == 3 else []
    phrase = f"a {kind} of {NUMBERS[count]} {color} {chance.blocks}"
    return Thing([[[color] for _ in range(count)]], "row", phrase, [f"the {kind}", f"the {color} {kind}"], tuple(parts))


def ordered_row(chance: Chance) -> Thing:
    """A row of three in an order that is told."""
    looks = chance.looks(3)
    blocks = f" {chance.blocks}" if len(looks[0]) > 1 else ""
    phrase = chance.of(
        f"a row of {looks[0]}, {looks[1]} and {looks[2]}{blocks} from left to right",
        f"a row that is {', '.join(looks)} from left to right",
        f"the row {', '.join(looks)} (from left to right)",
    )
    return Thing([[[look] for look in looks]], "row", phrase, ["the row"])


def word(chance: Chance) -> Thing:
    """A word, or a block where no word is left."""
    spelled = chance.word(_WORDS)
    if spelled is None:
        return one(chance)
    return Thing([[[letter] for letter in spelled]], "row", f"the word {spelled}", ["the word"])


def tower(chance: Chance) -> Thing:
    """A tower of one colour, or of two blocks of which it is told which is on top."""
    kind = chance.of("tower", "stack")
    if chance.often(0.5):
        (color,), count = chance.colors(1), chance.number(2, 3)
        phrase = f"a {kind} of {NUMBERS[count]} {color} {chance.blocks}"
        tops = (("the top of", None), ("the top block of", None))
        return Thing([[[color] * count]], "tower", phrase, [f"the {kind}", f"the {color} {kind}"], tops)
    low, high = chance.colors(2)
    phrase = chance.of(
        f"a {kind} with {high} on {low}", f"a {kind} of {a(high)} {chance.block} on {a(low)} one",
        f"a {kind} of two, {high} on {low}",
    )  # fmt: skip
    return Thing([[[low, high]]], "tower", phrase, [f"the {kind}"])


def grid(chance: Chance) -> Thing:
    """Two rows of two."""
    (color,) = chance.colors(1)
    kind = chance.of("grid", "square")
    phrase = f"a {chance.of('two by two', '2x2')} {kind} of {color} {chance.blocks}"
    return Thing([[[color], [color]], [[color], [color]]], "grid", phrase, [f"the {kind}"])


def patch(chance: Chance) -> Thing:
    """A patch of the table."""
    (color,), kind = chance.colors(1), chance.of("mat", "patch")
    return Thing([[[f"{color}_patch"]]], "patch", f"the {color} {kind}", [f"the {color} {kind}", f"the {kind}"])


def any_thing(chance: Chance) -> Thing:
    """What may be placed."""
    return chance.of(one, one, row, ordered_row, word, tower, grid)(chance)


def any_base(chance: Chance) -> Thing:
    """What something may be placed to."""
    return chance.of(one, one, row, row, ordered_row, word, tower, tower, grid, patch)(chance)
