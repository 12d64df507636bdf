"""The verbs of sorting and separating."""

from __future__ import annotations

from dataclasses import fields
from itertools import pairwise

from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.language.meaning import (
    At,
    Clause,
    Coord,
    In,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pattern,
    Pronoun,
    Structure,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.arranging import arrange_blocks, counted
from rpg.passes.schema.resolve.clauses.in_sequence import in_sequence
from rpg.passes.schema.resolve.clauses.shaped import shaped
from rpg.passes.schema.resolve.clauses.sides_told import of_told_kinds
from rpg.passes.schema.resolve.clauses.spec import Spec, sort_adjuncts
from rpg.passes.schema.resolve.orders.extremes import tells_an_end
from rpg.passes.schema.resolve.places.mutual import reciprocal
from rpg.passes.schema.resolve.places.patches import matching_patches
from rpg.passes.schema.resolve.places.placing import Goals, places
from rpg.passes.schema.resolve.structures.grouped import as_groups, equal, group_size
from rpg.passes.schema.resolve.structures.groups import (
    DEFAULT_EACH,
    DEFAULT_GROUPS,
    attribute_of,
    fill,
    share_out,
    sort_into,
)
from rpg.passes.schema.resolve.things.members import certain
from rpg.passes.schema.resolve.things.operands import measure
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

GATHERS = frozenset({"gather", "collect", "cluster", "group", "bunch", "merge", "combine", "unite",
                     "herd", "bundle", "lump", "crowd", "huddle"})  # fmt: skip
UNITES = frozenset({"merge", "combine", "unite"})
DIVIDES = frozenset({"separate", "segregate", "split", "divide", "partition", "distribute"})
_SORTS = ("sort", "group", "cluster")
SIDE = 3
"""Blocks on each side that are separated, where their number is left open."""


_LINED = ("row", "line", "column", "stack", "grid")


def sort(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "sort the blocks by colour", "separate the red blocks from the blue ones", "gather the blocks"."""
    divides = clause.lemma in DIVIDES or (clause.lemma in _SORTS and (_from_others(spec) or _opposites(clause.theme)))
    line = any(getattr(i.structure, "kind", "") in _LINED for i in spec.intos)
    ordered = any(o.by != "attribute" for o in spec.orders) or spec.toward or any(map(tells_an_end, spec.absolutes))
    if any(o.by in ("ascending", "number", "label") for o in spec.orders):  # "sort by value, descending"
        spec.orders = [o for o in spec.orders if (o.by, o.attribute) != ("attribute", "label")]
    _one_for_each(spec)
    _no_order(clause, spec, line)
    if isinstance(clause.theme, Structure) and clause.theme.kind == "pile":
        return _sort_piles(clause.theme, spec, scene, scope)[1]
    if clause.theme is None and not any(scene.blocks()):
        raise refuse("no-goal", "it is not said which blocks", clause.word or clause.span, "name the blocks")
    apart = next((p for p in spec.places if isinstance(p, Loc) and p.rel in ("apart", "off") and not p.negated), None)
    said = clause.theme or Pronoun(word="everything", span=clause.span)
    theme_meaning = counted(said, spec, clause) if clause.theme is not None else said
    if clause.lemma in UNITES and any(isinstance(x, Structure) and x.det != "these" for x in parts_of(theme_meaning)):
        raise refuse("ambiguous", "these are structures of the start or of the end", theme_meaning.span,
                     "say what there is at the start, then what to build")  # fmt: skip
    if (of_groups := as_groups(clause, theme_meaning, spec, scene)) is not None:
        return shaped(of_groups, spec, scene, scope)
    attribute = next((o.attribute for o in spec.orders if o.by == "attribute"), None)
    each = 1 if line or ordered else _lot(spec, scene)
    few = SIDE if divides and (apart or spec.usings) else 6
    need = 4 if line or ordered else few if each < 3 else DEFAULT_GROUPS * each
    _at_hand(theme_meaning, spec, scene)
    theme = certain(refer(theme_meaning, scene, replace(scope, need=need, need_each=each)), scene)
    _check_repeated(theme, clause, spec, scene)
    theme, attribute = of_told_kinds(theme, attribute or _by_color(theme, spec, scene) or _of_each(spec), spec, scene)
    if line or ordered:
        in_sequence(clause, theme, spec, scene)
        return arrange_blocks(theme, "arrange", spec, scene, scope, clause.span)
    if (patched := _onto_patches(theme, attribute, spec, scene, clause)) is not None:
        return patched
    lots = tuple(part.names for part in theme.parts)
    if apart and _of_each_other(apart) and len(lots) < 2 and clause.lemma in GATHERS and attribute is None:
        raise refuse("ambiguous", "these could be a group of their own, or each by itself", apart.span,
                     "say 'in a group of their own', or 'apart from each other'")  # fmt: skip
    if apart is not None and _of_each_other(apart) and len(lots) > 1 and attribute is None and not spec.intos:
        spec.places.remove(apart)
        return [s.GroupBy(groups=lots, span=clause.span), *places(theme, spec, scene, scope, clause.span)]
    into_one = (clause.lemma in GATHERS and not _opposites(clause.theme)) or (bool(spec.intos) and not divides)
    if into_one and not (apart and (divides or _of_each_other(apart))) and attribute is None and _one_pile(spec):
        return _gathered(theme, spec, scene, scope, clause)
    if divides and attribute is None and (far := _by_so_much(theme, spec)) is not None:
        return [far, *places(theme, spec, scene, scope, clause.span)]
    pair = len(theme.names) == 2 and not (theme.parts or spec.intos or spec.usings or apart)
    if divides and attribute is None and pair:
        one, other = theme.names
        return [r.Apart(a=(one,), b=(other,), span=clause.span), *places(theme, spec, scene, scope, clause.span)]
    if divides and attribute is None and (apart is not None or len(theme.parts) == 2 or spec.usings):
        return _separate(theme, apart, spec, scene, scope, clause)
    shape, attribute = _pile_target(spec), attribute_of(spec)
    if attribute is None and shape is not None and clause.lemma in DIVIDES:
        built, goals = share_out(theme, shape, spec, scene, clause.span)
    else:
        built, goals = sort_into(theme.names, attribute, shape, spec, scene, scope, clause.span)
    equal(built, spec)
    goals += _sides_of(built, spec, scene)
    return goals + places(replace(theme, built=tuple(built)), spec, scene, scope, clause.span)


def _one_for_each(spec: Spec) -> None:
    """ "(Group the cubes), one cluster per color": by what they are sorted."""
    for told in [x for x in spec.patterns if x.unit == "pile" and x.different and not x.values]:
        spec.patterns.remove(told)
        if not any(o.by == "attribute" for o in spec.orders):
            spec.orders.append(OrderBy(by="attribute", attribute=told.attribute, span=told.span))


def _by_color(theme: Ref, spec: Spec, scene: Scene) -> str | None:
    """ "Group 3 red and 3 blue blocks with one stranger in each group": a stranger is one of another colour."""
    looks = {(scene.things[n].color, scene.things[n].label) for n in theme.names}
    colors = all(color and not label for color, label in looks)
    if len(looks) < 2 or not colors or not any(m.kind == "outliers" for m in spec.manners):
        return None
    spec.orders.append(OrderBy(by="attribute", attribute="color", span=theme.span))
    return "color"


def _of_each(spec: Spec) -> str | None:
    """ "(separate three red and three blue cubes) into one group per color": what tells the groups apart."""
    shapes = [x.structure for x in spec.intos if isinstance(x.structure, Structure) and x.structure.kind == "pile"]
    told = [d for shape in shapes for d in shape.details if isinstance(d, Pattern) and d.unit == "stack"]
    return told[0].attribute if len(told) == 1 and told[0].different and not told[0].values else None


def _gathered(theme: Ref, spec: Spec, scene: Scene, scope: Scope, clause: Clause) -> Goals:
    """ "gather the red blocks", "put A and B into one group": all of them in one."""
    if not spec.intos:
        scene.gathered.add(frozenset(theme.names))
    spec.intos = []
    spec.places = [p for p in spec.places if not _together(p)]
    for middle in [x for x in spec.ats if (x.side, x.index, x.whole) == ("middle", None, None)]:
        spec.ats.remove(middle)  # "gather them in the middle": of the table
        spec.places.append(In(region="middle", span=middle.span))
    node = s.GroupBy(groups=(theme.names,), span=clause.span)
    ref = replace(theme, built=(scene.add_built("pile", theme.names, False, clause.span),))
    return [node, *places(ref, spec, scene, scope, clause.span)]


def _so_far_apart(groups: tuple[tuple[str, ...], ...], spec: Spec) -> Goals:
    """ "separate A, B, C from X, Y, Z with at least 10 cm between the groups": how far the two groups are apart."""
    far = [
        p for p in spec.places if isinstance(p, Loc) and p.rel in ("moved", "distance") and not (p.negated or p.mods)
    ]
    if len(far) != 1 or len(groups) != 2:
        return []
    mark = far[0].landmark
    if far[0].rel == "distance" and not (isinstance(mark, Pronoun) and mark.word == "each other"):
        return []
    spec.places.remove(far[0])
    low, high, (a, b) = far[0].low, far[0].high, groups
    return [r.Distance(a=a, b=b, minimum=low, maximum=high, measure=measure(far[0]), span=far[0].span)]


def _by_so_much(theme: Ref, spec: Spec) -> r.Distance | None:
    """ "separate red and blue by 20 cm", "... so that they are 20 cm apart": of two blocks, how far that is."""
    far = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("moved", "distance") and not p.negated]
    if len(theme.names) != 2 or len(far) != 1 or far[0].mods:
        return None
    moved, mark = far[0].rel == "moved", far[0].landmark
    if not moved and not (isinstance(mark, Pronoun) and mark.word == "each other"):
        return None
    spec.places.remove(far[0])
    a, b = theme.names
    low, high = far[0].low, far[0].high
    return r.Distance(a=(a,), b=(b,), minimum=low, maximum=high, measure=measure(far[0]), span=far[0].span)


def _no_order(clause: Clause, spec: Spec, line: bool) -> None:
    """ "group them by letter" puts nothing in order, and "divide them between two patches" nothing in the gap."""
    _not_between_patches(clause, spec)
    if clause.lemma in GATHERS | DIVIDES and not line and (by := [o for o in spec.orders if o.by == "label"]):
        raise refuse("misplaced", "groups have no order", by[0].span, "say 'in a row', or 'by the same letter'")


def _not_between_patches(clause: Clause, spec: Spec) -> None:
    """ "Divide the blocks between two patches" shares them out, and does not sort them in the gap."""
    for place in spec.places if clause.lemma in DIVIDES else ():
        mark = place.landmark if isinstance(place, Loc) and place.rel == "between" else None
        if any(isinstance(x, Noun) and x.head == "patch" for x in parts_of(mark)):
            raise refuse(
                "ambiguous", "it is not said how many are on each patch", place.span, "say 'three on each patch'"
            )


def by_kinds(clause: Clause, spec: Spec) -> Clause:
    """ "A, B, 1 and 2: letters in one group, digits in the other": told of each kind, whatever the verb."""
    if any(o.by == "parted" for o in spec.orders):
        spec.orders = [replace(o, by="attribute") if o.by == "parted" else o for o in spec.orders]
        kept = isinstance(clause.theme, Structure) or spec.intos or clause.verb == "stack"
        clause = clause if kept else replace(clause, verb="sort")
    by = [o.by == "attribute" for o in spec.orders]
    if clause.verb == "be" and len(by) == 1 and all(by) and not (spec.intos or spec.toward or spec.absolutes):
        return replace(clause, verb="sort", lemma="sort")
    return clause


def _from_others(spec: Spec) -> bool:
    """ "sort the vowels from the consonants"."""
    apart = [x for x in spec.places if isinstance(x, Loc) and x.rel in ("apart", "off") and not x.negated]
    return any(x.lead == "from" for x in spec.usings) or not all(map(_of_each_other, apart))


_OPPOSITES = ({"vowel", "consonant"}, {"odd", "even"}, {"letter", "digit"}, {"big", "small"})


def _opposites(theme: Meaning | None) -> bool:
    """ "group odd and even numbers": kinds that exclude each other are told to be parted, not to be joined."""
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" and len(theme.items) == 2 else ()
    marks = [x.traits for x in items if isinstance(x, Noun) and not (x.traits.labels or x.traits.colors)]
    return {x.quality or x.size or x.kind for x in marks} in _OPPOSITES


def _at_hand(theme: Meaning, spec: Spec, scene: Scene) -> None:
    """ "separate the odd from the even digits, using 1 to 6": the symbols among which these are."""
    if not any(isinstance(x, Noun) and x.traits.quality and not x.traits.labels for x in parts_of(theme)):
        return
    for using in list(spec.usings):
        if isinstance(using.members, Noun) and len(using.members.traits.labels) > 1:
            found = refer(using.members, scene, Scope(given=True, start=True))
            scene.mentions.pop()
            spec.usings.remove(using)
            for name in found.names:
                scene.things[name].declared = True


_ACROSS = {"left": 0, "front": 0, "middle": 1, "right": 2, "back": 2}


def _sides_of(built: list[Built], spec: Spec, scene: Scene) -> Goals:
    """ "... into two groups, gray on the left and pink on the right": how the groups lie to each other."""
    ranked: list[tuple[int, tuple[str, ...]]] = []
    sided = [x for x in spec.absolutes if isinstance(x.adjuncts[0], At) and x.adjuncts[0].index is None]
    for item in sided:
        at_ = item.adjuncts[0]
        marks = item.theme.traits if isinstance(item.theme, Noun) else None
        alike = {t.name for t in matching(marks, scene, False)} if marks else set()
        lot = next((b for b in built if alike == {*b.members}), None)
        if lot is None or not isinstance(at_, At) or at_.side not in _ACROSS or len(item.adjuncts) > 1:
            raise refuse("ambiguous", "it is not clear which group this is", item.span, "name the group by its colour")
        ranked.append((_ACROSS[at_.side], lot.members))
    sides = {x.adjuncts[0].side for x in sided if isinstance(x.adjuncts[0], At)}
    if not ranked:
        return []
    deep = bool(sides & {"front", "back"})
    if len(ranked) != len(built) or len({n for n, _ in ranked}) < len(ranked) or (deep and sides & {"left", "right"}):
        raise refuse("ambiguous", "it is not said where each of the groups lies", sided[0].span, "say it of each group")
    spec.absolutes = [x for x in spec.absolutes if x not in sided]
    node: type[r.LeftOf | r.InFrontOf] = r.InFrontOf if deep else r.LeftOf
    return [node(a=a, b=b, span=sided[0].span) for (_, a), (_, b) in pairwise(sorted(ranked))]


def _check_repeated(theme: Ref, clause: Clause, spec: Spec, scene: Scene) -> None:
    """ "Group two As and two Bs by letter": blocks that show the same are grouped, not put in order."""
    labels = [scene.things[n].label for n in theme.names]
    if clause.lemma in GATHERS and any(o.by == "label" for o in spec.orders) and len(set(labels)) < len(labels):
        raise refuse("misplaced", "blocks that show the same are grouped, not put in order", clause.span)


def _one_pile(spec: Spec) -> bool:
    """ "combine the blocks", "combine them into one pile"."""
    shapes = [i.structure for i in spec.intos]
    return all(isinstance(x, Structure) and x.kind == "pile" and not x.plural for x in shapes)


def _lot(spec: Spec, scene: Scene) -> int:
    """How many blocks each group has, where their number is open."""
    shape = next((i.structure for i in spec.intos if getattr(i.structure, "kind", "") == "pile"), None)
    size = group_size(shape) if isinstance(shape, Structure) else None
    return size or (scene.each[0] if scene.each else DEFAULT_EACH)


def _together(place: Meaning) -> bool:
    """ "gather the blocks together", "close to each other": what the verb says already."""
    mark = place.landmark if isinstance(place, Loc) and place.rel in ("near", "together") else None
    return isinstance(mark, Pronoun) and mark.word in ("each other", "one another")


def _of_each_other(place: Loc) -> bool:
    return place.rel == "apart" and isinstance(place.landmark, Pronoun) and place.landmark.word == "each other"


def _onto_patches(theme: Ref, attribute: str | None, spec: Spec, scene: Scene, clause: Clause) -> Goals | None:
    """ "sort the blocks onto the patches by colour": each on the patch of its colour."""
    on = next((p for p in spec.places if isinstance(p, Loc) and p.rel in ("on", "in") and not p.negated), None)
    mark = on.landmark if on is not None else None
    if on is None or not isinstance(mark, Noun) or mark.head != "patch" or mark.traits.colors:
        return None
    if attribute not in (None, "color") or not (mark.plural or mark.det == "each" or mark.traits.matching):
        return None
    if attribute is None and not mark.traits.matching:
        raise refuse("ambiguous", "it is not said what to sort by", mark.span, "say 'by color'")
    attribute_of(spec)
    spec.places.remove(on)
    own = mark.traits.matching and all(scene.things[n].color for n in theme.names)
    there = refer(mark, scene, Scope(role="landmark", given=True)).names if mark.det == "the" and not own else ()
    count = mark.amount.low if mark.amount else len(there) or None
    fill([scene.things[n] for n in theme.names], "color", count, scene)
    colors = {scene.things[n].color for n in theme.names}
    if count is not None and len(colors) > count:
        raise refuse("count-mismatch", f"{len(colors)} colours, but {count} patches", mark.span, "name as many of both")
    return [*matching_patches(theme, Ref(patch=True, matching=True), scene, clause.span)]


def _pile_target(spec: Spec) -> Structure | None:
    for into in list(spec.intos):
        if isinstance(into.structure, Structure) and into.structure.kind == "pile":
            if into.structure.det == "each":
                raise refuse("misplaced", "it is not clear what is in each of them", into.span,
                             "say 'with exactly one stranger in each group'")  # fmt: skip
            spec.intos.remove(into)
            inner = sort_adjuncts(into.structure.details)
            for part in fields(Spec):
                if isinstance(held := getattr(spec, part.name), list):
                    held += getattr(inner, part.name)
            return into.structure
    return None


def _sort_piles(shape: Structure, spec: Spec, scene: Scene, scope: Scope) -> tuple[list[Built], Goals]:
    _pile_target(spec)
    attribute = attribute_of(spec)
    return sort_into(None, attribute, shape, spec, scene, scope, shape.span)


def _separate(theme: Ref, apart: Loc | None, spec: Spec, scene: Scene, scope: Scope, clause: Clause) -> Goals:
    """ "separate the red blocks from the blue ones"."""
    target = _pile_target(spec)
    two = apart is not None or bool(spec.usings) or len(theme.parts) == 2
    if target is not None and target.amount and target.amount.low > 2 and two:
        raise refuse("count-mismatch", "two groups are separated", target.span, "say 'into two groups'")
    if apart is None and spec.usings and len(theme.parts) != 2:
        from_ = spec.usings.pop(0).members
        other = refer(from_, scene, replace(scope, role="landmark", need=SIDE))
        if other.reciprocal:
            return reciprocal(theme, Loc(rel="apart", landmark=from_, span=from_.span), clause.span)
        groups: tuple[tuple[str, ...], ...] = (theme.names, other.names)
    elif apart is None and len(theme.parts) == 2:
        groups = tuple(p.names for p in theme.parts)
    elif apart is not None and apart.landmark is not None:
        spec.places.remove(apart)
        mark = refer(apart.landmark, scene, replace(scope, role="landmark", need=SIDE))
        if mark.reciprocal:
            return reciprocal(theme, apart, clause.span)
        groups = (theme.names, mark.names)
    else:
        attribute = attribute_of(spec)
        return sort_into(theme.names, attribute, target, spec, scene, scope, clause.span)[1]
    if set(groups[0]) & set(groups[1]):
        raise refuse("self-reference", "a block is in both groups", clause.span, "name different blocks")
    if len(groups[0]) == len(groups[1]) == 1:
        return [r.Apart(a=groups[0], b=groups[1], span=clause.span)]
    for lot in groups:
        scene.add_built("pile", lot, False, clause.span)
    return [s.GroupBy(groups=groups, span=clause.span), *_so_far_apart(groups, spec)]
