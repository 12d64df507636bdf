"""What changes its place with something, or gives way to it, in words that are read in other places as well: "takes the
place of", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST

_END = "(?:top|bottom|middle|lowest|highest|uppermost|leftmost|rightmost|first|second|third|last|upper|lower)"
_BLOCK = "(?:block|cube|brick|one)"
TRADED: tuple[Turn, ...] = (
    (f"\\bthe ({_END}) and the ({_END}) ({_BLOCK})\\b", "the {1} {3} and the {2} {3}"),
    (f"^(.+?) (?:takes|{MUST} take) the place of (.+?) and \\2 (?:(?:takes|{MUST} take) the place of|that of) \\1$",
     "swap {1} and {2}"),
    (f"^(.+?) and (.+?) (?:(?:{MUST} )?end up|{MUST} be|are) in each other 's (?:places?|positions?|spot)$",
     "swap {1} and {2}"),
    ("^i (?:want|would like|need) (.+?) and (.+?) (?:to be )?(?:swapped|exchanged|interchanged|switched)$",
     "swap {1} and {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("spot",)
"""Words that these take besides those that are read anyway."""
