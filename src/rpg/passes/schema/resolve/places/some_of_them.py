"""Relations of some blocks of several to each other: "two of the three red blocks touch"."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from math import comb

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.language.meaning import Amount, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, denied, disj, negation
from rpg.passes.schema.resolve.orders.positions import looks
from rpg.passes.schema.resolve.places.alone import beyond
from rpg.passes.schema.resolve.places.mutual import ALL_OTHERS, of_every_two, reciprocal, some_other
from rpg.passes.schema.resolve.things.operands import DIRECTIONS, LEVEL
from rpg.passes.schema.resolve.things.world import Exclusive, Ref, Scene, Scope, Thing, refuse


def to_each_other(theme: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms:
    """What a relation "to each other" says of the blocks, or of so many of them.

    Raises:
        Refusal: "ambiguous", of "with only A and B touching": is C to touch none of them, and D neither C?
    """
    if theme.op == "only":
        raise refuse("ambiguous", "it is not clear what 'only' says of the other blocks", theme.span,
                     "leave out 'only', and say what the other blocks should not do")  # fmt: skip
    some = _among_some(theme, loc, scene, span)
    return some if some is not None else reciprocal(theme, loc, span, denied=loc.negated or scene.denying)


def _among_some(theme: Ref, loc: Loc, scene: Scene, span: Span) -> Atoms | None:
    """So many of look-alikes are so related, and no others; None where it is said of all of them, or of none."""
    many = theme.quant
    two = getattr(loc.landmark, "word", "") == "each other"  # "no two of them on each other"
    if many == Amount(0, 1, True) and loc.rel in _ONE_WAY and not (two or loc.negated or scene.denying):
        raise refuse("ambiguous", "it is not said which of these may be so", span,
                     "say which of them must not: 'A and B must not be on another block'")  # fmt: skip
    if "not all" in loc.mods and len(theme.names) > 2:  # "(three blocks,) not all touching"
        raise _of_some(span)
    if many is None or (many.low == 0 and many.high in (0, 1)) or len(theme.names) < 2:
        return None
    parting = loc.rel == "apart" or (loc.rel == "distance" and loc.high is None)
    if loc.negated or scene.denying or parting or many.low < 2 or theme.built:
        raise _of_some(span)
    alike = len({looks(scene.things[n]) for n in theme.names}) == 1
    if not alike and comb(len(theme.names), many.low) > _CHOICES:
        raise refuse("ambiguous", "it is not said which of the blocks are meant", span, "name the blocks")
    if many.high != many.low:
        lots = combinations(theme.names, many.low)
        return [disj([conj(reciprocal(Ref(names=lot), loc, span), span) for lot in lots], span)]
    if alike and not any(map(_of_no_look, (scene.things[n] for n in theme.names))):
        return _just_these(theme.names[: many.low], theme.names, loc, span)
    lots = combinations(theme.names, many.low)  # these will differ in looks: whichever of them
    return [disj([conj(_just_these(lot, theme.names, loc, span), span) for lot in lots], span)]


def by_itself(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> Atoms | None:
    """What it says of one block that it is by itself; None where it does not say so."""
    single = len(theme.names) == 1 and theme.quant is None and not (theme.patch or theme.built)
    alone = loc.rel == "apart" and getattr(loc.landmark, "word", "") == "each other"
    if not (single and alone) or loc.negated or scene.denying:
        return None
    return (_apart_there if scope.given else _from_all_others)(theme, scene, span)


def _from_all_others(theme: Ref, scene: Scene, span: Span) -> Atoms:
    """ "One of the five lies apart": from each other block that the task has in the end."""
    near: Callable[[str], g.Goal] = lambda n: g.Not(goal=r.Apart(a=theme.names, b=(n,), span=span), span=span)  # noqa: E731
    scene.exclusive.append(Exclusive(theme.names, near, span, Traits()))
    return [conj([denied(near(n), span) for n in beyond(scene.exclusive[-1], scene)])]


def _apart_there(theme: Ref, scene: Scene, span: Span) -> Atoms | None:
    """ "(There are A and B in a row) and D by itself": it starts apart from those that were told of before it."""
    others = [t.name for t in scene.things.values() if not t.patch and t.name not in theme.names]
    return [r.Apart(a=theme.names, b=(name,), span=span) for name in others] or None


def _of_some(span: Span) -> Refusal:
    told = "is this said of every two of them, or of some?"
    return refuse("ambiguous", told, span, "say 'every two of ...', or name the blocks")


_ONE_WAY = frozenset({"on", "above", "under", *DIRECTIONS})
"""Where at most one may be so to another, one of two may; none may be where it is so of both."""
_CHOICES = 12
"""Of so many sets of blocks it may be said that they are those."""


def _of_no_look(thing: Thing) -> bool:
    return thing.color is None and thing.label is None


def _just_these(chosen: tuple[str, ...], names: tuple[str, ...], loc: Loc, span: Span) -> Atoms:
    """The relation of the chosen ones to each other, and of no two others."""
    others = (two for two in combinations(names, 2) if not set(two) <= set(chosen))
    apart = negation([conj(reciprocal(Ref(names=two), loc, span), span) for two in others], span)
    return [*reciprocal(Ref(names=chosen), loc, span), *apart]


def to_others(theme: Ref, loc: Loc, span: Span) -> Atoms:
    """What a relation of each of several blocks to others of them says: "(each touches) another", "the other two",
    "exactly one other block"."""
    mark, others = loc.landmark, len(theme.names) - 1
    many = mark.amount if isinstance(mark, Noun) else None
    if getattr(mark, "word", "") in ALL_OTHERS or (many is not None and many[:2] == (others, others) and others > 1):
        return of_every_two(theme.names, loc, span)
    if many is not None and many.strict:
        return [_to_so_many(name, theme, loc, many, span) for name in theme.names]
    if isinstance(mark, Noun) and mark.plural and mark.det != "any":
        raise refuse("ambiguous", "is this said of all others, or of some of them?", mark.span,
                     "say how many others, such as 'at least two other blocks' or 'the other two'")  # fmt: skip
    return some_other(theme, loc, span)


def _to_so_many(name: str, theme: Ref, loc: Loc, many: Amount, span: Span) -> g.Goal:
    """The relation of one of the blocks to so many others of them."""
    if many.low > len(theme.names) - 1 or theme.built or theme.patch or loc.rel not in LEVEL:
        raise refuse("misplaced", "this is not understood of so many others", loc.span, "name the blocks")
    others = tuple(other for other in theme.names if other != name)
    one = conj(reciprocal(Ref(names=(name, EACH)), loc, span), span)
    return g.Count(over=others, at_least=many.low, at_most=many.high, goal=one, span=span)


def none_of_others(theme: Ref, mark: Meaning | None) -> Meaning | None:
    """ "(Each touches) none of the others", "(it touches) no other block": what is denied of it."""
    if not isinstance(mark, Noun) or theme.quant is not None or mark.head == "patch":
        return None
    if mark.det == "no other" and mark.amount is None:
        return replace(mark, det="another", amount=Amount(1, 1), plural=False)
    others = mark.part_of if mark.det == "no" and mark.head == "any" and theme.each else None
    return others if isinstance(others, Pronoun) and others.word in ALL_OTHERS else None


def any_one(loc: Loc) -> Loc:
    """ "Touches some blue block", "within 10 cm of some blue block": of any one of them, as "a blue block" is."""
    mark = loc.landmark
    if not isinstance(mark, Noun) or (mark.det, mark.amount, mark.plural) != ("some", None, False):
        return loc
    return replace(loc, landmark=replace(mark, det="a")) if mark.part_of is None else loc
