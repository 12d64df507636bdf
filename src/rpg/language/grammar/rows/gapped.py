"""A second part that leaves out what the first one said, "... on the mat, and after that the red one as well", where
each began, sides told beside one thing, "two and no more", as rows that say all of it."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import ASIDE, BLOCK, IS, LABEL, PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import (
    AND,
    COLOR,
    CUBE,
    FEW,
    LENGTH,
    LIES,
    LINE,
    MANY,
    MUST,
    PATCH,
    WAY,
)  # fmt: skip

_MARK = f"(?:(?:on|onto|in|into|inside) (?:the|an?|my|that|this) (?:\\w+ ){{0,2}}(?:{PATCH}|table|half|corner))"
_AFTER = "(?:only then|only after that|only afterwards|after (?:it|that|this)|only after it)"
_LATER = f"(?:{_AFTER}|then|afterwards|next|thereafter|subsequently)"
_TOO = "(?: as well| too| also| there)"
_BLOCKS = "(?:blocks?|cubes?|bricks?)"
_NAMED = f"(?:the|an?|my|{FEW}) (?:\\w+ ){{0,2}}{_BLOCKS}"
"""A block that is called one, and is no patch."""
_BEGAN = ("(?:is|was|stands|stood|starts|started|begins|began|lies|lay|sits|sat)"
          "(?: now| at first| before| initially| originally| (?:at|in) the (?:start|beginning))?")  # fmt: skip
_ENDS = f"(?:(?:{MUST} )?(?:end up|ends up|end|ends|finish|finishes|be|go|stand|lie|come)|goes|belongs)"
_ONE = f"(?:{_BLOCKS}|one)"
_OTHER = f"the other(?: one| {BLOCK})?"
_AT_START = "(?:at|in) the (?:start|beginning)|initially|originally|at first|now|currently"
_LIES_ON = "(?:lies|stands|sits|rests|is(?: now)?(?: lying| standing| sitting| resting)?)(?: now)? on"
_AT = "((?:to|on) the (?:left|right)|left|right|in front)(?: of it)?"
_KIND = "vowels|consonants|letters|digits|numbers|odd|even"
_ALONE = "(?:(?! and )[^,])*?"
_IT = f"(?:(?:that|this|the) {LINE}|it|that)"
_MORE = "(?:no|not) more"
_JUST = f"{_MORE}(?:(?: and| ,| or|) (?:no|not) (?:less|fewer))?"
_DISTRACT = "(?:only |just |merely )?as (?:mere )?(?:a )?distractors?"
_THERE = "(?: on the table| around| nearby| there| present)"
_BESIDE = "(?:relative to|in relation to|with respect to|with reference to|with regard to)"
_PART = "(?:separate|divide|sort|split|part|group)"
_SYMBOLS = "(?:\\w(?: , \\w)*(?: ,)? and \\w|\\d (?:to|through) \\d)"
_ONTO = "(?:go |must go |must be |are )?(?:onto|on|into|in|to)"
_HERE = f"(?:the|my) (?:\\w+ ){{0,2}}{PATCH}"

_GAP = "gap|distance|space|spacing|separation"
_ABOUT = "(?:about|around|roughly|exactly|precisely|at least|at most|no more than|no less than|more than|less than)"


GAPPED_AT_ONCE: tuple[Turn, ...] = (
    # two kinds of symbols
    (f"^(?:please )?{_PART} (?:the )?({_KIND})(?: ones)? (?:from|and) (?:the )?({_KIND})(?: ones)? (?:among|amongst|"
     f"of|out of|from among|in) (?:the (?:letters|symbols|digits|numbers|blocks|cubes) )?({_SYMBOLS})$",
     "separate {3} into {1} and {2}"),
    *((f"^(?:(?:take|get|use) ([^:]+?) and (?:sort|separate|divide) them|(?:sort|separate|divide) (?:them|these|those|"
       f"([^:]+?))) [:,] (?:the )?({kind}){ones} {_ONTO} ({_HERE})(?: ,| and|;)+ (?:the )?({kind}){ones} {_ONTO} "
       f"({_HERE})$",
       f"there are {{1}} {{2}} . the {{3}} {said} must be on {{4}} and the {{5}} {said} must be on {{6}}")
      for kind, ones, said in (("odd|even", "(?: ones| numbers| digits)?", "ones"),
                               ("vowels|consonants|letters|digits|numbers", "", ""))),
    # where it is at first
    (f"^({_ALONE}\\b(?:the|an?) {_ALONE}) , (?:{_AT_START}) ({PLACE} [^,]+?) , (.+)$", "{1} , which starts {2} , {3}"),
    # all in one row
    (f"^({WAY}) : (.+?) , (?:all )?in (?:a|one|the same|a single) (?:straight |single )?(row|line|column)$",
     "a {3} {1} : {2}"),
    (f"^(?:going |reading |counting |counted |read |looking )?({WAY})(?: ,)? ((?:\\d+ , )+(?:\\d+ ,? ?)?and \\d+) "
     f"((?:{MUST} )?(?:stand|be|lie|are|go)) in (\\w+ order)$", "{2} {3} in {4} {1}"),
    # one gap and another
    (f"\\b({_GAP}) (.+? between .+?)( ,| and| , and) (?:another(?: one| \\1)?|one|a second(?: one| \\1)?) of "
     f"((?:{_ABOUT} )?{LENGTH}) between\\b", "{1} {2} {3} a {1} of {4} between"),
    # one of two
    (f"\\beither (?:({COLOR}) )?{PATCH}\\b(?!.* or )", "either of the two {1} patches"),
    (f"\\bneither (?:({COLOR}) )?{PATCH}\\b(?!.* n?or )", "neither of the two {1} patches"),
    # a block that is lifted off what it lies on: on a patch it could still lie on that
    (f"^(?:carefully |gently |slowly |please )*(?:lift|pick|take|remove)(?: up)? (?=the )({THING})(?: up)? off "
     f"(?=the )(?!the [a-z ]*{PATCH} and)({THING})(?: ,)? and (?:then )?((?:set|put|place|lay) it (?:down )?"
     f"(?:on|onto) (?:the|a) [a-z ]*{PATCH})$",
     "at the start , {1} is on {2} . {3} . {1} must not be on {2}"),
    (f"^(?:carefully |gently |slowly |please )*(?:lift|pick|take|remove)(?: up)? ({THING})(?: up)? off ({THING})(?: "
     f"(?:that |which )?it {_LIES_ON})?(?: ,)? and (?:then )?((?:set|put|place|lay) it (?:down )?(?:on|onto|to|next|"
     "in|behind|beside) .+)$", "at the start , {1} is on {2} . {3}"),
    # what is there at the start
    (f"^({THING}) , (?:(?:which|that) ({THINGS}) (?:occupy|occupies|cover|covers)|(?:which|that) (?:is|are) "
     f"(?:occupied|covered) by ({THINGS})|(?:on|in) which ({THINGS}) {LIES}) (?:{_AT_START}) , (.+)$",
     "at the start , {2} {3} {4} is on {1} . {1} {5}"),
    (f"^({THINGS}) (?:occupy|occupies|cover|covers) ({THING}) (?:{_AT_START})$", "at the start , {1} is on {2}"),
    # each where the other was
    (f"^(?:{PUT} )?the ({COLOR})(?: {_ONE})?(?: {_ENDS})?(?: to)? where the ({COLOR})(?: {_ONE})? {_BEGAN}{AND}? "
     f"?(?:the \\2(?: {_ONE})?(?: {_ENDS})?(?: to)? where (?:the \\1(?: {_ONE})?|{_OTHER})(?: {_BEGAN})?|vice versa)$",
     "the {1} block and the {2} block must swap places"),
    (f"^(?:(?:at|in) the end ,? ?)?each(?: one| of (?:them|the two)| {BLOCK})? {MUST} (?:be|stand|lie|end up|end) "
     f"where {_OTHER} {_BEGAN}$", "they must swap places"),
    # a line behind another
    (f"^(?:{PUT} )?({THINGS}) in an? ({LINE})(?: ,)? and ({ASIDE}) {_IT} another(?: one| {LINE})?(?: ,)? (?:made "
     ")?(?:of|from|with|out of) (.+)$", "a {2} of {1} and {3} it a {2} of {4}"),
    (f"^(an? ({LINE}) of {THINGS})(?: ,)? and ({ASIDE}) {_IT} another(?: one| {LINE})?(?: ,)? (?:made )?(?:of|from|"
     "with|out of) (.+)$", "{1} and {3} it a {2} of {4}"),
    # so many
    (f"^({FEW}) , {_JUST} , ({MUST} .+)$", "exactly {1} of them {2}"),
    (f"\\b({FEW}) (of [^,]+?)(?: ,| and|) {_JUST} , (?=\\w)", "exactly {1} {2}"),
    ("(?<!either )\\bone or two (of (?:them|these|those|the))\\b", "at least one and at most two {1}"),
    # a second step that leaves out where
    (f"^(on(?:to)? {_HERE})(?: ,)?(?: please)?(?: :| ,)? (?:first )?({THING}){AND}? ?{_LATER} ({THING})(?: please)?$",
     "first put {2} {1} , then put {3} {1}"),
    (f"^(?:first ,? ?)?{PUT} ({THING}) ({_MARK})(?: first)?{AND}? ?{_LATER} (?:({_NAMED}){_TOO}?|({THING}){_TOO})$",
     "first put {1} {2} , then put {3} {4} {2}"),
    # what is between the others of it
    (f"^in (an? {LINE} (?:of|made of|made from|with) .+?)(?: ,)? ((?:the )?{COLOR}(?: {_ONE})?|{LABEL}) {IS} (?:in "
     ")?between the other (?:two|ones)$", "{1} with {2} between the other two"),
    # what is there besides
    (f"^with ({THINGS}) {_DISTRACT}{_THERE}(?: ,)? (.+)$", "{2} . {1} are distractors"),
    (f"^([^,]+) , with ({THINGS}){_THERE}? {_DISTRACT}{_THERE}?$", "{1} . {2} are distractors"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""


GAPPED: tuple[Turn, ...] = (
    (f"\\b(?:exactly|precisely) (?=(?:an?|{MANY}) {CUBE}(?: 's)? (?:widths?|lengths?|edges?)\\b)", ""),
    (f"\\b(gap of) (?:exactly|precisely) (?=(?:an?|{MANY}) {CUBE})", "{1} "),
    # a second step that leaves out where
    (f"^(?:first ,? ?)?({THING}) {IS} ({_MARK})(?: first)?{AND}? ?(?:{_AFTER} ({THING}){_TOO}?|({THING}) only after "
     "(?:it|that|this|then))$", "first {1} must be {2} , then {3} {4} must be {2}"),
    # so many
    (f"^((?:of|out of) .+?) ,? ?({FEW}) (?:,|and|but|, and|, but)? ?{_MORE}(?: than that)?(?: ,)? (?=\\w)",
     "{1} , exactly {2}"),
    (f"^(.*\\b(?:one or two|two or three|three or four|four or five|at most (?:{FEW}))\\b.*?)(?: ,)? (?:and|but) "
     f"{_MORE}(?: than that)?$", "{1}"),
    # one order or another
    (f"^{_BESIDE} ({THING}) ,? ?({THING}) {IS} {_AT} and ({THING})(?: {IS})? (behind|beside|under|above)(?: it)?$",
     "{2} must be {3} of {1} and {4} must be {5} {1}"),
    (f"^{_BESIDE} ({THING}) ,? ?({THINGS}) {IS} {_AT}$", "{2} must be {3} of {1}"),
    (f"^{_BESIDE} ({THING}) ,? ?({THINGS}) {IS} (behind|beside|under|above)(?: it)?$", "{2} must be {3} {1}"),
    (f"\\b({LINE}) (?:that|which) (?:is|reads|goes|runs)(?: ,)? ((?:{COLOR}(?: ,| and)+ )+{COLOR})(?: ,)? ({WAY})",
     "{1} of {2} {3}"),
    (f"^(?:rebuild|rearrange|restack|change|build|arrange) (?:it|them|the {LINE}|the blocks)(?: again)? (?:so|such) "
     "that (?:the|its|their) order (?:is|gets|becomes|comes out) (?:reversed|the reverse|turned around|inverted)$",
     "reverse the order"),
    # letters to be read
    (f"^(?:the )?(?:letter |digit )?(?:cubes|blocks|letters|digits) in an? (row|line)(?: ,)? (?:{MUST} )?(?:read|"
     "reads|spell|say|show)(?: the word)? (\\S+)$", "spell {2} in a {1}"),
    # what it is
    (f"^it is ((?:right |directly |immediately )?{PLACE} {THING}(?: and {THING})?) that ({THINGS}) ({MUST} (?:be|"
     "stand|lie|sit|rest|go|end up)|belongs?|goes|go)$", "{2} must be {1}"),
    (f"^it is ({THING}) that ({THINGS}) (?:{MUST} (?:be|stand|lie|sit|rest|go|end up)|belongs?|goes|go) (on|next to|"
     "behind|under)$", "{2} must be {3} {1}"),
    ("\\beither one of (?=(?:the )?two\\b)", "either of"),
    ("\\b(and|but) (?:definitely not|certainly not|absolutely not|surely not|under no circumstances|on no account|by "
     "no means|in no case) (?=the\\b|an?\\b|\\w+ (?:block|cube|one)\\b)", "{1} not"),
    (f"^({_MARK}) (?:i|we) (?:want|need|would like)(?: to see)? ({THINGS}) (?:and|but) not ({THINGS})$",
     "{2} must be {1} . {3} must not be {1}"),
    ("^(?:at|on|upon|after|right after)(?: the| each| every)? reset(?: ,)? (?=\\w)", "at the start ,"),
)  # fmt: skip
"""What makes no sense as it stands, with what it leaves out."""
WORDS = ("reference regard respect relation occupy occupies cover covers circumstances means account definitely "
         "certainly surely inverted restack legible reset slip wedge tuck versa vice "
         "occupied merely mere",)  # fmt: skip
"""Words that these take besides those that are read anyway."""
