"""Relations that are denied, left open between two, told of groups, of patches, of distances and of what is between."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

from tests.corpus.composed.scenes import wordings as w
from tests.corpus.composed.scenes.cells import Told, meaning

Made = tuple[str, str, dict[str, Any]]
"""A frame, its text, and what it means."""

_BE = (
    "should be",
    "must be",
    "has to be",
    "goes",
    "should go",
    "is to be",
    "belongs",
    "must stand",
    "should stand",
    "is",
)
_ON = ("on", "on top of", "onto", "upon")
_PATCH = ("patch", "mat", "zone", "spot", "area")
_NO = (
    "must not be",
    "should not be",
    "may not be",
    "is not to be",
    "shall not be",
    "must never be",
    "does not belong",
    "should not go",
    "must not stand",
    "is not",
    "must not end up",
    "isn't to be",
    "mustn't be",
    "shouldn't be",
)


def _colors(rng: Random, count: int) -> list[str]:
    return rng.sample(w.COLORS, count)


def denied(rng: Random) -> Made | None:
    """Where something is, and where it, or something else, is not."""
    a, b, c = _colors(rng, 3)
    noun = rng.choice(("block", "cube"))
    be, on, no = rng.choice(_BE), rng.choice(_ON[:2]), rng.choice(_NO)
    on_b, on_c = Told("on", (a, b)), Told("not", (Told("on", (a, c)),))
    c_off = Told("not", (Told("on", (c, b)),))
    bare = Told("bare", (a,))
    frames: tuple[tuple[str, list[Told]], ...] = (
        (f"put the {a} {noun} {on} the {b} one, not {on} the {c} one", [on_b, on_c]),
        (f"the {a} {noun} {be} {on} the {b} {noun} and not {on} the {c} {noun}", [on_b, on_c]),
        (f"the {a} {noun} {be} {on} the {b} one, but not {on} the {c} one", [on_b, on_c]),
        (f"not on the {c} {noun} but on the {b} one: that is where the {a} one goes", [on_b, on_c]),
        (f"the {a} {noun} {be} on the {b} one rather than on the {c} one", [on_b, on_c]),
        (f"it is the {b} {noun}, not the {c} {noun}, that the {a} {noun} must be on", [on_b, on_c]),
        (f"it is the {b} {noun} and not the {c} one on which the {a} one must stand", [on_b, on_c]),
        (f"the {a} {noun}, not the {c} one, {be} on the {b} one", [on_b, c_off]),
        (f"put the {a} {noun}, but not the {c} one, on the {b} one", [on_b, c_off]),
        (f"only the {a} {noun} {be} on the {b} one, the {c} one is not", [on_b, c_off]),
        (f"the {a} {noun} {be} {on} the {b} {noun}; the {c} one {no} on the {b} one", [on_b, c_off]),
        (
            f"the {a} {noun} {be} on the {b} one, with nothing on top of the {a} one; a {c} {noun} stands elsewhere",
            [on_b, bare],
        ),
        (
            f"the {a} {noun} {be} on the {b} one and nothing must be on the {a} one. there is also a {c} {noun}",
            [on_b, bare],
        ),
        (
            f"the {a} {noun} {be} {on} the {b} one; nothing may lie on the {a} one. a {c} {noun} is there as well",
            [on_b, bare],
        ),
        (
            f"the {a} {noun} {be} to the left of the {b} one; the {c} one {no} to the left of the {b} one",
            [Told("-left", (a, b)), Told("not", (Told("-left", (c, b)),))],
        ),
        (
            f"put the {a} {noun} on the {b} one, not on the {c} one, which should have the {b} one on it instead",
            [on_b, on_c, Told("on", (b, c))],
        ),
        (f"{a} {be} on {b}, not on {c}", [on_b, on_c]),
        (f"{a} on {b}, and not on {c}", [on_b, on_c]),
        (
            f"there are a {a}, a {b} and a {c} {noun}. the {a} one {be} {on} the {b} one, the {c} one {be} on neither",
            [on_b, Told("not", (Told("on", (c, a)),)), c_off],
        ),
        (f"the {a} {noun} {no} on the {b} {noun} but on the {c} {noun}", [Told("not", (on_b,)), Told("on", (a, c))]),
        (f"don't put the {a} {noun} on the {b} one, put it on the {c} one", [Told("not", (on_b,)), Told("on", (a, c))]),
        (f"instead of the {b} {noun}, the {c} one must carry the {a} one", [Told("not", (on_b,)), Told("on", (a, c))]),
    )
    text, told = rng.choice([frame for frame in frames if frame[1]])
    return made(rng, "denied", text, told, {x: x for x in (a, b, c)})


def either(rng: Random) -> Made | None:
    """One of two, where either is fine."""
    a, b, c = _colors(rng, 3)
    noun, be = rng.choice(("block", "cube")), rng.choice(_BE)
    side, other = rng.choice((("left", "right"), ("right", "left")))
    one_of = Told("or", (Told("on", (a, b)), Told("on", (a, c))))
    who = Told("or", (Told("on", (a, c)), Told("on", (b, c))))
    sides = Told("or", (Told(f"-{side}", (a, b)), Told(f"-{other}", (a, b))))
    frames: tuple[tuple[str, Told], ...] = (
        (f"the {a} {noun} {be} on the {b} one or on the {c} one", one_of),
        (f"put the {a} {noun} on either the {b} or the {c} {noun}", one_of),
        (f"either on the {b} {noun} or on the {c} one the {a} one must stand", one_of),
        (f"put the {a} {noun} on the {b} one or the {c} one, whichever you like", one_of),
        (f"on the {b} or on the {c} {noun} there must be the {a} one", one_of),
        (f"either the {a} or the {b} {noun} {be} on the {c} one", who),
        (f"the {a} or the {b} {noun}, no matter which, {be} on top of the {c} one", who),
        (f"on the {c} {noun} I want either the {a} or the {b} one", who),
        (
            f"the {a} {noun} {be} to the {side} or to the {other} of the {b} one. the {c} {noun} is a distractor",
            sides,
        ),
        (
            f"put the {a} {noun} either to the {side} of the {b} {noun} or to its {other}; a {c} one lies around too",
            sides,
        ),
    )
    text, told = rng.choice(frames)
    return made(rng, "either", text, [told], {x: x for x in (a, b, c)})


def grouped(rng: Random) -> Made | None:
    """All of a colour by all of another, by one, or one by each."""
    a, b = _colors(rng, 2)
    side = rng.choice(("left", "right", "front", "behind"))
    of = {"left": "left of", "right": "right of", "front": "in front of", "behind": "behind"}[side]
    to = {"left": "to the left of", "right": "to the right of"}.get(side, of)
    blocks = {f"{a}#1": a, f"{a}#2": a, f"{b}#1": b, f"{b}#2": b}
    all_all = [Told(f"s{side}", (f"{a}#{n}", f"{b}#{m}")) for n in (1, 2) for m in (1, 2)]
    be, noun = (
        rng.choice(("must be", "should be", "has to be", "is to be", "is", "must stand", "goes")),
        rng.choice(("block", "cube")),
    )
    are = {"has to be": "have to be", "is to be": "are to be", "is": "are", "goes": "go"}.get(be, be)
    each_on = [
        Told(
            "or",
            tuple(
                Told("all", (Told("on", (f"{a}#1", f"{b}#{n}")), Told("on", (f"{a}#2", f"{b}#{3 - n}"))))
                for n in (1, 2)
            ),
        )
    ]
    frames: tuple[tuple[str, list[Told]], ...] = (
        (f"two {a} and two {b} {noun}s: every {a} one {be} {to} every {b} one", all_all),
        (f"there are two {a} and two {b} {noun}s. each {a} {noun} {be} {to} each {b} {noun}", all_all),
        (f"all {a} {noun}s {are} {of} all {b} ones; there are two of each colour", all_all),
        (f"put both {a} {noun}s {to} both {b} {noun}s", all_all),
        (f"two {a} {noun}s and two {b} {noun}s, all {a} ones {of} all {b} ones", all_all),
        (f"both {a} {noun}s {are} {to} the two {b} {noun}s", all_all),
        (f"put one {a} {noun} on each of the two {b} {noun}s", each_on),
        (f"each of two {b} {noun}s should have a {a} {noun} on it", each_on),
        (f"two {b} {noun}s, each with a {a} {noun} on top", each_on),
        (f"two {a} and two {b} {noun}s: each {a} one {be} on a {b} one", each_on),
        (f"there are two {b} and two {a} {noun}s; every {b} one carries a {a} one", each_on),
        (f"on each of two {b} {noun}s there must be a {a} {noun}", each_on),
        (f"with two {b} and two {a} {noun}s, have a {a} one on every {b} one", each_on),
        (f"two {a} {noun}s go on two {b} {noun}s, one on each", each_on),
    )
    text, told = rng.choice(frames)
    return made(rng, "grouped", text, told, blocks)


def patched(rng: Random) -> Made | None:
    """Blocks on patches and by each other."""
    a, b, m, n = _colors(rng, 4)
    noun, be, mat = rng.choice(("block", "cube")), rng.choice(_BE), rng.choice(_PATCH)
    blocks, patches = {x: x for x in (a, b)}, (f"{m}_patch",)
    two = (f"{m}_patch", f"{n}_patch")
    on_m, b_on_m, b_on_n = (Told("on_patch", (x, f"{y}_patch")) for x, y in ((a, m), (b, m), (b, n)))
    off = Told("not", (b_on_m,))
    on_a = Told("on", (b, a))
    frames: tuple[tuple[str, list[Told], tuple[str, ...]], ...] = (
        (f"the {a} {noun} {be} on the {m} {mat} and the {b} one on the {n} {mat}", [on_m, b_on_n], two),
        (
            f"on the {m} {mat} {rng.choice(w.INVERTED[:9])} the {a} {noun}, on the {n} one the {b} {noun}",
            [on_m, b_on_n],
            two,
        ),
        (f"put the {a} {noun} on the {m} {mat} and put the {b} {noun} on top of it", [on_m, on_a], patches),
        (f"the {a} {noun} {be} on the {m} {mat}, with the {b} one on it", [on_m, on_a], patches),
        (f"the {m} {mat} carries the {a} {noun}, which carries the {b} one", [on_m, on_a], patches),
        (f"the {a} {noun} {be} on the {m} {mat}, but the {b} one {rng.choice(_NO)} on it", [on_m, off], patches),
        (f"the {a} {noun} {be} on the {m} {mat}, the {b} one off it", [on_m, off], patches),
        (f"only the {a} {noun}, not the {b} one, {be} on the {m} {mat}", [on_m, off], patches),
        (
            f"both the {a} and the {b} {noun} {'must be' if be == 'is' else 'go'} on the {m} {mat}",
            [on_m, b_on_m],
            patches,
        ),
        (
            f"the {a} {noun} {be} on the {m} {mat}, and so does the {b} one"
            if be == "belongs"
            else f"the {a} {noun} must be on the {m} {mat}, and so must the {b} one",
            [on_m, b_on_m],
            patches,
        ),
        (f"the {a} {noun} {be} on the {m} {mat}, the {b} {noun} on the {a} one", [on_m, on_a], patches),
        (f"the {a} {noun}, which {be} on the {m} {mat}, has the {b} one on it", [on_m, on_a], patches),
        (f"the {b} {noun} {be} on the {a} one, which is on the {m} {mat}", [on_m, on_a], patches),
        (f"where the {a} {noun} belongs is the {m} {mat}; the {b} one must not be there", [on_m, off], patches),
        (f"the {m} {mat} is for the {a} {noun}, the {n} {mat} for the {b} one", [on_m, b_on_n], two),
        (
            f"the {a} {noun} {be} on the {m} {mat} with the {b} one on top of it, the {n} {mat} stays empty",
            [on_m, on_a],
            two,
        ),
        (f"{a} {noun} on {m} {mat}, {b} {noun} on {n} {mat}", [on_m, b_on_n], two),
        (f"{a} on the {m} {mat} and {b} on the {n} {mat}", [on_m, b_on_n], two),
        (f"the {a} {noun} and the {b} {noun} go on the {m} and the {n} {mat} respectively", [on_m, b_on_n], two),
    )
    text, told, there = rng.choice(frames)
    return made(rng, "patched", text, told, blocks, there)


def made(
    rng: Random, frame: str, text: str, told: list[Told], blocks: dict[str, str], patches: tuple[str, ...] = ()
) -> Made | None:
    """What a frame's text means, if states are found in which it is so."""
    means = meaning(rng, told, blocks, patches)
    return (frame, text, means) if means is not None else None


def between(rng: Random) -> Made | None:
    """What stands between two others."""
    a, b, c = _colors(rng, 3)
    noun, be = rng.choice(("block", "cube")), rng.choice(_BE)
    told = [Told("between", (a, b, c))]
    ordered = [*told, Told("-left", (b, a)), Told("-left", (a, c))]
    frames: tuple[tuple[str, list[Told]], ...] = (
        (f"the {a} {noun} {be} between the {b} and the {c} one", told),
        (f"between the {b} {noun} and the {c} one {rng.choice(w.INVERTED[:9])} the {a} one", told),
        (f"the {b} and the {c} {noun} with the {a} one between them", told),
        (f"{a} between {b} and {c}", told),
        (f"{b} and {c}, and in between {a}", told),
        (f"the {b} {noun} and the {c} one should have the {a} one between them", told),
        (f"put the {a} {noun} between the other two, a {b} one and a {c} one", told),
        (f"the {b} {noun} on the left, the {c} one on the right, the {a} one in between", ordered[1:]),
        (
            f"the {a} {noun} {be} flanked by the {b} one and the {c} one"
            if be.endswith("be")
            else f"flank the {a} {noun} with the {b} and the {c} one",
            told,
        ),
        (f"put the {b} {noun} to the left of the {a} one and the {c} one to the right of the {a} one", ordered[1:]),
        (
            f"to the left of the {a} {noun} {rng.choice(w.INVERTED[:9])} the {b} one, to its right the {c} one",
            ordered[1:],
        ),
        (f"the {a} {noun} has the {b} one on its left side and the {c} one on its right side", ordered[1:]),
        (f"{b} left of {a}, {c} right of {a}", ordered[1:]),
    )
    text, relations = rng.choice(frames)
    return made(rng, "between", text, relations, {x: x for x in (a, b, c)})


def apart(rng: Random) -> Made | None:
    """How far two blocks are from each other."""
    a, b = _colors(rng, 2)
    noun, be = (
        rng.choice(("block", "cube")),
        rng.choice(("should be", "must be", "have to be", "are to be", "are", "must stand")),
    )
    cm = rng.choice((10, 12, 14, 15, 16, 18))
    length = rng.choice((f"{cm} cm", f"{cm}cm", f"{cm} centimetres"))
    the, two = f"the {a} {noun}", f"the {a} and the {b} {noun}"
    at = cm / 4
    exact = ([at], [at - 0.5, at + 0.5])
    about = ([at, at * 0.85, at * 1.15], [at * 0.65, at * 1.35])
    least, most = ([at + 0.2, at + 2], [at - 0.5]), ([at - 0.2, 1.5], [at + 0.5])
    gap = ([at + 1], [at, at + 1.6])
    touching, close = ([1.0], [1.3, 2.5]), ([1.3, 2.2], [3.0])
    frames: tuple[tuple[str, tuple[list[float], list[float]]], ...] = (
        (f"{two} {be} {length} apart", exact),
        (f"put {the} {length} from the {b} one", exact),
        (f"{the} should be {length} away from the {b} {noun}", exact),
        (f"keep a distance of {length} between {two}", exact),
        (f"the distance between {two} should be {length}", exact),
        (f"{length} should be the distance from {the} to the {b} one", exact),
        (f"{two} {be} about {length} apart", about),
        (f"place {two} roughly {length} from each other", about),
        (f"{two} {be} at least {length} apart", least),
        (f"{the} must be no closer than {length} to the {b} one", least),
        (f"{two} must be more than {length} apart", least),
        (f"there should be at least {length} between the centres of {two}", least),
        (f"{two} {be} at most {length} apart", most),
        (f"{the} must be less than {length} from the {b} one", most),
        (f"{the} must be within {length} of the {b} {noun}", most),
        (f"leave a gap of {length} between {two}", gap),
        (f"{two} with a gap of {length} between them", gap),
        (f"between {two} there should be a gap of {length}", gap),
        (f"the gap between {two} must be {length}", gap),
        (f"{two} {be} touching", touching),
        (f"{two} should touch each other", touching),
        (f"{the} must touch the {b} one", touching),
        (f"put {the} so close to the {b} one that they touch", touching),
        (f"{the} should be in contact with the {b} one", touching),
        (f"make {two} touch", touching),
        (f"put {the} near the {b} one", close),
        (f"{the} belongs close to the {b} one", close),
        (f"{two} {be} close to each other", close),
        (f"{two} {be} apart", ([2.6, 4.0], [1.3, 2.0])),
        (f"put {the} somewhere away from the {b} one", ([2.6, 4.0], [1.3, 2.0])),
        (f"keep {the} away from the {b} one", ([2.6, 4.0], [1.3, 2.0])),
    )
    text, (hold, miss) = rng.choice(frames)
    states = [[f"{a} {b} pitch={step:.3f}" for step in steps] for steps in (hold, miss)]
    return "apart", text, {"assets": {a: 1, b: 1}, "hold": states[0], "miss": states[1]}


def built(rng: Random) -> Made | None:
    """Where structures stand to each other and to blocks."""
    a, b = _colors(rng, 2)
    side = rng.choice(("left", "right", "front", "behind"))
    to = {"left": "to the left of", "right": "to the right of", "front": "in front of", "behind": "behind"}[side]
    its = {"left": "to its left", "right": "to its right", "front": "in front of it", "behind": "behind it"}[side]
    noun = rng.choice(("block", "cube"))
    tower = rng.choice((f"a tower of two {a} {noun}s", f"a stack of two {a} {noun}s", f"a two-{noun} {a} tower"))
    row = rng.choice((f"a row of three {b} {noun}s", f"a line of three {b} {noun}s"))
    inv = rng.choice(("there is", "put", "there should be", "stands", "I want", "place"))
    block = f"a {b} {noun}"
    back = {"left": "right", "right": "left", "front": "behind", "behind": "front"}[side]
    stack, flat, line = f"{a}^{a}", f"{a} {a}", f"{b} {b} {b}"
    one = {
        "assets": {a: 2, b: 1},
        "hold": [beside(stack, b, side)],
        "miss": [beside(stack, b, back), beside(flat, b, side)],
    }
    three = {"assets": {a: 2, b: 3}, "hold": [beside(stack, line, side)]}
    three["miss"] = [beside(stack, line, back), beside(stack, f"{b} . {b} . . {b}", side), beside(flat, line, side)]
    frames: tuple[tuple[str, dict[str, Any]], ...] = (
        (f"{tower} with {block} {its}", one),
        (f"build {tower} and put {block} {to} it", one),
        (f"{tower}, and {to} it {block}", one),
        (f"{block} {to} {tower}", one),
        (f"{to} {tower} {inv} {block}", one),
        (f"I want {tower}; {to} it {inv} {block}", one),
        (f"build {tower}. put {block} {to} it", one),
        (f"build {tower}. it should have {block} {its}", one),
        (f"there should be {tower} that has {block} {its}", one),
        (f"{tower} with {row} {its}", three),
        (f"{row} {to} {tower}", three),
        (f"{tower}, {to} which there is {row}", three),
        (f"{to} {tower} {inv} {row}", three),
        (f"make {tower} and, {to} it, {row}", three),
    )
    text, means = rng.choice(frames)
    return "built", text, means


def beside(tower: str, other: str, side: str) -> str:
    """A picture of something on a side of a tower, amid it."""
    if side in ("left", "right"):
        return f"{other} . {tower}" if side == "left" else f"{tower} . {other}"
    wide = (len(other.split()) - len(tower.split())) // 2
    pad = " ".join(["."] * abs(wide))
    tower, other = (f"{pad} {tower}", other) if wide > 0 else (tower, f"{pad} {other}")
    return f"{tower} | . | {other}" if side == "front" else f"{other} | . | {tower}"


SPECIAL: tuple[Callable[[Random], Made | None], ...] = (denied, either, grouped, patched, between, apart, built)
