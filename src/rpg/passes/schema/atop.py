"""On top of what: blocks lie on top of blocks, though "on top of it" may be said of a mat where nothing else lies."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.ir.node import Highest, members
from rpg.ir.relations import On, OnPatch
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms
from rpg.language.grammar.rows.vocabulary import MANY, PATCH, TOWER
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_THEM = frozenset({"it", "them", "both", "either", "neither", "each", "one", "any", "that", "those", "these"})


def check_atop(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "A on the red mat, B on the blue mat, and C on top of one of them" as somewhere on one of the mats."""
    for top, of, what in zip(words, words[1:], words[2:], strict=False):
        if top.word != "top" or of.word != "of" or what.word not in _THEM:
            continue
        here: set[str] = set()
        ahead: set[str] = set()
        for atom in atoms(task.goal):
            if isinstance(atom, OnPatch) and atom.span is not None:
                (here if atom.span[1] >= what.span[1] else ahead).add(atom.patch)
        if here & ahead:
            raise refuse("ambiguous", "on the patch, or on a block that is there?", what.span, "name it")


_ON = r"\b(?:on|onto|on top of|to|upon|atop)"
_ONE = r"(?:(?!(?:on|and|or) )[a-z0-9]+ ){1,4}?"
_HAVING = r"(?:that has|which has|with|having)"
_TOP = r"(?:on (?:the |its )?top(?: of it)?|on it)"
_WHICH_TOWER = re.compile(
    rf"{_ON} the {TOWER}(?: of {MANY}(?: blocks| cubes)?)? "
    rf"(?:whose top\b|{_HAVING} {_ONE}{_TOP}|{_HAVING} (?:the|an?) \w+ top\b)"
)
_WHICH_PATCH = re.compile(rf"{_ON} the {PATCH} with (?:the|an?) {_ONE}on it\b")


def check_top_of_which(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put yellow on the tower that has the blue block on top" as with blue on yellow, and "put red on the mat
    with the blue block on it" as with blue on red: these may tell which tower or which mat it is."""
    said = " ".join(token.word for token in words)
    ons = [x for x in atoms(task.goal) if isinstance(x, On)]
    borne = {name for x in ons if not isinstance(x.b, Highest) for name in members(x.b)}
    topmost = {name for x in ons if isinstance(x.b, Highest) for name in members(x.a)}
    placed = {name for x in atoms(task.goal) if isinstance(x, OnPatch) for name in members(x.a)}
    for pattern, put, kind, what in ((_WHICH_TOWER, topmost, TOWER, "tower"), (_WHICH_PATCH, placed, PATCH, "patch")):
        found = pattern.search(said)
        known = found is not None and re.search(rf"\b{kind}\b", said[: found.start()])
        if found is not None and put & borne and not (known and " with " in found[0]):
            at, last = said[: found.start()].count(" "), said[: found.end()].count(" ")
            raise refuse("ambiguous", f"is this told of the {what}, or does it lie on what is put there?",
                         (words[at].span[0], words[last].span[1]),
                         f"name the {what} alone, and say in another sentence which block lies on which")  # fmt: skip
