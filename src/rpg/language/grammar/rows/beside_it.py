"""On which side of a thing others are, told by its other side, with what is left out, or of neither, as rows that say
it plainly: "next to it, and another on the other side", "a blue one on its left and two more on its right"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import ASIDE, IS, LABEL, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LENGTH, MUST, PATCH, N

_BLOCK = "(?:block|cube|brick)"
_ARE = f"(?:{IS}|are|{MUST} be|go|stand|lie)"
_OTHER = "on (?:the|its) (?:other|opposite)(?: one| side)?"
_A = "(?:an?|one|another|the)"
_ENDS = "(?:at|on|to) (?:the|both|the two|opposite|its|the opposite|both of the) ends"
_ROW = "(an? (?:row|line|column) of [^,]+)"
_THERE = f"there (?:is|stands|{MUST} be)"
_NO_PLACE = f"(?!.*\\b(?:table|{PATCH}|row|line|column)\\b)"
_NOT = f"((?:{MUST}|may|can|do) not)"
_IN_LINE = "(?:be|stand|lie|form)(?: in)? an? (?:\\w+ )?(?:row|line|column)"

BESIDE_IT_AT_ONCE: tuple[Turn, ...] = (
    # on the other side of it
    (f"^(?:{PUT} )?({THING})(?: {IS})? (next to|beside) ({THING})(?: ,)? and ({THING}) (?:{IS} )?{_OTHER}(?: of "
     "(?:it|\\3))?$", "{1} must be {2} {3} . {3} must be between {1} and {4}"),
    (f"^(?:{PUT} )?({THING})(?: {IS})? {_OTHER} of ({THING}) (?:from|than|to) ({THING})$",
     "{2} must be between {1} and {3}"),
    # "a white one to the left and another one to the right of it"
    (f"\\b(with {_A} [^,]+?) (?:to|on) the (left|right)(?: side)?(?: ,)? and ({_A} [^,]+?) (?:to|on) the "
     "(?!\\2)(left|right)(?: side)? of it$", "{1} to the {2} of it and {3} to the {4} of it"),
    (f"^((?:to|on) the (left|right) of {_NO_PLACE}[^,]+? (?:{_THERE}|is|stands|goes|put|place) {_A} [^,]+?)(?: ,)?(?: "
     f"and)? (?:to|on) the (?!\\2)(left|right)(?: of it)?((?: {_THERE})? {_A} [^,]+)$", "{1} and to its {3} {4}"),
    # names behind what is denied of them
    (f"^(?:the |these )?(?:{FEW} )?(?:blocks|cubes) {_NOT} ({_IN_LINE}) : ({THINGS})$", "{3} {1} {2}"),
    # in one line with two others, and on which side of them
    (f"^((?:{PUT} )?)({THING})(?: {IS})? in (?:a |one )?(?:straight )?line with ({THING}) and ({THING})(?: ,)?(?: and)?"
     f" ({ASIDE}) (?:both|both of them|them|the two)$",
     "{1} {2} in line with {3} and {4} . {2} must be {5} {3} and {4}"),
    # one after the other
    (f"^({PUT}|position) ({THING})(?: ,)? then ({THING}) (?=(?:{LENGTH} )?(?:{ASIDE}|next to|beside) \\2(?: ,|$))",
     "{1} {2} down , then put {3} "),
    # names before which it is only said that there are letters
    (f"^(?:{PUT}|position|arrange|lay out|order) (?:the|these) (?:letters|digits|numbers|symbols) (?:so|such|in such a "
     f"way) that (?!.*\\b(?:they|them|it|word|order|line|row)\\b)({LABEL} {IS} .+)$", "{1}"),
    # so many more of those that were told of
    (f"^((?:{PUT} )?(?:one|an?) ({COLOR}) ({_BLOCK}) (?:(?!\\b(?:an?|one) )[^,])+?(?: ,)? and) (?:another ({FEW})|"
     f"({FEW}) (?:more|others?))(?! of) (?=(?:to|on) (?:its|the) |{PLACE}\\b)", "{1} {4} {5} more {2} {3s} "),
    # "on the left of it and on its right"
    (f"^(?:{PUT} )?({THING})(?: {IS})? (?:on|to) ({THING}) 's (left|right)(?: side)?(?: ,)? and ({THING})(?: {IS})? "
     "(?:on|to) its (?!\\3)(left|right)(?: side)?$", "{1} must be to the {3} of {2} and {4} must be to the {5} of {2}"),
)  # fmt: skip
"""What is read otherwise as it stands."""
BESIDE_IT: tuple[Turn, ...] = (
    # neither this nor that
    (f"\\b({MUST}) neither touch ({THING}) nor (?:touch )?({THING})$", "{1} not touch {2} and {1} not touch {3}"),
    (f"\\b({MUST}) neither be ({PLACE}) ({THING}) nor (?:\\2 |to )?({THING})$",
     "{1} not be {2} {3} and {1} not be {2} {4}"),
    (f"\\b({MUST}) neither (touch|be {PLACE}) ({THING}) nor (touch|be {PLACE}) ({THING}|it)$",
     "{1} not {2} {3} and {1} not {4} {5}"),
    (f"\\b({MUST}) neither be ({PLACE}) ({THING}) nor ({PLACE}) ({THING}|it)$",
     "{1} not be {2} {3} and {1} not be {4} {5}"),
    # at both ends
    (f"^(?:{PUT} )?(?:the )?two ({COLOR}){N} (?:{_ARE} )?{_ENDS} of {_ROW}$", "{2} with a {1} block at each end"),
)  # fmt: skip
"""What makes no sense as it stands."""
