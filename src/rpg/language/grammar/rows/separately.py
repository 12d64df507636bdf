"""Lots that are stacked or lined up each for itself, "the three yellow blocks, and the two green ones too, but
separately", "a tower of A and B and one of C and D", and a block on one of several towers, as rows that tell each by
itself."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, PATCH

_BLOCKS = "(?:blocks|cubes|ones|letters|digits)"
_LOT = f"(?:(?:the |all |all the )?(?:{MANY} )?(?:{COLOR} )?{_BLOCKS})"
_WAYS = (("(?:stack|pile up|pile)", "tower"), ("line up", "row"))
_ALSO = "(?: too| as well| also)?"


def _each(done: str, figure: str) -> tuple[Turn, ...]:
    both = f"build two separate {figure}s , one of {{1}} and one of {{2}}"
    return (
        (f"^(?:please )?{done} (?:the )?({COLOR})(?: {_BLOCKS})? and (?:the )?({COLOR}) {_BLOCKS}(?: ,)?(?: but)? "
         "separately$", both.replace("{1}", "the {1} blocks").replace("{2}", "the {2} blocks")),
        (f"^(?:please )?{done} ({_LOT})(?: ,)? and(?: ,)? separately(?: ,)? ({_LOT})$", both),
        (f"^(?:please )?{done} ({_LOT})(?: ,)? and ({_LOT}){_ALSO}(?: ,)?(?: but)? separately$", both),
    )  # fmt: skip


_NAMED = f"(?:(?:the|an?|and|,|{MANY}|{COLOR}|[a-z]|\\d|blocks?|cubes?) )+?"
_BY_IT = "(?:next to|beside|behind|in front of|left of|right of|to the left of|to the right of) it"
_THERE = f"(?:(?:on (?:the|an?) (?:{COLOR} )?{PATCH}|{_BY_IT}) )?"
_LABELS = "[a-z\\d](?:(?: ,| and| , and) [a-z\\d])+(?! blocks| cubes)\\b"

SEPARATELY: tuple[Turn, ...] = (
    (f"\\b(an?|one) ({LINE}) of ({_NAMED}{_THERE})(?:, )?and ((?:there (?:is|are|{MUST} be) )?{_THERE})one of "
     f"(?={_LABELS})", "{1} {2} of {3} and {4} a {2} of"),
    *(row for done, figure in _WAYS for row in _each(done, figure)),
    ("^isolate (the [^,]+?) from (?=the|all|both|every)", "keep {1} away from "),
    ("\\b(?:isolated|alone(?: ,)? (?:and )?(?:far )?away) from (?=the|all|both|every)", "away from "),
    ("^((?:put )?[^,]+ on ([^,]+) and [^,]+ on ([^,]+?))(?: ,)? separately$", "{1} . {2} and {3} must be on the table"),
)  # fmt: skip
"""What is looked for, and what is said instead; in every sentence."""


def _topped(many: int) -> Turn:
    """ "Build three towers of two white blocks and put a red block on top of one of them"."""
    said, fewer = (next(word for word, n in lexicon.NUMBER.items() if n == m) for m in (many, many - 1))
    others = "a tower" if many == 2 else f"{fewer} towers"
    return (
        f"^(?:build|make|form) {said} (?:towers|stacks) of ({MANY}) ({COLOR}) (?:blocks|cubes)(?: each)?(?: ,| \\.|)"
        f"(?: and)?(?: then)?(?: ,)? (?:put|place|set) (?:an?|the|one) ({COLOR}) (?:block|cube|one) on(?: top of)? "
        "(?:exactly |just |only )?one of (?:them|these|the towers|the stacks)(?= \\.|$)",
        f"build {others} of {{1}} {{2}} blocks and a tower of {{1}} {{2}} blocks with a {{3}} block on top",
    )


ONE_TOPPED: tuple[Turn, ...] = tuple(map(_topped, range(2, 7)))
"""The same over a whole text, for so many towers."""
WORDS = ("separately isolate isolated",)
"""Words that these take besides those that are read anyway."""
