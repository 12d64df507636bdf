"""Parts of the table that are cleared, or free of blocks, as rows that say that nothing is to be there."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST

_SIDE = "(?:left|right|near|far|front|back|rear|upper|lower)"
_PART = f"(?:{_SIDE} (?:half|side|edge)|{_SIDE} {_SIDE} corner|middle|center)"
_WHICH = f"(?:the ({_PART}) of the table|the table 's ({_PART}))"
_FREE = "(?:free|clear|empty)(?: of (?:all |any )?(?:the )?(?:blocks|cubes|bricks|objects))?"

CLEARED_PARTS: tuple[Turn, ...] = (
    (f"^(?:clear|empty|vacate|free)(?: up| out)? {_WHICH}(?: of (?:all |any )?(?:the )?(?:blocks|cubes|bricks))?$",
     "the {1} {2} of the table must be empty"),
    (f"^{_WHICH} (?:({MUST}) (?:be|stay|remain|be kept|be left)|is|stays|remains) {_FREE}$",
     "the {1} {2} of the table must be empty"),
    (f"^(?:keep|leave) {_WHICH} {_FREE}$", "the {1} {2} of the table must be empty"),
)  # fmt: skip
"""What makes no sense as it stands."""
