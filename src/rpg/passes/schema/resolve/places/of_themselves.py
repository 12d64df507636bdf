""" "Red on the left, green on the right": sides of the two, unless they may be the sides of something else."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.walk import atoms
from rpg.language.meaning import At, Meaning
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse, said

Loose = tuple[Ref, Meaning, Span]
Ranks = tuple[tuple[str, ...], ...]


def of_themselves(loose: list[Loose], goal: g.Goal, starts: list[g.Goal]) -> None:
    """Refuse "red to the left, green to the right, and blue behind the patch": they may be beside the patch, too; and
    so they may be beside a row, or at its ends, also one that is there at the start."""
    own = {name for ref, _, _ in loose for name in ref.names}
    sides = {at_.side for _, at_, _ in loose if isinstance(at_, At)}
    if sides & {"left", "right"} and sides & {"front", "back"}:
        raise refuse("ambiguous", "it is not clear of what these are the sides", loose[0][2], "say of what")
    if any(isinstance(a, r.OnPatch) and own & {*members(a.a)} and own - {*members(a.a)} for a in atoms(goal)):
        raise refuse("ambiguous", "on the same patch, or of the table?", loose[-1][2], "say of what")
    lots = [lot for a in atoms(goal) if isinstance(a, s.GroupBy) for lot in a.groups or ()]
    lots += [members(a.a) for a in atoms(goal) if isinstance(a, r.OnPatch | r.OnTable)]
    if len(sides) > 1 and "middle" not in sides and any(own < {*lot} for lot in lots):
        raise refuse("ambiguous", "of each other, or of another block that is with them?", loose[0][2], "say of what")
    placed = r.LeftOf | r.RightOf | r.InFrontOf | r.Behind | r.OnPatch
    for beside in (a for a in atoms(goal) if isinstance(a, placed)):
        if not own & {*members(beside.a), *(() if isinstance(beside, r.OnPatch) else members(beside.b))}:
            raise refuse("ambiguous", "this could be a side of the table or of what is spoken of beside it",
                         loose[0][2], "say of what")  # fmt: skip
    told = [a for one in (goal, *starts) for a in atoms(one)]
    line = next((a for a in told if isinstance(a, s.Row | s.Stack) and not own & {*a.blocks}), None)
    around = any(isinstance(a, r.Between) and own & {*members(a.b), *members(a.c)} for a in atoms(goal))
    if line is not None and not around and not any(ref.built for ref, _, _ in loose):
        what = "tower" if isinstance(line, s.Stack) else "line"
        raise refuse("ambiguous", f"these could be the sides of the {what}, or of each other", loose[0][2],
                     "say of what, such as 'to the left of the row'")  # fmt: skip


def check_between(loose: list[Loose], scene: Scene) -> None:
    """Refuse "there are red, green and blue: red at the bottom, blue on top": is green between them, or left out?"""
    own = {name for ref, _, _ in loose for name in ref.names}
    told = {name for m in scene.mentions if m.role != "given" for name in m.ref.names}
    left = next((t for t in scene.blocks() if t.declared and not t.extra and t.name not in own | told), None)
    if left is not None:
        raise refuse("ambiguous", f"it is not said whether {said(left)} is among these", loose[0][2],
                     "say where it goes, or that it is a distractor")  # fmt: skip


def with_the_one_between(ranks: Ranks, loose: list[Loose], goal: g.Goal, scene: Scene) -> Ranks:
    """ "Red is the highest, green is below it, blue is the lowest": what is told of an end stands between the two."""
    own = {name for rank in ranks for name in rank}
    tied = [a for a in atoms(goal) if isinstance(a, r.On | r.Above) and len(own & {*members(a.a), *members(a.b)}) == 1]
    others = tuple(dict.fromkeys(n for a in tied for n in (*members(a.a), *members(a.b)) if n not in own))
    if not others:
        return ranks
    inside = all(members(a.a) == ranks[-1] or members(a.b) == ranks[0] for a in tied)
    if len(others) > 1 or len(ranks) != len(("bottom", "top")) or not inside:
        other = said(scene.things[others[0]])
        raise refuse("ambiguous", f"it is not clear whether {other} is among these", loose[0][2],
                     "name the blocks from bottom to top")  # fmt: skip
    return (ranks[0], others, ranks[-1])


def deep(loose: list[Loose]) -> bool:
    """Whether the sides are those in front and behind."""
    return any(isinstance(at_, At) and at_.side in ("front", "back") for _, at_, _ in loose)


def of_the_ends(
    ref: Ref, node: type[r.LeftOf | r.RightOf | r.InFrontOf | r.Behind], goal: g.Goal, span: Span
) -> g.Goal | None:
    """ "A between B and C, B on the left": of the two ends, it is left of the other."""
    parts = goal.goals if isinstance(goal, g.All) else ()
    related = (r.LeftOf, r.RightOf, r.InFrontOf, r.Behind, r.Between, s.Stack, s.Row)
    said = [a for a in atoms(goal) if isinstance(a, related)]
    if len(said) != 1 or not isinstance(said[0], r.Between) or said[0] not in (goal, *parts):
        return None
    ends = (*members(said[0].b), *members(said[0].c))
    if len(ref.names) != 1 or len(ends) != 2 or ref.names[0] not in ends:
        return None
    return node(a=ref.names, b=(ends[1 - ends.index(ref.names[0])],), span=span)
