""" "There is a row of three blue blocks with a red one at the left end. Move it": the row, or the red block?"""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse


def of_the_one(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Three blocks are in a row. The left one is red. Put it on the mat": the red block, and not the row; behind
    "build a row of three" it may be the row."""
    ordered = False
    found: list[Chain] = []
    before: Meaning | None = None
    for chain in chains:
        clauses: list[Meaning] = []
        for clause in chain.clauses:
            look = None if ordered else _told_look(before)
            it = clause.theme if isinstance(clause, Clause) else None
            if look is not None and isinstance(it, Pronoun) and it.word == "it" and isinstance(clause, Clause):
                clause = replace(clause, theme=replace(look, span=it.span))
            clauses.append(clause)
            before = clause
            ordered = ordered or (isinstance(clause, Clause) and clause.mode == "command")
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def _told_look(fact: Meaning | None) -> Noun | None:
    """The block that "the left one is red" tells of, by its colour."""
    if not isinstance(fact, Clause) or fact.negated or len(fact.adjuncts) != 1:
        return None
    alone = fact.adjuncts[0]
    if fact.verb == "part" and fact.theme is None and isinstance(alone, Absolute) and isinstance(alone.theme, Noun):
        colors = alone.theme.traits.colors if not alone.theme.plural else ()
        return replace(alone.theme, head="block", det="the", amount=None) if len(colors) == 1 else None
    if fact.lemma != "fact":
        return None
    noun, look = fact.theme, fact.adjuncts[0]
    one = isinstance(noun, Noun) and noun.det == "the" and not noun.plural and noun.traits.rank is not None
    if not one or not isinstance(noun, Noun) or noun.head == "patch" or not isinstance(look, Quality):
        return None
    colors = look.traits.colors
    return replace(noun, head="block", traits=Traits(colors=colors)) if len(colors) == 1 else None


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
