"""Blocks that a verb arranges: into structures, lines, towers, one after the other."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.later import later
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    Toward,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.fitting import uses_orders
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.clauses.turning import moved_from
from rpg.passes.schema.resolve.goals.logic import conj, negation
from rpg.passes.schema.resolve.orders.orders import order_of
from rpg.passes.schema.resolve.orders.parts import place_of
from rpg.passes.schema.resolve.orders.positions import all_told, alternatives
from rpg.passes.schema.resolve.orders.reading import legible
from rpg.passes.schema.resolve.orders.reordered import kind_again, within
from rpg.passes.schema.resolve.places.across_the_table import table_sides
from rpg.passes.schema.resolve.places.mutual import of_every_two
from rpg.passes.schema.resolve.places.patches import like_the_last
from rpg.passes.schema.resolve.places.placing import Goals, absolutes, loose_ats, places
from rpg.passes.schema.resolve.places.relations import related
from rpg.passes.schema.resolve.places.stacking import separately
from rpg.passes.schema.resolve.structures.figures import check_built
from rpg.passes.schema.resolve.structures.groups import attribute_of, sort_into
from rpg.passes.schema.resolve.structures.so_many_towers import so_high
from rpg.passes.schema.resolve.structures.structures import either, make, stack_built
from rpg.passes.schema.resolve.things.members import certain, of_look_alikes, picked_for
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import bare_colors, plain_colors
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.orders.orders import implied_kind
    from rpg.passes.schema.resolve.structures.groups import fill, value_of
else:
    (implied_kind,) = later(__name__, "rpg.passes.schema.resolve.orders.orders", "implied_kind")
    fill, value_of = later(__name__, "rpg.passes.schema.resolve.structures.groups", "fill", "value_of")


def counted(theme: Meaning, spec: Spec, clause: Clause) -> Meaning:
    """Kinds and numbers that the adjuncts imply for an open theme ("the blocks in alphabetical order")."""
    kind = implied_kind(spec)
    if (
        isinstance(theme, Noun)
        and kind
        and not theme.traits.kind
        and not theme.traits.labels
        and not theme.traits.colors
    ):
        return replace(theme, traits=replace(theme.traits, kind=kind))
    total = next((z for z in spec.sizes if z.what in ("size", "total") and z.amount is not None), None)
    if total is None and (several := _in_turn(theme, spec, clause.lemma)) is not None:
        return several
    colors = plain_colors(theme)
    if total is None or len(colors) < 2:
        return theme
    spec.sizes.remove(total)
    return Noun(head="block", amount=total.amount, plural=True, traits=Traits(colors=colors), span=theme.span)


def _in_turn(theme: Meaning, spec: Spec, lemma: str) -> Meaning | None:
    """ "red and blue blocks alternating in a stack of four", "like a 4x4 chessboard": as many as it takes."""
    shapes = [i.structure for i in spec.intos if isinstance(i.structure, Structure) and i.structure.members is None]
    long = [z for z in spec.sizes if z.what in ("long", "columns")]
    if not spec.intos and len(long) == 1:
        shapes = [Structure(kind="line" if long[0].what == "long" else "row", sizes=(long[0],), span=long[0].span)]
    if len(shapes) != 1 or len(colors := bare_colors(theme)) != 2:
        return None
    shape = shapes[0]
    count = math.prod(shape.dims) if shape.dims else shape.size.low if shape.size is not None else 0
    turns = shape.kind == "checkerboard" or lemma == "alternate" or any(o.by == "alternating" for o in spec.orders)
    if not turns or not count or (shape.size is not None and shape.size.high != shape.size.low):
        return None
    return Noun(head="block", amount=Amount(count, count), plural=True, traits=Traits(colors=colors), span=theme.span)


def arrange_blocks(theme: Ref, verb: str, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """What becomes of blocks that a verb speaks of: a structure, a line in an order, places."""
    if theme.table:
        raise refuse("misplaced", "the table stays where it is", theme.span, "name blocks")
    _evenly_on_patches(spec)
    if verb == "place" and spec.places and theme.names and not theme.built and not scope.start:
        moved_from(theme, spec, scene, scope, span)
    if verb == "stack":
        separately(spec, scene)
        spec.intos = [i for i in spec.intos if not _is_a_pile(i.structure)]
    if not spec.intos and ((spec.ats and verb == "be") or (spec.places and verb in ("be", "place"))):
        spec.orders = [o for o in spec.orders if o.by != "any"]
    heaped = [p for p in spec.places if isinstance(p, Loc) and p.rel == "heaped"]
    spec.places = [p for p in spec.places if p not in heaped]
    if (separate := _not_on_each_other(theme, verb, heaped, spec, scene, span)) is not None:
        return [*separate, *places(theme, spec, scene, scope, span)]
    temporal = next((o for o in spec.orders if o.by == "temporal" or _in_time(o, verb, theme, spec)), None)
    if temporal is not None or (theme.op == "then" and spec.places and not heaped):
        spec.orders = [o for o in spec.orders if o is not temporal]
        return _one_by_one(theme, temporal, spec, scene, scope, span)
    upright = verb == "stack" or bool(heaped)
    if theme.op == "then" and (upright or _lined(verb, spec, theme)) and not any(o.items for o in spec.orders):
        spec.orders = [*(o for o in spec.orders if o.by != "given"), OrderBy(by="given", span=theme.span)]
        spec.in_turn = () if any(x.listed or x.parts for x in theme.parts) else tuple(x.names for x in theme.parts)
    if (again := None if scope.start else within(theme, verb, spec, scene, span)) is not None:
        spec.ats = []
        return [*again, *places(theme, spec, scene, scope, span)]
    ref, structured = theme, True
    goals: Goals = []
    if _spelt_later(verb, spec, scene, theme):
        return []
    _by_dims(verb, spec)
    if spec.intos:
        ref, goals = _into(theme, spec, scene, scope)
    elif upright:
        ref, goals = _stacked(theme, spec, scene, scope, span, bool(heaped))
    elif _wants_row(verb, spec, theme):
        built, goals = make(Structure(kind=kind_again(theme, spec, scene), span=span), spec, theme, scene, scope)
        spec.orders = []
        ref = replace(theme, names=built[0].members, built=tuple(built))
        scene.mention(ref, "theme")
    else:
        structured = False
    if spec.patterns and any(p.unit == "stack" for p in spec.patterns):
        raise refuse("misplaced", "towers are spoken of, but nothing is stacked", spec.patterns[0].span, "say 'stack'")
    others = len(scene.exclusive)  # what is told of it and of blocks that are named later
    goals = [*goals, *places(ref, spec, scene, scope, span)]
    if spec.ats and scope.start and (scene.built or not table_sides(spec.ats)):
        raise refuse("misplaced", "this is a place in a structure of the start", spec.ats[0].span, "say it beside that")
    goals += loose_ats(ref, spec, scene, scope, span) if spec.ats else []
    told = structured or (spec.thats and not scope.start) or (verb == "be" and spec.absolutes)
    told = told or len(scene.exclusive) > others
    if not goals and not told:
        hint = "say for example 'on the blue block' or 'in a row'"
        raise refuse("no-goal", "it is not said where or how", span, hint)
    if spec.absolutes:
        goals += absolutes(ref, spec, scene, scope)
    return goals


def _is_a_pile(structure: Meaning) -> bool:
    return isinstance(structure, Structure) and structure.kind == "pile" and not structure.plural


def _not_on_each_other(theme: Ref, verb: str, heaped: list[Loc], spec: Spec, scene: Scene, span: Span) -> Goals | None:
    """ "not on top of each other", "do not stack the blocks": none of them on another, not just no tower of all."""
    more = spec.intos or spec.orders or spec.toward or spec.patterns or spec.ats or spec.absolutes
    if more or theme.op not in ("and", "nor") or theme.quant is not None or len(theme.names) < 2:
        return None
    pairs = of_every_two(theme.names, Loc(rel="heaped", span=span), span)
    if not scene.denying:
        return negation(pairs, span) if any(item.negated for item in heaped) else None
    return pairs if heaped or (verb == "stack" and not spec.places) else None


def _evenly_on_patches(spec: Spec) -> None:
    """ "evenly over three patches": so many on each, or evenly spaced?"""
    marks = [x for place in spec.places for x in parts_of(place) if isinstance(x, Noun) and x.head == "patch"]
    for even in (x for x in spec.spacings if x.kind == "even" and (len(marks) > 1 or any(m.plural for m in marks))):
        raise refuse("ambiguous", "evenly spaced, or as many on each patch?", even.span, "say 'two on each patch'")


def _by_dims(verb: str, spec: Spec) -> None:
    """ "eight orange blocks, 2 by 2 by 2": the structure that so many by so many are."""
    sized = next((z for z in spec.sizes if z.what == "dims"), None)
    if sized is not None and not spec.intos and verb in ("be", "arrange", "place"):
        kind = "cube" if len(sized.dims) == 3 else "grid"
        spec.intos = [Into(structure=Structure(kind=kind, span=sized.span), span=sized.span)]


def _spelt_later(verb: str, spec: Spec, scene: Scene, theme: Ref) -> bool:
    """ "stack letters so that they read SUN": the word says which blocks; the verb only that it stands upright."""
    upright = verb == "stack" or any(getattr(i.structure, "kind", "") == "stack" for i in spec.intos)
    flat = not upright and any(getattr(i.structure, "kind", "") in ("row", "line") for i in spec.intos)
    if not (upright or flat) or not all(scene.things[n].elastic for n in theme.names):
        return False
    for index, that in enumerate(spec.thats):
        chain = that.clauses
        first = chain.clauses[0] if isinstance(chain, Chain) else None
        if isinstance(chain, Chain) and isinstance(first, Clause) and first.verb in ("spell", "read"):
            along = Toward(axis="z" if upright else "y", span=that.span)
            them = Using(members=Pronoun(word="them", span=that.span), span=that.span)
            told = any(isinstance(a, Using) for a in first.adjuncts) or first.verb == "read"
            said = replace(first, adjuncts=(*first.adjuncts, along) if told else (them, *first.adjuncts, along))
            spec.thats[index] = replace(that, clauses=replace(chain, clauses=(said, *chain.clauses[1:])))
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
    units = theme.parts or tuple(Ref(names=(n,)) for n in theme.names)
    if theme.quant is not None and theme.quant.low < len(theme.names):
        raise refuse("ambiguous", "it is not said which blocks come one after the other", span, "name them")
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
    stages = []
    mark = None if theme.each else _one_mark(spec, scene, scope)
    for unit in units:
        if mark is not None and isinstance(on := spec.places[0], Loc):
            stages.append(g.Stage(goal=conj(related(unit, mark, on, scene, span), span)))
            mark = mark if mark.patch else unit
            continue
        again = Spec(places=list(spec.places), ats=list(spec.ats), manners=list(spec.manners))
        stages.append(g.Stage(goal=conj(places(unit, again, scene, scope, span), span)))
    spec.places, spec.manners = [], [m for m in spec.manners if m.kind != "respectively"]
    return [g.Sequence(stages=tuple(stages), span=span)]


def _one_mark(spec: Spec, scene: Scene, scope: Scope) -> Ref | None:
    """ "yellow, then green on a mat": one for all of them. "... on the black block": there is room for one on it, and
    what comes later goes on that one."""
    item = spec.places[0] if len(spec.places) == 1 else None
    mark = item.landmark if isinstance(item, Loc) and item.rel in ("on", "in") and not item.negated else None
    if isinstance(mark, Noun):
        single = mark.det in ("a", "the", "bare") and not mark.plural and not mark.traits.matching
    else:
        single = isinstance(mark, Pronoun) and mark.word in ("it", "that")
    if mark is None or not single:
        return None
    like = scope.like_patch or (scene.last_landmark_patch and scene.last_landmark_at < mark.span[0])
    found = refer(mark, scene, replace(scope, role="landmark", like_patch=like, pool=(), need=None))
    return found if len(found.names) == 1 and found.quant is None and not found.table else None


def _lined(verb: str, spec: Spec, theme: Ref) -> bool:
    """Whether blocks are to form a line or a tower: "red, then blue" says how they follow each other."""
    kinds = [getattr(into.structure, "kind", "") for into in spec.intos]
    if kinds:
        return kinds[0] in ("stack", "row", "line", "column")
    return _wants_row(verb, spec, theme)


def _wants_row(verb: str, spec: Spec, theme: Ref) -> bool:
    runs = [o for o in spec.orders if o.by == "run" and verb == "place"]
    if len(spec.orders) > len(runs) or spec.toward or any(sp.kind == "even" for sp in spec.spacings):
        return True
    parts = [x for x in map(place_of, spec.absolutes) if x is not None]
    inside = all(x.side == "middle" for x in parts)
    return len(theme.names) > 2 and bool(parts) and any(_in_line(x, inside) for x in spec.places)


def _in_line(place: Meaning, inside: bool) -> bool:
    """ "next to each other", "5 cm apart": of more than two blocks a line; of those that touch one may be `inside`."""
    each_other = getattr(getattr(place, "landmark", None), "word", "") == "each other"
    return each_other and getattr(place, "rel", "") in ("touching", "side_by_side", "adjacent", "distance")[inside:]


def _into(theme: Ref, spec: Spec, scene: Scene, scope: Scope) -> tuple[Ref, Goals]:
    into = spec.intos.pop(0)
    target = into.structure
    if spec.intos:
        raise refuse("order-conflict", "two structures are named for the same blocks", spec.intos[0].span,
                     "keep one of them")  # fmt: skip
    if isinstance(target, Coord):
        sorted_ = [x for x in target.items if isinstance(x, Structure) and x.kind == "pile"]
        if len(sorted_) == len(target.items) and not any(x.sizes for x in sorted_):
            built_, goals_ = sort_into(theme.names, None, None, spec, scene, scope, target.span)
            return replace(theme, built=tuple(built_)), goals_
        raise refuse("ambiguous", "it is not said which blocks go into which structure", target.span,
                     "use a clause for each")  # fmt: skip
    if not isinstance(target, Structure):
        raise refuse("misplaced", "this is nothing that blocks can form", target.span)
    if target.det == "the":
        check_built(target)
    theme = certain(picked_for(target, theme, spec, scene), scene)
    built, goals = make(target, spec, theme, scene, scope)
    if uses_orders(built):
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
    theme = of_look_alikes(theme, spec, scene)
    if theme.quant is not None or theme.op == "or" or theme.mixed:
        raise refuse("ambiguous", "it is not said which of the blocks are stacked", theme.span, "name the blocks")
    items = next((o.items for o in spec.orders if o.items and o.by in ("given", "run", "read")), ())
    if (told := len(items) or all_told(spec.absolutes)) and len(theme.names) != told:
        theme = replace(theme, names=scene.fit(theme.names, told))
    base = _base(theme, spec, scene, scope)
    spec.listed = spec.listed or theme.listed
    if spec.sizes:
        built_, goals_ = make(so_high(theme, spec.sizes[0], scene, span), spec, theme, scene, scope)
        return replace(theme, names=built_[0].members, built=tuple(built_)), goals_
    order = order_of(spec, theme.names, "stack", scene, scope, span)
    names = theme.names
    if base:
        names = (*base, *names)
        ranks = order.ranks if order.by == "given" else ((theme.names),)
        if order.by not in ("any", "given") or order.first == "top":
            raise refuse("ambiguous", "an order of part of a tower is not understood here", span,
                         "name every block from the bottom up")  # fmt: skip
        order = Order(by="given", ranks=(*((b,) for b in base), *ranks), first="bottom")
    exact = theme.op in ("except", "only")  # "all but the gray one": nor is that on top
    nodes = [
        s.Stack(blocks=names, order=o, readable=legible(o, names, spec, scene), exact=exact, span=span)
        for o in alternatives(order, scene)
    ]
    spec.orders, spec.toward = [], []
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
            if item.landmark.traits.matching or (item.landmark.det == "the" and like_the_last(item, scene)):
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
