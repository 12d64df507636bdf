"""What is said once more in other words: "by which I mean that ...", "which means ...". It holds beside what it
explains."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY

_THAT_IS = (
    "(?: ,|;| -| \\()? (?:ie|that is to say|which is to say|by (?:which|this|that) (?:i|we) mean|meaning|(?:which|that|"
    "this) (?:means|is to mean)|(?:or )?in other words)(?: that)?(?: ,| :)? "
)
_TELLS = (
    "(?=(?:(?!\\b(?:not|no) more\\b).)*\\b(?:is|are|must|has to|have to|should|stands?|lies?|goes|touch(?:es)?)\\b)"
)

SAID_AGAIN: tuple[Turn, ...] = (
    (f"^(.*\\b(?:sort|sorting|group|grouping|order|ordering) (?:\\w+ )*?by \\w+){_THAT_IS}", "{1} : "),
    (f"{_THAT_IS}{_TELLS}", " . "),
    (_THAT_IS, " , "),
    (f"\\ball ({MANY}) of the (?:other|remaining) (blocks|cubes|ones)\\b", "the other {1} {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
