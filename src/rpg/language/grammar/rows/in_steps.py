"""One thing after the other, told from behind or of one block on its way, what stays as it is meanwhile, what changes
places and how a letter is turned, as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, LABEL, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, FEW, MUST, PATCH

_PUT = "(?:put|place|set|move|bring|carry|lay|take|shift|push|slide)"
_DONE = "(?:put|placed|set|moved|brought|laid|stacked)"
_ON = f"((?:on|onto|in|into|to) (?:the|my) (?:{COLOR} )?(?:{PATCH}|table))"
_NEXT = "(?: ,)?(?: and)? (?:then|finally)"
_THERE = "(?:there|(?:on|onto|in|into) it)"
_TOO = "(?: too| as well| also)?"
_TO = "(?:onto|on|into|in|to)"
_THEN = "(?:then |next |after that |afterwards |from there |finally |lastly |last |at last |in the end )"
_SHOWN = "(upside - down|upside down|upright|sideways)"
_SELF = "(?:is|are|appears?|stands?|reads?|lies?)"
_SWAP = "(?:trade|swap|switch|change|exchange)"
_END = "(?:top|bottom|left|right|first|last|leftmost|rightmost|middle|front|back|lowest|highest|uppermost)"
_ASKED = "(?:let|can|could|may|is it possible (?:that|for)|(?:i|we) (?:want|need|would like))"
_WHOLE = "(?:thing|time|process|operation|task|episode|procedure|job)"
_NAMED = f"(?:{THING}|{LABEL})"
_EITHER = f"(?:{THING}|\\w)"
_HERE = f"the (?:{COLOR} )?{PATCH}"
_GOES = f"(?:{_PUT} ({THING}|it) (?:first )?{_TO}|({THING}) (?:(?:goes|{MUST} go) (?:first )?{_TO}|{MUST} visit))"
_AND_THEN = (f"(?:first ?)?(?: ,|and|, and)+ {_THEN}(?:on )?(?:back )?"
             f"(?:{_TO}|come to rest on|(?:end up|end|stop|rest) on|visit)? ?")  # fmt: skip
"""How it is told that a block goes somewhere, and then somewhere else."""


IN_STEPS: tuple[Turn, ...] = (
    # one thing more
    ("^(first .+?) , ((?:and )?then .+?)(?: ,)? and (?:at|in) the (?:very )?end (?!of |it |there )(.+)$",
     "{1} , {2} , then {3}"),
    # the same place for one after the other, "then green, then blue"; what comes on top of what is there by then
    (f"^(?:first )?({_PUT}) ({THING}) {_ON}{_NEXT} ({THING}){_NEXT} ({THING})$",
     "first {1} {2} {3} , then {1} {4} {3} , then {1} {5} {3}"),
    (f"^(?:first )?({THING}) ((?:goes|comes|{MUST} (?:go|be|come))) {_ON}{_NEXT} ({THING}){_NEXT} ({THING})$",
     "first {1} {2} {3} , then {4} {2} {3} , then {5} {2} {3}"),
    (f"(?: ,)?(?: and)?(?: then| ,) ({THING}) on top (of (?:it|that)){_NEXT} ({THING})(?= , | and |$)",
     " , then {1} on top {2} , then {3} on top of that"),
    (f"^((?:first )?{_PUT} {THING} (?:on|onto) {THING}(?: ,)?(?: and)?) then ({THING}) on top{_NEXT} ({THING})"
     "(?= , | and |$)", "{1} then {2} on top , then {3} on top of that"),
    # what comes first told last
    (f"^before ({THING}) (?:is|are|{MUST} be) {_DONE} {_ON} , ({THING}) (?:{MUST} be|is) {_DONE} {_THERE}{_TOO}$",
     "first put {3} {2} , then put {1} {2}"),
    (f"^before (?:you |we |the robot )?{_PUT}s? ({THING}) {_ON} ,? ?{_PUT} ({THING}) {_THERE}{_TOO}(?: first)?$",
     "first put {3} {2} , then put {1} {2}"),
    (f"^{_PUT} ({THING}) {_ON} ,? ?(?:but|and) ({THING}) {MUST} (?:get|be|go|come|arrive) {_THERE} (?:before (?:it|"
     "that)|first|earlier)$", "first put {3} {2} , then put {1} {2}"),
    (f"^({THING}) (?:(?:{MUST} be|is|may be) {_DONE}|goes|{MUST} go|may go) {_ON} only (?:after|once|when) ({THING}) "
     f"(?:has been|is|was) (?:{_DONE} )?{_THERE}$", "first put {3} {2} , then put {1} {2}"),
    ("^((?:after|once|as soon as|when) .+?)(?: ,)?(?: and| but)? not (?:earlier|sooner|before|any earlier|any "
     "sooner)(?: than that)?( ,.*)?$", "{1} {2}"),
    (f"^(the ({COLOR}) {BLOCK}) (?:goes|is {_DONE}|{MUST} be {_DONE}|{MUST} go|comes) before (the ({COLOR}) {BLOCK}) "
     "((?:on|onto|in|into|to) [^,:]+) : first (?:the )?\\2 , then (?:the )?\\4$",
     "first put {1} {5} , then put {3} {5}"),
    (f"^({THING}) ((?:on|onto) [^,]+?) (?:comes|must come|should come|happens|is done|goes) before ({THING}) ((?:on|"
     "onto) .+)$", "first put {1} {2} , then put {3} {4}"),
    (f"^(?:{FEW}|\\d) (?:stage|step|phase|part|steps|stages) (?:task|job|plan|procedure) : ", ""),
    (f"^in the first (?:step|stage|phase) (.+?){AND} in the (?:second|next) (?:step|stage|phase)? ?(.+)$",
     "first {1} , then {2}"),
    # one block on its way
    (f"^{_GOES} ({_HERE}) ?(?:{_AND_THEN}|(?: ,|and|, and)+ {_TO} )({_HERE}) ?{_AND_THEN}({_HERE})$",
     "first put {1} {2} on {3} , then put {1} {2} on {4} , then put {1} {2} on {5}"),
    (f"^{_GOES} ({_HERE}) ?{_AND_THEN}({_HERE})$", "first put {1} {2} on {3} , then put {1} {2} on {4}"),
    # meanwhile
    (f"\\b(?:during|throughout|for) the (?:whole|entire) {_WHOLE}\\b", "the whole time"),
    ("\\bwithout (?:disturbing|displacing|dislodging|budging) (?!each other|one another|any)", "without moving "),
    (f"(?: ,)? with ({THINGS}) not being (?:moved|shifted|displaced)\\b", " without moving {1}"),
    (f"\\bwithout ({THINGS}) being (?:moved|shifted|displaced)\\b", "without moving {1}"),
    (f"\\b({MUST}|may|can) not be (?:displaced|shifted|dislocated|budged)\\b", "{1} not be moved"),
    (f"^move ({THINGS})(?: ,)? without moving ({THINGS})$", "{1} must be moved . {2} must stay where they are"),
    (f"^without moving ({THINGS}) , move ({THINGS})$", "{2} must be moved . {1} must stay where they are"),
    (f"^({THING}) has (?:been )?moved(?: from its place| away)?(?: ,)? (?:and|but|while) ({THING}) has not(?: "
     "been)?(?: moved)?$", "{1} must be moved . {2} must stay where it is"),
    ("^(?:subject to|under) the (?:constraint|condition|restriction|proviso) that (.+?) , (.+)$", "{1} . {2}"),
    # changing places
    (f"^({_SWAP}) (?:its|the) ({_END})(?: {BLOCK})? (?:and|with) (?:its|the) ({_END}) (?:{BLOCK}|one)$",
     "swap the {2} block and the {3} block"),
    (f"^({_SWAP}) its ({_END}) and ({_END}) {BLOCK}s$", "swap the {2} block and the {3} block"),
    (f"^({_SWAP}) ({_EITHER}) (?:with|and|for) ({_EITHER})(?: ,)? and ({_EITHER}) (?:with|for) ({_EITHER})$",
     "swap {2} and {3} . swap {4} and {5}"),
    (f"^({_NAMED} and {_NAMED}) ((?:{MUST} )?{_SWAP} (?:their )?(?:places|positions))(?: ,)? and so {{must}} "
     f"({_NAMED} and "
     f"{_NAMED})$".replace("{must}", f"(?:do|{MUST})"), "{1} {2} . {3} {2}"),
    (f"^((?:swap|switch|exchange|trade) .+?|.+? {MUST} be (?:swapped|exchanged)|.+? {_SWAP} (?:places|positions))(?: "
     ",)? so (?:that )?each(?: one)?(?: of them| of the two)? (?:finally |then |in the end )?(?:stands|is|lies|sits|"
     "ends up|ends)(?: exactly)? where the other(?: one)? (?:was|stood|lay|is now|started|stands now|sat)(?: (?:at|"
     "in) the (?:start|beginning)| before)?$", "{1}"),
    (f"^(?:{_PUT} )({_NAMED}) (?:in|into|to|at) the (?:place|position|spot) of ({_NAMED})(?: ,)? and vice versa$",
     "{1} and {2} must swap places"),
    (f"^(.+?)(?: ,| and)+ (?:keep|leave) ({_NAMED}) (?:put|in place|where it is)$", "{1} . {2} must stay where it is"),
    (f"^{_ASKED} ({THINGS}) (?:to )?({_SWAP} (?:places|positions))(?: ,)? without (?:moving|touching) ({THINGS})$",
     "{1} must swap places . {3} must stay where it is"),
    # how a letter is turned
    (f"^(?:turn|rotate|flip|put|place|set) ((?:the )?{BLOCK} (\\w)|the (\\w)(?: {BLOCK})?)(?: around| over| down)? so "
     f"that (?:the|its) (?:letter |digit )?(?:\\2|\\3)(?: on (?:it|(?:its )?top(?: face)?))? {_SELF} {_SHOWN}$",
     "turn {1} {4}"),
    (f"^the (?:letter )?(\\w) on the (\\1 {BLOCK}) ", "the {2} "),
    (f"^(write|spell) (?:the word )?(\\w+)(?: ,)? but (?:with )?the (\\w)(?: is|{MUST} be)? {_SHOWN}$",
     "{1} {2} with the {3} {4}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("subject dislocated budged constraint restriction proviso",)
"""Words that these take besides those that are read anyway."""
