"""Several that look alike, one here and another there, and what "the other" of two is when the first is told."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import behind, length_at
from rpg.language.tokens import Token

ANOTHER = frozenset({"another", "second", "third", "fourth", "last"})
_ONE_MORE = (("another",), ("another", "one"), ("the", "second"), ("the", "second", "one"), ("the", "third"),
             ("the", "third", "one"), ("the", "fourth"), ("the", "fourth", "one"), ("the", "last"),
             ("the", "last", "one"), ("a", "second"), ("a", "second", "one"), ("a", "third"), ("a", "third", "one"),
             ("yet", "another"), ("yet", "another", "one"), ("the", "other"), ("the", "other", "one"))  # fmt: skip
_ONE = (("one",), ("one", "of", "them"), ("one", "of", "these"), ("the", "first", "one"))
_THERE = frozenset({"on", "onto", "in", "into", "at", "goes", "is", "stands", "must", "should", "has", "lies", "shall",
                    "belongs", "to", "rests", "sits", "ends", "needs", "left", "right", "behind", "next"})  # fmt: skip
_AHEAD = frozenset({",", ":", ";", ".", "and", "put", "place", "so", "that", "want", "with", "move", "set", "bring",
                    "get", "lay", "while", "but", "then", "of", "have", "like", "need"})  # fmt: skip
_STOPS = frozenset({".", "!", "?"})


def one_another(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "One on the red mat, the second on the blue one": one on the red mat, one on the blue one."""
    begun = [n for n in range(len(words)) if _stands(words, n, _ONE) or words[n : n + 2] == ["one", "of"]]
    if not begun:
        return None
    found: list[tuple[int, int]] = []
    for at in range(begun[0] + 1, len(words)):
        if words[at] in _STOPS:
            break
        if long := _stands(words, at, _ONE_MORE):
            found.append((at, at + long))
    more = [words[begin:end] for begin, end in found]
    if not found or all("other" in said for said in more) or ("other" in more[0] and len(found) > 1):
        return None
    for begin, end in reversed(found):
        other = "other" in words[begin:end] or len(found) == 1
        said = [tokens[begin].saying(word) for word in (("the", "other") if other and len(found) == 1 else ("one",))]
        tokens = [*tokens[:begin], *said, *tokens[end:]]
    return tokens


def _stands(words: list[str], at: int, phrases: tuple[tuple[str, ...], ...]) -> int:
    """How many words of such a phrase stand there for a thing: something precedes it, and where it is follows."""
    long = length_at(words, at, phrases)
    ahead = at == 0 or words[at - 1] in _AHEAD
    return long if long and ahead and words[at + long : at + long + 1] and words[at + long] in _THERE else 0


CORNER = frozenset({"corner"})
_OWN_CORNER = (("a", "different", "corner"), ("another", "corner"), ("its", "own", "corner"),
               ("a", "separate", "corner"), ("a", "corner", "of", "its", "own"))  # fmt: skip
_STANDS = ((), ("is",), ("goes",), ("lies",), ("belongs",), ("must", "be"), ("should", "be"), ("has", "to", "be"),
           ("stands",), ("must", "go"), ("should", "go"), ("ends", "up"))  # fmt: skip
_EACH_STANDS = tuple(
    (each, *one, *them, *stands, into)
    for each in ("each", "every")
    for one in ((), ("one",))
    for them in ((), ("of", "them"))
    for stands in _STANDS
    for into in ("in", "into")
)
_CORNERS = 4


def one_in_each_corner(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(There are four white blocks.) Each goes in a corner of its own": one in each corner. With fewer of them, some
    corner would be empty."""
    for at in range(len(words) - 3):
        own = behind(words, at, _EACH_STANDS)
        end = behind(words, own, _OWN_CORNER) if own else 0
        if end and [token.many for token in tokens if token.many > 1] == [_CORNERS]:
            said = [tokens[own].saying(word) for word in ("each", "corner")]
            of = [token for token in tokens[at + 1 : own] if token.word != "one"]
            return [*tokens[:at], tokens[at].saying("one"), *of, *said, *tokens[end:]]
    return None


_OPPOSITE = {"left": "right", "right": "left", "near": "far", "far": "near", "front": "back", "back": "front",
             "top": "bottom", "bottom": "top"}  # fmt: skip
_HALF = frozenset({"half", "side"})


def other_half(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Red in the left half of the table and blue in the other (one)": in the right half."""
    named = [n for n in range(1, len(words)) if words[n] in _HALF and words[n - 1] in _OPPOSITE]
    first = named[0] if named else 0
    for at in range(first + 1, len(words) - 1) if first else ():
        if words[at : at + 2] != ["the", "other"] or words[at - 1] not in ("in", "into"):
            continue
        if len({words[n - 1] for n in named if n < at}) > 1:  # "each is in the other half": other than it was in
            continue
        end = at + 2 + (words[at + 2 : at + 3] in (["one"], ["half"], ["side"]))
        if end < len(words) and (words[end] not in (*_STOPS, ",", ";", "of") or words[end] in lexicon.BLOCK):
            continue
        half = [tokens[at].saying(word) for word in ("the", _OPPOSITE[words[first - 1]], words[first])]
        return [*tokens[:at], *half, *tokens[end:]]
    return None
