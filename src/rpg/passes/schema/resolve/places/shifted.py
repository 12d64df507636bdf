"""How far which way from the start: "10 cm to the left", "a bit closer to the robot", "5 cm farther apart"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import Direction
from rpg.ir.walk import names
from rpg.language.grammar.clauses.shifts import HERE
from rpg.language.meaning import Clause, Loc, Pronoun
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.operands import spread
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Goals = list[g.Goal]

RELS = frozenset({"shifted", "approached", "receded"})
WAYS: dict[str, Direction] = {"left": "left", "right": "right", "front": "front", "back": "back"}
PLAIN = {"shifted": 0.05, "approached": 0.02, "receded": 0.02}
"""How far at least, where it is not said (m)."""
ACROSS = 0.02
"""How far off the axis at most, where it is said how far along it (m)."""
FEWEST = 2
LEAST = 0.01
"""The shortest way that something is moved (m), where it is said just how far."""
EXACT = 0.01
"""What a plain length is good for, either way (m)."""


def told_shift(spec: Spec) -> Loc | None:
    """What a clause says of how far which way something is moved."""
    return next((p for p in spec.places if isinstance(p, Loc) and p.rel in RELS), None)


def shifted(clause: Clause, told: Loc, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """Where something is at the end, seen from where the episode finds it."""
    if clause.negated:
        raise refuse("ambiguous", "not moved at all, or not so far?", told.span, "say 'leave it where it is'")
    if scope.start:
        raise refuse("misplaced", "nothing has moved yet at the start", told.span, "say where it is at the start")
    spec.places.remove(told)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    _from_here(clause, told, theme, spec, scene)
    if theme.patch:
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", clause.span,
                     "move blocks instead")  # fmt: skip
    if theme.op == "only":
        raise refuse("ambiguous", "it is not said what becomes of the others", clause.span, "say where they should be")
    _there(theme, told, scene)
    low, high = _range(told, scene)
    if told.rel == "shifted":
        return [_gone(told, theme, low, high, scene)]
    if isinstance(told.landmark, Pronoun) and told.landmark.word == "each other":
        return [_mutual(told, theme, low, high)]
    assert told.landmark is not None
    mark = refer(told.landmark, scene, scope)
    if {*mark.names} & {*theme.names}:
        raise refuse("self-reference", "nothing is placed relative to itself", told.span, "name another block")
    node = r.Approached if told.rel == "approached" else r.Receded
    return [
        spread(theme, lambda a: node(a=a, b=mark.names, at_least=low, at_most=high, span=told.span), told.span,
               together=True)
    ]  # fmt: skip


def _from_here(clause: Clause, told: Loc, theme: Ref, spec: Spec, scene: Scene) -> None:
    """Refuse "it must be 10 cm to the left" where nothing says that this is seen from where it starts."""
    if HERE in told.mods or clause.lemma in _MOVING:
        return
    if told.rel != "shifted" and clause.verb == "be":
        raise refuse("ambiguous", "than what, or than at the start?", told.span, "say 'move ...', or 'than ...'")
    if told.rel != "shifted" and spec.places:
        raise refuse("ambiguous", "than the other one, or than at the start?", told.span, "say 'than ...'")
    if told.rel == "shifted" and told.low is None and clause.lemma == "put":
        raise refuse("ambiguous", "it is not said how far", told.span, "say 'move ...', or how far")
    if clause.verb == "be" or (told.rel == "shifted" and any(x.name not in theme.names for x in scene.blocks())):
        raise refuse("ambiguous", "of what, or from where it starts?", told.span, "say 'move ...', or of what")


_MOVING = frozenset({"move", "push", "shift", "slide", "nudge", "drag", "pull", "bring", "shove"})


def _there(theme: Ref, told: Loc, scene: Scene) -> None:
    """Refuse to move a structure on from where it is that is not there yet."""
    begun = [{*names(fact)} for fact in scene.start_goals]
    for built in theme.built:
        if not any({*built.members} <= blocks for blocks in begun):
            raise refuse("ambiguous", "it is not said that this is there at the start", told.span,
                         "say 'There is a row of three blocks. Move the row ...'")  # fmt: skip


def _gone(told: Loc, theme: Ref, low: float, high: float | None, scene: Scene) -> g.Goal:
    way, across = WAYS[told.mods[0]], None
    for word in (word for word in told.mods[2:] if word != HERE):
        where = "away from" if way == "back" else "towards"
        scene.assume(f"{word}: {where} the robot")
    if high is not None:
        across = round(max(ACROSS, (high - low) / 2), 6)
    return spread(
        theme,
        lambda a: r.Shifted(a=a, toward=way, at_least=low, at_most=high, across=across, span=told.span),
        told.span,
        together=True,
    )


def _mutual(told: Loc, theme: Ref, low: float, high: float | None) -> g.Goal:
    if len(theme.names) < FEWEST:
        raise refuse("no-referent", "one block alone has no other to relate to", told.span, "name at least two blocks")
    if theme.quant is not None or theme.built:
        raise refuse("ambiguous", "it is not clear which blocks this is said of", told.span, "name the blocks")
    node = r.Approached if told.rel == "approached" else r.Receded
    return node(a=theme.names, b=theme.names, at_least=low, at_most=high, span=told.span)


def _measured(told: Loc, low: float, high: float) -> tuple[float, float]:
    """A range that leaves out where it starts: one centimetre is not taken as "up to two"."""
    if low >= LEAST / 2:
        return low, high
    if (middle := high - EXACT) < LEAST - 1e-6:
        raise refuse("misplaced", "blocks are not placed as exactly as this", told.span, "say at least 1 cm")
    return round(middle / 2, 6), round(1.5 * middle, 6)


def _range(told: Loc, scene: Scene) -> tuple[float, float | None]:
    """How far at least and at most; noted where that is left open."""
    how = told.mods[-1] if told.rel != "shifted" else told.mods[1]
    if told.low is None and told.high is not None:
        raise refuse("misplaced", "a move is at least so far", told.span, "say 'at least', 'about' or just how far")
    if told.high is not None and told.low is not None:
        return _measured(told, told.low, told.high)
    low = PLAIN[told.rel] if told.low is None else told.low
    if told.low is None or how:
        what = how or {"shifted": "moved", "approached": "closer", "receded": "farther"}[told.rel]
        scene.assume(f"{what}: by at least {low * 100:g} cm, seen from where it starts")
    return low, None
