"""Quantified sentences against what they mean, told apart from the grammar: who is spoken of comes first.

"Both red blocks touch at least one blue block" is put together of a subject, a relation and a landmark. Each has its
truth here, of how many of so many blocks it holds; the goal that the front end makes of the sentence has to agree with
that in random states. A refusal is no mistake, but most of these are to be read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import permutations
from random import Random

import pytest

from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import BlockState, World
from rpg.ir import relations as r
from rpg.ir.assets import EDGE
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.frontend import BuiltinFrontEnd

STATES = 16
SAMPLE = 40
"""Sentences of each kind, drawn from all there are."""
READ = 0.7
"""At least so many of them are read."""
PITCHES = (1.0, 1.4, 2.2, 3.2)
"""Distances between places in edges: touching, next to each other, near, and apart."""
ROWS = 3
"""Of a lattice with as many columns."""
ON_TOP = 0.3
"""How often a block lies on another one."""

HowMany = Callable[[int], bool]
Phrase = tuple[str, str, HowMany]
"""Words for so many of the blocks, their verb, and whether it is true of so many of them."""


def all_of(many: int, color: str) -> list[Phrase]:
    """Words for every one of `many` (2 or 3) blocks."""
    singular = [f"each {color} block", f"every {color} block", f"each of the {many} {color} blocks"]
    plural = [f"all {color} blocks", f"all of the {color} blocks"]
    if many == 2:
        plural += [f"both {color} blocks", f"both of the {color} blocks"]
    found = [(words, "is") for words in singular] + [(words, "are") for words in plural]
    return [(words, verb, lambda count: count == many) for words, verb in found]


def none_of(many: int, color: str) -> list[Phrase]:
    """Words for none of them."""
    words = [f"no {color} block", f"none of the {many} {color} blocks", f"not one of the {color} blocks"]
    words += [f"neither {color} block", f"neither of the {color} blocks"] if many == 2 else []
    return [(one, "is", lambda count: count == 0) for one in words]


def some_of(many: int, color: str) -> list[Phrase]:
    """Words for so many of them, or not all."""
    return [
        (f"at least one {color} block", "is", lambda count: count >= 1),
        (f"at least one of the {many} {color} blocks", "is", lambda count: count >= 1),
        (f"one or more of the {color} blocks", "are", lambda count: count >= 1),
        (f"exactly one {color} block", "is", lambda count: count == 1),
        (f"only one of the {many} {color} blocks", "is", lambda count: count == 1),
        (f"at most one of the {color} blocks", "is", lambda count: count <= 1),
        (f"no more than one of the {many} {color} blocks", "is", lambda count: count <= 1),
        (f"not all of the {many} {color} blocks", "are", lambda count: count < many),
        (f"not every {color} block", "is", lambda count: count < many),
        (f"all but one of the {many} {color} blocks", "are", lambda count: count == many - 1),
    ]


RELATIONS: dict[str, Callable[[str, str], r.Touching | r.Beside | r.Near]] = {
    "touching": lambda a, b: r.Touching(a=(a,), b=(b,)),
    "next to": lambda a, b: r.Beside(a=(a,), b=(b,)),
    "near": lambda a, b: r.Near(a=(a,), b=(b,)),
}
Truth = Callable[[list[list[bool]]], bool]
"""Whether a sentence is true, given for each red block to which of the blue ones the relation holds."""


def of_subjects() -> Iterator[tuple[str, Truth]]:
    """ "At most one of the three red blocks is touching the blue block"."""
    before = "There are three red blocks and a blue block."
    for words, verb, so_many in (*all_of(3, "red"), *none_of(3, "red"), *some_of(3, "red")):
        for relation in RELATIONS:
            yield f"{before} {words} {verb} {relation} the blue block. /{relation}", _of_reds(so_many, any)


def of_landmarks() -> Iterator[tuple[str, Truth]]:
    """ "The red block is near none of the three blue blocks"."""
    before = "There are a red block and three blue blocks."
    kinds = (*all_of(3, "blue"), *none_of(3, "blue"), *some_of(3, "blue")[:7])
    for words, _, so_many in kinds:
        for relation in RELATIONS:
            yield f"{before} The red block must be {relation} {words}. /{relation}", _of_blues(so_many)


def of_both() -> Iterator[tuple[str, Truth]]:
    """ "Each red block is next to at least one blue block": one of its own."""
    before = "There are two red blocks and two blue blocks."
    landmarks: list[tuple[str, Callable[[list[bool]], bool]]] = [
        ("at least one blue block", any), ("any of the blue blocks", any), ("both blue blocks", all),
        ("exactly one blue block", lambda told: sum(told) == 1),
    ]  # fmt: skip
    for words, verb, so_many in (*all_of(2, "red"), *none_of(2, "red")):
        for mark, of_blue in landmarks:
            for relation in RELATIONS:
                yield f"{before} {words} {verb} {relation} {mark}. /{relation}", _of_reds(so_many, of_blue)


def _of_reds(so_many: HowMany, of_blue: Callable[[list[bool]], bool]) -> Truth:
    return lambda table: so_many(sum(map(of_blue, table)))


def _of_blues(so_many: HowMany) -> Truth:
    return lambda table: so_many(sum(table[0]))


def states(task: TaskSchema, rng: Random) -> Iterator[BlockState]:
    """Random places on a lattice, some of them on top of others."""
    world, still = World(task.assets), (1.0, 0.0, 0.0, 0.0)
    for _ in range(STATES):
        pitch = rng.choice(PITCHES) * EDGE
        cells = [(x, y) for x in range(ROWS) for y in range(ROWS)]
        rng.shuffle(cells)
        tops: list[tuple[float, float, float]] = []
        position = {}
        for name in rng.sample(list(world.blocks), len(world.blocks)):
            if tops and rng.random() < ON_TOP:
                x, y, z = tops.pop(rng.randrange(len(tops)))
                place = (x, y, z + EDGE)
            else:
                row, column = cells.pop()
                place = (WORKSPACE_X[0] + row * pitch, WORKSPACE_Y[0] + column * pitch, EDGE / 2)
            position[name] = place
            tops.append(place)
        yield BlockState(world, {name: position[name] for name in world.blocks}, dict.fromkeys(world.blocks, still))


def holds(task: TaskSchema, state: BlockState, red: list[str], blue: list[str]) -> bool:
    """Whether the goal is met under some naming of the blocks that look alike."""
    for reds in permutations(red):
        for blues in permutations(blue):
            called = dict(zip(red + blue, (*reds, *blues), strict=True))
            position = {called[name]: at for name, at in state.position.items()}
            if evaluate(task.goal, BlockState(state.world, position, state.orientation)):
                return True
    return False


@pytest.mark.parametrize("kind", [of_subjects, of_landmarks, of_both])
def test_so_many_of_the_ones_and_of_the_others(kind: Callable[[], Iterator[tuple[str, Truth]]]) -> None:
    rng = Random(kind.__name__)
    sentences = sorted(kind(), key=lambda one: one[0])
    chosen = rng.sample(sentences, min(SAMPLE, len(sentences)))
    read = 0
    for said, truth in chosen:
        text, _, relation = said.partition(" /")
        task, _ = BuiltinFrontEnd().read(text, name=None, seed=0, author=None)
        if task is None:
            continue
        read += 1
        red, blue = ([b.name for b in task.blocks if b.color == color] for color in ("red", "blue"))
        for state in states(task, rng):
            table = [[bool(evaluate(RELATIONS[relation](a, b), state)) for b in blue] for a in red]
            assert holds(task, state, red, blue) == truth(table), (text, state.position)
    assert read >= READ * len(chosen)
