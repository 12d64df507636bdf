"""Blocks that are told by their size: "the small yellow block on the big one", "three big red blocks"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.scene import Ref, Scene, Unclear
from rpg.language.compose.syntax import ALL, Noun

_OTHER = {"big": "small", "small": "big"}
_HEIGHT = {"big": "tall", "small": "short"}
_TWO = 2


def is_of_blocks(scene: Scene, noun: Noun) -> bool:
    """Whether a size is one of blocks: "the big one" of towers is the tall one."""
    built = any(not figure.implied for figure in scene.figures)
    return noun.of is None and (noun.noun == "block" or (noun.noun in {"one", ""} and not built))


def of_heights(noun: Noun) -> Noun:
    """ "The bigger tower" is the taller one."""
    return replace(noun, ranks=tuple(_HEIGHT.get(rank, rank) for rank in noun.ranks))


def sized(scene: Scene, noun: Noun) -> Ref:
    """Blocks of that size that are there, one of two of which no size was told, or further ones.

    Raises Unclear where it may be any of them.
    """
    if len(noun.ranks) != 1 or noun.nth or noun.content is not None or noun.bound or noun.det in {"any", "no", "other"}:
        raise Unclear
    size = noun.ranks[0]
    fits = [n for n, block in enumerate(scene.blocks) if noun.color in {"", block.color} and not block.label]
    like = [n for n in fits if scene.blocks[n].size == size]
    definite, many = noun.det in {"the", *ALL}, noun.many or noun.det in ALL or noun.count > 1
    if definite and not like and not many:
        like = _one_of_two(scene, fits, size)
    if definite and like:
        if (noun.count and noun.count != len(like)) or (not many and len(like) > 1):
            raise Unclear
        return Ref("block", like, each=noun.det == "each", every=noun.det in ALL)
    if like or noun.det == "another" or (many and not noun.count) or (noun.det in ALL and not noun.color):
        raise Unclear
    if any(not scene.blocks[n].size for n in fits) or (not noun.color and (definite or scene.blocks)):
        raise Unclear  # one of those of which no size, or no colour, was told
    return Ref("block", scene.new_blocks(noun.count or 1, noun.color, size=size), fresh=True)


def _one_of_two(scene: Scene, fits: list[int], size: str) -> list[int]:
    """ "(Two green blocks,) the small one": one of them, and the other one is big."""
    plain = [n for n in fits if not scene.blocks[n].size]
    other = [n for n in fits if scene.blocks[n].size == _OTHER[size]]
    if not plain:
        return []
    if len(plain) + len(other) != _TWO or not scene.alike(plain) or scene.used & set(plain):
        raise Unclear
    scene.blocks[plain[0]].size = size
    return plain[:1]
