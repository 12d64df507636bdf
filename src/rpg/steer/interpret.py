"""A request -> the version it starts from, typed edits, and the class of change that its words call for."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from pydantic import ValidationError

from rpg.blocks.english import describe, describe_goal
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.edits import Edit, Overwrite, SetGoal, SetText, apply
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import conjuncts
from rpg.steer.carry import WEAK, carry_out
from rpg.steer.doubts import (
    Reader,
    about_all_there,
    about_new_things,
    besides,
    not_half,
    not_of_those_there,
    not_of_what_is_built,
    only_adds,
)
from rpg.steer.draft import Draft
from rpg.steer.history import History, Past
from rpg.steer.naming import tidied
from rpg.steer.proof.classify import Category
from rpg.steer.proof.identity import look
from rpg.steer.proof.shape import STRUCTURES, same_structure, structures
from rpg.steer.requests import requests as r
from rpg.steer.requests.afresh import (
    Fresh,
    by_itself,
    extended,
    fresh_start,
    of_those_there,
    reused,
    speaks_of_parts,
)
from rpg.steer.requests.backrefs import Reference
from rpg.steer.requests.known import mentions_known, names_structure, of_another_kind, only_known, speaks_of_kinds
from rpg.steer.requests.language import tokenize
from rpg.steer.requests.manners import plainly
from rpg.steer.requests.parse import Parsed, is_edit, parse
from rpg.steer.requests.told import check, divided
from rpg.steer.requests.turning import turned_otherwise

KIND_OF = {"label": "letter", "number": "digit"}
TRIES = 12
"""Readings of a request that are carried out in turn until one can be."""


@dataclass(frozen=True)
class Interpretation:
    """What a request means. `task` is the reference with `edits` applied; a pure return to a version has no edits.

    `reference` is None for a task that keeps nothing. `focus`: what later requests mean by "it".
    """

    request: str
    reference: int | None
    edits: tuple[Edit, ...]
    task: TaskSchema
    intent: Category
    parameters: dict[str, Any] = field(default_factory=dict)
    focus: tuple[str, ...] = ()

    @property
    def reverts(self) -> bool:
        """Whether the request only goes back to a version."""
        return not self.edits


def interpret(request: str, history: History, read: Reader) -> Interpretation:
    """Understand `request` in the light of a family; raises Refusal with the reasons where that fails."""
    _only_words(request)
    if (plain := plainly(request)) != request:
        return replace(interpret(plain, history, read), request=request)
    if (told := divided(request)) is not None:
        understood = interpret(told[0], history, read)
        check(request, told[1], understood.task)
        return replace(understood, request=request)
    readings = parse(request)
    fresh = fresh_start(request)
    if fresh is not None and not any(reading.whole for reading in readings):
        return _whole(request, fresh.text, fresh.offset, history, read, "FRESH")
    refusals: list[Refusal] = []
    weak: list[Refusal] = []
    wholes = [reading for reading in readings if reading.whole and _changes(reading)]
    for parsed in [reading for reading in wholes if not (_ONLY.match(request) and _adds(reading))][:TRIES]:
        try:
            return _carried_out(request, parsed, history, read)
        except Refusal as refusal:
            if not refusals and refusal.diagnostics[0].code == "nothing-to-do" and _moves(parsed):
                raise
            (weak if any(isinstance(each, WEAK) for each in parsed.requests) else refusals).append(refusal)
    if fresh is not None:
        return _whole(request, fresh.text, fresh.offset, history, read, "FRESH")
    there = [refusal for refusal in weak if refusal.diagnostics[0].code == "ambiguous-object"]
    if there and not refusals and not about_all_there(request, history, read):
        raise there[0]
    try:
        return _otherwise(request, readings, refusals, history, read)
    except Refusal:
        if weak and not refusals:
            raise weak[0] from None
        raise


def _moves(reading: Parsed) -> bool:
    return any(isinstance(each, r.Move) for each in reading.requests)


_ONLY = re.compile(
    r"^\W*(?:and\s+)?(?:only|just|exactly|at least|at most)\s+(?:\d|an?\b|one\b|two\b|three\b|four\b|five\b|six\b)",
    re.IGNORECASE,
)
"""So many and no more: nothing that is to be added to what is there."""


def _adds(reading: Parsed) -> bool:
    return any(isinstance(each, r.Add) for each in reading.requests)


def _changes(reading: Parsed) -> bool:
    """Whether a reading asks for something; what is merely to keep its place is no request by itself."""
    return not reading.requests or any(not isinstance(q, r.Keep) or q.still for q in reading.requests)


def _only_words(request: str) -> None:
    """Refuse characters that the language does not have, rather than read on without them."""
    tokens, strays = tokenize(request)
    if not tokens or strays:
        span = strays[0].span if strays else (0, len(request))
        message = f"{strays[0].text!r} means nothing here" if strays else "the request is empty"
        hint = "say in English what is to change: add a green block on top"
        raise Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])


def _carried_out(request: str, parsed: Parsed, history: History, read: Reader) -> Interpretation:
    past = _reference(parsed.reference, parsed.requests, history)
    if not parsed.requests:
        if past.number == history.head:
            told = f"version {past.number} is the current one already"
            raise Refusal([Diagnostic(code="nothing-to-do", message=told, span=(0, len(request)), origin="steer")])
        return Interpretation(request, past.number, (), past.schema, "TWEAK", {"revert": past.number}, past.focus)
    draft = Draft(past.schema, past.focus)
    if past.number != history.head:
        draft.parameters["revert"] = past.number
    instead = parsed.reference is None and _INSTEAD.search(request) is not None
    told, hint = "it is not said what this comes instead of", "say 'replace ... with ...', or add it"
    of_nothing = draft.refusal("edit-unclear", told, (0, len(request)), hint)
    if instead and _adds(parsed):
        raise of_nothing
    carry_out(draft, parsed.requests)
    if instead and only_adds(past.schema.goal, draft.schema.goal):
        raise of_nothing
    if _AFTER.match(request):
        _staged(draft, past.schema.goal)
    if besides(request, parsed.requests, past.schema.goal, draft.schema.goal):
        told, hint = "this cannot be besides what the task asks for already", "leave out 'also', 'as well' or 'and'"
        refusal = draft.refusal("edit-unclear", told, (0, len(request)), hint)
        return _added(request, history, read, refusal)
    return finish(request, draft, past)


_AFTER = re.compile(r"^\W*(?:and\s+)?(?:then|finally|after that|afterwards|next(?! to)|lastly)\b", re.IGNORECASE)


_INSTEAD = re.compile(r"\binstead\b(?! of)", re.IGNORECASE)


def _added(request: str, history: History, read: Reader, refusal: Refusal) -> Interpretation:
    """What only adds, as a sentence more about the task: its goal stays, whatever place the sentence names."""
    try:
        return _clause(request, history, read)
    except Refusal:
        raise refusal from None


def _staged(draft: Draft, before: g.Goal) -> None:
    """What is to come after a sequence is a further stage of it."""
    goal = draft.schema.goal
    if isinstance(before, g.Sequence) and isinstance(goal, g.All) and goal.goals[0] == before:
        new = goal.goals[1] if len(goal.goals) == 2 else g.All(goals=goal.goals[1:])
        draft.do(SetGoal(goal=before.model_copy(update={"stages": (*before.stages, g.Stage(goal=new))})))


def _reference(reference: Reference | None, requests: Sequence[r.Request], history: History) -> Past:
    """The version that the changes apply to: the one named, else the current one, unless it lacks what is needed."""
    if reference is not None:
        return history.find(reference)
    current = history.current
    for request in requests:
        kind = KIND_OF.get(request.how) if isinstance(request, r.Reorder) else None
        if kind is not None and all(_plain(block) for block in current.schema.blocks):
            return history.latest_with(kind) or current
    return current


def _plain(block: Any) -> bool:
    return bool(block.type == "ColoredCube")


def finish(request: str, draft: Draft, past: Past) -> Interpretation:
    """The draft as a checked task with words of its own."""
    if draft.schema == past.schema:
        message = "this changes nothing"
        raise Refusal([Diagnostic(code="nothing-to-do", message=message, span=(0, len(request)), origin="steer")])
    tidied(draft)
    kept = tuple(text for text in past.schema.assumptions if text not in draft.assumptions)
    draft.do(SetText(instruction=worded(draft.schema), assumptions=(*kept, *draft.assumptions)))
    try:
        task = apply(past.schema, draft.edits)
    except ValidationError as error:
        message = f"this does not give a task: {error.errors()[0]['msg']}"
        raise Refusal(
            [Diagnostic(code="edit-unclear", message=message, span=(0, len(request)), origin="steer")]
        ) from error
    return Interpretation(
        request=request,
        reference=past.number,
        edits=tuple(draft.edits),
        task=task,
        intent=draft.intent,
        parameters=draft.parameters,
        focus=draft.focus,
    )


def worded(schema: TaskSchema) -> str:
    """A canonical instruction for a task, from its data alone."""
    from rpg.steer.view import View

    init = schema.init
    special = init.arranged or init.heaps or init.poses or View(schema).idle
    return describe(schema) if special else describe_goal(schema)


def _adds_at_end(reading: Parsed) -> bool:
    """Whether a reading puts something new at a place that only what is there has: "on top", "to the left"."""
    added = [each for each in reading.requests if isinstance(each, r.Add) and each.places]
    return any(isinstance(place, r.Spot) for each in added for place in each.places)


def _otherwise(
    request: str, readings: Sequence[Parsed], refusals: Sequence[Refusal], history: History, read: Reader
) -> Interpretation:
    """No edit grammar covers the request, or none could be carried out: an instruction, or a clause of one."""
    longest = next((reading for reading in readings if not reading.whole), None)
    edits = is_edit(request) or any(reading.whole and _adds_at_end(reading) for reading in readings)
    edits = edits or (speaks_of_parts(request) and bool(structures(history.current.schema.goal) & STRUCTURES))
    reasons: list[Diagnostic] = []
    if of_those_there(request):
        raise refusals[0] if refusals else _not_understood(request, longest, reasons, True)
    not_of_what_is_built(request, history, read)
    if not edits and not Fresh.adds(request) and (not refusals or "instead" in request.lower()):
        try:
            return _reused(request, history, read)
        except Refusal as refusal:
            reasons += [] if refusals else refusal.diagnostics[1:]
    if refusals and (edits or not about_new_things(request, history, read)):
        raise refusals[0]
    if longest is not None and (longest.requests or longest.reference):
        try:
            return _with_clause(request, longest, history, read)
        except Refusal as refusal:
            reasons += refusal.diagnostics
    more = mentions_known(Draft(history.current.schema, history.current.focus), request)
    steps = (_clause,) if edits or Fresh.adds(request) else (_clause, _standalone) if more else (_standalone, _clause)
    if by_itself(request) != request and not request.rstrip(" .!?").lower().endswith("again"):
        steps = (_standalone,)
    for step in steps:
        try:
            return step(request, history, read)
        except Refusal as refusal:
            reasons += refusal.diagnostics
    raise refusals[0] if refusals else _not_understood(request, longest, reasons, edits)


def _with_clause(request: str, parsed: Parsed, history: History, read: Reader) -> Interpretation:
    """Edits, then words that only the instruction language has: those are read as a sentence about the task."""
    assert parsed.rest is not None
    past = _reference(parsed.reference, parsed.requests, history)
    draft = Draft(past.schema, past.focus)
    if past.number != history.head:
        draft.parameters["revert"] = past.number
    carry_out(draft, parsed.requests)
    extended(draft, request, parsed.rest[0], read)
    return finish(request, draft, past)


def _clause(request: str, history: History, read: Reader) -> Interpretation:
    past = history.current
    draft = Draft(past.schema, past.focus)
    try:
        extended(draft, request, 0, read)
    except Refusal:
        draft = Draft(past.schema, past.focus)
        if not turned_otherwise(draft, request, read):
            raise
    return finish(request, draft, past)


def _reused(request: str, history: History, read: Reader) -> Interpretation:
    past = history.current
    draft = Draft(past.schema, past.focus)
    reused(draft, request, read)
    if all(part.kind in _OF_A_BLOCK for part in conjuncts(draft.schema.goal)):
        raise _not_understood(request, None, (), True)
    not_half(request, draft.schema.goal, history)
    return finish(request, draft, past)


_OF_A_BLOCK = frozenset({"facing", "turned", "moved", "shifted", "stayed", "clear"})
"""What a goal asks of a block by itself: said of one that is there, it is said of the task at hand."""


_SAME = re.compile(
    r"\b(?:same|these|those) (?:\w+ )?(?:blocks|cubes|ones|bricks|letters|digits|patch|mat)\b", re.IGNORECASE
)
"""The blocks that are there, of which an instruction of its own does not know."""


def _standalone(request: str, history: History, read: Reader) -> Interpretation:
    """An instruction of its own; one that names some of the task's blocks must not name others that it lacks."""
    draft = Draft(history.current.schema, history.current.focus)
    only_known(draft, request, 0)
    if names_structure(draft, request) or _SAME.search(request) or speaks_of_kinds(draft, request):
        raise _not_understood(request, None, (), True)
    found = _whole(request, by_itself(request), 0, history, read, "PIVOT")
    not_half(request, found.task.goal, history)
    if of_another_kind(draft, request, found.task):
        raise _not_understood(request, None, (), True)
    not_of_those_there(request, found.task, draft)
    there = [look(block) for block in history.current.schema.blocks]
    if all(part.kind in _OF_A_BLOCK for part in conjuncts(found.task.goal)) and any(
        look(block) in there for block in found.task.blocks
    ):
        return _clause(request, history, read)
    return found


def _whole(request: str, text: str, offset: int, history: History, read: Reader, intent: Category) -> Interpretation:
    """An instruction that stands for itself takes the place of the goal (or of everything)."""
    schema, diagnostics = read(text)
    if schema is None:
        raise Refusal([_moved(diagnostic, offset) for diagnostic in diagnostics if diagnostic.severity == "error"])
    past = history.current
    task = schema.model_copy(update={"name": past.schema.name, "author": past.schema.author, "seed": past.schema.seed})
    return Interpretation(
        request=request,
        reference=None if intent == "FRESH" else past.number,
        edits=(Overwrite(task=task),),
        task=apply(past.schema, [Overwrite(task=task)]),
        intent="MODIFY" if intent == "PIVOT" and same_structure(past.schema.goal, task.goal) else intent,
        parameters={"instruction": [text]},
        focus=(),
    )


def _moved(diagnostic: Diagnostic, offset: int) -> Diagnostic:
    span = diagnostic.span
    return diagnostic if span is None else diagnostic.model_copy(update={"span": (span[0] + offset, span[1] + offset)})


_OF_INSTRUCTIONS = frozenset({"unknown-word", "misplaced-word", "incomplete"})
"""What the instruction language says of the verbs of edits, which it does not know."""


def _not_understood(request: str, longest: Parsed | None, reasons: Sequence[Diagnostic], edits: bool) -> Refusal:
    """What was not understood: the words that no reading covers, and what the front end says of the sentence."""
    errors = [reason for reason in reasons if reason.severity == "error"]
    if errors and not (edits and errors[0].code in _OF_INSTRUCTIONS):
        return Refusal([errors[0]])
    rest = longest.rest if longest is not None and longest.rest is not None else (0, len(request))
    hint = "say what changes: add, remove, replace, recolour, reverse, sort, undo; or give a whole instruction"
    return Refusal(
        [Diagnostic(code="edit-unclear", message="this was not understood", span=rest, hint=hint, origin="steer")]
    )
