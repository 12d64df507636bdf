"""How large some blocks are, told behind what is done with them by size: "stack them by size, biggest at the bottom:
the red block is 6 cm, the blue one 5 cm", as rows that tell the sizes first, each with its verb."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH

_ONE = f"(?:(?:the|an?|one) {COLOR}(?: (?:block|cube|one))?|the (?:\\w (?:block|cube)|(?:block|cube) \\w))"
_IS = "(?:is|measures|has)"
_LONG = f"{LENGTH}(?: (?:wide|big|large|high|tall|long|across))?"
_DONE = "((?:stack|pile|line up|line|arrange|sort|put|order) (?:them|these|those|the blocks|the cubes)(?: up)?\\b[^:]*)"

SIZES_TOLD_AT_ONCE: tuple[Turn, ...] = (
    (f"^{_DONE} :(?: the sizes are(?: :| ,)?)? ({_ONE} {_IS} {_LONG}(?= ,| and|$).*)$", "{2} . {1}"),
    (f"^({_ONE} {_IS} {_LONG}\\b.*?) (?:, and|,|and) ({_ONE}) (?={LENGTH})", "{1} and {2} is"),
)
"""What is looked for, and what is said instead."""
