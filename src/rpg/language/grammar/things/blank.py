"""Blocks that show nothing: "all the cubes that have nothing printed on them", "blocks without any symbol"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Traits

_ON = "on_it|on_them"
_DONE = "printed|written|painted|drawn|shown"
_SIGNS = "symbol|symbols|sign|signs|print|marking|markings|inscription|text"
_NOTHING = Patterns(
    f"that|which? has|have|having|with nothing {_DONE} {_ON}",
    "that|which show|shows|display|displays nothing",
    f"without|with_no any|a|an? {_SIGNS} {_DONE}? {_ON}?",
    f"without anything {_DONE} {_ON}",
    f"that|which have|has|show|shows|bear|bears|carry|carries no {_SIGNS} {_DONE}? {_ON}?",
)


@choice
def blank(p: Parser, i: int) -> Results[Traits]:
    """What is said of plain blocks, which show no symbol."""
    if j := max(_NOTHING.matches(p, i), default=0):
        yield Traits(kind="plain"), j
