"""Several towers that stand in a row: a row of their lowest blocks."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.meaning import Into, Structure, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Built, Scene, refuse


def lined_up(shape: Structure, spec: Spec) -> Structure:
    """ "four towers of two, arranged in a row": what is said of the row is said of the towers in it."""
    said = [*spec.intos, *(a for a in shape.details if isinstance(a, Into))]
    into = said[0] if len(said) == 1 else None
    line = into.structure if into is not None else None
    if shape.kind != "stack" or not shape.plural:
        return shape
    if not isinstance(line, Structure) or line.kind not in ("row", "line") or line.plural or line.det not in _NEW:
        return shape
    if line.members or line.traits != Traits() or (shape.sizes and line.sizes):
        return shape
    if heights := next((z for z in shape.sizes if z.what == "heights"), None):
        raise refuse("ambiguous", "it is not said which of the towers in the row has which height", heights.span,
                     "say of which blocks each tower is, one by one")  # fmt: skip
    spec.intos = []
    spec.lined = True
    own = tuple(a for a in shape.details if not isinstance(a, Into))
    return replace(shape, sizes=shape.sizes or line.sizes, details=(*own, *line.details))


_NEW = ("a", "bare")


def line_of(built: list[Built], scene: Scene, span: Span) -> g.Goal:
    """The lowest blocks of the towers, where it is known which these are, or all blocks of a tower look alike."""
    feet: list[str] = []
    for tower in built:
        looks = {(t.color, t.label, t.kind, t.size, t.edge) for t in (scene.things[n] for n in tower.members)}
        if tower.kind != "stack" or not (tower.ordered or len(looks) == 1):
            raise refuse("ambiguous", "it is not said which blocks of the towers are the lowest ones", span,
                         "say of which blocks each tower is, from the bottom up")  # fmt: skip
        feet.append(tower.members[0])
    return s.Row(blocks=tuple(feet), axis="y", span=span)
