"""Where one of two structures is, or so many of several, told behind them: "..., the taller one on the left", "... with
the red row in front", "..., one of the towers on the mat"; as rows over a text that tell it in a sentence of its own.
"""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turns
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_IS = f"(?: (?:is|goes|stands|comes|being|{MUST} (?:be|go|stand)))?"
_SIDE = "(on the (?:left|right)|in front|at the (?:front|back)|in the (?:front|back))(?= \\.|$)"
_VERB = f"((?:is|goes|stands|comes|lies|{MUST} (?:be|go|stand)|{MUST} not (?:be|stand)|may not (?:be|stand)|is not))"
_THERE = "((?:on|in|at|to|beside|next to|behind|near|left of|right of) [^.,;:]+?)(?= [.;]|$| and the )"
_APART = "(?: ,| \\.| ;)+(?: and| with| but| where)*"
_AND = f"(?:{_APART}| and| while| whereas)"
_LONG, _TALL = "longest|shortest|longer|shorter", "tallest|highest|shortest|lowest|taller|higher|shorter|lower"
_ONES = (("row", _LONG), ("column", _LONG), ("line", _LONG), ("tower", _TALL), ("stack", _TALL))
_SOME = f"((?:exactly |only |just |at least |at most )?{MANY}|none|neither|both|each)"
ONE_OF_TWO = Turns((
    *((f"^(.*\\b{kind}s\\b.*?){_AND} {_SOME} of the ({MANY} )?{kind}s {_THERE}",
       f"{{1}} . {{2}} of the {{3}} {kind}s must be {{4}}") for kind, _ in _ONES),
    *((f"^(.*\\b{kind}s?\\b.*?){_APART} the ({more}) one{_IS} {_SIDE}", f"{{1}} . the {{2}} {kind} must be {{3}}")
      for kind, more in _ONES),
    *((f"^(.*\\b{kind}s?\\b.*?){_AND} the ({more})(?: one)? {_VERB} {_THERE}", f"{{1}} . the {{2}} {kind} {{3}} {{4}}")
      for kind, more in _ONES),
    *((f"^(.*\\b{kind}s?\\b.*?){_AND} the ({more})(?: one)? {_THERE}", f"{{1}} . the {{2}} {kind} must be {{3}}")
      for kind, more in _ONES),
    (f"(?:{_APART}| with)(?: with)? the ({COLOR}) (row|column|line|tower|stack){_IS} {_SIDE}",
     " . the {1} {2} must be {3}"),
))  # fmt: skip
"""What is looked for in a text, and what is said instead."""
