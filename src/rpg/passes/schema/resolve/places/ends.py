"""The two ends of "between": two blocks, two towers, a tower and a block, the two blocks in the middle of a tower."""

from __future__ import annotations

from rpg.ir import structures as s
from rpg.ir.walk import names
from rpg.language.meaning import Loc
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse


def two_ends(mark: Ref, loc: Loc, scene: Scene) -> tuple[Ref, ...]:
    """What something is between."""
    ends = mark.parts if len(mark.parts) == 2 else tuple(Ref(names=(n,)) for n in mark.names)
    if len(mark.built) == 2 and len(mark.parts) != 2:
        ends = tuple(Ref(names=b.members, built=(b,)) for b in mark.built)
    elif len(mark.built) == 1 and mark.built[0].kind == "towers":
        ends = _two_towers(mark, scene)
    elif len(mark.built) == 1 and mark.names == mark.built[0].members and _is_begun(mark.built[0], scene):
        ends = _middle_two(mark.built[0], loc)
    if mark.op == "or" or len(ends) != 2:
        raise refuse(
            "between-two",
            "'between' wants two ends",
            loc.span,
            "say 'between the red block and the blue block'",
            ends=len(ends),
        )
    return ends


def _is_begun(tower: Built, scene: Scene) -> bool:
    """Whether this is a tower that stands there at the start."""
    return tower.kind == "stack" and any({*tower.members} == {*names(start)} for start in scene.start_goals)


def _middle_two(tower: Built, loc: Loc) -> tuple[Ref, ...]:
    """ "(There is a tower of A, B, C and D from bottom to top.) Put a block in the middle of it": between B and C."""
    half = len(tower.members) // 2
    if len(tower.members) % 2 or not tower.ordered:
        raise refuse("ambiguous", "it is not clear between which two blocks of the tower this is", loc.span,
                     "name the two blocks, as in 'between A and B'")  # fmt: skip
    return tuple(Ref(names=(one,)) for one in tower.members[half - 1 : half + 1])


def _two_towers(mark: Ref, scene: Scene) -> tuple[Ref, ...]:
    """Two towers of look-alike blocks, told apart by fixing which block is in which."""
    blocks = mark.names
    looks = {(scene.things[n].color, scene.things[n].label) for n in blocks}
    if len(looks) > 1 or len(blocks) % 2 or None in {c for c, _ in looks}:
        return (mark,)
    half = len(blocks) // 2
    ends = []
    for part in (blocks[:half], blocks[half:]):
        built = scene.add_built("stack", part, False, mark.span)
        scene.goals.setdefault(scene.clause, []).append(s.Stack(blocks=part, exact=True, span=mark.span))
        ends.append(Ref(names=part, built=(built,)))
    return tuple(ends)
