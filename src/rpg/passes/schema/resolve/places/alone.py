""" "Only the red block is on the mat", "it stands alone there": what no other block of the task does."""

from __future__ import annotations

from collections.abc import Callable

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Pronoun, TableTop, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.places.mutual import Relate
from rpg.passes.schema.resolve.things.operands import base_of
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import fits
from rpg.passes.schema.resolve.things.world import Exclusive, Ref, Scene, Scope, refuse


def told_alone(clause: Clause, spec: Spec) -> Clause:
    """ "leave it alone" is leaving it where it is; "it is alone on the mat" is that only it is there."""
    alone = spec.manner("alone")
    if alone is None:
        if getattr(clause.theme, "op", "") == "only" and any(map(_mutual, spec.places)):
            raise refuse("misplaced", "'only' does not fit this", clause.span,
                         "say what the other blocks should not do")  # fmt: skip
        return clause
    if clause.lemma == "leave" and not spec.places:
        spec.manners.append(replace(alone, kind="stay"))
        return clause
    if clause.mode == "start" and clause.theme is not None and not (spec.places or clause.negated):
        spec.places.append(Loc(rel="on", landmark=TableTop(span=alone.span), span=alone.span))
        return clause
    there = spec.places[0] if len(spec.places) == 1 else None
    on = isinstance(there, Loc) and there.rel in ("on", "in") and not isinstance(there.landmark, TableTop)
    if clause.theme is None or clause.negated or not (on or isinstance(there, In)):
        raise refuse("ambiguous", "it is not clear from what this is apart", alone.span,
                     "say where no other block should be")  # fmt: skip
    return replace(clause, theme=Coord(op="only", items=(clause.theme,), span=clause.theme.span))


def _mutual(place: Meaning) -> bool:
    mark = place.landmark if isinstance(place, Loc) else None
    return isinstance(mark, Pronoun) and mark.word == "each other"


def only_here(theme: Ref, region: In, scene: Scene) -> Ref:
    """ "only the red block is in the left half": it is, and no other block that the task has."""
    if region.negated or theme.quant is not None:
        raise refuse("misplaced", "'only' does not fit this", theme.span, "say what the other blocks should not do")
    _of_no_other(theme.names, _in(region), region.span, scene)
    return replace(theme, op="and")


def only_on_table(theme: Ref, loc: Loc, scene: Scene) -> Ref:
    """ "only the red block is on the table": it is, and no other block lies there.

    "Put only the red block on the table" may say no more than that no other one is to be moved.
    """
    if loc.negated or theme.quant is not None or not scene.describing:
        raise refuse("ambiguous", "is no other block to lie on the table, or to be put there?", theme.span,
                     "say which blocks should not be on the table")  # fmt: skip
    there: Callable[[str], g.Goal] = lambda n: r.OnTable(a=(n,), span=loc.span)  # noqa: E731
    _of_no_other(theme.names, there, loc.span, scene)
    return replace(theme, op="and")


def _of_no_other(names: tuple[str, ...], there: Callable[[str], g.Goal], span: Span, scene: Scene) -> None:
    """It holds of no other block; where it is denied, "only the red one should not be on the mat", of all others."""
    told: Callable[[str], g.Goal] = (lambda n: g.Not(goal=there(n), span=span)) if scene.denying else there
    scene.exclusive.append(Exclusive(names, told, span, Traits()))


def alone_there(theme: Ref, mark: Ref, loc: Loc, scene: Scene, relate: Relate) -> tuple[Ref, Ref]:
    """ "only red is on the patch", "green touches only blue": so it is, and neither of other blocks nor to others."""
    if theme.op == "only":
        return only_on(theme, mark, loc, scene, relate), mark
    if loc.rel in _OF_OTHERS_TOO:
        if loc.negated or scene.denying or len(theme.names) > 1 or mark.patch:
            raise refuse("misplaced", "'only' does not fit this", loc.span, "say what is not to be beside it")
        there = replace(mark, op="and")
        no_other: Callable[[str], g.Goal] = lambda n: relate(theme, Ref(names=(n,)), loc, scene, loc.span)  # noqa: E731
        scene.exclusive.append(Exclusive((*theme.names, *there.names), no_other, loc.span, Traits()))
    return theme, replace(mark, op="and")


def only_on(theme: Ref, mark: Ref, loc: Loc, scene: Scene, relate: Relate) -> Ref:
    """ "only the red block is on the patch", "... on the blue block": it is, and no other block that the task has."""
    one = not mark.patch and len(mark.names) == 1 and mark.quant is None and not (mark.built or theme.built)
    if one and loc.rel in _TO_A_BLOCK and not loc.negated and theme.quant is None and loc.low is loc.high is None:
        there: Callable[[str], g.Goal] = _related(mark, loc, scene, relate)
        if loc.rel == "on":
            there = lambda n: r.On(a=(n,), b=mark.names, span=loc.span)  # noqa: E731
        _of_no_other((*theme.names, *mark.names), there, loc.span, scene)
        return replace(theme, op="and")
    if not mark.patch or loc.rel not in ("on", "in") or loc.negated or theme.quant is not None:
        raise refuse("misplaced", "'only' does not fit this", theme.span, "say what the other blocks should not do")
    for patch in mark.names:
        _of_no_other(theme.names, _on(patch, loc), loc.span, scene)
    return replace(theme, op="and")


_OF_OTHERS_TOO = ("touching", "beside", "adjacent", "near", "distance", "left", "right", "front", "behind")
"""Relations to one block that there may be to others as well."""
_TO_A_BLOCK = ("on", "beside", "adjacent", "touching")


def none_beyond(theme: Ref, meaning: Meaning, scene: Scene, scope: Scope, relate: Relate) -> g.Goal:
    """ "Red is on the mat, and nothing else is": no block but those of which the clause before said it."""
    before = [m for m in scene.mentions if m.role == "theme" and m.clause < scene.clause and m.ref.names]
    if not before or before[-1].ref.quant is not None or before[-1].ref.patch or theme.beyond is None:
        raise refuse("no-referent", "it is not clear besides what", theme.span, "say which blocks may be there")
    spoken = {n: None for m in scene.mentions if m.clause == before[-1].clause for n in m.ref.names}
    names = tuple(spoken)
    found: list[Exclusive] = []
    if isinstance(meaning, In) and not meaning.negated:
        found.append(Exclusive(names, _in(meaning), meaning.span, theme.beyond))
    elif not isinstance(meaning, Loc) or meaning.landmark is None or meaning.negated:
        raise refuse("misplaced", "this does not fit here", theme.span, "say which blocks may be there")
    else:
        mark = _the_same(meaning, before[-1].clause, scene)
        mark = mark or refer(meaning.landmark, scene, replace(scope, role="landmark", rel=f"not {meaning.rel}"))
        if mark.quant is not None or not spoken.keys() >= set(mark.names) or not mark.names or mark.op == "nor":
            raise refuse("ambiguous", "it is not clear where nothing else is", meaning.span, "name the block or patch")
        patched = mark.patch and meaning.rel in ("on", "in", "above")
        for other in mark.names:
            alone = replace(mark, names=(other,), built=(), parts=(), op="and")
            there = _on(other, meaning) if patched else _related(alone, meaning, scene, relate)
            carried = [n for n in scene.on_top if patched and base_of(n, scene) in names]
            found.append(Exclusive((*names, *mark.names, *carried), there, meaning.span, theme.beyond))
    scene.exclusive += found
    return conj([g.Not(goal=x.there(n), span=x.span) for x in found for n in beyond(x, scene)])


def _the_same(loc: Loc, clause: int, scene: Scene) -> Ref | None:
    """ "A purple block on each white one, and nothing else on them": on what that clause put something on."""
    marks = [m.ref for m in scene.mentions if m.clause == clause and m.role == "landmark" and m.rel == loc.rel]
    return marks[0] if isinstance(loc.landmark, Pronoun) and len(marks) == 1 and loc.rel == "on" else None


def none_further(spec: Spec, scene: Scene) -> None:
    """ "Red on the mat, nothing else": there is no block but those of the sentence. Where there is one, this could be
    said of the mat as well, or mean that nothing else is to be done."""
    if (manner := spec.manner("no more")) is not None:
        said = {n for m in scene.mentions if m.sentence == scene.sentence for n in m.ref.names}
        scene.closed.append((Traits(), sum(not scene.things[n].patch for n in said), manner.span))


def kept_away(scene: Scene) -> list[g.Goal]:
    """ "Only these may be there": of them it is not asked, and of the others it is denied."""
    told = [x for x in scene.exclusive if x.span == scene.exclusive[-1].span]
    return [g.Not(goal=x.there(n), span=x.span) for x in told for n in beyond(x, scene)]


def none_there(region: In, scene: Scene) -> g.Goal:
    """ "no block is in the right half": none of those that the task has in the end."""
    alone = Exclusive((), _in(region), region.span, Traits())
    scene.exclusive.append(alone)
    return conj([g.Not(goal=alone.there(n), span=alone.span) for n in beyond(alone, scene)])


def beyond(alone: Exclusive, scene: Scene) -> list[str]:
    """The blocks of which it does not hold, distractors among them."""
    there = [t.name for t in scene.things.values() if not t.patch and fits(t, alone.traits)]
    return [name for name in there if name not in alone.names]


def _related(mark: Ref, loc: Loc, scene: Scene, relate: Relate) -> Callable[[str], g.Goal]:
    return lambda n: relate(Ref(names=(n,)), mark, loc, scene, loc.span)


def _in(region: In) -> Callable[[str], g.Goal]:
    return lambda n: r.InRegion(a=(n,), region=region.region, span=region.span)  # type: ignore[arg-type]


def _on(patch: str, loc: Loc) -> Callable[[str], g.Goal]:
    return lambda n: r.OnPatch(a=(n,), patch=patch, span=loc.span)
