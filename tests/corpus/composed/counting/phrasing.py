"""Patterns of sentences, in which `[a|b]` is one of both and `{gap}` what a gap is filled with; stocks of blocks."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from random import Random
from typing import Any

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
NOUNS = ("block", "block", "cube", "cube", "brick", "box")
PATCHES = ("patch", "patch", "mat", "zone", "area", "spot")
HAVE = (
    "[there are|I have|we have|you have|you get|you are given|here are|these are|I've got] {inv}",
    "{inv} [are on the table|lie on the table|are there|are given]",
    "on the table [there are|are|lie|we have] {inv}",
    "{inv} are [available|at hand|to be used|on the table]",
    "[the table has|the scene has|the task has|the scene contains|the setup is|blocks are|the blocks are] {inv}",
    "[we start with|start with|use|take|given are|you will need|blocks available:|inventory:|blocks:|stock:] {inv}",
    "{inv}",
)
BACK = re.compile(r"\b(them|these|those|they|it|their|others?|rest|second|third)\b")


@dataclass
class Wish:
    """What is wanted: `stock` told, `goals` that speak of it, `wholes` that name it themselves (in the gap `inv`)."""

    name: str
    stock: tuple[str, ...]
    goals: tuple[str, ...]
    wholes: tuple[str, ...]
    meaning: dict[str, Any]
    gaps: dict[str, str] = field(default_factory=dict)
    built: bool = False


def number(rng: Random, n: int) -> str:
    """A number, in words or digits."""
    return NUMBERS[n] if rng.random() < 0.75 else str(n)


def plural(noun: str) -> str:
    return noun + ("es" if noun.endswith(("x", "ch")) else "s")


def listed(items: list[str], word: str = "and") -> str:
    return ", ".join(items[:-1]) + f" {word} {items[-1]}" if len(items) > 1 else items[0]


def said(rng: Random, pattern: str, gaps: dict[str, str]) -> str:
    """A pattern with its choices made and its gaps filled."""
    while (found := re.search(r"\[([^\[\]]*)\]", pattern)) is not None:
        pattern = pattern[: found.start()] + rng.choice(found[1].split("|")) + pattern[found.end() :]
    text = re.sub(r"\{(\w+)\}", lambda gap: said(rng, gaps[gap[1]], gaps), pattern)
    text = re.sub(r"bunchs\b", "bunches", text)
    text = re.sub(r"\b([Aa]) (?=[aeio])(?!one\b)", r"\1n ", text)
    return re.sub(r" +([,;.]|$)", r"\1", re.sub(r"\s+", " ", text)).strip()


def counted(rng: Random, n: int, color: str, noun: str) -> str:
    """`n` blocks of a colour."""
    if n == 1:
        return f"{'an' if color[0] in 'aeiou' else 'a'} {color} {noun}"
    return f"{number(rng, n)} {color} {plural(noun)}"


def stock(rng: Random, lots: list[tuple[int, str]], noun: str) -> tuple[str, ...]:
    """Ways of telling how many blocks of each colour there are."""
    many = plural(noun)
    total = number(rng, sum(n for n, _ in lots))
    digits = rng.random() < 0.3
    ns = [str(n) if digits else NUMBERS[n] for n, _ in lots]
    if any(n == 1 for n, _ in lots) and not digits:
        ns = [("an" if c[0] in "aeiou" else "a") if n == 1 else s for (n, c), s in zip(lots, ns, strict=True)]
    pairs = [f"{n} {c}" for n, (_, c) in zip(ns, lots, strict=True)]
    colors = [c for _, c in lots]
    last = noun if lots[-1][0] == 1 else many
    ways = [
        listed([counted(rng, n, c, noun) for n, c in lots]),
        listed(pairs) + f" {last}",
        f"{total} {many}, {listed(pairs)}" + (" one" if lots[-1][0] == 1 else ""),
        f"{total} {many} ({', '.join(pairs)})",
    ]
    if all(n == 1 for n, _ in lots):
        ways += [
            f"a {listed(colors)} {noun}",
            f"{total} {many} ({', '.join(colors)})",
            f"{total} {many}, one {', one '.join(colors[:-1])} and one {colors[-1]}",
            f"{listed(colors)} {many}, one of each",
            f"one {noun} each [in|of] {listed(colors)}",
        ]
    elif len({n for n, _ in lots}) == 1:
        n = ns[0]
        ways += [
            f"{n} {noun if n == '1' else many} each [of|in] {listed(colors)}",
            f"{total} {many}, {n} each of {listed(colors)}",
            f"{listed(colors)} {many}, {n} of each",
            f"{n} {many} in each of the colours {listed(colors)}",
            f"{total} {many}, {n} of them {', '.join(f'{c} and {n}' for c in colors[:-1])} {colors[-1]}"
            if len(colors) == 2
            else f"{total} {many}: {', '.join(pairs)}",
        ]
    if all(n > 1 for n, _ in lots):
        ways.append(listed([f"{pairs[0]} {many}", *(f"{pair} ones" for pair in pairs[1:])]))
        ways.append(
            f"{total} {many}, {ns[0]} of which are {colors[0]} and {ns[1]} {colors[1]}" if len(lots) == 2 else ways[0]
        )
    return tuple(ways)


def apposed(inv: str) -> bool:
    """Whether a stock is told as a number and, behind a comma, what that is made of."""
    return bool(re.match(r"[^,]*(bricks|blocks|cubes|boxes), ", inv))


def on(blocks: list[str], patch: str) -> str:
    """The picture of blocks on a patch, in two rows."""
    half = (len(blocks) + 1) // 2
    rows = [blocks[:half], blocks[half:]] if len(blocks) > 2 else [blocks]
    return f"{' | '.join(' '.join(row) for row in rows if row)} at={patch}"


def piled(*towers: list[str]) -> str:
    """The picture of towers, bottoms first."""
    return "; ".join("^".join(tower) for tower in towers)


def sentence(rng: Random, wish: Wish) -> tuple[str, str]:
    """A frame and a text of the wish."""
    gaps = wish.gaps | {"inv": rng.choice(wish.stock)} if wish.stock else wish.gaps
    if wish.wholes and (not wish.stock or not wish.goals or rng.random() < 0.4):
        pattern = rng.choice(wish.wholes)
        told = pattern.replace("{inv} ", "{inv}, ") if apposed(gaps.get("inv", "")) else pattern
        return f"{wish.name}: {pattern}", said(rng, told, gaps)
    goal = rng.choice(wish.goals)
    have = rng.choice(HAVE)
    ways = ["{have}. {goal}", "{have}. {goal}", "{have}; {goal}", "{inv}: {goal}"]
    ways.append("[from|out of|with|using] {inv}, {goal}" if wish.built else "[with|given] {inv}, {goal}")
    if not BACK.search(goal):
        ways += ["{goal}. {have}", "{goal}. {have}", "{goal} ({inv})", "{goal}: {inv}"]
    way = rng.choice(ways)
    way, goal = (w.replace("{inv} ", "{inv}, ") if apposed(gaps.get("inv", "")) else w for w in (way, goal))
    shown = way.replace("{goal}", goal).replace("{have}", have)
    return f"{wish.name}: {way.replace('{goal}', goal)}", said(rng, shown, gaps)


def written(rng: Random, text: str) -> str:
    """A text as people write it: mostly with capitals and a full stop, sometimes without."""
    if rng.random() < 0.25:
        return text
    text = re.sub(r"(^|[.?!] )([a-z])", lambda m: m[1] + m[2].upper(), text)
    return text if text.endswith(("?", "!")) or rng.random() < 0.2 else text + "."
