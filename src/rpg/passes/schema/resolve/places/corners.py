"""Blocks in each of the four corners of the table."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Amount, In, Meaning, Noun, Pronoun, Traits
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj
from rpg.passes.schema.resolve.places.different_corners import CORNERS, different_corners
from rpg.passes.schema.resolve.places.lots import one_lot_each
from rpg.passes.schema.resolve.places.patches import indefinite
from rpg.passes.schema.resolve.things.operands import spread
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

WITHOUT_CORNERS = ("stack", "towers", "row", "line", "column", "word", "equation", "pile", "group")
"""Structures that no corner is told of."""


def corners(theme: Ref, meaning: In, scene: Scene, span: Span) -> Atoms:
    """ "a red block in each corner": as many again for every corner; "four blocks in the four corners": one in each."""
    if meaning.region.startswith("different"):
        return different_corners(theme, meaning, scene, span)
    if meaning.region.startswith("opposite"):
        return _opposite_corners(theme, meaning, scene, span)
    there = corners_of(meaning.region)
    if indefinite(theme) and not theme.quant:  # "red blocks in the corners": one in each
        theme = replace(theme, names=scene.fit(theme.names, len(there)))
    theme = _but_the_rest(theme, meaning, len(there), scene)
    names = theme.names
    one_of_four = theme.quant is not None and (theme.quant.low, theme.quant.high) == (1, 1) and not theme.parts
    if one_of_four and len(names) == len(there):
        theme = replace(theme, quant=None)  # "one of them in each corner": of four, so that each has a corner
    others = [b for b in scene.built if b not in theme.built]
    if meaning.region.endswith("?") and (others or any(t.patch for t in scene.things.values())):
        raise refuse("ambiguous", "it is not clear of what these are the corners", meaning.span, "say 'of the table'")
    if theme.built:
        return _each_structure(theme, there, meaning, scene, span)
    if theme.quant is not None or theme.op != "and" or theme.patch or meaning.negated or not names:
        raise refuse("ambiguous", "it is not clear which blocks go into the corners", span, "say what each corner gets")
    if len(names) == len(there):
        things = [scene.things[n] for n in names]
        if all(t.color is None and t.label is None and t.kind is None for t in things):
            if any(thing.scheme not in (None, "same") for thing in things):
                return [_some_in(names, where, span) for where in there]
            for thing in things:
                thing.scheme = "same"
        elif not alike(things):
            return [_some_in(names, where, span) for where in there]
        lots: list[tuple[str, ...]] = [(n,) for n in names]
    elif 1 < len(names) < len(there) and not alike([scene.things[n] for n in names]):
        raise refuse("ambiguous", "one of these blocks in each corner, or all of them in every one?", span,
                     "say which block is in which corner")  # fmt: skip
    elif indefinite(theme) and len(names) > 1 and meaning.region.startswith("each_corners"):
        raise refuse("ambiguous", "it is not clear how many are in which corner", span, "say what each corner gets")
    elif indefinite(theme):
        lots = one_lot_each(theme, len(there), scene)
        for thing in (scene.things[n] for lot in lots for n in lot):
            if thing.color is None and thing.label is None and thing.kind is None:
                thing.scheme = thing.scheme or "same"
    else:
        raise refuse("count-mismatch", f"{len(names)} blocks cannot be in each of {len(there)} corners", span,
                     f"name {len(there)} blocks, or say 'a red block in each corner'")  # fmt: skip
    return [r.InRegion(a=lot, region=where, span=span) for lot, where in zip(lots, there, strict=True)]  # type: ignore[arg-type]


def corners_of(region: str) -> list[str]:
    """ "Each corner", "both far corners": which ones these are."""
    told = region.removesuffix("?").partition(":")[2]
    return [where for where in CORNERS if told in where]


def _each_structure(theme: Ref, there: list[str], meaning: In, scene: Scene, span: Span) -> Atoms:
    """ "A tower of two red blocks in each corner": one in each, which have to look alike."""
    shown = [sorted((t.color or "", t.label or "") for t in (scene.things[n] for n in b.members)) for b in theme.built]
    standing = all(b.kind == "stack" for b in theme.built) and not meaning.negated and theme.quant is None
    if not standing or len(theme.built) != len(there) or any(look != shown[0] for look in shown):
        raise refuse("ambiguous", "it is not clear which blocks go into the corners", span, "say what each corner gets")
    return [r.InRegion(a=b.members, region=where, span=span) for b, where in zip(theme.built, there, strict=True)]  # type: ignore[arg-type]


def _but_the_rest(theme: Ref, meaning: In, many: int, scene: Scene) -> Ref:
    """ "Five white cubes, one in each corner, and the fifth in the middle": four of them."""
    names, told = theme.names, scene.speaks_of_rest and meaning.region.startswith("each_corner")
    apart = not scene.parted.isdisjoint(names) or theme.quant is not None or theme.built or theme.op != "and"
    if not told or apart or len(names) <= many or not alike([scene.things[n] for n in names]):
        return theme
    scene.parted.update(names[:many])
    scene.whole = names
    return replace(theme, names=names[:many])


def _some_in(names: tuple[str, ...], where: str, span: Span) -> g.Goal:
    """One of the blocks is in this corner; as there are four, each has a corner of its own."""
    there = r.InRegion(a=(EACH,), region=where, span=span)  # type: ignore[arg-type]
    return g.Count(over=names, at_least=1, at_most=1, goal=there, span=span)


def one_for_each_corner(theme: Meaning, places: list[Meaning], scene: Scene) -> Meaning:
    """ "one block in each corner: red, green, blue and white", "four blocks. One in each corner": the four of them."""
    corner = any(isinstance(p, In) and p.region.startswith("each_corner") and not p.negated for p in places)
    one = isinstance(theme, Noun) and theme.traits == Traits() and theme.part_of is None and not theme.conditions
    one = one and isinstance(theme, Noun) and _single(theme)
    there = [t for t in scene.blocks() if t.declared and not t.extra]
    one = one or (isinstance(theme, Pronoun) and theme.word == "one")
    if corner and one and len(there) == len(CORNERS):
        return Pronoun(word="everything", span=theme.span)
    if corner and one and len(there) > len(CORNERS) and scene.speaks_of_rest and alike(there):
        four = Amount(len(CORNERS), len(CORNERS))  # "... and the fifth in the middle"
        them = Pronoun(word="everything", span=theme.span)
        return Noun(head="any", det="some", amount=four, plural=True, part_of=them, span=theme.span)
    return theme


def _single(noun: Noun) -> bool:
    """Whether this is "one block", or "one" with a number or without, as in "put one in each corner"."""
    bare = noun.head == "any" and noun.det == "bare" and noun.amount is None and not noun.plural
    return bare or (noun.head in ("block", "any") and noun.amount == Amount(1, 1))


_DIAGONAL = {
    "far_left_corner": "near_right_corner", "near_right_corner": "far_left_corner",
    "far_right_corner": "near_left_corner", "near_left_corner": "far_right_corner",
}  # fmt: skip


_PAIRS = {
    "opposite_corners": _DIAGONAL,
    "opposite_halves": {"left_half": "right_half", "right_half": "left_half", "near_half": "far_half",
                        "far_half": "near_half"},
    "opposite_edges": {"left_edge": "right_edge", "right_edge": "left_edge", "near_edge": "far_edge",
                       "far_edge": "near_edge"},
}  # fmt: skip


def _opposite_corners(theme: Ref, meaning: In, scene: Scene, span: Span) -> Atoms:
    """ "red in the far left corner and blue in the opposite one"; "red and blue in opposite corners": any two such."""
    if meaning.region == "opposite_corner":
        if (other := _in_a_corner(theme, scene)) is not None and not (meaning.negated or scene.denying):
            return [_across(other, theme.names, "opposite_corners", span)]
        if scene.region not in _DIAGONAL:
            raise refuse("no-referent", "it is not said which corner the opposite one is", meaning.span,
                         "say which one, or 'put the red and the blue cube in opposite corners'")  # fmt: skip
        where = _DIAGONAL[scene.region]
        return [spread(theme, lambda a: r.InRegion(a=a, region=where, span=span), span, together=True)]  # type: ignore[arg-type]
    units = [part.names for part in theme.parts] or [(name,) for name in theme.names]
    if len(units) != 2 or theme.quant is not None or theme.op != "and" or meaning.negated or scene.denying:
        what = meaning.region.replace("_", " ")
        raise refuse("ambiguous", f"two things can be in {what}", span, "name two blocks")
    told = {*units[0], *units[1]}
    if any(told <= {*built.members} and built.kind not in WITHOUT_CORNERS for built in scene.built):
        raise refuse("ambiguous", "of the figure, and not of the table: in which of its corners is which?", span,
                     "say 'with the A in the far left corner'")  # fmt: skip
    return [_across(units[0], units[1], meaning.region, span)]


def _across(one: tuple[str, ...], other: tuple[str, ...], regions: str, span: Span) -> g.Goal:
    """Each in one of two regions that are opposite each other."""
    ways = [
        conj([r.InRegion(a=one, region=here, span=span), r.InRegion(a=other, region=there, span=span)], span)  # type: ignore[arg-type]
        for here, there in _PAIRS[regions].items()
    ]
    return disj(ways, span)


def _in_a_corner(theme: Ref, scene: Scene) -> tuple[str, ...] | None:
    """ "Red in a corner and blue in the opposite corner": the block in a corner of which it is not said which."""
    last = next((m.ref for m in reversed(scene.mentions) if not m.ref.patch and m.ref.names != theme.names), None)
    single = last is not None and len(last.names) == 1 and last.quant is None and last.op == "and"
    plain = len(theme.names) == 1 and theme.quant is None and theme.op == "and"
    return last.names if scene.region == "corner" and single and plain and last is not None else None


_OPPOSITE = _PAIRS["opposite_halves"]


def _the_other_half(scene: Scene, span: Span) -> str:
    """ "red in the left half and blue in the other half": opposite the half that was spoken of last."""
    if scene.region not in _OPPOSITE:
        raise refuse("no-referent", "it is not said which half the other one is", span, "say 'the left half'")
    return _OPPOSITE[scene.region]


def from_their_halves(theme: Ref, place: In, scene: Scene, scope: Scope) -> list[tuple[Ref, In]]:
    """ "Red begins in the left half, blue in the right half. At the end each is in the other half": opposite the half
    that each of them begins in, if it is known of them all; where it is known of none, opposite the one spoken of."""
    begun = [goal for goal in scene.start_goals if isinstance(goal, r.InRegion) and goal.region in _OPPOSITE]
    half = {name: goal.region for goal in begun for name in names_in(goal)}
    own = {half.get(name) for name in theme.names}
    if own == {None} or theme.quant is not None or theme.op != "and" or scope.start:
        return [(theme, replace(place, region=_the_other_half(scene, place.span)))]
    if None in own:
        raise refuse("ambiguous", "it is not said of all of these in which half they begin", place.span,
                     "say 'the left half' of each")  # fmt: skip
    if len(own) == 1 and scene.region in _OPPOSITE and {scene.region} != own:
        raise refuse("ambiguous", "the other one of the two that it begins in, or of the half spoken of last?",
                     place.span, "say 'the left half'")  # fmt: skip
    return [
        (replace(theme, names=names), replace(place, region=_OPPOSITE[region]))
        for region in sorted(x for x in own if x is not None)
        if (names := tuple(name for name in theme.names if half[name] == region))
    ]


def of_something_else(theme: Ref, place: In, scene: Scene) -> bool:
    """Whether a corner, an edge or a half may be that of a structure, or a bare side, "red left", that of the patch
    that the blocks were put on."""
    bare = place.span[1] - place.span[0] < len("left half")
    return (bare and _on_a_patch(theme, scene)) or any(_has_such(x, place.region, scene) for x in scene.built)


def _has_such(built: Built, region: str, scene: Scene) -> bool:
    """Halves are those of a structure where its blocks have no colours yet."""
    plain = all(scene.things[n].color is None and scene.things[n].label is None for n in built.members)
    return built.kind not in WITHOUT_CORNERS and (plain or not region.endswith("half"))


def _on_a_patch(theme: Ref, scene: Scene) -> bool:
    """Whether the blocks were put on a patch by a clause before."""
    patched = {m.clause for m in scene.mentions if m.ref.patch and m.rel in ("on", "in") and m.clause < scene.clause}
    return any(m.clause in patched and m.role == "theme" and {*theme.names} <= {*m.ref.names} for m in scene.mentions)


def in_region(theme: Ref, region: str, span: Span) -> g.Goal:
    """What is spoken of lies in a part of the table: several blocks "in a corner" in the same one."""
    several = len(theme.names) > 1 and theme.op == "and" and theme.quant is None and not theme.each
    several = several and [built.kind for built in theme.built] != ["stack"]  # which is in one place anyway

    def inside(part: str) -> g.Goal:
        return spread(theme, lambda a: r.InRegion(a=a, region=part, span=span), span, together=True)  # type: ignore[arg-type]

    if region == "corner" and several:
        return disj([inside(f"{deep}_{side}_corner") for deep in ("near", "far") for side in ("left", "right")], span)
    return inside(region)
