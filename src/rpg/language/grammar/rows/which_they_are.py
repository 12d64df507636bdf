"""Blocks told by what they are behind "that", and those that are not: "those that are vowels form a row, while the ones
that aren't are stacked", as rows that call them by it."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST

_ONES = "(?:the |all |all the )?(?:ones|those|cubes|blocks|letters|symbols)(?: of them)?"
_ONE = "the (?:one|cube|block|letter|symbol)"
_THAT = "(?:that|which|who)"
_DOES = (
    f"(?:{MUST}|are|form|make|build|go|get|be|lie|stand|sit|stay|remain|come|belong|stacked|placed|put|left|lined|in|on|"
    "next|beside|behind)"
)
WHICH_THEY_ARE: tuple[Turn, ...] = (
    (f"\\b{_ONES} {_THAT} (?:are|show|bear|carry|have|happen to be) (vowels|consonants)\\b(?: on them)?", "the {1}"),
    (f"\\b{_ONE} {_THAT} (?:is|shows|bears|carries|has) an? (vowel|consonant)\\b(?: on it)?", "the {1}"),
    (f"\\b{_ONES} {_THAT} (?:are|do|have) not(?=$| ,| {_DOES}\\b)", "the others"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
