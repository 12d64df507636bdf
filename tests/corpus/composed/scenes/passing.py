"""Relations as they are told in passing: in two sentences, of a picture, by what one block is for another, by
comparison, by counts, and those of structures."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

from tests.corpus.composed.scenes import wordings as w
from tests.corpus.composed.scenes.cells import Told
from tests.corpus.composed.scenes.special import Made, beside, made

_TO = {"left": "to the left of", "right": "to the right of", "front": "in front of", "behind": "behind"}
_ITS = {"left": "at its left", "right": "at its right", "front": "in front of it", "behind": "behind it"}
_BACK = {"left": "right", "right": "left", "front": "behind", "behind": "front"}
_FURTHER = {
    "left": ("further left than", "farther to the left than", "more to the left than"),
    "right": ("further right than", "further to the right than", "more to the right than"),
    "front": ("closer to the viewer than", "further to the front than", "nearer to the robot than"),
    "behind": ("further back than", "farther from the robot than", "farther away than", "further to the back than"),
}
Frames = tuple[tuple[str, list[Told]], ...]


def _drawn(rng: Random, name: str, frames: Frames, looks: dict[str, str]) -> Made | None:
    number = rng.randrange(len(frames))
    text, told = frames[number]
    return made(rng, f"{name} {number}", text, told, {x: look for x, look in looks.items() if look in text})


def pairs(rng: Random) -> Made | None:
    """One block by another."""
    a, b = rng.sample(w.COLORS, 2)
    n, side = rng.choice(("block", "cube")), rng.choice(tuple(_TO))
    to, more, on = _TO[side], rng.choice(_FURTHER[side]), [Told("on", (a, b))]
    rel, some = ([Told(f"{how}{side}", (a, b))] for how in ("-", "s"))
    frames: Frames = (
        (f"Take the {a} {n}. It goes {to} the {b} one.", rel),
        (f"Look for the {b} {n}. The {a} one has to end up {to} it.", rel),
        (f"There's a {b} {n} on the table. I want you to put the {a} one {to} it.", rel),
        (f"You have a {a} {n} and a {b} {n}. Stack the former on the latter.", on),
        (f"The {a} {n} is to be placed {to} the {b} {n} by the robot.", rel),
        (f"the {a} {n} should be found {to} the {b} one", rel),
        (f"the {b} {n} should be used as a base for the {a} {n}", on),
        (f"Can the {a} {n} be moved so that it is {to} the {b} one?", rel),
        (f"Would it be possible to have the {a} {n} {to} the {b} {n}?", rel),
        (f"Is the {a} {n} on the {b} one? If not, put it there.", on),
        (f"how about the {a} {n} {to} the {b} {n}?", rel),
        (f"At the end we see the {a} {n} {to} the {b} {n}.", rel),
        (f"From where the robot stands, the {a} {n} is {to} the {b} one.", rel),
        (f"use the {b} {n} as the base and place the {a} {n} on it", on),
        (f"the {b} {n} serves as a stand for the {a} one", on),
        (f"the {a} {n} is {more} the {b} {n}", some),
        (f"the {a} {n} should end up {more} the {b} one", some),
        (f"please put the {a} {n} {to} {b} {n}", rel),
        (f"{a} {n} must to be on {b} {n}", on),
        (f"I would want that the {a} {n} is {to} the {b} {n}", rel),
        (f"it should be the {a} {n} {to} the {b} {n}", rel),
        (f"make the {a} {n} to be {to} the {b} {n}", rel),
        (f"bring the {a} {n} over to the {b} {n} and set it down {to} it", rel),
    )
    return _drawn(rng, "pairs", frames, {a: a, b: b})


def threes(rng: Random) -> Made | None:
    """Three blocks by each other."""
    a, b, c = rng.sample(w.COLORS, 3)
    n, side, other = rng.choice(("block", "cube")), rng.choice(("left", "right")), rng.choice(("front", "behind"))
    side, other = rng.choice(((side, other), (other, side)))
    to, to2, from2, its = _TO[side], _TO[other], _TO[_BACK[other]], _ITS[other]
    rel, rel2 = Told(f"-{side}", (a, b)), Told(f"-{other}", (c, b))
    on, on_table = Told("on", (a, b)), Told("on_table", (c,))
    three = [on, Told("on", (b, c))]
    frames: Frames = (
        (f"Grab the {a} {n}, it belongs on the {b} one. The {c} {n} goes {to2} the {b} one.", [on, rel2]),
        (f"the {a} {n} has to be stacked on the {b} {n}, and the {c} {n} is to be put {to2} the {b} {n}", [on, rel2]),
        (f"The final picture shows the {a} {n} on top of the {b} {n}, and {to2} them the {c} {n}.", [on, rel2]),
        (f"success: the {a} {n} sits on the {b} {n} and the {c} {n} is {to2} the {b} {n}", [on, rel2]),
        (f"target configuration: {a} {to} {b}, {c} {to2} {b}", [rel, rel2]),
        (f"{b} supports {a}; {c} stands {to2} {b}", [on, rel2]),
        (f"{a} over {b}, and {c} {to2} {b}", [on, rel2]),
        (f"There's a {b} {n}. {to.capitalize()} it there's a {a} one, and {to2} it a {c} one.", [rel, rel2]),
        (f"make sure the {b} {n} ends up with the {a} one on its top and the {c} one {its}", [on, rel2]),
        (f"with the {a} {n} on it, the {b} {n} stands {from2} the {c} one", [on, Told(f"-{_BACK[other]}", (b, c))]),
        (f"the {a} {n} is on the {b} one, and the {c} {n} is not on the table", [on, Told("not", (on_table,))]),
        (f"the {a} {n} must be on a {n}, but not on the {c} one; there is also a {b} one", [on]),
        (f"put the {a} {n} on the {b} {n} but leave the {c} one on the table", [on, on_table]),
        (f"the {a} {n} is on the {b} {n}, the other one, which is {c}, is on the table", [on, on_table]),
        (
            f"there is a {c} {n} too; everything is on the table except the {a} {n}, which is on the {b} one",
            [on, on_table, Told("on_table", (b,))],
        ),
        (
            f"nothing may be on the {a} {n}, which is itself on the {b} one; the {c} one is on the table",
            [on, on_table, Told("bare", (a,))],
        ),
        (f"{a} on {b} on {c}", three),
        (f"first comes the {c} {n}, on it the {b} one and on that the {a} one", three),
        (f"the {b} {n} has a {c} {n} under it and a {a} {n} on top", three),
        (f"the {b} {n} is sandwiched between the {c} one below and the {a} one above", three),
    )
    return _drawn(rng, "threes", frames, {a: a, b: b, c: c})


def counted(rng: Random) -> Made | None:
    """Counts of blocks that stand somewhere."""
    a, b = rng.sample(w.COLORS, 2)
    n, side = rng.choice(("block", "cube")), rng.choice(tuple(_TO))
    to, looks = _TO[side], {f"{a}#1": a, f"{a}#2": a, b: b}
    x, y, _ = looks
    left, right, far, some, on = ([Told(how, (z, b)) for z in (x, y)] for how in (
        "-left", "-right", f"-{side}", f"s{side}", "on"))  # fmt: skip
    not_far, off = ([Told("not", (told,)) for told in both] for both in (far, on))
    on_table = [Told("on_table", (z,)) for z in (x, y)]

    def one_each(first: list[Told], second: list[Told]) -> list[Told]:
        ways = ((first[0], second[1]), (first[1], second[0]))
        return [Told("or", tuple(Told("all", way) for way in ways))]

    frames: Frames = (
        (f"exactly one of the two {a} {n}s is on the {b} {n}", one_each(on, off)),
        (f"one of two {a} {n}s is {to} the {b} {n}, the other is not", one_each(far, not_far)),
        (f"at least one of two {a} {n}s has to be {to} the {b} {n}", [Told("or", tuple(far))]),
        (f"there are two {a} {n}s; none of them is {to} the {b} {n}", not_far),
        (f"neither of the two {a} {n}s must be on the {b} {n}", off),
        (f"two {a} {n}s, one on either side of the {b} {n}", [Told("between", (b, x, y))]),
        (f"the {b} {n} has a {a} {n} to its left and another {a} {n} to its right", one_each(left, right)),
        (f"a {a} {n} on each side of the {b} {n}, left and right", one_each(left, right)),
        (f"put one {a} {n} to the left and one {a} {n} to the right of the {b} {n}", one_each(left, right)),
        (
            f"two {a} {n}s and a {b} one: one {a} {n} is on the {b} one and the other {a} {n} is on the table",
            one_each(on, on_table),
        ),
        (f"both {a} {n}s stand {to} the {b} {n}", some),
    )
    return _drawn(rng, "counted", frames, looks)


def structures(rng: Random) -> Made | None:
    """Towers and rows by each other."""
    a, b = rng.sample(w.COLORS, 2)
    n, side = rng.choice(("block", "cube")), rng.choice(tuple(_TO))
    to, back = _TO[side], _BACK[side]
    tower, other, row = f"{a}^{a}", f"{b}^{b}", f"{b} {b} {b}"
    towers: dict[str, Any] = {"assets": {a: 2, b: 2}, "hold": [beside(other, tower, side)]}
    towers["miss"] = [beside(other, tower, back), beside(f"{b} {b}", tower, side), beside(other, f"{a} {a}", side)]
    by_row: dict[str, Any] = {"assets": {a: 1, b: 3}, "hold": [beside(row, a, side)]}
    by_row["miss"] = [beside(row, a, back), beside(f"{b} {b}^{b}", a, side)]
    topped: dict[str, Any] = {"assets": {a: 2, b: 1}, "hold": [f"{a}^{a}^{b}"]}
    topped["miss"] = [f"{a}^{b}^{a}", f"{b}^{a}^{a}", f"{a}^{a} {b}"]
    frames = (
        (f"a tower of two {a} {n}s stands {to} a tower of two {b} {n}s", towers),
        (f"two towers of two, a {a} one and a {b} one, the {a} one {to} the {b} one", towers),
        (f"build a {a} tower and a {b} tower, two {n}s each; the {a} tower has to be {to} the {b} tower", towers),
        (f"Stack two {b} {n}s. {to.capitalize()} that stack, stack two {a} {n}s.", towers),
        (f"make a row of three {b} {n}s and put a {a} {n} {to} it", by_row),
        (f"three {b} {n}s in a row and a {a} one {to} the row", by_row),
        (f"the {a} {n} stands {to} a row of three {b} {n}s", by_row),
        (f"Line up three {b} {n}s. The {a} {n} should be {to} the line.", by_row),
        (f"a tower of two {a} {n}s with a {b} {n} on the very top", topped),
        (f"the {b} {n} should be on top of a tower made of two {a} {n}s", topped),
    )
    number = rng.randrange(len(frames))
    return f"structures {number}", *frames[number]


PASSING: tuple[Callable[[Random], Made | None], ...] = (pairs, threes, counted, structures)
