"""Two or three rows told by what each of them has: blocks of a kind that are told ahead, "the letters in the front row,
the digits behind them", one look each with a number for all, or lots from front to back."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_AT = "(?:back|far|rear|front|near)"
_ALSO = "(?: ,| and| , and)?"
_MAKE = "(?:(?:build|make|lay|put|lay out) )?"
_LOT = f"(?:an? row of )?({MANY} (?:{COLOR}|letters?|plain)(?: (?:blocks|cubes|ones))?)"
_APIECE = "(?:each|apiece|in each(?: row| of them)?|per row|in every row)"
_ON = "(?: ,| \\.| ;)?(?: and)?"
_THREE = "three rows : {{{}}} in the front row , {{{}}} in the middle row and {{{}}} in the back row"
ROWS_HAVE: tuple[Turn, ...] = (
    *((f"^(?!.*\\b(?:two|2) rows\\b)((?:the )?{_AT} row [^.;]+? (?:the )?{_AT} row [^.;]+?)"
       f"(?: \\.| ,| ;) {ahead}({MANY})(?: blocks| cubes)?{behind}(?= \\.|$)", "two rows of {2} : {1}")
      for ahead, behind in (("each row (?:has|contains) ", ""), ("", f" {_APIECE}"))),
    (f"^(?=(?:.*\\brow\\b){{3}})(.*?)\\ban? ({COLOR}) row of ({MANY})(?: blocks| cubes)?(?= ,| \\.| and|$)",
     "{1} a row of {3} {2} blocks"),
    (f"^{_MAKE}(?:three|3) (?:parallel )?rows(?: one behind the other)?(?: ,)? from (?:the )?front to (?:the )?(?:back|"
     f"rear) : {_LOT} , {_LOT}(?: , and| ,| and) {_LOT}(?= \\.|$)", _THREE.format(1, 2, 3)),
    (f"^{_MAKE}{_LOT}{_ON} behind (?:it|that) {_LOT}{_ON} behind (?:that|that one|it|this one) {_LOT}(?= \\.|$)",
     _THREE.format(1, 2, 3)),
    (f"^{_MAKE}{_LOT}{_ON} in front of (?:it|that) {_LOT}{_ON} in front of (?:that|that one|it|this one) {_LOT}"
     "(?= \\.|$)", _THREE.format(3, 2, 1)),
)  # fmt: skip
"""What is told over a whole text."""

_KIND = (
    f"(?:the )?((?:{COLOR}|plain|odd|even) (?:ones|blocks|cubes|numbers|digits)|letters|digits|numbers|vowels|"
    "consonants|letter (?:blocks|cubes)|number (?:blocks|cubes))"
)
_INTO = (
    f"(?=.*\\brows?\\b)(?!(?:two|2) rows(?: ,| :| with)+ (?:the )?{COLOR}\\b)"
    "(?:(?:(?:arrange|put|place|set|lay|line up) (?:them|these|it|all of them|the (?:blocks|cubes)|everything) (?:up "
    ")?)?(?:(?:in|into|as) )?(?:two|2) rows(?: ,| :| with)+ )?(?:put |place |arrange |line up )?"
)
_ARE = f"(?: (?:{MUST} )?(?:be|is|are|go|goes|stand|come|belong))?"
_FRONTMOST = f"{_ARE} (?:in|into|as|on|at)(?: the)? (?:front|near)(?: row| one)?"
_BACKMOST = f"{_ARE} (?:(?:in|into|as|on|at)(?: the)? (?:back|rear|far)(?: row| one)?"
_BEHIND_THEM = "|(?:in (?:a|the|another) row )?behind(?: (?:them|it))?)"
_BEFORE_THEM = f"{_ARE} (?:(?:in|into|as|on|at)(?: the)? (?:front|near)(?: row| one)?|in front of (?:them|it))"
_EACH = "(?:(?: ,| and| with)+ ((?:each|every) .+))?"
_THERE = f"((?:the )?(?:{MANY}(?! rows)|letters|digits|numbers|blocks|cubes) [^.;:]+?)(?: ,| :) "


def _kinds(first: str, second: str, where: str) -> tuple[Turn, Turn]:
    """Two kinds with a row each, and the same behind what tells which blocks there are."""
    said = f"the {{}} must be in a row . the {{}} must be in a row {where} them . {{}}"
    both = f"{_KIND}{first}{_ALSO} {_KIND}{second}{_EACH}$"
    return (
        (f"^{_INTO}{both}", said.format("{1}", "{2}", "{3}")),
        (f"^(?=.*\\brows?\\b){_THERE}{both}", f"there are {{1}} . {said.format('{2}', '{3}', '{4}')}"),
    )


KINDS_IN_ROWS: tuple[Turn, ...] = (
    *_kinds(_FRONTMOST, f"{_BACKMOST}{_BEHIND_THEM}", "behind"),
    *_kinds(f"{_BACKMOST})", _BEFORE_THEM, "in front of"),
)
"""Blocks of a kind that are told ahead, each kind in a row of its own."""
