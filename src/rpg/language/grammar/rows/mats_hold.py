"""What each mat may hold, or has to, and blocks that are all on some mat: "no mat may hold more than three", "every mat
must contain one block of each color", "each block is on a mat", as rows that say it of the blocks."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH, PATCHES

_BLOCK = "(?:blocks?|cubes?|bricks?|ones?)"
_HOLD = "(?:hold|have|carry|contain|bear|get|receive)"
_HOLDS = f"(?:(?:{MUST}|may|can|is allowed to) {_HOLD}|holds|has|carries|contains|bears|gets|receives)"
_ON_IT = "(?: on (?:it|them|top))?"
_LOT = f"({MANY}(?: {COLOR})?)(?: {_BLOCK})?"
_FIXED = f"(?:an? (?:{COLOR} )?|{MANY} (?:{COLOR} )?)(?:blocks?|cubes?|bricks?|{PATCHES}|{PATCH})"
_SO_MANY_EACH = (
    f"(?:exactly |just |only |at least |at most )?{MANY}(?: {_BLOCK})? (?:per|(?:on|onto|in|for|to) (?:each|every))"
)

MATS_HOLD_AT_ONCE: tuple[Turn, ...] = (
    # the stock by itself, and in front of what each mat gets, of which it is no part
    (f"^(?=.*\\b(?:{PATCHES}|{PATCH})\\b)({_FIXED}) , ({_FIXED})$", "there are {1} and {2}"),
    (f"^(?=.*\\b(?:{PATCHES}|{PATCH})\\b)({_FIXED}) , ({_FIXED}) , (?={_SO_MANY_EACH}\\b)", "there are {1} and {2} . "),
)  # fmt: skip
"""What is looked for in every sentence, and what is said instead."""
MATS_HOLD: tuple[Turn, ...] = (
    # what there is, in short
    (f"^(?=.*\\b(?:{PATCHES}|{PATCH})\\b)({_FIXED}(?:(?: ,| and| , and) {_FIXED})*)$", "there are {1}"),
    # at most so many, and no fewer
    (f"^(?:no|none of the(?: {MANY})?) (?:{PATCH}|{PATCHES}) (?:{MUST}|may|can|is allowed to) {_HOLD} (more|fewer) "
     f"than "
     f"{_LOT}{_ON_IT}$", "no patch may have {1} than {2} blocks on it"),
    (f"^(?:each|every|each of the(?: {MANY})?) (?:{PATCH}|{PATCHES}) {_HOLDS} (?:at most|no more than|not more than) "
     f"{_LOT}{_ON_IT}$", "no patch may have more than {1} blocks on it"),
    (f"^(the (?:{COLOR} )?{PATCH}|it) (?:(?:{MUST}|may|can) not {_HOLD} more than|{_HOLDS} (?:at most|no more than)) "
     f"(?=.*\\bof the\\b)(.+)$", "at most {2} may be on {1}"),
    # "it must not be empty, and it must ..."
    (f"^(the (?:{COLOR} )?{PATCH}) ({MUST} not be empty)(?: ,)? (?:and|but) it (.+)$", "{1} {2} . {1} {3}"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""
ON_SOME_MAT: tuple[Turn, ...] = (
    (f"^(?=.*\\b(two|three|four|2|3|4) (?:different )?({PATCHES})\\b)(.*\\b(?:each|every)(?: one)?(?: of)?(?: the)?"
     f"(?: {MANY})? (?:blocks?|cubes?|bricks?) (?:{MUST} (?:be|lie|go|stand)|is|lies|goes)(?: put| placed)? "
     f"(?:on|onto|in)) "
     f"(?:an?|some|any) {PATCH}(?= [.,;]|$)", "{3} one of the {1} {2}"),
    (f"^(?=.*\\b(two|three|four|2|3|4) (?:different )?({PATCHES})\\b)(.*\\b)(all|all the|all of the)((?: {MANY})? "
     f"(?:blocks|cubes|bricks)) (?:{MUST} (?:be|lie|go|stand)|are|lie|go) (?:on|onto|in) (?:an?|some|any) {PATCH}"
     "(?= [.,;]|$)", "{3} each of the {5} must be on one of the {1} {2}"),
)  # fmt: skip
"""Over a whole text: "each block is on a mat", where several mats are told of that have no colors."""
