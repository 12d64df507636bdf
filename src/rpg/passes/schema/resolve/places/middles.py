"""Of what "the middle" or "the front" is that is told without it, and what stands beside it."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.walk import atoms
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Absolute, At, Loc, Manner, Pronoun
from rpg.passes.schema.resolve.orders.positions import SIDES
from rpg.passes.schema.resolve.places.pointed import BESIDE
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse, which_one


def of_a_line(ref: Ref, at_: At, scene: Scene) -> None:
    """Refuse "there is a row of red, green and blue. Put the red block in the middle": of the row, or of the table?"""
    for b in scene.built if at_.side == "middle" and not ref.built else ():
        begun = any(set(b.members) == set(names_in(start)) for start in scene.start_goals)
        further = not set(ref.names) & set(b.members) and not ref.patch  # which may go into the tower
        inside = set(ref.names) < set(b.members)
        if b.kind in SIDES and ((begun and (inside or b.kind != "stack")) or (further and b.kind == "stack")):
            raise refuse("ambiguous", f"this could be the middle of the {b.kind} or of the table", at_.span,
                         "say 'of the table', or name the blocks in the order that they should have")  # fmt: skip


def of_a_word(ref: Ref, at_: At, scene: Scene) -> None:
    """Refuse "the letters spell EAT. Move the T to the front": of the word, or of the table?"""
    begun = [a for fact in scene.start_goals for a in atoms(fact) if isinstance(a, s.Spells)]
    if any({*ref.names} < {*word.blocks} for word in begun):
        raise which_one("this could be a side of the table or an end of the word", at_.span,
                        "say 'of the table', or spell the other word")  # fmt: skip


def related_to(ref: Ref, goal: g.Goal, scene: Scene) -> bool:
    """Whether it is told on which side of another some block is, or that this one is close to another."""
    told = [*atoms(goal), *(a for fact in scene.start_goals for a in atoms(fact))]
    close = r.Between | r.Beside | r.Adjacent | r.Touching
    sides = r.LeftOf | r.RightOf | r.InFrontOf | r.Behind
    return any(isinstance(a, sides) or (isinstance(a, close) and {*ref.names} & {*names_in(a)}) for a in told)


def beside_another(ats: list[At], scene: Scene) -> bool:
    """ "Put red on blue with green in the middle": between the two, or in the middle of the table?"""
    marks = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark"]
    return any(at_.side == "middle" for at_ in ats) and any(not (m.ref.patch or m.ref.table) for m in marks)


def set_apart(whole: Ref, told: Absolute) -> bool:
    """ "Two towers of two with a green block between them", "a row of three with a tower behind it": what stands beside
    a structure is none of its blocks."""
    spots = [a for a in told.adjuncts if not isinstance(a, Manner)]
    between = len(whole.built) > 1
    return bool(whole.built and spots) and all(
        isinstance(a, Loc) and isinstance(a.landmark, Pronoun) and (a.rel in BESIDE or (a.rel == "between" and between))
        for a in spots
    )
