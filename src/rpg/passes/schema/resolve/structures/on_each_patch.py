"""A structure on each of several patches, or in each corner: "build a stack of two on each patch" are as many stacks as
patches."""

from __future__ import annotations

from rpg.language.meaning import Amount, Clause, In, Loc, Meaning, Noun, Pronoun, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.places.corners import corners_of
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Scene, refuse

_EVERY = ("each", "all", "both")
_UNSAID = 3
"""So many patches there are where nothing is said of their number."""


def on_each_patch(clause: Clause, places: list[Meaning], scene: Scene) -> Clause:
    """The clause, whose theme is so many structures where one of them is on each patch, or in each corner."""
    theme = clause.theme
    so_many = isinstance(theme, Structure) and theme.plural and theme.amount is not None
    if not isinstance(theme, Structure) or so_many or theme.det not in ("a", "bare", "some"):
        return clause
    marks = [p.landmark for p in places if isinstance(p, Loc) and p.rel == "on" and not p.negated]
    regions = [p.region for p in places if isinstance(p, In) and not p.negated]
    corners = next((len(corners_of(told)) for told in regions if told.startswith("each_corner")), 0)
    many = next((n for n in (corners, *(_as_many(mark, scene) for mark in marks)) if n > 1), 0)
    if not many:
        return clause
    if _of_known_blocks(theme.members):
        raise refuse("ambiguous", "these blocks cannot be in each of several places at once", theme.span,
                     "say of what blocks the structure in each place is")  # fmt: skip
    each = theme.det == "a" and theme.span != getattr(theme.members, "span", None)  # "a tower of two": two each
    if each or theme.plural:  # but "pile two cubes on both patches" may be one on each
        places[:] = [_of_each(p, many, scene) for p in places]
    return replace(clause, theme=replace(theme, plural=True, det="bare", each_size=each, amount=Amount(many, many)))


def _of_each(place: Meaning, many: int, scene: Scene) -> Meaning:
    """ "A tower on both patches", "on all three patches": on each of these."""
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" else None
    if not isinstance(mark, Noun) or mark.head != "patch" or mark.det not in ("all", "both") or mark.part_of:
        return place
    there = "the" if matching(mark.traits, scene, True) else "bare"
    those = replace(mark, det=there, amount=Amount(many, many), plural=True)
    return replace(place, landmark=Noun(head="patch", det="each", plural=True, part_of=those, span=mark.span))


def _as_many(mark: Meaning | None, scene: Scene) -> int:
    """The number of the patches on each of which something is; 0 where this is no such place."""
    if not isinstance(mark, Noun) or mark.head != "patch" or mark.det not in _EVERY:
        return 0
    of = mark.part_of if isinstance(mark.part_of, Noun) else mark
    if mark.det == "both":
        return 2
    amount = of.amount or mark.amount
    if amount is not None and amount.low == amount.high and amount.low > 1:
        return amount.low
    return len(matching(mark.traits, scene, True)) or (_UNSAID if of is mark else 2)


def stacked_on_each(clause: Clause, spec: Spec) -> Clause:
    """ "Stack two cubes on each patch": a tower of these."""
    blocks = clause.theme
    if clause.verb != "stack" or clause.negated or clause.mode == "start" or not isinstance(blocks, Noun):
        return clause
    several = blocks.det == "bare" and blocks.amount is not None and blocks.amount.high == blocks.amount.low > 1
    each = any(isinstance(p, Loc) and p.rel == "on" and not p.negated and _on_each(p.landmark) for p in spec.places)
    if not (several and each) or blocks.part_of is not None or spec.intos:
        return clause
    tower = Structure(kind="stack", amount=Amount(1, 1), members=blocks, span=blocks.span)
    return replace(clause, verb="build", theme=tower)


def _on_each(mark: Meaning | None) -> bool:
    return isinstance(mark, Noun) and mark.head == "patch" and mark.det in _EVERY


def _of_known_blocks(members: Meaning | None) -> bool:
    """ "a tower of the red blocks": blocks that are known, and in one place at a time."""
    return isinstance(members, Pronoun) or (isinstance(members, Noun) and members.det in ("the", "all"))
