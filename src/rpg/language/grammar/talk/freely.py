"""Orders that are left open but for one thing: "in any order, only white must be above black"."""

from __future__ import annotations

from itertools import takewhile

from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_BREAKS = frozenset({".", "!", "?", ";", ",", ":"})
_IN_ANY_ORDER = tuple(
    (*lead, which, "order", *like)
    for lead in (("in",), ())
    for which in ("any", "whatever", "whichever")
    for like in ((), ("you", "like"), ("you", "want"), ("you", "please"), ("you", "wish"), ("you", "prefer"))
)
_FREELY = (("any", "way", "you", "like"), ("however", "you", "like"), ("any", "way", "you", "want"),
           ("as", "you", "like"), ("in", "any", "way", "you", "like"),
           ("in", "whatever", "order", "you", "like"), ("any", "order", "will", "do"), ("any", "order", "is", "fine"),
           *((*the, "order", *open_, *mine)
             for the in (("the",), ())
             for open_ in (("does", "not", "matter"), ("is", "not", "important"), ("is", "up", "to", "you"))
             for mine in ((), ("to", "me"), ("to", "us"), ("much",), ("at", "all"))))  # fmt: skip
_BUT = (("as", "long", "as"), ("so", "long", "as"), ("provided",), ("but", "with"))


def freely(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Stack them any way you like as long as green is in the middle": as long as it is there.
    "DOG, but as a tower": as a tower. "In any order, only white must be above black": but white must."""
    for at in range(1, len(words) - 2):
        only = at + length_at(words, at, _IN_ANY_ORDER)
        if only > at and words[only : only + 2] in ([",", "only"], [",", "just"]) and _asks(words[only + 2 :]):
            return [*tokens[: only + 1], tokens[only + 1].saying("but"), *tokens[only + 2 :]]
        free = length_at(words, at, _FREELY)
        comma = words[at + free : at + free + 1] == [","]
        begun = at + free + comma
        lead = length_at(words, begun, _BUT) if free else 0
        if lead:
            return [*tokens[:at], *tokens[begun + (lead if words[at - 1] in (".", ";", ":") else 0) :]]
        if words[at : at + 2] == [",", "but"] and words[at + 2] in ("as", "in") and words[at + 3 : at + 4] == ["a"]:
            return [*tokens[:at], *tokens[at + 2 :]] if words[at + 4 : at + 5] != ["group"] else None
    return None


def _asks(words: list[str]) -> bool:
    """ "(Only) red and green can't be neighbours": before the next comma something has to be, or must not be."""
    told = list(takewhile(lambda word: word not in _BREAKS, words))
    return any(word in _MODAL for word in told[1:6])


_MODAL = frozenset({"must", "should", "shall", "cannot", "has", "have", "needs", "need", "not", "never"})  # fmt: skip
