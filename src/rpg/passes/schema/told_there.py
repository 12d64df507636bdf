"""What was said before it was put in plainer words, and what a task has: no fewer blocks than an inventory tells to be
there, others only where one says so, and something for every number."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

from rpg.ir.assets import Block, SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import names
from rpg.language import lexicon
from rpg.language.grammar.talk.corrected import corrected
from rpg.language.inventories import Told
from rpg.language.tokens import Token
from rpg.passes.schema.evidence import unfounded
from rpg.passes.schema.feasibility import Feasibility
from rpg.passes.schema.patience import LOST
from rpg.passes.schema.resolve.things.world import refuse

_SIGNS = frozenset("+-*/=")
"""A sum is made of digits that are listed, with signs that are not."""
_FURTHER = frozenset({"another", "more", "further", "additional", "extra", "new", "distractor", "distractors", "add",
                      "besides", "second", "third", "fourth"})  # fmt: skip
"""Words of blocks that come on top of those that are there."""


def check_told(told: Told | None, task: TaskSchema) -> None:
    """Refuse a task with fewer blocks than are told to be there, or with others that nobody brings up."""
    if told is None:
        return
    there = Counter(map(_look, task.blocks))
    further = any(token.word in _FURTHER for token in told.rest)
    for look in sorted({*told.looks, *there} - _SIGNS):
        many, had = told.looks[look], there[look]
        if had < many:
            raise refuse("count-mismatch", f"there are {many} of '{look}', but only {had} are spoken of",
                         _where(told, look), "say which of them are meant")  # fmt: skip
        if had == many or further:
            continue
        if not many and (told.closed or not _brought_up(told, look)):
            raise refuse("no-referent", f"there is no '{look}' block among those that are listed", _where(told, look),
                         "list it with the others, or name one of them")  # fmt: skip
        if many and not _brought_up(told, look):
            raise refuse("count-mismatch", f"there are {many} of '{look}', but {had} are spoken of",
                         _where(told, look), "list them all, or say 'another'")  # fmt: skip
    _check_marks(told, task)


def _check_marks(told: Told, task: TaskSchema) -> None:
    """Refuse a task with patches of other colours than those that are told: "there are a red block and a blue mat. The
    block must be on the mat of its colour"."""
    named = {lexicon.COLOR.get(token.word) for token in told.rest}
    strange = {p.color for p in task.patches} - told.marks - named if told.marks else set()
    if strange and not any(token.word in _FURTHER for token in told.rest):
        raise refuse("no-referent", f"there is no {min(strange)} patch among those that are listed", None,
                     "list it with the others, or name one of them")  # fmt: skip


def check_numbers(said: list[Token], words: Sequence[Token], found: Feasibility) -> None:
    """Refuse a task of which a number tells nothing that was lost on the way from what was said to the plainer words:
    "a pyramid of six blocks as a 2x2 base and one on top"."""
    kept = {token.span for token in words}
    if all(token.span in kept for token in said if _number(token)):
        return
    meant = corrected(said)  # "a tower of two, er, three blocks"
    behind = (*(token.word for token in meant[1:]), "")
    counts = (token for token, after in zip(meant, behind, strict=True) if _number(token) and after != "times")
    lost = {token.span for token in counts if token.span not in kept}
    for token in unfounded(meant, found.task, found.chosen) if lost else ():
        if token.span in lost:
            raise refuse("misplaced", f"{LOST} of {token.raw!r}", token.span, "say this part in a sentence of its own")


def check_none_added(words: list[Token], task: TaskSchema) -> None:
    """Refuse more blocks of a look than a text begins with: "there are 2 red and 4 white cubes, make 2 rows of three,
    red in front" has no row of three red ones beside the two."""
    told = [token.word for token in words]
    if told[:1] != ["there"] or not _FURTHER.isdisjoint(told):
        return
    there = Counter(map(_look, task.blocks))
    behind = (*told[2:], "")
    for (number, token), verb, noun in zip(pairwise(words), told[1:], behind, strict=False):
        if verb in lexicon.VERB and verb not in ("is", "are"):
            return
        color = lexicon.COLOR.get(token.word) if noun not in lexicon.STRUCTURE else None  # "two red towers"
        if color is not None and 0 < number.many < there[color]:
            message = f"there are {number.many} of '{color}', but {there[color]} are spoken of"
            raise refuse("count-mismatch", message, token.span, "list them all, or say 'another'")


def _number(token: Token) -> bool:
    return token.kind == "number" or token.word in lexicon.NUMBER


def check_wanted(words: Sequence[Token], task: TaskSchema, *, each_block: bool) -> None:
    """Refuse a task that wants nothing of the blocks of some look, or of some block, which `words` list and do not call
    distractors."""
    if not words or not _IDLE.isdisjoint(token.word for token in words):
        return
    used = set(names(task.goal))
    idle = {_look(b) for b in task.blocks} - {_look(b) for b in task.blocks if b.name in used}
    idle |= {_look(b) for b in task.blocks if b.name not in used} if each_block else set()
    if idle:
        raise refuse("unused-block", f"nothing is said of where '{min(idle)}' should be", None,
                     "say what becomes of it, or that it is a distractor")  # fmt: skip


def _look(block: Block) -> str:
    return (block.label or block.color) if isinstance(block, SemanticCube) else block.color


_IDLE = frozenset({"distractor", "distractors", "anywhere", "ignore", "ignored", "unused"})


def _brought_up(told: Told, look: str) -> bool:
    """Whether blocks that look so are brought up: "a green block", "two green ones", "a block S"."""
    alike = [other for other in told.looks if (other in _COLORS) == (look in _COLORS)]
    if len(alike) < _SEVERAL:
        return True
    for n, token in enumerate(told.rest):
        if (lexicon.COLOR.get(token.word) or token.word.upper()) == look:
            before = [t.word for t in told.rest[max(0, n - 2) : n] if t.word not in _NOUNS]
            if before[-1:] != ["the"]:
                return True
    return False


_COLORS = frozenset(lexicon.COLOR.values())
_NOUNS = frozenset({*lexicon.BLOCK, *lexicon.LETTER, *lexicon.DIGIT})
_SEVERAL = 2
"""With fewer kinds of blocks that are told it may be no list of all there is."""


def _where(told: Told, look: str) -> tuple[int, int] | None:
    """Where such a block is spoken of."""
    return next((t.span for t in told.rest if lexicon.COLOR.get(t.word, t.word.upper()) == look), None)
