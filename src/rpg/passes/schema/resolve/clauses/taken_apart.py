"""What is taken apart: a pile, and no single block."""

from __future__ import annotations

from rpg.ir.node import members
from rpg.ir.relations import On
from rpg.ir.structures import Stack
from rpg.language.meaning import Meaning, Pronoun, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene


def pile_of(theme: Ref, said: Meaning | None, scene: Scene) -> Ref:
    """ "Blue starts on green and green starts on red. Take it apart": all of what one of them stands in, for a single
    block has no parts."""
    single = isinstance(said, Pronoun) and said.word == "it" and len(theme.names) == 1 and not theme.built
    if not single or theme.patch or theme.table:
        return theme
    lots = [
        {*x.blocks} if isinstance(x, Stack) else {*members(x.a), *members(x.b)}
        for x in scene.start_goals
        if isinstance(x, Stack | On)
    ]
    found = set(theme.names)
    while more := set[str]().union(*(lot for lot in lots if lot & found)) - found:
        found |= more
    return replace(theme, names=tuple(n for n in scene.things if n in found)) if len(found) > 1 else theme
