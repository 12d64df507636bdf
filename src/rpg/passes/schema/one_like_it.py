"""What "one" is of, where it could be a block, or like what was named before it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise, takewhile

from rpg.ir.assets import SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.resolve.things.world import refuse

_ENDS = frozenset({"(", ")"})


def check_one_like_it(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "build a red tower of two next to a green one", "a red A on a blue one" as something beside a block, or
    beside a tower of as many blocks as nobody said."""
    if all(token.word != "one" for token in words):
        return
    _check_built(words, task)
    counted = any(token.kind == "number" or lexicon.NUMBER.get(token.word, 0) > 1 for token in words)
    unsaid = counted and any(note.startswith("the number of") for note in task.assumptions)
    of_blocks = (a for a, b in pairwise([*words, words[-1]]) if b.word not in lexicon.PATCH)  # not "the blue mat"
    said = Counter(lexicon.COLOR.get(token.word) for token in of_blocks)
    shown = {symbol for block in task.blocks for symbol in symbols_of(block)}
    for index, (look, noun) in enumerate(pairwise(words)):
        symbol = noun.word in _SYMBOL_NOUNS or noun.raw in shown
        shape = noun.word in lexicon.STRUCTURE and noun.word not in lexicon.PATCH
        if look.word not in lexicon.COLOR or not (symbol or shape):
            continue
        after = [*takewhile(lambda token: token.word not in _ENDS, words[index + 2 :])]
        at = next((n for n, token in enumerate(after) if token.word == "one"), 0)
        color = lexicon.COLOR.get(after[at - 1].word) if at else None
        blocks = any(
            token.word in lexicon.BLOCK and (before.word in lexicon.COLOR or not lexicon.BLOCK[token.word])
            for before, token in pairwise(after[:at])
        )
        known = shape and words[max(index - 1, 0)].word == "the" == after[max(at - 2, 0)].word if at else False
        blocks = blocks and not known  # "leave the red tower there and put a white block on the blue one"
        alone = color is not None and said[color] == 1 and (unsaid or _plain(task, color))
        if alone and not blocks and at > 1 and {x.word for x in after[max(at - 3, 0) : at]} & {"a", "the"}:
            where = (after[at - 1].span[0], after[at].span[1])
            raise refuse("ambiguous", "a plain block, or like what is named before it?", where,
                         "say what it is, 'a blue tower of two', 'a blue A', or 'block' for 'one'")  # fmt: skip


def _check_built(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "(build a row of three.) Build a blue one behind it" as a single block: blocks are not built."""
    shape = False
    for verb, det, look, one in zip(words, words[1:], words[2:], words[3:], strict=False):
        shape = shape or (verb.word in lexicon.STRUCTURE and verb.word not in lexicon.PATCH)
        color = lexicon.COLOR.get(look.word) if (det.word, one.word) == ("a", "one") else None
        built = any(sense == "build" for sense, _, _ in lexicon.VERB.get(verb.word, ()))
        if shape and built and color is not None and _plain(task, color):
            raise refuse("ambiguous", "a plain block, or like what is named before it?", (look.span[0], one.span[1]),
                         "say what it is, 'a blue tower of two', or 'block' for 'one'")  # fmt: skip


def _plain(task: TaskSchema, color: str) -> bool:
    """Whether there is a single block of a colour, which shows nothing."""
    alike = [block for block in task.blocks if block.color == color]
    return len(alike) == 1 and not isinstance(alike[0], SemanticCube)


_SYMBOL_NOUNS = frozenset({*lexicon.LETTER, *lexicon.DIGIT})
