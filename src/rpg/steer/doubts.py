"""Requests that could be about the task at hand or another one: what decides, and what is refused as it is open."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Sequence

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.walk import conjuncts
from rpg.steer.draft import Draft
from rpg.steer.history import History
from rpg.steer.proof.identity import look
from rpg.steer.proof.shape import STRUCTURES, gives_up_places, structures
from rpg.steer.requests import requests as r
from rpg.steer.requests.afresh import by_itself, of_all, of_them, one_more, only_a_number, only_named
from rpg.steer.requests.known import names_look
from rpg.steer.requests.terse import Bring, Shift

Reader = Callable[[str], tuple[TaskSchema | None, tuple[Diagnostic, ...]]]
"""The front end: an instruction that stands for itself -> its schema, or the reasons why not."""


def not_of_what_is_built(request: str, history: History, read: Reader) -> None:
    """Refuse "three towers" where there are two: as an instruction of its own it would make up the blocks."""
    if not only_a_number(request):
        return
    schema, _ = read(by_itself(request))
    built = structures(history.current.schema.goal) & STRUCTURES
    if schema is not None and structures(schema.goal) & built:
        message = "this may be about what is there, or an instruction of its own"
        hint = "say 'add ...' or 'remove ...' for what is there, or 'build ...' for another task"
        span = (0, len(request))
        raise Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])


def not_half(request: str, goal: g.Goal, history: History) -> None:
    """Refuse "build a tower instead" of a row on a mat: this leaves open whether the tower is to be on the mat."""
    if by_itself(request) != request and gives_up_places(history.current.schema.goal, goal):
        message = "this leaves open whether the blocks still have to be where they are now"
        hint = "say where they go, or 'forget that' first; or say only what they become: 'make it a tower'"
        span = (0, len(request))
        raise Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])


def about_new_things(request: str, history: History, read: Reader) -> bool:
    """Whether a request that failed as an edit is an instruction of its own, about blocks the task does not have."""
    schema, _ = read(by_itself(request))
    if schema is None or one_more(request):
        return False
    known = [look(asset) for asset in history.current.schema.blocks]
    shared = [look(asset) in known for asset in schema.blocks]
    return not any(shared)


def about_all_there(request: str, history: History, read: Reader) -> bool:
    """Whether a request, as an instruction of its own, is about the very blocks that the task has."""
    schema, _ = read(by_itself(request))
    if schema is None:
        return False
    looks = [sorted(repr(look(asset)) for asset in each.blocks) for each in (schema, history.current.schema)]
    return looks[0] == looks[1]


def not_of_those_there(request: str, task: TaskSchema, draft: Draft) -> None:
    """Refuse "blues on the left" where there are blue blocks, but not as many as would be made up for the sentence."""
    old = draft.schema
    counted = any(text.startswith("the number of ") for text in task.assumptions)
    looks = [look(block) for block in task.blocks]
    there = [look(block) for block in old.blocks]
    fewer = _of_any_size(looks) < _of_any_size(there)
    unsaid = task.assumed(COLORS_UNSAID) or task.assumed("the colours are not said")
    made_up = of_all(request) and any("not said" in text for text in task.assumptions)
    made_up = made_up or (unsaid and only_named(request) and by_itself(request) == request)
    sizes, had = {block.size for block in task.blocks}, {block.size for block in old.blocks}
    made_up = made_up or (unsaid and len(sizes) > 1 and sizes <= had)
    made_up = made_up or (unsaid and (of_them(request) or names_look(draft, request)))
    alike = all(each in there for each in looks) and len(looks) != len(there)
    alike = alike or all(any(block.type == "SemanticCube" for block in each.blocks) for each in (task, old))
    if made_up or fewer or (counted and alike):
        message = "this may be about the blocks that are there, or about others"
        hint = "say 'the red blocks', or how many there should be"
        hint = "say 'move ...' for what is there, or 'new task: ...'" if fewer else hint
        span = (0, len(request))
        raise Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])


def _of_any_size(looks: Sequence[dict[str, object]]) -> Counter[str]:
    return Counter(repr({**each, "size": None}) for each in looks)


_BESIDES = re.compile(
    r"^\W*(?:(?:also|in addition|additionally|furthermore|moreover)\b\W*(?:put|place|stack|set|lay|add)"
    r"|and\s+(?:the\s+)?\w+(?:\s+(?:block|cube|one))?\s+(?:to|on|in|at|behind|next|left|right))\b",
    re.IGNORECASE,
)
"""Words that only add: "also put ...", "and red to the left"."""


_TOO = re.compile(r"\b(?:as well|too|also|in addition|additionally)\b", re.IGNORECASE)


def only_adds(before: g.Goal, after: g.Goal) -> bool:
    """Whether all that was asked is asked still, and something else besides."""
    return before != after and all(part in conjuncts(after) for part in conjuncts(before))


def besides(request: str, asked: Sequence[r.Request], before: g.Goal, after: g.Goal) -> bool:
    """Whether a request that only adds took something away: "put B on C as well", where B is on A so far. What goes
    where something else is already, "B on the red patch too", leaves the place where it was."""
    if before == after or only_adds(before, after):
        return False
    if _BESIDES.match(request):
        return True
    if not _TOO.search(request) or not any(isinstance(each, r.Move | Shift | Bring) for each in asked):
        return False
    places = [_where(part) for part in conjuncts(before)]
    new = [part for part in conjuncts(after) if part not in conjuncts(before)]
    return not any(_where(part) and _where(part) in places for part in new)


def _where(part: g.Goal) -> tuple[object, ...]:
    """The place that a condition puts a block in: on what, beside what, where on the table."""
    near = [value for name in ("b", "patch", "region") if (value := getattr(part, name, None)) is not None]
    return (part.kind, *near) if near or part.kind == "on_table" else ()
