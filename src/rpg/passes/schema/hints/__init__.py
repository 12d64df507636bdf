"""What is wrong with a wish that cannot be read, where a refusal only says that a word does not fit."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.core.diagnostics import Diagnostic
from rpg.passes.schema.hints.figures import FIGURES
from rpg.passes.schema.hints.places import PLACES
from rpg.passes.schema.hints.symbols import SYMBOLS, no_digit
from rpg.passes.schema.hints.unchecked import UNCHECKED
from rpg.passes.schema.hints.wish import Wish

_NAMED = re.compile(
    r"\b(?:make|build|create|form|construct|draw|assemble)(?: me| us)? (?:an? |the |my |some )?(?:\w+ )?(\w+)", re.I
)
"""What is to be made."""


def explained(text: str, found: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics of a refusal; one that only says that a word does not fit tells what is wrong with the wish."""
    codes = {one.code for one in found}
    wishes = (*SYMBOLS, *no_digit(text), *UNCHECKED, *PLACES, *FIGURES, *_thing(text, found)) if found else ()
    wish = next((wish for wish in wishes if wish.explains(text, codes)), None)
    return tuple(found) if wish is None else (found[0].model_copy(update={"message": wish.message, "hint": wish.hint}),)


def _thing(text: str, found: Sequence[Diagnostic]) -> tuple[Wish, ...]:
    """ "Make a house": of what is to be made nobody knows how its blocks stand."""
    named, span = _NAMED.search(text), found[0].span
    if found[0].code != "unknown-word" or span is None or named is None or not named.start() < span[0] < named.end():
        return ()
    word = text[span[0] : span[1]]
    message = f"it is not known how the blocks of a {word!r} stand"
    return (Wish(named.re, message, f"say it behind a colon, as in 'build a {word}: a red block on a blue block'"),)
