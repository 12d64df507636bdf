"""What is said of single blocks, small lots and patches: the words for them and for how they stand to each other."""

from __future__ import annotations

import re
from dataclasses import dataclass

from rpg.language.frames.pieces import Pattern, patterns


@dataclass(frozen=True)
class Relation:
    """How one thing stands to another, as it is told behind "must". `turned`: the second is the one that is told of
    first; `mutual`: how it is told of two things together; `count`: so many are behind it; `aside`: it may also mean a part of a patch."""

    phrase: str
    turned: bool = False
    mutual: str = ""
    count: int = 0
    aside: bool = False


_NOUN = "blocks?|cubes?|bricks?|box(?:es)?|ones?"
_PATCH = "patch|mat|zone|pad|spot|target|goal|area|rug|carpet|coaster|marker|field|sheet"
_PLAIN_PATCH = "patch|mat|zone|pad|rug|carpet|coaster|target patch|target zone|goal patch|goal zone|target"
_DET = "the|this|these|those|that|my|our|your|a|an|both|both the|all|all the|all of the|both of the"
_HOW_MANY = "exactly|precisely|at least|at most|no more than|not more than|no fewer than|no less than|not fewer than"
THINGS: list[Pattern] = [
    *patterns("thing", "block",
        rf"(?:(?P<det>{_DET}) )?(?:(?P<count>NUM) )?(?:(?P<size>SIZE) )?(?P<color>COLOR)(?P<many>s)?"
        rf"(?: colored)?(?: (?P<noun>{_NOUN}))?",
        rf"(?:(?P<det>the|a|an) )?(?P<noun>block|cube) (?P<color>COLOR)(?= (?!block|cube))"),
    *patterns("thing", "letter",
        r"(?:(?P<det>the|a|an) )?(?:letters?|block|cube|letter block|letter cube) (?P<letter>[A-Z])(?: (?P<noun>block|cube))?",
        r"(?:(?P<det>the|a|an) )?(?P<letter>[A-HJ-Z])(?: (?P<noun>block|cube))?"),
    *patterns("thing", "number",
        r"(?:(?P<det>the|a|an) )?(?:number|digit|cube|block|number block|number cube) (?P<number>\d)(?! \d)",
        r"(?P<det>the) (?P<number>\d) (?:block|cube)"),
    *patterns("thing", "patch",
        rf"(?:(?P<det>the|this|that|a|an|my|our|your|one) )?(?:(?P<size>SIZE|long) )?(?:(?P<shape>round|square|circular) )?"
        rf"(?P<color>COLOR)(?: colored)?(?: (?P<behind>round|square|circle|circular))? (?P<noun>{_PATCH})",
        rf"(?P<det>the|this|that|a|my|our|your|one) (?:(?P<size>SIZE|long) )?(?:(?P<shape>round|square|circular) )?(?P<noun>{_PLAIN_PATCH})"),
    *patterns("part", None,
        rf"(?:(?P<how>{_HOW_MANY}) )?(?P<part>NUM) (?:out )?of (?:(?:the|these|those|my|our|all) )*(?P<count>NUM) (?P<color>COLOR)s?(?: (?:{_NOUN}))?",
        rf"(?:(?P<how>{_HOW_MANY}) )?(?P<part>NUM) (?:out )?of (?:(?:the|these|those|my|our) )(?P<color>COLOR)s?(?: (?:{_NOUN}))?",
        rf"(?:(?P<how>{_HOW_MANY}) )?(?P<part>NUM) (?P<color>COLOR) (?:{_NOUN}) (?:out )?of (?:the )?(?P<count>NUM)"),
    *patterns("one", None, rf"one of (?:them|these|those|the 2|the 2 (?:{_NOUN}))"),
    *patterns("rest", None,
        rf"(?:the |all the |all )?(?:other|remaining|others) (?:(?P<count>NUM) )?(?:(?P<color>COLOR) )?(?:{_NOUN})",
        rf"(?:the |all the |all )?(?:other|remaining) (?:(?P<count>NUM))", "(?:the )?other (?P<color>COLOR)",
        rf"(?:the |all the |all )?(?:others|rest|remainder)(?: of them| of the (?P<color>COLOR) (?:{_NOUN}))?", "the other"),
    *patterns("it", "any", "it|that one|this one"),
    *patterns("it", "block", "(?:the|that|this) (?:block|cube)"),
    *patterns("they", None,
        "they|them|both|both of them|the 2|the 2 of them|these 2|both (?:blocks|cubes)|the 2 (?:blocks|cubes)|the (?:blocks|cubes)"),
]  # fmt: skip
"""Kinds of what statements are about."""

_CLOSE = "directly|immediately|right|just"
_SIDES = {
    "to the left of": "(?:(?:to|on|at) )?(?:the )?left(?: hand)? (?:of|from|to)|leftwards? of",
    "to the right of": "(?:(?:to|on|at) )?(?:the )?right(?: hand)? (?:of|from|to)|rightwards? of",
    "in front of": "(?:in|at|to) (?:the )?front (?:of|from)|before",
    "behind": "behind|behind of|in back of|(?:at|in|to) the (?:back|rear) of|in the rear of",
}
_ASIDES = {
    "to the left of": "(?:to|on|at) (?:the|its) left(?: hand)?(?: side)?",
    "to the right of": "(?:to|on|at) (?:the|its) right(?: hand)?(?: side)?",
    "in front of": "in its front",
    "on top of": "on top|on (?:its|the) top|on (?:its|the) upper side",
    "under": "underneath|beneath|below",
}


def _sided() -> list[Pattern]:
    """The four sides, as they are and with how close it is."""
    found = []
    for phrase, said in _SIDES.items():
        found += patterns("rel", Relation(phrase), said)
        found += patterns("rel", Relation(f"somewhere {phrase}"), f"somewhere (?:{said})")
        close = lambda match, told=phrase: Relation(f"{match['close']} {told}")
        found += patterns("rel", close, f"(?P<close>{_CLOSE}) (?:{said})")
        measured = lambda match, told=phrase: Relation(f"{match['far']} {told}")
        found += patterns("rel", measured, f"(?P<far>{_FAR}) (?:{said})")
    for side in ("left", "right"):
        beside = Relation(f"to the {side} of", aside=True)
        found += patterns("rel", beside, f"(?:to|on|at) the {side}(?: hand)? side (?:of|from)")
        found += patterns("rel", Relation(f"immediately to the {side} of"), f"(?:to|on) the immediate {side} of")
    for phrase, said in _ASIDES.items():
        found += patterns("aside", Relation(phrase), said)
    return found


_FAR = r"(?:(?:about|around|roughly|approximately|exactly|at least|at most|no more than|no less than) )?(?:\d+(?:\.\d+)?) (?:cm|mm|inch|inches)"


def _far(match: re.Match[str]) -> str:
    return match["far"]


RELATIONS: list[Pattern] = [
    *_sided(),
    *patterns("rel", Relation("on"),
        "(?:right |directly |straight |flat )?(?:on|onto|upon|on to)"),
    *patterns("rel", Relation("off"), "outside|outside of"),
    *patterns("rel", Relation("on top of"),
        "(?:right |directly |straight |stacked )?(?:on top of|on the top of|atop|atop of)", "tops|crowns|caps",
        "stacked (?:on|onto|upon)",
        "(?:is |are |being )?(?:carried|supported|held up|borne) by"),
    *patterns("rel", Relation("on top of", turned=True),
        "carries|carrying|supports|supporting|bears|bearing|carry|support|bear|holds up|(?:is |be )?(?:topped|crowned|capped) (?:by|with)"),
    *patterns("rel", Relation("above"), "(?:somewhere )?(?:above|over)"),
    *patterns("rel", Relation("directly above"), "(?:directly|right|immediately|just|straight) (?:above|over)"),
    *patterns("rel", Relation("under"), "(?:somewhere )?(?:under|below|beneath|underneath)"),
    *patterns("rel", Relation("directly under"), "(?:directly|right|immediately|just|straight) (?:under|below|beneath|underneath)"),
    *patterns("rel", Relation("next to", mutual="next to each other"), "next to|beside|alongside|alongside of|at the side of|by the side of"),
    *patterns("rel", Relation("right next to", mutual="right next to each other"),
        "(?:right|directly|immediately|just|straight) (?:next to|beside|alongside)", "adjacent to|adjoining|(?:directly|immediately) adjacent to"),
    *patterns("rel", Relation("near", mutual="near each other"), "near|near to|close to|close by|nearby|in the vicinity of|not far from|in the neighborhood of"),
    *patterns("rel", Relation("far from", mutual="far apart"), "far from|far away from|well away from"),
    *patterns("rel", Relation("touch", mutual="touch each other"),
        "touch|touches|touching|(?:be |is |are )?in (?:direct )?contact with|(?:right )?up against|makes? contact with|comes? into contact with"),
    *patterns("rel", Relation("between", count=2),
        "between|in between|somewhere between", "(?:is |be |are )?(?:flanked|framed) by"),
    *patterns("rel", Relation("halfway between", count=2),
        "(?:right |exactly )?(?:in the (?:exact )?middle|midway|halfway|half way) between"),
    *patterns("rel", lambda match: Relation(f"{match['far']} from"),
        f"(?:at )?(?:a distance of )?(?P<far>{_FAR})(?: away| apart| distant)? from", f"at a distance of (?P<far>{_FAR}) (?:to|from)"),
]  # fmt: skip
"""Kind "rel" (with things behind it) and "aside" (without)."""
_EACH = "(?:each other|one another)"
MUTUAL: list[Pattern] = [
    *patterns("mutual", "be next to each other", f"(?:next to|beside|alongside) {_EACH}", "side by side", "next door to " + _EACH),
    *patterns("mutual", "be right next to each other", f"(?:right|directly|immediately) (?:next to|beside) {_EACH}", f"adjacent(?: to {_EACH})?"),
    *patterns("mutual", "be near each other", f"(?:near|close to|near to) {_EACH}", "close together", "near together"),
    *patterns("mutual", "be far apart", "far apart(?: from each other)?", f"far (?:away )?from {_EACH}", "well apart"),
    *patterns("mutual", "touch each other",
        f"(?:touch|touches|touching)(?: {_EACH})?", f"in (?:direct )?contact(?: with {_EACH})?", f"up against {_EACH}"),
    *patterns("mutual", lambda match: f"be {match['far']} apart",
        f"(?P<far>{_FAR}) (?:apart|away|distant)(?: from {_EACH})?", f"(?P<far>{_FAR}) from {_EACH}", f"at a distance of (?P<far>{_FAR})(?: from {_EACH})?"),
    *patterns("mutual", "swap places",
        "(?:swap|swaps|exchange|exchanges|switch|switches|trade|trades|change|changes) (?:the |their )?(?:places|positions)(?: with each other)?"),
    *patterns("apart", lambda match: f"be {match['far']} apart",
        f"(?P<far>{_FAR}) between", f"(?:a |the )?distance of (?P<far>{_FAR}) between"),
    *patterns("gap", _far,
        f"(?:(?:a|the) )?(?:gap|space|clearance) of (?P<far>{_FAR}) between", f"(?:a )?(?P<far>{_FAR})(?: wide)? (?:gap|space) between"),
    *patterns("between", "apart", "(?:the )?(?:distance|centre distance|center distance) between"),
    *patterns("between", "gap", "(?:the )?(?:gap|space|clearance) between"),
    *patterns("measure", _far, f"(?:(?:must |should |shall |has to )?(?:be|is|measures|measure|amounts to) )(?P<far>{_FAR})(?: wide)?"),
    *patterns("swap", None,
        "(?:swap|exchange|switch|interchange|trade)(?: round| around| over)?(?: the)?(?: places?| positions?)?(?: of| between)?"),
]  # fmt: skip
"""What two things are to each other."""

_SIDE = "left|right|near|far|front|back"
_CORNER = (
    "(?:(?:near|far|front|back|close|top|bottom|upper|lower) (?:left|right)|(?:left|right) (?:near|far|front|back))"
)
PLACES: list[Pattern] = [
    *patterns("place", lambda match: f"in the {match['side']} half of the table",
        rf"(?:in|on|into|onto|to|within|inside) the (?P<side>{_SIDE}) half(?: of the TABLE)?"),
    *patterns("place", lambda match: f"on the {match['side']} side of the table",
        rf"(?:in|on|onto|to|at) the (?P<side>{_SIDE}) (?:side|part) of the TABLE"),
    *patterns("place", lambda match: f"in the {match['corner']} corner of the table",
        rf"(?:in|at|into|to|on) the (?P<corner>{_CORNER})(?: hand)? corner(?: of the TABLE)?"),
    *patterns("place", "in a corner of the table", "(?:in|at|into|to) (?:a|any|some|one) corner(?: of the TABLE)?"),
    *patterns("place", lambda match: f"at the {match['side']} edge of the table",
        rf"(?:at|on|along|to|by|near) the (?P<side>{_SIDE}) (?:edge|border|rim)(?: of the TABLE)?"),
    *patterns("place", "at the edge of the table", "(?:at|on|by) (?:the|an) (?:edge|border|rim) of the TABLE"),
    *patterns("place", "in the middle of the table", "(?:right )?(?:in|at|into|to|on) the (?:very |exact )?(?:middle|center) of the TABLE", "(?:in|at) the TABLE (?:center|middle)"),
    *patterns("place", "on the table", "(?:directly |right |flat |straight )?(?:on|onto|upon) (?:the |a )?(?:TABLE|ground|floor)"),
    *patterns("stay", None,
        "where (?:it|he|she) (?:is|stands|lies|sits)|where they (?:are|stand|lie|sit)|in (?:its |their |the same )?(?:old |own |original )?(?:place|position|spot)"
        "|(?:stays|stay|remain|remains) (?:put|still)|untouched|unmoved|undisturbed|as (?:it|they) (?:is|are)|alone|in the place where it is"),
    *patterns("elsewhere", None, "elsewhere|somewhere else|anywhere else"),
]  # fmt: skip
"""Kind "place", to be told behind "must be"."""

_POSTURE = "sit|stand|lie|rest|perch|hide|lean|live|dwell|end up|finish|finish up|end|land"
_POSTURES = (
    "sits|stands|lies|rests|perches|hides|lives|dwells|ends up|finishes|finishes up|ends|lands|sitting|standing|lying|"
    "resting|perching|perched|hiding|hidden|sat|stood|located|situated|positioned|placed|set|laid|found|seen|put"
)
_MUST = "must|should|shall|has to|have to|need to|needs to|needs|ought to|is to|are to|is supposed to|are supposed to|will|is going to|has got to|must needs"
_DO = (
    "put|place|set|move|bring|lay|position|shift|push|slide|get|stick|pop|plop|stand|sit|rest|drop|carry|transfer|"
    "locate|make|let|perch|balance|plonk|pull|drag|nudge|set down|put down|lay down|relocate|arrange|deposit"
)
MOODS: list[Pattern] = [
    *patterns("be", "must",
        f"(?:{_MUST})(?: (?:be|go|come|get|touch(?= each| one)|{_POSTURE}))?(?: (?:{_POSTURES}))?", "goes|go|belongs|belong|comes|come|going|to (?:be|go|come|stand|sit|lie|rest)"),
    *patterns("be", "make", f"(?:{_DO})(?: (?:down|over|up))?"),
    *patterns("be", "stack", "stack(?: up)?"),
    *patterns("be", "is", "is|are|being|be", f"(?:(?:is|are|be|being) )?(?:{_POSTURES})"),
    *patterns("there", None, "there (?:is|are)|there (?:must|should|shall|has to|have to|needs to) be|we have|you have|i have|you see|one sees|i see|we see"),
    *patterns("take", None, "take|use|pick|pick up|grab|using|given|you get|we use"),
    *patterns("keep", None, "keep|leave|leaves|keeps|stays|stay|remains|(?:must |should |shall |has to |have to )(?:stay|remain)"),
    *patterns("not", None, "not|never"),
    *patterns("have", None, "with|has|have|having"),
    *patterns("that", None, "so that|such that|in such a way that"),
    *patterns("first", None, "first|firstly|first of all"),
    *patterns("then", None, "then|after that|afterwards|and then|after this|and after that|and afterwards|thereafter|thereupon|finally"),
    *patterns("end", None, "(?:at|in) the end"),
    *patterns("join", None, "and|while|whereas|but|and also|as well as|plus|whilst"),
    *patterns("comma", None, ","),
    *patterns("stop", None, "[.;:!?]"),
]  # fmt: skip
"""Words that bind things and relations together. Kind "be" has the value "do" where something is asked for."""
GLUE: list[Pattern] = [
    *patterns("glue", None, "please|kindly|(?:could|can|would|will) you|you|i|we|me|us|for me|for us|pls"),
    *patterns("sure", "must", "(?:i|we) (?:want|would like|need|wish)(?: that| to (?:see|have))?"),
    *patterns("glue", None, "you (?:must|should|have to)|let us|want|would like|(?:i|we) (?:want|would like|need) you to"),
    *patterns("sure", "do", "(?:make|be) sure(?: that)?|ensure(?: that)?|see to it that|see that"),
    *patterns("sure", "must", "it must be that"),
    *patterns("glue", None, "that(?= the)"),
    *patterns("sure", "must",
        "(?:in )?(?:the |my |a )?(?:final |end |finished |last |closing |goal |target )?(?:picture|image|scene|shot|"
        "view|photo|frame|state|result|goal|task)(?: is| shows| :)(?: that)?",
        "in the (?:final |finished )?(?:picture|image|scene|photo)"),
    *patterns("glue", None, "also(?= (?:must|should|put|place|set|move|is|are|touch|on|next|to|in|left|right) )"),
]  # fmt: skip
"""Words that say nothing of their own beside parts. No word that denies, compares, or binds parts in another way."""
PATTERNS = [*THINGS, *RELATIONS, *MUTUAL, *PLACES, *MOODS, *GLUE]
