"""Lines in other words: a list ahead of what is done with it, blocks that are to be used, ends that are told one by
one, as rows that tell the order from one end to the other."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, END, FEW, MUST

_DO = "(?:put|place|lay|arrange|line|stack|sort|order|set|pile|build|make|bring|move)"
_LINE = "(?:row|line)"
_ONE = f"{_DO} (?:an?|the|one) ({COLOR})(?: block| cube| one)?"
_ROW = f"(?:an?|the) ({_LINE}) of ((?:{FEW}|\\d+) (?!{_LINE})(?:\\w+ )?(?:blocks|cubes))"
_THEM = "(?:them|these|those|all|it|all of them)"

LINED_AT_ONCE: tuple[Turn, ...] = (
    # what there is, ahead of what is done with it
    (f"^(?:the )?({COLOR}(?: , {COLOR})*(?: ,)? (?:and )?{COLOR})(?: blocks| cubes)? : ({_DO} {_THEM} .+)$",
     "there are {1} blocks . {2}"),
    (f"^use (?:only )?(?:the )?(?:colors )?({COLOR}(?: , {COLOR})*(?: ,)? (?:and )?{COLOR})(?: blocks| cubes)?$",
     "there are {1} blocks"),
    # what is at the ends
    (f"^{_ONE} (?:at|on|to) the left end of {_ROW}$", "a {2} , from left to right : {1} , then {3}"),
    (f"^{_ONE} (?:at|on|to) the right end of {_ROW}$", "a {2} , from left to right : {3} , then {1}"),
    (f"^(?:the|an?) ({_LINE} of [^:]+?) (?:has|{MUST} have) ([^:]*) at its ({END}) end(.* at its \\w+ end)?$",
     "a {1} with {2} at the {3} end {4}"),
    (f"\\bat its ({END}) end\\b", "at the {1} end"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
