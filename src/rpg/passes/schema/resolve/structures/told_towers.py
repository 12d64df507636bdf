"""Towers that nothing builds but what is told of each: "one tower has two blocks, the other three"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Absolute, Amount, At, Clause, Coord, Loc, Meaning, Places, Structure, parts_of, replace

TOLD = "told"
Kept = list[list[tuple[str, Meaning]]]


def told_towers(found: Kept, clause: Clause) -> Clause | None:
    """The clause that builds as many towers as are told of, where none was built before."""
    parts = _parts(clause)
    units = [x.adjuncts[0].unit for x in parts if isinstance(x.adjuncts[0], Places)]
    before = [said for kept in found for _, said in kept]
    if clause.verb != "part" or clause.theme is not None or clause.mode != "goal" or clause.negated:
        return None
    if len(units) < len(parts) or "whole stack" not in units or set(units) - {"whole", "whole stack"}:
        return None
    if any(not isinstance(said, Clause) or said.mode != "given" for said in before):
        return None
    return replace(clause, verb="build", lemma=TOLD, theme=_towers(len(parts), clause))


def one_more_tower(found: Kept, clause: Clause) -> bool:
    """ "Tower 1: red on blue. Tower 2: green on yellow.": the second is one more of those told so."""
    parts = _parts(clause)
    last = next((kept for kept in reversed(found) if kept), None)
    said = last[-1][1] if last is not None else None
    if not isinstance(said, Clause) or said.lemma != TOLD or not isinstance(said.theme, Structure) or not parts:
        return False
    there = len(_parts(said))
    turns = [x.adjuncts[0].index if isinstance(x.adjuncts[0], Places) else None for x in parts]
    if clause.verb != "part" or clause.theme is not None or clause.negated or turns[:1] != [there + 1]:
        return False
    whole = Coord(op="absolutes", items=(*_parts(said), *parts), span=said.span)
    assert last is not None
    last[-1] = (last[-1][0], replace(said, theme=_towers(there + len(parts), said), adjuncts=(whole,)))
    return True


def side_by_side(clause: Clause) -> Clause | None:
    """ "a red tower on the left and a blue tower on the right": each is built, the one beside the other."""
    parts = _parts(clause)
    places = [x.adjuncts[0] for x in parts if isinstance(x.adjuncts[0], At) and x.adjuncts[0].index is None]
    new = [x.theme for x in parts if isinstance(x.theme, Structure) and x.theme.det in ("a", "bare")]
    sides = {place.side: shape for place, shape in zip(places, new, strict=False)}
    if clause.verb != "part" or clause.theme is not None or clause.negated or not len(parts) == len(places) == len(new):
        return None
    for one, other in (("left", "right"), ("back", "front")):
        if len(parts) == 2 and sides.keys() == {one, other} and not any(shape.plural for shape in new):
            rel = {"left": "left", "back": "behind"}[one]
            place = Loc(rel=rel, landmark=sides[other], span=places[0].span)
            return replace(clause, verb="build", theme=sides[one], adjuncts=(place,))
    return None


def other_side(found: Kept, clause: Clause) -> bool:
    """ "On the left there is a tower of two, on the right a tower of three": the second stands beside the first."""
    last = next((kept for kept in reversed(found) if kept), None)
    first = last[-1][1] if last is not None else None
    if last is None or not isinstance(first, Clause) or not (_on_a_side(first) and _on_a_side(clause)):
        return False
    assert first.theme is not None and clause.theme is not None
    parts = tuple(Absolute(theme=c.theme, adjuncts=c.adjuncts, span=c.span) for c in (first, clause) if c.theme)
    both = Coord(op="absolutes", items=parts, span=first.span)
    built = side_by_side(replace(first, verb="part", lemma="", theme=None, adjuncts=(both,)))
    if built is not None:
        last[-1] = (last[-1][0], built)
    return built is not None


def _on_a_side(clause: Clause) -> bool:
    """Whether a clause builds something that stands on a side of nothing that it names."""
    shape = clause.theme
    new = isinstance(shape, Structure) and shape.det in ("a", "bare") and not shape.plural
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    told = (clause.verb, clause.mode, clause.negated) == ("build", "goal", False)
    return new and told and isinstance(place, At) and place.index is None and place.whole is None


def _parts(clause: Clause) -> Sequence[Absolute]:
    one = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    items = one.items if isinstance(one, Coord) and one.op == "absolutes" else (one,)
    return tuple(x for x in items if isinstance(x, Absolute)) if all(isinstance(x, Absolute) for x in items) else ()


def _towers(count: int, clause: Clause) -> Structure:
    if count == 1:
        return Structure(kind="stack", det="a", plural=True, span=clause.span)
    return Structure(kind="stack", det="bare", amount=Amount(count, count), plural=True, span=clause.span)


def told_after(found: Kept, clause: Clause) -> bool:
    """ "Put blue next to the tower. The tower is red on yellow.": what the tower is comes first."""
    shape = clause.theme
    told = isinstance(shape, Structure) and (shape.det, shape.plural) == ("the", False) and not clause.negated
    if not told or not isinstance(shape, Structure) or clause.verb not in ("part", "build") or clause.mode != "goal":
        return False
    if not (clause.adjuncts or shape.members or shape.sizes) or any(_builds_such(c, shape) for c in _all(found)):
        return False
    for kept in found:
        for at, (link, said) in enumerate(kept):
            marks = [x.landmark for x in parts_of(said) if isinstance(x, Loc) and isinstance(x.landmark, Structure)]
            if any(replace(x, cost=0) == Structure(kind=shape.kind, det="the", span=x.span) for x in marks if x):
                kept[at : at + 1] = [(link, replace(clause, verb="build")), ("and", said)]
                return True
    return False


def _all(found: Kept) -> list[Meaning]:
    return [said for kept in found for _, said in kept]


def _builds_such(said: Meaning, shape: Structure) -> bool:
    """Whether a clause builds something of this kind, or tells of several, so that "the tower" may be that."""
    return any(
        isinstance(x, Structure) and x.kind == shape.kind and (x.det != "the" or x.members or x.details or x.sizes)
        for x in parts_of(said)
    )
