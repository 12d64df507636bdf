"""A block in the middle of an outline: "a circle of eight red blocks with a blue one in its middle"."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rpg.blocks.figures import Cell
from rpg.ir import structures as s
from rpg.language.meaning import (
    Absolute,
    At,
    Clause,
    Into,
    Loc,
    Meaning,
    Noun,
    PartOf,
    Pronoun,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.orders import order_of
from rpg.passes.schema.resolve.orders.parts import cells_of, laid, place_of
from rpg.passes.schema.resolve.structures.extents import Made, made
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse

OUTLINES = ("circle", "square")


def in_the_middle(clause: Clause) -> tuple[Absolute, Meaning] | None:
    """ "in its centre there is a white one", "put a red block inside a circle": what is in the middle of what."""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    theme = clause.theme
    if clause.verb not in ("be", "place", "exist") or clause.negated or clause.mode == "start":
        return None
    if not isinstance(place, Loc) or place.negated or place.second is not None or not isinstance(theme, Noun):
        return None
    mark = place.landmark
    if place.rel == "in" and isinstance(mark, PartOf) and mark.part == "middle":
        mark = mark.whole
    elif not (place.rel == "in" and isinstance(mark, Structure | Pronoun)) and place.rel not in ("between", "centre"):
        return None
    if isinstance(mark, Noun) and mark.head == "patch" and mark.det == "the" and mark.amount is None:
        plain = mark.traits == Traits(shape=mark.traits.shape) and mark.traits.shape in OUTLINES
        mark = Structure(kind=str(mark.traits.shape), det="the", span=mark.span) if plain else mark
    whole = isinstance(mark, Structure) and mark.kind in OUTLINES
    if mark is None or not (whole or (isinstance(mark, Pronoun) and mark.word == "it")) or not _single(theme):
        return None
    return Absolute(theme=theme, adjuncts=(At(side="middle", span=place.span),), span=clause.span), mark


def _single(theme: Noun) -> bool:
    one = not theme.plural and amount_of(theme) in (None, 1) and theme.head != "patch"
    return one and theme.part_of is None and theme.det in ("a", "the", "bare")


def outlines(clause: Clause, named: Structure | None = None) -> bool:
    """Whether a clause builds a circle or the outline of a square, and just what is named so later."""
    shapes = [clause.theme, *(a.structure for a in clause.adjuncts if isinstance(a, Into))]
    found = [x for x in shapes if isinstance(x, Structure)]
    if named is not None and named.kind not in {x.kind for x in found}:
        return False
    return len(found) == 1 and found[0].kind in OUTLINES and not found[0].filled and not found[0].plural


def brought_up(whole: Meaning) -> bool:
    """ "a circle of eight purple blocks": built by the clause that says what is in its middle."""
    return isinstance(whole, Structure) and whole.det == "a" and bool(whole.members or whole.sizes)


def in_outline(found: list[list[tuple[str, Meaning]]], clause: Clause, link: str) -> bool:
    """ "in its centre there is a white one", "nothing is inside it": said of the outline that was built before."""
    last = next((lot[-1] for lot in reversed(found) if lot), None)
    builder = last[1] if last is not None else None
    if link == "then" or not isinstance(builder, Clause) or not outlines(builder):
        return False
    if builder.negated or builder.mode == "start":
        return False
    line = max(n for n, lot in enumerate(found) if lot)
    inside = in_the_middle(clause)
    of = inside[1] if inside is not None else None
    if inside is not None and not (
        isinstance(of, Structure) and (brought_up(of) or of.members or not outlines(builder, of))
    ):
        if (filled_then := _then_filled(builder, clause, inside[0])) is not None:
            found[-1].append((link, filled_then))
            return True
        found[line][-1] = (found[line][-1][0], replace(builder, adjuncts=(*builder.adjuncts, inside[0])))
        return True
    if told_inside(clause):
        found[line][-1] = (found[line][-1][0], emptied(builder))
        return True
    return False


def _then_filled(builder: Clause, clause: Clause, hub: Absolute) -> Clause | None:
    """ "There is a circle of six white blocks. Put a red one inside it": the circle is there at the start, and this is
    what it is to be like."""
    shape = builder.theme
    asked = clause.mode == "command" or (clause.mode, clause.lemma) == ("goal", "")
    if (builder.verb, builder.mode) != ("exist", "given") or not asked or not isinstance(shape, Structure):
        return None
    of = shape.members
    known = replace(of, det="the") if isinstance(of, Noun) and of.det == "bare" else of
    adjuncts = (*builder.adjuncts, hub)
    return Clause(verb="build", theme=replace(shape, members=known), adjuncts=adjuncts, mode="goal", span=clause.span)


def hub_of(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> Absolute | None:
    """What is said of the middle of an outline of blocks that look otherwise."""
    found = [a for a in spec.absolutes if _inside(a)]
    if shape.kind not in OUTLINES or len(found) != 1 or not isinstance(found[0].theme, Noun):
        return None
    middle = found[0].theme
    source = shape.members or (spec.usings[0].members if spec.usings else None)
    own = source.traits.colors if isinstance(source, Noun) else shape.traits.colors
    if theme is not None:
        own = tuple(scene.things[n].color or "" for n in theme.names)
    told = bool(middle.traits.colors or middle.traits.labels)
    if not _single(middle) or not told or set(own) & set(middle.traits.colors):
        return None
    every = isinstance(source, Noun) and source.traits == Traits() and source.amount is None
    open_ = _around(found[0]) or (shape.kind == "circle" and (every or bool(own) or _alternating(spec)))
    return found[0] if (own and "" not in own) or (open_ and not {*own} - {""}) else None


def _inside(item: Absolute) -> bool:
    """ "(with a white one) in the middle", "in the middle of it"."""
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if isinstance(place, Loc):
        return place.rel == "between" and isinstance(place.landmark, Pronoun) and place.landmark.word == "it"
    return isinstance(at := place_of(item), At) and at.side == "middle"


def _alternating(spec: Spec) -> bool:
    return [order.by for order in spec.orders] == ["alternating"]


def _around(hub: Absolute) -> bool:
    """ "The blocks in a circle around the red one": all of them but this one, whatever they look like."""
    place = place_of(hub)
    return isinstance(place, At) and place.whole in OUTLINES


def with_hub(names: tuple[str, ...], hub: Absolute, shape: Structure, spec: Spec, scene: Scene) -> Made:
    """The outline of `names` with one more block in its middle."""
    middle = refer(hub.theme, scene, Scope(role="member")).names
    scene.mentions.pop()
    if len(middle) != 1 or middle[0] in names:
        raise refuse("ambiguous", "it is not clear which block is in the middle", hub.span, "name one further block")
    if scene.denying:
        raise refuse("ambiguous", "it is not clear what of this is denied", hub.span, "say it in two sentences")
    alternating = shape.kind == "circle" and _alternating(spec)
    if alternating:
        order_of(spec, names, "row", scene, Scope(role="member"), shape.span)
        spec.orders = []
    elif _around(hub) or all(scene.things[n].color is None for n in names):
        _of_one_look([scene.things[n] for n in names], scene)
    looks = {(t.color, t.label, t.kind, t.size) for t in (scene.things[n] for n in names)}
    ring = shape.kind == "circle"
    flat = shape.extent("layers", "high") in (None, 1) and (ring or len(names) == 8)
    if len(looks) > 1 + alternating or spec.orders or spec.patterns or not flat:
        raise refuse("misplaced", "this outline has no single middle that could be told so", hub.span,
                     "use a circle or a square of eight blocks that look alike")  # fmt: skip
    count = len(names) + 1
    square = s.Grid(blocks=("",), rows=3, columns=3)
    form = s.Figure(blocks=("",), shape="circle", filled=True) if ring else square
    cells = cells_of(form, count)
    at = next((k for k, cell in enumerate(cells) if abs(cell.x) + abs(cell.y) < 0.01), None)
    if at is None:
        raise refuse("too-few", f"{len(names)} blocks do not go around another one", shape.span, "use eight")
    ranks: tuple[tuple[str, ...], ...]
    if alternating:
        names = _in_turn(names, [cells[k] for k in range(count) if k != at], shape, scene)
        ranks = tuple((n,) for n in (*names[:at], *middle, *names[at:]))
    else:
        ranks = (names[:at], middle, names[at:])
    pattern = laid(form, ranks)
    every = (*names, *middle)
    node = form.model_copy(update={"blocks": every, "pattern": pattern, "span": shape.span})
    return made(shape.kind, node, every, shape.span, scene)


def _in_turn(names: tuple[str, ...], cells: Sequence[Cell], shape: Structure, scene: Scene) -> tuple[str, ...]:
    """The blocks of a ring cell by cell, so that two looks take turns all the way round."""
    first = [n for n in names if scene.things[n].color == scene.things[names[0]].color]
    other = [n for n in names if n not in first]
    if len(first) != len(other):
        raise refuse("count-mismatch", "these colours do not alternate all the way round", shape.span,
                     "use as many blocks of the one as of the other")  # fmt: skip
    round_ = sorted(range(len(cells)), key=lambda k: math.atan2(cells[k].y, cells[k].x))
    turns = dict(zip(round_, (n for pair in zip(first, other, strict=True) for n in pair), strict=True))
    return tuple(turns[k] for k in range(len(cells)))


def _of_one_look(ring: list[Thing], scene: Scene) -> None:
    """What is left open of the blocks around another one: they look alike, and are so many."""
    unsaid = f"the number of blocks is not said: {len(ring)}"
    if scene.assumptions.pop(unsaid, "said") is None or any(thing.elastic and not thing.color for thing in ring):
        scene.assume(f"how many blocks go around it is not said: {len(ring)}")
    for thing in ring:
        thing.elastic = None if thing.color is None else thing.elastic
        thing.scheme = thing.scheme or ("same" if thing.color is None else None)


def told_first(whole: Meaning, found: list[list[tuple[str, Meaning]]]) -> bool:
    """ "Put the red block inside the square of blue blocks": an outline that is told here for the first time."""
    if not isinstance(whole, Structure) or whole.members is None or whole.kind not in OUTLINES:
        return False
    return not any(isinstance(c, Clause) and outlines(c) for lot in found for _, c in lot)


def told_inside(clause: Clause) -> bool:
    """ "nothing is inside it": of an outline."""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    nothing = isinstance(clause.theme, Pronoun) and clause.theme.word == "nothing"
    if not nothing or not isinstance(place, Loc) or place.negated or place.rel not in ("in", "between"):
        return False
    mark = place.landmark.whole if isinstance(place.landmark, PartOf) else place.landmark
    known = isinstance(mark, Structure) and mark.kind in OUTLINES and mark.det == "the" and mark.members is None
    return known or (isinstance(mark, Pronoun) and mark.word == "it")


def emptied(clause: Clause) -> Clause:
    """The clause that builds an outline, which has nothing inside."""
    if isinstance(clause.theme, Structure):
        return replace(clause, theme=replace(clause.theme, filled=False))
    hollow = tuple(
        replace(a, structure=replace(a.structure, filled=False))
        if isinstance(a, Into) and isinstance(a.structure, Structure)
        else a
        for a in clause.adjuncts
    )
    return replace(clause, adjuncts=hollow)
