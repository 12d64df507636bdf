"""What could be told of something that is there already, or of something further: "between two white ones"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_ONES = frozenset({"ones", *(noun for noun, plural in lexicon.BLOCK.items() if plural)})
_OLD = frozenset({"old", "former", "previous"})


def check_of_which(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse what can be told of two things, of which one would be a guess."""
    _between_two(words, task)
    _the_first(words, task)
    told = [token.word for token in words]
    for at in range(len(words)):
        ahead, here = told[:at], told[at:]
        if here[:2] == ["in", "its"] and _at_its_place(here[2:]) and not {"put", "move"}.isdisjoint(ahead):
            raise refuse("ambiguous", "whose place is this?", words[at].span, "name the place")
        if here[:3] == ["each", "of", "those"] and "each" in ahead:
            raise refuse("ambiguous", "it is not clear which these are", words[at].span, "name the blocks")
        if here[:2] == ["with", "the"] or here[:1] != ["with"]:
            continue
        side = next((n for n in range(at, len(words) - 2) if told[n + 1 : n + 3] == ["it", "in"]), None)
        beside = side is not None and (told[side] == "behind" or told[side - 2 : side + 1] == ["in", "front", "of"])
        if side is not None and beside and told[side + 3 : side + 5] in (["that", "order"], ["this", "order"]):
            raise refuse("misplaced", "it is not clear which of the blocks are in this order", words[side + 3].span,
                         "say from which side on they follow, in a sentence of its own")  # fmt: skip


def _at_its_place(words: Sequence[str]) -> bool:
    """ "... (in its) old place goes the green one"."""
    old = bool(words) and words[0] in _OLD
    return list(words[old : old + 2]) in (["place", "goes"], ["place", "comes"], ["spot", "goes"], ["place", "put"])


def _between_two(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of four white blocks and a black one that is between two white ones" as of six white ones."""
    for color, at in _colors_behind(words, ("between", "two")):
        many = sum(block.color == color for block in task.blocks)
        counted = max((lexicon.NUMBER.get(words[n].word, 0) for n, c in _counted(words[:at]) if c == color), default=0)
        if 1 < counted < many and words[at + 1].word in _ONES:
            raise refuse("ambiguous", "these could be two of those before them, or further ones", words[at].span,
                         "say 'two of them', or 'two other'")  # fmt: skip


def _counted(words: Sequence[Token]) -> Iterator[tuple[int, str]]:
    """Where a number stands in front of a colour."""
    for n in range(len(words) - 1):
        color = lexicon.COLOR.get(words[n + 1].word)
        if color is not None and words[n].word in lexicon.NUMBER:
            yield n, color


def _the_first(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two towers, the first red, the second blue" as towers of which the first has a red block in it, and "two
    towers, red and green, in that order" as towers of whatever colours."""
    if not task.assumed(COLORS_UNSAID):
        return
    shapes = [lexicon.STRUCTURE[token.word] for token in words if token.word in lexicon.STRUCTURE]
    several = len(shapes) > 1 or any(plural for _, plural in shapes)
    for color, at in _colors_behind(words, ("the", "first")) if several else ():
        raise refuse("ambiguous", f"is the first one {color}, or its first block?", words[at].span,
                     "say of each of them what it is made of")  # fmt: skip
    told = [token.word for token in words]
    orders = [
        n
        for n in range(len(told) - 2)
        if told[n] == "in" and told[n + 1] in ("that", "this") and told[n + 2] == "order"
    ]
    for n in orders if several else ():
        if any(token.word in lexicon.COLOR for token in words[max(0, n - 3) : n]):
            raise refuse("ambiguous", "are these the colours of the structures, or further blocks?", words[n].span,
                         "say of each of them what it is made of")  # fmt: skip


def _colors_behind(words: Sequence[Token], ahead: tuple[str, str]) -> Iterator[tuple[str, int]]:
    """Colours that stand behind two words, and where."""
    for n in range(len(words) - 3):
        color = lexicon.COLOR.get(words[n + 2].word)
        if color is not None and (words[n].word, words[n + 1].word) == ahead:
            yield color, n + 2
