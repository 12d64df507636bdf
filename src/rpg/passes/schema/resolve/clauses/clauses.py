"""Clauses -> goals: what each verb makes of its theme and its adjuncts."""

from __future__ import annotations

from typing import TypeGuard

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.walk import names as names_in
from rpg.language.grammar.clauses.heights_bounded import BOUNDED
from rpg.language.grammar.clauses.numbers_compared import COMPARED
from rpg.language.grammar.things.retold import universal
from rpg.language.meaning import (
    Amount,
    At,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    Pattern,
    Pronoun,
    Structure,
    replace,
)
from rpg.passes.schema.resolve.clauses import turning, turns
from rpg.passes.schema.resolve.clauses.ahead import ahead, by_verb
from rpg.passes.schema.resolve.clauses.appearance import appear
from rpg.passes.schema.resolve.clauses.arranging import arrange_blocks, counted
from rpg.passes.schema.resolve.clauses.begun_facts import moved_from
from rpg.passes.schema.resolve.clauses.between_two import counted_between
from rpg.passes.schema.resolve.clauses.company import in_company
from rpg.passes.schema.resolve.clauses.denials import denied, denied_of_any, denied_once
from rpg.passes.schema.resolve.clauses.heights_bounded import bounded_heights
from rpg.passes.schema.resolve.clauses.leftovers import nothing_left
from rpg.passes.schema.resolve.clauses.numbers_compared import compared_numbers
from rpg.passes.schema.resolve.clauses.one_or_all import place_of_which, with_its_noun
from rpg.passes.schema.resolve.clauses.out_of_line import out_of_line
from rpg.passes.schema.resolve.clauses.shaped import all_it_has, shaped
from rpg.passes.schema.resolve.clauses.sorting import by_kinds, in_sequence, sort
from rpg.passes.schema.resolve.clauses.spec import Spec, check_built, sort_adjuncts
from rpg.passes.schema.resolve.clauses.spelled import spell
from rpg.passes.schema.resolve.clauses.spread_out import spread_out
from rpg.passes.schema.resolve.clauses.started import laid_down, partly, was_so
from rpg.passes.schema.resolve.clauses.swapped import mere_result, swap
from rpg.passes.schema.resolve.clauses.the_same_ones import of_the_same
from rpg.passes.schema.resolve.clauses.throughout import held_throughout, of_the_rest
from rpg.passes.schema.resolve.goals.logic import forbids
from rpg.passes.schema.resolve.orders.loose import each_alone
from rpg.passes.schema.resolve.orders.rebuilt import once_more
from rpg.passes.schema.resolve.orders.reordered import reverse
from rpg.passes.schema.resolve.places.alone import kept_away, none_further, told_alone
from rpg.passes.schema.resolve.places.between import by_sandwiching
from rpg.passes.schema.resolve.places.centred import by_centring, centred
from rpg.passes.schema.resolve.places.corners import one_for_each_corner
from rpg.passes.schema.resolve.places.moved import MOVES, is_moved
from rpg.passes.schema.resolve.places.moved import moved as far_moved
from rpg.passes.schema.resolve.places.patches import one_for_each_patch
from rpg.passes.schema.resolve.places.placing import Goals, absolutes, distractors, is_shape, parts_alone, places
from rpg.passes.schema.resolve.places.relations import place
from rpg.passes.schema.resolve.places.stacking import Towers
from rpg.passes.schema.resolve.structures.by_looks import as_results
from rpg.passes.schema.resolve.structures.heaps import heaped_up
from rpg.passes.schema.resolve.structures.lined_towers import mixed_line
from rpg.passes.schema.resolve.structures.some_of_several import of_so_many
from rpg.passes.schema.resolve.structures.structures import make
from rpg.passes.schema.resolve.structures.towers import on_matching_patches
from rpg.passes.schema.resolve.things.alike import by_likeness, counterparts
from rpg.passes.schema.resolve.things.inventory import blocks_and_patches, mark_given, tally, told_apart
from rpg.passes.schema.resolve.things.off_it import note_verb
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spare import ignore
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def clause_goals(clause: Clause, scene: Scene, start: bool) -> Goals:
    """The goals that a clause states; structures that its noun phrases bring up come first."""
    scene.clause += 1
    number = scene.clause
    note_verb(clause, scene)
    scope = Scope(start=start, given=clause.mode == "given" or start)
    clause = counted_between(denied_of_any(denied_once(clause), scene), scene)
    clause = moved_from(with_its_noun(of_the_rest(in_company(clause))))
    spec = sort_adjuncts(clause.adjuncts)
    if distractors(clause, spec, scene):
        nothing_left(spec, clause)
        return []
    if clause.theme is not None:
        _first_thats(clause.theme, spec, scene)
        for one in (p for p in spec.places if universal(clause.theme) and "besides" in getattr(p, "mods", ())):
            raise refuse("ambiguous", "all but this one, or all away from it?", one.span, "say 'except' or 'away from'")
    loose, towers = len(scene.loose), Towers.of(scene)
    scene.placing = clause.verb in ("place", "use") and getattr(clause.theme, "word", "") != "same"
    scene.placing |= clause.verb == "be" and scene.later  # where it is then, it was moved to
    scene.denying, scene.describing = clause.negated, clause.verb == "be"
    goals = of_the_same(_dispatch(clause, spec, scene, scope), clause, scene)
    scene.denying = False
    towers.after(scene, start=start, denied=clause.negated)
    together = spec.manner("not all")
    if clause.negated and len(scene.loose) > loose:
        _deny(loose, goals, scene, clause.span, whole=together is not None)
    was_so(goals, clause, spec, scene)
    built = scene.goals.pop(number, [])
    if not clause.negated:
        built, goals = [], [*built, *goals]
    later = _thats(clause, spec, scene, start)
    goals = mere_result(goals, later, scene)
    if spec.manner("xor") is not None:
        goals = not_both(goals, clause.span)
    leave = spec.manner("allowed") is not None and not clause.negated
    goals = kept_away(scene) if leave and getattr(clause.theme, "op", "") == "only" else goals
    if leave and not all(forbids(x) for x in goals):
        raise refuse("no-goal", "this is allowed, but not asked for", clause.span, "say 'must' or 'should'")
    for name in [n for goal in goals for n in names_in(goal)]:
        scene.held.pop(name, None)
    always = spec.manner("always") is not None
    if spec.manner("only") is not None:
        scene.only += [n for m in scene.mentions if m.clause == number and m.role == "theme" for n in m.ref.names]
    none_further(spec, scene)
    nothing_left(spec, clause)
    if clause.negated:
        goals = denied(goals, clause, scene, together)
    if always and not start:
        goals = held_throughout(goals, scene, clause.span)
    return [*built, *goals, *later]


def _deny(loose: int, goals: Goals, scene: Scene, span: Span, whole: bool) -> None:
    """ "the red one is not at the top": it is denied when it is settled. `whole`: "not both", else none of them."""
    if len(scene.loose) > loose + 1 or any(not isinstance(x, g.All) or x.goals for x in goals):
        raise refuse("ambiguous", "it is not clear how much of this is denied", span, "say it in two sentences")
    scene.denied += [one for x in scene.loose[loose:] for one in ([x] if whole else each_alone(x))]
    del scene.loose[loose:]


def _first_thats(theme: Meaning, spec: Spec, scene: Scene) -> None:
    """ "without moving the blue block, place ... to its left": what stands in front is spoken of first."""
    for that in list(spec.thats):
        if that.kind == "without" and any(
            isinstance(p, Loc) and p.rel == "off" and p.span[0] >= that.span[1] for p in spec.places
        ):
            raise refuse("misplaced", "it is not clear what is off what", that.span, "say it in a sentence of its own")
        if that.kind == "without" and that.span[1] <= theme.span[0]:
            scene.goals.setdefault(scene.clause, []).extend(turning.without(that, scene))
            spec.thats.remove(that)


def not_both(goals: Goals, span: Span) -> Goals:
    """ "either ... or ..., but not both"."""
    if len(goals) != 1 or not isinstance(goals[0], g.Any):
        raise refuse("misplaced", "'but not both' needs two alternatives", span, "say 'either ... or ... but not both'")
    parts = goals[0].goals
    return [g.All(goals=(goals[0], g.Not(goal=g.All(goals=parts, span=span), span=span)), span=span)]


LEAVING = {"get", "take", "move", "bring", "transfer", "relocate", "pull", "drag", "carry", "shift", "slide", "shove"}
"""Verbs of moving: what they move off something is on it at the start."""


def _is_off(place: Meaning) -> TypeGuard[Loc]:
    return isinstance(place, Loc) and place.rel == "off" and not place.negated


_BY_VERB = {"sort": sort, "spell": spell, "read": spell, COMPARED: compared_numbers, BOUNDED: bounded_heights}


def _dispatch(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    place_of_which(clause, clause.lemma in LEAVING)
    by_centring(clause, spec, scene)
    _at_a_distance(spec)
    clause = heaped_up(clause, spec)
    clause = by_kinds(told_alone(by_likeness(clause, spec, scene) or clause, spec), spec)
    if clause.lemma in LEAVING and clause.verb in ("place", "use"):
        spec.places = [replace(x, mods=(*x.mods, "leaving")) if _is_off(x) else x for x in spec.places]
    if clause.mode != "given" and (pairs := counterparts(clause, spec, scene, scope)) is not None:
        return pairs
    for told in (once_more, of_so_many):
        if (found := told(clause, spec, scene, scope)) is not None:
            return found
    if clause.verb == "stack":
        scene.last_landmark_patch = False
    if clause.negated and is_shape(clause.theme) and clause.theme is not None and spec.places:
        if clause.verb not in ("be", "place"):
            raise refuse("ambiguous", "it is not clear what of this is denied", clause.span, "use two sentences")
        return places(refer(clause.theme, scene, scope), spec, scene, scope, clause.span)
    if laid_down(clause, spec):
        return _exist(replace(clause, verb="exist", lemma="", mode="given"), Spec(), scene, scope)
    match clause.verb:
        case "exist":
            return _exist(clause, spec, scene, scope)
        case "ignore":
            return ignore(clause, scene, scope)
        case "keep" | "touch" | "pick" | "unstack" | "remove" | "swap" | "replace" | "turn" | "use" | "reverse":
            return _special(clause, spec, scene, scope)
        case verb if verb in _BY_VERB:
            return _BY_VERB[verb](clause, spec, scene, scope)
        case "part":
            return parts_alone(spec, scene, scope, clause.span)
        case "offset":
            return centred(spec, scene, clause.span)
    if (goals := _in_a_manner(clause, spec, scene, scope)) is not None:
        return goals
    by_verb(clause, spec)
    line = out_of_line(clause, spec, scene, scope) or mixed_line(clause, spec, scene, scope)
    if line is not None:
        return line
    if is_shape(clause.theme) or (clause.theme is None and spec.intos):
        return shaped(clause, spec, scene, scope)
    if all_it_has(clause.theme, spec, scene):
        return shaped(replace(clause, theme=None), spec, scene, scope)
    if clause.theme is None or ahead(clause.theme, clause.verb, spec, scene):
        return _themeless(clause, spec, scene, scope)
    if any(m.kind in ("facing", "turn", "by", "by?") for m in spec.manners) and not spec.intos:
        return turns.turn(clause, spec, scene, scope)
    if clause.lemma == "balance" and any(isinstance(x, In) for x in spec.places):
        raise refuse("misplaced", "blocks lie flat: none is balanced on an edge or a corner", clause.span, "say 'on'")
    return _arranged(clause, clause.theme, spec, scene, scope)


def _at_a_distance(spec: Spec) -> None:
    """ "far from the gray block, at least 20 cm": a measure of that, rather than of how far something moves."""
    far = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("apart", "near") and p.landmark and p.low is None]
    measured = [p for p in spec.places if isinstance(p, Loc) and p.rel == "moved" and p.cost and not p.mods]
    if len(far) == len(measured) == 1:
        told = replace(far[0], rel="distance", mods=(), low=measured[0].low, high=measured[0].high)
        spec.places = [told if p is far[0] else p for p in spec.places if p is not measured[0]]


def _in_a_manner(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """What the manner of a clause settles before its theme is looked at: looks, staying, moving; else None."""
    if spec.manner("partial") is not None:
        return partly(clause, scene, scope)
    if spec.qualities and clause.verb in ("be", "keep"):
        return appear(clause, spec, scene, scope)
    if any(m.kind == "stay" for m in spec.manners):
        put = clause.verb in ("place", "stack") and clause.mode == "command" and not clause.negated
        if put and any(isinstance(p, Loc) and p.landmark is not None and p.rel != "moved" for p in spec.places):
            raise refuse("ambiguous", "what is put somewhere does not stay where it is", clause.span,
                         "say what stays where it is in a sentence of its own")  # fmt: skip
        return turning.keep(clause, spec, scene, scope)
    if clause.lemma == "move" and clause.theme and [getattr(a, "kind", "") for a in clause.adjuncts] == ["only"]:
        refer(clause.theme, scene, scope)  # "Only move the red block. It goes ...": nothing of where it goes
        return []
    moved = [p for p in spec.places if isinstance(p, Loc) and p.rel in MOVES]
    if clause.verb == "place" and clause.negated and moved and "here" in moved[0].mods and len(spec.places) == 1:
        spec.places = []
        return turning.stay(clause, spec, scene, scope, stays=True)
    if is_moved(clause, moved):
        return far_moved(clause, spec, scene, scope)
    if (
        clause.verb == "place"
        and clause.lemma in ("move", "shift", "nudge", "relocate", "push", "drag")
        and not (clause.adjuncts or clause.negated)
    ):
        if clause.theme is not None and clause.mode == "command" and clause.span[1] > clause.theme.span[1]:
            raise refuse("no-goal", "it is not said where to", clause.span, "say where the block should be")
        theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
        return turning.moved(theme, scene, clause.span)
    if clause.negated and clause.verb == "place" and all(getattr(a, "kind", "") in _BARRED for a in clause.adjuncts):
        return turning.stay(clause, spec, scene, scope, stays=True)
    return None


_BARRED = ("always", "allowed")
"""How a block may be said not to be moved: never, or "may not"."""


def _arranged(clause: Clause, said: Meaning, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """Blocks that a verb arranges, with what the verb itself says of their order and their places."""
    if not spec.intos and (clause.lemma == "line" or (clause.lemma in ("align", "straighten") and not clause.adjuncts)):
        spec.intos.append(Into(structure=Structure(kind="line", span=clause.word or clause.span), span=clause.span))
    matching = clause.verb == "stack" and any(on_matching_patches(place, said) for place in spec.places)
    if matching and not _kind_of_shape(spec):
        spec.patterns.append(Pattern(unit="stack", span=clause.span))
    shape = _kind_of_shape(spec)
    spread_out(clause, spec)
    said = one_for_each_patch(one_for_each_corner(said, spec.places, scene), spec.places, scene)
    theme = refer(counted(said, spec, clause), scene, replace(scope, need_each=2 if shape == "towers" else 1))
    by_sandwiching(clause, spec)
    in_sequence(clause, theme, spec, scene)
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _kind_of_shape(spec: Spec) -> str:
    """Whether the adjuncts speak of several towers."""
    towers = any(p.unit in ("stack", "pile") for p in spec.patterns)
    towers = towers or any(
        isinstance(i.structure, Structure) and i.structure.kind == "stack" and i.structure.plural for i in spec.intos
    )
    return "towers" if towers or any(o.by == "attribute" for o in spec.orders) else ""


def _themeless(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "align in a row", "sort by colour": the blocks spoken of before."""
    listed = next((o for o in spec.orders if o.items and o.by in ("given", "named", "run", "read")), None)
    unnamed = any(t.color is None and t.label is None for t in scene.blocks())
    if listed is not None and not spec.usings and not unnamed:
        upright = clause.verb == "stack" or listed.first in ("top", "bottom") or any(t.axis == "z" for t in spec.toward)
        built, goals = make(Structure(kind="stack" if upright else "line", span=clause.span), spec, None, scene, scope)
        spec.orders = []
        ref = Ref(names=built[0].members, built=tuple(built))
        return [*goals, *places(ref, spec, scene, scope, clause.span), *absolutes(ref, spec, scene, scope)]
    check_built(clause, spec, scene)
    source = spec.usings.pop(0).members if spec.usings else Pronoun(word="everything", span=clause.span)
    theme = refer(source, scene, scope)
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _only(theme: Meaning | None) -> Meaning | None:
    """ "there is only one red block": just as many."""
    if isinstance(theme, Coord) and theme.op == "only" and isinstance(item := theme.items[0], Noun) and item.amount:
        return replace(item, amount=item.amount._replace(strict=True))
    return theme


def _exist(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "there are three red blocks": objects; with a place in a goal: a condition."""
    if clause.lemma in ("tally", "stock"):
        return tally(clause, spec, scene, scope)
    if clause.mode == "given":
        if (kinds := blocks_and_patches(clause)) is not None:
            return [goal for one in kinds for goal in _exist(one, Spec(), scene, scope)]
        clause = replace(clause, theme=told_apart(_only(clause.theme)))
        if is_shape(clause.theme) and (spec.toward or spec.orders or spec.ats or spec.absolutes or spec.sizes):
            return _there_already(clause, spec, scene, scope)
        theme = refer(clause.theme, scene, replace(scope, given=True, start=True)) if clause.theme else Ref()
        mark_given(theme, scene, clause.span)
        amount: Amount | None = getattr(clause.theme, "amount", None)
        exact = amount is not None and amount.strict and amount.low == amount.high
        if exact and amount is not None and isinstance(clause.theme, Noun) and not clause.theme.traits.extra:
            scene.closed.append((clause.theme.traits, amount.low, clause.span))
        starting = replace(scope, start=True)
        if spec.intos:
            goals = arrange_blocks(replace(theme, det="the"), "be", spec, scene, starting, clause.span)
        else:
            goals = [goal for item in spec.places for goal in place(theme, item, scene, starting, clause.span)]
        spec.places = []
        scene.start_goals += [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
        return []
    if is_shape(clause.theme):
        return shaped(clause, spec, scene, scope)
    theme = refer(one_for_each_patch(clause.theme, spec.places, scene), scene, scope) if clause.theme else Ref()
    goals = places(theme, spec, scene, scope, clause.span)
    if not goals:
        raise refuse("no-goal", "it is not said where", clause.span, "say where the blocks should be")
    return goals


def _there_already(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "there is a row of A, B and C from left to right": a structure of the start with all that is said of it."""
    goals = shaped(clause, spec, scene, replace(scope, given=True, start=True))
    for name in scene.mentions[-1].ref.names:
        scene.things[name].declared = True
    scene.start_goals += [x for x in goals if not (isinstance(x, g.All) and not x.goals) and x not in scene.start_goals]
    return []


def _special(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    match clause.verb:
        case "keep":
            return turns.keep(clause, spec, scene, scope)
        case "touch":
            return turning.stay(clause, spec, scene, scope, stays=clause.negated)
        case "pick":
            return turning.pick(clause, spec, scene, scope)
        case "unstack" | "remove":
            return turning.remove(clause, spec, scene, scope)
        case "swap" | "replace":
            return swap(clause, spec, scene, scope)
        case "turn":
            return turns.turn(clause, spec, scene, scope)
        case "reverse":
            theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
            if isinstance(clause.theme, Structure) and (clause.theme.members or clause.theme.details):
                scene.start_goals += scene.goals.pop(scene.clause, [])
            return reverse(theme, scene, clause.span, spec, clause.lemma == "turn around")
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _thats(clause: Clause, spec: Spec, scene: Scene, start: bool) -> Goals:
    """ "so that ...", "without ...": the clauses inside."""
    from rpg.passes.schema.resolve.clauses.chains import chain_goals

    goals: Goals = []
    for that in spec.thats:
        sided = any(isinstance(a, At) for a in clause.adjuncts)  # "to the left until it touches blue": right of blue
        if that.kind == "until" and (sided or clause.negated or clause.verb in ("keep", "be", "touch")):
            raise refuse("misplaced", "it is not said what holds after that", that.span, "say 'first ..., then ...'")
        if that.kind == "without":
            goals += turning.without(that, scene, clause.verb == "turn")
        else:
            themes = (m.ref.names for m in scene.mentions if m.clause == scene.clause and m.role == "theme")
            scene.told.update(next(themes, ()))
            told = that.clauses if start else as_results(that.clauses, scene)  # type: ignore[arg-type]
            goals += chain_goals(told, scene, start)  # type: ignore[arg-type]
    spec.thats = []
    return goals
