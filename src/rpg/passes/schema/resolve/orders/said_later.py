"""Orders and gaps of a line that was spoken of before: "Put A, C and B in a row. The row should be sorted."."""

from __future__ import annotations

from rpg.language.meaning import Clause, Meaning, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Scene

_LINES = ("row", "line", "column", "stack")


def said_later(clause: Clause, spec: Spec, scene: Scene) -> bool:
    """Whether a clause says of the blocks of the only such line how they are to lie in it, and nothing besides."""
    shape = clause.theme
    plain = isinstance(shape, Structure) and shape.kind in _LINES and shape.det == "the" and not _told(shape)
    made = [one for one in scene.built if isinstance(shape, Structure) and _is(one.kind, shape.kind)]
    how: list[Meaning] = [*spec.orders, *spec.spacings]
    all_of_it = bool(how) and len(how) + len(spec.toward) == len(clause.adjuncts)
    return plain and len(made) == 1 and clause.verb == "be" and all_of_it


def _told(shape: Structure) -> bool:
    """Whether more is said of it than which kind of line it is."""
    more = (shape.amount, shape.members, shape.details, shape.sizes, shape.dims)
    return shape.plural or any(more)


def _is(made: str, said: str) -> bool:
    """Whether a line that was made is what is called so: a row may be called a line."""
    return made == said or {made, said} <= {"row", "line"}
