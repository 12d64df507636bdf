"""What patches are called in more words than one: "goal region", "target position", "drop-off area"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser

_AIMED = frozenset({"goal", "target"})
_PLACES = {
    word: word.endswith("s")
    for place in ("region", "position", "location", "place", "site")
    for word in (place, f"{place}s")
}
_FOR_WHAT = ("drop off", "dropoff", "drop", "delivery", "landing", "docking", "parking", "storage", "loading",
             "unloading", "charging", "assembly", "marked", "painted", "floor")  # fmt: skip
_REGION = {
    word: word.endswith("s")
    for place in (
        "region",
        "location",
        "sector",
        "station",
        "slot",
        "bay",
        "section",
        "compartment",
        "dock",
        "container",
    )
    for word in (place, f"{place}s")
}
"""Patches where a colour stands in front of them."""


def patch_noun(p: Parser, i: int) -> tuple[int, bool]:
    """The position behind the word for a patch that stands here, and whether it is a plural; else `i`."""
    start = p.any_of(i, _FOR_WHAT) or i
    j, plural = start, False
    while (found := p.lex(j, lexicon.PATCH)) is not None:
        j, plural = j + 1, found
    if j > start and p.stands(j - 1, _AIMED) and (place := p.lex(j, _PLACES)) is not None:
        return j + 1, place
    if j == i and p.follows(i, lexicon.COLOR) and (several := p.lex(i, _REGION)) is not None:
        return i + 1, several
    return (j, plural) if j > start else (i, False)
