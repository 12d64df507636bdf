"""What is said of single blocks, small lots and patches: the words for how they stand to each other, and where."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from rpg.language.frames.pieces import Pattern, patterns


@dataclass(frozen=True)
class Relation:
    """How one thing stands to another, as it is told behind "must". `turned`: the second is the one that is told of
    first; `count`: so many are behind it; `inside`: said of a patch it may also mean a part of that."""

    phrase: str
    turned: bool = False
    count: int = 0
    inside: bool = False


_NEAR = "(?:right|directly|immediately|just|straight)"
_TO = "(?:(?:to|on|at) )?(?:the )?"
_SIDES = {
    "to the left of": f"{_TO}left(?: hand)? (?:of|from|to)|leftwards? of",
    "to the right of": f"{_TO}right(?: hand)? (?:of|from|to)|rightwards? of",
    "in front of": "(?:in|at|to) (?:the )?front (?:of|from)",
    "behind": "behind|behind of|in back of|(?:at|in|to) the (?:back|rear) of",
}
_ASIDES = {
    "to the left of": "(?:to|on|at) (?:the |its )?left(?: hand)?(?: side)?",
    "to the right of": "(?:to|on|at) (?:the |its )?right(?: hand)?(?: side)?",
    "in front of": "in its front|in front(?= (?:[.,;:!?]|and|but|while|$))",
    "behind": "behind(?= (?:[.,;:!?]|and|but|while|$))",
    "on top of": "on top(?! (?:the|a|an|SIZE|COLOR) )|on (?:its|the) top|on (?:its|the) upper side",
    "under": "(?:underneath|beneath|below)(?= (?:[.,;:!?]|and|but|while|$))",
}
_UNIT = "(?:cm|mm|inch|inches|(?:centi|milli)(?:meters?|metres?))"
_FAR = (
    r"(?:(?:about|around|roughly|approximately|exactly|at least|at most|no more than|no less than) )?"
    rf"\d+(?:\.\d+)? {_UNIT}"
)


def _far(match: re.Match[str]) -> str:
    """How far it is, in short."""
    return re.sub("centi[a-z]+$", "cm", re.sub("milli[a-z]+$", "mm", match["far"]))


def _in_front(group: str, phrase: str) -> Callable[[re.Match[str]], Relation]:
    """A relation with what a group of the match says in front of it: "10 cm" and "to the left of"."""
    return lambda match: Relation(f"{_far(match) if group == 'far' else match[group]} {phrase}")


def _sided() -> list[Pattern]:
    """The four sides, as they are and with how close it is."""
    found = []
    for phrase, said in _SIDES.items():
        found += patterns("rel", Relation(phrase), said)
        found += patterns("rel", _in_front("close", phrase), f"(?P<close>directly|immediately|right|just) (?:{said})")
        found += patterns("rel", Relation(f"somewhere {phrase}"), f"(?:somewhere|anywhere) (?:{said})")
        found += patterns("rel", _in_front("far", phrase), f"(?P<far>{_FAR}) (?:{said})")
    for side in ("left", "right"):
        inside = Relation(f"to the {side} of", inside=True)
        found += patterns("rel", inside, f"{_TO}{side}(?: hand)? side (?:of|from)")
        found += patterns("rel", Relation(f"immediately to the {side} of"), f"(?:to|on) the immediate {side} of")
    for phrase, said in _ASIDES.items():
        found += patterns("aside", Relation(phrase), said)
        if phrase in _SIDES:
            found += patterns("aside", _in_front("close", phrase), f"(?P<close>right|just|directly) (?:{said})")
    return found


RELATIONS: list[Pattern] = [
    *_sided(),
    *patterns("rel", Relation("on"), f"(?:down )?(?:{_NEAR} |flat |squarely )?(?:on|onto|upon|on to)"),
    *patterns("rel", Relation("on", turned=True), "(?:(?:must|should|shall|is to|has to) )?(?:holds?|contains?)"),
    *patterns("rel", Relation("outside"), "outside|outside of"),
    *patterns("rel", Relation("off"), "off of|off(?! (?:and|,) )"),
    *patterns("rel", Relation("from"), "(?:away )?from(?: on top of| the top of| off| off of| on)?"),
    *patterns("rel", Relation("inside"), "to|over to|in|into|inside|within|at|inside of"),
    *patterns("amid", None, "(?:right )?in between(?= (?:[.,;!?]|and|$))"),
    *patterns("rel", Relation("on top of"),
        f"(?:{_NEAR} |stacked )?(?:on top of|on the top of|atop|atop of)", "tops|crowns|caps",
        "stacked (?:on|onto|upon)", "on top(?= (?:the|a|an|SIZE|COLOR) )",
        "(?:is |are |be |being )?(?:carried|supported|held up|borne) by"),
    *patterns("rel", Relation("on top of", turned=True),
        "(?:must |should |shall |is to )?(?:carry|support|bear|hold up)", "carries|supports|bears|holds up",
        "carrying|supporting|bearing|holding up", "(?:is |be )?(?:topped|crowned|capped|covered) (?:by|with|off by)"),
    *patterns("rel", Relation("above"), "(?:somewhere )?(?:above|over)(?! (?:until|so|to) )", "higher up than"),
    *patterns("rel", Relation("directly above"), f"{_NEAR} (?:above|over)"),
    *patterns("rel", Relation("under"), "(?:somewhere )?(?:under|below|beneath|underneath)"),
    *patterns("rel", Relation("directly under"), f"{_NEAR} (?:under|below|beneath|underneath)"),
    *patterns("rel", Relation("next to"),
        "next to|beside|beside of|alongside|alongside of|at the side of|by the side of|at (?:one|either) side of",
        "(?:is )?(?:a|the) neighbor of|neighbors(?= (?:the|a|an|COLOR) )"),
    *patterns("rel", Relation("right next to"),
        f"{_NEAR} (?:next to|beside|alongside)", "adjacent to|adjoining|adjoins", f"{_NEAR} adjacent to", "hard by"),
    *patterns("rel", Relation("near"),
        "near|near of|near to|close to|close by|nearby|in the vicinity of|not far from|in the neighborhood of"),
    *patterns("rel", Relation("far from"), "far from|far away from|well away from"),
    *patterns("rel", Relation("touch"),
        "touch|touches|touching|(?:be |is |are )?in (?:direct )?contact with|(?:right )?up against",
        "(?:makes?|making|comes? into|has|having) contact with|abuts"),
    *patterns("rel", Relation("between", count=2),
        "between|in between|somewhere between", "(?:is |be |are )?(?:flanked|framed) by", "separates|separating"),
    *patterns("rel", Relation("halfway between", count=2),
        "(?:right |exactly )?(?:in the (?:exact )?middle|midway|halfway|half way) between"),
    *patterns("rel", lambda match: Relation(f"{_far(match)} from"),
        f"(?:at )?(?:a distance of )?(?P<far>{_FAR})(?: away| apart| distant)? from",
        f"at a distance of (?P<far>{_FAR}) (?:to|from)"),
    *patterns("rel", lambda match: Relation(f"at most {_far(match)} from"),
        rf"(?:within|no farther than|not farther than) (?P<far>\d+(?:\.\d+)? {_UNIT}) (?:of|from)"),
    *patterns("rel", lambda match: Relation(f"at least {_far(match)} from"),
        rf"(?:no closer than|not closer than|no nearer than) (?P<far>\d+(?:\.\d+)? {_UNIT}) (?:to|from)"),
]  # fmt: skip
"""Kind "rel" (with things behind it) and "aside" (without)."""
_EACH = "(?:each other|one another)"
MUTUAL: list[Pattern] = [
    *patterns("mutual", "be next to each other",
        f"(?:next to|beside|alongside) {_EACH}", "side by side", f"next door to {_EACH}", "neighbors"),
    *patterns("mutual", "be right next to each other",
        f"{_NEAR} (?:next to|beside) {_EACH}", f"adjacent(?: to {_EACH})?"),
    *patterns("mutual", "be near each other", f"(?:near|close to|near to) {_EACH}", "close together", "near together"),
    *patterns("mutual", "be far apart",
        "far apart(?: from each other)?", f"far (?:away )?from {_EACH}", "well apart", "wide apart"),
    *patterns("mutual", "touch each other",
        f"(?:touch|touches|touching)(?: {_EACH}|(?= (?:[.,;:!?]|and|but|$)))",
        f"in (?:direct )?contact(?: with {_EACH})?", f"up against {_EACH}"),
    *patterns("mutual", lambda match: f"be {_far(match)} apart",
        f"(?P<far>{_FAR}) (?:apart|away|distant)(?: from {_EACH})?", f"(?P<far>{_FAR}) from {_EACH}",
        f"at a distance of (?P<far>{_FAR})(?: from {_EACH})?"),
    *patterns("mutual", "swap places",
        "(?:swap|swaps|exchange|exchanges|switch|switches|trade|trades|change|changes) (?:the |their )?"
        f"(?:places|positions|spots)(?: with {_EACH})?"),
    *patterns("apart", lambda match: f"be {_far(match)} apart",
        f"(?:a |the )?distance of (?P<far>{_FAR}) between", f"(?:a )?(?P<far>{_FAR})(?: of)? distance between"),
    *patterns("gap", _far,
        f"(?:(?:a|the) )?(?:gap|space|clearance) of (?P<far>{_FAR}) between",
        f"(?:a )?(?P<far>{_FAR})(?: wide)?(?:(?: of)? (?:gap|space|clearance))? between"),
    *patterns("between", "from", "(?:the )?(?:distance|center distance) from"),
    *patterns("between", "apart", "(?:the )?(?:distance|center distance) between"),
    *patterns("between", "gap", "(?:the )?(?:gap|space|clearance) between"),
    *patterns("width", lambda match: ("gap", _far(match)),
        rf"(?:(?:a|the) )?(?:gap|space|clearance) of (?P<far>{_FAR})(?! between )",
        rf"(?:a )?(?P<far>{_FAR})(?: wide)?(?: of)? (?:gap|space|clearance)(?! between )",
        rf"(?:separated|parted) by (?:(?:a )?(?:gap|space) of )?(?P<far>{_FAR})(?: from each other)?"),
    *patterns("width", lambda match: ("apart", f"be {_far(match)} apart"),
        rf"(?:(?:a|the) )?(?:center )?distance of (?P<far>{_FAR})(?! (?:between|from|to) )"),
    *patterns("measure", _far,
        f"(?:(?:must |should |shall |has to )?(?:be|is|measures|measure|amounts to) )(?P<far>{_FAR})(?: wide)?"
        "(?! (?:apart|away|distant|from|to|left|right|in|behind) )", f"(?P<far>{_FAR})(?= (?:[.,;]|$))"),
    *patterns("swap", None,
        "(?:swap|exchange|switch|interchange|trade)(?: round| around| over)?(?: the)?(?: places?| positions?)?"
        "(?: of| between)?"),
]  # fmt: skip
"""What two things are to each other."""

_IN = "(?:(?:somewhere|anywhere) )?(?:in|on|into|onto|to|within|inside|at)(?: the)?"
_SIDE = "left|right|near|far|front|back"
_CORNER = (
    "(?:(?:near|far|front|back|close|top|bottom|upper|lower) (?:left|right)|(?:left|right) (?:near|far|front|back))"
)
_HE = "(?:it|he|she|they)"
_STARTED = (
    f"(?:(?:its|the|their) (?:starting|initial|start|original|first|old|beginning) "
    f"(?:position|place|spot|location|pose)|where {_HE} (?:is|are|was|were|"
    "started|starts|began|begins)(?: at the (?:start|beginning))?)"
)
_REST = "(?:everything else|all else|all (?:the )?other (?:blocks|cubes)|(?:all )?the (?:others|rest))"
_AS_IT_IS = (
    f"(?:exactly )?(?:put|still|in place|untouched|unmoved|alone|(?:where|as) {_HE} (?:already )?(?:is|are)(?: now)?)"
)
PLACES: list[Pattern] = [
    *patterns("place", lambda match: f"in the {match['side']} half of the table",
        rf"(?:{_IN} )?(?P<side>{_SIDE}) half(?: of the TABLE)?"),
    *patterns("place", lambda match: f"on the {match['side']} side of the table",
        rf"{_IN} (?P<side>{_SIDE}) (?:side|part) of the TABLE"),
    *patterns("place", lambda match: f"in the {match['corner']} corner of the table",
        rf"(?:{_IN} )?(?P<corner>{_CORNER})(?: hand)? corner(?: of the TABLE)?"),
    *patterns("place", "in a corner of the table", "(?:in|at|into|to) (?:a|any|some|one) corner(?: of the TABLE)?"),
    *patterns("place", lambda match: f"at the {match['side']} edge of the table",
        rf"(?:at|on|along|to|by|near)(?: the)? (?P<side>{_SIDE}) (?:edge|border|rim)(?: of the TABLE)?"),
    *patterns("place", "at the edge of the table", "(?:at|on|by) (?:the|an) (?:edge|border|rim) of the TABLE"),
    *patterns("place", "in the middle of the table",
        "(?:right )?(?:in|at|into|to|on) the (?:very |exact )?(?:middle|center) of the TABLE",
        "(?:in|at) the TABLE (?:center|middle)"),
    *patterns("place", "on the table",
        "(?:the )?TABLE(?= : )",
        f"(?:{_NEAR} |flat |back )?(?:on|onto|upon|to) (?:the |a )?(?:TABLE|ground|floor)(?: top| itself)?(?: only)?",
        "not (?:to be |be )?on (?:top of )?(?:anything(?: else)?|any (?:other )?(?:block|cube)|another "
        "(?:block|cube))"),
    *patterns("stay", None,
        f"(?:exactly |right )?where {_HE} (?:already |now |currently )?(?:is|are|stands?|lies?|sits?)(?: now)?",
        "where is",
        "in (?:its |their |the same )?(?:old |own |original |present |current )?(?:place|position|spot)",
        "untouched|unmoved|undisturbed|alone", f"as {_HE} (?:is|are)", "in the place where it is"),
    *patterns("within", lambda match: f"be moved by more than {_far(match)}",
        rf"(?:(?:must|should|shall|has to|have to|is to) )?(?:(?:stays?|remains?|is|are|be|keep|keeps|lies?) )?"
        rf"(?:within|no farther than|no more than|at most|less than) "
        rf"(?P<far>\d+(?:\.\d+)? {_UNIT})(?: away)? (?:of|from|to) "
        rf"{_STARTED}",
        rf"(?:must|should|shall|may|can|is to) (?:not|never) (?:be )?(?:moved?|shift(?:ed)?|displaced) (?:by )?(?:more "
        rf"than|farther than|over) (?P<far>\d+(?:\.\d+)? {_UNIT})(?: (?:away )?from {_STARTED})?"),
    *patterns("stays", None,
        "(?:(?:must|should|shall|has to|have to|is to) )?(?:stays?|remains?) (?:put|still|in place)",
        "(?:(?:must|should|shall|may|is to|are to|does|will|can) )?(?:not|never) (?:be |get )?(?:moved|move|budge|"
        "displaced|disturbed|change its place)(?: at all)?",
        "(?:is|are) not (?:to be )?(?:moved|displaced|disturbed)(?: at all)?"),
    *patterns("still", None,
        "(?:do not|never|without|not) (?:move|moving|shift|shifting|disturb|disturbing|displace|displacing)"),
    *patterns("empty", None,
        "(?:(?:left|kept|completely|totally) )?(?:empty|clear|free|vacant|bare|unoccupied|uncovered)"
        "(?: of (?:all |any )?(?:blocks|cubes|anything))?",
        "with nothing on (?:it|top|top of it)"),
    *patterns("nothing", None, "nothing|no (?:blocks?|cubes?)(?! (?:other|but|except) )"),
    *patterns("others", None,
        f"{_REST} (?:(?:must|should|shall|has to|have to|is to|are to) )?(?:stays?|remains?|is left|are left|be left) "
        f"{_AS_IT_IS}",
        f"(?:keep|leave|keeping|leaving) {_REST} {_AS_IT_IS}",
        "(?:do not|without|not) (?:move|moving|touch|touching|disturb|disturbing) (?:anything else|any other "
        "(?:blocks?|cubes?)|the (?:others|rest))",
        "nothing else (?:must|should|shall|may|is to) (?:move|be moved)"),
    *patterns("anymore", None, "any ?more|any longer|no longer|no more(?! than )"),
    *patterns("elsewhere", None, "(?:elsewhere|somewhere else|anywhere else)(?: on the TABLE)?"),
]  # fmt: skip
"""Kind "place", to be told behind "must be", and words for what stays where it is."""
