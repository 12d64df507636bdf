"""What people say of a row, a line or a column of blocks, whatever the blocks are."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, patterns

_END = "(?: end| side| edge| hand side| hand end| hand| most end| place| spot| position)"
_OF_IT = (
    "(?: of (?:it|them|all|this|that|the (?:whole |entire )?(?:row|line|lineup|column|queue|sequence)|the (?:3|4|5|6|"
    "7|8|9)))"
)
_ONE = "(?: (?:BLOCK|one|ones|place|position|spot|slot|space))"
_VERY = "(?:very |far |extreme |outer |utmost |most )"
_SIDES = {
    "left": ("left", "leftmost|left most|lefternmost"),
    "right": ("right", "rightmost|right most"),
    "front": ("front|near", "nearest|frontmost|foremost|front most|closest"),
    "back": ("back|rear|far", "farthest|furthest|rearmost|hindmost|farthest away|furthest away|most distant"),
}
"""The ends of a row or column by name: words for the end, and words for the block that is nearest to it."""
_VIEWER = "(?: (?:to|from) (?:me|you|us|the (?:robot|viewer|camera|front|front edge)))"
_NTH = "(?P<nth>first|second|third|fourth|fifth|sixth|seventh|eighth|ninth|tenth|1st|2nd|3rd|[4-9]th|10th)"
_FROM = (
    "(?: (?:one |BLOCK |place |position )?(?:when )?(?:counted |counting |seen |reading |read |starting |as seen "
    ")?(?:from|on) (?:the )?(?P<side>left|right|front|near|back|rear|far)(?: hand)?(?: end| side| edge)?)"
)
_HAS = "(?:occupies|occupy|occupying|takes|take|taking|fills|filling|gets|has|holds|holding)"
_NAMES = {"near": "front", "rear": "back", "far": "back"}
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def _nth(said: str) -> int:
    """The number that an ordinal says."""
    return _ORDINALS.index(said) + 1 if said in _ORDINALS else int("".join(c for c in said if c.isdigit()))


def _side(said: str) -> str:
    return _NAMES.get(said, said)


_NOT_OF = "(?! of (?!(?:a|one) (?:row|line|column)))"


def _at_side(side: str) -> list[Pattern]:
    """Ways to say that blocks are at one of the ends, or which blocks these are."""
    end, most = _SIDES[side]
    across = side in ("left", "right")
    bare = f"|(?:BE )?(?:on|at|to) {side}(?= (?:[,.;)]|$))|BE {side}(?= (?:[,.;)]|$))" if across else ""
    plain = f"|(?:BE )?(?:on|at|to) the (?:{_VERY})?(?:{end}){_NOT_OF}" if across else ""
    return patterns("place", (side, 1),
        f"(?:BE )?(?:placed |located |positioned )?(?:on|at|in|to|forming|as|occupying|occupies|occupy|taking|takes|"
        f"filling|fills) (?:the|its) {_VERY}?(?:{end}){_END}(?:{_OF_IT}|{_NOT_OF}){plain}{bare}",
        f"(?:BE )?(?:on|at) (?:the )?(?:{_VERY})?(?:{end}){_END}{_NOT_OF}",
        f"(?<!from )(?<!from the )(?:(?:on|at) )?(?:the |its )?(?:{_VERY})?(?:{end}){_END}?(?= (?:BE |: ))(?: "
        f"BE)?", f"the (?:{_VERY})?(?:{end}){_END}? (?:one|BLOCK)(?= (?:BE |: ))(?: BE)?",
        f"(?:the )?{_VERY}?(?:{end}){_END}(?= (?:a|one|the|NUM) )",
        f"(?:BE )?(?:the )?(?:BLOCK |one )?(?:BE )?(?:the )?(?:{most})(?:{_ONE}| "
        f"end)?{_VIEWER}?{_OF_IT}?", f"(?:BE )?(?:on|at|in) the (?:{most}) (?:end|place|position|spot|slot){_OF_IT}?",
        f"(?:the |that )?(?:BLOCK|one|ones) (?:at|on|to) the (?:{_VERY})?(?:{end}){_END}?{_NOT_OF}{_OF_IT}?",
        *([f"(?:BE )?on the (?:far|outer|very) {end}"] if side in ("left", "right") else []),
        *([f"(?:BE )?(?:the )?(?:nearest|closest){_ONE}?{_VIEWER}"] if side == "front" else []),
        *(["(?:BE )?(?:farthest|furthest)(?: away)?(?: from (?:me|you|us|the (?:robot|viewer|"
            "camera)))?"] if side == "back" else []),
    )  # fmt: skip


NEIGHBORS = (
    "(?:with )?(?:its|both its|the) (?:2 |immediate |direct |both )*neighbors(?: on (?:both|either|each) sides?)?(?= "
    "(?:BE|COLOR) )(?: BE)?|(?:the )?(?:2|ones|BLOCK|2 ones|2 BLOCK) (?:right |immediately |directly )?"
    "(?:next to|beside) it(?: on (?:both|either|each) sides?)?(?= (?:BE|COLOR) )(?: BE)?"
)
"""Those to both sides of what was told of."""

PLACES: list[Pattern] = [
    *(pattern for side in _SIDES for pattern in _at_side(side)),
    *patterns("place", lambda match: (_side(match["side"]), _nth(match["nth"])),
        f"(?:BE |{_HAS} )?(?:in |at |as )?(?:the |its )?{_NTH}{_ONE}?(?: in)?{_FROM}", f"(?:BE )?on the {_NTH} "
        f"(?:place|"
        f"position|spot|slot){_FROM}"),
    *patterns("place", lambda match: (_side(match["side"]), int(match["n"])),
        r"(?:BE )?(?:in |at |on )(?:the )?(?:position|place|spot|slot|number) (?P<n>\d+)" + _FROM),
    *patterns("place", lambda match: ("first", int(match["n"])), r"(?:BE )?(?:in |at |on )(?:the )?(?:position|place|"
        r"spot|slot|number) (?P<n>\d+)(?! from)", r"(?:the )?(?:position|place|spot|slot|number) (?P<n>\d+)(?= (?:is|"
        r":|has) )"),
    *patterns("place", lambda match: ("first", _nth(match["nth"])),
        f"(?:BE |{_HAS} )?(?:in |at )?(?:the |its )?{_NTH}{_ONE}(?: in (?:the )?(?:row|line))?(?: BE)?(?! "
        f"from)", f"BE (?:the )?{_NTH}(?: in (?:the )?(?:row|line))?(?! from)",
        f"(?:the )?{_NTH}(?: in (?:the )?(?:row|line))? BE"),
    *patterns("place", ("first", 1),
        "(?:to )?(?:starts|starting|start|begins|beginning|begin|opens|opening|led)(?: off)?(?: with| "
        "by)", "first", "(?:BE )?(?:at|in) the (?:beginning|start|front of the row|head)(?: of (?:it|the (?:row|"
        "line)))?"),
    *patterns("place", ("last", 1),
        "(?:to )?(?:ends|ending|end|finishes|finishing|finish|closes|closing)(?: up| off)?(?: with| in| "
        "by)", "(?:BE )?(?:the )?last(?: BLOCK| one| place| position)?(?: in (?:the )?(?:row|line))?(?: BE)?",
        "(?:BE )?in (?:the )?last (?:place|position|spot)", "(?:BE )?at the end(?: of (?:it|the (?:row|line)))?"),
    *(pattern for side in ("left", "right") for pattern in patterns("place", (side, 1),
        f"(?:starts|starting|start|begins|beginning|begin)(?: off)? (?:at|on|from) the {side}(?: end| side)? with",
        f"(?:ends|ending|finishes|finishing|finish) (?:up )?(?:at|on) the {side}(?: end| side)? with",
        f"(?:starts|begins) (?:at|on|from) the (?:far )?{side}(?: end| side)?(?= (?:[,.;)]|and|$))")),
    *patterns("place", lambda match: ("first", _nth(match["nth"])), f"(?:the )?{_NTH}(?= (?:a |an |one )?(?:COLOR|"
        f"[A-Z]) )"),
    *(pattern for side in ("left", "right") for pattern in patterns("place", (side, 1),
        f"(?:BE )?(?:placed )?(?:(?:to|on|at) )?(?:the |its )?{side}(?: hand)?(?: side)? of (?:it|that|this|the "
        f"(?:middle|"
        f"center)(?: one| BLOCK)?)", f"(?:BE )?(?:placed )?(?:to|on|at) its {side}(?: side)?")),
    *patterns("place", ("left", 1), "(?<!the )(?<!from )left(?= (?:and|[,.;]|$))"),
    *patterns("place", ("right", 1), "(?<!the )(?<!from )right(?= (?:and|[,.;]|in|$))"),
    *patterns("place", ("front", 1), "(?:BE )?(?:at|in) the front(?= (?:[,.;)]|and|with|$))"),
    *patterns("place", ("back", 1), "(?:BE )?(?:at|in) the (?:back|rear)(?= (?:[,.;)]|and|with|$))"),
    *patterns("place", ("middle", 0), "(?:the )?(?:middle|center)(?= COLOR )"),
    *patterns("place", ("middle", 0), r"(?:the )?middle(?= \d)", "(?:BE )?(?:on |at )?(?:the )?inside(?= (?:[,.;)]|"
    "and|$))"),
    *patterns("place", ("last", 2), "(?:BE )?(?:the )?(?:next to last|second to last|last but one|second last)(?: "
        "BLOCK| one| place)?(?: BE)?"),
    *patterns("place", ("each end", 0), f"(?:BE )?(?:placed )?(?:at|on) (?:each|either|every)(?: of the| of its)?(?: "
        f"2)? ends?{_OF_IT}?"),
    *patterns("place", ("ends", 0),
        f"(?:BE )?(?:placed )?(?:at|on|in|form|forming|as) (?:both|the|its|the 2|both the|both of its|both of the|"
        f"the outer|the opposite|opposite)(?: 2| outer| outer 2)? ends{_OF_IT}?",
        f"(?:the )?(?:ones|2|2 ones|BLOCK|2 BLOCK) (?:at|on|in) (?:the|both|the 2|its|both the) ends{_OF_IT}?(?: BE)?",
        f"(?:at |on )?(?:with )?(?:both|the|its|the 2|the outer|both of the|both of its) (?:ends|end blocks|end "
        f"cubes|outer ones|outer BLOCK){_OF_IT}?(?: BE(?: both)?)?", "(?:BE )?(?:on|at|to) the "
        "outsides?", "(?:BE )?(?:on the )?outside(?= (?:[,.;)]|and|$))", "(?:the )?outer (?:2|ones|BLOCK|2 "
        "BLOCK)(?: BE(?: "
        "both)?)?", "(?:the )?(?:first|leftmost)(?: one| BLOCK)? and (?:the )?(?:last|rightmost)(?: one| ones| "
        "BLOCK)?(?: BE(?: both)?)?", "(?:BE )?(?:the )?(?:2 )?outermost(?: ones| BLOCK)?",
        "(?:starts|starting|start|begins|beginning|begin) and (?:ends|ending|end|finishes|finishing|finish) (?:with|"
        "in|by)", "(?:BE )?(?:flanked|framed|bordered|enclosed|bracketed|sandwiched) (?:on both sides |on each side |"
        "at both ends )?by"),
    *patterns("place", ("ends", 0), "(?:the )?ends(?= (?:COLOR|BE) )(?: BE)?"),
    *patterns("place", ("end", 0), f"(?:BE )?(?:at|on) (?:one|1|an) (?:of the (?:2 )?ends|end){_OF_IT}?"),
    *patterns("place", ("other", 0), f"(?:BE )?(?:at|on) the (?:other|opposite)(?: end| one){_OF_IT}?"),
    *patterns("place", ("middle", 0),
        f"(?:BE )?(?:right |exactly |just |precisely |directly )?(?:in|at|on|occupying|occupies|occupy|taking|takes|"
        f"filling|fills) (?:the|its) (?:very |exact |dead )?(?:middle|center)(?: position| place| spot)?(?:{_OF_IT}|"
        f"{_NOT_OF})(?: BE)?", "(?:BE )?(?:in )?(?:the )?(?:middle|center)(?= : )",
        "(?:BE )?(?:middle|center)(?= (?:[,.;)]|and|$))", "(?:the )?(?:middle|central|center|centermost|middlemost)(?: "
        "BLOCK| one| ones| position| place)(?: BE)?", "(?:BE )?(?:hides |hide |hidden |halfway |squeezed |sandwiched "
        "|wedged |"
        "caught )?(?:in |right |exactly )?between(?: them| those| these| the ends| the 2 ends| the 2(?! COLOR)| the "
        "2 of them)?", "in the (?:middle|center)(?= (?:a|one|the|1) )"),
    *patterns("place", ("sides", 0), "(?:the |both |its )?sides(?= (?:COLOR|BE) )(?: BE)?",
        "(?:BE )?(?:(?:on|at|to) )?(?:each|either|both|every)(?: one)?(?: of (?:its|the 2|the))? sides?(?: of "
        "(?:it|that|"
        "them))?", "(?:BE )?(?:to the )?left and right of (?:it|that)", "(?:BE )?to (?:its|the) left and (?:to "
        ")?(?:its )?right", NEIGHBORS),
]  # fmt: skip
"""Kind "place": a name and a number from there: ("left", 2) is the second from the left; ("first", 1) as it is read;
("middle", 0), ("ends", 0), ("sides", 0) of what is in the middle, ("end", 0) one of the ends, ("other", 0) the other
one."""

_ADJ = (
    "(?:(?:straight|nice|neat|simple|single|long|short|horizontal|tidy|little|lovely|pretty|perfect|clean|proper|"
    "whole|flat|complete|beautiful|well ordered) )"
)
_IN = "(?:(?:in|into|to|as|on|along|of|for|forming|making|make|makes|form|forms) )?"
_LINE = (
    "line|lineup|line up|queue|sequence|single line|linear (?:arrangement|configuration|formation|layout|sequence|"
    "order|"
    "structure)"
)
FIGURE: list[Pattern] = [
    *(pattern for noun, words in (("row", "row"), ("line", _LINE), ("column", "column")) for pattern in (
        *patterns("figure", noun, f"{_IN}(?:(?:a|an|one|1|my|our|exactly one|just one|the following) )?(?:and same "
            f")?{_ADJ}*(?:{words})"),
        *patterns("mention", noun, f"{_IN}(?:the|this|that|the same|your) {_ADJ}*(?:{words})(?: itself| 's)?"))),
    *patterns("mention", "row", "from (?:one|either) end of the row to the other(?: end| one)?"),
    *patterns("mention", "line", "from (?:one|either) end of the line to the other(?: end| one)?"),
    *patterns("figure", "line", "(?:align|aligned|aligning|aligns)(?: (?:them|these|it))?(?! (?:to|along|at) )"
        "(?! (?:[^.,;]+ )?with (?:the|a|an|its|this|that) )"),
    *patterns("figure", "line", "(?:line|lines|lined|lining) (?:them |these |it |all of them |them all |(?:the |my "
    "|our |these )?(?:BLOCK|letters|digits|numbers) )?up"),
    *patterns("beside", None, "side by side"),
    *patterns("glue", None, "(?:one|1) (?:after|beside|next to|following) (?:another|the other)"),
]  # fmt: skip
"""Kind "figure" (the noun to tell it by), and "mention" of the one that was told before."""

_AWAY = "(?:(?:that|which|going|running|leading|pointing|extending|leads|runs|goes|extends|lead|run|go) )*"
_READ = (
    "(?:(?:read|reading|listed|counting|counted|going|viewed|seen|told|ordered|running|arranged|starting|beginning|"
    "as seen|as read|when read|which goes|that goes|goes) )?(?:from )?(?:the )?"
)
DIRECTIONS: list[Pattern] = [
    *patterns("direction", "from left to right",
        f"{_READ}(?:far )?left(?: most| hand)?(?: end| side| edge)?(?: of the TABLE)? (?:to|→|towards) (?:the "
        f")?(?:far )?right(?: most| "
        f"hand)?(?: end| side)?", f"{_READ}leftmost to (?:the )?rightmost",
        "(?:starting|beginning|begin|start|counted|listed|reading|read|seen|counting|going) (?:at|from|on) the "
        "(?:far )?left(?: end| side)?", "from (?:the )?left(?: end| side)?(?= (?:[:,.;]|BE|reads|COLOR|$))", "to "
        "the right(?= :)"),
    *patterns("direction", "from right to left",
        f"{_READ}(?:far )?right(?: most| hand)?(?: end| side)? (?:to|→|towards) (?:the )?(?:far )?left(?: most| "
        f"hand)?(?: end| side)?", f"{_READ}rightmost to (?:the )?leftmost",
        "(?:starting|beginning|begin|start|counted|listed|reading|read|seen|counting|going) (?:at|from|on) the "
        "(?:far )?right(?: end| side)?", "from (?:the )?right(?: end| side)?(?= (?:[:,.;]|BE|reads|COLOR|$))"),
    *patterns("direction", "from front to back",
        f"{_READ}(?:front|near|nearest|closest|near side|near end|front end|near edge|front edge)(?: of the TABLE)? "
        f"(?:to|→|towards) (?:the )?(?:back|far|farthest|furthest|rear|far side|far end|back end|far edge|back "
        f"edge)(?: "
        f"of the TABLE)?",
        "(?:starting|beginning) (?:near|closest to|nearest to|nearest|closest|next to|in front of) (?:me|you|us|"
        "the (?:robot|"
        "viewer|camera))(?: "
        "and)?(?: (?:going|running) (?:back|backwards|away))?", "(?:starting|beginning|counted|listed|reading|read) "
        "(?:at|from|in) (?:the )?front", "from (?:the )?front(?= "
        "[:,])"),
    *patterns("direction", "from front to back", f"{_AWAY}(?:straight )?away from (?:me|you|us|the (?:robot|viewer|"
        f"camera|reader))", f"{_AWAY}away(?= [,.:;])"),
    *patterns("direction", "from back to front", f"{_AWAY}(?:straight )?(?:towards?|to) (?:me|you|us|the (?:robot|"
        f"viewer|camera|reader))",
        f"{_READ}(?:back|far|farthest|furthest|rear|far side|far end|back end|far edge|back edge) (?:to|→|towards) "
        f"(?:the )?(?:front|near|nearest|closest|near side|near end|front end|near edge|front edge)",
        "(?:starting|beginning|counted|listed|reading|read) (?:at|from|in) (?:the )?(?:back|rear)", "from (?:the "
        ")?(?:back|rear)(?= (?:[:,.;]|$))"),
    *patterns("listed", None,
        "(?:always )?(?:exactly |precisely |just )?in (?:exactly |precisely )?(?:that|this|the following|exactly "
        "this|exactly that|the given|the stated|the same|this exact|that exact|that very|the said|precisely this|"
        "precisely that) (?:order|sequence)(?: BE)?",
        "(?:exactly |precisely )?in (?:the|this|that) (?:exact |same )?(?:order|sequence) (?:as )?(?:(?:I |i |we |you |"
        "they |it is |they are )?(?:named|mentioned|listed|written|typed|given|told|stated|said|shown|read|spoken|"
        "described|specified|indicated|name|mention|list|say|give|wrote|said them|named them)|of (?:mention|naming|the "
        "list))(?: here| above| below| before)?",
        "(?:in |with |has )?(?:the |a |their |its )?(?:color )?(?:order|sequence|color sequence|pattern|color "
        "pattern)(?: of (?:the )?colors)?(?: BE| of| shall be| reads)?", "(?:the )?colors (?:BE|read|in "
        "order)", "(?:that |which )?(?:reads|reading)", "(?:(?:should|must|shall|has to|to) )?(?:go|goes|run|runs|"
        "read)(?= (?:COLOR|[A-Z]|:) )"),
]  # fmt: skip
"""Kinds "direction" (in which a list is told), and "listed": what is listed is an order."""
