"""Parts of a line told by the part before: "red at the bottom, blue on it", "white on top, green between them"."""

from __future__ import annotations

from rpg.language.meaning import Absolute, At, Loc, Meaning, Noun, Places, Pronoun, replace

_ENDS = ({"top", "bottom"}, {"left", "right"}, {"front", "back"})
_UP = frozenset({"on", "above"})
_DOWN = frozenset({"under"})
_BESIDE = frozenset({"beside", "adjacent"})
_WAYS = {
    "bottom": _UP, "top": _DOWN, "left": _BESIDE | {"right"}, "right": _BESIDE | {"left"},
    "front": _BESIDE | {"behind"}, "back": _BESIDE | {"front"},
}  # fmt: skip
"""How what comes next lies to a block at this end."""
_IT = frozenset({"it", "that", "this", "them", "those", "that one", "this one"})


def in_between(parts: list[Absolute]) -> list[Absolute]:
    """ "red at the bottom, blue on top, green between them": green is in the middle."""
    rest = [part for part in parts if isinstance(place := part.adjuncts[0], Places) and place.side == "rest"]
    sides = {part.adjuncts[0].side for part in parts if isinstance(part.adjuncts[0], At)}
    if len(rest) != 1 or len(parts) != 3 or sides not in _ENDS or not _one_look(rest[0].theme):
        return parts
    inside = replace(rest[0], adjuncts=(At(side="middle", span=rest[0].adjuncts[0].span),))
    return [inside if part is rest[0] else part for part in parts]


def _one_look(theme: Meaning) -> bool:
    return isinstance(theme, Noun) and not theme.plural and len(theme.traits.colors + theme.traits.labels) == 1


def onward(parts: list[Absolute]) -> list[Absolute]:
    """ "red at the bottom, two blue ones above it, white on those": each next to the one before, up or down a tower;
    "white on the left, pink to the right of it, cyan at the right end" along a row."""
    found: list[Absolute] = []
    way: frozenset[str] | None = None
    for part in parts:
        place = part.adjuncts[0]
        if isinstance(place, Loc) and found:
            last = _of_the_last(place) or _named_again(place, found[-1].theme)
            if len(part.adjuncts) > 1 or not last or way is None or place.rel not in way:
                return parts
            found.append(replace(part, adjuncts=(At(side="next", whole=place.rel, span=place.span),)))
        else:
            side = place.side if isinstance(place, At) and place.index in (None, 1) else ""
            way = way if side in ("middle", "next") else _WAYS.get(side)
            found.append(part)
    return found


def _named_again(place: Loc, before: Meaning) -> bool:
    """ "A at the bottom, B on A": of the block that was named last, by its look."""
    plain = not place.negated and place.low is None and place.high is None and not place.mods
    mark = place.landmark
    same = isinstance(mark, Noun) and isinstance(before, Noun) and mark.traits == before.traits and _one_look(mark)
    return plain and same


def _of_the_last(place: Loc) -> bool:
    """ "on it", "above that": of the block that was named last, by no measure."""
    plain = not place.negated and place.low is None and place.high is None and not set(place.mods) & {"somewhere"}
    return plain and isinstance(place.landmark, Pronoun) and place.landmark.word in _IT
