"""One that there should be, with what is told of it behind "that" or "which": "there should be a red block that stands
behind the tower", "a red block that touches it", as rows that say it of the block."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MUST

_ONE = f"an? (?:(?:{COLOR}|small|big|large|\\d cm) )*(?:{CUBE}|brick|letter \\w)"
_WISHED = f"(?:there {MUST} be|(?:i|we) (?:want|need|would like)(?: to (?:see|have))?)"
_IS = f"(?:is|stands|lies|sits|rests|{MUST} (?:be|stand|lie|sit))"
_OF_IT_ALONE = "(?!.*\\b(?:that|which|and (?:an?|one|the|two|three))\\b)"
"""What is told then of others may be told of what it lies beside."""

WISHED_SUCH_AT_ONCE: tuple[Turn, ...] = (
    (f"^{_WISHED} ({_ONE}) (?:that|which) {_IS} (?={PLACE}\\b){_OF_IT_ALONE}", "{1} must be "),
    (f"^{_WISHED} ({_ONE}) (?:that|which) touches {_OF_IT_ALONE}", "{1} must touch "),
)
"""What would be told of a block by the way, and of which it is not said where it is."""
WISHED_SUCH: tuple[Turn, ...] = (
    (f"\\b({_ONE}) (?:that|which) (?:touches|{MUST} touch|is in contact with) ", "{1} touching "),
    (f"^({_ONE}) (?:that|which) {_IS} (?={PLACE}\\b){_OF_IT_ALONE}", "{1} must be "),
)
"""What makes no sense as it stands."""
