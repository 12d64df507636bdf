"""Which T, L or U the parts make that are told of it: how long they are, and where it points."""

from __future__ import annotations

from rpg.language.compose.limbs import Limb
from rpg.language.compose.scene import OPPOSITE, Unclear


def drawn(kind: str, limbs: tuple[Limb, ...], total: int) -> tuple[tuple[int, int], str]:
    """The two lengths of such a letter, of so many blocks if that is said, and where it points.

    Raises Unclear where they make none, or more than one.
    """
    parts = {limb.part: limb for limb in limbs}
    if len(parts) < len(limbs):
        raise Unclear
    return {"T": _of_t, "L": _of_l, "U": _of_u}[kind](parts, total)


def _of_t(parts: dict[str, Limb], total: int) -> tuple[tuple[int, int], str]:
    bar, stem = parts.get("bar", Limb("bar")), parts.get("stem", Limb("stem"))
    if set(parts) - {"bar", "stem"}:
        raise Unclear
    ways = {OPPOSITE[bar.side]} if bar.side else set()
    ways |= {way for way in (stem.way, stem.side) if way}
    if len(ways) > 1:
        raise Unclear
    if bar.way or (bar.across and not ways & {"near", "far"}) or stem.across:
        raise Unclear
    wide, long = bar.count, stem.count
    if total and not wide:
        wide = total - long if long else 0
    if not wide:
        return (0, 0), next(iter(ways), "")
    if not total and not long:
        raise Unclear
    total = total or wide + long
    if long and total not in {wide + long, wide + long - 1}:
        raise Unclear
    if wide % 2 == 0 or wide < 3 or total - wide < 1:
        raise Unclear
    return (wide, total - wide + 1), next(iter(ways), "")


def _of_l(parts: dict[str, Limb], total: int) -> tuple[tuple[int, int], str]:
    long, foot = parts.get("long", Limb("long")), parts.get("foot", Limb("foot"))
    if set(parts) - {"long", "foot"} or long.side or long.across or foot.across:
        raise Unclear
    way = foot.way or (foot.side if foot.side in {"left", "right"} else "")
    sided = foot.side in {"near", "far"} or bool(long.way)
    if sided and (foot.side == "far" or long.way not in {"", "far"} or way not in {"left", "right"}):
        raise Unclear  # on which side of its foot the long arm is
    count, short = long.count, foot.count
    if not count:
        return (0, 0), way
    if not total and not short:
        raise Unclear
    if short > 1 and total != count + short - 1:
        raise Unclear  # with the corner, or without it
    total = total or count + short
    if short and total not in {count + short, count + short - 1}:
        raise Unclear
    if not 2 <= total - count + 1 <= count:
        raise Unclear
    return (count, total - count + 1), way


def _of_u(parts: dict[str, Limb], total: int) -> tuple[tuple[int, int], str]:
    if {"left", "right"} & set(parts):
        return _of_u_by_sides(parts, total)
    arm, base = parts.get("arm", Limb("arm")), parts.get("base", Limb("base"))
    if set(parts) - {"arm", "base"} or arm.side or base.way or arm.across:
        raise Unclear
    ways = {way for way in (arm.way, OPPOSITE.get(base.side, "")) if way}
    if len(ways) > 1 or (base.across and not ways & {"near", "far"}):
        raise Unclear
    deep, wide = arm.count, base.count
    total = total or (wide + 2 * (deep - 1) if deep and wide else 0)
    if not (deep or wide):
        return (0, 0), next(iter(ways), "")
    if deep and not wide:
        wide = total - 2 * (deep - 1)
    if wide and not deep:
        deep = (total - wide) // 2 + 1
    if deep < 2 or wide < 3 or wide + 2 * (deep - 1) != total:
        raise Unclear
    return (deep, wide), next(iter(ways), "")


def _of_u_by_sides(parts: dict[str, Limb], total: int) -> tuple[tuple[int, int], str]:
    """ "Three on the left side, three on the right side, and one in the middle that connects them at the front"."""
    if set(parts) != {"left", "right", "inner"}:
        raise Unclear
    left, right, inner = (parts[side] for side in ("left", "right", "inner"))
    whole = left.count + right.count + inner.count
    if left.count != right.count or left.count < 2 or inner.side not in {"near", "far"} or total not in {0, whole}:
        raise Unclear
    return (left.count, inner.count + 2), OPPOSITE[inner.side]
