"""Sentences made from templates whose meaning is known, for finding misreadings in large numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

import yaml

from rpg.ir import goal as g
from rpg.ir.assets import Asset, Color, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.order import Order, Side
from rpg.ir.structures import Row, Spells, Stack

COLORS: tuple[Color, ...] = (
    "red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white",
)  # fmt: skip
SAID: dict[str, list[str]] = yaml.safe_load((Path(__file__).parent / "templates.yaml").read_text(encoding="utf-8"))
NUMBERS = {1: ("one",), 2: ("two", "2"), 3: ("three", "3"), 4: ("four", "4"), 5: ("five", "5")}
WORDS = ("CAT", "DOG", "ROBOT", "HELLO", "SUN", "MILK")
RELATIONS: tuple[tuple[Callable[..., g.Goal], dict[str, bool], tuple[str, ...]], ...] = (
    (g.On, {}, ("on", "on top of", "onto", "atop")),
    (g.LeftOf, {}, ("to the left of", "left of", "on the left of", "on the left side of", "on the left-hand side of")),
    (g.RightOf, {}, ("to the right of", "right of", "on the right side of")),
    (g.InFrontOf, {}, ("in front of",)),
    (g.Behind, {}, ("behind",)),
    (g.Beside, {}, ("next to", "beside", "alongside")),
    (g.Adjacent, {}, ("adjacent to",)),
    (g.Near, {}, ("near", "close to")),
    (g.LeftOf, {"directly": True}, ("directly to the left of", "directly left of")),
    (g.Behind, {"directly": True}, ("directly behind",)),
    (g.RightOf, {"somewhere": True}, ("somewhere to the right of",)),
    (g.RightOf, {"directly": True, "immediate": True}, ("immediately to the right of", "immediately right of")),
)
FACTS = ("{a} is {r} {b}", "{a} sits {r} {b}", "{a} stands {r} {b}")
ORDERS = ("put", "place", "take", "position", "get", "please move")
ACROSS: tuple[tuple[str, str, Side], ...] = (
    ("from left to right", "y", "left"), ("from right to left", "y", "right"),
    ("from front to back", "x", "front"), ("from back to front", "x", "back"),
)  # fmt: skip
UPWARD: tuple[tuple[str, Side], ...] = (
    ("from bottom to top", "bottom"), ("from top to bottom", "top"),
    ("from the bottom up", "bottom"), ("from the top down", "top"),
)  # fmt: skip


@dataclass(frozen=True)
class Case:
    """A sentence, the template it came from, the objects it calls for and the goals that it may mean."""

    text: str
    template: str
    assets: tuple[Asset, ...]
    goals: tuple[g.Goal, ...]


def case(seed: int) -> Case:
    """A random sentence."""
    rng = Random(seed)
    return rng.choice(FAMILIES)(rng)


def _cubes(color: Color, count: int) -> tuple[Asset, ...]:
    if count == 1:
        return (ColoredCube(name=f"{color}_block", color=color),)
    return tuple(ColoredCube(name=f"{color}_block_{i}", color=color) for i in range(1, count + 1))


def _names(assets: tuple[Asset, ...]) -> tuple[str, ...]:
    return tuple(asset.name for asset in assets)


def _list(rng: Random, colors: list[Color]) -> str:
    """Colours as people list them."""
    full = [f"the {color} block" for color in colors]
    head, last = ", ".join(colors[:-1]), colors[-1]
    forms = (f"{head} and {last}", f"{head}, and {last}", f"{head}, {last}", ", then ".join(colors))
    return rng.choice((*forms, f"{', '.join(full[:-1])} and {full[-1]}"))


def _article(rng: Random, color: str) -> str:
    forms = ("the {} block", "the {} block", "the {} cube", "the {} brick", "{}", "the {} one")
    return rng.choice(forms).format(color)


def _statement(rng: Random, a: str, b: str) -> tuple[str, str, g.Goal]:
    make, flags, words = rng.choice(RELATIONS)
    template = rng.choice(SAID["placed"][:-1] if make is not g.On else SAID["placed"])
    text = template.format(a=_article(rng, a).replace("one", "block"), b=_article(rng, b), r=rng.choice(words))
    return text, template, make(a=f"{a}_block", b=f"{b}_block", **flags)


def relation(rng: Random) -> Case:
    """One statement of place."""
    a, b = rng.sample(COLORS, 2)
    text, template, goal = _statement(rng, a, b)
    return Case(text, template, _cubes(a, 1) + _cubes(b, 1), (goal,))


def two_relations(rng: Random) -> Case:
    """Two statements of place that may share a block."""
    colors = rng.sample(COLORS, 4)
    first, told, one = _statement(rng, colors[0], colors[1])
    d = colors[3] if isinstance(one, g.On) else rng.choice((colors[3], colors[1], colors[0]))
    second, ordered, two = _statement(rng, colors[2], d)
    if told in FACTS and ordered.startswith(ORDERS):  # the other way round it would be told of the start
        first, second, one, two = second, first, two, one
    template = rng.choice(SAID["joined"])
    used = dict.fromkeys((*colors[:3], d))
    assets = tuple(cube for color in used for cube in _cubes(color, 1))
    return Case(
        template.format(s=first.rstrip("?"), t=second.rstrip("?")), template, assets, (g.All(goals=(one, two)),)
    )


def tower(rng: Random) -> Case:
    """A tower of look-alikes."""
    color, count = rng.choice(COLORS), rng.randint(2, 5)
    cubes, template = _cubes(color, count), rng.choice(SAID["towers"])
    text = template.format(w=rng.choice(NUMBERS[count]), c=color, p=rng.choice(("blocks", "cubes", "bricks")))
    return Case(text, template, cubes, tuple(Stack(blocks=_names(cubes), exact=exact) for exact in (True, False)))


def on_patch(rng: Random) -> Case:
    """All, or so many, of some look-alikes on a patch."""
    color, other = rng.sample(COLORS, 2)
    count = rng.randint(2, 5)
    cubes, few = _cubes(color, count), rng.randint(1, count - 1)
    words = {
        "w": rng.choice(NUMBERS[count]), "c": color, "d": other, "k": rng.choice(NUMBERS[few]),
        "m": rng.choice(("patch", "mat", "target", "zone", "goal patch")),
    }  # fmt: skip
    patch = GoalPatch(name=f"{other}_patch", color=other)
    if rng.random() < 0.4:
        template, goal = rng.choice(SAID["all_on"]), _on(_names(cubes), patch)
    else:
        template, form = rng.choice(SAID["some_on"]), rng.choice(("exactly", "at least", "at most"))
        words["f"] = form
        low, high = {"exactly": (few, few), "at least": (few, None), "at most": (0, few)}[form]
        goal = g.Count(over=_names(cubes), at_least=low, at_most=high, goal=_on(("each",), patch))
    return Case(template.format(**words), template, (*cubes, patch), (goal,))


def _on(names: tuple[str, ...], patch: GoalPatch) -> g.Goal:
    return g.OnPatch(a=names, patch=patch.name)


def row(rng: Random) -> Case:
    """An ordered row or column."""
    colors = rng.sample(COLORS, rng.randint(3, 5))
    cubes = tuple(cube for color in colors for cube in _cubes(color, 1))
    words, axis, first = rng.choice(ACROSS)
    template = rng.choice(SAID["rows"])
    order = Order(by="given", ranks=tuple((name,) for name in _names(cubes)), first=first)
    fields: Any = {"blocks": _names(cubes), "axis": axis, "order": order}
    return Case(template.format(l=_list(rng, colors), d=words), template, cubes, (Row(**fields),))


def stack(rng: Random) -> Case:
    """An ordered stack."""
    colors = rng.sample(COLORS, rng.randint(3, 5))
    cubes = tuple(cube for color in colors for cube in _cubes(color, 1))
    words, first = rng.choice(UPWARD)
    template = rng.choice(SAID["stacks"])
    names = _names(cubes)
    upward = names if first == "bottom" else names[::-1]
    ways = ((names, first), (upward, "bottom"), (upward[::-1], "top"))
    goals = tuple(
        Stack(blocks=names, exact=exact, order=Order(by="given", ranks=tuple((n,) for n in ranks), first=side))
        for exact in (True, False)
        for ranks, side in ways
    )
    return Case(template.format(l=_list(rng, colors), d=words), template, cubes, goals)


def between(rng: Random) -> Case:
    """One block between two."""
    a, b, c = rng.sample(COLORS, 3)
    template = rng.choice(SAID["between"])
    goal = g.Between(a=f"{a}_block", b=f"{b}_block", c=f"{c}_block")
    return Case(template.format(a=a, b=b, c=c), template, _cubes(a, 1) + _cubes(b, 1) + _cubes(c, 1), (goal,))


def sequence(rng: Random) -> Case:
    """One thing after another."""
    colors = rng.sample(COLORS, 4)
    a, b, c, d = colors
    full = rng.random() < 0.5
    p, q = (f"the {x} block on the {y} block" if full else f"{x} on {y}" for x, y in ((a, b), (c, d)))
    template = rng.choice(SAID["sequences"])
    stages = tuple(g.Stage(goal=g.On(a=f"{x}_block", b=f"{y}_block")) for x, y in ((a, b), (c, d)))
    assets = tuple(cube for color in colors for cube in _cubes(color, 1))
    return Case(template.format(p=p, q=q), template, assets, (g.Sequence(stages=stages),))


def spelling(rng: Random) -> Case:
    """A word in any case, with or without quotes."""
    word = rng.choice(WORDS)
    shown = rng.choice((word, word.lower(), word.capitalize(), f'"{word}"', f"'{word.lower()}'"))
    counts, assets = Counter(word), []
    for letter in dict.fromkeys(word):
        many = range(1, counts[letter] + 1) if counts[letter] > 1 else (0,)
        assets += [SemanticCube(name=f"{letter}_block_{i}", label=letter) for i in many]
    template = rng.choice(SAID["spellings"])
    goal = Spells(blocks=_names(tuple(assets)), word=word)
    return Case(template.format(w=shown), template, tuple(assets), (goal,))


FAMILIES: tuple[Callable[[Random], Case], ...] = (
    relation, relation, two_relations, tower, on_patch, row, stack, between, sequence, spelling,
)  # fmt: skip
