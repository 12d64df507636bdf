"""Which of all blocks is beyond the others: "red is the rightmost of the four", "A is farthest to the left", as rows
that say it as others do."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import ME, MUST

_FAR = "(?:farthest|furthest)"
_MOST = (f"(?:leftmost|rightmost|frontmost|(?:nearest|closest)(?: to {ME})?|{_FAR}(?: away)?(?: from {ME})?|"
         "topmost|uppermost|lowest|bottommost)")  # fmt: skip
_ONE = "(?: one| block| cube)?"
_IS = f"(?:is|{MUST} be)"

UTMOST_TOLD: tuple[Turn, ...] = (
    *((f"\\b(?:the )?{_FAR}{_ONE} (?:(?:out )?(?:to|towards|on|at) the )?{side}(?= ,| and| of| among|$)", f"{side}most")
      for side in ("left", "right")),
    (f"^(.+?) ({_IS}) (?:the )?({_MOST}){_ONE} (?:of|among|out of|from) (?!an? \\w)(.+)$",
     "there are {4} . {1} {2} {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
