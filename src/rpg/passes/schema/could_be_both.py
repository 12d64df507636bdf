"""What is said in words that two people take for two things: "each on a mat", "do not leave it alone", "put it right",
"with the letter A on it"; what is kept out of a line by the words, and becomes a part of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import product

from rpg.ir import goal as g
from rpg.ir.assets import EDGE
from rpg.ir.node import members
from rpg.ir.relations import InRegion, Moved, On, OnPatch, Stayed
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import atoms, within
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.resolve.things.world import refuse

_BLOCK = f"(?:{'|'.join(lexicon.BLOCK)})"
_SIZE = "(big|large|small|little)"
_EACH_ON_A = on_demand(
    rf", (?:with )?each(?: one| of them)?(?: is| are| goes| stands| being)? (?:on|onto) an? (?:{COLOR} )?{PATCH}"
    r"(?= [.,;!]|$)"
)
_NOT_ALONE = on_demand(r"\b(?:not|never) leave [^.;,]*\balone\b|\bleave (?:no|none|neither)\b[^.;,]*\balone\b")
_PUT_RIGHT = on_demand(r"\b(?:put|set|make|get) (?:it|this|that|them|these|things|everything) right(?= [.;!]|$)")
_LETTER_ON_IT = on_demand(r"\bwith the (?:letter|digit|number) (\w) on it\b")
_AT_EITHER_END = on_demand(
    r"\bone(?: block| of them)? (?:on|at) (?:the )?(?:top|bottom)(?: ,| and| , and) (?:one|the other|another)"
    r"(?: one)? (?:on|at) (?:the )?(?:top|bottom)\b"
)
_COLORS_BEHIND = on_demand(
    rf"\b{LINE}(?: of {MANY})?(?: {_BLOCK})? on each (?:of (?:the )?)?(?:{MANY} )?(?:{PATCH}|{PATCHES}) [:,.;] "
    rf"(?:the )?{COLOR}(?: one)? on the\b"
)
_SIZED_MATS = on_demand(rf"\b{PATCHES} [,:] an? {_SIZE} (?:{COLOR} )?one\b.*\bthe (?P<size>\w+) one\b")
_SIZED_BLOCK = on_demand(rf"\b{_SIZE} (?:{COLOR} )?{_BLOCK}\b")
_MATS_IN_ORDER = on_demand(
    rf"\b(?:on|onto) (?:the )?{MANY} {PATCHES} [,:] ({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR}) , in (?:this|that) "
    r"order\b"
)
_KEPT_OUT = on_demand(
    r"\bbut (?:(?:please )?(?:leave|keep|put|set|have|let) )?(?P<what>(?:\w+ ){1,4}?)(?:(?:stays?|remains?|goes) )?"
    rf"(?:on the table|aside|(?:next to|beside|behind|in front of|away from) (?:the (?:{LINE}|others?|rest)|it|them))\b"
)


def check_could_be_both(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse what can be told of two things, of which one would be a guess.

    Raises:
        Refusal: "ambiguous".
    """
    for sentence in sentences(tokens):
        _any_but(sentence)
    text = text_of(tokens)
    for told, is_guess, message, hint in _GUESSES:
        found = told.search(text)
        if found is not None and is_guess(text, task):
            begin, end = text[: found.start()].count(" "), text[: found.end()].count(" ")
            where = (tokens[begin].span[0], tokens[min(end, len(tokens) - 1)].span[1])
            raise refuse("ambiguous", message, where, hint)


_ANY_BUT = on_demand(
    rf"\bany (?:of the )?(?:\w+ )?(?:{'|'.join(lexicon.BLOCK)}|ones?) (?:but|except|besides|other than)\b"
)
_DENIED = frozenset({"not", "never", "no", "without", "nothing", "nobody", "none", "if"})


def _any_but(sentence: Sequence[Token]) -> None:
    """Refuse "move any block but the red one": one of the others, or all of them?"""
    words = [token.word for token in sentence]
    if _ANY_BUT.search(" ".join(words)) and _DENIED.isdisjoint(words):
        raise refuse("ambiguous", "one of the others, or all of them?", (sentence[0].span[0], sentence[-1].span[1]),
                     "say 'one of the other blocks' or 'all but the red one'")  # fmt: skip


def _one_mat(text: str, task: TaskSchema) -> bool:
    """ "Two red blocks, each on a mat"."""
    found = [x for x in atoms(task.goal) if isinstance(x, OnPatch | Stack) and x.patch is not None]
    held = sum(1 if isinstance(x, Stack) else len(members(x.a)) for x in found)
    return len(task.patches) == 1 and held > 1


def _is_to_move(text: str, task: TaskSchema) -> bool:
    """ "Do not leave the red block alone", "leave no block alone"."""
    return any(isinstance(x, Stayed | Moved) for x in atoms(task.goal))


def _on_the_right(text: str, task: TaskSchema) -> bool:
    """ "The row reads A C B. Put it right"."""
    return any(isinstance(x, InRegion) and "right" in x.region for x in atoms(task.goal))


def _on_a_plain_one(text: str, task: TaskSchema) -> bool:
    """ "A red block with the letter A on it"."""
    symbol = _LETTER_ON_IT.search(text)
    shown = {b.name for b in task.blocks if symbol and symbol[1] in {x.lower() for x in symbols_of(b)}}
    shown &= {
        b.name for b in task.blocks if b.color == "ivory"
    }  # but for "the blue one with an A on it", which is blue
    plain = {block.name for block in task.blocks if not symbols_of(block)}
    return any(isinstance(x, On) and {*members(x.a)} <= shown and {*members(x.b)} <= plain for x in atoms(task.goal))


def _both_on_top(text: str, task: TaskSchema) -> bool:
    """ "Add two blue blocks to the tower of two red ones, one on top, one at the bottom", as one on the other."""
    found = [x for x in atoms(task.goal) if isinstance(x, On)]
    return any(members(lower.a) == members(upper.b) for lower, upper in product(found, found))


def _further_ones(text: str, task: TaskSchema) -> bool:
    """ "A tower on each of two mats: red on the left one, blue on the right one", as towers of other colours."""
    towers = {name for x in atoms(task.goal) if isinstance(x, Stack) for name in x.blocks}
    return bool(towers) and not {block.name for block in task.blocks} <= towers


def _mats_lost(text: str, task: TaskSchema) -> bool:
    """ "A and B on two mats, red and green, in that order", as of further blocks, or in any order."""
    told = _MATS_IN_ORDER.search(text)
    colors = {lexicon.COLOR[word] for word in told[1].split() if word in lexicon.COLOR} if told else set()
    either = any(isinstance(x, g.Any) and any(isinstance(y, OnPatch) for y in atoms(x)) for x in within(task.goal))
    return either or not colors <= {patch.color for patch in task.patches}


def _sized_anew(text: str, task: TaskSchema) -> bool:
    """ "Two mats, a big red one and a small blue one. The big block goes on the small one", as on a small block."""
    told = _SIZED_MATS.search(text)
    sized = {block.name for block in task.blocks if block.size != EDGE}
    on_such = any(isinstance(x, On) and {*members(x.b)} <= sized for x in atoms(task.goal))
    return told is not None and on_such and told["size"] not in _SIZED_BLOCK.findall(text)


def _in_line_yet(text: str, task: TaskSchema) -> bool:
    """ "Stack red, green and blue, but leave the green one on the table", as of a tower with the green one in it."""
    told = _KEPT_OUT.search(text)
    words = told["what"].split() if told else []
    looks = {lexicon.COLOR.get(word, word.upper()) for word in words}
    out = {block.name for block in task.blocks if {block.color, *symbols_of(block)} & looks}
    lines = [{*x.blocks} for x in atoms(task.goal) if isinstance(x, Stack | Row)]
    return any(out < line for line in lines if out)


_GUESSES: tuple[tuple[re.Pattern[str], Callable[[str, TaskSchema], bool], str, str], ...] = (
    (_EACH_ON_A, _one_mat, "a patch for each of them, or one for all?", "say 'each on its own' or 'all on one'"),
    (_NOT_ALONE, _is_to_move, "are these to be moved, or to have others beside them?", "say where each should be"),
    (_PUT_RIGHT, _on_the_right, "on the right, or as it should be?", "say 'on the right', or how it should be"),
    (_LETTER_ON_IT, _on_a_plain_one, "a block that shows this, or another that lies on it?",
     "say 'a red A', or 'a red block with the A block on it'"),
    (_AT_EITHER_END, _both_on_top, "it is not clear which goes where", "name the blocks from bottom to top"),
    (_COLORS_BEHIND, _further_ones, "are these the colours of the towers, or further blocks?",
     "say of each tower what it is made of"),
    (_MATS_IN_ORDER, _mats_lost, "it is not clear which block goes on which patch", "say it of each block"),
    (_SIZED_MATS, _sized_anew, "this could be a patch or a block", "say 'patch' or 'block' for 'one'"),
    (_KEPT_OUT, _in_line_yet, "is this one a part of it, or left out?", "name the blocks that it is built of"),
)  # fmt: skip
"""What is looked for in a text, whether the task guesses what it means, and what to say of it then."""
