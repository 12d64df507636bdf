"""Towers that stand at the start and that the goal speaks of: "there is a tower of three; put the blue block on it"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.walk import atoms, children, names, rebuild
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene


def still_standing(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal`, and that the towers and rows of the start still stand to which it relates blocks: what is on top of a
    tower is on no heap.

    Left alone where the goal itself says of a block of theirs where it should be.
    """
    if not scene.start_goals:
        return goal
    found = _with_a_crown(goal, scene.start_goals)
    there = {frozenset(names(start)) for start in found}
    later = [*_landmarks(goal, scene), *_moved(goal, scene)]
    found += [start for start in later if frozenset(names(start)) not in there]
    return conj([*found, goal]) if found else goal


def _with_a_crown(goal: g.Goal, starts: Iterable[g.Goal]) -> list[g.Goal]:
    """The towers whose highest or lowest block the goal relates something to."""
    related = [set(_operands(atom)) for atom in atoms(goal)]
    spoken = {name for atom, towers in zip(atoms(goal), related, strict=True) for name in names(atom) if not towers}
    found: list[g.Goal] = []
    for start in starts:
        if isinstance(start, s.Stack) and spoken.isdisjoint(start.blocks):
            ends = [end for towers in related for end in towers if set(members(end)) == set(start.blocks)]
            if ends:
                found.append(_covered(start, any(isinstance(end, Highest) for end in ends)))
    return found


def _landmarks(goal: g.Goal, scene: Scene) -> Iterator[g.Goal]:
    """What makes up the structures of the start that are spoken of as such, and beside or on which something goes."""
    wholes = [start for start in scene.start_goals if isinstance(start, s.Stack | s.Row | r.On | s.Grid | s.Spells)]
    said = [m for m in scene.mentions if m.role == "landmark" and not m.start and m.rel in RELATIONS]
    marks = [(m.rel, built) for m in said for built in m.ref.built]
    tops = [("on", built) for built in scene.topped]
    for start in wholes:
        blocks = set(names(start))
        named = marks if isinstance(start, r.On) else [*marks, *tops]  # "red is on green; put blue on top": of red
        there = {rel for rel, built in named if blocks <= {*built.members}}
        placed = _placed(goal, feet="under" in there)
        if there and blocks.isdisjoint(placed):
            yield _covered(start, True) if isinstance(start, s.Stack) else start
        elif (
            isinstance(start, s.Stack)
            and (rest := _below(start, placed)) is not None
            and (there or any({*m.ref.names} == {*rest.blocks} and m.word.startswith(_REST) for m in said))
        ):
            yield rest


def _below(tower: s.Stack, placed: set[str]) -> s.Stack | None:
    """ "Put the top block next to the tower": what is left of it, where all that is taken is taken from its top."""
    ranks = tower.order.ranks if tower.order.by == "given" else ()
    upward = ranks[::-1] if tower.order.first == "top" else ranks
    left = [rank for rank in upward if placed.isdisjoint(rank)]
    if len(left) < 2 or upward[: len(left)] != tuple(left) or any(len(rank) > 1 for rank in upward):
        return None
    order = tower.order.model_copy(update={"ranks": tuple(left), "first": "bottom"})
    return tower.model_copy(update={"blocks": tuple(rank[0] for rank in left), "order": order, "exact": False})


def _moved(goal: g.Goal, scene: Scene) -> Iterator[g.Goal]:
    """ "Move the tower to the left": it is still a tower there, where nothing but its place is said of its blocks."""
    told = [m.ref for m in scene.mentions if m.role == "theme" and m.ref.built and not m.start]
    themes = [ref for ref in told if not ref.plural]  # "the tower", not "the blocks"
    for start in (x for x in scene.start_goals if isinstance(x, s.Stack | s.Row | s.Grid | s.Figure | s.Spells)):
        blocks = set(names(start))
        about = [atom for atom in atoms(goal) if blocks & set(names(atom))]
        whole = all(isinstance(atom, _OF_A_WHOLE) and blocks <= set(names(atom)) for atom in about)
        if about and whole and any(blocks == {*built.members} for ref in themes for built in ref.built):
            yield _covered(start, True) if isinstance(start, s.Stack) else start


_REST = ("the rest", "the other", "the remaining")
"""How what is left of a tower is spoken of."""
_OF_A_WHOLE = r.InRegion | r.Shifted | r.Ranged
"""What may be said of a structure and leaves it as it is."""
RELATIONS = frozenset(
    {"on", "above", "under", "left", "right", "front", "behind", "beside", "adjacent", "near", "touching", "apart",
     "distance"}
)  # fmt: skip
"""Relations to a structure that leave it as it is; what goes between its blocks may part them."""


def _covered(tower: s.Stack, covered: bool) -> s.Stack:
    return tower.model_copy(update={"exact": tower.exact and not covered})


def _placed(goal: g.Goal, *, feet: bool) -> set[str]:
    """The blocks of which a goal says where they are: not the landmarks. `feet`: nor what goes on a block that is put
    under it."""
    found: set[str] = set()
    for atom in atoms(goal):
        if not isinstance(getattr(atom, "b", None), tuple):
            found |= set(names(atom))
        elif not (feet and isinstance(atom, r.On | r.Above)):
            found |= set(members(getattr(atom, "a", ())))
    return found


def none_left_out_on_top(goal: g.Goal, left_out: set[str]) -> g.Goal:
    """ "Stack A, B and C without using D": nor is D on top of them."""
    if not left_out or isinstance(goal, g.Not):
        return goal
    if isinstance(goal, s.Stack):
        return goal if goal.exact or goal.raised else goal.model_copy(update={"exact": True})
    inner = children(goal)
    return rebuild(goal, tuple(none_left_out_on_top(x, left_out) for x in inner)) if inner else goal


def _operands(atom: g.Atom) -> Iterator[Lowest | Highest]:
    """The towers that an atom relates something to."""
    for field in ("a", "b", "c"):
        value = getattr(atom, field, None)
        if isinstance(value, Lowest | Highest):
            yield value
