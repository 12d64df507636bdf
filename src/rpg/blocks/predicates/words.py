"""spells, equation: symbols that are read one after the other along a row or down a stack."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, islice, pairwise, product
from random import Random
from typing import Any

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.equations import is_true, plain, same_equation, solutions
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.common import put, set_aside, shift, stand_on, strangers, swap
from rpg.blocks.predicates.plainly import piled, straight
from rpg.blocks.predicates.reading import apart, legible, unreadable
from rpg.blocks.predicates.row import best_line, gap_too_large, lay, lined_up, spacing
from rpg.blocks.predicates.stack import alone, chain, column
from rpg.blocks.predicates.vertical import DIRECTLY, GROUND
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.blocks.traits import AWAY, TO_VIEWER, UP, Traits, symbol_of, symbols_shown
from rpg.blocks.verdict import FALSE, Verdict, every, holds
from rpg.ir.structures import Equation, Row, Spells

MAX_CHOICES = 200
"""How many choices among cubes with the same symbol are looked at."""
MAX_BUILDS = 6
READING = Row(blocks=("",), axis="y")
"""The tolerances of a row that is read from left to right."""


def row_for(gap_edges: float, excused: tuple[str, ...] = ()) -> Row:
    """The row that a text stands in."""
    return READING.model_copy(update={"gap_edges": gap_edges, "excused": excused, "readable": True})


def well_read(state: BlockState, sequence: Sequence[str], node: Spells | Equation, readable: bool) -> Verdict:
    """`sequence`, in reading order, is a row from left to right (or a stack from its top), legible and by itself."""
    if node.along == "stack":
        upward = list(sequence)[::-1]
        parts = [chain(state, upward), alone(state, upward, node.covered)]
        if readable:
            parts.append(legible(state, upward, TO_VIEWER, UP, node.excused))
        return every(parts)
    line = best_line(state, sequence)
    if line.sequence != list(sequence):
        return FALSE
    row = READING if node.gap_edges == READING.gap_edges else row_for(node.gap_edges)
    parts = [
        holds(min(lined_up(line, state, row), spacing(row, sequence, state))),
        apart(state, line, node.gap_edges, node.covered, beside=node.beside),
    ]
    if readable:
        parts.append(legible(state, sequence, UP, AWAY, node.excused))
    return every(parts)


def in_reading_order(state: BlockState, names: Sequence[str], along: str) -> list[str]:
    """Blocks from left to right, or from the top down."""
    if along == "stack":
        return sorted(names, key=lambda name: -state.position[name][2])
    return best_line(state, names).sequence


def _set_out(node: Spells | Equation, many: Centres) -> Mask:
    """The states in which all the cubes of a text may stand in one row, or in one stack."""
    if node.along == "stack":
        return piled(many, node.blocks, DIRECTLY)
    return straight(many, READING, node.blocks, READING.axis)


def text_misses(
    state: BlockState, sequence: Sequence[str], node: Spells | Equation, readable: bool
) -> Iterator[NearMiss]:
    """What spoils any text: a symbol out of its place, a gap, another block next to it, an unreadable symbol."""
    stack = node.along == "stack"
    if len(sequence) > 1:
        middle = sequence[len(sequence) // 2]
        edge = state.world.edge[middle]
        if stack:
            yield NearMiss(f"{sequence[0]} set down on the table", set_aside(state, sequence[0]))
            yield NearMiss(f"{sequence[0]} past the edge", shift(state, sequence[:1], 0.0, edge * 0.5 + 0.006))
        else:
            yield NearMiss(f"{middle} out of the line", shift(state, [middle], -2.0 * edge, 0.0))
            yield gap_too_large(row_for(node.gap_edges), best_line(state, sequence), state)
    others = [name for name in strangers(state, sequence) if stack or name not in node.beside]
    if others and not (stack and sequence[0] in node.covered):
        yield NearMiss(f"{others[0]} adjoins the text", _adjoin(state, others[0], sequence, stack))
    if readable:
        normal, up = (TO_VIEWER, UP) if stack else (UP, AWAY)
        yield from unreadable(state, sequence, normal, up, node.excused)


def _adjoin(state: BlockState, other: str, sequence: Sequence[str], stack: bool) -> BlockState:
    if stack:
        return stand_on(state, other, sequence[0])
    x, y, z = state.position[sequence[-1]]
    edges = state.world.edge
    lift = (edges[other] - edges[sequence[-1]]) / 2
    return put(state, other, (x, y - (edges[other] + edges[sequence[-1]]) / 2 - 0.01, z + lift), IDENTITY)


class SpellsPredicate(Predicate[Spells]):
    """Some choice of cubes with the word's letters stands in its order, and nothing else adjoins them."""

    def evaluate(self, node: Spells, state: BlockState) -> Verdict:
        word = _as_read(node)
        shown = symbols_shown(state, node.blocks, TO_VIEWER if node.along == "stack" else UP)
        traits = Traits(state.world, shown)
        best = FALSE
        for chosen in _choices(word, node.blocks, traits):
            sequence = in_reading_order(state, chosen, node.along)
            if "".join(traits.symbol(name) for name in sequence) != word:
                continue
            found = well_read(state, sequence, node, node.readable)
            best = max(best, found, key=lambda v: (v.value, v.margin))
        return best

    def perhaps(self, node: Spells, many: Centres) -> Mask:
        return _set_out(node, many) if len(node.word) == len(node.blocks) else many.all()

    def build(self, node: Spells, world: World, rng: Random) -> Iterator[list[Cluster]]:
        traits = Traits(world)
        for chosen in islice(_choices(_as_read(node), node.blocks, traits), MAX_BUILDS):
            yield from _text_clusters(_spelled(_as_read(node), chosen, traits), node, world)

    def supports(self, node: Spells, world: World) -> Iterable[tuple[str, str]]:
        if node.along == "stack" and len(set(node.word)) == len(node.word) == len(node.blocks):
            traits = Traits(world)
            down = _spelled(_as_read(node), node.blocks, traits)
            yield from pairwise(down)
            yield down[-1], GROUND

    def near_misses(self, node: Spells, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        sequence = self._standing(node, state)
        if sequence is None:
            return
        word = _as_read(node)
        for k, (a, b) in enumerate(pairwise(sequence)):
            if word[k] != word[k + 1]:
                yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
        if len(sequence) > 2 and word[0] != word[-1]:
            yield NearMiss(f"{sequence[0]} and {sequence[-1]} exchanged", swap(state, sequence[0], sequence[-1]))
        yield from text_misses(state, sequence, node, node.readable)

    def _standing(self, node: Spells, state: BlockState) -> list[str] | None:
        """The cubes that spell the word in `state`, in reading order."""
        word = _as_read(node)
        traits = Traits(state.world, symbols_shown(state, node.blocks, TO_VIEWER if node.along == "stack" else UP))
        for chosen in _choices(word, node.blocks, traits):
            sequence = in_reading_order(state, chosen, node.along)
            spelled = "".join(traits.symbol(name) for name in sequence)
            if spelled == word and well_read(state, sequence, node, node.readable):
                return sequence
        return None


def _as_read(node: Spells) -> str:
    """The symbols in reading order."""
    word = node.word.upper()
    return word[::-1] if node.reverse else word


def _choices(word: str, names: Sequence[str], traits: Traits) -> Iterator[tuple[str, ...]]:
    """Choices of blocks with just the symbols of `word`."""
    letters = sorted(set(word))
    options = []
    for letter in letters:
        having = [name for name in names if traits.symbol(name) == letter]
        options.append(list(islice(combinations(having, word.count(letter)), MAX_CHOICES)))
    for choice in islice(product(*options), MAX_CHOICES):
        yield tuple(name for part in choice for name in part)


def _spelled(word: str, names: Sequence[str], traits: Traits) -> list[str]:
    """`names` in the order of `word`."""
    pool = list(names)
    sequence = []
    for letter in word:
        name = next(n for n in pool if traits.symbol(n) == letter)
        pool.remove(name)
        sequence.append(name)
    return sequence


def _text_clusters(sequence: Sequence[str], node: Spells | Equation, world: World) -> Iterator[list[Cluster]]:
    """The row or the stack of a text, all symbols upright."""
    if node.along == "stack":
        yield [column(list(sequence)[::-1], world, IDENTITY, node.excused)]
        return
    row = lay(row_for(node.gap_edges, node.excused), list(sequence), 0.0, world)
    if row is not None:
        yield [row]


class EquationPredicate(Predicate[Equation]):
    """All the cubes, in reading order, form a true equation."""

    def evaluate(self, node: Equation, state: BlockState) -> Verdict:
        sequence = in_reading_order(state, node.blocks, node.along)
        traits = Traits(state.world, symbols_shown(state, node.blocks, TO_VIEWER if node.along == "stack" else UP))
        if not self._says(node, "".join(traits.symbol(name) or "?" for name in sequence)):
            return FALSE
        return well_read(state, sequence, node, True)

    def perhaps(self, node: Equation, many: Centres) -> Mask:
        return _set_out(node, many)

    def _says(self, node: Equation, text: str) -> bool:
        """Is `text` the equation that is asked for, or any true one?"""
        return is_true(text, node.longer) and (node.text is None or same_equation(text, plain(node.text)))

    def build(self, node: Equation, world: World, rng: Random) -> Iterator[list[Cluster]]:
        traits = Traits(world)
        symbols = [symbol_of(world, name) for name in node.blocks]
        if not all(symbols):
            return
        texts = solutions(symbols, node.longer) if node.text is None else iter([plain(node.text)])
        for text in islice(texts, MAX_BUILDS):
            if sorted(text) == sorted(symbols):
                yield from _text_clusters(_spelled(text, node.blocks, traits), node, world)

    def near_misses(self, node: Equation, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        sequence = in_reading_order(state, node.blocks, node.along)
        traits = Traits(state.world, symbols_shown(state, node.blocks, TO_VIEWER if node.along == "stack" else UP))
        symbols = [traits.symbol(name) for name in sequence]
        for i in range(len(symbols)):
            j = next((j for j in range(i + 1, len(symbols)) if not self._says(node, _exchanged(symbols, i, j))), None)
            if j is not None:
                a, b = sequence[i], sequence[j]
                yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
        yield from text_misses(state, sequence, node, True)


def _exchanged(symbols: Sequence[str], i: int, j: int) -> str:
    changed = list(symbols)
    changed[i], changed[j] = changed[j], changed[i]
    return "".join(changed)


TABLE: dict[str, Predicate[Any]] = {"spells": SpellsPredicate(), "equation": EquationPredicate()}
