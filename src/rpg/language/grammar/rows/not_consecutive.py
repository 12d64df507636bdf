"""Numbers of a line of which none is next to the one that follows it: "no two consecutive numbers are neighbours"."""

from __future__ import annotations

import re
from itertools import pairwise

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.grammar.rows.vocabulary import MUST
from rpg.language.tokens import Token

_LISTED = re.compile(r"\b(\d(?: (?:, and|,|and|&) \d)+|\d (?:to|through|-) \d)\b")
_NUMBERS = "(?:numbers|digits|blocks|cubes|ones)"
_FOLLOWING = f"(?:consecutive|successive)(?: {_NUMBERS})?"
_NEXT = "(?:neighbou?rs|adjacent|next to (?:each other|one another)|side by side|beside (?:each other|one another))"
_BE = f"(?:are|is|stands?|(?:{MUST}|may|can)(?: be| stand)?|being|standing)"
_SUCCESSOR = ("(?:the (?:one|number|cube|block) that (?:follows|comes after|comes next after|comes right after) it|its "
              "successor|the (?:next|following) (?:one|number))")  # fmt: skip
_ROWS = (
    f"no two {_FOLLOWING} {_BE} {_NEXT}",
    f"no two {_FOLLOWING} {_NEXT}",
    f"no two (?:neighbou?rs|(?:neighbou?ring|adjacent) {_NUMBERS}|{_NUMBERS} next to each other) {_BE} consecutive",
    f"no (?:number|digit|cube|block) {_BE} next to {_SUCCESSOR}",
    f"{_FOLLOWING} (?:{MUST}|may|can) not (?:be |stand )?(?:{_NEXT}|touch(?: each other)?)",
)
_WORDS = frozenset({"consecutive", "successive", "follows", "successor", "after", "following", "next"})


def not_consecutive(tokens: list[Token]) -> list[Token]:
    """The tokens with each two numbers that follow each other told by themselves, where one list of numbers is told."""
    words = {token.word for token in tokens}
    if _WORDS.isdisjoint(words) or words.isdisjoint(("no", "not")):
        return tokens
    lists = _LISTED.findall(text_of(tokens))
    if len(lists) != 1:
        return tokens
    ends = [int(number) for number in re.findall(r"\d", lists[0])]
    numbers = sorted({*ends}) if re.search(", |and|&", lists[0]) else [*range(ends[0], ends[-1] + 1)]
    apart = [(one, two) for one, two in pairwise(numbers) if two == one + 1]
    if not apart:
        return tokens
    told = " . ".join(f"{one} must not be next to {two}" for one, two in apart)
    return turned(tokens, Turns([
        *((f"^{row}$", told) for row in _ROWS),
        *((f"^(.+?)(?: ,)?(?: and| so that| such that| with| but| where)? {row}$", f"{{1}} . {told}") for row in _ROWS),
    ]))  # fmt: skip


WORDS = ("consecutive successive follows successor neighboring neighbouring adjacent",)
"""Words that these rows take besides those that are read anyway."""
