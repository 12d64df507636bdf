"""Clauses about how blocks look: "both blocks are blue", "the patch is long"."""

from __future__ import annotations

from rpg.passes.schema.meaning import Clause, Noun, Quality
from rpg.passes.schema.resolve.refer import give, refer
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.world import Ref, Scene, Scope, refuse, said


def appear(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> None:
    """Let the objects have the looks that the clause gives them."""
    if clause.negated:
        raise refuse("misplaced", "looks can be given, not excluded", clause.span, "say which colour they have")
    theme = refer(clause.theme, scene, Scope(given=scope.given)) if clause.theme is not None else Ref()
    if theme.table:
        raise refuse("misplaced", "the table has one look", clause.span)
    for quality in spec.qualities:
        _give(theme, quality, clause, scene)
    spec.qualities = []


def _give(theme: Ref, quality: Quality, clause: Clause, scene: Scene) -> None:
    traits = quality.traits
    things = [scene.things[n] for n in theme.names]
    if traits.empty:
        raise refuse("misplaced", "say it as a goal: 'the patch should be empty'", quality.span)
    if traits.extra:
        for thing in things:
            thing.extra = True
        return
    if len(traits.colors) > 1 and len(traits.colors) != len(things):
        raise refuse(
            "count-mismatch",
            f"{len(traits.colors)} colours for {len(things)} objects",
            quality.span,
            "name one colour for each",
        )
    for index, thing in enumerate(things):
        color = traits.colors[index if len(traits.colors) > 1 else 0] if traits.colors else None
        if color and thing.color not in (None, color):
            raise refuse(
                "contradiction",
                f"{said(thing)} is said to be {color} here",
                quality.span,
                "name one colour",
                labels=((theme.span, f"{thing.color} here"),),
            )
        from dataclasses import replace

        give(thing, replace(traits, colors=(color,) if color else ()))
        if traits.scheme:
            thing.scheme = traits.scheme
        if traits.kind and thing.kind is None:
            thing.kind = traits.kind
        thing.claims -= 1


__all__ = ["Noun", "appear"]
