"""Orders told by what the values do along a line, by its ends, by the alphabet or the rainbow, and rows that alternate
or touch: as rows that say the order in its common words."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, END, MANY, MUST, WAY

ALONG = (
    "(?:(?:going |read |reading |running |seen )?(?:from )?(?:the )?left to (?:the )?right"
    "|(?:starting|beginning) (?:from|on|at) the left(?: end| side)?)"
)
"""From left to right, in whatever words."""
_WAY = f"(?:{ALONG}|(?:going |read |reading )?from (?:the )?{END} to (?:the )?{END}|to(?:wards)? the right)"
_THEY = (
    "(?:they|it|the (?:numbers|digits|values|numerals)(?: on (?:them|it|top))?|the (?:row|line|column|tower|stack)"
    "|its (?:numbers|digits|values))"
)
_SO = "(?:so|so that|such that|in which|where|with)"
_MORE = "(?:bigger|larger|higher|greater)"
_LESS = "(?:smaller|lower|less|lesser)"
_GROW = (
    f"(?:increases?|increasing|grows?|growing|go(?:es)? up|going up|rises?|rising|ascends?|climbs?|(?:gets?|getting"
    f"|becomes?|becoming) (?:{_MORE}|{_MORE} and {_MORE}))"
)
_SHRINK = (
    f"(?:decreases?|decreasing|shrinks?|go(?:es)? down|going down|falls?|falling|descends?|(?:gets?|getting|becomes?"
    f"|becoming) (?:{_LESS}|{_LESS} and {_LESS}))"
)
_DIGITS = "^(?=.*(?:\\b\\d\\b(?! ?(?:cm|mm))|\\bnumbers?\\b|\\bdigits?\\b))(?!.* (?:cm|mm)\\b)"
_UP = (
    "in (?:ascending|increasing|numeric|numerical|rising) order|from (?:the )?(?:smallest|lowest) to (?:the "
    ")?(?:largest"
    "|biggest|highest)|sorted ascending"
)
_UPS = f"(?:{_UP}|from low to high|from small to (?:large|big)|(?:sorted )?ascending)"
_DOWNS = (
    "(?:in (?:descending|decreasing|falling) order|from (?:the )?(?:largest|biggest|highest) to (?:the )?(?:smallest|"
    "lowest)"
    "|(?:sorted )?descending)"
)
_WHAT = "(?: number| digit| one| block| cube| value)?"
_EACH = (
    f"({_DIGITS}.*?)(?: ,)?(?: so that| such that| with| where| in which)? each(?: one| number| digit| cube)? "
    "(?:is |being |)?"
)
"""What leads to "larger than the one before it"."""
_SMALL = f"(?:with )?(?:the )?(?:smallest|lowest|least){_WHAT}(?: is| being)?"
_LARGE = f"(?:with )?(?:the )?(?:largest|biggest|highest|greatest){_WHAT}(?: is| being)?"
_ME = "(?:(?: to)? (?:me|us|you|the viewer|the robot|the camera))?"
_PLACES = {
    "left": "(?:(?:on|at) the (?:far )?left(?: end| side)?|leftmost|first(?: from the left| on the left))",
    "right": "(?:(?:on|at) the (?:far )?right(?: end| side)?|rightmost)",
    "front": f"(?:(?:nearest|closest){_ME}|(?:at|in) (?:the )?(?:very )?front|in front)",
    "back": "(?:(?:farthest|furthest)(?: away)?(?: from (?:me|us|you|the viewer|the robot|the camera))?"
            "|(?:at|in) the (?:very )?back|at the rear)",
    "bottom": "(?:at the (?:very )?bottom|on the bottom|lowest)",
    "top": "(?:at the (?:very )?top|on (?:the )?top|uppermost)",
}  # fmt: skip
_AXES = (("left", "right"), ("front", "back"), ("bottom", "top"))
_JOIN = "(?: ,)?(?: and)?"
_BOTH_ENDS: tuple[Turn, ...] = tuple(
    (
        f"{head}(?: ,)? (?:(?:so that|such that|in which|where) )?{small} {_PLACES[a]}{_JOIN} {large} "
        f"{_PLACES[b]}(?= ,|$)",
        f"{{1}} {order} from {a} to {b}",
    )
    for head, order in (
        ("(^(?=.*(?: cm| mm)\\b).*?)", "from smallest to largest"),
        (f"({_DIGITS}.*?)", "in ascending order"),
    )
    for one, other in _AXES
    for a, b, small, large in (
        (one, other, _SMALL, _LARGE),
        (other, one, _SMALL, _LARGE),
        (one, other, _LARGE, _SMALL),
        (other, one, _LARGE, _SMALL),
    )
)
"""The smallest at one end, the largest at the other; told from the smallest on."""
_OPPOSITE = {a: b for one in _AXES for a, b in (one, one[::-1])}


def _from_the_smallest(row: Turn) -> Turn:
    """The same where the largest is told first: the order still begins with the smallest."""
    pattern, said = row
    if pattern.index("smallest|lowest|least") < pattern.index("largest|biggest|highest|greatest"):
        return row
    *ahead, a, _, b = said.split()
    return pattern, " ".join((*ahead, b, "to", a))


_ONE_END: tuple[Turn, ...] = tuple(
    (
        f"\\b({_UP})(?: ,)? {what} {_PLACES[place]}(?= ,|$)",
        f"{{1}} from {place if what == _SMALL else _OPPOSITE[place]} to "
        f"{_OPPOSITE[place] if what == _SMALL else place}",
    )
    for place in ("front", "back")
    for what in (_SMALL, _LARGE)
)
"""Sorted, and which is at the front."""
_ALPHABET = "(?:as in|like in|by|according to|following|in the order of|along|through) the alphabet"
_BACK = (
    "(?:backwards? (?:through|in|along) the alphabet|against the alphabet|from the last to the first in the alphabet"
    "|from last to first in the alphabet|from z to a|in backwards? alphabetical order)"
)
_RAINBOW = "(?:rainbow|spectrum|gradient|color gradient|rainbow gradient)"
_LIST = f"((?:(?:the |an? )?{COLOR}(?: {CUBE}s?)?(?: ,| and| , and)* ?)+?)"
_EVERY = "(?:every other|every second)"
_FROM_END = (
    f"(?:(?:from )?(?:the )?{END}(?: up| down)? to (?:the )?{END}|(?:starting|beginning) (?:on|from|at) the left)"
)
_SYMBOL = f"(?:{COLOR}|[a-z]|\\d)"
_ITEM = f"(?:the )?(?:(?:letter|number|digit|cube|block) )?{_SYMBOL}(?: (?:one|block|cube))?"
_SYMBOLS = (
    "(?:the )?(?:(?:letters|digits|numbers|cubes|blocks|(?:letter|number|digit) (?:cubes|blocks)) )?"
    f"(?:(?:the |an? )?{_SYMBOL}(?: block| cube)?(?: ,| and| , and) )+(?:the |an? )?{_SYMBOL}(?: blocks?| cubes?)?"
)
_BE = f"(?:is|being|comes|stands|goes|sits|{MUST} be|{MUST} stand|{MUST} come|as)"
_IS = f"(?: {_BE})?"
_NTH = "(?:second|third|fourth|fifth|sixth)"
_PLACE = (
    f"(?:(?:the )?{_NTH}(?: one)? from the (?:left|right)|(?:the )?(?:leftmost|rightmost)(?: one)?|(?:the )?first(?: "
    f"from "
    "the left| on the left)?|(?:on|at) the (?:far )?(?:left|right)(?: end| side)?|in the (?:middle|center))"
)

_LINED = f"^((?:.*? )?(?:row|lined?|arrange|order)\\b.*?)(?:(?: ,| :)(?: {_SO})?| {_SO})"
_KIND = "(?:the |all |all the |all of the )?(letters|digits|numbers)(?: cubes| blocks)?"
_COME = f"(?:(?:{MUST} )?(?:come|go|stand|be|are|coming|standing|going|placed) )?"
_SYMBOLIC = "(?:digits|numbers|letters|numerals|(?:digit|number|letter) (?:blocks|cubes))"
_SORT = (
    "(?:the|all|vowels|consonants|letters|digits|numbers|even|odd|evens|odds|ones|first|before|then|followed by|and|"
    "come|go|after|to the left of|left of|ahead of|,)"
)
"""What tells which sort comes first."""
_THESE = "((?:the )?(?:digits |numbers |letters )?\\w(?:(?: ,| and| , and| to| through)? \\w(?= |$))+)"

ORDERED_AT_ONCE: tuple[Turn, ...] = (
    # which sort comes first, and then the symbols
    (f"^(?:in (?:a|one) row ,? ?)?(?:(?:put|place|sort|arrange|line up) )?(?=[^:]*\\b(?:vowels|consonants|evens?|odds?|"
     f"letters)\\b[^:]* )((?:{_SORT} )*(?:first|before|then|followed by|after|left of|ahead of) (?:{_SORT} )*?)"
     f"(?:in a row )?[:,] {_THESE}(?: in a row)?$", "a row of {2} , {1}"),
    (f"\\b({_SYMBOLIC}) (\\w) down to (?=\\w\\b)", "{1} from {2} down to "),
    # the one kind of symbols before the other
    (f"{_LINED} {_KIND} {_COME}(?:before|ahead of) {_KIND}$", "{1} , the {2} first"),
    (f"{_LINED} {_KIND} {_COME}after {_KIND}$", "{1} , the {3} first"),
    (f"{_LINED} first {_KIND}(?: ,)? (?:and )?then {_KIND}$", "{1} , the {2} first"),
    (f"{_LINED} {_KIND} first(?: ,)? (?:and )?then {_KIND}$", "{1} , the {2} first"),
    ("\\bso (?=the (?:biggest|largest|smallest|lowest|highest) (?:one |number |digit |block |cube )?is\\b)",
     "so that "),
    ("(?: ,)? (?:that|which) (?:goes|runs|is) from the (biggest|largest|smallest|lowest|highest)(?: one)? (?:at|on) "
     "the (left|right|bottom|top) to the (biggest|largest|smallest|lowest|highest)(?: one)? (?:at|on) the ",
     " from the {1} on the {2} to the {3} on the"),
    ("^(.*\\b(?:row|line)\\b[^:,]*?)(?: ,)? but not in (alphabetical|numerical|numeric|ascending|descending) order$",
     "{1} . they must not be in {2} order"),
    # numbers and sizes
    *map(_from_the_smallest, _BOTH_ENDS),
    *_ONE_END,
    *(
        (f"({_DIGITS}.*?\\b(?:row|line|column|tower|stack|up|other)\\b.*?)(?: ,)? {_SO} {_THEY} (?:{MUST} )?{changes}"
         f"{way}(?= {_WAY}| {_SO}|$| ,)", f"{{1}} in {order} order{told}")
        for changes, order in ((_GROW, "ascending"), (_SHRINK, "descending"))
        for way, told in ((" to(?:wards)? the right", " from left to right"), ("", ""))
    ),
    (f"({_DIGITS}.*?)(?: ,)? so that ,? ?((?:going |read |reading )?from (?:the )?{END} to (?:the )?{END})(?: ,)? "
     f"{_THEY} (?:{MUST} )?{_GROW}$", "{1} in a row in ascending order {2}"),
    ("\\b(?:by|of|in) (?:increasing|growing|ascending) size\\b", "from smallest to largest"),
    ("\\b(?:by|of|in) (?:decreasing|shrinking|descending) size\\b", "from largest to smallest"),
    ("\\b(?:sorted )?by size(?: ,)? (?:the )?smallest(?: one)? first\\b", "from smallest to largest"),
    (f"\\b({MANY} (?:\\w+ )?(?:blocks|cubes)) , ((?:\\d (?:cm )?(?:,|and|, and) )+\\d cm) (?:in size|wide|large|big|"
     "long|high|each|edges?)(?= |$)", "{1} of {2}"),
    (f"\\b({MANY} (?:\\w+ )?(?:blocks|cubes)) , with (?:edges|sides|an edge|edge lengths) of ((?:\\d (?:cm )?(?:,|and|"
     ", and) )+\\d cm) ,", "{1} of {2}"),
    ("\\b(in a (?:row|line|column)) (?:of increasing size|of growing size)\\b", "{1} from smallest to largest"),
    # kinds, one before the other
    *(
        row
        for told, order in ((_UPS, "in ascending order"), (_DOWNS, "in descending order"))
        for row in (
            (f"(?: :| ,)*(?: the)? (even|odd) (?:numbers|digits|ones) before (?:the )?(?:even|odd) (?:numbers|digits|"
             f"ones)"
             f"{_JOIN} (?:sorted )?{told} (?:with)?in(?:side)? (?:each|every|both)(?: (?:kind|part|group|half|of "
             f"them)s?)?$",
             f" , first the {{1}} numbers , then the others , each {order}"),
            (f"(?: :| ,)*(?: first)?(?: the)? (even|odd) (?:numbers|digits|ones)(?: ,)? (?:sorted )?{told}{_JOIN} "
             f"(?:then|"
             f"followed by)(?: the)? (even|odd)(?: numbers| digits| ones)?(?: ,)? (?:sorted )?{told}(?=$| ,)",
             f" , first the {{1}} numbers , then the {{2}} ones , each {order}"),
        )
    ),
    (f"{_EACH}{_MORE} than the (?:one|number|digit|cube) (?:before it|before|to its left|on its left|preceding it)$",
     "{1} in ascending order from left to right"),
    (f"{_EACH}{_LESS} than the (?:one|number|digit|cube) (?:before it|before|to its left|on its left|preceding it)$",
     "{1} in descending order from left to right"),
    (f"{_EACH}(?:{_MORE} than the (?:one|number|digit|cube) (?:on it|on top of it|above it|above)|{_LESS} than the "
     "(?:one|"
     f"number"
     "|digit|cube) (?:below it|under it|it stands on|it is on|beneath it|below))$",
     "{1} in descending order from bottom to top"),
    (f"{_EACH}(?:{_LESS} than the (?:one|number|digit|cube) (?:on it|on top of it|above it|above)|{_MORE} than the "
     "(?:one|"
     f"number"
     "|digit|cube) (?:below it|under it|it stands on|it is on|beneath it|below))$",
     "{1} in ascending order from bottom to top"),
    ("\\bone behind (?:the other|another) ,? ?(?=in (?!the )\\w+ (?:\\w+ )?order)", "in a column "),
    # letters
    (f"(?:,? ?(?:sorted|ordered|arranged) )?\\b{_BACK}\\b", "in reverse alphabetical order"),
    (f"(?<!in )(?:,? ?(?:sorted|ordered|arranged) )?\\b{_ALPHABET}\\b(?! of)", "in alphabetical order"),
    # along which way
    (f"\\b(row|line|column|tower|stack) (?:that|which) (?:runs|goes|leads|reads|is read|is to be read) ({WAY})\\b",
     "{1} {2}"),
    ("\\b(?:one|each) (?:after|behind) (?:the other|another|one another|the next) ,? ?(?=(?:from )?(?:the )?front to "
     "(?:the )?back)", "in a column "),
    ("\\b(?:starting|beginning) (?:from|on|at) the left(?: end| side)?(?= :| ,|$| in | with)", "from left to right"),
    # rainbows
    (f"(?: ,)? (?:so|such)(?: that)? (?:the|their|its) colors (?:form|make|give) an? {_RAINBOW}", " in rainbow order"),
    (f"\\b(in rainbow order(?: ,)?(?: with)?) ((?:the )?{COLOR}(?: one)?) first (?=on the left|from the left)",
     "{1} {2} "),
    (f"^(?:the )?colors (?:of|in) the (row|line) {MUST} (?:follow|form|make) (?:the|a) {_RAINBOW} ,? ?(.*?)(?: ,)? ?: "
     f"(?:use )?{_LIST}$", "put {3} in a {1} in rainbow order , {2}"),
    (f"^an? {_RAINBOW} ({ALONG} )?in an? (row|line) : (.+?)( , .+? (?:leftmost|on the left|at the left end))?$",
     "put {3} in a {2} in rainbow order {1} {4}"),
    # places in a row
    ("\\bthe (\\d) ((?:is |being |comes |stands )?(?:the )?(?:second|third|fourth|fifth|leftmost|rightmost|first)(?= "
     "from the"
     "| ,|$| and| in a (?:row|line)))", "the digit {1} {2}"),
    (f"^(?:out )?of (?:the )?({MANY}(?: {COLOR})? (?:blocks|cubes|bricks)) in (?:an?|the|one)(?: single)? (row|line|"
     "column)(?: ,)? ((?:only )?(?:the|every|each) .+)$", "a {2} of {1} . {3}"),
    (f"^in an? (row|line|column) of ({MANY}(?: (?:blocks|cubes|bricks))?)(?: ,)? ((?:every|each) (?:second|other) .+)$",
     "a {1} of {2} , {3}"),
    (f"^(?:(?:make|build|i want) )?an? row of (.+?) (?:in which|where) ((?:{_ITEM}{_IS} {_PLACE}{_JOIN} ?)+)$",
     "put {1} in a row , {2}"),
    (f"^in an? row of ({_SYMBOLS})(?: ,| :) ((?:{_ITEM}{_IS} {_PLACE}{_JOIN} ?)+)$", "put {1} in a row , {2}"),
    (f"^((?:{_ITEM}{_IS} {_PLACE}{_JOIN} ?)+) in an? row of ({_SYMBOLS})$", "put {2} in a row , {1}"),
    (f"^(.* in a row , .*?)({_ITEM}) {_BE} (?={_PLACE}(?:$| ,| and))", "{1} {2} "),
    (f"^the (?:middle one|middle block|middle cube|one in the middle|middle) (?:of|in) an? row of ({_SYMBOLS}) "
     f"(?:{MUST} be|is) ({_ITEM})$", "put {1} in a row , {2} in the middle"),
    ("(?: ,)? in (?:any order|whatever order|whichever order|an arbitrary order)(?: you (?:like|want|please|"
     "wish))?(?: ,)? "
     f"(?:but|as long as|provided that|provided|so long as|if only|just)(?: with)? ({_ITEM}) (?:{_BE} )?(in the "
     f"(?:middle"
     "|center))(?: one)?$", " with {1} {2}"),
    # lists
    (f"^(?:lined up|all lined up|in line|in a line|in a row) ({ALONG}) - (.+)$", "a row , from left to right : {2}"),
    (f"\\b(row|line|tower|stack|column) with ,? ?({_FROM_END}) ,? ?(?=.* (?:,|and) )", "{1} , {2} : "),
    (f"^in (?:the|a|one) (tower|stack|row|line|column) ,? ?(?:(?:which|that) )?(?:reads|is read|read|seen)? "
     f"?({_FROM_END}) ,? ?"
     "(?:(?:we|you|i) (?:can )?see|are|there are|stand) (?=.* (?:,|and) )(.+)$", "a {1} , {2} : {3}"),
    (f"^an? (tower|stack|row|line|column) that ,? ?(?:when |if )?read ({_FROM_END}) ,? ?(?:says|goes|is|shows|reads) "
     "(?=.* (?:,|and) )(.+)$", "a {1} , {2} : {3}"),
    (f"^(?:the )?(?:blocks|cubes|members)(?: in| of)? the (row|line) {MUST} be ,? ?(?:in this order|in order)?(?: and|"
     f",)* ?"
     f"({_FROM_END})(?: :| ,) (.+)$", "a {1} , {2} : {3}"),
    # rows that alternate
    (f"(?: ,)?(?: (?:that|which|and))? (?:begins|starts|beginning|starting|begin|start) and (?:ends|finishes|ending|"
     f"end) with (?:an? )?({COLOR})(?: one| block| cube)?(?= |$)", " with {1} at both ends"),
    (f"( with {COLOR} at both ends) and (?:has|with) ({MANY} {COLOR}(?: \\w+)? (?:in )?between)", "{1} and {2}"),
    (f"(?<!the )\\b({COLOR})(?: one| block| cube)? (?:at|on) (?:each|either) end(?= ,|$| and)", "{1} at both ends"),
    (f"\\b(row|line) that alternates(?: ,| :) ({MANY} {COLOR} and {MANY} {COLOR} (?:blocks|cubes))", "{1} of {2} that "
     "alternates"),
    (f"\\b(always one ({COLOR}) (?:and )?one {COLOR}|alternat\\w+)((?: .*)?) , (?:the )?({COLOR})(?: one)? (?:is|"
     f"comes|being)? "
     "?(?:the )?first(?: (?:on|from) the left)?$", "{1} {3} , starting with {4} on the left"),
    (f"^an? alternating row ({ALONG} )?: (.+ starting with .+)$", "put {2} in a row {1} , alternating"),
    (f"^alternating row ({ALONG} )?: (.+) , (starting with {COLOR} on the left|{COLOR} first)$",
     "{2} in a row , alternating , {3}"),
    (f"\\b(alternating) , ({COLOR}) first$", "{1} , starting with {2} on the left"),
    (f"^(?:the )?({COLOR}) and ({COLOR}) (blocks|cubes) , ({MANY}) (?:of each|each) , (?:alternate|alternating) "
     f"(?:along|in) an? "
     "(row|line)$", "{4} {1} and {4} {2} {3} in a {5} , alternating"),
    (f"^({MANY} (?:blocks|cubes)) in an? (row|line)(?: ,| :) ((?:{MANY} {COLOR} ?(?:,|and|, and)? )+, )(?:placed |"
     f"arranged |laid )?"
     "(?=so that|such that)", "a {2} of {1} , {3} "),
    (f"\\bone ({COLOR}) (block|cube)s\\b", "one {1} {2}"),
    (f"^(?:the )?colors (?:of the (?:blocks|cubes) )?(?:in|of) (?:the|a) (row|line) (?:{MUST} )?alternate( between "
     f"{COLOR} and "
     f"{COLOR})?(?: ,| :) ({MANY} .+)$", "put {3} in a {1} , alternating {2}"),
    (f"\\b({MANY} {COLOR}(?: blocks| cubes| ones)?) alternating with ({MANY} {COLOR})(?: ones| blocks| cubes)? in "
     f"(?:a|one|a "
     "single) (row|line)$", "{1} and {2} blocks in a {3} , alternating"),
    (f"^{_EVERY} (?:block|cube|one) (?:in|of) an? (row|line) of ({MANY}) (?:is|{MUST} be) ({COLOR}) ,? ?(?:beginning|"
     f"starting) "
     f"(?:with|from|at) the leftmost(?: one)?(?: ,)?(?: and)? the (?:others|rest|other ones)(?: are| is| {MUST} be)? "
     f"({COLOR})$", "a {1} of {2} blocks alternating {3} and {4} , starting with {3} on the left"),
    # rows that touch
    (f"(?: ,)?(?: so that| such that| so)?(?: ,)? (?:every|each)(?: one| block| cube)? (?:{MUST} touch|touches) (?:the "
     "next(?: one| block)?|its (?:next )?neighbors?)", " , touching"),
    ("(?: ,)? (?:where|in which|so that|such that) (?:all )?(?:the )?(?:neighbors|neighboring (?:blocks|cubes)) touch"
     "(?: each other)?", " , touching"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
_OF = "(?:formed by|formed of|made of|made from|consisting of|of)"

_SIZES = "(?:(?:the |all |all the |these |their )?(?:blocks|cubes|boxes|ones|sizes|sizes of the (?:blocks|cubes)))"

ORDERED: tuple[Turn, ...] = (
    # sizes
    *(
        (f"^(?:({_WAY})(?: ,)? )?{_SIZES} (?:{MUST} )?{changes}(?: in size)?(?: ({_WAY}))? : (.+?)(?: in an? row)?$",
         f"put {{3}} in a row from {order} {{1}} {{2}}")
        for changes, order in ((_GROW, "smallest to largest"), (_SHRINK, "largest to smallest"))
    ),
    # numbers
    (f"^(?:({_WAY})(?: ,)? )?the (row|line) {_OF} (.+?) (?:{MUST} )?{_GROW}(?: ({_WAY}))?$",
     "put {3} in a {2} in ascending order {1} {4}"),
    (f"^(?:({_WAY})(?: ,)? )?the (row|line) {_OF} (.+?) (?:{MUST} )?{_SHRINK}(?: ({_WAY}))?$",
     "put {3} in a {2} in descending order {1} {4}"),
    (f"^the (numbers|digits) (?:in|of) the (row|line) (?:{MUST} )?{_GROW}(?: ({_WAY}))? : (.+)$",
     "put the {1} {4} in a {2} in ascending order {3}"),
    (f"^the (numbers|digits) (?:in|of) the (row|line) (?:{MUST} )?{_SHRINK}(?: ({_WAY}))? : (.+)$",
     "put the {1} {4} in a {2} in descending order {3}"),
    (f"^(.*?\\d)(?: ,)? in a (row|line)(?: ,)? {_GROW}(?: ({_WAY}))?$", "{1} in a {2} in ascending order {3}"),
    (f"^(.*?\\d)(?: ,)? in a (row|line)(?: ,)? {_SHRINK}(?: ({_WAY}))?$", "{1} in a {2} in descending order {3}"),
    ("^an? (?:number (tower|stack)|(tower|stack) of (?:numbers|digits)) going up (\\d.*)$",
     "a {1} {2} from bottom to top : {3}"),
    (f"^count (?:up|down) : (.+ {ALONG}.*|.+ order.*)$", "{1}"),
    # rows that alternate
    (f"\\b({MANY} {COLOR}(?: blocks| cubes| ones)?) n (?={MANY}\\b)", "{1} and "),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = (
    "alphabet ascend ascends decrease decreases decreasing descend descends follow gradient grow grows growing "
    "increase "
    "increases increasing rise rises rising shrink shrinks spectrum z",
)
"""Words that these take besides those that are read anyway."""
