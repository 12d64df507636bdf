"""Blocks that a task has more often than they are told, or less often: "each has a white block on top", "one blue block
on top of both", "the blue block between two towers"; and parts of figures that were taken for blocks besides."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import chain, pairwise

from rpg.ir.assets import SemanticCube
from rpg.ir.node import members
from rpg.ir.relations import Above, Clear, On
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Grid, Stack
from rpg.ir.walk import atoms, names
from rpg.language import lexicon
from rpg.language.compared_and_counted import left_over
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, LINE, MANY, PATCH, PATCHES, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_A_LOOK = rf"an? (?P<look>{COLOR}) {CUBE}"
_EACH_HAS = on_demand(
    rf"[.;] (?:each|both|every one|all)(?: one)?(?: of (?:them|these|those))? (?:has|have|gets?|carr(?:y|ies)|bears?) "
    rf"{_A_LOOK} (?:on|at) (?:(?:the |its |their )?(?:top|bottom)|it|them)\b"
)
_WITH_ONE = rf"\b(?P<look>{COLOR}) {CUBE} with an? (?P<other>{COLOR}) (?:one|{CUBE})\b"
_EACH_OF = rf"\beach of the (?:\w+ ){{0,2}}(?:{PATCHES}|corners)\b"
_WITH_ONE_EACH = (on_demand(rf"{_EACH_OF}[^.;!?]*{_WITH_ONE}"), on_demand(rf"{_WITH_ONE}[^.;!?]*{_EACH_OF}"))
_UPON = "(?:on|onto|on top of|atop|across|over)"
_BOTH = (
    rf"{_UPON} (?:both|all(?: of)? (?:four|three|of (?:them|these|those)))\b"
    rf"(?! (?:of )?(?:the )?(?:\w+ )?(?:{PATCH}|{PATCHES}|sides|ends|corners)\b)"
)
_ONE = rf"\b(?:one|a single|single|plain|an?) (?P<look>{COLOR}) {CUBE}\b"
_ONE_ON_BOTH = (
    on_demand(rf"{_ONE}(?: \w+){{0,3}}? {_BOTH}"),
    on_demand(rf"{_BOTH}(?: of (?:them|these|those|the \w+))?(?: \w+){{0,2}}? {_ONE}"),
)
_ONE_ON_THEM = on_demand(rf"{_ONE.replace('|an?)', ')')}(?: \w+){{0,3}}? {_UPON} them\b")
_BETWEEN_TOWERS = on_demand(
    rf"\b(?:the|an?|one) (?P<look>\w+) {CUBE} (?:\w+ ){{0,3}}?between (?:the )?two (?:\w+ )?(?:towers|stacks|piles)\b"
)
_IN_THE_MIDDLE = on_demand(
    rf"(?:[,.;] |\bwith |\band )the ({COLOR}) (?:one|{LINE}) (?:\w+ )?in the (?:middle|center)\b"
)
_EMPTY_THERE = on_demand(
    r"\b(?:middle|center|corner|place|spot|cell)\b(?: [a-z0-9]+)*? (?:empty|vacant|unoccupied)\b"
    r"|\b(?:leav\w+|keep\w*) (?:its|the) (?:\w+ ){0,2}(?:middle|center|corner)(?: of the \w+(?: \w+)?)? free\b"
)
_ON_ITS_LINE = on_demand(r"\bon (?:top of )?(?:its|the|this|that) (?:\w+ )?(?:row|column)\b")
_PUT = frozenset({"put", "place", "lay", "set", "stack", "add", "pile", "lie", "lies", "rest", "rests", "sit", "sits"})
_FILLED = on_demand(
    rf"\b(?P<rows>\d)x(?P<columns>\d) (?:grid|square|rectangle|array|matrix) (?:made )?(?:out )?of (?:{MANY} )?"
    rf"(?P<look>{COLOR})\b"
)
_CALLED = on_demand(rf"\b(?:{LINE}|pile|pyramid|grid) ([a-z]|\d) (?:has|is|consists|contains)\b")
_ONE_BEYOND = on_demand(
    rf"\bthe (?:next )?(?:one|{CUBE}) (?:\w+ )?(?:above|over|below|under|beneath|underneath) (?:it|that)\b"
)
_Asked = Iterator[tuple[str, str]]


def check_had_so_often(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task that has a block for each of several where one is told for all, or one for all where each has one,
    and one in which a part of a figure that was told became a block besides.

    Raises:
        Refusal: "misplaced", where it may make sense otherwise, or "ambiguous".
    """
    text = " ".join(token.word for token in tokens)
    whole = (tokens[0].span[0], tokens[-1].span[1])
    looks = Counter(chain.from_iterable(_looks(block) for block in task.blocks))
    for message, hint in chain(_too_few(text, looks), _too_many(text, looks), _besides(text, task)):
        raise refuse("misplaced", message, whole, hint)
    for message, hint in _which(text, looks, task):
        raise refuse("ambiguous", message, whole, hint)


def _looks(block: object) -> Iterator[str]:
    """The colour of a block, and what is on it."""
    yield str(getattr(block, "color", ""))
    if isinstance(block, SemanticCube) and block.label:
        yield block.label.lower()


def _too_few(text: str, looks: Counter[str]) -> _Asked:
    """ "(A red and a blue tower.) Each has a white block on top", "on each of the mats a red block with a blue one"."""
    for found in _EACH_HAS.finditer(text):
        if looks[lexicon.COLOR[found["look"]]] == 1:
            yield "each of them has one, and there is only one", "say on which of them it is"
    for found in chain.from_iterable(pattern.finditer(text) for pattern in _WITH_ONE_EACH):
        if looks[lexicon.COLOR[found["other"]]] == 1 < looks[lexicon.COLOR[found["look"]]]:
            yield "one for each of them, or for one of them?", f"say 'each {found['look']} block' in another sentence"


def _too_many(text: str, looks: Counter[str]) -> _Asked:
    """ "The blue block lies between two towers, each with a red base and a green top": in between, and not in them."""
    for found in _BETWEEN_TOWERS.finditer(text):
        color = lexicon.COLOR.get(found["look"])
        if looks[color or found["look"]] > 1 and (not color or text.split().count(found["look"]) == 1):
            yield "one block between the towers, or one in each of them?", "say what is in each of the towers"
    for found in _IN_THE_MIDDLE.finditer(text):
        counted = [number(many) for many in _numbers_of(found[1], text)]
        if counted and min(counted) > 1 and looks[lexicon.COLOR[found[1]]] > sum(counted):
            yield "another block in the middle, or the one that was told?", "say between which others it is"


def _numbers_of(look: str, text: str) -> list[str]:
    """How many blocks of a look are told, one lot after the other."""
    words = text.split()
    return [many for many, what in pairwise(words)
            if what == look and (many.isdigit() or many in lexicon.NUMBER)]  # fmt: skip


def _besides(text: str, task: TaskSchema) -> _Asked:
    """ "A 2x3 grid of blue blocks; put three red ones on its back row": on it, and not in it; "(the second one is red,)
    the one above it is blue": one of the tower, and not above it."""
    found = _FILLED.search(text)
    if found is not None and _ON_ITS_LINE.search(text, found.end()) and not _PUT.isdisjoint(text.split()):
        color = lexicon.COLOR[found["look"]]
        there = {block.name for block in task.blocks if block.color == color}
        grids = [{*names(x)} for x in atoms(task.goal) if isinstance(x, Grid)]
        if any(len(grid & there) < int(found["rows"]) * int(found["columns"]) for grid in grids):
            yield "are these on blocks of the figure, or in their place?", "say on which blocks they lie"
    if _ONE_BEYOND.search(text):
        stacks = [{*names(x)} for x in atoms(task.goal) if isinstance(x, Stack)]
        beyond = [x for x in atoms(task.goal) if isinstance(x, Above)]
        if any(len({*names(x)} & stack) == 1 for x in beyond for stack in stacks):
            yield "one of these, or a further one?", "count the blocks from one end"


def _which(text: str, looks: Counter[str], task: TaskSchema) -> _Asked:
    """ "One blue block on top of both", "leave the corner of the square empty", "tower A has ...; A is left of B",
    "twice as many red as blue blocks: four red ones"."""
    asked = "one block that lies across them, or one on each?", "say 'each', or on which blocks it lies"
    for pattern in (*_ONE_ON_BOTH, _ONE_ON_THEM):
        for found in pattern.finditer(text):
            color, told = lexicon.COLOR[found["look"]], text.split().count(found["look"])
            if text[found.end() :].split()[:1] in (["end"], ["ends"], ["outer"], ["corner"], ["corners"]):
                continue  # "on both end blocks": one on each
            alone = pattern is not _ONE_ON_THEM and looks[color] == 1
            if told == 1 and (looks[color] > 1 or (alone and _on_one(color, task))):
                yield asked
    if task.assumed("a block on four others") and not {"towers", "stacks", "piles"}.isdisjoint(text.split()):
        yield "a block across towers, or one on each?", "say on which blocks it lies"
    if _EMPTY_THERE.search(text):
        grids = [{*names(x)} for x in atoms(task.goal) if isinstance(x, Grid)]
        if any({*names(x)} & grid for x in atoms(task.goal) if isinstance(x, Clear) for grid in grids):
            yield "no block there, or none on top of it?", "say of which shape the blocks are"
    for found in _CALLED.finditer(text):
        if looks[found[1]] and not _cubes_called(found[1], text):
            yield (
                f"is {found[1].upper()!r} the figure that is called so, or a block?",
                "say 'the tower', or 'the block'",
            )
    if left_over(text):
        yield "so many that are there, or so many of all?", "say it in a sentence of its own"


def _on_one(color: str, task: TaskSchema) -> bool:
    """Whether the one block of a colour has to be on one other, or on one tower, and that is all."""
    (name,) = (block.name for block in task.blocks if block.color == color)
    told = [x for x in atoms(task.goal) if name in names(x)]
    return len(told) == 1 and isinstance(told[0], On) and name in members(told[0].a)


def _cubes_called(name: str, text: str) -> bool:
    """Whether a block that shows this is told of."""
    words = text.split()
    return any(a in lexicon.BLOCK or b in lexicon.BLOCK for a, what, b in zip(words, words[1:], words[2:], strict=False)
               if what == name)  # fmt: skip
