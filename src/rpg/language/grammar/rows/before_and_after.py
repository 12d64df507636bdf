"""How something is, and how it has to become: "red is left of blue now. I want it on the right.", "at some point, but
not at the end", "brown isn't on pink yet. Change that.", as rows that tell the start and the goal."""

from __future__ import annotations

from rpg.language.grammar.rows.begun import END, LIST, TIME, UP
from rpg.language.grammar.rows.said_short import LABEL, PLACE, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, PATCHES

_IS = "(?:is|are|lies|lie|stands|stand|sits|sit)"
_HAS_TO = f"(?:{MUST}|has to|have to)"
_NOW = "(?: now| right now| currently| at the moment)?"
_CHANGE = (
    "(?:change (?:that|it|this) so(?: that)? it is|i want it(?: to be)?|put it|move it|it should be|it must be|make it)"
)
_ONE = f"(?:the (?:letter |digit |number )?{LABEL}(?: block| cube)?|{THING})"
_WORD = f"(?!{COLOR}\\b)\\S{{2,}}"
_SPELT = (
    f"(?:the word )?({_WORD}) (?:lies|is|stands|is written|is spelled) (?:on the table|there|already there|out|in a "
    "row)(?: at "
    f"the start| at first)?|"
    f"the word on the table (?:is|reads|says) ({_WORD})|"
    f"the (?:cubes|letters|blocks|row|word) (?:spells?|reads?|says?) ({_WORD})(?: at first| now| at the start)?"
)
_READS = "(?:it|they|the (?:letters|cubes|blocks|row|word)) (?:spells?|reads?|says?|becomes?)"
"""How a word is told that is there, and one that is to be there."""


def _other_side(one: str, said: str, other: str) -> Turn:
    """ "Red is left of blue now. I want it on the right."."""
    return (
        f"^({THING}) {_IS}{_NOW} (?:{one}) ({THING}){_NOW} \\. (?:please )?{_CHANGE} (?:{said})(?: of it| of that)?(?: "
        "instead)?(?= \\.|$)",
        f"at the start {{1}} is {one.split('|')[0]} {{2}} . put {{1}} {other} {{2}}",
    )


_FROM = "(?: ,)?(?: in order)?(?: ,)? (?:beginning|starting) (?:with|from|at)"
"""What is laid or stacked first, of what stands in an order already: the others follow in that order."""
_SWAP = "(?:swap|exchange|switch)"
_WAY = f"(?: ,)?(?: \\()? ({UP})(?: \\))?"
_ORDER_WAS = (
    f"^(?:{TIME} ,? ?)?(?:the|an?) ({LINE})(?: of (?:blocks|cubes))?(?: {TIME})? (?:reads?|is|goes|shows|has the order)"
    f"(?: {TIME})?(?:{_WAY})?(?: :)? ({LIST})(?:{_WAY})?(?: {TIME})?(?: \\.| ,)?(?: and| but)? "
)
_ORDER_WILL_BE = f"(?:{END} ,? ?)?(?:(?:it|the \\1) )?(?:{MUST} |make it )(?:read|be|go|show|have the order)(?: {END})?"
"""A line that is told twice, with the order of its colours at the start and at the end."""
_WAS_AND_WILL_BE = (
    f"^(?=[^.]*\\b{UP}\\b)(?:{TIME} ,? ?)?(?:the|an?) ({LINE})(?: of (?:blocks|cubes))?(?: {TIME})?(?: ({UP}))? "
    f"(?:reads?|is|goes|shows|has the order)(?: {TIME})?(?: ({UP}))?(?: :)? ({LIST})(?: ,)?(?: ({UP}))?(?: {TIME})?"
    f"(?: \\.| ,)?(?: and| but)? (?:{END} ,? ?)?(?:(?:it|the \\1) )?"
    f"(?:(?:{MUST}|make it)(?: (?:read|be|become|go|show|have the order))?|becomes?|turns? into)(?: {END})?(?: :)? "
    f"({LIST})(?: {END})?(?= \\.|$)"
)
"""The same where only the first order says where it begins."""

BEFORE_AND_AFTER: tuple[Turn, ...] = (
    (f"^(?:the robot|it|you) (?:will )?finds? ([^.]+?) (?:standing|lying|sitting) (in [^.]+?)(?: ,)? and (?:it |you )?"
     f"{_HAS_TO} leave (?:them|it) (?:as |in )", "at the start , {1} stand {2} . at the end , they must be "),
    ("\\b(clear|empty) (the [^.,]+?) first(?: so that it is (?:empty|clear|free)(?: again)?)? \\. "
     "(?=(?:the|an?|two|three|four) [^.]*?\\b(?:is|are|lies?|stands?|sits?)(?: lying| standing| sitting)? "
     "(?:on it|there)(?: \\.|$))", "first {1} {2} . "),
    ("(^|\\. )(step|stage|phase) (\\d+) \\. (?=\\w)", "{1} {2} {3} : "),
    (f"^the ({LINE}) (?:consists of|is made(?: up)? of|is built of|contains) ([^.]+?) \\. (?:please )?"
     "(?=(?:turn|reverse|invert|flip|unstack|dismantle|take|restack) )", "there is a {1} of {2} . "),
    (f"^((?:swap|exchange|switch) (?:the )?(?:two )?(?:blocks|cubes)) on the (?:two )?{PATCHES} \\. ([^.]+? (?:is|lies|"
     "starts|stands|sits) on [^.]+)(?= \\.|$)", "at the start , {2} . swap the two"),
    (f"{_ORDER_WAS}{_ORDER_WILL_BE}(?: :)? ({LIST}){_WAY}(?: {END})?(?= \\.|$)",
     "at the start there is a {1} : {3} {2} {4} . build a {1} : {5} {6}"),
    ("^(?:the )?start is ([^.]+?)(?: \\.| ,| ;| and| , and) (?:the )?(?:goal|end|finish) is (?!(?:that|to|not)\\b)",
     "start : {1} . goal : "),
    ("^start is (?=an? )", "the start is "),
    (_WAS_AND_WILL_BE, "at the start there is a {1} : {4} {2} {3} {5} . build a {1} : {6} {2} {3} {5}"),
    (f"{_ORDER_WAS}{_ORDER_WILL_BE}(?: :)? ({LIST})(?: {END})?(?= \\.|$)",
     "at the start there is a {1} : {3} {2} {4} . build a {1} : {5} {2} {4}"),
    (f"(\\b(?:tower|stack|pile)\\b.* \\. [^.]*\\brow\\b[^.,]*?)(?: from left to right)?{_FROM} the (top|bottom)"
     "(?:most)?(?: one| block| cube)?(?= \\.|$)", "{1} in the same order , the {2} one at the left"),
    ("(\\b(?:upside down|on its (?:side|head|back)|sideways)\\b.* \\.) (?:please )?(?:set|put|turn|make) it right(?: "
     "again)?(?= \\.|$)", "{1} turn it upright"),
    (f"(\\b(?:row|line)\\b.* \\. (?:please )?(?:now )?(?:stack|pile) [^.,]+?)(?: up)?{_FROM} the (left|right)(?:most)?"
     "(?: one| block| cube)?(?= \\.|$)", "{1} in the same order , the {2} one at the bottom"),
    # what is left open is no more than that: "the other two may be (of any colour)"
    (f"(?: ,| ;| \\.)(?: and)? the (?:others?|rest|other {MANY}|remaining {MANY})(?: blocks| cubes| ones)? (?:may|can) "
     "(?:be|have)(?:(?: of)? any colors?(?: you (?:like|want))?)?(?= \\.|$)", ""),
    _other_side("to the left of|left of|on the left of", "on the right|to the right|right", "to the right of"),
    _other_side("to the right of|right of|on the right of", "on the left|to the left|left", "to the left of"),
    _other_side("in front of", "behind|behind it", "behind"),
    _other_side("behind", "in front|in front of it", "in front of"),
    (f"^({THINGS}) {_IS} not ({PLACE} {THING}) yet \\. (?:please )?(?:change|fix) (?:that|this|it)(?= \\.|$)",
     "put {1} {2}"),
    (f"^({THING}) {_IS} ({PLACE} {THING}){_NOW}(?: ,)? but must not (?:be )?(?:there )?(?:at|in) the end(?= \\.|$)",
     "at the start {1} is {2} . {1} must not be {2}"),
    (f"^(?:at some point(?: ,)? )({THING}) {_HAS_TO} be ({PLACE} {THING})(?: ,)? but not (?:at|in) the end(?= \\.|$)",
     "first , put {1} {2} . then , {1} must not be {2}"),
    (f"^({THING}) must end up where it started(?: ,)? but {_HAS_TO} be ({PLACE} {THING}) at some point(?= \\.|$)",
     "first , put {1} {2} . then , put {1} back where it started"),
    ("^((?:build|make|form|stack) [^.]+?) at some point(?: ,)? (?:but|and) (?:finish|end|end up) with ([^.]+)(?= "
     "\\.|$)",
     "first , {1} . then , {2}"),
    ("^([^.]+) \\. take it off before you (put|place|set|move|bring) ([^.]+)(?= \\.|$)",
     "{1} . first , take it off . then , {2} {3}"),
    (f"^({_ONE}) (?:is|lies|stands) (upright|upside down|the right way up|on its head)(?: on the table)? \\. "
     "(turn|rotate|flip|give) it\\b",
     "at the start {1} is {2} . {3} {1}"),
    (f"^({MANY}) ({COLOR}) (blocks|cubes) (?:are|lie|stand) (?:already )?(on (?:the|a) [^.]+?) \\. (?:add|put|bring) "
     f"({MANY}) more(?: "
     f"{COLOR})?(?: ones| blocks| cubes)?(?: there| on it| to it)?(?= \\.|$)",
     "at the start {1} {2} {3} are {4} . put {5} more {2} {3} there"),
    (f"^(?:{_SPELT}) \\. (?:please )?(?:take|remove|swap|exchange|add|move|change|rearrange|put) [^.]+? so(?: that)? "
     f"(?:{_READS} ({_WORD})|({_WORD}) is left|({_WORD}) remains)(?= \\.|$)",
     "at the start the letters spell {1} {2} {3} . at the end the letters must spell {4} {5} {6}"),
    (f"^(?:{_SPELT}) \\. (?:please )?(?:make|let) (?:it|that|them) (?:be )?(?:read|spelled|spell) (?:from right to "
     "left|backwards|"
     "the other way (?:round|around))(?= \\.|$)",
     "at the start the letters spell {1} {2} {3} . at the end the letters must spell {1} {2} {3} from right to left"),
    (f"^(?:{_SPELT}) \\. (?:please )?(?:make|turn|change|convert) (?:it|that|them|this) (?:into )?({_WORD})(?= \\.|$)",
     "at the start the letters spell {1} {2} {3} . at the end the letters must spell {4}"),
)  # fmt: skip
"""Over a whole text: what is looked for, and what is said instead."""

_TOP = (
    "(?:(?:pointing|facing|turned) )?(?:to|towards?|at|on|to the side of) "
    "(the (?:left|right|front|back)|me|us|the viewer)"
)
WITH_ITS_TOP: tuple[Turn, ...] = (
    (f"^({_ONE}) (?:lies|is|stands|has|{MUST} (?:lie|be|stand|have))(?: lying| turned| placed)?(?: with)? its top "
     f"{_TOP}$",
     "{1} must be turned with its top to {2}"),
    (f"^(?:turn|rotate|place|put|lay) ({_ONE}) (?:so(?: that)?|such that|with) its top (?:is |points |faces |looks "
     f")?{_TOP}$",
     "{1} must be turned with its top to {2}"),
    ("\\bthe way (it|they) (is|are|was|were)$", "as {1} {2}"),
)  # fmt: skip
"""The same in every sentence."""
ORDER_CHANGED: tuple[Turn, ...] = (
    (f"^change (?:the order of )?the ({LINE}) from ({LIST}) to ({LIST})(?: ,)?(?: \\()?(?: ({UP}))?(?: \\))?$",
     "at the start there is a {1} : {2} {4} . build a {1} : {3} {4}"),
    (f"^in (?:the|an?) ({LINE})(?: of)? ({LIST})(?: ,)?(?: ({UP}))? , (?={_SWAP} )",
     "at the start there is a {1} : {2} {3} . "),
    (f"^({_SWAP} (?:the (?:positions|places) of )?the \\w+ (?:and|with) (?:the )?\\w+(?: blocks?| cubes?| ones?)?) "
     f"(?:in|of) (?:the|an?) ({LINE})(?: of)? ({LIST})(?:(?: ,)? ({UP}))?$",
     "at the start there is a {2} : {3} {4} . {1}"),
    ("\\b(empty|clear|free) again$", "{1}"),
    (f"\\b(?:they|these|those|the (?:blocks|cubes|letters|digits|numbers)) {_HAS_TO} (?:be|stand|go|end up)(?: as| in "
     f"the order)? ((?:{LABEL}(?: ,| and| , and) )+{LABEL}) (from left to right|from right to left)$",
     "{1} must be in a row {2}"),
)  # fmt: skip
"""In every sentence: what is done to a line, and which one it is."""
WORDS = ("yet moment point finish reversal inversion inverting reversing dismantling unstacking",)
"""Words that these take besides those that are read anyway."""
