"""What a request says again, "swap them: green on blue, yellow on red", "add an S, so that it reads CATS": it must be
so in the result."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rpg.core.diagnostics import Diagnostic, Refusal, Span
from rpg.ir import goal as g
from rpg.ir.relations import On, OnPatch
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Equation, Spells
from rpg.ir.walk import conjuncts
from rpg.steer.matching import matches
from rpg.steer.requests.language import Parser, longest, m, noun_phrase, tokenize
from rpg.steer.view import BEGINS, ENDS, View

_GOES = "goes | go | should go | belongs | comes | must be | should be | is | lies | has to be | will be"


_READS = re.compile(
    r"[\s,]+so(?: that)? (?:it|the word|the text|the row|they|the equation|the result|the cubes|the blocks)"
    r"(?: now| then)? (?:reads?|spells?|says?|shows?)\s+(?P<text>[\w+*/=\s-]+?)\s*[.!]*$",
    re.IGNORECASE,
)


_FIRST = re.compile(r"\s*first\b", re.IGNORECASE)
"""What is said again are steps, one after the other."""


_ENDS = {
    "on the left": "left", "to the left": "left", "on the right": "right", "to the right": "right", "on top": "top",
    "at the top": "top", "at the bottom": "bottom", "in front": "front", "at the front": "front", "behind": "back",
    "at the back": "back", "on the far left": "left", "on the far right": "right", "underneath": "bottom",
}  # fmt: skip
_ENDS_UP = re.compile(
    r"[\s,]+so(?: that)? (?P<who>[\w\s]+?)(?: now| then)? "
    r"(?:is|are|goes|comes|sits|stands|ends up|will be|should be)(?: now| then)? "
    rf"(?P<where>{'|'.join(_ENDS)})\s*[.!]*$",
    re.IGNORECASE,
)


_ENDED = re.compile(
    rf"[,:]\s*(?:with )?(?P<who>[\w\s]+?) (?:is |goes |now )?(?P<where>{'|'.join(_ENDS)})\s*[.!]*$", re.IGNORECASE
)
_TURNS = re.compile(r"^\W*(?:swap|switch|exchange|reverse|flip|turn|invert|interchange)\b", re.IGNORECASE)


def divided(request: str) -> tuple[str, int] | None:
    """The request before what it says again, and where that begins."""
    if found := _READS.search(request):
        return request[: found.start()], found.start("text")
    if found := _ENDS_UP.search(request) or (_TURNS.match(request) and _ENDED.search(request)) or None:
        return request[: found.start()], found.start("who")
    before, colon, after = request.partition(":")
    if not colon or not before.strip() or not after.strip() or _pairs(after, 0) is None:
        return None
    if _FIRST.match(after) and not re.search(r"\b(?:other way|order|reverse|opposite|swap|switch)\b", before, re.I):
        return None
    return re.sub(r"\b(swap|switch|exchange) it\b", r"\1 them", before), len(before) + 1


def check(request: str, begin: int, task: TaskSchema) -> None:
    """Refuse a request whose second half is not so in the task that its first half led to."""
    view = View(task)
    if found := _READS.search(request):
        text = re.sub(r"\s", "", found["text"])
        if not any(_reads(part) == text for part in conjuncts(task.goal)):
            raise _not_so(found.span("text"))
        return
    if found := _ENDS_UP.search(request) or (_TURNS.match(request) and _ENDED.search(request)) or None:
        if not _at_end(found["who"], _ENDS[found["where"].lower()], view):
            raise _not_so((found.start("who"), found.end("where")))
        return
    pairs = _pairs(request[begin:], begin)
    steps = isinstance(task.goal, g.Sequence)
    stages = [stage.goal for stage in task.goal.stages] if isinstance(task.goal, g.Sequence) else [task.goal]
    at = -1
    for upper, lower, span in pairs or ():
        there = [
            k for k, stage in enumerate(stages) if any(_is_on(part, upper, lower, view) for part in conjuncts(stage))
        ]
        in_turn = bool(_FIRST.match(request[begin:]))
        if not there or in_turn != steps or (in_turn and there[0] <= at):
            raise _not_so(span)
        at = there[0]


def _at_end(who: str, end: str, view: View) -> bool:
    """Whether a block, as a phrase names it, is at an end of its line."""
    p = Parser(tokenize(who)[0])
    named = [noun for noun, j in noun_phrase(p, 0) if j == p.end and isinstance(noun, m.Noun) and _plain(noun)]
    names = [name for name in view.world.blocks if named and matches(view, name, named[0].traits)]
    line = view.line_of(names) if len(names) == 1 else None
    if line is None or not line.ordered or end not in (BEGINS[line.kind], ENDS[BEGINS[line.kind]]):
        return False
    return line.members[0 if end == BEGINS[line.kind] else -1] == names[0]


def _not_so(span: Span) -> Refusal:
    message = "this is not what the first half of the request comes to"
    hint = "say only one of the two"
    return Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])


def _reads(part: g.Goal) -> str:
    """The word or the equation that a condition asks for."""
    if isinstance(part, Spells):
        return part.word[::-1] if part.reverse else part.word
    if isinstance(part, Equation):
        return part.text or ""
    return ""


def _is_on(part: g.Goal, upper: m.Noun, lower: m.Noun, view: View) -> bool:
    if isinstance(part, OnPatch):
        below: tuple[str, ...] = (part.patch,)
    elif isinstance(part, On) and isinstance(part.b, tuple):
        below = part.b
    else:
        return False
    if not isinstance(part.a, tuple):
        return False
    patches = set(view.world.patches)
    kind = {"patch": patches, "block": set(view.world.blocks)}.get(lower.head, patches | set(view.world.blocks))
    fits = all(name in kind and matches(view, name, lower.traits) for name in below)
    return fits and all(matches(view, name, upper.traits) for name in part.a)


def _pairs(text: str, begin: int) -> list[tuple[m.Noun, m.Noun, Span]] | None:
    """Every "green on blue" of a list; None where the text says anything else."""
    p = Parser(tokenize(text)[0])
    while p.end and p.words[p.end - 1] in (".", "!"):
        p = Parser(p.tokens[: p.end - 1])
    found: list[tuple[m.Noun, m.Noun, Span]] = []
    i = longest(p, 0, "first , | first")
    while i < p.end:
        one = max(_pair(p, i), key=lambda each: each[2], default=None)
        if one is None:
            return None
        upper, lower, j = one
        start, end = p.span(i, j)
        found.append((upper, lower, (start + begin, end + begin)))
        i = longest(p, j, ", and | and | , | ; | , then | then | , and then | and then") or j
        if i == j and j < p.end:
            return None
    return found or None


def _pair(p: Parser, i: int) -> Iterator[tuple[m.Noun, m.Noun, int]]:
    for upper, j in noun_phrase(p, i):
        j = longest(p, j, _GOES) or j
        k = longest(p, j, "on top of | onto | on")
        for lower, end in noun_phrase(p, k) if k else ():
            if isinstance(upper, m.Noun) and isinstance(lower, m.Noun) and _plain(upper) and _plain(lower):
                yield upper, lower, end


def _plain(noun: m.Noun) -> bool:
    """Whether a phrase says one colour, one symbol or one size, and nothing else."""
    one = len(noun.traits.colors) + len(noun.traits.labels) + bool(noun.traits.size) == 1
    return one and not (noun.conditions or noun.part_of or noun.amount)
