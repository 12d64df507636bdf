"""The verb "turn", and how symbols are told to lie."""

from __future__ import annotations

from functools import partial

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Clause, Manner
from rpg.passes.schema.resolve.clauses import turning
from rpg.passes.schema.resolve.clauses.orientation import oriented, others_not_turned, turn_of
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.clauses.spun import spun
from rpg.passes.schema.resolve.clauses.turned_as_well import TURNS
from rpg.passes.schema.resolve.clauses.whose_turn import is_none, neither, turned_of, unturned
from rpg.passes.schema.resolve.goals.logic import negation
from rpg.passes.schema.resolve.places.relations import place
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Goals = list[g.Goal]


def keep(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "leave K and M upright" turns them; "keep red on blue" keeps it there."""
    kinds = {m.kind for m in spec.manners}
    if kinds & TURNS and not kinds & {"stay", "always"}:
        return turn(clause, spec, scene, scope)
    return turning.keep(clause, spec, scene, scope)


def turn(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "turn the A upside down", "rotate the red block by 90 degrees", "face the letter A left"."""
    told = neither(clause.theme) if clause.negated else clause.theme
    theme = refer(told, scene, scope) if told else Ref()
    if theme.patch or theme.table:
        raise refuse("fixed-patch", "patches and the table cannot be turned", theme.span, "name a block")
    if len(theme.names) > 1 and theme.built:
        raise refuse("misplaced", "a structure is not turned as a whole", theme.span, "say which blocks to turn")
    goals: Goals = []
    used: list[Manner] = []
    degrees = next((m for m in spec.manners if m.kind in ("by", "by?")), None)
    facing = next((m for m in spec.manners if m.kind == "facing"), None)
    flat = next((m for m in spec.manners if m.kind == "turn"), None)
    if (pointed := _pointed(theme, facing, spec)) is not None:
        return _upward(theme, pointed, flat, spec, scene, clause.span)
    if degrees is not None:
        by = partial(_by_degrees, degrees=degrees, clause=clause, lies=flat is not None, scene=scene)
        goals += turned_of(theme, by, clause.span, done=clause.verb == "turn")
        used.append(degrees)
    if facing is not None or flat is not None:
        lies = partial(turn_of, facing=facing, flat=flat, scene=scene, span=clause.span)
        goals += turned_of(theme, lies, clause.span, done=False)
        used += [m for m in (facing, flat) if m]
    spec.manners = [m for m in spec.manners if m not in used]
    plain = not (goals or spec.manners or spec.places or spec.thats)
    if plain and (clause.negated or is_none(theme)):  # "do not turn the A", "neither A nor B may be turned"
        still = [unturned(name, clause.span) for name in theme.names]
        return negation([*still], clause.span) if clause.negated else [*still]
    if not goals and _target(clause, spec):
        return _target_letter(theme, spec, scene, clause.span)
    if not goals:
        if clause.lemma == "flip" and not spec.places:
            if len(theme.names) == 2 and theme.det not in ("both", "each", "all"):
                raise refuse("ambiguous", "are these turned upside down, or do they change places?", clause.span,
                             "say 'upside down', or 'swap'")  # fmt: skip
            goals = [
                oriented(n, None, Manner(kind="turn", value=180.0, span=clause.span), scene, clause.span)
                for n in theme.names
            ]
        elif not spec.places and not spec.thats:
            raise refuse("no-goal", "it is not said how far or which way to turn it", clause.span,
                         "say 'by 90 degrees' or 'upside down'")  # fmt: skip
    goals += _of_others(theme, degrees, facing, flat, scene, clause.span)
    for item in spec.places:
        goals += place(theme, item, scene, scope, clause.span)
    spec.places = []
    return goals


def _by_degrees(name: str, degrees: Manner, clause: Clause, lies: bool, scene: Scene) -> g.Goal:
    """ "by 90 degrees clockwise": how far a block came, or how a symbol stands that is read."""
    value = float(degrees.value or 0)
    if not 0 < abs(value) <= 360:
        raise refuse("misplaced", "a turn is by 1 to 360 degrees", degrees.span)
    read = spun(name, degrees, clause.mode == "goal", scene, clause.span, lies)
    return read or r.Turned(block=name, degrees=value, either_way=degrees.kind == "by?", span=clause.span)


def _of_others(
    theme: Ref, degrees: Manner | None, facing: Manner | None, flat: Manner | None, scene: Scene, span: Span
) -> Goals:
    """ "Turn only B by 90 degrees": no other block is turned."""
    if theme.op != "only" or degrees is None:
        others = tuple(thing.name for thing in scene.blocks() if thing.label or thing.kind)
        return others_not_turned(theme, others, facing, flat, scene, span)
    return [unturned(thing.name, span) for thing in scene.blocks() if thing.name not in theme.names]


_ROUND = {"back": 0.0, "left": 90.0, "front": 180.0, "viewer": 180.0, "right": -90.0}
"""How far a symbol that is read from above is turned where its top points to a side."""


def _pointed(theme: Ref, facing: Manner | None, spec: Spec) -> Manner | None:
    """ "its top points left", "with its top to the right": where the top of a symbol is."""
    if facing is not None and theme.part == "top":
        return facing
    return next((m for m in spec.manners if m.kind == "pointing:top"), None)


def _upward(theme: Ref, pointed: Manner, flat: Manner | None, spec: Spec, scene: Scene, span: Span) -> Goals:
    """A symbol that lies with its top to a side, wherever it is put."""
    goals = pointing(theme, pointed, flat, scene, span)
    used = (pointed, flat)
    spec.manners = [m for m in spec.manners if not any(m is x for x in used)]
    for item in spec.places:
        goals += place(theme, item, scene, Scope(), span)
    spec.places = []
    return goals


def pointing(theme: Ref, pointed: Manner, flat: Manner | None, scene: Scene, span: Span) -> Goals:
    """Symbols with their tops to a side; "on its side" says so once more."""
    degrees = _ROUND.get(str(pointed.value))
    if degrees is None:
        raise refuse("ambiguous", "the symbol could be turned round, or its block tipped over", pointed.span,
                     "say 'upside down', 'to the left' or 'facing up'")  # fmt: skip
    if flat is not None and abs(degrees) != flat.value:
        raise refuse("contradiction", "this says two ways to turn it", pointed.span, "keep one of them")
    exact = Manner(kind="turn", value=degrees, span=span)
    return [oriented(name, None, exact, scene, span) for name in theme.names]


def _target(clause: Clause, spec: Spec) -> bool:
    return bool(spec.thats) and clause.theme is not None


def _target_letter(theme: Ref, spec: Spec, scene: Scene, span: Span) -> Goals:
    """ "so that the target letter is in the target orientation": the letter is chosen."""
    return []
