"""Which blocks a structure is made of."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Coord,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Size,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.onward import in_between, onward
from rpg.passes.schema.resolve.orders.orders import implied_kind
from rpg.passes.schema.resolve.orders.runs import run_length
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import alike, amount_of, create, matching, plain_colors
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse


def members_of(
    shape: Structure, spec: Spec, theme: Ref | None, need: int | None, default: int, scene: Scene, scope: Scope
) -> tuple[str, ...]:
    """The blocks of a structure: those named, else `need` (or `default`) new ones."""
    default = run_length(spec) or default
    if theme is not None:
        theme = certain(theme, scene)
        _agrees(shape, theme.names, scene)
        spec.listed = spec.listed or theme.listed
        listed = _order_items(spec)
        open_ = all(scene.things[n].elastic for n in theme.names)
        names = scene.fit(theme.names, need or (len(listed) or default if open_ else None))
        return _checked(names, need, shape.span, scene)
    source = shape.members or (spec.usings.pop(0).members if spec.usings else None)
    listed = _order_items(spec)
    count = need or (len(listed) if listed else None)
    colors = plain_colors(source) if isinstance(source, Coord) else ()
    if source is not None and need is not None and need > len(colors) > 1:
        source = Noun(head="block", plural=True, traits=Traits(colors=colors), span=source.span)
    if source is not None:
        source = _with_kind(source, implied_kind(spec), shape.traits)
        named = refer(
            source,
            scene,
            Scope(start=scope.start, given=scope.start, need=count or default, role="member", share=count is not None),
        )
        _fix_parts(named)
        named = certain(_of_its_color_among(shape, source, named, scene), scene)
        _of_its_colors(shape, named, scene)
        _of_one_color(source, named, scene)
        spec.listed = spec.listed or named.listed
        in_turn = named.op == "then" or (
            _named_one_by_one(source) and all(_of_another(x, source) for x in spec.absolutes)
        )
        if in_turn and shape.kind in ("stack", "row", "line", "column") and not spec.orders:
            spec.orders.append(OrderBy(by="given", span=source.span))
        names = scene.fit(
            named.names, count or (default if all(scene.things[n].elastic for n in named.names) else None)
        )
        return _checked(names, need, shape.span, scene)
    if need is None and listed:
        whole = refer(Coord(op="and", items=listed, span=shape.span), scene, Scope(role="member"))
        scene.mentions.pop()
        _name_items(spec, whole)
        return whole.names
    return _unnamed(shape, spec, count, default, scene)


def _unnamed(shape: Structure, spec: Spec, count: int | None, default: int, scene: Scene) -> tuple[str, ...]:
    """The blocks of a structure of which none is named but by its place: those there are, or new ones."""
    there = declared(shape.traits, scene)
    if count is None and not there and scene.looks == 1 and _one_of_more(shape, spec):
        count = _WITH_A_MIDDLE
        scene.assume(f"how many blocks it has is not said: {count}")
    if absolute := _by_its_parts(shape, spec, count, there, scene):
        return absolute
    if len(there) > 1 and (count is None or len(there) == count):
        return there
    if count is not None and (some := some_of(there, count, shape, scene)):
        return some
    if count is None and scene.each is not None and len(shape.traits.colors) == 1:
        count = scene.each[0]
    if count is None:
        count = default
        scene.assume(f"the number of blocks is not said: {default}")
    return new_members(shape.traits, count, implied_kind(spec), scene)


_WITH_A_MIDDLE = 3
"""So many blocks has a line of which a single one is told where it is."""


def _one_of_more(shape: Structure, spec: Spec) -> bool:
    """ "A tower with a red block on top": that block, and others below it of which nothing is said."""
    told = spec.absolutes[0] if len(spec.absolutes) == 1 else None
    place = told.adjuncts[0] if told is not None and len(told.adjuncts) == 1 else None
    theme = told.theme if told is not None else None
    single = isinstance(theme, Noun) and not theme.plural and amount_of(theme) in (None, 1)
    ends = isinstance(place, At) and place.index is None and place.side in _PLACES.get(shape.kind, ())
    return ends and single and not (spec.orders or spec.patterns or shape.traits.colors)


_PLACES = {
    "stack": ("top", "bottom", "middle"),
    "row": ("left", "right", "middle"),
    "line": ("left", "right", "front", "back", "middle"),
    "column": ("front", "back", "middle"),
}


def _of_its_color_among(shape: Structure, source: Meaning, named: Ref, scene: Scene) -> Ref:
    """ "A white row (and a purple one) out of them": the white ones of them."""
    if not isinstance(source, Pronoun) or not shape.traits.colors:
        return named
    such = tuple(n for n in named.names if scene.things[n].color in shape.traits.colors)
    return replace(named, names=such, parts=()) if such else named


def _of_its_colors(shape: Structure, named: Ref, scene: Scene) -> None:
    if shape.traits.colors and not {scene.things[n].color for n in named.names} <= set(shape.traits.colors):
        raise refuse("contradiction", "the blocks have other colours than the structure", shape.span,
                     "name one colour for both")  # fmt: skip


def _by_its_parts(
    shape: Structure, spec: Spec, need: int | None, there: tuple[str, ...], scene: Scene
) -> tuple[str, ...]:
    """The blocks that are told by their places; none where one is told of the blocks that `there` are: it is of all of
    these, "3 blue, 1 red. Tower with red on top"."""
    looks = all(isinstance(a.theme, Noun) and a.theme.traits.colors + a.theme.traits.labels for a in spec.absolutes)
    absolute = _from_absolutes(shape, spec, need, scene)
    fewer = bool(absolute) and set(absolute) < set(there)
    sides = {getattr(a.adjuncts[0], "side", None) for a in spec.absolutes}
    if fewer and len(absolute) > 1 and len(sides) > 1:  # "with the two yellow ones at the bottom" has more above
        raise refuse("ambiguous", "of these blocks alone, or of all the blocks there are?", shape.span,
                     "say 'of all blocks', or name all its blocks")  # fmt: skip
    return () if fewer and looks else absolute


def _of_one_color(source: Meaning, named: Ref, scene: Scene) -> None:
    """Refuse "a row of four with equal colours side by side: two red, two blue": of all, or of neighbours?"""
    same = isinstance(source, Noun) and source.traits.scheme == "same"
    if same and len({scene.things[n].color for n in named.names} - {None}) > 1:
        raise refuse("ambiguous", "it is not clear which blocks are of the same colour", source.span,
                     "say 'with blocks of the same colour together'")  # fmt: skip


def _agrees(shape: Structure, names: tuple[str, ...], scene: Scene) -> None:
    """What is said of a structure's blocks must hold of the blocks that are to form it."""
    if shape.members is not None:
        raise refuse(
            "misplaced", "two sets of blocks are named for one structure", shape.members.span, "name its blocks once"
        )
    things = [scene.things[n] for n in names]
    colors = shape.traits.colors
    for thing in things:
        if colors and thing.color is None and thing.kind is None and len(colors) == 1:
            thing.color = colors[0]
    if colors and not {t.color for t in things} <= set(colors):
        raise refuse(
            "contradiction", "the blocks have other colours than the structure", shape.span, "name one colour for both"
        )
    if shape.traits.kind in ("letter", "digit") and any(t.kind not in (shape.traits.kind, "symbol") for t in things):
        open_ = [t for t in things if t.kind is None and t.color is None]
        if len(open_) < len(things):
            raise refuse(
                "contradiction",
                "the blocks do not show what the structure asks for",
                shape.span,
                "name letter or number blocks",
            )
        for thing in open_:
            thing.kind = shape.traits.kind


def certain(ref: Ref, scene: Scene) -> Ref:
    """The very blocks that are meant: of look-alikes as many as are asked for; else the phrase must say which."""
    if ref.op in ("or", "nor", "xor", "except", "only"):
        if ref.op == "except":
            scene.excepted |= {name for part in ref.parts[1:] for name in part.names}
            return ref.parts[0]
        raise refuse("ambiguous", "it is not said which of the blocks", ref.span, "name the blocks")
    if ref.mixed:
        raise refuse("ambiguous", "it is not said which of the blocks", ref.span, "name the blocks")
    if ref.quant is None:
        return ref
    things = [scene.things[n] for n in ref.names]
    if (
        ref.quant.low != ref.quant.high
        or ref.quant.low == 0
        or len({(t.color, t.label, t.kind, t.size) for t in things}) > 1
    ):
        raise refuse("ambiguous", "it is not said which of the blocks", ref.span, "name the blocks")
    for thing in things:
        thing.scheme = thing.scheme or "same"
    for name in ref.names[ref.quant.low :]:
        scene.spare.add(name)
    return replace(ref, names=ref.names[: ref.quant.low], quant=None)


def of_look_alikes(theme: Ref, spec: Spec, scene: Scene) -> Ref:
    """ "stack two of the three white blocks": of look-alikes it does not matter which, and no more of them."""
    told = theme.quant is not None and theme.op == "and" and not theme.mixed
    told = told and theme.quant is not None and theme.quant.high in (None, theme.quant.low)
    things = [scene.things[n] for n in theme.names]
    if spec.places or spec.sizes:
        return theme
    if theme.quant is None and len(theme.names) > 1 and set(theme.names) < set(scene.whole):
        many = Amount(len(theme.names), len(theme.names))
        spec.sizes.append(Size(what="size", amount=many, span=theme.span))
    if not told or theme.quant is None:
        return theme
    if not (alike(things) or all(map(_of_no_look, things))) or not 1 < theme.quant.low < len(things):
        return theme
    least = theme.quant.low
    spec.sizes.append(Size(what="size", amount=Amount(least, theme.quant.high), span=theme.span))
    scene.whole = theme.names
    scene.parted.update(theme.names[:least])
    return certain(replace(theme, quant=Amount(least, least)), scene)


def _of_no_look(thing: Thing) -> bool:
    """Whether nothing is said of how it looks, so that it can look as others do."""
    return thing.color is None and thing.label is None and thing.kind is None and thing.scheme in (None, "same")


def picked_for(target: Structure, theme: Ref, spec: Spec, scene: Scene) -> Ref:
    """ "Put (at least) three of the five blue blocks in a row": of look-alikes it does not matter which."""
    one = target.kind in ("stack", "row", "line", "column") and not (target.plural or target.sizes)
    return of_look_alikes(theme, spec, scene) if one and theme.quant is not None else theme


def _fix_parts(named: Ref) -> None:
    if named.patch or named.table:
        raise refuse("misplaced", "structures are made of blocks", named.span, "name blocks")


def _name_items(spec: Spec, whole: Ref) -> None:
    """The items of an order that brought its blocks into the task stand for just these."""
    for index, order in enumerate(spec.orders):
        if order.items:
            spec.orders[index] = replace(
                order,
                by="read" if order.by == "read" else "given",
                items=tuple(Pronoun(word="=" + " ".join(part.names), span=order.span) for part in whole.parts),
            )


def _named_one_by_one(source: Meaning) -> bool:
    """ "green, green, pink, pink": who counts says "two green ones"; this tells how they stand."""
    if isinstance(source, Noun):
        looks: list[object] = list(source.traits.colors) if not source.traits.either else []
    else:
        items = source.items if isinstance(source, Coord) and source.op == "and" else ()
        bare = all(isinstance(x, Noun) and x.det == "bare" and x.amount is None and not x.plural for x in items)
        looks = [x.traits for x in items if isinstance(x, Noun)] if bare else []
    return 1 < len(set(looks)) < len(looks)


def _of_another(told: Absolute, source: Meaning) -> bool:
    """ "(green, green and blue) with a yellow block on the blue one": said of no block of the list."""
    theme, where = told.theme, told.adjuncts[0] if told.adjuncts else None
    looks = {look for x in parts_of(source) if isinstance(x, Noun) for look in (*x.traits.colors, *x.traits.labels)}
    own = {*theme.traits.colors, *theme.traits.labels} if isinstance(theme, Noun) else looks
    return isinstance(where, Loc) and bool(own) and not own & looks


def _order_items(spec: Spec) -> tuple[Meaning, ...]:
    return next((o.items for o in spec.orders if o.items and o.by != "alternating"), ())


def _with_kind(source: Meaning, kind: str | None, traits: Traits) -> Meaning:
    """ "a letter pyramid of blocks": what is said of the structure's blocks holds for its members."""
    if isinstance(source, Noun):
        marks = source.traits
        if kind and not marks.kind and not marks.colors and not marks.labels:
            marks = replace(marks, kind=kind)
        if traits.colors and not marks.colors:
            marks = replace(marks, colors=traits.colors, either=False)
        if traits.scheme and not marks.scheme:
            marks = replace(marks, scheme=traits.scheme)
        if traits.kind and not marks.kind:
            marks = replace(marks, kind=traits.kind)
        return replace(source, traits=marks)
    if isinstance(source, Coord):
        return replace(source, items=tuple(_with_kind(i, kind, Traits()) for i in source.items))
    return source


def _checked(names: tuple[str, ...], need: int | None, span: Span, scene: Scene) -> tuple[str, ...]:
    if need is not None and len(names) != need:
        raise refuse(
            "count-mismatch", f"this takes {need} blocks, but {len(names)} are named", span,
            f"name {need} blocks, or change the size",
            needed=need, named=len(names),
        )  # fmt: skip
    return names


def _from_absolutes(shape: Structure, spec: Spec, need: int | None, scene: Scene) -> tuple[str, ...]:
    """ "a tower with a red block at the bottom and a blue one on top": its members, when their number agrees."""

    spec.absolutes = onward(spec.absolutes) if shape.kind in ("stack", "row", "line", "column") else spec.absolutes
    spec.absolutes = in_between(spec.absolutes) if need in (None, 3) else spec.absolutes
    inside = [a for a in spec.absolutes if isinstance(a.adjuncts[0], At)]
    if not inside or (need is not None and sum(amount_of(item.theme) or 1 for item in inside) < need):
        return ()
    names: list[str] = []
    for index, item in enumerate(spec.absolutes):
        if item not in inside:
            continue
        theme = item.theme
        if (
            isinstance(theme, Noun)
            and theme.traits.colors
            and any(scene.things[n].color in theme.traits.colors for n in names)
            and theme.det != "the"
        ):
            theme = replace(theme, det="another", amount=theme.amount or Amount(1, 1))
        found = refer(theme, scene, Scope(role="member")).names
        scene.mentions.pop()
        names += [n for n in found if n not in names]
        spec.absolutes[index] = replace(item, theme=Pronoun(word="=" + " ".join(found), span=item.span))
    return tuple(names) if need is None or len(names) == need else ()


def declared(traits: Traits, scene: Scene) -> tuple[str, ...]:
    """The blocks that "there are", for a structure that names none."""
    plain = replace(traits, scheme=None, shape=None)
    return tuple(t.name for t in matching(plain, scene, False) if t.declared and t.name not in scene.used)


def some_of(there: tuple[str, ...], count: int, shape: Structure, scene: Scene) -> tuple[str, ...]:
    """So many of the blocks that there are, where it does not matter which; they are used up."""
    things = [scene.things[n] for n in there]
    if there and len(there) < count and shape.traits == Traits(colors=shape.traits.colors[:1]):
        raise refuse("count-mismatch", f"this takes {count} blocks, but only {len(there)} are there for it", shape.span,
                     "say of which blocks it is built", needed=count, there=len(there))  # fmt: skip
    if there and len({(t.color, t.label, t.kind, t.size, t.edge) for t in things}) > 1:
        raise refuse("ambiguous", f"it is not said which of {len(there)} different blocks are used", shape.span,
                     "name the blocks", blocks=len(there))  # fmt: skip
    if len(there) < count:
        return ()
    for thing in things:
        thing.scheme = thing.scheme or "same"
    scene.used.update(there[:count])
    return there[:count]


def new_members(traits: Traits, count: int, kind: str | None, scene: Scene) -> tuple[str, ...]:
    """New blocks with the structure's traits; several colours share them evenly."""
    scene.new_batch()
    colors = traits.colors
    if len(colors) > 1 and count % len(colors):
        raise refuse(
            "count-mismatch",
            f"{count} blocks cannot be shared evenly by {len(colors)} colours",
            None,
            "say how many of each",
            blocks=count,
        )
    names = []
    for index in range(count):
        color = (colors[index * len(colors) // count],) if colors else ()
        one = replace(traits, colors=color, kind=traits.kind or kind, rank=None, labels=())
        thing = create(one, scene, False)
        thing.invented = not (color or one.kind or one.size)
        names.append(thing.name)
    return tuple(names)
