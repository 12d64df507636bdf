"""Several structures of which it is said what each is made of: "two towers, each of a red and a blue block"."""

from __future__ import annotations

from copy import copy

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.grammar.structures.copies import ALIKE, LISTED, SHARED
from rpg.language.meaning import Amount, Coord, Noun, OrderBy, Pronoun, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.copies import equal_share, in_one_order
from rpg.passes.schema.resolve.structures.several import MOST, Maker
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import create, give, matching, open_to
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, Thing, refuse

Made = tuple[list[Built], list[g.Goal]]
_ENDS = {"bottom": "top", "left": "right", "front": "back", "top": "bottom", "right": "left", "back": "front"}
KINDS = ("stack", "row", "line", "column", "pile")


def with_lots(shape: Structure, spec: Spec, scene: Scene) -> Structure:
    """ "(There are four red and two blue blocks.) Make groups of two red and one blue block", "two towers of a red and
    a blue block": what each of them has, and not all there is, as in "groups of three red and three blue blocks"."""
    members = shape.members
    lot = members.items if isinstance(members, Coord) and members.op == "and" and shape.kind in KINDS else ()
    counted = [x for x in lot if isinstance(x, Noun) and x.det in ("a", "bare") and x.amount and x.head != "patch"]
    if not shape.plural or len(counted) < max(len(lot), 2):
        return shape
    each = [(x, x.amount.low) for x in counted if x.amount is not None and x.amount.low == x.amount.high]
    total = sum(many for _, many in each)
    there = [t for t in matching(Traits(), scene, False) if t.declared]
    of_all = all(many > 1 for _, many in each) and len(there) <= total
    if len(each) < len(counted) or (of_all if shape.amount is None else total >= 2 * shape.amount.low):
        return shape
    items = tuple(replace(x, amount=Amount(1, 1), plural=False) for x, many in each for _ in range(many))
    spec.orders.append(OrderBy(by="each", items=items, span=shape.span))
    return replace(shape, members=None)


def each_made_of(shape: Structure, spec: Spec, theme: Ref | None, maker: Maker, scene: Scene, scope: Scope) -> Made:
    """So many structures, each with blocks of the looks that are said of each."""
    said = [o for o in spec.orders if o.by == "each"]
    lot = said[0]
    spec.orders = [o for o in spec.orders if o.by != "each"]
    heaped = shape.kind == "pile" and (scope.start or lot.first)
    if len(said) > 1 or shape.kind not in KINDS or heaped or spec.absolutes or spec.patterns:
        raise refuse("misplaced", "this does not go together with what else is said", lot.span, "say it of each alone")
    if not lot.items:
        raise refuse("ambiguous", "it is not said which blocks each of these has", lot.span,
                     "list them behind a colon, as in 'two identical towers: red, blue, green'")  # fmt: skip
    pool = _pool(shape, spec, theme, scene)
    count = _count(shape, lot, pool)
    spec.manner("equal")  # "of equal height, each with a red and a blue one": they are
    if lot.values == SHARED:
        lot = replace(lot, items=equal_share(lot, count))
    if lot.attribute == LISTED:
        way = spec.first(*_ENDS)
        lot = replace(lot, first=way or lot.first)
        if way is None:
            scene.assume(f"the order is read from {lot.first} to {_ENDS[lot.first or '']}")
    sizes = {z.amount for z in shape.sizes} | ({getattr(shape.members, "amount", None)} if shape.each_size else set())
    if sizes - {Amount(len(lot.items), len(lot.items)), None}:
        raise refuse("count-mismatch", f"of each {len(lot.items)} blocks are named, but another number is said",
                     lot.span, "name as many blocks as each has", named=len(lot.items))  # fmt: skip
    built: list[Built] = []
    goals: list[g.Goal] = []
    taken: set[str] = set()
    for _ in range(count):
        names = [one_of(item, pool, taken, lot, scene) for item in lot.items if isinstance(item, Noun)]
        members = Pronoun(word="=" + " ".join(names), span=lot.span)
        own = copy(spec)
        own.orders, own.usings, own.places = list(spec.orders), [], []
        if lot.first:
            items = tuple(Pronoun(word=f"={name}", span=lot.span) for name in names)
            own.orders = [OrderBy(by="given", items=items, first=lot.first, span=lot.span)]
        single = replace(shape, plural=False, amount=Amount(1, 1), det="a", sizes=(), members=None, traits=Traits())
        more, atoms = maker(single, own, refer(members, scene, Scope(role="member")), scene, scope)
        scene.mentions.pop()
        built += more
        goals += [a.model_copy(update={"exact": True}) if shape.kind == "stack" else a for a in atoms]
    if pool is not None and (left := [t for t in pool if t.name not in taken]):
        raise refuse("count-mismatch", f"{len(left)} of the blocks are in none of them", lot.span,
                     "say what each has so that all are used", left=len(left))  # fmt: skip
    spec.orders, spec.toward, spec.spacings = [], [], []
    if shape.kind == "pile":
        return built, [s.GroupBy(groups=tuple(b.members for b in built), span=shape.span)]
    return built, in_one_order(goals, scene) if lot.attribute == ALIKE else goals


def _pool(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> list[Thing] | None:
    """The blocks that are there to be used, if any are."""
    if shape.members is not None and not shape.each_size:
        theme = refer(shape.members, scene, Scope(role="member"))
    elif spec.usings:
        theme = refer(spec.usings.pop(0).members, scene, Scope(role="member"))
    if theme is not None:
        if theme.quant is not None or theme.patch:
            raise refuse("ambiguous", "it is not said which of the blocks", theme.span, "name the blocks")
        return [scene.things[n] for n in theme.names]
    return [t for t in matching(Traits(), scene, False) if t.declared and t.name not in scene.used] or None


def _count(shape: Structure, lot: OrderBy, pool: list[Thing] | None) -> int:
    """How many structures there are."""
    amount = shape.amount
    if amount is None and pool is not None and len(pool) % len(lot.items) == 0:
        return len(pool) // len(lot.items)
    if amount is None or amount.low != amount.high or not 1 < amount.low <= MOST:
        raise refuse("ambiguous", f"it is not said how many {shape.kind}s there are", shape.span, "say how many")
    return amount.low


def one_of(item: Noun, pool: list[Thing] | None, taken: set[str], lot: OrderBy, scene: Scene) -> str:
    """A block of a look: the next of those that are there, else a new one."""
    if pool is None:
        scene.new_batch()
        return create(item.traits, scene, False).name
    fits = {t.name for t in matching(item.traits, scene, False)}
    left = [t for t in pool if t.name not in taken]
    free = next((t for t in left if t.name in fits), None)
    if free is None and (free := next((t for t in left if t.kind is None and open_to(t, item.traits)), None)):
        give(free, item.traits)
    if free is None:
        raise refuse("no-referent", "there are not so many of these blocks", lot.span, "say what there is of each")
    taken.add(free.name)
    return free.name
