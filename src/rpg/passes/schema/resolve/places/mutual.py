"""Relations of blocks to each other: "next to each other", "5 cm apart"."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations, pairwise, permutations
from typing import Any

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Operand
from rpg.language.meaning import Amount, Loc, Meaning, Noun, Pronoun, Structure, TableTop, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj, negation
from rpg.passes.schema.resolve.structures.towers_apart import tell_apart
from rpg.passes.schema.resolve.things.operands import DIRECTIONS, LEVEL, foot
from rpg.passes.schema.resolve.things.things import create, fits, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

Relate = Callable[[Ref, Ref, Loc, Scene, Span], g.Goal]

MOST_EQUALLY_FAR = 3
"""Blocks on a table of which every two can be equally far from each other."""
MOST_CHAINED = 4
"""Structures that may stand side by side in any order."""


def one_for_each(theme: Ref, mark: Noun, scene: Scene) -> list[str]:
    """ "Each red block is on a blue one": one of the blue blocks spoken of, else as many of them as of the red ones."""
    known = [t.name for t in matching(mark.traits, scene, False) if t.name not in theme.names and not t.extra]
    told = any(m.clause < scene.clause and set(theme.names) <= set(m.ref.names) for m in scene.mentions)
    if len(known) == 1 or (known and mark.head == "block" and not told):
        raise refuse("ambiguous", "this could be one of the blocks before it, or a further one", mark.span,
                     "say 'one of them', or 'another'")  # fmt: skip
    if not known:
        scene.new_batch()
    return known or [create(mark.traits, scene, False).name for _ in theme.names]


def reciprocal(theme: Ref, loc: Loc, span: Span, *, denied: bool = False) -> Atoms:
    """ "next to each other", "5 cm apart", "on top of each other". `denied`: what comes of it is denied."""
    names = theme.names
    if isinstance(loc.landmark, Pronoun) and loc.landmark.word in ("itself", "themselves") and loc.rel != "heaped":
        alone = "say from what it is to be apart" if loc.rel == "beside" else "name another block"
        raise refuse("self-reference", "nothing is placed relative to itself", loc.span, alone)
    if theme.patch:
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", span, "move blocks instead")
    if theme.quant is not None and theme.quant.low == 0 and theme.quant.high in (0, 1) and len(names) > 1:
        return _none_of_them(theme, loc, span)
    if len(names) < 2:
        raise refuse("no-referent", "one block alone has no other to relate to", loc.span, "name at least two blocks")
    if any(b.kind == "towers" for b in theme.built):
        raise refuse(
            "ambiguous", "it is not clear which block is in which tower", loc.span, "name the towers one by one"
        )
    if denied and loc.rel not in ("together", "one_behind") and theme.quant is None and len(theme.built) < 2:
        return of_every_two(names, loc, span)
    units = _units(theme)
    if loc.rel == "distance":
        return _distances(theme, units, loc, span)
    if loc.rel in ("near", "apart"):
        return [LEVEL[loc.rel](a=a, b=b, span=span) for a, b in combinations(units, 2)]
    return [_close(names, units, loc, span)]


def some_other(theme: Ref, loc: Loc, span: Span) -> Atoms:
    """ "Every block touches another block": each of them some other one, not every two each other."""
    if len(theme.names) == 2 or loc.rel == "apart":
        return reciprocal(theme, loc, span)
    if loc.rel not in LEVEL or theme.built or theme.patch or len(theme.names) > MOST_CHAINED:
        raise refuse("misplaced", "this is not understood of each of so many blocks", loc.span, "name the blocks")
    pairs = {two: conj(reciprocal(Ref(names=two), loc, span), span) for two in combinations(theme.names, 2)}
    return [disj([goal for two, goal in pairs.items() if name in two], span) for name in theme.names]


_LEVEL = frozenset({"distance", "apart", "side_by_side", "beside", "adjacent", "near", "touching"})


def of_the_towers(theme: Ref, loc: Loc, scene: Scene) -> Ref:
    """ "Make a red tower. Make a blue tower. 10 cm between them": said of both towers."""
    if any(b.kind == "towers" for b in theme.built):
        tell_apart(Structure(kind="stack", det="the", plural=True, span=theme.span), scene)
        apart = tuple(b for b in scene.built if b.kind == "stack" and {*b.members} < {*theme.names})
        return replace(theme, built=apart) if {n for b in apart for n in b.members} == {*theme.names} else theme
    stacks = [b for b in scene.built if b.kind == "stack" and len(b.members) > 1]
    own = [b for b in stacks if set(theme.names) == set(b.members)]
    piles = [{*x.blocks} for x in scene.start_goals if isinstance(x, s.Stack)]
    begun = bool(own) and ({*own[0].members} in piles or {*own[0].members[1:]} <= scene.begun_on)
    # Of a tower of the start blocks are said anything.
    several = len(theme.parts) > 1 or len(theme.built) > 1 or theme.quant is not None
    if not own or begun or loc.rel not in _LEVEL or several:
        return theme
    if len(stacks) == 2:
        names = tuple(n for b in stacks for n in b.members)
        return Ref(names=names, built=tuple(stacks), plural=True, span=theme.span)
    if loc.rel in ("distance", "apart"):
        raise refuse("ambiguous", "blocks of one tower lie on each other", loc.span, "say of what this is said")
    return theme


def of_the_other(ref: Ref, spec: Spec) -> None:
    """What is said of blocks "to each other" beside a place: of one block, it is said of what that is placed by."""
    _gapless(spec)
    _whose_side(spec)
    _which_or_where(ref, spec)
    _alone(ref, spec)
    if len(ref.names) == 1:
        _merge_distance(spec)


def _whose_side(spec: Spec) -> None:
    """Refuse "red is touching blue on its right": on the right of red, or of blue?"""
    for one, two in pairwise(p for p in spec.places if isinstance(p, Loc)):
        its = isinstance(two.landmark, Pronoun) and two.landmark.word == "it" and two.rel in ("left", "right")
        touched = one.rel == "touching" and isinstance(one.landmark, Noun | Structure)
        if its and touched and two.span[0] - one.span[1] < 2:
            raise refuse("ambiguous", "it is not clear on whose side this is", two.span,
                         "say it of one of the two in a sentence of its own")  # fmt: skip


ALL_OTHERS = {**dict.fromkeys(("the others", "all the others", "all others", "the other ones", "all the rest",
                               "the rest"), None), **dict.fromkeys(("the other", "the other one"), 1),
              "the other two": 2}  # fmt: skip
"""What stands for all others of the blocks that something is said of, and how many that are if it is said."""
COMPARED = frozenset({"closer", "farther", "as_far", "closest", "farthest"})
"""Places that are told by two distances."""


def _which_or_where(ref: Ref, spec: Spec) -> None:
    """Refuse "put the block closer to red than to blue on the mat": which block (or mat) is meant, or where it goes?"""
    told = [p for p in spec.places if isinstance(p, Loc) and p.rel in COMPARED]
    others = [p for p in spec.places if p not in told]
    for place in told if others else ():
        behind = any(isinstance(p, Loc) and p.span[1] + 1 == place.span[0] and not isinstance(p.landmark, TableTop)
                     for p in others)  # fmt: skip
        apposed = ref.span[1] + 1 == place.span[0] and any(p.span[0] == place.span[1] + 1 for p in others)
        if behind or apposed:
            raise refuse("ambiguous", "does this say which one is meant, or where it goes?", place.span,
                         "say it in a sentence of its own")  # fmt: skip


def _alone(ref: Ref, spec: Spec) -> None:
    """ "white in front of black, touching", "a tower of two left of a tower of three, 5 cm apart": of one block, or one
    structure, it is said of what it is placed by."""
    marks = [p.landmark for p in spec.places if isinstance(p, Loc) and not p.negated and not _mutual(p)]
    marks = [mark for mark in marks if not isinstance(mark, TableTop)]  # "touching blue, side by side on the table"
    mark = marks[0] if len(marks) == 1 else None
    one = len(ref.names) == 1 or (len(ref.built) == 1 and ref.built[0].kind == "stack")
    if isinstance(mark, Pronoun) and mark.word in ("it", "them") and one:
        _said_of(mark, spec)
    if not isinstance(mark, Noun | Structure) or getattr(mark, "head", "") == "patch":
        return
    if not one:
        _clear_what_touches(spec)
        return
    if len(ref.names) > 1 and mark.plural:
        return
    _said_of(replace(mark, det="the", amount=None) if mark.amount in (None, Amount(1, 1)) else mark, spec)


def _said_of(mark: Meaning, spec: Spec) -> None:
    """What is said "to each other" is said of this one."""
    spec.places = [
        replace(p, landmark=mark, rel="beside" if p.rel == "side_by_side" else p.rel, mods=(*p.mods, "level"))
        if isinstance(p, Loc) and _mutual(p)
        else p
        for p in spec.places
    ]


def _clear_what_touches(spec: Spec) -> None:
    """Refuse "two red blocks next to two blue ones, touching"."""
    for place in spec.places:
        if isinstance(place, Loc) and _mutual(place) and place.rel == "touching":
            raise refuse("ambiguous", "what touches what: these each other, or what they are placed by?", place.span,
                         "say it in a sentence of its own")  # fmt: skip


def _mutual(place_: Loc) -> bool:
    each_other = isinstance(place_.landmark, Pronoun) and place_.landmark.word == "each other"
    return each_other and place_.rel in ("touching", "adjacent", "distance", "near", "apart", "side_by_side")


def _merge_distance(spec: Spec) -> None:
    """ "left of the blue block, 10 cm apart": so far from the blue block."""
    far = [p for p in spec.places if isinstance(p, Loc) and p.rel == "distance"]
    marks = [p.landmark for p in spec.places if isinstance(p, Loc) and p not in far and not p.negated]
    if len(far) == 1 and len(marks) == 1 and isinstance(far[0].landmark, Pronoun) and isinstance(marks[0], Noun):
        mark = marks[0] if marks[0].det != "a" else replace(marks[0], det="the", amount=None)
        spec.places[spec.places.index(far[0])] = replace(far[0], landmark=mark)


def _gapless(spec: Spec) -> None:
    """ "white left of black, without a gap": of blocks that form nothing, that they touch."""
    near = [p for p in spec.places if isinstance(p, Loc) and not p.negated and p.rel in (*DIRECTIONS, "side_by_side",
            "beside", "adjacent")]  # fmt: skip
    for tight in [x for x in spec.spacings if x.kind == "touching"] if len(near) == 1 and not spec.intos else ():
        spec.spacings.remove(tight)
        each = Pronoun(word="each other", span=tight.span)
        spec.places.append(Loc(rel="touching", landmark=each, span=tight.span))


def among_themselves(theme: Ref, mark: Meaning, scene: Scene, denied: bool) -> bool:
    """ "any of the others", and "another block" behind all of the blocks, or "another red one" behind all red ones."""
    if isinstance(mark, Pronoun):
        alone = all(t.name in theme.names or t.extra for t in scene.blocks())
        if mark.word in ALL_OTHERS and (theme.each or denied) and alone and not theme.everything:
            return ALL_OTHERS[mark.word] in (None, len(theme.names) - 1)
        return mark.word in ("another", "any other", "any other one", "any of the others")
    if not isinstance(mark, Noun) or mark.det not in ("another", "any", "other"):
        return False
    if mark.head == "patch" or _that_other(mark):
        return False
    such = all(fits(scene.things[name], mark.traits) for name in theme.names)
    if not (theme.everything or theme.each) or not such:
        return False
    scene.surveyed.append((mark.traits, theme.names, mark.span))
    return all(t.name in theme.names or t.extra for t in matching(mark.traits, scene, False)) or not denied


def check_further(theme: Ref, mark: Meaning | None, scene: Scene, denied: bool) -> None:
    """Refuse "exactly one of the three red blocks touches another red block": one of the three, or a fourth?"""
    if not isinstance(mark, Noun) or mark.det != "another" or mark.head == "patch" or denied:
        return  # "none of them touches another block": nor any other
    some = theme.quant is not None
    others = set(scene.whole) - set(theme.names) if scene.parted.issuperset(theme.names) else ()
    left = theme.names if some else others
    if any(fits(scene.things[name], mark.traits) for name in left):
        raise refuse("ambiguous", "this could be another one of them, or a further one", mark.span,
                     "name the blocks, or say how many there are in all")  # fmt: skip


def _that_other(mark: Noun) -> bool:
    """ "nothing is on the other": on that one, and not on whichever other there is."""
    return mark.det == "other" and mark.head == "any" and not mark.plural


def _any_such(mark: Noun) -> bool:
    """ "no odd number is on an even one": on any of those there are."""
    plain = mark.traits.rank is None and mark.traits.scheme is None and not mark.traits.matching
    return mark.det == "a" and mark.part_of is None and not mark.conditions and plain


def none_another(theme: Ref, loc: Loc, scene: Scene, span: Span, relate: Relate) -> Atoms | None:
    """ "no blue block touches another block", "red is not on another one": nor any block besides it that there is."""
    if (alone := _touching_none(theme, loc, scene, span, relate)) is not None:
        return alone
    mark, none = loc.landmark, theme.quant is not None and theme.quant.high == 0
    denied = none or ((loc.negated or scene.denying) and theme.quant is None)
    if not denied or not isinstance(mark, Noun) or mark.head == "patch" or _that_other(mark):
        return None
    there = [thing.name for thing in matching(mark.traits, scene, False) if not thing.extra]
    any_such = none and bool(there) and not theme.built and _any_such(mark)
    if mark.det not in ("another", "other") and not any_such:
        return None
    if loc.rel in LEVEL and not none and len(theme.names) > 1 and not theme.each:
        raise refuse("ambiguous", "other ones than all of these, or may these not touch each other either?", loc.span,
                     "say 'none of them touches another', or name the others")  # fmt: skip
    scene.surveyed.append((mark.traits, (*theme.names, *there), mark.span))
    pairs = dict.fromkeys((a, b) for a in theme.names for b in there if a != b)
    both_ways = loc.rel in ("on", "above", "under", *DIRECTIONS)
    kept = [(a, b) for a, b in pairs if both_ways or a < b or (b, a) not in pairs]
    if not kept:
        raise refuse("no-referent", "there is no other block", loc.span, "say which blocks there are")
    related = [relate(Ref(names=(a,)), Ref(names=(b,)), loc, scene, span) for a, b in kept]
    return [g.Not(goal=goal, span=span) for goal in related] if none else related  # what denies the clause denies these


_NOTHING = ("nothing", "nothing else", "no other")
_ANYTHING = ("anything", "anything else")
WHATEVER = (*_NOTHING, *_ANYTHING)
"""What stands for whichever other blocks there are."""


def _touching_none(theme: Ref, loc: Loc, scene: Scene, span: Span, relate: Relate) -> Atoms | None:
    """ "the green block touches nothing", "... is not next to anything": no other block that there is."""
    word = loc.landmark.word if isinstance(loc.landmark, Pronoun) else ""
    denied = loc.negated or scene.denying
    if loc.rel not in LEVEL or word not in (_ANYTHING if denied else _NOTHING) or len(theme.names) != 1:
        return None
    told = _told_of(theme, scene) if word.endswith("else") else set()
    others = [t.name for t in scene.blocks() if not t.extra and t.name not in theme.names and t.name not in told]
    if not others or theme.quant is not None or theme.built:
        raise refuse("no-referent", "there is no other block", loc.span, "say which blocks there are")
    goals = [relate(theme, Ref(names=(name,)), loc, scene, span) for name in others]
    return goals if denied else [g.Not(goal=goal, span=span) for goal in goals]


_BESIDE = frozenset({"beside", "adjacent", "touching"})


def _told_of(theme: Ref, scene: Scene) -> set[str]:
    """ "Red is on blue and touches nothing else": nothing but what it is said to lie on, or touch."""
    before = [m for m in scene.mentions if m.clause == scene.clause - 1]
    same = any(m.role == "theme" and m.ref.names == theme.names for m in before)
    marks = [m.ref.names for m in before if same and m.role == "landmark" and m.rel in ("on", *_BESIDE)]
    here = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark" and m.rel in _BESIDE]
    return {name for names in (*marks, *(m.ref.names for m in here)) for name in names}


def _none_of_them(theme: Ref, loc: Loc, span: Span) -> Atoms:
    """No two of the blocks are so related; where these are all there are, nothing is on any of them."""
    if theme.everything and loc.rel in ("on", "above", "heaped"):
        return [r.Clear(a=theme.names, span=span)]
    return negation(of_every_two(theme.names, loc, span), span)


def of_every_two(names: tuple[str, ...], loc: Loc, span: Span) -> Atoms:
    """The relation of every two of the blocks, by itself: what "not next to each other" denies is each of these."""
    if loc.rel in ("on", "above", "heaped", "under"):
        upon = r.On if "directly" in loc.mods else r.Above
        return [upon(a=(a,), b=(b,), span=span) for a in names for b in names if a != b]
    return [goal for two in combinations(names, 2) for goal in reciprocal(Ref(names=two), loc, span)]


def _units(theme: Ref) -> list[Operand]:
    """What stands to each other: towers, groups, or single blocks."""
    if len(theme.built) > 1 and len({n for b in theme.built for n in b.members}) == len(theme.names):
        return [foot(Ref(names=b.members, built=(b,))) for b in theme.built]
    if len(theme.parts) > 1 and any(len(p.names) > 1 for p in theme.parts):
        _of_a_kind(theme)
        _of_groups(theme)
        return [foot(p) for p in theme.parts]
    return [(n,) for n in theme.names]


def _of_a_kind(theme: Ref) -> None:
    """Refuse "a tower of two and the black ones side by side": it could be said of the black ones alone."""
    loose = any(len(p.names) > 1 and not p.built for p in theme.parts)
    if loose and any(p.built for p in theme.parts):
        raise refuse("misplaced", "this could be said of all of these, or of the last ones", theme.span,
                     "say it in a sentence of its own")  # fmt: skip


def _of_groups(theme: Ref) -> None:
    """Refuse "two red blocks and a blue one must be far apart": of every two of them, or of the red ones from the blue?
    "The red blocks and the blue blocks" are two groups."""
    loose = [p for p in theme.parts if not p.built]
    if any(len(p.names) > 1 and p.det != "the" for p in loose) or len({len(p.names) > 1 for p in loose}) > 1:
        raise refuse("ambiguous", "is this said of every two of these blocks, or of the ones and the others?",
                     theme.span, "say 'no two of ...', or 'the red blocks far from the blue block'")  # fmt: skip


def _distances(theme: Ref, units: list[Operand], loc: Loc, span: Span) -> Atoms:
    """Distances of every two; of more than two blocks "5 cm apart" is the spacing of a row, but three may as well be
    so far "from each other"."""
    mutual = "mutual" in loc.mods
    if mutual and len(units) > MOST_EQUALLY_FAR and loc.low is not None and loc.high is not None:
        raise refuse("ambiguous", "so many blocks cannot all be as far from each other: of neighbours in a row, or at "
                     "least so far?", loc.span, "say 'in a row', or 'at least ...'")  # fmt: skip
    if len(units) == 2 or loc.low is None or loc.high is None or mutual:
        if len(units) > 2 and loc.high is not None and any(b.kind in ("row", "line", "column") for b in theme.built):
            raise refuse("ambiguous", "of neighbours, or of every two of the line?", loc.span, "say 'with gaps of ...'")
        options: dict[str, Any] = {"minimum": loc.low, "maximum": loc.high, "measure": loc.measure}
        return [r.Distance(a=a, b=b, span=span, **options) for a, b in combinations(units, 2)]
    key = "gap" if loc.measure == "faces" else "spacing"
    spaced: dict[str, Any] = {key: round((loc.low + loc.high) / 2, 6),
                              "tolerance": round((loc.high - loc.low) / 2, 6)}  # fmt: skip
    return [s.Row(blocks=theme.names, span=span, **spaced)]


def _chained(units: list[Operand], loc: Loc, span: Span) -> g.Goal:
    """ "three towers side by side": each beside the next one, whichever comes first."""
    node = {"side_by_side": r.Beside, "beside": r.Beside, "adjacent": r.Adjacent, "touching": r.Touching}.get(loc.rel)
    if node is None or len(units) > MOST_CHAINED:
        raise refuse("misplaced", "this is not understood of so many structures", loc.span, "say it of every two")
    rows = [row for row in permutations(units) if units.index(row[0]) < units.index(row[-1])]
    chains = [conj([node(a=a, b=b, span=span) for a, b in pairwise(row)], span) for row in rows]
    return disj(chains, span)


def _close(names: tuple[str, ...], units: list[Operand], loc: Loc, span: Span) -> g.Goal:
    """Side by side, touching, together: of two a relation, of more a row or a group."""
    two = len(units) == 2
    if not two and len(names) > len(units):
        return _chained(units, loc, span)
    match loc.rel:
        case "side_by_side" | "beside":
            return r.Beside(a=units[0], b=units[1], span=span) if two else s.Row(blocks=names, gap_edges=1.0, span=span)
        case "adjacent" if two:
            return r.Adjacent(a=units[0], b=units[1], span=span)
        case "adjacent":
            return s.Row(blocks=names, gap_edges=0.5, span=span)
        case "touching" if two:
            return r.Touching(a=units[0], b=units[1], span=span)
        case "touching":
            return s.GroupBy(groups=(names,), inner_edges=s.TOUCHING_EDGES, span=span)
        case "together":
            return s.GroupBy(groups=(names,), span=span)
        case "one_behind" if two and len(names) > 2:
            return g.Any(goals=tuple(r.Behind(a=a, b=b, span=span) for a, b in (units, units[::-1])), span=span)
        case "one_behind" if len(units) == len(names):
            return s.Row(blocks=names, axis="x", span=span)
        case "off":
            apart = [r.Above(a=(a,), b=(b,), span=span) for a in names for b in names if a != b]
            return g.All(goals=tuple(g.Not(goal=x, span=span) for x in apart), span=span)
        case _:
            raise refuse("misplaced", "this relation does not go with 'each other'", loc.span)
