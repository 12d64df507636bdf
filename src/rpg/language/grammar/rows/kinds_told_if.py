"""What is done with blocks of a kind, told as a condition: "if a cube is red, it goes on the left mat" is said of every
red cube, and "those without letters must not" of what those with letters do."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MUST

_BLOCK = "(block|cube|brick)"
_IF = "(?:if|when|whenever) (?:an?|any)"
_GOES = f"(?:it (?:{MUST} (?:go|be|be put|be placed|lie|end up)|goes|belongs|is)|(?:put|place|move|bring|set) it)"
_PLACE = "((?:on|onto|in|into|to) (?:the|an?) [^,;]+?)"
_NEXT = "(?: ,| ;| and| , and| ; and| , but| but| while| , while)"

KINDS_ACROSS: tuple[Turn, ...] = (
    (f"\\b({_IF} {_BLOCK} is {COLOR}[^.;]*) [;.] (?:and )?if it is (?={COLOR})", "{1} , if it is"),
)
"""What is told in two sentences."""
KINDS_TOLD_IF: tuple[Turn, ...] = (
    (f"^{_IF} {_BLOCK} is ({COLOR})(?: ,)?(?: then)? {_GOES} {_PLACE}$", "every {2} {1} must be {3}"),
    (f"^{_IF} {_BLOCK} is ({COLOR})(?: ,)?(?: then)? {_GOES} {_PLACE}{_NEXT} (?:if|when) it is ({COLOR})(?: ,)?(?: "
     f"then)? "
     f"{_GOES} {_PLACE}$", "every {2} {1} must be {3} . every {4} {1} must be {5}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
