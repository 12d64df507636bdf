"""Sentences of one kind each: orders, counts on patches, starts, regions, distances, denials, structures in pairs."""

from __future__ import annotations

from collections import Counter

from tests.madeup.chance import NUMBERS, Chance, a, listed, the
from tests.madeup.scenes import MadeUp

_REGIONS = {
    "left half": (0, 4), "right half": (0, -4), "far left corner": (3, 5.5), "far right corner": (3, -5.5),
    "near left corner": (-3, 5.5), "near right corner": (-3, -5.5),
}  # fmt: skip
_ON_PATCH = ((0.6, 0.6), (-0.6, -0.6), (0.6, -0.6), (-0.6, 0.6))


def ordered_row(chance: Chance) -> MadeUp:
    """A row from one side to the other."""
    looks, way = chance.looks(chance.number(3, 5)), chance.of("left to right", "right to left")
    colors = len(looks[0]) > 1
    blocks, line = (f" {chance.blocks}" if colors else ""), chance.of("line up", "arrange", "put")
    text = chance.of(
        f"{chance.of('make', 'build', 'form')} a row from {way}: {', '.join(looks)}",
        f"{line} {listed(looks)} in a row from {way}",
        f"{line} the {listed(looks)}{blocks} in a row in {chance.of('this', 'that')} order from {way}",
        f"a row from {way} of {listed(looks)}{blocks}",
        f"from {way} I want to see {listed(looks)} in {chance.of('a', 'one')} row",
        f"there {chance.of('is', 'should be')} a row: {listed(looks)} from {way}",
    )
    seen = looks if way == "left to right" else looks[::-1]
    return MadeUp(text, Counter(looks), [" ".join(seen)], [" ".join(_swapped(seen, chance)), " ".join(seen[::-1])])


def ordered_tower(chance: Chance) -> MadeUp:
    """A tower from one end to the other."""
    looks, way = chance.looks(chance.number(3, 4)), chance.of("bottom to top", "top to bottom")
    blocks = f" {chance.blocks}" if len(looks[0]) > 1 else ""
    upward = looks if way == "bottom to top" else looks[::-1]
    texts = [
        f"{chance.of('make', 'build')} a tower, {way}: {', '.join(looks)}", f"stack {listed(looks)} from {way}",
        f"a {chance.of('tower', 'stack')} from {way} of {listed(looks)}{blocks}",
        " on ".join(upward[::-1]),
    ]  # fmt: skip
    if len(looks) == 3:
        texts.append(f"stack {listed(looks)} with {upward[-1]} {chance.of('on top', 'at the top')} and {upward[0]} "
                     "at the bottom")  # fmt: skip
    miss = ["^".join(_swapped(upward, chance)), "^".join(upward[::-1])]
    return MadeUp(chance.of(*texts), Counter(looks), ["^".join(upward)], miss)


def _swapped(looks: list[str], chance: Chance) -> list[str]:
    """With two neighbours changed."""
    n = chance.number(0, len(looks) - 2)
    return [*looks[:n], looks[n + 1], looks[n], *looks[n + 2 :]]


def row_with_one(chance: Chance) -> MadeUp:
    """A row of one colour with one block of another, at a place that is told."""
    count, (most, other) = chance.of(3, 5), chance.colors(2)
    many, fewer = NUMBERS[count], NUMBERS[count - 1]
    place, at = chance.of(
        ("middle", count // 2), ("leftmost", 0), ("rightmost", count - 1), ("second from the left", 1)
    )
    texts = [
        f"line up {fewer} {most} {chance.blocks} and {a(other)} {chance.block} so that the {other} one is "
        + {"middle": "in the middle", "leftmost": "at the left end", "rightmost": "at the right end"}.get(place, place),
        f"a row of {many} {chance.blocks}: the {place}{' one' if at != 1 else ''} is {other}, the others are {most}",
    ]  # fmt: skip
    if place.endswith("most"):
        texts.append(f"a row of {many} {chance.blocks}, {most} except for the {place} one, which is {other}")
    hold = [most] * count
    hold[at] = other
    miss = [" ".join([*[most] * n, other, *[most] * (count - 1 - n)]) for n in range(count) if n != at]
    return MadeUp(chance.of(*texts), Counter(hold), [" ".join(hold)], miss[:3])


def counted_on_patch(chance: Chance) -> MadeUp:
    """So many of some blocks on a patch."""
    (color, mat), count = chance.colors(2), chance.number(3, 4)
    some, how = chance.number(1, count - 1), chance.of("exactly", "at least", "at most", "only")
    kind, blocks = chance.of("mat", "patch"), chance.blocks
    text = chance.of(
        f"{chance.put} {how} {NUMBERS[some]} of the {NUMBERS[count]} {color} {blocks} on the {mat} {kind}",
        f"{how} {NUMBERS[some]} of {NUMBERS[count]} {color} {blocks} must be on the {mat} {kind}",
        f"there are {NUMBERS[count]} {color} {blocks}. {how} {NUMBERS[some]} of them should be on the {mat} {kind}",
        f"the {mat} {kind} {chance.of('holds', 'has')} {how} {NUMBERS[some]} of the {NUMBERS[count]} {color} {blocks}",
    )
    fits = {"exactly": [some], "only": [some], "at least": [*range(some, count + 1)], "at most": [*range(some + 1)]}[
        how
    ]
    states = {
        n: " ; ".join(f"{color} at={mat}_patch+{x},{y}" for x, y in _ON_PATCH[:n]) or f"{color} at=-5,0"
        for n in range(count + 1)
    }
    hold = [states[n] for n in fits]
    return MadeUp(text, Counter({color: count, f"{mat}_patch": 1}), hold, [s for s in states.values() if s not in hold])


def patch_each(chance: Chance) -> MadeUp:
    """Blocks, each on a patch of its own."""
    count, kind = chance.number(2, 3), chance.of("mat", "patch")
    colors, mats = chance.colors(count), chance.colors(count)
    several = f"{kind}es" if kind == "patch" else f"{kind}s"
    text = chance.of(
        ", ".join(f"the {c} {chance.block} goes on the {m} {kind}" for c, m in zip(colors, mats, strict=True)),
        f"{chance.put} {listed([the(c, chance) for c in colors])} on {listed([f'the {m}' for m in mats])} {several} "
        "respectively",
        f"{the(colors[0], chance)} is on the {mats[0]} {kind} and "
        + " and ".join(f"{the(c, chance)} on the {m} one" for c, m in zip(colors[1:], mats[1:], strict=True)),
    )
    there = [" ; ".join(f"{c} at={m}_patch" for c, m in zip(colors, way, strict=True)) for way in (mats, mats[::-1])]
    return MadeUp(text, Counter([*colors, *(f"{m}_patch" for m in mats)]), [there[0]], [there[1]])


def begun(chance: Chance) -> MadeUp:
    """How it is at the start, and what becomes of it."""
    one, two, three = chance.colors(3)
    if chance.often(0.5):
        text = chance.of(
            f"{the(one, chance)} starts on {the(two, chance)}. {chance.of('Put', 'Move')} it on {the(three, chance)}.",
            f"at the start {the(one, chance)} is on {the(two, chance)}; in the end it must be on {the(three, chance)}",
            f"initially {the(one, chance)} lies on {the(two, chance)}. Move it onto {the(three, chance)}",
        )
        miss = [f"{two}^{one}", f"{one}^{three}"]
        return MadeUp(text, Counter([one, two, three]), [f"{three}^{one}"], miss, (f"{two}^{one}",), (f"{one}^{two}",))
    text = chance.of(
        f"{the(one, chance)}, {the(two, chance)} and {the(three, chance)} start stacked, {one} at the bottom and "
        f"{three} on top. Unstack them so that all stand on the table.",
        f"there is a tower at the start: {three} on {two} on {one}. Put all three {chance.blocks} on the table.",
    )
    miss = [f"{one}^{two} ; {three}", f"{one}^{two}^{three}"]
    start, other = f"{one}^{two}^{three}", f"{three}^{two}^{one}"
    return MadeUp(text, Counter([one, two, three]), [f"{one} ; {two} ; {three}"], miss, (start,), (other,))


def in_region(chance: Chance) -> MadeUp:
    """Two blocks in two parts of the table."""
    one, two = chance.colors(2)
    halves, corners = ("left half", "right half"), ("far left corner", "near right corner")
    first, second = chance.of(halves, halves[::-1], corners, ("near left corner", "far right corner"))
    text = chance.of(
        f"{chance.put} {the(one, chance)} in the {first} and {the(two, chance)} in the {second} of the table",
        f"{the(one, chance)} {chance.must_be} in the {first} of the table, {the(two, chance)} in the {second}",
    )
    states = [
        " ; ".join(f"{c} at={_REGIONS[r][0]},{_REGIONS[r][1]}" for c, r in ((one, x), (two, y)))
        for x, y in ((first, second), (second, first))
    ]
    return MadeUp(text, Counter([one, two]), states[:1], states[1:])


def apart(chance: Chance) -> MadeUp:
    """Two things so many centimetres apart."""
    (one, two), cm = chance.looks(2), chance.of(10, 12, 15, 20)
    how = chance.of("at least", "exactly")
    text = chance.of(
        f"{the(one, chance)} and {the(two, chance)} are {how} {cm} cm apart",
        f"keep {the(one, chance)} {how} {cm} cm away from {the(two, chance)}",
        f"the distance between {the(one, chance)} and {the(two, chance)} must be {how} {cm} cm",
    )
    edges = cm / 4
    there, not_there = (edges, edges + 2.6) if how == "exactly" else (edges + 1.3, edges - 0.9)
    states = [f"{one} at=0,0 ; {two} at=0,{x:g}" for x in (there, not_there)]
    return MadeUp(text, Counter([one, two]), states[:1], states[1:])


def denied(chance: Chance) -> MadeUp:
    """What must not be, or one of two."""
    one, two, three = chance.colors(3)
    if chance.often(0.3):
        text = f"{the(one, chance)} {chance.must_be} next to {the(two, chance)} but not next to {the(three, chance)}"
        return MadeUp(text, Counter([one, two, three]), [f"{one} {two} {three}"], [f"{two} {one} {three}"])
    if chance.often(0.3):
        text = f"{the(one, chance)} {chance.must_be} on {the(two, chance)} or on {the(three, chance)}"
        return MadeUp(text, Counter([one, two, three]), [f"{two}^{one}", f"{three}^{one}"], [f"{one}^{two}", one])
    text = chance.of(
        f"{the(one, chance)} must not be on {the(two, chance)}, but on {the(three, chance)}",
        f"{chance.put} {the(one, chance)} on {the(three, chance)}, not on {the(two, chance)}",
        f"{chance.put} {the(one, chance)} on {the(three, chance)} instead of {the(two, chance)}",
    )
    return MadeUp(text, Counter([one, two, three]), [f"{three}^{one}"], [f"{two}^{one}", f"{one}^{three}"])


def two_towers(chance: Chance) -> MadeUp:
    """A tower of one colour on one side of a tower of another."""
    (one, two), count, kind = chance.colors(2), chance.number(2, 3), chance.of("tower", "stack")
    many, side = NUMBERS[count], chance.of("left", "right")
    text = chance.of(
        f"build a {kind} of {many} {one} {chance.blocks} to the {side} of a {kind} of {many} {two} {chance.blocks}",
        f"two {kind}s of {many}, the {one} one {side} of the {two} one",
        f"two {kind}s of {many}: the {one} one is {side} of the {two} one",
        f"there is {a(one)} {kind} of {many} to the {side} of {a(two)} {kind} of {many}",
    )
    towers = ["^".join([color] * count) for color in (one, two)][:: 1 if side == "left" else -1]
    return MadeUp(text, Counter({one: count, two: count}), [" . ".join(towers)], [" . ".join(towers[::-1])])


def two_rows(chance: Chance) -> MadeUp:
    """A row of one colour behind a row of another, or in front of it."""
    (one, two), count = chance.colors(2), chance.number(3, 4)
    many, (side, back) = NUMBERS[count], chance.of(("behind", True), ("in front of", False))
    text = chance.of(
        f"a row of {many} {one} {chance.blocks} {side} a row of {many} {two} {chance.blocks}",
        f"put a row of {many} {one} {chance.blocks} {side} a row of {many} {two} ones",
        f"two rows of {many}: the {one} one is {side} the {two} one",
        f"build a row of {many} {two} {chance.blocks} and {side} it a row of {many} {one} ones",
    )
    rows = [" ".join([color] * count) for color in ((one, two) if back else (two, one))]
    states = [f"{far} at=2,0 ; {near} at=0,0" for far, near in (rows, rows[::-1])]
    return MadeUp(text, Counter({one: count, two: count}), states[:1], states[1:])


def each_on_one(chance: Chance) -> MadeUp:
    """Several pairs of one block on another."""
    (one, two), count, kind = chance.colors(2), chance.number(2, 3), chance.of("tower", "stack")
    many = NUMBERS[count]
    text = chance.of(
        f"{many} {kind}s of two, each with {a(one)} {chance.block} on {a(two)} one",
        f"build {many} {kind}s of two {chance.blocks} with {one} on top and {two} at the bottom of each",
        f"put {a(one)} {chance.block} on each of {many} {two} {chance.blocks}",
        f"on each of the {many} {two} {chance.blocks} there is {a(one)} {chance.block}",
    )
    pairs = [f"{two}^{one}"] * count
    miss = [" ; ".join([*pairs[1:], f"{one}^{two}"]), " ; ".join([*pairs[1:], one, two])]
    return MadeUp(text, Counter({one: count, two: count}), [" ; ".join(pairs)], miss)


KINDS = (
    ordered_row, ordered_tower, row_with_one, counted_on_patch, patch_each, begun, in_region, apart, denied, two_towers,
    two_rows, each_on_one,
)  # fmt: skip
