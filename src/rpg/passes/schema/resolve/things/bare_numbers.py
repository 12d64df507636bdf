"""A bare number where blocks were counted that nothing else is said of: so many of them, or a block that shows it?"""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Absolute, Chain, Noun, Traits, parts_of
from rpg.passes.schema.resolve.things.world import Scene, refuse

_LAYERED = frozenset({"pyramid", "wall", "staircase", "cube"})
"""Of these it is told how many blocks each layer has."""
_MOST = 9


def check_bare_numbers(goal: g.Goal, scene: Scene, chains: tuple[Chain, ...]) -> None:
    """Refuse "there are five red cubes; 2 must be on the mat", where the five would only lie around, and "a row with 2
    on the left", where nothing else shows a symbol."""
    told = set(names_in(goal)) | {n for x in scene.start_goals for n in names_in(x)}
    told |= scene.spare | {n for heap in scene.heaps for n in heap}
    there = [x for x in scene.things.values() if x.declared]
    idle = [x for x in there if x.name not in told and not (x.patch or x.extra or x.label)]
    shown = {x.label for x in there}
    layered = any(
        built.kind in _LAYERED and not any(n in scene.things and scene.things[n].label for n in built.members)
        for built in scene.built
    )
    parts = [part for chain in chains for part in parts_of(chain)]
    lone = [x.theme for x in parts if isinstance(x, Absolute)] if _one_symbol(scene) else []
    for part in (part for part in parts if isinstance(part, Noun)):
        many = _number(part)
        idly = (len(idle) > 1 or layered) and 0 < many <= (_MOST if layered else len(idle)) and str(many) not in shown
        if idly or (many > 0 and part in lone):
            number = part.traits.labels[0]
            raise refuse(
                "ambiguous",
                f"{number} could be a block that shows it, or so many of the blocks that were counted",
                part.span,
                f"say 'the number {number}', or '{number} of them'",
            )


def _one_symbol(scene: Scene) -> bool:
    """Whether there is one block with a symbol beside others that have none: "a row with 2 on the left"."""
    symbols = {x.label for x in scene.things.values() if not x.patch}
    return None in symbols and len(symbols) == 2


def _number(noun: Noun) -> int:
    """Which number a noun is that says no more than that; 0 where it says more."""
    mere = noun.det == "bare" and noun.head != "patch" and noun.amount is None and noun.part_of is None
    alone = mere and noun.traits == Traits(labels=noun.traits.labels) and len(noun.traits.labels) == 1
    return int(noun.traits.labels[0]) if alone and noun.traits.labels[0].isdigit() else 0
