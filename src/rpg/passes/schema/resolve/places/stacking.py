"""Blocks on, above and under each other: what a vertical relation says, and which towers it makes."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import EACH, Highest, Lowest, Operand
from rpg.ir.order import Order, Pattern
from rpg.language.meaning import Loc, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.things.operands import check_one_on_many, crown, foot, on_any, spread
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse, which_one


@dataclass(frozen=True)
class Towers:
    """What stood on what before a clause was read."""

    on_top: dict[str, str]
    built: list[Built]

    @classmethod
    def of(cls, scene: Scene) -> Towers:
        return cls(dict(scene.on_top), list(scene.built))

    def after(self, scene: Scene, *, start: bool, denied: bool) -> None:
        """Towers of the start may be gone at the end; what is denied makes none."""
        if denied:
            scene.on_top, scene.built = dict(self.on_top), [*self.built]
        new = {name for name, below in scene.on_top.items() if self.on_top.get(name) != below}
        scene.begun_on = scene.begun_on | new if start else scene.begun_on - new


def check_bodies(theme: Ref, loc: Loc, scene: Scene) -> None:
    """ "The word HI on red cubes": are these below the letters, or do they show them?"""
    mark = loc.landmark
    if loc.rel != "on" or not isinstance(mark, Noun) or mark.head == "patch":
        return
    spelt = any(built.kind == "word" and {*theme.names} <= {*built.members} for built in scene.built)
    if mark.amount is not None and not (spelt and mark.det == "a" and len(theme.names) == 1):
        return
    below = [t for t in scene.blocks() if t.declared and t.label is None and t.color in mark.traits.colors]
    if theme.quant is not None and len(below) > 1:
        return  # cubes of that colour are there already, and no letter is on them all
    open_ = [scene.things[name] for name in theme.names]
    shown = all(thing.label is not None and thing.color is None for thing in open_)
    one = mark.det == "a" or (mark.det == "bare" and mark.plural)
    if open_ and shown and one and mark.traits == Traits(colors=mark.traits.colors):
        raise refuse("ambiguous", "are these cubes below, or do they show the letters?", mark.span,
                     "say 'on top of ...' with their number, or 'letters on ... bodies'")  # fmt: skip


def vertical(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """On, above, under: stacks come into being."""
    if loc.rel == "under":
        return _under(theme, mark, loc, scene, span)
    if (loc.rel == "above" and not ({"directly", "immediate"} & set(loc.mods))) or "somewhere" in loc.mods:
        b = crown(mark) if mark.built else mark.names
        return spread(theme, lambda a: r.Above(a=a, b=b, span=span), span)
    if theme.quant is None and theme.op == "and" and len(theme.names) > 1 and len(mark.names) == 1 and not theme.built:
        return _several_on_one(theme, mark, scene, span)
    tower = mark.built[0] if len(mark.built) == 1 and mark.built[0].kind == "stack" else None
    one = getattr(loc.landmark, "word", "") != "them"  # "stack two and put two on them": one on each of these?
    if tower and one and theme.quant is None and theme.op == "and" and len(theme.names) > 1 and not theme.built:
        return piled_on(theme.names, crown(mark), scene, span)
    if len(theme.built) > 1 and len(mark.names) == 1:
        raise refuse("ambiguous", "two towers have no room on one block", loc.span, "say which of them stands on it")
    if theme.built and theme.built[0].kind == "stack":
        return _tower_on(theme, mark, scene, span)
    if theme.built and len(theme.names) > 2 and len(mark.names) == 1 and theme.op == "and":
        raise refuse("ambiguous", f"a {theme.built[0].kind} has no room on one block", loc.span,
                     "say which block lies on it")  # fmt: skip
    if _several_tops(mark):
        return _on_a_wall(theme, mark, loc, span)
    mark = _as_a_tower(mark, scene)
    if (whichever := _so_many_on(theme, mark, loc, scene, span)) is not None:
        return whichever
    counted = theme.quant is not None or any(part.quant is not None for part in theme.parts)
    if len(theme.names) > 1 and len(mark.names) == len(theme.names) and not counted and not mark.built:
        return conj([_on(a, (b,), scene, span) for a, b in zip(theme.names, mark.names, strict=True)], span)
    b = crown(mark)
    if not isinstance(b, Lowest | Highest) and len(b) > 1:
        if loc.negated and mark.quant is None and mark.op == "and" and len(theme.names) == 1:  # "not on them": on none
            return conj([_on_operand(theme.names, (one,), scene, span) for one in b], span)
        plain = mark.quant is None and mark.op == "and" and not loc.negated
        if plain and _both(theme, loc) and _bears(theme, b, scene):
            return across(theme.names[0], b, scene, span)
        raise which_one(
            "one block cannot lie on several blocks; it is not clear which is meant",
            loc.span,
            "name one of them, or say 'on both blue blocks'" if len(b) == 2 else "name one of them",
        )
    return spread(theme, lambda a: _on_operand(a, b, scene, span), span)


def _so_many_on(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal | None:
    """ "At least two of the letters on black cubes": each of so many on whichever of these, one on one."""
    plain = mark.op == "and" and mark.quant is None and not (mark.built or mark.patch or loc.negated)
    if theme.quant is None or len(mark.names) < 2 or not plain or not alike([scene.things[n] for n in mark.names]):
        return None
    if theme.quant.low > len(mark.names):
        raise refuse("too-many-asked", "so many blocks find no place on these, one on one", loc.span,
                     f"ask for at most {len(mark.names)}")  # fmt: skip
    return spread(theme, lambda a: disj([r.On(a=a, b=(one,), span=span) for one in mark.names], span), span)


_ACROSS = {2: (2, 1), 4: (2, 2)}
"""So many blocks a single one may lie across, and how these lie."""


def _bears(theme: Ref, below: tuple[str, ...], scene: Scene) -> bool:
    """Whether one block may lie across these: two or four on the table, as large as it is."""
    single = len(theme.names) == 1 and not theme.built and len(below) in _ACROSS and EACH not in (*below, *theme.names)
    sizes = {scene.things[name].size for name in (*theme.names, *below)} if single else set()
    towers = any(built.kind == "stack" and not {*below}.isdisjoint(built.members) for built in scene.built)
    level = len(sizes) == 1 and not towers
    return level and scene.on_top.keys().isdisjoint(below) and not {*below} & {*scene.on_top.values()}


def _both(theme: Ref, loc: Loc) -> bool:
    """ "The black block on both white ones", "across the two"; "a block on both" may be one on each."""
    mark = loc.landmark
    both = getattr(mark, "det", "") == "both" or getattr(mark, "word", "").startswith("both")
    return (both and theme.det != "a") or "across" in loc.mods


def across(top: str, below: tuple[str, ...], scene: Scene, span: Span) -> g.Goal:
    """ "The black block rests on both white ones": two side by side, or four in a square, and one on them all."""
    scene.assume(f"a block on {'two' if len(below) == 2 else 'four'} others lies across them, as in a pyramid")
    order = Order(by="given", ranks=((top,), below))
    return s.Pyramid(
        blocks=(*below, top), base=_ACROSS[len(below)], pattern=Pattern(kind="reading", order=order), span=span
    )


def _as_a_tower(mark: Ref, scene: Scene) -> Ref:
    """ "Stack two blue cubes and put a red one on them": on the tower that they are."""
    towers = [b for b in scene.built if b.kind == "stack" and set(b.members) == set(mark.names)]
    alone = len(towers) == 1 and len(mark.names) > 1 and not mark.built and mark.op == "and" and mark.quant is None
    return replace(mark, built=(towers[0],)) if alone else mark


def _on(a: str, b: Operand, scene: Scene, span: Span) -> g.Goal:
    return _on_operand((a,), b, scene, span)


def _on_operand(a: Operand, b: Operand, scene: Scene, span: Span) -> g.Goal:
    if (
        not isinstance(a, Lowest | Highest)
        and not isinstance(b, Lowest | Highest)
        and len(a) == len(b) == 1
        and EACH not in (*a, *b)
    ):
        scene.stacked(a[0], b[0], span)
    return r.On(a=a, b=b, span=span)


def piled_on(names: tuple[str, ...], base: Operand, scene: Scene, span: Span) -> g.Goal:
    """ "Two blue blocks on top of the tower": one on the other, for there is no room; of look-alikes it does not
    matter which."""
    if len({_look(name, scene) for name in names}) > 1:
        raise refuse("ambiguous", "it is not said which of these is on which", span, "say what goes on what")
    first = _on_operand((names[0],), base, scene, span)
    return conj([first, *(_on(upper, (lower,), scene, span) for lower, upper in pairwise(names))], span)


def _several_on_one(theme: Ref, mark: Ref, scene: Scene, span: Span) -> g.Goal:
    """ "stack the green and the yellow block on the red one": a tower on it in the order named, if it says so."""
    raise refuse(
        "ambiguous", "several blocks on one: a tower of them in the order named, or all side by side on it?", span,
        "say which block goes on which",
    )  # fmt: skip


def _several_tops(mark: Ref) -> bool:
    return len(mark.built) == 1 and mark.built[0].kind == "wall" and mark.quant is None


def _on_a_wall(theme: Ref, mark: Ref, loc: Loc, span: Span) -> g.Goal:
    """ "On top of the wall": on any of its blocks, of which several are on top.

    Raises:
        Refusal: "ambiguous", of several blocks, or where it is denied.
    """
    if len(theme.names) != 1 or theme.quant is not None or loc.negated:
        raise refuse("ambiguous", "a wall has several blocks on top; it is not clear which are meant", loc.span,
                     "say it of one block, or name those below")  # fmt: skip
    return on_any(theme.names, mark.names, span)


def _tower_on(theme: Ref, mark: Ref, scene: Scene, span: Span) -> g.Goal:
    """A tower put on a block goes on with it: one stack."""
    tower = theme.built[0]
    base = crown(mark)
    if tower.ordered:
        return _on(tower.members[0], base, scene, span)
    return r.On(a=Lowest(lowest=tower.members), b=base, span=span)


def _under(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    direct = {"directly", "immediate"} & set(loc.mods)
    if theme.quant is not None or theme.op != "and" or theme.mixed:
        above = r.On if direct else r.Above
        if direct and theme.quant is not None:
            check_one_on_many(mark, theme.quant)
        marks = [foot(mark)] if mark.built else [(b,) for b in mark.names]
        return spread(theme, lambda a: conj([above(a=b, b=a, span=span) for b in marks], span), span)
    lower = crown(theme) if theme.built else theme.names
    upper: Operand = foot(mark) if mark.built else mark.names
    if (len(theme.names) > 1 and not theme.built) or (len(mark.names) > 1 and not mark.built):
        parts = [r.Above(a=(b,), b=(a,), span=span) for a in theme.names for b in mark.names]
        return conj(parts, span)
    if direct:
        return _on_operand(upper, lower, scene, span)
    if isinstance(upper, tuple) and isinstance(lower, tuple) and EACH not in (*upper, *lower):
        scene.on_top.setdefault(upper[0], lower[0])
    return r.Above(a=upper, b=lower, span=span)


def sandwich(one: str, inner: str, other: str, scene: Scene, span: Span) -> g.Goal:
    """A block stacked between two others, of which either is the lower one."""
    scene.assume("sandwiched means stacked: one below, one above")
    orders = [(one, inner, other), (other, inner, one)]
    if _look(one, scene) == _look(other, scene):
        orders = orders[:1]
    scene.add_built("stack", orders[0], len(orders) == 1, span)
    given = [Order(by="given", ranks=tuple((n,) for n in names)) for names in orders]
    nodes = [s.Stack(blocks=orders[0], order=order, span=span) for order in given]
    return nodes[0] if len(nodes) == 1 else g.Any(goals=tuple(nodes), span=span)


def _look(name: str, scene: Scene) -> tuple[object, ...]:
    thing = scene.things[name]
    return thing.color, thing.label, thing.size, thing.kind


def separately(spec: Spec, scene: Scene) -> None:
    """ "and two blue ones stacked separately": apart from the tower before, which a tower of its own is."""
    apart = [place for place in spec.places if isinstance(place, Loc) and place.rel == "apart"]
    inner = [place for place in apart if isinstance(place.landmark, Pronoun)]
    if inner and not scene.built:
        raise refuse("contradiction", "blocks of one tower are not apart", inner[0].span, "say 'towers', and how many")
    spec.places = [place for place in spec.places if place not in inner]


def stands_on(ref: Ref, theme: Ref, scene: Scene) -> bool:
    """ "Put red on blue, with green on top": on the one block that was put on something."""
    marks = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark"]
    single = len(ref.names) == 1 == len(theme.names) and not (ref.built or theme.built) and ref.names != theme.names
    return single and bool(marks) and all(m.rel == "on" for m in marks)
