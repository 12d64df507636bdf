"""What is said of blocks besides where they are must show in the task: a size that is named, "the biggest" of them,
"always", vowels, and that they touch. Whichever rule loses one of these is caught here."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.traits import VOWELS
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import Node
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import TOUCHING_EDGES, Grid, Towers
from rpg.ir.walk import atoms, names, within
from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.lexicon import MEDIUM_EDGE
from rpg.language.tokens import Token
from rpg.passes.schema.patience import LOST
from rpg.passes.schema.resolve.things.world import refuse

_MOST = 3
"""So many words at most stand between a size and the blocks that have it."""
_BLOCKS = lexicon.BLOCK.keys() - {"letter", "letters", "digit", "digits", "number", "numbers"}
_STARTS = frozenset({"starts", "start", "begins", "begin", "starting"})
_EXTREMES = frozenset({"biggest", "largest", "smallest"})
_FIGURES = lexicon.STRUCTURE.keys() - lexicon.BLOCK.keys() | {"number", "digit", "group", "patch", "mat"}
_TOUCHING = frozenset({"touching", "touch", "touches"})
_CLOSE = (r.Touching, r.Adjacent, r.Stayed, r.On, r.OnTable, r.OnPatch, r.Clear, r.Above)
_LYING = frozenset({"upright", "upside", "turned"})
_TURNING = frozenset({"turn", "rotate", "flip", "give"})
_WANTED = frozenset({"must", "should", "shall", "want", "make", "turn", "put", "let", "at"})
_SORTS = {"vowel": True, "vowels": True, "consonant": False, "consonants": False}
"""Sorts of letters, and whether they are vowels."""
_BETWEEN = (r.Between, r.Touching, r.Adjacent, r.Beside)
"""What touching comes to besides lines and groups without gaps: nothing is touched that stays where it is, and what is
on something touches it."""


def check_modifiers(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task in which nothing comes of such a word."""
    _turned_from(words, task)
    for index, token in enumerate(words):
        if _lost(words, index, token, task):
            raise refuse("misplaced", f"{LOST} of {token.raw!r}", token.span, "say this part in a sentence of its own")


def _lost(words: Sequence[Token], index: int, token: Token, task: TaskSchema) -> bool:
    if token.word in ("always", *_TOUCHING) and any(map(_regular, atoms(task.goal))):
        return False  # "always one red, one white", "no two of the same colour touch"
    if token.word == "always":
        behind = [t.word for t in words[index + 1 : index + 3]]
        begun = not _STARTS.isdisjoint(behind) or behind[:1] == ["one"]  # "always starts", "always one red, one white"
        return not begun and not any(
            isinstance(goal, g.Always | g.Sequence | r.Stayed | g.Not) for goal in within(task.goal)
        )
    if token.word == "one" and [t.word for t in words[index + 1 : index + 3]] in (["of", "them"], ["of", "these"]):
        return _on_a_block_of_towers(task)
    if token.word in _SORTS:
        letters = {getattr(block, "label", "") for block in task.blocks} - {""}
        return not any(label.isalpha() and (label in VOWELS) == _SORTS[token.word] for label in letters)
    if token.word == "nothing" and [t.word for t in words[index + 1 : index + 2]] == ["between"]:
        return not any(isinstance(atom, _BETWEEN) or getattr(atom, "immediate", False) for atom in atoms(task.goal))
    if token.word in _TOUCHING:
        return not any(map(_touches, (*atoms(task.goal), *(x for part in task.init.arranged for x in atoms(part)))))
    if any(isinstance(atom, Grid) and atom.layers > 1 for atom in atoms(task.goal)):
        return False  # "one big cube of eight small ones"
    edges = {block.size for block in task.blocks}
    if token.word in _EXTREMES:
        shown = any(getattr(block, "label", "").isdigit() for block in task.blocks)
        of_lines = any(t.word in _FIGURES for t in words[index + 1 : index + 3])
        patches = {patch.size for patch in task.patches}
        return len(edges) == 1 and len(patches) < 2 and not shown and not of_lines
    size = lexicon.SIZE.get(token.word)
    if size not in ("big", "small") or not _of_blocks(words[index + 1 : index + 2 + _MOST]):
        return False
    return not any(edge > MEDIUM_EDGE if size == "big" else edge < MEDIUM_EDGE for edge in edges)


def _turned_from(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "the A lies upright. Give it a quarter turn" as both at the end: it is upright before it is turned."""
    first, *rest = sentences([*words]) or [[]]
    facts = {token.word for token in first}
    fact = facts.isdisjoint(_WANTED) and not facts.isdisjoint(_LYING)
    if not fact or not rest or rest[0][0].word not in _TURNING:
        return
    facing = {name for atom in atoms(task.goal) if isinstance(atom, r.Facing) for name in names(atom)}
    turned = {name for atom in atoms(task.goal) if isinstance(atom, r.Turned) for name in names(atom)}
    if facing & turned:
        raise refuse("contradiction", "it is so before it is turned", first[0].span, "say 'at the start'")


def _on_a_block_of_towers(task: TaskSchema) -> bool:
    """Whether "on one of them" came to any block of several towers, where it is said of the towers."""
    found = [task.goal, *task.init.arranged]
    towers = [{*names(atom)} for part in found for atom in atoms(part) if isinstance(atom, Towers)]
    counts = [goal for goal in within(task.goal) if isinstance(goal, g.Count) and isinstance(goal.goal, r.On)]
    return any({*count.over} in towers for count in counts)


def _regular(atom: Node) -> bool:
    order = getattr(atom, "order", None)
    return getattr(order, "by", "") == "alternating" or getattr(atom, "evenly", False)


def _touches(atom: Node) -> bool:
    gaps = [getattr(atom, name, None) for name in ("gap", "inner_edges", "gap_edges", "minimum")]
    return (
        isinstance(atom, _CLOSE)
        or getattr(atom, "touching", False)
        or any(gap is not None and gap <= TOUCHING_EDGES for gap in gaps)
    )


def _of_blocks(behind: Sequence[Token]) -> bool:
    """Whether blocks follow, with nothing but colours, sizes and a comma between."""
    for token in behind:
        if token.word in _BLOCKS:
            return True
        if not (token.word in lexicon.COLOR or token.word in lexicon.SIZE or token.word == ","):
            return False
    return False
