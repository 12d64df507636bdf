"""Structures: which blocks they are made of and the atom that says so."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.ir.schema import MAX_BLOCKS
from rpg.language.meaning import Amount, Coord, Noun, Size, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec, sort_adjuncts
from rpg.passes.schema.resolve.goals.spacing import gaps_of
from rpg.passes.schema.resolve.orders.alternating import as_listed
from rpg.passes.schema.resolve.orders.lengthened import lengthened
from rpg.passes.schema.resolve.orders.orders import order_of
from rpg.passes.schema.resolve.orders.pairwise import one_on_another
from rpg.passes.schema.resolve.orders.positions import alternatives
from rpg.passes.schema.resolve.orders.reading import legible
from rpg.passes.schema.resolve.orders.runs import rainbow_of
from rpg.passes.schema.resolve.structures import figures, grids, groups, lots, stepped, symbols, towers
from rpg.passes.schema.resolve.structures.extents import check_own_lines, check_total, dims_told, totals
from rpg.passes.schema.resolve.structures.heights import as_heights
from rpg.passes.schema.resolve.structures.several import each_of, one_by_one
from rpg.passes.schema.resolve.structures.slanting import check_slanting, slanting, slope_of
from rpg.passes.schema.resolve.structures.told_of_each import check_top
from rpg.passes.schema.resolve.things.from_stock import from_stock
from rpg.passes.schema.resolve.things.members import members_of
from rpg.passes.schema.resolve.things.spoken import SPOKEN_OF, exact_size, known_ones, other_of_two
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

Made = tuple[list[Built], list[g.Goal]]
Maker = Callable[[Structure, Spec, Ref | None, Scene, Scope], Made]


def refer_structure(shape: Structure, scene: Scene, scope: Scope) -> Ref:
    """A structure as a noun phrase: one spoken of before, or a new one (whose making joins the goal)."""
    known = known_ones(shape, scene, scope.role) if shape.det in SPOKEN_OF else other_of_two(shape, scene, scope.role)
    if known:
        if shape.amount is not None and shape.amount.low > len(known) and not shape.traits.rank:
            raise refuse(
                "count-mismatch", f"{shape.amount.low} are spoken of, but there are {len(known)}", shape.span,
                f"say {len(known)}", asked=shape.amount.low, there=len(known),
            )  # fmt: skip
        if len(known) > 1 and isinstance(shape.members, Coord):
            from rpg.passes.schema.resolve.things.refer import refer

            mine = set(refer(shape.members, scene, scope).names)
            scene.mentions.pop()
            known = [built for built in known if set(built.members) == mine][-1:] or known
        if len(known) > 1 and len({frozenset(built.members) for built in known}) == 1:
            known = [built for built in known if built.ordered][-1:] or known[-1:]  # told twice
        if len(known) > 1 and not shape.plural and shape.det not in ("each", "all"):
            raise refuse("ambiguous", f"there are {len(known)} of them", shape.span, "say which")
        names = tuple(dict.fromkeys(n for b in known for n in b.members))
        det = shape.det if shape.det in ("both", "all") else "the"
        return Ref(names=names, built=tuple(known), det=det, plural=len(known) > 1, each=shape.det == "each")
    several = any(built.kind == "towers" for built in scene.built)
    if several and shape.kind == "stack" and shape.det in ("each", "the", "both") and shape.members is None:
        raise refuse("ambiguous", "it is not clear which block is in which tower", shape.span,
                     "name the towers one by one")  # fmt: skip
    if shape.det == "the" or scope.role == "landmark" or scope.given:
        figures.check_built(shape)
    spec = Spec()
    built, goals = make(shape, spec, None, scene, scope)
    names = tuple(dict.fromkeys(n for b in built for n in b.members))
    ref = Ref(names=names, built=tuple(built), plural=len(built) > 1)
    if spec.absolutes:
        from rpg.passes.schema.resolve.places.placing import absolutes

        goals = [*goals, *absolutes(ref, spec, scene, scope)]
    if scope.start:
        scene.start_goals += goals
    else:
        scene.goals.setdefault(scene.clause, []).extend(goals)
    return ref


def make(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """Build a structure (or several) from `theme`, its own members, or new blocks."""
    if (shape.det == "other" and theme is None) or shape.traits.rank is not None:
        raise refuse("no-referent", "it is not clear what this is one of", shape.span,
                     "tell of all of them, as in 'there is a red tower of three and a blue tower of two'")  # fmt: skip
    shape = replace(
        shape,
        sizes=(*shape.sizes, *spec.sizes),
        dims=shape.dims or dims_told(shape, spec.sizes),
    )
    spec.sizes = []
    total = next((z for z in shape.sizes if z.what == "total"), None)
    shape = replace(shape, sizes=totals(shape))
    if shape.kind == "column" and any(z.what == "high" for z in shape.sizes):  # what has a height stands upright
        shape = replace(shape, kind="stack")
    if shape.details:
        inner = sort_adjuncts(shape.details)
        spec.orders, spec.spacings, spec.patterns = (
            [*inner.orders, *spec.orders],
            [*inner.spacings, *spec.spacings],
            [*inner.patterns, *spec.patterns],
        )
        spec.toward, spec.any_way = [*inner.toward, *spec.toward], spec.any_way or inner.any_way
        spec.viewed = spec.viewed or inner.viewed
        spec.absolutes, spec.manners = [*inner.absolutes, *spec.absolutes], [*inner.manners, *spec.manners]
        shape = replace(shape, details=())
    one_on_another(shape, spec)
    shape = _paged(as_listed(shape, spec, theme, scene), spec, theme)
    _known_sizes(shape)
    if shape.filled is False and shape.kind in _MASSIVE:
        raise refuse("unsupported-structure", f"a {shape.kind} has no hole here", shape.span, "say 'an outline square'")
    if shape.kind == "again":
        if not scene.built and any(m.clause < scene.clause for m in scene.mentions):
            raise refuse("no-referent", "it is not said in which other one", shape.span, "name the place")
        shape = replace(shape, kind=scene.built[-1].kind if scene.built else "pile")
    counted = not shape.plural and shape.det == "a" and amount_of(shape.members) is not None  # "a tower of five blocks"
    piles = ("stack", "pile", "again") if not counted else ()
    if shape.kind not in piles and any(p.unit == "stack" and p.different for p in spec.patterns):
        raise refuse(
            "misplaced", f"a {shape.kind} for each colour is not understood", shape.span, f"name each {shape.kind}"
        )
    maker = MAKERS.get(shape.kind)
    if maker is None:
        raise refuse("unsupported-structure", f"a {shape.kind} cannot be built from blocks here", shape.span)
    shape = lots.with_lots(shape, spec, scene)
    if any(o.by == "each" for o in spec.orders):
        return lots.each_made_of(shape, spec, theme, maker, scene, scope)
    shape = as_heights(shape, spec, theme)
    if one_by_one(shape, spec, scope.rel):
        check_own_lines(shape, scene)
        return each_of(shape, spec, theme, maker, scene, scope)
    check_slanting(spec.toward, shape.kind)
    built, goals = maker(shape, spec, theme, scene, scope)
    check_total(total, {name for one in built for name in one.members})
    return built, [*goals, *gaps_of(goals, spec)]


def _paged(shape: Structure, spec: Spec, theme: Ref | None) -> Structure:
    """ "two rows of three, in reading order": rows that are read one after the other make a grid."""
    many = shape.amount.low if shape.amount is not None and shape.amount.low == shape.amount.high else 1
    read = any(o.by == "paged" or (o.by == "in_order" and theme is not None) for o in spec.orders)
    if shape.kind != "row" or not shape.plural or many < 2 or not read or spec.absolutes:
        return shape
    inner = isinstance(shape.members, Noun) and shape.each_size
    long = shape.extent("size", "long", "columns") or (amount_of(shape.members) if inner else None)
    lines = [("rows", many), *([("columns", long)] if long else [])]
    sizes = tuple(Size(what=what, amount=Amount(n, n), span=shape.span) for what, n in lines)
    members = shape.members
    if isinstance(members, Noun) and inner:
        members = replace(members, amount=None)
    return replace(shape, kind="grid", plural=False, amount=None, sizes=sizes, members=members, each_size=False)


_MASSIVE = ("grid", "checkerboard", "cube", "wall", "pyramid", "staircase", "stack", "row", "line", "column", "pile")


_SIZES = {
    "stack": {"size", "high", "layers", "heights"}, "row": {"size", "long", "columns", "wide"},
    "line": {"size", "long", "columns", "wide"}, "column": {"size", "long", "columns"},
    "grid": {"size", "rows", "columns", "layers", "high", "wide", "long", "deep", "side", "dims"},
    "wall": {"size", "wide", "long", "columns", "high", "layers", "rows", "dims"},
    "pyramid": {"size", "base", "wide", "layers", "high", "dims"}, "staircase": {"size", "steps", "high", "layers"},
    "cube": {"dims", "side", "size", "wide", "deep", "high", "long", "layers"},
    "square": {"size", "side", "dims", "rows", "columns", "wide", "long", "deep", "layers", "high", "corners"},
    "rectangle": {"size", "dims", "rows", "columns", "wide", "long", "deep", "corners"},
    "triangle": {"size", "side", "corners", "rows", "base"}, "circle": {"size"},
    "checkerboard": {"dims", "rows", "columns", "size", "side"},
    "gradient": {"size", "long"}, "word": {"size"}, "T": {"size", "bar", "stem", "high", "wide"},
    "L": {"size", "long arm", "short arm", "equal arms", "each arm", "shared", "high", "long", "wide"},
    "U": {"size", "wide", "high", "deep"}, "plus": {"size", "each arm"},
}  # fmt: skip


def _known_sizes(shape: Structure) -> None:
    """Refuse sizes that the structure has no use for, and those that are beyond every table."""
    most = max((*shape.dims, *(size.amount.low for size in shape.sizes if size.amount is not None)), default=0)
    if most > MAX_BLOCKS:
        raise refuse(
            "too-many-blocks",
            f"this takes at least {most} blocks; a task has at most {MAX_BLOCKS}",
            shape.span,
            f"use at most {MAX_BLOCKS} blocks",
            blocks=most,
            limit=MAX_BLOCKS,
        )
    allowed = _SIZES.get(shape.kind, {"size"})
    if shape.kind in ("row", "line", "column") and not shape.plural and not (shape.amount and shape.amount.low > 1):
        allowed = allowed - {"columns"}
    for size in shape.sizes:
        if size.what not in allowed:
            raise refuse("misplaced", f"a {shape.kind} has no such size", size.span, "say how many blocks it has")


def _stack(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    if theme is not None and theme.quant is not None:
        raise refuse("misplaced", "a tower is built of certain blocks", shape.span, "say which blocks")
    check_top(shape, spec.absolutes)
    many = shape.plural or (shape.amount and (shape.amount.high or 2) > 1)
    if many or any(p.unit in ("stack", "pile") and p.different for p in spec.patterns):
        if shape.dims:
            raise refuse("misplaced", "several towers have no such size", shape.span, "say how high each of them is")
        return towers.several(shape, spec, theme, scene, scope)
    if shape.dims:
        return _thick(shape, spec, theme, scene, scope)
    spec.patterns = [p for p in spec.patterns if p.unit != "stack"]
    shape, theme = lengthened(from_stock(shape, spec, theme, scene), spec, theme, scene)
    need = exact_size(shape)
    source = shape.members or (spec.usings[0].members if spec.usings else None)
    least = shape.size is not None and shape.size.high is None
    if shape.size is not None and need is None and not least:
        raise refuse("ambiguous", "the height of the tower is left open", shape.span, "say one number, or 'at least'")
    if least and theme is not None:
        theme = replace(theme, names=_alike(theme, shape, scene)[: shape.size.low if shape.size else 2])
    if (
        theme is not None
        and need is not None
        and theme.names
        and len(theme.names) > need
        and not any(scene.things[n].elastic for n in theme.names)
    ):
        theme = replace(theme, names=_alike(theme, shape, scene)[:need])
    wanted = need if not least else shape.size.low if shape.size else None
    names = members_of(shape, spec, theme, wanted, amount_of(shape.members) or 3, scene, scope)
    if len(names) < 2:
        raise refuse("too-few", "a lone block is no tower", shape.span, "name at least two blocks", blocks=len(names))
    named = any(o.items and o.by != "alternating" for o in spec.orders)
    order = order_of(spec, names, "stack", scene, scope, shape.span)
    if order.by != "any":
        spec.toward = [t for t in spec.toward if t.axis != "z"]
    counted = (
        bool(need is not None or scene.excepted)  # "all but the red one": nor is that on top
        or (source is None and theme is None and not named)
        or (isinstance(source, Noun) and source.det in ("bare", "a", "some", "all but") and not _one_by_one(source))
    )
    nodes = [
        s.Stack(
            blocks=names,
            order=o,
            exact=counted and not least,
            readable=legible(o, names, spec, scene),
            span=shape.span,
        )
        for o in alternatives(order, scene)
    ]
    return [stack_built(nodes[0], scene) if len(nodes) == 1 else scene.add_built("stack", names, False, shape.span)], [
        either(nodes)
    ]


def _thick(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a 2x2 tower three layers high", "a 2x2x3 tower": layers of several blocks each."""
    if len(shape.dims) < 3 and not shape.extent("layers", "high"):
        raise refuse("ambiguous", "it is not said how many layers this tower has", shape.span, "say '2x2x3'")
    scene.assume("a tower whose layers have several blocks is a block of them, each right above another")
    return grids.grid(replace(shape, kind="grid"), spec, theme, scene, scope)


def _one_by_one(source: Noun) -> bool:
    """ "a tower of red, blue, red": its blocks are named, and others may lie on top."""
    return source.head == "any" and source.amount is None and len(source.traits.colors) > 1


def _alike(theme: Ref, shape: Structure, scene: Scene) -> tuple[str, ...]:
    """Blocks of which some are to be chosen must look alike, so that it does not matter which."""
    looks = {(t.color, t.label, t.kind, t.size) for t in (scene.things[n] for n in theme.names)}
    if len(looks) > 1 or theme.quant is not None:
        raise refuse(
            "count-mismatch",
            f"it is not said which of {len(theme.names)} different blocks are used",
            shape.span,
            "name the blocks",
            blocks=len(theme.names),
        )
    for name in theme.names:
        scene.things[name].scheme = scene.things[name].scheme or "same"
        scene.spare.add(name)
    return theme.names


def either(nodes: Sequence[s.Stack | s.Row]) -> g.Goal:
    """One of several ways to fill the free places of an order."""
    return nodes[0] if len(nodes) == 1 else g.Any(goals=tuple(nodes), span=nodes[0].span)


def stack_built(node: s.Stack, scene: Scene) -> Built:
    """Remember a stack, bottom first where its order is fixed block by block."""
    order = node.order
    if order.by == "given" and all(len(r) == 1 for r in order.ranks):
        names = tuple(r[0] for r in order.ranks)
        if order.first == "top":
            names = names[::-1]
        for upper, lower in zip(names[1:], names[:-1], strict=True):
            scene.on_top[upper] = lower
        return scene.add_built("stack", names, True, node.span or (0, 0))
    return scene.add_built("stack", node.blocks, False, node.span or (0, 0))


def _row(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    if shape.upright:
        raise refuse("ambiguous", "a vertical row could be a tower, or a column on the table going away from you",
                     shape.span, "say 'tower' or 'column'")  # fmt: skip
    if any(t.axis == "z" for t in spec.toward) and (shape.kind == "line" or shape.kind == "column"):
        return _stack(replace(shape, kind="stack"), spec, theme, scene, scope)
    shape, theme = lengthened(from_stock(shape, spec, theme, scene), spec, theme, scene)
    least = shape.size.low if shape.size is not None and shape.size.high is None else None
    names = members_of(shape, spec, theme, exact_size(shape) or least, amount_of(shape.members) or 4, scene, scope)
    if len(names) < 2:
        raise refuse("too-few", "one block is no line", shape.span, "name at least two blocks", blocks=len(names))
    slope = slope_of(spec, shape.kind, shape.span)
    node = row_node(names, shape.kind, spec, scene, scope, shape.span, shape.upright is False)
    nodes = [slanting(node, slope, order) for order in alternatives(node.order, scene, line=True)]
    if len(nodes) > 1:
        return [scene.add_built(shape.kind, names, False, shape.span)], [either(nodes)]
    return [row_built(nodes[0], shape.kind, scene)], [*nodes]


def _gradient(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a colour gradient": a line in the order of the rainbow."""
    spec.orders = [rainbow_of(shape, spec), *[o for o in spec.orders if o.by != "rainbow"]]
    return _row(replace(shape, kind="line"), spec, theme, scene, scope)


def row_built(node: s.Row, kind: str, scene: Scene) -> Built:
    """Remember a row."""
    order = node.order
    fixed = order.by == "given" and all(len(r) == 1 for r in order.ranks)
    names = tuple(r[0] for r in order.ranks) if fixed else node.blocks
    return scene.add_built(kind, names, fixed, node.span or (0, 0), order.first)


def row_node(
    names: tuple[str, ...], kind: str, spec: Spec, scene: Scene, scope: Scope, span: Span, flat: bool = False
) -> s.Row:
    """The atom of a line with its order, direction and spacing."""
    order = order_of(spec, names, kind, scene, scope, span)
    if kind == "column" and (order.first in ("left", "right") or any(t.axis == "y" for t in spec.toward)):
        raise refuse("contradiction", "a column goes from front to back", span, "say 'a row'")
    axis = next((t.axis for t in spec.toward if t.axis in ("x", "y")), None)
    spec.toward = []
    if axis is None:
        axis = {"left": "y", "right": "y", "front": "x", "back": "x"}.get(order.first or "")
    if axis is None:
        axis = "x" if kind == "column" else "y" if (kind == "row" and not spec.any_way) or flat else None
    options: dict[str, object] = {}
    for spacing in spec.spacings:
        options["evenly" if spacing.kind == "even" else "touching"] = True
    spec.spacings = []
    for place in list(spec.places):
        if (
            getattr(place, "rel", "") in ("distance", "side_by_side", "adjacent", "touching", "heaped_row")
            and not getattr(place, "negated", False)
            and getattr(getattr(place, "landmark", None), "word", "") == "each other"
        ):
            spec.places.remove(place)
            if any(isinstance(getattr(x, "landmark", None), Structure) and x.span < place.span for x in spec.places):
                raise refuse("ambiguous", "of the blocks of this line, or of the two structures?", place.span,
                             "say it right behind the line, or in a sentence of its own")  # fmt: skip
            options.update(_spaced(place))
    readable = legible(order, names, spec, scene)
    return s.Row(blocks=names, axis=axis, order=order, readable=readable, span=span, **options)  # type: ignore[arg-type]


def _spaced(place: object) -> dict[str, object]:
    rel, low, high = getattr(place, "rel", ""), getattr(place, "low", None), getattr(place, "high", None)
    if rel == "touching":
        return {"touching": True}
    if rel == "side_by_side":
        return {"gap_edges": 1.0}
    if rel == "adjacent":
        return {"gap_edges": 0.5}
    if low is None and high is not None and getattr(place, "measure", "") == "faces":
        low = 0.0  # "gaps of at most 5 mm": none is fine, too
    if low is None or high is None:
        raise refuse(
            "ambiguous", "the spacing of a row is one distance", getattr(place, "span", None), "say '5 cm apart'"
        )
    key = "gap" if getattr(place, "measure", "") == "faces" else "spacing"
    return {key: round((low + high) / 2, 6), "tolerance": round((high - low) / 2, 6)}


MAKERS: dict[str, Maker] = {
    "stack": _stack,
    **dict.fromkeys(("row", "line", "column"), _row),
    "gradient": _gradient,
    "pile": groups.piles,
    "word": symbols.word,
    "equation": symbols.equation,
    **dict.fromkeys(("square", "rectangle", "triangle", "circle", "L", "T", "V", "U", "plus", "X"), figures.figure),
    "grid": grids.grid,
    "checkerboard": grids.grid,
    "cube": grids.grid,
    "wall": grids.wall,
    "pyramid": stepped.pyramid,
    "staircase": stepped.staircase,
}

__all__ = ["Order", "make", "refer_structure", "row_built", "row_node", "stack_built"]
