"""When something is so: at the start, never, one after the other, and what takes the place of what, as rows that say it
plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH, LINE, MUST, PATCH

_MUST = f"(?:{MUST}|may|can|might)"
_NEVER = "(?:at no (?:time|point|moment|stage|instant)|on no occasion|not once|never ever|not ever)"
_EVER = "(?:at any (?:time|point|moment)|at all times|the whole time|the entire time|all the time|throughout|always)"
_BLOCK = "(?:block|cube|brick|thing)"
_STEP = "(?:put|place|move|stack|set|bring|lay|take|unstack|swap|build|make|line up|carry|transfer|shift)"
_LIFT = "(?:get|take|lift|remove|pull|move|bring)"
_MOVED = "(?:moved|touched|disturbed|displaced|shifted)"
_OTHERS = "the others stay where they are"
_BARE = "nothing may ever be on {1}"
_SO = "(?:is|are|has been|have been|lies|stands|sits|rests)"
_END = "(?:top|bottom|middle|lowest|highest|uppermost|leftmost|rightmost|first|second|third|last|upper|lower)"
_PLACE = "(?:on|next to|beside|to the left of|to the right of|in front of|behind|in|under) the [^,]+?"
_TO_BE = "(?=(?:be|go|stand|lie|sit|rest|end|touch|form)\\b)"
_NOW = "(?:now|at the moment|at present|right now|currently|at first|initially)"
_REGION = "(the (?:(?:left|right|near|far) half|(?:(?:near|far|front|back|left|right) ){2}corner))(?: of the table)?"
_ENDS_UP = f"(?:{MUST} (?:end up|go|come|be|stand|lie)|ends up|goes|comes)"
_IS_NOW = f"{_SO}(?: {_NOW}| at the (?:start|beginning))?"

OFF_FIRST: tuple[Turn, ...] = (
    (f"^(?:(?:do|take|begin with|start with) )?({THING})(?: (?:goes|comes))? first : ({_STEP}) (?:it|that one) (.+)$",
     "first {2} {1} {3}"),
    (f"^(?:build|make|put together) (?:the|a) {LINE} in (?:this|that|the following) order : "
     "(?=.* (?:on|onto) (?!top|the (?:left|right|bottom))\\w+.*\\b(?:then|after that)\\b)", ""),
    (f"^(?:please )?(?:first )?remove ({THING}|it)(?: first)?(?: ,| and| , and)? then (?={_STEP}\\b)",
     "first take {1} off , then"),
    (f"^(?:please )?({_LIFT}) ({THING}|it|them) (off|away|down) first(?: ,| and| , and)? then (?={_STEP}\\b)",
     "first {1} {2} {3} , then"),
    (f"^(?:please )?({_LIFT}) ({THING}|it|them) (off|away|down) first$", "first {1} {2} {3}"),
)  # fmt: skip
"""What is done before anything else, of which the order would be lost; in every sentence."""
_AT_LAST = "(?: ,)? (?:\\.|;|,|and|but) (?:and |but )?(?:(?:at|in) the end|finally)(?: ,)?"
_ONCE = "at some (?:point|time|stage|moment)"
_SHORTLY = "(?:temporarily|briefly|momentarily|for a (?:short |brief )?(?:moment|while|second|time))"
_MAT = f"(the (?:{COLOR} )?{PATCH})"
IN_PASSING: tuple[Turn, ...] = (
    (f"^{_ONCE}(?: ,)? ([^.;]+?){_AT_LAST} ([^.;]+)(?= \\.|$)", "first {1} . then {2}"),
    (f"^([^.;]+?) {_ONCE}{_AT_LAST} ([^.;]+)(?= \\.|$)", "first {1} . then {2}"),
    (f" {_SHORTLY}(?=(?: [^.;,]*)? [.;,] (?:and |only )?then\\b)", ""),
    (f"\\bvisit {_MAT} with ({THING})(?: ,)? (?:and )?then (?:visit )?{_MAT}", "move {2} onto {1} , then onto {3}"),
)  # fmt: skip
"""Over a whole text: what is so on the way, and what comes behind it."""
_BEGUN = "(?:at (?:the )?(?:start|beginning)|at first|initially)"
_AT_END = "(?:(?:at|in) the end|finally|afterwards)"
AT_TIMES: tuple[Turn, ...] = (
    (f"^{_MAT} is empty {_BEGUN}(?: ,)? (?:and|but) (?:it )?(?:holds|has|contains) ([^,]+?)(?: on it)? {_AT_END}$",
     "at the start {1} is empty . {2} must be on {1}"),
    ("^(?:by no means|under no circumstances|on no account|in no case)(?: ,)? (?=put|place|move|set|stack|touch)",
     "do not "),
    (f"^({THING}) (?:is|are) (never|not) (?:allowed|permitted) ({PLACE} .+)$", "{1} must {2} be {3}"),
    # told under a heading
    (f"^(?:never(?: allowed)?|forbidden|prohibited|not allowed|must never happen|must not happen) : ({THING}) "
     f"({PLACE} {THING}|{_PLACE})$", "{1} must never be {2}"),
    # never
    (f"\\b{_NEVER} (touch|touches|lie|lies|put|place|let|move|take|stack|leave|leaves|lift|allow)\\b", "never {1}"),
    ("\\b((?:not|never) [^,]+?)(?: ,)? not even (?:temporarily|briefly|momentarily|shortly|in passing|in "
     "between|once|for (?:a|one|a short|a brief|a single) (?:moment|second|time|while|instant))$", "{1} at any time"),
    (f"\\b(must|should|may) never move(?: ,)? {_EVER}$", "{1} never move"),
    ("\\b(?:is|are) (not|never) (?:allowed|permitted|supposed) to\\b", "must {1}"),
    # later
    (f"^([^,]+?) ({MUST}) (?:thereafter|afterwards|subsequently|later)(?: on)? {_TO_BE}", "then , {1} {2} "),
    (f"\\b({MUST}) (?:eventually|ultimately) {_TO_BE}", "{1} "),
    ("\\bwithout (.+?) ever (?:being|lying|standing) on (.+)$", "and {1} must never be on {2}"),
    ("\\bwithout (.+?) ever touching (.+)$", "and {1} must never touch {2}"),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} (?:be|stay|remain|be kept) (?:clear|free) {_EVER}$", _BARE),
    (f"\\b(?:{MUST}|may) not leave (.+?)(?: {_EVER})?$", "must not leave {1}"),
    # nothing else
    (f"\\b(?:no other {_BLOCK}|nothing else) (?:moves|(?:{_MUST} )?(?:be|is|gets?) {_MOVED}|{_MUST} move)$", _OTHERS),
    (f"\\bwithout (?:moving|touching|disturbing|displacing|shifting) (?:any other {_BLOCK}s?|anything else)$",
     "without moving any of the others"),
    # one after the other
    (f"^(?:please )?wait (?:until|till) (.+?)(?: ,)? (?:and )?(?:then|before you) ({_STEP} .+)$", "once {1} , {2}"),
    (f"^(.+?)(?: ,)? (?:but )?(?:as soon as|once|only when|but not until) ([^,]+? {_SO} .+)$", "once {2} , {1}"),
    (f"^(.+?) ({MUST}|may) not be (?:put|placed|moved|stacked) (on .+?) (?:before|until) ([^,]+? {_SO} .+)$",
     "once {4} , put {1} {3}"),
    ("^(.+?) (first|at first)(?: and| ,| , and) ([^,]+?) (?:after that|afterwards|thereafter|at last|last of all)$",
     "first {1} , then {3}"),
    ("^(?:first(?: ,)? )?(.+?)(?: and| ,| , and) ([^,]+?) (?:after that|afterwards|thereafter|at last|last of all)$",
     "first {1} , then {2}"),
    (f"^before (?:anything|everything|all) else (?={_STEP}\\b)", "before anything else , "),
    ("^(?:the )?first (?:thing (?:to do )?|step )?is to (.+?) ,(?: and)? (?:the )?(?:second|next|last)(?: thing| "
     "step)? is to (.+)$", "first {1} , then {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
TRADED: tuple[Turn, ...] = (
    (f"^({THING}) {_ENDS_UP} (?:exactly )?where ({THING}) {_IS_NOW}(?: ,)?(?: and| while) \\2 (?:{_ENDS_UP} )?"
     f"(?:exactly )?where \\1 {_IS_NOW}$", "swap {1} and {2}"),
    (f"\\bthe ({_END}) and the ({_END}) ({_BLOCK})\\b", "the {1} {3} and the {2} {3}"),
    (f"^(.+?) (?:takes|{MUST} take) the place of (.+?) and \\2 (?:(?:takes|{MUST} take) the place of|that of) \\1$",
     "swap {1} and {2}"),
    (f"^(.+?) and (.+?) (?:(?:{MUST} )?end up|{MUST} be|are) in each other 's (?:places?|positions?|spot)$",
     "swap {1} and {2}"),
    ("^i (?:want|would like|need) (.+?) and (.+?) (?:to be )?(?:swapped|exchanged|interchanged|switched)$",
     "swap {1} and {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
BEFORE_IT: tuple[Turn, ...] = (
    (f"^([^,]+?) , (?:which|that) (?:is|lies|stands|sits) ({_PLACE}) {_NOW} , ", "{1} , which starts {2} ,"),
    (f"^([^,]+?) (?:is|lies|stands|sits) ((?:on|next to|left of|right of|behind|in front of|in) [^,]+?) {_NOW}(?: ,)? "
     f"(?:and|but) (it {MUST} .+)$", "at the start , {1} is {2} . {3}"),
    (f"^([^,]+?) (?:is|lies|stands|sits) ((?:on|next to|left of|right of|behind|in front of|in) [^,]+?) {_NOW}(?: ,)? "
     "(?:and|but) belongs (.+)$", "at the start , {1} is {2} . it must be {3}"),
    (f"^move (.+?) at least ({LENGTH}) each$", "move {1} by at least {2}"),
    ("^get (the .+?) out from under (the .+?) and put it (.+)$", "at the start , {2} is on {1} . put {1} {3}"),
    (f"^(?:at the start|initially|at first)(?: ,)? a ({LINE}) has (.+)$", "at the start there is a {1} with {2}"),
    (f"^the ({LINE}) (?:at the start|currently|now) reads (.+)$", "at the start , the {1} is {2}"),
    ("\\bbut only (?:when|once|if) (the .+?) (?:already )?(?:lies|is|stands|sits)(?: already)? (on .+)$",
     "but only after {1} has been put {2}"),
    ("^it has (.+? at the bottom(?: ,)?.+)$", "at the start , {1}"),
    (f"^(?:put|move|bring|carry|take) (.+?) from {_REGION} (?:to|into) {_REGION}$",
     "at the start , {1} is in {2} of the table . put {1} in {3}"),
    (f"^(an? {LINE}(?: of)? .+?) (?:(?:is )?(?:standing|lying)|stands|lies|is|has been built|was built) (?:on the "
     "table|there)$", "there is {1}"),
    *AT_TIMES,
    *TRADED,
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("forbidden prohibited briefly instant letting momentarily occasion permitted present spot temporarily wait",)
"""Words that these take besides those that are read anyway."""
AT_THE_END: tuple[Turn, ...] = (
    ("^((?:at|in) the end(?: ,)? .+) , (?:and |but )?never (?=in front|behind|left|right|on|next|beside|to)",
     "{1} , not "),
)  # fmt: skip
"""What is told of the end alone: "never" is no more than "not" there."""
