"""Structures that are spoken of as if they were known, though nothing says what they are made of."""

from __future__ import annotations

from collections import Counter

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Structure, Traits, parts_of
from rpg.passes.schema.resolve.things.world import Scene, refuse


def check_known(chains: tuple[Chain, ...], scene: Scene) -> None:
    """Refuse "the tower" of made-up blocks beside named ones, and "on the red stack" of nobody knows how many."""
    parts = [part for chain in chains for part in parts_of(chain)]
    shapes = [part for part in parts if isinstance(part, Structure)]
    made_up = any(t.invented and t.color is not None for t in scene.things.values())
    named = any(not (t.invented or t.extra or t.patch) for t in scene.things.values())
    told, built = Counter(x.kind for x in shapes if x.det != "the"), Counter(b.kind for b in scene.built)
    known = [x for x in shapes if x.det == "the" and x.members is None and x.letter is None]
    if made_up and named and any(x.kind not in told or built[x.kind] > told[x.kind] for x in known):
        raise refuse(
            "no-referent",
            "a structure is spoken of as known, but it is not said which blocks it is made of",
            chains[0].span,
            "name its blocks",
        )
    marks = [part.landmark for part in parts if isinstance(part, Loc)]
    _nowhere_built(marks, chains, scene)
    for mark in marks if any(told.startswith(_UNSAID) for told in scene.assumptions) else ():
        if not isinstance(mark, Structure) or mark.plural or mark.det not in ("the", "bare") or not _open(mark):
            continue
        if not any(other is not mark and other.kind == mark.kind for other in shapes):
            raise refuse("no-referent", "this is spoken of as known, but it is not said how many blocks it has",
                         mark.span, f"say 'a {mark.kind} of three red blocks', for example")  # fmt: skip


def _nowhere_built(marks: list[Meaning | None], chains: tuple[Chain, ...], scene: Scene) -> None:
    """Refuse "there are two red and two blue blocks. Put a yellow one on the tower" as a tower of those four."""
    clauses = [part for chain in chains for part in parts_of(chain) if isinstance(part, Clause)]
    shapes = [part for chain in chains for part in parts_of(chain) if isinstance(part, Structure)]
    listed = any(thing.declared and not thing.patch for thing in scene.things.values())
    begun = any(goal.kind not in ("row", "on_patch", "in_region") for goal in scene.start_goals)
    builds = begun or bool(scene.on_top) or any(clause.verb in _BUILDING for clause in clauses)
    told = {shape.kind for shape in shapes if shape.det != "the"}
    for mark in marks if listed and not builds else ():
        if isinstance(mark, Structure) and mark.det == "the" and _bare(mark) and not (mark.plural or mark.kind in told):
            raise refuse("no-referent", "this is spoken of as known, but nothing says that it is there or is built",
                         mark.span, f"say first that there is a {mark.kind}, or what is to be one")  # fmt: skip


_BUILDING = frozenset({"stack", "build", "arrange", "spell", "sort", "order"})


def _bare(shape: Structure) -> bool:
    return shape.members is None and not (
        shape.sizes or shape.dims or shape.letter or shape.details or shape.amount or shape.traits != Traits()
    )


_UNSAID = "the number of"


def _open(shape: Structure) -> bool:
    """Whether no more is said of a structure than its kind and the colours of its blocks."""
    members = shape.members
    plain = members is None or (
        isinstance(members, Noun)
        and members.amount is None
        and members.det == "bare"
        and members.traits == Traits(colors=members.traits.colors)
        and len(members.traits.colors) == 1
        and members.plural
    )
    return plain and not (shape.sizes or shape.dims or shape.letter or shape.details)
