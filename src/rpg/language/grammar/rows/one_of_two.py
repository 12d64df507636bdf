"""Where one of two structures is, told behind them: "..., the taller one on the left", "... with the red row in front",
as rows over a text that tell it in a sentence of its own."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turns
from rpg.language.grammar.rows.vocabulary import COLOR, MUST

_IS = f"(?: (?:is|goes|stands|comes|being|{MUST} (?:be|go|stand)))?"
_SIDE = "(on the (?:left|right)|in front|at the (?:front|back)|in the (?:front|back))(?= \\.|$)"
_APART = "(?: ,| \\.| ;)+(?: and| with| but| where)*"
_ONES = (("row|column|line", "longer|shorter"), ("tower|stack", "taller|higher|shorter|lower"))
ONE_OF_TWO = Turns((
    *((f"^(.*\\b({kinds})s?\\b.*?){_APART} the ({more}) one{_IS} {_SIDE}", "{1} . the {3} {2} must be {4}")
      for kinds, more in _ONES),
    (f"(?:{_APART}| with)(?: with)? the ({COLOR}) (row|column|line|tower|stack){_IS} {_SIDE}",
     " . the {1} {2} must be {3}"),
))  # fmt: skip
"""What is looked for in a text, and what is said instead."""
