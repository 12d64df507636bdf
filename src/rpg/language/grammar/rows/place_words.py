"""The words in which a line is told block by block: the blocks, the places, and what comes around them."""

from __future__ import annotations

from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MUST

LINE = "(?:row|line|column)"
LINES = frozenset({"row", "line", "column", "behind"})
IS = (
    f"(?:(?:{MUST} )?(?:be|stand|lie|sit|come|go|follow)|is|are|being|goes|go|stands?|comes?|sits?|lies?|follows?"
    "|belongs?)(?: placed| put| found)?"
)
_NOUN = "(?:block|cube|brick|box|one|letter|digit)"
_NOUNS = "(?: blocks| cubes| ones| boxes)"
_ALONE = "(?:(?:the|an?|one|another|its|single|lone|remaining|only|last) )*"
_AGAIN = "(?: again| too| as well| also)?"
THING = (
    f"(?:(?:the |all |only |just )*(?P<many>{FEW}|\\d+|both) (?P<colors>{COLOR})s?{_NOUNS}?"
    f"|(?:the |all |all the )?(?P<several>{COLOR})(?:s|{_NOUNS})"
    f"|(?:just )?(?P<same>as many) (?P<like>{COLOR}){_NOUNS}?"
    f"|{_ALONE}(?P<color>{COLOR})(?: {_NOUN})?{_AGAIN}"
    f"|(?:(?:the|an?|one|another) )?(?:{_NOUN} )?(?P<label>@[a-z]|\\d)(?: {_NOUN})?)"
)
REMAINING = f"(?:the )?(?:remaining|other) (?P<many>{FEW}|\\d+)(?: ones)?(?: {IS})?(?: all)? ({COLOR})"
_TO_ME = "(?: to (?:me|you|us|the viewer|the robot|the camera)| me| you)?"
_FROM_ME = "(?: away)?(?: from (?:me|you|us|the viewer|the robot))?"
_END = "(?: end| side| edge| hand side| end of it| of it| of all| position| place)?"
_AT = "(?:(?:at|on|to) )?(?:the )?(?:far |very |extreme |outer |outermost )?"
_FROM_LEFT = "(?: (?:from|on|at) (?:the )?left)?"
_LEFT_OUT = "(?:all )?the (?:places|spots) (?:that are left|left|in between)"
PLACES = {
    "left": f"leftmost|{_AT}left{_END}|(?:the )?first(?: {_NOUN})?{_FROM_LEFT}|the leftmost(?: {_NOUN})?"
            f"|(?:the |its )left {_NOUN}",
    "right": f"rightmost|{_AT}right{_END}|(?:the |at )?last(?: {_NOUN})?(?: (?:from|on|at) (?:the )?(?:left|right))?"
             f"|the rightmost(?: {_NOUN})?|(?:the |its )right {_NOUN}",
    "front": f"(?:in |at |to )?(?:the )?(?:very )?front{_END}|(?:the )?(?:nearest|closest)(?: one)?{_TO_ME}|frontmost"
             "|(?:the )?first(?: one)?(?: from the front)?",
    "back": f"(?:in |at |to )?(?:the )?(?:very )?(?:back|rear){_END}|(?:the )?(?:farthest|furthest)(?: one)?{_FROM_ME}"
            "|rearmost|(?:the )?last(?: one)?(?: from the front)?",
    "middle": "(?:(?:right |exactly )?in|at) (?:the|its) (?:very |exact )?(?:middle|center)"
              f"(?: position| place| of it| between them)?|the middle {_NOUN}|the one in the middle|middle|center",
    "ends": "(?:at|on) (?:both|the|the two|either|each) (?:ends?|sides?)(?: of it)?"
            "|the (?:two )?outer(?:most)?(?: ones| blocks)?",
    "rest": "(?:all )?the rest|the others|the other (?:ones|blocks)|(?:those|the ones) (?:in )?between"
            f"|(?:in )?{_LEFT_OUT}|the remaining (?:ones|blocks)|in the middle of them"
            "|(?:anywhere |somewhere )?(?:in )?between(?: (?:them|those|these|those two|the two|these two))?",
}  # fmt: skip
"""Where blocks stand in a line: at one of its ends, in the middle, at both ends, or where nothing else is."""
INNER = (
    f"(?P<thing>.+?)(?: {IS})? (?:next to|beside|inside) (?:(?:each|both|either|every one)(?: of (?:them|these|those)| "
    f"end| of the ends| {COLOR})?|them|those|these|that|the ends|the (?:two )?{COLOR}s?)(?: {_NOUN}s?)?"
)
"""What is said so of both ends of the line, of what is next to them."""
ASIDE = {
    "left": "(?:to|on) its left(?: side)?|(?:to|on) the left of it",
    "right": "(?:to|on) its right(?: side)?|(?:to|on) the right of it",
    "front": "in front of it",
    "back": "behind it",
}
"""What is said so of the middle of the line."""
NEXT = (
    "(?:(?:then|next|after (?:it|that|this)|followed by|next to (?:it|that)|beside it|behind (?:it|that))"
    f"(?: {IS})? (?P<thing>.+)"
    "|(?:it |then )?(?:continues|goes on|continuing|going on) with (?P<thing3>.+)"
    f"|(?:then )?the next(?: one| two| three)?(?: {IS})? (?P<thing1>.+)"
    f"|(?P<thing2>.+?) (?:{IS} )?(?:next|then|after (?:it|that)|next to it|beside it|behind (?:it|that)))"
)
ONWARD = {
    "left": "(?:(?:to|on) its left(?: side)?|(?:(?:to|on) the )?left(?: side)? of (?:it|that))",
    "right": "(?:(?:to|on) its right(?: side)?|(?:(?:to|on) the )?right(?: side)? of (?:it|that))",
    "front": "in front of (?:it|that)",
    "back": "behind (?:it|that)",
}
"""What is next of what was told before, seen from the other end."""
ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")
NTH = (
    f"(?:(?:at|in) )?(?:the )?(?P<nth>{'|'.join(ORDINALS[1:])})(?: one| place| position| block)?"
    "(?:(?: place| position)? from (?:the )?(?P<from>left|right|front|back))?"
)
_SIDE = "(?:at|on|from) the (?P<side{0}>left|right|front|back)(?: end| side)?"
WITH = (
    "(?:(?:the |this )?(?:row|line|column) |it )?"
    "(?P<verb>starts|begins|ends|finishes|starting|beginning|ending|finishing)"
    f"(?: {_SIDE.format('')})? with (?P<thing>.+?)(?: {_SIDE.format('1')})?"
)
CLOSES = f"(?P<thing>.+?) (?:closes|ends|completes|finishes) (?:it|the row|the line)(?: {_SIDE.format('')})?"
_MADE = "(?: (?:formed|made|built|laid|created|set up|arranged))?"
SAID = (
    "^(?:(?:at|in) the end(?: ,)? |finally(?: ,)? |what (?:i|we) want(?: to see)? (?:: |is )|(?:the|my) (?:final )?"
    "(?:thing|picture|result|state|goal|idea) (?:: |is )|please |just )*"
)
"""What stands ahead and tells nothing."""
_LEAD = (
    f"(?:(?:there (?:is|are|{MUST} be)|make|build|lay(?: out)?|form|create|set out|arrange|put|i want|i would like"
    "|we want|give me|i need)(?: me)? )?"
)
DO = "^(?:put|place|set|lay|arrange|have|line up|i want)(?: (?:the|some) (?:blocks|cubes)| them)?(?: so that)? "
_SIZE = f"(?: of (?P<size>{FEW}|\\d+)(?: blocks| cubes| boxes)?(?! {COLOR}))?"
_ALL = "(?: ,)?(?: and)?(?: all| everything| they are all| all of them)?"
_A_LINE = f"(?:straight |single )?(?P<line>{LINE}){_SIZE}(?: on the table)?"
_WHERE = "in which|where|so that|such that|with|which has|that has|has|have|and(?= it)|that(?= \\w+s )"
FRAMES = (
    f"^{_LEAD}(?:in )?(?:an?|the|one|my|this) {_A_LINE}(?: {MUST} be{_MADE})?(?: ,)?(?: :| (?:{_WHERE}))?(?= )",
    f"^(?P<line>{LINE})(?: :| with(?= ))",
    f"{_ALL} (?:in|of) (?:an?|one|the) {_A_LINE}(?=$| ,| ;| \\.| and | is | are | {MUST} | : )",
    f"(?:^|{_ALL} )(?:standing )?(?P<line>one behind the other|behind each other|behind one another)(?: :)?(?=$| )",
)
"""What names the line, ahead of its blocks, in between or behind them."""
MIRRORED = f"\\b(?:mirror )?(?:symmetric|symmetrical|mirrored|palindromic) (?={LINE}\\b)"
"""A line that is its own mirror image, where its places show that it is."""
STOCKED = (
    f"^({_LEAD}(?:an?|the|one) (?:row|line|column))(?: of| with| from) ((?:(?:the |an? )?[^ ,:;]+ ?(?:block|"
    f"cube)?s?(?: ,| and)+"
    " )+(?:the |an? )?[^ ,:;]+(?: blocks?| cubes?)?)(?: ,)? (?:such that|so that|in which|where|with) "
)
"""A line, and what blocks it has, ahead of their places."""
UTMOST = {
    "at the front": "(?:(?:the )?(?:nearest|closest)(?: to)? (?:me|you|us|the viewer|the robot|the camera)"
                    "|which is (?:nearest|closest)(?: to me)?)",
    "at the back": "(?:(?:is )?(?:the )?(?:farthest|furthest)(?: away)?(?: from (?:me|you|us|the viewer|the robot))?)",
}  # fmt: skip
"""Ends of a column told by who stands there."""
CHANGED = frozenset({
    "reverse", "reversed", "swap", "swapped", "exchange", "change", "rearrange", "reorder", "flip", "now", "currently",
    "initially", "originally", "already", "beginning", "start", "turn", "trade",
})  # fmt: skip
"""What is told of a line that is there already, and is to change."""
WORDS = ("closes completes finishes frontmost rearmost",)
"""Words that these take besides those that are read anyway."""
