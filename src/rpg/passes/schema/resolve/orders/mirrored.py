"""Lines told from the middle outwards: "green in the middle, a blue on each side of it, red at both ends"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Absolute, Amount, At, Loc, Meaning, Noun, OrderBy, Places, Pronoun, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.things import amount_of

_BESIDE = frozenset({"beside", "adjacent", "touching", "around"})
_IT = frozenset({"it", "that", "this", "them", "those", "that one", "this one"})
Shell = tuple[Noun, int]
"""Blocks of one look, and how many of them stand on each side of the middle (or in it)."""


def mirrored(shape: Structure, spec: Spec) -> bool:
    """Whether the parts of a line tell all of it, the same on both sides; the whole order replaces them in `spec`."""
    source = shape.members
    plain = source is None or (isinstance(source, Noun) and source.head == "block" and not _look(source))
    orders = [o for o in spec.orders if o.by != "mirrored"]
    if not plain or shape.plural or shape.traits.colors or shape.traits.labels or orders or len(spec.absolutes) < 2:
        return False
    total = shape.extent("size", "long", "high", "columns", "wide", "total") or amount_of(source)
    found = _shells(spec.absolutes)
    if found is None or (shape.kind == "stack" and len(found) > 2):
        return False
    (middle, inside), *around = found
    half = [noun for noun, many in reversed(around) for _ in range(many)]
    line = (*half, *[middle] * inside, *reversed(half))
    items = tuple(_single(noun, noun in line[:k]) for k, noun in enumerate(line))
    if total not in (None, len(items)):
        return False
    spec.absolutes = []
    spec.orders = [OrderBy(by="named", items=items, span=shape.span)]
    return True


def _shells(parts: Sequence[Absolute]) -> list[Shell] | None:
    """The middle and what is around it, from the inside out; None where this does not tell the whole line."""
    middle: list[Shell] = []
    beside: list[Shell] = []
    ends: list[Shell] = []
    last: Noun | None = None
    for part in parts:
        theme, place = part.theme, part.adjuncts[0]
        if len(part.adjuncts) != 1 or not isinstance(theme, Noun) or not _one_look(theme):
            return None
        if isinstance(place, At | Places) and place.side == "middle" and place.index is None:
            many = getattr(place, "several", None) or amount_of(theme) or (None if theme.plural else 1)
            if many is None or middle:
                return None
            middle.append((theme, many))
        elif (many := _of_one_side(theme, place)) is None:
            return None
        elif isinstance(place, Places) and place.side in ("ends", "outer"):
            ends.append((theme, many))
        elif isinstance(place, Loc) and not _of(place.landmark, [*middle, *beside], last):
            return None
        else:
            beside.append((theme, many))
        last = theme
    if len(middle) != 1 or len(ends) > 1 or not (ends or beside):
        return None
    return [middle[0], *beside, *ends]


def _of_one_side(theme: Noun, place: Meaning) -> int | None:
    """How many stand on each of two sides."""
    if isinstance(place, Places):
        if place.side not in ("ends", "outer", "beside") or place.unit != "block" or place.several not in (None, 2):
            return None
    elif not isinstance(place, Loc) or place.rel not in _BESIDE or place.negated or place.low or place.high:
        return None
    many = amount_of(theme)
    if many is None:
        return 1 if isinstance(place, Places) or theme.plural else None
    if many == 1:
        return 1 if isinstance(place, Places) else None
    if isinstance(place, Places) and place.each:
        return many
    return many // 2 if many % 2 == 0 else None


def _of(mark: Meaning | None, inner: list[Shell], last: Noun | None) -> bool:
    """Whether this is the outermost of the blocks that were told so far."""
    if not inner:
        return False
    outermost = inner[-1][0]
    if isinstance(mark, Pronoun):
        return mark.word in _IT and last is outermost
    return isinstance(mark, Noun) and mark.det == "the" and mark.traits == outermost.traits


def _look(noun: Noun) -> bool:
    return bool(noun.traits.colors or noun.traits.labels or noun.traits.kind or noun.part_of or noun.conditions)


def _one_look(noun: Noun) -> bool:
    marks = noun.traits
    told = len(marks.colors) + len(marks.labels) == 1 and not marks.either and marks.rank is None and not marks.extra
    return told and noun.det in ("a", "bare", "the", "another") and noun.head != "patch" and noun.part_of is None


def _single(noun: Noun, again: bool) -> Noun:
    one = replace(noun, det="bare", amount=None, plural=False, head="any")
    return replace(one, det="another", amount=Amount(1, 1)) if again and noun.traits.labels else one
