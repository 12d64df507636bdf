"""What stands at the ends of a tower, in other words: "the tower's base is blue", "blue is the base of the tower, red
its top", "the tower grows by a green block", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MID, MUST, TOWER

_BASE, _TOP = "(?:base|bottom|foot)", "(?:top|tip)"
_END = f"(?:{_BASE}|{_TOP}|{MID})"
_IS = f"(?:is|forms|makes|{MUST} be|{MUST} form)"
_GROWING = f"((?:the|an?|each|both) [^,.]*?{TOWER}s?\\b[^,.]*?|it)"
_MORE = f"(?:another|(?:an?|one|two|three) (?:\\w+ )*{COLOR}) [^,.]+"

ENDS_OF_TOWERS_AT_ONCE: tuple[Turn, ...] = (
    (f"\\bthe ({TOWER}|pyramid) 's ({_END})\\b", "the {2} of the {1}"),
    (f"^use ({THING}) as (?:the|a) {_BASE}(?: of (?:the|a) {TOWER})?(?: ,| and| then)+ (?:stack|put|place|pile) "
     "([^,.]+) on (?:it|top|top of it)$", "stack {2} on {1}"),
    (f"^heap (.+?)(?: up)? (in|into) (an?|one) ({TOWER})\\b", "stack {1} {2} {3} {4}"),
    ("\\bas (?:the|a) cherry on top(?= |$)", "on top"),
)  # fmt: skip
"""What may be read as it stands, but not as it is meant."""
ENDS_OF_TOWERS: tuple[Turn, ...] = (
    (f"^({THING}) {_IS} the {_BASE} of (?:the|a) ({TOWER})(?: ,| and)+ ({THING}) (?:{_IS} )?(?:its|the) {_TOP}"
     f"(?: ,| and| with)+ ({THING})(?: {_IS})? (?:in between|in the {MID}|between them)$",
     "a {2} with {1} at the bottom , {4} in the middle and {3} on top"),
    (f"\\b(?:the |its )?({_BASE}) and (?:the |its )?({_TOP})(?: are)?(?: both)? ({COLOR})(?=$| , (?:and )?(?:the|all))",
     "the {1} {3} , the {2} {3}"),
    (f"^(?:let |have |make )?{_GROWING} (?:{MUST} )?grows? (?:higher |taller )?by ({_MORE})$", "put {2} on top of {1}"),
    (f"^(?:extend|heighten|lengthen|raise) {_GROWING} (?:upwards? )?(?:by|with) ({_MORE})$", "put {2} on top of {1}"),
    (f"^make {_GROWING} one {CUBE} (?:taller|higher) (?:with|by adding|using) ({_MORE})$", "put {2} on top of {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
