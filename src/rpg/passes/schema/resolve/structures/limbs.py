"""The arms of letters by their lengths: which T, L, U or plus they make."""

from __future__ import annotations

from rpg.language.meaning import Structure
from rpg.passes.schema.resolve.things.world import refuse

Sides = tuple[int, int]


def limbs_of(shape: Structure, count: int | None) -> tuple[Sides | None, int | None]:
    """The two lengths of a T, an L, a U or a plus, both with the block where they meet, and its number of blocks."""
    told = {size.what for size in shape.sizes} - {"size"}
    if not told:
        return None, count
    options = {"T": _of_t, "L": _of_l, "U": _of_u, "plus": _of_plus}[shape.kind](shape, count)
    if len(options) != 1:
        raise refuse(
            "ambiguous" if len(options) > 1 else "count-mismatch",
            f"these lengths make no single {shape.kind}", shape.span,
            "say how many blocks it has in all, and how long each part is",
        )  # fmt: skip
    (a, b) = options[0]
    return (a, b), b + 2 * (a - 1) if shape.kind == "U" else a + b - 1


def _of_u(shape: Structure, count: int | None) -> list[Sides]:
    """As deep as its arms with the base, and as wide as its base."""
    deep, wide = shape.extent("high", "deep"), shape.extent("wide")
    if count is not None and deep is None and wide is not None and (count - wide) % 2 == 0:
        deep = (count - wide) // 2 + 1
    if count is not None and wide is None and deep is not None:
        wide = count - 2 * (deep - 1)
    if deep is None or wide is None or deep < 2 or wide < 3:
        return []
    return [(deep, wide)] if count in (None, wide + 2 * (deep - 1)) else []


def _of_plus(shape: Structure, count: int | None) -> list[Sides]:
    """Four arms around the block in the middle, which only a number of blocks tells whether it is counted."""
    arm = shape.extent("each arm") or 0
    options = [n for n in (arm, arm - 1) if n > 0 and count in (None, 4 * n + 1)]
    return [(2 * n + 1, 2 * n + 1) for n in options]


def _of_t(shape: Structure, count: int | None) -> list[Sides]:
    """A stem begins below the bar, unless it is told or the number of blocks says that it has the bar's middle."""
    bar, stem, high = shape.extent("bar", "wide"), shape.extent("stem"), shape.extent("high")
    if high is not None and stem is None:  # all of it, of which the bar is one
        stem = high - 1
    whole = any(size.what == "stem" and size.amount and size.amount.strict for size in shape.sizes)
    if bar is not None and stem is not None and whole:
        options = [(bar, stem)]
    elif bar is not None and stem is not None:
        options = [(bar, stem + 1)] if count is None else [(bar, stem + 1), (bar, stem)]
    elif count is None:
        return []
    else:
        options = [(bar, count - bar + 1)] if bar is not None else [(count - s + 1, s) for s in _counts(stem)]
    return [(a, b) for a, b in options if a % 2 and a > 2 and b > 1 and count in (None, a + b - 1)]


def _counts(stem: int | None) -> tuple[int, ...]:
    return () if stem is None else (stem + 1, stem)


def _of_l(shape: Structure, count: int | None) -> list[Sides]:
    """Both arms have the corner; without it only a number of blocks tells how it is counted."""
    told = {size.what for size in shape.sizes}
    if "equal arms" in told:
        return [] if count is None or not count % 2 else [((count + 1) // 2, (count + 1) // 2)]
    if (each := shape.extent("each arm")) is not None:
        return [(each, each)] if count == 2 * each - 1 or (count is None and "shared" in told) else []
    long, short = shape.extent("long arm", "high", "long"), shape.extent("short arm", "wide")
    if count is not None and (long is None) != (short is None):
        long, short = (long, count - long + 1) if long is not None else (count - (short or 0) + 1, short)
    if long is None or short is None or long < short or short < 2:
        return []
    whole = long + short - 1
    if count is None:
        return [(long, short)] if told & {"shared", "wide", "high", "long"} else [(long, short), (long, short + 1)]
    return [(long, short)] if count == whole else [(long, short + 1)] if count == whole + 1 else []
