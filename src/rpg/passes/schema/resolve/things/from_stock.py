"""Structures built from some of the blocks that there are: "a tower of at least three from the five blue blocks"."""

from __future__ import annotations

from rpg.language.meaning import Amount, Noun, Pronoun, Size, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.members import certain
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope

_FROM = ("from", "out of", "among", "only from", "from only")
"""What the blocks follow of which not all need be used."""


def from_stock(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> Structure:
    """One structure: its size said as its size, where it was said of the blocks; and so many of the blocks."""
    if theme is not None:
        return shape
    if _mere_size(shape, spec) and isinstance(shape.members, Noun):
        many = Size(what="size", amount=shape.members.amount, span=shape.members.span)
        shape = replace(shape, members=None, sizes=(many,))
    told = shape.members or (spec.usings[0].members if spec.usings else None)
    if isinstance(told, Pronoun) and shape.members is None and _exceeded(told, shape, spec, scene):
        _use(spec, _some(told, shape.size.low if shape.size is not None else 0))
        return shape
    if not isinstance(told, Noun) or told.traits.labels or told.amount is None:
        return shape
    if told.amount.high is None and not shape.sizes and told.det in ("some", "bare"):
        return _at_least(shape, told, spec)
    if told.part_of is not None and told.det == "some" and told.amount.low == told.amount.high and not shape.sizes:
        return replace(shape, sizes=(Size(what="size", amount=told.amount, span=told.span),))
    size = shape.size
    if shape.members is not None or size is None or size.high not in (None, size.low) or not _drawn(told, spec):
        return shape
    if size.low < told.amount.low:
        _use(spec, _some(told, size.low))
    return shape


def _exceeded(them: Pronoun, shape: Structure, spec: Spec, scene: Scene) -> bool:
    """ "(There are six blue blocks.) Build a tower of three from them": more of them than it takes."""
    size = shape.size
    if size is None or size.high not in (None, size.low) or spec.usings[0].lead not in _FROM:
        return False
    there = [thing for thing in scene.things.values() if thing.declared and not thing.patch]
    return them.word in _THEM and size.low < len(there)


_THEM = ("them", "these", "those", "it")
"""What a stock, or a heap, is called that was spoken of."""


def _mere_size(shape: Structure, spec: Spec) -> bool:
    """ "A tower of three blocks out of the six green ones": of its blocks the first phrase tells the number alone."""
    told, stock = shape.members, spec.usings[0].members if spec.usings else None
    if not isinstance(told, Noun) or not isinstance(stock, Noun) or shape.sizes or told.amount is None:
        return False
    return told.traits == Traits() and told.det == "bare" and told.part_of is None and _drawn(stock, spec)


def _at_least(shape: Structure, told: Noun, spec: Spec) -> Structure:
    """ "A tower of at least three (of the five) blue blocks": three of them will do, and more may come."""
    least = told.amount.low if told.amount is not None else 0
    shape = replace(shape, sizes=(Size(what="size", amount=Amount(least, None), span=told.span),))
    fewest = replace(told, amount=Amount(least, least))
    if shape.members is not None:
        return replace(shape, members=fewest)
    _use(spec, fewest)
    return shape


def several_from_stock(
    shape: Structure, count: int | None, spec: Spec, theme: Ref | None, scene: Scene
) -> tuple[Structure, Ref | None]:
    """Several structures of one size: so many of the blocks as they take together."""
    if theme is not None or count is None:
        return shape, theme
    members = shape.members
    if isinstance(members, Noun) and members.det == "some" and isinstance(members.part_of, Noun):
        per, stock = members.amount, members.part_of
    elif members is None and spec.usings and isinstance(spec.usings[0].members, Noun):
        per, stock = shape.size, spec.usings[0].members
    else:
        return shape, theme
    there = stock.amount
    if per is None or there is None or per.low != per.high or there.low != there.high or stock.traits.labels:
        return shape, theme
    need = per.low * count
    left = need < there.low
    if stock.part_of is not None or need > there.low or (left and members is None and not _drawn(stock, spec)):
        return shape, theme
    if members is None:
        spec.usings.pop(0)
    whole = _some(stock, need) if left else stock
    found = certain(refer(whole, scene, Scope(role="member", need=need)), scene)
    size = Size(what="size", amount=per, span=shape.span)
    return replace(shape, members=None, sizes=(size,), each_size=False), found


def _drawn(stock: Noun, spec: Spec) -> bool:
    """Whether a number of blocks is named of which some are to be taken."""
    exact = stock.amount is not None and stock.amount.low == stock.amount.high
    drawn = bool(spec.usings) and spec.usings[0].lead in _FROM
    return exact and drawn and stock.part_of is None and stock.head != "patch"


def _some(stock: Noun | Pronoun, count: int) -> Noun:
    """So many of these blocks."""
    many = Amount(count, count)
    return Noun(head="block", det="some", amount=many, plural=True, part_of=stock, span=stock.span)


def _use(spec: Spec, members: Noun) -> None:
    spec.usings[0] = replace(spec.usings[0], members=members)
