"""Clauses -> goals: what each verb makes of its theme and its adjuncts."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Lowest
from rpg.ir.order import Order
from rpg.passes.schema.meaning import (
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    Toward,
    Traits,
)
from rpg.passes.schema.resolve import turning
from rpg.passes.schema.resolve.appearance import appear
from rpg.passes.schema.resolve.groups import attribute_of, sort_into
from rpg.passes.schema.resolve.orders import alternatives, order_of
from rpg.passes.schema.resolve.refer import continued, give, refer
from rpg.passes.schema.resolve.relations import (
    conj,
    crown,
    foot,
    matching_patches,
    negation,
    place,
    reciprocal,
    related,
    spread,
)
from rpg.passes.schema.resolve.spec import Spec, sort_adjuncts
from rpg.passes.schema.resolve.structures import either, make, row_node, stack_built
from rpg.passes.schema.resolve.world import Built, Ref, Scene, Scope, refuse

Goals = list[g.Goal]


def clause_goals(clause: Clause, scene: Scene, start: bool) -> Goals:
    """The goals that a clause states; structures that its noun phrases bring up come first."""
    scene.clause += 1
    number = scene.clause
    scope = Scope(start=start, given=clause.mode == "given" or start)
    spec = sort_adjuncts(clause.adjuncts)
    if distractors(clause, spec, scene):
        return []
    if clause.theme is not None:
        _first_thats(clause.theme, spec, scene)
    goals = _dispatch(clause, spec, scene, scope)
    goals = [*scene.goals.pop(number, []), *goals]
    later = _thats(spec, scene, start)
    if spec.manner("xor") is not None:
        goals = _not_both(goals, clause.span)
    always = spec.manner("always") is not None
    _leftovers(spec, clause)
    if clause.negated:
        goals = negation(goals, clause.span)
    if always and not start:
        goals = held_throughout(goals, scene, clause.span)
    return [*goals, *later]


def _first_thats(theme: Meaning, spec: Spec, scene: Scene) -> None:
    """ "without moving the blue block, place ... to its left": what stands in front is spoken of first."""
    for that in list(spec.thats):
        if that.kind == "without" and that.span[1] <= theme.span[0]:
            scene.goals.setdefault(scene.clause, []).extend(turning.without(that, scene))
            spec.thats.remove(that)


def _not_both(goals: Goals, span: Span) -> Goals:
    """ "either ... or ..., but not both"."""
    if len(goals) != 1 or not isinstance(goals[0], g.Any):
        raise refuse(
            "misplaced", "'but not both' needs two alternatives", span, "say 'either ... or ..., but not both'"
        )
    parts = goals[0].goals
    return [g.All(goals=(goals[0], g.Not(goal=g.All(goals=parts, span=span), span=span)), span=span)]


def held_throughout(goals: Goals, scene: Scene, span: Span) -> Goals:
    """ "at all times": true from the start on, so that it is arranged at the start too."""
    goals = [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
    scene.start_goals += [
        x for x in goals if not isinstance(x, g.Not | g.Always | r.OnTable) and x not in scene.start_goals
    ]
    return [g.Always(goal=conj(goals, span), span=span)] if goals else []


def distractors(clause: Clause, spec: Spec, scene: Scene) -> bool:
    """Blocks that are only there: "with two extra blue blocks", "a purple block lies around as a distractor"."""
    for using in list(spec.usings):
        if is_extra(using.members):
            refer(using.members, scene, Scope())
            scene.mentions.pop()
            spec.usings.remove(using)
    for place_ in list(spec.places):
        if (
            isinstance(place_, Loc)
            and place_.rel == "between"
            and place_.landmark is not None
            and is_extra(place_.landmark)
        ):
            refer(place_.landmark, scene, Scope())
            scene.mentions.pop()
            spec.places.remove(place_)
    if (
        clause.verb not in ("be", "exist")
        or clause.theme is None
        or _is_shape(clause.theme)
        or spec.manner("extra") is None
    ):
        return False
    marked = as_extra(clause.theme)
    refer(marked, scene, Scope())
    scene.mentions.pop()
    spec.places = []
    return True


def is_extra(meaning: Meaning) -> bool:
    """Whether a phrase speaks of distractors."""
    if isinstance(meaning, Coord):
        return all(is_extra(item) for item in meaning.items)
    return isinstance(meaning, Noun) and meaning.traits.extra


def as_extra(meaning: Meaning) -> Meaning:
    """The phrase with its blocks as distractors."""
    if isinstance(meaning, Coord):
        return replace(meaning, items=tuple(as_extra(item) for item in meaning.items))
    if isinstance(meaning, Noun):
        return replace(meaning, traits=replace(meaning.traits, extra=True))
    return meaning


def _dispatch(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    match clause.verb:
        case "exist":
            return _exist(clause, spec, scene, scope)
        case "ignore":
            return _ignore(clause, scene, scope)
        case "keep" | "touch" | "pick" | "unstack" | "remove" | "swap" | "turn" | "use":
            return _special(clause, spec, scene, scope)
        case "sort":
            return _sort(clause, spec, scene, scope)
        case "spell" | "read":
            return _spell(clause, spec, scene, scope)
    if spec.manner("partial") is not None:
        return _partly(clause, scene, scope)
    if spec.qualities and clause.verb in ("be", "keep"):
        return appear(clause, spec, scene, scope)
    if any(m.kind == "stay" for m in spec.manners):
        return turning.keep(clause, spec, scene, scope)
    if clause.verb == "place" and any(isinstance(p, Loc) and p.rel == "moved" for p in spec.places):
        return turning.moved(clause, spec, scene, scope)
    if (
        clause.verb == "place"
        and clause.lemma in ("move", "shift", "nudge", "relocate", "push", "drag")
        and not clause.adjuncts
        and not clause.negated
    ):
        theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
        scene.assume("moved: at least 5 cm away from where it started")
        return [spread(theme, lambda a: r.Moved(a=a, span=clause.span), clause.span, together=True)]
    if clause.negated and clause.verb == "place" and not clause.adjuncts:
        return turning.stay(clause, spec, scene, scope, stays=True)
    if _is_shape(clause.theme) or (clause.theme is None and spec.intos):
        return _shaped(clause, spec, scene, scope)
    if clause.theme is None:
        return _themeless(clause, spec, scene, scope)
    if any(m.kind in ("facing", "turn", "by", "by?") for m in spec.manners) and not spec.intos:
        return turning.turn(clause, spec, scene, scope)
    if clause.lemma == "alphabetize":
        spec.orders.append(OrderBy(by="label", span=clause.word or clause.span))
    shape = _kind_of_shape(spec)
    if clause.lemma in ("spread", "distribute") and not (
        spec.orders or spec.intos or spec.toward or spec.spacings or spec.places
    ):
        each = Pronoun(word="each other", span=clause.span)
        spec.places.append(Loc(rel="apart", landmark=each, span=clause.span))
    theme = refer(_counted(clause.theme, spec, clause), scene, replace(scope, need_each=2 if shape == "towers" else 1))
    _sandwich(clause, spec)
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _partly(clause: Clause, scene: Scene, scope: Scope) -> Goals:
    """ "start partially stacked": two of the blocks, in a way that the goal does not ask for."""
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    pairs = [(a, b) for a in theme.names for b in theme.names if a != b and scene.on_top.get(a) != b]
    pairs.sort(
        key=lambda two: (scene.on_top.get(two[1]) == two[0], theme.names.index(two[0]) < theme.names.index(two[1]))
    )
    if clause.mode != "start" or not pairs:
        raise refuse("misplaced", "only a start can be partial", clause.span, "say which block goes on which")
    scene.assume("partially stacked at the start: one block lies on another")
    return [r.On(a=(pairs[0][0],), b=(pairs[0][1],), span=clause.span)]


def _sandwich(clause: Clause, spec: Spec) -> None:
    if clause.lemma == "sandwich":
        spec.places = [
            replace(p, rel="sandwiched") if isinstance(p, Loc) and p.rel == "between" else p for p in spec.places
        ]


def _kind_of_shape(spec: Spec) -> str:
    """Whether the adjuncts speak of several towers."""
    towers = any(p.unit in ("stack", "pile") for p in spec.patterns)
    towers = towers or any(
        isinstance(i.structure, Structure) and i.structure.kind == "stack" and i.structure.plural for i in spec.intos
    )
    return "towers" if towers or any(o.by == "attribute" for o in spec.orders) else ""


def _is_shape(theme: Meaning | None) -> bool:
    return isinstance(theme, Structure) or (
        isinstance(theme, Coord) and any(isinstance(i, Structure) for i in theme.items)
    )


def _counted(theme: Meaning, spec: Spec, clause: Clause) -> Meaning:
    """Kinds and numbers that the adjuncts imply for an open theme ("the blocks in alphabetical order")."""
    from rpg.passes.schema.resolve.orders import implied_kind

    kind = implied_kind(spec)
    if (
        isinstance(theme, Noun)
        and kind
        and not theme.traits.kind
        and not theme.traits.labels
        and not theme.traits.colors
    ):
        return replace(theme, traits=replace(theme.traits, kind=kind))
    return theme


def arrange_blocks(theme: Ref, verb: str, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """What becomes of blocks that a verb speaks of: a structure, a line in an order, places."""
    if theme.table:
        raise refuse("misplaced", "the table stays where it is", theme.span, "name blocks")
    if verb == "stack":
        spec.intos = [
            i
            for i in spec.intos
            if not (isinstance(i.structure, Structure) and i.structure.kind == "pile" and not i.structure.plural)
        ]
    heaped = [p for p in spec.places if getattr(p, "rel", "") == "heaped"]
    spec.places = [p for p in spec.places if p not in heaped]
    temporal = next((o for o in spec.orders if o.by == "temporal" or _in_time(o, verb, theme, spec)), None)
    if temporal is not None or (theme.op == "then" and spec.places):
        spec.orders = [o for o in spec.orders if o is not temporal]
        return _one_by_one(theme, temporal, spec, scene, scope, span)
    ref, goals = theme, []
    structured = True
    if _spelt_later(verb, spec, scene, theme):
        return []
    if spec.intos:
        ref, goals = _into(theme, spec, scene, scope)
    elif heaped or verb == "stack":
        ref, goals = _stacked(theme, spec, scene, scope, span, bool(heaped))
    elif _wants_row(verb, spec, theme):
        built, goals = make(Structure(kind="line", span=span), spec, theme, scene, scope)
        spec.orders = []
        ref = replace(theme, names=built[0].members, built=tuple(built))
        scene.mention(ref, "theme")
    else:
        structured = False
    if spec.patterns and any(p.unit == "stack" for p in spec.patterns):
        raise refuse("misplaced", "towers are spoken of, but nothing is stacked", spec.patterns[0].span, "say 'stack'")
    goals = [*goals, *_places(ref, spec, scene, scope, span)]
    goals += loose_ats(ref, spec, scene, span) if spec.ats else []
    if not goals and not structured and not spec.thats and not (verb == "be" and spec.absolutes):
        raise refuse(
            "no-goal", "it is not said where or how", span, "say for example 'on the blue block' or 'in a row'"
        )
    if spec.absolutes:
        goals += absolutes(ref, spec, scene, scope)
    return goals


def _spelt_later(verb: str, spec: Spec, scene: Scene, theme: Ref) -> bool:
    """ "stack letters so that they read SUN": the word says which blocks; the verb only that it stands upright."""
    upright = verb == "stack" or any(getattr(i.structure, "kind", "") == "stack" for i in spec.intos)
    flat = not upright and any(getattr(i.structure, "kind", "") in ("row", "line") for i in spec.intos)
    if not (upright or flat) or not all(scene.things[n].elastic for n in theme.names):
        return False
    for index, that in enumerate(spec.thats):
        first = that.clauses.clauses[0] if isinstance(that.clauses, Chain) else None
        if isinstance(first, Clause) and first.verb in ("spell", "read"):
            along = Toward(axis="z" if upright else "y", span=that.span)
            said = replace(first, adjuncts=(*first.adjuncts, along))
            spec.thats[index] = replace(that, clauses=replace(that.clauses, clauses=(said, *that.clauses.clauses[1:])))
            spec.intos = []
            return True
    return False


def _in_time(order: OrderBy, verb: str, theme: Ref, spec: Spec) -> bool:
    """ "put A, B and C on the patch in that order": an order of blocks that form no line is one in time."""
    if order.by != "given" or spec.intos or spec.toward or (len(theme.names) < 2 and not order.items):
        return False
    placed = verb == "place" and any(isinstance(p, Loc) and p.rel in ("on", "in") for p in spec.places)
    return placed or (not order.items and theme.op == "then")


def _one_by_one(theme: Ref, temporal: OrderBy | None, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """ "red, then green, then blue on the patch"; "in temporal order (blue first, then red)": one stage for each."""
    units = theme.parts
    if temporal is not None and temporal.items:
        found = [refer(item, scene, Scope(pool=theme.names)) for item in temporal.items]
        del scene.mentions[-len(found) :]
        names = tuple(n for ref in found for n in ref.names)
        extra = [n for n in theme.names if n not in names]
        if extra and all(scene.things[n].elastic for n in extra):
            for name in extra:
                del scene.things[name]
            extra = []
        if extra:
            raise refuse(
                "count-mismatch", "the order leaves some of the blocks out", temporal.span, "name every block once"
            )
        units = tuple(found)
    if not units:
        units = tuple(Ref(names=(n,)) for n in theme.names)
    stages = []
    for unit in units:
        again = Spec(**{key: list(value) if isinstance(value, list) else value for key, value in vars(spec).items()})
        stages.append(g.Stage(goal=conj(_places(unit, again, scene, scope, span), span)))
    spec.places, spec.manners = [], [m for m in spec.manners if m.kind != "respectively"]
    return [g.Sequence(stages=tuple(stages), span=span)]


def _wants_row(verb: str, spec: Spec, theme: Ref) -> bool:
    if spec.orders or spec.toward or any(sp.kind == "even" for sp in spec.spacings):
        return True
    return (
        verb == "arrange"
        and not [p for p in spec.places if not isinstance(p, In)]
        and not spec.thats
        and not spec.ats
        and len(theme.names) > 1
    )


def _into(theme: Ref, spec: Spec, scene: Scene, scope: Scope) -> tuple[Ref, Goals]:
    into = spec.intos.pop(0)
    target = into.structure
    if spec.intos:
        raise refuse(
            "order-conflict", "two structures are named for the same blocks", spec.intos[0].span, "keep one of them"
        )
    if isinstance(target, Coord):
        sorted_ = [x for x in target.items if isinstance(x, Structure) and x.kind == "pile"]
        if len(sorted_) == len(target.items):
            built_, goals_ = sort_into(theme.names, None, None, spec, scene, scope, target.span)
            return replace(theme, built=tuple(built_)), goals_
        raise refuse(
            "ambiguous", "it is not said which blocks go into which structure", target.span, "use a clause for each"
        )
    if not isinstance(target, Structure):
        raise refuse("misplaced", "this is nothing that blocks can form", target.span)
    if theme.quant is not None:
        raise refuse("ambiguous", "it is not said which of the blocks", theme.span, "name the blocks")
    built, goals = make(target, spec, theme, scene, scope)
    spec.orders = []
    ref = replace(
        theme, names=tuple(dict.fromkeys(n for b in built for n in b.members)) or theme.names, built=tuple(built)
    )
    scene.mention(ref, "theme")
    return ref, goals


def _stacked(theme: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span, heaped: bool) -> tuple[Ref, Goals]:
    """The verb "stack": a tower of the theme, on something where that is said."""
    if any(m.kind == "respectively" for m in spec.manners) and not heaped:
        return theme, []
    if any(p.unit in ("stack", "pile") for p in spec.patterns) or any(o.by == "attribute" for o in spec.orders):
        return _towers_by(theme, spec, scene, span)
    if len(theme.names) == 1:
        if not spec.places and not heaped:
            raise refuse("no-goal", "it is not said on what to stack it", span, "say 'on the blue block'")
        return theme, []
    if theme.quant is not None or theme.op == "or":
        raise refuse("ambiguous", "it is not said which of the blocks are stacked", theme.span, "name the blocks")
    items = next((o.items for o in spec.orders if o.items and o.by == "given"), ())
    if items and len(theme.names) != len(items):
        theme = replace(theme, names=scene.fit(theme.names, len(items)))
    base = _base(theme, spec, scene, scope)
    spec.listed = spec.listed or theme.listed
    counted = next((z for z in spec.sizes), None)
    if counted is not None:
        built_, goals_ = make(Structure(kind="stack", span=span), spec, theme, scene, scope)
        return replace(theme, names=built_[0].members, built=tuple(built_)), goals_
    order = order_of(spec, theme.names, "stack", scene, scope, span)
    spec.orders, spec.toward = [], []
    names = theme.names
    if base:
        names = (*base, *names)
        ranks = order.ranks if order.by == "given" else ((theme.names),)
        if order.by not in ("any", "given") or order.first == "top":
            raise refuse(
                "ambiguous",
                "an order of part of a tower is not understood here",
                span,
                "name every block from the bottom up",
            )
        order = Order(by="given", ranks=(*((b,) for b in base), *ranks), first="bottom")
    nodes = [
        s.Stack(blocks=names, order=o, readable=o.by in ("label", "number"), span=span)
        for o in alternatives(order, scene)
    ]
    built = stack_built(nodes[0], scene) if len(nodes) == 1 else scene.add_built("stack", names, False, span)
    ref = replace(theme, names=names, built=(built,))
    scene.mention(ref, "theme")
    return ref, [either(nodes)]


def _base(theme: Ref, spec: Spec, scene: Scene, scope: Scope) -> tuple[str, ...]:
    """ "stack the green and the red block on the blue one": the blue block is the bottom of the tower."""
    for item in list(spec.places):
        if (
            isinstance(item, Loc)
            and item.rel == "on"
            and isinstance(item.landmark, Noun)
            and not item.negated
            and item.landmark.head != "patch"
        ):
            if item.landmark.traits.matching:
                continue
            mark = refer(item.landmark, scene, replace(scope, role="landmark"))
            if mark.patch or len(mark.names) != 1:
                scene.mentions.pop()
                if not mark.patch:
                    raise refuse("ambiguous", "a tower stands on one block", item.span, "name one block")
                continue
            spec.places.remove(item)
            return mark.names
    return ()


def _towers_by(theme: Ref, spec: Spec, scene: Scene, span: Span) -> tuple[Ref, Goals]:
    """ "stack the blocks by colour", "where each stack is one colour"."""
    from rpg.passes.schema.resolve.groups import fill, value_of

    attribute = attribute_of(spec) or "color"
    if all(scene.things[n].elastic for n in theme.names):
        colors = len({scene.things[n].color for n in theme.names}) if scene.things[theme.names[0]].color else 3
        theme = replace(theme, names=scene.fit(theme.names, max(2 * colors, len(theme.names))))
    things = [scene.things[n] for n in theme.names]
    fill(things, attribute, None, scene)
    keys: dict[str, list[str]] = {}
    for thing in things:
        keys.setdefault(value_of(thing, attribute), []).append(thing.name)
    if any(len(v) < 2 for v in keys.values()):
        short = next(k for k, v in keys.items() if len(v) < 2)
        raise refuse("too-few", f"a lone {short} block is no tower", span, "name at least two of each")
    node = s.Towers(blocks=theme.names, count=len(keys), each=attribute, separate=True, span=span)  # type: ignore[arg-type]
    built = tuple(scene.add_built("stack", v, False, span) for v in keys.values())
    return replace(theme, built=built), [node]


def _places(ref: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """Every place of the clause, for the theme or the structure it became."""
    goals: Goals = []
    _merge_sides(spec)
    vertical = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("on", "above", "under")]
    level = [p for p in spec.places if p not in vertical]
    respectively = spec.manner("respectively") is not None
    for item in [*vertical, *level]:
        if isinstance(item, Loc) and item.rel == "heaped":
            continue
        goals += _place_one(ref, item, scene, scope, span, respectively)
    spec.places = []
    return [goal for goal in goals if not (isinstance(goal, g.All) and not goal.goals)]


def _merge_sides(spec: Spec) -> None:
    """ "right next to the blue block, on its right side": one relation; "beside it on the right" too."""
    close = next(
        (p for p in spec.places if isinstance(p, Loc) and p.rel in ("adjacent", "beside") and p.landmark is not None),
        None,
    )
    if close is None:
        return
    tight = close.rel == "adjacent" or "immediate" in close.mods
    for at_ in [a for a in spec.ats if a.side in ("left", "right", "front", "back") and a.index is None]:
        spec.ats.remove(at_)
        spec.places[spec.places.index(close)] = replace(
            close, rel={"back": "behind"}.get(at_.side, at_.side), mods=("immediate",) if tight else ()
        )
        if not tight:
            spec.places.append(close)
        return
    for index, side in enumerate(spec.places):
        if (
            isinstance(side, Loc)
            and side.rel in ("left", "right", "front", "behind")
            and tight
            and isinstance(side.landmark, Pronoun)
        ):
            spec.places[index] = replace(side, landmark=close.landmark, mods=("immediate",))
            spec.places.remove(close)
            return


def _place_one(ref: Ref, item: Meaning, scene: Scene, scope: Scope, span: Span, respectively: bool) -> Goals:
    where = (min(span[0], item.span[0]), max(item.span[1], span[0]))
    if isinstance(item, Loc) and item.landmark is not None and ref.built and item.rel == "on":
        patched = _tower_patch(ref, item, scene, scope, where)
        if patched is not None:
            return patched
    if respectively and isinstance(item, Loc) and item.landmark is not None:
        mark = refer(item.landmark, scene, replace(scope, role="landmark"))
        if len(mark.names) != len(ref.names):
            raise refuse(
                "count-mismatch",
                f"'respectively' pairs {len(ref.names)} with {len(mark.names)}",
                item.span,
                "list as many of both",
                left=len(ref.names),
                right=len(mark.names),
            )
        goals: Goals = []
        for a, b in zip(ref.names, mark.names, strict=True):
            single = replace(item, landmark=Pronoun(word="@" + b, span=item.span))
            goals += _direct(
                Ref(names=(a,), span=ref.span), Ref(names=(b,), patch=mark.patch, span=mark.span), single, scene, where
            )
        return goals
    return place(ref, item, scene, scope, where)


def _direct(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> Goals:
    return related(theme, mark, loc, scene, span)


def _tower_patch(ref: Ref, item: Loc, scene: Scene, scope: Scope, span: Span) -> Goals | None:
    """A structure on patches: one patch for all, or a matching one for each tower."""
    landmark = item.landmark
    if isinstance(landmark, Noun) and (
        landmark.traits.matching
        or (landmark.head == "patch" and landmark.traits.scheme in ("some", "different") and not landmark.traits.colors)
    ):
        return matching_patches(ref, Ref(patch=True, matching=True), scene, span)
    return None


def loose_ats(ref: Ref, spec: Spec, scene: Scene, span: Span) -> Goals:
    """ "on the left", "at the bottom" with no structure in the clause: settled once all clauses are read."""
    goals: Goals = []
    for at_ in spec.ats:
        scene.loose.append((ref, at_, span))
    spec.ats = []
    return goals or [g.All(goals=())]


def absolutes(ref: Ref, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "with a red block next to it", "with the letter A on top": further conditions, or parts of the structure."""
    goals: Goals = []
    for item in spec.absolutes:
        if is_extra(item.theme):
            refer(item.theme, scene, Scope())
            scene.mentions.pop()
            continue
        theme = refer(item.theme, scene, replace(scope, role="theme"))
        if any(scene.things[n].invented for n in ref.names) and not set(theme.names) & set(ref.names) and ref.built:
            raise refuse(
                "ambiguous", "it is not clear which blocks the structure is made of", item.span, "name its blocks"
            )
        inner = sort_adjuncts(item.adjuncts)
        _merge_sides(inner)
        for at_ in list(inner.ats):
            if (
                len(ref.built) == 1
                and not set(theme.names) & set(ref.names)
                and at_.side in ("top", "bottom")
                and at_.index is None
            ):
                inner.ats.remove(at_)
                goals += _at_end(theme, ref, at_, scene, item.span)
        if inner.ats and ref.built and not set(theme.names) & set(ref.names):
            raise refuse(
                "misplaced",
                "this place does not fit the structure",
                inner.ats[0].span,
                "say 'on top', or name the block among its members",
            )
        if inner.ats:
            goals += loose_ats(theme, inner, scene, item.span)
        for adjunct in inner.places:
            mark = getattr(adjunct, "landmark", None)
            if isinstance(mark, Pronoun) and mark.word in ("it", "them", "that") and isinstance(adjunct, Loc):
                goals += related(theme, ref, adjunct, scene, item.span)
            else:
                goals += place(theme, adjunct, scene, scope, item.span)
    spec.absolutes = []
    return goals


def _at_end(theme: Ref, ref: Ref, at_: At, scene: Scene, span: Span) -> Goals:
    """A further block on top of a structure, or under it."""
    if at_.side == "top":
        return [r.On(a=theme.names, b=crown(ref), span=span)]
    if ref.built[0].kind != "stack" or len(theme.names) != 1:
        raise refuse("misplaced", "nothing goes under this", at_.span, "count the block among its members")
    return [r.On(a=foot(ref) if ref.built[0].ordered else Lowest(lowest=ref.names), b=theme.names, span=span)]


def _shaped(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """A structure as the theme ("build a tower of ..."), or what the clause is to form ("arrange in a circle")."""
    shapes: list[Meaning]
    if isinstance(clause.theme, Coord) and len(clause.theme.items) == 2 and isinstance(clause.theme.items[0], Noun):
        last = clause.theme.items[1]
        if isinstance(last, Structure) and last.members is None and clause.theme.cost:
            theme = refer(clause.theme.items[0], scene, scope)
            spec.intos.append(Into(structure=last, span=last.span))
            return arrange_blocks(theme, "arrange", spec, scene, scope, clause.span)
    if clause.theme is None:
        shapes = [spec.intos.pop(0).structure]
    else:
        shapes = list(clause.theme.items) if isinstance(clause.theme, Coord) else [clause.theme]
    built: list[Built] = []
    goals: Goals = []
    parts: list[Ref] = []
    for shape in shapes:
        if isinstance(shape, Structure) and not _spoken_of(shape, clause, scene):
            if shape.kind == "pile" and spec.places and clause.verb == "stack":
                raise refuse("misplaced", "piles lie on the table", shape.span)
            more, atoms = make(shape, spec, None, scene, scope)
            spec.intos = [i for i in spec.intos if getattr(i.structure, "kind", "") != "set"]
            goals += atoms
            built += more
            parts.append(Ref(names=tuple(n for b in more for n in b.members), built=tuple(more), span=shape.span))
        else:
            ref = refer(shape, scene, scope)
            if not ref.built and not spec.places:
                raise refuse(
                    "no-goal", "it is not said where these blocks should be", shape.span, "say where they should be"
                )
            built += ref.built
            parts.append(ref)
    names = tuple(dict.fromkeys(n for p in parts for n in p.names))
    ref = Ref(
        names=names,
        built=tuple(built),
        plural=len(built) > 1,
        parts=tuple(parts) if len(parts) > 1 else (),
        span=clause.span,
    )
    scene.mention(ref, "theme")
    if spec.intos:
        raise refuse(
            "order-conflict", "two structures are named for the same blocks", spec.intos[0].span, "keep one of them"
        )
    used = list(goals)
    spec.orders = []
    goals += _places(ref, spec, scene, scope, clause.span)
    if spec.absolutes:
        goals += absolutes(ref, spec, scene, scope)
    if scope.start and any(b.kind == "pile" for b in built):
        return goals
    if not used and not goals:
        raise refuse("no-goal", "it is not said what to do with it", clause.span)
    return goals


def _spoken_of(shape: Structure, clause: Clause, scene: Scene) -> bool:
    from rpg.passes.schema.resolve.structures import _known

    if clause.verb in ("build", "spell") and shape.det in ("a", "bare", "some"):
        return False
    return shape.det in ("the", "its", "each", "all", "both") and bool(_known(shape, scene))


def _themeless(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "align in a row", "sort by colour": the blocks spoken of before."""
    listed = next((o for o in spec.orders if o.items and o.by in ("given", "named")), None)
    if listed is not None and not spec.usings:
        upright = clause.verb == "stack" or listed.first in ("top", "bottom") or any(t.axis == "z" for t in spec.toward)
        kind = "stack" if upright else "line"
        built, goals = make(Structure(kind=kind, span=clause.span), spec, None, scene, scope)
        return [*goals, *_places(Ref(names=built[0].members, built=tuple(built)), spec, scene, scope, clause.span)]
    if not any(True for _ in scene.blocks()) and not spec.usings:
        raise refuse("no-goal", "it is not said which blocks", clause.word or clause.span, "name the blocks")
    source = spec.usings.pop(0).members if spec.usings else Pronoun(word="everything", span=clause.span)
    theme = refer(source, scene, scope)
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _exist(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "there are three red blocks": objects; with a place in a goal: a condition."""
    if clause.mode == "given":
        theme = refer(clause.theme, scene, replace(scope, given=True, start=True)) if clause.theme else Ref()
        scene.mentions[-1].role = "given"
        for name in theme.names:
            scene.things[name].declared = True
        amount = getattr(clause.theme, "amount", None)
        if isinstance(clause.theme, Noun) and amount is not None and amount.strict and amount.low == amount.high:
            scene.closed.append((clause.theme.traits, amount.low, clause.span))
        goals = [
            goal for item in spec.places for goal in place(theme, item, scene, replace(scope, start=True), clause.span)
        ]
        spec.places = []
        scene.start_goals += [x for x in goals if not (isinstance(x, g.All) and not x.goals)]
        return []
    if _is_shape(clause.theme):
        return _shaped(clause, spec, scene, scope)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    goals = _places(theme, spec, scene, scope, clause.span)
    if not goals:
        raise refuse("no-goal", "it is not said where", clause.span, "say where the blocks should be")
    return goals


def _ignore(clause: Clause, scene: Scene, scope: Scope) -> Goals:
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    for name in theme.names:
        scene.things[name].extra = True
    return []


def _special(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    match clause.verb:
        case "keep":
            return turning.keep(clause, spec, scene, scope)
        case "touch":
            return turning.stay(clause, spec, scene, scope, stays=clause.negated)
        case "pick":
            return turning.pick(clause, spec, scene, scope)
        case "unstack" | "remove":
            return turning.remove(clause, spec, scene, scope)
        case "swap":
            return turning.swap(clause, spec, scene, scope)
        case "turn":
            return turning.turn(clause, spec, scene, scope)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    return arrange_blocks(theme, clause.verb, spec, scene, scope, clause.span)


def _sort(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "sort the blocks by colour", "separate the red blocks from the blue ones", "gather the blocks"."""
    line = any(getattr(i.structure, "kind", "") in ("row", "line", "column", "stack", "grid") for i in spec.intos)
    ordered = any(o.by != "attribute" for o in spec.orders) or spec.toward
    if isinstance(clause.theme, Structure) and clause.theme.kind == "pile":
        built, goals = _sort_piles(clause.theme, spec, scene, scope)
        return goals
    if clause.theme is None and not any(True for _ in scene.blocks()):
        raise refuse("no-goal", "it is not said which blocks", clause.word or clause.span, "name the blocks")
    apart = next((p for p in spec.places if isinstance(p, Loc) and p.rel in ("apart", "off") and not p.negated), None)
    theme_meaning = (
        _counted(clause.theme, spec, clause)
        if clause.theme is not None
        else Pronoun(word="everything", span=clause.span)
    )
    if isinstance(theme_meaning, Structure):
        return _shaped(clause, spec, scene, scope)
    attribute = next((o.attribute for o in spec.orders if o.by == "attribute"), None)
    theme = refer(theme_meaning, scene, replace(scope, need=6 if not (line or ordered) else 4, need_each=2))
    if line or ordered:
        return arrange_blocks(theme, "arrange", spec, scene, scope, clause.span)
    if clause.lemma in ("gather", "collect", "cluster", "group", "bunch") and attribute is None and not spec.intos:
        spec.places = [p for p in spec.places if getattr(p, "rel", "") not in ("near", "together")]
        node = s.GroupBy(groups=(theme.names,), span=clause.span)
        ref = replace(theme, built=(scene.add_built("pile", theme.names, False, clause.span),))
        return [node, *_places(ref, spec, scene, scope, clause.span)]
    if (
        clause.lemma in ("separate", "split", "divide")
        and attribute is None
        and (apart is not None or len(theme.parts) == 2)
    ):
        return _separate(theme, apart, spec, scene, scope, clause)
    shape = _pile_target(spec)
    attribute = attribute_of(spec)
    built, goals = sort_into(theme.names, attribute, shape, spec, scene, scope, clause.span)
    ref = replace(theme, built=tuple(built))
    return goals + _places(ref, spec, scene, scope, clause.span)


def _pile_target(spec: Spec) -> Structure | None:
    for into in list(spec.intos):
        if isinstance(into.structure, Structure) and into.structure.kind == "pile":
            spec.intos.remove(into)
            return into.structure
    return None


def _sort_piles(shape: Structure, spec: Spec, scene: Scene, scope: Scope) -> tuple[list[Built], Goals]:
    _pile_target(spec)
    attribute = attribute_of(spec)
    return sort_into(None, attribute, shape, spec, scene, scope, shape.span)


def _separate(theme: Ref, apart: Loc | None, spec: Spec, scene: Scene, scope: Scope, clause: Clause) -> Goals:
    """ "separate the red blocks from the blue ones"."""
    target = _pile_target(spec)
    if apart is None and len(theme.parts) == 2:
        groups: tuple[tuple[str, ...], ...] = tuple(p.names for p in theme.parts)
    elif apart is not None and apart.landmark is not None:
        spec.places.remove(apart)
        mark = refer(apart.landmark, scene, replace(scope, role="landmark"))
        if mark.reciprocal:
            return reciprocal(theme, apart, clause.span)
        groups = (theme.names, mark.names)
    else:
        attribute = attribute_of(spec)
        return sort_into(theme.names, attribute, target, spec, scene, scope, clause.span)[1]
    return [s.GroupBy(groups=groups, span=clause.span)]


def _spell(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "spell CAT with ...", "the cubes read A, B, C"."""
    theme = None
    if spec.usings and _mentioned(spec.usings[0].members):
        theme = refer(spec.usings.pop(0).members, scene, scope)
    if clause.verb == "read" and isinstance(clause.theme, Noun):
        return _read_row(clause, clause.theme, theme, spec, scene, scope)
    if theme is not None and isinstance(clause.theme, Structure):
        built, goals = make(clause.theme, spec, theme, scene, scope)
        ref = Ref(names=built[0].members, built=tuple(built))
        return [*goals, *_places(ref, spec, scene, scope, clause.span)]
    return _shaped(clause, spec, scene, scope)


def _mentioned(meaning: Meaning) -> bool:
    return isinstance(meaning, Pronoun) or (
        isinstance(meaning, Noun) and meaning.det in ("the", "all", "both", "these")
    )


def _read_row(clause: Clause, said: Noun, theme: Ref | None, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "their up-faces read A, B, C ...": a row in reading order."""
    labels = continued(said.traits.labels, None) if said.traits.open_ended else said.traits.labels
    if theme is not None and all(scene.things[n].elastic for n in theme.names):
        names = scene.fit(theme.names, len(labels))
        for name, label in zip(names, labels, strict=True):
            give(scene.things[name], Traits(labels=(label,)))
    else:
        names = refer(said, scene, scope).names
    spec.orders = [o for o in spec.orders if o.by not in ("label", "number", "ascending", "in_order")]
    spec.listed = True
    node = row_node(names, "line", spec, scene, scope, clause.span)
    order = node.order if node.order.by != "any" else Order(by="given", ranks=tuple((n,) for n in names), first="left")
    scene.assume("read from left to right")
    return [node.model_copy(update={"order": order, "readable": True, "axis": "y"})]


def _thats(spec: Spec, scene: Scene, start: bool) -> Goals:
    """ "so that ...", "without ...": the clauses inside."""
    from rpg.passes.schema.resolve.chains import chain_goals

    goals: Goals = []
    for that in spec.thats:
        if that.kind == "without":
            goals += turning.without(that, scene)
        else:
            goals += chain_goals(that.clauses, scene, start)  # type: ignore[arg-type]
    spec.thats = []
    return goals


def _leftovers(spec: Spec, clause: Clause) -> None:
    """Refuse what no reading of the verb has used: a word must never be dropped in silence."""
    for name in (
        "orders",
        "toward",
        "ats",
        "absolutes",
        "usings",
        "patterns",
        "spacings",
        "sizes",
        "places",
        "intos",
        "qualities",
    ):
        for item in getattr(spec, name):
            raise refuse(
                "misplaced",
                "this is understood, but does not fit what is said here",
                item.span,
                "say it in a sentence of its own",
            )
    for manner in spec.manners:
        if manner.kind not in ("idle", "finally", "always"):
            raise refuse(
                "misplaced",
                "this is understood, but does not fit what is said here",
                manner.span,
                "say it in a sentence of its own",
            )
