"""Groups of which it is told one by one what each has: "one with three red blocks and a blue one, the other ..."."""

from __future__ import annotations

from itertools import pairwise

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.language.meaning import (
    Absolute,
    Amount,
    Clause,
    Coord,
    Into,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.looks_of_each import told_looks
from rpg.passes.schema.resolve.structures.lots import one_of
from rpg.passes.schema.resolve.structures.sharing import Look
from rpg.passes.schema.resolve.things.things import alike, amount_of, matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Thing, refuse

Made = tuple[list[Built], list[g.Goal]]


def group_size(shape: Structure) -> int | None:
    """How many blocks each of several groups has, if it was said."""
    amount = getattr(shape.members, "amount", None) if shape.each_size else None
    if amount is not None and amount.low == amount.high:
        return int(amount.low)
    return shape.extent("size", "columns")


def as_groups(clause: Clause, theme: Meaning, spec: Spec, scene: Scene) -> Clause | None:
    """The clause of the groups to be built, where it tells of structures or of what each group has and not of which
    blocks there are: "group the blocks so that each group has a red and a blue one"."""
    if isinstance(theme, Structure):
        return clause
    if not any(o.by == "each" and o.items for o in spec.orders):
        return None
    groups = Structure(kind="pile", plural=True, span=clause.span)
    spec.intos = spec.intos or [Into(structure=groups, span=clause.span)]
    the_blocks = Noun(head="block", det="the", plural=True, span=theme.span)
    whichever = (isinstance(theme, Pronoun) or theme == the_blocks) and not any(scene.blocks())
    return replace(clause, theme=spec.intos.pop().structure) if whichever and len(spec.intos) == 1 else None


def equal(built: list[Built], spec: Spec) -> None:
    """ "two equal groups": of as many blocks each."""
    told = spec.manner("equal")
    if told is not None and len({len(b.members) for b in built}) > 1:
        raise refuse("count-mismatch", "these groups are not equal", told.span, "use as many blocks for each group")


def groups_joined(kept: list[tuple[str, Meaning]]) -> list[tuple[str, Meaning]]:
    """ "a group of three red blocks with a blue stranger, and a group of ...": told as one list."""
    joined: list[tuple[str, Meaning]] = []
    for link, said in kept:
        before = joined[-1][1] if joined else None
        both = _with_stranger(before), _with_stranger(said)
        if link == "and" and all(both) and isinstance(before, Clause):
            theme = Coord(op="and", items=(*both[0], *both[1]), span=before.span)
            joined[-1] = joined[-1][0], replace(before, theme=theme)
        else:
            joined.append((link, said))
    return joined


def _with_stranger(said: Meaning | None) -> tuple[Meaning, ...]:
    """The groups that a clause builds and says no more of, where each has blocks of several looks."""
    theme = said.theme if isinstance(said, Clause) and said.verb == "build" and not said.adjuncts else None
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    lots = [x for x in items if isinstance(x, Structure) and x.kind == "pile" and getattr(x.members, "op", "") == "lot"]
    return tuple(lots) if len(lots) == len(items) else ()


def told_apart(said: Clause) -> tuple[Clause, ...]:
    """ "Group the cubes: letters together, digits together": the grouping, and each group that is told; or nothing."""
    told = [x for a in said.adjuncts for x in _absolutes(a)]
    together = [x for x in told if len(x.adjuncts) == 1 and getattr(x.adjuncts[0], "rel", "") == "together"]
    if said.verb != "sort" or said.negated or len(together) < 2 or len(together) < len(told):
        return ()
    rest = tuple(a for a in said.adjuncts if not _absolutes(a))
    groups = (Clause(verb="be", theme=x.theme, adjuncts=x.adjuncts, mode="goal", span=x.span) for x in together)
    return replace(said, adjuncts=rest), *groups


def _absolutes(adjunct: Meaning) -> tuple[Absolute, ...]:
    items = adjunct.items if isinstance(adjunct, Coord) and adjunct.op == "absolutes" else (adjunct,)
    return tuple(x for x in items if isinstance(x, Absolute))


def sorted_with_strangers(said: Meaning) -> Meaning:
    """ "a group of four red blocks and a group of four blue ones, one wrong in each": sorted with strangers."""
    theme = said.theme if isinstance(said, Clause) and said.verb in ("build", "be") and not said.negated else None
    if not isinstance(said, Clause) or not isinstance(theme, Coord) or theme.op != "and":
        return said
    told = [x.members for x in _with_stranger(said) if isinstance(x, Structure) and x.members is not None]
    if told:
        place = Places(side="one", unit="whole", span=theme.span)
        each = tuple(Absolute(theme=x, adjuncts=(place,), span=x.span) for x in told)
        detail = Coord(op="absolutes", items=each, span=theme.span)
        many = Amount(len(told), len(told))
        whole = Structure(kind="pile", amount=many, plural=True, det="bare", details=(detail,), span=theme.span)
        return replace(said, verb="build", theme=whole)
    piles = [x.members for x in theme.items if isinstance(x, Structure) and x.kind == "pile" and not x.plural]
    lots = [x for x in piles if isinstance(x, Noun) and len(x.traits.colors) == 1 and x.amount is not None]
    strange = any(isinstance(x, Manner) and x.kind == "outliers" for x in said.adjuncts)
    if not strange or len(lots) != len(theme.items):
        return said
    return replace(said, verb="sort", lemma="sort", theme=replace(theme, items=tuple(lots)))


def told_lots(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> Made:
    """So many groups, each with the blocks that are said of it."""
    amount = shape.amount or Amount(len(spec.absolutes), len(spec.absolutes))
    looks, axis = told_looks(spec, amount.low)
    size = group_size(shape)
    members = None if size is not None and amount_of(shape.members) == size else shape.members
    if spec.absolutes or members is not None or amount.low != amount.high or spec.orders or None in looks:
        raise refuse("ambiguous", "it is not said which blocks are in which group", shape.span, "name each group")
    order = OrderBy(by="each", span=shape.span)
    pool = [scene.things[n] for n in theme.names] if theme is not None else None
    pool = pool or [t for t in scene.blocks() if t.declared and not t.extra and t.name not in scene.used] or None
    taken: set[str] = set()
    lots = tuple(
        _of_a_class(look, pool, taken, scene)
        or tuple(one_of(x, pool, taken, order, scene) for x in _blocks(look, size))
        for look in looks
    )
    if pool is not None and len(taken) < len(pool):
        raise refuse("count-mismatch", "some of the blocks are in none of the groups", shape.span,
                     "say what each group has so that all are used")  # fmt: skip
    if axis is None and (mixed := _mixed(lots, shape, scene)) is not None:
        return mixed
    node: type[r.LeftOf | r.InFrontOf] = r.LeftOf if axis == "y" else r.InFrontOf
    goals: list[g.Goal] = [s.GroupBy(groups=lots, span=shape.span)]
    goals += [node(a=a, b=b, span=shape.span) for a, b in pairwise(lots)] if axis is not None else []
    return [scene.add_built("pile", lot, False, shape.span) for lot in lots], goals


def _of_a_class(look: Look, pool: list[Thing] | None, taken: set[str], scene: Scene) -> tuple[str, ...]:
    """ "one has the vowels", "one with the red ones": those of the blocks that were spoken of."""
    marks = look.traits if isinstance(look, Noun) and look.amount is None else Traits()
    told = isinstance(look, Noun) and look.det == "the" and look.plural and len(marks.colors) == 1
    if pool is None or not (marks.kind or marks.quality or told) or marks.labels or (marks.colors and not told):
        return ()
    fits = {t.name for t in matching(marks, scene, False)}
    found = tuple(t.name for t in pool if t.name in fits and t.name not in taken)
    taken.update(found)
    return found


def _blocks(look: Look, size: int | None) -> list[Noun]:
    """The blocks of one group one by one."""
    items = look.items if isinstance(look, Coord) and look.op == "lot" else (look,)
    found: list[Noun] = []
    for item in items:
        if not isinstance(item, Noun):
            raise refuse("ambiguous", "it is not said which blocks this group has", None, "name the blocks of each")
        marks = item.traits
        if size is not None and item.amount is None and len(items) == 1 and len(marks.colors) == 1:
            item = replace(item, amount=Amount(size, size))
        many = item.amount or Amount(1, 1)
        names = [replace(marks, labels=(x,)) for x in marks.labels] or [marks]
        known = item.amount is not None or marks.labels or len(marks.colors) > 1
        if not known or len(marks.colors) > 1 or many.low != many.high or (len(names) > 1 and item.amount):
            raise refuse("ambiguous", "it is not said how many blocks this group has", item.span, "say how many")
        found += [replace(item, traits=one, amount=Amount(1, 1)) for one in names for _ in range(many.low)]
    if size is not None and len(found) != size:
        raise refuse("count-mismatch", f"groups of {size} are asked for, but this one has {len(found)}", items[0].span
                     if isinstance(items[0], Noun) else None, "say how many blocks each group has")  # fmt: skip
    return found


def _mixed(lots: tuple[tuple[str, ...], ...], shape: Structure, scene: Scene) -> Made | None:
    """Look-alikes in two groups of two colours: by colour with so many strangers in each, which of them being open.
    That says as much as how many of each there are; None where it does not."""
    if not any(alike([scene.things[a], scene.things[b]]) for one, two in pairwise(lots) for a in one for b in two):
        return None
    colors = [[scene.things[n].color for n in lot] for lot in lots]
    most = [max(set(lot), key=lot.count) for lot in colors]
    strange = {len(lot) - lot.count(best) for lot, best in zip(colors, most, strict=True)}
    plain = all(scene.things[n].label is None for lot in lots for n in lot)
    if len(strange) > 1 or len(set(most)) < len(most) or len(lots) != 2 or not plain:
        return None
    if any(scene.things[n].color not in most for lot in lots for n in lot):
        return None
    kinds = tuple(tuple(n for lot in lots for n in lot if scene.things[n].color == best) for best in most)
    node = s.GroupBy(groups=kinds, by="color", outliers=strange.pop(), span=shape.span)
    return [scene.add_built("pile", tuple(n for lot in lots for n in lot), False, shape.span)], [node]
