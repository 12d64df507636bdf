"""The words that it is told in which colours each of several towers of one height has."""

from __future__ import annotations

from rpg.language.frames.pieces import number, patterns
from rpg.language.frames.shared import BREAKS, GLUE

_T, _TS = "(?:tower|stack|pillar)", "(?:towers|stacks|pillars)"
_ADJ = "(?:(?:little|small|neat|separate|single|different|such|equal) )"
_OF = f"(?: of (?:them|which|these|the (?:NUM )?{_TS}))"
_HAS = "(?:(?:has|have|having|with|is|are|be|of|in|must|should|shall|being|built|made|from|always) )*"
_A = "(?:(?:a|an|one|the|its) )?"
_BLOCK = "(?: BLOCK| one)?"
_ONE = ("a ", "an ", "one ")
_TOP = "(?:(?:always )?(?:on|at) (?:the |its )?top)"
_BOTTOM = "(?:(?:always )?(?:at|on|in) (?:the |its )?(?:bottom|base))"
_ALL = "(?:all|only|entirely|completely|purely)"
_ONE_COLOR = "(?:(?:a|one|only|just|the) )*(?:single|one|same) color(?: only| alone)?"
_ENDS = (
    "(?:top(?: BLOCK)? and (?:the )?bottom|bottom(?: BLOCK)? and (?:the )?top)(?: BLOCK| ones)?"
    "(?: of (?:it|the tower|the stack))?"
)

PATTERNS = [
    *patterns("towers", lambda match: number(match["count"]) if match["count"] else 0,
        f"(?:in |into |as )?(?:exactly )?(?:(?P<count>NUM) )?{_ADJ}*{_TS}"),
    *patterns("towers", 1, f"(?:in |into |as )?(?:a |one )?(?:single |tall |vertical )*{_T}"),
    *patterns("size", lambda match: number(match["size"]),
        r"of (?P<size>[2-9])(?: BLOCK)?(?: each)?(?! (?:COLOR|SIZE|cm)\b)",
        r"(?:each |both |all )?(?P<size>[2-9])(?: BLOCK)? (?:high|tall)(?: each)?", r"(?P<size>[2-9]) BLOCK each",
        rf"(?:each|every)(?: {_T})? (?:has|of|with) (?P<size>[2-9])(?: BLOCK)?(?! COLOR\b)"),
    *patterns("lot", lambda match: (match["color"], number(match["count"])),
        r"(?:the |these )?(?P<count>NUM) (?P<color>COLOR)(?:s|(?: BLOCK| ones| one)\b)?(?! (?:on|at|top)\b)"),
    *patterns("who", ("each", 0),
        f"(?:in |on |of |with )?(?:each|every one|every|all|both)(?: {_T}| {_TS}| one)?{_OF}?"),
    *patterns("who", ("none", 0), f"(?:none|neither|no {_T}|not one)(?: {_T})?{_OF}?(?: may| can)?"),
    *patterns("who", lambda match: ("exactly", number(match["count"])),
        f"(?:only|exactly|just) (?:in |on )?(?P<count>NUM)(?: {_T}| {_TS})?{_OF}?"),
    *patterns("who", ("slot", 0),
        f"(?:one|another|the other)(?: {_T}| one)?(?: of (?:them|the {_TS}))?(?! BLOCK)"),
    *patterns("who", ("rest", 0), "the (?:other|remaining)(?: NUM| ones)|the (?:others|rest)"),
    *patterns("told", lambda match: ("top", f"{match['color']}{'' if match['one'] in _ONE else ' bare'}"),
        f"{_HAS}(?P<one>{_A})(?P<color>COLOR){_BLOCK} (?:is )?{_TOP}"),
    *patterns("told", lambda match: ("top", match["color"]),
        f"{_HAS}{_A}(?P<color>COLOR) top",
        f"tops?(?: BE)?(?: all)? (?P<color>COLOR){_BLOCK}"),
    *patterns("told", lambda match: ("bottom", f"{match['color']}{'' if match['one'] in _ONE else ' bare'}"),
        f"{_HAS}(?P<one>{_A})(?P<color>COLOR){_BLOCK} (?:is )?{_BOTTOM}"),
    *patterns("told", lambda match: ("bottom", match["color"]),
        f"{_HAS}{_A}(?P<color>COLOR) bottom",
        f"bottoms?(?: BE)?(?: all)? (?P<color>COLOR){_BLOCK}"),
    *patterns("denied", lambda match: (match["end"], match["color"]),
        f"(?:with |has |have )?no (?P<color>COLOR){_BLOCK} (?:is |may be )?(?:on|at) (?:the |its )?"
        "(?P<end>top|bottom)"),
    *patterns("told", ("single", ""), f"{_HAS}{_ONE_COLOR}"),
    *patterns("told", ("mixed", ""), f"{_HAS}(?:mixed|more than one color|two colors|2 colors|different colors)"),
    *patterns("told", ("every", ""),
        f"{_HAS}(?:both|all)(?: NUM)?(?: of the)? colors", f"{_HAS}a BLOCK (?:of|in) (?:each|either|every) color"),
    *patterns("told", ("ends", "same"),
        f"(?:the |with )*{_ENDS} (?:BE |have |has |of |in )*(?:the )?(?:same|equal) colors?",
        "(?:with )?the same color (?:at|on) (?:the )?(?:top and (?:at )?(?:the )?bottom|both ends|bottom and (?:on )?"
        "(?:the )?top)"),
    *patterns("told", ("ends", "different"),
        f"(?:the |with )*{_ENDS} (?:BE |have |has |of |in )*(?:different|unequal|two different) colors?"),
    *patterns("told", ("turns", ""),
        "(?:the )?colors? (?:taking turns|take turns|takes turns|alternate|alternating)",
        "(?:in )?(?:strictly )?(?:alternating colors|alternating|alternation)"),
    *patterns("denied", lambda match: (match["end"], match["color"]),
        r"(?:the |with )*(?P<color>COLOR)(?: BLOCK| one)? (?:is |must |may |should |can )*(?:be )?(?:not|never) "
        r"(?:be )?(?:on|at) (?:the )?(?P<end>top|bottom)",
        r"(?:the )?(?P<color>COLOR)(?: BLOCK| one)? anywhere but (?:on|at) (?:the )?(?P<end>top|bottom)"),
    *patterns("told", ("one each", ""),
        f"{_HAS}(?:exactly )?one (?:BLOCK )?(?:of|in) (?:each|either|every)(?: of the NUM)? color(?: in each)?"),
    *patterns("told", lambda match: ("plain", match["color"]), f"{_HAS}{_ALL} (?P<color>COLOR)(?: BLOCK)?"),
    *patterns("told", lambda match: ("capped", f"{match['color']} {match['cap']}"),
        f"{_HAS}(?:{_ALL} )?(?P<color>COLOR) with {_A}(?P<cap>COLOR)(?: top|{_BLOCK} {_TOP})"),
    *patterns("told", lambda match: ("more", f"{match['color']} {number(match['count'])}"),
        f"{_HAS}more than (?P<count>NUM) (?P<color>COLOR){_BLOCK}"),
    *patterns("told", lambda match: ("exactly", f"{match['color']} 1"),
        f"{_HAS}(?:exactly |just |only )?(?:a|one|a single) (?P<color>COLOR){_BLOCK}(?! (?:on|at|top|bottom)\\b)"),
    *patterns("glue", None, "we have|i have|there are|out of|from|always|a|it|so that|such that"),
    *BREAKS,
    *GLUE,
]  # fmt: skip
