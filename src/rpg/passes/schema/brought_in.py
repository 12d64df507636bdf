"""Blocks that are brought in behind what is to be done, "use only red and blue", "B and C too": something must be asked
of them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rpg.ir import goal as g
from rpg.ir.assets import Block, SemanticCube
from rpg.ir.node import Highest, members
from rpg.ir.relations import On
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.walk import names
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.rows.vocabulary import COLOR
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_LOOK = rf"(?:(?:a|an|the) )?(?:{COLOR}|[A-Z]|\d)(?: (?:{'|'.join(lexicon.BLOCK)}|ones?))?"
_LIST = rf"{_LOOK}(?:(?: ,| and| , and) {_LOOK})*"
_USED = re.compile(rf"^(?:please )?(?:use|take)(?: only| just)? ({_LIST})(?: too| as well| also)?$")
_TOO = re.compile(rf", (?:and )?({_LIST}) (?:too|as well|also)$")


def check_brought_in(tokens: list[Token], task: TaskSchema) -> None:
    """Refuse a task that asks nothing of the blocks that a later sentence, or the end of one, brings in.

    Raises:
        Refusal: "unused-block", with the first of them; "ambiguous" where one may be among those that were counted.
    """
    _not_on_top(task)
    used = {*names(task.goal)}
    for n, sentence in enumerate(sentences(tokens)):
        said = [token for token in sentence if token.word not in STOPS - {","}]
        text = " ".join(token.raw if token.raw.isupper() else token.word for token in said)
        found = [m for m in (_USED.search(text) if n else None, _TOO.search(text)) if m is not None]
        for look, token in _looks(said, found[0][1]) if found else ():
            those = {block.name for block in task.blocks if look in _shown(block)}
            if those and not those & used:
                raise refuse("unused-block", f"nothing is said of where {token.raw!r} should be", token.span,
                             "say what becomes of it, or how many blocks of which look there are")  # fmt: skip


def _not_on_top(task: TaskSchema) -> None:
    """Refuse "a tower of five blocks. Red must not be on top" as a red one besides: it could be one of the five."""
    parts = task.goal.goals if isinstance(task.goal, g.All) else ()
    if not task.assumed(COLORS_UNSAID):
        return
    wanted = {n for part in parts if not isinstance(part, g.Not) for n in names(part)}
    for part in (x for x in parts if isinstance(x, g.Not) and isinstance(x.goal, On)):
        if isinstance(part.goal, On) and isinstance(part.goal.b, Highest) and wanted.isdisjoint(members(part.goal.a)):
            raise refuse("ambiguous", "is this one of the blocks of the tower, or a further one?", part.span,
                         "say which colours the blocks of the tower have")  # fmt: skip


def _looks(said: Sequence[Token], listed: str) -> Iterator[tuple[str, Token]]:
    """The colours and labels of a list, with where they are said."""
    for token in said:
        look = lexicon.COLOR.get(token.word) or (token.raw if len(token.raw) == 1 else None)
        if look is not None and re.search(rf"\b{re.escape(token.raw)}\b", listed, re.IGNORECASE):
            yield look, token


def _shown(block: Block) -> set[str | None]:
    return {block.color, block.label if isinstance(block, SemanticCube) else None}
