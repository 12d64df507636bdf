""" "Red is leftmost", "A must be nearest to me": beyond all other blocks that there are, where nothing is built."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.language.meaning import At, Meaning
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.things.operands import foot
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

BEYOND: dict[str, type[r.LeftOf | r.RightOf | r.InFrontOf | r.Behind]] = {
    "left": r.LeftOf, "right": r.RightOf, "front": r.InFrontOf, "back": r.Behind,
}  # fmt: skip


def beyond_others(loose: Sequence[tuple[Ref, Meaning, Span]], scene: Scene) -> g.Goal | None:
    """Each at its side of all others; None where one is not told so, or where there are no others."""
    own = {name for ref, _, _ in loose for name in ref.names}
    others = [t.name for t in scene.blocks() if not t.extra and t.name not in scene.ignored and t.name not in own]
    goals: list[g.Goal] = []
    before: list[str] = []
    for ref, at_, span in loose:
        if not isinstance(at_, At) or not at_.utmost or at_.side not in BEYOND or ref.quant is not None:
            return None
        goals.append(BEYOND[at_.side](a=foot(ref), b=(*before, *others), somewhere=True, span=span))
        before += ref.names
    if not others and len(own) == 1 and not scene.built:
        half = {"front": "near", "back": "far"}.get(getattr(loose[0][1], "side", ""), getattr(loose[0][1], "side", ""))
        raise refuse("no-referent", "there is no other block that it could be beyond", loose[0][2],
                     f"say first which other blocks there are, or say 'in the {half} half'")  # fmt: skip
    return conj(goals) if others else None


def not_beyond_others(item: tuple[Ref, Meaning, Span], scene: Scene) -> g.Goal | None:
    """ "Red must not be the leftmost": not at that side of one of the others at least."""
    if not isinstance(beyond := beyond_others([item], scene), r.LeftOf | r.RightOf | r.InFrontOf | r.Behind):
        return None
    each = [beyond.model_copy(update={"b": (name,)}) for name in members(beyond.b)]
    return disj([g.Not(goal=one, span=item[2]) for one in each], item[2])
