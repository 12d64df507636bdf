"""How far a block moves: "by at least 10 cm", "somewhere else"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeGuard

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Operand
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Clause, Loc, Pronoun
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.places.shifted import RELS, shifted, told_shift
from rpg.passes.schema.resolve.things.operands import crown, spread
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Goals = list[g.Goal]


MOVES = RELS | {"moved"}
"""What places say of where something is moved, seen from where it is."""


def is_moved(clause: Clause, moves: list[Loc]) -> bool:
    """Whether a clause says that something is to be moved so far, or to be "somewhere else"."""
    if any(p.rel in RELS for p in moves):
        return True
    if clause.verb == "be" and clause.mode == "goal" and any("else" in p.mods for p in moves):
        if any("aside" in p.mods for p in moves):
            raise refuse("ambiguous", "beside the others, or away from where it is now?", clause.span,
                         "say next to what it is, or 'move it to the side'")  # fmt: skip
        if clause.negated or clause.lemma == "fact":
            hint = "say 'move ... somewhere else'"
            raise refuse("misplaced", "it is not clear where else this is", clause.span, hint)
        return True
    away = [p for p in moves if p.low is not None and not (p.mods or p.negated)]  # "ends up 15 cm from where it was"
    ends = clause.verb == "be" and clause.mode == "goal" and clause.lemma != "fact" and not clause.negated
    return (clause.verb == "place" and bool(moves)) or (ends and bool(away))


def moved(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "move the red block by at least 10 cm"; "somewhere else" is also off what it starts on."""
    if (told := told_shift(spec)) is not None:
        return shifted(clause, told, spec, scene, scope)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    far = next(p for p in spec.places if isinstance(p, Loc) and p.rel == "moved")
    spec.places.remove(far)
    if far.low is None:
        raise refuse("misplaced", "a move is at least so far", far.span, "say 'by at least 10 cm'")
    begun = scene.start_goals if "else" in far.mods else []
    there = [x for x in begun if _lies_there(x) and set(x.a) <= {*theme.names}]
    left = [g.Not(goal=x.model_copy(update={"a": (name,)}), span=clause.span) for x in there for name in x.a]
    denied = "else" in far.mods and clause.verb == "be" and any(m.role == "landmark" for m in scene.mentions)
    if denied and not left:
        raise refuse("ambiguous", "not there, or away from where it is now?", far.span, "say where it should not be")
    return [r.Moved(a=theme.names, at_least=far.low, span=clause.span), *left]


def _lies_there(fact: g.Goal) -> TypeGuard[r.On | r.OnPatch]:
    """A fact of the start of what something lies on."""
    return isinstance(fact, r.On | r.OnPatch)


def off_what(theme: Ref, loc: Loc, scene: Scene) -> Ref | None:
    """ "Take it off": off all that it lies on, where that is known."""
    word = loc.landmark.word if isinstance(loc.landmark, Pronoun) else ""
    if loc.rel != "off" or theme.patch or word not in (("there",) if len(theme.names) == 1 else ("there", "them")):
        return None
    if len(theme.names) > 1 and (several := _off_their_own(theme, loc, scene)) is not None:
        return several
    if word != "there":
        return None
    under: list[str] = []
    below = scene.on_top.get(theme.names[0]) if len(theme.names) == 1 else None
    while below is not None and below not in under:
        under.append(below)
        below = scene.on_top.get(below)
    if not under and len(theme.names) == 1:
        towers = [x.blocks for x in scene.start_goals if isinstance(x, s.Stack) and theme.names[0] in x.blocks]
        tower = towers[0] if len(towers) == 1 and alike([scene.things[n] for n in towers[0]]) else ()
        under = [name for name in tower if name != theme.names[0]]
    if under:
        _out_of_the_middle(theme.names[0], under, scene)
        return Ref(names=tuple(under), plural=len(under) > 1, span=loc.span)
    return _off_its_patch(theme, loc, scene)


def _out_of_the_middle(name: str, under: list[str], scene: Scene) -> None:
    """ "(Green is on blue and blue is on red.) Take blue away": what lay on it and below it stays a tower."""
    over: list[str] = []
    while above := [n for n, below in scene.on_top.items() if below == ([name, *over][-1]) and n not in over]:
        over += above[:1]
    begun = {n for fact in scene.start_goals for n in names_in(fact)}
    if over and {name, *over, *under} <= begun and name not in scene.taken:
        scene.taken[name] = (*reversed(under), *over)


def _off_their_own(theme: Ref, loc: Loc, scene: Scene) -> Ref | None:
    """ "A is on B and C is on D. Take A and C off": off what each of them lies on."""
    bases = dict.fromkeys(scene.on_top.get(name) for name in theme.names)
    below = tuple(name for name in bases if name is not None and name not in theme.names)
    if not below or len(bases) < 2:
        return None
    if None in bases:
        raise refuse(
            "ambiguous", "it is not said of all of them what they are on", loc.span, "say off what they are taken"
        )
    return Ref(names=below, plural=True, span=loc.span)


def _off_its_patch(theme: Ref, loc: Loc, scene: Scene) -> Ref | None:
    """The patch that it begins on, where it was put on no other since and more than one was spoken of."""
    starts = [goal for goal in scene.start_goals if isinstance(goal, r.OnPatch)]
    on = {name: goal.patch for goal in starts for name in names_in(goal) if isinstance(goal.patch, str)}
    begun = {on.get(name) for name in theme.names}
    patch = next(iter(begun)) if len(begun) == 1 else None
    clauses = {m.clause for m in scene.mentions if m.role == "theme" and {*theme.names} & {*m.ref.names}}
    lain = [m.ref.names for m in scene.mentions if m.ref.patch and m.clause in clauses]
    if patch is None or not lain or lain[-1] != (patch,):
        return None
    return Ref(names=(patch,), patch=True, span=loc.span)


def put_there(upper: str, below: str, scene: Scene) -> bool:
    """ "Put it on the mat, then take it off again": it lies there by then, not at the start. Or it is stacked."""
    earlier = [m for m in scene.mentions if m.clause < scene.clause]
    on_it = {m.clause for m in earlier if m.role == "landmark" and m.rel in ("on", "in") and below in m.ref.names}
    both = {upper, below}
    begun = any(isinstance(x, s.Stack | r.On) and both <= {*names_in(x)} for x in scene.start_goals)
    stacked = any(b.kind == "stack" and both <= {*b.members} and b.ordered for b in scene.built)
    if stacked and not begun:
        return True
    return any(m.clause in on_it and m.role == "theme" and upper in m.ref.names for m in earlier)


def begins_on(theme: Ref, mark: Ref, scene: Scene, span: Span) -> None:
    """ "get the red block off the blue one", or off the tower of two white ones: it starts there; and so does what is
    excepted from all that is taken off a patch."""
    if len(theme.names) == 1 and len(mark.built) == 1 and mark.built[0].kind == "stack":
        new = theme.names[0] not in mark.names and not any(put_there(theme.names[0], b, scene) for b in mark.names)
        scene.start_goals += [r.On(a=theme.names, b=crown(mark), span=span)] if new else []
    left = theme.parts[-1].names if theme.op == "except" and mark.patch else ()
    for a, b in ((a, b) for a in (*theme.names, *left) for b in mark.names):
        there: g.Goal = r.OnPatch(a=(a,), patch=b, span=span) if mark.patch else r.On(a=(a,), b=(b,), span=span)
        if len(mark.names) == 1 and there not in scene.start_goals and not put_there(a, b, scene):
            scene.start_goals.append(there)


def note_taken(theme: Ref, mark: Ref, scene: Scene) -> None:
    """ "Take two blocks off the tower of four red ones": of blocks that look alike the others stay a tower."""
    tower = len(mark.built) == 1 and mark.built[0].kind == "stack" and {*theme.names} < {*mark.names}
    if tower and theme.quant is None and alike([scene.things[name] for name in mark.names]):
        scene.taken[theme.names[0]] = tuple(name for name in mark.names if name not in theme.names)


def taken_off(theme: Ref, below: str, span: Span) -> g.Goal:
    """Nothing of it is above this block any more."""
    return spread(theme, lambda a: g.Not(goal=r.Above(a=a, b=(below,), span=span), span=span), span)


def off_patches(a: Operand, patches: Sequence[str], span: Span) -> g.Goal:
    """None of the blocks of a row lies on any of them; a tower is where its lowest block is."""
    each: list[Operand] = [(name,) for name in a] if isinstance(a, tuple) else [a]
    return conj([g.Not(goal=r.OnPatch(a=n, patch=p, span=span), span=span) for p in patches for n in each], span)
