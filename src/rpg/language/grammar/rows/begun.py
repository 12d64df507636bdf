"""How things are at the beginning, in whichever words: what is given, what carries what, where something comes from, as
rows that say it in a sentence of its own."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LIES, LINE, MANY, MUST

BRICK = "(?:block|cube|brick)"
MAT = "(?:patch|mat|zone|target|area|spot)"
MARK = f"(?:the|an?) \\w+ {MAT}"
HEAP = "(?:heap|pile|jumble)"
_SHAPE = f"(?:{LINE}|{HEAP})"
EVENT = "(?:episode|task|run|game|process|procedure|exercise|operation|trial|simulation|test|round|level|puzzle|match)"
TIME = (
    "(?:at (?:the )?(?:very )?(?:start|beginning|outset)|initially|originally|in the beginning|to (?:begin|start) "
    "with|"
    "at first|currently|right now|now|at the moment|at present)"
)
"""When something is so at the beginning; with a blank behind it where it stands in front."""
_LED = f"(?:{TIME} (?:, )?)"
_AT_START = f"(?=.*\\b(?:{TIME}|(?:we|you) (?:start|begin) with\\b))"
"""Somewhere in the sentence it is said that this is so at the beginning."""
END = (
    f"(?:(?:(?:at|by) the end of|after) the {EVENT}|"
    "(?:at|in) the end|finally|afterwards|when (?:you are|all is|everything is) done)"
)
STARTS = "(?:starts?|begins?)(?: out| off)?"
SITS = f"(?:{LIES}|(?:is|are) (?:lying|sitting|standing|located|placed|resting)|{STARTS})"
ONE = f"(?:(?:the |an? )?{COLOR}(?: {BRICK}| one)?)"
"""A block by its colour."""
CHAIN = f"(?:{COLOR}(?: (?:on top of|on|over|above) {COLOR})+)"
LIST = f"(?:{COLOR}(?:(?: ,| and| , and|)(?: then)? {COLOR})+)"


def _layers(places: str) -> str:
    """Blocks of which each is told with its place in a line, or in the order of the line."""
    one = f"(?:{COLOR}|[a-z]|\\d)"
    layer = f"{one} (?:{places})"
    return f"(?:{layer}(?:(?: ,| and| , and|)(?: then)? (?:{layer}|{one}\\b))+)"


_LEVELS = "at the bottom|in the middle|on top|at the top|lowest|highest"
_SIDES = "on the left|in the middle|on the right"
LAYERS, LAYERS_UP, LAYERS_ACROSS = _layers(f"{_LEVELS}|{_SIDES}"), _layers(_LEVELS), _layers(_SIDES)
_SIDE = "(?:bottom|top|left|right|front|back)"
UP = (
    f"(?:(?:counted |listed |told |seen )?from (?:the )?{_SIDE}(?: to (?:the )?{_SIDE}| up| upwards| down| "
    f"downwards)?|"
    f"(?:bottom|left|front) to (?:top|right|back)|top to bottom)"
)
ORDER = f"(?:{UP} (?:, |: )?{LIST}|{LIST}(?: ,)? {UP}|{LAYERS})"
"""An order in full."""
_REGION = "(?:the )?((?:left|right|near|far|front|back) half|(?:(?:near|far|front|back|left|right) ){2}(?:corner|one))"
_TABLE = "(?: of the table)?"
_THERE = "(?:there|on the table|already there|already standing there|standing there|in place)"
MOVE = "(?:put|move|bring|carry|take|transfer)"
_BROUGHT = "(?:be )?(?:brought|moved|taken|carried|transferred|put)"
GOES = f"(?:goes|travels?|moves?|wanders?|comes|gets|{MUST} (?:go|travel|move|get|come|{_BROUGHT}))"
WHICH = "(?:which|that|who)"
_WHERE_IT_IS = f", (?:where|on which|in which|which is where) (?:it|they) (?:{SITS}|{TIME} {SITS})(?: {TIME})?"
COMMAND = (
    "(?:put|place|move|bring|take|carry|transfer|stack|unstack|build|rebuild|make|turn|reverse|swap|exchange|replace|"
    "sort|line|leave|add|clear|empty|set|dismantle|rearrange|arrange|get|let|separate|switch|keep)"
)
_THEM = (
    f"(?:it|its|they|them|both|the|an?|all|each|every|everything|that|this|one|up|apart|there|nothing|none|no|"
    f"{MANY}|{COLOR})"
)
_FACT = (
    f"((?:the|an?|on|there|we|you|i|everything|{MANY}|{COLOR}|{TIME})\\b(?:(?!{MUST}|\\b(?:which|that|where|if|when|"
    f"once|"
    f"until|unless)\\b)"
    f".)*? (?:{SITS}|has|have|holds|carries|form|{TIME})\\b(?:(?!{MUST}).)*?)"
)
"""How something is, by nothing but facts."""
_BECOMES = f"(?:{MUST}|becomes?|ends?|finish(?:es)?|goes|comes|turns?)"
_A_LINE = f"(?:the {BRICK}s|all {BRICK}s|three {BRICK}s|everything)"
_HAVE = "(?:there (?:is|are)|we have|you have|i have|(?:we|you) (?:start|begin) with)"
_GETS = "(?:gets?|has|have|is given|are given|receives?|finds?)"

_CARRIES = "(?:has|holds|carries|bears)"
_LISTED = f", (?:{ORDER})(?: ,)?"
_UNDO = "(?:reverse|invert|flip|rebuild|restack|unstack|dismantle|disassemble)"
"""What is done to a line that is there."""
_LAY = f"(?:{LIES}|was|(?:is|was|has been|got) (?:put|placed|left|laid|set))"
_ON_IT = f"(?:on|in|next to|behind|under|in front of) (?:the |an? )?{COLOR}(?: (?:{BRICK}|{MAT})| one)?"
_IN_A_HEAP = f"in (an?|one) (?:settled |random |messy |mixed |loose )?({HEAP})"
_OF_EACH = (
    f" , ({MANY})(?: of them)? ({COLOR})(?: ones)?(?: ,| and| , and) ({MANY})(?: of them)? ({COLOR})(?: ones)?\\b"
)
_ONE_OF_TWO = f"(?:the|an?|both|all) [^,]+? {STARTS} [^,]+? and (?:go(?:es)?|ends?|moves?|{MUST}) [^,]+?"
_BEFORE = "(?:in front of|before) (?:you|us|me|the robot)(?: there)?"

BEGUN_AT_ONCE: tuple[Turn, ...] = (
    ("^(.+?) (?:is|are) how (?:it|they|things|everything|we) (?:all )?(?:starts?|begins?)$", "at the start {1}"),
    ("^(?:given|provided) (is|are) (?!that\\b)", "there {1} "),
    (f"^(?:you (?:will )?(?:find|see|encounter|be given)|{_BEFORE} (?:is|are|stands?|lies?|(?:you|we) (?:find|see))) "
     f"(?=(?:an?|two|three) (?:\\w+ )?{_SHAPE}s?\\b)", "at the start there is "),
    (f"\\b(?:(?:at|on|upon) reset|when (?:the|this|an|each|every) {EVENT} (?:starts|begins)|when (?:we|you) "
     "(?:start|begin)(?= [,:]|$))\\b", "at the start"),
    (f"^the (?:initial|starting|original) ({LINE}) (is|has|stands|reads) ", "at the start the {1} {2} "),
    (f"^in the (?:final|resulting|finished) {LINE}(?: ,)? (?=(?:the )?{COLOR}\\b)", "at the end "),
    (f"^(?:and |but )?when (?:it|the {EVENT}) (?:ends|is over)(?: ,)? (?=(?:the|an?|all|both|{MANY}|{COLOR})\\b)",
     "at the end , "),
    (f"^there (is|are) (an? {LINE}(?: of [^:,]+?)?) {TIME} (?=:)", "at the start there {1} {2} "),
    (f"^everything {STARTS} ", "all blocks start "),
    (f"^({TIME})(?: ,)? everything {LIES} ", "{1} all blocks are "),
    (f"^everything {LIES} ([^,]+? {TIME})$", "all blocks are {1}"),
    ("^(start|end|goal|initial state|start state|final state) , (?!then\\b|at last\\b)", "{1} : "),
    (f"^(?:start|initial state|starting (?:state|scene|position)) : "
     f"(?=.*\\b(?:{TIME}|starts?|begins?|starting)\\b)", ""),
    (f"(^|: )when (?:you are|everything is|all is) (?:done|finished)(?: ,)? (?={_THEM}\\b)", "{1} at the end , "),
    (f"^(?:please )?(take|remove|lift|pick|get|move) ({ONE}) (?:up |away )?(?:off|from) (?:the )?top of (?:the|an?) "
     f"(tower|stack) (?:of |with |made of |from )?({LIST})(?: blocks| cubes)?(?= and |$)",
     "at the start there is a {3} of {4} with {2} on top . {1} {2}"),
    ("^to (?:get (?:to|at)|reach|access|free) [^,]*?\\b(?:of|in|under) (the (?:tower|stack)\\b.*?) , ((?:please )?"
     "(?:first )?(?:unstack|dismantle|take apart|take down)) it\\b", "{2} {1}"),
    (f"^((?:the|all|these|my|our|{MANY}) [^,:]*?\\bin an? (?:row|line|column)) {TIME} :", "at the start {1} :"),
    # two of whom each begins somewhere and goes elsewhere
    (f"^({_ONE_OF_TWO})(?: ,)?(?: and| while| whereas| but|(?<= ,)) ({_ONE_OF_TWO})$", "{1} . {2}"),
    # how it is, and what becomes of it, in one sentence
    (f"^([^,:]+?) , (stacked|scattered|in an? (?:heap|pile|row|tower)) {TIME} , (?=(?:are|is) to be\\b|{MUST}\\b)",
     "{1} that are {2} at the start "),
    (f" , which (?:{MUST} )?{TIME} (?:be |are |lie )?(?:lying |all )*(in an? (?:heap|pile|row|tower))$",
     " , which are {1} at the start"),
    ("^from (an? (?:settled )?(?:heap|pile) of [^,:]+?(?: , [^,:]+ and [^,:]+)?) , sort (by \\w+)$", "sort {1} , {2}"),
    (f"^{_FACT} [,:] ((?:please )?(?:first )?{COMMAND} {_THEM}\\b.+)$", "{1} . {2}"),
    (f"^(?!there (?:is|are) ,){_FACT} [,:] (?:and |but )?({END})(?: ,)? ({_THEM}\\b.+)$", "{1} . {2} , {3}"),
    (f"^(?!there (?:is|are) ){_FACT} [,:] (?:and |but )?((?:it|they|both|the two|each|all"
     f"|(?:the )?{COLOR}(?: one| {BRICK})?) {_BECOMES}\\b.+)$",
     "{1} . {2}"),
    (f"\\b(from [^,]+?) {_WHERE_IT_IS} ,? ?(?=(?:over )?(?:to|onto|into|back) )", "{1}"),
    (f"\\b((?:leave|keep) [^,]+? where (?:it|they)) (?:{STARTS}|started|began|was|were)(?: {TIME})?\\b", "{1} is"),
    (f"^(an? (?:\\w+ )?{_SHAPE}\\b.+?)(?: ,)? is (?:given|already there|what (?:you|we|i) start with|the start)$",
     "at the start there is {1}"),
    (f"^from ({MARK}) , where (?:it|they) {SITS}(?: {TIME})? , ({ONE}) (.+)$",
     "at the start , {2} is on {1} . {2} {3}"),
    (f"^(.+?) and keep ({ONE}) , {WHICH} {STARTS} on ({MARK}) , on (?:that|the|the same) {MAT}(?: the whole time)?$",
     "at the start , {2} is on {3} . {1} and keep {2} there the whole time"),
    # "it is there now", behind what is to be done with it; "there is one there now"
    *((f"^there (?:is|are) {already}((?:an?|{MANY}) .+?) there{now}$", "{1} start there")
      for already, now in (("already ", f"(?: {TIME})?"), ("", f" {TIME}"))),
    *((f"{begun}(it|they) ({SITS}) ([^,]+?) (?:right )?now$", f"{told}at the start , {{{n}}} {{{n + 1}}} {{{n + 2}}}")
      for begun, told, n in (("^", "", 1), (f"^((?:please )?{COMMAND} .+?) , (?:and )?", "{1} . ", 2))),
    # heaps
    (f"^(?:from|out of) (?:the|a|your|this) ({HEAP}) of ({MANY} (?:{COLOR} )?{BRICK}s)(?: ,)? "
     f"(?:take|get|pick|remove) ({MANY})(?: of them)?(?: ,)? and (put|place|set|move|stack|lay) (?:them|it) ",
     "at the start there is a {1} of {2} . {4} {3} of them "),
    (f"^({MANY} of) the ({MANY} (?:{COLOR} )?{BRICK}s) (?:in|from) (?:the|a) ({HEAP}) (?={MUST} )",
     "at the start there is a {3} of {2} . {1} them "),
    (f"^{_LED}?(?:the robot|we|you|i) {_GETS} (an? (?:\\w+ )?{HEAP} (?:of|with)\\b.+)$", "at the start there is {1}"),
    (f"^(?:the )?(?:initial|starting|given) ({HEAP}) (?:: |is |of |has )(.+)$", "at the start there is a {1} of {2}"),
    (f"^{_AT_START}{_LED}?({MANY} {BRICK}s) (?:lie|are|start|begin)(?: {TIME})? {_IN_A_HEAP}(?: {TIME})?{_OF_EACH}",
     "at the start there is {2} {3} of {1} , {4} {5} and {6} {7}"),
    (f"^({MANY} {BRICK}s) (?:start|begin) {_IN_A_HEAP}{_OF_EACH}",
     "at the start there is {2} {3} of {1} , {4} {5} and {6} {7}"),
    (f"^({MANY} {BRICK}s) lie {_IN_A_HEAP}{_OF_EACH}", "there is {2} {3} of {1} , {4} {5} and {6} {7}"),
    (f"^(.+?) , {WHICH} (?:{TIME} )?(?:lie|start|begin|are|lying)(?: {TIME})?(?: lying)? (in an? "
     f"{HEAP})(?: {TIME})?(?: ,)? ({MUST}) (.+)$", "at the start {1} lie {2} . they {3} {4}"),
    (f"^(.+?) (?:from|of|out of) ({MANY} (?:{COLOR} )?{BRICK}s) , {WHICH} (?:{TIME} )?(?:lie|are|"
     f"start)(?: {TIME})?(?: lying)? (in an? {HEAP})(?: {TIME})?$", "at the start {2} lie {3} . {1} from them"),
    (f"^(?:out of|from) the ({HEAP}) in which (?:the )?(.+?) {SITS}(?: {TIME})? , (.+)$",
     "at the start {2} lie in a {1} . {3}"),
    # layers told of blocks
    (f"\\bthe ({COLOR}) (?:{BRICK}|one) (at the bottom) ,(?: and)? the ({COLOR}) (?:{BRICK}|one) (in the middle)(?: "
     f",)? "
     f"and the ({COLOR}) (?:{BRICK}|one) (on top|at the top)\\b", "{1} {2} , {3} {4} and {5} {6}"),
    (f"\\bthe ({COLOR}) (?:{BRICK}|one) (on top|at the top) ,(?: and)? the ({COLOR}) (?:{BRICK}|one) (in the "
     f"middle)(?: ,"
     f")? and the ({COLOR}) (?:{BRICK}|one) (at the bottom)\\b", "{1} {2} , {3} {4} and {5} {6}"),
    # lines that are there
    (f"^the ({LINE}) (?:that|which) is (?:already )?there(?: now| {TIME})? (?:is|has|reads) ({CHAIN}|{ORDER})$",
     "at the start the {1} is {2}"),
    (f"^take the ({LINE}) (?:that|which) is (?:already )?there ({_LISTED}) apart\\b",
     "at the start there is a {1} {2} . take it apart"),
    (f"^(?:reverse )?the order of the ({LINE}) (?:that|which) is (?:already )?there ({_LISTED})"
     f"(?: {MUST} be reversed)?$", "at the start there is a {1} {2} . reverse its order"),
    (f"^{_LED}?the ({LINE}) {STARTS} as ({CHAIN})$", "at the start there is a {1} of {2}"),
    (f"^{_LED}?the ({LINE}) {STARTS}(?: as| with| like this :)? ({ORDER})$", "at the start there is a {1} : {2}"),
    (f"^{_LED}the ({LINE}) (?:has|is|reads) ({ORDER})$", "at the start there is a {1} : {2}"),
    (f"^({UP}) the ({LINE}) {STARTS}(?: as| with)? ({LIST})$", "at the start there is a {2} : {3} {1}"),
    (f"^the ({LINE}) {TIME} (?:has|is|reads)(?: ,)? ({ORDER})$", "at the start there is a {1} : {2}"),
    (f"^the ({LINE}) (?:is|has|reads) {TIME} ({ORDER})$", "at the start there is a {1} : {2}"),
    (f"^the ({LINE}) (?:is|has|reads) ({ORDER}) {TIME}$", "at the start there is a {1} : {2}"),
    (f"^{_A_LINE} (?:{STARTS}|(?:are|is) {TIME})(?: stacked)? (?:in|as) (?:an?|one) ({LINE}) [,:] ({ORDER})$",
     "at the start there is a {1} : {2}"),
    (f"^{_A_LINE} (?:{STARTS} stacked|are stacked {TIME}) [,:] ({ORDER})$", "at the start there is a tower : {1}"),
    (f"^{_A_LINE} (?:{STARTS} lined up|are lined up {TIME}) [,:] ({ORDER})$", "at the start there is a row : {1}"),
    (f"^(?:the )?left(?:most)? {BRICK} (?:of|in) a row is ({COLOR}) {TIME} , the middle one (?:is )?({COLOR})(?: ,)? "
     f"and the right(?:most)? one (?:is )?({COLOR})$", "at the start there is a row : {1} , {2} , {3} from left to "
     "right"),
    (f"^(?:the |an? )?({COLOR})(?: {BRICK})? {STARTS} on (?:the |an? )?({COLOR})(?: {BRICK}| one)? , {WHICH} {SITS} "
     f"on "
     f"(?:the |an? )?({COLOR})(?: {BRICK}| one)?$", "at the start there is a tower of {1} on {2} on {3}"),
    (f"^{_AT_START}{_LED}?(?:{_HAVE} )?two (?:towers|stacks)(?: {TIME})? [,:] ({COLOR}) on ({COLOR})(?: and| ,| , and) "
     f"({COLOR}) on ({COLOR})$", "at the start , {1} is on {2} and {3} is on {4}"),
    (f"^two stacked {BRICK}s {TIME} [,:] ({ONE}) on(?: top of)? ({ONE})$", "at the start , {1} is on {2}"),
    (f"^(?:take )?(?:the|an?) ({LINE})(?: of)? (.+?)(?: ,)? {WHICH} (?:is|stands|lies)(?: already)?(?: standing| "
     f"lying)? "
     "(?:there|here)(?: ,)? and (.+)$", "at the start there is a {1} of {2} . {3}"),
    (f"^({_UNDO}(?: the order of)?) (?:the|an?) ({LINE}) {WHICH} (?:{STARTS} (?:as|with)|is|has) ({CHAIN})$",
     "at the start there is a {2} of {3} . {1} it"),
    (f"^({_UNDO}(?: the order of)?) (?:the|an?) ({LINE})(?: of {MANY} {BRICK}s)?(?: ,)? {WHICH} (?:is|has|"
     f"{STARTS} (?:as|with)) ({ORDER})$",
     "at the start there is a {2} : {3} . {1} it"),
    (f"^the (?:final|finished|resulting|completed) ({LINE})(?: of {BRICK}s)? (?:has(?: the order)?|is|reads|shows|"
     f"{MUST} (?:be|have|read|have the order))(?: :)? ({ORDER})$", "build a {1} : {2}"),
    # what is on a patch, told aside
    (f"^(?:clear|empty) ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})?$", "at the start , {2} is on {1} . "
     "clear {1}"),
    (f"^((?:first )?(?:clear|empty) ({MARK})) \\( ({ONE}) {SITS} (?:there|on it) \\)(?: ,)? (.*)$",
     "at the start , {3} is on {2} . {1} , {4}"),
    (f"^from ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})? , (?:it|they) {GOES} (?:to|onto|on) (.+)$",
     "at the start , {2} is on {1} . put {2} on {3}"),
    (f"( , {WHICH} {SITS} on ({MARK})(?: {TIME})? ,) ((?:{MUST} )?(?:stays?|remains?)) (?:there|on it)\\b", "{1} "
     "{3} on {2}"),
    (f"^({ONE} and {ONE}) , {WHICH} (?:start|begin)(?: out)? ([^,]+?) , {MUST} (?:end|finish)(?: up)? (.+)$",
     "at the start {1} are {2} . at the end they must be {3}"),
    (f"^separate ({ONE}) from ({ONE}) [,:] (touching|next to each other|side by side) at (?:the )?start , (.+?) at "
     f"the end$",
     "at the start , {1} and {2} are {3} . at the end , {1} and {2} must be {4}"),
    (f"^swap the two {BRICK}s on the (?:patches|mats|zones|spots|areas) [,:] (.+? {STARTS} on .+)$", "{1} . swap "
     "the two"),
    (f"^(.+? {STARTS}) (?:in|on) the (left|right|near|far) side(?: of the table)?(?=$| [,:])",
     "{1} in the {2} half of the table"),
    # where it does not belong
    (f"^({ONE}) {_LAY} ({_ON_IT})(?: ,)? (?:but|where|and) (?:(?:it|that) )?(?:does not belong(?: there)?|should not "
     "be(?: there)?|is wrong)$", "at the start , {1} is {2} . {1} must not be {2}"),
)  # fmt: skip
"""What is read otherwise as it stands."""

_WAY = f"from ({ONE}|the {MAT}|the table) (?:over |across )?(?:to|onto|on to|on) ({ONE})(?= [.;!]|$)"
_NO_MATS = (
    f"^(?!.*\\b(?:{COLOR} {MAT}|{MAT}e?s)\\b)((?:(?:(?!\\b(?:{COMMAND}|{MUST}|first)\\b)[^.;])*[.;] )*)(?:please )?"
)
"""Where mats are called by their colours, "from red to blue" may be from mat to mat; behind a command it is no
start."""
FROM_BLOCK_TO_BLOCK: tuple[Turn, ...] = (
    (f"{_NO_MATS}(?:{MOVE} ({ONE})|({ONE}) {GOES}) {_WAY}", "{1} at the start {2} {3} is on {4} . put {2} {3} on {5}"),
)  # fmt: skip
"""Over a whole text: of blocks, "from" tells what something is on, and "to" what it goes on."""
BEGUN: tuple[Turn, ...] = (
    (f"^(an?|one) ({LINE}) has ({LAYERS})$", "there is {1} {2} with {3}"),
    (f"\\b(an? {LINE}) ({LAYERS})$", "{1} with {2}"),
    (f"^({ONE}) {_LAY} ({_ON_IT}) (?:by mistake|by accident|accidentally|mistakenly|wrongly)$",
     "at the start , {1} is {2}"),
    (f"^({ONE}) {_LAY} ({_ON_IT})(?: ,)? but(?: it)? (?:really |actually )?belongs ({_ON_IT})$",
     "at the start , {1} is {2} . {1} must be {3}"),
    (f"^(?:the|this|each|every|our|my) {EVENT} {STARTS} with (?=an?\\b|the\\b|all\\b|{MANY}\\b|{COLOR}\\b)",
     "at the start there is "),
    (f"^put (an? .+?) on ({MARK}) only (?:after|when|once) ({ONE}) , {WHICH} {STARTS} (?:there|on it) , (?:has left it|"
     "is off it|is gone)$", "at the start , {3} is on {2} . first take {3} off {2} , then put {1} on {2}"),
    (f"^({ONE} {STARTS} on ({MARK})) and {MUST} never leave it$", "{1} . it must never leave {2}"),
    (f"^{TIME} (?:, )?the ({LINE}) is ({LIST})(?: ,)? ({UP}) , {END} ({LIST})$",
     "at the start there is a {1} : {2} {3} . build a {1} of {4} {3}"),
    (f"^{TIME} (?:, )?it is ({CHAIN}) , {END} (?:it is )?({CHAIN})$",
     "at the start there is a tower of {1} . build a tower of {2}"),
    # where a block comes from
    (f"^{MOVE} (.+?) from {_REGION}{_TABLE}(?: over)? (?:in)?to {_REGION}{_TABLE}$",
     "at the start , {1} is in the {2} of the table . put {1} in the {3} of the table"),
    (f"^(the [^,]+?|{COLOR}) {GOES} from {_REGION}{_TABLE}(?: over)? (?:in)?to {_REGION}{_TABLE}$",
     "at the start , {1} is in the {2} of the table . put {1} in the {3} of the table"),
    (f"^(the [^,]+?|{COLOR}) from {_REGION}{_TABLE} (?:in)?to {_REGION}{_TABLE}$",
     "at the start , {1} is in the {2} of the table . put {1} in the {3} of the table"),
    (f"^(?:clear|empty) ({MARK}) by (?:moving|putting|stacking|placing) ({ONE}) {WHICH} {STARTS} on it (on(?:to)? .+)$",
     "at the start , {2} is on {1} . put {2} {3}"),
    (f"^from {_REGION}{_TABLE} (?:in)?to {_REGION}{_TABLE} with (.+)$",
     "at the start , {3} is in the {1} of the table . put {3} in the {2} of the table"),
    ("^(.+?) 's (?:starting|start|initial) (?:place|position|spot|point) is ((?:in|on|at|next) .+)$",
     "at the start , {1} is {2}"),
    (f"^the (?:starting|start|initial) (?:place|position|spot|point) of ([^,]+?) is ({MARK})$", "at the start , {1} "
     "is on {2}"),
    # what a patch carries
    (f"^{_AT_START}{_LED}?({MARK}) {_CARRIES} ((?:(?! [,:] ).)+?)(?: on it)?(?: {TIME})?(?: on it)?(?: ,| and) "
     f"({MARK}) (?:has )?(an? (?:(?! [,:] ).)+?)(?: on it)?(?: {TIME})?$",
     "at the start , {2} is on {1} and {4} is on {3}"),
    (f"^{_AT_START}{_LED}?({MARK}) {_CARRIES} ((?:(?! [,:] ).)+?)(?: on it)?(?: {TIME})?(?: on it)?$",
     "at the start , {2} is on {1}"),
    # what is given
    (f"^{_AT_START}(an? (?:\\w+ )?{_SHAPE}\\b.+?)(?: ,)? (?:is|stands|lies|exists)(?: {_THERE})?(?: {TIME})?(?: "
     f"{_THERE})?$", "at the start there is {1}"),
    (f"^({CHAIN}) is what (?:you|we|i) (?:start|begin) with$", "at the start there is a tower of {1}"),
    (f"^with (.+?) {TIME} (in|on|at|next to) ([^,]+) , (.+)$", "at the start , {1} is {2} {3} . {4}"),
    (f"^(?:start(?:ing)?|begin(?:ning)?) from (an? {_SHAPE}\\b.+?) , (an? .+?) {MUST} be (?:built|made|formed|"
     f"assembled)(?: from "
     "(?:it|them))?$", "at the start there is {1} . build {2}"),
    (f"^from (an? {LINE})((?: ,|:| with| of) .+?)(?: ,)? ({COMMAND} .+)$", "at the start there is {1} {2} . {3}"),
    (f"^(?:unstack|dismantle|restack|rebuild|reverse) : ({CHAIN}) at (?:the )?start , (.+?)(?: at the end)?$",
     "at the start there is a tower of {1} . at the end , {2}"),
    (f"^from ({CHAIN}) to ({CHAIN})$", "at the start there is a tower of {1} . build a tower of {2}"),
    # what lies on a patch, and leaves it
    (f"^(?:the )?({MANY} (?:{COLOR} )?{BRICK}s) {WHICH} (?:{STARTS}|{TIME} {LIES}|{LIES})(?: {TIME})? (on .+?) "
     f"({MUST}) (.+)$",
     "at the start {1} are {2} . they {3} {4}"),
    (f"^{MOVE} (?:the )?({MANY} (?:{COLOR} )?{BRICK}s) (?:lying|starting|standing|sitting|that (?:start|lie|are)) "
     f"(on .+?) "
     "(?:to|onto|over to) (.+)$", "at the start {1} are {2} . put them on {3}"),
    (f"^(?:clear|empty) ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})? , by (?:moving|putting|stacking|"
     f"placing) (?:it|"
     f"that {BRICK}) (on(?:to)? .+)$", "at the start , {2} is on {1} . put {2} {3}"),
    (f"^from ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})? , (?:all(?: the)? {BRICK}s?|it|they|every "
     f"{BRICK}|both|all of "
     f"them) {MUST} be (?:removed|taken away|taken|cleared)$", "at the start , {2} is on {1} . clear {1}"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
WORDS = ("accident accidentally mistake mistakenly",)
"""Words that these take besides those that are read anyway."""
