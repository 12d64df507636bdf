"""Sentences of all, each, none, some and others, and of one place among several."""

from __future__ import annotations

from collections import Counter

from tests.madeup.chance import NUMBERS, Chance, a
from tests.madeup.scenes import OPPOSITE, MadeUp

_TO = {"left": "to the left of", "right": "to the right of", "behind": "behind", "front": "in front of"}
_AT = {"left": "0,5", "right": "0,-5", "behind": "3,0", "front": "-3,0"}
_WORDS = ("BED", "TEN", "PEN", "LED", "MET")


def all_beside_all(chance: Chance) -> MadeUp:
    """All of one colour on one side of all of another."""
    (one, two), n, m, side = chance.colors(2), chance.number(2, 3), chance.number(2, 3), chance.of("left", "right")
    blocks, many, others = chance.blocks, NUMBERS[n], NUMBERS[m]
    text = chance.of(
        f"all {many} {one} {blocks} are to the {side} of all {others} {two} {blocks}",
        f"put the {many} {one} {blocks} to the {side} of the {others} {two} {blocks}",
        f"each of the {many} {one} {blocks} must be {side} of each of the {others} {two} {blocks}",
        f"the {others} {two} {blocks} should all be to the {OPPOSITE[side]} of the {many} {one} ones",
    )
    seen = [one] * n + [two] * m if side == "left" else [two] * m + [one] * n
    last = seen.index(seen[-1])
    mixed = [*seen[: last - 1], seen[last], seen[last - 1], *seen[last + 1 :]]
    return MadeUp(text, Counter({one: n, two: m}), [" ".join(seen)], [" ".join(mixed), " ".join(seen[::-1])])


def none_touch(chance: Chance) -> MadeUp:
    """None of one colour touches one of another."""
    (one, two), n = chance.colors(2), chance.number(2, 3)
    many, blocks = NUMBERS[n], chance.blocks
    text = chance.of(
        f"no {one} {chance.block} may touch {a(two)} {chance.block}. There are {many} {one} and two {two} {blocks}.",
        f"there are {many} {one} and two {two} {blocks}. None of the {one} ones touches {a(two)} one.",
        f"there are {many} {one} {blocks} and two {two} ones. The {one} ones must not touch the {two} ones.",
    )
    ones, twos = " ".join([one] * n), f"{two} {two}"
    on_it = " ".join([*[one] * (n - 1), f"{one}^{two}"])
    hold, miss = f"{ones} pitch=1 ; {twos} pitch=1", [f"{ones} {twos} pitch=1", f"{on_it} ; {two}"]
    return MadeUp(text, Counter({one: n, two: 2}), [hold], miss)


def each_has_one(chance: Chance) -> MadeUp:
    """Each of several has one on it."""
    (one, two), n = chance.colors(2), chance.number(2, 3)
    many, blocks = NUMBERS[n], chance.blocks
    text = chance.of(
        f"each of the {many} {one} {blocks} has {a(two)} one on it",
        f"every one of {many} {one} {blocks} must have {a(two)} {chance.block} on top",
        f"there are {many} {one} {blocks} and {many} {two} ones. Each {one} one has {a(two)} one on it.",
    )
    pairs = [f"{one}^{two}"] * n
    miss = " ; ".join([*pairs[1:], f"{two}^{one}"])
    return MadeUp(text, Counter({one: n, two: n}), [" ; ".join(pairs)], [miss])


def all_but_one(chance: Chance) -> MadeUp:
    """All but one of three on a patch."""
    one, two, three, mat = chance.colors(4)
    three_of_them, kind = f"{a(one)}, {a(two)} and {a(three)} block", chance.of("mat", "patch")
    text = chance.of(
        f"put all blocks on the {mat} {kind} except the {one} one. There are {three_of_them}.",
        f"there are {three_of_them}. All of them but the {one} one must be on the {mat} {kind}.",
        f"there is {three_of_them}. Everything except the {one} block goes on the {mat} {kind}.",
    )
    there = [f"{color} at={mat}_patch+{x},0" for color, x in ((two, 0.7), (three, -0.7))]
    miss = [
        f"{there[0]} ; {three} at=-5,0 ; {one} at=-5,3",
        f"{there[0]} ; {one} at={mat}_patch+-0.7,0 ; {three} at=-5,0",
    ]
    assets = Counter([one, two, three, f"{mat}_patch"])
    return MadeUp(text, assets, [f"{there[0]} ; {there[1]} ; {one} at=-5,0"], miss)


def word_beside(chance: Chance) -> MadeUp | None:
    """A word with a block at one of its sides."""
    word, (color,), side = chance.word(_WORDS), chance.colors(1), chance.of(*_TO)
    if word is None:
        return None
    text = chance.of(
        f"spell {word} and put {a(color)} {chance.block} {_TO[side]} the word",
        f"spell the word {word} with {a(color)} {chance.block} {_TO[side]} it",
        f"write {word} {_TO[OPPOSITE[side]]} the {color} {chance.block}",
        f"the {color} {chance.block} must be {_TO[side]} the word {word}",
    )
    cells = " ".join(word)
    states = [
        f"{x} at=0,0 ; {color} at={_AT[y]}" for x, y in ((cells, side), (cells, OPPOSITE[side]), (cells[::-1], side))
    ]
    return MadeUp(text, Counter([*word, color]), states[:1], states[1:])


def only_one(chance: Chance) -> MadeUp:
    """One of two on a patch, and not the other."""
    one, two, mat = chance.colors(3)
    kind, block, exactly = chance.of("mat", "patch"), chance.block, chance.often(0.3)
    text = chance.of(
        f"the {one} {block}, and not the {two} one, belongs on the {mat} {kind}",
        f"of the {one} and the {two} {block} only the {one} one is on the {mat} {kind}",
    )
    text = f"exactly one of the {one} and the {two} {block} must be on the {mat} {kind}" if exactly else text
    either = [f"{x} at={mat}_patch ; {y} at=-5,0" for x, y in ((one, two), (two, one))]
    both = f"{one} at={mat}_patch+0.7,0 ; {two} at={mat}_patch+-0.7,0"
    hold, miss = (either, [both]) if exactly else (either[:1], [either[1], both])
    return MadeUp(text, Counter([one, two, f"{mat}_patch"]), hold, miss)


def on_one_of_a_row(chance: Chance) -> MadeUp:
    """A block on the first or the last of a row."""
    (one, two), n, side = chance.colors(2), chance.number(3, 4), chance.of("left", "right")
    many, blocks = NUMBERS[n], chance.blocks
    text = chance.of(
        f"put {a(two)} {chance.block} on the {side}most of {many} {one} {blocks} in a row",
        f"line up {many} {one} {blocks} and put {a(two)} one on the {side}most",
        f"there is a row of {many} {one} {blocks}. The {side}most one has {a(two)} {chance.block} on it.",
        f"the {side}most block in a row of {many} {one} {blocks} carries {a(two)} {chance.block}",
    )
    place = 0 if side == "left" else n - 1
    rows = [" ".join([f"{one}^{two}" if k == there else one for k in range(n)]) for there in (place, 1, n - 1 - place)]
    return MadeUp(text, Counter({one: n, two: 1}), rows[:1], rows[1:])


def the_others(chance: Chance) -> MadeUp:
    """One of several on a patch, and the others stacked."""
    (one, mat), n, kind = chance.colors(2), chance.number(3, 4), chance.of("mat", "patch")
    text = chance.of(
        f"put one of the {NUMBERS[n]} {one} {chance.blocks} on the {mat} {kind} and stack the others",
        f"one of {NUMBERS[n]} {one} {chance.blocks} goes on the {mat} {kind}; stack the rest",
        f"lay one of the {NUMBERS[n]} {one} {chance.blocks} on the {mat} {kind} and pile up the remaining ones",
    )
    tower, row = "^".join([one] * (n - 1)), " ".join([one] * (n - 1))
    states = [f"{x} at=-5,0 ; {one} at={mat}_patch" for x in (tower, row)]
    return MadeUp(text, Counter({one: n, f"{mat}_patch": 1}), states[:1], states[1:])


def some_of_three(chance: Chance) -> MadeUp:
    """At least, or exactly, so many of three."""
    (one, two), blocks = chance.colors(2), chance.blocks
    text, hold, miss = chance.of(
        (f"at least one of the three {one} {blocks} must be on the {two} block", [f"{two}^{one} {one} {one}"],
         [f"{one}^{two} {one} {one}"]),
        (f"at least two of the three {one} {blocks} touch the {two} block",
         [f"{one} {two} {one} pitch=1", f"{one} {two}^{one} pitch=1"],
         [f"{one} {two} pitch=1", f"{one} {one} {two} pitch=1"]),
        (f"exactly one of the three {one} {blocks} is to the left of the {two} block", [f"{one} {two} {one} {one}"],
         [f"{one} {one} {two} {one}", f"{two} {one} {one} {one}"]),
    )  # fmt: skip
    return MadeUp(text, Counter({one: 3, two: 1}), hold, miss)


QUANTITIES = (
    all_beside_all, none_touch, each_has_one, all_but_one, word_beside, only_one, on_one_of_a_row, the_others,
    some_of_three,
)  # fmt: skip
