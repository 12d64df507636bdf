"""Which way a line goes, told in a sentence behind it: "Make a row: red, yellow, blue. Lay it out from right to left.";
and patterns that are lines by that: "a pattern of red, blue, red from left to right"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, WAY

_PLEASE = "(?:please |just |(?:can|could|would|will) (?:you|the robot|somebody|we) |let us )*"
_LAID = (
    f"{_PLEASE}(?:lay|build|make|do|put|set|place|arrange|show|write|form|stack|pile) (?:it|this|that|them|these)"
    "(?: all)?(?: out| up| down)?"
)
_RUNS = (
    "(?:it|this|that|they|the (?:row|line|column|tower|stack|pattern|order|sequence|list)) "
    "(?:goes|go|runs|run|reads|read|is|are|should (?:go|run|read|be)|must (?:go|run|read|be))(?: read)?"
)
_LINE = "(?:row|line|column|tower|stack|pattern|sequence|stack(?:ed)?|lined?)"
_PARTED = "(?:(?!\\b(?:from (?:the )?\\w+ to|not|never|no|starts?|initially|begins?|currently|was|were)\\b)[^.?!;])"
"""No sentence that is of the start, is denied or tells a way itself."""
_LISTED = f"(?!first\\b){_PARTED}*\\b{_LINE}\\b{_PARTED}*(?: ,|\\band) {_PARTED}*?"
_MAKE = "(?:(?:make|build|lay(?: out)?|form|show|create|do|put|we make|here is|this is|there is|it is|i want) )?"

WAY_BEHIND: tuple[Turn, ...] = (
    (f"((?:^|(?<=\\. ))[^.?!;:,]*\\ba (?:\\w+ )?rainbow (?:row|line|column|tower|stack)) [.!] (?=(?:the )?{COLOR} (?:"
     "at|on|in|first|then|,))", "{1} : "),
    (f"((?:^|(?<=\\. )){_LISTED}) [.!?;] (?:{_LAID}|{_RUNS})( in (?:a|one) (?:row|line|column|tower|stack))? ({WAY})"
     "(?: please)?(?= [.!?;]|$)", "{1} , {2} {3}"),
)  # fmt: skip
"""What is said over two sentences."""
PATTERNS_LINED: tuple[Turn, ...] = (
    (f"^{_MAKE}(?:a|an|the|this|that|my|our) (?:\\w+ )?pattern (?:is |of |with |reads )?(?:: )?({_PARTED}+?)(?: ,)?"
     "(?: in a (?:row|line))? (from (?:left to right|right to left))$", "a row : {1} {2}"),
    (f"^{_MAKE}(?:a|an|the|this|that|my|our) (?:\\w+ )?pattern (?:is |of |with |reads )?(?:: )?({_PARTED}+?)(?: ,)?"
     "(?: in a (?:tower|stack))? (from (?:top to bottom|bottom to top))$", "a tower : {1} {2}"),
)  # fmt: skip
"""What makes no sense as it stands."""
