"""Of what "the middle" is that is told without it."""

from __future__ import annotations

from rpg.ir.walk import names as names_in
from rpg.language.meaning import At
from rpg.passes.schema.resolve.orders.positions import SIDES
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def of_a_line(ref: Ref, at_: At, scene: Scene) -> None:
    """Refuse "there is a row of red, green and blue. Put the red block in the middle": of the row, or of the table?"""
    for b in scene.built if at_.side == "middle" and not ref.built else ():
        begun = any(set(b.members) == set(names_in(start)) for start in scene.start_goals)
        further = not set(ref.names) & set(b.members) and not ref.patch  # which may go into the tower
        inside = set(ref.names) < set(b.members)
        if b.kind in SIDES and ((begun and (inside or b.kind != "stack")) or (further and b.kind == "stack")):
            raise refuse("ambiguous", f"this could be the middle of the {b.kind} or of the table", at_.span,
                         "say 'of the table', or name the blocks in the order that they should have")  # fmt: skip


def beside_another(ats: list[At], scene: Scene) -> bool:
    """ "Put red on blue with green in the middle": between the two, or in the middle of the table?"""
    marks = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark"]
    return any(at_.side == "middle" for at_ in ats) and any(not (m.ref.patch or m.ref.table) for m in marks)
