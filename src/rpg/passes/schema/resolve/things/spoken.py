"""Structures that were spoken of before, and are meant again."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.language.meaning import Amount, Coord, Noun, OrderBy, Structure, Traits, replace
from rpg.passes.schema.resolve.structures.towers_apart import on_their_sides, tell_apart
from rpg.passes.schema.resolve.things.things import fits, matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, Thing, refuse

SPOKEN_OF = ("the", "its", "each", "all", "both", "bare")
"""Determiners of structures that may have been spoken of before."""
_FAMILY = {"line": "row", "column": "row", "checkerboard": "grid"}


def as_it_stands(ref: Ref, scene: Scene) -> list[g.Goal]:
    """ "Move the tower onto the mat": a structure of the start that is put somewhere is one there, too."""
    wholes = [(set(built.members), built.kind == "stack") for built in ref.built]
    told = [x for x in scene.start_goals if isinstance(x, s.Stack | s.Row | s.Grid | s.Figure | s.Spells)]
    pairs = [x for x in scene.start_goals if isinstance(x, r.On) and isinstance(x.a, tuple) and isinstance(x.b, tuple)]
    return [
        *(x for x in told if (set(x.blocks), isinstance(x, s.Stack)) in wholes),
        *(x for x in pairs if any(built.kind == "stack" and {*x.a, *x.b} <= {*built.members} for built in ref.built)),
    ]


def known_ones(shape: Structure, scene: Scene, role: str = "") -> list[Built]:
    """Structures brought up before that fit the description; what stands beside "that tower" is another one."""
    tell_apart(shape, scene)
    found = _fitting(shape, scene) or _with_its_color(shape, scene)
    bare = shape.det == "the" and not (shape.members or shape.plural)
    if not found and bare and shape.kind in ("row", "line"):  # "the word stands in a row, red behind that row"
        found = [x for kind in ("word", "equation") for x in _fitting(replace(shape, kind=kind), scene)]
    found = _parted(found) if shape.plural else found
    if role == "landmark" and len(found) > 1:
        now = [m.ref for m in scene.mentions if m.clause == scene.clause and m.role == "theme"]
        found = [x for x in found if not any(x in ref.built for ref in now)] or found
    if not found and shape.kind == "pile" and bare and not scene.heaps:
        return known_ones(replace(shape, kind="stack"), scene)  # "green on brown, white left of that pile"
    return found


def _parted(found: list[Built]) -> list[Built]:
    """ "(Nine blocks in a heap end as one pile per color,) the piles apart": what the others are parts of is none of
    them."""
    return [x for x in found if {*x.members} != {n for one in found if one is not x for n in one.members}] or found


def other_of_two(shape: Structure, scene: Scene, role: str) -> list[Built]:
    """ "the red tower is left of the other tower": of the two there are, the one that is not spoken of here."""
    if shape.det != "other" or shape.plural or shape.members is not None or role != "landmark":
        return []
    now = {b for m in scene.mentions if m.clause == scene.clause and m.role == "theme" for b in m.ref.built}
    left = known_ones(replace(shape, det="the"), scene, role)
    return left if len(now) == len(left) == 1 and not now & {*left} else []


def _fitting(shape: Structure, scene: Scene) -> list[Built]:
    found = []
    for built in scene.built:
        if _FAMILY.get(built.kind, built.kind) != _FAMILY.get(shape.kind, shape.kind):
            continue
        things = [scene.things[n] for n in built.members]
        colors = shape.traits.colors
        if colors and any(t.color not in colors for t in things):
            continue
        kind = Traits(quality=shape.traits.quality, kind=shape.traits.kind)
        if kind != Traits() and not all(fits(t, kind) for t in things):
            continue
        if (
            shape.letter
            and len(shape.letter) > 1
            and shape.kind in ("word", "equation")
            and "".join(t.label or "" for t in things) != shape.letter
        ):
            continue
        if (
            isinstance(shape.members, Noun)
            and shape.members.traits.colors
            and not _one_of_it(shape.members)
            and any(t.color not in shape.members.traits.colors for t in things)
        ):
            continue
        if not _of_these(shape, things):
            continue
        if (n := exact_size(shape)) is not None and n != len(things):
            continue
        found.append(built)
    return _ranked(shape, _holding(shape, found, scene), scene)


def _of_these(shape: Structure, things: list[Thing]) -> bool:
    """Whether "the tower of green on pink", "the row with A and B", "the row of three reds" can be these blocks."""
    whole = shape.members.items if isinstance(shape.members, Coord) else (shape.members,)
    items = [*whole, *(x for order in shape.details if isinstance(order, OrderBy) for x in order.items)]
    told = [x for x in items if isinstance(x, Noun) and _mere_look(x.traits)]
    looks = {look for thing in things for look in (thing.color, thing.label)}
    if not all({*noun.traits.colors, *noun.traits.labels} <= looks for noun in told):
        return False
    counts = [(x.amount, sum(t.color in x.traits.colors for t in things)) for x in told if x.plural and x.traits.colors]
    return all(amount is None or amount.low != amount.high or amount.low == there for amount, there in counts)


def _mere_look(traits: Traits) -> bool:
    return traits == Traits(colors=traits.colors, labels=traits.labels, kind=traits.kind)


def _holding(shape: Structure, found: list[Built], scene: Scene) -> list[Built]:
    """ "the tower with A": of several, the one that has that block in it."""
    whole = shape.members
    if len(found) < 2 or not isinstance(whole, Noun) or whole.plural or whole.amount not in (None, Amount(1, 1)):
        return found
    named = whole.traits.labels or _one_of_it(whole)
    held = [thing.name for thing in matching(whole.traits, scene, False)] if named else []
    having = [built for built in found if {*held} & {*built.members}]
    return having if len(having) == 1 else found


def _one_of_it(whole: Noun) -> bool:
    """ "the tower with the red block": it has that block in it, and others."""
    return whole.det == "the" and not whole.plural and whole.amount is None


def _with_its_color(shape: Structure, scene: Scene) -> list[Built]:
    """ "the red tower" after "red on white": the one that has red in it, where no tower is all red."""
    whole = shape.members
    one = isinstance(whole, Noun) and not whole.plural and whole.amount in (None, Amount(1, 1))
    colors = shape.traits.colors
    if one and isinstance(whole, Noun) and whole.traits == Traits(colors=whole.traits.colors):
        colors = colors or whole.traits.colors
    elif whole is not None:
        return []
    if shape.det != "the" or not colors:
        return []
    there = [built for built in scene.built if built.kind == shape.kind]
    found = [b for b in there if any(scene.things[n].color in colors for n in b.members)]
    if not found and (shape.sizes or whole is not None):
        return []
    if len(found) > 1 and whole is not None:
        return []
    if there and len(found) != 1:
        raise refuse("ambiguous", "it is not clear which of those spoken of this is", shape.span, "name its blocks")
    return found


def one_built(noun: Noun, scene: Scene, scope: Scope) -> Ref | None:
    """ "a red tower of two and a blue one of three, the red one on the mat": of several structures of one kind, the one
    of all blocks that look so."""
    marks = noun.traits
    if scope.role == "theme" and (lot := _group_of(noun, scene)) is not None:
        return lot
    if noun.det == "the" and marks == Traits(labels=marks.labels) and not matching(marks, scene, False):
        drawn = [b for b in scene.built if (b.kind,) == marks.labels]  # "an L of five blocks ... the L"
        return Ref(names=drawn[0].members, built=(drawn[0],)) if len(drawn) == 1 else None
    if noun.head != "any" or noun.det != "the" or noun.plural or noun.amount is not None or scope.pool:
        return None
    if len(marks.colors) != 1 or marks != Traits(colors=marks.colors) or len(scene.built) < 2:
        return None
    names = {t.name for t in matching(marks, scene, False)}
    hues = [{scene.things[n].color for n in b.members} for b in scene.built if b.kind == "stack"]
    if not names and scope.role == "theme" and len(hues) == len(scene.built) and all(len(hue) == 1 for hue in hues):
        raise refuse("no-referent", "no tower spoken of looks so, and no block was named that does", noun.span,
                     "say 'a block', or name one of the towers")  # fmt: skip
    like = [b for b in scene.built if {scene.things[n].color for n in b.members} == {*marks.colors}]
    if len(names) < 2 or len(like) != 1 or len({b.kind for b in scene.built}) > 1:
        return None
    now = [m for m in scene.mentions if m.clause == scene.clause and m.role == "theme" and m.ref.built]
    alone = names == {*like[0].members} and like[0].kind in ("stack", "row", "column", "line")
    there = scope.role == "theme" or now if alone else scope.role == "landmark" and now
    return Ref(names=like[0].members, built=(like[0],)) if there else None


def _group_of(noun: Noun, scene: Scene) -> Ref | None:
    """ "Sort the blocks into two groups. Gray goes on the left": the group of all the gray ones."""
    marks, plain = noun.traits, noun.amount is None and noun.det in ("bare", "the") and noun.head == "any"
    if not plain or marks != Traits(colors=marks.colors) or len(marks.colors) != 1:
        return None
    names = {t.name for t in matching(marks, scene, False)}
    lot = next((b for b in scene.built if b.kind == "pile" and {*b.members} == names), None)
    several = sum(b.kind == "pile" for b in scene.built) > 1
    return Ref(names=lot.members, built=(lot,), plural=True) if lot is not None and several and len(names) > 1 else None


def _ranked(shape: Structure, found: list[Built], scene: Scene) -> list[Built]:
    """ "the first tower", "the left stack", "the taller tower": the one of those built that is meant."""
    rank, told = shape.traits.rank, shape.amount.low if shape.amount is not None and not shape.plural else 1
    if rank is None:
        return found
    if found and 1 < told != len(found):  # "the taller of the two towers"
        raise refuse("count-mismatch", f"{told} are spoken of, but there are {len(found)}", shape.span,
                     f"say {len(found)}", asked=told, there=len(found))  # fmt: skip
    if len(found) > 1 and (rank.isdigit() or rank == "last"):
        index = len(found) if rank == "last" else int(rank)
        return found[index - 1 : index]
    if rank in ("most", "least"):
        long = sorted({len(built.members) for built in found})
        utmost = long[-1 if rank == "most" else 0] if len(long) > 1 else None
        return [built for built in found if len(built.members) == utmost]
    return on_their_sides(rank, found, scene)


def exact_size(shape: Structure) -> int | None:
    """The number of blocks along one structure, if it was said."""
    found = {s.amount for s in shape.sizes if s.amount is not None}
    if len(found) > 1:
        raise refuse("contradiction", "two sizes are given", shape.span, "keep one of them")
    amount = next(iter(found), None)
    return amount.low if amount is not None and amount.low == amount.high else None
