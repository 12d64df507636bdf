"""Distractors that a phrase speaks of: those there are, or new ones."""

from __future__ import annotations

from rpg.language.meaning import Noun, Traits, replace
from rpg.passes.schema.resolve.things.things import create
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def extras(noun: Noun, scene: Scene) -> Ref:
    """Distractors: as many as are said, of the colours or labels listed."""
    labels, colors = noun.traits.labels, noun.traits.colors
    count = noun.amount.low if noun.amount else len(labels) or len(colors) or (2 if noun.plural else 1)
    if noun.det in ("the", "other") and (known := _known_extras(noun, scene)):
        return Ref(names=known, patch=noun.head == "patch", det=noun.det, plural=len(known) > 1)
    if noun.head == "any" and noun.traits == Traits(extra=True) and any(True for _ in scene.blocks()):
        raise refuse("ambiguous", "it is not said what these blocks look like", noun.span, "name their colour")
    scene.new_batch()
    names = []
    for index in range(max(count, len(labels), len(colors))):
        color = (colors[index % len(colors)],) if colors else ()
        label = (labels[index % len(labels)],) if labels else ()
        thing = create(replace(noun.traits, labels=label, colors=color), scene, noun.head == "patch")
        thing.extra = True
        names.append(thing.name)
    return Ref(names=tuple(names), patch=noun.head == "patch", det=noun.det, plural=len(names) > 1)


def _known_extras(noun: Noun, scene: Scene) -> tuple[str, ...]:
    """ "the distractors": those that were brought up, if they are as many and look so."""
    there = [t for t in scene.things.values() if t.extra and t.patch == (noun.head == "patch")]
    there = [t for t in there if not noun.traits.colors or t.color in noun.traits.colors]
    there = [t for t in there if not noun.traits.labels or t.label in noun.traits.labels]
    many = noun.amount.low if noun.amount is not None else len(there) if noun.plural else 1
    return tuple(t.name for t in there) if len(there) == many else ()
