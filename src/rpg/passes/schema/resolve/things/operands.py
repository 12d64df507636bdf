"""Operands of relations: every, any or so many blocks; the foot and the top of a tower."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH, Highest, Lowest, Operand
from rpg.language.meaning import Amount, Loc, Pronoun, replace
from rpg.passes.schema.resolve.goals.logic import conj, disj, negation
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse, said

LEVEL = {"beside": r.Beside, "adjacent": r.Adjacent, "touching": r.Touching, "near": r.Near, "apart": r.Apart}


DIRECTIONS: dict[str, type[r.LeftOf | r.RightOf | r.InFrontOf | r.Behind]] = {
    "left": r.LeftOf, "right": r.RightOf, "front": r.InFrontOf, "behind": r.Behind,
}  # fmt: skip


def measure(loc: Loc) -> Any:
    return loc.measure


UPRIGHT = ("stack", "wall", "pyramid", "staircase")


def spread(theme: Ref, atom: Callable[[Operand], g.Goal], span: Span, together: bool = False) -> g.Goal:
    """`atom` of every, any, or so many of the theme's blocks. `together`: the atom takes several blocks at once."""
    if theme.quant is not None:
        return count(theme.names, theme.quant, atom, span)
    if theme.mixed:
        return conj([spread(part, atom, span, together) for part in theme.parts], span)
    if theme.op == "except":
        inside, out = theme.parts
        return conj([spread(inside, atom, span, together), *negation([spread(out, atom, span)], span)], span)
    if theme.op == "nor":
        return conj(negation([spread(part, atom, span) for part in theme.parts], span), span)
    if theme.op == "xor":
        parts = [spread(part, atom, span, together) for part in theme.parts]
        return g.All(
            goals=(g.Any(goals=tuple(parts), span=span), g.Not(goal=g.All(goals=tuple(parts), span=span), span=span)),
            span=span,
        )
    if theme.op == "or":
        return disj([spread(part, atom, span, together) for part in theme.parts], span)
    if theme.built and len(theme.built) == 1 and not theme.each:
        return atom(theme.names if together else foot(theme))
    if together or len(theme.names) == 1:
        return atom(theme.names)
    return conj([atom((name,)) for name in theme.names], span)


def count(names: tuple[str, ...], quant: Amount, atom: Callable[[Operand], g.Goal], span: Span) -> g.Goal:
    """So many of `names` satisfy `atom`."""
    if quant.high == 0:
        return conj([g.Not(goal=atom((name,)), span=span) for name in names], span)
    if quant.low == 1 and quant.high is None:
        return disj([atom((name,)) for name in names], span)
    if quant.low == len(names) and (quant.high is None or quant.high == len(names)):
        return conj([atom((name,)) for name in names], span)
    return g.Count(over=names, at_least=quant.low, at_most=quant.high, goal=atom((EACH,)), span=span)


def one_by_one(mark: Ref, loc: Loc, scene: Scene) -> list[Ref]:
    """ "next to the blue and the green block": next to each of them. Several that look alike are one landmark where
    that comes to the same, as with "at least 10 cm from the two red blocks"."""
    if loc.rel not in (*LEVEL, "distance") or loc.rel == "apart" or mark.op != "and" or mark.patch:
        return [mark]
    whole = len(mark.built) == 1 and {*mark.built[0].members} == {*mark.names}  # "(stack A, B, C and put D) next to it"
    if not (whole or scene.denying) and _beside_them(mark, loc, scene):
        raise _each_or_all(loc)
    if len(mark.built) > 1 and getattr(loc.landmark, "det", "") in ("both", "each", "all"):
        return [Ref(names=each.members, built=(each,)) for each in mark.built]  # "next to both towers"
    if len(mark.parts) > 1 or mark.built:
        return [mark] if whole else list(mark.parts) or [mark]
    if mark.each or mark.det in ("all", "both") or loc.rel == "touching":
        return [Ref(names=(name,)) for name in mark.names]
    looks: dict[tuple[str | None, ...], list[str]] = {}
    for thing in (scene.things[name] for name in mark.names if name != EACH):
        looks.setdefault((thing.color, thing.label, thing.size), []).append(thing.name)
    alike = any(len(names) > 1 for names in looks.values())
    if alike and loc.rel in ("beside", "adjacent"):
        raise _each_or_all(loc)
    if loc.rel == "near":
        return [Ref(names=(name,)) for name in mark.names]
    return [Ref(names=tuple(names)) for names in looks.values()] if len(looks) > 1 else [mark]


_THEM = frozenset({"them", "these", "those"})


def _beside_them(mark: Ref, loc: Loc, scene: Scene) -> bool:
    """Whether something is to be next to "them", several blocks that lie on the table or a patch."""
    them = isinstance(loc.landmark, Pronoun) and loc.landmark.word in _THEM and not loc.negated
    flat = len(mark.names) > 1 and scene.on_top.keys().isdisjoint(mark.names)
    return them and flat and loc.rel in ("beside", "adjacent")


def _each_or_all(loc: Loc) -> Refusal:
    return refuse("ambiguous", "next to each of these, or to them as a group?", loc.span,
                  "say 'next to both', 'next to each of the ...', or 'next to one of the ...'")  # fmt: skip


def far_from_any(mark: Ref, loc: Loc) -> Ref:
    """ "far from any of the red blocks", "at least 10 cm from any of them": from each."""
    far = loc.rel == "apart" or (loc.rel == "distance" and loc.low is not None and loc.high is None)
    return replace(mark, quant=None, det="all") if far and mark.det == "any" and mark.quant == ANY else mark


ANY = Amount(1, None, True)
_ONE = Amount(1, 1, True)


def one_on_one(theme: Ref, mark: Ref, loc: Loc) -> Ref:
    """ "One of the red blocks on one of the blue ones": it is on any of them."""
    close = loc.rel in ("on", *LEVEL) and loc.rel != "apart"
    return replace(mark, quant=ANY) if close and theme.quant == mark.quant == _ONE else mark


def check_one_on_many(theme: Ref, quant: Amount) -> None:
    """Refuse "two of the three blue blocks carry a red block": a single one lies on no two."""
    if quant.low > 1 and len(theme.names) == 1 and not theme.built:
        raise refuse("ambiguous", f"one block cannot lie on {quant.low} blocks, and how many there are is not said",
                     theme.span, "say: 'two of the three red blocks are on any of the three blue blocks'")  # fmt: skip


def _check_same_one(theme: Ref, mark: Ref, loc: Loc) -> None:
    """Refuse "put A and B next to one of the red blocks": next to the same one, or each next to any of them?"""
    several = len(theme.names) > 1 and theme.quant is None and theme.op == "and" and not (theme.each or theme.built)
    if several and mark.quant is not None and mark.quant[:2] == (1, 1) and not (loc.negated or mark.each):
        raise refuse("ambiguous", "all with the same one, or each with any of them?", loc.span,
                     "say 'each of ...', or which one it is")  # fmt: skip


def first_of_all(theme: Ref, mark: Ref, loc: Loc) -> bool:
    """Whether every one of the theme's blocks, or so many of them, have each so many of the landmarks: "both red blocks
    touch at least one blue block", "no red block touches both blue ones"."""
    _check_same_one(theme, mark, loc)
    quant = theme.quant
    each = len(theme.names) > 1 and not theme.built and (theme.each or theme.det in ("all", "both"))
    of_all = mark.each or mark.det in ("all", "both")
    if quant is None or quant.high == 0:
        return (quant is not None or each) and (mark.quant is not None or (quant is not None and of_all))
    if mark.quant is not None and mark.quant != ANY and quant.low != len(theme.names):
        raise refuse("ambiguous", "so many of the ones, and so many of the others: it is not clear which", loc.span,
                     "say 'on any of them', or name the blocks")  # fmt: skip
    if mark.each and len(mark.names) > 1:
        raise refuse("ambiguous", "it is not clear which of them is meant by each", loc.span, "use two sentences")
    return mark.quant is not None


def foot(ref: Ref) -> Operand:
    """The operand for a relation on the table: a tower's lowest block, a structure's blocks, the block itself."""
    if len(ref.built) == 1 and ref.built[0].kind == "stack":
        built = ref.built[0]
        return (built.members[0],) if built.ordered else Lowest(lowest=built.members)
    return ref.names


def crown(ref: Ref) -> Operand:
    """The operand for putting something on it: a tower's highest block."""
    if len(ref.built) == 1 and ref.built[0].kind in UPRIGHT:
        built = ref.built[0]
        if built.kind == "stack" and built.ordered:
            return (built.members[-1],)
        return Highest(highest=built.members)
    return ref.names


def on_any(names: tuple[str, ...], wall: tuple[str, ...], span: Span) -> g.Goal:
    """On top of a wall is on any of its blocks: several of them are the highest."""
    return g.Count(over=wall, at_least=1, goal=r.On(a=names, b=(EACH,), span=span), span=span)


def base_of(name: str, scene: Scene) -> str:
    """The lowest block of the tower that `name` is in at the end."""
    seen = {name}
    while name in scene.on_top and name not in scene.begun_on and scene.on_top[name] not in seen:
        name = scene.on_top[name]
        seen.add(name)
    return name


def carrier(a: Operand, scene: Scene, *, moved: bool = False, level: bool = False) -> Operand:
    """A relation on the table to a block that goes on a tower is one to the tower's lowest block.

    `moved`: it is put there by this very clause; what put it on a tower before is past. `level`: both must stand on
    the table.
    """
    if isinstance(a, Lowest | Highest) or len(a) != 1:
        return a
    name = a[0]
    if moved and (scene.denying or (scene.placing and scene.on_clause.get(name, scene.clause) != scene.clause)):
        return a
    if level and name in scene.begun_on and not _moved(name, scene):
        below = said(scene.things[scene.on_top[name]])
        raise refuse("ambiguous", f"{said(scene.things[name])} lies on {below} at the start", None,
                     f"say 'next to {below}', or where {said(scene.things[name])} goes first")  # fmt: skip
    return (base_of(name, scene),)


def _moved(name: str, scene: Scene) -> bool:
    """Whether a block was put somewhere since it was said where it starts."""
    begun = scene.on_clause.get(name, 0)
    return any(m.role == "theme" and begun < m.clause < scene.clause and name in m.ref.names for m in scene.mentions)


def so_far(a: Operand, b: Operand, loc: Loc, span: Span) -> list[g.Goal]:
    """ "10 cm to the left of": how far that is."""
    if loc.low is None and loc.high is None:
        return []
    return [r.Distance(a=a, b=b, minimum=loc.low, maximum=loc.high, measure=measure(loc), span=span)]
