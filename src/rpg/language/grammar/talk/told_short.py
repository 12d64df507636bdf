"""Halves and pairs told short: "half the blocks on the red patch and half on the blue patch" is one half and the other
half, "so that no two touch" is no two blocks."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_STOPS = frozenset({".", ";", "!", "?"})
_JOINTS = frozenset({"and", ",", "while", "then"})
_PLACES = frozenset(
    {"on", "in", "to", "onto", "into", "at", "go", "goes", "should", "must", "are", "is", "left", "right"}
)
_LEADS = ((), ("put",), ("place",), ("move",), ("i", "want"), ("please", "put"))


def halves_told(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with "the other half" for the second of two, and "half of the blocks" for a first one of nothing."""
    at = [n for n, word in enumerate(words[:-1]) if word == "half" and words[n - 1 : n] != ["other"]]
    if len(at) != 2 or not _STOPS.isdisjoint(words[at[0] : at[1]]):
        return None
    first, second = at
    of_them = 2 * (words[second + 1 : second + 3] in (["of", "them"], ["of", "those"], ["of", "these"]))
    behind = words[second + 1 + of_them : second + 2 + of_them]
    if words[second - 1] not in _JOINTS or not behind or behind[0] not in _PLACES:
        return None
    of = [tokens[first].saying(word) for word in ("of", "the", "blocks")]
    bare = words[first + 1] in _PLACES and tuple(words[:first]) in _LEADS
    other = [tokens[second].saying(word) for word in ("the", "other")]
    rest = [*other, tokens[second], *tokens[second + 1 + of_them :]]
    return [*tokens[: first + 1], *(of if bare else ()), *tokens[first + 1 : second], *rest]


_AFTER_TWO = frozenset({"are", "is", "touch", "touches", "should", "must", "may", "can", "shall", "will", "lie",
                        "stand", "touching", "next", "end", "have"})  # fmt: skip


def no_two(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(So that) no two are touching": no two blocks."""
    for at in range(2, len(words)):
        if words[at - 2 : at] == ["no", "two"] and words[at] in _AFTER_TWO:
            return [*tokens[:at], tokens[at].saying("blocks"), *tokens[at:]]
    return None


def any_other(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "No block may touch any other block": another."""
    for at in range(3, len(words) - 2):
        if words[at : at + 2] != ["any", "other"] or words[at + 2] not in (*lexicon.BLOCK, "one"):
            continue
        begun = max((n + 1 for n in range(at) if words[n] in _STOPS or words[n] == ","), default=0)
        if any(one == "no" and words[n + 1] in lexicon.BLOCK for n, one in enumerate(words[begun:at], begun)):
            return [*tokens[:at], tokens[at].saying("another"), *tokens[at + 3 :]]
    return None


_BESIDE = frozenset({"of", "from", "behind"})
"""Behind these "every other block" is all others, and not every second one."""


def every_other(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "To the right of every other block": of all others."""
    for at in range(2, len(words) - 2):
        ones = words[at + 2] in (*lexicon.BLOCK, *lexicon.LOOSE_BLOCK, "one")
        if words[at : at + 2] == ["every", "other"] and ones and words[at - 1] in _BESIDE:
            others = [tokens[at].saying(word) for word in ("all", "others")]
            return [*tokens[:at], *others, *tokens[at + 3 :]]
    return None


_GROUPING = frozenset({"group", "put", "split", "divide", "sort", "separate", "arrange", "organize", "place", "stack",
                       "pile", "like", "want", "have", "need", "collect", "gather", "lay", "set"})  # fmt: skip


def in_pairs(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Group the blocks into pairs": into groups of two; and "each pair" is each of these groups."""
    at = next((n for n in range(2, len(words) - 1) if words[n + 1] in _PAIRS and words[n] in ("in", "into")), 0)
    behind_it = tuple(words[at + 2 : at + 5])
    ends = not behind_it or behind_it[0] in _STOPS or behind_it in _OF_ONE_COLOR or behind_it[:2] in _OF_EACH
    if (
        not at
        or not ends
        or _GROUPING.isdisjoint(words[:at])
        or words[at - 1] not in (*lexicon.BLOCK, "them", "these", "those")
        or "," in words[:at]
    ):
        return None
    groups = [tokens[at].saying(word) for word in ("into", "groups", "of", "two")]
    behind = [
        t.saying("group") if t.word == "pair" and words[at + 1 + n] == "each" else t
        for n, t in enumerate(tokens[at + 2 :])
    ]
    return [*tokens[:at], *groups, *behind]


_PAIRS = ("pairs", "twos", "couples")
_OF_EACH = ((",", "each"), (",", "every"), (",", "same"))
_OF_ONE_COLOR = (("of", "the", "same"), ("of", "equal", "color"), ("of", "one", "color"), ("by", "color", ""))


_TURNED = frozenset({"backwards", "reversed", "backward", "mirrored"})


def but_turned(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Spell DOG, but backwards": backwards."""
    for at in range(1, len(words) - 1):
        last = at + 2 == len(words) or words[at + 2] in _STOPS
        if words[at] == "but" and words[at + 1] in _TURNED and last:
            return [*tokens[: at - (words[at - 1] == ",")], *tokens[at + 1 :]]
    return None
