"""Wishes that are often typed and cannot be read: what is wrong with them in their own words, and what works."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic

_VAGUE = frozenset({"incomplete", "misplaced-word", "no-goal", "unknown-word"})
"""Codes of refusals that do not know what was wished."""
_UNLAID = "ABCDEFGHIJKMNOPQRSWYZ"
_LAID = "T, L, U, V and X"


@dataclass(frozen=True)
class _Wish:
    """What a text has in it, the message, and a wording that works."""

    pattern: re.Pattern[str]
    message: str
    hint: str


_WISHES = (
    _Wish(
        re.compile(r"\bas (?:far|close|near)(?: \w+){0,2} as possible\b", re.I),
        "it is not said how far that is: what is possible depends on the table",
        "say a distance, as in 'put the red block at least 30 cm away from the blue block'",
    ),
    _Wish(
        re.compile(r"^(?!.*\d ?[-+*/=]).*\b(?:sum|equation|calculation) (?:that|which|with|whose)\b", re.I),
        "it is not said which numbers the equation is made of",
        "say all of it, as in 'make 4 + 6 = 10'",
    ),
    _Wish(
        re.compile(rf"\b(?:letter|shape of an?|shape of the letter) [{_UNLAID}]\b(?! (?:block|cube|on\b))"),
        f"blocks are laid out as {_LAID}, and as no other letter",
        "say for example 'make the letter T from five blocks', or 'put the block A on the patch' for a block that "
        "shows a letter",
    ),
)


def explained(text: str, found: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics of a refusal; one that only says that a word does not fit tells what is wrong with the wish."""
    if len(found) != 1 or found[0].code not in _VAGUE:
        return tuple(found)
    wish = next((wish for wish in _WISHES if wish.pattern.search(text)), None)
    if wish is None:
        return tuple(found)
    return (found[0].model_copy(update={"message": wish.message, "hint": wish.hint}),)
