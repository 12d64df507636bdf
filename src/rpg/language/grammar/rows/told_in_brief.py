"""Places, what is left over and what is stacked at the start, told with fewer words than elsewhere: "red left", "one
green block left over", "red=left", "nothing is stacked"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, CUBE, MANY

_NAME = f"(?:the )?(?:{COLOR}|[a-z])(?: one| {CUBE})?"
_PAIRED = "(?:next to each other|next to one another|side by side|beside each other|beside one another)"
_ENDS = "(?= ,| and|$)"
_PLACE = "(?:left|right|middle|center|top|bottom|front|back)"
_AT_FIRST = (
    "(?:at the start|at the beginning|in the beginning|at first|to start with|to begin with|originally|initially)"
)

TOLD_IN_BRIEF: tuple[Turn, ...] = (
    # of a pair: which of them is left of the other
    (f"({_PAIRED})(?: ,| with|{AND}) ({_NAME}) (left|right){_ENDS}", "{1} , {2} on the {3}"),
    (f"({_PAIRED}) , ({_NAME} on the (?:left|right)){AND} ({_NAME}) (left|right){_ENDS}", "{1} , {2} , {3} on the {4}"),
    # no part of what is built
    (f"({AND}) ((?:an?|one) (?:\\w+ )?(?:{CUBE}|one)) (?:left over|is left)$", "{1} {2} is left over"),
    (f"({AND}) ({MANY} (?:\\w+ )?(?:{CUBE}s|ones)) (?:left over|are left)$", "{1} {2} are left over"),
    # before anything is built
    (f"^{_AT_FIRST}(?: ,)? nothing is stacked(?: up)?(?: yet)?$", "at the start , no block is on another"),
    (f"^nothing is stacked(?: up)?(?: yet)?(?: ,)? {_AT_FIRST}$", "at the start , no block is on another"),
)

_NAMED = f"\\b({COLOR}|[a-z]) ="
_IN_LINE = "\\b(?:row|line)\\b"

ASSIGNED: tuple[Turn, ...] = (
    (f"^(.*){_NAMED} ({_PLACE})(?= [,.;]| and)(.*{_IN_LINE}.*)$", "{1} {2} {3} {4}"),
    (f"^(.*{_IN_LINE}.*){_NAMED} ({_PLACE})(?= [,.;]| and|$)", "{1} {2} {3}"),
    (f"{_NAMED} (top|bottom)(?= [,.;]| and|$)", "{1} {2}"),
)
"""Where blocks of a line are, as values are given to names."""
