"""One that there should be, with what is told of it behind "that" or "which": "there should be a red block that stands
behind the tower", "a red block that touches it", as rows that say it of the block."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY, MUST

_ONE = f"(?:an?|{MANY}) (?:(?!(?:that|which|and|with) )[^,])+?"
_WISHED = f"(?:there {MUST} be|(?:i|we) (?:want|need|would like)(?: to (?:see|have))?)"
_THAT = "(?:that|which)"
_NOW = "(?!.*\\b(?:start|now|first|initially|beginning)\\b)"
_IS = f"(?:is|are|stands?|lies?|sits?|rests?|{MUST} (?:be|stand|lie|sit))"
_LIES = f"{_THAT} {_IS} (?=(?:not )?{PLACE}\\b)"
_OF_IT_ALONE = "(?!.*\\b(?:that|which)\\b)(?!(?:(?!\\bbetween\\b).)*\\band (?:an?|one|the|two|three)\\b)"
"""What is told then of others may be told of what it lies beside."""

WISHED_SUCH_AT_ONCE: tuple[Turn, ...] = (
    (f"^{_NOW}{_WISHED} ({_ONE}) {_LIES}((?:(?!\\bbetween\\b)[^,])+?)(?: ,)? and ({_ONE}) {_LIES}"
     f"((?:(?!\\b{_THAT}\\b).)+)$", "{1} must be {2} and {3} must be {4}"),
    (f"^{_NOW}{_WISHED} ({_ONE}) {_LIES}{_OF_IT_ALONE}", "{1} must be "),
    (f"^{_NOW}{_WISHED} ({_ONE}) {_THAT} (?:touch|touches) {_OF_IT_ALONE}", "{1} must touch "),
    (f"^{_NOW}{_WISHED} ({_ONE}) {_THAT} (?:does|do|{MUST}) not touch {_OF_IT_ALONE}", "{1} must not touch "),
)  # fmt: skip
"""What would be told of a block by the way, and of which it is not said where it is."""
WISHED_SUCH: tuple[Turn, ...] = (
    (f"\\b({_ONE}) {_THAT} (?:touch|touches|{MUST} touch|is in contact with) ", "{1} touching "),
    (f"\\b({_ONE} (?:(?:on|to) its (?:left|right)|(?:in front of|behind|next to|beside) it)) {_THAT} touches it\\b",
     "{1} touching it"),
    (f"^({_ONE}) {_LIES}{_OF_IT_ALONE}", "{1} must be "),
)  # fmt: skip
"""What makes no sense as it stands."""
