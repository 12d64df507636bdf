"""The words that several towers are told in whose heights are compared, or which stand in an order."""

from __future__ import annotations

import re
from typing import Any

from rpg.language.frames.pieces import number, patterns
from rpg.language.frames.shared import BREAKS, GLUE

_T, _TS = "(?:tower|stack|pillar|pile)", "(?:towers|stacks|pillars|piles)"
_ADJ = "(?:(?:little|small|neat|separate|single|different|such|further) )"
_HIGH = "(?:high|tall|in height)"
_MOST = "tallest|highest|biggest|largest|taller|higher|bigger|larger"
_LEAST = "lowest|shortest|smallest|lower|shorter|smaller"
RANKS = {word: rank for rank, words in ((1, _MOST), (-1, _LEAST)) for word in words.split("|")}
"""Words for the one at an end of the order by height: 1 the highest, -1 the lowest."""
SIDES = {"left": ("left", 0), "right": ("left", -1), "front": ("front", 0), "near": ("front", 0), "back": ("front", -1),
         "rear": ("front", -1)}  # fmt: skip
"""The side at which the order of the towers begins, and the place in it of the one on this side."""
_END = "(?:leftmost|rightmost|left|right)"
_DO = "(?:stack|pile)(?: up)?(?= (?:(?:all|the|these|those|up) )*(?:NUM )?(?:COLOR )?BLOCK)"
"""What is done with blocks, no tower."""
_DET = "the other|the|another|a|an|one|other"
_ONE = "(?:one|of them)"
_SIDE = "left|right|front|back|rear"
_BY = r"(?P<by>NUM|a)(?: single)?(?: BLOCK| floors?| levels?)?"
_TIMES = "(?P<times>twice|double|NUM times)"
_OF_US = "(?:us|me|you|the (?:viewer|camera|robot|front))"


def _by(sign: int) -> Any:
    return lambda match: ("by", sign * number(match["by"] if match["by"] != "a" else "one"))


def _heights(match: re.Match[str]) -> list[int]:
    return [int(said) for said in re.findall(r"\d", match["list"])]


PATTERNS = [
    *patterns("towers", lambda match: (number(match["count"]) if match["count"] else None, match["color"]),
        f"(?:(?:all )?(?:in|into|as|of) )?(?:exactly )?(?:the |these )?(?:(?P<count>NUM) )?{_ADJ}*"
        f"(?:(?P<color>COLOR) )?{_TS}"),
    *patterns("tower", None,
        f"(?!{_DO})(?:(?P<det>{_DET}) )?{_ADJ}*(?:(?P<rank>{_MOST}|{_LEAST}) )?(?:(?P<color>COLOR) )?{_T}",
        f"(?:(?P<det>{_DET}) )(?:(?P<rank>{_MOST}|{_LEAST}) )?(?P<color>COLOR) one",
        f"the (?P<rank>{_MOST}|{_LEAST})(?: (?:one|{_T}))?(?: of (?:the NUM|them|the {_TS}))?(?! than)",
        f"(?P<det>the other|another|other)(?: one(?! BLOCK))?(?! (?:{_T}|ones|\\d))",
        f"(?:(?P<det>{_DET}) )?{_T} of (?P<color>COLOR) BLOCK",
        f"(?:the )?(?P<det>one)(?: of (?:them|the {_TS}))?"
        f"(?! (?:BLOCK|more|{_T}|{_MOST}|{_LEAST}|behind|above|of (?:the|these|those))\\b)",
        f"the (?:(?P<side>{_END})|(?P<middle>middle|center))(?: (?:one|{_T}))(?: of (?:the NUM|them|the {_TS}))?"),
    *patterns("group", lambda match: match["which"],
        f"the (?P<which>outer|inner|other)(?: (?P<many>[2-9]))?(?: ones| {_TS})?", "the (?P<which>other)s"),
    *patterns("looks", lambda match: re.findall(r"\b(?!and\b)[a-z]+", match["list"]),
        "(?:, |: |in )*(?P<list>COLOR(?:(?: ,)?(?: and)? COLOR)+)(?! (?:BLOCK|ones?)\\b)"),
    *patterns("it", None, "it|that one|that"),
    *patterns("heights", _heights,
        r"(?:of heights? |with heights? |heights? )?(?P<list>[1-9](?:(?: ,)?(?: and)? [1-9])+)(?: (?P<color>COLOR))?"
        f"(?: BLOCK)?(?: {_HIGH})?(?! (?:COLOR|SIZE|x|cm)\\b)"),
    *patterns("many", lambda match: number(match["count"]),
        rf"(?:(?:the|exactly|all|just|in total|a total of|some) )*(?P<count>NUM)(?: (?P<color>COLOR))? BLOCK"
        rf"(?P<high> {_HIGH})?(?P<each> (?:each|apiece))?(?: (?:in total|in all|altogether|overall))?(?! more)",
        rf"(?:exactly )?(?P<count>\d+)(?: (?P<color>COLOR))?(?P<high> {_HIGH})?(?P<each> (?:each|apiece))?"
        r"(?! (?:BLOCK|times|more|fewer|less|COLOR)\b)"),
    *patterns("compared", _by(1),
        rf"(?:BE )?(?:exactly |just )?{_BY} (?:higher|taller)", rf"(?:with |has |have )?(?:exactly |just )?{_BY} more"
        "(?: BLOCK)?"),
    *patterns("compared", _by(-1),
        rf"(?:BE )?(?:exactly |just )?{_BY} (?:lower|shorter)", rf"(?:with |has |have )?(?:exactly |just )?{_BY} "
        "(?:less|fewer)(?: BLOCK)?"),
    *patterns("compared", lambda match: ("times", number(match["times"].split()[0].replace("double", "2"))),
        rf"(?:BE )?(?:exactly )?{_TIMES} as {_HIGH}", rf"(?:BE )?(?:exactly )?{_TIMES} the height(?: of)?",
        rf"(?:has )?(?:exactly )?{_TIMES} as many BLOCK"),
    *patterns("compared", ("times", 1),
        f"(?:BE )?(?:just |exactly )?as {_HIGH}",
        "(?:BE |of |with |has |have |at )*the same (?:height|number of BLOCK)"),
    *patterns("compared", ("more", 1), "(?:BE )?(?:the )?(?:higher|taller)(?! one| tower| stack)"),
    *patterns("compared", ("more", -1), "(?:BE )?(?:the )?(?:lower|shorter)(?! one| tower| stack)"),
    *patterns("compared", ("most", 1), "(?:BE )?the (?:tallest|highest)(?= [,.;])"),
    *patterns("than", None, "than|as|compared to"),
    *patterns("unequal", None,
        "(?:(?:of|with|have|all|both|at|that) )*different heights", "not (?:equally|the same|of the same|of equal) "
        "(?:high|tall|height)", "(?:with )?no (?:two|2)(?: of them| of which)? (?:BE )?(?:equally (?:high|tall)|(?:of "
        "|the |same |equal )+height|as high as each other)", "(?:each|every one) (?:BE |of |with |has )*a different "
        "height", "all different in height", "(?:of|with) unequal heights?"),
    *patterns("bound", lambda match: (match["which"], number(match["count"])),
        f"(?:(?:with|and) )?(?:none|neither|no {_T})(?: of (?:them|which|these))? (?:BE )?(?P<which>lower|shorter|"
        "higher|taller) than (?P<count>NUM)(?: BLOCK)?",
        f"(?:(?:with|and) )?(?:none|neither|no {_T})(?: of (?:them|which|these))? (?:with|has|have|having|of) "
        "(?P<which>exactly) (?P<count>NUM)(?: BLOCK)?",
        f"each(?: of them)? (?P<which>at least|at most) (?P<count>NUM)(?: BLOCK)?(?: {_HIGH})?"),
    *patterns("side", lambda match: SIDES[match["side"]],
        rf"(?:BE )?(?:(?:placed|put) )?(?:on|at|to|in)(?: the)? (?:very |far )?(?P<side>{_SIDE})(?: (?:end|side|hand "
        r"side))?(?! (?:of|half|corner|edge)\b)"),
    *patterns("middle", None,
        "(?:BE )?(?:placed )?in (?:the )?(?:middle|center)(?! of)",
        "(?:BE )?(?:in )?between (?:the )?(?:(?:NUM|other) )*(?:others|ones|them)?(?! (?:a|the|NUM|COLOR)\\b)",
        "(?:BE )?between the other (?:two|2)(?: ones)?"),
    *patterns("rel", lambda match: ("left of", match["near"]),
        "(?:BE )?(?P<near>right |directly |immediately )?(?:(?:to|on|at) (?:the|its) )?left(?: of| (?=it))"),
    *patterns("rel", lambda match: ("right of", match["near"]),
        "(?:BE )?(?P<near>directly |immediately )?(?:(?:to|on|at) (?:the|its) )?right(?: of| (?=it))"),
    *patterns("rel", lambda match: ("behind", match["near"]), "(?:BE )?(?P<near>right |directly |immediately )?behind"),
    *patterns("rel", lambda match: ("in front of", match["near"]),
        "(?:BE )?(?P<near>right |directly |immediately )?in front of"),
    *patterns("rel", ("behind", None), f"(?:BE )?(?:farther|further)(?: away)? from {_OF_US} than"),
    *patterns("rel", ("in front of", None), f"(?:BE )?(?:nearer|closer) to {_OF_US} than"),
    *patterns("rel", lambda match: ("next to", match["near"]),
        "(?:BE )?(?P<near>right |directly |immediately )?(?:next to|beside)(?! each| one another)"),
    *patterns("mutual", None, "(?:BE )?(?:next to|beside) (?:each other|one another)|side by side"),
    *patterns("line", None, "(?:BE )?(?:lined up |standing )?(?:in|into) (?:a|one) (?:straight |single )?(?:row|line)"),
    *patterns("line", None, "line up|lined up"),
    *patterns("behind", None, "(?:BE )?one behind (?:the other|another)"),
    *patterns("way", lambda match: match["from"],
        "(?:(?:counted|counting|going|reading|read|seen) )?from (?:the )?(?P<from>left|right)(?: to (?:the )?(?:left|"
        "right))?", "(?:(?:counted|going) )?from (?:the )?(?P<from>front|back)(?: to (?:the )?(?:front|back))?"),
    *patterns("all used", lambda match: match.groupdict().get("count"),
        "(?:and )?all of (?:them|these)(?: (?:are|must be|should be|get))? used", "no BLOCK (?:is |are )?left over",
        "none of (?:the (?:(?P<count>NUM) )?BLOCK|them) (?:is|are|being) (?:left over|left|unused|spare)"),
    *patterns("glue", None, _DO),
    *patterns("glue", None, "(?:are )?available|(?:the )?(?:picture|image) shows"),
    *patterns("glue", None, "there is|there are|given|take|of which|when|where|so that|such that|has|have|"
        "having|exactly"),
    *BREAKS,
    *GLUE,
]  # fmt: skip
