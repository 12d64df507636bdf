""" "None of A and B may be both near red and on the mat": each may be one of these, and none may be both."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.language.meaning import Coord, In, Loc, Meaning, Noun
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms, conj
from rpg.passes.schema.resolve.places.stacking import Towers
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Placing = Callable[[Ref, Meaning, Scene, Scope, Span], Atoms]
_JOINED = 1
"""More than so many letters apart, two places have a word or a comma between them."""


def none_there(theme: Ref, spec: Spec, scene: Scene, scope: Scope, span: Span, placing: Placing) -> Atoms | None:
    """That no block is in all of the places together; None where a clause is not of none, or tells of one place.

    Raises:
        Refusal: where it is not clear whether each of the places is denied, or all of them together.
    """
    none = theme.op == "nor" or (theme.quant is not None and theme.quant.high == 0)
    together = any(m.kind == "not all" for m in spec.manners)
    spots = [p for p in spec.places if not getattr(p, "negated", False)]
    if not none or scene.denying or len(spots) < len(spec.places) or theme.beyond is not None or theme.built:
        return None
    if len(spots) < 2 and not (together and spots and _several(spots[0])):
        if together:
            raise refuse("ambiguous", "it is not clear in which two places none of them may be", span,
                         "say which blocks there are in a sentence of its own")  # fmt: skip
        return None
    if not together and any(two.span[0] - one.span[1] > _JOINED for one, two in pairwise(spots)):
        raise _unclear(spots[-1].span)
    if any(_to_each_other(p) for p in spots):
        if together:
            raise _unclear(span)
        return None
    if any(_one_more(p) for p in spots):
        raise refuse("ambiguous", "it is not clear which block this is near or on", spots[-1].span, "name the block")
    spec.places = [p for p in spec.places if p not in spots]
    towers = Towers.of(scene)
    found = [_never_all(name, spots, scene, scope, span, placing) for name in theme.names]
    towers.after(scene, start=False, denied=True)
    return [x for x in found if x is not None]


def _unclear(span: Span) -> Refusal:
    told = "it is not clear whether each of these is denied, or both together"
    return refuse("ambiguous", told, span, "say 'both ... and ...', or say it of each in a sentence of its own")


def _never_all(
    name: str, spots: list[Meaning], scene: Scene, scope: Scope, span: Span, placing: Placing
) -> g.Goal | None:
    """That one block is not in all the places; None of a block that is what one of the places is told by."""
    try:
        goals = [x for spot in spots for x in placing(Ref(names=(name,)), spot, scene, scope, span)]
    except Refusal as refusal:
        if refusal.diagnostics[0].code != "self-reference":
            raise
        return None
    return g.Not(goal=conj(goals, span), span=span)


def _several(place: Meaning) -> bool:
    """ "(both) near A and near B", "near (both) A and B"."""
    mark = place.landmark if isinstance(place, Loc) else None
    listed = isinstance(mark, Noun) and (mark.plural or mark.det == "both")
    return listed or isinstance(mark, Coord) or (isinstance(place, Coord) and place.op == "and")


def _to_each_other(place: Meaning) -> bool:
    """ "(Left on the table) by itself": not said of one block alone."""
    return getattr(getattr(place, "landmark", None), "word", "") in ("each other", "one another", "itself")


def _one_more(place: Meaning) -> bool:
    """Whether a place is told by "a block", which may be another one for each."""
    mark = place.landmark if isinstance(place, Loc) else None
    return isinstance(mark, Noun) and mark.det in ("a", "some", "another") and not isinstance(place, In)
