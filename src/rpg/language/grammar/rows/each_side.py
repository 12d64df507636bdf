""" "One red block each in front of it, behind it and on its left": as many blocks as there are places."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, CUBE, MUST

_BLOCK = f"(?:one|an?) ((?:{COLOR} )?(?:{CUBE}|letter|digit))"
_WHAT = f"(?:it|(?:the|an?) (?:{COLOR} )?(?:{CUBE}|one|\\S))"
_PLACE = (
    f"((?:in front of|behind|(?:on|to|at) the (?:left|right)(?: side)? of|left of|right of) {_WHAT}|"
    "(?:on|to|at) its (?:left|right)(?: side)?)"
)
_SHORT = "(in front|behind|(?:on|to|at) the (?:left|right)(?: side)?|left|right)(?: of)?"


def _each(many: int) -> Turn:
    places = f"{AND} ".join([_PLACE] * many)
    return f"\\b{_BLOCK} each {places}", " , ".join(f"a {{1}} {{{n}}}" for n in range(2, many + 2))


EACH_SIDE: tuple[Turn, ...] = (
    *map(_each, (4, 3, 2)),
    (
        f"^((?:the|an?) (?:{COLOR} )?(?:{CUBE}|one|letter|digit|\\w)) (?:{MUST} have|has|gets) (?:(?:an?|one|two) )?"
        f"({COLOR}|vowel|consonant)(?: {CUBE})?(?: as)?(?: an?)? neighbors? on (?:either|both|each|every) (?:of its )?"
        "sides?(?: of it)?$",
        "two {2} blocks must be next to {1} and {1} must be between them",
    ),
    (f"\\b{_BLOCK} each {_SHORT}{AND} {_SHORT}(?: of)? ({_WHAT})", "a {1} {2} of {4} and another {1} {3} of {4}"),
)
"""What is looked for in every sentence."""
