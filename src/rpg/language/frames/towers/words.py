"""The words that several towers are told in."""

from __future__ import annotations

import re

from rpg.language.frames.groups.shared_words import ALSO, LOTS, OF, STARTS, STOPS
from rpg.language.frames.pieces import number, patterns
from rpg.language.frames.shared import GLUE, WHERE

_SIDES = {
    "left": "left of",
    "right": "right of",
    "behind": "behind",
    "in front": "in front of",
    "next": "next to",
    "beside": "next to",
}
_PAIR = {"both": 2, "pair of": 2, "twin": 2}
T = "(?:tower|stack|pillar)"
TS = "(?:towers|stacks|pillars)"
_ADJ = (
    "(?:(?:little|small|neat|separate|identical|equal|single|own|different|similar|individual|short|matching|twin|"
    "single color|one color|monochrome|distinct|such) )"
)
ORD = "first|second|third|fourth|fifth|last|left|right|middle|center|leftmost|rightmost"
_IN = "(?:(?:in|into|as|to|on|forms?|makes?) )?"
_OF = f"(?: {OF})*(?: :)?"
_EACH = f"(?:each|every|either|both|all)(?: one)?(?: of (?:them|these|the (?:NUM )?(?:{TS})))?(?: {TS}| {T})?(?! other)"
_HAS = (
    "(?:(?:of|with|has|have|contains|contain|consists of|consist of|consisting of|containing|made of|made from|"
    "made up of|BE|must|should|be|to|exactly|shall|will|have|has to|being|getting|gets|get|just|has exactly) )*"
)
_HIGH = "(?:high|tall|in height)"

PATTERNS = [
    *patterns("tinted", lambda match: (_PAIR.get(match["count"]) or number(match["count"]), match["color"]),
        f"(?:in |into |as |of )?(?:the )?(?P<count>NUM|pair of|both|twin) {_ADJ}*(?P<color>COLOR) {TS}"),
    *patterns(
        "whole", lambda match: (match["color"], int(match["size"])),
        f"(?:a|an|one|another|the other)(?: {T})? (?P<color>COLOR)(?: {T}| one)?(?: ,)? (?:of |which |that |BE |"
        f"with |has |height |having )*(?P<size>[2-9])(?: BLOCK)?(?: {_HIGH})?(?! (?:COLOR|SIZE|x|cm)\\b)",
        f"(?:the )?(?P<color>COLOR) (?:{T}|one)(?: \\()? (?:of |which |that |BE |with |has |height |having |: |, "
        f")*(?P<size>[2-9])"
        f"(?: BLOCK)?(?: {_HIGH})?(?: \\))?(?! (?:COLOR|SIZE|x|cm)\\b)", f"{T} (?P<color>COLOR)(?: ,| :)? "
        f"(?P<size>[2-9])"
        f"(?: BLOCK)?(?: {_HIGH})?(?! (?:COLOR|SIZE|x|cm|each)\\b)",
        f"(?:a|an|one|another|the other) (?P<color>COLOR)(?: {T}| one)? \\( (?P<size>[2-9])(?: BLOCK)?(?: "
        f"{_HIGH})? \\)", f"(?:a|one|another|the other) (?P<size>[2-9]) (?:BLOCK )?(?:{_HIGH} )?(?P<color>COLOR) {T}",
        f"(?:(?:a|an|one|another|the other|other)(?: {T})?|{T})(?: of| with)? (?P<size>[2-9])(?: BLOCK)?(?: "
        f"{_HIGH})? (?:(?:in|of|"
        f"all|with|only|colored) )*color (?P<color>COLOR)",
        f"(?:a|an|one|another|the other)(?: {T})? (?P<size>[2-9])(?: BLOCK)? {_HIGH}(?: {T})?(?: ,)? (?:BE |in |of "
        "|from |all |only |made of |made from )*(?P<color>COLOR)(?: BLOCK)?",
    ),
    *patterns("alone", lambda match: match["color"],
        f"(?:a|an|one|another) (?P<color>COLOR) {T}", f"(?P<color>COLOR) {T}(?= (?:,|and|\\.|;))"),
    *patterns(
        "line", None,
        "(?:BE )?(?:lined up |standing |arranged )?(?:in|into|along|forming) (?:a|one) (?:straight |single "
        ")?(?:row|line)", "lined up|line up",
    ),
    *patterns(
        "relation", lambda match: f"The {match['one']} tower is {_SIDES[match['side']]} the {match['other']} tower.",
        f"(?:with )?the (?P<one>COLOR)(?: {T}| one| BLOCK)? (?:BE )?(?:placed |put )?(?:to the |on the |"
        "immediately |at the )*(?P<side>left|right|behind|in front|next|beside)(?: of| to)? (?:the "
        f")?(?P<other>COLOR)(?: {T}| one| BLOCK)?",
    ),
    *patterns(
        "way", None,
        "(?:(?:reading|read|going|counted|seen|in (?:that|this|the given) order) )*(?:from )?(?:the )?left "
        "(?:through )?to (?:the )?right(?: :)?",
    ),
    *patterns(
        "between", lambda match: match["color"],
        "(?:with |and )?(?:a|one) (?P<color>COLOR) (?:BLOCK|one) (?:BE )?(?:in )?between (?:them|the(?: NUM)? "
        f"{TS})",
    ),
    *LOTS,
    *WHERE,
    *STARTS,
    *STOPS,
    *ALSO,
    *GLUE,
    *patterns(
        "figure", lambda match: _PAIR.get(match["count"]) or number(match["count"]) if match["count"] else None,
        "(?:(?:in|into|to|as|of) )?(?:the |exactly |a set of |a group of )*(?:(?P<count>NUM|both|pair of|twin) "
        f")?{_ADJ}*{TS}",
    ),
    *patterns("figure", lambda match: int(match["count"]), f"(?:into |in )?(?P<count>[2-9]) {_ADJ}*{T}",
    f"{TS} x (?P<count>[2-9])"),
    *patterns("figures", lambda match: (number(match["count"]), int(match["size"])),
        f"(?:in |into |as |of )?(?:the )?(?P<count>NUM) {_ADJ}*(?P<size>[2-9]) (?:BLOCK (?:{_HIGH} )?|{_HIGH} ){TS}"),
    *patterns(
        "size", lambda match: number(match["size"]),
        r"(?P<size>[2-9])(?= (?:[,.;]|$))",
        f"(?:BE )?(?:of |each of |with )?(?:exactly )?(?P<size>[2-9])(?: BLOCK)?(?: (?:{_HIGH}|each|apiece|in "
        f"each(?: {T})?|per {T}))+", r"of (?:exactly )?(?P<size>[2-9])(?: BLOCK)?(?! (?:COLOR|SIZE)\b)",
        rf"(?:(?:with|where) )?{_EACH} {_HAS}(?P<size>[2-9])(?: BLOCK)?(?: {_HIGH})?(?! (?:COLOR|SIZE|x)\b)",
        "(?:BE )?(?:each |both |all )?(?:of |with |at )?(?:a |the )?height (?:of |BE )?(?P<size>[2-9])(?: "
        "BLOCK)?(?: each)?", f"(?P<size>[2-9]) (?:BLOCK )?(?:per|in each|in every|to a|for each|in) {T}",
        f"(?:BE )?(?P<size>[2-9]) BLOCK {_HIGH}", "(?:high|tall) (?P<size>[2-9])",
    ),
    *patterns(
        "heights", lambda match: [int(said) for said in re.findall(r"\d", match["list"])],
        "(?:BE |of |with |having )*(?:the |different )?(?:heights?|sizes) (?:of |: |BE )*(?P<list>[1-9](?:(?: "
        ",)?(?: and)? [1-9])+)(?: BLOCK)?",
        f"(?:BE |of |with )*(?P<list>[1-9](?:(?: ,)?(?: and)? [1-9])+)(?: BLOCK)? {_HIGH}",
        r"of (?P<list>[1-9](?: , [1-9])*(?: ,)? and [1-9])(?: BLOCK)?(?! (?:COLOR|SIZE)\b)",
    ),
    *patterns(
        "even", None,
        "(?:BE |of |with )*(?:the )?(?:same|equal|identical|equally tall|equally high|even|as tall as each other)(?: "
        "(?:height|size|high|tall|number of BLOCK))?|equally(?: high| tall)?|alike",
    ),
    *patterns(
        "basis", "color", "(?:by|per|for each|for every|according to) (?:their |its |the |own )*color",
        "(?:for|of|in) (?:each|every one) of the (?:NUM )?colors?", "color wise",
        f"(?:one|a|an|its own|own) {_ADJ}*{T} (?:per|for each|for every|of each|of every|for|in each) (?:one "
        ")?(?:of the )?colors?", "one (?:per|for each|for every|of each|of every|for|in each) color",
        f"(?:each|every one|all)(?: one| {T})? (?:in |of |with |has |having )?(?:a |its )?(?:color of its own|"
        "own color|color for itself)",
        "(?:each|every) color (?:BE |has |have |gets |forms |makes |becomes |goes |should have |must have |must "
        f"form |must be |should form |be |stacked |put |placed |built |made |into |to |in |on )*(?:a |an |its |one "
        f"|in )*{_ADJ}*{T}(?: of its own| for "
        "itself| by itself)?",
        f"{_EACH} (?:tower |stack )?(?:BE )?(?:in |of |with |has |have |having )*a different color",
        "sorted by color",
    ),
    *patterns(
        "basis", "single",
        f"{_EACH} {_HAS}(?:only |just |in )*(?:of |blocks of |BLOCK of )*(?:a |one |the )?(?:single|one|same|just "
        "one|only one) (?:single )?color(?: only| alone)?", f"{_EACH} BLOCK (?:have|has|BE|of) (?:the )?same color",
        f"(?:each |all )?(?:of|in|with) (?:one|a single|the same|only one) color(?: each| per {T})?",
        "(?:(?:in|with|of|using) )?(?:the )?colors(?: :)?(?= COLOR)", f"(?:single|one|same) color(?= {TS})",
        "(?:of |in |with )?(?:the |a )?same color(?:ed)?",
        f"(?:(?:so that|such that) )?(?:{_EACH} )?(?:BE )?(?:monochrome|monochromatic|unicolored|single colored|"
        f"one colored)",
        "(?:no|without) (?:mixed colors|mixing(?: of)? (?:the )?colors)", "(?:do not|never) mix (?:the )?colors",
    ),
    *patterns("basis", "different",
        f"no (?:two|2) (?:{TS}|of them) (?:BE |have |of |in |with )*(?:the )?same(?: color)?",
        f"{TS} (?:have|of|in|with|BE|are of|are in|have all) different colors"),
    *patterns(
        "each", None,
        f"(?:(?:in|with|where|of|for|on) )*{_EACH}(?: (?:with|has|have|of|contains?|is|are|must|should|be|"
        "consists? of|made of|made from|to|shall|will|needs?|built (?:from|of)|composed of|includes?|gets?|exactly|"
        "made up "
        "of|:))*",
        "of which each (?:has|is)|each of which (?:has|is|consists of|contains)|apiece",
    ),
    *patterns(
        "place", "at the bottom",
        "(?:BE )?(?:(?:at|on|in|as|forming) )?(?:the |its )?(?:very )?(?:bottom|base|lower part|foot)(?: (?:one|"
        "block|of it))?(?: BE)?(?: :)?", "(?:BE )?(?:the )?lower(?: one| BLOCK)?(?: BE)?",
        "(?:BE )?(?:below|underneath|under it|down|downstairs)",
    ),
    *patterns(
        "place", "at the top",
        "(?:BE )?(?:(?:at|on|in|as) )?(?:the |its )?(?:very )?top(?: (?:one|block|of it))?(?: BE)?(?: :)?",
        "(?:BE )?(?:the )?upper(?: one| BLOCK)?(?: BE)?", "(?:BE )?(?:above|above it|over it|on it)",
        "(?:(?<=cube )|(?<=block )|(?<=one )|(?<=cubes )|(?<=blocks ))(?:BE )?up(?= (?:(?:,|and|\\.|;) |$))",
    ),
    *patterns(
        "over", None, "(?:BE )?(?:directly )?(?:on|upon|over|on top of|above|atop|sitting on|standing on|stacked on)",
    ),
    *patterns("under", None, "(?:BE )?(?:directly )?(?:under|below|beneath|underneath)"),
    *patterns(
        "slot", lambda match: match["slot"],
        f"{_IN}(?:the |a |an |its )*(?P<slot>one|a|other|another|{ORD})(?: (?:hand|side))? {_ADJ}*{T}{_OF}",
        f"{_IN}(?:the )?(?P<slot>other|another|{ORD})(?! BLOCK)(?: one| hand one)?{_OF}",
        "in (?P<slot>one)(?: of them)?(?: of)?", f"(?P<slot>{T}) (?:of|with|from|made of|made from|:)",
f"(?P<slot>one)(?: of them)? (?:{OF}|:)(?: {OF})*", f"(?:the )?(?P<slot>one|other|first|second) of which{_OF}",
        f"{T} (?P<slot>[1-5A-E])(?: {OF}| =| :)+",
        f"(?P<slot>a) {_ADJ}*{T}{_OF}",
    ),
    *patterns(
        "near", "next to it",
        "(?:BE |standing |right |directly |immediately |placed )*(?:next to|beside|alongside|near)(?= an? )|(?:BE |"
        "standing |right |directly |immediately |placed )*(?:next to|beside|alongside|near) (?:it|that|this|that "
        "one|the first|the first one|the other)",
    ),
    *patterns(
        "near", "next to each other",
        f"(?:(?:{TS} )?BE )?(?:right |standing |closely )*(?:next to|beside) (?:each other|one another)|side by "
        "side|adjacent(?: to each other)?|neighboring",
    ),
    *patterns(
        "near", "near each other", f"(?:(?:{TS}|{T}) )?(?:BE |standing )*(?:near|close to|close by) (?:each other|"
            f"one another)|close "
        "together",
    ),
    *patterns(
        "near", "touch",
        f"(?:that |which |so that |and |with |the )*(?:they |{TS} )*(?:BE )?(?:must |should |all )?(?:touching|"
        "touch)(?: (?:each other|one another))?", "no gaps? between (?:them|the towers)",
    ),
    *patterns(
        "near", "do not touch",
        f"(?:that |which |so that |and |the )*(?:they |{TS} )*(?:must|may|should|shall|do|can|are) not (?:be "
        ")?(?:touch|touching)(?: (?:each other|one another))?",
        "without touching(?: (?:each other|one another))?|not touching(?: (?:each other|one another))?",
    ),
    *patterns(
        "near", lambda match: f"are {match['least'] or ''}{match['length']} {match['unit']} apart",
        rf"(?:with |the |that |which )*(?:{TS} )?(?:BE )?(?:(?P<least>at least) )?(?P<length>[\d.]+) (?P<unit>cm|"
        "mm) (?:apart|from each other|away from each other)",
    ),
    *patterns(
        "glue", None,
        "(?:the )?colors|sort|sorted|divide|divided|split|split up|distribute|distributed|distribute over|over|"
        "stack|stacked|up|separate|so that|such that|so|that|block|to|become|becomes|turn into|end up|ends up|them|"
        "these|those|they|erect|raise|pile up|stack up|build up|all|only",
    ),
]  # fmt: skip
