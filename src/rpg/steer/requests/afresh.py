"""Requests that are sentences of the instruction language: whole instructions, and clauses about the task at hand."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rpg.blocks.english import describe
from rpg.blocks.english.scene import objects
from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import bare
from rpg.blocks.state import World
from rpg.blocks.symmetry import Canonical
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.assets import Asset
from rpg.ir.edits import AddAsset, AddCondition, SetGoal, SetStart
from rpg.ir.relations import Beside, Directional, Swapped
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import GroupBy
from rpg.ir.walk import conjuncts, rename, transform
from rpg.ir.walk import names as mentions
from rpg.steer.draft import Draft
from rpg.steer.proof.identity import look
from rpg.steer.proof.shape import same_structure
from rpg.steer.refer import resolve
from rpg.steer.requests.known import names_structure, only_known, only_new
from rpg.steer.requests.language import m
from rpg.steer.view import NOUNS
from rpg.steer.wholes import noun_of

_FRESH = re.compile(
    r"^\W*(?:(?:ok(?:ay)?|now|actually|please|never ?mind|hm+|no|scratch that|wait|well)\b[\s,.;:!-]*)*"
    r"(?:(?:(?:make\s+(?:it|this)\s+)?(?:a\s+)?(?:(?:completely|totally|entirely|brand)\s+)?"
    r"(?:new|different|another|other|fresh)\s+(?:task|instruction|scene|problem)(?:\s+instead)?)"
    r"|start(?:ing)?\s+(?:over|afresh|again|from\s+scratch)|from\s+scratch"
    r"|forget\s+(?:all\s+(?:of\s+)?)?(?:about\s+)?(?:that|this|it|everything)"
    r"(?:\s+and\s+start\s+(?:over|afresh|again|from\s+scratch))?"
    r"|(?:something|a)\s+(?:completely|totally|entirely|quite)\s+(?:different|new)(?:\s+task)?"
    r"|throw\s+(?:it\s+all|everything)\s+away|clear\s+everything)"
    r"\s*(?:[:.,;!-]|and|with|then)*\s+(?:(?:and|then|instead|now)\s+)?",
    re.IGNORECASE,
)
_COMPARED = re.compile(r"[\s,]+(?:instead|again)[\s.!?]*$", re.IGNORECASE)
_ADDS = re.compile(
    r"\b(?:also|too|as well|must|should|shall|has to|have to|needs? to|without|while|starts?|starting|begins?|beginning"
    r"|still|in addition|furthermore|moreover|keep)\b|^\W*(?:and|plus|then|afterwards|after that|finally)\b"
    r"|^\W*(?:please\W+)?(?:another|one more|two more|a further|a second)\b"
    r"|\b(?:before that|beforehand)\b|\bfirst\W*$|^\W*(?:but\s+)?first\b(?!.*\bthen\b)",
    re.IGNORECASE,
)


_ONE_MORE = re.compile(
    r"\b(?:as|in) (?:a|an|the) (?:second|third|fourth|fifth|sixth|further|separate|new) (?:group|pile|tower|stack)\b",
    re.IGNORECASE,
)


_NUMBER = re.compile(
    r"^\W*(?:(?:just|only|now|then|and)\s+)*(?:\d+|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve)\s",
    re.IGNORECASE,
)


_PUTS = re.compile(
    r"^\W*(?:(?:now|and|also|then|please)\s+)*(?!(?:the|it|them|all|both|these|each)\b)(?:"
    r"(?:put|place|add|set|stick)\s+(?!(?:the|it|them|all|both|these|each)\b)"
    r"|(?:an?\s+)?\w+(?:\s+(?:block|cube|one|brick)s?)?\s+(?:in|at|on)\b)",
    re.IGNORECASE,
)
_PARTS = re.compile(
    r"\b(?:each|every|both|all|the|its)\s+(?:\w+\s+)?(?:corner|end|edge|side|middle|centre|center|top|bottom)s?\b"
    r"(?!\s+(?:of|half|side))",
    re.IGNORECASE,
)


def speaks_of_parts(request: str) -> bool:
    """Whether a request puts something at places that what is built has, and not at the table's."""
    return bool(_PUTS.match(request) and _PARTS.search(request)) and "table" not in request.lower()


_SETTING = re.compile(r"^\W*\w+(?: \w+)?\s*[:=]\s*[\w.+-]+(?:\s+\w+)?\W*$")


_OF_THOSE_THERE = re.compile(
    r"^\W*(?:\w+\W+){0,3}?(?:move|shift|transfer|take|bring|carry)\s+(?:an?|one|two|three|\d+|some)\b.*\bfrom\b"
    r"|\bin (?:its|their|that|the same) (?:place|places|spot|stead)\b"
    r"|^\W*(?:the )?same (?:thing |again |task )?with\b"
    r"|^\W*(?:write|spell|print|paint|label)\b.*\b(?:on|onto) (?:it|them|these|those|the (?:blocks|cubes))\W*$"
    r"|^(?!.*\b(?:build|make|put|place|stack|tower|row|pyramid)\b)(?:(?!\b(?:on|of)\b).)+\bon top\W*$",
    re.IGNORECASE,
)


def of_those_there(request: str) -> bool:
    """Whether a request can only be about what is there: "move one block from the red mat", "a red one in its place",
    or a mere "top: white"."""
    return bool(_OF_THOSE_THERE.search(request) or _SETTING.match(request))


def only_a_number(request: str) -> bool:
    """Whether a request begins with how many, and has no verb before it."""
    return bool(_NUMBER.match(request)) and by_itself(request) == request


_OF_THEM = re.compile(
    r"^(?:(?!\b(?:an?|one|two|three|four|five|six|seven|eight|nine|ten|\d+)\b).)*?"
    r"\b(?:them|they|it|these|those|the (?:blocks|cubes|bricks))\b",
    re.IGNORECASE,
)


def of_them(request: str) -> bool:
    """Whether a request speaks of "them", "the blocks", before it brings in any block itself."""
    return bool(_OF_THEM.match(request))


_ALL = re.compile(r"^\W*(?:(?:and|now|also|then|but)\s+)*(?:each|every|all|both|none|no)\b", re.IGNORECASE)


_NAMED = re.compile(r"^\W*(?:(?:just|only|now|then|and|rather)\s+)*(?:(?:in|as|into)\s+)?(?:a|an|one)\s", re.IGNORECASE)


def only_named(request: str) -> bool:
    """Whether a request only names something: "a rectangle of six", "in a circle"."""
    return bool(_NAMED.match(request) or _NUMBER.match(request))


def of_all(request: str) -> bool:
    """Whether a request begins with "every", "all", "both": of what is there, rather than of blocks it would bring."""
    return bool(_ALL.match(request))


def one_more(request: str) -> bool:
    """Whether a request speaks of one more of what the task has: no instruction of its own does."""
    return bool(_ONE_MORE.search(request))


@dataclass(frozen=True)
class Fresh:
    """The instruction after "new task:", and where it begins in the request."""

    text: str
    offset: int

    @staticmethod
    def adds(request: str) -> bool:
        """Whether a sentence says something more about the task at hand rather than giving another one."""
        return bool(_ADDS.search(request))


def by_itself(request: str) -> str:
    """The request without a closing word that only compares it with the task at hand ("spell CAT instead")."""
    return _COMPARED.sub("", request)


def fresh_start(request: str) -> Fresh | None:
    """The new task in a request that gives up the old one."""
    found = _FRESH.match(request)
    if found is None or found.end() >= len(request.rstrip()):
        return None
    return Fresh(by_itself(request[found.end() :]), found.end())


def extended(
    draft: Draft, request: str, begin: int, read: Callable[[str], tuple[TaskSchema | None, tuple[Diagnostic, ...]]]
) -> None:
    """Read the words of `request` from `begin` on as one more sentence about the task, and take over what they add."""
    only_known(draft, request, begin)
    if _APART.search(request):
        raise Refusal([_vague(begin, len(request))])
    said = _by_name(draft, request[begin:].strip(" ,;"))
    known = describe(draft.schema)
    whole = f"{known} {said[:1].upper()}{said[1:]}"
    schema, diagnostics = read(whole)
    if schema is None:
        errors = [d for d in diagnostics if d.severity == "error"]
        raise Refusal(
            [_placed(error, len(known) + 1, begin, len(request)) for error in errors] or [_vague(begin, len(request))]
        )
    names = counterparts(draft.schema, schema)
    if names is None or _says_nothing(read(known)[0], schema):
        raise Refusal([_vague(begin, len(request))])
    only_new(draft, request, begin, schema)
    if _THE_BLOCK.search(request) and len(schema.blocks) > len(draft.schema.blocks) > 1:
        raise Refusal([_vague(begin, len(request))])
    _take_over(draft, request, schema, names, (begin, len(request)))


def _says_nothing(before: TaskSchema | None, after: TaskSchema) -> bool:
    """Whether a text asks for the same with one more sentence, which is only talk then: "looks nice"."""
    if before is None:
        return False
    same = before.assets == after.assets and before.init == after.init
    return same and _bare(before.goal) == _bare(after.goal)


_APART = re.compile(
    r"\b(?:take|taken|pull|pulled|break|broken)\b.*\b(?:apart|down|up)\b|\b(?:unstack|dismantle|disassemble)",
    re.IGNORECASE,
)
"""What is built is to be built no more: nothing that a sentence could add to the task."""


_THE_BLOCK = re.compile(r"^\W*(?:\w+\W+){0,6}?the (?:block|cube|one|box|brick)\b", re.IGNORECASE)
"""Some block that is there, by its place alone: a sentence about it brings no other one."""


_AGAINST = re.compile(r"^\W*(?:(?:no|now|actually|instead|rather|then|ok(?:ay)?|please)\b[\s,]*)+", re.IGNORECASE)


_OF_WHAT_IS_SAID = re.compile(r"\b(?:it|its|this|that|rest|others?|remaining|else)\b", re.IGNORECASE)
"""Words for what was said before, which a goal that takes the place of the old one leaves behind."""


def reused(draft: Draft, request: str, read: Callable[[str], tuple[TaskSchema | None, tuple[Diagnostic, ...]]]) -> None:
    """Read a request as an instruction about the blocks that are there. Its goal takes the place of the old one where
    it needs all blocks that the old one spoke of, and no others."""
    span = (0, len(request))
    only_known(draft, request, 0)
    if names_structure(draft, request) or _OF_WHAT_IS_SAID.search(request):
        raise Refusal([_vague(*span)])
    there = ". ".join(objects(draft.schema, Speaker(draft.view.world)))
    schema, _ = read(f"{there}. {_AGAINST.sub('', by_itself(request))}")
    names = None if schema is None else counterparts(draft.schema, schema)
    if schema is None or names is None or len(schema.assets) != len(draft.schema.assets):
        raise Refusal([_vague(*span)])
    init = schema.init
    goal = rename(schema.goal, names)
    if init.arranged or init.heaps or init.poses or not set(draft.view.busy) <= set(mentions(goal)):
        raise Refusal([_vague(*span)])
    draft.aim("MODIFY" if same_structure(draft.schema.goal, goal) else "PIVOT")
    draft.do(SetGoal(goal=goal), span)
    draft.note("instruction", by_itself(request))
    draft.look_at(())


def _by_name(draft: Draft, said: str) -> str:
    """A clause about "it", with what the word means here in its place: in a longer text it could mean another."""
    found = re.match(r"it\b(?=\s)", said, re.IGNORECASE)
    if found is None:
        return said
    meant = resolve(draft.view, m.Pronoun(word="it", span=(0, 2)))
    noun = noun_of(draft.view, meant.line) if meant.line else NOUNS[type(meant.figure.node)] if meant.figure else None
    return f"the {noun or bare(meant.names[0], draft.view.world)}{said[found.end() :]}"


def _placed(error: Diagnostic, known: int, begin: int, end: int) -> Diagnostic:
    """A finding about the whole text, at the words of the request."""
    span = (begin, end)
    if error.span is not None and error.span[0] >= known:
        span = (error.span[0] - known + begin, min(end, error.span[1] - known + begin))
    return error.model_copy(update={"span": span, "labels": ()})


def _vague(begin: int, end: int) -> Diagnostic:
    message = "this could not be joined to the task"
    return Diagnostic(
        code="edit-unclear", message=message, span=(begin, end), hint="give the whole instruction", origin="steer"
    )


def counterparts(old: TaskSchema, new: TaskSchema) -> dict[str, str] | None:
    """Names in `new` -> names in `old` of the objects that both have by look; None where one of `old` is missing."""
    free = list(new.assets)
    found: dict[str, str] = {}
    for asset in old.assets:
        twin = next((a for a in free if a.name == asset.name and _look(a) == _look(asset)), None)
        twin = twin or next((a for a in free if _look(a) == _look(asset)), None)
        if twin is None:
            return None
        free.remove(twin)
        found[twin.name] = asset.name
    taken = set(found.values())
    for asset in free:
        name, number = asset.name, 2
        while name in taken:
            name, number = f"{asset.name}_{number}", number + 1
        taken.add(name)
        found[asset.name] = name
    return found


def _look(asset: Asset) -> dict[str, object]:
    found = look(asset)
    if asset.type == "GoalPatch":
        found.pop("size", None)
    return found


_MERE = re.compile(r"^\W*(?:\d+|two|three|four|five|six)\s+\w+\W*$", re.IGNORECASE)
"""A number of something, "two rows": no sentence about the task."""
_FIGURE = re.compile(r"\b(?:in|into|as|to) an? (?:circle|ring|square|rectangle)\W*$", re.IGNORECASE)
"""What blocks form, and no patch of that shape."""


_IS_THERE = re.compile(
    r"\b(?:is|are|be|lies?|lying|stands?|sits?|has|have|with|put|place|add|include|also|too|as well|around"
    r"|besides|distractors?)\b",
    re.IGNORECASE,
)
"""What says of a block only that it is there; a mere "4 blue ones" may be what other blocks become."""


def _take_over(draft: Draft, request: str, schema: TaskSchema, names: dict[str, str], span: tuple[int, int]) -> None:
    """New objects, conditions and starts of the longer text."""
    kept = {asset.name for asset in draft.schema.assets}
    busy = set(draft.view.busy)
    for asset in schema.assets:
        name = names[asset.name]
        if name not in kept:
            draft.do(AddAsset(asset=asset.model_copy(update={"name": name})), span)
    canonical = Canonical(World(draft.schema.assets))
    before = [canonical(part, {}) for part in conjuncts(draft.schema.goal)]
    parts = [rename(part, names) for part in conjuncts(schema.goal)]
    new = [part for part in parts if canonical(part, {}) not in before]
    if any(isinstance(part, GroupBy) and len(part.groups) == 1 for part in new):
        raise Refusal([_vague(*span)])
    shaped = any(asset.type == "GoalPatch" and names[asset.name] not in kept for asset in schema.assets)
    if (new and _MERE.match(request)) or (shaped and _FIGURE.search(request)):
        raise Refusal([_vague(*span)])
    if any(isinstance(part, Swapped) and busy & set(mentions(part)) for part in new):
        raise Refusal([_vague(*span)])  # they change places in the goal, not from the start to the end
    if not _BESIDES.search(request) and any(_elsewhere(part, conjuncts(draft.schema.goal)) for part in new):
        told, hint = (
            "it is not said whether this comes besides the place that it has, or instead",
            "say 'move', or 'also'",
        )
        raise Refusal([Diagnostic(code="edit-unclear", message=told, span=span, hint=hint, origin="steer")])
    if all(told in [canonical(part, {}) for part in parts] for told in before):
        for part in new:
            draft.do(AddCondition(goal=part), span)
    elif new:
        draft.do(SetGoal(goal=rename(schema.goal, names)), span)
    init = schema.init.model_copy(
        update={
            "arranged": tuple(rename(goal, names) for goal in schema.init.arranged),
            "heaps": tuple(tuple(names[n] for n in heap) for heap in schema.init.heaps),
            "poses": tuple(s.model_copy(update={"block": names[s.block]}) for s in schema.init.poses),
            "vacant": draft.schema.init.vacant,
        }
    )
    brings = len(schema.assets) > len(kept) and not new and init == draft.schema.init
    if brings and not _IS_THERE.search(request[span[0] :]):
        told, hint = "it is not said whether these come besides or instead", "say 'add ...', or what they replace"
        raise Refusal([Diagnostic(code="edit-unclear", message=told, span=span, hint=hint, origin="steer")])
    if init != draft.schema.init:
        draft.do(SetStart(init=init), span)
    draft.aim("EXTEND" if new else "TWEAK")
    draft.note("clause", new[0].kind if new else "start")
    draft.look_at(tuple(n for n in names.values() if n not in kept) or _mentioned(draft, new))


_BESIDES = re.compile(r"\b(?:also|too|as well|and|both|still|besides|in addition|finally|then|first)\b", re.IGNORECASE)


def _elsewhere(part: g.Goal, before: Sequence[g.Goal]) -> bool:
    """Whether a block, of which the goal says on which side of one thing it is, is to be on that side of another."""
    if not isinstance(part, Directional | Beside):
        return False
    return any(old.kind == part.kind and old.a == part.a and old.b != part.b for old in before if hasattr(old, "a"))


def _mentioned(draft: Draft, new: Sequence[g.Goal]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(n for part in new for n in mentions(part) if n in draft.view.world.blocks))


def _bare(goal: g.Goal) -> str:
    return transform(goal, lambda node: node.model_copy(update={"span": None})).model_dump_json()
