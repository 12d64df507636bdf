"""Lines that are their own mirror image, "whose right half mirrors its left half", "that reads the same from both
ends", "whose colors form a palindrome", as rows that call them mirrored."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, END, MUST

_LINE = "(?:row|line|column|tower|stack)"
_BE = f"(?:is|are|be|{MUST} be|being)"
_IN = "(?: in (?:its |their |the )?colors?| colors?| color - ?wise)?"
_ABOUT = (
    "(?: (?:about|around|to|with respect to|relative to) (?:its|the|their) (?:own )?"
    "(?:middle|center|middle block|center block|middle one|midpoint|axis)| like (?:in|with|through) a mirror"
    "| left (?:and|to) right| left - right| as in a mirror| from left to right)?"
)
_FROM = f"from (?:the )?{END}(?: end| side)?(?: to (?:the )?{END})?"
_EACH_WAY = (
    f"(?:from (?:both|either) (?:ends?|sides?|directions?)|both ways|either way|in both directions|in either direction"
    f"|forwards? (?:and|as) backwards?|backwards? (?:and|as) forwards?"
    f"|{_FROM} (?:as|and|or) (?:when )?(?:read )?(?:{_FROM}|(?:the )?{END})"
    "|(?:from )?(?:whichever|whatever|no matter which) (?:end|side|way) (?:you |one |it is )?"
    "(?:starts?|begins?|looks?|comes?|reads?|read)(?: it)?(?: from| at)?)"
)
_SAME = f"(?:exactly |just )?(?:the )?same(?: if you read it| when read| read)? {_EACH_WAY}"
_READS = f"(?:reads?|looks?|appears?|is|are|be|runs?|goes|go|{MUST} (?:read|look|appear|be|run|go)|can be read)"
_IMAGE = "(?:an? |the |its own )?(?:exact )?(?:mirror images?|mirrored|reflections?)"
_OF_IT = "(?: of (?:it|the row|the line|them))?"
_HALVES = (
    f"(?:the |its )?(?:left|right|upper|lower|one) half{_OF_IT} {{0}} (?:the |its )?(?:left|right|upper|lower|other)"
    "(?: half| one)?"
)
_REFLECTS = f"(?:(?:{MUST} )?mirrors?|(?:{MUST} )?reflects?|{_BE} {_IMAGE} (?:of|by|in)|is mirrored (?:by|in))"
_BOTH = f"(?:the |its )?(?:left (?:and|half and)(?: the)? right (?:half|halves|side|sides)|(?:two )?halves){_OF_IT}"
_EACH_OTHER = "(?: of each other| of one another)?"
_MIRRORED = (
    f"(?:{_BE} (?:exactly |perfectly |fully )?(?:mirror )?(?:symmetric|symmetrical|mirrored){_IN}{_ABOUT}{_IN}"
    f"|{_BE} an? (?:color )?palindrome{_IN}(?: of colors)?|{_BE} {_IMAGE}(?: of itself)?(?: left and right)?"
    f"|(?:forms?|makes?|gives?|{MUST} (?:form|make|give)) an? (?:color )?palindrome|{_READS} {_SAME})"
)
_ALL = (
    f"(?:it|they|these|everything|all of it|the (?:whole )?{_LINE}|(?:the|its|their) (?:colors?|color sequence|order))"
)
_IN_THE_MIDDLE = f"({COLOR})(?: one| block| cube)? (?:in|at) the (?:middle|center)$"
_ITS = "(?:colors|color sequence|sequence of colors|color order|order|order of colors|color pattern|pattern)"

MIRRORS_AT_ONCE: tuple[Turn, ...] = (
    # what is said of a line behind it
    (f"(?: ,)? (?:that|which) {_MIRRORED}(?! [:,] {COLOR} outside)(?=$| ,| :| \\(|\\.| and| with| from| of| on| in| "
     "out)", " that is mirrored"),
    (f"(?: ,)? (?:whose|of which the|in which the|where the) {_ITS} {_MIRRORED}", " that is mirrored"),
    (f"(?: ,)? whose {_HALVES.format(_REFLECTS)}", " that is mirrored"),
    (f"(?: ,)? (?:so|such|so that|such that|in a way|arranged so)(?: that)? {_ALL} {_MIRRORED}",
     " so that it is symmetric"),
    (f"(?: ,)? (?:so|such|where|in which)(?: that)? {_HALVES.format(_REFLECTS)}", " so that it is symmetric"),
    (f"(?: ,)? (?:so|such|where|in which)(?: that)? {_BOTH} (?:mirror (?:each other|one another)|{_BE} (?:symmetric|"
     f"symmetrical|mirror images{_EACH_OTHER}))", " so that it is symmetric"),
    ("\\b(?:with|in|of) (?:an? )?(?:mirror )?(?:symmetric|symmetrical|mirrored|mirror symmetric|palindromic) "
     "(?:colors?|color (?:order|pattern|sequence|arrangement)|arrangement|sequence)\\b", "in mirrored order"),
    (f"\\b(?:symmetric|symmetrical|mirror symmetric) \\( (?:mirrored|symmetric|symmetrical|palindromic) \\) ({_LINE})",
     "mirrored {1}"),
    (f"\\b(mirrored|symmetric|symmetrical|mirror symmetric|mirror) ({_LINE})(?: image)? (:|from) (.+?) , (?:and "
     f")?(an?|one|1) {_IN_THE_MIDDLE}", "mirrored {2} of {4} and {5} {6}"),
    (f"(that is mirrored :) (.+?) , (?:and )?(an?|one|1) {_IN_THE_MIDDLE}", "{1} {2} and {3} {4}"),
    (f"\\b(?:mirrored|symmetric|symmetrical|mirror symmetric) ({_LINE} (?:of \\S+ (?:blocks |cubes )?)?(?:,|with|:) "
     f"{COLOR} at (?:both|the) ends , {COLOR} in the (?:middle|center) and {COLOR} in between)$", "{1}"),
    # what is said of a line that stands before it
    (f"^the (?:colors?|color order|order|color sequence) (?:of|in) the ({_LINE}) {_MIRRORED}",
     "the {1} should be in mirrored order"),
    (f"^((?:the|my|this) {_LINE}(?: (?:of|with|from|made of) .+?)?|it|they) {_MIRRORED}(?=$| ,| :)",
     "{1} should be in mirrored order"),
    (f"(?: ,)? and (it|they|the {_LINE}) {_MIRRORED}$", " . {1} should be in mirrored order"),
    (f"^(?:the|my|this) ({_LINE})(?: of blocks)? should be in mirrored order : (.+)$", "a mirrored {1} : {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("palindrome palindromes mirrors mirror reflects reflect reflection reflections halves half image images",)
"""Words that these take besides those that are read anyway."""
