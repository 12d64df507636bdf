"""Rings and crosses as people describe them, "eight in a circle around the black one", "arms two cubes long", as rows
that say it plainly."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import FEW, MUST, Turn

_COLOR = f"(?:{'|'.join(sorted(lexicon.COLOR))})"
_MANY = f"(?:\\d+|{FEW})"
_BLOCKS = "(?:blocks|cubes|bricks|ones)"
_BLOCK = "(?:block|cube|brick|one)"
_MADE = "(?:build|make|form|lay|lay out|set out|set up|put|place|arrange|create|construct)"
_BE = f"(?:is|are|being|{MUST} be|stands|lies|sits)"
_RING = "(?:circle|ring)"
_PLUS = "(?:plus sign|plus shape|plus|cross)"
_MID = "(?:middle|center)"
_WITHOUT = "(?: ,)? (?:not counting|without|not including) the (?:center|middle)(?: block| cube| one)?"
_ARMS = (f"(?:arms|each arm|each of (?:the |its )?(?:four )?arms)(?: that| which)?(?: is| are| being)?(?: of)? "
         f"({_MANY}) "
         "(?:blocks|cubes)(?: long)?(?: each)?")  # fmt: skip

FIGURES: tuple[Turn, ...] = (
    # rings around something
    (f"^(?:{_MADE} )?({_MANY} [^,:]*?{_BLOCKS}) (?:{MUST} )?(?:form |make |stand |are |lie |be )?(?:placed |arranged )?"
     f"(?:in |into |as )?an? ({_RING}) (?:all )?(?:around|round) ((?:the|an?) [^,:]+)$", "a {2} of {1} around {3}"),
    (f"^(?:surround|encircle) ((?:the|an?) [^,:]+?) (?:with|by) an? ({_RING}) (?:of|made of|from) ({_MANY} [^,:]+)$",
     "a {2} of {3} around {1}"),
    ("\\b(circle|ring|square|plus|cross|grid)\\b((?:(?! and ).)*?) (in|at) the (middle|center) of the \\1$",
     "{1} {2} {3} the {4}"),
    (f"^(?:{_MADE} )?({_MANY} [^,:]*?{_BLOCKS}) in an? ({_RING})(?: ,)? (?:and|with) (an? [^,:]+?) in (?:the|its) "
     f"{_MID}$",
     "a {2} of {1} with {3} in the middle"),
    (f"\\b((?:circle|ring|square|outline|rectangle) .*?)(?: ,)? (with|and) ((?:the|an?) {_COLOR}(?: {_BLOCK})?) "
     f"(?:inside|within)(?: ,)? in the ({_MID})$", "{1} {2} {3} in the {4}"),
    # crosses
    (f"\\b({_PLUS}\\b[^:;]*?)(?: ,| :)?(?: with| where| and| whose)?(?: four)? {_ARMS}(?:{_WITHOUT})?$",
     "{1} with each arm of {2} blocks"),
    (f"^(.*\\b(?:five|5) [^,:]*?{_BLOCKS}) (?:on the table )?(?:in|like|as) an? ({_PLUS})(?: ,| :)? one in the {_MID} "
     "and one (?:on|at|for) each (?:of the four |of its four |of the |of its )?(?:sides?|arms?|ends?)$",
     "{1} as a plus"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})?(?: ,| :)? (?:four|4)(?: of (?:them|these))? "
     f"({_COLOR})(?: {_BLOCKS})? "
     f"and (?:the (?:one|block|cube) (?:in|at) the {_MID}|the {_MID} (?:one|block|cube)|the {_MID}) ({_COLOR})$",
     "{1} with a {3} center and {2} arms"),
    (f"\\b({_PLUS}) (?:of|from|out of|made of) (?:four|4) ({_COLOR})(?: {_BLOCKS})? (?:and|with|around) (?:an?|one) "
     f"({_COLOR})(?: {_BLOCK})?(?: (?:in|at|as|for) (?:the|its) {_MID}| so that the \\3 (?:one|{_BLOCK}) "
     f"(?:is|becomes|forms|makes|{MUST} be) (?:its|the) {_MID})$", "{1} with a {3} center and {2} arms"),
    (f"^{_MADE} (?:four|4) ({_COLOR})(?: {_BLOCKS})? around an? ({_COLOR})(?: {_BLOCK})? ,? ?(?:which|that|so that it|"
     f"so it|to) (?:gives?|makes?|forms?) an? ({_PLUS})(?: with an? \\2 {_MID})?$",
     "a {3} with a {2} center and {1} arms"),
    (f"^an? ({_COLOR}) (?:{_BLOCK}) {_BE} (?:in|at) the {_MID} of an? ({_PLUS}) (?:whose|with) (?:the |its "
     f")?(?:four )?arms "
     f"(?:are |of )?({_COLOR})(?: {_BLOCKS})?$", "a {2} with a {1} center and {3} arms"),
    (f"\\b({_PLUS})(?: ,| :)? the {_MID}(?: {_BLOCK})? {_BE} ({_COLOR}) and the (?:four )?(?:{_BLOCKS}|others)"
     f"(?: all)?(?: around(?: it)?)? {_BE} ({_COLOR})$", "{1} with a {2} center and {3} arms"),
    (f"\\b({_PLUS})(?: sign| shape)? ,? ?(?:for which|out of which|from which) ({_MANY} (?:\\w+ )?{_BLOCKS}) {MUST} be "
     "used$", "{1} made of {2}"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})(?: ,)? all(?: of them)? ({_COLOR}) (?:but|except|apart "
     f"from|save)(?: for)? the (?:one (?:in|at) the {_MID}|{_MID} one|{_MID})(?: ,)?(?: which is| being)? ({_COLOR})$",
     "{1} with a {3} center and {2} arms"),
    # what lies on the middle
    (f"^(.*\\b(?:{_PLUS}|grid|square)\\b[^,]*?) (?:whose {_MID}(?: {_BLOCK})? (?:carries|bears|holds|supports)|with the"
     f" {_MID} (?:one|{_BLOCK}) (?:carrying|bearing|holding)) (?:the|an?) ({_COLOR} {_BLOCK})$",
     "{1} with a {2} on its center"),
    (f"^(.*\\b(?:{_PLUS}|grid|square)\\b[^,]*?) , the (?:one|{_BLOCK}) (?:in|at) (?:the|its) {_MID} (?:carrying|"
     f"bearing|"
     f"holding) (an? {_COLOR} {_BLOCK})$", "{1} with {2} on its center"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
