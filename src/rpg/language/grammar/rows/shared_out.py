"""So many blocks, and where some and others of them go, "of the three red cubes, two must be on A and one on B", and
the other of two towers, as rows that count or name them."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import IS, PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST

_BLOCKS = f"{MANY}(?: {COLOR})? (?:block|cube)s"
_GOES = f"(?:{MUST}|is|are|go|goes|on|in|stands?)"
_OTHERS = f"(?:(?:,|and|, and) {MANY} {_GOES} (?!(?:top )?of them).+)"
SHARED_OUT: tuple[Turn, ...] = (
    (f"^(?:out )?(?:of|from) (?:the )?({_BLOCKS}) , ({MANY} {_GOES} .+? {_OTHERS})$", "{1} : {2}"),
    (f"^({MANY}) of (?:the )?({_BLOCKS}) ({_GOES} .+? {_OTHERS})$", "{2} : {1} {3}"),
    (f"^(the (?:\\w+ )?({LINE})(?: with [^,]+?)? {IS} {PLACE} the other)(?: one)?$", "{1} {2}"),
)
"""What is looked for, and what is said instead; in every sentence."""
