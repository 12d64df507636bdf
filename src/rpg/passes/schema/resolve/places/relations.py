"""Places -> goals: a relation between what a clause speaks of and its landmark."""

from __future__ import annotations

from typing import Any

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Operand
from rpg.language.meaning import Amount, Coord, In, Loc, Meaning, Noun, Pronoun, replace
from rpg.passes.schema.resolve.clauses.alls import all_others
from rpg.passes.schema.resolve.clauses.each_of_what import EACH_TOWER, first_and_last
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj, negate, negation
from rpg.passes.schema.resolve.places.alone import alone_there, none_beyond, none_there, only_here, only_on_table
from rpg.passes.schema.resolve.places.any_patch import on_any_patch, on_just_one
from rpg.passes.schema.resolve.places.bare_table import on_the_table
from rpg.passes.schema.resolve.places.between import between, only_between
from rpg.passes.schema.resolve.places.centred import centred_on
from rpg.passes.schema.resolve.places.compared import compared as compared_far
from rpg.passes.schema.resolve.places.corners import corners, from_their_halves, in_region, of_something_else
from rpg.passes.schema.resolve.places.flanks import flanked
from rpg.passes.schema.resolve.places.lots import along_a_line, one_lot_each
from rpg.passes.schema.resolve.places.moved import begins_on, note_taken, off_patches, off_what, taken_off
from rpg.passes.schema.resolve.places.mutual import (
    COMPARED,
    among_themselves,
    check_further,
    none_another,
    of_the_towers,
    one_for_each,
)
from rpg.passes.schema.resolve.places.one_structure import of_one_structure
from rpg.passes.schema.resolve.places.patches import (
    any_of_the_rest,
    check_same,
    each_its_own,
    indefinite,
    like_the_last,
    matching_patches,
    on_patches,
    on_separate_patches,
)
from rpg.passes.schema.resolve.places.side_lengths import MEASURES, so_large
from rpg.passes.schema.resolve.places.some_of_them import (
    any_one,
    by_itself,
    none_of_others,
    to_each_other,
    to_others,
)
from rpg.passes.schema.resolve.places.stacking import Towers, check_bodies, vertical
from rpg.passes.schema.resolve.places.where_was import took_place
from rpg.passes.schema.resolve.things.none_of import one_and_all
from rpg.passes.schema.resolve.things.operands import (
    DIRECTIONS,
    LEVEL,
    carrier,
    check_one_on_many,
    count,
    crown,
    far_from_any,
    first_of_all,
    foot,
    measure,
    one_by_one,
    one_on_one,
    so_far,
    spread,
)
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.theirs import off_which
from rpg.passes.schema.resolve.things.things import compared, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse, which_one

PATCH_MIDDLE = 0.02
"""How far from a patch's centre a block in its middle may be, in metres."""


def place(theme: Ref, meaning: Meaning, scene: Scene, scope: Scope, span: Span) -> Atoms:
    """The goals that "theme is <meaning>" states."""
    if theme.beyond is not None:
        return [none_beyond(theme, meaning, scene, scope, _relate)]
    if theme.everything and theme.quant is not None and isinstance(meaning, In) and not meaning.negated:
        return [none_there(meaning, scene)]
    if theme.op == "only" and isinstance(meaning, In):
        theme = only_here(theme, meaning, scene)
    if theme.op == "only" and not (isinstance(meaning, Loc) and meaning.landmark is not None):
        raise refuse("misplaced", "'only' does not fit this", theme.span, "say what the other blocks should not do")
    match meaning:
        case In(region=region) if region.startswith(("each_corner", "opposite_", "different_")):
            return corners(theme, meaning, scene, span)
        case In(vague=True) if of_something_else(theme, meaning, scene):
            raise refuse("ambiguous", f"it is not clear of what this is the {meaning.region.replace('_', ' ')}",
                         meaning.span, "say 'of the table', or name the structure's blocks")  # fmt: skip
        case In(region="other_half"):
            pairs = from_their_halves(theme, meaning, scene, scope)
            return [x for one, half in pairs for x in place(one, half, scene, scope, span)]
        case In():
            scene.region, scene.region_at = meaning.region, meaning.span[0]
            scene.regions[scene.clause] = meaning.region
            return [negate(in_region(theme, meaning.region, span), meaning.negated, span)]
        case Coord():
            if meaning.op == "or" and theme.each and theme.quant is None and len(theme.names) > 1:
                return [x for n in theme.names for x in place(Ref(names=(n,)), meaning, scene, scope, span)]
            if meaning.op == "or":
                places = of_one_structure(meaning.items, scene, scope)
                return [disj([_alternative(theme, x, scene, scope, span) for x in places], span)]
            return [conj(place(theme, x, scene, scope, span), span) for x in meaning.items]
        case Loc(landmark=Coord(op=op, items=marks)) if any(getattr(x, "word", "") == "each other" for x in marks):
            both = tuple(replace(meaning, landmark=x) for x in marks)
            if op == "except":  # "touches it but not each other"
                op, both = "and", (both[0], *(replace(x, negated=not x.negated) for x in both[1:]))
            whole = Coord(op="and" if meaning.negated else op, items=both, span=meaning.span)  # "not each other or red"
            return place(theme, whole, scene, scope, span)
        case Loc(landmark=Pronoun(word="there")) if scene.region_at > scene.last_landmark_at:
            return place(theme, In(region=scene.region, negated=meaning.negated, span=meaning.span), scene, scope, span)
        case Loc(measure=measure) if measure in MEASURES:
            return [so_large(theme, meaning, scene)]
        case Loc(rel="where was"):
            return took_place(theme, meaning, scene, scope, span)
        case Loc():
            towers = Towers.of(scene)
            goals = _loc(theme, meaning, scene, scope, span)
            if meaning.negated:
                towers.after(scene, start=False, denied=True)
            if meaning.negated and getattr(getattr(meaning.landmark, "traits", None), "scheme", "") == "same":
                return [g.Not(goal=conj(goals, span), span=span)]
            return negation(goals, span) if meaning.negated else goals
        case _:
            raise refuse("misplaced", "this does not say where something is", meaning.span)


def _alternative(theme: Ref, meaning: Meaning, scene: Scene, scope: Scope, span: Span) -> g.Goal:
    """One of several places: the towers that it would make are no more certain than it is."""
    towers = Towers.of(scene)
    goal = conj(place(theme, meaning, scene, scope, span), span)
    towers.after(scene, start=False, denied=True)
    return goal


def _loc(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> Atoms:
    if (loc := loc if loc.negated or scene.denying else any_one(loc)).landmark is None:
        raise refuse("misplaced", "it is not said of what", loc.span)
    if loc.rel in COMPARED:
        return compared_far(theme, loc, scene, scope, span)
    check_bodies(theme, loc, scene)
    check_same(theme, loc, scene)
    if loc.rel == "off" and getattr(loc.landmark, "op", "") == "then":  # "take blue off it, then green"
        raise refuse("ambiguous", "is it taken off that next, or is that taken off next?", loc.span,
                     "say 'then take ... off'")  # fmt: skip
    denied = loc.negated or scene.denying
    none = theme.quant is not None and theme.quant.high == 0
    check_further(theme, loc.landmark, scene, denied or none)
    if not denied and (others := none_of_others(theme, loc.landmark)) is not None:
        return negation(_loc(theme, replace(loc, landmark=others, negated=True), scene, scope, span), span)
    if len(theme.names) > 1 and among_themselves(theme, loc.landmark, scene, denied or none):
        mutual = denied or theme.quant is not None
        return to_each_other(theme, loc, scene, span) if mutual else to_others(theme, loc, span)
    if (apart_from := none_another(theme, loc, scene, span, _relate)) is not None:
        return apart_from
    if (alone := by_itself(theme, loc, scene, scope, span)) is not None:
        return alone
    like = scope.like_patch or (loc.rel in ("on", "in") and like_the_last(loc, scene))
    if (apart := on_separate_patches(theme, loc, scene, scope, span)) is not None:
        return apart
    if (found := _any_of_them(theme, loc, scene)) is not None:
        if theme.quant is not None:
            return [_some_on_any(theme, theme.quant, found, loc, scene, span)]
        units = [Ref(names=(n,)) for n in theme.names]
        if isinstance(loc.landmark, Noun) and loc.landmark.traits.scheme == "different":
            if len(found) != len(units):
                raise refuse("count-mismatch", "there are not as many of both", loc.span, "name as many of both")
            return [_relate(one, Ref(names=(m,)), loc, scene, span) for one, m in zip(units, found, strict=True)]
        return [
            conj([disj([_relate(one, Ref(names=(m,)), loc, scene, span) for m in found], span) for one in units], span)
        ]
    loc = on_any_patch(loc, theme, scene, scope, denied=denied or none)
    rel = f"not {loc.rel}" if none or denied else loc.rel
    there = replace(scope, role="landmark", like_patch=like and loc.rel in ("on", "in"), pool=(), need=None, rel=rel)
    mark = off_what(theme, loc, scene) or refer(loc.landmark, scene, there)  # type: ignore[arg-type]
    return related(theme, mark, loc, scene, span)


_UPRIGHT = ("on", "above", "under")


def _any_of_them(theme: Ref, loc: Loc, scene: Scene) -> tuple[str, ...] | None:
    """ "every red block is beside a blue one": any of the blue ones, for each of the red."""
    mark = loc.landmark
    if not isinstance(mark, Noun) or mark.det != "a" or mark.head == "patch" or theme.built:
        return None
    denied = loc.negated or scene.denying  # "not next to a blue one": to none of them
    if len(theme.names) < 2 and not denied:
        return None
    there = [t.name for t in matching(mark.traits, scene, False) if t.declared or denied]
    plain = not mark.conditions and mark.traits.rank is None
    if theme.quant is not None and not plain:
        return None
    if not there and theme.each and theme.quant is None and plain and not compared(mark):
        there = one_for_each(theme, mark, scene)
    return tuple(there) if len(there) > 1 and loc.rel in (*DIRECTIONS, *LEVEL, *_UPRIGHT, "distance") else None


def _some_on_any(theme: Ref, quant: Amount, marks: tuple[str, ...], loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """ "exactly one of the three green blocks is on a black block": on any of the black ones."""

    def to_any(a: Operand) -> g.Goal:
        if loc.rel == "on":
            return disj([r.On(a=a, b=(m,), span=span) for m in marks], span)
        return disj([_relate(Ref(names=a), Ref(names=(m,)), loc, scene, span) for m in marks], span)  # type: ignore[arg-type]

    return count(theme.names, quant, to_any, span)


def related(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms:
    """The goals of a relation between what is known already."""
    if theme.patch and not mark.table and not mark.patch:
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", span, "move blocks instead")
    if mark.mixed or (theme.mixed and mark.reciprocal):
        raise refuse("ambiguous", "it is not said which of the blocks are meant", loc.span, "name the blocks")
    if mark.reciprocal:
        _groups_or_blocks(theme, loc, scene)
        found = to_each_other(of_the_towers(theme, loc, scene), loc, scene, span)
        if loc.rel == "together" and not (loc.negated or scene.denying or theme.built):
            scene.add_built("pile", theme.names, False, span)
        return found
    if theme.op == "nor":
        return [x for part in theme.parts for x in negation(related(part, mark, loc, scene, span), span)]
    if mark.op == "nor":
        return [x for part in mark.parts for x in negation(related(theme, part, loc, scene, span), span)]
    if (pairs := one_and_all(theme, mark, loc, scene)) is not None:
        return [x for one, other in pairs for x in related(one, other, loc, scene, span)]
    if mark.table:
        theme = only_on_table(theme, loc, scene) if theme.op == "only" else theme
        return [on_the_table(theme, loc, scene, span)]
    if (shared := each_its_own(theme, mark, loc, scene)) is not None:
        return [x for one, other in shared for x in related(one, other, loc, scene, span)]
    if loc.rel in ("between", "sandwiched", "flank"):
        theme = only_between(theme, mark, loc, scene) if theme.op == "only" else theme
        return [(flanked if loc.rel == "flank" else between)(theme, mark, loc, scene, span)]
    none = theme.everything and theme.quant is not None and theme.quant.high == 0
    if none and loc.rel in ("on", "above") and not mark.patch:
        return [r.Clear(a=crown(mark), span=span)]
    if theme.everything and theme.quant and mark.patch and not mark.matching and loc.rel in ("on", "above", "in"):
        return [r.Empty(patch=p, span=span) for p in mark.names]
    if mark.op == "except":
        mark = any_of_the_rest(mark, loc)
    theme = all_others(theme, mark, loc, scene)
    _check_self(theme, mark, loc)
    if "outside" in loc.mods and not mark.patch and not any(b.kind == "stack" for b in mark.built):
        raise refuse("misplaced", "this is no patch that something could be out of", loc.span, "say 'not next to ...'")
    if loc.rel == "off" and "leaving" in loc.mods:
        begins_on(theme, mark, scene, span)
    if "only" in (theme.op, mark.op):
        theme, mark = alone_there(theme, mark, loc, scene, _relate)
    if mark.matching and loc.rel == "off":
        raise off_which(loc.span)
    if mark.matching:
        if loc.rel not in ("on", "in", "above"):
            raise refuse("misplaced", "blocks match the patches that they are on", loc.span, "say 'on'")
        return matching_patches(theme, mark, scene, span)
    if loc.rel == "in" and not mark.patch:
        raise refuse("misplaced", "blocks are solid: nothing can be put in one", loc.span, "say 'on' or 'next to'")
    if mark.patch:
        return _patch(theme, mark, loc, scene, span)
    return [_landmarks(theme, mark, loc, scene, span)]


def _groups_or_blocks(theme: Ref, loc: Loc, scene: Scene) -> None:
    """ "Separate the red and the blue blocks. They are 10 cm apart.": the groups, or every two blocks?"""
    inside = [b for b in scene.built if b.kind == "pile" and set(b.members) < set(theme.names)]
    if not theme.built and loc.rel in ("distance", "apart") and len(inside) > 1:
        raise refuse("ambiguous", "the groups, or every two of the blocks?", loc.span, "say 'the groups'")


def _check_self(theme: Ref, mark: Ref, loc: Loc) -> None:
    if mark.built and len(theme.built) > 1 and set(mark.names) < set(theme.names):
        raise refuse("misplaced", "this is one of the structures themselves", loc.span, "say it of the other one")
    shared = set(theme.names) & set(mark.names)
    if mark.built and any(part.names == mark.names for part in theme.parts):
        raise refuse("self-reference", "a structure cannot be placed relative to itself", loc.span, "use two sentences")
    inside = {b.kind for b in mark.built} & {"row", "line", "column"} and len(mark.built) == 1 and not theme.built
    if inside and shared == set(theme.names) < set(mark.names) and loc.rel in ("front", "behind", "distance", *LEVEL):
        told = "nothing is placed relative to itself: this is one of the blocks of the row"
        raise refuse("ambiguous", told, loc.span, "name the other blocks of the row, or say at which end")
    parts = (mark.built or theme.built) and theme.names != mark.names
    if shared and not theme.quant and not mark.quant and not parts:
        raise refuse("self-reference", "a block cannot be placed relative to itself", loc.span, "name another block")


def _landmarks(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """One relation, over alternatives, each-to-each pairs and counts of the landmark."""
    if mark.op == "or" and theme.each and not theme.built and len(theme.names) > 1:
        return conj([_landmarks(Ref(names=(n,)), mark, loc, scene, span) for n in theme.names], span)
    if mark.op == "or":
        return disj([_landmarks(theme, part, loc, scene, span) for part in mark.parts], span)
    mark = one_on_one(theme, far_from_any(mark, loc), loc)
    if first_of_all(theme, mark, loc):
        return spread(theme, lambda a: _landmarks(Ref(names=tuple(a)), mark, loc, scene, span), span)  # type: ignore[arg-type]
    if (quant := mark.quant) is not None:
        if loc.rel == "on":
            check_one_on_many(theme, quant)
        return count(mark.names, quant, lambda b: _relate(theme, Ref(names=tuple(b)), loc, scene, span), span)  # type: ignore[arg-type]
    each = getattr(loc.landmark, "word", "") in ("each", "each one", "each of them")
    if each and loc.rel == "on" and len(mark.built) == 1 and mark.built[0].kind == "stack":
        raise refuse("ambiguous", "only the top one of these blocks has room on it", loc.span, "say 'on top of it'")
    one_each = (each or mark.each) and len(mark.built) > 1
    if loc.rel == "on" and (mark.each or each) and theme.built and len(mark.names) > 1 and not mark.built:
        raise refuse("ambiguous", "one tower on all of these, or one on each?", loc.span, EACH_TOWER)
    if (one_each or first_and_last(loc.landmark)) and loc.rel != "on" and indefinite(theme) and len(theme.names) == 1:
        raise which_one("one for all of them, or one for each?", loc.span, "name the one of each")
    marks = [mark] if mark.each and indefinite(theme) else one_by_one(mark, loc, scene)
    if len(marks) > 1 and (theme.op in ("or", "xor") or (theme.quant is not None and theme.quant.high != 0)):
        raise refuse("ambiguous", "it is not clear which of them is meant by each", loc.span, "use two sentences")
    return conj([_relate(theme, part, loc, scene, span) for part in marks], span)


def _relate(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    single = not mark.built or (len(mark.built) == 1 and mark.built[0].kind in ("row", "line", "column", "word"))
    if mark.each and len(mark.names) > 1 and single and indefinite(theme) and not theme.built:
        loc = along_a_line(mark, loc, scene)
        if loc.rel in DIRECTIONS and not {"directly", "immediate"} & set(loc.mods):
            raise refuse("ambiguous", "one for all of them, or one for each?", loc.span, "name the one of each")
        lots = one_lot_each(theme, len(mark.names), scene)
        pairs = zip(lots, mark.names, strict=True)
        if (len(lots[0]) == 1 or loc.rel != "on") and theme.quant is None:
            return conj([_relate(Ref(names=lot), Ref(names=(b,)), loc, scene, span) for lot, b in pairs], span)
    several = len(mark.built) > 1 and (mark.each or mark.det in ("both", "all")) and not theme.built
    if several and loc.rel == "on" and indefinite(theme) and theme.quant is None:  # "a block on each tower"
        lots = one_lot_each(theme, len(mark.built), scene)
        tops = [Ref(names=tower.members, built=(tower,)) for tower in mark.built]
        each = zip(lots, tops, strict=True)
        return conj([_relate(Ref(names=lot), top, loc, scene, span) for lot, top in each], span)
    if loc.rel in _UPRIGHT:
        return conj([vertical(theme, mark, loc, scene, span), *centred_on(theme, mark, loc, span)], span)
    if loc.rel in DIRECTIONS:
        return _directional(theme, mark, loc, scene, span)
    together = bool(theme.built) and not (len(theme.built) == 1 and theme.built[0].kind == "stack")
    b = carrier(foot(mark), scene, level=True) if "level" in loc.mods else foot(mark)
    if loc.rel == "distance":
        return spread(theme,
                      lambda a: r.Distance(a=a, b=b, minimum=loc.low, maximum=loc.high, measure=measure(loc),
                                           span=span), span, together)  # fmt: skip
    if loc.rel in LEVEL:
        node = LEVEL[loc.rel]
        if loc.rel == "beside" and "immediate" in loc.mods:
            node = r.Adjacent
        if loc.rel == "touching":
            return spread(theme, lambda a: node(a=a, b=b, span=span), span, together=bool(theme.built))
        b = carrier(foot(mark), scene, level=loc.rel in ("beside", "adjacent"))

        def level(a: Operand) -> g.Goal:
            below = carrier(a, scene, moved=True)
            ends = (a, foot(mark)) if below == b else (below, b)  # in one tower it is said of the two themselves
            found: g.Goal = node(a=ends[0], b=ends[1], span=span)
            return found

        return spread(theme, level, span, together=together)
    if loc.rel == "off":
        note_taken(theme, mark, scene)
        return conj([taken_off(theme, n, span) for n in mark.names if n not in theme.names], span)
    if loc.rel == "together":
        return s.GroupBy(groups=((*theme.names, *mark.names),), span=span)
    raise refuse("misplaced", "this relation does not fit here", loc.span)


def _directional(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    node = DIRECTIONS[loc.rel]
    b = foot(mark)
    flags: dict[str, Any] = {"directly": bool({"directly", "immediate"} & set(loc.mods)),
                             "immediate": "immediate" in loc.mods, "somewhere": "somewhere" in loc.mods}  # fmt: skip
    if theme.quant is not None or theme.op in ("or", "xor", "except") or theme.mixed:

        def far(a: Operand) -> g.Goal:
            return conj([node(a=a, b=b, span=span, **flags), *so_far(a, b, loc, span)], span)

        return spread(theme, far, span)
    goal = node(a=carrier(foot(theme), scene, moved=True), b=b if mark.patch else carrier(b, scene), span=span, **flags)
    return conj([goal, *so_far(foot(theme), b, loc, span)], span)


def _patch(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms:
    patches = mark.names
    if "side" in loc.mods:
        told = f"the {loc.rel} side of a patch could be a part of it or the table beside it"
        raise refuse("ambiguous", told, loc.span, f"say 'on the patch' or 'to the {loc.rel} of the patch'")
    if loc.rel == "off":
        return [spread(theme, lambda a: off_patches(a, patches, span), span)]
    if loc.rel in ("on", "above", "in"):
        if mark.part == "middle":
            if isinstance(lowest := foot(theme), tuple) and len(lowest) != 1:
                raise refuse("ambiguous", "only one block fits in the middle of a patch", span, "name one block")
            near = r.Distance(a=lowest, b=patches, maximum=loc.high or PATCH_MIDDLE, span=span)
            return [on_patches(theme, mark, scene, span), near]
        return [on_just_one(theme, mark, loc, scene, span) or on_patches(theme, mark, scene, span)]
    if loc.rel in ("left", "right", "front", "behind", "near", "apart", "beside", "adjacent", "distance"):
        return [_landmarks(theme, mark, loc, scene, span)]
    raise refuse("misplaced", "this relation does not fit a patch", loc.span, "say 'on' or 'next to'")
