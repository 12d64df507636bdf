"""One of the patches there are said to be: "put the red block on a mat", "neither of them is on a mat"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Amount, Loc, Noun, Traits, replace
from rpg.passes.schema.resolve.goals.logic import disj
from rpg.passes.schema.resolve.goals.so_many_of import so_many_of
from rpg.passes.schema.resolve.things.things import alike, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope


def on_any_patch(loc: Loc, theme: Ref, scene: Scene, scope: Scope, *, denied: bool) -> Loc:
    """The relation with any of these patches for "a mat", where several that look different are told of; what is denied
    of a mat is denied of each that is spoken of."""
    mark = loc.landmark
    one = isinstance(mark, Noun) and mark.head == "patch" and mark.det == "a" and mark.amount == Amount(1, 1)
    if not one or not isinstance(mark, Noun) or loc.rel not in ("on", "in") or scope.start or theme.built:
        return loc
    single = theme.quant is None and (len(theme.names) == 1 or theme.each) and theme.op != "or"
    if not (denied and (theme.quant is None or theme.quant.high == 0)) and not single:
        return loc  # "both are on a mat": on the same one, or each on one?
    if mark.part_of is not None or mark.conditions or mark.traits != Traits(colors=mark.traits.colors):
        return loc
    there = [t for t in matching(mark.traits, scene, True) if t.declared or denied]
    looks = {(t.color, t.shape, t.size) for t in there}
    if len(there) < (1 if denied else 2) or (len(looks) < len(there) and not denied):
        return loc
    return replace(loc, landmark=replace(mark, det="any", amount=None))


def on_just_one(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal | None:
    """ "Exactly one of the mats must have a red block on it", where there are several: the others have none."""
    one = theme.det == "a" and len(theme.names) == 1 and theme.quant is None and not theme.built
    exactly = isinstance(loc.landmark, Noun) and loc.landmark.amount == mark.quant == Amount(1, 1, True)
    if not exactly or mark.op != "and" or not one or scene.denying:
        return None
    like = scene.things[theme.names[0]]
    there = [t.name for t in scene.blocks() if t is like or (t.declared and not t.extra and alike([t, like]))]
    if len(there) < 2:
        return None
    each = [disj([r.OnPatch(a=(name,), patch=patch, span=span) for name in there], span) for patch in mark.names]
    return so_many_of(each, mark, span)
