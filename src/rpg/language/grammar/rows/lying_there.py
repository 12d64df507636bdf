"""What there is at a place, and how it lies there: "on the mat there are two blocks, one on top of the other", as rows
that say both of the blocks."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_SEVERAL = f"({MANY} (?:{COLOR} )?(?:{BLOCK}s|bricks|boxes)|an? {COLOR}(?: {BLOCK})? and an? {COLOR} {BLOCK})"
_OVER = "(?:directly |right )?(?:on|on top of|above|next to|beside|behind|in front of)"
_HOW = f"(?:,|with)? ?(one {_OVER} the other(?: one)?|stacked|piled up)(?=$| ,| and)"
_AT = "((?:on|in) (?:the|an?) [^,:;]+?)"
_BEGIN = "(?:^|(?<=at the start )|(?<=at the end )|(?<=, )|(?<= and ))"

LYING_THERE_AT_ONCE: tuple[Turn, ...] = (
    (f"{_BEGIN}{_AT} (?:there )?(?:are|is|lie|stand) {_SEVERAL} {_HOW}", "{2} are {1} , {3}"),
    (f"{_BEGIN}{_AT} (?:there )?({MUST} (?:be|lie|stand)) {_SEVERAL} {_HOW}", "{3} {2} {1} , {4}"),
    (f"{_BEGIN}there (?:are|is) {_SEVERAL} {_AT} {_HOW}", "{1} are {2} , {3}"),
    (f"{_BEGIN}there ({MUST} be) {_SEVERAL} {_AT} {_HOW}", "{2} {1} {3} , {4}"),
    ("(?<=, )one ((?:directly |right )?(?:next to|beside)) the other(?: one)?(?=$| ,| and)", "{1} each other"),
)
"""What is looked for in every sentence, and what is said instead."""
