""" "Spread the blocks out", "distribute them": apart from each other, unless it is said how else they are to lie."""

from __future__ import annotations

from rpg.language.meaning import Clause, In, Loc, Pronoun
from rpg.passes.schema.resolve.clauses.spec import Spec


def spread_out(clause: Clause, spec: Spec) -> None:
    """What the verb itself asks for; "over the left half" only says where, and "on the table" that they do not pile."""
    told = spec.orders or spec.intos or spec.toward or spec.spacings or spec.thats
    halves = [place for place in spec.places if isinstance(place, In) and place.region.endswith("half")]
    elsewhere = len(halves) < len(spec.places) or (halves and clause.lemma != "spread")
    if clause.lemma in ("spread", "distribute") and not told and not elsewhere:
        each = Pronoun(word="each other", span=clause.span)
        spec.places.append(Loc(rel="apart", landmark=each, span=clause.span))
