"""Corners and halves of the table that are named ahead of what goes into them, "four corners: one cube in each", and
corners that are filled, or of which none is empty, as rows that say what is in each corner."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PUT
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MUST

_FOUR = "(?:the table has |there are )?(?:the |its )?four corners(?: of the table)?"
_ONE = f"((?:exactly )?(?:one|an?) (?:{COLOR} )?(?:block|cube|brick))"
_BLOCK = f"(?:one|an?) ({COLOR} )?(?:block|cube|brick)"
_ALL = "(?:all(?: of)?(?: the)? four|all(?: the)?|the four|each of the four|each|every)"

CORNERS_ACROSS: tuple[Turn, ...] = (
    (f"(?<![^ ])the table has four corners \\. {PUT} {_ONE} (?:in|into) each(?: of them| one| corner)?(?= \\.|$)",
     "put {1} in each corner of the table"),
)  # fmt: skip
"""What is told in two sentences."""
CORNERS_TOLD: tuple[Turn, ...] = (
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
