"""What counts, said of a task that was told already: "both outcomes should pass", "success only when all four are
there", "the order matters". Each is a pattern of the whole clause, and whether the task says so without it."""

from __future__ import annotations

from collections.abc import Callable

from rpg.ir import goal as g
from rpg.ir.assets import Block
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import atoms, names, within
from rpg.language import lexicon
from rpg.language.grammar.rows.order_matters import ORDER_BINDS

Parts = dict[str, str | None]
Check = Callable[[TaskSchema, Parts], bool]
"""Whether a task says it without the clause, of which these are the parts."""


def _ordered(task: TaskSchema, told: Parts) -> bool:
    """Whether all lines have an order, or what is done has."""
    lines = [atom for atom in atoms(task.goal) if isinstance(atom, Row | Stack) and len(atom.blocks) > 1]
    staged = any(isinstance(goal, g.Sequence) for goal in within(task.goal))
    return all(atom.order.by != "any" for atom in lines) and (staged or bool(lines))


def _one_or_other(task: TaskSchema, told: Parts) -> bool:
    """Whether one of two things is asked for."""
    return any(isinstance(goal, g.Any) for goal in within(task.goal))


def _all_of_it(task: TaskSchema, told: Parts) -> bool:
    """Whether all that is asked for holds at the end, of just so many blocks as are told."""
    if any(isinstance(goal, g.Any | g.Count) for goal in within(task.goal)):
        return False
    undone = [goal for goal in within(task.goal) if isinstance(goal, g.Sequence) and any(s.undone for s in goal.stages)]
    blocks = {asset.name for asset in task.assets if isinstance(asset, Block)}.intersection(names(task.goal))
    number = 2 if told["all"] == "both" else lexicon.NUMBER.get(told["n"] or "") or int(told["n"] or 0)
    return not undone and number in (0, len(blocks))


_MADE = "(?:outcomes?|results?|solutions?|options?|alternatives?|variants?|possibilit(?:y|ies)|cases?|ways?)"
_PASSES = (
    "(?:(?:(?:is|are|be) )?(?:fine|ok|okay|alright|good|accepted|acceptable|allowed|valid|correct|possible)"
    "(?: (?:with|by|for) (?:me|us))?|(?:counts?|pass(?:es)?|succeeds?|works?)(?: as (?:a )?success| equally)?)"
)
_WON = "(?:the |this |that |our )?(?:success|reward|task|episode|trial|run|attempt|goal|it|this|that)"
_COUNTED = (
    "(?:(?:is|are|gets|will be|should be|must be) )?(?:only )?(?:(?:counted|counts?|given|granted|awarded|reached|"
    "achieved|complete|completed|done|finished|successful|met|passed|passes|solved|fulfilled|over|declared|a success|"
    "succeeds) )?(?:as (?:a success|success|done|solved|passed|complete) )?(?:only )?"
)
_DONE = "(?:done|finished|complete|completed|successful|passed|solved)"
_WHEN = "(?:when|once|if|as soon as|if and only if|iff)"
_THERE = (
    "(?:(?:is|are|stands?|sits?|lies?|has been|have been) )(?:all )?(?:there|in place|in position|placed|done|"
    "(?:in|at|on) (?:its|their) (?:places?|spots?|positions?|corners?|patch|patches|mats?|targets?)|"
    "like (?:this|that)|so|where (?:it|they) (?:belongs?|should be)|fulfilled|met|filled|taken|occupied)"
    "(?: at the end| together)?"
)
_SO_MANY = f"(?P<n>{'|'.join(sorted(lexicon.NUMBER))}|\\d+)"
_THINGS = (
    f"(?P<all>all|both|everything|it)(?: {_SO_MANY})?(?: of (?:them|these|those|it))?"
    "(?: (?:the )?(?:blocks|cubes|corners|conditions))?"
)

SAID_OF_SUCCESS: tuple[tuple[str, Check], ...] = (
    (ORDER_BINDS, _ordered),
    (f"(?:both|either|each|any|all)(?: one)?(?: of (?:them|these|those|the two))?(?: {_MADE})?"
     f"(?: should| may| can| would| will)? {_PASSES}", _one_or_other),
    (f"(?:{_WON} {_COUNTED}|{_DONE} (?:only )?){_WHEN} {_THINGS} {_THERE}", _all_of_it),
)  # fmt: skip
