"""The words for grids, walls, pyramids and cubes of blocks, and for places in them."""

from __future__ import annotations

import re
from typing import NamedTuple

from rpg.language.frames.pieces import Pattern, number, patterns


class Place(NamedTuple):
    """Where blocks are. `kind`: "line" (`axis` where it is told), "cells", or "rest"; `many`: how many lines are meant,
    or of the rest how many blocks, 0 where that is not told; `blocks`: how many are there, 0 where not told."""

    kind: str
    side: str
    axis: str | None = None
    many: int = 0
    blocks: int = 0


_SIDES = {
    "far": "far|farther|farthest|further|furthest|back|backmost|rear|rearmost|hind|hindmost",
    "near": "near|nearer|nearest|front|frontmost|foremost|closest|closer",
    "left": "left|left hand|leftmost",
    "right": "right|right hand|rightmost",
    "top": "top|topmost|upper|uppermost|higher|highest|tip|peak|apex|summit",
    "bottom": "bottom|bottommost|lower|lowermost|lowest|undermost|base|ground|foundation",
    "middle": "middle|center|central|intermediate",
    "other": "other|remaining",
    "outer": "outer|outside|outermost",
    "1": "first|1st", "2": "second|2nd", "3": "third|3rd", "4": "fourth|4th", "5": "fifth|5th", "6": "sixth|6th",
    "last": "last",
}  # fmt: skip
_SIDE_OF = {word: side for side, words in _SIDES.items() for word in words.split("|")}
_AXIS_OF = {"row": "row", "line": "row", "column": "column", "file": "column"}
"""Axes by their words; all the others are layers."""
_PLAIN = ("far", "near", "left", "right", "top", "bottom", "middle")
AXES = "(?P<axis>row|line|column|file|layer|level|tier|floor|storey|story|course)"


def _side(*sides: str) -> str:
    """A group for the words of some sides, of all of them where none is named."""
    words = [word for word, side in _SIDE_OF.items() if side in sides or not sides]
    return f"(?P<side>{'|'.join(sorted(words, key=len, reverse=True))})"


def axis_of(match: re.Match[str]) -> str:
    """The axis that the group of AXES says."""
    return _AXIS_OF.get(match["axis"], "layer")


_HALF = -1
"""As `many` of a place: half of all lines."""


def _line(match: re.Match[str]) -> Place:
    named = match.groupdict()
    side = number(named["number"]) if named.get("number") else _SIDE_OF[named["side"]]
    axis = axis_of(match) if named.get("axis") else None
    if named.get("half"):
        return Place("line", str(side), axis, _HALF)
    count = 1 if named.get("single") else int(named.get("count") or 0)
    return Place("line", str(side), axis, int(named.get("many") or 1), count)


def _corner(match: re.Match[str]) -> Place:
    return Place("cells", f"{_SIDE_OF[match['a']]} {_SIDE_OF[match['b']]}")


_FAR, _NEAR = "far|back|rear|top|upper", "near|front|bottom|lower"


def _diagonal(match: re.Match[str]) -> Place:
    """The diagonal that begins in the far left, or in the far right corner; one that is none has no cells."""
    far = "left" if (_SIDE_OF[match["a"]] in ("far", "top")) == (match["b"] == "left") else "right"
    across = match["b"] != match["d"] and (match["a"] in _FAR.split("|")) != (match["c"] in _FAR.split("|"))
    return Place("cells", f"diagonal {far}" if across else "")


def _rest(match: re.Match[str]) -> Place:
    counts = (said for name, said in match.groupdict().items() if name.startswith("many") and said)
    return Place("rest", "", None, int(next(counts, 0)))


_KINDS = (
    "(?:(?:one|single|small|big|large|huge|giant|little|tiny|simple|plain|nice|neat|proper|regular|complete|full|"
    "filled|solid|flat|low|"
    "short|thick|"
    "standing|upright|brick|mini|decent) )*"
)
_CHECKER = "(?:checkerboard|chessboard|checkered|chequered|checker|checkers|chess|chess board|checker board)"
_BOARD = "(?:checkerboard|chessboard|(?:chess|checker|checkers|draughts) (?:board|grid|square))"
_ALTERNATING = (
    "(?:in )?(?:alternating|alternate|alternately|taking turns|(?:with |in |the |their |of )*(?:alternating colors|"
    "colors alternate|colors alternating))"
)
FIGURES: list[Pattern] = [
    *patterns("figure", "grid",
        f"{_KINDS}(?:(?:rectangular|square) )?(?:grid|array|matrix|lattice)(?: (?:pattern|formation|arrangement))?"),
    *patterns("figure", "rectangle",
        "(?:(?:small|flat|little) )*(?:filled|filled in|solid|full|complete)(?: flat)? rectangle",
        "rectangle(?: (?:that is )?filled)"),
    *patterns("figure", "outline", "(?:(?:small|flat|little) )*rectangle"),
    *patterns("figure", "square", f"{_KINDS}square(?: (?:that is )?filled(?: in)?)?"),
    *patterns("figure", "wall",
        f"{_KINDS}(?:long |tall |high |big )?(?:(?:block|castle|garden|brick|stone|city|boundary|fortress|border) "
        f")?wall"),
    *patterns("figure", "pyramid",
        f"{_KINDS}(?:big )?(?:step |stepped |layered )?(?:square |square based |flat |(?:two|2) dimensional |"
        f"triangular )?"
        "pyramid"),
    *patterns("figure", "cube",
        f"{_KINDS}(?:big|large|huge|giant|bigger|larger|solid|compact)(?: solid)? (?:cube|block|cuboid|box)", "cuboid",
        "(?:cube|block)(?= (?:of|from|out of|made|consisting|built|that is made|which is made|that consists|which "
        "consists|with (?:an? )?(?:edge|side)) )", r"cube(?= \d+x\d+x\d+ )",
        r"(?<=\dx\d )cube", r"(?<=\dx\dx\d )cube"),
    *patterns("figure", "board", f"{_KINDS}{_BOARD}(?: pattern| grid| square)?",
        f"{_KINDS}(?:checkered|chequered|checkerboard|chessboard|chess) (?:floor|area|surface|field|tiling|mat|plane|"
        f"carpet|rectangle|square)"),
    *patterns("checkered", None,
        f"(?:in |with |like |as |has |showing |to form |after )*(?:(?:a|the) )?{_CHECKER}(?: like)? "
        "(?:pattern|fashion|style|way|arrangement|order|manner|coloring|design)",
        f"(?:{_ALTERNATING} )?(?:(?:that|which|to|it) )?(?:(?:look|looks|looking) )?(?:like|as|after the manner of|"
        f"in the manner of) (?:on |in )?(?:a |the )?"
        f"(?:small |real )?{_BOARD}",
        "(?:like|as in|as on|as for) (?:a )?(?:chess|checkers|draughts)(?: game)?", "chess style",
        "(?:checkered|chequered)"),
]  # fmt: skip
"""Kinds "figure" (which) and "checkered"."""
_FIGURE = "(?:grid|array|matrix|wall|pyramid|cube|square|rectangle|figure|checkerboard|chessboard|board)"
_THE = "(?:the |its |their |your |my )?(?:very )?"
_IN = "(?:all )?(?:in |at |to |along |for |as )?"
_LEVELS = "(?P<axis>layer|level|tier|floor|storey|story|course)"
_OF = f"(?: of (?:it|them|the {_FIGURE}))?"
_FROM = "(?: away)?(?: (?:from|to) (?:me|us|you|the (?:viewer|camera|robot)))?"
_THEM = "(?:them|that|those|these|this|both(?: of them)?|the 2|the others)"
_UPON = "(?:on top of|over|above|upon)"
_LINE = "(?:row|layer|level|one)"
_NOT_BESIDE = "(?<!pyramid and )(?<!wall and )(?<!cube and )(?<!square and )"
"""Not behind a figure: "a pyramid and a row of three" are two structures."""
_MIDDLE = "(?:in|at|on) (?:the|its) (?:very |exact )?(?:middle|center)"
PLACES: list[Pattern] = [
    *patterns("place", _line,
        rf"{_IN}{_THE}{_side()}(?: most)? {AXES}(?: away)?{_OF}", rf"(?:all )?on {_THE}{_side()} {_LEVELS}{_OF}",
        rf"(?:all )?on {_THE}{_side('far', 'near', '1', '2', '3', '4', '5', 'last', 'middle')} {AXES}{_OF}",
        rf"{_IN}{_THE}{AXES} (?:(?:which|that) )?(?:BE )?(?:in |at |on |to )?(?:the )?{_side(*_PLAIN)}(?: side)?"
        rf"{_FROM}",
        rf"{_IN}{_THE}{_side('far', 'near')} {AXES}{_FROM}",
        rf"{_IN}(?:the )?{AXES} (?:number )?(?P<number>NUM)(?! BLOCK)",
        rf"(?:all )?(?:in |on )?(?:(?:the|both|its) )*(?P<many>\d+) {_side()} {AXES}s",
        rf"{_IN}(?:the |both )?{_side('1', 'last', 'top', 'bottom', 'far', 'near', 'left', 'right', 'other')} "
        rf"(?P<many>\d+) {AXES}s",
        rf"{_IN}(?:the |its )(?:very )?{_side()}(?: one| end)?", rf"the one (?:in|at|on) "
        rf"the {_side(*_PLAIN)}{_FROM}", rf"{_IN}(?:the )?{_side('far', 'near')}{_FROM}",
        rf"(?:all )?(?:in|at|to|as) (?:(?:the|a) )?(?:very )?{_side(*_PLAIN)}(?: side| end)?",
        rf"(?:all )?on (?:(?:the|a) )?(?:very )?{_side('left', 'right', 'top', 'bottom')}(?: side| end)?",
        rf"(?:at|as|in) its {_side(*_PLAIN)}", rf"(?:at|as) (?:its |the )?{_side('top', 'bottom')}{_OF}",
        rf"on {_side('top')} {_MIDDLE}",
        rf"(?:the |its )?{_side(*_PLAIN)} (?P<count>\d+)(?: BLOCK| ones)?(?! (?:rows|columns|layers|by|x))",
        rf"(?:the )?(?P<count>\d+)(?: BLOCK| ones)? (?:in|at|on) the {_side(*_PLAIN)}(?= (?:BE )?(?:all )?(?:in "
        rf")?COLOR)",
        rf"(?:the |its )?{_side(*_PLAIN)} (?:blocks|cubes|ones)(?: in {AXES})?",
        rf"(?:the |its )?{_side('top', 'bottom')}(?= (?:an? )?(?:single |lone )?(?:NUM )?COLOR )",
        rf"(?:the |its )?(?:very )?{_side('top', 'bottom')} (?P<single>block|cube|piece|element)",
        rf"{_side(*_PLAIN, '1', '2', '3', '4', 'last')}(?: one)?(?= (?::|'s|is|are|BE|(?:all )?COLOR))",
        rf"{_side(*_PLAIN[:-1])}(?= [,.;)]| and | $)", rf"(?:the |both )?{_side('outer')} (?P<many>2)",
        rf"{_side('middle')}(?: one)?", "(?P<side>tip|peak|apex)", rf"(?:the )?{_side(*_PLAIN[:-1])} (?P<half>half)"),
    *patterns("place", Place("line", "top"),
        "(?:(?:which|that) is )?(?:is )?(?:crowned|topped|capped|finished)(?: off)?(?: (?:by|with))",
        "(?:crowns?|tops?|caps?|finishes)(?: off)? (?:it|them|this|everything|the pyramid)"),
    *patterns("place", Place("line", "bottom", None, 1),
        "(?:(?:with|on|upon|over) )?(?:a |the |its )?(?:base|baseline|(?:base|bottom|lowest) (?:row|layer|line))"
        "(?: of (?:it|the (?:pyramid|wall|figure|cube)))?(?: (?:of|is|being|has|"
        "having|with|made of|consists of|consisting of|containing|contains|shall|should|must|be|a row of))* "
        "(?=(?:(?:the|a) )?(?:NUM )?(?:SIZE )?COLOR)".replace("* (?=", "*(?= ")),
    *patterns("place", Place("rest", "between"), "in between", "between(?: them)?"),
    *patterns("place", Place("line", "2", "layer"),
        f"{_UPON} (?:the|its) (?:base|bottom|bottom (?:layer|row)|base (?:layer|row)|first (?:layer|row))"),
    *patterns("place", Place("line", "far"), "(?:all )?behind(?: (?:it|them|that))?",
        f"{_IN}the (?:row|one) behind(?: (?:it|them|that))?"),
    *patterns("place", Place("line", "near"), "(?:in front|before)(?: of)? (?:it|them|that|those|these)",
        f"{_IN}the (?:row|one) (?:in front|before it)(?: of (?:it|them|that))?"),
    *patterns("place", Place("line", "above"), f"(?:{_UPON}|on) {_THEM}", "above",
        f"(?:in |on |as )?the {_LINE} (?:above|over|on(?: top)?(?: of)?)(?: (?:it|{_THEM}))?",
        f"(?:in |on |as )?(?:the )?next(?: {_LINE})?(?: up| above)?"),
    *patterns("place", lambda match: Place("line", "above", None, 1, int(match["count"])),
        r"the (?P<count>\d+) (?:BLOCK |ones )?above"),
    *patterns("place", Place("line", "above it"), f"(?:{_UPON}|on) it"),
    *patterns("place", Place("line", "below"), f"(?:under|below|underneath|beneath)(?: {_THEM})?",
        f"(?:in |on )?(?:the )?{_LINE} (?:below|under|underneath|beneath)(?: (?:it|that|them))?"),
    *patterns("place", Place("cells", "center"),
        f"{_IN}{_THE}(?:exact |dead )?(?:middle|center|central) (?:BLOCK|cell|square|position|spot|place|field){_OF}",
        f"(?:for )?the (?:BLOCK|cell|square) (?:in|at) the (?:very )?(?:middle|center){_OF}",
        f"(?:right )?(?:in|at) (?:the|its) (?:very |exact )(?:middle|center){_OF}",
        "(?:right )?(?:in|at) (?:the |its )?dead center", "dead center"),
    *patterns("place", Place("cells", "corners"),
        f"{_IN}(?:(?:the|its|all|4) )*(?:corners|corner (?:blocks|cubes|cells|squares|positions|ones|places)){_OF}",
),
    *patterns("place", Place("cells", "corners"), "on the(?: 4)? corners"),
    *patterns("place", Place("cells", "corners", None, 4),
        f"(?:(?:in|at) )?(?:each|every)(?: one)?(?: of (?:the|its)(?: 4)?)? corners?{_OF}"),
    *patterns("place", Place("cells", "edges"), f"{_IN}(?:(?:the|its|all|4|outer) )*(?:edges|sides)"),
    *patterns("place", Place("cells", "border"),
        "(?:all )?(?:around|round)(?: (?:it|that|the (?:middle|center)(?: one| block)?))?", f"{_IN}(?:(?:the|its|a) "
        f")?(?:outer |outside )?(?:border|rim|frame|perimeter|(?<=outer )ring|(?<=outer )edge|boundary)(?: of (?:it|"
        f"the {_FIGURE}|BLOCK))?",
        f"{_IN}(?:the |its )?(?:outer|outside|outermost|edge|border) (?:blocks|cubes|ones|cells)"),
    *patterns("place", Place("cells", "inside"), f"{_IN}(?:(?:the|its|a) )?(?:inside|interior|inner part|inner square)",
        f"{_IN}(?:the |its )?(?:inner|interior|inside) (?:blocks|cubes|ones|cells)"),
    *patterns("place", lambda match: Place("cells", "inside", None, 0, int(match["count"])),
        rf"{_IN}(?:the |its )?(?:inner|interior|inside) (?P<count>4|6|8|9)(?: BLOCK| ones| cells| squares)?"
        r"(?! (?:rows|columns|layers|by|x))",
        rf"{_IN}(?:the |its )?(?P<count>\d+) (?:inner|interior|inside) (?:BLOCK|ones|cells|squares|places)"),
    *patterns("place", _diagonal,
        rf"{_IN}(?:the )?(?:main )?diagonal (?:(?:which|that) )?(?:(?:goes|runs|going|running|leading) )?from (?:the "
        rf")?(?P<a>{_FAR}|{_NEAR}) (?P<b>left|right)"
        rf"(?: corner)?(?: down| up)? to (?:the )?(?P<c>{_FAR}|{_NEAR}) (?P<d>left|right)(?: corner)?"),
    *patterns("place", Place("cells", "diagonals"), f"{_IN}(?:both|the|the 2|both the)(?: main)? diagonals"),
    *patterns("place", _corner,
        rf"(?:the (?:BLOCK|one) )?{_IN}(?:the )?(?P<a>far|back|rear|near|front|top|upper|bottom|lower) "
        rf"(?P<b>left|right)(?: hand)?"
        rf"(?: (?:corner|BLOCK|cell|one|square|position))?{_OF}",
        rf"{_IN}(?:the )?(?P<b>left|right) (?:hand )?(?P<a>far|back|rear|near|front|top|upper|bottom|lower) "
        rf"(?:corner|BLOCK|cell|one|square|position){_OF}"),
    *patterns("place", _rest, "the remainder", "all (?:of )?the rest",
        f"(?:everywhere|everything|anywhere) else{_OF}", "elsewhere", "otherwise", "everywhere", "the other color(?: "
        "is| being)?",
        "(?:all )?(?:(?:of )?the )?(?:others|rest|remainder)(?: of (?:it|them))?", r"(?:all )?the (?P<many>\d+) others",
        r"(?:in |on |at )?(?:all )?(?:the )?(?:other|remaining)(?: (?P<many>\d+))? (?:blocks|cubes|pieces|ones|"
        r"cells|squares|positions|places|rows|columns|layers)",
        r"the other (?P<many>\d+)|(?:the )?remaining (?P<many_>\d+)"),
]  # fmt: skip
"""Kind "place"."""
JOINTS: list[Pattern] = [
    *patterns("any", True, "(?:(?:of|in|with) )?(?:any|whatever|whichever) colors?(?: (?:(?:at all|you (?:like|want|"
        "choose|wish|prefer)|"
        "will do|(?:BE )?(?:fine|ok|okay|good|allowed|possible|welcome|works?)|goes)))?",
        "(?:the )?colors? (?:of (?:the )?(?:BLOCK|it|them) )?(?:BE )?(?:irrelevant|unimportant|arbitrary|free|"
        "optional|open|up to you|"
        "your choice|not important|not relevant|(?:do|does) not matter)",
        "(?:i )?do not (?:care|mind) (?:about )?(?:what |which )?(?:the )?colors?(?: (?:(?:they|it) (?:are|is|have)))?",
        "no matter (?:what|which) colors?", "(?:with )?no (?:color preference|preference (?:for|of) "
        "colors?)", "(?:of |in )?arbitrary colors?"),
    *patterns("lot", None, r"(?:(?P<det>the|all the) )?(?:(?P<count>NUM) )?(?P<color>COLOR) (?:cells|squares|fields|"
        r"tiles|positions|spots)"),
    *patterns("total", lambda match: number(match["count"]), r"(?:of |with |from )?(?P<count>NUM) (?:squares|cells|"
        r"fields|spaces|slots|spots|tiles)"
        "(?: in total| in all)?"),
    *patterns("then", None, "(?:and )?then", "followed by"),
    *patterns("except", None, "except(?: for| that)?", "apart from", "save for"),
    *patterns("lot", None, "(?P<half>half)(?: of (?:them|it|the BLOCK))?(?: (?:BE |in )*)?(?P<color>COLOR)(?: BLOCK)?"),
    *patterns("glue", None, "as (?:the |its )?(?:second|other|first|main) color"),
    *patterns("some", None, r"(?<!the )(?P<count>NUM)(?: (?:of (?:them|these|which)|ones?))?"),
    *patterns("glue", None, "(?:it|its|they|here|completely|in all|"
        "entirely|all over|fill|fills|cover|covers|tile|occupied by|occupied|occupies|shall|must|be|"
        "upright|standing|lying|have|consists? of|contains?|have got|wanted|needed|required|fully|exclusively|"
        "solely|purely|only|just|nothing but|everything|everything is|all of (?:it|them)|the whole thing|throughout|"
        "it is all|all|for|becomes?|(?:so )?(?:it|they) (?:becomes?|forms?|makes?|is|are)|making|forming|surrounded by|"
        f"{_NOT_BESIDE}a (?:row|line|layer) of(?! NUM and an? (?:pyramid|wall|cube|square) )|over the 4)",
        "stack up|stack(?= NUM (?:layers|levels|tiers) )|erect|fill|tile|cover|enter|write|assemble|layout|"
        "showing|shows|occupy|occupies|hey|hi|hello|ok|okay|so|"
        "(?:would )?(?:you )?mind|building|making|constructing|arranging|laying|placing|putting|creating|down|"
        "(?:my|our) (?:son|daughter|kid|kids|child|boss|friend|wife|husband|customer|client)(?: wants?| needs?)?|"
        "picture|imagine|them all|(?:here is )?(?:the|my) (?:plan|idea|job|wish|request) :|"
        "all (?:of )?(?:the )?BLOCK(?: BE)?|comprising|comprises?|made up of|(?:it is )?requested(?: that)?|"
        "do|love|wants|'s|style|go(?:es)? (?:in|into|on)|that is|put|into|all is|everything in|completely in|together|"
        "(?:the )?colors?(?: of (?:(?:the|all) )*(?:blocks|cubes|it|them))?(?: is| :| being)?|"
        "compact|solid|them(?= (?:out )?(?:as|in|into|to) )"),
    *patterns("break", None, "whose|such that|so that|(?:all )?(?:on|of|with|in) which"),
    *patterns("glue", None, "lay|set|put|spread|makes|it makes", "out(?= (?:as|in|of|on|into|a|the) )",
        "make up", "erected|raised",
        "arrangement|formation|structure|pattern|shape", "(?:somewhere|anywhere)(?= (?:in|on) )"),
    *patterns("over", "center",
        f"(?:(?:(?:that|which) )?(?:BE )?(?:put|placed|set|sitting|resting) )?(?:onto|on top of|atop|over|"
        f"above) {_THE}(?:middle|center|central)"
        f"(?: (?:one|BLOCK|cell|square|position|field))?{_OF}",
        f"(?:on top|above)(?: of (?:it|them))?,? {_MIDDLE}{_OF}"),
    *patterns("glue", None, "(?:the|this|your|my) (?:figure|structure|arrangement|construction|target|goal|"
        "result)(?= (?:BE|must|has|should|shall) )"),
    *patterns("flat", None, "flat"),
    *patterns("glue", None, "got|field|these are|they are|require|requires|full of|that's|measures|measuring|planar",
        "(?:each|every) (?:BLOCK|one|one of them)(?: BE)?(?= (?:COLOR|in|at|on) )",
        "(?:those|the ones|the blocks|the cubes)(?= (?:in|at|on) )"),
    *patterns("filled", None, "(?:that is |which is |is )?filled(?: in)?"),
    *patterns("break", None, r"[()&/-]"),
    *patterns("glue", None, r"each (?:layer|level|one|of which|of them)(?: BE| has| having| with| of| consisting "
        r"of)*(?= "
        r"(?:a )?\d+ rows)"),
]  # fmt: skip
"""Kinds "then" and "except", which part; "some" (a number of blocks); and words that say nothing beside the parts."""
