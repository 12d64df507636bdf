"""How things are at the beginning, in whichever words: what is given, and what becomes of it, as
rows that say it in a sentence of its own."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LIES, LINE, MANY, MUST

BRICK = "(?:block|cube|brick)"
MAT = "(?:patch|mat|zone|target|area|spot)"
MARK = f"(?:the|an?) \\w+ {MAT}"
HEAP = "(?:heap|pile|jumble)"
_SHAPE = f"(?:{LINE}|{HEAP})"
EVENT = "(?:episode|task|run|game|process|procedure|exercise|operation|trial|simulation|test)"
TIME = (
    "(?:at (?:the )?(?:very )?(?:start|beginning|outset)|initially|originally|in the beginning|to (?:begin|start) "
    "with|"
    "at first|currently|right now|now|at the moment|at present)"
)
"""When something is so at the beginning; with a blank behind it where it stands in front."""
_LED = f"(?:{TIME} (?:, )?)"
END = f"(?:at the end of the {EVENT}|(?:at|in) the end|finally|afterwards|when (?:you are|all is|everything is) done)"
STARTS = "(?:starts?|begins?)(?: out| off)?"
SITS = f"(?:{LIES}|(?:is|are) (?:lying|sitting|standing|located|placed|resting)|{STARTS})"
ONE = f"(?:(?:the |an? )?{COLOR}(?: {BRICK}| one)?)"
"""A block by its colour."""
CHAIN = f"(?:{COLOR}(?: (?:on top of|on|over|above) {COLOR})+)"
LIST = f"(?:{COLOR}(?:(?: ,| and| , and|)(?: then)? {COLOR})+)"
_LAYER = f"{COLOR} (?:at the bottom|in the middle|on top|at the top|lowest|highest|on the left|on the right)"
_LAYERS = f"(?:{_LAYER}(?:(?: ,| and| , and|)(?: then)? (?:{_LAYER}|{COLOR}))+)"
_SIDE = "(?:bottom|top|left|right|front|back)"
UP = (
    f"(?:(?:counted |listed |told |seen )?from (?:the )?{_SIDE}(?: to (?:the )?{_SIDE}| up| upwards| down| "
    f"downwards)?|"
    f"(?:bottom|left|front) to (?:top|right|back)|top to bottom)"
)
ORDER = f"(?:{UP} (?:, |: )?{LIST}|{LIST}(?: ,)? {UP}|{_LAYERS})"
"""An order in full."""
MOVE = "(?:put|move|bring|carry|take|transfer)"
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
    f"((?:the|an?|on|there|we|you|i|everything|{MANY}|{COLOR}|{TIME})\\b(?:(?!{MUST}|\\b(?:which|that|where|if|when|once|"
    f"until|unless)\\b)"
    f".)*? (?:{SITS}|has|have|holds|carries|form|{TIME})\\b(?:(?!{MUST}).)*?)"
)
"""How something is, by nothing but facts."""
_BECOMES = f"(?:{MUST}|becomes?|ends?|finish(?:es)?|goes|comes|turns?)"
_A_LINE = f"(?:the {BRICK}s|all {BRICK}s|three {BRICK}s|everything)"
_GETS = "(?:gets?|has|have|is given|are given|receives?|finds?)"

_ENDED = f"({END} (?:, )?)?"
_TRADE = "(?:change|switch|swap|exchange|trade)"

BEGUN_AT_ONCE: tuple[Turn, ...] = (
    # how it is, and what becomes of it, in one sentence
    (f"^{_FACT} [,:] ((?:please )?(?:first )?{COMMAND} {_THEM}\\b.+)$", "{1} . {2}"),
    (f"^(?!there (?:is|are) ){_FACT} [,:] (?:and |but )?((?:it|they|both|the two|each|all"
     f"|(?:the )?{COLOR}(?: one| {BRICK})?) {_BECOMES}\\b.+)$",
     "{1} . {2}"),
    (f"\\b(from [^,]+?) {_WHERE_IT_IS} ,? ?(?=(?:over )?(?:to|onto|into|back) )", "{1}"),
    (f"^(an? (?:\\w+ )?{_SHAPE}\\b.+?)(?: ,)? is (?:given|already there|what (?:you|we|i) start with|the start)$",
     "at the start there is {1}"),
    (f"^from ({MARK}) , where (?:it|they) {SITS}(?: {TIME})? , ({ONE}) (.+)$",
     "at the start , {2} is on {1} . {2} {3}"),
    (f"^(.+?) and keep ({ONE}) , {WHICH} {STARTS} on ({MARK}) , on (?:that|the|the same) {MAT}(?: the whole time)?$",
     "at the start , {2} is on {3} . {1} and keep {2} there the whole time"),
    # heaps
    (f"^{_LED}?(?:the robot|we|you|i) {_GETS} (an? (?:\\w+ )?{HEAP} (?:of|with)\\b.+)$", "at the start there is {1}"),
    (f"^(?:the )?(?:initial|starting|given) ({HEAP}) (?:: |is |of |has )(.+)$", "at the start there is a {1} of {2}"),
    (f"^(.+?) , {WHICH} (?:{TIME} )?(?:lie|start|begin|are|lying)(?: {TIME})?(?: lying)? (in an? "
     f"{HEAP})(?: {TIME})?(?: ,)? ({MUST}) (.+)$", "at the start {1} lie {2} . they {3} {4}"),
    (f"^(?:out of|from) the ({HEAP}) in which (?:the )?(.+?) {SITS}(?: {TIME})? , (.+)$",
     "at the start {2} lie in a {1} . {3}"),
    # lines that are there
    (f"^the ({LINE}) (?:that|which) is (?:already )?there(?: now| {TIME})? (?:is|has|reads) ({CHAIN}|{ORDER})$",
     "at the start the {1} is {2}"),
    (f"^the ({LINE}) {TIME} (?:has|is|reads)(?: ,)? ({ORDER})$", "at the start there is a {1} : {2}"),
    (f"^{_A_LINE} (?:{STARTS}|(?:are|is) {TIME})(?: stacked)? (?:in|as) (?:an?|one) ({LINE}) [,:] ({ORDER})$",
     "at the start there is a {1} : {2}"),
    (f"^{_A_LINE} (?:{STARTS} stacked|are stacked {TIME}) [,:] ({ORDER})$", "at the start there is a tower : {1}"),
    (f"^two stacked {BRICK}s {TIME} [,:] ({ONE}) on(?: top of)? ({ONE})$", "at the start , {1} is on {2}"),
    (f"^(?:take )?(?:the|an?) ({LINE})(?: of)? (.+?)(?: ,)? {WHICH} (?:is|stands|lies)(?: already)?(?: standing| "
     f"lying)? "
     "(?:there|here)(?: ,)? and (.+)$", "at the start there is a {1} of {2} . {3}"),
    # what is on a patch, told aside
    (f"^((?:first )?(?:clear|empty) ({MARK})) \\( ({ONE}) {SITS} (?:there|on it) \\)(?: ,)? (.*)$",
     "at the start , {3} is on {2} . {1} , {4}"),
    (f"^({ONE} and {ONE}) , {WHICH} (?:start|begin)(?: out)? ([^,]+?) , {MUST} (?:end|finish)(?: up)? (.+)$",
     "at the start {1} are {2} . at the end they must be {3}"),
    (f"^separate ({ONE}) from ({ONE}) [,:] (touching|next to each other|side by side) at (?:the )?start , (.+?) at "
     f"the end$",
     "at the start , {1} and {2} are {3} . at the end , {1} and {2} must be {4}"),
    (f"^swap the two {BRICK}s on the (?:patches|mats|zones|spots|areas) [,:] (.+? {STARTS} on .+)$", "{1} . swap "
     "the two"),
    # what becomes of it
    (f"\\bwhen (?:you are|everything is|all is) (?:done|finished)\\b(?!(?: ,)? (?:please )?{COMMAND}\\b)",
     "at the end"),
    # lines in another order
    (f"^{_ENDED}(?:it|the (?:row|line)) (?:{MUST} (?:read|be|become|end up(?: as)?)|reads|becomes|ends up(?: as)?) "
     f"({LIST}(?: ,)? from left to "
     f"right)$",
     "{1} build a row of {2}"),
    (f"\\b(?:build|stack|set) (it|the {LINE}) (?:up )?again\\b", "rebuild {1}"),
    (f"\\b(?:build|stack|set up) the same ({LINE}) (?:up )?again\\b", "rebuild the {1}"),
    (f"^(?:{END} (?:, )?)?(?:the|its) order (?:of the {LINE} )?(?:{MUST} be|is) reversed$", "reverse its order"),
    # places that are traded
    (f"^(?:let|make) them {_TRADE} sides(?: , so that| : so that| so that| ,|) ?(.*)$",
     "each of them must be in the other half . {1}"),
)  # fmt: skip
"""What is read otherwise as it stands."""

BEGUN: tuple[Turn, ...] = (
    # what is given
    (f"^with (.+?) {TIME} (in|on|at|next to) ([^,]+) , (.+)$", "at the start , {1} is {2} {3} . {4}"),
    (f"^(?:start(?:ing)?|begin(?:ning)?) from (an? {_SHAPE}\\b.+?) , (an? .+?) {MUST} be (?:built|made|formed|"
     f"assembled)(?: from "
     "(?:it|them))?$", "at the start there is {1} . build {2}"),
    (f"^from (an? {LINE})((?: ,|:| with| of) .+?)(?: ,)? ({COMMAND} .+)$", "at the start there is {1} {2} . {3}"),
    (f"^(?:unstack|dismantle|restack|rebuild|reverse) : ({CHAIN}) at (?:the )?start , (.+?)(?: at the end)?$",
     "at the start there is a tower of {1} . at the end , {2}"),
    # what lies on a patch, and leaves it
    (f"^(?:clear|empty) ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})? , by (?:moving|putting|stacking|"
     f"placing) (?:it|"
     f"that {BRICK}) (on(?:to)? .+)$", "at the start , {2} is on {1} . put {2} {3}"),
    (f"^from ({MARK}) , (?:where|on which) (.+?) {SITS}(?: {TIME})? , (?:all(?: the)? {BRICK}s?|it|they|every "
     f"{BRICK}|both|all of "
     f"them) {MUST} be (?:removed|taken away|taken|cleared)$", "at the start , {2} is on {1} . clear {1}"),
    (f"^({MOVE}) to ({MARK}) (the .+)$", "{1} {3} to {2}"),
    (f"^(.+? (?:lie|start|begin|are)(?: {TIME})? in an? {HEAP}(?: {TIME})?)(?: ,)? and (?:{MUST} )?(?:become|make|"
     f"form|end as|end up "
     "as|turn into) (.+?)(?: at the end)?$", "{1} . make {2} of them"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
