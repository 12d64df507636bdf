"""Grids, walls, rings, crosses, outlines and letters as people describe them, "a back row of orange blocks", "arms two
cubes long", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.figures_asked import FIGURE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import BUILD, COLOR, FEW, MANY, MID, MUST, N

_BLOCKS = "(?:blocks|cubes|bricks|ones)"
_BLOCK = "(?:block|cube|brick|one)"
_BE = f"(?:is|are|being|{MUST} be|stands|lies|sits)"
_RING = "(?:circle|ring)"
_PLUS = "(?:plus sign|plus shape|plus|cross)"
_WITHOUT = "(?: ,)? (?:not counting|without|not including) the (?:center|middle)(?: block| cube| one)?"
_ARMS = ("(?:arms|each arm|each of (?:the |its )?(?:four )?arms)(?: that| which)?(?: is| are| being)?(?: of)? "
         f"({MANY}) (?:blocks|cubes)(?: long)?(?: each)?")  # fmt: skip
_IS = f"(?: is| are| being| {MUST} be)?(?: all)?"
_SIDE = "(?:left|right|middle|center|front|back|near|far)"
_THAT = "(?: ,| :| that is| which is| where| in which)*"
_BUT = "(?:except|but|apart from|save)(?: for)?"
_LOW, _HIGH = "(?:lower|bottom|lowest)", "(?:upper|top|topmost)"
_DIMS = "(\\d+x\\d+|(?:\\d+|two|three|four) by (?:\\d+|two|three|four))"
_LETTER = "((?:\\b(?:shape|form) of (?:a|an|the letter) |\\b(?:a|an|the letter) |^)[uvUV](?: shape)?\\b.*?)"
_OPEN = (f"(?: ,| and it| and| so that it)*(?: that| which| thats)?(?: is| {MUST} be| {MUST})?(?<! the)(?<! its)(?<! "
         "an) (?:opens?|opened|opening(?= away| at| on))(?: up)?(?: is)?")  # fmt: skip
_ME = "(?:the )?(?:robot|me|viewer|camera|us|you)"
_TOWARD = {
    "back": f"(?:away from {_ME}|(?:at|to|towards?|on) the (?:back|far side|far end|far edge)|backwards?)",
    "front": f"(?:towards? {_ME}|(?:at|to|towards?|on) the (?:front|near side|near end|near edge))",
    "left": "(?:at|to|towards?|on) the left(?: side)?", "right": "(?:at|to|towards?|on) the right(?: side)?",
}  # fmt: skip
_EACH_SIDE = (f"({MANY})(?: blocks| cubes| bricks| of them)? (?:along|on|to|per|at) ?(?:each|every|a)?(?: one of its)? "
              "?sides?(?: ,)?(?:(?: with)?(?: the)? corners (?:counted|included)| counting the corners| including the "
              "corners)?")  # fmt: skip
_OUTLINE = "(?:the )?outline of an? (rectangle|square)"
_LONG_WIDE = (f"({MANY}){N}(?: long| along)?(?: by| and| ,)+ ({MANY}){N}(?: wide| across| deep)?(?:(?: ,)?(?: with| "
              "and) nothing inside)?")  # fmt: skip
_ARE = f"(?:is|are|{MUST} be)"
_LATERAL = f"(?:{_ARE} )?(?:on|at|in|to) the"
_NEAR = "(?:nearer|nearest|closer|closest) to (?:me|you|us|the viewer|the robot)"
_ONE_AND_OTHER = f"\\b(grid\\b.*?) one (column|row) (?:{_ARE} )?(\\w+)(?: ,)? and the other(?: one)? (?:{_ARE} )?(\\w+)"
_ROW_AND_OTHER = f"({_ARE} )?(?:all )?(\\w+)(?: ,)? and the other(?: one| row)? ({_ARE} )?(?:all )?(\\w+)$"
_THE_FIRST = "(?: ,| with|;)+ the \\3 (?:column|row|one)"
_EACH_OF_ONE = (
    "(?:in which|where|such that|so that|whose|with)? ?(?:each|every) {axis} (?:is|being|must be|should be|has|having|"
    "of) (?:monochrome|monochromatic|unicolored|(?:of )?(?:one|a single|the same) color|single colored)"
)
_WHICH = (
    "\\b(?:far|back|rear|near|front|middle|center|left|right|top|bottom|upper|lower|first|second|third|fourth|last)"
)

FIGURES: tuple[Turn, ...] = (
    # which kind of it
    (f"\\b({FIGURE}\\b[^,:]*?)(?: ,)? (?:of )?(?:the|that) (?:kind|sort|type|variety) (with|that has|which has|where|"
     "of|made of|from)\\b", "{1} {2}"),
    # how long their sides are
    (f"\\b(triangle|square|outline)(?: ,)? (?:whose|the|its|with(?: the)?|and its) sides(?: each)? (?:{MUST} )?(?:"
     f"consist of|consisting of|are made of|made of|are built of|have|having|contain|are|of) ({MANY}(?: {COLOR})? "
     f"{_BLOCKS})(?: each)?\\b(?! long)", "{1} with {2} on each side"),
    # letters by what people call them
    ("\\b([tl]) (?:junction|bend)(?= (?:of|out|from|made|with|using)\\b)", "{1} shape"),
    ("\\b(?:tetris ([tl]) (?:piece|block|shape)|([tl]) tetromino)(?:$| (?:out of|of|from|with|made of|made from) (?:4 "
     f"|four )?({COLOR} )?{_BLOCKS}$)", "{1} {2} shape of 4 {3} blocks"),
    ("\\b(?:plus|cross) (?:shaped|like) (?:cross|plus|figure)\\b", "plus"),
    ("\\bsquare (?:ring|loop)\\b", "square frame"),
    ("(?: ,)? in plan(?: view)?(?= ,|$)", ""),
    (f"\\b(checkerboard|chessboard) of ({MANY} {_BLOCKS}) , (?:in )?({COLOR}) and ({COLOR})$", "{1} of {2} in {3} "
     "and {4}"),
    (f"\\b(?:as|in|into) an? (?:tray|sheet|board|carpet|panel|slab|array)(?: ,| of)* (?={MANY} rows?\\b|\\d+x\\d+)",
     "as a grid ,"),
    # "4 columns 2 rows, all black"
    *((f"^({MANY}) ({COLOR}) {one}(?: ,| and| by)* ({MANY}) \\2 {other}(?=$| ,)",
       f"a grid of {{2}} blocks with {{1}} {one} and {{3}} {other}")
      for one, other in (("columns", "rows"), ("rows", "columns"))),
    # rings around something
    (f"^(?:{BUILD} )?({MANY} [^,:]*?{_BLOCKS}) (?:{MUST} )?(?:form |make |stand |are |lie |be )?(?:placed |arranged "
     f")?(?:in |into |as )?an? ({_RING}) (?:all )?(?:around|round) ((?:the|an?) [^,:]+)$", "a {2} of {1} around {3}"),
    (f"^((?:put|place|set|lay) .+? in the {MID})(?: ,)? (?:and |then |and then )?surround (?:it|that|that one) (?:with|"
     f"by) ({MANY} [^,:]+)$", "{1} and {2} around it"),
    (f"^(?:surround|encircle) ((?:the|an?) [^,:]+?) (?:with|by) an? ({_RING}) (?:of|made of|from) ({MANY} [^,:]+)$",
     "a {2} of {3} around {1}"),
    ("\\b(circle|ring|square|plus|cross|grid)\\b((?:(?! and ).)*?) (in|at) the (middle|center) of the \\1$",
     "{1} {2} {3} the {4}"),
    (f"\\b((?:circle|ring|square|outline|rectangle) .*?)(?: ,)? (with|and) ((?:the|an?) {COLOR}(?: {_BLOCK})?) "
     f"(?:inside|within)(?: ,)? in the ({MID})$", "{1} {2} {3} in the {4}"),
    # crosses
    (f"\\b({_PLUS}\\b[^:;]*?)(?: ,| :)?(?: with| where| and| whose)?(?: four)? {_ARMS}(?:{_WITHOUT})?$",
     "{1} with each arm of {2} blocks"),
    (f"^(.*\\b(?:five|5) [^,:]*?{_BLOCKS}) (?:on the table )?(?:in|like|as) an? ({_PLUS})(?: ,| :)? one in the {MID} "
     "and one (?:on|at|for) each (?:of the four |of its four |of the |of its )?(?:sides?|arms?|ends?)$",
     "{1} as a plus"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})?(?: ,| :)? (?:four|4)(?: of (?:them|these))? ({COLOR})(?: "
     f"{_BLOCKS})? and (?:the (?:one|block|cube) (?:in|at) the {MID}|the {MID} (?:one|block|cube)|the {MID}) "
     f"({COLOR})$",
     "{1} with a {3} center and {2} arms"),
    (f"\\b({_PLUS}) (?:of|from|out of|made of) (?:four|4) ({COLOR})(?: {_BLOCKS})? (?:and|with|around) (?:an?|one) "
     f"({COLOR})(?: {_BLOCK})?(?: (?:in|at|as|for) (?:the|its) {MID}| so that the \\3 (?:one|{_BLOCK}) (?:is|becomes|"
     f"forms|makes|{MUST} be) (?:its|the) {MID})$", "{1} with a {3} center and {2} arms"),
    (f"^{BUILD} (?:four|4) ({COLOR})(?: {_BLOCKS})? around an? ({COLOR})(?: {_BLOCK})? ,? ?(?:which|that|so that it|so "
     f"it|to) (?:gives?|makes?|forms?) an? ({_PLUS})(?: with an? \\2 {MID})?$",
     "a {3} with a {2} center and {1} arms"),
    (f"^an? ({COLOR}) (?:{_BLOCK}) {_BE} (?:in|at) the {MID} of an? ({_PLUS}) (?:whose|with) (?:the |its )?(?:four "
     f")?arms (?:are |of )?({COLOR})(?: {_BLOCKS})?$", "a {2} with a {1} center and {3} arms"),
    (f"\\b({_PLUS})(?: ,| :)? the {MID}(?: {_BLOCK})? {_BE} ({COLOR}) and the (?:four )?(?:{_BLOCKS}|others)(?: "
     f"all)?(?: around(?: it)?)? {_BE} ({COLOR})$", "{1} with a {2} center and {3} arms"),
    (f"\\b({_PLUS})(?: of five {_BLOCKS}| of 5 {_BLOCKS})(?: ,)? all(?: of them)? ({COLOR}) (?:but|except|apart from|"
     f"save)(?: for)? the (?:one (?:in|at) the {MID}|{MID} one|{MID})(?: ,)?(?: which is| being)? ({COLOR})$",
     "{1} with a {3} center and {2} arms"),
    # what lies on the middle
    (f"^(.*\\b(?:{_PLUS}|grid|square)\\b[^,]*?) (?:whose {MID}(?: {_BLOCK})? (?:carries|bears|holds|supports)|with the "
     f"{MID} (?:one|{_BLOCK}) (?:carrying|bearing|holding)) (?:the|an?) ({COLOR} {_BLOCK})$",
     "{1} with a {2} on its center"),
    (f"\\b(?:checkerboard|chessboard|checkered) ({COLOR})(?: and|/| ,)? ({COLOR})$", "in a checkerboard pattern of "
     "{1} and {2}"),
    ("\\b([tluv]) shaped (?:corner|figure|form|structure|arrangement)\\b", "{1} shape"),
    (f"^(?:put|place) (?:the )?({COLOR})(?: {_BLOCKS})? (?:on|in|at|to) the corners of an? ({_DIMS} grid) and (?:the "
     f")?({COLOR})(?: {_BLOCKS})? (?:on|in|to) (?:all )?the (?:other|remaining|rest of the) (?:cells|places|squares|"
     "fields|positions)$",
     "a {2} with {1} corners and the other blocks {4}"),
    (f"^fill the ({_SIDE}) (column|row) of an? ({_DIMS} grid) with ({COLOR})(?: {_BLOCKS})? and the (?:rest|others|"
     f"other cells) with ({COLOR})(?: {_BLOCKS}| ones)?$", "a {3} with the {1} {2} {5} and the rest {6}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
BOARDS: tuple[Turn, ...] = (
    # sizes, and what there is
    (f"\\b((?:rectangle|grid|square)\\b.*?) ({MANY}) rows by ({MANY})(?= ,|$)", "{1} {2} rows by {3} columns"),
    *((f"^(?:{BUILD} )?(?:(?:with|a grid of|grid) )?({MANY}) {one} (?:x|by|and|times|,) ({MANY}) {other}(?: ,| :| in| "
       "as| with)+ (?:an? )?(checkerboard|chessboard)(?: pattern)?", f"a {{3}} with {{1}} {one} and {{2}} {other}")
      for one, other in (("rows", "columns"), ("columns", "rows"))),
    (f"\\b(checkerboard|chessboard)(?: pattern)? , ({MANY} {COLOR}){N} and ({MANY} {COLOR}){N} ,",
     "{1} of {2} and {3} blocks ,"),
    (f"^(?:goal : )?({MANY} {COLOR} {_BLOCKS}) in the ({_SIDE}) (row|column) and ({MANY} {COLOR} {_BLOCKS}) in the "
     f"({_SIDE}) (row|column) of an? (.*grid)$", "a {7} with the {2} {3} {1} and the {5} {6} {4}"),
    ("\\b(grid) with ((?:\\S , )*\\S(?: ,)? and \\S) in the (far|back) row and ((?:\\S , )*\\S(?: ,)? and \\S) in the "
     "(near|front) row$", "{1} : {2} in the {3} row , {4} in the {5} row"),
    ("\\b(grid\\b.*?)(?: ,)+ (?:its|the) (columns|rows) ,? ?(from (?:left to right|right to left|front to back|back "
     f"to front))(?: ,| :)?(?: are| {MUST} be)? ((?:{COLOR} ,? ?)+and {COLOR}|{COLOR}(?: , {COLOR})+)$",
     "{1} , the {2} {3} : {4}"),
    ("\\b([tT]\\b.*?) , (?:the|its) (bar|crossbar|stem|foot)(?: of (?:it|the [tT]))? (?:is|lies|points|stands) ((?:at|"
     "on|to|towards?) .+)$", "{1} , the {2} {3}"),
    # rows and columns
    (f"\\b(grid\\b.*?) an? ({_SIDE}) (row|column) (?:of|with) ({MANY} )?({COLOR}) ({_BLOCKS})\\b",
     "{1} the {2} {3} {4} {5} {6}"),
    (f"\\b(grid\\b.*?) an? ({COLOR}) (row|column) (?:on|at|in) the ({_SIDE})(?: side| end)?\\b", "{1} the {4} {3} {2}"),
    (f"\\b(grid\\b.* (?:row|column) {COLOR}.*?) an? ({COLOR}) (row|column) (?:between them|in between(?: them)?)$",
     "{1} the middle {3} {2}"),
    (f"^(?=.*(?:\\b3x|\\b(?:three|3) (?:by|rows)\\b))(.*\\bgrid\\b.* the (?:near|front|nearest) row{_IS} {COLOR} ,(?: "
     "and)?) the (?:row|one) behind (?:it|that)\\b", "{1} the middle row"),
    (f"^(?=.*(?:\\b3x|\\b(?:three|3) (?:by|rows)\\b))(.*\\bgrid\\b.* the (?:far|back|farthest) row{_IS} {COLOR} ,(?: "
     "and)?) the (?:row|one) in front of (?:it|that)\\b", "{1} the middle row"),
    ("\\b(grid\\b.* in the (?:near|front) row) , in reading order$", "{1}"),
    ("\\b(grid) (?:that|which) reads (.+?) row by row(?: ,)?(?: (?:starting )?(?:from|at) the far left)?$",
     "{1} of {2} in reading order"),
    (f"^((?:(?!\\b{COLOR}\\b).)*\\b(?:square|grid)\\b(?:(?!\\b{COLOR}\\b).)*?)(?: ,| with| and| so that)+ (?:the )?"
     f"(?:two )?({COLOR}){N}{_IS} on one diagonal(?: ,| and)+ (?:the )?(?:two )?({COLOR}){N}{_IS} on the other(?: "
     "diagonal| one)?$", "{1} of two {2} and two {3} blocks with equal colors diagonally opposite each other"),
    (f"^(?=.*\\b({COLOR})\\b.*\\b\\1\\b)(.*\\b(?:square|grid)\\b.*?)(?: ,| with| and| so that)+ the(?: two)? {COLOR}{N}"
     f"{_IS} (?:on (?:one|a|the same) "
     f"diagonal|diagonally opposite(?: to)?(?: each other)?|diagonal(?:ly)?(?: to| from)? each other)"
     f"(?:(?: ,| and)+ the(?: two)? {COLOR}{N}{_IS} on the other(?: diagonal| one)?)?$",
     "{2} with equal colors diagonally opposite each other"),
    # one that differs
    (f"\\b(square|grid)\\b(.*?){_THAT} (?:all|every{N}{_IS}) ({COLOR}){N} {_BUT} (?:an?|one|the) ({COLOR}){N} (?:in|"
     f"at) the {MID}$", "{1} {2} with a {4} center and the rest {3}"),
    (f"\\b(square|grid)\\b(.*?){_THAT} (?:all|every{N}{_IS}) ({COLOR}){N} {_BUT} the (?:{MID}{N}|one in the {MID})(?: "
     f",)?(?: which is| is| being)? ({COLOR})$", "{1} {2} with a {4} center and the rest {3}"),
    (f"\\b(grid|square) (of|from) ({MANY} {COLOR} {_BLOCKS}) and (?:an?|one) ({COLOR}){N}(?: ,)? (?:which is |with it |"
     f"it is |that is |being )?(?:in|at) the {MID}$", "{1} of {3} with a {4} block in the center"),
    # layers
    (f"\\b((?:cube|grid|wall)\\b.*?)(?: ,| with)+(?: the)? ({COLOR}){N}(?: all)? (?:in|on) the ({_LOW}|{_HIGH}) "
     f"layer(?: ,| and)+(?: the)? ({COLOR}){N}(?: all)? (?:in|on) the ({_LOW}|{_HIGH})(?: layer| one)?$",
     "{1} , the {3} layer {2} and the {5} layer {4}"),
    (f"^two layers : the {_LOW}(?: one| layer)?{_IS} an? {_DIMS}(?: grid| square)? (?:of )?({COLOR}){N}(?: ,| and| ;)+ "
     f"the {_HIGH}(?: one| layer)?{_IS}(?: an?)? \\1(?: grid| square)? (?:of )?({COLOR}){N}(?: on (?:it|top of it))?$",
     "two layers of {1} blocks , the bottom layer {2} and the top layer {3}"),
    # outlines
    ("\\b(?:trace|mark|draw|mark out|traces|marks) (the outline of)\\b", "form {1}"),
    (f"^(?:{BUILD} )?({MANY} [^,:]*?{_BLOCKS})(?: {MUST})? (?:as|in|into|form|make) {_OUTLINE}(?: ,)? {_LONG_WIDE}$",
     "the outline of a {2} of {1} , {3} by {4}"),
    (f"^(?:{BUILD} )?{_OUTLINE} (?:with|of|from|out of) ({MANY} [^,:]*?{_BLOCKS})(?: ,)? {_LONG_WIDE}$",
     "the outline of a {1} of {2} , {3} by {4}"),
    (f"^{_OUTLINE} , {_LONG_WIDE} , (?:is|{MUST} be) (?:laid|made|built|formed) (?:with|of|from|out of) ({MANY} "
     f"[^,:]*?{_BLOCKS})$", "the outline of a {1} of {4} , {2} by {3}"),
    (f"^(?:{BUILD} )?({MANY} [^,:]*?{_BLOCKS}) , {_EACH_SIDE} ,(?: {MUST})? (?:form|make|are) the outline of an? "
     "(square|triangle)$", "the outline of a {3} of {1} with {2} per side"),
    (f"^(?:{BUILD} )?({MANY} [^,:]*?{_BLOCKS}) (?:as|in|into) the outline of an? (square|triangle) ,(?: with)? "
     f"{_EACH_SIDE}$", "the outline of a {2} of {1} with {3} per side"),
    (f"^the outline of an? (square|triangle) {MUST.replace('shall', 'is|shall')} (?:be )?(?:formed|made|laid) (?:by|of|"
     f"from|with) ({MANY} [^,:]*?{_BLOCKS}) ,(?: with)? {_EACH_SIDE}$",
     "the outline of a {1} of {2} with {3} per side"),
    (f"\\b(outline of an? (?:triangle|square)\\b.*?)(?: ,)? each side of which {MUST} (?:consist of|have|be) ({MANY}) "
     f"{_BLOCKS}(?: long)?$", "{1} with {2} blocks per side"),
    (f"^(?:an? )?hollow square(?: ,| :)? {_EACH_SIDE} , ({MANY} [^,:]*?{_BLOCKS})(?: in (?:all|total))?(?:(?: ,| and| "
     f"with)+ nothing (?:in the {MID}|inside))?$", "a hollow square of {2} with {1} per side"),
    (f"^(?:an? )?hollow (square|circle|rectangle)(?: ,| :)+ ({MANY} (?:\\w+ )?{_BLOCKS}) (?:around|round|along|on|at) "
     f"the (?:outside|edge|edges|rim)(?:(?: ,| and| with)+ nothing (?:in the {MID}|inside))?$", "a hollow {1} of {2}"),
    (f"\\ban? (square) (?:thats|that is|which is) hollow in the {MID}$", "a hollow {1}"),
    (f"^(?:with|from|out of) ({MANY} [^,:]*?{_BLOCKS}) {BUILD} (an? hollow \\w+)$", "{2} of {1}"),
    (f"^(.*\\b({COLOR})\\b.*\\b(?:layer|level|row|column|one)(?: {_ARE}| being)?) \\2 again(?=$| ,)", "{1} {2}"),
    (f"(the {_WHICH} (?:row|column)) (?:being |{_ARE} )?(?:occupied|filled|taken|made up|formed) by\\b", "{1}"),
    (f"(the {_WHICH} (?:row|column) [^;:]+? and the {_WHICH} (?:row|column)) by (?=\\w)", "{1}"),
    (f"(?: ,)?(?: and)?(?: then)? fill (?:in )?(the rest|the others|everything else)(?: in| up)? with ({COLOR})(?: "
     "blocks| cubes| ones)?$", " and {1} in {2}"),
    # how many there are of each, and on either side
    (f"^((?:{COLOR} ?,? ?(?:and )?)+?)(?: ,)? (?::|-|;) (?:just |exactly )?one (?:block |cube |of )*each(?: color)?(?: "
     ",)? (.+)$", "one block each of {1} , {2}"),
    *((f"\\b((?:row|line) of (?:{total}) .*?) (?:the |one )?(?:{side})(?: (?:blocks|ones|cubes))? (?:on|to) (?:each|"
       f"either) side(?: of (?:it|that|the middle one))?(?: (?:is|are|being|{MUST} be))? ({COLOR})$",
       "{1} the others {2}")
      for total, side in (("three|3", "ones?|blocks?"), ("five|5", "two|2"), ("seven|7", "three|3"))),
    # each line of one colour, where it is told which
    *((f"\\b((?:{many}) {axis}s\\b.*?)(?: ,)? {_EACH_OF_ONE.format(axis=axis)}(?: ,| and| ,? with)* "
       f"({f'(?:[^;:]*?{_WHICH} {axis} )' * n}[^;:]*)$", "{1} , {2}")
      for n, many in ((2, "two|2"), (3, "three|3"), (4, "four|4")) for axis in ("row", "column", "layer")),
    ("\\b(each|every) (row|column|layer) (?:is|being) (?:monochrome|monochromatic|unicolored|single colored)\\b",
     "{1} {2} has one color"),
    # letters
    *((f"{_LETTER}{_OPEN} {toward}$", f"{{1}} with its opening to the {side}") for side, toward in _TOWARD.items()),
    (f"\\b([tT]\\b.*?)(?: ,| with)+ the (bar|crossbar) (at the (?:far|near) side) and ({MANY}) {_BLOCKS} long$",
     "{1} with a {2} of {4} blocks , the {2} {3}"),
    # grids
    (f"^(.*\\bgrid\\b[^,]*?) (?:has|must have|should have) (the {_SIDE} (?:row|column) \\w+)\\b", "{1} with {2}"),
    ("\\b(grid) with (\\w+)(?: blocks| ones)? on the left and (\\w+)(?: blocks| ones)? on the right$",
     "{1} with the left column {2} and the right column {3}"),
    (f"\\b(grid\\b.*) the row {_NEAR} {_ROW_AND_OTHER}", "{1} the near row {2} {3} and the far row {4} {5}"),
    (f"{_ONE_AND_OTHER}{_THE_FIRST} {_LATERAL} left$", "{1} the left {2} {3} and the right {2} {4}"),
    (f"\\b(grid) (?:in which|where|whose) ((?:{FEW})) (?:blocks |cubes |of them )?{_ARE} (\\w+)(?: ,)? and the "
     f"(?:center|middle)(?: one| block| cube) (?:{_ARE} )?(\\w+)$",
     "{1} of {2} {3} blocks with a {4} block in the center"),
    ("\\b(grid with .+?) , the (\\w+) ones in the (\\w+) row and the (\\w+) ones in the (\\w+) row$",
     "{1} , {2} in the {3} row and {4} in the {5} row"),
    # letters
    ("^(?:make|build) a (?:tower|stack) of (?:the |some )?letters?(?: blocks| cubes)? (?:so that|that|such that)(?: "
     "from top to bottom)?(?: it| they)? (?:says?|spells?|reads?) (\\S+)(?: from top to bottom)?$",
     "stack letter blocks so that they read {1} from the top down"),
    ("\\b(?:show|have|take) the shape of (?:the |a )?(?:letter )?(\\w)\\b", "form the letter {1}"),
    ("\\b(?:so that|so) they look like (?:the |a )?(?:letter )?(\\w)\\b", "so that they form the letter {1}"),
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
WORDS = ("junction bend tetris tetromino tray sheet carpet panel slab array",)
"""Words that these take besides those that are read anyway."""
