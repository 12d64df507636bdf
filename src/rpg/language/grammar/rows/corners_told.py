"""Corners and halves of the table that are named ahead of what goes into them, "four corners: one cube in each", and
corners that are filled, or of which none is empty, as rows that say what is in each corner."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PUT, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_FOUR = "(?:the table has |there are )?(?:the |its )?four corners(?: (?:of|on) the table)?"
_ONE = f"((?:exactly )?(?:one|an?) (?:{COLOR} )?(?:block|cube|brick))"
_BLOCK = f"(?:one|an?) ({COLOR} )?(?:block|cube|brick)"
_TABLE = "(?: of the table)?"
_IN = f"(?: (?:{MUST} (?:be|go|lie)|goes|go|are|is|belongs|belong|lies|lie))?(?: all)?(?: together)? (?:in|into|to)"
_LOT = f"(?:{THINGS}|the (?:{MANY} )?{COLOR}s)"
_ALL = "(?:all(?: of)?(?: the)? four|all(?: the)?|the four|each of the four|each|every)"

_SIDE = "(?:near|far|left|right)"
CORNERS_ACROSS: tuple[Turn, ...] = (
    (f"(?<![^ ])(?=the table has |there are ){_FOUR} [.,:] {PUT} {_ONE} (?:in|into) each(?: of them| one| corner)?"
     "(?= \\.|$)",
     "put {1} in each corner of the table"),
)  # fmt: skip
"""What is told in two sentences."""
CORNERS_AT_ONCE: tuple[Turn, ...] = (
    (f"\\b({MUST}) each (be|go|lie|stand) in an? (?:different|separate) corner\\b", "{1} {2} in different corners"),
    *((f"^(?:{PUT} )?({_LOT}){_IN} (?:one|a)(?: single)? corner{_TABLE}(?: ,)?(?: and| while| ,) ({_LOT}){_IN} {other}"
     f"(?: corner| one){_TABLE}$", f"put {{1}} and {{2}} in {corners} corners of the table")
      for other, corners in (("(?:another|a different|a second)", "different"), ("(?:the|an) opposite", "opposite"))),
    *((f"\\b({_SIDE} corners?\\b.* (?:in|into) (?:each|both|the)(?: of)?(?: the)?(?: two)? {_SIDE}) {one}(?= |$)",
       f"{{1}} {corner}") for one, corner in (("ones", "corners"), ("one", "corner"))),
)  # fmt: skip
"""Two lots, each in a corner of which it is not said which, or in "the near ones"; in every sentence."""
CORNERS_TOLD: tuple[Turn, ...] = (
    (f"^(?:each|every)(?: one)?(?: of the (?:four )?corners?| corner){_TABLE} (?:{MUST} )?(?:has|have|holds?|gets?|"
     f"contains?) {_ONE}(?: (?:in|on) it)?$", "put {1} in each corner of the table"),
    (f" and (?=there are |the table has ){_FOUR}(?= ?[:,].*\\bcorner$)", ""),
    (f"^{_FOUR} ?[:,] (?:four (?:blocks|cubes|bricks) ?[:,] )?(?:{PUT} )?{_ONE} (?:in|into) each(?: of them| one| "
     "corner)?(?: of the table)?$", "put {1} in each corner of the table"),
    (f"^(?:{_FOUR}|(?:two |three )?corners(?: of the table)?) ?[:,] (?=.*\\b(?:near|far|front|back|left|right) "
     "corner\\b)",
     ""),
    ("^(?:the )?(?:table has )?(?:the )?(?:two )?halves(?: of the table)? ?[:,] (?=.*\\bhalf\\b.*\\bhalf\\b)", ""),
    (f"^{_ALL} corners?(?: of the table)? {MUST} (?:be|get)(?: occupied| filled| taken| covered)(?: by| with) "
     f"{_BLOCK}(?: "
     "each)?$", "put a {1} block in each corner of the table"),
    (f"^(?:fill|occupy) {_ALL} corners?(?: of the table)? with {_BLOCK}(?: each)?$",
     "put a {1} block in each corner of the table"),
)  # fmt: skip
"""What makes no sense as it stands."""
