"""Which of several things is so, left open in more words than "or" and "one of them": "it does not matter which of the
two is on the mat, but one of them has to be", "exactly one of the following is true", "accept either ... or ..."."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import FEW, MANY, MUST

_VAIN = "(?:does not|should not|need not|will not|must not) (?:really )?(?:matter|make (?:a|any) difference)"
_OPEN = f"(?:{_VAIN}|makes no difference|is (?:irrelevant|unimportant|not important|up to you|your choice|left open))"
_WHICH = (f"(?:(?:it|this) (?:{_VAIN}|makes no difference|is (?:irrelevant|unimportant|not important))|(?:i|we) do not "
          "(?:really )?(?:care|mind)|no matter|never mind)(?: to me)?")  # fmt: skip
_OF_THEM = f"which(?: one| ones| {MANY})? of ((?:the |these |those |my )?(?:{FEW}|\\d+) [^,]+?)"
_IS = f"(?:is|are|lies?|stands?|sits?|rests?|goes|go|ends up|end up|{MUST} (?:be|go|lie|stand))"
_PLACED = "((?:on|in|at|next|beside|behind|under|near|to the|in front|left|right|touching|between) .+?)"
_BUT = "(?: ,)?(?: (?:but|as long as|so long as|provided(?: that)?|just))?"
_NEEDED = (f"((?:exactly |just |only |at least |at most )?(?:{FEW}|\\d+))(?: of (?:them|the (?:{FEW}|\\d+)|these))?"
           "(?: (?:blocks?|cubes?|ones?))? (?:is|are|does|do|has to|have to|needs to|need to|must|should|ought to)"
           "(?: be)?(?: there)?")  # fmt: skip
_ONE = "(?:(?:exactly|only|just|precisely) )one"
_OF = "of (?:the following|these|those|the two|two|the following two|these two)(?: (?:things|statements|conditions))?"
_HOLDS = (f"(?:(?:is|are|{MUST} be|can be|may be)(?: (?:true|the case|so|met|fulfilled|satisfied|right|correct))|"
          f"holds|applies|(?:{MUST}|may|can) (?:hold|apply|be))(?: (?:in|at) the end| finally)?")  # fmt: skip
_THIS = "((?:(?! or | ?,).)+?)"
_SUM = "[^ ]*=[^ ]*"
_PASS = (
    "(?:are|would be|will be) (?:both )?(?:fine|ok|okay|alright|good|accepted|acceptable|allowed|valid|correct|"
    "possible)(?: (?:with|by|for) (?:me|us))?"
)
_OR = "(?: ,)? or"
"""A way in which it may be, and what stands ahead of the last one."""

ALTERNATIVES_AT_ONCE: tuple[Turn, ...] = (
    # what "or" leaves open anyway
    ("^(.* or .+?)(?: ,)? or (?:even |maybe |perhaps |possibly )?both(?: of (?:them|these))?$", "{1}"),
    ("^(.* or .+?) , never both(?: of (?:them|these))?(?: at once| at the same time)?$", "{1} , but not both"),
    (f"^(?:either )?(all) or none (of (?:the )?(?:{FEW}) .+?) ({PLACE} .+)$", "either {1} {2} or none {2} {3}"),
    ("^([^,]+) , ([^,]+?)(?: ,)? or (?:even |maybe |perhaps |possibly )?both$", "{1} or {2}"),
)
"""What is looked for, and what is said instead; in every sentence."""
ALTERNATIVES: tuple[Turn, ...] = (
    (f"^{_WHICH} {_OF_THEM} {_IS} {_PLACED}{_BUT} {_NEEDED}$", "{3} of {1} must be {2}"),
    (f"^{_OF_THEM} {_IS} {_PLACED} {_OPEN}{_BUT} {_NEEDED}$", "{3} of {1} must be {2}"),
    (f"^{_ONE} {_OF} {_HOLDS} : (?:either )?{_THIS}{_OR} {_THIS}$", "either {1} or {2} , but not both"),
    (f"^at least one {_OF} {_HOLDS} : (?:either )?{_THIS}{_OR} {_THIS}$", "{1} or {2}"),
    (f"^at least one {_OF} {_HOLDS} : (?:either )?{_THIS}(?: ,|{_OR}) {_THIS}{_OR} {_THIS}$",
     "{1} or {2} or {3}"),
    ("^(?:i |we )?(?:will |would )?(?:accept|allow|count|take) (?:either )?(an? .+ or an? .+?)(?: as (?:a |the )?"
     "(?:solution|result|success|goal|done|solved|right|correct))?$", "build {1}"),
    ("^(?:you )?(?:may|can|could) (?:build|make) (?:either )?(an? .+ or an? .+)$", "build {1}"),
    (f"^(?:both )?({_SUM}) and ({_SUM}) {_PASS}(?=$| [,.;])", "{1} or {2}"),
    (f"^both ([^,]+? {PLACE} [^,]+?) and ([^,]+? {PLACE} [^,]+?) {_PASS}$", "{1} or {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
EITHER_WAY: tuple[Turn, ...] = (
    ("(\\bor\\b[^.;]*?)(?: ,| ;| \\.)(?: and)? if both (?:are|is|hold|holds|apply)(?: true| so| the case| met| "
     "fulfilled)?(?: ,)? (?:then )?(?:that|this|it) is (?:also |just )?(?:fine|ok|okay|good|right)(?: too| as well)?"
     "(?= \\.|$)", "{1}"),
    (f"^(?:it|this) (?:{_VAIN}|makes no difference|is (?:irrelevant|unimportant|not important))(?: to me)? "
     f"(?:whether|if) ([^.]+? {PLACE} [^.]+? or [^.]+? {PLACE} [^.]+?){_BUT}(?: (?:at least )?one of (?:them|these|the "
     "two) (?:is|must be|has to be|should be)(?: so| true| the case)?)?(?: \\.)?$", "{1} ."),
)  # fmt: skip
"""Over a whole text that says nothing else: one of the two is what is wanted."""
WORDS = ("accept allow count following statements conditions true case met fulfilled satisfied applies apply holds "
         "irrelevant unimportant matter difference mind care solution result success",)  # fmt: skip
"""Words that these take besides those that are read anyway."""
