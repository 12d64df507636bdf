"""How people speak who think of no program: "starting from the table", "an odd-one-out", "take it down again", "first
red goes on the mat, after that blue", as rows that say it as others do."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, PUT, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MANY, ME, MUST, PATCH, READER, TOWER

_BLOCKS = f"(?:{CUBE}s|bricks|ones|toys|pieces)"
_ALL = f"((?:all )?(?:the |these |those |my |our )?(?:{COLOR} )?{_BLOCKS}|them|these|everything)"
_AND = "(?: ,| and| , and)"
_OR = "(?: ,)? or"
_NEXT = f"(?:{_AND} )?(?:then|next|after that|after this|afterwards|after it|secondly|second|thereafter)(?: ,)?"
_LAST = f"(?:{_AND} )?(?:lastly|last|finally|last of all|at last|thirdly|third|at the end|then|after that)(?: ,)?"
_GO = f"(?:goes|comes|is put|is placed|gets put|{MUST} be put|{MUST} go|{MUST} be placed)"
_ERRAND = "(?:scene|setup|scenario|task|test|challenge|benchmark|goal|example|problem|layout|job|exercise)"
_KIND = "(?:grasp|grasping|motion|pick|picking|place|placing|stacking|path|task|new|robot|arm|manipulation|language)"
_AGENT = (
    "(?:agent|robot|arm|gripper|policy|model|controller|demo|experiment|video|paper|lab|class|lesson|camera|parser)"
)
_LOT = f"((?:{MANY}) {COLOR})s?(?: {_BLOCKS})?"
_ONLY = "(?:block|cube|one)"
_FOOT = "(?:at the bottom|lowest|at the base|on the table|below|first)"
_HEAD = "on top|at the top|on top of (?:it|that|them|this)|uppermost|last|topmost"
_ROW = "(row|line|column|tower|stack)"
_THOSE = "(?:all )?(?:the |those )?(?:blocks|cubes|ones)"
_WAYS = ("ab", "aab", "abb", "aba", "aabb", "abab", "abba", "aabbaabb", "abababab")
_FOR_LETTERS = f"({COLOR}) (?:for|as|is|equals|=) (?:the )?a(?: ,| and)+ ({COLOR}) (?:for|as|is|equals|=) (?:the )?b"
_LETTERS_ARE = f"a (?:is|being|for|=|:|stands for) ({COLOR})(?: ,| and)+ b (?:is|being|for|=|:|stands for) ({COLOR})"
_WAY = "(?:from )?\\w+ to \\w+"
_SORTED = "(?:make |build |sort (?:the |these )?(?:blocks|cubes) into |put (?:them|the blocks) in(?:to)? )?"
_NOW = "(?:at the (?:start|beginning|moment)|now|right now|currently|at present|initially)"
_ALSO = "[^,]* (?:it|and (?:put|place|set|then|move|stack|build|lay|make|also))\\b"
_BOTH = "(?:towers|stacks|rows|columns|piles)"
_LINE = "(?:row|line|column|tower|stack)"
_ONE = "(?: one| tower| stack| row| column| pile)?"
_LEFT = "(?:stands? |is |being |goes )?(?:on|at|to) the (left|right)(?: side)?"
_TWO = "(?:two|any two|2) (?:blocks|cubes|ones)"
_DOWN = "(?:down|apart|to pieces|back down)"
_WITHOUT = "without (?:moving|shifting|disturbing|displacing)"
_UNTOUCHED = "(?: ,| :)(?: but)? (?:do not|never) (?:move|touch)(?: them| it| these)?"
_UNMOVED = (
    "(?:(?:with )?(?:its|the) )?(?:position|place|location) (?:(?:is|stays|remains|kept|must stay|must remain) )?"
    "(?:unchanged|the same|fixed)"
)
_AROUND = "(?:surround|encircle|enclose|flank)"

PLAIN_TALK_AT_ONCE: tuple[Turn, ...] = (
    (f"\\bboth (?:the )?(?:\\w+ )?(?:{_BLOCKS}|letters|digits|numbers) , (?={THING} and {THING}$)", "both "),
    # how the text is made up
    *(("^(?:the |my |our |this )?(?:goal|task|job|exercise|request|instruction)s? (?:has|have|consists? of|comprises?|"
       f"is made up of|with) {MANY} {parts}", "")
      for parts in ("(?:parts|conditions|things|points|requirements|goals)(?: :|$)",
                    f"(?:steps|stages) :(?= (?:first|{PUT}|stack|build)\\b)")),
    ("^(?:the |my |our )?goals(?: are)? :", "goal :"),
    # from which end
    ("^(.*\\b(?:stack|pile|stacked|piled|tower)\\b.*?)(?: ,)? (?:starting|beginning|begin|start|begun) (?:from|on|at) "
     "(?:the )?(?:table|ground|floor)(?: (?:up|upwards?|and going up))?$", "{1} , from bottom to top"),
    ("^(?:starting|beginning) (?:from|at|on) the (?:table|ground|floor)(?: up)? , (.*\\b(?:stack|pile|tower)\\b.*)$",
     "{1} , from bottom to top"),
    ("\\bfrom down (?:to up|up|upwards)\\b", "from bottom to top"),
    (f"\\b(all (?:the |of the )?(?:blocks|cubes) are )(?:in )?(?:one|a|a single) ({TOWER}) \\( (.+?)(?: ,)? (from \\w+ "
     "to \\w+) \\)", "{1} in one {2} : {3} {4}"),
    # each for itself
    (f"\\b((?:each|every|all)(?: of)?(?: the)?(?: single)? (?:{_BLOCKS}|{CUBE}|one)(?: of (?:them|these))? (?:is|are|"
     f"stands?|lies?|{MUST} be|{MUST} stand|{MUST} lie)) (?:alone|on its own|on their own) (on the table)(?: again)?$",
     "{1} {2} by itself"),
    # nothing more
    ("(\\d\\S* .*?)(?: ,|;)? (?:and |with )?nothing else (?:is |lies |stands )?(?:on the (?:table|desk)|in the scene|"
     "there|around)(?: please)?$", "{1} and nothing else"),
    ("\\b(?:the )?sequence (?=(?:does not matter|is (?:free|irrelevant|unimportant|up to you|open)))", "the order "),
    (f"\\b({COLOR}) odd one(?: out)?\\b", "{1} stranger"),
    # one of two figures
    (f"^(?:(?:we|i) (?:need|want|would like)|build|make|put up|there {MUST} be)? ?(?:me |us )?either (an? "
     f"[^,]*?{_LINE}[^,]*?)(?<= )({COLOR})\\b([^,]*?){_OR} (an? (?!{_ALSO}|[^,]*\\b\\2\\b)[^,]*?{_LINE}[^,]*? "
     f"{COLOR}\\b[^,]*?)$",
     "either build {1} {2} {3} or build {4}"),
    # figures beside each other
    (f"^(two {_BOTH} of [^,:]+?)(?: ,| :| with)+ (?:the|an?|one) ({COLOR}){_ONE} {_LEFT}{_AND} (?:the|an?|one) "
     f"({COLOR}){_ONE} {_LEFT}(?=$| ,| with)", "{1} , the {3} one {2} , the {5} one {4}"),
    # what is undone
    (f"\\b(?:take|pull|tear|bring) (it|them|the (?:{TOWER}|wall)) {_DOWN}(?: again)?$", "unstack {1}"),
    ("\\b(?:nicely|neatly|regularly|equally) spaced(?: out| apart)?\\b", "evenly spaced"),
    # of which looks
    (f"\\bsomething ({COLOR})(?! (?:blocks?|cubes?|ones?|and|or)\\b)", "a {1} block"),
    *((f"^{_SORTED}{many} {line}s (?:sorted )?by color(?: :| ,) {lots}$",
       f"a {line} of {{1}} blocks , a {line} of {{2}} blocks{more.format(line)}")
      for line in ("row", "column", "tower", "stack")
      for many, lots, more in (("two", f"{_LOT}{_AND} {_LOT}", ""),
                               ("three", f"{_LOT}{_AND} {_LOT}{_AND} {_LOT}", " , a {} of {{3}} blocks"))),
    (f"^((?:one|a) {_LINE} (?:with|of|from|for) all (?:the )?[^,:]+? and (?:one|a|another) {_LINE} (?:with|of|from|"
     "for) all (?:the )?[^,:]+?) : ((?:\\S(?: ,| and)? )+\\S)$", "{2} : {1}"),
    (f"^(?:put |place )?the (?:biggest|largest)(?: {_ONLY})? {_FOOT}(?:{_AND} )(?:then )?the (?:middle|medium|middle "
     f"sized|medium sized|second largest|second biggest)(?: {_ONLY})?(?: on (?:it|that|top of (?:it|that))| in the "
     f"middle)?(?:{_AND} )(?:then )?the smallest(?: {_ONLY})? (?:{_HEAD})$",
     "a tower of three blocks by size , the largest at the bottom"),
    # beside each other, and where
    (f"^(.*?\\b({THING}) and ({THING}) (?:next to|beside) each other)(?: ,| :| with)+ (\\2|\\3) (?:is |being )?(?:on "
     "the )?(left|right)(?: side)?$", "{1} , {4} on the {5}"),
    ("\\b(?:clear|visible|free|empty) gap of\\b", "gap of"),
    (f"^(every (?:second|third|other) (?:block|cube|one)) (?:of|in) (?:the|a) {_ROW} (?:is|{MUST} be) ({COLOR})(?: ,|"
     f"{_AND})? (?:and )?((?:all )?the (?:others|rest)) ({COLOR})(?: ,| :)+ ({MANY}) (?:blocks|cubes)(?: in total| in "
     "all)?$",
     "a {2} of {6} blocks , {1} {3} , {4} {5}"),
    (f"^(?:i |we )?(?:only |just )?want (?:only |just )?one (?:block|cube) (on [^,]+?) ,(?: namely)? ({THING})$",
     "only {2} must be {1}"),
    (f"^keep everything off ([^,]+?)(?: ,)? (?:but|except|except for|apart from) ({THING})$",
     "keep everything but {2} off {1}"),
    ("^(?:unload|clear|empty) (the [^,:]+?) (?::|,) (?:move|bring|take|put) its ([^,]+?) (to|onto|on) (the [^,]+)$",
     "move the {2} from {1} {3} {4}"),
    ("^left , (?:middle|center) , right : (\\S+) , (\\S+) , (\\S+)$", "a row from left to right : {1} , {2} , {3}"),
    ("^(?:\\( )?(\\S+) , (\\S+) , (\\S+)(?: \\))? : left , (?:middle|center) , right$", "a row from left to right : "
     "{1} , {2} , {3}"),
    ("\\b(nearest|closest|nearer|closer) (?=the (?:robot|viewer|camera)\\b)", "{1} to "),
    (f"^(?:(?:{PUT}|position|add|have) )?(?:an?|one) (block|cube) at (each|either) end of the (row|line|column|tower|"
     f"stack) of ([^,]+?) , both ({COLOR})$",
     "a {5} {1} at {2} end of a {3} of {4}"),
    ("\\b(start|goal) : all(?: (?:blocks|cubes|of them))?(?: are)? on the (left|right)(?: side)?(?: of the table)?$",
     "{1} : all blocks in the {2} half of the table"),
    # what lies on it now
    (f"^(?:{_NOW}(?: ,)? )there (?:is|are) ([^,]+?) (on (?:top of )?(?:it|them))$", "at the start {1} are {2}"),
    (f"^there (?:is|are) ([^,]+?) (on (?:top of )?(?:it|them)) {_NOW}$", "at the start {1} are {2}"),
    # one on each
    ("^(\\w+ (?:mats|patches|zones|areas|targets))(?: ,|:)+ on (?:each|every)(?: one)?(?: of (?:them|these))? (an? "
     "[^,]+)$",
     "{1} , {2} on each"),
    # in other words for a line
    (f"^(?:please )?(?:{PUT}|line up|arrange|line) ([^,]+?) (?:one )?behind (?:each other|one another|the (?:other|"
     "next))((?: ,)? with .+)$", "put {1} in a column {2}"),
    ("^(?:please )?(?:stack|pile)(?: them| it| the blocks| the cubes| up)? (?:as follows|like this|like that|this way|"
     "in this way|the following way) [:,]", "a stack :"),
    # what is told in letters
    *((f"\\bpattern (?:of )?{''.join(way)}(?: ,| with| using| where|\\()* {told}(?: \\))?", f"pattern "
       f"{' , '.join(of[x] for x in way)}")
      for way in _WAYS for told, of in ((_FOR_LETTERS, {"a": "{1}", "b": "{2}"}), (_LETTERS_ARE, {"a": "{1}",
       "b": "{2}"}))),
    (f"\\b{_THOSE} (?:that|which|with) (?:have |show |bear |carry |has )?an? (vowel|consonant|letter|digit)(?: on "
     "(?:them|it))?\\b",
     "all {1s}"),
    # which way it goes
    *(("\\b(?:so that |such that |with )?(?:the )?(?:numbers?|digits|they) (?:count|counting|go|going|run|running) "
       f"{down} as (?:you|it|they|we|the tower|the stack) (?:go|goes|move|climb|get) (?:{up})$",
       f"in {order} order from {way}")
      for down, order in (("down", "descending"), ("up", "ascending"))
      for up, way in (("up|higher|upwards", "bottom to top"), ("down|lower|downwards", "top to bottom"))),
    (f"^(?:this (?:end|side) up : )?((?:the )?(\\w) (?:block|cube)) ({MUST}) have (?:its|it is) (?:letter|symbol|"
     "number|\\2) (?:on top|up|facing up|upwards|facing upwards|at the top)$",
     "{1} {3} face up"),
    # what stands where in the line
    ("^([^,]+ at (?:the|both)(?: two)? ends (?:and|,) [^,]+ between them)(?: ,)? (?:lined up|in (?:a|one) (?:row|"
     "line))$",
     "in a row : {1}"),
    ("^(?:put|place|arrange|line up|lay|sort) (?:the |these )?(?:cubes|blocks|letters)(?: in a row)?(?: ,)? in the "
     "(?:same )?order (?:as|of)(?: in)?(?: the)? (?:letters (?:in|of) )?(?:the )?(?:word|name) "
     "(\\S+)$", "spell {1} in a row"),
    ("\\b4 (?:in|at) the (base|bottom|lowest)( layer| level| row)? \\( 2x2 \\)", "4 blocks in the base layer"),
    # what there was
    (f"^(?:i|we|somebody|someone|the kids|the children)(?: have| has)? (?:built|made|stacked) (an? {_LINE}(?: :| of| "
     "from| ,) .+)$",
     "there is {1}"),
    ("\\b(?:(?:take|pull) it (?:down|apart) and (?:then )?)?(?:rebuild|restack|build|stack) it (?:again )?(?:the other "
     "way (?:around|round)|upside down|in reverse|backwards|in reverse order)$", "reverse it"),
    ("^use (?:every|all)(?: the| of the)? (?:blocks?|cubes?) : (.+)$", "there are {1}"),
    ("^(?:do not|never) stack (?:anything|any of them|any|any (?:blocks?|cubes?)|(?:the )?(?:blocks|cubes))$",
     "no block must be on another block"),
    # who reads it
    (f"^(.*\\b(?:write|spell|(?<!of )the word|the name)\\b .+?)(?: ,)? so (?:that )?{READER} can (?:easily |all )?read "
     "(?:it|the word)$", "{1}"),
    # what lies across two
    (f"\\bon(?: top of)? (two (?:{COLOR} )?(?:ones|{CUBE}s)) (?=(?:that|which) (?:are|stand|lie|sit) (?:next to|"
     "beside) (?:each other|one another)\\b)", "across {1} "),
    # the row behind
    (f"^(?:two rows(?: ,| :) )?(?!two )(.+? in) the (?:front|near) row ({_WAY})(?: ,)?(?: and)? (.+?) in the (?:back "
     f"row|row behind(?: it| that)?)(?: ,)? (?!\\2)({_WAY})$", "{1} a row {2} , behind it a row of {3} {4}"),
    (f"^(.+? in the) (?:front|near) row( {_WAY})?(?: ,)? and (.+?) in the row behind(?: it| that)?$",
     "two rows : {1} front row {2} , and {3} in the back row {2}"),
    (f"^(.+? in the) (?:front|near) row( {_WAY})?(?: ,)? and (.+?) in the row behind(?: it| that)?((?: ,)? {_WAY})$",
     "two rows : {1} front row {2} , and {3} in the back row {4}"),
    # which ones, and which word
    ("\\b(odd|even) numbered (?:blocks|cubes|ones) (?:\\( (?:from )?(\\d) to (\\d) \\)|(?:from )?(\\d) to (\\d))",
     "{1} numbers from {2} {4} to {3} {5}"),
    ("\\bevery color of the rainbow\\b", "all the colors of the rainbow"),
    ("\\b((?:row|line|column|tower|stack))(?: consists| is made| is made up)? of pairs :", "{1} :"),
    *((f"^{begun}({COLOR}) and ({COLOR})(?: blocks| ones)?(?: ,)? (?:taking turns|in turns?|by turns|alternating|"
       f"alternately)(?: ,)? ({MANY}) (?:blocks|cubes)(?: in all| in total)?(?: ,)? (?:and )?(beginning|starting) and "
       f"ending with ({COLOR})$",
       f"a {line} of {{3}} blocks alternating {{1}} and {{2}} , {{4}} and ending with {{5}}")
      for line, begun in (("row", "line up "), *((x, f"(?:make |build |form )?a {x} of ") for x in ("row", "column",
       "tower")))),
    ("\\b(?:spell(?: out)?|write|form) (?:the name of )?(?:my|our|his|her|their|the) \\w+ (?:'s (?:first |last )?name "
     ")?, (\\S+)",
     "spell {1}"),
    ("^(?:take )?the word (\\S+)(?: ,)? and (?:turn|change|make|rearrange) it (?:in)?to (?:the word )?(\\S+)$",
     "there is the word {1} . turn it into the word {2}"),
    # which side of the table, and of two mats
    (f"\\b(edge|side|half|end) of the table (?:(?:which|that) is )?(?:closest|nearest)(?: to)? {ME}\\b",
     "near {1} of the table"),
    (f"\\b(edge|side|half|end) of the table (?:(?:which|that) is )?(?:farthest|furthest)(?: away)?(?: from)? {ME}\\b",
     "far {1} of the table"),
    (f"\\b(halfway |midway |exactly |right |in )?between the (left|right|{COLOR}) and (?:the )?(left|right|{COLOR}) "
     f"{PATCH}$",
     "{1} between the {2} patch and the {3} patch"),
    ("^(?:align|line up) ([^.:;]*?(?:\\b(?:and|them|all)\\b|s\\b)[^.:;]*?) (?:with|along|to|at) "
     "(the (?:near|far|left|right|front|back) edge of the table)$", "put {1} in a line along {2}"),
    ("^(?:align|line up) ([^,]+?) (?:with|along|to|at) (the (?:near|far|left|right|front|back) edge of the table)$",
     "put {1} at {2}"),
    # which board
    ("^(?:this is |make |build |lay )?(?:the |a )?(?:corner|piece|part|bit|section) of a (chess board|chessboard|"
     "checkerboard|board of checkers) :", "a checkerboard :"),
    (f" with an? ({COLOR}) main diagonal\\b", " , the diagonal from the far left to the near right is {1}"),
    ("\\b(?:the|a|its) main diagonal\\b", "the diagonal from the far left to the near right"),
    # never beside its like
    (f"^({_TWO} of (?:the )?same color (?:can|may|must|should|are|will) (?:never|not)(?: be| stand| lie)? (?:neighbors|"
     "next to each other|adjacent|side by side|direct neighbors)) (in the (?:row|line|tower|stack))$", "{2} , {1}"),
    # what is changed, and what not
    (f"^({THING} and {THING}) swap (?:with each other|with one another|over|around|round|too|as well|also)$",
     "{1} swap places"),
    (f"^(?:nobody|no one|no robot) (?:ever )?(?:moves|touches|disturbs|has (?:moved|touched|disturbed)|"
     f"(?:may|can|{MUST}|has ever|is (?:allowed|permitted) to) (?:ever )?(?:have )?(?:move|touch|disturb)(?:d|ed)?) "
     f"({THING})$", "do not move {1}"),
    ("\\bthe table 's (left|right|near|far|front|back) (half|side|edge)\\b", "the {1} {2} of the table"),
    # what stays where it is
    (f"^({MANY} {COLOR})(?: {CUBE}s?)?(?: (?:are |is )?on (?:the )?table)?{_UNTOUCHED}$",
     "the {1} blocks must stay where they are"),
    (f"^({THING}|(?:the )?{COLOR}){_UNTOUCHED}$", "do not move {1}"),
    (f"^{_UNMOVED}$", "it must stay where it is"),
    (f"^(.+?) , {_UNMOVED}$", "{1} . it must stay where it is"),
    (f"^{_WITHOUT} ({THING})(?: ,)? ({_AROUND}) (?:it|this|that)(?: one)? ((?:with|by) .+)$",
     "{2} {1} {3} . {1} must not be moved"),
    (f"^({_AROUND}) ({THING}) ((?:with|by) .+?)(?: ,)? {_WITHOUT} (?:it|this|that)(?: one)?$",
     "{1} {2} {3} . {2} must not be moved"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
PLAIN_TALK: tuple[Turn, ...] = (
    # who sees it, and what there is to be seen
    (f"\\b(i|we) (want|need|would like|would love) (?:{READER} )?to (?:see|read|get|find) (?=the |an? )", "{1} {2} "),
    (f"\\bi count (?={MANY} )", "there are "),
    (f"(?: ,)? so(?: that)? {READER} (?:can )?reads? (?:them|it) (like a (?:page|book|text))$", " , read {1}"),
    (f"\\b(everything|all (?:of it|(?:the )?{_BLOCKS})) ([^,:]+?)(?: ,| -) (?:that|these|those) (?:is|are) (?=the )",
     "{1} {2} : "),
    # how it should not be
    (f"^(?:do not|never) let ({THINGS}) be (?:too )?(close|near)(?: together| to (?:each other|one another))?(?= ,|$)",
     "{1} must not be {2} to each other"),
    # in whichever order the words are
    (f"^((?:{PUT}|build|make|stack)) first ", "first {1} "),
    # what it is for
    (f"^(?:(?:i|we) (?:need|want|have|would like) )?(?:something |(?:an? |the |this )?{_ERRAND} )?(?:for|to (?:test|"
     f"train|try|check)) (?:my|our|the|this) (?:{_KIND} ){{0,2}}{_AGENT}(?: please)? :", ""),
    # one after the other
    (f"^(?:in (?:this|that|the following) order : )?(?:first|firstly)(?: ,)?(?: of all)?(?: ,)? (?:{PUT} "
     f")?({THING})(?: {_GO})? ({PLACE} [^,]+?){_NEXT} ({THING}){_LAST} ({THING})(?: goes there| there)?$",
     "first put {1} {2} . then put {3} {2} . finally put {4} {2}"),
    (f"^(?:in (?:this|that|the following) order : )?(?:first|firstly)(?: ,)?(?: of all)?(?: ,)? (?:{PUT} "
     f")?({THING})(?: {_GO})? ({PLACE} [^,]+?){_NEXT} ({THING})(?: goes there| there)?$",
     "first put {1} {2} . then put {3} {2}"),
    # at both ends
    (f"^(?:{PUT}|position|add|have) ((?:an?|one) {COLOR} (?:block|cube)) at each end of (?:the|a) {_ROW} of ([^,]+)$",
     "{1} at each end of a {2} of {3}"),
    # where it may be
    (f"^(?:{PUT} )?({THING})(?: {MUST}(?: be| go| lie| stand)?)? (?:any|some)where (on the (?:table|desk))(?: ,)? "
     f"(?:except|but|other than)(?: for)? ((?:{PLACE}|at|not) .+)$", "{1} must be {2} . {1} must not be {3}"),
    # by colour
    (f"^(?!.*\\b(?:letters?|digits?|numbers?|big|small|large|sizes?|patch|mat)\\b)(?!.*\\b{COLOR}\\b)(.*\\b{MANY} "
     f"{_BLOCKS}\\b.*?)(?: ,)?(?: any colors?)?(?: ,)?(?: but)? no two(?: of them)? (?:the same|alike|identical)$",
     "{1} , all of different colors"),
    (f"^(?:please )?(?:tidy|clear|clean|put|pack|sort|straighten)(?: up| away| out)? {_ALL}(?: up| away| out)? by "
     "(color|colors|letter|number|kind)", "sort {1} by color"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("policy model controller parser motion odd sequence tear pieces chess straighten",)
"""Words that these take besides those that are read anyway."""
