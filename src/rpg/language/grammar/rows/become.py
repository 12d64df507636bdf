"""What becomes of how things are at the beginning, in whichever words, as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.begun import (
    BRICK,
    CHAIN,
    COMMAND,
    END,
    GOES,
    HEAP,
    LAYERS_ACROSS,
    LAYERS_UP,
    LIST,
    MARK,
    MAT,
    MOVE,
    ONE,
    TIME,
    UP,
)
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LENGTH, LIES, LINE, MANY, MUST, PATCH, TOWER

_LED = f"({END} (?:, )?)?"
_BOTH = f"(?:they|both|the two|both {BRICK}s|both of them|the two {BRICK}s)"
_WAS = "(?:is|are|was|were|starts?|started|begins?|began|stands?|stood|lies?|lay)"
_ENDS = f"(?:{MUST} end up|ends up|{MUST} be|is|ends|{MUST} end)"
_TRADED = "(?:changed|switched|swapped|exchanged|traded)"
_TRADE = "(?:change|switch|swap|exchange|trade)"
_BACK = "(?:then|after that|afterwards|and then)"
_STAYING = "(?:(?<=stay )|(?<=stays )|(?<=remain )|(?<=remains ))"

_LONE = "(?:single|separate|individual|loose)"
_WISHED = f"(?=.*\\b(?:{END}|{MUST}|goal|build|make|form|becomes?)\\b)(?!.*\\b{TIME}\\b)"
_TOWER = f"(?:an?|one|{MANY}) {LINE}s? of {MANY}(?: {BRICK}s)?"
_SINGLE = "(?:single|singly|individually|loose|loosely)"
_UNSTACK = "(?:take apart|take down|dismantle|disassemble|unstack|tear down|pull down|break up|break down)"

BECOME_AT_ONCE: tuple[Turn, ...] = (
    # what is taken apart
    (f"\\b(?:(?:pull|bring|break) down|break up) (?=(?:the|an?|this) (?:\\w+ )?(?:{LINE}|{HEAP})\\b)", "take apart "),
    (f"^break ((?:the|an?|this) (?:\\w+ )?(?:{LINE}|{HEAP})\\b[^,]*?) (?:apart|up)$", "take apart {1}"),
    (f"^(?:take|bring|pull|get) ((?:the|an?|this) (?:\\w+ )?{TOWER}(?: of [^,]+?)?) down(?: to the table)?$",
     "take apart {1}"),
    (f"^({_UNSTACK} .+?|take .+? apart) (?:in)?to (?:its |their )?(?:single|individual|separate|loose) (?:{BRICK}s|"
     "pieces|parts)$", "{1}"),
    (f"^({_UNSTACK} .+?|take .+? apart)(?: ,)? ({BRICK}|piece|one) by \\2$", "{1}"),
    ("\\bon (?:its|their) own(?=$| [,:]| on the table\\b)", "by themselves"),
    (f"(?<= )nothing {LIES} on(?: top of)? (?:anything|another|each other)(?: else)?$", "no block is on another"),
    (f"\\b(?:{_SINGLE} on the table|on the table {_SINGLE})\\b", "on the table by themselves"),
    (f"^({END} (?:, )?)there (?:is|are|{MUST} be) (?:only )?({MANY}) {_LONE} ({BRICK}s)"
     "(?: (?:lying )?on the table)?$", "{1} the {2} {3} must be on the table"),
    (f"^{_WISHED}(.*\\b{_TOWER})(?: ,)? and ({MANY}) {_LONE} {BRICK}s(?: (?:lying )?on the table)?$",
     "{1} and the other {2} must be on the table"),
    (f"^{_WISHED}(.*?)\\b({MANY}) {_LONE} {BRICK}s(?: (?:lying )?on the table)?(?: ,)? and ({_TOWER})$",
     "{1} {3} and the other {2} must be on the table"),
    # "it starts in the left half and must stay in that half", "and must leave it"
    (f"({MUST})(?: all| both)? (?:leave|get out of) it$", "{1} not be there"),
    (f"{_STAYING}(?:in|on) (?:that|this) (?:half|side|corner|part|area|region|{PATCH})\\b", "there"),
    (f"\\bwhen (?:you are|everything is|all is) (?:done|finished)\\b(?!(?: ,)? (?:please )?{COMMAND}\\b)",
     "at the end"),
    ("\\bfrom (?:its|their) (?:starting|start|original|initial|first) (?:place|position|spot|point|location)\\b",
     "from where it started"),
    # lines in another order
    (f"^({END} (?:, )?)(?:it|they|the (?:tower|stack|{BRICK}s)) (?:{MUST} )?(?:be|is|are) ({CHAIN})$",
     "{1} build a tower of {2}"),
    (f"^{_LED}(?:it|they|the (?:tower|stack|{BRICK}s)) (?:(?:{MUST} )?(?:ends?(?: up)?|finish(?:es)?)(?: as)?|{MUST} "
     f"become|becomes?) ({CHAIN})$", "{1} build a tower of {2}"),
    *((f"^(?:({END} (?:, )?)(?:it|the {line}) (?:is|has|becomes|shows)|{_LED}(?:it|the {line}) (?:{MUST} (?:be|have|"
       f"show|become|end with|end up with)|ends(?: up)? with)) ({layers})$", f"{{1}} {{2}} build a {line} with {{3}}")
      for line, layers in (("tower", LAYERS_UP), ("row", LAYERS_ACROSS))),
    (f"^{_LED}(?:it|the (?:row|line)) (?:{MUST} (?:read|be|become|end up(?: as)?)|reads|becomes|ends up(?: as)?) "
     f"({LIST}(?: ,)? from left to "
     f"right)$",
     "{1} build a row of {2}"),
    (f"^(?:turn|convert|change|make|transform|rearrange) (?:it|them) (?:into )?an? ({LINE}) (?:of|with|:) "
     f"({LIST}(?: ,)? {UP})$",
     "build a {1} of {2}"),
    (f"\\b(?:build|stack|set) (it|the {LINE}) (?:up )?again\\b", "rebuild {1}"),
    (f"\\b(?:build|stack|set up) the same ({LINE}) (?:up )?again\\b", "rebuild the {1}"),
    (f"\\brestack (?=(?:it|the {LINE})\\b)", "rebuild"),
    (f"^((?:(?!\\b{MUST}\\b).)+? (?:start|begin)(?: out| off)? (?:as|in) an? {LINE}\\b(?:(?!\\b{MUST}\\b).)*?)(?: ,)? "
     f"and {MUST} (?:end|finish)(?: up)? (.+)$", "{1} . at the end they must be {2}"),
    (f"^(?:{END} (?:, )?)?(?:the|its) order (?:of the {LINE} )?(?:{MUST} be|is) reversed$", "reverse its order"),
    # places that are traded
    (f"^{_LED}(it|{ONE}) (?:{MUST} {_TRADE} sides|has {_TRADED} sides|{MUST} have {_TRADED} sides)$",
     "{1} {2} must be in the other half"),
    (f"^{_LED}{_BOTH} (?:{MUST} {_TRADE} sides|have {_TRADED} sides)$", "{1} each of them must be in the other half"),
    (f"^(?:let|make) them {_TRADE} sides(?: , so that| : so that| so that| ,|) ?(.*)$",
     "each of them must be in the other half . {1}"),
    (f"^{_LED}(?:each of them|(?:each|every) {BRICK}) is on the other ", "{1} each is on the other "),
    (f"^{MOVE} each(?: of them| {BRICK})? (?:on|onto|to) the other (?={MAT}$)", "each is on the other"),
    (f"^(?:swap ({ONE}) and ({ONE})) , (?:so that )?each(?: of them)? {_ENDS} where the other(?: one)? {_WAS}$",
     "swap {1} and {2}"),
    (f"^each of ({ONE}) and ({ONE}) {_ENDS} where the other(?: one)? {_WAS}$", "swap {1} and {2}"),
    (f"^{_LED}(.+? and .+?|they|both|it|{ONE}) (?:{MUST} be|{MUST} end(?: up)?|is|are|ends?(?: up)?) (?:each |both )?"
     f"(at least {LENGTH})(?: away)? "
     f"from where (?:they|it) {_WAS}(?: {TIME})?$", "{1} {2} must be moved by {3}"),
    # what stays, and what does not
    (f"\\b(?:is|are|lies|lie|stands|stand) still where (it|they) {_WAS}(?: {TIME})?$", "must stay where {1} is"),
    (f"\\b((?:none|only one|just one|at most {MANY}|exactly {MANY})(?: of them)?) "
     f"(may not|may|"
     f"{MUST} not|{MUST}) (?:stay|remain|be left) there\\b", "{1} {2} be on it"),
    (f"^(?:put|place|set|lay) (an? {COLOR} (?:{BRICK}|one)) there instead$", "replace it by {1}"),
    # some of a heap
    (f"\\b(an? {LINE} of {MANY}) (?:out of|from) (?:it|the {HEAP})$", "{1} of them"),
    (f"\\b(an? {COLOR} (tower|stack|row|line)(?: of {MANY})?) and (?:an?|another) ({COLOR}) one( of {MANY})?$",
     "{1} and a {3} {2} {4}"),
    (f"^(?:get|take|pick|fish) (the {COLOR} (?:ones|{BRICK}s)) out(?: of (?:it|there|the {HEAP}))?(?: ,)? and "
     f"({COMMAND} .+?) "
     "(?:of|from|with|out of) (?:them|these|those)$", "{2} from {1}"),
    ("^(?:(.+?)(?: ,| and| but| , and| , but) )?(?:i|we) (?:want|need|would like)(?: to have)? "
     "(?:it|them|that|this)(?: to be)? the other way (?:round|around)$", "{1} . put them the other way around"),
)  # fmt: skip
"""What is read otherwise as it stands."""

BECOME: tuple[Turn, ...] = (
    (f"^replace ({ONE}) on (the (?:{COLOR} )?{MAT}) (?:by|with) ({ONE})$",
     "at the start , {1} is on {2} . take {1} off {2} . put {3} on {2}"),
    (f"^replace ({ONE}) (?:by|with) ({ONE}) on (the (?:{COLOR} )?{MAT})$",
     "at the start , {1} is on {3} . take {1} off {3} . put {2} on {3}"),
    (f"\\b({MUST}|let them|make them|have them) {_TRADE} {MAT}(?:e?s)$", "{1} change places"),
    (" , (?:no matter|it does not matter|never mind) in (?:which|what) direction$", ""),
    (f"^(?:first )?take ({ONE}) off , then ({ONE})$", "first take {1} off , then take {2} off"),
    (f"^{_LED}it (?:stands|is|{MUST} be|{MUST} stand) on ({MARK}) with the order reversed$",
     "{1} rebuild it on {2} in reverse order"),
    (f"^(?:exchange|swap) (it|{ONE}) by (an? {COLOR} (?:{BRICK}|one))$", "replace {1} by {2}"),
    (" , same order$", ", in the same order"),
    (f"^({ONE}|it) {MUST} move (?:from there )?(?:onto|on|on top of|to the top of) (.+)$", "{1} must be on {2}"),
    (f"^{MOVE} ({ONE}) (?:to )?where ({ONE}) {_WAS}(?: {TIME})?$", "{1} must be where {2} was at the start"),
    (f"^({MOVE}) to ({MARK}) (the .+)$", "{1} {3} to {2}"),
    (f"^(an? {COLOR} {BRICK}) {MUST} (?:be|lie) (?:there|on it) instead$", "at the end {1} must be there instead"),
    (f"\\b(all {MANY}|they all|all of them) (?:are|become) (one|an?) ({LINE})\\b", "{1} form {2} {3}"),
    (f"\\b(all {MANY}|they) go on the table\\b", "{1} must be on the table"),
    (f"\\b(?:they are stacked|stack them) ({UP})(?: ,| :)? ({LIST})$", "stack them {2} {1}"),
    (f"^(?:let )?the (first|left|leftmost)(?: one| {BRICK})? and the (last|right|rightmost) (?:one|{BRICK}) "
     f"(?:{MUST} )?{_TRADE} places$", "swap the {1} one and the {2} one"),
    (f"^(?:end|goal|final state) : (?={COMMAND} )", ""),
    (f"^(.+? (?:lie|start|begin|are)(?: {TIME})? in an? {HEAP}(?: {TIME})?)(?: ,)? and (?:{MUST} )?(?:become|make|"
     f"form|end as|end up "
     "as|turn into) (.+?)(?: at the end)?$", "{1} . make {2} of them"),
    (f"^(.+? (?:lie|start|begin|are)(?: {TIME})? in an? {HEAP}(?: {TIME})?)(?: ,)? and (?:{MUST} )?(?:end|end up|"
     f"finish) (in .+?)(?: at "
     "the end)?$", "{1} . at the end they must be {2}"),
    ("^(.+?) (form|make|are in|are|become) (an? (?:tower|stack|row|line))(?: ,)? and so (?:do|are|must) (.+)$",
     "{1} {2} {3} and {4} {2} {3}"),
    (f"({MUST})(?: all| both)? leave (the {BRICK}|{MARK})$", "{1} not be on {2}"),
    (f"^(?:take|move|remove|clear) (?:some|any|several|so many|as many)(?: of them| {BRICK}s)?(?: away| off)? until "
     f"(at most {MANY}) "
     "(?:is|are)(?: still)? left (on .+)$", "at the end {1} of them may be {2}"),
    ("^(take|move|get) (.+?) away$", "{1} {2} off"),
    # there and back
    (f"^(.+?)(?: first)?(?: ,)?(?: and)? {_BACK} back (?:to|on|onto) ({MARK}|the table)$", "{1} , then put it on {2}"),
    (f"^(.+?)(?: first)? , then it returns (?:to|onto|on) ({MARK}|the table)$", "{1} , then it is on {2}"),
    (f"^(.+?) {GOES} (?:to|onto) ({MARK})(?: ,)? and (?:then|after that) (?:returns?|goe?s? back|comes? back) to "
     f"({MARK})$",
     "first {1} must be on {2} , then {1} must be on {3}"),
    # other blocks in their place
    (f"^(?:put|place|set|stack) ({ONE}) on ({ONE}) (?:instead of|in place of) ({ONE})$", "take {3} off {2} . put "
     "{1} on {2}"),
    (f"^({ONE}|it) (?:comes|{MUST} come|is taken|{MUST} be taken) (?:off|down)(?: ,)? and (?:goes|ends up|is put|"
     f"{MUST} be) (.+)$",
     "{1} must be {2}"),
    (f"^({ONE}) ({MUST}) take the (?:place|position|spot) (?:which|that) ({ONE}) has(?: {TIME})?$", "{1} {2} be "
     "where {3} was"),
    (f"^{_LED}(the two [^,]+?) (?:have {_TRADED}|{MUST} {_TRADE})(?: their)? (?:places|positions)$", "{1} swap {2}"),
    (f"^(?:move|shift|displace) ({ONE} and {ONE}) (by at least [^,]+?) each$", "move {1} {2}"),
    (f"^(?:bring|move|transfer|carry|take|shift) (it|the {LINE}) (?:on)?to (an? \\w+ \\w+|the \\w+ \\w+)(?: ,)?(?: "
     f"but)? (?:with the "
     "order reversed|in (?:reverse|reversed|the opposite) order)$", "rebuild {1} on {2} in reverse order"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
WORDS = ("singly individually loosely break broken",)
"""Words that these take besides those that are read anyway."""
