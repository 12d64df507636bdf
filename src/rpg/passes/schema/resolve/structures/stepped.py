"""Pyramids and staircases."""

from __future__ import annotations

from collections import Counter

from rpg.blocks.figures import pyramid_size
from rpg.ir import structures as s
from rpg.ir.order import Pattern
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Coord,
    Loc,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Structure,
    Toward,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.parts import cells_of, laid, widened
from rpg.passes.schema.resolve.structures.extents import Made, made, plain, said_count
from rpg.passes.schema.resolve.structures.patterns import pattern_of
from rpg.passes.schema.resolve.things.members import members_of
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def pyramid(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a pyramid with a 3x3 base", "a pyramid of six blocks"."""
    if shape.extent("wide") is not None:  # "four blocks wide at the bottom"
        spec.ats = [at_ for at_ in spec.ats if at_.side != "bottom" or at_.index is not None]
    spec.absolutes = [part for item in spec.absolutes for part in _topped(item)]
    plain(shape)
    told = [x for x in spec.absolutes if _level(x) is not None]
    _looks_of_each(shape, told)
    base = _base(shape, spec, theme, scene)
    layers = min(base) if base[1] > 1 else base[0]
    if any(shape.extent(what) not in (None, layers) for what in ("layers", "high")):
        raise refuse("contradiction", f"such a pyramid has {layers} layers", shape.span, f"say {layers} layers")
    need = pyramid_size(base)
    upon = [x for x in spec.absolutes if _is_upon(x, shape, need)]
    spec.absolutes = [x for x in spec.absolutes if x not in upon]
    _in_their_layers(told, base)
    _numbered(spec, base)
    form = s.Pyramid(blocks=("",), base=base)
    shape = widened(shape, spec, theme, form, need, scene)
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, (base[1], base[0], layers), scene, scope, form)
    for item in upon:
        on_it = Loc(rel="on", landmark=Pronoun(word="it", span=item.span), span=item.span)
        spec.absolutes.append(replace(item, adjuncts=(on_it,)))
    node = s.Pyramid(blocks=names, base=base, pattern=pattern, readable=readable, span=shape.span)
    return made("pyramid", node, names, shape.span, scene)


def _is_upon(item: Absolute, shape: Structure, need: int) -> bool:
    """ "A pyramid of three blue cubes with a yellow one on top": on the whole one, which is blue."""
    blocks, further, place = shape.members, item.theme, item.adjuncts[0]
    if not isinstance(blocks, Noun) or not isinstance(further, Noun) or not isinstance(place, At):
        return False
    one = further.det in ("a", "bare") and not further.plural and further.amount in (None, Amount(1, 1))
    looks = blocks.traits.colors, further.traits.colors
    on_top = place.side == "top" and place.index is None
    return blocks.amount == Amount(need, need) and on_top and one and all(looks) and looks[0] != looks[1]


def _looks_of_each(shape: Structure, told: list[Absolute]) -> None:
    """Refuse "two red blocks at the bottom and a block on top": is that one red as well?"""
    themes = [x.theme for x in told if isinstance(x.theme, Noun)]
    bare = [x for x in themes if x.head == "block" and x.traits == Traits()]
    if bare and any(x.traits.colors for x in themes) and shape.members is None and not shape.traits.colors:
        raise refuse(
            "ambiguous", "it is not said how these blocks look", bare[0].span, "say of all layers how they look"
        )


def _topped(item: Absolute) -> list[Absolute]:
    """ "two white blocks and a black one on top": of two lots the last one is on top, and the first one below."""
    place = _level(item)
    lots = item.theme.items if isinstance(item.theme, Coord) and item.theme.op == "and" else ()
    several, one = lots if len(lots) == 2 else (None, None)
    many = isinstance(several, Noun) and amount_of(several) in (2, 4)  # what is all but the top of a small one
    if place is None or place.side != "top" or not many or not isinstance(one, Noun) or (amount_of(one) or 1) > 1:
        return [item]
    base = Places(side="bottom", unit="layer", span=item.span)
    return [replace(item, theme=several, adjuncts=(base,)), replace(item, theme=one)] if several else [item]


def _base(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> tuple[int, int]:
    """Blocks along the base, and its depth."""
    base = next((z for z in shape.sizes if z.what == "base" and z.dims), None)
    dims = shape.dims or (base.dims if base else ())
    if len(dims) >= 2:
        return dims[0], dims[1]
    total = said_count(shape, theme, scene) or _symbols(spec)
    size = shape.extent("base", "wide", "layers", "high")
    layers = _layers(spec, total is not None or size is not None, shape.extent("base"))
    if layers:
        bottom = shape.extent("base")
        return _layered([*([bottom] if bottom is not None else []), *layers], total, shape, scene)
    options = [(n, 1) for n in range(2, 8)] + [(n, n) for n in range(2, 5)]
    if total is not None:
        fits = [
            b
            for b in options
            if pyramid_size(b) == total and (size is None or b[0] == size or (b[1] > 1 and b[0] * b[1] == size))
        ]
        if not fits:
            counts = sorted(pyramid_size(b) for b in options)
            near = sorted(counts, key=lambda c: (abs(c - total), c))[:2]
            raise refuse(
                "count-mismatch",
                f"{total} blocks do not make a pyramid",
                shape.span,
                f"use {near[0]} or {near[1]}",
                blocks=total,
            )
        scene.assume(f"the base of the pyramid is {fits[0][0]} by {fits[0][1]} blocks")
        return fits[0]
    if size is not None:
        if shape.traits.shape == "square":
            return size, size
        scene.assume(f"the pyramid is flat: {size} blocks in its base, one deep")
        return size, 1
    if shape.traits.shape == "square":
        scene.assume("the size of the pyramid is not said: a base of 3 by 3 blocks")
        return 3, 3
    scene.assume("the size of the pyramid is not said: a base of 3 blocks, one deep")
    return 3, 1


def _layered(layers: list[int], total: int | None, shape: Structure, scene: Scene) -> tuple[int, int]:
    """The base whose layers are the ones said: all of them, or some of one pyramid alone."""
    said = sorted(layers, reverse=True)
    options = {(n, 1): [*range(n, 0, -1)] for n in range(2, 8)}
    options |= {(n, n): [k * k for k in range(n, 0, -1)] for n in range(2, 5)}
    whole = [base for base, counts in options.items() if counts == said]
    part = [base for base, counts in options.items() if counts[0] == said[0] and _within(said, counts)]
    fits = [base for base in whole or part if total in (None, sum(options[base]))]
    if len(fits) > 1:
        scene.assume(f"the pyramid is flat: {fits[0][0]} blocks in its base, one deep")
    if not fits:
        counted = ", ".join(map(str, said))
        message = f"layers of {counted} blocks do not make a pyramid"
        raise refuse(
            "count-mismatch", message, shape.span, "let each layer be one block smaller, down to one", blocks=sum(said)
        )
    return fits[0]


def _within(few: list[int], many: list[int]) -> bool:
    """Whether all of `few` are among `many`, none twice."""
    return all(few.count(n) <= many.count(n) for n in few)


def _one(theme: Noun) -> bool:
    """ "one on top"."""
    return theme.head == "any" and theme.det == "bare" and theme.amount is None and theme.traits == Traits()


_LEVELS = ("top", "bottom", "middle", "next", "first", "last")


def _level(item: Absolute) -> At | Places | None:
    """The layer of a pyramid that a phrase names, if it names one; "on them" is the next one."""
    place = item.adjuncts[0]
    if isinstance(place, Places):
        return place if place.unit in ("layer", "row") and place.side in _LEVELS and place.several is None else None
    if isinstance(place, At):
        return place if place.side in _LEVELS and len(item.adjuncts) == 1 else None
    mark = place.landmark if isinstance(place, Loc) and place.rel in ("on", "above") and not place.negated else None
    them = isinstance(mark, Pronoun) and mark.word in ("them", "it", "both", "that", "these", "those", "both of them")
    return At(side="next", span=place.span) if them else None


def _number(item: Absolute) -> int | None:
    """How many blocks a phrase puts into a layer."""
    theme = item.theme
    single = isinstance(theme, Pronoun) and theme.word == "one"
    single = single or (isinstance(theme, Noun) and (_one(theme) or (theme.det in ("a", "the") and not theme.plural)))
    return 1 if single else amount_of(theme)


def _layers(spec: Spec, known: bool, base: int | None) -> list[int]:
    """ "four blocks at the bottom and one on top": how many blocks each layer has. `known`: the size is said apart."""
    found: list[int] = []
    told = [n for x in spec.absolutes if _level(x) is not None and (n := _number(x)) is not None]
    most = max(*told, base or 0, 0)
    for item in list(spec.absolutes):
        theme, place, count = item.theme, _level(item), _number(item)
        single = isinstance(theme, Pronoun) and theme.word == "one"
        single = single or (isinstance(theme, Noun) and _one(theme))
        looks = (Traits(), Traits(kind="letter"))
        plain = single or (isinstance(theme, Noun) and theme.head != "patch" and theme.traits in looks)
        if place is not None and count is not None and (plain or not known):
            if {"bottom": count < most, "top": count > min(found, default=count) or count == most > 1}.get(place.side):
                raise refuse("misplaced", "a pyramid grows smaller upwards", item.span, "say how many its base has")
            found.append(count)
            if plain:
                spec.absolutes.remove(item)
    return [] if found == [1] and any(map(_level, spec.absolutes)) else found


def _symbols(spec: Spec) -> int | None:
    """ "(form a pyramid) of the letters A, B and C"."""
    source = spec.usings[0].members if spec.usings else None
    listed = isinstance(source, Noun) and source.amount is None and not source.traits.open_ended
    return (len(source.traits.labels) or None) if isinstance(source, Noun) and listed else None


def _sizes(base: tuple[int, int]) -> list[int]:
    """The blocks of each layer, the lowest one first."""
    longer, depth = max(base), min(base)
    return [*range(longer, 0, -1)] if depth == 1 else [(longer - k) * (depth - k) for k in range(depth)]


def _in_their_layers(told: list[Absolute], base: tuple[int, int]) -> None:
    """Refuse "two blocks in the third layer" where that is the top one."""
    sizes = _sizes(base)
    for item in told:
        place, count = _level(item), _number(item)
        index = place.index if isinstance(place, Places) and place.side == "first" and not place.several else None
        if index is not None and count is not None and sizes[index - 1 : index] != [count]:
            raise refuse("count-mismatch", f"this layer does not have {count} blocks", item.span,
                         "let each layer be one block smaller, down to one")  # fmt: skip


def _numbered(spec: Spec, base: tuple[int, int]) -> None:
    """ "three red at the bottom, two white above and one blue on top": each layer by its number of blocks.

    Of several that are above the others only the last one is the top.
    """
    sizes = _sizes(base)
    told = [x for x in spec.absolutes if _level(x) is not None and _number(x) is not None]
    tops = [x for x in told if (place := _level(x)) is not None and place.side == "top"]
    between = [x for x in told if (place := _level(x)) is not None and place.side == "next"] + tops[:-1]
    for item in between:
        count = _number(item)
        if count not in sizes[1:] or not isinstance(item.theme, Noun):
            raise refuse("count-mismatch", f"no layer above the first one has {count} blocks", item.span,
                         "let each layer be one block smaller, down to one")  # fmt: skip
        layer = Places(side="first", unit="layer", index=sizes.index(count) + 1, span=item.span)
        spec.absolutes[spec.absolutes.index(item)] = replace(item, adjuncts=(layer,))


def _step_by_step(shape: Structure, spec: Spec) -> tuple[OrderBy, dict[int, str]] | None:
    """ "from left to right: one red, two blue, three green": the colour of each step by its height."""
    order = next((o for o in spec.orders if o.items and o.by in ("named", "given")), None)
    items = [x for x in order.items if isinstance(x, Noun)] if order is not None else []
    counts = [amount_of(x) or 1 for x in items]
    plain = all(len(x.traits.colors) == 1 and not x.traits.labels for x in items)
    if (
        order is None
        or len(items) < len(order.items)
        or not plain
        or sorted(counts) != list(range(1, len(items) + 1))
        or len(spec.orders) > 1
    ):
        return None
    if shape.members or counts not in (sorted(counts), sorted(counts)[::-1]) or order.first in ("top", "bottom"):
        return None
    if any(way.first in ("top", "bottom") for way in spec.toward):
        return None
    return order, {many: x.traits.colors[0] for many, x in zip(counts, items, strict=True)}


def _falls(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> bool:
    """ "A descending staircase", "heights 3, 2, 1": whether the stairs go down the way they are told. Where blocks show
    numbers, it is these that descend."""
    listed = spec.manner("steps")
    looks = [part.traits for part in parts_of((shape, *spec.usings)) if isinstance(part, Noun | Structure)]
    shown = any(look.labels or look.kind for look in looks) or (
        theme and any(scene.things[n].label for n in theme.names)
    )
    if any(look.labels for look in looks) and any(look.colors and not look.labels for look in looks):
        raise refuse("ambiguous", "numbers that blocks show, or numbers of blocks?", shape.span,
                     "say 'one red, two white, three blue'")  # fmt: skip
    told = [o for o in spec.orders if o.by == "ascending" and not o.items and o.first in (None, *_ACROSS) and not shown]
    spec.orders = [o for o in spec.orders if o not in told]
    spec.toward += [Toward(first=o.first, span=o.span) for o in told if o.first]
    falls = listed is not None and listed.value == "down"
    if told and listed is not None and told[0].descending != falls:
        raise refuse("contradiction", "these heights go the other way", listed.span, "leave one of them out")
    return falls or any(o.descending for o in told)


_ACROSS = {"left": "right", "right": "left", "front": "back", "back": "front"}


def _rise(order: OrderBy, up: str | None, first: str | None) -> str:
    """Which way stairs rise whose steps are told in this order."""
    begin = order.first or first
    rising = isinstance(order.items[0], Noun) and (amount_of(order.items[0]) or 1) == 1
    way = (_ACROSS.get(begin) if rising else begin) if begin in _ACROSS else up
    if way is None or up not in (None, way):
        raise refuse("ambiguous", "it is not clear whether these are its steps or its layers", order.span,
                     "say 'from left to right' for its steps, 'from top to bottom' for its layers")  # fmt: skip
    return way


def _in_columns(form: s.Staircase, colors: dict[int, str], names: tuple[str, ...], scene: Scene) -> Pattern:
    cells = cells_of(form, len(names))
    heights = Counter((cell.row, cell.column) for cell in cells)
    left = {color: [n for n in names if scene.things[n].color == color] for color in colors.values()}
    ranks = tuple((left[colors[heights[cell.row, cell.column]]].pop(0),) for cell in cells)
    return laid(form, ranks)


def _highest(spec: Spec, up: str | None) -> str | None:
    """ "three steps, the highest on the left": which way the stairs go up, and nothing of the sizes of blocks."""
    for order in [o for o in spec.orders if o.by == "extreme" and o.first]:
        way = order.first if order.descending else _ACROSS.get(order.first or "")
        if way not in _ACROSS or up not in (None, way):
            raise refuse("order-conflict", "the stairs do not go up to this side", order.span,
                         "say 'going up to the left'")  # fmt: skip
        spec.orders.remove(order)
        up = way
    return up


def staircase(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a staircase with four steps, going up to the left"."""
    plain(shape)
    steps = shape.extent("steps", "high", "layers")
    total = said_count(shape, theme, scene)
    told = _step_by_step(shape, spec) if theme is None else None
    if told is not None and steps in (None, len(told[1])):
        steps = len(told[1])
    if steps is None and total is not None:
        steps = next((n for n in range(2, 8) if n * (n + 1) // 2 == total), None)
        if steps is None:
            raise refuse(
                "count-mismatch", f"{total} blocks do not make a staircase", shape.span, "use 3, 6 or 10", blocks=total
            )
    if steps is None:
        steps = 3
        scene.assume("the number of steps is not said: 3")
    up = None
    rising = spec.manner("rising")
    if rising is not None:
        up = str(rising.value)
    falls = _falls(shape, spec, theme, scene)
    side = spec.first("left", "right", "front", "back")
    if side and up is None:
        up = side if falls else _ACROSS[side]
        spec.toward = []
    up = _highest(spec, up)
    if told is not None:
        up = _rise(told[0], up, side)
    elif (order := next((o for o in spec.orders if o.items and (o.first or side) in _ACROSS), None)) is not None:
        raise refuse("ambiguous", "it is not clear which of these blocks make which step", order.span,
                     "say 'from left to right one red, two blue, three green'")  # fmt: skip
    need = steps * (steps + 1) // 2
    names = members_of(shape, spec, theme, None if told else need, need, scene, scope)
    form = s.Staircase(blocks=("",), steps=steps, up=up)  # type: ignore[arg-type]
    pattern: Pattern | None
    if told is not None and len(names) == need:
        spec.orders = []
        pattern, readable = _in_columns(form, told[1], names, scene), False
    else:
        pattern, readable = pattern_of(shape, spec, names, None, scene, scope, form)
    node = s.Staircase(blocks=names, steps=steps, up=up, pattern=pattern, readable=readable, span=shape.span)  # type: ignore[arg-type]
    return made("staircase", node, names, shape.span, scene)
