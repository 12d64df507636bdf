"""Which blocks each of several structures is made of, where these are named or counted for all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace as changed

from rpg.language.meaning import Amount, Coord, Meaning, Noun, Size, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.members import certain
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse

Look = Noun | Coord | Structure | None
"""What is said of one of several structures."""


def shared_out(shape: Structure, looks: Sequence[Look], spec: Spec) -> Structure:
    """ "two towers from five orange blocks: one has three, the other two": of the blocks that are counted for all."""
    told = [look.amount for look in looks if isinstance(look, Noun) and look.amount is not None]
    stock = shape.members or (spec.usings[0].members if len(spec.usings) == 1 else None)
    if len(told) < len(looks) or not isinstance(stock, Noun) or stock.amount is None or shape.sizes:
        return shape
    if any(x.low != x.high for x in (*told, stock.amount)) or sum(x.low for x in told) != stock.amount.low:
        raise refuse("count-mismatch", f"this takes {sum(x.low for x in told)} blocks", stock.span,
                     "use as many blocks as are told of each")  # fmt: skip
    spec.usings = [] if shape.members is None else spec.usings
    return replace(shape, members=replace(stock, amount=None), each_size=False)


def of_all_of_them(
    shape: Structure, looks: Sequence[Look], spec: Spec, theme: Ref | None, scene: Scene
) -> tuple[Structure, Ref | None]:
    """ "Two rows from four red blocks": four are there for both, while "of four" says how many each has."""
    members = shape.members or (spec.usings[0].members if len(spec.usings) == 1 else None)
    items = members.items if isinstance(members, Coord) and members.op == "and" else (members,)
    amounts = [x.amount for x in items if isinstance(x, Noun) and x.amount is not None]
    stacked = shape.kind == "stack" and not spec.usings and not any(looks)  # "stack two cubes on each patch"
    each = shape.each_size or shape.sizes or shape.dims or stacked
    if theme is not None or each or members is None or len(amounts) < len(items):
        return shape, theme
    if any(x.low != x.high for x in amounts):
        return shape, theme
    told = any(look is not None and not _mere(look) for look in looks)
    if told and not (isinstance(members, Noun) and members.traits == Traits() and all(map(_colored, looks))):
        return shape, theme
    spec.usings = [] if shape.members is None else spec.usings
    if not told:
        theme = certain(refer(members, scene, Scope(role="member")), scene)
    many, left = divmod(amounts[0].low, len(looks))
    if told and left:
        raise refuse("ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
                     f"say how many blocks each {shape.kind} has")  # fmt: skip
    equal = len(amounts) == 1 and not left and (told or shape.kind in _LINES)
    sizes = (Size(what="size", amount=Amount(many, many), span=shape.span),) if equal else ()
    return replace(shape, members=None, sizes=sizes), theme


def _mere(look: Look) -> bool:
    """ "One (on the left)": of which neither a look nor a number is said."""
    return isinstance(look, Noun) and look.amount is None and look.traits == Traits() and look.part_of is None


def _colored(look: Look) -> bool:
    """Of which a colour is said, and no number."""
    return isinstance(look, Noun) and look.amount is None and look.traits == Traits(colors=look.traits.colors[:1])


def of_its_color(shape: Structure, looks: list[Look], there: Sequence[str], scene: Scene) -> list[Look]:
    """ "There are two red and four white blocks. Make two rows, red in front": each line has all of its colour."""
    if shape.kind not in _LINES or shape.sizes or shape.dims or shape.members or not all(map(_colored, looks)):
        return looks
    own = [x for x in looks if isinstance(x, Noun)]
    many = [sum(scene.things[n].color in x.traits.colors for n in there) for x in own]
    if min(many) < _FEWEST or len({x.traits.colors for x in own}) < len(own):
        return looks
    return [replace(x, amount=Amount(n, n)) for x, n in zip(own, many, strict=True)]


_FEWEST = 2
"""So many blocks are a line."""


def named_lots(theme: Ref | None, looks: Sequence[Look], scene: Scene) -> list[Ref | None]:
    """Which of the blocks that were named each line has, where it is told by their labels."""
    if theme is None or not all(isinstance(look, Noun) and look.traits.labels for look in looks):
        return []
    lots: list[Ref | None] = [
        Ref(names=tuple(n for n in theme.names if scene.things[n].label in look.traits.labels), span=theme.span)
        for look in looks
        if isinstance(look, Noun)
    ]
    shared = [n for lot in lots if lot is not None for n in lot.names]
    return lots if sorted(shared) == sorted(theme.names) else []


def lots_of(theme: Ref | None, count: int, shape: Structure, scene: Scene) -> list[Ref | None]:
    """The blocks of each, where they were named one lot after the other, or all look alike."""
    if theme is None:
        return [None] * count
    if len(theme.parts) == count and all(len(p.names) > 1 for p in theme.parts) and theme.op == "and":
        if shape.members is None:
            raise refuse("ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
                         f"say 'a {shape.kind} of ... and a {shape.kind} of ...'")  # fmt: skip
        return list(theme.parts)
    if shape.kind in _LINES and all(_open(scene.things[n]) for n in theme.names):
        theme = changed(theme, names=scene.fit(theme.names, _LENGTH * count))
    things = [scene.things[n] for n in theme.names]
    share, left = divmod(len(things), count)
    same = len({(t.color, t.label, t.kind, t.size) for t in things}) == 1 and theme.quant is None and not left
    if same and share > 1 and (shape.kind in _LINES or not any(t.elastic for t in things)):
        for thing in things:
            thing.scheme = thing.scheme or "same"
        return [Ref(names=theme.names[k * share : (k + 1) * share], span=theme.span) for k in range(count)]
    raise refuse(
        "ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
        f"say how many blocks each {shape.kind} has",
    )  # fmt: skip


_LINES = ("row", "line", "column")
_LENGTH = 3
"""So many blocks each line has, where nothing is said of them but that they stand in several lines."""


def _open(thing: Thing) -> bool:
    """A block that shows nothing, and of which no number is said."""
    return thing.elastic is not None and not (thing.label or thing.kind)


def in_turn(told: Meaning) -> Meaning:
    """ "(the back row is) red, white, blue": its blocks one by one, as one list of their looks."""
    items = told.items if isinstance(told, Coord) and told.op in ("then", "and") else ()
    nouns = [x for x in items if isinstance(x, Noun) and x.amount in (None, Amount(1, 1)) and x.det in ("bare", "a")]
    colors = tuple(c for x in nouns if x.traits == Traits(colors=x.traits.colors[:1]) for c in x.traits.colors)
    if not items or len(colors) < len(items):
        return told
    return Noun(head="any", plural=True, traits=Traits(colors=colors), span=told.span)


def as_long_as_listed(shape: Structure, looks: Sequence[Look], scene: Scene) -> Structure:
    """ "two rows: the far one red, white, blue, the near one black": all of them are as long as those listed."""
    long = {len(x.traits.colors or x.traits.labels) for x in looks if isinstance(x, Noun) and x.amount is None} - {0, 1}
    if len(long) != 1 or shape.sizes or shape.dims or shape.members or shape.kind not in ("row", "line", "column"):
        return shape
    many = Amount(min(long), min(long))
    if any(isinstance(x, Noun) and len(x.traits.colors or x.traits.labels) < many.low for x in looks):
        scene.assume(f"all {shape.kind}s are as long as those of which each block is told: {many.low} blocks")
    return replace(shape, sizes=(Size(what="size", amount=many, span=shape.span),))
