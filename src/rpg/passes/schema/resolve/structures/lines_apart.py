""" "A row of three white blocks and a row of three black ones, 10 cm apart": the rows are, not the blocks of one."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Loc, Meaning, Pronoun, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse

_LINES = frozenset({"row", "line", "column", "word", "equation"})
_WITHIN = frozenset({"touching", "adjacent", "heaped_row"})


def between_lines(shapes: Sequence[Meaning], spec: Spec) -> list[Meaning]:
    """The places that tell how several structures stand to each other, taken out of what is told of each of them.

    Raises:
        Refusal: where it could as well be how the blocks of each line stand to each other.
    """
    lined = [x for x in shapes if isinstance(x, Structure) and x.kind in _LINES and not x.plural]
    if len(shapes) < 2 or not lined or any(not isinstance(x, Structure) for x in shapes):
        return []
    mutual = [p for p in spec.places if isinstance(p, Loc) and _of_each_other(p) and not p.negated]
    for place in mutual:
        if place.rel in _WITHIN or (place.rel == "distance" and place.measure == "faces"):
            raise refuse("ambiguous", "of the blocks of each line, or of the lines?", place.span,
                         "say 'the rows are 10 cm apart', or it behind each row")  # fmt: skip
    spec.places = [p for p in spec.places if p not in mutual]
    return [*mutual]


def _of_each_other(place: Loc) -> bool:
    return isinstance(place.landmark, Pronoun) and place.landmark.word == "each other"
