"""Several structures of one kind at once: "two pyramids", "two rows of three, the left one red"."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from itertools import pairwise

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.language.meaning import (
    Absolute,
    Amount,
    Coord,
    In,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Size,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.looks_of_each import beside_others, sided, told_looks, whole
from rpg.passes.schema.resolve.structures.rows_apart import close_by, not_one_line, on_the_table, own_unit, too_alike
from rpg.passes.schema.resolve.structures.sharing import (
    Look,
    as_long_as_listed,
    lots_of,
    named_lots,
    of_all_of_them,
    of_its_color,
    shared_out,
)
from rpg.passes.schema.resolve.things.from_stock import several_from_stock
from rpg.passes.schema.resolve.things.members import declared
from rpg.passes.schema.resolve.things.operands import foot
from rpg.passes.schema.resolve.things.things import amount_of, matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

Made = tuple[list[Built], list[g.Goal]]
Maker = Callable[[Structure, Spec, Ref | None, Scene, Scope], Made]
APART = ("stack", "pile", "word", "equation")
"""Kinds that have a way of their own with several at once."""
COLORS = ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink", "brown", "white", "black", "gray")
MOST = 6
LENGTH = 3
"""Blocks in each of several rows of which nothing is said."""


def one_by_one(shape: Structure, spec: Spec, rel: str) -> bool:
    """Whether each of several structures is made by itself. `rel`: the relation that they are the landmark of."""
    if not shape.plural and not (shape.amount and shape.amount.low > 1):
        return False
    if shape.kind != "stack":
        return shape.kind not in APART
    if any(z.what == "heights" for z in shape.sizes):
        return False  # which are told apart by these
    apart = _to_each_other(spec) or ((spec.lined or _own_places(spec)) and not spec.patterns)
    apart = apart or _are_ends(shape, spec, rel)
    told = any(whole(x) is not None or beside_others(x) for x in spec.absolutes)
    return sided(spec) is not None or told or apart


def _own_places(spec: Spec) -> bool:
    """ "Three stacks of two, each on its own patch", "in each corner": each of them is somewhere else."""
    marks = [p.landmark for p in spec.places if isinstance(p, Loc) and p.rel == "on" and not p.negated]
    mats = any(isinstance(m, Noun) and (m.det == "each" or _own(m)) and m.head == "patch" for m in marks)
    return mats or _in_corners(spec)


def _in_corners(spec: Spec) -> bool:
    return any(isinstance(p, In) and p.region.startswith("each_corner") and not p.negated for p in spec.places)


def _own(mark: Noun) -> bool:
    return mark.traits.scheme == "different" and not mark.traits.colors


def _to_each_other(spec: Spec) -> bool:
    """Whether several towers stand in a relation to each other, so that they must be told apart."""
    related = any(getattr(getattr(p, "landmark", None), "word", "") == "each other" for p in spec.places)
    return related and not spec.patterns and not any(m.kind == "equal" for m in spec.manners)


def _are_ends(shape: Structure, spec: Spec, rel: str) -> bool:
    """Whether something stands between two towers, so that they must be told apart."""
    held = any(
        isinstance(a, Loc) and a.rel == "between" for x in _with_what_is_between(shape, spec) for a in x.adjuncts
    )
    return shape.amount == Amount(2, 2) and not spec.patterns and (held or rel == "between")


def _with_what_is_between(shape: Structure, spec: Spec) -> list[Absolute]:
    """What is told beside structures, with "a green block in between" of two of them as one between them."""
    if shape.amount != Amount(2, 2):
        return spec.absolutes
    between = Loc(rel="between", landmark=Pronoun(word="them", span=(0, 0)), span=(0, 0))
    inside = Places(side="rest", unit="block", span=(0, 0))
    told = [(x, x.adjuncts[0].span) for x in spec.absolutes]
    return [
        replace(x, adjuncts=(replace(between, span=at),)) if x.adjuncts == (replace(inside, span=at),) else x
        for x, at in told
    ]


def each_of(shape: Structure, spec: Spec, theme: Ref | None, maker: Maker, scene: Scene, scope: Scope) -> Made:
    """So many structures, each with its own blocks."""
    count = shape.amount.low if shape.amount else 2
    if shape.amount is None:
        scene.assume(f"the number of {shape.kind}s is not said: {count}")
    if (
        count > MOST
        or (shape.kind == "cube" and not shape.dims)
        or (shape.amount is not None and shape.amount.low != shape.amount.high)
    ):
        raise refuse("unsupported-structure", f"so many {shape.kind}s at once are not understood", shape.span,
                     f"name each {shape.kind} by itself")  # fmt: skip
    _one_gap(shape, spec)
    spec.absolutes = _with_what_is_between(shape, spec)
    shape, theme = several_from_stock(shape, count, spec, theme, scene)
    for place in filter(None, map(whole, spec.absolutes)):
        own_unit(shape, place)
    looks, axis = _looks(shape, spec, theme, count, scene)
    shape = as_long_as_listed(shared_out(shape, looks, spec), looks, scene)
    shape, theme = of_all_of_them(shape, looks, spec, theme, scene)
    sized = bool(shape.sizes or shape.dims or amount_of(shape.members))
    told = all(isinstance(look, Structure) for look in looks)  # words are as long as they are
    if not told and not any(isinstance(look, Noun) and look.amount is not None for look in looks):
        shape = _fresh(shape, theme, count, scene)
    lots = named_lots(theme, looks, scene) or lots_of(theme, count, shape, scene)
    built, goals = list[Built](), list[g.Goal]()
    color: tuple[str, ...] = ()
    for index in range(count):
        color = color if color and _in_corners(spec) else _color(shape, spec, theme, looks, scene, scope)
        own = _copied(spec)
        look = _spelling(shape, said_of) if isinstance(said_of := looks[index], Structure) else said_of
        if isinstance(look, Noun) and _listed(look):
            single = _told_in_order(shape, look, lots[index], own, scene)
            more, atoms = maker(single, own, lots[index], scene, scope)
            if isinstance(looks[index], Structure):
                atoms = [x.model_copy(update={"readable": True}) if isinstance(x, s.Row) else x for x in atoms]
            own.orders = [o for o in own.orders if o.by != "named"]
        else:
            single = _piled(shape, look, own, scene) if isinstance(look, Coord) else _single(shape, look, color)
            more, atoms = maker(single, own, lots[index], scene, scope)
            own.orders = [] if isinstance(look, Coord) else own.orders
        built += more
        goals += [close_by(x, scene) for x in atoms]
        if color:
            (scene.painted if sized else scene.vague).update(n for b in more for n in b.members)
    members = [n for b in built for n in b.members]
    _as_long_as_told(built, own, shape)
    if len(set(members)) < len(members):
        raise refuse("ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
                     f"say how many blocks each {shape.kind} has")  # fmt: skip
    spec.orders, spec.patterns, spec.spacings, spec.toward, spec.usings = (
        own.orders, own.patterns, own.spacings, own.toward, [],
    )  # fmt: skip
    spec.absolutes, spec.manners = own.absolutes, own.manners
    if axis is not None:
        return built, goals + _side_by_side(built, axis, shape, scene)
    if (grid := too_alike(goals, scene, shape.span)) is not None:
        return built, [grid]
    return built, goals + not_one_line(goals, on_the_table(shape, scene))


def _looks(shape: Structure, spec: Spec, theme: Ref | None, count: int, scene: Scene) -> tuple[list[Look], str | None]:
    """What is said of each, with how many blocks of its colour there are, and the axis along which they lie."""
    there = declared(Traits(), scene) if theme is None else ()
    known = dict.fromkeys(scene.things[n].color for n in there or (theme.names if theme is not None else ()))
    looks, axis = told_looks(spec, count, shape.kind, list(filter(None, known)))
    return of_its_color(shape, looks, there, scene), axis


def _as_long_as_told(built: list[Built], own: Spec, shape: Structure) -> None:
    """Refuse "of different lengths" of structures that are equally long, and the other way round."""
    lengths = {len(b.members) for b in built}
    if (unequal := own.manner("unequal")) is not None and len(lengths) < len(built):
        raise refuse("contradiction", f"these {shape.kind}s are not told to differ so", unequal.span, "leave it out")
    if (equal := own.manner("equal")) is not None and len(lengths) > 1:
        raise refuse("contradiction", f"these {shape.kind}s are not equally long", equal.span, "leave it out")


def _side_by_side(built: list[Built], axis: str, shape: Structure, scene: Scene) -> list[g.Goal]:
    """Each in front of the next one, or on its left, as their places were told."""
    ends = ("left", "right") if axis == "y" else ("front", "back")
    scene.sides.update({built[0].key: ends[0], built[-1].key: ends[1]})
    if len(built) == 3:
        scene.sides[built[1].key] = "middle"
    node: type[r.LeftOf | r.InFrontOf] = r.LeftOf if axis == "y" else r.InFrontOf
    feet = [foot(Ref(names=b.members, built=(b,))) for b in built]
    return [node(a=a, b=b, span=shape.span) for a, b in pairwise(feet)]


def _spelling(shape: Structure, look: Structure) -> Noun:
    """ "two rows of three: the far row spells CAT": its letters, read in this order; other rows may lie close by."""
    size = shape.extent("size", "long", "columns") or amount_of(shape.members)
    if shape.kind not in ("row", "line") or (size is not None and size != len(look.letter or "")):
        raise refuse("count-mismatch", f"{look.letter} has {len(look.letter or '')} letters", look.span,
                     f"say so of a {shape.kind} of as many blocks", letters=len(look.letter or ""))  # fmt: skip
    letters = Traits(labels=tuple(look.letter or ""), kind="letter")
    return Noun(head="block", plural=True, traits=letters, span=look.span)


def _listed(look: Noun) -> bool:
    """ "letters A to D", "red, green, blue": the blocks of one of several lines, one by one."""
    return look.amount is None and max(len(look.traits.labels), len(look.traits.colors)) > 1


def _told_in_order(shape: Structure, look: Noun, lot: Ref | None, own: Spec, scene: Scene) -> Structure:
    """One of several lines whose blocks are listed: in this order, unless another one is said.

    Its blocks are none of those that another line has.
    """
    marks = look.traits
    looks = [replace(marks, labels=(x,)) for x in marks.labels] or [replace(marks, colors=(c,)) for c in marks.colors]
    if not own.orders and shape.kind in ("row", "line", "column"):
        items = tuple(Noun(head="any", traits=one, span=look.span) for one in looks)
        own.orders = [OrderBy(by="named", items=items, span=look.span)]
    used = {n for b in scene.built for n in b.members}
    others = tuple(_further(Noun(head="any", traits=one, span=look.span), used, scene) for one in looks)
    members: Meaning = look
    if any(isinstance(item, Noun) and item.det == "another" for item in others):
        members = Coord(op="and", items=tuple(map(_alone, others)), span=look.span)
    return replace(shape, plural=False, amount=Amount(1, 1), det="a", members=None if lot is not None else members)


def _alone(item: Meaning) -> Meaning:
    return replace(item, amount=Amount(1, 1)) if isinstance(item, Noun) else item


def _piled(shape: Structure, look: Coord, own: Spec, scene: Scene) -> Structure:
    """ "the left one red on yellow": a tower of these blocks, which are none of those that another one has."""
    if look.op != "piled":
        raise refuse("misplaced", "it is not clear in which order these are", look.span, "name the order of each")
    shape = _of_so_many(shape, len(look.items))
    if shape.kind != "stack" or shape.members is not None or shape.sizes or shape.traits != Traits() or own.orders:
        raise refuse("misplaced", "this does not fit what is said of all of them", look.span, "say it of towers alone")
    used = {n for b in scene.built for n in b.members}
    items = tuple(_further(item, used, scene) for item in look.items)
    own.orders = [OrderBy(by="named", items=items, first="top", span=look.span)]
    return replace(shape, plural=False, amount=Amount(1, 1), det="a")


def _of_so_many(shape: Structure, count: int) -> Structure:
    """ "two towers of two: red on blue and green on white": as many in each as are named."""
    members, alone = shape.members, {Amount(count, count)}
    bare = isinstance(members, Noun) and members.traits == Traits() and members.det == "bare" and shape.each_size
    if bare and {getattr(members, "amount", None), *(z.amount for z in shape.sizes)} == alone:
        return replace(shape, members=None, sizes=(), each_size=False)
    said = {z.amount for z in shape.sizes if z.what in ("size", "high", "layers")}
    return replace(shape, sizes=()) if said == alone and len(said) == len(shape.sizes) else shape


def _further(item: Meaning, used: set[str], scene: Scene) -> Meaning:
    if isinstance(item, Noun) and any(t.name in used for t in matching(item.traits, scene, False)):
        return replace(item, det="another", amount=Amount(1, 1))
    return item


def _one_gap(shape: Structure, spec: Spec) -> None:
    """ "two rows of three blocks with a gap of 5 cm": between the rows or between the blocks?"""
    gaps = [p for p in spec.places if isinstance(p, Loc) and p.rel == "distance" and p.measure == "faces"]
    if gaps and shape.kind in ("row", "line", "column"):
        raise refuse("ambiguous", f"the gap could be between the {shape.kind}s or between their blocks", gaps[0].span,
                     f"build each {shape.kind} in a sentence of its own")  # fmt: skip


def _copied(spec: Spec) -> Spec:
    """The same words for each, but for where they are: what one of them uses is there for the next one too."""
    own = copy(spec)
    for name, value in vars(own).items():
        if isinstance(value, list):
            setattr(own, name, list(value))
    own.places = []
    return own


def _fresh(shape: Structure, theme: Ref | None, count: int, scene: Scene) -> Structure:
    """ "two rows of red blocks": blocks of which no number is said are others for each. "Twelve blocks in three rows":
    as many in each."""
    source = shape.members
    if isinstance(source, Noun) and _plain(source) and shape.traits in (Traits(), source.traits):
        shape = replace(shape, members=None, traits=source.traits)
    many = len(theme.names) // count if theme is not None and not len(theme.names) % count else 0
    if shape.kind in ("row", "line", "column") and shape.members is None and not shape.sizes and many > 1:
        shape = replace(shape, sizes=(Size(what="size", amount=Amount(many, many), span=shape.span),))
    elif shape.kind in ("row", "line", "column") and shape.members is None and not shape.sizes:
        scene.assume(f"the length of the {shape.kind}s is not said: {LENGTH} blocks each")
        shape = replace(shape, sizes=(Size(what="size", amount=Amount(LENGTH, LENGTH), span=shape.span),))
    return shape


def _plain(source: Noun) -> bool:
    """Blocks of a look alone: no number of them is said, none of them are named."""
    if source.amount is not None or source.det not in ("bare", "some") or source.traits.labels:
        return False
    return not source.conditions and source.part_of is None


def _single(shape: Structure, look: Noun | None, color: tuple[str, ...]) -> Structure:
    members = shape.members
    if look is not None and (look.traits.size or look.traits.edge):
        if members is not None and not _unsized(members):
            raise refuse("ambiguous", "it is not clear which blocks are so large", look.span, "name each by itself")
        told = replace(look, det="bare", head="block", traits=replace(look.traits, colors=look.traits.colors or color))
        return replace(shape, plural=False, amount=Amount(1, 1), det="a", members=told)
    colors = look.traits.colors if look is not None and look.traits.colors else color
    if look is not None and look.amount is not None:
        if (members is not None and not _unsized(members)) or shape.sizes:
            raise refuse("contradiction", "two sizes are given", look.span, "keep one of them")
        if isinstance(members, Noun):
            members = replace(members, amount=look.amount)
        shape = shape if members else replace(shape, sizes=(Size(what="size", amount=look.amount, span=look.span),))
    if isinstance(members, Noun):
        own = members.traits.colors
        if look is not None and own and colors and own != colors:
            raise refuse("contradiction", "two colours are given for the same blocks", look.span, "keep one of them")
        amount = amount_of(members)
        fixed = Amount(amount, amount) if amount is not None else None
        members = replace(members, amount=fixed, det="bare", traits=replace(members.traits, colors=own or colors))
        return replace(shape, plural=False, amount=Amount(1, 1), det="a", members=members)
    traits = replace(shape.traits, colors=shape.traits.colors or colors)
    if look is not None and colors and shape.traits.colors not in ((), colors):
        raise refuse("contradiction", "two colours are given for the same blocks", look.span, "keep one of them")
    return replace(shape, plural=False, amount=Amount(1, 1), det="a", traits=traits)


def _unsized(members: Meaning) -> bool:
    """ "two towers of purple blocks": of which no number is said."""
    return isinstance(members, Noun) and members.amount is None and members.det == "bare" and not members.traits.labels


def _color(
    shape: Structure, spec: Spec, theme: Ref | None, looks: list[Look], scene: Scene, scope: Scope
) -> tuple[str, ...]:
    """A colour of its own for each that is to be built, where nothing is said of the blocks' looks."""
    members = shape.members
    if scope.given or isinstance(members, Coord):
        return ()  # "three towers of a big and a small cube"
    said = members.traits if isinstance(members, Noun) else Traits()
    plain = (
        replace(said, scheme=None) == Traits() and shape.traits == Traits() and (members is None or said == Traits())
    )
    if not plain or theme is not None or spec.usings or spec.orders or spec.patterns or any(looks) or _there(scene):
        return ()
    long = shape.extent("size", "long", "columns")
    if long and shape.amount and any(len(b.members) == long * shape.amount.low for b in scene.built):
        raise refuse("ambiguous", "these could be the blocks named before, or further ones", shape.span,
                     "say 'another' of further ones, or what the structure is made of in one phrase")  # fmt: skip
    taken = {t.color for t in scene.blocks()} | (scene.colors if spec.absolutes else frozenset())
    free = [c for c in COLORS if c not in taken]
    scene.assume(f"the colours are not said: one for each {shape.kind}")
    return (free[0],) if free else ()


def _there(scene: Scene) -> bool:
    return bool(declared(Traits(), scene))
