"""How two things lie to each other, told by what one is for the other, by its part in a contrast, or with their names
first, as rows that say it plainly: "the blue one serves as a base for the red one", "red and blue, green between"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import ASIDE, IS, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MUST, PATCH

_BASE = f"as (?:a|an|the|its) (?:base|support|stand) (?:for|of(?= {THING}))"
_TO = "(?:(?:on |to )?(?:the |its )?)"
_SIDES = f"{_TO}left and {_TO}right"
_SET_DOWN = f"{PUT}(?: it)?(?: down)?"
_BY = f"(?:{ASIDE}|next to|beside)"
_ONE = f"(?:the |an? )?({COLOR})(?: {CUBE}| one)?"
_AREA = f"(?:on|in|into|onto) the (?:{COLOR} {PATCH}|(?:left|right|near|far|front|back) half(?: of the table)?)"
_YOU = "(?:you|we)"
_TASK = "(?:the|my|your|our) (?:task|job|goal)"
_DONE = "(?:done|finished|ready|solved|complete|completed|accomplished|reached|achieved|over)"

RELATED_AT_ONCE: tuple[Turn, ...] = (
    # what is taken and where it goes
    (f"^(?:locate|look for|search for) ({THING})$", "find {1}"),
    (f"^(?:bring|move|carry|take) ({THING})(?: over)? to ({THING}) and (?:then )?{_SET_DOWN} ({PLACE}) it$",
     "put {1} {3} {2}"),
    (f"^({PUT}|take|lift|get) ({THING}) off (?:of )?the table(?: ,)?(?: and)?(?: {_SET_DOWN})? (?=on(?:to)? )",
     "{1} {2} "),
    (f"^make ({THING}) the (?:one|{CUBE}) (?={PLACE} )", "put {1} "),
    (f"^use ({THING}) as (?:a|the) base(?: ,)? and ({PUT}|stack) ({THING}) (?:on|on top of) it$", "{2} {3} on {1}"),
    # on one side of what is told of, or on another
    (f"^(.+?) (?:either )?({_BY}) ((?:an?|one) (?:(?!\\bor\\b)[^,:])+?)(?: ,)? or (?:else )?(?:(?:it|they) {IS} )?"
     f"({_BY}) (?:it|that)$", "{1} {2} or {4} {3}"),
    # how it is when all is done
    (f"^(?:when|once|if|as soon as) (.+?) , (?:then )?(?:{_YOU} are {_DONE}|{_TASK} is {_DONE})$", "{1}"),
    (f"^{_YOU} (?:will|should|must) (?:find|see) ({THING}) ({PLACE} .+?)(?: ,)? (?:when {_YOU} are {_DONE}|at the end|"
     "in the end|afterwards)$", "{1} must be {2}"),
    # on which sides, and which one
    ("\\b(left|right) (front|back|near|far|rear)(?= corner\\b)", "{2} {1}"),
    ("\\b(?:exactly|directly) in line between ", "collinear between "),
    ("\\bon its left(?: side)?(?: ,)? and on its right(?: side)?$", "on its left and right"),
    (f"\\b(?:on|at|to) (?:each|either|both) sides? of ({THING})(?: ,)? {_SIDES}$", "to the left and right of {1}"),
    (f"\\bthe other (?:one|{CUBE}) , (?:which|that) is (?:an? )?({COLOR})(?: one| {CUBE})?(?= ,)",
     "the other one , the {1} one"),
)  # fmt: skip
"""What is read otherwise as it stands, or could be meant in several ways."""
RELATED: tuple[Turn, ...] = (
    (f"^the {CUBE} (on|in) (the (?:{COLOR} )?{PATCH}) is ({COLOR})$", "the {3} block is {1} {2}"),
    (f"^(?:{PUT} )?{_ONE} (?:{IS} )?({_AREA})(?: ,)? and {_ONE} (?:{IS} )?({_AREA})(?: ,)? or (?:the other "
     "way (?:round|around)|vice versa|the reverse)$",
     "either the {1} block must be {2} and the {3} block must be {4} , or the {1} block must be {4} and the {3} block "
     "must be {2}"),
    (f"^((?:(?:build|make|form) )?an? (?:(?!{PLACE} )[^,])+?)(?: ,)? ({PLACE}) which (?:there )?"
     "(?:is|are|stands?|lies?|sits?) (an? .+)$", "{1} with {3} {2} it"),
    # what one is for the other
    (f"\\b({MUST}) (?:serve|act|function|be used|work) {_BASE}\\b", "{1} support"),
    (f"\\b(?:serves|acts|functions|is used|works) {_BASE}\\b", "supports"),
    (f"^use ({THING}) {_BASE} ({THING})$", "{1} must support {2}"),
    # what is between two that were named
    (f"^(?:{PUT} )?({THING})(?: ,)? and ({THING})(?: ,)? (?:and )?(?:in between|between them) ({THING})$",
     "{3} must be between {1} and {2}"),
    (f"^(.+?)(?: (?:strictly|exactly|directly))? between (.+?)(?: ,)?(?: so| such)? that (?:all (?:three|of them)|the "
     f"three|they)(?: {CUBE}s)? (?:are|lie|stand) collinear$", "{1} collinear between {2}"),
    (f"^(?:would|could|will|is) it (?:be )?(?:possible|okay|ok|fine) for ({THINGS}) to (?=\\w)", "{1} must "),
    # which alone
    (f"^as for ({THING}) , (?:it|this one|that one) ", "{1} "),
    ("^(there (?:is|are) [^,]+) , ((?:(?:exactly|at most|at least) )?(?:one|two|three|none)) of which ",
     "{1} . {2} of them "),
    (f"^only ({THING})(?: ,)?(?: and)? not ({THING})(?: ,)? ({IS} .+)$", "only {1} {3} , not {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("locate collinear",)
"""Words that these take besides those that are read anyway."""
