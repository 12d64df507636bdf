"""The verbs of sorting and separating."""

from __future__ import annotations

from dataclasses import replace

from rpg.ir import structures as s
from rpg.language.meaning import Clause, Loc, Pronoun, Structure
from rpg.passes.schema.resolve.arranging import arrange_blocks, counted
from rpg.passes.schema.resolve.groups import attribute_of, sort_into
from rpg.passes.schema.resolve.mutual import reciprocal
from rpg.passes.schema.resolve.placing import Goals, places
from rpg.passes.schema.resolve.refer import refer
from rpg.passes.schema.resolve.shaped import shaped
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.world import Built, Ref, Scene, Scope, refuse


def sort(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "sort the blocks by colour", "separate the red blocks from the blue ones", "gather the blocks"."""
    line = any(getattr(i.structure, "kind", "") in ("row", "line", "column", "stack", "grid") for i in spec.intos)
    ordered = any(o.by != "attribute" for o in spec.orders) or spec.toward
    if isinstance(clause.theme, Structure) and clause.theme.kind == "pile":
        built, goals = _sort_piles(clause.theme, spec, scene, scope)
        return goals
    if clause.theme is None and not any(True for _ in scene.blocks()):
        raise refuse("no-goal", "it is not said which blocks", clause.word or clause.span, "name the blocks")
    apart = next((p for p in spec.places if isinstance(p, Loc) and p.rel in ("apart", "off") and not p.negated), None)
    theme_meaning = (
        counted(clause.theme, spec, clause)
        if clause.theme is not None
        else Pronoun(word="everything", span=clause.span)
    )
    if isinstance(theme_meaning, Structure):
        return shaped(clause, spec, scene, scope)
    attribute = next((o.attribute for o in spec.orders if o.by == "attribute"), None)
    theme = refer(theme_meaning, scene, replace(scope, need=6 if not (line or ordered) else 4, need_each=2))
    if line or ordered:
        return arrange_blocks(theme, "arrange", spec, scene, scope, clause.span)
    if clause.lemma in ("gather", "collect", "cluster", "group", "bunch") and attribute is None and not spec.intos:
        spec.places = [p for p in spec.places if getattr(p, "rel", "") not in ("near", "together")]
        node = s.GroupBy(groups=(theme.names,), span=clause.span)
        ref = replace(theme, built=(scene.add_built("pile", theme.names, False, clause.span),))
        return [node, *places(ref, spec, scene, scope, clause.span)]
    if (
        clause.lemma in ("separate", "split", "divide")
        and attribute is None
        and (apart is not None or len(theme.parts) == 2)
    ):
        return _separate(theme, apart, spec, scene, scope, clause)
    shape = _pile_target(spec)
    attribute = attribute_of(spec)
    built, goals = sort_into(theme.names, attribute, shape, spec, scene, scope, clause.span)
    ref = replace(theme, built=tuple(built))
    return goals + places(ref, spec, scene, scope, clause.span)


def _pile_target(spec: Spec) -> Structure | None:
    for into in list(spec.intos):
        if isinstance(into.structure, Structure) and into.structure.kind == "pile":
            spec.intos.remove(into)
            return into.structure
    return None


def _sort_piles(shape: Structure, spec: Spec, scene: Scene, scope: Scope) -> tuple[list[Built], Goals]:
    _pile_target(spec)
    attribute = attribute_of(spec)
    return sort_into(None, attribute, shape, spec, scene, scope, shape.span)


def _separate(theme: Ref, apart: Loc | None, spec: Spec, scene: Scene, scope: Scope, clause: Clause) -> Goals:
    """ "separate the red blocks from the blue ones"."""
    target = _pile_target(spec)
    if apart is None and len(theme.parts) == 2:
        groups: tuple[tuple[str, ...], ...] = tuple(p.names for p in theme.parts)
    elif apart is not None and apart.landmark is not None:
        spec.places.remove(apart)
        mark = refer(apart.landmark, scene, replace(scope, role="landmark"))
        if mark.reciprocal:
            return reciprocal(theme, apart, clause.span)
        groups = (theme.names, mark.names)
    else:
        attribute = attribute_of(spec)
        return sort_into(theme.names, attribute, target, spec, scene, scope, clause.span)[1]
    return [s.GroupBy(groups=groups, span=clause.span)]
