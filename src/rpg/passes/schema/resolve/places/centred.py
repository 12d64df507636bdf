"""How far off centre a block may lie on another one: a tighter limit than what "on" asks for by itself."""

from __future__ import annotations

from itertools import pairwise

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Clause, In, Loc, Noun, PartOf, TableTop, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def centred(spec: Spec, scene: Scene, span: Span, names: tuple[str, ...] | None = None) -> list[g.Goal]:
    """Every block that is put on another one (of `names`) is so near its middle."""
    found = [p for p in spec.places if isinstance(p, Loc) and p.rel == "offset"]
    if not found:
        return []
    spec.places = [p for p in spec.places if p not in found]
    pairs = [(a, b) for a, b in scene.on_top.items() if a not in scene.begun_on and (names is None or a in names)]
    alike = [] if pairs or scene.denying else _alike(scene, names)
    pairs = pairs or alike
    stacked = {name for pair in pairs for name in pair}
    others = any(t.name not in stacked and not t.extra for t in scene.blocks()) and "all" in found[0].mods
    if len(found) > 1 or not pairs or scene.denying or others:
        raise refuse("ambiguous", "it is not said which block lies on which, centred so well", found[0].span,
                     "say it of a block that is put on another one")  # fmt: skip
    near: list[g.Goal] = [r.Distance(a=(a,), b=(b,), maximum=found[0].high, span=span) for a, b in pairs]
    return [*(r.On(a=(a,), b=(b,), span=span) for a, b in alike), *near]


def _alike(scene: Scene, names: tuple[str, ...] | None) -> list[tuple[str, str]]:
    """What lies on what in towers of blocks that look alike: which of them is which makes no difference."""
    towers = [b.members for b in scene.built if b.kind == "stack" and (names is None or {*b.members} & {*names})]
    things = [[scene.things[name] for name in members] for members in towers]
    if any(len({(t.color, t.label, t.size, t.edge) for t in tower}) > 1 for tower in things):
        return []
    return [(upper, lower) for members in towers for lower, upper in pairwise(members)]


def by_centring(clause: Clause, spec: Spec, scene: Scene) -> None:
    """ "center the red block on the mat": in its middle; on another block it is to be said how well."""
    _well_on_a_patch(spec, scene)
    if clause.lemma != "center":
        return
    told = any(isinstance(p, Loc) and p.rel == "offset" for p in spec.places)
    for n, place in enumerate(spec.places):
        if not isinstance(place, Loc) or place.rel not in ("on", "above"):
            continue
        mark = place.landmark
        if isinstance(mark, TableTop):
            spec.places[n] = In(region="middle", span=place.span)
        elif isinstance(mark, Noun) and mark.head == "patch" and not told:
            middle = PartOf(part="middle", whole=mark, span=mark.span)
            spec.places[n] = replace(place, rel="on", landmark=middle)
        elif not told and place.high is None:
            raise refuse("ambiguous", "it is not said how well it is to be centred", place.span, "say 'to within 5 mm'")


def _well_on_a_patch(spec: Spec, scene: Scene) -> None:
    """ "on the green patch, tolerance 1 cm": so near its middle."""
    offsets = [p for p in spec.places if isinstance(p, Loc) and p.rel == "offset"]
    lain = [p for p in spec.places if isinstance(p, Loc) and p.rel in ("on", "in") and not p.negated]
    if len(offsets) != 1 or len(lain) != 1 or scene.denying or _of_several(scene):
        return
    mark = lain[0].landmark
    middle = mark if isinstance(mark, PartOf) and mark.part == "middle" else None
    patch = middle.whole if middle else mark
    if not isinstance(patch, Noun) or patch.head != "patch":
        return
    if middle is None:
        scene.assume("from where the tolerance is measured is not said: from the middle of the patch")
        middle = PartOf(part="middle", whole=patch, span=patch.span)
    spec.places.remove(offsets[0])
    spec.places[spec.places.index(lain[0])] = replace(lain[0], rel="on", landmark=middle, high=offsets[0].high)


def _of_several(scene: Scene) -> bool:
    """Whether another block was placed in the same sentence, of which the tolerance may be said as well."""
    before = [m for m in scene.mentions if m.sentence == scene.sentence and m.clause < scene.clause]
    return any(not m.ref.patch for m in before)


def centred_on(theme: Ref, mark: Ref, loc: Loc, span: Span) -> Atoms:
    """ "centred on the blue block to within 5 mm": how far off its middle at most."""
    if loc.high is None:
        return []
    if len(theme.names) != 1 or len(mark.names) != 1:
        raise refuse("ambiguous", "it is not said which block lies on which, centred so well", loc.span,
                     "say it of a block that is put on another one")  # fmt: skip
    return [r.Distance(a=theme.names, b=mark.names, maximum=loc.high, span=span)]
