"""Rows and columns told by their ends, by the order of the rainbow or as mirrored, as rows that tell the order of their
blocks."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import LABEL
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, END, FEW, MANY, MUST, WAY

_DO = "(?:put|place|lay|arrange|line|stack|sort|order|set|pile|build|make|bring|move)"
_ROW_OR_LINE = "(?:row|line)"
_ONE = f"{_DO} (?:an?|the|one) ({COLOR})(?: block| cube| one)?"
_ROW = f"(?:an?|the) ({_ROW_OR_LINE}) of ((?:{FEW}|\\d+) (?!{_ROW_OR_LINE})(?:\\w+ )?(?:blocks|cubes))"
_THEM = "(?:them|these|those|all|it|all of them)"
_LINE = "(?:row|line|column|tower|stack)"
_SPECTRUM = "(?:the |a )?(?:rainbow|spectrum|color spectrum|spectrum of colors)"
_COLORS = "(?:(?:the |its |their )?colors? )?"
_SORTED = "(?:(?:sorted|ordered|arranged|placed|laid out|lined up) )?"
_COME = "(?:appear|come|follow each other|follow one another|follow|occur|stand|are|lie|are found|have)"
_OF_IT = f"(?:(?:the )?colors of {_SPECTRUM}|{_SPECTRUM}(?: colors)?)"
_ALONG = f"(?:the )?{END} to (?:the )?{END}"
_MADE = "(?:formed|made|built|laid|laid out|created|arranged)"
_BLOCK_OR_LABEL = f"(?:(?:the )?(?:(?:letter|digit|number|block|cube) )?{LABEL}(?: block| cube)?)"
_PLACE = "(?:middle|first|last|second|third|fourth|leftmost|rightmost|top|bottom|lowest|highest)"
_BE = f"(?:is|are|be|{MUST} be|being)"
_IN = "(?: in (?:its |their |the )?colors?| colors?| color - ?wise)?"
_ABOUT = (
    "(?: (?:about|around|to|with respect to|relative to) (?:its|the|their) (?:own )?(?:middle|center|middle block|"
    "center block|middle one|midpoint|axis)| like (?:in|with|through) a mirror| left (?:and|to) right| left - right| "
    "as in a mirror| from left to right)?"
)
_NOWHERE = "|".join(f"{end} to (?:the )?{end}" for end in ("left", "right", "top", "bottom", "front", "back"))
_FROM = f"from (?:the )?(?!{_NOWHERE}){END}(?: end| side)?(?: to (?:the )?{END})?"
_EACH_WAY = (
    "(?:from (?:both|either) (?:ends?|sides?|directions?)|both ways|either way|in both directions|in either direction|"
    f"forwards? (?:and|as) backwards?|backwards? (?:and|as) forwards?|{_FROM} (?:as|and|or) (?:when )?(?:read "
    f")?(?:{_FROM}|(?:the )?{END})|(?:from )?(?:whichever|whatever|no matter which) (?:end|side|way) (?:you |one |it "
    "is )?(?:starts?|begins?|looks?|comes?|reads?|read)(?: it)?(?: from| at)?)"
)
_SAME = f"(?:exactly |just )?(?:the )?same(?: if you read it| when read| read)? {_EACH_WAY}"
_READS = f"(?:reads?|looks?|appears?|is|are|be|runs?|goes|go|{MUST} (?:read|look|appear|be|run|go)|can be read)"
_IMAGE = "(?:an? |the |its own )?(?:exact )?(?:mirror images?|mirrored|reflections?)"
_OF_ROW = "(?: of (?:it|the row|the line|them))?"
_HALVES = (
    f"(?:the |its )?(?:left|right|upper|lower|one) half{_OF_ROW} {{0}} (?:the |its )?(?:left|right|upper|lower|"
    "other)(?: half| one)?"
)
_REFLECTS = f"(?:(?:{MUST} )?mirrors?|(?:{MUST} )?reflects?|{_BE} {_IMAGE} (?:of|by|in)|is mirrored (?:by|in))"
_BOTH = f"(?:the |its )?(?:left (?:and|half and)(?: the)? right (?:half|halves|side|sides)|(?:two )?halves){_OF_ROW}"
_EACH_OTHER = "(?: of each other| of one another)?"
_MIRRORED = (
    f"(?:{_BE} (?:exactly |perfectly |fully )?(?:mirror )?(?:symmetric|symmetrical|mirrored){_IN}{_ABOUT}{_IN}|{_BE} "
    f"an? (?:color )?palindrome{_IN}(?: of colors)?|{_BE} {_IMAGE}(?: of itself)?(?: left and right)?|(?:forms?|makes?|"
    f"gives?|{MUST} (?:form|make|give)) an? (?:color )?palindrome|{_READS} {_SAME})"
)
_ALL = (
    f"(?:it|they|these|everything|all of it|the (?:whole )?{_LINE}|(?:the|its|their) (?:colors?|color sequence|order))"
)
_IN_THE_MIDDLE = f"({COLOR})(?: one| block| cube)? (?:in|at) the (?:middle|center)$"
_ITS = "(?:colors|color sequence|sequence of colors|color order|order|order of colors|color pattern|pattern)"

_BLOCK = f"(?:the )?({COLOR}|\\w)(?: block| cube| one)?"
_ENDS = "(?:(?:each|both|either)(?: (?:one )?of (?:its|the|both|the two|its two))?|the two|its two|both the)(?: two)?"
_OF_LINE = "(?: of (?:it|the row|the line))?"
_ON_ENDS = (f"(?:on top of {_ENDS} ends?(?: blocks?| cubes?)?{_OF_LINE}|on {_ENDS} end (?:blocks?|cubes?){_OF_LINE}|on "
            "(?:top of )?the (?:first|leftmost)(?: one| block| cube)? and (?:on )?(?:the )?(?:last|rightmost)(?: one| "
            "block| cube)?)")  # fmt: skip
"""On top of the blocks at both ends; "on each end" alone may be farther along the line."""
_OUTER = "the (?:two (?:blocks |cubes |ones )?at the ends|(?:two )?end (?:blocks|cubes|ones)|outer two|two outer ones)"
_CARRY = (f"(?:{MUST} )?(?:each |both )?(?:have|having|with|carry|carrying|bear|bearing|hold|holding|get|topped "
 "(?:with|by)|capped (?:with|by))(?: each)?")  # fmt: skip
_TOP_ONE = f"(?:(?:an?|one|two) )?({COLOR})s?(?: blocks?| cubes?| ones?)?"
_TO_ENDS = f"^((?!.*\\b(?:front|column|two rows)\\b).*?\\b{_ROW_OR_LINE}\\b.+?)(?: ,)?"
_ON_BOTH = "{1} with a {2} block on the leftmost one and another {2} block on the rightmost one"

_ITEM = f"(?:(?:an? |the )?{COLOR}(?: block| cube| one)?|{LABEL})"
_PUT_IN = "(?:(?:build|make|form|put|lay|stack|place|arrange|line up) )?"


def _between_ends() -> tuple[Turn, ...]:
    """ "Red at the bottom, yellow, blue at the top": what stands bare between the two ends of a line is between "
    "them."""
    rows: list[Turn] = []
    for line, ends in (("tower|stack", ("bottom", "top")), ("row|line", ("left", "right"))):
        for one, other in (ends, ends[::-1]):
            at, there = (
                f"(?:(?:at|on) (?:the )?(?:very |far )?{end}(?: end)?|\\( {end} \\)|{end}most)" for end in (one, other)
            )
            told = (f"({_ITEM}) {at} , (?:then )?({_ITEM}(?: , (?:then )?{_ITEM})*) ,(?: and)?(?: then)? ({_ITEM}) "
                    f"{there}(?= ,|$)")  # fmt: skip
            made = "a tower" if one in ("bottom", "top") else "a row"
            rows += [
                (f"^{_PUT_IN}(?:an? |one )?(?:{line})(?: of| with| ,| :)? {told}",
                 f"{made} from {one} to {other} : {{1}} , {{2}} , {{3}}"),
                (f"^(?:put |place |stack )?{told}", f"{'stack' if 'tower' in made else 'a row'} from {one} to {other} "
                 f": {{1}} , {{2}} , {{3}}"),
            ]  # fmt: skip
    return tuple(rows)


_OUTERS = "(?:(?:each|both) (?:of )?)?(?:the )?(?:two )?outer (?:ones?|blocks?|cubes?)"

_JOINT = "(?: ,| and| , and| ;)+"
LINES_IN_SHORT: tuple[Turn, ...] = (
    ("(?<!on )(?<!along )\\b(an?|single) diagonal(?! (?:rows?|lines?|is|are|of (?:the|an?|this|that))\\b)",
     "{1} diagonal line"),
    ("\\b(?:with )?(?:an? )?(?:gaps?|spacing)(?: of| :| =| is)? (?:0|zero)(?: cm| mm)?(?= ,|$)", "without gaps"),
    ("^(?:please )?(?:spell|write|lay|lay out|show)(?: out)? (?:my|our|his|her|the|their) initials(?: ,| :)? "
     "((?:\\w (?:, and |, |and ))+\\w)(?: in a row)?(?: from left to right)?$",
     "put the letters {1} in a row in this order from left to right"),
    *((f"^(?:an? )?(row|line) of ({MANY})(?: blocks| cubes)?(?: ,| :| where| in which)* (?:every|each) (?:second|"
       f"other)(?: one| block| cube)?(?: is| being)? ({COLOR}){_JOINT} (?:the )?(?:others?|rest|other ones)(?: are|"
       f" is)? ({COLOR}){_JOINT} {begun}$",
       f"a {{1}} of {{2}} blocks alternating {{3}} and {{4}} , starting with {said}")
      for begun, said in ((f"(?:it )?(?:starts|starting|beginning|begins) with (?:a |the )?({COLOR})(?: one| block)?",
                           "{5}"),
                          (f"({COLOR}) (?:first|comes first|is first)", "{5}"),
                          ("(?:starting|beginning) with the first(?: one| block)?", "{3}"))),
)  # fmt: skip
"""Lines told in few words: every second block, gaps of nothing, initials."""
PLACES_BY_NUMBER: tuple[Turn, ...] = tuple(
    (f"^(?=.*\\b(?:row|line|column)\\b)(.*?)\\b(?:position|place|spot|slot)(?: number)? {n}(?: is| has| gets| :| =)? "
     f"(?=(?:the |an? )?(?:{COLOR}|{LABEL})(?= |$))", f"{{1}} {nth} ")
    for n, nth in enumerate(("first", "second", "third", "fourth", "fifth", "sixth"), 1)
)  # fmt: skip
"""Places of a line by their numbers, over a whole text."""
LINED_AT_ONCE: tuple[Turn, ...] = (
    # "a row of 6, 2 red and 4 blue": six in all, and no cube that shows a 6
    (f"\\b({_LINE}) of (\\d|{FEW}) , (?=(?:\\d|{FEW}) {COLOR})", "{1} of {2} : "),
    *LINES_IN_SHORT,
    ("^let (?:all )?(?:of )?(?:the|these|those|my|your) (?:blocks|cubes) be(?:come)? (an? (?:rainbow|gradient|"
     f"{_LINE})) :", "make {1} :"),
    # which of several that are in a line
    (f"^({_BLOCK_OR_LABEL} {_BE}) the ({_PLACE}(?: one| block| cube)?) of (?:the )?(?:(?:letters|digits|numbers|blocks|"
     f"cubes) )?({LABEL}(?:(?: ,)?(?: and)? {LABEL})+) in (an? {_LINE})$", "{1} the {2} in {4} of {3}"),
    # so many places away
    *((f"^(?:(?:in|for) (an? {_ROW_OR_LINE} of .+ and \\w+(?: blocks?| cubes?)?) , )?{_BLOCK} (?:{_BE}|stands|comes) "
       f"(?:{n}) (?:places|positions|spots) (?:further )?to the (left|right) of {_BLOCK}(?:(?: ,)? in (an? "
       f"{_ROW_OR_LINE} of .+))?$",
       f"{{1}} {{5}} with exactly {between} between the {{2}} and the {{4}} block , the {{2}} block is {{3}} of the "
       f"{{4}} block")
      for n, between in (("two|2", "one block"), ("three|3", "two blocks"))),
    *_between_ends(),
    # "next to each other in a row", of which one thing more may be said behind it
    (f"\\bnext to (?:each other|one another)(?: ,)? (in an? {_ROW_OR_LINE})\\b", "side by side {1}"),
    (f"\\b(in an? {_ROW_OR_LINE})(?: ,)? next to (?:each other|one another)\\b", "side by side {1}"),
    # what there is, ahead of what is done with it
    (f"^(?:the )?({COLOR}(?: , {COLOR})*(?: ,)? (?:and )?{COLOR})(?: blocks| cubes)? : ({_DO} {_THEM} .+)$",
     "there are {1} blocks . {2}"),
    (f"^use (?:only )?(?:the )?(?:colors )?({COLOR}(?: , {COLOR})*(?: ,)? (?:and )?{COLOR})(?: blocks| cubes)?$",
     "there are {1} blocks"),
    # what is at the ends
    ("\\b((?:row|line)\\b.*?) at the (?:far |very )?(left|right) of it\\b", "{1} at the {2} end"),
    (f"^{_ONE} (?:at|on|to) the left end of {_ROW}$", "a {2} , from left to right : {1} , then {3}"),
    (f"^{_ONE} (?:at|on|to) the right end of {_ROW}$", "a {2} , from left to right : {3} , then {1}"),
    (f"^(?:the|an?) ({_ROW_OR_LINE} of [^:]+?) (?:has|{MUST} have) ([^:]*) at its ({END}) end(.* at its \\w+ end)?$",
     "a {1} with {2} at the {3} end {4}"),
    (f"\\bat its ({END}) end\\b", "at the {1} end"),
    # what lies on both of its ends
    (f"^(.+? and)(?: then)?(?: ,)? on {_OUTERS} ((?:an?|one) {COLOR} (?:block|cube|one))$",
     "{1} {2} on each of the outer ones"),
    (f"\\b((?:an?|one) {COLOR} (?:block|cube|one)) on both (?:of )?(?:the )?outer (?:ones|blocks|cubes)\\b",
     "{1} on each of the outer ones"),
    (f"{_TO_ENDS} (?:with|and(?: then)? (?:put|place|set|lay)) {_TOP_ONE} {_ON_ENDS}$", _ON_BOTH),
    (f"{_TO_ENDS} and(?: then)? stack {_TOP_ONE} on (?:top of )?{_ENDS} ends?(?: blocks?| "
     f"cubes?)?{_OF_LINE}$", _ON_BOTH),
    (f"{_TO_ENDS}(?: with| in which| where| ,)* {_OUTER} (?:of it )?{_CARRY} {_TOP_ONE}(?: each)?(?: on top(?: of "
     "(?:it|them))?| on (?:it|them))?$", _ON_BOTH),
)  # fmt: skip
"""What is looked for, and what is said instead."""
RAINBOWS_AT_ONCE: tuple[Turn, ...] = (
    # the order
    (f"(?: ,)? {_SORTED}(?:(?:exactly |just )?(?:like|as)|the way|in the way|in the (?:same )?order (?:in which|that)) "
     f"(?:(?:the |its )?colors|they) {_COME} in {_SPECTRUM}", " in rainbow order"),
    (f"(?: ,)? {_SORTED}(?:in the (?:same )?order (?:as|like) (?:in )?|(?:by|following|according to|in accordance with|"
     f"based on|along|in keeping with) (?:the order of )?){_OF_IT}", " in rainbow order"),
    (f"(?: ,)? {_SORTED}{_COLORS}(?:(?:in )?order )?(?:just )?(?:like|as) (?:in )?(?:(?:the )?colors of "
     f")?{_SPECTRUM}(?=$| ,| \\.| \\)| {WAY}| with| start| begin| on| in an? {_LINE})", " in rainbow order"),
    ("(?: ,)? (?:so|such|so that|such that|whose|where|in which|with)(?: that)? (?:the |its |their )?(?:colors|they|"
     f"it) (?:{MUST} )?(?:follow|follows|following|match|go through|run through) (?:the order of )?{_OF_IT}",
     " in rainbow order"),
    # lists of them, and of their places
    ("\\b((?:middle|center|top|bottom|left|right|first|last|corners|border|edges|inside|outside|ends|others|rest)(?: "
     f"one| ones| block| blocks)?) = ({COLOR})\\b", "{1} {2}"),
    (f"\\b(?:pattern|sequence) : ((?:{COLOR}(?: , and| ,| and)? )+)in an? ({_LINE})$", "{2} : {1}"),
    ("\\b(?:with|having) (?:the |their )?colors in (?:the )?(?:rainbow order|order of (?:the|a) rainbow)\\b",
     "in rainbow order"),
    (f"^((?:an? )?(?:rainbow|gradient) {_LINE}) : (?:the )?((?:{COLOR} (?:, and |, |and )?)+)(?:blocks |cubes )?, "
     f"(?=(?:the )?{COLOR} (?:block |one )?(?:\\w+most|lowest|highest|(?:on|at|to) the|first|last|left|right|top|"
     "bottom))", "{1} of {2} blocks , "),
    ("\\b((?:rainbow|gradient|alphabetical|ascending|descending|numerical)\\b.*?) in (?:the|their) (?:right |correct |"
     "appropriate )?(?:places|positions|spots|order) (?=(?:in )?between\\b)", "{1} "),
    # where it begins
    (f"(\\brainbow order|\\bgradient .+?)(?: ,| -)? (?:(?:which|that|and|it|and it|the {_LINE}) )?(?:{MUST} "
     f")?(?:begins|begin|starts|start) with ((?:the )?{COLOR}\\b)", "{1} , beginning with {2}"),
    (f"^in rainbow order(?: and| ,| ,  and)? ((?:beginning|starting) with (?:the )?{COLOR}(?: (?:at|on|from) the "
     "\\w+(?: end| side)?)?) , (.+)$", "{2} in rainbow order , {1}"),
    (f"^rainbow order(?: ,)?( (?:from )?{_ALONG})?(?: ,)?( (?:beginning|starting) with (?:the )?{COLOR}(?: (?:at|on|"
     "from) the \\w+(?: end| side)?)?)? : (.+)$", "{3} in rainbow order {1} {2}"),
    # lines that are told as a rainbow
    (f"\\b(?:rainbow|gradient) ({_LINE}) (?=from {COLOR} )", "{1} in rainbow order"),
    (f"\\b({_LINE}) (from {COLOR} (?:on|at) the \\w+(?: end| side)? to {COLOR} (?:on|at) the \\w+(?: end| side)?) in "
     "rainbow order$", "{1} in rainbow order {2}"),
    (f"\\bgradient(?: (?:running|going|that runs|that goes|which runs))? from ({COLOR}) (?:on|at) the (left|right|"
     f"front|back|bottom|top)(?: end| side)?( .+?)?(?: ,)? to ({COLOR}) (?:on|at) the (left|right|front|back|bottom|"
     "top)(?: end| side)?$", "gradient from {1} {3} to {4} from {2} to {5}"),
    (f"^(?:lay out|lay|make|build|form|put|show|create|arrange) a rainbow(?: in an? ({_LINE}))? : (.+?)(?: in an? "
     f"(?:{_LINE}))?( {WAY})?$", "put {2} in a row in rainbow order {3}"),
    (f"\\b({_LINE}) (?:of|with|in) (?:the )?rainbow colors(?: ,)?( {WAY})? (?=[:,])", "rainbow {1} {2}"),
    (f"^an? ({_LINE}) {MUST} be {_MADE}(?: ,)? (?:in which|where) (.+?) (?:follow (?:one another|each other)|are|stand|"
     "come|are placed|are arranged|are laid) (in \\w+ order.*)$", "{2} must be in a {1} {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
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
    (f"\\b(mirrored|symmetric|symmetrical|mirror symmetric|mirror) ({_LINE})(?: image)? (:|from) (.+?) , (?:and )?(an?|"
     f"one|1) {_IN_THE_MIDDLE}", "mirrored {2} of {4} and {5} {6}"),
    (f"(that is mirrored :) (.+?) , (?:and )?(an?|one|1) {_IN_THE_MIDDLE}", "{1} {2} and {3} {4}"),
    (f"\\b(?:mirrored|symmetric|symmetrical|mirror symmetric) ({_LINE} (?:of \\S+ (?:blocks |cubes )?)?(?:,|with|:) "
     f"{COLOR} at (?:both|the) ends , {COLOR} in the (?:middle|center) and {COLOR} in between)$", "{1}"),
    # what is said of a line that stands before it
    (f"^the (?:colors?|color order|order|color sequence) (?:of|in) the ({_LINE}) {_MIRRORED}",
     "the {1} should be in mirrored order"),
    (f"^((?:the|my|this) {_LINE}(?: (?:of|with|from|made of|made from|consisting of) .+?)?|it|they) {_MIRRORED}(?=$| ,|"
     " :)",
     "{1} should be in mirrored order"),
    (f"(?: ,)? and (it|they|the {_LINE}) {_MIRRORED}$", " . {1} should be in mirrored order"),
    (f"^(?:the|my|this) ({_LINE})(?: of blocks)? should be in mirrored order : (.+)$", "a mirrored {1} : {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = (
    "places positions half halves image images mirror mirrors occur palindrome palindromes reflect reflection "
    "reflections reflects spectrum way",
)
"""Words that these take besides those that are read anyway."""
