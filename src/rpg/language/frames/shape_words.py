"""The words of flat figures: which figure, its sizes, its parts, where it points, whether it is filled."""

from __future__ import annotations

import re

from rpg.language.frames.lots import LOTS
from rpg.language.frames.pieces import Pattern, number, numbers, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE

_KIND = "(?: (?:sign|symbol|shape|shaped|figure|form|pattern|formation|arrangement|layout|design))*"
_LETTER = "(?:(?:the |a )?(?:(?:capital|block|upper case|uppercase|big) )?letter )?(?:(?:capital|uppercase) )?"
_IT = "(?:it|them|this|that|which|(?:(?:the|this) )?(?:shape|figure|whole|circle|ring|square|plus|cross|rectangle|triangle|outline|letter|[TLUVX]))"
_ITS = "(?:(?:and |with )?(?:the|its|whose|his|both) )?(?:(?:4|3|2) )?"
_TWO_PARTS = "(?: (?:BLOCK|ones|one|piece|place|places|position|positions|spot|part|parts))?"
_HAS = "(?:BE |has |have |having |with |contains? |containing |consists? of |consisting of |made of |of |: |gets? |counts? |measures? |takes? |shows? )*"
_EACH = "(?:each|every|a|all|both|the|any one|each one|every one)(?: of)?(?: the| its)?(?: (?:4|3|2))?"
_COUNT = "(?P<count>NUM)(?! (?:SIZE )?COLOR)(?: BLOCK)?(?: of (?:them|these|the BLOCK))?"
_MADE_LONG = "(?: (?:long|wide|each|in length|in size))*"

FIGURES: list[Pattern] = [
    *patterns("figure", "plus", f"(?:plus|cross){_KIND}", "and (?:shaped?|sign|symbol|figure)"),
    *patterns("figure", "circle", f"(?:circle|ring|loop){_KIND}", f"(?:circular|round)(?: ring| circle)?{_KIND}(?<!circular)(?<!round)"),
    *patterns("figure", "triangle", f"(?:equilateral )?triangle{_KIND}", "triangular (?:shape|figure|form|formation|arrangement|outline)"),
    *patterns("figure", "square", f"square(?! PATCH| base| BLOCK){_KIND}"),
    *patterns("figure", "rectangle", f"(?:rectangle|oblong){_KIND}", "rectangular (?:shape|figure|form|formation|arrangement)"),
    *(found for letter in "TLUVX" for found in patterns("figure", letter,
        f"{_LETTER}'?{letter}'?{_KIND}", f"{_LETTER}'?(?<!')\\b{letter.lower()}(?: shape| shaped| form| figure)+",
        f"(?:an?|the|letter|the letter|a letter) {letter.lower()}(?= (?:of|from|out|made|with|using|on|,|that|which|whose|shape))",
        *(["(?:^|a )you (?:shape|shaped)(?= (?:with|of|from|out|made|,|:|NUM))"] if letter == "U" else []))),
    *patterns("again", None, "(?:the|this|that) (?:figure|shape|whole figure|whole thing|form|whole shape)", "it(?= BE )"),
]  # fmt: skip

FILL: list[Pattern] = [
    *patterns("fill", "hollow", "(?:trace|traces|tracing|mark|marks|outline|outlines|outlining)(?: out)?(?= (?:a|an) (?:square|triangle|rectangle)\\b)",
        r"(?:(?:just|only) )?(?:the |an |a )?(?:outline|contour|perimeter|boundary|frame|outer line|edges)(?: only)?(?: (?:of|for))?(?: an?| the)?(?= (?:square|rectangle|triangle|rectangular|triangular)\b)",
        "(?:just|only) (?:the |its |an )?(?:outline|contour|border|edges|frame|perimeter)", "(?:the |an |in )?outline(?: only)?",
        "(?:outline|edges|border|frame) only", "hollow|unfilled|outlined", "frame",
        f"(?:(?:and |with )?(?:the |its |whose )?(?:inside|interior|inner part|middle|center|hole|space inside)(?: of {_IT})? )(?:BE )?(?:left |kept |staying |stays |remains |remaining |that stays )*(?:empty|free|open|hollow|clear|unfilled|bare|vacant|blank)",
        "(?:that |which )?(?:BE )?(?:left |kept )?(?:empty|hollow|free|open|unfilled)(?: BE)? (?:inside|within|in the (?:middle|center|inside)|in its (?:middle|center)|in it|in middle|in center|on the inside|in between)",
        "(?:leaving|leave|keeping|keep|leaves|keeps) (?:the |its )?(?:inside|interior|middle|center)(?: of it)? (?:empty|free|open|clear|unfilled|hollow)",
        f"(?:and |with )?(?:there is |has )?(?:nothing|no BLOCK)(?: BE)? (?:inside|within|in the (?:middle|center|inside)|in its (?:middle|center)|in it|inside it|in middle|in between)(?: of {_IT})?",
        "without (?:anything|any BLOCK|a BLOCK|BLOCK) (?:inside|within|in the (?:middle|center)|in it|inside it)",
        "(?:with )?(?:a )?hole in (?:(?:the|its) )?(?:middle|center)", "(?:with )?nothing (?:in|inside)(?: of)? it",
        "(?:in |on )?(?:the |its )?(?:inside|interior|middle) it (?:BE )?(?:empty|free|hollow|open)", "empty(?= (?:square|rectangle|triangle)\\b)", "around the edges?", "(?:a|the) border of"),
    *patterns("fill", "filled",
        "(?:to be )?filled(?: in| up| out)?(?: by| with)?|solid|full|massive|completely filled|filled completely|completely full|fully filled",
        "(?:with )?(?:no|without a|without any|without) holes?(?: in (?:it|the middle|the center))?",
        "(?:the |its |with the )?(?:inside|interior|middle|center) (?:BE )?(?:filled|full)(?: in| too| as well)?", "not hollow"),
]  # fmt: skip

_DEEP = "(?:deep|from front to back|front to back|in depth|high|tall|down|from the front to the back)"
_WIDE = "(?:wide|across|in width|from left to right|left to right|broad|from the left to the right)"
_LONG = "(?:long|along|in length)"
_AND = "(?: ,)?(?: and| by| x| times)?"
_SIDE = "(?:sides?|edges?)(?: of it)?"
_WAYS = "(?:way|direction|ways|directions)"
_ROW = "(?: (?:along|at|in|on|for) (?:the|its) (?:base|bottom|front|back|top|near side|far side)(?: row)?)?"
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
        f"(?P<a>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:long|longer) (?:one|{_SIDE}){_AND} (?P<b>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:short|shorter) (?:one|ones|{_SIDE})",
        f"(?P<b>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:short|shorter) (?:one|{_SIDE}){_AND} (?P<a>NUM)(?: BLOCK)? (?:(?:along|on|in|for|to) )?(?:the |each |its |both )?(?:2 )?(?:long|longer) (?:one|ones|{_SIDE})"),
    *patterns("dims", lambda m: ("sides", number(m["a"]), number(m["b"])),
        f"(?:with )?(?:the |its )?(?:2 )?long(?:er)? {_SIDE} {_HAS}(?P<a>NUM)(?: BLOCK)?(?: long)?{_AND} (?:the |its )?(?:2 )?short(?:er)? (?:ones|{_SIDE}) {_HAS}(?P<b>NUM)(?: BLOCK)?(?: long)?"),
    *patterns("dims", lambda m: ("wide", number(m["b"]), number(m["a"])),
        "(?:in )?(?P<a>NUM) rows (?:of|with) (?P<b>NUM)(?: BLOCK)?(?: each)?(?! (?:SIZE )?COLOR)"),
    *patterns("side", lambda m: number(m["count"]),
        f"(?:with )?{_COUNT}{_MADE_LONG} (?:per|on|along|in|for|at|to|down|each|every|makes?|make up|form|forming|a)(?: {_EACH})? {_SIDE}",
        f"(?:with |and |so that )?(?:{_EACH} |the length of {_EACH} )?{_SIDE} {_HAS}(?:exactly )?{_COUNT}{_MADE_LONG}",
        f"(?:with )?(?:(?:a|the|its) )?(?:side|edge)(?: length| size)? {_HAS}{_COUNT}{_MADE_LONG}", f"{_COUNT}{_MADE_LONG} (?:a|per|each) {_SIDE}"),
    *patterns("rows", lambda m: [number(n) for n in re.findall(r"\d+|one", m[0])],
        r"(?:in )?rows of (?:(?:\d+|one|single)(?: BLOCK)?(?: ,)?(?: and| then| and then)? )+(?:\d+|one)(?: BLOCK)?"),
    *patterns("rows", lambda m: [number(n) for n in re.findall(r"\d+|one", m[0])],
        f"NUM(?: BLOCK)?{_ROW}(?:(?: ,| then| and)+ NUM(?: BLOCK)?{_ROW}){{2,}}"),
    *patterns("per", True, f"(?:per|on|along|in|for|at|to|down|each|every) (?:{_EACH} )?{_SIDE}", f"(?:on|along|to|at) a {_SIDE}"),
    *patterns("arm", lambda m: number(m["count"]),
        f"(?:with |and |so that )?(?:{_EACH} |(?:(?:the|its|with its) )?(?:[234] )?(?:equal )?)(?:arms?|legs?|branch|branches|limbs?|strokes?) {_HAS}(?:exactly )?{_COUNT}{_MADE_LONG}",
        f"(?:with )?{_COUNT}{_MADE_LONG} (?:per|on|along|in|for|at|to|each|makes?|make up|form|forming)(?: {_EACH})? (?:arms?|legs?|branch|branches|{_WAYS})",
        f"(?:with )?(?P<count>NUM) BLOCK (?:long )?arms?", f"{_COUNT} each {_WAYS}", "arms (?P<count>NUM)(?: BLOCK)? long",
        f"(?:with )?(?:4 )?arms {_HAS}(?:length )?(?P<count>NUM)"),
    *patterns("shared", True, r"(?:including|counting) (?:the )?(?:shared )?(?:corner|corners)(?: BLOCK)?(?: (?:counted|included|shared|twice|in both|in each))*",
        r"(?:with )?(?:the |a )?shared corner(?: BLOCK)?", r"with (?:the )?corners?(?: BLOCK)? (?:counted|included|shared|counting|belonging)(?: (?:twice|in both|to both|in each|by both))*",
        "sharing (?:the|a|one) corner(?: BLOCK)?", "(?:the )?corners?(?: BLOCK)? (?:BE )?(?:counted|included|shared|counted in)(?: (?:twice|in both|to both|in each|by both))*"),
    *patterns("shared", True, "(?:if you )?(?:count|counts|counted|counting|including|sharing) (?:the |one )?corner(?: BLOCK)?(?: in| to)?(?: (?:both|each|each one|both legs|both arms|each leg|each arm|each of them|both of them|the 2))?",
        "the corner(?: BLOCK)? (?:BE )?(?:counted|included|shared)(?: in| by)?(?: (?:both|each))?(?: of them| legs?| arms?)?"),
    *patterns("equal", True, "(?:(?:with|and|having) )?(?:(?:the|its|both) )?(?:(?:both|2|4) )?(?:equal|equally long|same size|same length) (?:arms|legs|sides|strokes)",
        "(?:(?:with|and|having) )?(?:(?:the|its|both) )?(?:(?:both|2|4) )?(?:arms|legs|sides|strokes) (?:(?:BE|have|having|with|of) )*(?:(?:the|an) )?(?:equally long|(?:equal|same)(?: in)?(?: length| size)?)"),
    *patterns("apart", True, "(?:not (?:counting|including)|without|excluding|besides|beyond|in addition to) the (?:center|middle|corner|corners)(?: BLOCK| one)?"),
]  # fmt: skip

_MORE = "(?P<more> more| further| additional| extra| others?)?"
_FOR = "(?:(?:for|in|as|forming|form|forms|make|makes|making|along|across|make up|making up|at|on|are|being|is) )"
_ARM = "(?:arm|side|leg|stroke|part|bar|line|limb)"
_BAR = "(?:(?:top |horizontal |upper )?(?:bar|crossbar|cross bar|crosspiece|cross piece|beam|stroke|line|arm|roof)|top(?: row)?)"
_STEM = "(?:(?:vertical |long |middle )?(?:stem|leg|trunk|post|shaft|tail|stalk|vertical(?: bar| line| stroke)?))"
_N = "(?:with )?(?:then )?(?P<another>another |the other |the remaining )?" + _COUNT


def _further(match: re.Match[str]) -> bool:
    """Whether these are blocks besides those that are told before."""
    return bool(match["another"] or match["more"]) if "another" in match.re.groupindex else bool(match["more"])


LIMBS: list[Pattern] = [
    *patterns("limb", lambda m: ("bar", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)?(?: go| lie| lying| run| running)? (?:across|{_FOR}(?:the |its )?{_BAR}|across (?:the |its )?(?:top|{_BAR}|bar))(?: {_FOR}?the {_BAR})?",
        f"(?:the |its |a |whose |with a |with the )?{_BAR}(?: of it)? {_HAS}{_COUNT}{_MORE}(?: BLOCK)?(?: long| wide| across)?"),
    *patterns("limb", lambda m: ("stem", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)?(?: going| go| running| run| lie| lying| hanging| hang| sticking)? (?:{_FOR}(?:the |its )?{_STEM}|down(?:wards?)?(?: (?:from )?(?:the|its) (?:middle|center|stem))?|below(?: (?:it|them|that|the bar|the middle))?(?: in the (?:middle|center))?|down from the (?:middle|center)|under (?:it|the middle|the bar)|underneath(?: it)?)(?: in the middle)?(?: (?:as|for) (?:the|its) {_STEM})?",
        f"(?:the |its |a |whose |with a |with the )?{_STEM}(?: of it)? {_HAS}{_COUNT}{_MORE}(?: BLOCK)?(?: long| high| tall)?"),
    *patterns("limb", lambda m: ("up", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:going |standing |straight )?(?:up(?:wards?|right)?|{_FOR}(?:the |its )?(?:upright|stem|back))"),
    *patterns("limb", lambda m: ("long", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:tall|high|long|{_FOR}(?:the |its )?(?:long|longer|vertical) {_ARM})",
        f"(?:the |its |a |whose |with a |with the )?(?:(?:long|longer|vertical) {_ARM}|upright) {_HAS}{_COUNT}{_MORE}(?: BLOCK)?(?: long| high| tall)?"),
    *patterns("limb", lambda m: ("along", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? {_FOR}(?:the |its )?(?:foot|base|toe)"),
    *patterns("limb", lambda m: ("short", number(m["count"]), _further(m)),
        f"{_N}{_MORE}(?: BLOCK)? (?:wide|across|{_FOR}(?:the |its )?(?:short|shorter|horizontal|bottom) {_ARM})",
        f"(?:the |its |a |whose |with a |with the )?(?:foot|base|toe|(?:short|shorter|horizontal|bottom) {_ARM}) {_HAS}{_COUNT}{_MORE}(?: BLOCK)?(?: long| wide)?"),
    *(found for side in ("left", "right") for found in patterns("along", lambda m, side=side: (number(m["count"]), _further(m), side),
        f"{_N}{_MORE}(?: BLOCK)?(?: going| pointing| go| as (?:the|its) foot)? (?:to|towards?) the {side}",
        f"{_N}{_MORE}(?: BLOCK)? (?:for|as|in) (?:the |its )?foot (?:going |pointing |turning |sticking out )?(?:to|towards?) the {side}")),
]  # fmt: skip
"""Value: the limb, how many blocks, whether besides those told before."""

_TOWARD = {
    "left": "(?:(?:to|towards?|on|at|in|facing) )?(?:the |its |my |your )?left(?: hand)?(?: side)?|leftwards?",
    "right": "(?:(?:to|towards?|on|at|in|facing) )?(?:the |its |my |your )?right(?: hand)?(?: side)?|rightwards?",
    "front": "(?:(?:to|towards?|at|on|facing|in) )?(?:the )?(?:front|near)(?: side| edge| end)?(?: of the TABLE)?|(?:(?:towards?|to|facing|at|nearest|nearest to|closest to|near) )?(?:me|us|you|(?:the )?(?:robot|viewer|camera|observer|spectator))|nearest|closest",
    "back": "(?:(?:to|towards?|at|on|facing|in) )?(?:the )?(?:back|rear|far)(?: side| edge| end)?(?: of the TABLE)?|away(?: from (?:me|us|you|(?:the )?(?:robot|viewer|camera|observer|spectator)))?|backwards?|(?:farthest|furthest)(?: away)?(?: from (?:me|us|you|the (?:robot|viewer|camera)))?",
    "top": "(?:(?:at|to|towards?|on) )?(?:the )?top|up(?:wards?)?",
}  # fmt: skip
_POINTS = "(?:(?:BE |must |should |shall |to |that |which )?(?:point|points|pointing|pointed|face|faces|facing|aim|aims|aiming|aimed|directed|turned|turn|turns|turning|look|looks|looking|show|shows|showing|open|opens|opening|extend|extends|extending|go|goes|going|stick|sticks|sticking|reach|reaches|reaching|run|runs|running|come|comes|coming)(?: out| up| straight| directly)? |BE )?"
_PART_OF = {
    "foot": "foot|base|toe|(?:short|shorter|lower|bottom) (?:arm|leg|bar|stroke|side|line)",
    "stem": "(?:(?:foot|end|bottom|bottom end) of the )?(?:stem|leg)|trunk|post|shaft|tail|stalk",
    "bar": "(?:top )?(?:bar|crossbar|cross bar|crosspiece)",
    "opening": "opening|open side|open end|open ends|mouth|open part|gap",
    "tip": "tip|point|apex|peak|vertex|pointed end|pointy end|tip block|sharp end",
}  # fmt: skip
WAYS: list[Pattern] = [
    *(found for part, names in _PART_OF.items() for side, toward in _TOWARD.items()
      for found in patterns("way", (part, side), f"(?:(?:and |with |so that )?(?:its|the|whose|a) )?(?:{names})(?: end)?(?: of {_IT})? {_POINTS}(?:{toward})")),
    *patterns("way", ("any", ""), "(?:in |with )?(?:any|whichever|whatever|some) (?:orientation|direction|way|rotation|way round|way around)(?: (?:will do|(?:BE|is) (?:fine|ok|okay|good|allowed)|you like))?",
        "(?:the )?(?:orientation|direction|rotation) (?:(?:BE|is) up to you|does not matter|(?:BE|is) (?:free|open))", "(?:it|this|that) (?:may|can) be (?:turned|rotated|oriented) (?:(?:in )?any way|any way round|as you like|anyhow|freely)"),
    *patterns("way", ("all", "upright"), "(?:(?:that|which) )?(?:BE )?(?:upright|right way up|the right way up|readable)(?= [,.;]| and )", "upright(?= letter| capital| [TLUV] )"),
    *(found for side in ("left", "right") for found in patterns("way", ("foot", side),
        f"(?:(?:its|the) )?foot (?:BE )?(?:at|on|in) the (?:near|bottom|lower|front)(?: end| side| edge)? {_POINTS}(?:{_TOWARD[side]})")),
    *(found for side, toward in _TOWARD.items() for found in (
      *patterns("way", ("opening", side), f"(?:(?:that|which|it|and|must|should|shall) )*(?:BE )?(?:opens?|opened|opening|open)(?: up)? (?:{toward})"),
      *patterns("way", ("tip", side), f"(?:(?:that|which|it|must|should|shall) )*(?:BE )?(?:points?|pointing|pointed) (?:{toward})"))),
    *patterns("way", ("all", "over"), "(?:that |which )?(?:BE )?(?:turned )?upside down", "inverted"),
    *(found for base, tip in (("front", "back"), ("back", "front"), ("left", "right"), ("right", "left"))
      for found in patterns("base", lambda m, tip=tip: (number(m["count"]), tip),
        f"{_COUNT} (?:BE )?(?:along|in|at|on|forming|as) (?:its |the )?(?:{'|'.join({'front': ['front', 'near', 'nearest'], 'back': ['back', 'far', 'farthest']}.get(base, [base]))})(?: (?:row|side|edge|line))?")),
    *patterns("side", lambda m: number(m["count"]), f"(?:with )?(?:a |the |its )?base {_HAS}{_COUNT}(?: wide| long)?", f"{_COUNT} (?:along|in|at|on|forming|as|for) (?:its |the )?(?:base|bottom)(?: row| side| line)?"),
]  # fmt: skip
"""Value: a part, and where it points; "base": how many blocks there are along the side over against the tip."""

_OF_IT = f"(?: of {_IT})?"
_PLACES = {
    "center": (f"(?:BE )?(?:right |exactly |directly |placed |set |put )?(?:in|at|as|for|into|forming) (?:(?:the|its|a|her) )?(?:very |exact |dead )?(?:middle|center|heart|core|hub|crossing|hole)(?: BLOCK| one| piece| point| position)?{_OF_IT}(?! of the TABLE| row)",
               f"(?:(?:the|its|a|whose) )?(?:middle|center|central|heart|core|hub)(?: BLOCK| one| piece)?(?! of the TABLE| row){_OF_IT}",
               f"(?:BE )?(?:inside|within)(?: (?:of )?{_IT})?", "(?:BE )?(?:in )?between(?: them)?", "dead center"),
    "around": ("(?:BE )?(?:all )?(?:a?round|surrounding)(?: (?:it|them|that|this|the (?:middle|center)(?: BLOCK| one)?|the one in the (?:middle|center)|that one))?(?: on (?:all|its|the) (?:4 )?sides)?(?! (?:an?|the|NUM|this) )(?! COLOR)",
               "(?:BE )?on (?:all|the|its) (?:4 )?sides(?: of it)?", "(?:BE )?(?:at|on|for) the outside", "(?:the )?outer (?:ones|BLOCK)"),
    "corners": (f"(?:BE )?(?:(?:in|at|on|as|for) )?{_ITS}corners?(?: BLOCK| ones)?{_OF_IT}", "at corners"),
    "arms": (f"(?:BE )?(?:(?:in|at|as|for|on|forming) )?{_ITS}(?:arms|ends|tips|branches)(?: of it)?{_TWO_PARTS}",
             "(?:BE )?(?:on|at) (?:the|its) outside"),
    "sides": (f"(?:BE )?(?:(?:in|at|as|for|along) )?{_ITS}(?:sides|edges|border|rim|frame|edge)(?: (?:BLOCK|ones))?",
              "(?:BE )?(?:in )?between (?:the corners|corners)"),
    "bar": (f"(?:BE )?(?:(?:in|at|as|for|on|across|forming|along) )?(?:(?:the|its|whose|a) )?{_BAR}{_OF_IT}", "(?:BE )?across"),
    "stem": (f"(?:BE )?(?:(?:in|at|as|for|forming) )?(?:(?:the|its|whose|a) )?{_STEM}{_OF_IT}", "(?:BE )?down(?:wards)? (?:in )?the (?:middle|center)", "(?:BE )?(?:below|underneath|beneath|under it|below it)(?= [,.;])"),
    "tip": (f"(?:BE )?(?:(?:in|at|as|for|on|forming) )?(?:(?:the|its|whose|a) )?(?:tip|point|apex|peak)(?: BLOCK)?{_OF_IT}",),
    "rest": ("(?:all )?(?:of )?(?:the |its )?(?:rest|others|remainder|remaining (?:ones|BLOCK)|other (?:ones|BLOCK))(?: of (?:it|them))?", "everything else", "everywhere else|elsewhere|all around it", "(?:all )?other BLOCK"),
}  # fmt: skip
PLACES: list[Pattern] = [
    *(found for place, texts in _PLACES.items() for found in patterns("place", place, *texts)),
    *(found for place in ("center", "corners", "tip", "bar") for text in _PLACES[place]
      for found in patterns("place", place, f"(?:the )(?:BLOCK|ones?)(?: (?:that|which) BE)? (?:{text})")),
    *(found for place, texts in _PLACES.items() if place != "rest" for text in texts
      for found in patterns("part", lambda m, place=place: (place, number(m["many"])),
        f"(?P<many>NUM)(?: BLOCK)?(?: of (?:them|these))?(?: more| others?)? (?:goes |go |comes |come |on |placed )?(?:{text})")),
    *patterns("part", ("around", 4), "(?:one |a single one )(?:more )?(?:on|at|for) (?:each|every)(?: one)?(?: of (?:its|the))?(?: 4)? (?:sides?|arms?|ends?)(?: of it)?"),
    *patterns("part", lambda m: ("rest", number(m["many"])), "(?:all )?(?:the )?(?:other|remaining) (?P<many>NUM)(?: ones| BLOCK)?"),
    *patterns("each", "around", "(?:BE )?(?:on|at|for) (?:each|every)(?: one)?(?: of (?:its|the))?(?: 4)? sides?(?: of it)?"),
    *patterns("each", "arms", "(?:BE )?(?:on|at|for|in) (?:each|every)(?: one)?(?: of (?:its|the))?(?: 4)? (?:arms?|ends?)(?: of it)?"),
    *patterns("each", "corners", "(?:BE )?(?:in|at|on|for) (?:each|every)(?: one)?(?: of (?:its|the))?(?: [34])? corners?(?: of it)?"),
    *patterns("pivot", "around", "(?:BE |all |placed |arranged |set |put )*(?:a?round|surrounding|surround|surrounds|encircling|encircle|encircles|enclosing)"),
    *patterns("pivot", "within", "(?:(?:that |which )?(?:BE )?)?(?:surrounded|encircled|enclosed|ringed|framed) (?:by|with)"),
]  # fmt: skip
"""Kinds "place", "part" (a place with a number of blocks) and "pivot" (what stands before it is around what stands
behind it, or "within")."""

LOOKS: list[Pattern] = [
    *patterns("any", True, "(?:, )?(?:of |in )?(?:any|whatever|whichever|any old) colors?(?: at all| you like| you want)?(?: (?:(?:BE|are|is) )?(?:fine|ok|okay|good|allowed|will do|works|goes))?",
        "(?:the )?colors? (?:does|do|is|are) (?:not (?:matter|important)|unimportant|free)", "no matter (?:what|which) colors?", "(?:i )?do not (?:care|mind) (?:about )?(?:what |which |the )?colors?(?: (?:they|it) (?:are|is|have))?", "what color"),
    *patterns("lot", None, "(?P<count>NUM) of (?:them|these|which)(?: BLOCK)? (?:BE )?(?:in )?(?P<color>COLOR)"),
    *patterns("total", lambda m: number(m["count"]), "(?:, )?of which there (?:BE) (?P<count>NUM)(?= ,)",
        "(?P<count>NUM) of (?:them|these)(?= [,.;!])"),
    *patterns("lot", None, "(?:all|every one|each one|everything|each BLOCK|every BLOCK)(?: of (?:them|these|it|the BLOCK)| BLOCK)?(?: (?:BE|in))? (?P<color>COLOR)(?! (?:but|except|apart|save))"),
    *patterns("colors", "alternating",
        "(?:in |of |with |so that )?(?:the |strictly )?(?:alternating|alternate|alternates|alternately|alternation)(?: (?:in )?colors?| pattern| order)*",
        "(?:the )?colors? (?:should |must |shall )?(?:alternate|alternates|alternating)", "(?:in |taking )turns", "by turns", "in turn",
        "(?:the )?(?:two )?colors (?:take|taking) turns"),
    *patterns("colors", "different",
        "(?:each|all|every one)(?: one| of them| BLOCK)?(?: BE)?(?: has| of| in| with)?(?: a)? different colors?", "(?:of |in |with )?(?:all )?different colors",
        "(?:each|every)(?: one| of them| BLOCK)? (?:BE )?(?:has |of |in |with )?(?:its own|another|a color of its own)(?: color)?", "no 2 (?:BLOCK )?(?:of|in|have|with) the same color"),
]  # fmt: skip

OWN_BREAKS: list[Pattern] = patterns("break", None, r"[()]", ",? ?(?:and )?(?:so that|such that|in such a way that|in a way that)", ", and|, with|, where|, but|, while|: with")
EXCEPT: list[Pattern] = patterns("except", None, r"but(?: for)?", r"except(?: for)?|apart from|save for|other than", ", (?:but|except(?: for)?)")
OWN_GLUE: list[Pattern] = [
    *patterns("glue", None, "standing|placed|sitting|lying|making|arranged|sits?|rests?|so|to make|to give|that together|which together|together"),
    *patterns("glue", None, "(?:and )?nowhere else|do|dream of|imagine|picture|in plan|plan|forming|be used|used|used for|(?:that |which )?be (?:formed|made|built|laid|shaped)(?: of| from| by| with| out of)?|also|ordinary|given|"
        "some|so|love|been|have|down|altogether|overall|in total|in all|total|they|together they|flat|lying flat|laid flat|lying|laid|out|out of|'s|exactly|there|here|its|whose|their", ", (?:which|that) (?:BE)"),
    *patterns("glue", None, "(?:in |into |to |like |as )?(?:an? |the )?(?:shape|form|figure|pattern|arrangement|formation|layout|letter)(?: (?:of|like|:))?(?: an?| the)?"),
    *patterns("glue", None, "(?:the |these |all the |all these |my |your )?(?:BLOCK)(?= (?:form|make|should|must|shall|are|stand|lie|in|as|into|on|to)\\b)"),
    *patterns("glue", None, "only(?= [,.;!])", "take|grab", "by",
        "(?:arrange|put|place|lay|set|use|form|make|bring|organize)(?: out)? (?:them|these)(?: all| out)?", "(?:could|can|would|will|should|shall|must) the robot(?: please| kindly)?",
        "(?:one|a single|single)(?= (?:circle|ring|square|plus|cross|triangle|rectangle|letter|[TLUV])\\b)", "(?:it|they) (?:looks?|becomes?|makes?|forms?|should|shall|must)(?: like)?"),
    *patterns("glue", None, "(?:(?:there|here) (?:are|is)|(?:we|i|you) have)", "(?:out of|from|of|with|using|use) (?:all of )?(?:them|these)", "for which",
        "all the way (?:a?round)"),
    *patterns("glue", None, "(?:a?round)(?= in (?:a )?(?:circle|ring))", "shape|draw|makes|shaped|pattern|color|colored|in color|colour"),
    *patterns("glue", None, "looks? like|that looks like|like|resembling|represents|show|result|should|shall|must|would|makes up|become|becomes|becoming|serves? as|acting as|acts as|take|takes|play|plays"),
]  # fmt: skip

PATTERNS: list[Pattern] = [
    *FIGURES, *FILL, *SIZES, *LIMBS, *WAYS, *PLACES, *LOOKS, *LOTS, *WHERE, *EXCEPT, *BREAKS, *OWN_BREAKS, *GLUE, *OWN_GLUE,
]  # fmt: skip
