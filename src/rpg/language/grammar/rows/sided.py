"""What lies at the sides of a block, and which of all is beyond the others, in other orders of words, as rows that name
the block and its side."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, ME, MUST

_NO = (
    "(?!(?:on|in|to|of|with|behind|and|or|not|at|from|by|for|that|which|if|is|are|has|left|right|between|then|must"
    "|sits?|stands?|lies?|goes|go|comes?|belongs?|be|it|its|table|row|line|column|grid|half)\\b)"
)
_T = f"{_NO}[^ ,:;]+(?: {_NO}[^ ,:;]+){{0,3}}"
_IS = f"(?: (?:{MUST} )?(?:is|are|be|stands?|sits?|lies?|goes|go|comes?|belongs?))?"
_PUT = "(?:put|place|set|move|have|get|bring|i want|i would like)"
_R = "(?:immediately |directly )?(?:behind|in front of|(?:to the )?left of|(?:to the )?right of)"
_ONE = f"((?:the )?(?:{COLOR}|\\S+ (?:block|cube|one)|\\w))"
_AND = "(?: ,)?(?: and)?"
_HAS = f"(?:has|have|{MUST} have)"
_ON_ITS = "(?:on|to) (?:its|the)"
_BLOCKS = "(?:blocks|cubes|ones)"
_GOES_ON = f"(?={_AND} {_T}{_IS} (?:{_R} it|(?:to|on) its (?:left|right))\\b)"
_RIGHT_ON = "(?:one )?(?:on |to )?(?:its|the) right(?: side)? , (?:one )?in front"
_AROUND = f"(?:on|to) (?:its|the) left(?: side)? , {_RIGHT_ON}"
_BEHIND = "(?: of it)?(?: ,)? and (?:one )?behind(?: it)?$"
_ALL_SIDES = (
    "a {1} block must be to the left of {0} , a {1} block to the right of {0} , a {1} block in front of {0} and a {1} "
    "block behind {0}"
)
_PLACED = "block|cube|one|it|stands?|goes|comes|is"
_LETTER = "(the (?:first|last) (?:letter|digit)|the [a-z]|the word \\w{2,})"
_FAR = "(?:farthest|furthest)"
_MOST = (f"(?:leftmost|rightmost|frontmost|(?:nearest|closest)(?: to {ME})?|{_FAR}(?: away)?(?: from {ME})?|"
         "topmost|uppermost|lowest|bottommost)")  # fmt: skip
_ONES = "(?: one| block| cube)?"
_MUST_BE = f"(?:is|{MUST} be)"

_WHICH_IS = "(?:(?:that|which) (?:is|lies|points|faces) )?"
_OFF_ME = f"(?:(?:away|{_FAR}|farther|further)(?: away)?|opposite) from {ME}(?! than)"
_AT_ME = f"(?:(?:nearest|closest|nearer|closer|near|close)(?: to)? {ME}|(?:facing|towards?|next to) {ME})(?! than)"
_TT = f"(?:(?:the|an?) (?:tower|stack) of {MANY} \\w+ {_BLOCKS}|{_T})"
_TOUCH = (
    (f"({MUST}) touch", "{1} be touching", 2), ("touches", "is touching", 1),
    ("(?:touching|(?:up )?against)", "touching", 1),
)  # fmt: skip
"""How it is told that something is touched, what is said instead, and the group that stands behind it."""
_POINTING = "(?:point(?:ing|ed|s)?|fac(?:ing|es)|open(?:ing|s)?|(?:going|leading) up|rising|climbing)"
_TOWARDS = (
    ("left", "left"),
    ("right", "right"),
    (f"(?:away from {ME}|back|rear|backwards?)", "(?:far|back)"),
    (f"(?:towards? {ME}|front|forwards?)", "(?:near|front)"),
)
"""How a direction is told, and the edge that lies there."""
_MINE = "(?:on|to) my {side}(?: side| hand| hand side)?"

SIDED_AT_ONCE: tuple[Turn, ...] = (
    # a direction told twice: "pointing to the left, towards the left edge" is no place
    *((f"\\b({_POINTING} (?:to the )?{way}) , towards? the {edge} (?:edge|side|end)(?: of the table)?\\b(?! of)", "{1}")
      for way, edge in _TOWARDS),
    # which side of it is touched
    *((f"\\b{touch} (the (?:left|right|front|back|near|far) (?:side|face) of (?=\\w))", f"{said} {{{n}}}")
      for touch, said, n in _TOUCH),
    *((f"\\b{touch} ({_TT}) (?:on|from|at) the (left|right|front|back|near|far)(?: side)?$",
       f"{said} the {{{n + 1}}} side of {{{n}}}") for touch, said, n in _TOUCH),
    (f"\\b(?:up )?against ({_TT}) from (?:behind|the back)$", "touching the back side of {1}"),
    # the far side and the near one, told by who looks on
    *((f"\\b(?:on|at|to) the side of ({_TT}) {_WHICH_IS}{seen}", f"on the {side} side of {{1}}")
      for side, seen in (("far", _OFF_ME), ("near", _AT_ME))),
    *((f"(?: ,)?(?: but)? (?:on|at|to) (?:the|its) side {_WHICH_IS}{seen}", f"on the {side} side")
      for side, seen in (("far", _OFF_ME), ("near", _AT_ME))),
    # each on one side of who looks on, where it is no side of one another
    *((f"^(?!.*\\b(?:row|line|next|between|beside|side by side)\\b)(.+?) {_MINE.format(side=one)}(?: ,)?(?: and| "
       f"while) (.+?) {_MINE.format(side=other)}$", f"{{1}} in the {one} half , and {{2}} in the {other} half")
      for one, other in (("left", "right"), ("right", "left"))),
    # at the sides of the same block
    (f"^(?:put |place |set )?(?:an?|one) ({COLOR})(?: block| cube) to the left of (the [^,]+) , {_RIGHT_ON}{_BEHIND}",
     _ALL_SIDES.format("{2}", "{1}")),
    (f"^(?:{_PUT} )?({_T}){_IS} ((?:(?:on|to|at) the )?)(left|right)(?: ,)?(?: and)? ({_T}){_IS} \\2(?!\\3)(left|"
     f"right) of ({_T})$", "{1} must be to the {3} of {6} and {4} to the {5} of {6}"),
    (f"^((?:.+? )?{_R} {_ONE}{_AND} {_T}{_IS}) (?:to|on) its (left|right)(?: side)?{_GOES_ON}",
     "{1} to the {3} of {2}"),
    (f"^((?:.+? )?{_R} {_ONE}{_AND} {_T}{_IS} {_R}) it{_GOES_ON}", "{1} {2}"),
    (f"^(.* {_R} {_ONE}{_AND} {_T}{_IS} {_R} \\2{_AND} {_T}{_IS}) (?:to|on) its (left|right)(?: side)?\\b",
     "{1} to the {3} of {2}"),
    (f"^(.* {_R} {_ONE}{_AND} {_T}{_IS} {_R} \\2{_AND} {_T}{_IS} {_R}) it\\b", "{1} {2}"),
    (f"^surround (the .+?) (?::|with|by) (?:an?|one) ({COLOR})(?: block| cube| one)? {_AROUND}{_BEHIND}",
     _ALL_SIDES.format("{1}", "{2}")),
    (f"^(the .+?) {_HAS} (?:an?|one) ({COLOR})(?: block| cube| one)? {_AROUND}{_BEHIND}",
     _ALL_SIDES.format("{1}", "{2}")),
    ("^with (.+? (?:to|on) its (?:left|right)) and (.+? (?:to|on) its (?:left|right)) , (the .+?) (?:stands?|is|"
     f"{MUST} be|lies|sits)(?: in the middle| in between| between them)?$", "{3} must have {1} and {2}"),
    (f"\\bflanked by (?:an?|one) ({_T}) (?:on|to) (?:its|the) left(?: side)?(?: ,)? and (?:by )?({_T}) (?:on|to) "
     "(?:its|the) right(?: side)?(?=$| , and )", "between a {1} and {2} , the {1} on the left"),
    (f"\\bflanked by ({_T}) (?:on|to) (?:its|the) left(?: side)?(?: ,)? and (?:by )?({_T}) (?:on|to) (?:its|the) "
     "right(?: side)?$", "between {1} and {2} , {1} on the left"),
    (f"^(?:i (?:want|would like|need)(?: to see)? |there (?:is|{MUST} be) |put |place )?(an?|the) ({_T}) between two "
     f"({COLOR})s?(?: {_BLOCKS})? ,(?: with)? one {_ON_ITS} (left|right)(?: side)?{_AND} (?:one|the other|another)(?: "
     f"one)? {_ON_ITS} (left|right)(?: side)?$",
     "{1} {2} must be between two {3} blocks . one of them must be to the {4} of the {2} and the other one to the "
     "{5} of the {2}"),
    (f"\\b(one|an?) ({COLOR}) (block|cube|one) ({_ON_ITS} left(?: side)?(?: of it)?)(?: ,)? and another(?: one)? "
     f"({_ON_ITS} right)\\b", "{1} {2} {3} {4} and another {2} {3} {5}"),
    (f"\\b({_T} (?:on|to) the left)(?: ,)? ({_T} (?:on|to) the right) and ({_T}) (?:in between|in the middle)$",
     "{1} , {2} and {3} in between"),
    # all of these at the side of all of those
    (f"^(?:each|every one|all) of the ({MANY} \\w+ {_BLOCKS}) {_HAS} (?!an? |one )(.+?)( somewhere)? (?:to|on) (?:its|"
     "their) (left|right)(?: side)?$", "{2} must be {3} to the {4} of the {1}"),
    ("^(?:move|arrange|place|sort|put|rearrange|lay out) (?:the|these) (?:cubes|blocks) so that (?!.*\\b(?:they|them|"
     f"it)\\b)((?:every one of |each of |all |all of )?(?:the )?{MANY} \\w+ {_BLOCKS} .+ {MANY} \\w+(?: "
     f"{_BLOCKS})?.*)$", "{1}"),
    (f"^with ({MANY} \\w+ {_BLOCKS} and {MANY} \\w+ {_BLOCKS}) on the table , (.+)$", "there are {1} . {2}"),
    # the place ahead
    (f"^(?:right |immediately |directly )?next to {_ONE} on (?:the|its) (left|right)(?: side)?(?: ,)? (?:put|place|"
     f"set|goes|is|stands|comes|lies) ({_T})$", "{3} must be immediately to the {2} of {1}"),
    (f"^({_T}) 's (left|right)(?: - hand| hand)? side is where ({_T}) (?:goes|belongs|{MUST} be|{MUST} go|is|stands)$",
     "{3} must be to the {2} of {1}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
UTMOST_TOLD: tuple[Turn, ...] = (
    # "next to it, but on the left"
    ("\\b((?:next to|beside|adjacent to|touching|near|close to) .+?)(?: ,)? but (on the (?:left|right|far|near)(?: "
     "side)?)$", "{1} , {2}"),
    *((f"\\b(?:the )?{_FAR}{_ONES} (?:(?:out )?(?:to|towards|on|at) the )?{side}(?= ,| and| of| among|$)",
       f"{side}most")
      for side in ("left", "right")),
    # which one of a row that is known
    *((f"\\bthe {side} (block|cube|one)(?= of (?:the|that|this) (?:row|line)\\b)", f"the {side}most {{1}}")
      for side in ("left", "right")),
    # which one of two that were told of
    ("\\bthe (shorter|taller|higher|lower|upper|smaller|bigger|larger|longer|left|right|front|back|nearer|farther)(?: "
     f"one)? of (?:the|these|those) two(?=$| ,| and| {MUST}| is| goes| stands)", "the {1} one"),
    # in a row that is to be made, no one that is there
    (f"^(.+?) {_MUST_BE} (?:the )?({_MOST}){_ONES} (?:of|among|out of|from) (?!an? \\w)(.+?) (in an? [^,]*\\b(?:row|"
     "line|column)(?: on .+)?)$", "{3} must be {4} with {1} {2}"),
    (f"^(.+?) ({_MUST_BE}) (?:the )?({_MOST}){_ONES} (?:of|among|out of|from) (?!an? \\w)(.+)$",
     "there are {4} . {1} {2} {3}"),
    # in a word, which is read from left to right
    *((f"\\b({_PLACED}) {how}{where} {_LETTER}(?=$| ,| and| \\.)", f"{{1}} {near}to the {side} of {{2}}")
      for how, near in (("(?:right |directly |just |immediately )", "immediately "), ("", ""))
      for where, side in (("after", "right"), ("before", "left"))),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("belongs flanked forward precedes surround",)
"""Words that these take besides those that are read anyway."""
