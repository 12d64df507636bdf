"""Several towers at once: counts, heights, one per colour, on patches."""

from __future__ import annotations

from collections import Counter
from itertools import combinations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.meaning import Coord, Meaning, Noun, Pattern, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.heights import of_heights
from rpg.passes.schema.resolve.structures.so_many_towers import bounded, each_number, within, without_range
from rpg.passes.schema.resolve.structures.towers_by_turns import by_turns
from rpg.passes.schema.resolve.things.from_stock import several_from_stock
from rpg.passes.schema.resolve.things.members import certain, declared, new_members, some_of
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

STACK_COLORS = ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink")
DEFAULT_HEIGHT = 2
DEFAULT_COLORS = 3
Made = tuple[list[Built], list[g.Goal]]


def several(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "two towers of three red blocks", "towers, one per colour", "two stacks"."""
    if any(z.what == "heights" for z in shape.sizes):
        return of_heights(shape, spec, theme, scene)
    _which_form_which(shape, spec)
    shape, bounds = bounded(_of_one_color(shape, theme))
    shape = _told_apart(shape, spec)
    sorted_by = next((o.attribute for o in spec.orders if o.by == "attribute"), None)
    spec.orders = [o for o in spec.orders if o.by != "attribute"]
    patterns = [p for p in spec.patterns if p.unit in ("stack", "pile")]
    spec.patterns = [p for p in spec.patterns if p.unit not in ("stack", "pile")]
    by_color = (
        bool(patterns)
        or sorted_by == "color"
        or shape.traits.scheme == "same"
        or any(_matching(p) for p in (*spec.places, *(x for a in spec.absolutes for x in a.adjuncts)))
    )
    if sorted_by not in (None, "color"):
        raise refuse("misplaced", "several towers are told apart by colour only", shape.span, "say what is in each")
    count = shape.amount.low if shape.amount and shape.amount.low > 1 else None
    shape, theme = several_from_stock(shape, count, spec, theme, scene)
    per = shape.extent("size", "high", "layers") or (scene.each[0] if scene.each else None)
    equal = spec.manner("equal") is not None
    told = amount_of(shape.members) if shape.each_size else shape.extent("size")
    if equal and told is not None and count is not None and told % count == 0 and not scene.each:
        raise refuse("ambiguous", f"{told} blocks in each of them, or in all?", shape.span,
                     f"say '{told} blocks each', or 'of {told} blocks in all, of equal height'")  # fmt: skip
    theme, per = _source(shape, spec, theme, per, count, by_color, scene, scope)
    if theme is not None and count is not None and (one := without_range(shape, per, len(theme.names))) is not shape:
        shape, count = one, amount_of(one)
    if (
        theme is not None
        and count is None
        and not by_color
        and len(theme.parts) > 1
        and all(len(p.names) > 1 for p in theme.parts)
    ):
        if shape.members is None or (equal and len({len(p.names) for p in theme.parts}) > 1):
            raise refuse("ambiguous", "it is not said how many towers, and of which blocks each", shape.span,
                         "say how many towers, or 'a tower for each color'")  # fmt: skip
        return _one_each(theme, shape, scene)
    if bounds is not None and (theme is None or per is not None or scene.each):
        raise refuse("ambiguous", "the height of the towers is left open", shape.span, "say one number")
    if theme is not None:
        names, count = _given(theme, shape, count, per, by_color, scene)
    else:
        names, count = _new(shape.traits, shape, count, per, by_color, scene)
    if not by_color and bounds is None and (made := by_turns(names, count, per, spec, shape, scene)) is not None:
        return made
    if not by_color and not any(o.by == "any" for o in spec.orders):
        _one_color_each(names, count, per, equal, shape, scene)
    heights = (per,) * count if per is not None and count is not None else None
    if spec.manner("unequal") is not None:
        heights = _unequal(len(names), count, per, shape)
    node = s.Towers(
        blocks=names, count=count, heights=heights, equal=equal, each="color" if by_color else None,
        separate=by_color, span=shape.span
    )  # fmt: skip
    goal = each_number(node, shape, by_color) if bounds is None else within(node, bounds, shape)
    return _remember(node, by_color, scene), [goal]


def _which_form_which(shape: Structure, spec: Spec) -> None:
    """Refuse blocks of which it is not told how they are shared out, and numbers that could be heights."""
    for listed in (shape.members, *(x.members for x in spec.usings)):
        items = listed.items if isinstance(listed, Coord) else (listed,)
        named = [x for x in items if isinstance(x, Noun) and not (x.amount and x.amount.low > 1)]
        looks = [color for x in named for color in x.traits.colors]
        shown = listed.traits.labels if isinstance(listed, Noun) and listed.det == "bare" and listed.cost else ()
        if "".join(shown).isdigit() and (shape.amount is None or shape.amount.low == len(shown)):
            raise refuse("ambiguous", "are these the heights of the towers, or cubes that show these numbers?",
                         shape.span, "say 'of heights 2, 3 and 4', or 'of the cubes 2, 3 and 4'")  # fmt: skip
        if len(set(looks)) < len(looks):
            raise refuse("ambiguous", "it is not clear which blocks form which tower", shape.span,
                         "say of which blocks each tower is")  # fmt: skip


def _of_one_color(shape: Structure, theme: Ref | None) -> Structure:
    """ "(Stack the blocks in) towers of two of the same color": of blocks that are named before, each of one colour."""
    members = shape.members
    if theme is None or not isinstance(members, Noun) or members.traits != Traits(scheme="same"):
        return shape
    return replace(shape, members=replace(members, traits=Traits()), traits=replace(shape.traits, scheme="same"))


def _unequal(blocks: int, count: int | None, per: int | None, shape: Structure) -> tuple[int, ...]:
    """The heights of towers that all differ, where there is one way to build them of so many blocks."""
    ways = [x for x in combinations(range(2, blocks), count or blocks) if sum(x) == blocks] if per is None else []
    if len(ways) != 1:
        raise refuse("ambiguous" if ways else "count-mismatch", f"{blocks} blocks can be shared so in {len(ways)} ways",
                     shape.span, "say how high each tower is")  # fmt: skip
    return ways[0]


def _one_color_each(
    names: tuple[str, ...], count: int | None, per: int | None, equal: bool, shape: Structure, scene: Scene
) -> None:
    """Refuse "three red, two blue. Two stacks.", which could be a stack of each colour."""
    lots = Counter(scene.things[n].color for n in names)
    told = None not in lots and scene.vague.isdisjoint(names) and len(lots) == count
    even = len(set(lots.values())) == 1 if equal else per is None or set(lots.values()) == {per}
    if told and even and len(lots) > 1 and min(lots.values()) > 1:
        raise refuse("ambiguous", "a tower of each colour, or of whichever of these blocks?", shape.span,
                     "say 'one tower per color', or 'in any order'")  # fmt: skip


def _told_apart(shape: Structure, spec: Spec) -> Structure:
    """ "two towers, red and blue": one of each colour; no other order goes with several towers."""
    for order in list(spec.orders):
        if order.by == "attribute" or not order.items:
            continue
        colors = tuple(c for item in order.items if isinstance(item, Noun) for c in item.traits.colors)
        plain = all(isinstance(i, Noun) and i.amount is None and len(i.traits.colors) == 1 for i in order.items)
        if not plain or shape.amount is None or shape.amount.low != len(colors) or shape.traits.colors:
            raise refuse("misplaced", "this order is not one of several towers", order.span,
                         "say what each tower is made of")  # fmt: skip
        spec.orders.remove(order)
        spec.patterns.append(Pattern(unit="stack", span=order.span))
        members = shape.members
        if isinstance(members, Noun) and not members.traits.colors:
            shape = replace(shape, members=replace(members, traits=replace(members.traits, colors=colors)))
        else:
            shape = replace(shape, traits=replace(shape.traits, colors=colors))
    return shape


def _matching(place: object) -> bool:
    """A place on patches of the towers' own colours."""
    mark = getattr(place, "landmark", None)
    if not isinstance(mark, Noun) or mark.head != "patch":
        return False
    return mark.traits.matching or (mark.traits.scheme in ("some", "different") and not mark.traits.colors)


def on_matching_patches(place: object, blocks: Meaning) -> bool:
    """ "stack the blocks on the patches of their own colour", "... on the patch of the same colour": one for each."""
    mark = getattr(place, "landmark", None)
    several = isinstance(blocks, Coord) or (isinstance(blocks, Noun) and len(blocks.traits.colors) > 1)
    return isinstance(mark, Noun) and mark.head == "patch" and mark.traits.matching and (mark.plural or several)


def _source(
    shape: Structure,
    spec: Spec,
    theme: Ref | None,
    per: int | None,
    count: int | None,
    by_color: bool,
    scene: Scene,
    scope: Scope,
) -> tuple[Ref | None, int | None]:
    """The blocks that were named for the towers, and how many are in each where that was said."""
    if theme is not None:
        return theme, per or _so_many_each(theme, shape, count)
    source: Meaning | None = shape.members or (spec.usings.pop(0).members if spec.usings else None)
    if source is None:
        there = declared(shape.traits, scene)
        if per and count and len(there) > per * count and not by_color:  # "two towers of two and one of three"
            scene.dealt.append((there, refuse(
                "count-mismatch", f"{count} towers take {per * count} blocks, but {len(there)} are named", shape.span,
                f"use {per * count}, or say what becomes of the others", blocks=len(there), towers=count,
            )))  # fmt: skip
            there = some_of(there, per * count, shape, scene) or there
        return (Ref(names=there), per) if there else (None, per)
    if isinstance(source, Noun):
        amount = source.amount.low if source.amount and source.amount.low == source.amount.high else None
        if shape.members is source and shape.each_size and amount is not None and source.det != "the":
            return _each(source, amount, shape, count, by_color, scene), amount
        if amount is None and source.det in ("bare", "some", "a") and not source.traits.labels:
            traits = replace(source.traits, colors=source.traits.colors or shape.traits.colors)
            there = declared(traits, scene)
            if there:
                return Ref(names=there), per
            names, _ = _new(traits, shape, count, per, by_color, scene)
            return Ref(names=names), per
    found = refer(source, scene, replace(scope, role="member", need_each=DEFAULT_HEIGHT))
    return certain(found, scene), per


def _so_many_each(theme: Ref, shape: Structure, count: int | None) -> int | None:
    """ "(Divide six green blocks into) two towers of three blocks each": how many of the theme's blocks that is."""
    members = shape.members if isinstance(shape.members, Noun) else None
    plain = members is not None and members.traits == Traits() and members.part_of is None
    many = amount_of(members) if plain else None
    return many if many is not None and (shape.each_size or many * (count or 0) == len(theme.names)) else None


def _each(source: Noun, amount: int, shape: Structure, count: int | None, by_color: bool, scene: Scene) -> Ref:
    """ "two towers of three red blocks", "two red towers of three blocks each": three for each tower."""
    source = replace(source, traits=replace(source.traits, colors=source.traits.colors or shape.traits.colors))
    towers = count or (
        len(source.traits.colors) if len(source.traits.colors) > 1 else DEFAULT_COLORS if by_color else 2
    )
    there = declared(source.traits, scene)
    if count is None and not by_color and there and len(there) % amount == 0 and len(there) > amount:
        towers = len(there) // amount
    if there and source.det in ("bare", "some"):
        if len(there) == towers * amount:
            return Ref(names=there)
        if some := some_of(there, towers * amount, shape, scene):
            return Ref(names=some)
    names, _ = _new(source.traits, shape, towers, amount, by_color, scene)
    return Ref(names=names)


def _given(
    theme: Ref, shape: Structure, count: int | None, per: int | None, by_color: bool, scene: Scene
) -> tuple[tuple[str, ...], int | None]:
    names = theme.names
    colors = list(dict.fromkeys(scene.things[n].color for n in names))
    if by_color and None in colors:
        towers = count or DEFAULT_COLORS
        names = scene.fit(names, max(len(names), towers * (per or DEFAULT_HEIGHT)))
        for index, name in enumerate(names):
            scene.things[name].color = STACK_COLORS[index * towers // len(names)]
        scene.assume(f"the colours are not said: {', '.join(STACK_COLORS[:towers])}")
        return names, towers
    if by_color:
        if count is not None and count != len(colors):
            raise refuse(
                "count-mismatch",
                f"{count} towers, but {len(colors)} colours",
                shape.span,
                f"say {len(colors)} towers",
                towers=count,
            )
        count = len(colors)
    elif count is not None:
        names = scene.fit(names, max(len(names), count * (per or DEFAULT_HEIGHT)))
    elif per is not None:  # "six blocks into towers of three"; where it is open how many, into two of these
        names = scene.fit(names, max(len(names), 2 * per))
        count = max(2, round(len(names) / per))
    if count is not None and (len(names) < 2 * count or (per is not None and per * count != len(names))):
        needed = per * count if per is not None else 2 * count
        raise refuse(
            "count-mismatch", f"{count} towers take {needed} blocks or more, but {len(names)} are named", shape.span,
            f"use {needed}",
            blocks=len(names), towers=count,
        )  # fmt: skip
    return names, count


def _new(
    traits: Traits, shape: Structure, count: int | None, per: int | None, by_color: bool, scene: Scene
) -> tuple[tuple[str, ...], int]:
    """New blocks for towers that name none."""
    colors = traits.colors
    if count is None:
        count = len(colors) if len(colors) > 1 else DEFAULT_COLORS if by_color else 2
        scene.assume(f"the number of towers is not said: {count}")
    height = per or DEFAULT_HEIGHT
    if per is None:
        scene.assume(f"the number of blocks is not said: {height * count}")
    if not by_color and len(colors) < 2:
        return new_members(traits, height * count, None, scene), count
    if len(colors) > 1 and len(colors) != count:
        raise refuse(
            "count-mismatch",
            f"{count} towers, but {len(colors)} colours",
            shape.span,
            "name one colour for each tower",
            towers=count,
        )
    names: list[str] = []
    for color in colors if len(colors) == count else STACK_COLORS[:count]:
        names += new_members(replace(traits, colors=(color,), scheme=None), height, None, scene)
    return tuple(names), count


def _one_each(theme: Ref, shape: Structure, scene: Scene) -> Made:
    """ "towers of two black and two pink cubes": each part a tower of its own."""
    nodes: list[g.Goal] = [s.Stack(blocks=p.names, exact=True, span=shape.span) for p in theme.parts]
    return [scene.add_built("stack", p.names, False, shape.span) for p in theme.parts], nodes


def _remember(node: s.Towers, by_color: bool, scene: Scene) -> list[Built]:
    """Towers whose members are told apart by colour are structures of their own; others are known together only."""
    names = node.blocks
    colors = list(dict.fromkeys(scene.things[n].color for n in names))
    if by_color and None not in colors:
        return [
            scene.add_built("stack", [n for n in names if scene.things[n].color == c], False, node.span or (0, 0))
            for c in colors
        ]
    if node.heights is not None:
        scene.heights[names] = node.heights
    return [scene.add_built("towers", names, False, node.span or (0, 0))]
