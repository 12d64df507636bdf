"""The words of staircases: steps and heights, which way they rise, and places in them."""

from __future__ import annotations

import re

from rpg.language.frames.lots import LOTS
from rpg.language.frames.pieces import Pattern, number, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE

_COLUMN = "(?:steps|columns?|treads?|stacks?|towers?|levels?)"
_STEP = "(?:steps?|stairs?|columns?|treads?|stacks?|towers?|levels?)"
_PILE = "(?:first )?(?:an? (?:stack|tower|pile|column) of )?"
_HEIGHT = rf"{_PILE}(?:\d+|one|a|an)(?: single)?(?: BLOCK)?(?: (?:high|tall|stacked))?(?: BLOCK)?(?: {_STEP})?"
_SEP = (
    "(?: ,| ;| and| plus| then| next| after that| afterwards| followed by| beside it| beside that| next to it| next to "
    "that|next to those|next to them|next to these|beside those|beside them)+"
)
_BE = "(?:(?:BE|has|have|with|of|:) )*"
_LIST = rf"(?:{_HEIGHT}(?:(?:{_SEP})? {_HEIGHT}){{2,}}|{_HEIGHT}{_SEP} {_HEIGHT}(?! COLOR))"
_RISE = (
    "(?:(?:that|which|it|should|must|shall|has to|and) )*(?:(?:BE|that is|which is) )?"
    "(?:rising|rises?|going up|goes? up|climbing|climbs?|climb up|climbing up|ascending|ascends?|leading up|leads? up|"
    "ascend|climb|running up|runs? up|stepping up|steps? up|walking up|growing|grows?|mounting|mounts?|upwards?|up|"
    "uphill|"
    "get higher|gets higher|getting higher)"
)
_FALL = (
    "(?:(?:that|which|it|should|must|shall|has to|and) )*(?:(?:BE|that is|which is) )?"
    "(?:descending|descends?|going down|goes? down|leading down|leads? down|falling|falls?|dropping|drops?|"
    "stepping down|steps? down|running down|runs? down|down|downwards?|downhill|get lower|gets lower|getting lower)"
)
_SIDES = {
    "left": "left(?: hand)?(?: side| end)?",
    "right": "right(?: hand)?(?: side| end)?",
    "front": "(?:front|near(?:er)?)(?: side| end| edge)?",
    "back": "(?:back|rear|far(?:ther)?)(?: side| end| edge)?",
}
OVER = {"left": "right", "right": "left", "front": "back", "back": "front"}
_AWAY = "(?:away )?from (?:me|us|you|the (?:robot|viewer|camera))"
_NEAR = "(?:me|us|you|the (?:robot|viewer|camera))"
_HIGH = "(?:highest|tallest|top|topmost|biggest|high|tall|last|upper)"
_LOW = "(?:lowest|shortest|smallest|bottom|low|short|first|lower)"
_THE = "(?:(?:with|and|where) )?(?:(?:the|its|whose|a) )?"
NTH = ("first", "second", "third", "fourth")
_END = f"(?: (?:{_STEP}|one|end|side|BLOCK|part))?(?: of it)?"
_AT = "(?:BE )?(?:(?:on|at|to|towards?) )(?:the |its |my )?"


def _toward(side: str) -> str:
    """Words for a direction."""
    other = OVER[side]
    ways = f"(?:to|towards?) (?:the |my )?{_SIDES[side]}(?! of)"
    ways += f"|(?:from )?(?:the )?{_SIDES[other]} to (?:the )?{_SIDES[side]}"
    ways += f"|{side}wards?" if side in ("left", "right") else ""
    ways += {"back": f"|{_AWAY}", "front": f"|towards? {_NEAR}"}.get(side, "")
    return f"(?:{ways})"


def _heights(match: re.Match[str]) -> tuple[int, ...]:
    """The numbers of a list of heights."""
    said = re.findall(r"\b(?:\d+|one|an?)\b(?! (?:single|stack|tower|pile|column))", match["list"])
    return tuple(int(word) if word.isdigit() else 1 for word in said)


def _counts(*texts: str) -> list[Pattern]:
    """Ways to tell how many steps there are."""
    return patterns("steps", lambda match: number(match["count"]), *texts)


_WAYS = [
    found
    for side, other in OVER.items()
    for found in (
        *patterns("way", side,
            f"{_RISE}(?: (?:in|by) {_STEP})? {_toward(side)}", f"{_FALL} {_toward(other)}",
            f"{_toward(side)} (?:upwards?|up)",
            f"(?:which |that )?(?:going|goes|go|leading|leads|heading|running) (?:to|towards?) the {_SIDES[side]}(?! "
            f"(?:of|down))",
            *{"back": [f"(?:which |that )?(?:leading|leads|running|runs) {_AWAY}"],
              "front": [f"(?:which |that )?(?:leading|leads|running|runs) towards? {_NEAR}"]}.get(side, []),
            f"(?:the |its )?(?:direction of (?:the )?(?:ascent|rise|climb|climbing)|(?:rise|ascent|climb|climbing|"
            f"upward) direction) (?:BE |: )?{_toward(side)}",
            f"{_THE}{_HIGH}{_END} (?:{_AT})?(?:very |far )?{_SIDES[side]}",
            f"{_THE}{_LOW}{_END} (?:{_AT})?(?:very |far )?{_SIDES[other]}"),
        *patterns("top", lambda match, side=side: (number(match["count"]), side),
            f"{_THE}{_HIGH}{_END} {_AT}(?:very )?{_SIDES[side]}(?: ,)? and (?:BE|has|counts) (?P<count>NUM)(?: BLOCK)?"
            "(?: high| tall)?(?! COLOR)",
            f"{_THE}{_HIGH}{_END} (?:BE |has |have |having |with |of |counts |measures |height )*(?P<count>NUM)(?: "
            f"BLOCK)?"
            f"(?: high| tall| in height)?(?: ,)?(?: and)?(?: it)? {_AT}(?:very |far )?{_SIDES[side]}"),
        *patterns("order", side, f"{_SIDES[other]} to (?:the )?{_SIDES[side]}",
            f"(?:counted |listed |read |told )?{_toward(side)}(?= [,:]| (?:one|NUM|a) )",
            f"(?:{_LOW} to {_HIGH} )?from (?:the )?{_SIDES[other]} to (?:the )?{_SIDES[side]}"),
        *patterns("end", lambda match, side=side: (number(match["count"]), side),
            f"(?:BE )?(?P<count>NUM)(?: BLOCK)?(?: high| tall)? (?:on|at) the (?:very )?{_SIDES[side]}"),
    )
]  # fmt: skip
PATTERNS: list[Pattern] = [
    *LOTS,
    *WHERE,
    *BREAKS,
    *GLUE,
    *patterns("borne", None, f"(?:put|place|set|rest|lay|add) (?:a |the |one )?COLOR(?: BLOCK| one)? (?:up)?on(?:to)? "
        f"(?:top of )?{_THE}(?:{_LOW}|middle) {_STEP}"),
    *patterns("figure", "staircase",
        "(?:(?:flight|set|row) of )?(?:stairs?|stairways?|staircases?|stair case)(?: (?:shape|shaped|form|"
        "formation|structure|"
        "figure|pattern))?", "(?:flight|set) of steps", "(?:flight|set) of(?= NUM steps )", "steps(?! (?:of )?(?:the|"
        "which))"),
    *_counts(
        f"(?:in )?(?P<count>NUM) (?:BLOCK )?{_STEP}(?! (?:high|tall))", "steps : (?P<count>NUM)(?! ,)(?! BLOCK ,)",
        "(?:steps|stairs) ,? ?(?P<count>NUM) of (?:them|those)",
        "(?P<count>NUM) (?:steps?|stepped|level)(?= (?:stair|flight))",
        f"(?P<count>NUM)(?: {_STEP}| BLOCK)? (?:high|tall|long|wide|in height|in length)",
        f"{_THE}{_HIGH}{_END} (?:BE |has |have |having |with |of |counts |measures |height )*(?P<count>NUM)(?: BLOCK)?"
        "(?: high| tall| in height)?(?! COLOR)",
        f"(?P<count>NUM)(?: BLOCK)?(?: high| tall)? (?:on|at) (?:the|its) {_HIGH}{_END}",
        "(?:with )?(?:a |its )?(?:total |maximum |maximal |max )?height (?:of |is |: )?(?P<count>NUM)(?: BLOCK)?"),
    *patterns("low", None,
        f"{_THE}{_LOW}{_END} (?:BE |has |have |having |with |of |counts |measures |height )*(?:one|a single|1)"
        "(?: BLOCK)?(?: high| tall| in height)?(?! COLOR)"),
    *patterns("heights", _heights,
        rf"(?:(?:with|in|of|the|its|whose) )*(?:{_COLUMN} )?(?:(?:BE|has|have|having|with|of|in) )*(?:the )?heights?"
        rf"(?: (?:BE|of|:))*(?: (?:steps?|columns?))? (?P<list>{_LIST})",
        rf"(?:(?:with|in|of|the|its|whose) )*{_COLUMN}(?: (?:BE|has|have|having|with|of|:))* (?P<list>{_LIST})",
        f"(?:(?:where|in which|with|whose|so that) )?(?P<list>(?:the |its )?first(?: {_STEP})? "
        f"{_BE}{_HEIGHT}(?:(?:{_SEP})? (?:the |its )?(?:second|third|"
        "fourth|next|"
        f"last)(?: {_STEP})? {_BE}{_HEIGHT})+)",
        rf"(?:of |with |in )?(?P<list>{_LIST})(?: in (?:height|each))?(?: per {_STEP})?"),
    *_WAYS,
    *patterns("place", "over it",
        "(?:BE )?(?:on|onto|on top of|upon|atop|at the top of) (?:the|its|this) (?:very )?(?:highest|tallest|top|"
        f"topmost|last) {_STEP}(?: of (?:it|the stairs?|the staircase))?"),
    *(found for n, nth in enumerate(NTH) for found in patterns("place", f"{nth} step",
        f"(?:(?:in|at|as|for) )?{_THE}{nth} {_STEP}", f"{_THE}{nth}(?: one)?(?= (?::|BE|(?:all )?COLOR|\\)))",
        f"{_STEP} (?:number )?{n + 1}(?= (?::|BE|(?:all )?COLOR|\\)))")),
    *patterns("place", "highest step", f"(?:(?:in|at|as|for) )?{_THE}last {_STEP}", f"{_THE}last(?: one)?(?= (?::|BE|"
        f"(?:all )?COLOR|\\)))"),
    *patterns("place", "highest step", f"{_THE}(?:highest|tallest|top|topmost|biggest)(?: one)?(?= (?::|BE|(?:all "
        f")?COLOR|\\)))"),
    *patterns("place", "lowest step", f"{_THE}(?:lowest|shortest|smallest|bottom)(?: one)?(?= (?::|BE|(?:all "
        f")?COLOR|\\)))"),
    *patterns("place", "middle step", f"{_THE}(?:middle|center)(?: one)?(?= (?::|BE|(?:all )?COLOR|\\)))"),
    *patterns("place", "highest step", f"(?:(?:in|at|as|for) )?{_THE}(?:highest|tallest|top|topmost|biggest) {_STEP}"),
    *patterns("place", "lowest step", f"(?:(?:in|at|as|for) )?{_THE}(?:lowest|shortest|smallest|bottom) {_STEP}"),
    *patterns("place", "middle step", f"(?:(?:in|at|as|for) )?{_THE}(?:middle|center) {_STEP}",
        f"{_THE}{_STEP} in the (?:middle|center)"),
    *patterns("place", "top block of the highest step",
        f"{_THE}(?:top|topmost|highest|uppermost) BLOCK(?: (?:of|on) (?:the|its) (?:highest|tallest|top) {_STEP})?"),
    *patterns("place", "rest", "(?:all )?(?:of )?(?:the |its )?(?:rest|others|other ones|other BLOCK|remaining ones|"
        f"remaining BLOCK|remainder|other {_STEP}|remaining {_STEP})(?: of (?:it|them))?", "everything else"),
    *patterns("lot", None, "(?:all|every one|each one|everything|each BLOCK|every BLOCK)(?: of (?:them|these|it|the "
        "BLOCK)| BLOCK)?(?: (?:BE|in))? (?P<color>COLOR)(?! (?:except|apart|save))"),
    *patterns("lot", None,
        "(?:in )?(?:all |only |just |completely |entirely )(?:in )?(?P<color>COLOR)(?: throughout)?"),
    *patterns("hues", lambda match: re.findall(r"[a-z]+", match["hues"].replace(" and", "").replace(" then", "")),
        "(?:(?:and|with|in|the|their|its) )*colors? (?:(?:BE|go|goes|run|runs|should|must|will|:|in order|in that "
        "order) )*"
        "(?P<hues>COLOR(?:(?: ,| and| then)* COLOR)+)(?: (?:respectively|in (?:this|that) order))?",
        "(?:in )?(?P<hues>COLOR(?:(?: ,| and)* COLOR)+)(?: BLOCK)?(?: ,)? (?:respectively|in (?:this|that) order)"),
    *patterns("rainbow", True, "(?:an? )?rainbow(?: colored)?(?= (?:stair|step|flight))", "(?:in|with) "
        "(?:the )?(?:colors of (?:the|a) rainbow|rainbow (?:colors|order))"),
    *patterns("piled", None, "(?:(?:BE )?stacked |piled )?(?:on top of (?:each other|one another)|(?:one|each) "
                             "(?:up)?on "
        "(?:top of )?the other)", "(?:BE )?(?:stacked|piled)(?: up)?(?= [,;.:]| and | $)"),
    *patterns("then", None, "(?:(?:,|;|and) )*(?:next to|beside) (?:it|that|them|those|these)(?: BE)?"),
    *patterns("then", None, "(?:,|;)?(?: and)? ?(?:then|next|after that|finally)", ", (?:then|next|finally)",
        "and (?:then|finally)"),
    *patterns("own", None,
        f"(?:with )?(?:each|every) {_STEP} (?:BE )?(?:has |have |having |of |with |in )?(?:its own|a different|"
        "another|one|a single|its) color(?: of its own)?",
        f"(?:with )?(?:each|every) {_STEP} (?:BE )?(?:a |of |in )?(?:different|own) colors?",
        f"{_STEP} of different colors",
        f"one color (?:per|for each|for every|each) {_STEP}"),
    *patterns("break", None, "[()]", "except(?: for)?|apart from|save for|other than", ", which"),
    *patterns("glue", None, "needed|are needed", "they|it|in all", f"{_RISE}(?= [:,.])"),
    *patterns("glue", None, "high|tall|been|given|(?:there|here) (?:are|is)|(?:we|i|you) have|"
        "(?:out of|from|of|with|using|use) (?:all of )?(?:them|these)", "(?:gets?|grows?|becomes?|rises?|goes up|"
        f"going up) (?:by )?(?:one )?(?:BLOCK )?(?:higher |taller )?(?:with|at|for) (?:each|every) {_STEP}",
        f"(?:{_RISE} )?(?:by )?one BLOCK (?:per|each|every) {_STEP}",
        f"(?:each|every)(?: {_STEP}| one)? (?:BE )?(?:(?:by )?one (?:BLOCK )?)?(?:higher|taller)(?: by one BLOCK)? "
        f"than "
        f"the (?:{_STEP} |one )?(?:before|last|previous|one before|last one|previous one)(?: it)?",
        "(?:going |growing |increasing )?(?:by )?one (?:BLOCK )?(?:more|higher|taller)? ?(?:each time|every time)"),
    *patterns("glue", None, "so that|such that|which|that|its|whose|only|used|up|out|side by side|adjoining|like|"
        "in total|total|color|itself|was|thinking of|thinking|imagine|picture|love|some|so|have|has been|have been|"
        "verify that|check that|make sure that|sure|on|flat|beside each other|next to each other|neighboring|"
        "throughout|get|looks like|do|make|stacked|stack|pile|piled|ordinary|stacked into|rise"),
]  # fmt: skip
