"""Ordinary sentences in an order or with a word that others do without: headings of what follows, what is said of a
whole and once more of its parts, how a structure reads, as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, END, LENGTH, LIES, LINE, MANY, MUST, WAY

_BLOCKS = "(?:blocks|cubes|letters|digits)"
_THING = f"(?:{CUBE}|patch|mat|zone|target|area|spot)"
_ROW = "(?:far|near|front|back|first|second)"
_LEAVE = "(?:be taken (?:away|off)|be removed|be moved away|go|go away|come off|leave)"
_SIDE = "(?:to the left of|to the right of|left of|right of|in front of|behind)"
_AT_START = "(?:at the start|at the beginning|now|initially|at first)"
_THE = f"(?:the )?{COLOR}(?: {CUBE}| one)?"
_TURNED = "(?:upside - down|upside down|upright)"
_LOOK = f"(?:{COLOR}|[a-z0-9])"
_ON = "(?:next to|beside|on|between|near|under|above)"
_FACING = "(?:in|on|at|upon|on top of|to the right of|to the left of)"
_LETTERS = "(?:letter (?:blocks|cubes)|blocks|cubes|letter tiles)"

OTHERWISE_AT_ONCE: tuple[Turn, ...] = (
    # the one that is left over
    ("\\b(?:the|that) (ones?|blocks?|cubes?) (?:(?:(?:that|which) )?(?:(?:is|are|was|were|gets) )?left over|(?:that|"
     "which) (?:is|are|was|were) left|(?:that|which) remains?|remaining)(?! of\\b)", "the remaining {1}"),
    ("\\b(?:what|whatever) (?:(?:is|gets) (?:left over|left)|remains)(?! of\\b| is an? )", "the rest"),
    # headings
    ("^(?:sort|group)(?: them| the blocks| the cubes)?(?: by color)?(?: (?:onto|to|on) (?:the "
     ")?(?:mats|patches|targets|zones))? : (.+ on (?:the|an?) \\w+ (?:mat|patch|target|zone)\\b.*)$", "{1}"),
    # what there is
    ("^(?:from|with|using|out of) (the (?:letters|letter blocks|letter cubes) [^;:]+?) , (spell|write)(?: only| just)? "
     "((?:the word )?\\S+)$", "there are {1} . {2} {3}"),
    (f"^the number of (.+? {_BLOCKS}) (?:is|{MUST} be) ({MANY})$", "there are {2} {1}"),
    (f"\\b(?:the|that) ({_THING}) (?:with (?:the )?color ({COLOR})|with (?:the )?({COLOR}) color|(?:which|that) is "
     f"({COLOR})(?= (?:on|onto|in|into|next|to|behind|under)\\b|$))(?= |$)", "the {2} {3} {4} {1}"),
    # words
    (f"^the word (\\S+) , (?:in|with|from|out of) {_LETTERS}(?: please)?$", "spell the word {1}"),
    (f"^(?:(?:put|write|lay|set|spell) )?the words (\\S+) and (\\S+)(?: {MUST} be (?:written|put|laid|spelled))? in "
     f"two rows(?: ,| :) (\\1)(?: is)? in the ({_ROW}) (?:one|row)(?: ,| and)+ (\\2)(?: is)? in the ({_ROW}) (?:one|"
     "row)$", "{3} in the {4} row and {5} in the {6} row"),
    (f"^two words , one (?:per|in each) row : (\\S+) in the ({_ROW}) (?:one|row)(?: ,| and)+ (\\S+) in the ({_ROW}) "
     "(?:one|row)$", "{1} in the {2} row and {3} in the {4} row"),
    # what is left open anyway
    ("^(?:i|we) do not (?:care|mind) how (?:far|close|near|high) [^,]+$", ""),
    # "a red block on the left, to the right of it a blue one": which is the left one follows
    ("(^|: )(an? [^,:]+?) (?:on|at|to) the left(?: ,| and| , and) to the right of it (?=an? )",
     "{1} {2} , to the right of it"),
    # what it is made of and from
    (f"^(build|make|erect|construct) an? (tower|stack) with an? ({COLOR}) (?:base|bottom)(?: ,)? and (?:put|place|"
     f"stack|set) (?:the )?({COLOR}) and (?:the )?({COLOR})(?: ones| blocks?)? (?:over|above|on top of|on) it(?: "
     ",)?(?: in (?:whatever|any) order)?$", "make a {2} of {3} , {4} and {5} with {3} at the bottom"),
    ("^(?:rearrange|change|turn) the (?:row|word|letters) (\\S+) (?:to|into|to spell|to form|to read) (?:the word "
     ")?(\\S+)$", "blocks spell {1} at the start . rearrange them to {2}"),
    ("\\band at same time\\b", "and also"),
    (f"^use ({MANY} \\w+ {_BLOCKS}) (?:for|to build) ((?:an?|one) {LINE} of {MANY}) and (?:another|one)(?: one)? of "
     f"({MANY})$", "make {2} and one of {3} out of {1}"),
    (" on the table(?: ,)? (?:each (?:one |of them |block )?)?(?:by itself|by themselves)$", " on the table"),
    # what is over what in a tower
    (f"^(?:make sure (?:that )?)?({_THE}) (?:is|{MUST} be) higher(?: up)? than ({_THE}) in (?:one|an?|the same) "
     "(tower|stack) (?:of|made of) (.+)$", "a {3} of {4} with {1} somewhere above {2}"),
    (f"^(?:(?:i|we) (?:need|want|would like) )?({_THE}) somewhere (above|below) ({_THE}) in (?:one|an?|the same) "
     f"(tower|stack) (?:together )?with ({_THE})$", "a {4} of {1} , {3} and {5} with {1} somewhere {2} {3}"),
    ("^it is like a (?:chessboard|chess board|checkerboard) : (.+)$", "{1}"),
    ("\\bso as to (spell|read|form|write)\\b", "to {1}"),
    (f"^the {CUBE} (?:on|upon) which (the .+?) {LIES} {MUST} be ({COLOR})$", "{1} must be on a {2} block"),
    ("\\bin contact with the table\\b", "on the table"),
    (f"^(?:goal : )?((?:an? |the )?{COLOR} {CUBE}) (?:underneath|at the bottom|below) , ((?:an? |the )?{COLOR} "
     f"{CUBE}) (?:directly |right )?(?:on|on top of|above) it$", "{2} on {1}"),
    (f"^it is not (the [^,]+?) (?:that|which) ((?:goes|belongs|ends up|{MUST}) .+?)(?: ,)? but (the [^,]+)$",
     "{3} , not {1} , {2}"),
    (f"^it is (the [^,]+?) (?:that|which) ((?:goes|belongs|ends up|{MUST}) .+?)(?: ,)?(?: and)? not (the [^,]+)$",
     "{1} , not {3} , {2}"),
    (f"\\b(an?|the|one) ({LINE}|checkerboard|grid|wall|pyramid) in ({COLOR} and {COLOR}) (with|of)\\b",
     "{1} {3} {2} {4}"),
    # how a letter is turned
    (f"(?<!as )(?<!into )\\b(an?|the) ({_TURNED}) (?:letter )?(\\w)(?= {_SIDE}| {_ON}|$)(.*)$",
     "{1} {3} {4} . the {3} must be {2}"),
    (f"\\b(an?|the) (?:letter )?(\\w)(?: ,)? (?:({_TURNED})(?= {_SIDE}| {_ON})|(?:that|which) (?:is|stands|lies) "
     f"({_TURNED})(?= {_SIDE}| {_ON}|$))(.*)$", "{1} {2} {5} . the {2} must be {3} {4}"),
    # one on either side
    (f"^(.*?)(?:one|an?) ({COLOR} {CUBE}) ({_SIDE}) ([^,]+?)(?: ,)?(?: and| ,) (?:another|the other|one)(?: one| "
     "\\2)? (?:to|on) its (left|right)(?: side)?$", "{1} a {2} {3} {4} and a {2} to the {5} of {4}"),
    (f"^(.*?)(?:two|2) ({COLOR}) {CUBE}s (?:next to|beside|around) ([^,]+?)(?: ,| :) one (?:to|on) its (left|"
     "right)(?: side)?(?: ,)?(?: and)? (?:one|the other)(?: one)? (?:to|on) its (left|right)(?: side)?$",
     "{1} a {2} block to the {4} of {3} and a {2} block to the {5} of {3}"),
    (f"^flank ([^,]+?) with (?:two|2) ({COLOR}) (?:ones|{CUBE}s)(?: ,| :) one (?:to|on) its (left|right)(?: side)?(?: "
     ",)?(?: and)? (?:one|the other)(?: one)? (?:to|on) its (left|right)(?: side)?$",
     "put a {2} block to the {3} of {1} and a {2} block to the {4} of {1}"),
    # where another thing is
    (f"\\b(?:where|at the place where) the ({COLOR} (?:patch|mat|zone|target|area|spot)) is$", "on the {1}"),
    # mats that are told behind their number, which are in that order anyway
    (f"\\b((?:on|onto) (?:the )?{MANY} (?:mats|patches|zones|targets|areas|spots) [,:] {COLOR}(?: , {COLOR})*"
     f"(?: ,)? and {COLOR}) , in (?:this|that) order$", "{1}"),
    # a tower and another such
    (f"^(.*?\\ban? ({LINE}) (of {MANY}(?: {COLOR})?) (?:on|in|to|at|next|beside|behind)\\b[^,]+?)(?: ,| and| , and) "
     "another one (?=(?:on|off|in|to|at|next|beside|behind)\\b)", "{1} , another {2} {3} "),
    # what is taken from a tower that is told block by block
    (f"\\b(from|off|out of) the (tower|stack|pile) ({_LOOK}(?: , {_LOOK})*)(?: , and| ,| and) ({_LOOK})$",
     "{1} the {2} of {3} and {4}"),
    # a line and where it begins
    ("\\b(starting|beginning|start|begin) (at|on|from) the (top|bottom|left|right|far end|near end) with (?:an? |the "
     f")?({COLOR})(?: one| block| cube)?$", "starting with {4} at the {3}"),
    (f"^(an? {LINE} of .+?) , ({WAY}) , (is standing|stands|is|starts) (on the table)$", "{1} {2} {3} {4}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""

OTHERWISE: tuple[Turn, ...] = (
    # in the order of words of a specification
    (f"^({_SIDE}|{_ON}|{_FACING}) ([^,]+?) ({MUST}) (the [^,]+?) (be (?:found|placed|put|located|seen)|stand|lie|rest|"
     "sit|be)$", "{1} {2} {3} {5} {4}"),
    (f"\\b({MUST}) rise(?= an? {LINE})", "{1} stand"),
    (", the (lowest|lower|bottom|middle|upper|uppermost|top|topmost|leftmost|rightmost|first|last)(?: one)? of which "
     f"({MUST} be|is) ", ", of which the {1} {2} "),
    ("^the distance between (.+?)(?: ,)? measured (?:from )?(?:center to center|between (?:their|the) centers)(?: ,)? "
     f"({MUST} be|is) (.+)$", "the centers of {1} {2} {3} apart"),
    (f"\\ban? ({LINE}) of (.+?) whose centers are ({LENGTH}) apart$",
     "a {1} of {2} with a distance of {3} between their centers"),
    (f"\\bnever let (it|them|{_THE}) (?:get )?(?:onto|on to|on)\\b", "never let {1} be on"),
    (f"\\b({MANY} towers)(?: ,)? each ({MANY}) ({COLOR}) ({CUBE})s? (?:high|tall)$", "{1} of {2} {3} {4s} each"),
    ("^(?:round up|bring together|pool)\\b", "gather"),
    (f"\\b(is|are|{MUST} be|stands?|sits?) lower(?: down)? than\\b", "{1} somewhere below"),
    (f"^(the [^,]+?) (?:{MUST} receive|receives|gets) (the [^,]+?) on (?:its )?top(?: of it)?$", "{2} must be on {1}"),
    ("\\b(?:without|with no|with not) (?:any |a single )?(?:block|cube)s? (?:being )?(?:left over|left|remaining)$",
     "using all of them"),
    ("\\bthe lot$", "all of them"),
    ("^(.*\\boutline\\b.*?)(?: ,)? (?:hollow|empty|open) (?:in|at) the (?:center|middle)$", "{1}"),
    (f"^(?:({WAY})(?: ,)? )?the (numbers|digits) {MUST} get (?:smaller|lower)(?: ({WAY}))?$",
     "put the {2} in a row in descending order {1} {3}"),
    (f"^(?:({WAY})(?: ,)? )?the (numbers|digits) {MUST} get (?:larger|bigger|higher)(?: ({WAY}))?$",
     "put the {2} in a row in ascending order {1} {3}"),
    # said of the whole, and once more of its parts
    ("^(all .+? (?:in|inside|inside of|within|on) the [^,]+?) (?:,|and|, and|, with) none (?:of them )?(?:(?:remains|"
     "stays|lies|is|being|left|remaining|lying) )?(?:outside|elsewhere|on the table)(?: of it| it)?$", "{1}"),
    ("\\b(?:two|2) towers : (an? [^:]*?\\btower\\b[^:]*?\\ban? [^:]*?\\btower\\b(?:(?!tower).)*)$", "{1}"),
    (f"^(.*?)\\b(?:straight|directly|immediately|right) ({_SIDE}|above|under|below|next to|beside) ([^,]+?)(?: ,)+ "
     "(?:directly|immediately) \\2 (?:it|them)$", "{1} directly {2} {3}"),
    # patterns and groups
    ("^(.+ : .+) come together and (.+) come together$", "{1} are together and {2} are together"),
    ("^the (first|last|leftmost|rightmost)(?: one)?(?: of them)? gets (an? [^,]+?) on top(?: of it)?(?: ,| and| , and) "
     "the (first|last|leftmost|rightmost)(?: one)? (an? [^,]+)$", "put {2} on the {1} and {4} on the {3}"),
    # which way it reads
    ("\\breading (?:down|downwards|from top to bottom)(?: ,)? (?:you|one|we|i) (?:gets?|reads?|sees?) (\\S+)$",
     "they read {1} from top to bottom"),
    ("^spell (?:the word )?((\\w)\\w*(\\w)) vertically(?: by stacking (?:the )?(?:blocks|cubes|letters))?(?: ,)? with "
     "(?:the )?\\2 (?:on|at) (?:the )?top and (?:the )?\\3 (?:on|at) the bottom$",
     "a tower that reads {1} from top to bottom"),
    (f"^the (?:row|word|letters) (\\S+) , (?:which|that) (?:is|are) there {_AT_START} , {MUST} be (?:rearranged|"
     "changed|turned|made) (?:to|into) (?:the word )?(\\S+)$", "blocks spell {1} at the start . rearrange them to {2}"),
    (f"^(.+ {COLOR}) , (?:thats|that is) how the ({LINE}) {MUST} look$", "a {2} : {1}"),
    # places in a line, taken one by one
    (f"^({_THE}) takes the ({END}) end of the ({LINE}) , ({_THE}) the middle(?: ,)?(?: and)? ({_THE}) the ({END}) end$",
     "the {3} has {1} at the {2} end , {4} in the middle , {5} at the {6} end"),
    # what is not to be at an end of it
    ("(?: ,)? but not with (.+?) ((?:on|at) (?:the )?(?:top|bottom|left|right))(?: end)?$", "with {1} not {2}"),
    # what is all so but for a part
    (f"^((?:an? )?\\d+x\\d+)(?: square| grid)? of (\\w+) ({_BLOCKS})(?: ,)? except (?:for )?the (center|middle|"
     f"corners)(?: one| block| cube)?(?: ,)? which (?:is|are|{MUST} be) (\\w+)$",
     "{1} square of {2} {3} , but the {4} is {5}"),
    # towers told by their base or their height
    (f"^the (\\w+) tower has ({MANY}) \\w+ and (?:is|stands|is standing) ({_SIDE}) the (\\w+) tower , which has "
     f"({MANY}) \\w+$", "a {1} tower of {2} is {3} a {4} tower of {5}"),
    # what is there and has to go
    (f"^(?:clear|empty) (the [^:,]+?) : (the [^,:]+?) {LIES} on it(?: {_AT_START})? and {MUST} {_LEAVE}$",
     "at the start , {2} is on {1} . {2} must not be on {1}"),
    # numbers
    (f"^use (?:the )?{_BLOCKS} to (?:show|write)(?: that)? (.+ equals .+)$", "write {1}"),
    (f"(?: ,)? with (?:the )?(?:digit|number) and (?:operator|symbol|sign) {_BLOCKS}$", ""),
    # what is wanted
    (f"^({WAY})(?: ,)? (?:i|we) (?:need|want|would like) the following :", "{1} :"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("completes configure disposed following thats vertically operator",)
"""Words that these take besides those that are read anyway."""
