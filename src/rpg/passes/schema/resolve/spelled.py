"""The verbs of spelling and reading."""

from __future__ import annotations

from rpg.ir.order import Order
from rpg.language.meaning import Clause, Meaning, Noun, Pronoun, Structure, Traits
from rpg.passes.schema.resolve.listing import continued
from rpg.passes.schema.resolve.placing import Goals, places
from rpg.passes.schema.resolve.refer import refer
from rpg.passes.schema.resolve.shaped import shaped
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.structures import make, row_node
from rpg.passes.schema.resolve.things import give
from rpg.passes.schema.resolve.world import Ref, Scene, Scope


def spell(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "spell CAT with ...", "the cubes read A, B, C"."""
    theme = None
    if spec.usings and _mentioned(spec.usings[0].members):
        theme = refer(spec.usings.pop(0).members, scene, scope)
    if clause.verb == "read" and isinstance(clause.theme, Noun):
        return _read_row(clause, clause.theme, theme, spec, scene, scope)
    if theme is not None and isinstance(clause.theme, Structure):
        built, goals = make(clause.theme, spec, theme, scene, scope)
        ref = Ref(names=built[0].members, built=tuple(built))
        return [*goals, *places(ref, spec, scene, scope, clause.span)]
    return shaped(clause, spec, scene, scope)


def _mentioned(meaning: Meaning) -> bool:
    return isinstance(meaning, Pronoun) or (
        isinstance(meaning, Noun) and meaning.det in ("the", "all", "both", "these")
    )


def _read_row(clause: Clause, said: Noun, theme: Ref | None, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "their up-faces read A, B, C ...": a row in reading order."""
    labels = continued(said.traits.labels, None) if said.traits.open_ended else said.traits.labels
    if theme is not None and all(scene.things[n].elastic for n in theme.names):
        names = scene.fit(theme.names, len(labels))
        for name, label in zip(names, labels, strict=True):
            give(scene.things[name], Traits(labels=(label,)))
    else:
        names = refer(said, scene, scope).names
    spec.orders = [o for o in spec.orders if o.by not in ("label", "number", "ascending", "in_order")]
    spec.listed = True
    node = row_node(names, "line", spec, scene, scope, clause.span)
    order = node.order if node.order.by != "any" else Order(by="given", ranks=tuple((n,) for n in names), first="left")
    scene.assume("read from left to right")
    return [node.model_copy(update={"order": order, "readable": True, "axis": "y"})]
