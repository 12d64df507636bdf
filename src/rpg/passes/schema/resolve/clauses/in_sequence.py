"""What is sorted by what it shows, where no order is told: "sort 3, 1 and 2", "the even numbers are sorted"."""

from __future__ import annotations

from rpg.core.diagnostics import Refusal
from rpg.language.meaning import Clause, Noun, OrderBy, parts_of
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def in_sequence(clause: Clause, theme: Ref, spec: Spec, scene: Scene) -> None:
    """ "sort 3, 1 and 2 from left to right", "sort the letters in a row": by what they show, not as they are listed."""
    things = [scene.things[n] for n in theme.names]
    shown = all(t.label is not None or t.kind in ("letter", "digit") for t in things)
    told = [part for part in parts_of(tuple(spec.intos)) if isinstance(part, OrderBy)]
    if clause.lemma == "sort" and any(map(_unsorted, told)):
        raise _listed_or_sorted(clause)
    if spec.orders or told or clause.lemma not in ("sort", "order") or len(things) < 2 or not shown:
        return
    labels = [t.label for t in things if t.label is not None]
    listed = labels != sorted(labels) or any(t.elastic for t in things)
    if clause.lemma == "order" and labels and listed:
        raise _listed_or_sorted(clause)
    spec.orders.append(OrderBy(by="ascending", span=clause.word or clause.span))


def _unsorted(told: OrderBy) -> bool:
    """ "Sort the letters in a row: C, A, B": which is how they are listed, and not how they end up."""
    shown = [x for item in told.items if isinstance(item, Noun) for x in item.traits.labels]
    return told.by == "named" and told.first is None and len(shown) > 2 and shown != sorted(shown)


def _listed_or_sorted(clause: Clause) -> Refusal:
    told = "as they are listed, or by what they show?"
    return refuse("ambiguous", told, clause.span, "say 'in ascending order', or leave out 'sort'")
