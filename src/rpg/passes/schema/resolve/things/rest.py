"""Whether what is left over is spoken of, so that the blocks spoken of before are to be told apart from it."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Meaning, Noun, Pronoun, Traits


def speaks_of_rest(parts: Sequence[Meaning]) -> bool:
    """ "the others", "the rest"; "the third one" beside "two of them"."""
    counted = {x.amount.low for x in parts if isinstance(x, Noun) and x.part_of is not None and x.amount is not None}
    ranks = {x.traits.rank for x in parts if isinstance(x, Noun) and x.traits == Traits(rank=x.traits.rank)}
    return any(map(_rest, parts)) or any(str(many + 1) in ranks for many in counted)


def _rest(part: Meaning) -> bool:
    """ "the others", "the rest", "another red block": what is left when some are spoken of."""
    if isinstance(part, Noun):
        return part.det in ("other", "another")
    return (
        isinstance(part, Pronoun)
        and ("other" in part.word or "rest" in part.word or "remain" in part.word)
        and part.word not in ("each other", "one another")
    )
