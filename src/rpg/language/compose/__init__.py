"""A third reader: noun phrases, places and clauses with a meaning each, put together in any way.

The grammar and the families read what they know. What both refuse is parsed here by a small grammar in which every
rule is general: any noun phrase may stand wherever one fits (`phrases`, `clauses`). What a way to read the text means
is worked out against a scene of blocks, figures and patches (`nouns`, `statements`), which is then told in plain
sentences (`telling`) that the grammar reads and everything behind it checks. Every word has to be read, and all ways
to read a text that make sense have to come to the same sentences; else there is no reading.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from rpg.language.compose.clauses import Reader
from rpg.language.compose.in_time import check_in_time
from rpg.language.compose.items import items_of
from rpg.language.compose.scene import Unclear
from rpg.language.compose.telling import tell_all
from rpg.language.compose.ways import TooMany, readings
from rpg.language.frames.retelling import standing
from rpg.language.tokens import Token


def composed(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text in plain sentences, and the words of that, if all ways to read it come to the same."""
    told = meanings(tokens)
    if len(told) == 1:
        yield standing(told[0], tokens), told[0]


def meanings(tokens: Sequence[Token]) -> list[str]:
    """All that a text can mean, each in plain sentences."""
    items = items_of(tokens)
    if not items:
        return []
    found: dict[str, None] = {}
    try:
        for way, scenes in readings(Reader(items)):
            with suppress(Unclear):
                check_in_time(way)
                found[tell_all(scenes)] = None
    except TooMany:
        return []
    return list(found)
