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
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.compose.clauses import Reader
from rpg.language.compose.in_time import check_in_time
from rpg.language.compose.items import PATCH, Item, items_of
from rpg.language.compose.scene import Unclear
from rpg.language.compose.syntax import Clause, Looks
from rpg.language.compose.telling import tell_all
from rpg.language.compose.ways import TooMany, readings
from rpg.language.frames.retelling import standing
from rpg.language.tokens import Token


def composed_ways(tokens: Sequence[Token]) -> Iterator[tuple[list[list[Token]], str]]:
    """The text in plain sentences, and the words of that, if all ways to read it come to the same; and where it may be
    had in several ways, the text of each of them."""
    told = _all_told(tokens)
    for text, ways in told.items() if len(told) == 1 else ():
        yield [standing(text, tokens)], text
        if len(ways) > 1:
            yield [standing(way, tokens) for way in ways], text


def meanings(tokens: Sequence[Token]) -> list[str]:
    """All that a text can mean, each in plain sentences."""
    return list(_all_told(tokens))


def _all_told(tokens: Sequence[Token]) -> dict[str, list[str]]:
    items = items_of(tokens)
    return (_told(items) or _told(_told_last(items), ahead=True)) if items else {}


def _told(items: Sequence[Item], *, ahead: bool = False) -> dict[str, list[str]]:
    """All meanings, and the ways to have each of them. `ahead`: what the first clause tells stood at the end of the
    text, where only what there is is told."""
    found: dict[str, list[str]] = {}
    try:
        for way, scenes in readings(Reader(items)) if items else ():
            if ahead and way[0].mood not in {"there", "seen", "start", "lies"} and not _defines(way[0]):
                continue
            with suppress(Unclear):
                check_in_time(way, scenes[0].begun)
                text, ways = tell_all(scenes)
                found[text] = ways
    except TooMany:
        return {}
    return found


def _told_last(items: Sequence[Item]) -> list[Item]:
    """The last sentence ahead of all others; nothing where there is only one."""
    stops = [n for n, item in enumerate(items[:-1]) if item.text in {".", ";", "?"}]
    if not stops:
        return []
    last = [item for item in items[stops[-1] + 1 :] if item.text not in {".", "!"}]
    if any(item.text == "block" for item in items) and not any(item.text in PATCH for item in items):
        ones = [item.text == "one" and n > 0 and last[n - 1].text in lexicon.COLOR for n, item in enumerate(last)]
        last = [replace(item, text="block", number=0) if one else item for item, one in zip(last, ones, strict=True)]
    return [*last, items[stops[-1]], *items[: stops[-1]]]


def _defines(clause: Clause) -> bool:
    """Whether it tells what things look like that are spoken of: "the two towers are red on blue and green on red"."""
    return bool(clause.predicates) and all(isinstance(said, Looks) for said in clause.predicates)
