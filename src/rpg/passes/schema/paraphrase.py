"""Paraphrases V: other texts for a task, each of which was read back and asks for the same."""

from __future__ import annotations

import re
from collections.abc import Callable

from rpg.blocks.english.variants import variants
from rpg.blocks.equivalence import equivalent
from rpg.ir.schema import TaskSchema

WANTED = 6
TRIES = 16
"""Texts tried for one task: reading them back is most of the cost."""

Reader = Callable[[str], TaskSchema | None]


def paraphrases(schema: TaskSchema, read: Reader, wanted: int = WANTED) -> tuple[str, ...]:
    """At most `wanted` texts unlike the instruction and each other that `read` takes for the same task."""
    found: list[str] = []
    seen = {_words(schema.instruction)}
    for tried, text in enumerate(variants(schema)):
        if len(found) == wanted or tried == TRIES:
            break
        if _words(text) in seen:
            continue
        seen.add(_words(text))
        other = read(text)
        if other is not None and equivalent(schema, other):
            found.append(text)
    return tuple(found)


def _words(text: str) -> tuple[str, ...]:
    return tuple(re.findall(r"\w+|[-+*/=×÷]", text.lower()))
