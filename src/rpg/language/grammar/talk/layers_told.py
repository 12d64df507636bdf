"""Pyramids and filled triangles told layer by layer: "a 3x3 base, then 2x2, then a single cube on top" is a pyramid
with a 3x3 base, "three along the base, then two, then one" one with a base of three."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_SHAPES = frozenset({"pyramid", "triangle"})
_JOINTS = frozenset({",", ":", ";", "then", "and", "finally", "(", "with", "of"})
_THING = "cubes|blocks|bricks|cube|block|brick|ones|one|more"
_HERE = Patterns(
    f"{_THING}? base|layer|row|bottom|top|tip|square|level|footprint",
    f"{_THING}? at|on|in|as|along|for|forming the|its|a? very? bottom|base|ground|top|tip|peak|apex|second_row|"
    "second_layer|third_row|third_layer|next_row|next_layer|middle|bottom_row|bottom_layer|top_row|top_layer|first_row|"
    "first_layer|middle_row|middle_layer|front|back|front_row|back_row|far_row|near_row",
    f"{_THING}? on|above|over|behind|on_top_of|upon it|them|that|those|these|that_one|these_ones",
    f"{_THING}? on|as top|base|tip",
    f"{_THING}? above|below|next|underneath|over",
    _THING,
)
_HIGH = frozenset({"top", "tip", "peak", "above", "over", "upon"})
_LOW = frozenset({"bottom", "base", "ground", "below", "underneath"})
"""Where the lowest layer is not, and where the others are not."""
_DEPTH = Patterns("one|a_single|1|only_one|just_one block|cube|layer deep|thick|wide", "one|1 deep")


def in_layers(part: list[Token]) -> list[Token]:
    """The tokens with the size of the base for the layers of a pyramid or a filled triangle."""
    p = Parser(part)
    shape = next((i for i in range(p.end) if p.words[i] in _SHAPES), None)
    if shape is None:
        return part
    if p.words[shape] == "pyramid" and not any(token.kind == "dims" for token in part):
        part = _one_deep(part, shape)
        p = Parser(part)
    for i in range(shape + 1, p.end):
        if part[i].many or part[i].kind == "dims":
            break  # what stands further on is not all of it
        if p.words[i] not in _JOINTS or p.words[i - 1] in _JOINTS:
            continue
        base, end = _layers(p, part, i)
        if base is None or not (end >= p.end or p.stands(end, (",", ";", ".", ")"))):
            continue
        rest = part[p.opt(end, ")") :]
        if p.words[shape] == "triangle":
            return [*_of_so_many(part[:i], shape, base), *rest]
        return [*part[:i], *_with_base(part[i], base), *rest]
    return part


def _with_base(like: Token, base: Token) -> list[Token]:
    if base.kind == "dims":
        return [like.saying("with"), like.saying("a"), base, like.saying("base")]
    return [*(like.saying(word) for word in ("with", "a", "base", "of")), base, like.saying("blocks")]


def _of_so_many(part: list[Token], shape: int, base: Token) -> list[Token]:
    """The tokens up to the layers, with how many blocks a filled triangle has where that is not told."""
    before = [] if "filled" in (token.word for token in part) else [part[shape].saying("filled")]
    out = [*part[:shape], *before, *part[shape:]]
    if any(token.many > 1 for token in part):
        return out
    total = base.many * (base.many + 1) // 2
    many = replace(part[shape], kind="number", word=str(total), raw=str(total), value=float(total))
    after = shape + len(before) + 2
    if out[after - 1 : after] and out[after - 1].word == "of":
        return [*out[:after], many, *out[after:]]
    return [*out, part[shape].saying("of"), many, part[shape].saying("blocks")]


def _layers(p: Parser, part: list[Token], i: int) -> tuple[Token | None, int]:
    """The lowest of the layers that stand behind i, each smaller by one than the one before and one block the last;
    and the position after them."""
    sizes: list[int] = []
    base, square = None, False
    while i < p.end:
        start = i
        while p.stands(start, _JOINTS):
            start += 1
        start = p.opt(start, "a", "an", "the")
        token = part[start] if start < p.end else None
        size, at, dims = _size(p, token, start)
        if (
            size is None
            or token is None
            or (sizes and size != sizes[-1] - 1)
            or (dims != square and sizes and size > 1)
        ):
            break
        base, square = base or token, square if sizes else dims
        sizes.append(size)
        i = max(_HERE.matches(p, at), default=at)
        if not (_LOW if len(sizes) > 1 else _HIGH).isdisjoint(p.words[at:i]):
            break  # a pyramid upside down
        if size == 1:
            return (base if len(sizes) > 1 else None), i
    return None, i


def _size(p: Parser, token: Token | None, i: int) -> tuple[int | None, int, bool]:
    """How many blocks a layer has along a side, the position after it, and whether it is a square."""
    if token is not None and token.kind == "dims" and isinstance(token.value, tuple):
        one = len({*token.value}) == 1 and len(token.value) == 2
        return (token.value[0] if one else None), i + 1, True
    if p.stands(i, ("single",)):
        return 1, i + 1, False
    many = token.many if token is not None else 0
    if p.words[i - 1] in ("a", "an") and p.peek(i, lexicon.BLOCK) is False:
        return 1, i, False
    return (many or None), p.opt(i + 1, "single") if many == 1 else i + 1, False


def _one_deep(part: list[Token], shape: int) -> list[Token]:
    """The tokens without "one block deep", which a pyramid is that is told so."""
    p = Parser(part)
    for i in range(shape + 1, p.end):
        for j in sorted(_DEPTH.matches(p, i), reverse=True):
            return [*part[: i - 1 if p.words[i - 1] in (",", "that_is") else i], *part[j:]]
    return part
