"""Clauses whose theme is a structure."""

from __future__ import annotations

from rpg.ir import structures as s
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Size,
    Spacing,
    Structure,
    That,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.arranging import arrange_blocks
from rpg.passes.schema.resolve.clauses.fitting import uses_orders
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.said_later import said_later
from rpg.passes.schema.resolve.places.placing import Goals, absolutes, is_extra, loose_ats, places
from rpg.passes.schema.resolve.places.relations import related
from rpg.passes.schema.resolve.structures.boards import by_corners, by_layers
from rpg.passes.schema.resolve.structures.figures import check_built
from rpg.passes.schema.resolve.structures.lined_towers import line_of, lined_up
from rpg.passes.schema.resolve.structures.lines_apart import between_lines
from rpg.passes.schema.resolve.structures.on_each_patch import on_each_patch
from rpg.passes.schema.resolve.structures.side_of_two import side_of_two, sided
from rpg.passes.schema.resolve.structures.structures import make
from rpg.passes.schema.resolve.structures.towers_apart import stacked_alone
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spoken import known_ones
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def shaped(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """A structure as the theme ("build a tower of ..."), or what the clause is to form ("arrange in a circle")."""
    if (goals := _remade(clause, spec, scene, scope)) is not None:
        return goals
    _of_them_all(clause, spec)
    spec.usings = [using for using in spec.usings if not _first_named(using.members, clause.theme, scene)]
    if clause.lemma == "line" and not spec.intos and getattr(clause.theme, "kind", "") == "stack":
        spec.intos.append(Into(structure=Structure(kind="line", span=clause.span), span=clause.span))
    elif clause.lemma == "line" and isinstance(clause.theme, Coord) and not spec.toward:
        raise refuse("misplaced", "it is not clear what is lined up", clause.span, "say '... from left to right'")
    clause = _where_all_of_it_is(on_each_patch(clause, spec.places, scene), spec, scope)
    named = spec.intos.pop(0).structure if clause.theme is None else clause.theme
    shapes = _out_of_one_stock(list(named.items) if isinstance(named, Coord) else [named], spec)
    parts: list[Ref] = []
    goals = []
    of_each = [replace(z, what="size") for z in spec.sizes if z.what == "columns"] if len(shapes) > 1 else []
    lines = [x for x in shapes if isinstance(x, Structure) and x.kind in ("row", "line", "column")]
    ways = [] if len(lines) < 2 or len(lines) < len(shapes) else [*spec.toward]
    apart, spacings, sizes = between_lines(shapes, spec), [*spec.spacings], [*spec.sizes]
    for shape in shapes:
        spec.toward, spec.spacings = [*ways] or spec.toward, [*spacings]
        spec.sizes = [*sizes] if isinstance(shape, Structure) and shape.sizes else spec.sizes
        if of_each:
            spec.sizes = [*(z for z in spec.sizes if z.what not in ("columns", "size")), *of_each]
        if is_extra(shape) and len(shapes) > 1:
            refer(shape, scene, Scope())
            scene.mentions.pop()
            continue
        part, atoms = _part(shape, clause, spec, scene, scope)
        parts.append(part)
        goals += atoms
    built = [b for part in parts for b in part.built]
    ref = Ref(names=tuple(dict.fromkeys(n for p in parts for n in p.names)), built=tuple(built), plural=len(built) > 1,
              parts=tuple(parts) if len(parts) > 1 else (), span=clause.span)  # fmt: skip
    scene.mention(ref, "theme")
    if spec.intos:
        raise refuse(
            "order-conflict", "two structures are named for the same blocks", spec.intos[0].span, "keep one of them"
        )
    used = list(goals)
    spec.places += apart
    goals += _beside_the_other(parts, spec, scene, clause)
    if uses_orders(built):
        spec.orders = []
    goals += places(ref, spec, scene, scope, clause.span)
    goals += side_of_two(ref, clause, spec, scene, scope)
    if len(built) == 1 and built[0].kind in ("stack", "word") and not scope.start and sided(spec):
        goals += loose_ats(ref, spec, scene, scope, clause.span)
    if spec.absolutes:
        goals += absolutes(ref, spec, scene, scope)
    if scope.start and any(b.kind == "pile" for b in built):
        return goals
    if not used and not goals:
        raise stacked_alone(clause, built) or refuse("no-goal", "it is not said what to do with it", clause.span)
    return goals


def _out_of_one_stock(shapes: list[Meaning], spec: Spec) -> list[Meaning]:
    """ "Out of six red blocks make a tower of four and one of two": the blocks of all of them, where they are alike."""
    made = [x for x in shapes if isinstance(x, Structure)]
    if len(made) < 2 or len(made) < len(shapes) or any(not _counted_alone(x) for x in made[:-1]):
        return shapes
    last = made[-1].members
    told = last.part_of if isinstance(last, Noun) else None
    pool = told or (spec.usings[0].members if last is None and len(spec.usings) == 1 else None)
    if pool is None or not isinstance(pool, Noun) or pool.amount is None:
        return shapes
    sizes = [x.size or (x.members.amount if isinstance(x.members, Noun) else None) for x in made]
    lots = [size for size in sizes if size is not None and size.low == size.high]
    if len(lots) < len(made) or pool.traits == Traits() or pool.amount.low != pool.amount.high:
        raise refuse("ambiguous", "it is not clear which of these blocks form which structure", pool.span,
                     "say of which blocks each of them is")  # fmt: skip
    need = sum(size.low for size in lots)
    if need != pool.amount.low:
        raise refuse("count-mismatch", f"{need} blocks are needed, but {pool.amount.low} are there", pool.span,
                     "use as many blocks as are needed")  # fmt: skip
    spec.usings = [] if told is None else spec.usings
    pools = [replace(pool, det="bare", amount=size, plural=True) for size in lots]
    return [replace(x, members=own, sizes=()) for x, own in zip(made, pools, strict=True)]


def _counted_alone(shape: Structure) -> bool:
    """ "a tower of three", and no more is said of it."""
    own = shape.members
    bare = isinstance(own, Noun) and own.head == "any" and own.traits == Traits() and own.det == "bare"
    return (own is None or (bare and not shape.sizes)) and len(shape.sizes) < 2


def _where_all_of_it_is(clause: Clause, spec: Spec, scope: Scope) -> Clause:
    """ "Build a tower of red and blue that is on the mat": of the tower, as it should be, and not of the blue block."""
    shape = clause.theme
    higher = [x for x in spec.places if isinstance(x, Loc) and x.rel == "above" and "somewhere" in x.mods]
    if isinstance(shape, Structure) and shape.kind == "stack" and higher:
        raise refuse("ambiguous", "on top of it, or of more blocks?", higher[0].span, "say how many blocks each has")
    if not isinstance(shape, Structure) or shape.det not in ("a", "bare", "some", "the") or scope.given:
        return clause
    items = shape.members.items if isinstance(shape.members, Coord) else (shape.members,)
    last = items[-1]
    if not isinstance(last, Noun) or not last.conditions:
        return clause
    told = [x.clauses for x in last.conditions if isinstance(x, That) and x.kind == "whole"]
    if shape.det == "the" and not (told and all("aside" in getattr(x, "mods", ()) for x in told)):
        return clause
    if not told:
        if len(items) > 1 and last.det == "a" and not scope.start:
            raise refuse("ambiguous", "it is not clear whether this is of the block or of all of it",
                         last.conditions[0].span, "say it in a sentence of its own")  # fmt: skip
        if last.det != "bare" or last.amount or (last.head != "any" and not last.traits.labels):
            return clause
        told = list(last.conditions)
    if len(told) < len(last.conditions) or not all(isinstance(x, Loc | In) for x in told):
        return clause
    spec.places += told
    kept = replace(last, conditions=())
    members = replace(shape.members, items=(*items[:-1], kept)) if isinstance(shape.members, Coord) else kept
    return replace(clause, theme=replace(shape, members=members))


def all_it_has(theme: Meaning | None, spec: Spec, scene: Scene) -> bool:
    """ "The blocks start as a tower of red and blue": of blocks that the structure itself is the first to name."""
    return len(spec.intos) == 1 and _first_named(theme, spec.intos[0].structure, scene)


def _first_named(blocks: Meaning | None, shape: Meaning | None, scene: Scene) -> bool:
    if scene.things:
        return False
    plain = isinstance(blocks, Pronoun) and blocks.word in ("everything", "all")
    if isinstance(blocks, Noun) and blocks.det in ("the", "all", "bare"):
        plain = blocks == Noun(head="block", det=blocks.det, plural=True, span=blocks.span)
    listed = isinstance(shape, Structure) and any(isinstance(x, OrderBy) and x.items for x in shape.details)
    return plain and isinstance(shape, Structure) and (shape.members is not None or listed)


def _of_them_all(clause: Clause, spec: Spec) -> None:
    """ "a tower of red and blue, a green block and a yellow one: all of them in the left half": where all of it is."""
    theme = clause.theme
    several = isinstance(theme, Structure) and theme.plural
    sizes = (*spec.sizes, *theme.sizes) if isinstance(theme, Structure) and several else ()
    if loose := next((z for z in sizes if z.what == "size" and z.cost), None):  # "two red towers, six blocks"
        raise refuse("ambiguous", "so many in all, or in each of them?", loose.span, "say 'in all' or 'each'")
    for told in list(spec.absolutes) if several else ():  # "three stacks of two, each on its own patch"
        marks = [getattr(a, "landmark", None) for a in told.adjuncts]
        own = all(isinstance(m, Noun) and m.head == "patch" and m.traits.scheme == "different" for m in marks)
        if isinstance(told.theme, Pronoun) and told.theme.word == "each" and own:
            spec.absolutes.remove(told)
            spec.places += told.adjuncts
    for told in list(spec.absolutes) if isinstance(clause.theme, Coord) else ():
        whose = told.theme.part_of if isinstance(told.theme, Noun) and told.theme.det == "all" else told.theme
        all_ = isinstance(whose, Pronoun) and whose.word in ("them", "all of them", "everything", "all")
        if all_ and told.adjuncts and all(isinstance(a, Loc | In) for a in told.adjuncts):
            spec.absolutes.remove(told)
            spec.places += told.adjuncts


def _remade(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "the blocks: a circle", "turn the row into a tower", "alphabetize the row D, B, A": of blocks that are there."""
    theme = clause.theme
    if theme is not None and said_later(clause, spec, scene):
        return arrange_blocks(refer(theme, scene, scope), clause.verb, spec, scene, scope, clause.span)
    if isinstance(theme, Coord) and len(theme.items) == 2 and isinstance(theme.items[0], Noun):
        last = theme.items[1]
        if isinstance(last, Structure) and last.members is None and theme.cost:
            blocks = refer(theme.items[0], scene, scope)
            spec.intos.append(Into(structure=last, span=last.span))
            return arrange_blocks(blocks, "arrange", spec, scene, scope, clause.span)
    if clause.lemma == "alphabetize":
        spec.orders.append(OrderBy(by="label", span=clause.word or clause.span))
    known = _known_already(clause, scene)
    sorted_ = clause.lemma == "alphabetize" or (not known and _put_in_order(clause, spec))
    if sorted_ and isinstance(theme, Structure) and theme.det == "the":
        again = Structure(kind=theme.kind, span=theme.span)
        spec.intos.append(Into(structure=again, span=theme.span))
    if known and clause.verb == "build" and isinstance(theme, Structure) and not (spec.intos or theme.members):
        begun = theme.traits.rank is None and bool(scene.start_goals)  # "at the end the row is C, B, A"
        listed = [x for x in theme.details if isinstance(x, OrderBy) and x.items and begun]
        spec.orders += listed
        spec.intos += [Into(structure=Structure(kind=theme.kind, span=theme.span), span=theme.span) for _ in listed[:1]]
    if (line := _lined_already(clause, spec, scene, scope)) is not None:
        return line
    if isinstance(theme, Structure) and spec.intos and (known or sorted_ or clause.lemma == "turn into"):
        there = refer(theme, scene, scope if known else replace(scope, start=True, given=True))
        return arrange_blocks(Ref(names=there.names, plural=True), "arrange", spec, scene, scope, clause.span)
    return None


def _put_in_order(clause: Clause, spec: Spec) -> bool:
    """ "sort the row 3 1 2 (ascending)", "put the row C A B in order": as it is listed it is there at the start."""
    theme, into = clause.theme, spec.intos
    if clause.verb not in ("place", "sort", "arrange") or clause.negated or into or not isinstance(theme, Structure):
        return False
    listed = theme.members is not None or any(isinstance(x, OrderBy) and x.items for x in theme.details)
    if theme.kind not in _LINES or theme.det != "the" or theme.plural or not listed:
        return False
    if clause.verb == "sort" and not (spec.orders or spec.places):
        spec.orders.append(OrderBy(by="in_order", span=clause.word or clause.span))
    into_order = [o for o in spec.orders if o.by in _SORTING]
    shown = [label for part in parts_of(theme) if isinstance(part, Noun) for label in part.traits.labels]
    if not into_order or (shown and shown == sorted(shown) and into_order[0].by == "in_order"):
        return False
    if spec.places:
        raise refuse("ambiguous", "is it put there as it is, or in order?", spec.places[0].span, "use two sentences")
    return True


_SORTING = frozenset({"in_order", "label", "number", "ascending", "size", "rainbow"})


def _lined_already(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "Stack each colour. The towers stand in a row", "... form a row": of the towers, and never of all blocks."""
    towers, line = clause.theme, spec.intos[0].structure if len(spec.intos) == 1 else None
    if clause.lemma == "form" and len(spec.usings) == 1:
        towers, line = spec.usings[0].members, clause.theme
    if not isinstance(towers, Structure) or towers.kind != "stack" or not towers.plural or clause.negated:
        return None
    if not isinstance(line, Structure) or line.kind not in ("row", "line") or line.plural or line.members is not None:
        return None
    told = line.details or line.sizes or spec.orders or spec.ats or spec.absolutes
    if told or clause.lemma == "turn into" or not _spoken_of(towers, clause, scene):
        return None
    spec.intos, spec.usings = [], []
    there = refer(towers, scene, scope)
    return [line_of(list(there.built), spec, scene, clause.span), *places(there, spec, scene, scope, clause.span)]


def _part(shape: Meaning, clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> tuple[Ref, Goals]:
    """One of the structures that a clause speaks of: built, or known already."""
    if isinstance(shape, Structure) and not _spoken_of(shape, clause, scene):
        if shape.kind == "pile" and spec.places and clause.verb == "stack":
            raise refuse("misplaced", "piles lie on the table", shape.span)
        if shape.det == "the" and clause.verb not in ("build", "arrange"):
            check_built(shape)
        shape = _as_long(_of_neighbors(shape, spec, scene), clause)
        shape = by_layers(by_corners(lined_up(_laid_in(shape, spec), spec), spec), spec)
        built, atoms = make(shape, spec, None, scene, scope)
        atoms = [*atoms, line_of(built, spec, scene, shape.span)] if spec.lined else atoms
        spec.intos = [i for i in spec.intos if getattr(i.structure, "kind", "") != "set"]
        return Ref(names=tuple(n for b in built for n in b.members), built=tuple(built), span=shape.span), atoms
    if isinstance(shape, Noun) and shape.det == "each" and shape.head == "any" and shape.traits.colors:
        raise refuse("ambiguous", "it is not clear of what this is each one", shape.span, "say it in two sentences")
    ref = refer(shape, scene, scope)
    if clause.verb == "stack" and ref.built and not spec.intos and all(b.kind == "pile" for b in ref.built):
        return _piled_up(ref, scene)
    if not ref.built and not spec.places:
        raise refuse("no-goal", "it is not said where these blocks should be", shape.span, "say where they should be")
    return ref, []


def _piled_up(ref: Ref, scene: Scene) -> tuple[Ref, Goals]:
    """ "(Sort them by colour and) stack each group"."""
    short = next((b for b in ref.built if len(b.members) < 2), None)
    if short is not None:
        raise refuse("too-few", "a lone block is no tower", ref.span, "name at least two blocks of each", blocks=1)
    goals: Goals = [s.Stack(blocks=b.members, span=ref.span) for b in ref.built]
    built = tuple(scene.add_built("stack", b.members, False, ref.span) for b in ref.built)
    return replace(ref, built=built), goals


_BLOCKS = Noun(head="block", plural=True, span=(0, 0))


def _as_long(shape: Structure, clause: Clause) -> Structure:
    """ "a tower that reads HOUSE": of as many blocks as the word has letters; "a row of blocks: red, blue, red"."""
    listed = [x for x in clause.adjuncts if isinstance(x, OrderBy) and len(x.items) > 1]
    if len(listed) == 1 and isinstance(shape.members, Noun) and replace(shape.members, span=(0, 0)) == _BLOCKS:
        return replace(shape, members=None)
    told = [x for that in clause.adjuncts if isinstance(that, That) for x in parts_of(that)]
    words = [x.theme for x in told if isinstance(x, Clause) and x.verb == "spell" and isinstance(x.theme, Structure)]
    bare = shape.kind in _LINES and not (shape.members or shape.sizes or shape.plural or clause.adjuncts[1:])
    if not bare or len(words) != 1 or not words[0].letter:
        return shape
    many = Amount(len(words[0].letter), len(words[0].letter))
    return replace(shape, sizes=(Size(what="size", amount=many, span=words[0].span),))


def _of_neighbors(shape: Structure, spec: Spec, scene: Scene) -> Structure:
    """ "a row in which the six pink blocks touch each other": what it is made of, and how close they stand."""
    inner = spec.thats[0].clauses if len(spec.thats) == 1 and spec.thats[0].kind == "so" else None
    told = inner.clauses[0] if isinstance(inner, Chain) and len(inner.clauses) == 1 else None
    place = told.adjuncts[0] if isinstance(told, Clause) and len(told.adjuncts) == 1 else None
    plain = shape.kind in _LINES and not (shape.members or shape.sizes or shape.plural) and shape.traits == Traits()
    if not plain or not isinstance(told, Clause) or not isinstance(place, Loc) or told.verb != "be" or told.negated:
        return shape
    mutual = getattr(place.landmark, "word", "") in ("each other", "one another") and not place.negated
    blocks = told.theme.items if isinstance(told.theme, Coord) and told.theme.op == "and" else (told.theme,)
    counted = [x for x in blocks if isinstance(x, Noun) and x.amount is not None and x.det in ("the", "bare", "all")]
    if not mutual or place.rel not in ("touching", "adjacent", "side_by_side") or len(counted) < len(blocks):
        return shape
    if any(all(thing.color not in x.traits.colors for x in counted) for thing in scene.blocks()):
        return shape  # the row may have these, too
    spec.thats = []
    if place.rel == "touching" and shape.kind != "stack":
        spec.spacings.append(Spacing(kind="touching", span=place.span))
    return replace(shape, members=told.theme)


def _laid_in(shape: Structure, spec: Spec) -> Structure:
    """ "a gradient in one row", "a countdown in a tower", "a line in a column": a line, and how it lies."""
    into = spec.intos[0].structure if len(spec.intos) == 1 else None
    if isinstance(into, Structure) and into.kind == "grid" and shape.kind == "checkerboard":
        return _sized_in(shape, into, spec)
    if shape.kind not in ("line", "gradient") or not isinstance(into, Structure) or into.kind not in _LINES:
        return shape
    single = not (shape.plural or into.plural) and into.traits == Traits() and into.det in ("a", "bare")
    if not single or (shape.members and into.members) or (shape.sizes and into.sizes):
        return shape
    spec.intos = []
    rainbow = (OrderBy(by="rainbow", span=shape.span),) if shape.kind == "gradient" else ()
    return replace(
        shape,
        kind=into.kind,
        members=shape.members or into.members,
        sizes=shape.sizes or into.sizes,
        details=(*rainbow, *shape.details, *into.details),
        upright=into.upright,
    )


def _sized_in(board: Structure, into: Structure, spec: Spec) -> Structure:
    """ "a checkerboard of four red and five black cubes in a 3x3 grid": how large it is."""
    plain = not (into.plural or into.members or into.details) and into.traits == Traits() and into.det in ("a", "bare")
    if not plain or board.dims or board.sizes or not (into.dims or into.sizes):
        return board
    spec.intos = []
    return replace(board, dims=into.dims, sizes=into.sizes)


_LINES = ("row", "column", "line", "stack")


def _beside_the_other(parts: list[Ref], spec: Spec, scene: Scene, clause: Clause) -> Goals:
    """ "a red tower and a blue tower next to it": the last one next to the one before; "a red tower and a yellow and a
    white block next to it": both blocks next to the tower."""
    own = [p for p in spec.places if isinstance(p, Loc) and isinstance(p.landmark, Pronoun) and p.landmark.word == "it"]
    if len(parts) < 2 or not own:
        return []
    whole, *others = parts if parts[0].built and not any(p.built for p in parts[1:]) else parts[-2:]
    if len(others) + 1 < len(parts):
        raise refuse("ambiguous", "it is not clear what 'it' is", own[0].span, "name what you mean")
    spec.places = [p for p in spec.places if p not in own]
    return [x for place in own for other in others for x in related(other, whole, place, scene, clause.span)]


def _known_already(clause: Clause, scene: Scene) -> bool:
    return isinstance(clause.theme, Structure) and _spoken_of(clause.theme, clause, scene)


def _spoken_of(shape: Structure, clause: Clause, scene: Scene) -> bool:
    if clause.verb in ("build", "spell") and shape.det in ("a", "bare", "some"):
        return False
    groups = shape.kind == "pile" and shape.det == "bare" and shape.plural and clause.verb == "be"
    again = groups and shape.amount is None and shape.members is None
    return (again or shape.det in ("the", "its", "each", "all", "both")) and bool(known_ones(shape, scene))
