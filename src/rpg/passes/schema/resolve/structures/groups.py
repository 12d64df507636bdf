"""Piles, groups and sorting."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.blocks.traits import QUALITIES
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.schema import SYMBOLS_UNSAID
from rpg.language.later import later
from rpg.language.meaning import Amount, Noun, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.grouped import equal, group_size, told_lots
from rpg.passes.schema.resolve.structures.towers import STACK_COLORS
from rpg.passes.schema.resolve.things.members import declared, members_of, new_members
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, Thing, refuse, said

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")

Made = tuple[list[Built], list[g.Goal]]
DEFAULT_GROUPS = 3
DEFAULT_EACH = 2


def piles(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a pile of red blocks and ...", "three piles", "piles by colour"."""
    attribute = attribute_of(spec)
    if shape.det == "each":
        raise refuse("misplaced", "it is not clear what is in each of them", shape.span, "say what each group has")
    if shape.det == "the" and shape.members is None and theme is not None and not scope.start and _there(theme, scene):
        raise refuse("ambiguous", "a group that is there already would get further blocks", shape.span,
                     "say at once what is in the group")  # fmt: skip
    several = shape.plural or attribute is not None
    if scope.start and scene.denying:
        raise refuse("misplaced", "this says nothing of how they lie", shape.span, "say how they start")
    if scope.start and not several:
        names = members_of(shape, spec, theme, None, 4, scene, scope)
        if names not in scene.heaps:  # "a pile of five blocks at the start. Goal: ...", told again as a heading has it
            scene.heaps.append(names)
        for name in names:
            scene.things[name].declared = True
        return [scene.add_built("pile", names, False, shape.span)], []
    if not several:
        names = members_of(shape, spec, theme, group_size(shape), 4, scene, scope)
        return [scene.add_built("pile", names, False, shape.span)], [s.GroupBy(groups=(names,), span=shape.span)]
    if attribute is None and spec.absolutes:
        return told_lots(shape, spec, theme, scene)
    if attribute is None and theme is not None:
        made = share_out(theme, shape, spec, scene, shape.span)
        equal(made[0], spec)
        return made
    if attribute is None and group_size(shape) is not None:
        return share_out(_new_lots(shape, spec, scene), shape, spec, scene, shape.span)
    members = theme.names if theme is not None else None
    return sort_into(members, attribute, shape, spec, scene, scope, shape.span)


def _there(theme: Ref, scene: Scene) -> bool:
    """Whether there is a group that these blocks are to join."""
    return any(b.kind == "pile" and not {*theme.names} & {*b.members} for b in scene.built)


def _new_lots(shape: Structure, spec: Spec, scene: Scene) -> Ref:
    """ "three piles of two red blocks each": the blocks of all of them."""
    count = (shape.amount.low if shape.amount else DEFAULT_GROUPS) * (group_size(shape) or 1)
    source = shape.members or Noun(head="block", plural=True, span=shape.span)
    if not isinstance(source, Noun):
        raise refuse("ambiguous", "it is not said which blocks are in which group", shape.span, "name each group")
    if source.traits == Traits() and spec.usings:
        return refer(spec.usings.pop(0).members, scene, Scope(need=count, role="member"))
    return refer(replace(source, det="bare", amount=Amount(count, count), plural=True), scene, Scope(role="member"))


def share_out(theme: Ref, shape: Structure, spec: Spec, scene: Scene, span: Span) -> Made:
    """ "divide six blocks into two groups": look-alikes in equal lots, parts named one by one as they are named."""
    count = shape.amount.low if shape.amount and shape.amount.low > 1 else None
    parts = tuple(p.names for p in theme.parts)
    _check_mixed(shape)
    size = group_size(shape)
    if len(parts) > 1 and count in (None, len(parts)) and size is not None and any(len(p) != size for p in parts):
        raise refuse("count-mismatch", f"groups of {size} are asked for, but not so many of each kind", shape.span,
                     "say what each group has, as in 'groups of one red and one blue block'")  # fmt: skip
    if len(parts) > 1 and any(len(p) > 1 for p in parts) and count in (None, len(parts)):
        return _lots(parts, spec, scene, span)
    things = [scene.things[n] for n in theme.names]
    open_ = all(t.color is None and t.label is None and t.kind is None for t in things)
    if count is None or not (open_ or alike(things)):
        return sort_into(theme.names, None, shape, spec, scene, Scope(), span)
    size = group_size(shape) or DEFAULT_EACH
    names = scene.fit(theme.names, count * size) if all(t.elastic for t in things) else theme.names
    if len(names) % count or (group_size(shape) or len(names) // count) * count != len(names):
        raise refuse(
            "count-mismatch",
            f"{len(names)} blocks do not make {count} groups of one size",
            shape.span,
            "say how many blocks each group has",
            blocks=len(names),
            groups=count,
        )
    for name in names:
        scene.things[name].scheme = "same"
    each = len(names) // count
    return _lots(tuple(names[i * each : (i + 1) * each] for i in range(count)), spec, scene, span)


def _check_mixed(shape: Structure | None) -> None:
    """Refuse "two mixed groups" as of groups that each have one colour."""
    if shape is not None and shape.traits.scheme == "mixed":
        raise refuse("ambiguous", "it is not said how these groups are mixed", shape.span, "say what each group has")


def _lots(groups: tuple[tuple[str, ...], ...], spec: Spec, scene: Scene, span: Span) -> Made:
    spec.places = [p for p in spec.places if getattr(p, "rel", "") not in ("apart",)]
    built = [scene.add_built("pile", lot, False, span) for lot in groups]
    return built, [s.GroupBy(groups=groups, span=span)]


def outliers_of(spec: Spec) -> int:
    """How many strangers each group is to have."""
    found = spec.manner("outliers")
    return int(float(found.value or 0)) if found is not None else 0


def attribute_of(spec: Spec) -> str | None:
    """What blocks are sorted by, if it was said."""
    found = next((o for o in spec.orders if o.by == "attribute"), None)
    if found is not None:
        again = replace(found, span=(0, 0), values=())
        spec.values = next((o.values for o in spec.orders if o.attribute == found.attribute and o.values), ())
        spec.orders = [o for o in spec.orders if replace(o, span=(0, 0), values=()) != again]
        spec.patterns = [p for p in spec.patterns if p.unit not in ("pile", "stack") or p.attribute != found.attribute]
        return found.attribute
    pattern = next((p for p in spec.patterns if p.unit in ("pile", "stack")), None)
    if pattern is not None:
        spec.patterns.remove(pattern)
        return pattern.attribute
    return None


def _to_be_sorted(shape: Structure | None, spec: Spec, scene: Scene) -> tuple[str, ...]:
    """The blocks of groups of which nothing else says what they are made of."""
    count = shape.amount.low if shape and shape.amount and shape.amount.low > 1 else DEFAULT_GROUPS
    source = shape.members if shape is not None else None
    source = source or (spec.usings.pop(0).members if spec.usings else None)
    there = declared(Traits(), scene)
    if there and shape is not None and shape.det == "the":
        raise refuse("ambiguous", "it is not clear which groups these are", shape.span, "say what is in each of them")
    if there and (source is None or shape is None or shape.each_size):
        scene.used.update(there)
        return there
    if source is not None:
        count = shape.amount.low if shape and shape.amount else DEFAULT_GROUPS
        return refer(source, scene, Scope(need=count * DEFAULT_EACH, need_each=DEFAULT_EACH, role="member")).names
    scene.assume(f"the number of blocks is not said: {count * DEFAULT_EACH}")
    made = new_members(Traits(), count * DEFAULT_EACH, None, scene)
    scene.vague.update(made)
    return made


def sort_into(
    members: tuple[str, ...] | None,
    attribute: str | None,
    shape: Structure | None,
    spec: Spec,
    scene: Scene,
    scope: Scope,
    span: Span,
) -> Made:
    """Groups that lie apart, one for each value of the attribute."""
    _check_mixed(shape)
    if members is None:
        members = _to_be_sorted(shape, spec, scene)
    wanted = shape.amount.low if shape is not None and shape.amount and shape.amount.low > 1 else DEFAULT_GROUPS
    if all(scene.things[n].elastic for n in members) and len(members) < wanted * DEFAULT_EACH:
        members = scene.fit(members, wanted * DEFAULT_EACH)
    things = [scene.things[n] for n in members]
    if attribute is None:
        attribute = _guess(things, scene)
    fill(things, attribute, shape.amount.low if shape and shape.amount and shape.amount.low > 1 else None, scene)
    keyed: dict[str, list[str]] = {}
    for thing in things:
        _fits_in(thing, attribute, spec, span)
        keyed.setdefault(value_of(thing, attribute), []).append(thing.name)
    if len(keyed) < 2:
        raise refuse(
            "one-group",
            f"all the blocks agree in {attribute}, so that there is nothing to sort",
            span,
            "use blocks that differ in it",
        )
    if shape is not None and shape.amount and shape.amount.low > 1 and shape.amount.low != len(keyed):
        raise refuse(
            "count-mismatch",
            f"{shape.amount.low} groups are asked for, but sorting gives {len(keyed)}",
            span,
            f"say {len(keyed)} groups",
            asked=shape.amount.low,
            groups=len(keyed),
        )
    size = group_size(shape) if shape is not None else None
    if size is not None and any(len(v) != size for v in keyed.values()):
        raise refuse("count-mismatch", f"groups of {size} are asked for, but sorting gives others", span,
                     "say how many blocks of each kind there are", size=size)  # fmt: skip
    groups = tuple(tuple(v) for v in keyed.values())
    spec.places = [p for p in spec.places if getattr(p, "rel", "") not in ("apart",)]
    built = [scene.add_built("pile", v, False, span) for v in groups]
    return built, [s.GroupBy(groups=groups, by=attribute, outliers=outliers_of(spec), span=span)]  # type: ignore[arg-type]


def _fits_in(thing: Thing, attribute: str, spec: Spec, span: Span) -> None:
    """Refuse "A, B, 3 and a green block into letters and digits": a block that is of none of the groups."""
    label = thing.label or ""
    wanted = {"vowel": label.isalpha(), "parity": label.isdigit(), "label": bool(label)}.get(attribute, True)
    if not wanted or (spec.values and value_of(thing, attribute) not in spec.values):
        raise refuse("ambiguous", f"it is not said to which group {said(thing)} belongs", span,
                     "leave it out, or say where it should be")  # fmt: skip


def _guess(things: list[Thing], scene: Scene) -> str:
    kinds = {t.kind for t in things}
    if len(kinds) > 1 and len({(t.kind, t.color) for t in things}) > len({t.color for t in things}) > 1:
        raise refuse("ambiguous", "by colour, or by letters, numbers and plain blocks?", None,
                     "say 'by color' or 'by kind'")  # fmt: skip
    if len({t.color for t in things}) > 1 or all(t.color is None and t.kind is None for t in things):
        scene.assume("what to sort by is not said: colour")
        return "color"
    if len({t.kind for t in things}) > 1:
        scene.assume("what to sort by is not said: letters, numbers and plain blocks")
        return "kind"
    raise refuse("ambiguous", "it is not said what to sort by", None, "say 'by color', 'by letter' or 'by size'")


def value_of(thing: Thing, attribute: str) -> str:
    """The value of an attribute as text."""
    match attribute:
        case "color":
            return thing.color or "ivory"
        case "kind":
            return thing.kind or "plain"
        case "label":
            return thing.label or ""
        case "vowel":
            return "vowel" if (thing.label or "") in QUALITIES["vowel"] else "consonant"
        case "parity":
            return "even" if (thing.label or "1") in "02468" else "odd"
        case _:
            return str(thing.size or thing.edge or "medium")


def fill(things: list[Thing], attribute: str, groups: int | None, scene: Scene) -> None:
    """Give blocks whose looks are open values of the attribute, so that there is something to sort."""
    open_ = [t for t in things if t.color is None and t.label is None and t.kind in (None, "letter", "digit", "symbol")]
    if attribute == "color":
        plain = [t for t in open_ if t.kind is None]
        values = groups or (3 if len(plain) >= 6 else 2)
        if plain and len(plain) < values:
            raise refuse(
                "too-few",
                f"{len(plain)} blocks do not make {values} groups",
                None,
                "use more blocks",
                blocks=len(plain),
            )
        for index, thing in enumerate(plain):
            thing.color = STACK_COLORS[index * values // len(plain)]
        scene.vague.update(thing.name for thing in plain)
        if plain:
            scene.assume(f"the colours are not said: {', '.join(STACK_COLORS[:values])}")
    elif attribute == "size":
        for index, thing in enumerate(things):
            if thing.size is None and thing.edge is None:
                thing.size = ("small", "big")[index * 2 // len(things)]
        scene.assume("the sizes are not said: small and big")
    elif attribute in ("vowel", "parity", "label") or (attribute == "kind" and all(t.kind is None for t in things)):
        _fill_labels(open_, attribute, scene)


def _fill_labels(open_: list[Thing], attribute: str, scene: Scene) -> None:
    if not open_:
        return
    rows = {"vowel": "AEIBCD", "parity": "246135", "label": "AABBCCDD", "kind": "AB12"}[attribute]
    for index, thing in enumerate(open_):
        if attribute == "kind" and index % 3 == 2:
            thing.color = STACK_COLORS[index % len(STACK_COLORS)]
            continue
        if attribute == "kind":
            label = "ABCDEFG"[index // 3] if index % 3 == 0 else "1234567"[index // 3]
        else:
            label = rows[index % len(rows)]
        thing.label = label
        thing.kind = "letter" if label.isalpha() else "digit"
    scene.assume(f"{SYMBOLS_UNSAID}: chosen to fit")


__all__ = ["attribute_of", "fill", "piles", "replace", "sort_into", "value_of"]
