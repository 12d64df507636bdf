"""The words of flat figures: which figure, whether it is filled, its colours, and all of its patterns."""

from __future__ import annotations

from rpg.language.frames.lots import LOTS
from rpg.language.frames.pieces import Pattern, number, patterns
from rpg.language.frames.shapes.measures import LIMBS, SIZES
from rpg.language.frames.shapes.places import IT, PLACES, WAYS
from rpg.language.frames.shared import BREAKS, GLUE, WHERE

_KIND = "(?: (?:sign|symbol|shape|shaped|figure|form|pattern|formation|arrangement|layout|design))*"
_LETTER = "(?:(?:the |a )?(?:(?:capital|block|upper case|uppercase|big) )?letter )?(?:(?:capital|uppercase) )?"

_BIG = "big|large|huge|giant|small|little|tiny"

FIGURES: list[Pattern] = [
    *patterns("figure", "plus", f"(?:plus|cross){_KIND}", "and (?:shaped?|sign|symbol|figure)"),
    *patterns("figure", "circle", f"(?:circle|ring|loop){_KIND}",
        f"(?:circular|round)(?: ring| circle)?{_KIND}(?<!circular)(?<!round)"),
    *patterns("figure", "triangle", f"(?:equilateral )?triangle{_KIND}",
        "triangular (?:shape|figure|form|formation|arrangement|outline)"),
    *patterns("figure", "square", f"square(?! PATCH| base| BLOCK){_KIND}", "square (?:ring|frame)"),
    *patterns("figure", "rectangle", f"(?:rectangle|oblong){_KIND}",
        "rectangular (?:shape|figure|form|formation|arrangement|ring)"),
    *(found for letter in "TLUVX" for found in patterns("figure", letter,
        f"{_LETTER}'?{letter}'?{_KIND}", f"{_LETTER}'?(?<!')\\b{letter.lower()}(?: shape| shaped| form| figure)+",
        f"(?:an?|the|letter|the letter|a letter) {letter.lower()}(?= (?:of|from|out|made|with|using|on|,|that|"
        "which|whose|shape))", f"(?:{_BIG})(?: letter)? {letter.lower()}(?= (?:of|from|out|made|using))",
        *(["(?:^|a )you (?:shape|shaped)(?= (?:with|of|from|out|made|,|:|NUM))"] if letter == "U" else []))),
    *patterns("again", None, "(?:the|this|that) (?:figure|shape|whole figure|whole thing|form|whole shape)",
        "it(?= BE )"),
]  # fmt: skip

FILL: list[Pattern] = [
    *patterns("fill", "hollow", "(?:trace|traces|tracing|mark|marks|outline|outlines|outlining)(?: out)?(?= (?:a|"
        "an) (?:square|triangle|rectangle)\\b)",
        "(?:(?:just|only) )?(?:the |an |a )?(?:outline|contour|perimeter|boundary|frame|outer line|edges)(?: "
        r"only)?(?: (?:of|for))?(?: an?| the)?(?= (?:square|rectangle|triangle|rectangular|triangular)\b)",
        "(?:just|only) (?:the |its |an )?(?:outline|contour|border|edges?|frame|perimeter)",
        "(?:the |an |in )?outline(?: only)?",
        "(?:outline|edges|border|frame) only", "hollow|unfilled|outlined", "frame",
        "(?:(?:and |with )?(?:the |its |whose )?(?:inside|interior|inner part|middle|center|hole|space inside)(?: "
        f"of {IT})? )(?:BE )?(?:left |kept |staying |stays |remains |remaining |that stays )*(?:empty|free|open|"
        "hollow|clear|unfilled|bare|vacant|blank)",
        "(?:that |which )?(?:BE )?(?:left |kept )?(?:empty|hollow|free|open|unfilled)(?: BE)? (?:inside|within|in "
        "the (?:middle|center|inside)|in its (?:middle|center)|in it|in middle|in center|on the inside|in between)",
        f"(?:leaving|leave|keeping|keep|leaves|keeps) (?:the |its )?(?:inside|interior|middle|center)(?: of {IT})? "
        "(?:empty|free|open|clear|unfilled|hollow|bare|blank)",
        "(?:and |with )?(?:there is |has )?(?:nothing|no BLOCK)(?: BE)? (?:inside|within|in the (?:middle|center|"
        f"inside)|in its (?:middle|center)|in it|inside it|in middle|in between)(?: of {IT})?",
        "without (?:anything|any BLOCK|a BLOCK|BLOCK) (?:inside|within|in the (?:middle|center)|in it|inside it)",
        "(?:with )?(?:a )?hole in (?:(?:the|its) )?(?:middle|center)", "(?:with )?nothing (?:in|inside)(?: of)? it",
        "(?:in |on )?(?:the |its )?(?:inside|interior|middle) it (?:BE )?(?:empty|free|hollow|open)",
        "empty(?= (?:square|rectangle|triangle)\\b)", "around the edges?", "(?:a|the) border of"),
    *patterns("fill", "filled",
        "(?:to be )?filled(?: in| up| out)?(?: by| with)?|solid|full|massive|completely filled|filled completely|"
        "completely full|fully filled",
        "(?:with )?(?:no|without a|without any|without) holes?(?: in (?:it|the middle|the center))?",
        "(?:the |its |with the )?(?:inside|interior|middle|center) (?:BE )?(?:filled|full)(?: in| too| as well)?",
        "not hollow"),
    *patterns("fill", "hollow", "(?:but |and )?not (?:filled|solid|full)(?: in)?"),
]  # fmt: skip

LOOKS: list[Pattern] = [
    *patterns("lot", None, "(?P<count>NUM) x (?P<color>COLOR)(?: BLOCK)?"),
    *patterns("any", True, "(?:, )?(?:of |in )?(?:any|whatever|whichever|any old) colors?(?: at all| you like| you "
        "want)?(?: (?:(?:BE|are|is) )?(?:fine|ok|okay|good|allowed|will do|works|goes))?",
        "(?:the )?colors? (?:does|do|is|are) (?:not (?:matter|important)|unimportant|free)",
        "no matter (?:what|which) colors?",
        "(?:i )?do not (?:care|mind) (?:about )?(?:what |which |the )?colors?(?: (?:they|it) (?:are|is|have))?",
        "what color"),
    *patterns("lot", None, "(?P<count>NUM) of (?:them|these|which)(?: BLOCK)? (?:BE )?(?:in )?(?P<color>COLOR)"),
    *patterns("total", lambda m: number(m["count"]), r"(?<=[,.] )(?P<count>NUM)(?= [.!]| $)"),
    *patterns("total", lambda m: number(m["count"]), "(?:, )?of which there (?:BE) (?P<count>NUM)(?= ,)",
        "(?P<count>NUM) of (?:them|these)(?= [,.;!])"),
    *patterns("lot", None, "(?:(?:all|every one|each one|each|everything)(?: of (?:them|these|it|the BLOCK)| BLOCK)? "
        ")?(?:BE )?(?:of |in |have |having |with )?"
        "the color (?P<color>COLOR)"),
    *patterns("lot", None, "(?:all|every one|each one|everything|each BLOCK|every BLOCK)(?: of (?:them|these|it|"
        "the BLOCK)| BLOCK)?(?: (?:BE|in))? (?P<color>COLOR)(?! (?:but|except|apart|save))"),
    *patterns("colors", "alternating",
        "(?:in |of |with |so that )?(?:the |strictly )?(?:alternating|alternate|alternates|alternately|"
        "alternation)(?: (?:in )?colors?| pattern| order)*",
        "(?:the )?colors? (?:should |must |shall )?(?:alternate|alternates|alternating)", "(?:in |taking )turns",
        "by turns", "in turn",
        "(?:the )?(?:two )?colors (?:take|taking) turns"),
    *patterns("colors", "different",
        "(?:each|all|every one)(?: one| of them| BLOCK)?(?: BE)?(?: has| of| in| with)?(?: a)? different colors?",
        "(?:of |in |with )?(?:all )?different colors",
        "(?:each|every)(?: one| of them| BLOCK)? (?:BE )?(?:has |of |in |with )?(?:its own|another|a color of its "
        "own)(?: color)?", "no 2 (?:BLOCK )?(?:of|in|have|with) the same color"),
]  # fmt: skip

OWN_BREAKS: list[Pattern] = patterns(
    "break",
    None,
    r"[()]",
    ",? ?(?:and )?(?:so that|such that|in such a way that|in a way that)",
    ", and|, with|, where|, but|, while|: with",
)
EXCEPT: list[Pattern] = patterns(
    "except", None, r"but(?: for)?", r"except(?: for)?|apart from|save for|other than", ", (?:but|except(?: for)?)"
)
OWN_GLUE: list[Pattern] = [
    *patterns("glue", None, "standing|placed|sitting|lying|making|arranged|sits?|rests?|so|to make|to give|that "
        "together|which together|together"),
    *patterns("glue", None, "(?:and )?nowhere else|do|dream of|imagine|picture|in plan|plan|forming|be used|used|"
        "used for|(?:that |which )?be (?:formed|made|built|laid|shaped)(?: of| from| by| with| out of)?|also|"
        "ordinary|given|"
        "some|so|love|been|have|down|altogether|overall|in total|in all|total|they|together they|flat|lying flat|"
        "laid flat|lying|laid|out|out of|'s|exactly|there|here|its|whose|their", ", (?:which|that) (?:BE)"),
    *patterns("glue", None, "(?:in |into |to |like |as )?(?:an? |the )?(?:shape|form|figure|pattern|arrangement|"
        "formation|layout|letter)(?: (?:of|like|:))?(?: an?| the)?"),
    *patterns("glue", None, "(?:the |these |all the |all these |my |your )?(?:BLOCK)(?= (?:form|make|should|must|"
        "shall|are|stand|lie|in|as|into|on|to)\\b)"),
    *patterns("glue", None, "(?:big|large|small|little|tiny|giant|huge|mini)(?= (?:plus|cross|circle|ring|square|"
        "triangle|rectangle|[TLUVX]) )",
        "apiece", "each(?= [,.;])", "it(?= (?:with|has|BE) )"),
    *patterns("glue", None, "only(?= [,.;!])", "take|grab", "needed|are needed",
        "(?:arrange|put|place|lay|set|use|form|make|bring|organize)(?: out)? (?:them|these)(?: all| out)?",
        "(?:could|can|would|will|should|shall|must) the robot(?: please| kindly)?",
        "(?:one|a single|single)(?= (?:circle|ring|square|plus|cross|triangle|rectangle|letter|[TLUV])\\b)",
        "(?:it|they) (?:looks?|becomes?|makes?|forms?|should|shall|must)(?: like)?"),
    *patterns("glue", None, "(?:(?:there|here) (?:are|is)|(?:we|i|you) have)",
        "(?:out of|from|of|with|using|use) (?:all of )?(?:them|these)", "for which",
        "all the way (?:a?round)"),
    *patterns("glue", None, "(?:a?round)(?= in (?:a )?(?:circle|ring))",
        "shape|draw|write|makes|shaped|pattern|colors?|colored|in color|kind of"),
    *patterns("glue", None, "(?:in|into) (?:NUM )?rows(?= [:,])"),
    *patterns("glue", None, "(?:as )?(?:seen|viewed|looked at) from above(?: ,)?|in (?:a |the )?top view",
        "looks? like|that looks like|like|resembling|represents|show|result|should|shall|must|"
        "would|makes up|become|becomes|becoming|serves? as|acting as|acts as|take|takes|play|plays"),
]  # fmt: skip

PATTERNS: list[Pattern] = [
    *FIGURES, *FILL, *SIZES, *LIMBS, *WAYS, *PLACES, *LOOKS, *LOTS, *WHERE,
    *EXCEPT, *BREAKS, *OWN_BREAKS, *GLUE, *OWN_GLUE,
]  # fmt: skip
