"""What people say of the spacing and the colours of a row, of all its blocks, and words that only bind."""

from __future__ import annotations

import re

from rpg.language.frames.pieces import Pattern, number, patterns

_UNIT = "(?:cm|centimeters?|centimetres?|mm|millimeters?|millimetres?|inch|inches|dm)"
_LENGTH = (
    rf"(?P<about>(?:about|roughly|around|approximately|some|circa|ca|nearly|almost) )?(?P<most>(?:at most|no more "
    rf"than|not more than|up to|maximum|max) )?(?:exactly |precisely )?(?:a |one )?(?P<n>\d+(?:\.\d+)?|one|half "
    rf"a) ?(?P<unit>{_UNIT})"
)
_NEIGHBORS = (
    "(?: (?:in )?(?:between|from) (?:(?:each|all|the|every|any|every 2|each 2|any 2|2|all the|all of the|adjacent|"
    "neighboring|adjoining|consecutive|successive|their|each and every|all of|each of|any 2 of|every 2 of|each 2 of|"
    "one) )*(?:BLOCK|neighbors?|neighboring|ones?|them|"
    "other|another|faces|pair|pairs|edges|sides|pair of neighbors|pair of BLOCK|pair of neighboring BLOCK)(?: and "
    "(?:the )?(?:next|its neighbor|each other)(?: one| BLOCK)?| to (?:the )?next(?: one)?)?)"
)
_NEIGHBORS = f"(?:{_NEIGHBORS}| (?:in )?between each(?: one| other)?| in between| between(?= (?:[,.;!?]|$)))"
_FACES = (
    "(?: (?:from|between) (?:(?:the|their|neighboring|adjacent|facing) )*(?:faces?|edges?|sides)(?: to (?:face|"
    "edge))?| face to face| edge to edge| measured (?:between|from) (?:the )?faces?(?: to face)?)"
)
_CENTERS = (
    "(?:(?:between|from|of|measured between) (?:(?:the|their|neighboring|adjacent|block|cube|all|each|2|consecutive) "
    ")*centers?(?: (?:of|to) (?:(?:neighboring|adjacent|the|their|2|center|all) )*(?:BLOCK|neighbors|center|"
    "centers)?)?|center to center)"
)


def _length(template: str, *texts: str) -> list[Pattern]:
    """Patterns that say a length."""

    def told(match: re.Match[str]) -> str:
        named = match.groupdict()
        n = {"one": "1", "half a": "0.5"}.get(named["n"], named["n"])
        ahead = "about " if named["about"] else "at most " if named["most"] else ""
        return template.format(f"{ahead}{n} {named['unit']}")

    return patterns("spacing", told, *texts)


_GAP = "(?:gaps?|spaces?|clearance|free space|clear space|empty space|room|air|breathing room|open space)"
_DISTANCE = "(?:distances?|spacing|separation|intervals?)"
_EACH = "(?:each |all |every |always |(?:each|every) (?:one )?(?:BLOCK )?)"
_NEXT_ONE = "(?:its neighbors?|the next(?: one| BLOCK)?|the one (?:before|beside) it|its neighboring BLOCK)"
_ONE_TO_NEXT = (
    "(?:in )?(?:between|from) (?:(?:each|every) )?(?:one|BLOCK)? ?(?:and|to) (?:the|its) (?:next|neighbor)(?: one| "
    "BLOCK)?(?: in (?:the )?(?:row|line|column))?,? (?:there )?(?:BE |leave |keep )?"
)
SPACING: list[Pattern] = [
    *_length("The gap between neighbors is {}.",
        f"{_ONE_TO_NEXT}(?:a |an )?{_GAP}(?: of| :)* {_LENGTH}", f"{_ONE_TO_NEXT}{_LENGTH}(?: of)? {_GAP}",
        f"(?:(?:a|the|with|of|leaving|leave|keep|let|separated|spaced|parted|by|adjacent|neighboring|BLOCK|there BE|"
        f"BE|each) "
        f")*(?:equal |even |uniform |same |regular |constant |small |wide |clear "
        f")*{_GAP}(?:{_NEIGHBORS}|{_FACES})?(?: BE)?(?: (?:each|all|always))?(?: of| :| =| exactly)* {_LENGTH}(?: "
        f"wide| each)?(?:{_NEIGHBORS}|{_FACES})?",
        f"(?:(?:with|a|leaving|leave|keep|let|at|there BE) )*{_LENGTH}(?: wide)?(?: of)? (?:wide )?{_GAP}(?: "
        f"each)?(?:{_NEIGHBORS}|{_FACES})?",
        f"(?:(?:with|leaving|leave|keep|let|at) )*{_LENGTH}(?:{_NEIGHBORS}|{_FACES})(?! centers)",
        f"(?:(?:a|the|with|of|leaving|leave|keep) )*{_DISTANCE}{_FACES}(?: BE)?(?: of| :| =)* {_LENGTH}"),
    *_length("The blocks are {} apart.", f"{_ONE_TO_NEXT}(?:a |an )?{_DISTANCE}(?: of| :)* {_LENGTH}",
        f"{_ONE_TO_NEXT}{_LENGTH}(?: of)? {_DISTANCE}",
        f"(?:with )?(?:each|every)(?: BLOCK| one)? (?:BE )?{_LENGTH} (?:away )?from {_NEXT_ONE}",
        f"(?:BE )?spaced (?:at |by |out )?{_LENGTH}",
        f"(?:(?:spaced|set|placed|at|with|standing|sitting|lying|BE) )*{_EACH}?{_LENGTH} apart(?: from (?:each other|"
        f"one another|the next|its neighbor))?(?:,? (?:measured )?{_CENTERS})?",
        f"(?:(?:a|the|with|of|leaving|leave|keep|at) )*(?:equal |regular |constant |center "
        f")*{_DISTANCE}(?:{_NEIGHBORS}| {_CENTERS})?(?: BE)?(?: of| :| =)* {_LENGTH}(?:{_NEIGHBORS}| {_CENTERS}| "
        f"from (?:each other|one another))?",
        f"(?:(?:with|a|at|leaving|keep) )*{_LENGTH}(?: of)? {_DISTANCE}(?:{_NEIGHBORS}| {_CENTERS}| from (?:each "
        f"other|one another))?",
        f"(?:(?:with|at|leaving|keep|neighboring|the) )*(?:centers (?:BE )?)?{_LENGTH}(?: apart)? {_CENTERS}",
        f"(?:(?:with|neighboring|adjacent|the|their|all) )*centers(?: of (?:neighboring|adjacent|the|all|"
        f"2)* ?(?:BLOCK|neighbors))?(?: BE)?(?: spaced)? {_LENGTH} apart", f"{_CENTERS}(?: distance| spacing)?(?: "
        f"BE| of| :)* {_LENGTH}",
        f"(?:(?:with|a|of) )*(?:pitch|center distance|center spacing)(?: BE| of| :)* {_LENGTH}"),
    *patterns("spacing", "The blocks touch each other.", f"{_ONE_TO_NEXT}no (?:{_GAP}|{_DISTANCE})",
        "(?:(?:they|all|each|must|should|shall|so|that|everything|every one|every|one|BLOCK|of them|the) )*(?:BE "
        ")?(?:all )?(?:just )?(?:to )?(?:touching|touch|touches|contacting|in contact(?: with)?|in touch with)(?: "
        "(?:each other|one another|(?:the|its|their) (?:next|neighbors?|neighbor)(?: one| BLOCK| in (?:the )?(?:row|"
        "line))?))?(?! (?:the|a|an|another|its|both) )",
        f"(?:with(?:out)? |and |there (?:BE|shall be|must be|should be) |leave |leaving |has |have )*(?:no|any|"
        f"without|zero) (?:free |visible |empty |any )?(?:{_GAP}|spacing|gap|distance)(?: left| at all| in "
        f"between)*(?:{_NEIGHBORS})?(?: at all)?",
        "without (?:leaving )?(?:any )?(?:gaps?|spaces?|spacing)(?: left)?(?: in between| between (?:them|the BLOCK|"
        "neighbors|BLOCK))?(?: at all)?", "gapless(?:ly)?", "(?:pushed|pressed|shoved|packed|squeezed|placed|set|"
        "packed closely|packed tightly) (?:right |tightly |firmly |close |flush |snugly )?(?:together|against each "
        "other|against one another)",
        "(?:tightly|densely) packed", "(?:flush|snug) (?:together|against each other|against one another)"),
    *patterns("spacing", "The blocks do not touch each other.",
        "(?:(?:but|and|with|so that) )*(?:none(?: of (?:them|the BLOCK))?|no 2(?: BLOCK| of them)?) (?:of them "
        ")?(?:BE |may "
        "|must |should )?(?:touching|touch)(?: (?:each other|one another|its neighbors?|another))?(?! (?:the|a|an|"
        "any|both) )",
        "(?:(?:but|and|they|which|that|the BLOCK) )*(?:(?:do|must|should|may|are) )*(?:not|without) (?:be "
        ")?(?:touching|touch)(?: (?:each other|one another))?(?! (?:the|a|an|any|another|its|both) )"),
    *patterns("spacing", "The row is evenly spaced.",
        "(?:(?:they|all|BE|to) )*(?:evenly|equally|regularly|uniformly|equidistantly) (?:spaced|spread|distributed|"
        "far apart|spaced out|placed|distant|separated|set|laid|arranged|apart)(?: out)?(?: apart)?(?: from (?:each "
        "other|one another))?",
        "(?:spaced|spread|distributed|spread out|spaced out|placed|arranged) (?:out )?(?:evenly|equally|regularly|"
        "uniformly)(?: apart)?", "(?:BE )?(?:equidistant(?:ly)?|equispaced)",
        f"(?:(?:with|at|in|of|leave|leaving|keep|keeping|let|make|put|has|have|there BE|by|an|a|the|all) )*(?:equal|"
        f"same|identical|even|regular|uniform|constant|equally (?:large|big|wide)|the same|exactly the same|equal "
        f"sized)(?: size| amount of| width| length)? (?:{_GAP}|{_DISTANCE})(?: in between| "
        f"apart)?(?:{_NEIGHBORS})?(?: from (?:each other|one another))?",
        f"(?:(?:with|make|keep|let|have|all|the|leave) )*(?:{_GAP}|{_DISTANCE})(?:{_NEIGHBORS})? (?:BE )?(?:all "
        f")?(?:BE )?(?:the same|same|equal|equally (?:large|big|wide)|identical|even|uniform|the same size|constant|of "
        f"(?:the )?(?:same|equal) (?:size|width|length))(?: everywhere| throughout)?",
        "(?:(?:with|and) )*(?:each|every one|every)(?: BLOCK| one)? (?:BE )?(?:at )?(?:the|an) (?:same|equal) "
        "distance (?:from|to) (?:the next|its neighbors?|its neighbor)(?: one)?", "even(?:ly)? spacing", "spaced even"),
    *_length("The tolerance is {}.",
        f"(?:(?:with|a|the|at|and) )*(?:tolerance|allowed deviation|allowed error|deviation allowed|precision|"
        f"accuracy)(?: BE| of| :| =)* {_LENGTH}",
        f"(?:plus or minus|give or take|plus minus|to within|within|accurate to) {_LENGTH}(?: (?:tolerance|of "
        f"tolerance|accuracy|precision|either way))?", f"{_LENGTH}(?: of)? tolerance"),
]  # fmt: skip
"""Kind "spacing": the sentence that tells it (the tolerance belongs to the length told)."""

_COLORS = "(?:colors?|coloring)"
PATTERNED: list[Pattern] = [
    *patterns("pattern", "alternating",
        "(?:(?:in|with|an|of|strictly|always|the|have|has|having|and|BE|colors?|that|which|they|their|both|2) "
        ")*(?:alternating(?:ly)?|alternate[sd]?|alternately|alternation|interleaved|striped|zebra)(?: (?:in "
        ")?(?:color|colors|colored|pattern|order|between|from|fashion|sequence|stripes))*", "(?:always )?(?:in |by "
        ")?(?:taking |take |takes )?turns", "(?:1|one) after the other in turn",
        "(?:(?:so|and|with|that) )*no (?:2|two) (?:BLOCK )?(?:of|in|with|having) the same color (?:(?:may|must|"
        "should|can) )?"
        "(?:BE |touch |touching )?(?:(?:directly|right|immediately) )?(?:next to|beside|adjacent to|neighboring) "
        "(?:each "
        "other|one another)", "(?:so )?(?:that )?no (?:2|two) (?:neighbors|adjacent BLOCK|neighboring BLOCK) "
        "(?:have|of|BE)(?: of)? the "
        "same color"),
    *patterns("pattern", "mirrored",
        f"(?:(?:in|with|an|a|of|the|have|has|having|and|BE|that|which|forms?|as|color|colors|it|they|their|its|whose|"
        f"must be|be) )*(?:mirrored|mirror symmetric(?:al)?|mirror image|symmetric(?:al)?(?:ly)?|symmetry|mirror "
        f"symmetry|palindromic|palindrome)(?: (?:{_COLORS}|order|sequence|pattern|arranged|in {_COLORS}|in "
        f"its {_COLORS}|colored|about its (?:middle|center)|around the (?:middle|center)))*",
        "(?:(?:it|that|which|so|must|should|shall|and|to|the|colors|order|looks?) )*(?:reads?|reading|looks?|look) "
        "the same (?:from both (?:sides|ends|directions)|in both directions|both ways|forwards? and backwards?|"
        "backwards? and forwards?|from (?:the )?left and (?:from )?(?:the )?right|from left to right and (?:from "
        ")?right to left|from (?:the )?left as from (?:the )?right|either way)"),
    *patterns("pattern", "rainbow",
        "(?:ordered |sorted |arranged )?(?:by|like) (?:the|a) rainbow",
        "(?:(?:in|with|an|a|of|the|as|form|forms|forming|like|follow|follows|following|make|makes|all|showing|show) "
        ")*(?:rainbow|spectrum|color gradient|gradient|spectral)(?: (?:color )?(?:order|colors|sequence|"
        "colored))?", "(?:in )?(?:the )?order of (?:the|a) (?:rainbow|spectrum)", "(?:in )?(?:the )?colors of (?:the|"
        "a) rainbow"),
    *patterns("pattern", "grouped",
        "(?:BE )?(?:grouped|sorted|ordered|arranged)?(?: together)? by (?:their )?color", "(?:with |and )?(?:the "
        ")?(?:all )?(?:BLOCK of )?(?:the |each |every )?(?:same )colors? (?:BE )?(?:kept )?(?:together|next to each "
        "other|side by side|adjacent)",
        "(?:each|every) color (?:BE )?(?:kept )?together"),
    *patterns("pattern", "different",
        "(?:with )?no 2(?: of them)? the same color",
        "(?:with |and )?each(?: one| of them| BLOCK)? (?:BE )?(?:of |in |has |having |with )?another "
        "color", "(?:(?:with|and|in|of) )*(?:each|all|every one|every)(?: one| of them| BLOCK| of which)?(?: (?:BE|"
        "has|have|having))?(?: of| in)?(?: a| its)? (?:different|own|distinct) colors?",
        "(?:(?:of|in|with|all|having|has|have|completely) )*(?:different(?:ly)?|distinct|various) (?:colors|"
        "colored)", "no (?:2|two)(?: BLOCK| of them)? (?:of|have|with|BE|sharing|share)(?: of)? the same "
        "color", "all different(?: in color)?", "(?:BE )?(?:all )?of (?:a )?different color"),
    *patterns("pattern", "same",
        "(?:(?:with|and|in) )*(?:all |all of them |each )?(?:BE )?(?:of |in |have |with |has )+(?:just |only "
        ")?(?:the same|one|a single|one single|one and the same|1|the very same|1 single|equal) "
        "color", "(?:all )?(?:the )?same color(?: as (?:each other|one another))?"),
]  # fmt: skip
"""Kind "pattern" of the colours of all blocks."""

EACH: list[Pattern] = patterns("each", lambda match: number(match["n"]),
    "(?:with )?(?P<n>NUM)(?: BLOCK)? (?:of each|each|apiece|in each|per|for each)(?: of)?(?: (?:these|the|the "
    "following|following))*(?: (?:colors?|one|kind))?", "(?:each )(?:color )?(?P<n>NUM)(?: times)?(?: "
    "BLOCK)?")  # fmt: skip
"""Kind "each": so many blocks of each look."""
REST: list[Pattern] = patterns(
    "rest",
    None,
    r"(?:all )?(?:the )?(?:other (?P<n>\d+)|remaining (?P<m>\d+)|inner (?P<k>\d+)|rest|others|other ones|other BLOCK|"
    r"remaining ones|remaining BLOCK|remaining)(?: (?:BLOCK|ones))?(?: of (?:them|it|the BLOCK))?(?: (?:BE|all))*",
    "everything else(?: BE)?",
    "(?:BE )?(?:in|at|on|for|to|fill|fills|filling|take|takes|taking|occupy|occupies|occupying) (?:all )?(?:of "
    ")?(?:the )?"
    "(?:remaining|other|free|empty|rest of the|leftover) (?:positions|places|spots|slots|spaces)",
)
"""Kind "rest": what is told next is all that is left."""

_EDGE = "(?:front|near|far|back|left|right|closest|nearest|farthest)"
_EDGES = {"front": "near", "closest": "near", "nearest": "near", "back": "far", "farthest": "far"}
WHERE: list[Pattern] = [
    *patterns("where", lambda match: f"at the {_EDGES.get(match['edge'], match['edge'])} edge of the table",
        f"(?:BE )?(?:placed )?(?:along|at|by|close to|near|next to) (?:the )?(?P<edge>{_EDGE}) edge(?: of the "
        f"TABLE)?", f"(?:BE )?(?:placed )?(?:along|at) (?:the )?(?P<edge>{_EDGE}) side of the TABLE"),
    *patterns("where", lambda match: f"in the {match['side']} half of the table", r"(?:BE )?(?:placed )?(?:on|at|to) "
        r"the (?P<side>left|right) side of the TABLE"),
    *patterns("axis", "row", "(?:BE )?parallel to the (?:front|near|far|back) edge(?: of the TABLE)?"),
    *patterns("axis", "column", "(?:BE )?parallel to the (?:left|right) edge(?: of the TABLE)?", "(?:one|1) behind "
        "(?:another|the other)"),
]  # fmt: skip

WORDS: list[Pattern] = [
    *patterns("listed", None, "(?:in |with |has |having |of )?(?:the )?following (?:order|sequence|color sequence|"
    "pattern|"
        "color order|succession)(?: of colors)?(?= )"),
    *patterns("glue", None, "(?:with |has |having |of |from |using )?(?:the |this )?following (?:composition|contents?|"
        "colors?|BLOCK|elements|parts|specification|properties|description|constraints?|conditions?|requirements?|"
        "letters|digits|numbers|symbols)", "(?:along|across) the TABLE(?! edge)", "(?:all |of )?(?:his|her|their|"
        "our|my) "
        "BLOCK"),
    *patterns("listed", "now", "then(?: (?:comes|come|follows|goes))?(?: (?:again|another|next|finally|"
        "lastly))?", "(?:which BE )?followed (?:next )?by", "next(?: comes| follows)?(?! to)", "after (?:that|it|"
        "which)(?: comes| follows)?", "(?:and )?(?:finally|lastly)", "→", "after (?:this|that|it|them|these|those)",
        "(?:then|(?:which BE )?followed by|next|and finally|finally|lastly|and lastly)(?: comes)? (?:yet )?another"),
    *patterns("hues", lambda match: int(match["n"]),
        r"(?:(?:of|in|with|the|using) )*(?P<n>\d) (?:different )?colors(?= (?:[,.;:(]|alternating) )"),
    *patterns("stock", None, "(?:there (?:is|are)|i have(?: got)?|we have(?: got)?|you have(?: got)?|you get|take|"
        "here (?:is|are)|given(?: (?:is|are))?|given :|(?:available|materials?|inventory|stock|blocks|cubes)(?: "
        "(?:are|is))? :)"),
    *patterns("break", None, "so that", "so", "such that", "in such a way "
        "that", "in which", "whose", "including", "where", "also", "as well as", "[()]"),
    *patterns("act", None, "(?:and )?(?:put|place|set|add|lay|insert|stick|position|drop|move|locate)"),
    *patterns("repeated", None, "(?:(?:this|the|that|which) (?:pattern |sequence |order )?)?(?:BE )?(?:repeated|"
    "repeating|repeats)"
        "(?: (?:itself|over and over|until the end))?", "(?:in )?(?:a |the )?repeating (?:pattern|sequence|"
        "order)(?: of)?", "(?:the )?(?:colors )?repeating(?= COLOR)"),
    *patterns("again", None, "(?:once )?(?:again|more)(?= (?:[,.;)]|in|$))"),
    *patterns("glue", None, "BE(?: all)?", "let there be", "(?:is |BE )?(?:needed|required|wanted|"
        "desired)", "a series of", "(?:be )?brought", "the robot(?: arm)?|robot|have|let us "
        "have", "there (?:stand|stands|lie|lies|sit|sits)", "up(?= (?:[,.;]|in|from|on|with|$))", "(?:the |their |"
        "its )?colors(?= (?:from|in|COLOR|COLORs|:) )", "color(?= COLOR )",
        "comprising|comprises|comprised of|comprise|including", "all (?:the |of the |these )?BLOCK",
        "standing|sitting|lying|resting|placed|positioned|located|neatly|nicely|please|ok|so|all"),
    *patterns("glue", None, "(?:in|of|with) (?:the |any |whatever |whichever )?colors? (?:of your (?:own )?choice|"
    "(?:that )?you "
        "(?:like|want|choose|prefer|please))", "(?:of|in) any color"),
    *patterns("glue", None, "(?:all of )?(?:them|these)(?: all)?|they(?: all)?|it", "(?:colored|plain)", "also please"),
    *patterns("glue", None, "(?:color|number|letter|blocks|cubes|count|quantity|figure|structure|shape|arrangement|"
        "layout|configuration|object|objects|spacing|colors|which|that)(?= :)"),
]  # fmt: skip
"""Binding words, and those that tell an order ("listed"), what there is ("stock"), or to do a further thing ("act")."""

_END_HERE = "(?! (?:BLOCK|PATCH))"
OF_THEM: list[Pattern] = [
    *patterns("lot", None,
        rf"(?P<half>half) (?:(?:of )?(?:them|these|those|which|the BLOCK) )?(?:BE )?(?P<color>COLOR){_END_HERE}(?: "
        rf"ones)?",
        rf"(?<!of )(?P<count>NUM) (?:(?:of (?:them|these|those|which|the BLOCK)|BLOCK) )?BE(?: all)? "
        rf"(?P<color>COLOR){_END_HERE}"
        r"(?: ones)?",
        rf"(?P<count>NUM) of (?:them|these|those|which|the BLOCK) (?P<color>COLOR){_END_HERE}(?: ones)?",
        r"(?P<det>(?:the )?)(?P<color>COLOR)(?P<many> (?:half|group|part|section))(?= )",
        r"(?P<color>COLOR)(?: BLOCK)? : (?P<count>\d+)(?= (?:[,.;)]|and|$))",
        r"all (?P<count>NUM) of the (?P<color>COLOR)(?P<many>s)?(?: (?P<noun>BLOCK|ones))?",
        r"(?P<color>COLOR)(?: BLOCK)? (?:x|X|times) (?P<count>\d+)",
        r"(?:the )?(?P<color>COLOR)(?: (?:BLOCK|one))? (?:BE |appears |occurs |comes )?(?P<count>once|twice|\d+(?= "
        r"times))(?: times)?", r"(?P<count>\d+) (?:x|X|times) (?P<color>COLOR)"),
    *patterns("total", lambda match: int(match["n"]),
        r"(?P<n>\d+) of (?:them|these|those)(?= (?:[,.;)]|$))",
        r"(?P<n>\d+)(?= (?:differently|different|distinct) colored BLOCK )"),
]  # fmt: skip
"""Lots told as a part of all blocks: "two of them are red"; or by a number behind them."""
