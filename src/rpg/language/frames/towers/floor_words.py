"""The words that towers are told in floor by floor."""

from __future__ import annotations

import re
from typing import Any

from rpg.language import lexicon
from rpg.language.frames.pieces import number, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE
from rpg.language.frames.towers.words import PATTERNS as SEVERAL

T, TS = "(?:tower|stack|pillar)", "(?:towers|stacks|pillars)"
_N = "(?:block|cube|one|piece|element|color)"
_DET = "another|the other|the|a|an|one more|the only|only|exactly|just|its|both|all|both the|all the|again a|again"
_LOOK = r"(?P<size>SIZE|medium|medium sized) (?=COLOR|BLOCK|one)"
_FLOOR = "(?:floor|level|layer|storey|story|tier|position|place)"
_FROM = "(?:(?:counted |counting |seen )?(?:from|at) (?:the )?(?P<end>bottom|top))"
_ORD = "|".join(word for word in lexicon.ORDINAL if word.isalpha())
_ONES = f"(?: (?:BLOCK|ones|floors|levels|layers))?(?: (?:of|in) (?:it|the {T}))?"
_BOTTOM = "(?:bottom|lowest|bottommost|lowermost|undermost|lower|base)"
_TOP = "(?:top|highest|uppermost|topmost|upper)"
_MIDDLE = "(?:middle|central|center)"
_IT = "(?:it|that|this|them|those|these|that one|this one)"
_RIGHT = "(?:(?:directly|right|immediately|just|sitting|resting|standing|placed|stacked|put) )*"
_ADJ = (
    "(?:(?:little|small|neat|separate|identical|equal|single|own|different|similar|individual|short|tall|such|"
    "equally (?:high|tall)) )"
)
_LED = "(?:(?:going|reading|read|listed|counting|ordered|told|seen|and|in the order|in order|order|in this order) )*"


def _part(match: re.Match[str]) -> tuple[str, int | None]:
    """Which part of a tower so many blocks are; None where their number is left open."""
    said = match["part"]
    part = "middle" if re.fullmatch(_MIDDLE, said) else "bottom" if re.fullmatch(_BOTTOM, said) else "top"
    count = match.groupdict().get("count")
    return part, number(count) if count else None


def _nth(match: re.Match[str]) -> tuple[int, str | None]:
    """Which floor it is, and from which end it is counted, if that is told; any line has places."""
    said = match["nth"]
    counted = match.groupdict().get("floor") not in {None, "position", "place"}
    end = match.groupdict().get("end") or ("bottom" if counted else None)
    return lexicon.ORDINAL[said] if said in lexicon.ORDINAL else number(said), end


def _single(part: str) -> Any:
    return lambda match: (part, 1)


PATTERNS = [
    *patterns("item", None,
        rf"(?:(?P<det>{_DET}) )?(?:(?P<count>NUM) )?(?:{_LOOK})?(?:plain )?(?P<color>COLOR)(?P<many>s)?(?: (?P<noun>"
        rf"BLOCK|ones|one(?! (?:SIZE )?COLOR)))?(?: (?:again|too|once more))?",
        r"(?:(?P<det>another|the other|the|a|an) )?(?P<size>SIZE|medium|medium sized) (?P<noun>BLOCK|one)",
        r"(?:(?:the|an?) )?(?:(?:letter|BLOCK) )*(?P<glyph>[A-Z])(?! (?:see|want|need|would|can|like|have|will|am) )"
        r"(?: BLOCK)?"),
    *patterns("total", lambda match: number(match["count"]),
        r"(?:of |from |with |using |has |have )?(?:the |all |exactly )?(?P<count>NUM) (?:identical |plain |single |"
        r"stacked )?BLOCK(?: (?:in total|in all|altogether|overall|high|tall|in height|(?:stacked )?on top of (?:each "
        r"other|one another)))?", r"(?P<count>NUM) (?:in total|in all|altogether|overall|high|tall|floors|levels|"
        r"layers|storeys|stories)", r"(?:with )?(?:a |of )?height (?:of |: |is )?(?P<count>NUM)(?: BLOCK)?",
        r"of (?:exactly )?(?P<count>NUM)(?= [,.;:(])"),
    *patterns("towers", lambda match: [number(match[name]) if match[name] else None for name in ("count", "size")],
        f"(?:(?:the|both|exactly) )?(?:(?P<count>NUM) )?{_ADJ}*{TS}"
        "(?: (?:of|with) (?P<size>[2-9])(?: BLOCK)?(?: (?:high|tall))?(?: each)?(?! (?:SIZE |COLOR)))?",
        f"(?:(?P<count>[2-9]) )(?P<size>[2-9]) BLOCK (?:high )?{TS}"),
    *patterns("size", lambda match: number(match["size"]),
        "(?:BE )?(?:each|both|each of (?:them|which)|all)"
        "(?: BE| has| have| of| with| made of| consisting of| exactly)* "
        "(?P<size>[2-9])(?: BLOCK)?(?: (?:high|tall))?(?! (?:SIZE |COLOR))",
        "(?:of |with )?(?P<size>[2-9]) (?:BLOCK )?(?:high |tall )?(?:each|apiece)"),
    *patterns("same", None,
        "(?:in |with |of |have |has )*(?:the )?(?:same|identical) (?:color )?(?:order|colors|way|pattern|sequence)",
        f"identical|alike|in both|in each(?: {T}| one| of them)?",
        f"(?:each|both|every {T})(?: of them)?(?: with| has| have| having| consisting of| made of)?"),
    *patterns("slot", lambda match: match["which"],
        f"(?P<which>a second|a third|a|another|one|(?:the |an )?other|(?:the )?(?:{_ORD})) {_ADJ}*{T}",
        "(?:the )?tower (?P<which>[A-E1-5])(?= (?:consists|has|is|BE|:|\\(|of|with|from))",
        f"(?:the )?{T} (?P<which>[A-E1-5])(?= (?:consists|has|is|BE|:|\\())",
        "(?P<which>one|the other|another|(?:the )?other one|a second one|another one)(?! of (?:the|these|those) )"
        "(?= (?:of|in|with|from|has|is|consists|made|BE|:|,|\\())"),
    *patterns("side", lambda match: match["side"],
        f"(?:(?:BE )?(?:to|on|at) )?(?:the )?(?P<side>left|right)(?: (?:hand )?(?:side|one|{T}))?(?! (?:of|half|side))",
        f"the (?P<side>middle|center|central) {T}"),
    *patterns("rel", lambda match: match["rel"],
        f"(?:BE )?{_RIGHT}(?P<rel>next to|beside|behind|in front of|(?:(?:to|on) the )?(?:left|right) of|to its left|"
        f"to its right) (?:it|that|that one|that {T}|this one|the first|the first one|the first {T}|the other|"
        f"the other one|the other {T})"),
    *patterns("ahead", lambda match: match["rel"],
        f"(?:BE )?{_RIGHT}(?P<rel>next to|beside|behind|in front of|(?:(?:to|on) the )?(?:left|right) of)"
        f"(?= (?:a|one) {_ADJ}*{T})"),
    *patterns("relation", lambda match: (match["one"], match["rel"], match["other"]),
        f"(?:the )?(?:{T} )?(?P<one>first|second|third|[A-E1-5])(?: {T}| one)? "
        f"BE {_RIGHT}(?P<rel>next to|beside|behind|in front of|(?:to the )?(?:left|right) of) "
        f"(?:the )?(?:{T} )?(?P<other>first|second|third|[A-E1-5])(?: {T}| one)?"),
    *(pattern for pattern in SEVERAL if pattern.kind in ("near", "line") and pattern.value != "next to it"),
    *patterns("reversed", None, "(?:(?:it is|is|exactly|just) )*(?:the other way (?:round|around)|the reverse|"
        "the opposite|(?:in )?(?:the )?(?:reverse|reversed|opposite) order|reversed|upside down)"),
    *patterns("across", None, "(?:reading |read |going |seen )?(?:from )?(?:the )?left to (?:the )?right(?: :)?"),
    *patterns("figure", None, f"(?:one |single |tall |little |small |nice |vertical |a |the |this |such )*{T}",
        "stacked|vertically|on top of (?:each other|one another)|(?:one )?on top of the other|(?:stack|pile) "
        "(?:them|these|all of them|everything)(?: up)?(?: like this)?", "(?:in|as|into) (?:a|one|the) (?:single )?"
        f"{T}"),
    *patterns("part", _single("bottom"),
        "(?:BE )?(?:(?:right|all the way) )?(?:down )?(?:at|on|as|in|forming|for) (?:the |its |a )?(?:very )?(?:bottom|"
        f"base|foundation|ground|lowest place|bottom {_N}|ground floor|foot)(?: of (?:it|the {T}))?",
        f"(?:BE )?(?:the |its )?(?:very )?{_BOTTOM}(?: {_N}| {_FLOOR})?(?: of (?:it|the {T}))?",
        "(?:the |its )?(?:ground floor|foundation|base|foot)", "(?:at|on) bottom"),
    *patterns("part", _single("top"),
        f"(?:BE )?(?:right )?(?:on|at|as|for) (?:(?:the |its |a )?(?:very )?)?(?:top|top {_N}|summit|crown)"
        f"(?: of (?:the {T}|all|everything))?(?! of)",
        f"(?:BE )?(?:the |its )?(?:very )?{_TOP}(?: {_N}| {_FLOOR})?(?: of (?:it|the {T}))?(?! of)",
        "(?:as )?(?:the |a )?(?:crown|roof|cap|tip)", "(?:topped|capped|crowned)(?: off)? (?:with|by)"),
    *patterns("part", _single("middle"),
        f"(?:BE )?(?:sandwiched )?(?:right |exactly )?(?:in|at|for|as) (?:the |its )?(?:very |exact )?{_MIDDLE}(?: "
        f"{_N}| {_FLOOR})?(?: of (?:it|the {T}))?(?! of)", f"(?:BE )?(?:the |its )?{_MIDDLE}(?: {_N}| {_FLOOR})?"),
    *patterns("part", lambda match: ("middle", None),
        "(?:BE )?(?:sandwiched |lying |sitting )?(?:in )?between(?: (?:them|these|those|(?:the|these) 2))?"
        "(?! (?:(?:the|2|NUM) )*(?:SIZE |COLOR|ones|BLOCK))",
        f"(?:BE )?(?:the |those )?{_MIDDLE} (?:ones|BLOCK)|the inner(?: ones| BLOCK)?"),
    *patterns("half", _part,
        f"(?:in )?(?:the |its |whose )?(?P<part>bottom|top|lower|upper) half(?: of (?:it|the {T}))?"),
    *patterns("part", _part,
        f"(?:the )?(?P<part>{_BOTTOM}|{_TOP}|{_MIDDLE}) (?P<count>[2-9]){_ONES}",
        f"the (?P<count>[2-9]) (?P<part>{_BOTTOM}|{_TOP}|{_MIDDLE}){_ONES}",
        "(?:the )?(?P<count>[2-9]) (?:BLOCK |ones )?(?:at|in|on) (?:the )?(?P<part>bottom|top|middle|center)"),
    *patterns("ends", None,
        "(?:at|on) (?:both|the two|the 2|either|each) ends?|(?:(?:the|both|2|its) )*ends|the outer (?:ones|2|BLOCK)",
        "(?:the )?first and (?:the )?last(?: ones| BLOCK)?",
        "(?:both )?(?:at |on )?(?:the )?(?:top and(?: at)?(?: the)? bottom|bottom and(?: at)?(?: the)? top)"
        "(?: (?:BLOCK|ones))?"),
    *patterns("nth", _nth,
        f"(?:BE )?(?:on |in |at |as )?(?:the )?(?P<nth>{_ORD})(?: {_N})? {_FROM}",
        f"(?:BE )?(?:on |in |at |as )?(?:the )?(?P<nth>{_ORD}) (?P<floor>{_FLOOR})(?: {_FROM})?(?: of the {T})?",
        f"(?:on |in |at )?(?P<floor>{_FLOOR}) (?P<nth>[1-9]|one)(?: {_FROM})?",
        f"(?:BE )?(?:the )?(?P<nth>{_ORD})(?: {_N})?"),
    *patterns("upon", None, f"(?:BE )?{_RIGHT}(?:(?:on|on top of|onto|over|above|atop) {_IT}|on top of that one)",
        "thereon|on top again"),
    *patterns("under", None, f"(?:BE )?{_RIGHT}(?:under|below|beneath|underneath) {_IT}"),
    *patterns("between", None, "(?:BE )?(?:in )?between(?= (?:(?:the|2) )+(?:SIZE |COLOR))"),
    *patterns("over", None,
        f"(?:BE )?{_RIGHT}(?:on|upon|over|on top of|above|atop|onto)(?= (?:the|an?|one|NUM|COLOR|[A-Z]) )",
        "above|over"),
    *patterns("below", None, f"(?:BE )?{_RIGHT}(?:under|below|beneath|underneath)"),
    *patterns("then", None,
        "(?:and )?(?:then|next(?! to)|after that|after this|afterwards|followed by|finally|lastly|at last|then again|"
        "last)"
        "(?: (?:comes?|follows?|there (?:is|are)|we have|by|goes?))?"),
    *patterns("way", "up", f"{_LED}(?:from )?(?:the )?(?:bottom|base|ground) (?:end )?(?:to (?:the )?top|up(?:wards)?)",
        f"{_LED}(?:going )?upwards?", "(?:starting|beginning) (?:at|from) the (?:bottom|base)",
        "from (?:the )?bottom(?= [:,)])"),
    *patterns("way", "up", f"{_LED}from (?:the )?lowest(?: {_N})? to (?:the )?highest (?:{_N}|{_FLOOR})"),
    *patterns("way", "down", f"{_LED}from (?:the )?highest(?: {_N})? to (?:the )?lowest (?:{_N}|{_FLOOR})"),
    *patterns("way", "down", f"{_LED}(?:from )?(?:the )?top (?:end )?(?:to (?:the )?bottom|down(?:wards)?)",
        f"{_LED}(?:going )?downwards?", "(?:starting|beginning) (?:at|from) the top", "from (?:the )?top(?= [:,)])"),
    *patterns("first", None, "(?:which |that )?(?:starting|beginning|begins|starts|start|begin) with"),
    *patterns("every", None, f"all (?:of )?(?:(?:the|its) )?BLOCK(?: (?:in|of) (?:it|the {T}))?|everything(?: in it)?"),
    *patterns("rest", lambda match: number(match["count"]) if match.groupdict().get("count") else None,
        "(?:all )?(?:of )?(?:the |its )?(?:others|other ones|other BLOCK|rest|remaining(?: ones| "
        "BLOCK)?|remainder|rest of it|other (?P<count>[2-9])(?: ones| BLOCK)?)", "everything else|all other "
        f"BLOCK|(?:on )?(?:all )?(?:of )?(?:the )?(?:other|remaining) {_FLOOR}s"),
    *patterns("absent", lambda match: match["color"],
        "(?:(?:must|should|may|does|do|shall|can) not (?:contain|have|include)|contains no) (?:any |an? )?"
        "(?P<color>COLOR)(?: BLOCK| ones?)?",
        "(?:(?:there )?BE )?(?:no|without|without any|not any) (?P<color>COLOR)(?: BLOCK| ones?)?"
        f"(?: (?:BE|may be|appears?))?(?: (?:in|on|part of) (?:it|the {T}))?"),
    *patterns("alternating", None,
        "(?:in |with |of )?(?:strictly )?(?:alternating|alternate|alternately|alternates)(?: colors| order| pattern)?",
        "(?:its |the )?colors (?:alternate|alternating|take turns)|by turns"),
    *patterns("table", None, "(?:BE )?(?:put |placed |directly |right |flat )*(?:on|upon|onto) the TABLE"),
    *WHERE,
    *BREAKS,
    *patterns("except", None, "(?:, )?(?:except|except for|apart from|other than|besides)"),
    *patterns("break", None, "[()/=-]|so|so that|such that|in which|whose|having|has|have"),
    *patterns("glue", None, "with letters|the (?:robot|arm|gripper)|, which BE",
        "(?:its|the) colors?|also|itself|it|we|they|come|comes|goes|go|sits|follow|follows|stack|"
        "pile|pile up|stack up|there|order|colors?|showing|reading|appear|in (?:this|the) order|going|colored|"
        "a sandwich|sandwich|being|like this|like so|as follows|the following|following|consists of|which has|"
        "that has"),
    *GLUE,
]  # fmt: skip
