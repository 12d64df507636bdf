"""Grids and pyramids whose parts are told by where they are, "a red column on the left", "the row nearer to me", "a
base of 2x2 and one on top in the middle", as rows that name each part by its place."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LINE

_SIDE = "(?:left|right|middle|center|front|back|near|far)"
_NEAR = "(?:nearer|nearest|closer|closest) to (?:me|you|us|the viewer|the robot)"
_BE = "(?:is|are|must be|should be)"
_LATERAL = f"(?:{_BE} )?(?:on|at|in|to) the"
_ONE_AND_OTHER = f"\\b(grid\\b.*?) one (column|row) (?:{_BE} )?(\\w+)(?: ,)? and the other(?: one)? (?:{_BE} )?(\\w+)"
_THE_FIRST = "(?: ,| with|;)+ the \\3 (?:column|row|one)"
_ROW_AND_OTHER = f"({_BE} )?(?:all )?(\\w+)(?: ,)? and the other(?: one| row)? ({_BE} )?(?:all )?(\\w+)$"

_SPOT = "(?:to the left of|to the right of|left of|right of|in front of|behind|next to|beside)"
_BASE = "(\\d+x\\d+|(?:\\d+|two|three) by (?:\\d+|two|three))"


TOLD_SHAPES: tuple[Turn, ...] = (
    # grids
    (f"^(.*\\bgrid\\b[^,]*?) (?:has|must have|should have) (the {_SIDE} (?:row|column) \\w+)\\b", "{1} with {2}"),
    ("\\b(grid) with (\\w+)(?: blocks| ones)? on the left and (\\w+)(?: blocks| ones)? on the right$",
     "{1} with the left column {2} and the right column {3}"),
    (f"\\b(grid\\b.*) the row {_NEAR} {_ROW_AND_OTHER}", "{1} the near row {2} {3} and the far row {4} {5}"),
    (f"{_ONE_AND_OTHER}{_THE_FIRST} {_LATERAL} left$", "{1} the left {2} {3} and the right {2} {4}"),
    (f"\\b(grid) (?:in which|where|whose) ((?:{FEW})) (?:blocks |cubes |of them )?{_BE} (\\w+)(?: ,)? and the "
     f"(?:center|middle)(?: one| block| cube) (?:{_BE} )?(\\w+)$",
     "{1} of {2} {3} blocks with a {4} block in the center"),
    ("\\b(grid with .+?) , the (\\w+) ones in the (\\w+) row and the (\\w+) ones in the (\\w+) row$",
     "{1} , {2} in the {3} row and {4} in the {5} row"),
    # towers and rows
    (f"\\b(towers [^,]+ , one ({COLOR})(?: ,| and)? one ({COLOR}))(?: ,|;| with)+ (?:the )?\\2(?: one| tower)? "
     f"(?:{_BE} |stands )?({_SPOT}) (?:the )?\\3(?: one| tower)?$", "{1} . the {2} tower must be {4} the {3} tower"),
    (f"^(an? {LINE} of .+?) in front(?: ,| and)+ (an? {LINE} of .+?) behind(?: it)?$", "{1} and {2} behind it"),
    (f"^rainbow ({LINE})(?: :| of| ,| with)+ (.+ (?:blocks|cubes)|.+ , (?:starting|beginning) .+)$",
     "a rainbow {1} of {2}"),
    (f"^({FEW}|\\d+) (?:blocks )?high , (alternating .+)$", "a tower of {1} blocks , {2}"),
    (f"\\bthat (?:does not|must not|should not|may not) have (?:the )?({COLOR})(?: one| block| cube)? (at the top|on "
     "top|at the bottom)$", "with {1} not {2}"),
    ("(?: ,)? with the (\\w+) group (in|on|to|behind|next|near|left|right) (.+?) and the (\\w+) group (in|on|to|behind|"
     "next|near|left|right) (.+)$", " . the {1} group must be {2} {3} . the {4} group must be {5} {6}"),
    (f"^(?:stack|pile up|start with|begin with) (?:an? |the |one )?({COLOR})(?: block| cube| one)? , (?:then |and "
     f"then |next |and )?(?:put |place |set |stack )?((?:an? |the |one |another )?{COLOR}(?: block| cube| one)? on "
     "(?:it|that|top of it|that one)\\b.*)$", "there is a {1} block . put {2}"),
    # letters
    ("^(?:make|build) a (?:tower|stack) of (?:the |some )?letters?(?: blocks| cubes)? (?:so that|that|such that)(?: "
     "from top to bottom)?(?: it| they)? (?:says?|spells?|reads?) (\\S+)(?: from top to bottom)?$",
     "stack letter blocks so that they read {1} from the top down"),
    ("\\b(?:show|have|take) the shape of (?:the |a )?(?:letter )?(\\w)\\b", "form the letter {1}"),
    ("\\b(?:so that|so) they look like (?:the |a )?(?:letter )?(\\w)\\b", "so that they form the letter {1}"),
    # what there is
    (f"^(?:the )?({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR} (?:blocks|cubes)) : ((?:put|stack|place|build|make|"
     "arrange|line|move|set|lay) .+)$", "there are the {1} . {2}"),
    # pyramids
    (f"\\b(pyramid of [^,:]+?) (?:in which|where) the base(?: of \\w+)? {_BE} (\\w+) , the (?:second|middle) layer "
     f"(?:{_BE} )?(\\w+)(?: ,)? and the (?:tip|top|topmost block) (?:{_BE} )?(\\w+)$",
     "{1} : the base {2} , the second layer {3} , the tip {4}"),
    (f"\\b(an?|one) (pyramid with (?:an? )?{_BASE} base)(?: ,| and| with)+ (?:an?|one|a single) (block|cube) (on "
     f"top)(?: of it)?(?: ,| and)+ (?:they are )?all(?: of them)?(?: (?:block|cube)s)?(?: in)? ({COLOR})$",
     "{1} {6} {2} and one {4} {5}"),
    # sides and outlines
    (f"\\b((?:triangle|square|rectangle|pentagon|hexagon|outline)\\b.*?(?:{FEW}|\\d+)(?: \\w+)? (?:blocks|cubes)) "
     "(?:along|on|in|at|to|for) (?:every|each)(?: one)?(?: of its)? (?:side|edge|sides|edges)$", "{1} per side"),
    ("^(.*?\\b)(?:the )?outline of an? (rectangle|square)(?: ,)? ([^,]*\\b(?:wide|long|deep|high|by)\\b[^,]*?)(?: ,)? "
     f"(?:in|from|out of|made of|using|with) ((?:{FEW}|\\d+) (?:\\w+ )?(?:blocks|cubes))$",
     "{1} the outline of a {2} of {4} , {3}"),
    # orders
    ("\\b(grid) (?:that holds|holding|containing|which holds) (?=\\w)", "{1} of"),
    (f"^(.*\\b(?:{FEW}) (?:\\w+ )?(?:towers|stacks))(?: ,| that are| which are)?(?: respectively)? ((?:(?:{FEW}) ,? "
     f"?)+and (?:{FEW})) (?:blocks|cubes) (?:high|tall)(?: ,)?(?: respectively)?$", "{1} of {2} blocks"),
    ("^(?:slip|slide|squeeze|insert|wedge|fit|tuck|push) (.+?) (?:in )?between (?=\\w)", "put {1} between"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
