"""How large a flat figure is: its sides, arms and limbs, and how many blocks it has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear

_SIZES = ("equal", "dims", "side", "rows", "lines", "arm", "limb", "along", "base")
_KNOWN: dict[str, tuple[str, ...]] = {
    "plus": ("arm", "equal"),
    "X": ("arm", "equal"),
    "circle": (),
    "square": ("dims", "side", "rows", "equal"),
    "rectangle": ("dims",),
    "triangle": ("side", "rows", "lines", "base", "equal"),
    "T": ("limb", "arm", "dims"),
    "L": ("limb", "along", "arm", "side", "dims", "equal"),
    "V": ("arm", "equal"),
    "U": ("limb", "arm", "dims", "side"),
}
"""The sizes that each figure has."""


@dataclass(frozen=True)
class Sized:
    """The figure as it is named, its measures, how many blocks it has, if that is told, and whether by its sizes."""

    name: str
    measures: str = ""
    total: int | None = None
    measured: bool = False


def sized(pieces: Sequence[Piece], shape: str, total: int | None) -> Sized:
    """The figure with its sizes, checked against the number of its blocks."""
    return replace(_sized(pieces, shape, total), measured=any(piece.kind in _SIZES for piece in pieces))


def _sized(pieces: Sequence[Piece], shape: str, total: int | None) -> Sized:
    """The figure with its sizes.

    Raises:
        Unclear: the sizes are none that it has, or do not agree.
    """
    if any(piece.kind in _SIZES and piece.kind not in _KNOWN[shape] for piece in pieces):
        raise Unclear
    fill = one(pieces, "fill")
    rings = {"outline"} if shape == "circle" else {"outline", "ring", "frame"}
    outlined = any(piece.kind == "figure" and rings & {*piece.words.split()} for piece in pieces)
    filled = fill.value if fill else "hollow" if outlined else ""
    if outlined and filled != "hollow":
        raise Unclear
    if filled and shape not in ("square", "rectangle", "triangle", "circle"):
        raise Unclear
    if shape in ("square", "rectangle", "triangle"):
        return _sided(pieces, shape, filled, total)
    if shape == "circle":
        return Sized("a filled circle" if filled == "filled" else "a circle", "", total)
    if shape in ("plus", "X", "V"):
        return _armed(pieces, shape, total)
    return {"T": _tee, "L": _ell, "U": _you}[shape](pieces, total)


def _agreed(total: int | None, *possible: int) -> int:
    """The one number of blocks that there may be."""
    found = {number for number in possible if total in (None, number)}
    if len(found) != 1:
        raise Unclear
    return found.pop()


def _value(pieces: Sequence[Piece], kind: str) -> Any:
    piece = one(pieces, kind)
    return piece.value if piece else None


def _sided(pieces: Sequence[Piece], shape: str, filled: str, total: int | None) -> Sized:
    """A square, rectangle or triangle, filled or not."""
    name = {"hollow": f"the outline of a {shape}", "filled": f"a filled {shape}", "": f"a {shape}"}[filled]
    if shape == "triangle":
        return _triangle(pieces, name, filled, total)
    if one(pieces, "rows"):
        raise Unclear
    if shape == "square":
        return _square(pieces, name, filled, total)
    dims = _value(pieces, "dims")
    if not dims:
        return Sized(name, "", total)
    how, a, b = dims
    if min(a, b) < 2:
        raise Unclear
    if not filled and (total is None or how == "sides"):
        filled = "hollow" if how == "sides" else "filled"
    solid, hollow = [a * b] if filled != "hollow" else [], [2 * (a + b) - 4] if filled != "filled" else []
    found = _agreed(total, *solid, *hollow)
    filled = "filled" if found == a * b else "hollow"
    if how == "x":
        return Sized(f"a {filled} {a}x{b} rectangle", "", found)
    across = f", {a} blocks wide and {b} blocks deep," if how == "wide" else f", {a} blocks long and {b} blocks wide,"
    return Sized(f"a {filled} rectangle", across, found)


def _triangle(pieces: Sequence[Piece], name: str, filled: str, total: int | None) -> Sized:
    """A triangle, by its sides or rows."""
    side, lines, rows, base = (_value(pieces, kind) for kind in ("side", "lines", "rows", "base"))
    sides = {length for length in (side, lines) if length}
    sides |= {base[0]} if base else set()
    if rows:
        n = len(rows)
        if rows not in ([*range(1, n + 1)], [*range(n, 0, -1)]) or filled == "hollow":
            raise Unclear
        sides, filled, name = sides | {n}, "filled", "a filled triangle"
    if len(sides) > 1:
        raise Unclear
    if not sides:
        return Sized(name, "", total)
    n = sides.pop()
    if n > 3 and not filled and total is None:
        raise Unclear
    solid, hollow = [n * (n + 1) // 2] if filled != "hollow" else [], [3 * n - 3] if filled != "filled" else []
    return Sized(name, f" with {n} blocks per side", _agreed(total, *hollow, *solid))


def _square(pieces: Sequence[Piece], name: str, filled: str, total: int | None) -> Sized:
    """A square, by its sides."""
    dims, side = _value(pieces, "dims"), _value(pieces, "side")
    sides = {side} if side else set()
    if dims:
        if dims[1] != dims[2]:
            raise Unclear
        sides |= {dims[1]}
    if not sides:
        return Sized(name, "", total)
    n = sides.pop()
    if sides or n < (3 if filled == "hollow" and dims else 2):
        raise Unclear
    if not filled:
        filled = "filled" if dims or total == n * n else "hollow"
    found = _agreed(total, n * n if filled == "filled" else 4 * n - 4)
    return Sized(f"a {filled} {n}x{n} square", "", found)


def _armed(pieces: Sequence[Piece], shape: str, total: int | None) -> Sized:
    """A plus, an X or a V, by its arms."""
    arm = _value(pieces, "arm")
    name = "an X" if shape == "X" else f"a {shape}"
    if arm is None:
        return Sized(name, "", total)
    if shape == "plus":
        apart = one(pieces, "apart") is not None
        if total is None and not apart:
            raise Unclear  # does an arm begin in the middle?
        found = _agreed(total, 4 * arm + 1, *([] if apart else [4 * arm - 3]))
        arm = (found - 1) // 4
        return Sized(name, f" with each arm of {arm} block{'s' if arm > 1 else ''}", found)
    if (
        total is None
        or (shape == "X" and total != 4 * arm + 1)
        or (shape == "V" and total not in (2 * arm - 1, 2 * arm + 1))
    ):
        raise Unclear
    return Sized(name, "", total)


def _limbs(pieces: Sequence[Piece]) -> dict[str, tuple[int, bool]]:
    found: dict[str, tuple[int, bool]] = {}
    for piece in pieces:
        if piece.kind == "limb":
            limb, count, more = piece.value
            if found.get(limb, (count, more)) != (count, more):
                raise Unclear
            found[limb] = count, more
    return found


def _tee(pieces: Sequence[Piece], total: int | None) -> Sized:
    """A T: its bar, and what hangs down from it."""
    limbs, dims = _limbs(pieces), _value(pieces, "dims")
    for piece in pieces:
        if piece.kind == "arm":
            if "leg" not in piece.words.split() or "each" in piece.words or "stem" in limbs:
                raise Unclear
            limbs["stem"] = piece.value, False
    if dims:
        if limbs or dims[0] != "wide":
            raise Unclear
        limbs = {"bar": (dims[1], False), "stem": (dims[2], False)}
    if set(limbs) - {"bar", "stem"}:
        raise Unclear
    bar, stem = limbs.get("bar"), limbs.get("stem")
    if bar is None:
        if stem is None:
            return Sized("a T", "", total)
        if total is None:
            raise Unclear
        bar = total - stem[0], False
        if not bar[0] % 2 or bar[0] < 3:
            raise Unclear
    if stem is None:
        return Sized("a T", f" with a bar of {bar[0]} blocks", total)
    exact = _agreed(total, bar[0] + stem[0], *([bar[0] + stem[0] - 1] if total and not stem[1] else []))
    hangs = exact - bar[0]
    return Sized("a T", f" with a bar of {bar[0]} blocks and a stem of {hangs} block{'s' if hangs > 1 else ''}", exact)


def _ell(pieces: Sequence[Piece], total: int | None) -> Sized:
    """An L: two arms that share a corner, which is counted in both."""
    limbs, dims = _limbs(pieces), _value(pieces, "dims")
    arm = _value([replace(piece, kind="arm") if piece.kind == "side" else piece for piece in pieces], "arm")
    names = {"bar": "short", "stem": "up"}
    limbs = {names.get(limb, limb): said for limb, said in limbs.items()}
    along = _value(pieces, "along")
    if along:
        limbs["along"] = along[:2]
    if (
        [bool(limbs), arm is not None, dims is not None].count(True) > 1
        or {"long", "up"} <= set(limbs)
        or {"short", "along"} <= set(limbs)
        or "ups" in limbs
    ):
        raise Unclear
    shared = one(pieces, "shared") is not None
    if one(pieces, "equal") and arm is None:
        if limbs or dims or not total or total % 2 == 0:
            raise Unclear
        arm = (total + 1) // 2
    if dims:
        limbs = {"long": (max(dims[1:]), False), "short": (min(dims[1:]), False)}
        shared = shared or dims[0] != "sides"
    if arm is not None:
        limbs, shared = {"long": (arm, False), "short": (arm, False)}, one(pieces, "apart") is None
    if not limbs:
        return Sized("an L", "", total)
    high, _ = limbs.get("long") or limbs.get("up") or (0, False)
    wide, more = limbs.get("short") or limbs.get("along") or (0, False)
    if not high:
        raise Unclear
    if not wide:
        return Sized("an L", f" with a long arm of {high} blocks", total)
    if more or (arm is not None and not shared):
        possible = [high + wide]
    else:
        loose = total and not shared and "along" in limbs
        possible = [high + wide - 1, *([high + wide] if loose else [])]
        if total is None and not shared:
            raise Unclear  # is the corner one of both?
    exact = _agreed(total, *possible)
    wide = exact - high + 1
    if wide > high or wide < 2:
        raise Unclear
    if wide == high:
        return Sized("an L", f" with each arm of {high} blocks", exact)
    return Sized("an L", f" with a long arm of {high} blocks and a short arm of {wide} blocks", exact)


def _you(pieces: Sequence[Piece], total: int | None) -> Sized:
    """A U: its base, and two legs that stand on the ends of it."""
    limbs, arm, dims = _limbs(pieces), _value(pieces, "arm"), _value(pieces, "dims")
    wide = limbs.pop("short", limbs.pop("bar", limbs.pop("along", (None, False))))[0]
    ups = limbs.pop("ups", None)
    between, _ = limbs.pop("joint", (0, False))
    deep = limbs.pop("long", limbs.pop("stem", limbs.pop("up", ups or (arm, False))))[0]
    if ups and wide and ups[1]:
        return Sized("a U", f", {wide} blocks wide and {deep + 1} blocks deep,", _agreed(total, wide + 2 * deep))
    if limbs or (dims and (wide or deep)):
        raise Unclear
    if between:
        deep = deep or _value(pieces, "side")
        if wide or dims or not deep or (total is None and between > 2):
            raise Unclear  # are the corners those of the base that "joins them"?
        found = _agreed(total, between + 2 * deep)
        return Sized("a U", f", {between + 2} blocks wide and {deep} blocks deep,", found)
    side = _value(pieces, "side")
    if side and not (dims or wide or deep):
        return Sized("a U", f", {side} blocks wide and {side} blocks deep,", _agreed(total, 3 * side - 2))
    wide = wide or side
    if dims:
        _, wide, deep = dims
    if deep is None and wide is None:
        return Sized("a U", "", total)
    if deep is None or wide is None:
        if total is None:
            raise Unclear
        if wide is not None:
            return Sized("a U", f", {wide} blocks wide,", total)
        bases = {total - 2 * (deep - 1): deep, **({} if one(pieces, "shared") else {total - 2 * deep: deep + 1})}
        fitting = {base: legs for base, legs in bases.items() if base >= 3}
        if len(fitting) != 1:
            raise Unclear
        ((wide, deep),) = fitting.items()
        return Sized("a U", f", {wide} blocks wide and {deep} blocks deep,", total)
    exact = _agreed(
        total, *{wide + 2 * (deep - 1), *([wide + 2 * deep] if total and not one(pieces, "shared") else [])}
    )
    deep = (exact - wide) // 2 + 1
    return Sized("a U", f", {wide} blocks wide and {deep} blocks deep,", exact)
