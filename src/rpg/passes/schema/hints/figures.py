"""Things that people wish for by their name, of which nobody knows here how their blocks stand: what to say instead."""

from __future__ import annotations

import re

from rpg.passes.schema.hints.wish import Wish

_UNLAID = "ABCDEFGHIJKMNOPQRSWYZ"
_LAID = "T, L, U, V and X"
FIGURES = (
    Wish(
        re.compile(r"\bflags?\b", re.I),
        "no flag is known here, nor in which order its colours come",
        "say its colours in their order, as in 'put a blue, a white and a red cube in a row from left to right in this "
        "order'",
    ),
    Wish(
        re.compile(r"\b(?:bowling|ten) ?pins?\b|\bbowling\b", re.I),
        "it is not known how pins stand",
        "say which figure they form, as in 'make a filled triangle of six cubes pointing to the front'",
    ),
    Wish(
        re.compile(r"\bon (?:a|the) (?:die|dice)\b|\b(?:die|dice) face\b", re.I),
        "it is not known how the dots of a die lie",
        "say which figure they form, as in 'make an X from five blocks'",
    ),
    Wish(
        re.compile(r"\bpalindromes?\b.*\bletters?\b|\bletters?\b.*\bpalindromes?\b", re.I),
        "it is not said which letters there are",
        "say the word, as in 'spell LEVEL'",
    ),
    Wish(
        re.compile(r"\b(?:each|every) row and (?:each|every) column\b|\bsudoku\b|\blatin square\b", re.I),
        "what all rows and all columns have in common cannot be said at once",
        "say what each row is, as in 'make a 3x3 grid: the far row red, green, blue, the middle row green, blue, red, "
        "the near row blue, red, green'",
    ),
    Wish(
        re.compile(r"\b(?:house|roof|hut|church)\b", re.I),
        "it is not known how the blocks of a house stand",
        "say where each lies, as in 'make a 2x2 square of red blocks and put a blue block on top in the center'",
    ),
    Wish(
        re.compile(r"\b(?:gaps?|space|room)\b.* (?:big|large|wide) enough for\b", re.I),
        "a gap is told in centimetres, and a cube measures 4 of them",
        "say for example 'put five blocks in a row with gaps of 4 cm between them'",
    ),
    Wish(
        re.compile(rf"\b(?:letter|shape of an?|shape of the letter) [{_UNLAID}]\b(?! (?:block|cube|on\b))"),
        f"blocks are laid out as {_LAID}, and as no other letter",
        "say for example 'make the letter T from five blocks', or 'put the block A on the patch' for a block that "
        "shows a letter",
    ),
)
