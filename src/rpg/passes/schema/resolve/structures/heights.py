"""Several towers of which the heights are told: "three towers of heights 2, 3 and 4", "... from left to right"."""

from __future__ import annotations

from itertools import accumulate, pairwise

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Lowest
from rpg.language.meaning import Loc, Noun, Places, Size, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.members import certain, declared, new_members
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

Made = tuple[list[Built], list[g.Goal]]


def of_heights(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> Made:
    """Towers of these heights, in the order in which they are told where a direction is said."""
    said = next(z for z in shape.sizes if z.what == "heights")
    heights, total = said.dims, sum(said.dims)
    count = shape.amount.low if shape.amount and shape.amount.low > 1 else len(heights)
    if len(shape.sizes) > 1 or count != len(heights) or spec.patterns or spec.orders or shape.traits.scheme:
        raise refuse("count-mismatch", f"{len(heights)} heights are said, but not of as many towers", said.span,
                     "say the height of each tower", heights=len(heights), towers=count)  # fmt: skip
    way = spec.first("left", "right", "front", "back")
    if way is None and any(t.axis == "y" for t in spec.toward):
        scene.assume("the heights are read from left to right")
        way = "left"
    if max(heights) < 2:
        raise refuse("too-few", "a lone block is no tower", said.span, "say at least two blocks for each")
    names = _blocks(shape, spec, theme, total, scene)
    if len(names) != total:
        raise refuse("count-mismatch", f"these towers take {total} blocks, but {len(names)} are named", said.span,
                     f"use {total}", needed=total, named=len(names))  # fmt: skip
    to_each_other = any(getattr(p.landmark, "word", "") == "each other" for p in spec.places if isinstance(p, Loc))
    if way is not None or min(heights) < 2 or to_each_other:
        spec.toward = []
        return _in_order(heights if way in ("left", "front", None) else heights[::-1], way, names, said, scene)
    node = s.Towers(blocks=names, count=count, heights=heights, span=shape.span)
    scene.heights[names] = heights
    return [scene.add_built("towers", names, False, node.span or (0, 0))], [node]


def as_heights(shape: Structure, spec: Spec, theme: Ref | None) -> Structure:
    """ "(stack these blocks into) two towers, one three high and one two high": of whichever of the blocks each is."""
    looks = [x.theme for x in spec.absolutes]
    places = [x.adjuncts[0] for x in spec.absolutes if len(x.adjuncts) == 1]
    told = tuple(x.amount.low for x in looks if isinstance(x, Noun) and x.amount and x.amount.low == x.amount.high)
    mere = all(isinstance(x, Noun) and x.traits == Traits() and x.part_of is None for x in looks)
    one_each = all(isinstance(x, Places) and x.side == "one" and x.unit.startswith("whole") for x in places)
    many = shape.amount.low if shape.amount is not None else 0
    if shape.kind != "stack" or not mere or not one_each or shape.sizes or shape.members is not None:
        return shape
    if theme is None and 1 not in told:
        return shape
    if len(told) < 2 or not len(told) == len(looks) == len(places) == many:
        return shape
    spec.absolutes = []
    return replace(shape, sizes=(Size(what="heights", dims=told, span=shape.span),))


def _blocks(shape: Structure, spec: Spec, theme: Ref | None, total: int, scene: Scene) -> tuple[str, ...]:
    source = shape.members or (spec.usings.pop(0).members if spec.usings else None)
    if theme is None and source is not None:
        theme = certain(refer(source, scene, Scope(role="member", need=total)), scene)
    names = theme.names if theme is not None else declared(shape.traits, scene)
    return scene.fit(names, total) if names else new_members(shape.traits, total, None, scene)


def _in_order(heights: tuple[int, ...], way: str | None, names: tuple[str, ...], said: Size, scene: Scene) -> Made:
    """Each beside the next one: "3, 2 and 1 blocks from left to right", where one block stands by itself; with no way
    told, wherever each stands."""
    things = [scene.things[name] for name in names]
    if len({(t.color, t.label, t.kind, t.size, t.edge) for t in things}) > 1:
        raise refuse("ambiguous", "it is not said which blocks are in which tower", said.span,
                     "say of which blocks each tower is")  # fmt: skip
    for thing in things:
        thing.scheme = thing.scheme or "same"
    lots = [names[a:b] for a, b in pairwise((0, *accumulate(heights)))]
    goals: list[g.Goal] = []
    for lot in lots:
        alone: list[g.Goal] = [r.OnTable(a=lot, span=said.span), r.Clear(a=lot, span=said.span)]
        goals += alone if len(lot) == 1 else [s.Stack(blocks=lot, exact=True, span=said.span)]
    built = [scene.add_built("stack", lot, False, said.span) for lot in lots]
    if way is None:
        return built, goals
    node: type[r.LeftOf | r.InFrontOf] = r.LeftOf if way in ("left", "right") else r.InFrontOf
    feet = [lot if len(lot) == 1 else Lowest(lowest=lot) for lot in lots]
    goals += [node(a=a, b=b, span=said.span) for a, b in pairwise(feet)]
    ends = ("left", "right") if way in ("left", "right") else ("front", "back")
    scene.sides.update({built[0].key: ends[0], built[-1].key: ends[1]})
    return built, goals
