"""Sums whose result is to be found, and numbers that are to be read, in other words: "show what 8 minus 2 is", "so that
321 can be read", "count down from 9 to 7", as rows that solve, write or line them up."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import CUBE, MANY, MUST, WAY

_OP = "(?:[-+*/x]|plus|minus|times|multiplied by|divided by)"
_SUM = f"({MANY} {_OP} {MANY}(?: {_OP} {MANY})*)"
_EQUATION = f"(\\S*\\d=\\S+|{_SUM[1:-1]} = {MANY}|{MANY} = {_SUM[1:-1]})"
_DO = "(?:write|show|make|lay out|lay|build|spell out|form|put|arrange|place|display)(?: down)?"
_WHOLE = "(?:whole |complete |full |entire )?"
_CALL = f"{_WHOLE}(?:equation|calculation|sum|addition|subtraction|multiplication|division|problem)"
_RESULT = "(?:with|and|including|together with|plus) (?:its|the)(?: right| correct)? (?:result|solution|answer|outcome)"
_TRUE = "(?:correct|true|valid|right)"
_CUBES = "(?:(?:symbol|number|digit|letter) )?(?:cubes|blocks)"
_ALONG = "(?:from )?(?:the )?left to (?:the )?right"
_LARGE = "(?:biggest|largest|highest)"
_SMALL = "(?:smallest|lowest)"
_WHICH = "(?: number| digit| one)?"
_NEAR = "(?:nearest|closest)(?: to)? (?:me|us|you|the viewer|the robot)"

_OPERANDS = f"(?:with|of|from|using|made of|out of) (?:two|2) (?:(?:number|digit)s?(?: {CUBE}s)?|summands)"
_MARKS = "(?:(?: ,| and| with)+ (?:an? )?(?:{sign}|=|equals?|equality)(?: sign| symbol| block| cube)?)*"
_RESULT_IS = (
    "((?:with |and )*(?:an? |the )?(?:number |digit )?\\w+ as (?:the|its) (?:result|answer|sum|total)|(?:with |and )?"
    "(?:the |a )?(?:result|answer) (?:of )?\\w+|(?:that|which) (?:gives?|makes?|equals?|adds? up to|comes? to) \\w+|"
    "whose (?:result|answer|sum) is \\w+)"
)


def _of_two_numbers(sign: str, kind: str, called: str) -> Turn:
    """ "A sum with two number cubes, a plus, an equals sign and an 8 as the result": there is no other with it."""
    return (
        f"\\ban? (?:{_TRUE} )?(?:{called}|equation|calculation) {_OPERANDS}{_MARKS.format(sign=sign)}(?: ,)? "
        f"{_RESULT_IS}$",
        f"{kind} {{1}}",
    )


SUMS_AT_ONCE: tuple[Turn, ...] = (
    # sums of which the result alone is told
    _of_two_numbers("\\+|plus", "an addition", "sum|addition"),
    _of_two_numbers("-|minus", "a subtraction", "subtraction|difference"),
    _of_two_numbers("\\*|times|multiplication", "a multiplication", "multiplication|product"),
    _of_two_numbers("/|division|divided by", "a division", "division|quotient"),
    ("\\b(an? (?:addition|subtraction|multiplication|division)) and (?=(?:an? |the )?(?:\\w+ as (?:the|its) |result))",
     "{1} with "),
    # sums
    (f"^(?:show|tell|demonstrate)(?: me)? (?:how much|what) {_SUM} (?:is|are|makes?|gives?|equals)(?:(?: ,)? (?:by|as|"
     f"in|with)(?: (?:laying|writing|building|spelling|showing)(?: out| down)?)?(?: the| an?)? {_CALL})?(?: ,)?(?: "
     f"(?:using|with|by using|in|out of)(?: the| my| our)? {_CUBES})?$",
     "solve {1}"),
    (f"^and {_DO} the {_CALL}$", ""),
    (f"^{_DO} the (?:sum|addition) of ({MANY}) and ({MANY}) {_RESULT}$", "solve {1} + {2}"),
    (f"^(?:do|solve|work out|calculate|compute)(?: the (?:sum|calculation|problem))? {_SUM}(?: ,)? and (?:show|put|"
     f"lay|give|display|include|add)(?: me)? (?:the|its) (?:answer|result|solution)(?: too| as well| "
     "also)?$", "solve {1}"),
    ("^use (?:the )?(?:number|digit|symbol|sign)(?: (?:and|or) (?:number|digit|symbol|sign))? (?:cubes|blocks)(?: "
     ",)?(?: in a (?:row|line))?$", ""),
    # equations
    ("^(?:(?:if|when) i look (?:down|at (?:it|them|the table))(?: ,)? )?i (?:want|would like) to (?:read|see) "
     f"{_EQUATION}(?: on the table)?$", "write {1}"),
    (f"\\b(?:so|such) that an? {_TRUE} {_CALL} (?:comes out|come out|results|is formed|appears|arises)$",
     "so that they form a true equation"),
    (f"\\b(equation) (?:that|which) (?:shows|says|states|tells) that (?={MANY} )", "{1}"),
    # numbers that are read
    (f"\\b(?:so|such) that(?: ,)? (?:({WAY})(?: ,)? )?(?:(?:they|it|the (?:digits|cubes|blocks)|you|one) can be "
     f"read(?: as)?(?: ({WAY}))?(?: as)? (\\d+)|(\\d+) (?:can be read|is read|is shown))$",
     "so that they read {3} {4} {1} {2}"),
    ("\\b(?:so|such) that the number (\\d+) (?:appears|results|is shown)(?: when| if)?(?: you)? read(?:ing)?(?: it)? "
     f"({WAY})$", "so that they read {1} {2}"),
    ("^(?:digit|number) (?:cubes|blocks) in an? (?:row|line) (?:that|which) (?:reads|says|shows) (\\d+)$",
     "write the number {1}"),
    ("^(?:put|place|lay|arrange) the digits of (\\d+) (?:next to each other|side by side|in a row) so that they read "
     "\\1$", "write the number {1}"),
    # numbers in order
    (f"^count(?: up)? from ({MANY}) to ({MANY})(?: (?:with|in|using) {_CUBES})?(?: ,)?(?: in a row)?(?: ,)? {_ALONG}$",
     "put the digits from {1} to {2} in a row in ascending order from left to right"),
    (f"^count down from ({MANY}) to ({MANY})(?: (?:with|in|using) {_CUBES})?(?: ,)?(?: in a row)?(?: ,)? {_ALONG}$",
     "put the digits from {2} to {1} in a row in descending order from left to right"),
    (f"^count (?:up|down) : ((?:put|place|lay) .+ {WAY})$", "{1}"),
    ("\\b(row|line) of (?:the )?(?:digits|numbers) from (\\d+) (?:on|at) the left down to (\\d+) (?:on|at) the right$",
     "{1} of the digits from {3} to {2} in descending order from left to right"),
    ("^descending(?: (?:numbers|order))?(?: please)? : (.+?)(?: ,)?(?: (?:in )?a row)?(?: ,)? (?:the "
     f")?{_LARGE}{_WHICH} (?:on|at) the left(?: end)?$", "put {1} in a row in descending order from left to right"),
    (f"\\b(?:gets?|are|is|{MUST} be) sorted in(?:to)? an? (row|line) , (?:the )?{_SMALL}{_WHICH} on the left(?: "
     f",)?(?: and)? (?:the )?{_LARGE}{_WHICH} on the right$", "must be in a {1} in ascending order from left to right"),
    (f"\\bone (?:behind|after) the other(?: ,)? (?:with )?(?:the )?{_SMALL}{_WHICH} {_NEAR}$",
     "in a column in ascending order from front to back"),
    ("\\bone (?:behind|after) the other(?: ,)? (from front to back|from back to front)(?: ,)? (in \\w+ order)$",
     "in a column {2} {1}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("result results outcome solution answer compute calculate quotient count comes out",)
"""Words that these take besides those that are read anyway."""
