"""Words for the sizes of flat figures: sides, arms, rows, and the limbs of letters."""

from __future__ import annotations

import re

from rpg.language.frames.pieces import Pattern, number, patterns

HAS = (
    "(?:BE |has |have |having |with |contains? |containing |consists? of |consisting of |made of |of |: |gets? |"
    "counts? |measures? |takes? |shows? )*"
)
_EACH = "(?:each|every|a|all|both|the|any one|each one|every one)(?: of)?(?: the| its)?(?: (?:4|3|2))?"
COUNT = "(?P<count>NUM)(?! (?:SIZE )?COLOR)(?: BLOCK)?(?: of (?:them|these|the BLOCK))?"
_MADE_LONG = "(?: (?:long|wide|each|in length|in size))*"
_DEEP = "(?:deep|from front to back|front to back|in depth|high|tall|down|from the front to the back)"
_WIDE = "(?:wide|across|in width|from left to right|left to right|broad|from the left to the right)"
_LONG = "(?:long|along|in length)"
_AND = "(?: ,)?(?: and| by| x| times)?"
_SIDE = "(?:sides?|edges?)(?: of it)?"
_WAYS = "(?:way|direction|ways|directions)"
_LIMB = "(?:(?:vertical |horizontal |long |short |upright )?(?:stroke|stem|foot|arm|leg|bar|line|limb|base|upright))"
_ROW = (
    "(?: (?:along|at|in|on|for) (?:the |its )?(?:base|bottom|front|back|top|near side|far side|next|second|third|"
    "fourth|"
    "first|last|middle|near|far|rear|nearest|farthest|following|tip|apex|point|peak)(?: (?:row|one|line))?(?: "
    "(?:behind|before|in front of|after) (?:it|that|them))?| (?:behind|before|in front of|after) (?:it|that|them|"
    "those|these))?"
)
SIZES: list[Pattern] = [
    *patterns("dims", lambda m: ("x", *sorted(map(int, re.findall(r"\d+", m[0])), reverse=True)),
        r"(?:of )?(?:size )?\d+x\d+(?: BLOCK)?(?: in size)?", r"(?:of )?\d+(?: BLOCK)? (?:by|times|x) \d+(?: BLOCK)?"),
    *patterns("dims", lambda m: ("wide", number(m["a"]), number(m["b"])),
        f"(?P<a>NUM)(?: BLOCK)? {_WIDE}{_AND} (?P<b>NUM)(?: BLOCK)? {_DEEP}",
        f"(?P<b>NUM)(?: BLOCK)? {_DEEP}{_AND} (?P<a>NUM)(?: BLOCK)? (?:{_WIDE}|{_LONG})",
        f"(?P<a>NUM)(?: BLOCK)? {_LONG}{_AND} (?P<b>NUM)(?: BLOCK)? {_DEEP}"),
    *patterns("dims", lambda m: ("long", max(number(m["a"]), number(m["b"])), min(number(m["a"]), number(m["b"]))),
        f"(?P<a>NUM)(?: BLOCK)? {_LONG}{_AND} (?P<b>NUM)(?: BLOCK)? (?:wide|across|in width|broad)",
        f"(?P<b>NUM)(?: BLOCK)? (?:wide|across|in width|broad){_AND} (?P<a>NUM)(?: BLOCK)? {_LONG}"),
    *patterns("dims", lambda m: ("sides", number(m["a"]), number(m["b"])),
        "(?P<a>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:long|longer) "
        f"(?:one|{_SIDE}){_AND} (?P<b>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 "
        f")?(?:short|shorter) (?:one|ones|{_SIDE})",
        "(?P<b>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:short|shorter) "
        f"(?:one|{_SIDE}){_AND} (?P<a>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 "
        f")?(?:long|longer) (?:one|ones|{_SIDE})"),
    *patterns("dims", lambda m: ("sides", number(m["a"]), number(m["b"])),
        f"(?:with |whose )?(?:the |its )?(?:2 )?long(?:er)? {_SIDE} {HAS}(?P<a>NUM)(?: BLOCK)?(?: long)?{_AND} (?:the |"
        f"its |whose )?(?:2 )?short(?:er)? (?:ones|{_SIDE}) {HAS}(?P<b>NUM)(?: BLOCK)?(?: long)?"),
    *patterns("dims", lambda m: ("wide", number(m["b"]), number(m["a"])),
        "(?:in )?(?P<a>NUM) rows (?:of|with) (?P<b>NUM)(?: BLOCK)?(?: each)?(?! (?:SIZE )?COLOR)"),
    *patterns("side", lambda m: number(m["count"]),
        f"(?:with )?{COUNT}{_MADE_LONG} (?:per|on|along|in|for|at|to|down|each|every|makes?|make up|form|forming|"
        f"a)(?: {_EACH})? {_SIDE}",
        f"(?:with |and |so that |whose )?(?:{_EACH} |the length of {_EACH} )?{_SIDE} {HAS}"
        f"(?:exactly )?{COUNT}{_MADE_LONG}",
        f"(?:with )?(?:(?:a|the|its) )?(?:side|edge)(?: length| size)? {HAS}{COUNT}{_MADE_LONG}",
        f"{COUNT}{_MADE_LONG} (?:a|per|each) {_SIDE}"),
    *patterns("rows", lambda m: [number(n) for n in re.findall(r"\d+|one", m[0])],
        r"(?:in )?rows of (?:(?:\d+|one|single)(?: BLOCK)?(?: ,)?(?: and| then| and then)? )+(?:\d+|one)(?: BLOCK)?"),
    *patterns("rows", lambda m: [number(n) for n in re.findall(r"\d+|(?<!next )\bone\b", m[0])],
        f"(?:in |with )?(?:rows of )?NUM(?: BLOCK)?{_ROW}(?:(?: ,| then| and)+ NUM(?: BLOCK)?{_ROW}){{2,}}"),
    *patterns("lines", lambda m: number(m["count"]),
        "(?:(?:in|with|of|having|made of) )?(?P<count>NUM) rows(?= [.,;!])"),
    *patterns("per", True,
        f"(?:per|on|along|in|for|at|to|down) (?:(?:each|every|both|all)(?: of)?(?: the| its)?(?: [234])? ){_SIDE}",
        f"(?:per|each|every) {_SIDE}",
        f"(?:on|along|to|at) a {_SIDE}"),
    *patterns("arm", lambda m: number(m["count"]),
        f"(?:with |and |so that )?(?:{_EACH} |(?:(?:the|its|with its) )?(?:[234] )?(?:equal )?)(?:arms?|legs?|"
        f"branch|branches|limbs?|strokes?|uprights?) {HAS}(?:exactly )?{COUNT}{_MADE_LONG}",
        f"(?:with )?{COUNT}{_MADE_LONG} (?:per|on|along|in|for|at|to|each|makes?|make up|form|forming)(?: "
        f"{_EACH})? (?:arms?|legs?|branch|branches|{_WAYS})",
        "(?:with )?(?P<count>NUM) BLOCK (?:long )?arms?", f"{COUNT} each {_WAYS}",
        "arms (?P<count>NUM)(?: BLOCK)? long", f"(?:both|each)(?: of them)? {HAS}(?P<count>NUM)(?: BLOCK)? long",
        f"(?:with )?(?:4 )?arms {HAS}(?:length )?(?P<count>NUM)",
        f"(?:with |and )?(?:{_EACH} |(?:(?:the|its) )?(?:[234] )?)(?:arms?|branch|branches) {HAS}(?P<count>NUM)(?= "
        f"(?:SIZE )?COLOR )"),
    *patterns("shared", True, "(?:including|counting) (?:the )?(?:shared )?(?:corner|corners)(?: BLOCK)?(?: "
        "(?:counted|included|shared|twice|in both|in each))*",
        r"(?:with )?(?:the |a )?shared corner(?: BLOCK)?", "with (?:the )?corners?(?: BLOCK)? (?:counted|included|"
        "shared|counting|belonging)(?: (?:twice|in both|to both|in each|by both))*",
        "sharing (?:the|a|one) corner(?: BLOCK)?", "(?:the )?corners?(?: BLOCK)? (?:BE )?(?:counted|included|"
        "shared|counted in)(?: (?:twice|in both|to both|in each|by both))*"),
    *patterns("shared", True, "(?:if you )?(?:count|counts|counted|counting|including|sharing) (?:the |one "
        ")?corner(?: BLOCK)?(?: in| to)?(?: (?:both|each|each one|both legs|both arms|each leg|each arm|each of "
        "them|both of them|the 2))?",
        "the corner(?: BLOCK)? (?:BE )?(?:counted|included|shared)(?: in| by)?(?: (?:both|each))?(?: of them| "
        "legs?| arms?)?",
        f"(?:(?:the|both|its|these|whose|2) )*(?:they|which|arms|legs|strokes|limbs|parts|lines|{_LIMB} and (?:the |"
        f"its )?{_LIMB}) (?:BE )?(?:share|sharing|have) (?:the|a|one) (?:same |common )?corner(?: BLOCK)?(?: in "
        "common)?"),
    *patterns("equal", True, "(?:(?:with|and|having) )?(?:(?:the|its|both) )?(?:(?:both|2|4) )?(?:equal|equally "
        "long|same size|same length) (?:arms|legs|sides|strokes)",
        "(?:(?:with|and|having) )?(?:(?:the|its|both) )?(?:(?:both|2|4) )?(?:arms|legs|sides|strokes) (?:(?:BE|"
        "have|having|with|of) )*(?:(?:the|an) )?(?:equally long|(?:equal|same)(?: in)?(?: length| size)?)"),
    *patterns("apart", True, "(?:not (?:counting|including)|without|excluding|besides|beyond|in addition to) the "
        "(?:center|middle|corner|corners)(?: BLOCK| one)?"),
]  # fmt: skip

_MORE = "(?P<more> more| further| additional| extra| others?)?"
_FOR = "(?:(?:for|in|as|forming|form|forms|make|makes|making|along|across|make up|making up|at|on|are|being|is) )"
_ARM = "(?:arm|side|leg|stroke|part|bar|line|limb)"
BAR = (
    "(?:(?:top |horizontal |upper )?(?:bar|crossbar|cross bar|crosspiece|cross piece|beam|stroke|line|arm|roof)|"
    "top(?: row)?)"
)
STEM = (
    "(?:(?:down|downward|downwards|lower) (?:line|bar|stroke|part|piece|leg)|(?:vertical |long |middle )?(?:stem|"
    "leg|trunk|post|shaft|tail|stalk|vertical(?: bar| line| stroke)?))"
)
_N = "(?:with )?(?:then )?(?P<another>another |the other |the remaining )?" + COUNT
_ALONG_TOP = "(?: (?:along|across|at|on) (?:the|its) top)?"
_HANGS = (
    "(?:(?: (?:hangs?|hanging|goes|go|going|runs?|running|comes?|coming) down(?:wards)?)?(?: from (?:its|the) "
    "(?:middle|center)(?: of (?:it|the bar))?)?)"
)
_TO_A_SIDE = "(?: (?:going|pointing|turning|turned|running|sticking out))? (?:to|towards?) the "
_JOINS = "(?:joins?|joining|connects?|connecting|links?|linking|between|to (?:join|connect|link))"
_OTHERS = "(?:them|these|both|(?:(?:the|both|its|these) )?(?:2 )?(?:arms|legs|sides|strokes|uprights|ends))"
_BELOW = "(?: (?:at|on|along) the (?:bottom|base))?"


def _further(match: re.Match[str]) -> bool:
    """Whether these are blocks besides those that are told before."""
    return any(match.groupdict().get(name) for name in ("another", "more"))


LIMBS: list[Pattern] = [
    *patterns("limb", lambda m: ("bar", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)?(?: go| goes| going| lie| lying| run| running)? (?:across|horizontal|horizontally|"
        f"{_FOR}(?:the |its )?{BAR}|across "
        f"(?:the |its )?(?:top|{BAR}|bar))(?: {_FOR}?the {BAR})?",
        f"(?:the |its |a |whose |with a |with the )?{BAR}(?: of it)?{_ALONG_TOP} {HAS}{COUNT}{_MORE}(?: BLOCK)?(?: "
        f"long| wide| across)?{_ALONG_TOP}",
        f"across (?:the )?top(?: row)? {HAS}{COUNT}", f"across(?: :)? {COUNT}"),
    *patterns("limb", lambda m: ("stem", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)?(?: going| go| running| run| lie| lying| hanging| hang| sticking)? (?:{_FOR}(?:the "
        f"|its )?{STEM}|down(?:wards?)?(?: (?:from )?(?:the|its) (?:middle|center|stem)(?: "
        f"one| BLOCK)?(?: of (?:it|the bar))?)?|below(?: (?:it|them|that|"
        "the bar|the middle(?: one| BLOCK)?))?(?: in the (?:middle|center))?|vertical|vertically|down from the "
        "(?:middle|center)|"
        "under (?:it|the "
        f"middle|the bar)|underneath(?: it)?)(?: in the middle)?(?: (?:as|for) (?:the|its) {STEM})?",
        f"(?:(?:below|under|underneath)(?: (?:it|that|the {BAR}))? )?(?:the |its |a |whose |with a |with the "
        f")?{STEM}(?: of it)?{_HANGS} {HAS}{COUNT}{_MORE}(?: BLOCK)?(?: long| high| tall)?(?: (?:below|under|"
        f"underneath)(?: (?:it|the {BAR}))?)?", f"down(?:wards)?(?: :)? {COUNT}"),
    *patterns("limb", lambda m: ("ups", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:going |standing |straight )?up(?:wards?)? (?:on|at) (?:each|either|both|each of "
        "the|both of its) (?:sides?|ends?)", f"{_N}{_MORE}(?: BLOCK)? (?:on|at) (?:each|either) (?:side|end) going up"),
    *patterns("limb", lambda m: ("up", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:going |standing |straight )?(?:up(?:wards?|right)?|{_FOR}(?:the |its "
        ")?(?:upright|stem|back))"),
    *patterns("limb", lambda m: ("up", number(m["count"]), _further(m)),
        f"(?:with )?(?P<count>NUM){_MORE} (?P<hue>COLOR)(?: BLOCK)? (?:going |go |standing |straight "
        f")*(?:up(?:wards?)?|tall|high|"
        "vertical|vertically)"),
    *(found for side in ("left", "right") for found in patterns("along",
        lambda m, side=side: (number(m["count"]), _further(m), side),
        f"(?:with )?(?P<count>NUM){_MORE} (?P<hue>COLOR)(?: BLOCK)? (?:going |pointing |go )?(?:to|towards?) the "
        f"{side}")),
    *patterns("limb", lambda m: ("long", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:tall|high|long|{_FOR}(?:the |its )?(?:long|longer|vertical) {_ARM})",
        f"(?:the |its |a |whose |with a |with the )?(?:(?:long|longer|vertical) {_ARM}|upright) "
        f"{HAS}{COUNT}{_MORE}(?: BLOCK)?(?: long| high| tall)?"),
    *patterns("limb", lambda m: ("along", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? {_FOR}(?:the |its )?(?:foot|base|toe)"),
    *patterns("limb", lambda m: ("short", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:wide|across|{_FOR}(?:the |its )?(?:short|shorter|horizontal|bottom) {_ARM})",
        f"(?:the |its |a |whose |with a |with the )?(?:foot|base|toe|(?:short|shorter|horizontal|bottom) {_ARM}) "
        f"{HAS}{COUNT}{_MORE}(?: BLOCK)?(?: long| wide)?"),
    *(found for side in ("left", "right") for found in patterns("along",
        lambda m, side=side: (number(m["count"]), _further(m), side),
        f"{_N}{_MORE}(?: BLOCK)?(?: going| pointing| go| as (?:the|its) foot)? (?:to|towards?) the {side}",
        f"{_N}{_MORE}(?: BLOCK)? (?:for|as|in) (?:the |its )?foot (?:going |pointing |turning |sticking out "
        f")?(?:to|towards?) the {side}",
        f"(?:(?:at|from) (?:the|its) (?:near|lower|bottom|front) end(?: ,)? )?(?:the |its |a |whose |with a |with "
        f"the )?(?:foot|base|toe|(?:short|shorter|horizontal|bottom) {_ARM}) {HAS}{COUNT}{_MORE}(?: BLOCK)?(?: "
        f"long)?{_TO_A_SIDE}{side}")),
    *patterns("limb", lambda m: ("joint", number(m["count"]), False),
        f"(?:the |its |a |with a |with the )?(?:base|bottom|{BAR}) (?:that |which )?{_JOINS} {_OTHERS}{_BELOW} "
        f"{HAS}{COUNT}{_MORE}",
        f"(?:(?:the |its |a |with a |with the )?(?:base|bottom|{BAR}) {HAS})?{COUNT}{_MORE} (?:that |which "
        f")?{_JOINS} {_OTHERS}{_BELOW}",
        f"(?:that |which )?(?:BE )?(?:joined|connected|linked|closed){_BELOW} (?:by|with) (?:an? (?:base|bar) of "
        f")?{COUNT}{_BELOW}",
        f"{COUNT}{_MORE} (?:(?:that |which )?closes?|closing|to close|to fill) (?:the |its )?(?:bottom|base|gap)"),
]  # fmt: skip
"""Value: the limb, how many blocks, whether besides those told before."""
