"""Places of a clause: where its theme goes, and what is said of further blocks."""

from __future__ import annotations

import itertools

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import Lowest
from rpg.language.meaning import (
    Amount,
    At,
    Clause,
    Coord,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    TableTop,
    replace,
)
from rpg.passes.schema.resolve.clauses.between_two import so_many_between
from rpg.passes.schema.resolve.clauses.spec import Spec, sort_adjuncts
from rpg.passes.schema.resolve.clauses.spun import spun
from rpg.passes.schema.resolve.goals.logic import negation
from rpg.passes.schema.resolve.orders.loose import each_alone
from rpg.passes.schema.resolve.orders.onward import in_between
from rpg.passes.schema.resolve.places.across_the_table import table_sides
from rpg.passes.schema.resolve.places.centred import centred
from rpg.passes.schema.resolve.places.middles import beside_another, set_apart
from rpg.passes.schema.resolve.places.mutual import of_the_other
from rpg.passes.schema.resolve.places.none_there import none_there
from rpg.passes.schema.resolve.places.patches import dealt, matching_patches
from rpg.passes.schema.resolve.places.pointed import of_a_part, of_its_own_corner, of_the_nearest, onto_a_list, whom
from rpg.passes.schema.resolve.places.relations import place, related
from rpg.passes.schema.resolve.places.stacking import piled_on, stands_on
from rpg.passes.schema.resolve.things.operands import UPRIGHT, crown, foot
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spare import definite, further, known, pass_over
from rpg.passes.schema.resolve.things.spoken import as_it_stands
from rpg.passes.schema.resolve.things.things import alike, of_no_look
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse, which_one

Goals = list[g.Goal]
CHAINED = ("left", "right", "front", "behind", "above", "under", "beside", "adjacent", "touching", "near")


def distractors(clause: Clause, spec: Spec, scene: Scene) -> bool:
    """Blocks that are only there: "with two extra blue blocks", "a purple block lies around as a distractor"."""
    for using in list(spec.usings):
        if is_extra(using.members):
            refer(using.members, scene, Scope())
            scene.mentions.pop()
            spec.usings.remove(using)
            if clause.verb not in ("be", "exist"):
                spec.manner("extra")
    for item in list(spec.absolutes):
        table = all(isinstance(a, Manner) or isinstance(getattr(a, "landmark", None), TableTop) for a in item.adjuncts)
        told = is_extra(item.theme) or any(isinstance(a, Manner) and a.kind == "extra" for a in item.adjuncts)
        if table and told:
            refer(as_extra(item.theme), scene, Scope())
            scene.mentions.pop()
            spec.absolutes.remove(item)
    for place_ in list(spec.places):
        mark = place_.landmark if isinstance(place_, Loc) and place_.rel == "between" else None
        if mark is not None and is_extra(mark):
            refer(mark, scene, Scope())
            scene.mentions.pop()
            spec.places.remove(place_)
    if clause.verb not in ("be", "exist") or clause.theme is None or is_shape(clause.theme):
        return False
    marked = spec.manner("extra")
    lying = _on_the_table(spec) and not clause.negated and is_extra(clause.theme) and not definite(clause.theme)
    if marked is None and not lying:
        return False
    if marked is not None and marked.value == "around" and clause.verb == "be" and clause.word and not clause.lemma:
        raise refuse("misplaced", "'there' is no place of its own here", marked.span, "name the place")
    if (
        marked is not None
        and marked.value == "around"
        and not is_extra(clause.theme)
        and not definite(clause.theme)
        and not further(clause.theme)
    ):
        refer(clause.theme, scene, Scope(given=True, start=True))
        for name in scene.mentions.pop().ref.names:
            scene.things[name].declared = True
        return True
    if clause.negated:
        raise refuse("misplaced", "it is said what these blocks are not, but not where they should be", clause.span,
                     "say where they should be")  # fmt: skip
    pass_over(refer(clause.theme if known(clause.theme, scene) else as_extra(clause.theme), scene, Scope()), scene)
    about = [p for p in spec.places if isinstance(p, Loc) and isinstance(p.landmark, TableTop)]
    about = [p for p in about if p.rel not in ("left", "right", "front", "behind")]
    spec.places = [p for p in spec.places if p not in about]
    return True


def _on_the_table(spec: Spec) -> bool:
    """ "A green distractor lies on the table": where it is anyway, and nothing else is said of it."""
    spots = [x for x in spec.places if isinstance(x, Loc) and x.rel == "on" and isinstance(x.landmark, TableTop)]
    return bool(spots) and len(spots) == len(spec.places) and not any(x.negated for x in spots)


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


def places(ref: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """Every place of the clause, for the theme or the structure it became."""
    goals: Goals = []
    _merge_sides(spec)
    of_the_other(ref, spec)
    _no_chain(spec)
    if (none := none_there(ref, spec, scene, scope, span, place)) is not None:
        return none
    upright = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("on", "above", "under")]
    # "Near white, but not on it": of white, which has to be spoken of first.
    vertical = [p for p in upright if not isinstance(p.landmark, Pronoun) or p == spec.places[0]]
    offsets = [p for p in spec.places if isinstance(p, Loc) and p.rel == "offset"]
    level = [p for p in spec.places if p not in vertical and p not in offsets]
    scene.alike = (paired := spec.manner("respectively")) is not None and paired.value == "alike"
    for item in [*vertical, *level]:
        if isinstance(item, Loc) and item.rel == "heaped":
            if len(ref.built) > 1 or any(b.kind not in ("stack", "word") for b in ref.built):
                raise refuse("ambiguous", "it is not clear which block goes on which", item.span,
                             "say what goes on what")  # fmt: skip
            continue
        goals += _place_one(ref, item, scene, scope, span, paired is not None)
    spec.places = [*offsets]
    goals += centred(spec, scene, span, ref.names)
    if ref.built and goals and not scope.start and not scene.denying:
        goals = [*as_it_stands(ref, scene), *goals]
    return [goal for goal in goals if not (isinstance(goal, g.All) and not goal.goals)]


def _no_chain(spec: Spec) -> None:
    """ "A left of B left of C", "on B or C on D", with nothing between: of B, or of A? Nor "on B and on the table"."""
    for one, two in itertools.pairwise(p for p in spec.places if isinstance(p, Loc)):
        gap = two.span[0] - one.span[1]
        onto = onto_a_list(one, two)
        if one.rel == two.rel and (one.rel in CHAINED or onto) and 0 <= gap <= 1:
            raise refuse("misplaced", "it is not clear what this is said of", two.span, "say 'and', or two sentences")
        on = one.rel == two.rel == "on" and isinstance(one.landmark, Noun) and one.landmark.head != "patch"
        close = len(" and") < gap and (gap < len(" together with") or "directly" in two.mods)
        if on and isinstance(two.landmark, TableTop) and close:
            raise refuse("contradiction", "what is on a block is not on the table", two.span, "say which one is there")


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
            mark = close.landmark
            if isinstance(mark, Noun) and mark.amount == Amount(1, 1):
                close = replace(close, landmark=replace(mark, det="the", amount=None))
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
            raise refuse("count-mismatch", f"'respectively' pairs {len(ref.names)} with {len(mark.names)}", item.span,
                         "list as many of both", left=len(ref.names), right=len(mark.names))  # fmt: skip
        if scene.alike and mark.patch:
            return [dealt([(name,) for name in ref.names], mark.names, where)]
        one_sort = any(alike([scene.things[n] for n in x.names]) for x in (ref, mark))
        looks = {(t.color, t.label, t.kind) for t in (scene.things[n] for n in (*ref.names, *mark.names))}
        if scene.alike and not one_sort and looks == {(None, None, None)}:
            return place(ref, item, scene, scope, where)  # "the two small ones on the two big ones, one on each"
        if scene.alike and not one_sort:
            raise refuse("ambiguous", "it is not said which goes on which", item.span, "name what each goes on")
        goals: Goals = []
        for a, b in zip(ref.names, mark.names, strict=True):
            single = replace(item, landmark=Pronoun(word="@" + b, span=item.span))
            one, other = Ref(names=(a,), span=ref.span), Ref(names=(b,), patch=mark.patch, span=mark.span)
            goals += related(one, other, single, scene, where)
        return goals
    return place(ref, item, scene, scope, where)


def _tower_patch(ref: Ref, item: Loc, scene: Scene, scope: Scope, span: Span) -> Goals | None:
    """A structure on patches: one patch for all, or a matching one for each tower."""
    landmark = item.landmark
    if len(ref.built) > 1 and isinstance(landmark, Noun) and landmark.traits.scheme == "different":
        return None
    stack = len(ref.built) == 1 and ref.built[0].kind == "stack"
    if stack and isinstance(landmark, Noun) and landmark.plural and landmark.traits.scheme == "different":
        raise refuse("contradiction", "one tower does not stand on several patches", item.span,
                     "say 'make a tower of each color'")  # fmt: skip
    if isinstance(landmark, Noun) and (
        landmark.traits.matching
        or (landmark.head == "patch" and landmark.traits.scheme in ("some", "different") and not landmark.traits.colors)
    ):
        return matching_patches(ref, Ref(patch=True, matching=True), scene, span)
    return None


def loose_ats(ref: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """ "on the left", "at the bottom" with no structure in the clause: settled once all clauses are read."""
    if (ref.op == "except" or scope.start) and (regions := table_sides(spec.ats)) and not scene.built:
        spec.ats = []
        return [goal for region in regions for goal in place(ref, region, scene, scope, span)]
    one_of_them = ref.op in ("or", "xor") and all(len(part.names) == 1 for part in ref.parts) and len(spec.ats) == 1
    none = ref.quant is not None and ref.quant.high == 0 and not (scene.denying or ref.built or ref.everything)
    if (ref.op not in ("and", "nor") and not one_of_them) or (ref.quant is not None and not none):
        raise refuse("ambiguous", "it is not clear which block is meant", ref.span, "name one block")
    if ref.op == "nor" or none:
        scene.denied += [one for at_ in spec.ats for one in each_alone((ref, at_, span))]
    else:
        scene.loose += [(ref, at_, span) for at_ in spec.ats]
    spec.ats = []
    return [g.All(goals=())]


def parts_alone(spec: Spec, scene: Scene, scope: Scope, span: Span) -> Goals:
    """ "red leftmost, then blue, green rightmost": places with no structure, settled once all clauses are read."""
    goals: Goals = []
    spec.absolutes = in_between(spec.absolutes)
    blocks = [part for part in spec.absolutes if isinstance(part.adjuncts[0], At) and not is_shape(part.theme)]
    if not blocks or len(blocks) < len(spec.absolutes) or scene.built:
        raise refuse("no-referent", "it is not clear of which structure this is a part", span,
                     "say it in the sentence that builds the structure")  # fmt: skip
    for part in spec.absolutes:
        inner = sort_adjuncts(part.adjuncts)
        goals += loose_ats(refer(part.theme, scene, replace(scope, role="theme")), inner, scene, scope, part.span)
    spec.absolutes = []
    return goals


def absolutes(ref: Ref, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "with a red block next to it", "with the letter A on top": further conditions, or parts of the structure."""
    goals: Goals = []
    last: Ref | None = None
    for item in spec.absolutes:
        if is_extra(item.theme):
            placed = [a for a in item.adjuncts if not isinstance(getattr(a, "landmark", None), TableTop)]
            if any(not isinstance(a, Manner) for a in placed):
                raise refuse("misplaced", "distractors lie anywhere", item.span, "say only what they look like")
            refer(item.theme, scene, Scope())
            scene.mentions.pop()
            continue
        apart = set_apart(ref, item)
        own = ref.names if len(ref.names) > 1 and of_no_look(item.theme) and not apart else ()
        theme = refer(so_many_between(item, scene), scene, replace(scope, role="theme", pool=own))
        made_up = ref.built and any(scene.things[n].invented for n in ref.names)
        if made_up and not apart and not set(theme.names) & set(ref.names):
            raise which_one("it is not clear which blocks the structure is made of", item.span, "name its blocks")
        inner = sort_adjuncts(item.adjuncts)
        if any(m.kind in ("turn", "facing", "by", "by?") for m in inner.manners):
            goals += _turned(theme, ref, inner, scene, item.span)
        for part in inner.parts:
            raise refuse("misplaced", "the structure has no such part", part.span, "name its blocks one by one")
        of_its_own_corner(theme, ref, inner)
        _merge_sides(inner)
        goals += _at_its_ends(theme, ref, inner, scene, item.span)
        if inner.ats and ref.built and not set(theme.names) & set(ref.names):
            raise refuse("misplaced", "this place does not fit the structure", inner.ats[0].span,
                         "say 'on top', or name the block among its members")  # fmt: skip
        several = len(ref.names) > 1 or beside_another(inner.ats, scene)
        if inner.ats and several and not set(theme.names) & set(ref.names):
            raise refuse("ambiguous", "it is not clear of what this is a part", inner.ats[0].span, "say where it is")
        if inner.ats:
            goals += loose_ats(theme, inner, scene, scope, item.span)
        for adjunct in inner.places:
            mark = getattr(adjunct, "landmark", None)
            pointed = isinstance(adjunct, Loc) and not _off_it(adjunct, scene)
            if isinstance(mark, Pronoun) and mark.word in _POINTED and pointed and isinstance(adjunct, Loc):
                of_a_part(ref, theme, mark, adjunct, spec.absolutes)
                of_the_nearest(item, mark, adjunct, scene)
                nothing = theme.everything and theme.quant is not None and adjunct.rel != "between"
                marked = any(m.role == "landmark" and m.clause == scene.clause for m in scene.mentions)
                if (nothing or adjunct.negated) and marked:
                    raise refuse("ambiguous", f"it is not clear what {mark.word!r} is", mark.span, "name what you mean")
                that = last if mark.word == "that" and last is not None else whom(ref, last, mark, adjunct, scene)
                found = related(theme, that, adjunct, scene, item.span)
                goals += negation(found, item.span) if adjunct.negated else found
            else:
                before = len(scene.things)
                scene.named_again(item.theme, theme)
                goals += place(theme, adjunct, scene, scope, item.span)
                _among_members(ref, theme, before, scene, item.span)
        last = theme
    spec.absolutes = []
    return goals


def _off_it(place: Loc, scene: Scene) -> bool:
    """ "the red one on the mat and the blue one off it": off the mat."""
    return place.rel == "off" and any(m.ref.patch and m.clause == scene.clause for m in scene.mentions)


def _at_its_ends(theme: Ref, ref: Ref, inner: Spec, scene: Scene, span: Span) -> Goals:
    """What is on top or at the bottom of the structure, or on the one block that was put somewhere."""
    goals: Goals = []
    for at_ in list(inner.ats):
        further = not set(theme.names) & set(ref.names) and at_.index is None
        if len(ref.built) == 1 and further and at_.side in ("top", "bottom"):
            inner.ats.remove(at_)
            goals += _at_end(theme, ref, at_, scene, span)
        elif at_.side == "top" and further and stands_on(ref, theme, scene):
            inner.ats.remove(at_)
            goals += related(theme, ref, Loc(rel="on", span=at_.span), scene, span)
    return goals


_POINTED = ("it", "them", "that", "both", "both of them")


def _among_members(ref: Ref, theme: Ref, before: int, scene: Scene, span: Span) -> None:
    """ "a column of three with the red one between two blue ones": the blue ones could be among the three."""
    inside = ref.built and set(theme.names) < set(ref.names)
    further = any(not thing.patch for thing in list(scene.things.values())[before:])
    looks = ((scene.things[n].color, scene.things[n].label) for n in ref.names)
    if inside and further and (None, None) in looks:
        raise refuse("ambiguous", "these could be blocks of the structure or further ones", span, "name its blocks")


def _turned(theme: Ref, ref: Ref, inner: Spec, scene: Scene, span: Span) -> Goals:
    """ "with the U upside down", "with the letters facing up"."""
    from rpg.passes.schema.resolve.clauses.orientation import others_not_turned, turn_of
    from rpg.passes.schema.resolve.clauses.turns import pointing

    if theme.quant is not None or theme.patch or not theme.names:
        raise refuse("ambiguous", "it is not clear which block is turned", span, "name the block")
    facing = next((m for m in inner.manners if m.kind == "facing"), None)
    flat = next((m for m in inner.manners if m.kind == "turn"), None)
    if (by := next((m for m in inner.manners if m.kind in ("by", "by?")), None)) is not None:
        inner.manners = [m for m in inner.manners if m is not by]
        turned = [spun(name, by, True, scene, span) for name in theme.names]
        if facing is not None or flat is not None or None in turned:
            raise refuse("misplaced", "it is not clear from where on this is turned", span, "say it in a sentence")
        return [x for x in turned if x is not None]
    inner.manners = [m for m in inner.manners if m not in (facing, flat)]
    if facing is not None and theme.part == "top":
        return pointing(theme, facing, flat, scene, span)
    word = any(b.kind in ("word", "equation") and set(theme.names) <= set(b.members) for b in ref.built)
    if word and flat is None and facing is not None and facing.value == "up":
        return []
    others = others_not_turned(theme, ref.names, facing, flat, scene, span)
    return [*(turn_of(name, facing, flat, scene, span) for name in theme.names), *others]


def _at_end(theme: Ref, ref: Ref, at_: At, scene: Scene, span: Span) -> Goals:
    """A further block on top of a structure, or under it."""
    if at_.side == "top":
        if ref.built[0].kind not in UPRIGHT and len(ref.names) > 1:
            raise refuse("ambiguous", "it is not clear on which of the blocks this goes", at_.span, "name the block")
        return [piled_on(theme.names, crown(ref), scene, span)]
    if ref.built[0].kind != "stack" or len(theme.names) != 1:
        raise refuse("misplaced", "nothing goes under this", at_.span, "count the block among its members")
    return [r.On(a=foot(ref) if ref.built[0].ordered else Lowest(lowest=ref.names), b=theme.names, span=span)]


def is_shape(theme: Meaning | None) -> bool:
    return any(isinstance(item, Structure) for item in (theme.items if isinstance(theme, Coord) else (theme,)))
