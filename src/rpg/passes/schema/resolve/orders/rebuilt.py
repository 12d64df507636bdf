""" "Rebuild it with blue at the bottom", "restack it so that red is on top": the same blocks in another order."""

from __future__ import annotations

import dataclasses

from rpg.ir import relations as r
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Absolute, At, Chain, Clause, Into, Manner, Meaning, Pronoun, Structure, That
from rpg.passes.schema.resolve.clauses.arranging import arrange_blocks
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.order_kept import note_what_is_kept
from rpg.passes.schema.resolve.orders.out_of_line import out_of_its_line
from rpg.passes.schema.resolve.orders.reordered import reverse
from rpg.passes.schema.resolve.places.placing import Goals, places
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spoken import known_ones
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

_LINES = ("stack", "row", "line", "column")


def once_more(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """A structure that is there, built again the other way round or otherwise; None for other clauses."""
    note_what_is_kept(spec, scene, clause.span)
    if (left := out_of_its_line(clause, spec, scene, scope)) is not None:
        return left
    for way in (_the_other_way, _rebuilt, _as_it_was):
        if (goals := way(clause, spec, scene, scope)) is not None:
            return goals
    return None


def _as_it_was(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "Take it apart, then rebuild it": as it was at the start, where nothing else is told of it."""
    theme = clause.theme
    the = isinstance(theme, Structure) and theme.det == "the" and theme.members is None and not theme.details
    if clause.lemma != "rebuild" or clause.negated or scope.start or theme is None:
        return None
    otherwise = (spec.intos, spec.places, spec.orders, spec.toward, spec.ats, spec.absolutes, spec.thats, spec.usings,
                 spec.patterns)  # fmt: skip
    if any(otherwise) or not (the or (isinstance(theme, Pronoun) and theme.word == "it")):
        return None
    known = refer(theme, scene, scope)
    lines = [x for x in scene.start_goals if isinstance(x, Row | Stack) and {*x.blocks} == {*known.names}]
    if len(lines) != 1:
        scene.mentions.pop()
        return None
    return [lines[0].model_copy(update={"span": clause.span})]


def _the_other_way(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "rebuild it in reverse", "put the row in reverse order": a structure that is there, the other way round."""
    orders = spec.orders and all(o.by == "reverse" for o in spec.orders)
    backwards = any(m.kind == "backwards" or _over(m) for m in spec.manners)
    known = isinstance(clause.theme, Pronoun) or (isinstance(clause.theme, Structure) and clause.theme.det == "the")
    over = any(map(_over, spec.manners))
    wanted = clause.verb == "be" and not (clause.negated or scope.start) and bool(scene.start_goals)
    if (
        not (orders or backwards)
        or not known
        or spec.intos
        or clause.verb not in ("build", "stack", "arrange", "place", "turn", "be")
        or (clause.verb in ("turn", "be") and not (over or wanted))
    ):
        return None
    if wanted and not over and (pair := _other_pair(clause, spec, scene)) is not None:
        return pair
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    if over and not _plain_tower(theme, scene):
        scene.mentions.pop()
        return None
    spec.orders, spec.manners = [], [m for m in spec.manners if m.kind != "backwards" and not _over(m)]
    goals = reverse(theme, scene, clause.span, spec)
    again = scene.built[-1]
    theme = dataclasses.replace(theme, names=again.members, built=(again,))
    there = places(theme, spec, scene, scope, clause.span)
    return [*goals, *(x for x in there if x not in scene.start_goals)]  # it is no longer as it was


def _other_pair(clause: Clause, spec: Spec, scene: Scene) -> Goals | None:
    """ "Red starts on blue. I want it the other way round.": blue on red; and "red is on blue and blue is on green" """
    told = [m for m in spec.manners if m.kind == "backwards" and m.value is None]
    if not told or isinstance(clause.theme, Structure) or not isinstance(scene.start_goals[-1], _SIDED):
        return None
    facts = [x for x in scene.start_goals if isinstance(x, _SIDED) and x.kind == scene.start_goals[-1].kind]
    if len(facts) < len(scene.start_goals) or not all(map(_follow, facts, facts[1:])):
        raise refuse("ambiguous", "which of these should be the other way round?", clause.span, "name the blocks")
    if not all(isinstance(x, tuple) and len(x) == 1 for fact in facts for x in (fact.a, fact.b)):
        return None
    spec.orders, spec.manners = [], [m for m in spec.manners if m not in told]
    return [fact.model_copy(update={"a": fact.b, "b": fact.a, "span": clause.span}) for fact in facts]


_SIDED = (r.On, r.LeftOf, r.RightOf, r.InFrontOf, r.Behind)
_Sided = r.On | r.LeftOf | r.RightOf | r.InFrontOf | r.Behind


def _follow(one: _Sided, other: _Sided) -> bool:
    """Whether two relations join three things to one line."""
    return one.b == other.a or one.a == other.b


def _over(manner: Manner) -> bool:
    """ "Upside down"."""
    return manner.kind == "turn" and manner.value in (180.0, -180.0)


def _plain_tower(theme: Ref, scene: Scene) -> bool:
    """A tower of blocks that show nothing: upside down, it is one in reverse order."""
    stack = len(theme.built) == 1 and theme.built[0].kind == "stack"
    return stack and all(scene.things[n].label is None and scene.things[n].kind is None for n in theme.names)


def _rebuilt(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """A tower or row of the start, built again as its parts or an order say; None for other clauses."""
    theme = clause.theme
    it = isinstance(theme, Pronoun) and theme.word in ("it", "that", "this")
    the = isinstance(theme, Structure) and theme.det == "the" and theme.members is None and not theme.details
    the = the and isinstance(theme, Structure) and len(known_ones(theme, scene)) == 1
    if (
        clause.verb not in ("build", "stack", "arrange")
        or clause.negated
        or not (it or the)
        or spec.intos
        or theme is None
    ):
        return None
    ats = [part for that in spec.thats for part in _parts(that)]
    if not (ats or spec.absolutes or spec.orders or spec.toward) or spec.places:
        return None
    known = refer(theme, scene, scope)
    shapes = [b for b in known.built if b.kind in _LINES]
    if len(shapes) != 1 or len(known.built) != 1:
        scene.mentions.pop()
        return None
    again = next((o for o in spec.orders if it and o.by in ("given", "in_order")), None)
    if again is not None and not set(shapes[0].members) <= {n for x in scene.start_goals for n in names_in(x)}:
        raise refuse("ambiguous", "is this the order that it has at the end, or is it there in another one at first?",
                     again.span, "say 'there is a row A B C' of the start, or tell its order with it")  # fmt: skip
    spec.thats = [that for that in spec.thats if not _parts(that)]
    spec.absolutes += ats
    if shapes[0].kind != "stack":
        spec.intos.append(Into(structure=Structure(kind=shapes[0].kind, span=theme.span), span=theme.span))
    blocks = Ref(names=shapes[0].members, plural=True, span=known.span)
    verb = "stack" if shapes[0].kind == "stack" else "arrange"
    return arrange_blocks(blocks, verb, spec, scene, scope, clause.span)


def _parts(that: That) -> list[Absolute]:
    """ "so that blue is at the bottom and red on top": what is where; nothing if it says anything else."""
    clauses = that.clauses.clauses if isinstance(that.clauses, Chain) else ()
    if that.kind != "so" or not isinstance(that.clauses, Chain) or set(that.clauses.links) != {"and"}:
        return []
    found = [_part(clause) for clause in clauses]
    return [part for part in found if part is not None] if None not in found else []


def _part(clause: Meaning) -> Absolute | None:
    if not isinstance(clause, Clause) or clause.verb != "be" or clause.negated or clause.theme is None:
        return None
    places = clause.adjuncts
    if len(places) != 1 or not isinstance(places[0], At):
        return None
    return Absolute(theme=clause.theme, adjuncts=places, span=clause.span)
