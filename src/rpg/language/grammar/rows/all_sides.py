"""The four sides of a block told one by one, "one left, one right, one in front and one behind", "(left, right, front
and back)", which are all that it has: "one on each side", "on all four sides"."""

from __future__ import annotations

import re

from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_AT = "(?:(?:on|to|at|in) (?:the |its )?)?"
_SIDES = {
    "left": f"{_AT}left(?: side)?(?: of it)?",
    "right": f"{_AT}right(?: side)?(?: of it)?",
    "front": f"{_AT}front(?: side| of it)?",
    "behind": f"(?:behind(?: it)?|{_AT}back(?: side| of it)?)",
}
_BOTH = "(?:on|at) (?:each|either) side(?: of it)?"
"""Of the two that are left besides those in front and behind."""
_ONE = "(?:one(?: (?:of them|block|cube|each))? )?"
_SIDE = f"{_ONE}(?:{'|'.join((*_SIDES.values(), _BOTH))})"
_EACH = "(?:on|at) (?:each|every|all)(?: (?:one )?of (?:its|the))?(?: four)? sides?(?: of it)?"
_LISTED = on_demand(
    f"(?P<ahead>.*?)(?P<each> {_EACH})?(?: [,:(-]| with| namely| that is)+ (?P<sides>{_SIDE}(?:(?: ,| and| ;)+ "
    f"{_SIDE}){{2,3}})"
    "(?: \\))?(?= [.,;!]|$)"
)

_AROUND = frozenset({"around", "round", "surround", "surrounded", "surrounding"})


def all_sides(tokens: list[Token]) -> list[Token]:
    """The tokens, with the four sides of a block as all that it has."""
    words = [token.word.replace(" ", "_") or "_" for token in tokens]
    if "left" not in words and "each" not in words:
        return tokens
    listed = _LISTED.match(" ".join(words))
    if listed is None or not _all_four(listed["sides"]):
        return tokens
    if not listed["each"] and _AROUND.isdisjoint(listed["ahead"].split()):
        return tokens
    begin, end = listed.end("ahead"), listed.end()
    first, last = listed.string[:begin].count(" ") + 1, listed.string[:end].count(" ") + 1
    said = ["on", "all", "four", "sides"] if listed["each"] else [",", "one", "on", "all", "four", "sides"]
    return [*tokens[:first], *(tokens[first].saying(word) for word in said), *tokens[last:]]


def _all_four(listed: str) -> bool:
    """Whether each of the four is named once."""
    found = [
        [name for name, side in _SIDES.items() if re.fullmatch(f"{_ONE}{side}", part)] or ["left", "right"]
        for part in re.split("(?: ,| and| ;)+ ", listed)
    ]
    return sorted(name for names in found for name in names) == sorted(_SIDES)
