"""What a text is signed with: "Best, Karl", "Kind regards, Dr. Miller"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.harmless import NAMES
from rpg.language.nicknames import strange
from rpg.language.telling import tells
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_CLOSING = listed("best kind warm many regards wishes cheers thanks yours sincerely truly love greetings xoxo")
_STOPS = frozenset({".", "!", "?", "…"})
_TITLES = listed("dr prof mr mrs ms")
_LONGEST = 3


def signature(tokens: Sequence[Token]) -> int:
    """Where a signature begins behind a sentence; 0 where there is none."""
    words = [token.word for token in tokens]
    end = len(words) - (words[-1:] == ["."])
    name = end
    while name and name > end - _LONGEST and _named(tokens, name - 1):
        name -= 1
    if name == end or words[name - 1 : name] != [","]:
        return 0
    begin = name - 1
    while begin and words[begin - 1] in _CLOSING:
        begin -= 1
    return begin if 0 < begin < name - 1 and words[begin - 1] in _STOPS else 0


def _named(tokens: Sequence[Token], n: int) -> bool:
    """A name, or what stands in front of one: "Dr", with a stop behind it."""
    token = tokens[n]
    title = token.word in _TITLES or (token.word == "." and tokens[n - 1].word in _TITLES)
    name = token.raw[:1].isupper() and (token.word in NAMES or strange(token)) and not tells(token)
    return title or name
