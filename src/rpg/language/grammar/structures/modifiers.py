"""What may stand before the noun of a structure: words that shape it, and words that say how its blocks lie."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.meaning import Manner, OrderBy, Pattern, Spacing

MODIFIERS = {
    "straight": {}, "parallel": {"upright": False}, "layered": {}, "stepped": {}, "outline": {"filled": False},
    "horizontal": {"upright": False}, "vertical": {"upright": True}, "flat": {"upright": False},
    "filled": {"filled": True}, "solid": {"filled": True}, "compact": {"filled": True},
    "hollow": {"filled": False}, "outlined": {"filled": False},
    "simple": {}, "whole": {}, "entire": {}, "single": {}, "complete": {}, "perfect": {}, "nice": {}, "new": {},
    "upright": {"upright": True},
    "single file": {}, "standing": {"upright": True}, "closed": {}, "proper": {},
    "full": {"filled": True},
    "correct": {}, "subtraction": {}, "multiplication": {}, "division": {}, "neatly": {}, "regular": {}, "loose": {},
    "free standing": {}, "freestanding": {},
    "valid": {}, "true": {}, "math": {}, "mathematical": {}, "arithmetic": {},
    "addition": {}, "equilateral": {},
    "single digit": {}, "separate": {}, "separated": {}, "distinct": {}, "individual": {}, "neat": {},
}  # fmt: skip


EDGES = {"edges": True, "edge": True, "sides": True, "side": True, "size": True}


OPERATORS = {"addition": "+", "subtraction": "-", "multiplication": "*", "division": "/", "product": "*",
             "sum": "+"}  # fmt: skip


NOWHERE = (0, 0)


DETAILS: dict[str, OrderBy | Spacing | Manner | Pattern] = {
    "monochrome": Pattern(unit="stack", span=NOWHERE),
    "equally tall": Manner(kind="equal", span=NOWHERE), "equal": Manner(kind="equal", span=NOWHERE),
    "equally high": Manner(kind="equal", span=NOWHERE),
    **{word: Manner(kind="unequal", span=NOWHERE) for word in ("unequal", "differently tall", "differently high")},
    "alternating": OrderBy(by="alternating", span=NOWHERE), "symmetric": OrderBy(by="mirrored", span=NOWHERE),
    "mirror symmetric": OrderBy(by="mirrored", span=NOWHERE),
    "mirror symmetrical": OrderBy(by="mirrored", span=NOWHERE),
    "symmetrical": OrderBy(by="mirrored", span=NOWHERE), "mirrored": OrderBy(by="mirrored", span=NOWHERE),
    "reverse alphabetical": OrderBy(by="label", descending=True, span=NOWHERE),
    "ascending": OrderBy(by="ascending", span=NOWHERE),
    "descending": OrderBy(by="ascending", descending=True, span=NOWHERE),
    "alphabetical": OrderBy(by="label", span=NOWHERE), "alphabetically sorted": OrderBy(by="label", span=NOWHERE),
    "palindromic": OrderBy(by="mirrored", span=NOWHERE), "palindrome": OrderBy(by="mirrored", span=NOWHERE),
    **{
        f"{shade}{word}": OrderBy(by="rainbow", span=NOWHERE)
        for shade in ("", "color ", "rainbow ")
        for word in ("rainbow", "gradient")
    },
    "touching": Spacing(kind="touching", span=NOWHERE),
    "tight": Spacing(kind="touching", span=NOWHERE),
    "evenly spaced": Spacing(kind="even", span=NOWHERE), "equally spaced": Spacing(kind="even", span=NOWHERE),
    **{
        word: Spacing(kind="touching", span=NOWHERE)
        for word in ("gapless", "contiguous", "continuous", "unbroken", "uninterrupted", "seamless", "gap free")
    },
    "sorted": OrderBy(by="in_order", span=NOWHERE), "ordered": OrderBy(by="in_order", span=NOWHERE),
    "numerical": OrderBy(by="number", span=NOWHERE),
    **{
        word: Manner(kind="idle", value=f"size {word}", span=NOWHERE)
        for word in ("tall", "high", "long", "short", *lexicon.SIZE)
    },
}  # fmt: skip
