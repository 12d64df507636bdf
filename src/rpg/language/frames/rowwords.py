"""What people say of a row, a line or a column of blocks, whatever the blocks are."""

from __future__ import annotations

from rpg.language.frames.pieces import Pattern, number, patterns

_END = "(?: end| side| edge| hand side| hand end| hand| most end| place| spot| position)"
_OF_IT = "(?: of (?:it|them|all|this|that|the (?:whole |entire )?(?:row|line|lineup|column|queue|sequence)|the (?:3|4|5|6|7|8|9)))"
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
_FROM = "(?: (?:one |BLOCK |place |position )?(?:when )?(?:counted |counting |seen |reading |read |starting |as seen )?(?:from|on) (?:the )?(?P<side>left|right|front|near|back|rear|far)(?: hand)?(?: end| side| edge)?)"
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
    bare = "" if side in ("front", "back") else f"|(?:BE )?(?:on|at|to) {side}(?= (?:[,.;)]|$))|BE {side}(?= (?:[,.;)]|$))"
    plain = "" if side in ("front", "back") else f"|(?:BE )?(?:on|at|to) the (?:{_VERY})?(?:{end}){_NOT_OF}"
    return patterns("place", (side, 1),
        f"(?:BE )?(?:placed |located |positioned )?(?:on|at|in|to|forming|as|occupying|occupies|occupy|taking|takes|filling|fills) (?:the|its) {_VERY}?(?:{end}){_END}(?:{_OF_IT}|{_NOT_OF}){plain}{bare}",
        f"(?:BE )?(?:on|at) (?:the )?(?:{_VERY})?(?:{end}){_END}{_NOT_OF}",
        f"(?:(?:on|at) )?(?:the |its )?(?:{_VERY})?(?:{end}){_END}?(?= (?:BE |: ))(?: BE)?", f"the (?:{_VERY})?(?:{end}){_END}? (?:one|BLOCK)(?= (?:BE |: ))(?: BE)?",
        f"(?:the )?{_VERY}?(?:{end}){_END}(?= (?:a|one|the|NUM) )",
        f"(?:BE )?(?:the )?(?:BLOCK |one )?(?:BE )?(?:the )?(?:{most})(?:{_ONE}| end)?{_VIEWER}?{_OF_IT}?", f"(?:BE )?(?:on|at|in) the (?:{most}) (?:end|place|position|spot|slot){_OF_IT}?",
        f"(?:the |that )?(?:BLOCK|one|ones) (?:at|on|to) the (?:{_VERY})?(?:{end}){_END}?{_NOT_OF}{_OF_IT}?",
        *([f"(?:BE )?on the (?:far|outer|very) {end}"] if side in ("left", "right") else []),
        *([f"(?:BE )?(?:the )?(?:nearest|closest){_ONE}?{_VIEWER}"] if side == "front" else []),
        *([f"(?:BE )?(?:farthest|furthest)(?: away)?(?: from (?:me|you|us|the (?:robot|viewer|camera)))?"] if side == "back" else []),
    )  # fmt: skip


PLACES: list[Pattern] = [
    *(pattern for side in _SIDES for pattern in _at_side(side)),
    *patterns("place", lambda match: (_side(match["side"]), _nth(match["nth"])),
        f"(?:BE )?(?:in |at |as )?(?:the |its )?{_NTH}{_ONE}?(?: in)?{_FROM}", f"(?:BE )?on the {_NTH} (?:place|position|spot|slot){_FROM}"),
    *patterns("place", lambda match: (_side(match["side"]), int(match["n"])),
        r"(?:BE )?(?:in |at |on )(?:the )?(?:position|place|spot|slot|number) (?P<n>\d+)" + _FROM),
    *patterns("place", lambda match: ("first", int(match["n"])), r"(?:BE )?(?:in |at |on )(?:the )?(?:position|place|spot|slot|number) (?P<n>\d+)(?! from)", r"(?:the )?(?:position|place|spot|slot|number) (?P<n>\d+)(?= (?:is|:|has) )"),
    *patterns("place", lambda match: ("first", _nth(match["nth"])),
        f"(?:BE )?(?:in |at )?(?:the |its )?{_NTH}{_ONE}(?: in (?:the )?(?:row|line))?(?: BE)?(?! from)", f"BE (?:the )?{_NTH}(?: in (?:the )?(?:row|line))?(?! from)",
        f"(?:the )?{_NTH}(?: in (?:the )?(?:row|line))? BE"),
    *patterns("place", ("first", 1),
        "(?:to )?(?:starts|starting|start|begins|beginning|begin|opens|opening|led)(?: off)?(?: with| by)", "first", "(?:BE )?(?:at|in) the (?:beginning|start|front of the row|head)(?: of (?:it|the (?:row|line)))?"),
    *patterns("place", ("last", 1),
        "(?:to )?(?:ends|ending|end|finishes|finishing|finish|closes|closing)(?: up| off)?(?: with| in| by)", "(?:BE )?(?:the )?last(?: BLOCK| one| place| position)?(?: in (?:the )?(?:row|line))?(?: BE)?",
        "(?:BE )?in (?:the )?last (?:place|position|spot)", "(?:BE )?at the end(?: of (?:it|the (?:row|line)))?"),
    *(pattern for side in ("left", "right") for pattern in patterns("place", (side, 1),
        f"(?:starts|starting|start|begins|beginning|begin)(?: off)? (?:at|on|from) the {side}(?: end| side)? with",
        f"(?:ends|ending|finishes|finishing|finish) (?:up )?(?:at|on) the {side}(?: end| side)? with")),
    *patterns("place", ("last", 2), "(?:BE )?(?:the )?(?:next to last|second to last|last but one|second last)(?: BLOCK| one| place)?(?: BE)?"),
    *patterns("place", ("each end", 0), f"(?:BE )?(?:placed )?(?:at|on) (?:each|either|every)(?: of the| of its)?(?: 2)? ends?{_OF_IT}?"),
    *patterns("place", ("ends", 0),
        f"(?:BE )?(?:placed )?(?:at|on|in|form|forming|as) (?:both|the|its|the 2|both the|both of its|both of the|the outer|the opposite|opposite)(?: 2| outer| outer 2)? ends{_OF_IT}?",
        f"(?:at |on )?(?:with )?(?:both|the|its|the 2|the outer|both of the|both of its) (?:ends|end blocks|end cubes|outer ones|outer BLOCK){_OF_IT}?(?: BE(?: both)?)?", "(?:BE )?(?:on|at|to) the outsides?", "(?:BE )?outside(?= (?:[,.;)]|$))", "(?:the )?outer (?:2|ones|BLOCK|2 BLOCK)(?: BE(?: both)?)?", "(?:the )?(?:first|leftmost)(?: one| BLOCK)? and (?:the )?(?:last|rightmost)(?: one| ones| BLOCK)?(?: BE(?: both)?)?", "(?:BE )?(?:the )?(?:2 )?outermost(?: ones| BLOCK)?",
        "(?:starts|starting|start|begins|beginning|begin) and (?:ends|ending|end|finishes|finishing|finish) (?:with|in|by)", "(?:BE )?(?:flanked|framed|bordered|enclosed|bracketed|sandwiched) (?:on both sides |on each side |at both ends )?by"),
    *patterns("place", ("end", 0), f"(?:BE )?(?:at|on) (?:one|1|an) (?:of the (?:2 )?ends|end){_OF_IT}?"),
    *patterns("place", ("other", 0), f"(?:BE )?(?:at|on) the (?:other|opposite)(?: end| one){_OF_IT}?"),
    *patterns("place", ("middle", 0),
        f"(?:BE )?(?:right |exactly |just |precisely |directly )?(?:in|at|on|occupying|occupies|occupy|taking|takes|filling|fills) (?:the|its) (?:very |exact |dead )?(?:middle|center)(?: position| place| spot)?(?:{_OF_IT}|(?! of))(?: BE)?", "(?:BE )?(?:in )?(?:the )?(?:middle|center)(?= : )",
        "(?:BE )?(?:middle|center)(?= (?:[,.;)]|$))", "(?:the )?(?:middle|central|center|centermost|middlemost)(?: BLOCK| one| ones| position| place)(?: BE)?", "(?:BE )?(?:hides |hide |hidden |squeezed |sandwiched |wedged |caught )?(?:in |right |exactly )?between(?: them| those| these| the ends| the 2 ends| the 2(?! COLOR)| the 2 of them)?", "in the (?:middle|center)(?= (?:a|one|the|1) )"),
    *patterns("place", ("sides", 0),
        "(?:BE )?(?:on|at|to) (?:each|either|both|every)(?: one)?(?: of (?:its|the 2|the))? sides?(?: of (?:it|that|them))?", "(?:BE )?(?:to the )?left and right of (?:it|that)", "(?:BE )?to (?:its|the) left and (?:to )?(?:its )?right"),
]  # fmt: skip
"""Kind "place": a name and a number from there: ("left", 2) is the second from the left; ("first", 1) as it is read;
("middle", 0), ("ends", 0), ("sides", 0) of what is in the middle, ("end", 0) one of the ends, ("other", 0) the other."""

_ADJ = "(?:(?:straight|nice|neat|simple|single|long|short|horizontal|tidy|little|lovely|pretty|perfect|clean|proper|whole|flat|complete|beautiful|well ordered) )"
_IN = "(?:(?:in|into|to|as|on|along|of|for) )?"
FIGURE: list[Pattern] = [
    *(pattern for noun, words in (("row", "row"), ("line", "line|lineup|line up|queue|sequence|single line"), ("column", "column")) for pattern in (
        *patterns("figure", noun, f"{_IN}(?:(?:a|an|one|1|my|our|exactly one|just one) )?(?:and same )?{_ADJ}*(?:{words})"),
        *patterns("mention", noun, f"{_IN}(?:the|this|that|the same|your) {_ADJ}*(?:{words})(?: itself)?"))),
    *patterns("figure", "line", "(?:line|lines|lined|lining) (?:them |these |it |all of them |them all )?up"),
    *patterns("glue", None, "side by side", "(?:one|1) (?:after|beside|next to|following) (?:another|the other)"),
]  # fmt: skip
"""Kind "figure" (the noun to tell it by), and "mention" of the one that was told before."""

_AWAY = "(?:(?:that|which|going|running|leading|pointing|extending|leads|runs|goes|extends|lead|run|go) )*"
_READ = "(?:(?:read|reading|listed|counting|counted|going|viewed|seen|told|ordered|running|arranged|starting|beginning|as seen|as read|when read|which goes|that goes|goes) )?(?:from )?(?:the )?"
DIRECTIONS: list[Pattern] = [
    *patterns("direction", "from left to right",
        f"{_READ}(?:far )?left(?: most| hand)?(?: end| side)? (?:to|→|towards) (?:the )?(?:far )?right(?: most| hand)?(?: end| side)?", f"{_READ}leftmost to (?:the )?rightmost",
        "(?:starting|beginning|begin|start|counted|listed|reading|read|seen|counting|going) (?:at|from|on) the (?:far )?left(?: end| side)?", "from (?:the )?left(?: end| side)?(?= [:,])", "to the right(?= :)"),
    *patterns("direction", "from right to left",
        f"{_READ}(?:far )?right(?: most| hand)?(?: end| side)? (?:to|→|towards) (?:the )?(?:far )?left(?: most| hand)?(?: end| side)?", f"{_READ}rightmost to (?:the )?leftmost",
        "(?:starting|beginning|begin|start|counted|listed|reading|read|seen|counting|going) (?:at|from|on) the (?:far )?right(?: end| side)?", "from (?:the )?right(?: end| side)?(?= [:,])"),
    *patterns("direction", "from front to back",
        f"{_READ}(?:front|near|nearest|closest|near side|near end|front end|near edge|front edge) (?:to|→|towards) (?:the )?(?:back|far|farthest|furthest|rear|far side|far end|back end|far edge|back edge)",
        "(?:starting|beginning|counted|listed|reading|read) (?:at|from|in) (?:the )?front", "from (?:the )?front(?= [:,])"),
    *patterns("direction", "from front to back", f"{_AWAY}(?:straight )?away from (?:me|you|us|the (?:robot|viewer|camera|reader))", f"{_AWAY}away(?= [,.:;])"),
    *patterns("direction", "from back to front", f"{_AWAY}(?:straight )?(?:towards?|to) (?:me|you|us|the (?:robot|viewer|camera|reader))",
        f"{_READ}(?:back|far|farthest|furthest|rear|far side|far end|back end|far edge|back edge) (?:to|→|towards) (?:the )?(?:front|near|nearest|closest|near side|near end|front end|near edge|front edge)",
        "(?:starting|beginning|counted|listed|reading|read) (?:at|from|in) (?:the )?(?:back|rear)", "from (?:the )?(?:back|rear)(?= [:,])"),
    *patterns("listed", None,
        "(?:always )?(?:exactly |precisely |just )?in (?:exactly |precisely )?(?:that|this|the following|exactly this|exactly that|the given|the stated|the same|this exact|that exact|that very|the said|precisely this|precisely that) (?:order|sequence)(?: BE)?",
        "(?:in |with |has )?(?:the |a |their |its )?(?:color )?(?:order|sequence|color sequence|pattern|color pattern)(?: of (?:the )?colors)?(?: BE| of| shall be| reads)?", "(?:the )?colors (?:BE|read|in order)", "(?:that |which )?(?:reads|reading)", "(?:(?:should|must|shall|has to|to) )?(?:go|goes|run|runs|read)(?= (?:COLOR|[A-Z]|:) )"),
]  # fmt: skip
"""Kinds "direction" (in which a list is told), and "listed": what is listed is an order."""

_UNIT = "(?:cm|centimeters?|centimetres?|mm|millimeters?|millimetres?|inch|inches|dm)"
_LENGTH = rf"(?P<about>(?:about|roughly|around|approximately|some|circa|ca|nearly|almost) )?(?P<most>(?:at most|no more than|not more than|up to|maximum|max) )?(?:exactly |precisely )?(?:a |one )?(?P<n>\d+(?:\.\d+)?|one|half a) ?(?P<unit>{_UNIT})"
_NEIGHBORS = "(?: (?:in )?(?:between|from) (?:(?:each|all|the|every|any|every 2|each 2|any 2|2|all the|all of the|adjacent|neighboring|adjoining|consecutive|successive|their|each and every) )*(?:BLOCK|neighbors?|neighboring|ones?|them|other|another|faces|pair|pairs|edges|sides|pair of neighbors|pair of BLOCK|pair of neighboring BLOCK)(?: and (?:the )?(?:next|its neighbor|each other)(?: one| BLOCK)?| to (?:the )?next(?: one)?)?)"
_NEIGHBORS = f"(?:{_NEIGHBORS}| (?:in )?between each(?: one| other)?| in between)"
_FACES = "(?: (?:from|between) (?:(?:the|their|neighboring|adjacent|facing) )*(?:faces?|edges?|sides)(?: to (?:face|edge))?| face to face| edge to edge| measured (?:between|from) (?:the )?faces?(?: to face)?)"
_CENTERS = "(?:(?:between|from|of|measured between) (?:(?:the|their|neighboring|adjacent|block|cube|all|each|2|consecutive) )*centers?(?: (?:of|to) (?:(?:neighboring|adjacent|the|their|2|center|all) )*(?:BLOCK|neighbors|center|centers)?)?|center to center)"


def _length(template: str, *texts: str) -> list[Pattern]:
    """Patterns that say a length."""
    def told(match: object) -> str:
        named = match.groupdict()  # type: ignore[attr-defined]
        n = {"one": "1", "half a": "0.5"}.get(named["n"], named["n"])
        ahead = "about " if named["about"] else "at most " if named["most"] else ""
        return template.format(f"{ahead}{n} {named['unit']}")
    return patterns("spacing", told, *texts)


_GAP = "(?:gaps?|spaces?|clearance|free space|clear space|empty space|room|air|breathing room|open space)"
_DISTANCE = "(?:distances?|spacing|separation|intervals?)"
_EACH = "(?:each |all |every |always |(?:each|every) (?:one )?(?:BLOCK )?)"
SPACING: list[Pattern] = [
    *_length("The gap between neighbors is {}.",
        f"(?:(?:a|the|with|of|leaving|leave|keep|let|separated|spaced|parted|by|adjacent|neighboring|BLOCK|BE|each) )*(?:equal |even |uniform |same |regular |constant |small |wide |clear )*{_GAP}(?:{_NEIGHBORS}|{_FACES})?(?: BE)?(?: (?:each|all|always))?(?: of| :| =| exactly)* {_LENGTH}(?: wide| each)?(?:{_NEIGHBORS}|{_FACES})?",
        f"(?:(?:with|a|leaving|leave|keep|let|at) )*{_LENGTH}(?: wide)?(?: of)? (?:wide )?{_GAP}(?: each)?(?:{_NEIGHBORS}|{_FACES})?",
        f"(?:(?:with|leaving|leave|keep|let|at) )*{_LENGTH}(?:{_NEIGHBORS}|{_FACES})(?! centers)",
        f"(?:(?:a|the|with|of|leaving|leave|keep) )*{_DISTANCE}{_FACES}(?: BE)?(?: of| :| =)* {_LENGTH}"),
    *_length("The blocks are {} apart.",
        f"(?:(?:spaced|set|placed|at|with|standing|sitting|lying|BE) )*{_EACH}?{_LENGTH} apart(?: from (?:each other|one another|the next|its neighbor))?(?:,? (?:measured )?{_CENTERS})?",
        f"(?:(?:a|the|with|of|leaving|leave|keep|at) )*(?:equal |regular |constant |center )*{_DISTANCE}(?:{_NEIGHBORS}| {_CENTERS})?(?: BE)?(?: of| :| =)* {_LENGTH}(?:{_NEIGHBORS}| {_CENTERS}| from (?:each other|one another))?",
        f"(?:(?:with|a|at|leaving|keep) )*{_LENGTH}(?: of)? {_DISTANCE}(?:{_NEIGHBORS}| {_CENTERS}| from (?:each other|one another))?",
        f"(?:(?:with|at|leaving|keep|neighboring|the) )*(?:centers (?:BE )?)?{_LENGTH}(?: apart)? {_CENTERS}",
        f"(?:(?:with|neighboring|adjacent|the|their|all) )*centers(?: of (?:neighboring|adjacent|the|all|2)* ?(?:BLOCK|neighbors))?(?: BE)?(?: spaced)? {_LENGTH} apart", f"{_CENTERS}(?: distance| spacing)?(?: BE| of| :)* {_LENGTH}",
        f"(?:(?:with|a|of) )*(?:pitch|center distance|center spacing)(?: BE| of| :)* {_LENGTH}"),
    *patterns("spacing", "The blocks touch each other.",
        "(?:(?:they|all|each|must|should|shall|so|that|everything|every one|every|one|BLOCK|of them|the) )*(?:BE )?(?:all )?(?:just )?(?:to )?(?:touching|touch|touches|contacting|in contact(?: with)?|in touch with)(?: (?:each other|one another|(?:the|its|their) (?:next|neighbors?|neighbor)(?: one| BLOCK| in (?:the )?(?:row|line))?))?",
        f"(?:with(?:out)? |and |there (?:BE|shall be|must be|should be) |leave |leaving |has |have )*(?:no|any|without|zero) (?:free |visible |empty |any )?(?:{_GAP}|spacing|gap|distance)(?: left| at all| in between)*(?:{_NEIGHBORS})?(?: at all)?",
        "without (?:leaving )?(?:any )?(?:gaps?|spaces?|spacing)(?: left)?(?: in between| between (?:them|the BLOCK|neighbors|BLOCK))?(?: at all)?", "gapless(?:ly)?", "(?:pushed|pressed|shoved|packed|squeezed|placed|set|packed closely|packed tightly) (?:right |tightly |firmly |close |flush |snugly )?(?:together|against each other|against one another)",
        "(?:tightly|densely) packed", "(?:flush|snug) (?:together|against each other|against one another)"),
    *patterns("spacing", "The row is evenly spaced.",
        f"(?:(?:they|all|BE|to) )*(?:evenly|equally|regularly|uniformly|equidistantly) (?:spaced|spread|distributed|far apart|spaced out|placed|distant|separated|set|laid|arranged|apart)(?: out)?(?: apart)?(?: from (?:each other|one another))?",
        f"(?:spaced|spread|distributed|spread out|spaced out|placed|arranged) (?:out )?(?:evenly|equally|regularly|uniformly)(?: apart)?", "(?:BE )?(?:equidistant(?:ly)?|equispaced)",
        f"(?:(?:with|at|in|of|leave|leaving|keep|keeping|let|make|put|has|have|there BE|by|an|a|the|all) )*(?:equal|same|identical|even|regular|uniform|constant|equally (?:large|big|wide)|the same|exactly the same|equal sized)(?: size| amount of| width| length)? (?:{_GAP}|{_DISTANCE})(?: in between| apart)?(?:{_NEIGHBORS})?(?: from (?:each other|one another))?",
        f"(?:(?:with|make|keep|let|have|all|the|leave) )*(?:{_GAP}|{_DISTANCE})(?:{_NEIGHBORS})? (?:BE )?(?:all )?(?:BE )?(?:the same|equal|equally (?:large|big|wide)|identical|even|uniform|the same size|constant|of (?:the )?(?:same|equal) (?:size|width|length))(?: everywhere| throughout)?",
        "(?:(?:with|and) )*(?:each|every one|every)(?: BLOCK| one)? (?:BE )?(?:at )?(?:the|an) (?:same|equal) distance (?:from|to) (?:the next|its neighbors?|its neighbor)(?: one)?", "even(?:ly)? spacing", "spaced even"),
    *_length("The tolerance is {}.",
        f"(?:(?:with|a|the|at|and) )*(?:tolerance|allowed deviation|allowed error|deviation allowed|precision|accuracy)(?: BE| of| :| =)* {_LENGTH}",
        f"(?:plus or minus|give or take|plus minus|to within|within|accurate to) {_LENGTH}(?: (?:tolerance|of tolerance|accuracy|precision|either way))?", f"{_LENGTH}(?: of)? tolerance"),
]  # fmt: skip
"""Kind "spacing": the sentence that tells it (the tolerance belongs to the length told)."""

_COLORS = "(?:colors?|coloring)"
PATTERNED: list[Pattern] = [
    *patterns("pattern", "alternating",
        "(?:(?:in|with|an|of|strictly|always|the|have|has|having|and|BE|colors?|that|which|they|their|both|2) )*(?:alternating(?:ly)?|alternate[sd]?|alternately|alternation|interleaved|striped|zebra)(?: (?:in )?(?:color|colors|colored|pattern|order|between|from|fashion|sequence|stripes))*", "(?:always )?(?:in |by )?(?:taking |take |takes )?turns", "(?:1|one) after the other in turn",
        "(?:so )?(?:that )?no (?:2|two) (?:neighbors|adjacent BLOCK|neighboring BLOCK) (?:have|of|BE)(?: of)? the same color"),
    *patterns("pattern", "mirrored",
        f"(?:(?:in|with|an|a|of|the|have|has|having|and|BE|that|which|forms?|as|color|colors|it|they|their|its|whose|must be|be) )*(?:mirrored|mirror symmetric(?:al)?|mirror image|symmetric(?:al)?(?:ly)?|symmetry|mirror symmetry|palindromic|palindrome)(?: (?:{_COLORS}|order|sequence|pattern|arranged|in {_COLORS}|in its {_COLORS}|colored|about its (?:middle|center)|around the (?:middle|center)))*",
        "(?:(?:it|that|which|so|must|should|shall|and|to|the|colors|order|looks?) )*(?:reads?|reading|looks?|look) the same (?:from both (?:sides|ends|directions)|in both directions|both ways|forwards? and backwards?|backwards? and forwards?|from (?:the )?left and (?:from )?(?:the )?right|from left to right and (?:from )?right to left|from (?:the )?left as from (?:the )?right|either way)"),
    *patterns("pattern", "rainbow",
        "(?:(?:in|with|an|a|of|the|as|form|forms|forming|like|follow|follows|following|make|makes|all|showing|show) )*(?:rainbow|spectrum|color gradient|gradient|spectral)(?: (?:color )?(?:order|colors|sequence|colored))?", "(?:in )?(?:the )?order of (?:the|a) (?:rainbow|spectrum)", "(?:in )?(?:the )?colors of (?:the|a) rainbow"),
    *patterns("pattern", "grouped",
        "(?:BE )?(?:grouped|sorted|ordered|arranged)?(?: together)? by (?:their )?color", "(?:with |and )?(?:the )?(?:all )?(?:BLOCK of )?(?:the |each |every )?(?:same )colors? (?:BE )?(?:kept )?(?:together|next to each other|side by side|adjacent)",
        "(?:each|every) color (?:BE )?(?:kept )?together"),
    *patterns("pattern", "different",
        "(?:with |and )?each(?: one| of them| BLOCK)? (?:BE )?(?:of |in |has |having |with )?another color", "(?:(?:with|and|in|of) )*(?:each|all|every one|every)(?: one| of them| BLOCK| of which)?(?: (?:BE|has|have|having))?(?: of| in)?(?: a| its)? (?:different|own|distinct) colors?",
        f"(?:(?:of|in|with|all|having|has|have|completely) )*(?:different(?:ly)?|distinct|various) (?:colors|colored)", "no (?:2|two)(?: BLOCK| of them)? (?:of|have|with|BE|sharing|share)(?: of)? the same color", "all different(?: in color)?", "(?:BE )?(?:all )?of (?:a )?different color"),
    *patterns("pattern", "same",
        "(?:(?:with|and|in) )*(?:all |all of them |each )?(?:BE )?(?:of |in |have |with |has )+(?:just |only )?(?:the same|one|a single|one single|one and the same|1|the very same|1 single|equal) color", "(?:all )?(?:the )?same color"),
]  # fmt: skip
"""Kind "pattern" of the colours of all blocks."""

EACH: list[Pattern] = patterns("each", lambda match: number(match["n"]),
    "(?:with )?(?P<n>NUM)(?: BLOCK)? (?:of each|each|apiece|in each|per|for each)(?: of)?(?: (?:these|the|the following|following))*(?: (?:colors?|one|kind))?", "(?:each )(?:color )?(?P<n>NUM)(?: times)?(?: BLOCK)?")  # fmt: skip
"""Kind "each": so many blocks of each look."""
REST: list[Pattern] = patterns("rest", None, r"(?:all )?(?:the )?(?:rest|others|other ones|other BLOCK|remaining ones|remaining BLOCK|remaining|other (?P<n>\d+)|remaining (?P<m>\d+)|inner (?P<k>\d+))(?: of (?:them|it|the BLOCK))?(?: (?:BE|all))*", "everything else(?: BE)?")
"""Kind "rest": what is told next is all that is left."""

_EDGE = "(?:front|near|far|back|left|right|closest|nearest|farthest)"
WHERE: list[Pattern] = [
    *patterns("where", lambda match: f"at the {({'front': 'near', 'closest': 'near', 'nearest': 'near', 'back': 'far', 'farthest': 'far'}).get(match['edge'], match['edge'])} edge of the table",
        f"(?:BE )?(?:placed )?(?:along|at|by|close to|near|next to) the (?P<edge>{_EDGE}) edge(?: of the TABLE)?", f"(?:BE )?(?:placed )?(?:along|at) the (?P<edge>{_EDGE}) side of the TABLE"),
    *patterns("where", lambda match: f"in the {match['side']} half of the table", r"(?:BE )?(?:placed )?(?:on|at|to) the (?P<side>left|right) side of the TABLE"),
    *patterns("axis", "row", "(?:BE )?parallel to the (?:front|near|far|back) edge(?: of the TABLE)?"),
    *patterns("axis", "column", "(?:BE )?parallel to the (?:left|right) edge(?: of the TABLE)?", "(?:one|1) behind (?:another|the other)"),
]  # fmt: skip

WORDS: list[Pattern] = [
    *patterns("listed", "now", "then(?: (?:comes|come|follows|goes))?(?: (?:again|another|next|finally|lastly))?", "(?:which BE )?followed (?:next )?by", "next(?: comes| follows)?(?! to)", "after (?:that|it|which)(?: comes| follows)?", "(?:and )?(?:finally|lastly)", "→", "after (?:this|that|it)"),
    *patterns("stock", None, "(?:there (?:is|are)|i have(?: got)?|we have(?: got)?|you have(?: got)?|you get|take|here (?:is|are)|given(?: (?:is|are))?|given :|(?:available|materials?|inventory|stock|blocks|cubes)(?: (?:are|is))? :)"),
    *patterns("break", None, "so that", "so", "such that", "in such a way that", "in which", "whose", "including", "where", "also", "as well as", "[()]"),
    *patterns("act", None, "(?:and )?(?:put|place|set|add|lay|insert|stick|position|drop|move|locate)"),
    *patterns("again", None, "(?:once )?(?:again|more)(?= (?:[,.;)]|$))"),
    *patterns("glue", None, "BE(?: all)?", "let there be", "the robot(?: arm)?|robot|have|let us have", "there (?:stand|stands|lie|lies|sit|sits)", "up(?= (?:[,.;]|in|from|on|with|$))", "(?:the |their |its )?colors(?= (?:from|COLOR|COLORs|:) )",
        "comprising|comprises|comprised of|comprise|including", "all (?:the |of the |these )?BLOCK",
        "standing|sitting|lying|resting|placed|positioned|located|neatly|nicely|please|ok|so|all"),
    *patterns("glue", None, "(?:all of )?(?:them|these)(?: all)?|they(?: all)?|it", "(?:colored|plain)", "also please"),
    *patterns("glue", None, "(?:color|number|letter|blocks|cubes|count|quantity|figure|structure|shape|arrangement|layout|configuration|object|objects|spacing|colors|which|that)(?= :)"),
]  # fmt: skip
"""Binding words, and those that tell an order ("listed"), what there is ("stock"), or to do a further thing ("act")."""

OF_THEM: list[Pattern] = [
    *patterns("lot", None, "(?P<half>half) (?:(?:of )?(?:them|these|those|which|the BLOCK) )?(?:BE )?(?P<color>COLOR)(?! (?:BLOCK|PATCH))(?: ones)?", "(?P<count>NUM) (?:of (?:them|these|those|which|the BLOCK) )?BE(?: all)? (?P<color>COLOR)(?! (?:BLOCK|PATCH))(?: ones)?", "(?P<count>NUM) of (?:them|these|those|which|the BLOCK) (?P<color>COLOR)(?! (?:BLOCK|PATCH))(?: ones)?"),
    *patterns("total", lambda match: int(match["n"]), r"(?P<n>\d+) of (?:them|these|those)(?= (?:[,.;)]|$))"),
]  # fmt: skip
"""Lots told as a part of all blocks: "two of them are red"."""
