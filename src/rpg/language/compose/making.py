"""Further figures: of which blocks they are, and how large."""

from __future__ import annotations

from dataclasses import replace
from math import isqrt, prod

from rpg.blocks.figures import FEWEST
from rpg.language.compose.drawing import drawn
from rpg.language.compose.ordering import as_at_start, put_in_order
from rpg.language.compose.places_of import DRAWN, steps
from rpg.language.compose.scene import Figure, Resolve, Scene, Unclear
from rpg.language.compose.syntax import Both, Chain, Noun, Phrase

_COUNTED = frozenset({"tower", "row", "line", "column", "staircase", "pyramid"})

_SOLID = frozenset({"square", "grid", "wall", "cube"})
"""What is told by how wide, deep and high it is."""


def make(scene: Scene, noun: Noun, kind: str, resolve: Resolve) -> int:
    """A further figure, of further blocks unless its blocks are spoken of."""
    content, size, here = noun.content, noun.size, list(scene.here)
    if isinstance(content, Noun) and content.noun in {"block", "one", ""} and not content.color and content.count \
            and content.det == "" and not content.of and len(size) < 2 and not scene.stock:  # fmt: skip
        if content.bound not in {"", "exactly"} or prod(size or (content.count,)) != content.count:
            raise Unclear
        size, content = size or (content.count,), None
    stocked = _all_there_is(scene, noun, content, size)
    content = None if stocked else content
    figure = Figure(kind, [], size if len(size) > 1 else (), noun.word, way=noun.way, gaps=noun.gaps)
    if noun.word == "pair" and (not isinstance(content, Chain) or len(content.parts) != 2):
        raise Unclear  # of what stands side by side, or of what lies on what
    figure.counted = isinstance(content, Noun) and content.count > 0
    if isinstance(content, Chain):
        _told_in_turn(scene, figure, noun, content, resolve)
    elif content is not None:
        if isinstance(content, Noun) and content.noun == "one" and content.color and content.count and not content.det:
            content = replace(content, noun="block")  # "a row of three red blocks behind a row of three blue ones"
        if isinstance(content, Noun) and content.many and not content.count and content.det == "" and size:
            content = replace(content, count=prod(size))
        ref = resolve(scene, content)
        if ref.kind != "block" or ref.bound or ref.no:
            raise Unclear
        figure.blocks = list(ref.ids)
        labels = [scene.blocks[n].label for n in ref.ids]
        if noun.made == "from" and len(labels) > 2 and all(map(str.isdigit, labels)) and labels == sorted(labels):
            raise Unclear  # "a row from 1 to 5" is in this order, one "from the digits 1 to 5" in any
        figure.free = isinstance(content, Both) and any(isinstance(p, Noun) and p.count > 1 for p in content.parts)
        if noun.order == "alternating":
            figure.blocks, figure.alternates, figure.free = _in_turns(scene, figure), True, False
    elif noun.order == "alternating":
        figure.blocks = _alternating(scene, noun, size)
        figure.alternates = True
    elif noun.word:  # a word or an equation: a block for each of its symbols
        if any(block.label in noun.word for block in scene.blocks if block.label):
            raise Unclear
        figure.blocks = [scene.new_blocks(1, "", letter)[0] for letter in noun.word]
        figure.told = True
    else:
        figure.blocks = stocked or _further(scene, noun, kind, size)
        figure.free = bool(stocked) and not scene.alike(stocked)
    if noun.color and any(scene.blocks[n].color != noun.color for n in figure.blocks):
        raise Unclear
    _check_size(figure, size, noun)
    if noun.limbs:
        _draw(figure, noun)
    if len(figure.blocks) < 2 or _held(scene, kind) & set(figure.blocks):
        raise Unclear
    if noun.order in {"reversed", "kept"}:
        as_at_start(scene, figure, back=noun.order == "reversed")
    elif noun.order not in {"", "listed"} and not figure.alternates:
        put_in_order(scene, figure, noun.order)
    scene.figures.append(figure)
    scene.here = here  # "it" is the figure, not what it is made of
    return len(scene.figures) - 1


def _all_there_is(scene: Scene, noun: Noun, content: Phrase | None, size: tuple[int, ...]) -> list[int]:
    """ "(Two red blocks, two white blocks,) one tower of four": of all that the text said there is, if so many."""
    there = [n for lot in scene.stock for n in lot]
    bare = isinstance(content, Noun) and content == Noun(count=content.count, noun="block", many=True)
    many = content.count if bare and isinstance(content, Noun) else prod(size) if content is None else 0
    used = scene.used | {n for figure in scene.figures for n in figure.blocks}
    plain = not (noun.color or noun.word or noun.limbs) and noun.count < 2 and not noun.many
    return there if there and plain and many == len(there) and not used & set(there) else []


def _further(scene: Scene, noun: Noun, kind: str, size: tuple[int, ...]) -> list[int]:
    """Further blocks that look alike."""
    alike = [f for f in scene.figures if f.kind == kind]
    if noun.det == "another" and not size and alike and noun.color:
        size = (len(alike[-1].blocks),)
    if not noun.color and any(scene.blocks[f.blocks[0]].color or f.stage < 0 for f in scene.figures):
        raise Unclear  # of the same colour as that one, or of another; of its blocks, or of others
    return scene.new_blocks(_how_many(scene, noun, kind, size), noun.color)


def _how_many(scene: Scene, noun: Noun, kind: str, size: tuple[int, ...]) -> int:
    """Of how many blocks a figure is by its size or its parts, or usually; 0 if this is not known."""
    usual = kind == "plus" or (kind in DRAWN and noun.color)
    if usual and not size and scene.stock:
        raise Unclear  # of those that there are
    if noun.limbs and not size and any(told := drawn(kind, noun.limbs, 0)[0]):
        return told[1] + 2 * (told[0] - 1) if kind == "U" else sum(told) - 1
    return prod(size) if all(size) and size else FEWEST[kind] if usual else 0


def _draw(figure: Figure, noun: Noun) -> None:
    """The lengths of a letter, and where it points, as its parts were told."""
    sides, way = drawn(figure.kind, noun.limbs, len(figure.blocks))
    if figure.way and way not in {"", figure.way}:
        raise Unclear
    figure.size, figure.way = sides if any(sides) else (), figure.way or way


def _held(scene: Scene, kind: str) -> set[int]:
    """The blocks of other figures; a row may be of blocks on which others were put."""
    kept = [f for f in scene.figures if scene.at_start or not scene.may_change(f)]
    flat = kind in {"row", "line"}
    return {n for f in kept for n in f.blocks if not (flat and f.implied and n == f.blocks[0])}


def _told_in_turn(scene: Scene, figure: Figure, noun: Noun, content: Chain, resolve: Resolve) -> None:
    """A tower from top to bottom, or a row from the right, of which the blocks are listed."""
    for of in reversed(content.parts):
        figure.blocks.append(_storey(scene, of, resolve, figure.blocks))
    upright = figure.kind == "tower" or (noun.order == "listed" and figure.kind in {"row", "line", "column"})
    if not upright or noun.made.startswith("from") or len(set(figure.blocks)) < len(figure.blocks):
        raise Unclear
    figure.told, figure.sided = True, figure.kind in {"row", "line"}


def _storey(scene: Scene, phrase: Phrase, resolve: Resolve, below: list[int]) -> int:
    """A block of a tower told from top to bottom: one that lies below, or elsewhere, is not meant again."""
    told = isinstance(phrase, Noun) and phrase.color and not phrase.det and phrase.count < 2
    if told and isinstance(phrase, Noun):
        like = [n for n, block in enumerate(scene.blocks) if block.color == phrase.color]
        if like and all(n in below or scene.figure_of(n) for n in like):
            return scene.new_blocks(1, phrase.color)[0]
    if isinstance(phrase, Noun) and phrase.noun == "one" and phrase.det == "a" and phrase.color:
        phrase = replace(phrase, noun="block")
    return _one(scene, phrase, resolve)


def _in_turns(scene: Scene, figure: Figure) -> list[int]:
    """The blocks of a row or a tower, of two looks, in turn: as many of each, or one more of the first."""
    lots: list[list[int]] = []
    for n in figure.blocks:
        like = next((lot for lot in lots if scene.alike([n, lot[0]])), None)
        lots += [[n]] if like is None else []
        if like is not None:
            like.append(n)
    lots.sort(key=len, reverse=True)
    if len(lots) != 2 or len(lots[0]) - len(lots[1]) > 1 or figure.kind not in {"tower", "row", "line"}:
        raise Unclear
    return [lots[n % 2][n // 2] for n in range(len(figure.blocks))]


def _alternating(scene: Scene, noun: Noun, size: tuple[int, ...]) -> list[int]:
    """Blocks of two colours in turn: as many of each, or one more of the first."""
    if len(size) != 1 or not noun.word or noun.noun not in {"tower", "row", "line"} or size[0] < 2:
        raise Unclear
    colors = noun.word.split()
    lots = [iter(scene.new_blocks((size[0] + 1 - n) // 2, color)) for n, color in enumerate(colors)]
    return [next(lots[n % 2]) for n in range(size[0])]


def _one(scene: Scene, phrase: Phrase, resolve: Resolve) -> int:
    ref = resolve(scene, phrase)
    if ref.kind != "block" or len(ref.ids) != 1:
        raise Unclear
    return ref.ids[0]


def _check_size(figure: Figure, size: tuple[int, ...], noun: Noun) -> None:
    """What is said of the size has to fit the blocks. A square of four is two by two, one of nine is filled."""
    many, kind = len(figure.blocks), figure.kind
    if kind not in _SOLID:
        unlike = size and size[0] != many and kind in _COUNTED
        if len(size) > 1 or unlike or (kind == "staircase" and not steps(many)):
            raise Unclear
        return
    side = isqrt(many)
    if kind == "square" and not size and "hollow" not in noun.ranks and (side < 4 or "full" in noun.ranks):
        size = (side, side) if side * side == many else ()
    if kind == "square" and not size and many % 4 == 0 and many >= 8 and (many != 16 or "hollow" in noun.ranks):
        return
    if kind == "cube":
        edge = round(many ** (1 / 3))
        size = size or (edge, edge, edge)
    if kind == "wall" and 0 in size and many % max(size) == 0:
        size = tuple(n or many // max(size) for n in size)
    uneven = kind in {"cube", "square"} and len({*size}) > 1
    if len(size) != (3 if kind == "cube" else 2) or prod(size) != many or uneven:
        raise Unclear
    figure.size = size if kind in {"wall", "cube"} else (size[1], size[0])
    figure.kind = "grid" if kind == "square" else kind
