"""A wish that is often typed and cannot be read: what is wrong with it in its own words, and what works."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import NamedTuple

_VAGUE = frozenset({"incomplete", "misplaced-word", "no-goal", "unknown-word"})
"""Codes of refusals that do not know what was wished."""


class Wish(NamedTuple):
    """What a text has in it, the message, a wording that works, and further codes of refusals that it is told for."""

    pattern: re.Pattern[str]
    message: str
    hint: str
    also: frozenset[str] = frozenset()

    def explains(self, text: str, codes: Collection[str]) -> bool:
        """Whether this is what was wished, and no refusal with these codes says it better."""
        return _VAGUE | self.also >= {*codes} and self.pattern.search(text) is not None
