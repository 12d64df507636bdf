""" "There is a row of three blue blocks with a red one at the left end. Move it": the row, or the red block?"""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Absolute, At, Chain, Clause, Coord, Loc, Meaning, Noun, Pronoun, Structure
from rpg.passes.schema.resolve.things.world import refuse


def check_it(chains: tuple[Chain, ...]) -> None:
    """Refuse "it" that is put somewhere behind several structures, or one with a block of its own kind."""
    clauses = [clause for chain in chains for clause in chain.clauses if isinstance(clause, Clause)]
    for before, clause in pairwise(clauses):
        it = clause.theme
        if clause.verb != "place" or clause.mode != "command" or not isinstance(it, Pronoun) or it.word != "it":
            continue
        built = before.theme.items if isinstance(before.theme, Coord) else (before.theme,)
        if len(built) > 1 and all(isinstance(x, Structure) for x in built):
            raise refuse("ambiguous", "'it' is one thing, and several were mentioned", it.span,
                         "name the one you mean, or say 'them'")  # fmt: skip
        for part in (*before.adjuncts, *(d for x in built if isinstance(x, Structure) for d in x.details)):
            if isinstance(built[0], Structure) and _told_apart(part, there=before.mode == "given"):
                whole = "tower" if built[0].kind == "stack" else built[0].kind
                raise refuse("ambiguous", f"'it' could be the {whole}, or the block that is told apart with it",
                             it.span, "name the block or blocks you mean")  # fmt: skip


def _told_apart(part: Meaning, there: bool) -> bool:
    """ "With a red one at the left end", or, of what is yet to be built, "with a red one on top"."""
    one = part.theme if isinstance(part, Absolute) else None
    if not isinstance(part, Absolute) or not isinstance(one, Noun) or one.plural or one.det == "the":
        return False
    places = [x for x in part.adjuncts if isinstance(x, At | Loc)]
    return any(there or (isinstance(x, At) and x.side == "top") for x in places)
