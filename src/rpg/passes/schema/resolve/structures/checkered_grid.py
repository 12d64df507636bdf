""" "A 2 x 3 grid in a checkerboard pattern from three black and three white cubes": a checkerboard of that size."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Into, Meaning, Structure, replace

_BOARDS = frozenset({"grid", "square", "rectangle"})


def checkered_grid(chain: Chain) -> Chain:
    """The sentence with one structure for a grid and the pattern that it is to have."""
    return replace(chain, clauses=tuple(map(_in_one, chain.clauses)))


def _in_one(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or not isinstance(clause.theme, Structure) or clause.theme.kind not in _BOARDS:
        return clause
    grid = clause.theme
    found = [a for a in clause.adjuncts if isinstance(a, Into) and isinstance(a.structure, Structure)]
    board = found[0].structure if len(found) == 1 else None
    if not isinstance(board, Structure) or board.kind != "checkerboard" or board.dims or board.sizes or board.plural:
        return clause
    if grid.members is not None and board.members is not None:
        return clause
    whole = replace(grid, kind="checkerboard", members=grid.members or board.members, filled=None)
    return replace(clause, theme=whole, adjuncts=tuple(a for a in clause.adjuncts if a is not found[0]))
