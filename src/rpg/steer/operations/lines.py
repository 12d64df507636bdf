"""Lines of blocks rebuilt: members inserted, taken out, put in another order."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from rpg.blocks.predicates.order import SORTED
from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.edits import AddCondition, ChangeCondition, Path, SetField, SetGoal
from rpg.ir.node import Highest, Lowest
from rpg.ir.node import members as operand_members
from rpg.ir.order import Order
from rpg.ir.relations import Behind, Between, InFrontOf, LeftOf, On, RightOf
from rpg.ir.structures import Equation, Row, Spells, Stack
from rpg.ir.walk import transform
from rpg.steer.draft import Draft
from rpg.steer.requests.language import m
from rpg.steer.view import BEGINS, ENDS, STEPS, Line


def insert(draft: Draft, line: Line, index: int, name: str, span: Span | None = None) -> None:
    """Put the new block `name` at `index` of `line`; what is said of the whole line is said of it with the block."""
    _insert(draft, line, index, name, span)
    if line.node is not None and len(line.members) > 1:
        goal = transform(draft.schema.goal, lambda node: of_all(node, line.members, (name,)))
        if goal != draft.schema.goal:
            draft.do(SetGoal(goal=goal), span)


def of_all(node: g.Goal, members: Sequence[str], new: tuple[str, ...]) -> g.Goal:
    """A relation of the whole line, with new blocks among its own."""
    update: dict[str, object] = {}
    for field in ("a", "b", "c"):
        value = getattr(node, field, None)
        whole = value is not None and not isinstance(value, str) and set(operand_members(value)) == set(members)
        if whole and isinstance(value, Lowest):
            update[field] = Lowest(lowest=(*value.lowest, *new))
        elif whole and isinstance(value, Highest):
            update[field] = Highest(highest=(*value.highest, *new))
        elif whole and isinstance(value, tuple):
            update[field] = (*value, *new)
    return node.model_copy(update=update) if update else node


def _insert(draft: Draft, line: Line, index: int, name: str, span: Span | None) -> None:
    if line.node is None:
        _insert_in_chain(draft, line, index, name)
        return
    if isinstance(line.node, Spells | Equation) and not Traits(draft.view.world).symbol(name):
        told, hint = (
            "nothing that shows no symbol may adjoin what these cubes spell",
            "say beside which cube, and how far",
        )
        raise draft.refusal("breaks-structure", told, span, hint)
    members = (*line.members[:index], name, *line.members[index:])
    if not line.ordered:
        free_order = isinstance(line.node, Stack | Row) and line.node.order.by == "any"
        if index == 1 and len(line.members) == 2 and free_order:
            draft.do(SetField(at=line.path, field="blocks", value=members), span)
            draft.do(AddCondition(goal=Between(a=(name,), b=line.members[:1], c=line.members[1:])), span)
            return
        if index not in (0, len(line.members)):
            raise draft.refusal(
                "edit-unclear",
                "the order of these blocks is free, so that there is no such place among them",
                span,
                "put it at an end",
            )
        if isinstance(line.node, Equation):
            told, hint = "an equation has no place for one more cube", "give the equation: change it to 2 + 3 = 5"
            raise draft.refusal("breaks-structure", told, span, hint)
        free = _free_groups(line)
        groups = (*free, (name,)) if index else ((name,), *free)
        draft.do(ChangeCondition(at=line.path, to=_with_ranks(line, members, groups)), span)
        return
    draft.do(ChangeCondition(at=line.path, to=arranged(draft, line, members)), span)


def _free_groups(line: Line) -> tuple[tuple[str, ...], ...]:
    """The ranks of a line that leaves a choice, listed from where lines of its kind begin."""
    assert isinstance(line.node, Stack | Row)
    order = line.node.order
    if order.by != "given":
        return (line.members,)
    turned = order.first == ENDS[BEGINS[line.kind]]
    return tuple(reversed(order.ranks)) if turned else order.ranks


def pin(draft: Draft, names: Sequence[str], span: Span) -> None:
    """Blocks that a phrase picked by their place keep it, though they looked like others of their line."""
    line = draft.view.line_of(names)
    if line is None or not isinstance(line.node, Stack | Row) or not line.ordered:
        return
    order = line.node.order
    if order.by not in ("any", "given"):
        return
    rank = {name: index for index, ranked in enumerate(order.ranks) for name in ranked}
    chosen = set(names)
    groups = [
        tuple(members) for _, members in groupby(line.members, key=lambda name: (rank.get(name, 0), name in chosen))
    ]
    if len(groups) > max(1, len(order.ranks)):
        draft.do(ChangeCondition(at=line.path, to=_with_ranks(line, line.members, groups)), span)


def by_place(phrase: m.Meaning | None) -> bool:
    """Whether a phrase picks blocks by where they are: "the top block", "the second one"."""
    return isinstance(phrase, m.PartOf) or (isinstance(phrase, m.Noun) and bool(phrase.traits.rank))


def arranged(draft: Draft, line: Line, members: Sequence[str]) -> g.Goal:
    """The structure of `line` with `members` in this order."""
    node = line.node
    if isinstance(node, Spells):
        traits = Traits(draft.view.world)
        letters = [traits.symbol(name) for name in members]
        backwards = node.reverse != (node.along == "stack")
        word = "".join(reversed(letters) if backwards else letters)
        return node.model_copy(update={"blocks": tuple(members), "word": word})
    if isinstance(node, Equation):
        return node.model_copy(update={"blocks": tuple(members), "text": None})
    assert isinstance(node, Stack | Row)
    same = node.model_copy(update={"blocks": tuple(members)})
    kept = draft.view.sequence(same.blocks, node.order, line.kind)
    if node.order.by in (*SORTED, "any") and kept is not None and _looks(draft, kept) == _looks(draft, members):
        return same
    return _with_ranks(line, members, tuple((name,) for name in members))


def _looks(draft: Draft, members: Sequence[str]) -> list[tuple[str, ...]]:
    return [draft.view.world.look[name] for name in members]


def _with_ranks(line: Line, members: Sequence[str], ranks: Sequence[tuple[str, ...]]) -> g.Goal:
    """The structure with its members ranked from where the line begins."""
    assert isinstance(line.node, Stack | Row)
    begin = BEGINS[line.kind]
    first = line.node.order.first
    turned = first == ENDS[begin]
    listed = tuple(reversed(ranks) if turned else ranks)
    begins = first or (None if line.kind == "tower" else begin)
    order = Order.model_validate({"by": "given", "ranks": listed, "first": begins})
    return line.node.model_copy(update={"blocks": tuple(members), "order": order})


def _insert_in_chain(draft: Draft, line: Line, index: int, name: str) -> None:
    """A chain of relations: the new block is related to its neighbours, which are not to each other any more."""
    before = line.members[index - 1] if index else None
    after = line.members[index] if index < len(line.members) else None
    if before is not None and after is not None:
        path = link(draft, before, after)
        new = g.All(goals=(step(line, before, name), step(line, name, after)))
        if path is not None:
            draft.do(ChangeCondition(at=path, to=new))
            return
    if before is not None:
        draft.do(AddCondition(goal=step(line, before, name)))
    if after is not None:
        draft.do(AddCondition(goal=step(line, name, after)))


def step(line: Line, before: str, after: str) -> g.Goal:
    """The relation between two neighbours of a chain."""
    if line.kind == "tower":
        return On(a=(after,), b=(before,))
    return LeftOf(a=(before,), b=(after,)) if line.kind == "row" else InFrontOf(a=(before,), b=(after,))


def link(draft: Draft, before: str, after: str) -> Path | None:
    """Where the goal relates two neighbours of a chain directly."""
    for path, atom in draft.view.atoms:
        if isinstance(atom, On) and atom.a == (after,) and atom.b == (before,):
            return path
        if isinstance(atom, LeftOf | RightOf | InFrontOf | Behind):
            first, second = (atom.a, atom.b) if STEPS[atom.kind][1] else (atom.b, atom.a)
            if first == (before,) and second == (after,):
                return path
    return None
