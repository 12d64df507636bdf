"""Lines that the places along them make longer: "three red blocks in a row with a white one at each end"."""

from __future__ import annotations

from collections.abc import Collection

from rpg.language import lexicon
from rpg.language.grammar.things.retold import bare_color
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Size, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.mirrored import mirrored
from rpg.passes.schema.resolve.orders.parts import place_of
from rpg.passes.schema.resolve.orders.positions import doubled
from rpg.passes.schema.resolve.places.either_end import at_an_end
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def lengthened(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> tuple[Structure, Ref | None]:
    """ "three red blocks in a row with a white one at each end": further blocks in the line."""
    source = shape.members
    if theme is None and mirrored(shape, spec):
        return replace(shape, members=None, sizes=()), None
    if (told := _told_through(shape, spec, theme)) is not None:
        return told, theme
    if theme is None and (longer := _beyond_the_list(shape, spec)) is not None:
        return longer, None
    few = _few(shape, spec)
    if theme is None and few and (some := _some_many(source, few)) is not None:
        longer, made = lengthened(replace(shape, members=some), spec, None, scene)
        if isinstance(longer.members, Coord):
            scene.assume(f"the number of {some.traits.colors[0]} blocks is not said: {few}")
            return longer, made
    counted_ = theme is not None or amount_of(source) is not None
    if shape.sizes or not counted_ or (theme is None and not isinstance(source, Noun)) or (theme and theme.quant):
        return shape, theme
    things = [scene.things[n] for n in theme.names] if theme is not None else []
    own: Collection[str | None] = {thing.label or thing.color for thing in things}
    if isinstance(source, Noun) and theme is None:
        own = source.traits.labels or source.traits.colors
    some_many = any(thing.elastic for thing in things)
    if not own or None in own or (some_many and not few):
        return shape, theme
    closed = _closed(spec)
    more = [m for item in spec.absolutes if (m := _further(item, shape.kind, own, closed)) is not None]
    if not more:
        return shape, theme
    if theme is None:
        return replace(shape, members=Coord(op="and", items=(source, *more), span=shape.span)), None  # type: ignore[arg-type]
    if some_many:
        theme = replace(theme, names=scene.fit(theme.names, few))
    further: tuple[str, ...] = ()
    for noun in more:
        further += refer(noun, scene, Scope(role="member")).names
        scene.mentions.pop()
    if theme.listed and _ordered(spec, theme, scene):
        return shape, _around(theme, further, spec)
    return shape, replace(theme, names=theme.names + further, listed=False)


def _beyond_the_list(shape: Structure, spec: Spec) -> Structure | None:
    """ "a row of red, blue and green from left to right, with a yellow block at the left end": in front of the list, or
    behind it."""
    listed, first = shape.members, spec.first(*_OTHER_END)
    if first is None or shape.sizes or not isinstance(listed, Coord) or listed.op != "and":
        return None
    looks = [_look(x) for x in listed.items]
    ends: dict[str, list[Meaning]] = {first: [], _OTHER_END[first]: []}
    for item in spec.absolutes:
        place = place_of(item)
        new = (
            isinstance(item.theme, Noun) and item.theme.det in ("a", "bare") and _look(item.theme) not in (None, *looks)
        )
        if not new or not isinstance(place, At) or place.index is not None or ends.get(place.side, True):
            return None
        ends[place.side].append(item.theme)
    if not spec.absolutes or None in looks:
        return None
    spec.absolutes = []
    return replace(shape, members=replace(listed, items=(*ends[first], *listed.items, *ends[_OTHER_END[first]])))


def _look(item: Meaning) -> str | None:
    """The one colour or symbol of a single block."""
    single = isinstance(item, Noun) and not item.plural and amount_of(item) in (None, 1)
    looks = (*item.traits.labels, *item.traits.colors) if isinstance(item, Noun) else ()
    return looks[0] if single and len(looks) == 1 else None


_OTHER_END = {"left": "right", "right": "left", "front": "back", "back": "front"}


def _few(shape: Structure, spec: Spec) -> int | None:
    """How many blocks a line is of that are not counted, so that a middle can be told; None where ends are not all that
    is said of places in it."""
    sides = [place.side if place is not None else "" for place in map(place_of, spec.absolutes)]
    if shape.kind not in _LINES or shape.sizes or not sides or not set(sides) <= {"ends", "outer", "middle"}:
        return None
    return _FEW + ("middle" in sides)


def _some_many(source: Meaning | None, few: int) -> Noun | None:
    """ "a row of green blocks with a yellow one at each end": so many of them."""
    bare = isinstance(source, Noun) and source.det == "bare" and source.plural and source.amount is None
    if not bare or not isinstance(source, Noun) or len(source.traits.colors) != 1 or source.traits.labels:
        return None
    told = source.part_of is not None or source.conditions
    return None if told else replace(source, amount=Amount(few, few))


_LINES = ("row", "line", "column", "stack")
_FEW = 3
"""So many blocks stand between the ends of a line where it is not said how many they are."""


def _ordered(spec: Spec, theme: Ref, scene: Scene) -> bool:
    """Whether the list of a line is the order of its blocks."""
    sides = ("left", "right", "front", "back", "bottom", "top")
    return bool(spec.first(*sides) or spec.orders or doubled(theme.names, scene))


_ENDS = 2
"""So many ends a line has."""


def _around(theme: Ref, further: tuple[str, ...], spec: Spec) -> Ref:
    """ "red, blue, red in a row with a green block at each end": the list, with one before it and one behind."""
    item = spec.absolutes[0]
    if len(spec.absolutes) > 1 or len(further) != _ENDS or place_of(item).side not in ("ends", "outer"):  # type: ignore[union-attr]
        raise refuse("ambiguous", "it is not said between which of the listed blocks this one stands", item.span,
                     "list all the blocks in their order")  # fmt: skip
    spec.absolutes = []
    return replace(theme, names=(further[0], *theme.names, further[1]))


def _told_through(shape: Structure, spec: Spec, theme: Ref | None) -> Structure | None:
    """ "a column of numbers: 1 is nearest, then 2, then 3": as many as are told from one end on."""
    source = shape.members
    bare = isinstance(source, Noun) and source.det == "bare" and not source.traits.labels
    if theme is not None or shape.sizes or not (source is None or (bare and amount_of(source) is None)):
        return None
    places = [place_of(item) for item in spec.absolutes]
    if (total := _ends_and_rest(spec, places) or _and_others(spec, places)) is not None:
        return replace(shape, sizes=(Size(what="size", amount=Amount(total, total), span=shape.span),))
    sides = [place.side if place is not None and place.index in (None, 1) else "" for place in places]
    told = "next" in sides[1:] and sides[0] != "next" and set(sides[1:-1]) <= {"next"}
    single = all(isinstance(x.theme, Noun) and x.theme.amount in (None, Amount(1, 1)) for x in spec.absolutes)
    named = all(isinstance(x.theme, Noun) and len(x.theme.traits.colors + x.theme.traits.labels) == 1
                for x in spec.absolutes)  # fmt: skip
    if not (told and single and named):
        return None
    size = Size(what="size", amount=Amount(len(places), len(places)), span=shape.span)
    return replace(shape, sizes=(size,))


def _ends_and_rest(spec: Spec, places: list[At | Places | None]) -> int | None:
    """ "red at both ends and three blue ones between them": how many these are, where it is said of all."""
    sides = [place.side if place is not None and place.index is None else "" for place in places]
    counts = [
        amount_of(item.theme) or (None if side in ("rest", "middle") else 1)
        for item, side in zip(spec.absolutes, sides, strict=True)
    ]
    ends = [side for side in sides if side not in ("rest", "middle")]
    if len(sides) - len(ends) != 1 or not (ends in (["ends"], ["outer"]) or set(ends) in _BOTH) or None in counts:
        return None
    total = sum(n or 0 for n in counts)
    if len(ends) > 1:
        return total
    at = sides.index(ends[0])
    each = counts[at] == 1 or getattr(places[at], "each", False)
    return total + (counts[at] or 0) if each else total


def _and_others(spec: Spec, places: list[At | Places | None]) -> int | None:
    """ "red at the bottom and two blue ones": how many these are."""
    rest = places[-1] if len(places) > 1 else None
    if not isinstance(rest, Places) or rest.side != "rest" or rest.several is None:
        return None
    single = all(isinstance(x, At) and x.index is None and x.side != "next" for x in places[:-1])
    return rest.several + sum(amount_of(item.theme) or 1 for item in spec.absolutes[:-1]) if single else None


_BOTH = ({"left", "right"}, {"top", "bottom"}, {"front", "back"})


def _closed(spec: Spec) -> bool:
    """ "A row of three red blocks, blue on the left, green on the right": a colour at each end is one block there."""
    places = [place_of(item) for item in spec.absolutes]
    sides = [x.side if isinstance(x, At) and x.index is None and not x.own else "" for x in places]
    single = all(isinstance(x.theme, Noun) and bare_color(x.theme) and not x.theme.plural for x in spec.absolutes)
    return single and len(sides) == _ENDS and set(sides) in _BOTH


def _further(item: Absolute, kind: str, own: Collection[str | None], closed: bool) -> Noun | None:
    """The blocks that a part brings into the line: those of another colour, or that show something else, where it is
    said how many they are, or each is alone at its end of the line (`closed`)."""
    place, theme = place_of(item), item.theme
    if place is None or not isinstance(theme, Noun) or (theme.traits.labels and set(own) & set(lexicon.COLORS)):
        return None
    looks = theme.traits.labels or theme.traits.colors
    if not theme.traits.labels and theme.head == "any" and not set(own) & set(lexicon.COLORS):
        return None  # "three X cubes with a red one at each end": that may be an X as well
    if not looks or set(looks) & set(own):
        return None
    ends = isinstance(place, Places) and place.side in ("ends", "outer")
    counted_ = ends or closed or (theme.amount is not None and amount_of(theme) is not None)
    named = theme.det == "the" and amount_of(theme) in (None, 1) and not theme.plural  # "with the blue one at one end"
    if not named and (theme.det not in ("a", "bare") or not counted_):
        return None
    if ends and (theme.det, theme.head, theme.amount, theme.plural) == ("bare", "any", None, False):
        return None
    if place.side in ("rest", "next") or (kind == "stack" and isinstance(place, At) and place.side != "middle"):
        return None
    if named and (isinstance(place, At) or at_an_end(place)):
        return theme
    count = amount_of(theme) or 1
    if isinstance(place, Places) and ends and not at_an_end(place):
        count = _ENDS * count if place.each or count == 1 else count
    return replace(theme, det="bare", amount=Amount(count, count), plural=count > 1)
