"""The words that groups of blocks are told in."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.frames.groups.mixed import EACH_HAS, EXCEPT, MIXED, SNEAKED
from rpg.language.frames.groups.shared_words import ALSO, LOTS, OF, STARTS, STOPS
from rpg.language.frames.pieces import Pattern, number, patterns
from rpg.language.frames.shared import GLUE, WHERE

G = "(?:group|pile|cluster|bunch|heap|clump|bundle|lot|set|gathering|collection)"
GS = "(?:groups|piles|clusters|bunches|heaps|clumps|bundles|sets|lots)"
_ADJ = (
    "(?:(?:own|separate|single|little|small|neat|different|big|tidy|distinct|common|proper|clear|equal|identical|"
    "equally large|equally big|equal sized|same sized|close|tight|compact|(?:(?:spatially|clearly|well|physically|"
    "visibly|"
    "cleanly|mutually) )?(?:separated|distinct|disjoint|isolated|spaced)|neatly|dense|contiguous|coherent|"
    "connected|compact|nice|plain|individual|such) )"
)
ORD = "1st|2nd|3rd|4th|first|second|third|fourth|fifth|last|left|right|middle|center"
_IN = (
    "(?:BE )?(?:belongs? )?(?:all )?(?:together )?(?:put |gathered |sorted )?(?:(?:in|into|on|onto|to|→|forms?|forming|"
    "makes?|making|get|gets|as|inside) )?"
)
_OF = f"(?: {OF})*(?: :)?"
_EACH = f"(?:each|every|either|both|any)(?: of the(?: NUM)?)?(?: {G}s?| {GS}| one)?(?: of them)?"
_ODD = (
    "(?:stranger|outlier|odd one out|intruder|misfit|foreigner|odd one|wrong one|wrong BLOCK|foreign BLOCK|stray|"
    "stray BLOCK|stray one|exception|BLOCK (?:of|in|with) (?:the|a|another|an) ?(?:other|wrong|different)? color|"
    "(?:BLOCK|one|member) (?:that|which) (?:does|do) not belong(?: there| to it| in it)?)s?(?: (?:of|from|in) "
    "(?:the|an|a) ?(?:other|another|different|wrong) (?:color|group|kind)| in it| among them| inside)?"
)
KINDS = {
    "vowels": "vowels and consonants", "consonants": "vowels and consonants",
    "odd": "odd and even", "even": "odd and even",
    "letters": "letters and digits", "digits": "letters and digits", "big": "size", "small": "size",
}  # fmt: skip
"""What blocks are sorted by where one of its classes is told."""
_DET = "(?:(?:the|each|every|any of the|these|those|my|our|all|all the|all of the|following|given) )*"
_DOES = (
    "(?:(?:BE|shall|should|ought to|must|will|has to|have to|has|have|gets?|forms?|makes?|make up|makes up|"
    "becomes?|goes|go|constitutes?|builds?|ends? up|lies|stays?|stay|remains?|kept|put|placed|gathered|collected|"
    "sorted|grouped|into|to|in|on|as|up|its|together) )*"
)
_C = "(?: numbers?| digits?| ones?| cubes?| blocks?| letters?| numerals?| number BLOCK| digit BLOCK)?"
_PURE = (
    "(?:color|color homogeneous|color pure|monochrome|monochromatic|unicolored|single colored|one colored|"
    "uniformly colored|"
    f"color sorted|homogeneous|single color|one color|same color)(?= {_ADJ}*{GS})"
)
_SAME = (
    "(?:only |just |exactly )?(?:of |the |a )*(?:one|single|uniform|same|only one|just one|its own|one single|one "
    "and the same)"
)


def _apart(match: re.Match[str]) -> str:
    """How far groups are from each other: a gap is between faces, a distance between the middles."""
    length = f"at least {match['length']} {match['unit']}"
    gap = (match["noun"] or "distance").strip() != "distance"
    return f"The gap between the groups is {length}." if gap else f"The groups are {length} apart."


_CARRY = (
    "(?:(?:all|every|each|the|any|of|those|these|my) )*(?:(?:number |digit |letter )?BLOCK|tiles?|ones?|those|all|"
    "every one)(?: that| which)? (?:with|bearing|"
    "bears?|showing|shows?|carrying|carry|carries|labell?ed|marked|having|have|has|display|displaying|displays)(?: "
    "with)? "
    "(?:(?:a|an|the|any) )?"
)
SORTS: list[Pattern] = [
    *patterns("class", "<vowels>", f"{_CARRY}vowels?", f"{_DET}vowels?(?: letters?| BLOCK| ones)?"),
    *patterns("class", "<consonants>", f"{_CARRY}consonants?", f"{_DET}consonants?(?: letters?| BLOCK| ones)?"),
    *patterns("class", "<odd>", f"{_CARRY}(?:odd|uneven) (?:numbers?|digits?|numerals?)", f"{_DET}odds",
    f"{_DET}(?:digits?|numbers?) (?:(?:that|which) are )?odd", rf"{_DET}(?:odd|uneven){_C}"),
    *patterns("class", "<even>", f"{_CARRY}even (?:numbers?|digits?|numerals?)", f"{_DET}evens",
    f"{_DET}(?:digits?|numbers?) (?:(?:that|which) are )?even", rf"{_DET}even{_C}"),
    *patterns("class", "<letters>", f"{_CARRY}letters?", f"{_DET}(?:letters?|letter BLOCK)"),
    *patterns("class", "<digits>", f"{_CARRY}(?:digits?|numbers?|numerals?)", f"{_DET}(?:digits?|numbers?|"
        f"numerals?|number BLOCK|digit BLOCK)"),
    *patterns("class", lambda match: f"<{lexicon.SIZE[match['sized']]}>", f"{_DET}(?P<sized>SIZE) (?:BLOCK|ones)"),
    *patterns(
        "class", "<rest>",
        "(?:all )?(?:of )?(?:the )?(?:rest|others|remaining ones|remaining BLOCK|other BLOCK|other ones|"
        "(?:remaining|other) "
        "(?:letters|digits|numbers))(?: of them)?", "(?:everything|all|anything) else",
    ),
]  # fmt: skip
"""Kind "class": symbols of one sort, and the others."""

PATTERNS = [
    *patterns(
        "relation", lambda match: f"The {match['one']} group is {match['side']} of the {match['other']} group.",
        f"the (?P<one>COLOR|odd|even) (?:ones|{G}) (?:BE )?(?:to the |on the |at the )*(?P<side>left|right)(?: "
        f"hand side)? (?:of|from) the (?P<other>COLOR|odd|even)(?: ones| {G})?",
    ),
    *patterns(
        "slot", "together",
        "(?:BE |go |goes |belongs? |should |must |to |put |stays? |gathered |kept |stand |lie |sit |live |hang |"
        "out |stick "
        "|remain |huddle |bunched |grouped |placed |pushed |come |end up )*(?:all )?(?:close )?together(?: "
        f"in (?:one|a) {_ADJ}*{G})?",
    ),
    *LOTS,
    *WHERE,
    *STARTS,
    *STOPS,
    *ALSO,
    *GLUE,
    *patterns("figure", lambda match: number(match["count"]) if match["count"] else None,
        rf"(?:(?:in|into|to|as|of) )?(?:the )?(?:exactly )?(?:(?P<count>NUM) )?{_ADJ}*{GS}"),
    *patterns("figure", None, f"(?:in|into|make|form) {_ADJ}*{G}(?= (?:,|by|per|according|\\.))"),
    *patterns("own", lambda match: match["color"], f"(?:BE |go |goes )*(?:in|into|to|on) (?:the|a|its) "
        f"(?P<color>COLOR) {G}"),
    *patterns("alone", lambda match: match["color"], f"(?:(?:a|an|one|another) )?(?P<color>COLOR) {G}(?= (?:,|and|"
        f"&|\\.|;|with|of))"),
    *patterns("glue", None, "(?:the |their |its )?colors? (?:BE|:|will be)"),
    *patterns("figure", lambda match: int(match["count"]), f"{GS} x (?P<count>[2-9])"),
    *patterns("figure", lambda match: int(match["count"]), rf"(?:(?:in|into|to|as) )?(?P<count>[2-9]) {_ADJ}*{G}"),
    *patterns("figure", lambda match: number(match["count"]), rf"(?:(?:in|into) )?(?P<count>NUM)(?= {_PURE} )"),
    *patterns("basis", "color", f"(?:(?:in|into|of) )?(?:the )?{_PURE}"),
    *patterns(
        "figure", None,
        "group|grouped|grouping|cluster|clustered|clustering|gather|gathered|gathering|segregate|segregated|partition|"
        "partitioned|collect|collected|bunch|bunched|group together|group up|gather up",
    ),
    *patterns("break", None, "→"),
    *patterns("glue", None,
        "(?:(?<=put )|(?<=sort )|(?<=group )|(?<=all )|(?<=every )|(?<=divide )|(?<=arrange )|(?<=place )|"
        "(?<=separate ))(?:block|cube)"),
    *patterns(
        "parted", None,
        "break|break up|broken up|divide|divided|split|split up|separate|separated|separating|distribute|"
        "distributed|keep|kept|keep apart|part",
    ),
    *patterns("sorted", None, "sort|sorted|sorting|sort out|sorted out|classify|classified|organize|organized"),
    *patterns(
        "glue", None,
        "like (?:goes |BE )?with like|(?:well |far )?(?:away|apart|separate|separated) from (?:them|the others|"
        "it)", "lie|belong|belongs|belonging",
    ),
    *patterns(
        "glue", None,
        "tidy|tidy up|tidied up|own|set apart|in such a way|so that|such that|so|that|up|by "
        "themselves|cleanly|clean up|arranged|organized",
    ),
    *patterns("odd", None, "stranger|outlier|intruder|misfit|odd one out"),
    *patterns(
        "size", lambda match: number(match["size"]),
        f"(?:with |exactly )*(?P<size>NUM) (?:BLOCK )?(?:in|to|per|for|inside) (?:each|every|both)(?: one| {G}| of "
        "them)?", f"(?:with |exactly )*(?P<size>NUM) (?:BLOCK )?per {G}",
        r"of (?:exactly )?(?P<size>NUM)(?: BLOCK)?(?: each)?(?! (?:COLOR|SIZE|each)\b)",
        f"(?:in |of |for |with )?{_EACH} (?:(?:of|with|has|have|contains?|consists? of|comprises?|holds?|includes?|"
        f"gets?|there are|there must be|:) )?(?:exactly "
        f")?(?P<size>NUM)(?: BLOCK)?(?! (?:COLOR|"
        r"SIZE|(?:BLOCK )?(?:is|are|must be|should be) COLOR|of (?:either|each|every|both))\b)",
    ),
    *patterns(
        "even", None,
        "(?:of |with )?(?:the )?(?:equal|equally large|equally big|same|equal in|identical)(?: size)?|equally|"
        "evenly|in "
        "half|into halves|into (?:two )?equal parts",
    ),
    *patterns("basis", "color",
        "(?:by|per|according to|based on|depending on) (?:what|which) color (?:they|it|each) (?:are|is|have|has)",
        f"(?:so that |so |all |of |the )*(?:same|equal|like) colors? (?:BE |go |goes |stay |end up |put )*(?:in|"
        f"into|to) "
        f"(?:the same|one|same) {G}"),
    *patterns(
        "basis", "color",
        "(?:by|per|for each|for every|according to|on the basis of|based on|with respect to|depending on|after|"
        "for) (?:their |its |the |own )*color", "by their colors", "(?:arranged?|organized?|sorted|ordered|grouped|"
        "put|formed|laid out|assembled|put together|set up) by "
        "(?:their |its |the )?colors?", "one (?:of them )?(?:per|for each|for every|of each|of every|each for) color",
        "color wise|by matching color",
        f"one {_ADJ}*{G} (?:per|for each|for every|of each|of every|for) (?:one )?color",
        f"(?:a|an) {_ADJ}*{G} (?:per|for each|for every|of each|of every) color",
        f"(?:each|every)(?: single)? color {_DOES}(?:a |an |one |in )*{_ADJ}*{G}(?: of its own| for itself| by "
        "itself)?",
        f"(?:each|every) color {_DOES}(?:by itself|on its own|separately|together|separate|apart|for itself)",
        "(?:keep|keeping|kept|hold) (?:the |all |different )*colors (?:apart|separate|separated|unmixed)(?: from "
        "each other)?",
        f"(?:all |the )*(?:BLOCK |ones |those )?of (?:the |a )*(?:same|one|single) color (?:in|into|at|to) (?:one|"
        f"the same|a) (?:place|spot|{G})",
        f"(?:all |of |the )*(?:same|equal|like) color(?:ed)? (?:BLOCK|ones) (?:in|into|at|to) (?:one|the same|same|"
        f"a) (?:place|spot|{G})",
        "(?:BLOCK |ones |those )?of (?:the |a )?same color (?:BE |should |must |go |belong |stay |kept |lie |"
        f"stand |in |into |close |all )*(?:together|next to each other|the same {G}|one {G}|a {G})",
        "(?:all |the )*(?:BLOCK |ones |those )?(?:that |which |who )?(?:have |has |of |with |in |share )?(?:the |a "
        ")?same color "
        "(?:BE |should |must |go |belong |stay |kept |put |gather |bring |keep |placed |lie |stand |in |into |"
        "close |all )*(?:together(?: in (?:a|"
        f"one) {G})?|next to each other|(?:in )?the same {G}|one {G}|a {G})",
        "(?:BLOCK|ones|those|everything) (?:of|with|in|having|sharing|that have|that share) (?:the |an |a "
        ")?(?:same|equal|"
        "identical|like|one) color",
        "(?:same|equal|like) color(?:ed)? (?:BLOCK |ones )?(?:together|next to each other)?(?: BLOCK| ones)?",
        f"(?:as many {GS} as|one {G} for each of the|{GS} for all the) (?:there BE )?colors",
        f"(?:none|no BLOCK) of (?:another|a different|any other) color (?:in|inside|among) (?:a|any|the|each) {G}",
        "different colors (?:BE |should |must |go |stay |kept |lie |in |into |well )*(?:apart|separate|separated|"
        f"different {GS}|separate {GS})(?: from each other)?",
        f"{_EACH} (?:BE |must |should |shall |may |can |has |have |to |contains |contain |show |hold |be |holds |"
        f"with |consists |consist |only |of |blocks of |cubes of |pieces of |made of |for )*{_SAME} color(?: only| "
        "alone)?", f"(?:{GS} |{G} )?(?:of|with|in|from) {_SAME} color(?:ed)?(?: each| only| BLOCK| ones)?",
        "(?:same|equal|like) colors? (?:BE )?(?:with |to |and )?(?:(?:same|equal|like) colors?)?(?: ?together)?",
        "(?:the )?(?P<color>COLOR)s? (?:BLOCK )?(?:BE )?(?:with|near|by|next to) (?:the )?(?P=color)s?(?: "
        "BLOCK)?(?: ,)?(?: and)?(?: "
        "(?:the )?(?P<other>COLOR)s? (?:BLOCK )?(?:BE )?(?:with|near|by|next to) (?:the )?(?P=other)s?(?: BLOCK)?)*",
        "(?:no|without) (?:mixed colors|mixing(?: of)? (?:the )?colors|color mixing)",
        "(?:do not|never) mix (?:the )?colors", "(?:do|must|may|should|can|shall) not (?:be |get )?mix(?:ed)?",
        f"{_EACH} (?:BE |should |must |of )*(?:unicolored|monochrome|one colored|single colored)",
        "colors (?:do not mix|must not mix|BE not mixed|stay apart|BE separate|BE separated)",
        f"no {G} (?:may |can |should |must )?(?:has|have|contain|contains|mixes|mix) (?:more than one color|2 "
        "colors|different colors|several colors)",
    ),
    *patterns(
        "basis", "kind", "(?:by|according to|per) (?:their |its |the )*(?:kind|type|sort|kinds|types)",
        "letters (?:BE )?with letters(?: ,)?(?: and)? (?:digits|numbers) with (?:digits|numbers)",
    ),
    *patterns(
        "basis", "odd and even", "(?:by|according to|based on|with respect to|depending on|in terms of) (?:their |"
        "the )?parity",
        "(?:(?:by|into|in|as|to) )?(?:the |its |their )*(?:odds? and (?:the )?evens?|evens? and (?:the )?odds?|odd "
        "or even|"
        f"even or odd|whether they are odd or even|evenness)(?: numbers| digits| ones| BLOCK)?(?: {GS})?",
    ),
    *patterns(
        "basis", "vowels and consonants",
        "(?:by|into|in|as|to|according to|depending on) (?:the |their )*(?:vowels and (?:the )?consonants|consonants "
        "and vowels|vowel and consonant|vowel or consonant|consonant or vowel|vowels or consonants|whether (?:they|"
        "it) (?:are|is a) (?:vowels|vowel) or (?:a )?(?:consonants|consonant))",
        "vowel (?:and|vs|versus|or|/) consonant|vowels (?:vs|versus|/) consonants",
        "vowels (?:BE )?with vowels(?: ,)?(?: and)? consonants with consonants",
    ),
    *patterns(
        "basis", "letters and digits",
        "(?:by|into|in|according to) (?:letters and (?:digits|numbers)|(?:digits|numbers) and letters)",
    ),
    *patterns(
        "basis", "odd and even",
        f"(?:in |into |as )?(?:an? |one |the |its |their )*(?:odd {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| the)* "
        f"even|even {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| the)* odd) {_ADJ}*{G}",
    ),
    *patterns(
        "basis", "vowels and consonants",
        f"(?:in |into |as )?(?:an? |one |the |its |their )*(?:vowels? {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| "
        f"the)* consonants?|consonants? {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| the)* vowels?) {_ADJ}*{G}",
    ),
    *patterns(
        "basis", "letters and digits",
        f"(?:in |into |as )?(?:an? |one |the |its |their )*(?:letters? {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| "
        f"the)* (?:digit|number)s?|(?:digit|number)s? {_ADJ}*{G}(?: ,)?(?: and)?(?: an?| one| the)* letters?) "
        f"{_ADJ}*{G}",
    ),
    *patterns("glue", None, "by (?:the )?(?:letter|digit|number) (?:kind|type|class|category)"),
    *patterns("basis", "size", "(?:by|according to|per) (?:their |its |the )*size"),
    *patterns(
        "basis", "label",
        "(?:by|according to|per) (?:their |its |the )*(?:letter|label|symbol|number|digit|letters|labels|numbers)",
        "(?:each|every) (?:letter|number|digit|symbol) (?:BE )?(?:in |forms |has |gets |makes )?(?:its|a|an|one) "
        f"{_ADJ}*{G}(?: of its own)?",
    ),
    *SORTS,
    *patterns(
        "slot", lambda match: match["slot"],
        f"{_IN}(?:the |a |an |its |their )*(?P<slot>one|a|other|another|{ORD})(?: (?:hand|side))? {_ADJ}*{G}{_OF}",
        f"{_IN}(?:the |a |an |one |another )*{_ADJ}*{G} (?:BE )?(?:on|at|to|in) (?:the |its )(?P<slot>left|right|"
        f"middle|center)"
        f"(?: side| hand side| half)?{_OF}",
        f"{_IN}(?:the )?(?P<slot>other|another|{ORD})(?: one| hand side)?{_OF}",
        f"in (?P<slot>one)(?: of them)?{_OF}", "(?P<slot>group|pile|cluster|bunch|heap) (?:of|:)",
        f"(?:the )?(?P<slot>one|other|first|second) of which{_OF}",
        f"(?P<slot>one)(?: of them)? (?:{OF}|:)(?: {OF})*", f"{_IN}(?P<slot>a) {_ADJ}*{G}{_OF}",
    ),
    *patterns(
        "slot", lambda match: match["slot"],
        f"{_IN}(?:a|an|one|another) {_ADJ}*{G} (?:over )?(?P<slot>here|there)",
        "(?:BE )?(?:(?:on|at|to|in) )?(?:the |my )?(?P<slot>left|right)(?: (?:hand )?side| half| end| hand)?(?: of "
        "the TABLE)?(?: :)?", "(?:BE |over )?(?P<slot>here|there)(?: :)?",
        f"(?:BE |put )?(?:in|into|to|as) (?:the )?{G} (?P<slot>[123]|one)",
        f"(?:the )?{G} (?P<slot>[123A-C]|one)(?: :| =| has| contains| BE| with| gets)",
    ),
    *patterns(
        "strange", lambda match: number(match["count"]),
        "(?:with|has|have|contains?|but|there (?:is|are)|leave|leaving|keep|hold|holds|plant|hide|add|slip|"
        "smuggle|sneak|and|having|includes|including|gets|also) (?:only |just |exactly |a |an |always "
        f")*(?P<count>NUM)(?: single| lone)? {_ODD}",
        f"(?:exactly |just |precisely |only )+(?P<count>NUM)(?: single)? {_ODD}", f"(?P<count>NUM) {_ODD}",
    ),
    *patterns(
        "every", None, f"(?:(?:in|per|for|to|of|within|inside|among) )?{_EACH}(?: (?:BE|has|have|contains|gets))?",
        f"per {G}",
    ),
    *MIXED,
    *SNEAKED,
    *EXCEPT,
    *EACH_HAS,
    *patterns(
        "apart", _apart,
        rf"(?:the )?(?:{GS} |NUM )?(?:BE )?(?:at least|no less than|minimum) (?P<length>[\d.]+) (?P<unit>cm|mm|"
        f"centimeters?|centimetres?)(?P<noun> of space)? (?:apart|from each other|between (?:them|the {GS}|the NUM "
        f"{GS}|each other)|away from each other|distance(?: between them| between the {GS})?)",
    ),
    *patterns(
        "apart", _apart,
        "(?:with |leave |leaving |keep |keeping )?(?:a |the )?(?P<noun>distance|gap|space|spacing|clearance)s? "
        r"(?:of |BE )?(?:at least|no less than) (?P<length>[\d.]+) (?P<unit>cm|mm) between (?:the |each |NUM "
        f")*(?:{GS}|{G}|them)",
    ),
    *patterns(
        "glue", None,
        "as (?:must|should|do|are|shall)", "(?:must|should|have to|need to|shall|to|be|are)(?: be)? (?:disjoint|"
        "distinct)",
        "(?:well |clearly |far |a bit )?(?:apart|separated|separate|distinct)(?! from (?:each|one) )",
        f"(?:the |these |both |all )*{GS} (?:BE )?(?:well |clearly |far |a bit )?(?:apart|separated|separate|distinct) "
        "from (?:each other|one another)",  # of blocks it may be meant of those of one group
        "(?:the )?NUM kinds", "(?:the )?(?:different )?colors",
    ),
]  # fmt: skip
