"""Several towers told in roundabout ways: "both equally high", "one of height three and one of height two", "all red
ones in one tower, all blue ones in another", as rows that tell each of them plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, LINE, MANY, MUST, TOWER, WAY

_BLOCKS = "(?:blocks|cubes|ones)"
_TOWERS = "(?:towers|stacks)"
_EACH = "(?:both|all|each|every one)(?: of (?:them|these|those|which))?"
_EQUAL = (
    "(?:equally (?:high|tall)|(?:of |have |having )?(?:the same|equal|an equal) height|as (?:high|tall) as each other)"
)
_ARE = f"(?:(?:being|are|is|{MUST} be) )?"
_TALL = f"(?:with |of |having |has |that is |which is |is )?(?:a )?(?:height )?(?:of )?({MANY})(?: blocks| cubes)?"
_HIGH = "(?: high| tall| in height)?"
_OTHER = "(?:one|another|the other|a second|the second|a third|the third)(?: one| tower| stack)?"
_FIRST = "(?:one|the first)(?: one| tower| stack| of them)?"
_AND = "(?:, and|, while|and|,|while)"
_ASIDE = "(?:(?:to|on|at) )?(?:(?:the|its) )?(left|right)(?: side)?(?: of (?:it|that|this|that one))?"
_BESIDE = ("(?:(?:directly |right |immediately )?(?:to the left of|to the right of|left of|right of|behind|in front of|"
             "next to|beside))")  # fmt: skip
_THING = f"(?:(?:an?|the|one) )?(?:{COLOR}|[b-z0-9])(?: (?:block|cube|one))?"
_PAIR = f"(?:(?:{COLOR}|[a-z0-9]) and (?:{COLOR}|[a-z0-9]))"
_PILE = f"{_THING}(?: (?:on top of|on|over|above|atop) {_THING})+"
_STACKED = f"({MANY} {COLOR}s?(?: {_BLOCKS})?)(?: stacked(?: up)?)?"
_INTO = "(?:go |goes |belong |are |is |form |make |must be |should be |must form |should form |should go |must go )?"
_FLOOR = "(?:floor|storey|story|level)"
_FLOORS = "(?:floors|storeys|stories|levels)"
_GROUND = "(?:in|into|to)"
_FOOT = ("(?:below|lowest|first|down below|touching the table|on the table|at the (?:very )?bottom|at the base|at the "
         "foot|as the base|as its base)")  # fmt: skip
_ONE = f"(?:an? |the )?({COLOR})(?: block| cube| one)?"
_BEGINS = ("(?: ,)? (?:(?:and )?(?:starting|beginning) with|and begins with|and starts with|that (?:starts|begins) "
           f"with|with|and|,) {_ONE} (?:being |is )?{_FOOT}$")  # fmt: skip
_LOT = f"({MANY} {COLOR})(?: {_BLOCKS})?"
_TURNS = f"{_ONE}s? and {_ONE}s?"
_CHANGING = (
    "(?:with|in|of) (?:the |its )?(?:alternating|alternate) colors|(?:with |so that |and )?(?:the |their |its )?colors "
    "(?:alternate|alternating|take turns|taking turns|changing alternately|alternating each time)"
)
_IS = f"(?:is|are|{MUST} be)"
_SPOT = "(?:to the left of|to the right of|left of|right of|in front of|behind|next to|beside)"

_LABELS = "\\S(?:(?: ,| and| , and)? \\S)+"

_SOME_TOWERS = f"(?:(?:build|make|put up|form|i want|we need) )?{MANY} (?:{COLOR} )?{_TOWERS}"

TOWERS_AT_ONCE: tuple[Turn, ...] = (
    # each of several in short: "two gray towers, height two on the red mat, three high on the blue one"
    (f"^((?:build |make )?{MANY}) ({_TOWERS})(?: ,)? (?:both|all) ({COLOR})(?= (?::|,))", "{1} {3} {2}"),
    (f"^({_SOME_TOWERS}\\b[^.]*?(?: :| ,| and)) (?:height (?:of )?({MANY})|({MANY})(?: {_BLOCKS}(?: high| tall)?| "
     "high| tall))(?= (?:on|in) )", "{1} one of height {2} {3}"),
    (f"^({_SOME_TOWERS}\\b[^.]*?(?: :| ,| and)) the (?:one|tower|stack)(?: that is)? (on [^,.]+?)(?: {_IS})? (?:of "
     f"height )?({MANY})(?: {_BLOCKS})?(?: high| tall)(?=$| ,| and)", "{1} one of height {3} {2}"),
    # what comes on top, and not on what
    ("^((?:(?!\\b(?:bottom|base|middle|below|under|ground) ).)*?\\b(?:stack|pile|put|place|tower) "
     "(?:(?!\\b(?:bottom|base|middle|below|under|ground) ).)*?)(?: ,)? and on (?:the )?(?:very )?top "
     f"(?=(?:an?|one|the|another|{MANY}|{COLOR}|[a-z0-9])\\b)", "{1} and , on top , "),
    (f"^(make|build|form|create|stack) (?:from|out of) (?:the )?(letters|digits|blocks|cubes) ({_LABELS})(?: ,)? "
     f"(an?|one) ((?:vertical |single |tall |upright )?{LINE})\\b", "{1} {4} {5} from the {2} {3}"),
    (f"(?: ,)? to (?:read|spell) ({WAY})(?: the word)? (\\S+)$", " that reads {2} {1}"),
    (f"\\b((?:at the bottom|lowest) ,? ?then (?:an? |the )?{COLOR}(?:(?: ,| and)+ (?:then )?{COLOR})*?)(?: ,)? and "
     f"({COLOR}) (?:at|on) (?:the )?(?:very )?top\\b", "{1} , then {2} on top"),
    # what lies on each of several that have their blocks
    (
        f"^(?:the )?({MANY} {COLOR} {_TOWERS} of {MANY}(?: {_BLOCKS})?) (?:(?:{MUST} )?each (?:have|get)|"
        f"{MUST} (?:have|get) each|each (?:has|gets)) (.+) (?:on|at) (?:the |its )?(?:very )?top(?: of it)?$",
        "{1} , each with {2} on top",
    ),
    # a tower of these and one of those
    (f"\\b(an?) ({LINE}) of ({_PAIR})(?: ,)? and one of (?={_PAIR}\\b)", "{1} {2} of {3} and {1} {2} of"),
    # which one is meant
    ("\\b((?:on top of|on|onto|upon|atop|over|above|beside|next to|behind|in front of|left of|right of) the "
     "(?:taller|shorter|tallest|shortest)) one(?: of (?:them|these|the two))?\\b(?! of)", "{1} tower"),
    (f"\\b((?:{_BESIDE}|on|touching|near|underneath) )the one (?:at|on) the (bottom|top)$", "{1} the {2} one"),
    # until it is so high
    (f"^keep (?:piling|stacking|putting) ({COLOR} )?{_BLOCKS} (?:onto|on top of|on) (?:each other|one another) until "
     f"(?:the {TOWER}|it) is ({MANY})(?: {_BLOCKS})? (?:high|tall)$", "stack {2} {1} blocks"),
    (f"\\b({MANY}) (?:block|cube)s? (?:high|tall) ({COLOR} )?(?:column|pillar)\\b", "tower of {1} {2} blocks"),
    # what stands there stacked
    ("^([^,:]+?) , stacked(?: up)? , (?:all )?(?:standing|sitting|lying|resting|placed) (on [^,]+)$",
     "{1} , stacked , {2}"),
    # what is not on it
    (f"^((?!stack\\b).*\\b({TOWER})\\b[^:]*?)(?: ,)? (?:(?:and|with) )?nothing(?: else)?(?: (?:{_IS}|may be|lies))? on "
     f"(?:the )?top(?: of (?:it|that|the {TOWER}))?$", "{1} . nothing may be on top of the {2}"),
    (f"^((?:stack|put|place|set) ({_THING}) (?:on|onto|on top of) [^,]+?)(?: ,)? (?:(?:and|with) )?nothing(?: else)? "
     "on (?:the )?top$", "{1} with nothing on top of {2}"),
    (f"^({MANY})(?: blocks| cubes)? (?:high|tall) , all ({COLOR})(?: ones)?(?= ,|$)", "a tower of {1} {2} blocks"),
    # how high they are at least, and of which colour
    (f"\\b({TOWER})(?: ,)?(?: that is| which is)? (at least|at most) ({MANY})(?: blocks| cubes)? (?:high|tall)(?= |$)",
     "{1} of {2} {3}"),
    (f"\\b({MANY} {_TOWERS}\\b[^:]*?)(?: ,)? (?:one|a|a single) color (?:each|per (?:tower|stack))(?= ,| :|$)",
     "{1} , each in one color"),
    (f"^({MANY} {_TOWERS}) (?:{MUST} )?(?:be|stand|are|be built|be there)(?: on the table)? , (?=an? {COLOR} )",
     "{1} , "),
    (f"^((?:please )?(?:stack|pile)(?: up)? .+?) , (?:(?:all )?in |as )?(?:one|a|an)(?: single)? ({TOWER})$",
     "{1} in one {2}"),
    # towers and rows
    (f"\\b(towers [^,]+ , one ({COLOR})(?: ,| and)? one ({COLOR}))(?: ,|;| with)+ (?:the )?\\2(?: one| tower)? "
     f"(?:{_IS} |stands )?({_SPOT}) (?:the )?\\3(?: one| tower)?$", "{1} . the {2} tower must be {4} the {3} tower"),
    (f"^(an? {LINE} of .+?) in front(?: ,| and)+ (an? {LINE} of .+?) behind(?: it)?$", "{1} and {2} behind it"),
    (f"^rainbow ({LINE})(?: :| of| ,| with)+ (.+ (?:blocks|cubes)|.+ , (?:starting|beginning) .+)$",
     "a rainbow {1} of {2}"),
    (f"^({FEW}|\\d+) (?:blocks )?high , (alternating .+)$", "a tower of {1} blocks , {2}"),
    (f"\\bthat (?:does not|must not|should not|may not) have (?:the )?({COLOR})(?: one| block| cube)? (at the top|on "
     "top|at the bottom)$", "with {1} not {2}"),
    ("(?: ,)? with the (\\w+) group (in|on|to|behind|next|near|left|right) (.+?) and the (\\w+) group (in|on|to|behind|"
     "next|near|left|right) (.+)$", " . the {1} group must be {2} {3} . the {4} group must be {5} {6}"),
    (f"^(?:start with |begin with )?({_THING}) ,(?: and)? (?:then )?(?:put |place |set |stack )?({_THING}) on (?:it|"
     f"that|top of it|top of that)(?: ,| and| , and)+ (?:then )?({_THING}) on (?:it|that|that one|top|top of (?:it|"
     "that))$", "stack {1} , {2} and {3} from bottom to top"),
    (f"^(?:stack|pile up|start with|begin with) (?:an? |the |one )?({COLOR})(?: block| cube| one)? , (?:then |and then "
     f"|next |and )?(?:put |place |set |stack )?((?:an? |the |one |another )?{COLOR}(?: block| cube| one)? on (?:it|"
     "that|top of it|that one)\\b.*)$", "there is a {1} block . put {2}"),
    (f"\\b({TOWER}) (?:made |built |consisting )?(?:out )?(?:of|from|with) {_LOT}(?: ,)? (?:and |and then |then |"
     f"followed by ){_LOT}(?: on)?(?: the)?(?: very)? top(?: of (?:it|them|that|those))?$",
     "{1} , from bottom to top : {2} blocks , then {3} blocks"),
    ("\\b(on (?:that|it|this|top of (?:that|it|this))(?: one)? [^,]+?)(?: ,| and|;)+ (?:then |finally )?on (?:the "
     ")?(?:very )?top (?!of\\b)(?=\\w)", "{1} , on that"),
    ("\\bone (?:straight|directly|exactly|right|neatly) on top of the (?:other|next)\\b", "one on top of the other"),
    (f"^({MANY} [^,]+?) {MUST} be (?:distributed|divided|split|shared) (?:over|into|among|between) ({MANY} "
     f"{_TOWERS})\\b",
     "{1} in {2}"),
    (f"\\b((?:an?|one) (?:\\w+ )?{TOWER}) (?:with|of|having|that has|which has) (?:exactly )?({MANY}) {_FLOORS}(?! of| "
     "each of| with| , each (?:of|with|has|having|consisting))", "{1} of {2} blocks"),
    (f"\\b({TOWER} of {MANY} blocks\\b.*?\\b(?:each|every|top|bottom|middle|lowest|highest|uppermost|second|third|"
     f"other)) {_FLOOR}\\b", "{1} block"),
    (f"\\b({TOWER} of {MANY} blocks\\b.*?) ground {_FLOOR}\\b", "{1} bottom block"),
    # how high they are
    (f"\\b(equally (?:high|tall)|equal) ({_TOWERS}) (?:which are |that are )?(?:made|built|formed) (?:out )?(?:of|"
     f"from) (?={MANY}\\b)", "{1} {2} from"),
    (f"\\b({_TOWERS}\\b.*?)(?: ,)? (?:(?:and |with )?{_EACH} {_ARE}|(?:that|which) are ){_EQUAL}$",
     "{1} of equal height"),
    (f"\\b((?:{FEW}) {_TOWERS}\\b.*?)(?: ,| :)? {_FIRST} {_TALL}{_HIGH} {_AND} {_OTHER} {_TALL}{_HIGH}$",
     "{1} , one {2} blocks high and one {3} blocks high"),
    (f"\\b((?:{FEW}) {_TOWERS}\\b.*?)(?: ,| :)? {_FIRST} {_TALL}{_HIGH} {_AND} {_OTHER} {_TALL}{_HIGH} {_AND} {_OTHER} "
     f"{_TALL}{_HIGH}$", "{1} , one {2} blocks high , one {3} blocks high and one {4} blocks high"),
    # of so many colours
    (f"\\b({_TOWERS}\\b[^:]*?)(?: ,)? (?:each|every one)(?: one| tower| stack)?(?: of (?:them|these))? in (?:an?|its "
     "own) (?:(?:different|separate) )?color(?: of its own)?$", "{1} , each tower in its own color"),
    (f"\\b({_TOWERS}\\b[^:]*?)(?: ,)? (?:each|every)(?: one)?(?: tower| stack)?(?: of them)? (?:in|of) (?:just|only) "
     "one color(?= :|$)", "{1} , each of one color"),
    (f"^(?:given |with |from |use )?{MANY} {_BLOCKS} (?:in|of) ({FEW}) (?:different )?colors(?: ,)? ({MANY})(?: "
     f"{_BLOCKS})? (?:of each|per color|in each|each|for each)(?: color| of them)?(?: ,| :)? (?:make |build )?(?:one|"
     f"a) ({TOWER}) (?:per|for each|for every|of each) color$", "{1} {3s} of {2} , each {3} in its own color"),
    # colours that alternate
    (f"^(stack|pile up) {_LOT} and {_LOT}(?: ,)? (?:{_CHANGING}){_BEGINS}",
     "{1} {2} and {3} blocks alternately , {4} at the bottom"),
    (f"^(.*?\\b{TOWER} of {MANY})(?: blocks)? (?:{_CHANGING}) , {_LOT} and {_LOT}(?: ,)?{_BEGINS}",
     "{1} blocks , {2} and {3} , alternating , starting with {4} at the bottom"),
    (f"^(.*?\\b{TOWER}\\b[^,]*?) (?:is|are) (?:wanted|needed|required|desired) , (alternating .+)$", "{1} , {2}"),
    (f"\\b({TOWER} of {MANY}(?: blocks| cubes)?)(?: ,)? (?:that|which) (?:alternates|changes) between {_TURNS}",
     "{1} , alternating {2} and {3}"),
    (f"\\b((?:{TOWER}|row|line|column)\\b.*) alternating between {_TURNS}", "{1} alternating {2} and {3}"),
    (f"\\b({TOWER}\\b.*\\balternating .*?) with {_ONE} both at the (?:bottom|base|foot) and (?:at the top|on top)$",
     "{1} with {2} at the bottom and {2} at the top"),
    (f"\\b({TOWER}\\b[^,]*?)(?:(?: ,)? (?:(?:with|in|of) alternating colors ,|where|in which)| , (?:alternate|"
     f"alternating)) {_TURNS}(?: alternate)? ,? ?({MANY})(?: blocks| cubes)?(?: high| tall)?(?= ,|$)",
     "{1} of {4} blocks , alternating {2} and {3}"),
    (f"^alternate {_TURNS} in (?:an?|one) ({TOWER}) of ({MANY})(?: blocks| cubes)? that (?:starts|begins) with {_ONE} "
     f"{_FOOT}$", "a {3} of {4} blocks , alternating {1} and {2} , with {5} at the bottom"),
    (f"\\b({TOWER} of {MANY})(?: blocks| cubes)?(?: ,)? (?:in which|where) every (?:second|other) (?:block|cube|one) "
     ",? ?(?:starting|beginning) (?:with the (?:bottom|lowest|bottommost)(?: one| block| cube)?|at the bottom|from "
     f"the bottom) ,? ?is {_ONE} and the (?:rest|others|other blocks|other cubes) (?:is |are )?({COLOR})$",
     "{1} blocks , alternating {2} and {3} , with {2} at the bottom"),
    (f"\\b((?:tower|(?:an?|one|the) stack)\\b[^:]*\\b(?:alternating|alternate|alternately)\\b[^:]*?){_BEGINS}",
     "{1} , with {2} at the bottom"),
    # what becomes of one of them
    (f"^given ({MANY} {COLOR} {_BLOCKS}) , (make|build) (an? {TOWER}\\b.*)$", "from {1} {2} {3}"),
    (f"^(?:(?:split|divide|break|take|part) )?(?:the|an?|one) (tower|stack|row) of ({MANY}(?: {COLOR})?(?: "
     f"{_BLOCKS})?)(?: {MUST} be (?:split|divided|parted|broken|taken))?(?: apart| up)? (?:in|into) (?:halves ,? so "
     f"that )?({MANY}) ({_TOWERS}) of ({MANY})(?: {_BLOCKS})?(?: each)?(?: remain| result)?$",
     "at the start there is a {1} of {2} . at the end there are {3} {4} of {5}"),
    (f"^(?:make|build) ({MANY}) ({_TOWERS}) of ({MANY})(?: {_BLOCKS})?(?: each)? (?:out of|from) (?:the|an?|one) "
     f"(tower|stack|row) of ({MANY}(?: {COLOR})?(?: {_BLOCKS})?)$",
     "at the start there is a {4} of {5} . at the end there are {1} {2} of {3}"),
    (f"^(?:make |build )?(?:for (?:every|each) color)(?: ,)? (?:one|an?|its)(?: own| separate)? ({TOWER})$",
     "one {1} per color"),
    (f"^({MANY} {COLOR} {_BLOCKS})(?:(?: ,)? and an? ({COLOR}) (?:one|block|cube) on (?:top of )?each(?: of them| "
     f"one)?$| {MUST} each (?:carry|hold|support|bear|have|get) (?:one|an?) ({COLOR}) (?:one|block|cube)(?: on top| on "
     "it)?)", "put a {2} {3} block on each of {1}"),
    (f"\\b(?:a|one) ({TOWER}) (?:with|of) ({MANY})(?: {_BLOCKS})? and (?:a|one|another)(?: one| {TOWER})? (?:with|of) "
     f"({MANY})(?: {_BLOCKS})?(?: ,)? (?:everything|all of it)(?: in)? ({COLOR})$",
     "one {4} {1} of {2} and one {4} {1} of {3}"),
    (f"\\b(?:a|one) ({TOWER}) of ({MANY})(?: {_BLOCKS})? and (?:one|another)(?: one)? of ({MANY})(?: {_BLOCKS})? "
     "(?=from|out of)", "one {1} of {2} and one {1} of {3}"),
    (f"^(?:with|from|out of) (.+? {_BLOCKS})(?: ,)? (?:i|we) (?:want|need|would like) ((?:one|an?|{MANY}) "
     f".*{TOWER}.*)$", "with {1} build {2}"),
    (f"^(?:all )?(?:the )?{_BLOCKS} (?:are|stand|go) (?:all )?in (?:one|a single) ({TOWER}) : (.+)$", "a {1} of {2}"),
    (f"\\b({TOWER}) (of|out of|from|made of) ({COLOR}) ({COLOR}) and ({COLOR})(?= with| so| in|$)",
     "{1} {2} {3} , {4} and {5}"),
    (f"^(?:(?:make |build )?({MANY} {_TOWERS}) of (?:the same|equal) height from (.+ {_BLOCKS})|use (.+ {_BLOCKS}) to "
     f"(?:make|build) ({MANY} {_TOWERS}) of (?:the same|equal) height)(?: ,)? (?:with )?(?:the )?(?:colors )?in any "
     "order$", "stack {2} {3} into {1} {4} of equal height , in any order"),
    # what stands beside it
    (f"\\b(two|2) ({_TOWERS}) of ({MANY})(?: {_BLOCKS})?(?: each)? , the ({COLOR}) (?:one|{TOWER}) (?:is |being |"
     f"stands |standing )?({_BESIDE}) the ({COLOR}) (?:one|{TOWER})$",
     "{1} {2} of {3} , one {4} and one {6} . the {4} tower must be {5} the {6} tower"),
    (f"\\b((?:an?|one) ({TOWER}) of {MANY}\\b.*? on .*?) and one of (?={MANY}(?: {COLOR})?(?: {_BLOCKS})? on )",
     "{1} and a {2} of"),
    (f"\\b((?:an?|one) ({TOWER}) of {MANY}\\b.*?(?: and|,) (?:{_BESIDE}) it(?: ,)?) one of (?={MANY}\\b)",
     "{1} a {2} of"),
    (f"\\b(?:two|2) {TOWER}s [:,] ({_PILE})(?: ,)? (?:and )?{_ASIDE}(?: ,)? (?:there is |stands )?({_PILE})$",
     "a tower of {1} , and to the {2} of it a tower of {3}"),
    (f"\\b(?:two|2) {TOWER}s [:,] (?:on|to) the left {_STACKED}(?: ,)? (?:and )?(?:to|on) the right(?: of it)? "
     f"{_STACKED}$", "two towers , the left one of {1} and the right one of {2}"),
    (f"\\b(?:two|2) {TOWER}s [:,] on the left ({_PILE})(?: ,)? (?:and )?(?:to|on) the right(?: of it)? ({_PILE})$",
     "two towers : {1} on the left and {2} on the right"),
    (f"(?:^|(?<=: ))(?:(?:stack|sort)(?: them| the blocks)? by color [:,] )?(?:all )?(?:the )?({COLOR})(?: {_BLOCKS})? "
     f"{_INTO}{_GROUND} (?:one|a) {TOWER} of ({MANY})(?: ,| and|, and) (?:all )?(?:the )?({COLOR})(?: {_BLOCKS})? "
     f"{_INTO}{_GROUND} another(?: one| {TOWER})? of ({MANY})$",
     "one {1} tower of {2} and one {3} tower of {4}"),
    (f"(?:^|(?<=: ))(?:put |stack |build )?(?:all )?(?:of )?(the |my )?({COLOR}) ({_BLOCKS}) {_INTO}(?:{_GROUND} "
     f")?(?:one|a) ({TOWER}) (?:and|,|, and) (?:all )?(?:of )?(?:the )?({COLOR})(?: {_BLOCKS})? {_INTO}(?:{_GROUND} "
     f")?another(?: one| {TOWER})?$", "the {2} {3} form a {4} . the {5} {3} form another {4}"),
    # towers and rows
    (f"\\bin ({MANY})(?: separate)? (stacks|towers) , (?:each (?:of|with) (?:a )?)?height(?: of)? ({MANY})(?: each)?$",
     "in {1} {2} of height {3}"),
    (f"^stack {MANY} ({_BLOCKS}) in alternating colors(?: ,| :) ({MANY} {COLOR} and {MANY} {COLOR})\\b",
     "stack {2} {1} in alternating colors"),
    ("^(.*\\b(?:tower|stack)\\b.* (?:be|is)) neither (?:the )?first nor (?:the )?last\\b", "{1} neither at the top "
                                                                                           "nor at the bottom"),
    ("^(.*\\b(?:row|line)\\b.* (?:be|is)) neither (?:the )?first nor (?:the )?last\\b", "{1} neither at the left end "
                                                                                        "nor at the right end"),
    *((f"\\b(alternately|alternating) , (?:the |an? )?({COLOR}|\\w)(?: one| block)? (?:is |being )?(?:the "
       f")?(?:{end})(?: one)?$",
       f"{{1}} , {{2}} {where}")
      for end, where in (("lowest|bottommost|undermost", "at the bottom"), ("uppermost|topmost|highest", "at the top"),
                         ("leftmost", "at the left end"), ("rightmost", "at the right end"))),
    *((f"^(?:{n}) (\\w)(?:s| blocks)? and (?:{n}) (\\w)(?:s| blocks)? (?:{MUST} be )?(?:{put}) (?:alternately|"
       f"alternating) , (?:the |an? )?\\{first}(?: one| block)? (?:is |being )?at the {end}$",
       f"a {line} : {' , '.join([f'{{{first}}}', f'{{{3 - first}}}'] * many)}")
      for many, n in ((2, "2|two"), (3, "3|three"), (4, "4|four")) for first in (1, 2)
      for put, end, line in (("stacked|piled up", "bottom", "tower from bottom to top"),
                             ("stacked|piled up", "top", "tower from top to bottom"),
                             ("in a row|in a line", "left end", "row from left to right"),
                             ("in a row|in a line", "right end", "row from right to left"))),
    (f"^stack(?: them| em| everything)?(?: :)? (?:the )?({COLOR}|\\w)(?: block| one)? (?:at |on )?(?:the )?bottom((?: "
     f",(?: and)?(?: then)? (?:the )?(?:{COLOR}|\\w)(?: block| one)?)+) (?:at the top|on top|on the top|top|cap)$",
     "a tower from bottom to top : {1} {2}"),
    (f"^every (?:other|second) (?:block|cube|one) (?:in|of) (?:the|a) ({LINE}) of (two|four|six|eight|ten|twelve)(?: "
     f"{_BLOCKS})? {_IS} ({COLOR})(?: ,| and)+ (?:the )?(?:rest|others|other ones)(?: {_IS})? ({COLOR})$",
     "a {1} of {2} blocks alternating {3} and {4}"),
    (f"^(?:knock down|take apart|take down|dismantle|pull down|tear down) the ({TOWER}) of ({MANY}(?: {COLOR})?)(?: "
     f"{_BLOCKS})? and (?:then )?(?:build|make|form) an? (row|line|circle)(?: (?:of|from|with|out of) (?:it|them|its "
     "blocks|the blocks))?(?: instead)?$", "at the start there is a {1} of {2} blocks . put them in a {3}"),
    (f"^(?:build |make )?an? ({TOWER}) of ({COLOR})(?: {_BLOCKS})? ?(?:,|and|, and|, then|then)? ({_SPOT}) (?:it|"
     f"that)(?: ,)? an? (?:{TOWER}) of ({COLOR})(?: {_BLOCKS})?(?: ,)? (?:both|each)(?: of them)? ({MANY})(?: "
     f"{_BLOCKS})? (?:high|tall)$",
     "a {1} of {5} {2} blocks and {3} it a {1} of {5} {4} blocks"),
    (f"^turn the ({TOWER}) (?:upside down|over|on its head)(?: :| ,|;)+ it (?:is|'s) (?:now|currently|at the moment) "
     "(.+)$",
     "at the start {2} . reverse the {1}"),
    (f"\\b(stack|tower|row)(.*?) , (the )?middle (?:one )?({COLOR})(?: ,| and)+ (?:the )?(?:other|others|rest)(?: "
     "ones)? (?:whatever|any|anything|any color|of any color|in any color|does not matter|do not matter)(?: you "
     "like)?$",
     "{1} {2} , the middle one {4}"),
    (f"^((?:make |build )?(?:two|2) (?:columns|rows|lines|towers|stacks))(?: ,)?(?: of)? ({MANY})(?: blocks)?(?: each| "
     f"in each| per \\w+)? , ({COLOR} (?:on the |to the )?(?:left|right)) (?:, |and |, and )({COLOR} (?:on the |to the "
     ")?(?:left|right))$",
     "{1} of {2} : {3} , {4}"),
    ("\\b(tower|stack|row|line)\\b(.*?) with an? (?:stripe|stripes|striped|color) pattern :", "{1} {2} :"),
    (f"\\b({TOWER}) whose blocks (?:get|become|grow) smaller (?:towards?|to) the top(?: ,)?(?: ({MANY}) blocks)?$",
     "{1} of {2} blocks by size , biggest at the bottom"),
    (f"^((?:stack|pile up) [^,]+?)(?: ,)?(?: and)? then on top of (?:these|those|them|it|that) ({MANY} {COLOR} "
     f"{_BLOCKS})$",
     "{1} and put {2} on top of them"),
    (f"^(exchange|swap|replace) the (top|bottom|middle) block of the ({TOWER}) ({COLOR}(?: ,)? {COLOR}(?:(?: ,)?(?: "
     f"and)? {COLOR})*) (?:with|for|by) (the [^,]+)$",
     "at the start there is a {3} from bottom to top : {4} . {1} the {2} block with "
                                     "{5}"),
    (f"\\bone ({LINE}) only\\b", "one {1}"),
    ("(?: ,)? (?:with )?no (?:repeated|repeating|duplicate) colors?$", " , all in different colors"),
    ("^(arrange|put|place|lay) the (blocks|cubes) (?:alternately|alternating) : ", "{1} the {2} in a row : "),
    (f"^(?:take care |make sure |see to it |ensure )?(?:that )?the ({LINE}) of ({MANY})(?: {_BLOCKS})? (?:has|have|"
     f"shows) alternating(?: colors)?(?: ,| :)? ({COLOR}) and ({COLOR})$", "a {1} of {2} blocks with alternating "
      "colors {3} and {4}"),
)  # fmt: skip
"""What is read otherwise, or not at all, as it stands."""
TOWERS: tuple[Turn, ...] = (
    (f"^(.*\\b(?:blocks|cubes|ones|letters|digits|them|they|\\w)) are (?:all )?(?:one|an?)(?: single| straight)? "
     f"({LINE})$", "{1} form one {2}"),
    (f"^(.*\\b(?:blocks|cubes|ones|letters|digits|them|they|\\w)) ({MUST}) (?:all )?be (?:one|an?)(?: single| "
     f"straight)? ({LINE})$", "{1} {2} form one {3}"),
    ("\\bon the table , (?:unstacked|not stacked)$", "on the table"),
    ("(?: ,)? so that no two touch$", ". no two of them touch"),
    (f"^(.*\\b(?:{TOWER})\\b.*?) (is|goes) (?:down|below)(?= ,| and|$)", "{1} is at the bottom"),
    (f"^(.*\\b(?:{TOWER})\\b.*?) (is|goes) (?:middle|between)(?= ,| and|$)", "{1} is in the middle"),
    (f"^(.*\\b(?:{TOWER})\\b.*?) (is|goes) (?:up|above)(?= ,| and|$)", "{1} is on top"),
    *((f"\\bthe {told} (one|block|cube)(?: of (?:them|these|the two))?\\b(?! of)", f"the {end} {{1}}")
      for told, end in (("lower", "bottom"), ("upper", "top"))),
    (f"^(?:swap|exchange|switch) them(?: ,)? so(?: that)? (?:the )?({COLOR})(?: one| block)? (?:ends up|is|comes|goes|"
     "will be|lands) on top of (?:the )?(\\w+)$", "{1} must be on {2}"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
WORDS = ("equal height cap",)
"""Words that these take besides those that are read anyway."""
