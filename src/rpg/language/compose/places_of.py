"""The places of a figure: its ends, corners, middle, top; counted as `Figure` says."""

from __future__ import annotations

from rpg.language.compose.scene import Figure, Unclear

_ENDS = {
    "tower": ("bottom", "top"), "column": ("near", "far"),
    **dict.fromkeys(("row", "line", "word"), ("left", "right")),
}  # fmt: skip
"""The ends of what is one block wide, from the first place to the last."""


def columns(figure: Figure) -> int:
    """How many columns a grid or a wall has."""
    return figure.size[0] if len(figure.size) == 2 else 0


def places(figure: Figure, ranks: tuple[str, ...], nth: int = 0, count: int = 0) -> list[int]:
    """The numbers of the places that words such as "left end" or "far right corner" stand for.

    Raises Unclear where the figure has no such places.
    """
    many, said = len(figure.blocks), set(ranks)
    if len(said) == 1 and 1 < count < many and not nth and (some := _several(figure, said, count)):
        return some
    if figure.kind in _ENDS:
        return _one_line(many, said, nth, *_ENDS[figure.kind])
    if columns(figure):
        return _of_grid(figure, said)
    if figure.kind == "plus" and many == 5:
        if said == {"middle"}:
            return [2]
        if said == {"arm"} or said == {"end"}:
            return [0, 1, 3, 4]
    if figure.kind == "pyramid" and said == {"top"}:
        return [0]
    raise Unclear


def _several(figure: Figure, said: set[str], count: int) -> list[int]:
    """ "the two upper ones", "the three middle ones"."""
    ends = _ENDS.get(figure.kind)
    many = len(figure.blocks)
    if ends is None:
        return []
    if said == {"middle"}:
        return list(range((many - count) // 2, (many + count) // 2)) if (many - count) % 2 == 0 else []
    if said == {ends[0]}:
        return list(range(count))
    return list(range(many - count, many)) if said == {ends[1]} else []


def _one_line(many: int, said: set[str], nth: int, first: str, last: str) -> list[int]:
    """Of what stands in one line, counted from the first end."""
    ends = said & {first, last}
    rest = said - {first, last, "end"}
    if nth:
        if rest or len(ends) != 1 or nth > many:
            raise Unclear
        return [nth - 1] if ends == {first} else [many - nth]
    if rest == {"middle"} and not ends:
        if many % 2 == 0:
            raise Unclear
        return [many // 2]
    if rest == {"outer"} or (said == {"end"}):
        return [0, many - 1]
    if rest or len(ends) != 1:
        raise Unclear
    return [0] if ends == {first} else [many - 1]


def _of_grid(figure: Figure, said: set[str]) -> list[int]:
    """Of rows and columns: of what stands upright the rows are layers."""
    wide = columns(figure)
    tall = len(figure.blocks) // wide
    far, near = ("top", "bottom") if figure.kind == "wall" else ("far", "near")
    rows = range(tall)
    cols = range(wide)
    if said == {"middle"}:
        if wide % 2 == 0 or tall % 2 == 0:
            raise Unclear
        return [(tall // 2) * wide + wide // 2]
    if "left" in said or "right" in said:
        cols = range(1) if "left" in said else range(wide - 1, wide)
    if far in said or near in said:
        rows = range(1) if far in said else range(tall - 1, tall)
    whole = said & {"row", "layer", "column", "side"}
    sides = said & {"left", "right", far, near}
    if whole and len(sides) == 1 and len(said) == 2:
        along = {"row": {far, near}, "layer": {far, near}, "column": {"left", "right"}, "side": sides}[
            next(iter(whole))
        ]
        if sides <= along:
            return [r * wide + c for r in rows for c in cols]
    if said - sides - {"corner", "end"} or ("left" in said and "right" in said) or (far in said and near in said):
        raise Unclear
    if "end" in said:
        rows = range(1)  # what lies on the end of a wall lies on top
    if "corner" in said:
        return [r * wide + c for r in rows for c in cols if r in (0, tall - 1) and c in (0, wide - 1)]
    if len(sides) == 1 and "end" not in said and tall > 1 and wide > 1:
        raise Unclear  # a whole side
    return [r * wide + c for r in rows for c in cols]
