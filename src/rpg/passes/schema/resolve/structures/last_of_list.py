""" "A tower of four red blocks, a tower of four blue blocks and a white block": is that one of the last tower?"""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Coord, Meaning, Noun, Structure
from rpg.passes.schema.resolve.things.world import refuse


def check_last(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, if it is clear of which structure each of the blocks listed in them is.

    Raises:
        Refusal: where a single block behind several structures could be a thing of its own.
    """
    for chain in chains:
        told = [clause for clause in chain.clauses if isinstance(clause, Clause)]
        listed_on = all(clause.word is None or clause is told[0] for clause in told)  # no verb of its own
        themes = [clause.theme for clause in (told if listed_on else told[:1])]
        shapes = [
            x for theme in themes for x in (theme.items if isinstance(theme, Coord) else (theme,)) if x is not None
        ]
        last = shapes[-1] if len(shapes) > 1 and all(map(_built_of_one_look, shapes[:-1])) else None
        listed = last.members.items if isinstance(last, Structure) and isinstance(last.members, Coord) else ()
        if len(listed) == 2 and _several(listed[0]) and _single(listed[1]):
            raise refuse("ambiguous", "this could be one of the last structure, or a block of its own", listed[1].span,
                         "say it in a sentence of its own")  # fmt: skip
    return chains


def _built_of_one_look(shape: Meaning) -> bool:
    return isinstance(shape, Structure) and isinstance(shape.members, Noun)


def _several(thing: Meaning) -> bool:
    return isinstance(thing, Noun) and thing.plural


def _single(thing: Meaning) -> bool:
    return isinstance(thing, Noun) and not thing.plural and thing.det in ("a", "bare") and thing.amount == Amount(1, 1)
