"""Sentences that place things to each other: "the tower of two red blocks has the K behind it and ...".

Those that could be meant in two ways ("the row" where two were named) are not made.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection

from tests.madeup.chance import Chance
from tests.madeup.scenes import OPPOSITE, SIDES, MadeUp, Placed, told
from tests.madeup.things import Thing, any_base, any_thing, one, patch, row, tower

TO = {
    "left": ("to the left of", "left of", "on the left of"), "right": ("to the right of", "right of"),
    "behind": ("behind",), "front": ("in front of",), "on": ("on top of", "on"),
}  # fmt: skip
OF_IT = {
    "left": ("to its left", "on its left", "to the left of it"), "right": ("to its right", "to the right of it"),
    "behind": ("behind it",), "front": ("in front of it",), "on": ("on it", "on top of it"),
}  # fmt: skip
Tree = tuple[str, Thing, tuple[Placed, ...]]
"""A sentence, what is in the middle of its scene, and what is placed one after the other."""
_SHOWN = re.compile(r"\bhas the (?:letter )?[A-Z](?: block| cube)? on it")
"""What is had so may be a block, or what is printed on one."""
_KINDS = {"row": ("the row", "the line"), "tower": ("the tower", "the stack"), "grid": ("the grid", "the square")}


def related(chance: Chance) -> MadeUp | None:
    """A sentence with two or three things, or None where it would be ambiguous or have no room."""
    frame = chance.of(*_FRAMES)
    found = frame(chance)
    if found is None:
        return None
    text, root, placed = found
    shapes = [root.shape, *(x.thing.shape for x in placed)]
    if _SHOWN.search(text) or any(
        shapes.count(kind) > 1 and any(name in text for name in names) for kind, names in _KINDS.items()
    ):
        return None
    return told(chance.start(text), root, *placed) if shapes.count("patch") < 2 else None


def _free(mark: Thing, thing: Thing, taken: Collection[str] = ()) -> list[str]:
    """Where something may be placed to another."""
    on = thing.shape in ("one", "tower") and mark.shape in ("one", "tower", "patch")
    return [side for side in (*SIDES, *(("on", "on") if on else ())) if side not in taken]


def _to(side: str, mark: str, chance: Chance) -> str:
    return f"{chance.of(*TO[side])} {mark}"


def _pair(chance: Chance) -> tuple[Thing, str, Thing]:
    """One thing, its side, and what it is placed to."""
    base = any_base(chance)
    thing = chance.of(one, tower)(chance) if base.shape == "patch" else any_thing(chance)
    return thing, chance.of(*_free(base, thing)), base


def _three(chance: Chance) -> tuple[Thing, str, Thing, Thing, str] | None:
    """Two things, each at a side of the same."""
    thing, side, base = _pair(chance)
    third = one(chance)
    free = _free(base, third, (side,))
    return (thing, side, base, third, chance.of(*free)) if free else None


def _put(chance: Chance) -> Tree:
    thing, side, base = _pair(chance)
    return f"{chance.put} {thing.phrase} {_to(side, base.phrase, chance)}", base, (Placed(thing, side, base),)


def _stated(chance: Chance) -> Tree:
    thing, side, base = _pair(chance)
    text = f"{thing.phrase} {chance.must_be} {_to(side, base.phrase, chance)}"
    return text, base, (Placed(thing, side, base),)


def _place_first(chance: Chance) -> Tree:
    thing, side, base = _pair(chance)
    is_there = chance.of("there is", "there should be", "stands")
    return f"{_to(side, base.phrase, chance)} {is_there} {thing.phrase}", base, (Placed(thing, side, base),)


def _built_first(chance: Chance) -> Tree | None:
    thing, side, base = _pair(chance)
    if base.shape in ("one", "patch"):
        return None
    then = chance.of(", then ", ". Then ", ". ", " and ")
    text = f"build {base.phrase}{then}{'Put' if then == '. ' else 'put'} {thing.phrase} {chance.of(*OF_IT[side])}"
    return text, base, (Placed(thing, side, base),)


def _with_two(say: Callable[[Thing, str, Thing, Thing, str, Chance], str]) -> Callable[[Chance], Tree | None]:
    """A frame of two things that are each at a side of the same."""

    def frame(chance: Chance) -> Tree | None:
        found = _three(chance)
        if found is None:
            return None
        thing, side, base, third, other = found
        text = say(thing, side, base, third, other, chance)
        return text, base, (Placed(thing, side, base), Placed(third, other, base))

    return frame


def _put_and(a: Thing, side: str, base: Thing, c: Thing, other: str, chance: Chance) -> str:
    first = f"{chance.put} {a.phrase} {_to(side, base.phrase, chance)}"
    return f"{first} and {c.phrase} {_to(other, chance.of(*base.again), chance)}"


def _has(a: Thing, side: str, base: Thing, c: Thing, other: str, chance: Chance) -> str:
    return f"{base.phrase} has {a.phrase} {chance.of(*OF_IT[side])} and {c.phrase} {chance.of(*OF_IT[other])}"


def _which_has(a: Thing, side: str, base: Thing, c: Thing, other: str, chance: Chance) -> str:
    first = f"{chance.put} {a.phrase} {_to(side, base.phrase, chance)}"
    return f"{first}, which has {c.phrase} {chance.of(*OF_IT[other])}"


def _two_sentences(a: Thing, side: str, base: Thing, c: Thing, other: str, chance: Chance) -> str:
    first = f"{chance.put} {a.phrase} {_to(side, base.phrase, chance)}"
    return f"{first}. {c.phrase} {chance.must_be} {_to(other, chance.of(*base.again), chance)}."


def _wished(a: Thing, side: str, base: Thing, c: Thing, other: str, chance: Chance) -> str:
    wish = chance.of("I want", "I would like", "I need", "we want to see", "the goal:")
    first = f"{wish} {a.phrase} {_to(side, base.phrase, chance)}"
    joint = "," if wish == "the goal:" else " and"
    return f"{first}{joint} {c.phrase} {_to(other, chance.of(*base.again), chance)}"


def _one_by_one(chance: Chance) -> Tree | None:
    thing, side, base = _pair(chance)
    third = one(chance)
    free = _free(thing, third, (side, OPPOSITE.get(side, side)))
    if not free or base.shape == "patch":
        return None
    other = chance.of(*free)
    first = f"{chance.put} {thing.phrase} {_to(side, base.phrase, chance)}"
    text = f"{first}, and {third.phrase} {_to(other, chance.of(*thing.again), chance)}"
    return text, base, (Placed(thing, side, base), Placed(third, other, thing))


def _between(chance: Chance) -> Tree:
    thing, first, second = chance.of(one, tower)(chance), one(chance), one(chance)
    side = chance.of("left", "behind")
    text = f"{thing.phrase} {chance.must_be} between {first.phrase} and {second.phrase}"
    return text, thing, (Placed(first, side, thing), Placed(second, OPPOSITE[side], thing))


def _part(chance: Chance) -> Tree:
    """Something at a part of a row or a tower."""
    base = chance.of(row, row, tower)(chance)
    name, cell = chance.of(*(base.parts or (("the top of", None),)))
    thing = chance.of(one, one, tower)(chance)
    on = () if " end" in name else ("on", "on")  # "on the left end of a row" may be at its end
    side = chance.of("behind", "front", *on) if cell is not None else "on"
    where = _to(side, f"{name} {base.phrase}", chance)
    text = chance.of(
        f"{chance.put} {thing.phrase} {where}", f"{thing.phrase} {chance.must_be} {where}",
        f"build {base.phrase}. Put {thing.phrase} {_to(side, name, chance)} {chance.of(*base.again)}.",
    )  # fmt: skip
    return text, base, (Placed(thing, side, base, cell),)


def _part_has(chance: Chance) -> Tree:
    """A part of a row that has two things."""
    base = row(chance)
    name, cell = chance.of(*base.parts)
    thing, third = chance.of(one, tower)(chance), one(chance)
    side, other = chance.of(("on", "behind"), ("on", "front"), ("behind", "front"), ("front", "on"))
    text = f"{name} {base.phrase} has {thing.phrase} {chance.of(*OF_IT[side])} and {third.phrase} {OF_IT[other][0]}"
    return text, base, (Placed(thing, side, base, cell), Placed(third, other, base, cell))


def _on_patch(chance: Chance) -> Tree:
    base, thing = patch(chance), chance.of(one, tower)(chance)
    text = f"{thing.phrase} {chance.of('goes', 'belongs', 'must be', 'is')} on {base.phrase}"
    return text, base, (Placed(thing, "on", base),)


_FRAMES: tuple[Callable[[Chance], Tree | None], ...] = (
    _put, _stated, _place_first, _built_first, _one_by_one, _between, _part, _part_has, _on_patch,
    *map(_with_two, (_put_and, _has, _which_has, _two_sentences, _wished)),
)  # fmt: skip
