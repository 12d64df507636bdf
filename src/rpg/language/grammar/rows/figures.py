"""Rings and crosses as people describe them, "eight in a circle around the black one", "arms two cubes long", as rows
that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import BUILD, COLOR, MANY, MID, MUST

_BLOCKS = "(?:blocks|cubes|bricks|ones)"
_BLOCK = "(?:block|cube|brick|one)"
_BE = f"(?:is|are|being|{MUST} be|stands|lies|sits)"
_RING = "(?:circle|ring)"
_PLUS = "(?:plus sign|plus shape|plus|cross)"
_WITHOUT = "(?: ,)? (?:not counting|without|not including) the (?:center|middle)(?: block| cube| one)?"
_ARMS = (f"(?:arms|each arm|each of (?:the |its )?(?:four )?arms)(?: that| which)?(?: is| are| being)?(?: of)? "
         f"({MANY}) "
         "(?:blocks|cubes)(?: long)?(?: each)?")  # fmt: skip

FIGURES: tuple[Turn, ...] = (
    # rings around something
    (f"^(?:{BUILD} )?({MANY} [^,:]*?{_BLOCKS}) (?:{MUST} )?(?:form |make |stand |are |lie |be )?(?:placed |arranged "
     f")?(?:in |into |as )?an? ({_RING}) (?:all )?(?:around|round) ((?:the|an?) [^,:]+)$", "a {2} of {1} around {3}"),
    (f"^(?:surround|encircle) ((?:the|an?) [^,:]+?) (?:with|by) an? ({_RING}) (?:of|made of|from) ({MANY} [^,:]+)$",
     "a {2} of {3} around {1}"),
    ("\\b(circle|ring|square|plus|cross|grid)\\b((?:(?! and ).)*?) (in|at) the (middle|center) of the \\1$",
     "{1} {2} {3} the {4}"),
    (f"\\b((?:circle|ring|square|outline|rectangle) .*?)(?: ,)? (with|and) ((?:the|an?) {COLOR}(?: {_BLOCK})?) "
     f"(?:inside|within)(?: ,)? in the ({MID})$", "{1} {2} {3} in the {4}"),
    # crosses
    (f"\\b({_PLUS}\\b[^:;]*?)(?: ,| :)?(?: with| where| and| whose)?(?: four)? {_ARMS}(?:{_WITHOUT})?$",
     "{1} with each arm of {2} blocks"),
    (f"^(.*\\b(?:five|5) [^,:]*?{_BLOCKS}) (?:on the table )?(?:in|like|as) an? ({_PLUS})(?: ,| :)? one in the {MID} "
     "and one (?:on|at|for) each (?:of the four |of its four |of the |of its )?(?:sides?|arms?|ends?)$",
     "{1} as a plus"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})?(?: ,| :)? (?:four|4)(?: of (?:them|these))? ({COLOR})(?: "
     f"{_BLOCKS})? and (?:the (?:one|block|cube) (?:in|at) the {MID}|the {MID} (?:one|block|cube)|the {MID}) "
     f"({COLOR})$", "{1} with a {3} center and {2} arms"),
    (f"\\b({_PLUS}) (?:of|from|out of|made of) (?:four|4) ({COLOR})(?: {_BLOCKS})? (?:and|with|around) (?:an?|one) "
     f"({COLOR})(?: {_BLOCK})?(?: (?:in|at|as|for) (?:the|its) {MID}| so that the \\3 (?:one|{_BLOCK}) (?:is|becomes|"
     f"forms|makes|{MUST} be) (?:its|the) {MID})$", "{1} with a {3} center and {2} arms"),
    (f"^{BUILD} (?:four|4) ({COLOR})(?: {_BLOCKS})? around an? ({COLOR})(?: {_BLOCK})? ,? ?(?:which|that|so that it|"
     f"so it|to) (?:gives?|makes?|forms?) an? ({_PLUS})(?: with an? \\2 {MID})?$",
     "a {3} with a {2} center and {1} arms"),
    (f"^an? ({COLOR}) (?:{_BLOCK}) {_BE} (?:in|at) the {MID} of an? ({_PLUS}) (?:whose|with) (?:the |its )?(?:four "
     f")?arms (?:are |of )?({COLOR})(?: {_BLOCKS})?$", "a {2} with a {1} center and {3} arms"),
    (f"\\b({_PLUS})(?: ,| :)? the {MID}(?: {_BLOCK})? {_BE} ({COLOR}) and the (?:four )?(?:{_BLOCKS}|others)(?: "
     f"all)?(?: around(?: it)?)? {_BE} ({COLOR})$", "{1} with a {2} center and {3} arms"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})(?: ,)? all(?: of them)? ({COLOR}) (?:but|except|apart from|"
     f"save)(?: for)? the (?:one (?:in|at) the {MID}|{MID} one|{MID})(?: ,)?(?: which is| being)? ({COLOR})$",
     "{1} with a {3} center and {2} arms"),
    # what lies on the middle
    (f"^(.*\\b(?:{_PLUS}|grid|square)\\b[^,]*?) (?:whose {MID}(?: {_BLOCK})? (?:carries|bears|holds|supports)|with "
     f"the {MID} (?:one|{_BLOCK}) (?:carrying|bearing|holding)) (?:the|an?) ({COLOR} {_BLOCK})$",
     "{1} with a {2} on its center"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
