"""One block on two or four others at once as people tell it, "a base of two by two, and one on top in the middle", "so
that it rests on both", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MID

_TWO = "(?:2x2|two by two|2 by 2|two times two|2 x 2)"
_THREE = "(?:3x3|three by three|3 by 3|three times three|3 x 3)"
_N = f"(?:{CUBE}s?|bricks?|ones?)"
_THEM = "(?:it|them|these|those|that|this|the base|the square)"
_AND = "(?: ,| and| with|;)+"
_IN_MID = f"(?:(?:right |exactly |directly )?(?:in|at|over|on) the {MID}(?: of {_THEM})?|centered|centrally)"
_ON_TOP = f"(?:on top(?: of {_THEM})?|on {_THEM}|above(?: {_THEM})?)"
_SO = "(?:(?:so|such) that it|which|that|and(?: it)?)"
_RESTS = (
    f"(?:{_SO} )?(?:is )?(?:rests?|resting|lies|lying|sits|sitting|stands|standing|supported)(?: equally| evenly)? "
    "(?:on|by|across)"
)
_ALL = "(both|all four)(?: of (?:them|these|those))?"

ON_SEVERAL_AT_ONCE: tuple[Turn, ...] = (
    (f"{_ON_TOP}(?: ,)?(?: {_IN_MID})?(?: ,)? {_RESTS} {_ALL}", "across {1} of them"),
    (f"\\b((?:an?|one|the)(?: single)? (?:{COLOR} )?{_N})(?: ,)? (?:{_RESTS}) {_ALL}$", "{1} across {2} of them"),
    (
        f"\\bon(?: top of)? (?:all )?(?:the )?four ((?:{COLOR} )?{_N})(?: ,)? (?:that|which) (?:form|make|make "
        f"up|are) an? "
        f"(?:{_TWO} )?(?:square|grid)\\b",
        "on all four {1}",
    ),
    (f"\\brests? on two (?:other )?((?:{COLOR} )?{_N})$", "is across two {1}"),
    (f"\\brests? on four (?:other )?((?:{COLOR} )?{_N})$", "is on all four {1}"),
    (f"\\b(?:resting on|supported by) two (?:other )?((?:{COLOR} )?{_N})$", "across two {1}"),
    (f"\\b(?:resting on|supported by) four (?:other )?((?:{COLOR} )?{_N})$", "on all four {1}"),
    (
        f"^an? bridge(?: ,| :| of| from| made of| out of)+ (two (?:{COLOR} )?{_N})(?: ,| and| with)+ (an? "
        f"(?:{COLOR} )?{_N}) "
        "(?:lying |resting |placed )?(?:on|on top of|over|across) (?:both(?: of them)?|them|the two)$",
        "{1} next to each other and {2} across them",
    ),
)
"""What is read otherwise, or not at all, as it stands."""
ON_SEVERAL: tuple[Turn, ...] = (
    # three layers, each smaller
    (
        f"^(?:an? )?(?:base|bottom layer) of {_THREE} ({COLOR}) {_N}{_AND} {_ON_TOP} {_TWO} ({COLOR}) {_N}{_AND} (?:on "
        f"(?:that|top of (?:that|those|them))|(?:on|at) (?:the )?(?:very )?top) (?:an?|one)(?: single)? "
        f"({COLOR}) {_N}$",
        "a pyramid with a three by three base , the bottom layer {1} , the middle layer {2} and the top {3}",
    ),
    # the base
    (
        f"\\b(?:an? )?(?:square )?(?:base|foundation|platform|bottom layer) (?:of|from|made of) {_TWO}(?: of)? "
        f"((?:{COLOR} )?{_N})",
        "a two by two square of {1}",
    ),
    (f"\\ban? {_TWO} (?:base|foundation|platform|bottom layer|layer) (?:of|from|made of) ", "a two by two square of "),
    # what lies on it
    (f"^(?!.*{_THREE})(.*\\b(?:{_TWO}|four)\\b.*?)(?: ,)? {_ON_TOP}(?: ,)? {_IN_MID}$", "{1} centered on top of them"),
    (f"^(?!.*{_THREE})(.*\\b(?:{_TWO}|four)\\b.*?)(?: ,)? {_IN_MID}(?: ,)? {_ON_TOP}$", "{1} centered on top of them"),
)
"""What makes no sense as it stands."""
WORDS = ("bridge foundation platform",)
"""Words that these take besides those that are read anyway."""
