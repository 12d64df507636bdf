"""Distances compared: which of two a block is closer to, which of two is closer to it, what is equally far."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import Operand, members
from rpg.language.meaning import Coord, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, denied, negation
from rpg.passes.schema.resolve.places.alone import beyond
from rpg.passes.schema.resolve.things.operands import ANY, foot, spread
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Exclusive, Ref, Scene, Scope, refuse

CLEARLY = 0.01
"""How much closer what is closer is at least, in metres."""


def compared(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> Atoms:
    """The goals of a place that is told by two distances."""
    if theme.everything and theme.quant is not None and loc.rel in ("closer", "farther") and theme.beyond is None:
        return [_none_closer(loc, scene, scope, span)]
    if theme.op in ("only", "except") or theme.beyond is not None or theme.everything:
        raise refuse("misplaced", "this does not fit a comparison of distances", theme.span, "name the blocks")
    if loc.rel in ("closest", "farthest"):
        return _most(theme, loc, scene, scope, span)
    if loc.rel == "as_far" and loc.second is None:
        return [_as_far_from_all(theme, loc, scene, scope, span)]
    mark, second, other = _both(theme, loc, scene, scope)
    for meaning, met in ((loc.landmark, mark), (loc.second, second)) if len(theme.names) > 1 else ():
        if isinstance(meaning, Noun) and meaning.det == "a" and len(matching(meaning.traits, scene, met.patch)) > 1:
            raise refuse("ambiguous", "it is not clear which of these is meant", meaning.span, "name one of them")
    _check(theme, mark, second, loc)
    if loc.rel == "as_far":
        return [_as_far(theme, mark, second, other, loc, loc.negated or scene.denying, span)]
    found = _closer(theme, mark, second, other, loc, span)
    return negation([found], span) if "no" in loc.mods else [found]


def _closer(theme: Ref, mark: Ref, second: Ref, other: bool, loc: Loc, span: Span) -> g.Goal:
    """ "closer to red than to blue", "closer to red than blue is", and farther."""
    by = CLEARLY if loc.low is None else loc.low
    a, b = (mark, second) if loc.rel == "closer" else (second, mark)
    if other:
        hub = _operand(mark, loc, each=False)

        def against(x: Operand) -> g.Goal:
            b, c = (x, _operand(second, loc)) if loc.rel == "closer" else (_operand(second, loc), x)
            return r.Closer(a=hub, b=b, c=c, by=by, span=span)

        return spread(theme, against, span)
    near, far = _operand(a, loc, each=loc.rel == "farther"), _operand(b, loc, each=loc.rel == "closer")
    return spread(theme, lambda x: r.Closer(a=x, b=near, c=far, by=by, span=span), span)


def _none_closer(loc: Loc, scene: Scene, scope: Scope, span: Span) -> g.Goal:
    """ "no block is closer to the mat than the red one": none of those that the task has in the end."""
    if "other" not in loc.mods and "either" not in loc.mods:
        raise refuse("misplaced", "this does not fit a comparison of distances", loc.span, "name the blocks")
    mark = _there(loc.landmark, scene, scope, loc, patch=None)
    best = _there(loc.second, scene, scope, loc, patch=False)
    _check(Ref(), mark, best, loc)
    hub, one = _operand(mark, loc, each=False), _operand(best, loc, each=False)

    def past(name: str) -> g.Goal:
        b, c = ((name,), one) if loc.rel == "closer" else (one, (name,))
        return r.Closer(a=hub, b=b, c=c, span=span)

    alone = Exclusive((*mark.names, *best.names), past, loc.span, Traits())
    scene.exclusive.append(alone)
    return conj([g.Not(goal=past(n), span=span) for n in beyond(alone, scene)])


def _both(theme: Ref, loc: Loc, scene: Scene, scope: Scope) -> tuple[Ref, Ref, bool]:
    """The two landmarks, and whether the second is compared with the theme: "than the blue one is"."""
    mark = _there(loc.landmark, scene, scope, loc, patch=None)
    if "other" in loc.mods:
        return mark, _other(theme, loc, scene, scope), True
    if "either" not in loc.mods:
        return mark, _there(loc.second, scene, scope, loc, patch=mark.patch), False
    plain = isinstance(loc.second, Noun) and loc.second.head == "any"
    if mark.patch == theme.patch or (plain and matching_patch(loc.second, scene)):
        first, too = ("'as from ...'", "'as ... is'") if loc.rel == "as_far" else ("'than to ...'", "'than ... is'")
        raise refuse("ambiguous", "how far it is from this, or how far this is?", getattr(loc.second, "span", loc.span),
                     f"say {first} or {too}")  # fmt: skip
    second = _other(theme, loc, scene, scope)
    return mark, second, second.patch == theme.patch


def matching_patch(noun: Meaning | None, scene: Scene) -> bool:
    """Whether "the green one" may be a patch: where no block is known that looks so."""
    return isinstance(noun, Noun) and not matching(noun.traits, scene, False)


def _there(
    meaning: Meaning | None, scene: Scene, scope: Scope, loc: Loc, *, patch: bool | None, role: str = "landmark"
) -> Ref:
    if meaning is None:
        raise refuse("misplaced", "it is not said of what", loc.span)
    if isinstance(meaning, Noun) and meaning.head == "any" and patch is not None:
        meaning = replace(meaning, head="patch" if patch else "block")
    there = replace(scope, role=role, pool=(), need=None, rel=loc.rel, like_patch=False)
    found = refer(meaning, scene, there)
    if found.reciprocal:
        raise refuse("misplaced", "distances of four blocks are not compared", loc.span, "compare those from one block")
    return found


def _other(theme: Ref, loc: Loc, scene: Scene, scope: Scope) -> Ref:
    """ "(than) the blue one (is)", "... any other block": what is compared with the theme."""
    second = loc.second
    rest = isinstance(second, Noun) and second.head != "patch" and second.part_of is None and not second.conditions
    if isinstance(second, Noun) and rest and (second.det == "other" or second.traits.rank == "other"):
        return _the_rest(theme, second, loc, scene)
    if isinstance(second, Pronoun) and second.word in ("others", "the others", "all others"):
        return _the_rest(theme, None, loc, scene)
    patch = theme.patch if "other" in loc.mods else None
    return _there(second, scene, scope, loc, patch=patch)


def _the_rest(theme: Ref, noun: Noun | None, loc: Loc, scene: Scene) -> Ref:
    """All further blocks there are, of some look."""
    there = matching(noun.traits if noun else Traits(), scene, False)
    names = tuple(t.name for t in there if t.name not in theme.names and not t.extra)
    if not names:
        raise refuse("no-referent", "there is no other block", loc.span, "say which other blocks there are")
    return Ref(names=names, det="all", plural=True, span=loc.span)


def _check(theme: Ref, mark: Ref, second: Ref, loc: Loc) -> None:
    if mark.table or second.table:
        raise refuse("misplaced", "the table is everywhere", loc.span, "name blocks or patches")
    if theme.patch and mark.patch and second.patch:
        raise _fixed(loc)
    lots = [{*theme.names}, {*mark.names}, {*second.names}]
    if any(one & other for one, other in combinations(lots, 2)):
        raise refuse("self-reference", "a block is compared with itself here", loc.span, "name another block")


def _fixed(loc: Loc) -> Refusal:
    return refuse("fixed-patch", "patches are marks on the table and cannot be moved", loc.span, "move blocks instead")


def _operand(ref: Ref, loc: Loc, *, each: bool = True) -> Operand:
    """One landmark, the foot of a tower, or each of several. `each`: "the blue ones" are each of them."""
    if ref.op not in ("and", "or") or (ref.op == "or" and not each) or ref.matching or ref.reciprocal:
        raise refuse("ambiguous", "it is not clear which of these is meant", ref.span, "name one of them")
    if ref.quant is not None and not (each and ref.quant == ANY and ref.det == "any"):
        raise refuse("ambiguous", "it is not clear which of these is meant", ref.span, "name them")
    if len(ref.built) > 1 or (ref.built and ref.built[0].kind != "stack"):
        raise refuse("ambiguous", "it is not said to which block of it", ref.span, "name one of its blocks")
    several = len(ref.names) > 1 and not ref.built
    if several and not (each or ref.each or ref.listed or ref.det in ("all", "both", "each")):
        raise refuse("ambiguous", "each of these, or the nearest of them?", ref.span, "say 'each of ...', or name one")
    return foot(ref)


def _as_far(theme: Ref, mark: Ref, second: Ref, other: bool, loc: Loc, denying: bool, span: Span) -> g.Goal:
    """ "as far from red as from blue", "as far from red as blue is"; "not as far" is closer."""
    one, two = _operand(mark, loc, each=False), _operand(second, loc, each=False)
    if len(members(two)) > 1 and isinstance(two, tuple):
        raise refuse("ambiguous", "it is not clear with which of these it is compared", loc.span, "name one of them")
    bound = next((x for x in ("least", "most") if x in loc.mods), "as" if denying and "as" in loc.mods else "")
    if "as" in loc.mods and theme.quant is not None and theme.quant.high == 0:
        raise refuse("ambiguous", "is none as far, or none farther?", loc.span, "say 'closer' or 'farther'")

    def related(x: Operand) -> g.Goal:
        a, b = (one, x) if other else (x, one)
        if not bound:
            return r.Equidistant(a=a, b=b, c=two, span=span)
        b, c = (b, two) if (bound != "most") is not ("close" in loc.mods) else (two, b)
        return g.Not(goal=r.Closer(a=a, b=b, c=c, span=span), span=span)

    return spread(theme, related, span)


def _as_far_from_all(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> g.Goal:
    """ "at the same distance from red and blue"; "red and blue are equally far from green"."""
    if isinstance(loc.landmark, Pronoun) and loc.landmark.word in ("each other", "one another"):
        return _all_alike(theme, loc, span)
    mark = _listed(loc, scene, scope)
    _check(theme, mark, Ref(), loc)
    ends, themes = _units(mark, loc), _units(theme, loc)
    plain = theme.quant is None and theme.op == "and" and not theme.mixed
    if len(ends) > 1:
        if len(themes) > 1 and not theme.each and theme.det not in ("both", "each"):
            raise refuse("ambiguous", "each of these from both, or all of these from each?", loc.span,
                         "say 'each at the same distance from ...'")  # fmt: skip
        if theme.patch and mark.patch:
            raise _fixed(loc)
        return spread(theme, lambda x: _alike(x, ends, span), span)
    if len(themes) < 2 or not plain:
        raise refuse("ambiguous", "it is not said as far as what", loc.span, "say 'as far from ... as from ...'")
    if theme.patch and mark.patch:
        raise _fixed(loc)
    return _alike(ends[0], themes, span)


def _listed(loc: Loc, scene: Scene, scope: Scope) -> Ref:
    """The landmarks, blocks and patches among them: "from red, blue and the green mat"."""
    marks = loc.landmark.items if isinstance(loc.landmark, Coord) and loc.landmark.op == "and" else ()
    heads = [getattr(mark, "head", "") for mark in marks]
    if "patch" not in heads or all(head in ("patch", "any") for head in heads):
        return _there(loc.landmark, scene, scope, loc, patch=None)
    parts = [_there(mark, scene, scope, loc, patch=None) for mark in marks]
    if any(len(part.names) != 1 or part.quant is not None for part in parts):
        raise refuse("ambiguous", "it is not clear which of these is meant", loc.span, "name them one by one")
    return Ref(names=tuple(name for part in parts for name in part.names), listed=True, span=loc.span)


def _all_alike(theme: Ref, loc: Loc, span: Span) -> g.Goal:
    """ "the three are at the same distance from each other"."""
    units = _units(theme, loc)
    if len(units) != 3 or theme.quant is not None:
        few = "two have one distance" if len(units) < 3 else "more than three blocks cannot be so"
        raise refuse("misplaced", f"every two of these at one distance: {few}", loc.span, "say how far apart they are")
    return conj([_alike(units[n], [units[n - 1], units[n - 2]], span) for n in (0, 1)], span)


def _units(ref: Ref, loc: Loc) -> list[Operand]:
    """The blocks or towers of a phrase, one by one."""
    if len(ref.parts) > 1 and ref.op == "and" and ref.built:
        return [_operand(part, loc) for part in ref.parts]
    if len(ref.built) > 1 and all(b.kind == "stack" for b in ref.built):
        return [foot(Ref(names=b.members, built=(b,))) for b in ref.built]
    if ref.built or ref.op != "and" or ref.quant is not None:
        return [_operand(ref, loc)]
    return [(name,) for name in ref.names]


def _alike(hub: Operand, ends: list[Operand], span: Span) -> g.Goal:
    """All of `ends` are as far from `hub`."""
    if all(isinstance(end, tuple) for end in ends):
        rest = tuple(name for end in ends[1:] for name in members(end))
        return r.Equidistant(a=hub, b=ends[0], c=rest, span=span)
    pairs = combinations(ends, 2)
    return conj([r.Equidistant(a=hub, b=one, c=other, span=span) for one, other in pairs], span)


def _most(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> Atoms:
    """ "the closest (of the three) to the patch": closer than each other one, of all the task's or of so many."""
    mark = _there(loc.landmark, scene, scope, loc, patch=None)
    _check(theme, mark, Ref(), loc)
    if len(theme.names) != 1 or theme.quant is not None or theme.op != "and" or len(mark.names) != 1 or theme.patch:
        raise refuse("ambiguous", "one block is the closest to one other thing", loc.span,
                     "say 'closer to ... than ...'")  # fmt: skip
    near = loc.rel == "closest"
    one, hub = theme.names, mark.names

    def past(other: str) -> g.Goal:
        b, c = (one, (other,)) if near else ((other,), one)
        return r.Closer(a=hub, b=b, c=c, span=span)

    among = loc.second
    if among is None or (isinstance(among, Pronoun) and among.word == "all"):
        if loc.negated or scene.denying or scope.start:
            raise refuse("ambiguous", "it is not said which blocks these are", loc.span,
                         "say 'not closer to ... than ...'")  # fmt: skip
        no_other: Callable[[str], g.Goal] = lambda n: g.Not(goal=past(n), span=span)  # noqa: E731
        scene.exclusive.append(Exclusive((*one, *hub), no_other, loc.span, Traits()))
        return [conj([denied(no_other(n), span) for n in beyond(scene.exclusive[-1], scene)])]
    return [conj([past(n) for n in _rivals(among, theme, mark, loc, scene, scope)], span)]


def _rivals(among: Meaning, theme: Ref, mark: Ref, loc: Loc, scene: Scene, scope: Scope) -> list[str]:
    """The others of those among which it is the closest."""
    counted = isinstance(among, Noun) and among.amount is not None and among.traits == Traits()
    if isinstance(among, Noun) and counted and among.head in ("any", "block") and among.amount is not None:
        names = [t.name for t in scene.blocks() if not t.extra and t.name not in mark.names]
        if len(names) != among.amount.low:
            raise refuse("no-referent", "it is not said which blocks these are", among.span, "name them before")
    else:
        names = list(_there(among, scene, scope, loc, patch=None, role="theme").names)
    others = [name for name in names if name not in theme.names]
    if len(others) + len(theme.names) != len(names) or not others or {*mark.names} & {*names}:
        raise refuse("no-referent", "it is none of these", loc.span, "name the blocks that it is compared with")
    return others
