"""How large some blocks are, told behind what is done with them by size: "stack them by size, biggest at the bottom:
the red block is 6 cm, the blue one 5 cm", as rows that tell the sizes first, each with its verb; and sizes behind their
nouns, "a cube red big"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH, MANY

_ONE = f"(?:(?:the|an?|one) {COLOR}(?: (?:block|cube|one))?|the (?:\\w (?:block|cube)|(?:block|cube) \\w))"
_IS = "(?:is|measures|has)"
_LONG = f"{LENGTH}(?: (?:wide|big|large|high|tall|long|across))?"
_DONE = "((?:stack|pile|line up|line|arrange|sort|put|order) (?:them|these|those|the blocks|the cubes)(?: up)?\\b[^:]*)"

SIZES_TOLD_AT_ONCE: tuple[Turn, ...] = (
    (f"^{_DONE} :(?: the sizes are(?: :| ,)?)? ({_ONE} {_IS} {_LONG}(?= ,| and|$).*)$", "{2} . {1}"),
    (f"^({_ONE} {_IS} {_LONG}\\b.*?) (?:, and|,|and) ({_ONE}) (?={LENGTH})", "{1} and {2} is"),
)
"""What is looked for, and what is said instead."""
_SIZE = f"({'|'.join(sorted(lexicon.SIZE))})"
_A, _NOUN = f"(an?|one|the|{MANY})", "(blocks?|cubes?|bricks?|box|boxes)"
SIZES_TOLD: tuple[Turn, ...] = (
    # "a cube red big", "the block small"
    (f"\\b{_A} {_NOUN} ({COLOR}) {_SIZE}(?! enough)(?= |$)", "{1} {4} {3} {2}"),
    (f"\\b{_A} {_NOUN} {_SIZE}(?: and)? ({COLOR})(?= |$)", "{1} {3} {4} {2}"),
    (f"\\b{_A} ({COLOR} )?{_NOUN} {_SIZE}(?! (?:enough|and|or|as|than|to|{COLOR})\\b)(?= |$)", "{1} {4} {2} {3}"),
)
"""What makes no sense as it stands."""
