"""Which words of the language a word that means nothing here could be typed for."""

from __future__ import annotations

from functools import lru_cache

from rpg.language.spelling import LONG_WORD, NO_SLIPS, nearest, slip, vocabulary


@lru_cache(maxsize=1024)
def slips_of(word: str) -> tuple[str, ...]:
    """The words that it is a slip for; none where it is an ordinary word that means something else, or some of what is
    known."""
    if word in NO_SLIPS or word.removesuffix("s") in vocabulary():
        return ()
    near = nearest(word, 1 if len(word) < LONG_WORD else 2)
    return tuple(known for known in near if len(known) > 2 and slip(word, known))
