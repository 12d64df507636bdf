"""The words that blocks on patches are told in."""

from __future__ import annotations

import re

from rpg.language.frames.groups.shared_words import ALSO, LOTS, STARTS, STOPS
from rpg.language.frames.groups.words import SORTS
from rpg.language.frames.pieces import number, patterns
from rpg.language.frames.shared import GLUE
from rpg.language.frames.wishes import MOVED

_DOES = (
    "(?:(?:BE|shall|should|ought to|must|will|has to|have to|need to|needs to|supposed to|up|goes|go|get|gets|"
    f"move|moves|moved|belongs?|{MOVED}|ends?|ending|stays?|lands?|finish|finishes|remains?|kept|put|placed|gathered|"
    "collected|sorted|grouped|over|all|together|each|be|to end) )*"
)
_ON = "(?:on|onto|on to|in|into|to|upon|inside|within|over to|on top of|at|→|:|=|<=>)"
_A = "(?:the |a |an |its |my |our |one |that |this )*"
_LOOK = "(?:(?:(?:SIZE|long|round|square|circular|flat) )*(?P<patch>COLOR))"
_ITS = "(?:its|their|the|his|her|a|an)"
_SAME = (
    "(?:(?:identical|equal|like|respective|corresponding|matching|same|own|right|proper|correct|appropriate|fitting) )"
)
_ANY = "(?:(?:each|every|all|each of|each of the|the|my|our|these|those|all of|single) )*"
_MATCHES = (
    "(?:(?:that|which|whose color) )?(?:matches|matching|match|fits|sharing|shares|share|having|bearing|"
    "fitting|suits|corresponds to|has|with|of|in)"
)
_P = "(?:PATCH|place|region|position|section)"
_THEIR = (
    "(?:(?:the|its|their|a|that|your|exactly|one|very|block|cube) )*(?:(?:same|identical|equal|own|matching|"
    "corresponding|'s) )*"
)
_COLORS = f"{_THEIR}(?:color|colors|colour)(?: as (?:it|they|them|the BLOCK)(?: BE| has| have)?| of (?:the )?BLOCK)?"

PATTERNS = [
    *patterns(
        "basis", "color",
        f"{_DOES}{_ON} (?:{_ITS} )*{_SAME}*(?:(?:same )?color(?:ed)? )(?:{_P})(?: by color)?",
        f"{_DOES}{_ON} (?:{_ITS} )*{_SAME}+(?:color(?:ed)? {_P}|(?!spots?\\b)PATCH)(?: by color)?",
        f"{_DOES}{_ON} (?:its|their|the own|own|its own|their own) {_P}(?: by color)?",
        f"{_DOES}{_ON} (?:{_ITS} )*(?:colored )?{_P} {_MATCHES} {_COLORS}",
        f"{_DOES}{_ON} (?:{_ITS} )*color 's {_P}",
        f"(?:match|pair|matched|paired)(?: up)? {_ANY}(?:BLOCK|one|ones) (?:with|to|and) (?:{_ITS} "
        f")*{_SAME}*(?:colored )?"
        f"{_P}(?: {_MATCHES} {_COLORS})?",
        f"(?:{_ANY}(?:BLOCK |ones |those )?(?:of |with )?(?:the )?)?same color(?:s|ed)?(?: BLOCK| ones)? "
        f"{_DOES}{_ON} (?:the )?same {_P}",
        f"(?:for )?(?:each|every) color (?:there is |there must be |has |gets |has got )?(?:one|a|its|its own|an "
        f"own) {_P}",
        f"{_DOES}where (?:its|their|the) colors? (?:belongs?|matches|match|BE)"),
    *patterns(
        "matched", None, "(?:sorted |sort |matched |match )?by (?:their |its |the )?colors?(?: into| onto)?",
        "(?:so that |such that |with )?(?:the |their )*colors? (?:BE )?(?:match|matching|matches|agree|fit)",
    ),
    *patterns("everything", None, f"{_ANY}(?:BLOCK|colored BLOCK|color|colors)", "everything|all|each|each one|all "
        "of them|every one"),
    *patterns("slot", lambda match: f"{_looks(match[0])}{match['patch']} patch",
        f"{_DOES}{_ON} {_A}{_LOOK} (?:colored )?{_P}(?: :)?"),
    *patterns("bare slot", lambda match: f"{match['patch']} patch",
        f"{_DOES}{_ON} {_A}{_LOOK}(?: one)?(?! BLOCK)"),
    *patterns("patch", lambda match: f"{_looks(match[0])}{match['patch']} patch",
        f"(?:with )?{_A}{_LOOK} {_P}"),
    *patterns("patches", lambda match: number(match["count"]) if match["count"] else None,
        "(?:(?:on|onto|to|over|across|between|among|with|the|these|those|my|our) )*(?:(?P<count>NUM) )?(?:colored |"
        "different )*"
        "(?:patches|mats|zones|areas|spots|pads|targets|goals|fields|carpets|rugs|sheets|coasters|markers)"),
    *LOTS,
    *SORTS,
    *STARTS,
    *STOPS,
    *ALSO,
    *GLUE,
    *patterns("glue", None, "(?:the )?color(?= COLOR)", MOVED,
        "sort|sorted|sorting|sort out|move|moves|moved|transfer|transport|carry|distribute|distributed|separate|"
        "divide|split|deliver|relocate|send|drop|slide|push|collect|gather|keep|kept|tidy up|group|place|get|take|"
        "go|goes|end up|ends up|belong|belongs|colored|so that|such that|so|that"),
]  # fmt: skip
_SHAPES = re.compile(r"\b(?:round|circular|square|long)\b")


def _looks(said: str) -> str:
    """The shape that a patch is told with."""
    found = _SHAPES.search(said)
    return f"{found[0]} " if found else ""
