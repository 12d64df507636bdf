"""Members of a number of blocks, and those that are left: "three make a row and the other two a tower", "two blocks of
the three", "two of the red blocks ..., the third ...", as rows over a whole text that say it in full."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST

_BLOCKS = "(?:blocks|cubes|bricks)"
_LEFT = (
    f"(?:the (?:other|remaining) (?:{MANY}|half)|the other {MANY}|the (?:rest|others|remaining ones|other ones))"
    f"(?: {_BLOCKS}| of them)?"
)
_DOES = f"(?:touch|form|make|build|are|lie|stand|sit|go|rest|{MUST})"
_ONE_IS = f"(?:is|stands|lies|goes|sits|{MUST} (?:be|stand|lie|go|sit))"
_IT = "(?:it|them|both|those|the (?:tower|stack|row|line|column|pile|pair|(?:other|first) two))"
_NO_RANKS = "(?!.*\\b(?:three|3|first|second|row|line|tower|stack|column)\\b)"
_THIRD = f"\\bthe third (?:one |block |cube |{COLOR} \\w+ )?(?:{_ONE_IS}|touches|on|off)\\b"
MEMBERS_TOLD: tuple[Turn, ...] = (
    (f"\\b(makes?|forms?|builds?) (an? [^,.;]+?) (and|,|;|, and|, while) ({_LEFT}) (?=an? (?:\\w+ )?{LINE}\\b)",
     "{1} {2} {3} {4} make "),
    (f"(?<![^ ])({MANY}) ({_BLOCKS}) of the ({MANY}) (?={_DOES}\\b)", "{1} of the {3} {2} "),
    (f"^(.*\\b{MANY} (?:of|form|make|are)\\b.*)\\bthe last (?:one|block|cube) (?={_ONE_IS} {PLACE} {_IT}(?= [.,;]|$))",
     "{1} the remaining one "),
    (f"^{_NO_RANKS}(?=.*{_THIRD})((?:.* )?(?:two|2)) of the ((?:{COLOR} )?{_BLOCKS}) ", "{1} of the three {2} "),
    (f"^{_NO_RANKS}(?=.*{_THIRD})(two|2) ({COLOR} {_BLOCKS}) (?={_DOES} )", "{1} of the three {2} "),
)  # fmt: skip
"""What is looked for, and what is said instead."""
