"""What stands in brackets within a sentence, and whether it can be read as set off by commas."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_OPENING, _CLOSING = frozenset({"(", "["}), frozenset({")", "]"})
_BEGINS = frozenset({"starts", "start", "begins", "begin", "initially"})
_TELLING = frozenset({"the", "which", "that", "not", "it", "this", "whose", "where", "i", "or"})
_PLACES = frozenset({
    "on", "in", "at", "to", "left", "right", "middle", "center", "front", "back", "next", "beside", "behind", "between",
    "above", "below", "under", "near", "touching",
})  # fmt: skip
"""What a place begins with."""


def adds(tokens: list[Token]) -> bool:
    """Whether there are brackets, and what they hold adds something instead of telling which thing is meant."""
    inside = [
        "" if _of_it([t.word for t in tokens[n + 1 : n + 4]]) else tokens[n + 1].word
        for n, t in enumerate(tokens[:-1])
        if t.word in _OPENING
    ]
    begins = any(token.word in _BEGINS for token in tokens)
    telling = not begins and any(word in _TELLING for word in inside)
    return bool(inside) and not telling and not _of_one_listed(tokens)


def _of_one_listed(tokens: list[Token]) -> bool:
    """ "A red block, a blue block (on the mat) and a green one": without brackets that would be said of all of them."""
    items: list[tuple[bool, bool]] = []  # whether a thing has a place in brackets, and whether it has one outside
    depth, told, placed = 0, False, False
    for n, (token, after) in enumerate(zip(tokens, (*tokens[1:], None), strict=True)):
        opened = token.word in _OPENING
        depth += opened - (token.word in _CLOSING)
        told = told or (opened and after is not None and after.word in _PLACES and not _way(tokens, n + 1))
        placed = placed or (depth == 0 and token.word in _PLACES)
        if depth == 0 and (after is None or token.word in (",", "and")):
            items, told, placed = [*items, (told, placed)], False, False
    of_all = tokens[0].word in lexicon.COMMANDS  # "stack red, blue and green (on the mat)"
    return (True, False) in (items[:-1] if of_all else items) and (False, False) in items


def _way(tokens: list[Token], at: int) -> bool:
    """ "(left to right)": how a list goes, and no place."""
    return [token.word for token in tokens[at + 1 : at + 2]] == ["to"]


def _of_it(words: list[str]) -> bool:
    """ "(it is a distractor)", "(I have two)": said of what comes before, not telling which thing is meant."""
    return (words[:2] == ["it", "is"] and words[2:] != ["the"]) or words[:2] in (["i", "have"], ["i", "got"])


def unbracketed(tokens: list[Token]) -> list[Token]:
    """What stands in brackets, set off by commas."""
    out: list[Token] = []
    for index, token in enumerate(tokens):
        after = tokens[index + 1].word if index + 1 < len(tokens) else ","
        if token.word not in _OPENING | _CLOSING:
            out.append(token)
        elif out and out[-1].word not in (",", ":") and after not in (",", ":"):
            listed = [t.word if t.kind != "number" else "" for t in tokens[index + 1 : index + 3]] == ["", ","]
            mark = ":" if listed else ","
            out.append(replace(token, kind="punct", word=mark, raw=mark))
    return out
