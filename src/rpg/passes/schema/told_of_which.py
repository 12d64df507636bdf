"""What could be told of something that is there already, or of something further: "between two white ones"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from rpg.ir.goal import Sequence as Ordered
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.structures import Grid, Pyramid, Row, Stack
from rpg.ir.walk import atoms, within
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_SEVERAL = frozenset({"ones", *(noun for noun, plural in lexicon.BLOCK.items() if plural)})
_IN_THAT_ORDER = (("in", "that", "order"), ("in", "this", "order"))
_IN_ITS_PLACE = tuple(
    ("in", "its", *old, place, goes)
    for old in ((), ("old",), ("former",), ("previous",))
    for place in ("place", "spot", "stead")
    for goes in ("goes", "comes", "put")
)
_IN_FRONT_OF_IT = (("in", "front", "of", "it"), ("behind", "it"))
_ON_NEITHER = ((",", "on", "neither"), ("but", "on", "neither"), ("but", "not", "on", "either"))
_SIDES = frozenset({"top", "bottom", "upper", "lower"})
_ENDS = frozenset({".", "!", ";", ",", "and", "in", "into", "as", "up"})
_MADE_OF = frozenset({"stack", "pile", "of", "lay", "put", "line", "arrange"})
_NEAR = 3
"""Colours stand within so many words ahead of the order that they are said to be in."""


def check_of_which(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse what can be told of two things, of which one would be a guess.

    Raises:
        Refusal: "ambiguous", or "misplaced" for an order of which it is not clear what is in it.
    """
    _between_two(words, task)
    if task.assumed(COLORS_UNSAID):
        _of_structures(words)
        _everything_else(words)
    _one_of_a_layer(words, task)
    _each_by_itself(words, task)
    _each_of_those(words)
    _whose_place(words)
    _beside_it_in_order(words)
    _between_or_there(words)
    _neither_of_which(words)
    _in_time(words, task)
    _each_such_counted(words)


def _between_two(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a row of four white blocks and a black one that is between two white ones" as of six white ones."""
    for at in _behind(words, (("between", "two"),)):
        color = lexicon.COLOR.get(words[at].word) if at < len(words) else None
        if color is None or not any(token.word in _SEVERAL for token in words[at + 1 : at + 2]):
            continue
        counted = [number.many for number, hue in pairwise(words[:at]) if lexicon.COLOR.get(hue.word) == color]
        if 1 < max(counted, default=0) < sum(block.color == color for block in task.blocks):
            raise refuse("ambiguous", "these could be two of those before them, or further ones", words[at].span,
                         "say 'two of them', or 'two other'")  # fmt: skip


def _of_structures(words: Sequence[Token]) -> None:
    """Refuse "two towers, the first red, the second blue" as towers of which the first has a red block in it, and "two
    towers, red and green, in that order" as towers of whatever colours."""
    shapes = [lexicon.STRUCTURE[token.word] for token in words if token.word in lexicon.STRUCTURE]
    if len(shapes) < 2 and not any(plural for _, plural in shapes):
        return
    for at in _behind(words, (("the", "first"),)):
        if at < len(words) and words[at].word in lexicon.COLOR:
            raise refuse("ambiguous", f"is the first one {words[at].word}, or its first block?", words[at].span,
                         "say of each of them what it is made of")  # fmt: skip
    for at in _behind(words, _IN_THAT_ORDER):
        begin = at - len(_IN_THAT_ORDER[0])
        if any(token.word in lexicon.COLOR for token in words[max(0, begin - _NEAR) : begin]):
            raise refuse("ambiguous", "are these the colours of the structures, or further blocks?", words[begin].span,
                         "say of each of them what it is made of")  # fmt: skip


def _everything_else(words: Sequence[Token]) -> None:
    """Refuse "a tower with a pink block on top and one of two with pink at the bottom, everything else cyan" as with
    blocks of other colours in one of them."""
    for at in _behind(words, (("everything", "else"), ("all", "else"))):
        if any(token.word in lexicon.COLOR for token in words[at : at + _NEAR]):
            raise refuse("ambiguous", "all blocks of which no colour is said, or only some?", words[at - 1].span,
                         "say of each structure what it is made of")  # fmt: skip


def _one_of_a_layer(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a wall, blue, but one top block is red" as one of which all on top are red."""
    if not any(isinstance(atom, Pyramid | Grid) for atom in atoms(task.goal)):
        return
    for one, side, block in zip(words, words[1:], words[2:], strict=False):
        if one.word == "one" and side.word in _SIDES and block.word in lexicon.BLOCK:
            raise refuse("ambiguous", f"one of the {side.word} blocks, or all of them?", side.span,
                         f"say 'the {side.word} row', or which block of it")  # fmt: skip


def _each_by_itself(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "there are two rows of three. Stack each", and "stack them separately", as one stack of all of them."""
    built = [atom for atom in atoms(task.goal) if isinstance(atom, Stack | Row)]
    if len(built) != 1:
        return
    told = [*(token.word for token in words), "."]
    for at, word in enumerate(told):
        alone = word == "each" and told[at + 1] in _ENDS and at and told[at - 1] in _MADE_OF
        if alone or (word == "separately" and "them" in told[max(0, at - _NEAR) : at]):
            raise refuse("ambiguous", "each by itself, or all of them together?", words[at].span,
                         "say of each structure what becomes of it")  # fmt: skip


def _each_of_those(words: Sequence[Token]) -> None:
    """Refuse "each green block sits on a red one, and each of those on a blue one"."""
    for at in _behind(words, (("each", "of", "those"),)):
        if any(token.word == "each" for token in words[: at - 3]):
            raise refuse("ambiguous", "it is not clear which these are", words[at - 1].span, "name the blocks")


def _whose_place(words: Sequence[Token]) -> None:
    """Refuse "move the green block to the blue mat; in its old place goes the yellow one" as one that stays."""
    for at in _behind(words, _IN_ITS_PLACE):
        if any(token.word in ("put", "move") for token in words[: at - 1]):
            raise refuse("ambiguous", "whose place is this?", words[at - 2].span, "name the place")


def _beside_it_in_order(words: Sequence[Token]) -> None:
    """Refuse "a row of red and blue, with white and black in front of it in that order" as an order of the row."""
    for at in _behind(words, _IN_FRONT_OF_IT):
        follows = tuple(token.word for token in words[at : at + 3]) in _IN_THAT_ORDER
        if follows and any(a.word == "with" and b.word != "the" for a, b in pairwise(words[:at])):
            raise refuse("misplaced", "it is not clear which of the blocks are in this order", words[at].span,
                         "say from which side on they follow, in a sentence of its own")  # fmt: skip


def _between_or_there(words: Sequence[Token]) -> None:
    """Refuse "put red left of blue and in between two green ones" as blue between two green ones."""
    for at in _behind(words, (("in", "between"),)):
        begin = max((n + 1 for n in range(at) if words[n].word in STOPS), default=0)
        listed = at < len(words) and words[at].many > 1 and words[at - 3].word in (",", "and")
        told = [n for n in range(begin, at - 2) if words[n].word in lexicon.COLOR and not _of_patch(words, n)]
        if listed and len(told) > 1:
            raise refuse("ambiguous", "these could lie there, or what is told before lies between them",
                         words[at - 1].span, "say 'in between are ...', or name what is between them")  # fmt: skip


def _of_patch(words: Sequence[Token], at: int) -> bool:
    return at + 1 < len(words) and words[at + 1].word in lexicon.PATCH


def _neither_of_which(words: Sequence[Token]) -> None:
    """Refuse "put red next to both blue ones but on neither, and green on both" as green on neither."""
    for at in _behind(words, _ON_NEITHER):
        if any(token.word == "both" for token in words[at:]):
            raise refuse(
                "ambiguous", "which block is on neither?", words[at - 1].span, "say it in a sentence of its own"
            )


def _in_time(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "first the tower, last the row; in between put yellow on the mat" as yellow in the middle of the row."""
    said = {token.word for token in words}
    begun = bool(said & {"begin", "start"})  # "begin with the tower and end with the row; in between put ..."
    several = sum(token.word in lexicon.STRUCTURE and token.word not in lexicon.PATCH for token in words) > 1
    for at in _behind(words, (("in", "between"),)) if {"first", "last"} <= said or begun else ():
        done = begun and several and any(token.word in lexicon.COMMANDS for token in words[at : at + 1])
        if done or any(isinstance(part, Ordered) for part in within(task.goal)):
            raise refuse("ambiguous", "is this a place, or a time?", words[at - 1].span, "say what is done when")


def _each_such_counted(words: Sequence[Token]) -> None:
    """Refuse "put blue on each red block that is on the mat; two of the three red blocks are on the mat", where it
    would be told of all three that they are."""
    each = any(token.word in ("each", "every") for token in words)
    such = [at for at in _behind(words, (("that", "is"), ("which", "is"))) if each]
    for at in _behind(words, (("of", "the"),)) if such else ():
        if words[at - 3].many and at < len(words) and words[at].many > words[at - 3].many:
            raise refuse("ambiguous", "it is not clear of which of them this is told", words[at].span,
                         "say first where the blocks are at the start")  # fmt: skip


def _behind(words: Sequence[Token], phrases: Sequence[tuple[str, ...]]) -> Iterator[int]:
    """The positions behind these words."""
    told = [token.word for token in words]
    for at in range(len(told)):
        yield from (at + len(phrase) for phrase in phrases if tuple(told[at : at + len(phrase)]) == phrase)
