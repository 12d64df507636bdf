"""Words with their classes: what the rules of the compositional reader ask of a token."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.tokens import Token

_FIGURES = {
    "tower": "tower stack skyscraper pillar pair", "row": "row", "line": "line", "column": "column", "grid": "grid",
    "wall": "wall", "pyramid": "pyramid", "staircase": "staircase stairs stairway", "square": "square",
    "plus": "plus cross", "circle": "circle ring", "triangle": "triangle", "word": "word",
    "group": "group cluster bunch", "equation": "equation sum", "cube": "", "L": "", "T": "", "V": "", "U": "",
}  # fmt: skip
_PARTS = {
    "end": "end", "corner": "corner", "middle": "middle center centre", "top": "top", "bottom": "bottom base foot",
    "step": "step", "arm": "arm", "layer": "layer", "side": "side", "half": "half",
    "point": "point tip apex",
}  # fmt: skip
FIGURE = {word: kind for kind, words in _FIGURES.items() for word in words.split()}
PART = {word: kind for kind, words in _PARTS.items() for word in words.split()}
FIGURES, PARTS = frozenset(_FIGURES), frozenset(_PARTS)
_BLOCK = frozenset(f"{lexicon.BLOCK_NOUNS} object piece item".split())
PATCH = frozenset(lexicon.PATCH_NOUNS.split())
TABLE = frozenset(lexicon.TABLE_NOUNS.split())
SYMBOL = {
    "letter": "letter", "digit": "digit", "number": "digit", "numeral": "digit", "vowel": "vowel",
    "consonant": "consonant",
}  # fmt: skip
SYMBOL_KINDS = frozenset({*SYMBOL.values(), "even", "odd"})
RANK = {
    "left": "left", "leftmost": "left", "right": "right", "rightmost": "right", "far": "far", "back": "far",
    "rear": "far", "farther": "far", "nearest": "near", "farthest": "far", "furthest": "far",
    "near": "near", "nearer": "near", "front": "near", "closer": "near",
    "top": "top", "topmost": "top", "upper": "top", "highest": "top", "bottom": "bottom", "lower": "bottom",
    "lowest": "bottom", "middle": "middle", "central": "middle", "center": "middle", "centre": "middle",
    "inner": "middle", "outer": "outer", "tall": "tall", "taller": "tall", "tallest": "tall", "higher": "tall",
    "big": "big", "bigger": "big", "biggest": "big", "large": "big", "larger": "big", "largest": "big",
    "long": "tall", "longer": "tall", "longest": "tall", "short": "short", "shorter": "short", "shortest": "short",
    "small": "small", "smaller": "small", "smallest": "small", "little": "small", "last": "last",
    "corner": "corner", "end": "end", "former": "former", "latter": "latter", "hollow": "hollow",
    "filled": "full", "full": "full",
}  # fmt: skip
IDLE = frozenset({
    "please", "kindly", "simply", "also", "itself", "themselves", "thanks", "thx", "ok", "okay", "well",
    "actually", "precisely", "pls",
})  # fmt: skip
_PLAIN = frozenset({
    "single", "lone", "plain", "simple", "own", "whole", "entire", "individual", "separate",
})  # fmt: skip


def shows(label: str, kind: str) -> bool:
    """Whether a symbol is a letter, a vowel, a consonant, a digit, an even or an odd one."""
    if kind in {"even", "odd"}:
        return label.isdigit() and int(label) % 2 == (kind == "odd")
    if kind in {"letter", "digit"}:
        return label.isalpha() if kind == "letter" else label.isdigit()
    return label.isalpha() and (label in "AEIOU") == (kind == "vowel")


@dataclass(frozen=True, slots=True)
class Item:
    """A word: `text` in lower case, in the singular where it is a noun, "block" for any word for one.

    `many`: it is a plural; `number`: the one that it says; `value`: the word in quotes, or the size, that it is.
    """

    text: str
    raw: str
    many: bool = False
    number: int = 0
    value: str = ""


def items_of(tokens: Sequence[Token]) -> list[Item] | None:
    """The words of a text without idle ones; None where a fraction or a numbered list is told, or where a
    digit could be a symbol or count blocks."""
    found: list[Item] = []
    for token in tokens:
        word = token.word.strip("'’")
        if token.kind in {"quote", "literal"}:
            found.append(Item(word, token.raw, value=str(token.value).upper()))
        elif token.kind == "dims" and isinstance(token.value, tuple):
            found.append(Item("dims", token.raw, value="x".join(str(n) for n in token.value)))
        elif token.kind == "equation":
            found.append(Item("equation", token.raw, value=str(token.value)))
        elif token.kind == "number":
            if not token.many and token.raw != "0":
                return None
            found.append(Item(word, token.raw, number=token.many))
        elif word in IDLE:
            continue
        elif token.kind == "punct":
            mark = {"(": ",", ")": ",", "-": ",", "–": ",", "—": ",", "&": "and"}.get(word, word)
            if mark == ";" and found and found[-1].text == ".":
                return None  # a numbered list tells an order
            if not (mark == "," and found and found[-1].text == ","):  # an idle word stood between two
                found.append(Item(mark, token.raw))
        else:
            found.append(_word(token, word))
    return None if _lone_digit(found) else _without_at_all(found)


def _without_at_all(items: list[Item]) -> list[Item]:
    """ "Do not move it at all" says no more than without these words."""
    texts = [item.text for item in items]
    at = next((n for n in range(len(texts)) if texts[n : n + 2] == ["at", "all"]), -1)
    if at < 0 or texts[at + 2 : at + 3] in (["time"], ["times"]) or not _DENIED & set(texts[:at]):
        return items
    return [*items[:at], *items[at + 2 :]]


_DENIED = frozenset({"not", "no", "never", "nothing", "none", "without"})


def _lone_digit(items: Sequence[Item]) -> bool:
    """ "Three blocks, 2 on the mat": the only digit by itself could be on a block, or count some of them."""
    bare = [n for n, item in enumerate(items) if item.raw.isdigit() and item.number]
    alone = [n for n in bare if n + 1 == len(items) or items[n + 1].text in _BEHIND_DIGIT]
    told = [n for n in alone if n and items[n - 1].text in _AHEAD_OF_DIGIT]
    return len(alone) == len(told) == 1


_AHEAD_OF_DIGIT = frozenset({",", "and", "with", "."})
_BEHIND_DIGIT = frozenset({"on", "in", "at", "to", "left", "right", "behind", "beside", "next", ",", ".", "and"})


def _word(token: Token, word: str) -> Item:
    """A word in the singular, if it is a noun that is known."""
    number = token.many
    if word in _PLAIN:
        return Item("plain", token.raw)
    for end, said in (("", ""), ("s", ""), ("es", ""), ("ies", "y")):
        base = word[: len(word) - len(end)] + said if word.endswith(end) else ""
        if base in _BLOCK:
            return Item("block", token.raw, many=bool(end))
        if base in FIGURE or base in PART or base in PATCH or base in SYMBOL or base == "one":
            return Item(base, token.raw, many=bool(end), number=number)
        if base in lexicon.COLOR and end:
            return Item(base, token.raw, many=True)
    return Item(word, token.raw, number=number)
