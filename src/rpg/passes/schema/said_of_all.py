"""What is told of all at the end must hold of all: "a tower of three blocks and one of two blocks, both blue"."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rpg.core.diagnostics import Refusal
from rpg.ir.assets import Block, SemanticCube
from rpg.ir.relations import Facing, Turned
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.walk import atoms, names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.had_so_often import check_had_so_often
from rpg.passes.schema.resolve.things.world import refuse

_OF_ALL = on_demand(
    r"(?:^|, |[.;] )(?:both|all|each|everything|every one|all blocks|all the blocks)(?: of (?:them|these|it))?"
    rf"(?: (?:in|are|is|should be|must be))? {COLOR}(?= ?[.;!?]|$)"
)
_WITH_PATCH = on_demand(
    f"\\b(?:{CUBE}s? and \\w+ (?:{PATCH}|{PATCHES})|(?:{PATCH}|{PATCHES}) and \\w+ {CUBE}s?) , (?:both|all|each) "
    f"(?:of them )?(?:in )?{COLOR}\\b"
)
"""Blocks and patches that are listed together: "three blocks and a mat, all blue"."""
_ALL = r", (?:all|both)(?: of (?:them|these))?(?: (?:in|are|should be|must be))?"
_COLORED = on_demand(rf"^(.*){_ALL} ({COLOR})$")
_SIZED = on_demand(rf"{_ALL} (?:\d[\d.]* cm\b.*|{'|'.join(lexicon.SIZE)})$")
_TURNED = on_demand(rf"{_ALL} (?:upside down|upright|turned|rotated|facing)\b[^,]*$")
_ONLY = on_demand(rf"\buse only ({COLOR}) (?:{'|'.join(lexicon.BLOCK)}|ones)\b")
_SO_MANY = on_demand(rf"\buse (?:exactly |only |just )?({'|'.join(lexicon.NUMBER)}) (?:different )?colors\b")
_NONE = on_demand(rf", none of (?:them|these)(?: is| are)? ({COLOR})$")


def check_said_of_all(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task in which what is told of all at the end was taken as of some, or changed nothing, and one that has
    blocks for each that are told for all.

    Raises:
        Refusal: "ambiguous", or "contradiction" where what was told before is otherwise.
    """
    check_had_so_often(tokens, task)
    unsaid = any(note.startswith((COLORS_UNSAID, "the colours are not said")) for note in task.assumptions)
    patch = task.assumed("the colour of the patch is not said")
    whole = " ".join(token.word for token in tokens) if unsaid or patch else ""
    if (unsaid and _OF_ALL.search(whole)) or (patch and _WITH_PATCH.search(whole)):
        raise refuse("ambiguous", "it is not clear of which blocks this colour is told",
                     (tokens[0].span[0], tokens[-1].span[1]), "name the colour with each of them")  # fmt: skip
    if {"all", "both", "none", "use"}.isdisjoint(token.word for token in tokens):
        return
    used = {*names(task.goal)}
    blocks = [block for block in task.blocks if block.name in used]
    told = sentences(list(tokens))
    for sentence in told:
        text = " ".join(token.word for token in sentence if token.word not in STOPS)
        _used(text, blocks, sentence)
        if len(told) > 1 and all(token.word != "all" for token in sentence):  # "both" are those of the sentence
            continue
        _colors(text, blocks, sentence)
        if _SIZED.search(text) and len({block.size for block in blocks}) > 1:
            raise _asked(sentence, "it is not clear of which blocks this size is told")
        turned = {x.block for x in atoms(task.goal) if isinstance(x, Facing | Turned)}
        shown = {block.name for block in blocks if isinstance(block, SemanticCube)}
        if _TURNED.search(text) and turned and not shown <= turned:
            raise _asked(sentence, "it is not clear of which blocks this is told")


def _colors(text: str, blocks: Iterable[Block], sentence: Sequence[Token]) -> None:
    """Refuse "the red block on the blue one, all blue", "a tower of three red blocks, none of them red"."""
    there: list[str] = [block.color for block in blocks]
    if (told := _COLORED.search(text)) is not None:
        color = lexicon.COLOR[told[2]]
        named = {lexicon.COLOR.get(word) for word in told[1].split()}
        if there.count(color) < 2 or (color in named and {*there} & named - {None, color}):
            raise _asked(sentence, "it is not clear of which blocks this colour is told")
    none = _NONE.search(text)
    if none is not None and lexicon.COLOR[none[1]] in there:
        raise refuse("contradiction", "one of these has just this colour", (sentence[0].span[0], sentence[-1].span[1]),
                     "leave this out, or name another colour")  # fmt: skip


def _used(text: str, blocks: Iterable[Block], sentence: Sequence[Token]) -> None:
    """Refuse "(put a red and a blue block on the mat.) Use only red blocks", "use three colours"."""
    colors = {block.color for block in blocks} - {"ivory"}
    only, many = _ONLY.search(text), _SO_MANY.search(text)
    if only is not None and colors != {lexicon.COLOR[only[1]]}:
        raise _asked(sentence, "others than these are told of as well")
    if many is not None and len(colors) != lexicon.NUMBER[many[1]]:
        raise _asked(sentence, "so many colours are not told of")


def _asked(sentence: Sequence[Token], message: str) -> Refusal:
    return refuse("ambiguous", message, (sentence[0].span[0], sentence[-1].span[1]), "say it of each of them")
