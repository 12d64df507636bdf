"""Towers that were built together and look alike, told apart by what is said of single ones: "each of them", "the left
tower". Which blocks are in which of them does not matter then, and neither does which of them stands where."""

from __future__ import annotations

from itertools import pairwise

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Lowest
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Clause, Meaning, Noun, Pronoun, Structure, Traits
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse

_PLURAL = ("each", "both", "all")
_SIDES = {"left": "y", "right": "y", "front": "x", "back": "x", "middle": ""}
_ENDS = {"y": ("left", "right"), "x": ("front", "back")}


def tell_apart(shape: Structure, scene: Scene) -> None:
    """Take the towers that were built together one by one, where single ones of them are spoken of."""
    known = shape.det in _PLURAL or (shape.det in ("the", "its") and bool(shape.traits.rank or shape.plural))
    if shape.kind != "stack" or not known or shape.members is not None:
        return
    for built in [b for b in scene.built if b.kind == "towers" and b.members in scene.heights]:
        if not _look_alike(built.members, scene, made_so=shape.det not in _PLURAL):
            continue
        if _of_the_start(built.members, scene):
            continue
        heights = scene.heights[built.members]
        begins = [sum(heights[:n]) for n in range(len(heights) + 1)]
        key = max(b.key for b in scene.built) + 1
        lots = [built.members[a:b] for a, b in pairwise(begins)]
        at = scene.built.index(built)
        scene.built[at : at + 1] = [Built("stack", lot, False, built.span, key + n) for n, lot in enumerate(lots)]
        scene.lots[built.members] = tuple(lots)


def one_of_them(said: Meaning, scene: Scene) -> Ref | None:
    """ "Two towers of two red blocks. Each of them ...", "the left one": of such towers, where nothing else was built
    and no other blocks were told together since."""
    rank = (said.traits.rank or "").removeprefix("@") if isinstance(said, Noun) else None
    if isinstance(said, Noun):
        one = said.det == "the" and said.traits == Traits(rank=said.traits.rank) and rank in _SIDES
        both = said.det in _PLURAL and said.traits == Traits() and said.part_of is None
        known, det = said.head == "any" and (one or both), said.det
    else:
        word = said.word if isinstance(said, Pronoun) else ""
        known, det = word in _ALL_OF_THEM, _ALL_OF_THEM.get(word, "the")
    told = [b for b in scene.built if b.members in scene.heights or b in _told(scene)]
    if not known or not told or len(told) < len(scene.built) or _others_told(told, scene):
        return None
    tell_apart(Structure(kind="stack", det="the", plural=True, span=said.span), scene)
    found = _told(scene)
    if rank and det == "the":
        found = on_their_sides(rank, found, scene)
    if not found or (det == "both" and len(found) > len(_ENDS)):
        return None
    names = tuple(n for built in found for n in built.members)
    return Ref(names=names, built=tuple(found), det=det, plural=len(found) > 1, each=det == "each", span=said.span)


def which_on_which(span: Span) -> Refusal:
    """What is to be said of "stack the two towers"."""
    return refuse("ambiguous", "which of the towers is to stand on which?", span,
                  "say what each is made of, as in 'put the red tower on the blue one'")  # fmt: skip


def stacked_alone(clause: Clause, built: list[Built]) -> Refusal | None:
    """What is wrong with "(A is on B and C on D.) Stack the two towers"; None of other clauses."""
    towers = len(built) > 1 and all(b.kind == "stack" for b in built)
    return which_on_which(clause.span) if clause.verb == "stack" and towers else None


_ALL_OF_THEM = {"each": "each", "each one": "each", "each of them": "each", "both": "both", "both of them": "both"}


def _told(scene: Scene) -> list[Built]:
    """The towers that were told apart."""
    lots = {lot for lots in scene.lots.values() for lot in lots}
    return [built for built in scene.built if built.members in lots]


def _others_told(towers: list[Built], scene: Scene) -> bool:
    """Whether other blocks were spoken of together before."""
    inside = {name for built in towers for name in built.members}
    before = (m.ref for m in scene.mentions if m.clause < scene.clause and not m.ref.patch and len(m.ref.names) > 1)
    return any(not inside >= {*ref.names} for ref in before)


def on_their_sides(rank: str, found: list[Built], scene: Scene) -> list[Built]:
    """ "The left tower" of two that look alike: one of them, which then stands there."""
    axis = _SIDES.get(rank)
    told = any(scene.sides.get(built.key) for built in found)
    if axis is None or told or not 1 < len(found) <= len(_ENDS) + 1 or (rank == "middle") > (len(found) > 2):
        return [built for built in found if scene.sides.get(built.key) == rank]
    names = tuple(n for built in found for n in built.members)
    like = {built.kind for built in found} == {"stack"} and len({len(built.members) for built in found}) == 1
    if not like or not _look_alike(names, scene, made_so=True) or _of_the_start(names, scene):
        return []
    axis = axis or "y"
    sides = [_ENDS[axis][0], *["middle"] * (len(found) - 2), _ENDS[axis][1]]
    scene.sides.update({built.key: side for built, side in zip(found, sides, strict=True)})
    node: type[r.LeftOf | r.InFrontOf] = r.LeftOf if axis == "y" else r.InFrontOf
    feet = [Lowest(lowest=built.members) for built in found]
    more = [node(a=a, b=b, span=found[0].span) for a, b in pairwise(feet)]
    scene.goals.setdefault(scene.clause, []).extend(more)
    return [built for built in found if scene.sides[built.key] == rank]


def one_by_one(goal: g.Goal, scene: Scene) -> g.Goal:
    """The goal with such towers one by one."""
    if isinstance(goal, s.Towers) and (lots := scene.lots.get(tuple(goal.blocks))) is not None:
        return g.All(goals=tuple(s.Stack(blocks=lot, exact=True, span=goal.span) for lot in lots), span=goal.span)
    parts = getattr(goal, "goals", None) if scene.lots else None
    if parts is not None:
        return goal.model_copy(update={"goals": tuple(one_by_one(part, scene) for part in parts)})
    return goal


def _look_alike(names: tuple[str, ...], scene: Scene, *, made_so: bool) -> bool:
    """Whether the blocks look all the same; those of which no look was said are `made_so`. "Every tower has a red block
    on top", one of its blocks or one more, is said of towers whose looks are told."""
    things = [scene.things[n] for n in names]
    looks = {(t.color, t.label, t.kind, t.size, t.edge) for t in things}
    told = bool(things[0].color or things[0].label)
    if len(looks) > 1 or (not told and not made_so):
        return False
    if not told and any(t.kind or t.scheme not in (None, "same") for t in things):
        return False
    for thing in things if not told else ():
        thing.scheme = "same"
    return True


def _of_the_start(names: tuple[str, ...], scene: Scene) -> bool:
    """Whether something is said of where such blocks begin, so that it may matter which of them it is said of."""
    begun = {name for fact in scene.start_goals for name in names_in(fact)}.union(*scene.heaps)
    return not begun.isdisjoint(names)
