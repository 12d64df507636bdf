"""What could be of the mats or of blocks: lists behind "each mat", and "not the green one" behind the blue mat."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.schema import TaskSchema
from rpg.ir.walk import names
from rpg.language import lexicon
from rpg.language.grammar.rows.vocabulary import COLOR, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_LISTED = on_demand(
    "\\b(?:each|every|both|all)(?: one)?(?: of)?(?: the)? (?:mats?|patch|patches|zones?|targets?|areas?|spots?)\\b.*"
    f"\\b(?:there (?:is|are)|(?:we|i|you) (?:have|got|have got)) ({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR})"
    "(?= \\.|$)"
)


_APPOSED = on_demand(
    f"\\b{PATCHES} [,(:] (?:an?|one) {COLOR} (?:one|{PATCH})(?: , (?:an?|one) {COLOR} (?:one|{PATCH}))*(?: ,)? and "
    f"(?:an?|one) {COLOR} one(?= [.,;)]|$)"
)
"""Behind the patches, of which so many are told."""


def check_mats_listed(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put a white block on each mat, there are red, blue and green" as of blocks with which nothing is done.

    Raises:
        Refusal: "ambiguous", where what is listed could be either.
    """
    text = " ".join(token.word.replace(" ", "_") for token in tokens)
    _apposed(text, tokens, task)
    listed = _LISTED.search(text)
    if listed is None:
        return
    begin, end = (text[:at].count(" ") for at in listed.span(1))
    looks = {lexicon.COLOR.get(token.word) for token in tokens[begin : end + 1]}
    idle = {block.name for block in task.blocks if block.color in looks}
    if idle and not idle & {name for part in (task.goal, *task.init.arranged) for name in names(part)}:
        raise refuse("ambiguous", "what is listed could be the patches or the blocks",
                     (tokens[begin].span[0], tokens[end].span[1]),
                     "say 'blocks' or 'patches' where they are listed")  # fmt: skip


def _apposed(text: str, tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put one block on each of the two patches, a red one and a blue one" as of patches of other colours."""
    listed = _APPOSED.search(text)
    if listed is None:
        return
    begin, end = (text[:at].count(" ") for at in listed.span())
    looks = {lexicon.COLOR[token.word] for token in tokens[begin : end + 1] if token.word in lexicon.COLOR}
    if not looks <= {patch.color for patch in task.patches}:
        raise refuse("ambiguous", "these could be the patches, or blocks", (tokens[begin].span[0], tokens[end].span[1]),
                     "say 'the red patch and the blue patch', or what is said of the blocks in a sentence of its own",
                     )  # fmt: skip


_NOT_THE = on_demand(
    f"\\b(?:on|in|onto|into|inside|to) (?:the|an?) {COLOR} {PATCH}(?: ,)? (?:and |but )?not (?:the )?(?P<color>{COLOR})"
    "(?: one)?(?= [.,;!?]|$)"
)


def check_mat_or_block(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put red on the blue mat, not the green one" as of a green block that nothing else speaks of.

    Raises:
        Refusal: "ambiguous", where it could be another mat.
    """
    text = " ".join(token.word.replace(" ", "_") for token in tokens)
    other = _NOT_THE.search(text)
    color = lexicon.COLOR[other["color"]] if other is not None else ""
    if other is None or not any(block.color == color for block in task.blocks):
        return
    listed = sum(word in lexicon.COLOR for word in text[: other.start()].split(" . ")[-1].split())
    if listed > 1:
        return  # "green, pink and gray on the white mat, but not red": it is one of those that are listed
    mat = any(patch.color == color for patch in task.patches)
    if mat or sum(lexicon.COLOR.get(token.word) == color for token in tokens) == 1:
        at = text[: other.start("color")].count(" ")
        raise refuse("ambiguous", "this could be a patch or a block", tokens[at].span,
                     f"say 'not on the {other['color']} one', or 'not the {other['color']} block'")  # fmt: skip
