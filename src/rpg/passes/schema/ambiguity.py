"""Two readings of one instruction: whether they differ, and how that is said to people."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from rpg.blocks.english import describe, describe_goal
from rpg.blocks.equivalence import equivalent
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.goal import Goal
from rpg.ir.relations import On
from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.ir.structures import Stack
from rpg.ir.walk import rename

_UNORDERED = frozenset({"blocks", "assets", "groups"})
"""Lists of which it does not matter in what order they are given."""
Reader = Callable[[str], TaskSchema | None]


class TwoReadings(Refusal):
    """An instruction with two readings; the tasks that they come to."""

    def __init__(self, first: TaskSchema, second: TaskSchema, text: str) -> None:
        self.tasks = (first, second)
        one, two = _apart(*(_sentences(describe(task)) for task in self.tasks))
        message = f'this can be read in two ways: "{one}", or "{two}"'
        super().__init__(
            [Diagnostic(code="ambiguous", message=message, span=(0, len(text)), hint=_HINT, origin="schema")]
        )

    def reworded(self, read: Reader) -> tuple[Diagnostic, ...]:
        """The refusal with words for each reading that `read` takes for just that."""
        words = [text for text in (_wording(task, read) for task in self.tasks) if text is not None]
        found = self.diagnostics[0]
        if not words:
            return (found,)
        hint = "say " + ", or ".join(f'"{text}"' for text in words)
        hint += " if that is meant" if len(words) == 1 else ""
        return (found.model_copy(update={"hint": hint, "facts": {"readings": words}}),)


_HINT = "say it in several short sentences"


def same(a: TaskSchema, b: TaskSchema) -> bool:
    """Whether two readings come to the same task."""
    word_for_word = (a.goal, a.init, a.assets) == (b.goal, b.init, b.assets)
    return word_for_word or _bare(a) == _bare(b) or equivalent(a, b) or _alike_but_for_paint(a, b)


def _alike_but_for_paint(a: TaskSchema, b: TaskSchema) -> bool:
    """Whether they differ in colours alone that neither was told: the first choice of them is as good as the other."""
    if not all(task.assumed(COLORS_UNSAID) for task in (a, b)):
        return False
    return _unpainted(a) == _unpainted(b)


def _unpainted(schema: TaskSchema) -> str:
    """The task with its blocks called by their place in the list, whatever colours were chosen for them."""
    names = {asset.name: f"#{index}" for index, asset in enumerate(schema.assets)}
    goal = rename(schema.goal, names).model_dump(mode="json")
    start = [rename(x, names).model_dump(mode="json") for x in schema.init.arranged]
    told = [said.partition(": ")[2] for said in schema.assumptions if said.startswith(COLORS_UNSAID)]
    chosen = {color for said in told for color in said.split(", ")}
    looks = [asset.model_dump(mode="json", exclude={"name"}) for asset in schema.assets]
    looks = [{**x, "color": "" if {x["color"], "one of each colour"} & chosen else x["color"]} for x in looks]
    return repr((_unspanned(goal, len(schema.blocks)), _unspanned(start, len(schema.blocks)), looks))


def _bare(schema: TaskSchema) -> str:
    data = schema.model_dump(exclude={"name", "instruction", "assumptions", "paraphrases"}, mode="json")
    data["init"]["arranged"] = _as_it_lies(schema.init.arranged)
    return repr(_unspanned(data, len(schema.blocks)))


def _as_it_lies(arranged: tuple[Goal, ...]) -> list[object]:
    """What is so at the start, its stacks as which block lies on which: it is the same whatever says it."""
    lies = sorted({pair for goal in arranged for pair in _lying(goal)})
    others = [goal for goal in arranged if not _lying(goal) and not _said_by(goal, lies)]
    return [*([lower, upper] for lower, upper in lies), *(goal.model_dump(mode="json") for goal in others)]


def _lying(goal: Goal) -> list[tuple[str, str]]:
    """Each block of a stack with the one on it, if just that is said; nothing for other goals."""
    if isinstance(goal, On) and goal == On(a=goal.a, b=goal.b, span=goal.span):
        return [(goal.b, goal.a)] if isinstance(goal.a, str) and isinstance(goal.b, str) else []
    if not isinstance(goal, Stack) or goal.order.by != "given" or any(len(rank) > 1 for rank in goal.order.ranks):
        return []
    plain = Stack(blocks=goal.blocks, order=goal.order, exact=goal.exact, raised=goal.raised, span=goal.span)
    up = [rank[0] for rank in goal.order.ranks]
    up = up[::-1] if goal.order.first == "top" else up
    return list(pairwise(up)) if goal == plain and not goal.order.descending else []


def _said_by(goal: Goal, lies: list[tuple[str, str]]) -> bool:
    """Whether it is a stack of no order, whose blocks are known to lie on each other."""
    if not isinstance(goal, Stack) or goal != Stack(blocks=goal.blocks, exact=goal.exact, span=goal.span):
        return False
    within = [pair for pair in lies if set(pair) <= set(goal.blocks)]
    return len(within) == len(goal.blocks) - 1


def _unspanned(data: object, blocks: int, start: bool = False) -> object:
    """Without spans, without what has no order, and without "exact" for a stack of every block there is and for one of
    the start: nothing else could be in it; without what tells groups apart of which it is said who is in them."""
    if isinstance(data, dict):
        whole = data.get("kind") == "stack" and (start or len(data["blocks"]) == blocks)
        named = data.get("kind") == "group_by" and not data["outliers"]
        told = "exact" if whole else "by" if named else ""
        kept = {
            k: _unspanned(v, blocks, start or k == "init") for k, v in _one_way(data).items() if k not in ("span", told)
        }
        return {k: sorted(v, key=repr) if k in _UNORDERED and isinstance(v, list) else v for k, v in kept.items()}
    if isinstance(data, list):
        return [_unspanned(v, blocks, start) for v in data]
    return data


_OTHER_END = {"top": "bottom", "right": "left", "back": "front"}


def _one_way(data: dict[str, Any]) -> dict[str, Any]:
    """Ascending from the top is descending from the bottom: orders are told from one side."""
    first = _OTHER_END.get(data.get("first") or "")
    if first is not None and data.get("by") == "given":
        return {**data, "first": first, "ranks": data["ranks"][::-1]}
    if first is None or data.get("by") not in ("label", "number", "size"):
        return data
    return {**data, "first": first, "descending": not data.get("descending")}


def _wording(task: TaskSchema, read: Reader) -> str | None:
    """The shortest description of a task that is read as that task."""
    for text in (describe_goal(task), describe(task)):
        found = read(text)
        if found is not None and same(found, task):
            return text
    return None


def _sentences(reading: str) -> list[str]:
    return [f"{sentence}." for sentence in reading.removesuffix(".").split(". ")]


def _apart(first: list[str], second: list[str]) -> tuple[str, str]:
    """What each reading says that the other does not; all of it, where one of them says nothing more."""
    own = [s for s in first if s not in second], [s for s in second if s not in first]
    if all(own):
        return " ".join(own[0]), " ".join(own[1])
    return " ".join(first), " ".join(second)
