"""Shares of a number that was told: "five blocks, two of them red and the rest blue", "half red, half blue".

Arithmetic says how many the rest are, so that they are read like any other number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import by_first
from rpg.language.tokens import Token

_REST = by_first(
    tuple(
        f"{the}{rest}"
        for the in ("the ", "all the ", "all ")
        for rest in ("rest of them", "rest of the blocks", "rest of the cubes", "rest", "others", "other ones",
                     "remaining ones", "remainder", "remaining blocks", "remaining cubes", "other blocks",
                     "other cubes")
        if not (the == "all " and rest.startswith("rem"))
    )
)  # fmt: skip
_BEGUN = frozenset({"the", *_REST})
_HALF = by_first(
    tuple(
        f"{one}half{of}"
        for one in ("", "one ", "the other ", "exactly ")
        for of in ("", " of them", " of these", " of those", " of which")
    )
)
_ARE = frozenset({"are", "is", "be", "being", "should", "must", "shall", "will", "all", "in", "have", "has", "to"})
_OF_THEM = frozenset({"of", "them", "these", "those", "which", "the", "blocks", "cubes", "bricks", "ones", "one",
                      "block", "cube"})  # fmt: skip
_BETWEEN = frozenset({",", ";", ":", "(", ".", "-", "and", "but", "while", "whereas", "with", "where", "also"})
_THERE = by_first(("in the row", "in a row", "in the tower", "in the line", "in a line", "in a tower", "on the table",
                   "in total", "in all", "in it", "in the stack", "altogether", "here", "in the scene",
                   "lying around"))  # fmt: skip
_SIDES = frozenset({"left", "right", "top", "bottom", "upper", "lower", "near", "far", "the", "first", "second",
                    "front", "back", "one", "each", "other"})  # fmt: skip


def reckoned(tokens: list[Token]) -> list[Token]:
    """The tokens with such shares as numbers."""
    words = [token.word for token in tokens]
    if "half" in words:
        tokens = _halved(tokens)
        words = [token.word for token in tokens]
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        end = (_phrase(words, at, _REST) or _so_many_others(tokens, at)) if words[at] in _BEGUN else 0
        many = _left(out) if end and _colored(words, end) else 0
        if many > 0 and all(_value(token) in (0, many) for token in tokens[at:end]):
            if out[-1].word == ".":
                out[-1] = replace(out[-1], word=",", raw=",")
            out += [replace(tokens[at], word="and", raw="and")] if out[-1].word == "," else []
            out.append(_number(many, tokens[at:end]))
            at = end
        else:
            out.append(tokens[at])
            at += 1
    return out


def _so_many_others(tokens: Sequence[Token], at: int) -> int:
    """The position after "the other two (blocks)", or 0."""
    words = [token.word for token in tokens[at : at + 4]]
    if words[:2] not in (["the", "other"], ["the", "remaining"]) or len(words) < 4 or not _value(tokens[at + 2]):
        return 0
    return at + 3 + (words[3] in lexicon.BLOCK or words[3] == "ones")


def _halved(tokens: list[Token]) -> list[Token]:
    """ "half of the eight blocks are red and half are blue": four and four."""
    words = [token.word for token in tokens]
    halves = [n for n, word in enumerate(words) if word == "half"]
    totals = {many for n in range(len(words)) if (many := _total(tokens, n))}
    if len(halves) != 2 or len(totals) != 1 or min(totals) % 2:
        return tokens
    out: list[Token] = []
    at = told = 0
    while at < len(tokens):
        end = _phrase(words, at, _HALF)
        if end and "half" in words[at:end] and not (words[at] == "half" and at and words[at - 1] in _SIDES):
            after = end
            if words[end : end + 2] == ["of", "the"] and _total(tokens, end + 2):
                after = end + 4
            if _colored(words, after):
                out.append(_number(min(totals) // 2, tokens[at:end]))
                at, told = end, told + 1
                if words[end - 1] in ("them", "these", "those", "which"):
                    out += tokens[end - 2 : end]
                continue
        out.append(tokens[at])
        at += 1
    return out if told == 2 else tokens


def _phrase(words: Sequence[str], at: int, phrases: dict[str, list[tuple[str, ...]]]) -> int:
    """The position after the longest of these phrases that stands here, or 0."""
    found = [x for x in phrases.get(words[at], ()) if tuple(words[at : at + len(x)]) == x]
    return at + len(max(found, key=len)) if found else 0


def _colored(words: Sequence[str], at: int) -> bool:
    """Whether a colour follows, and nothing between but that these are so; it describes no noun of its own."""
    while at < len(words) and words[at] in _ARE:
        at += 1
    return at < len(words) and words[at] in lexicon.COLOR


def _number(many: int, said: Sequence[Token]) -> Token:
    return Token("number", str(many), str(many), (said[0].span[0], said[-1].span[1]), float(many))


def _value(token: Token) -> int:
    """A whole number, also "a"; 0 for anything else."""
    return token.many or int(token.kind == "word" and token.word in ("a", "an"))


def _total(tokens: Sequence[Token], at: int) -> int:
    """The number at a place, if it is one of blocks of which it says no more: "five blocks", "a tower of five"."""
    many = _value(tokens[at]) if tokens[at].word not in ("a", "an", "one") else 0
    after = tokens[at + 1].word if at + 1 < len(tokens) else ""
    built = at > 1 and tokens[at - 1].word == "of" and tokens[at - 2].word in lexicon.STRUCTURE
    return many if many and (lexicon.BLOCK.get(after) or (built and after not in lexicon.COLOR)) else 0


def _left(tokens: Sequence[Token]) -> int:
    """How many are left of the blocks counted last, when those told apart since then are taken away; 0: not clear."""
    for start in range(len(tokens) - 1, -1, -1):
        if many := _total(tokens, start):
            some = start > 2 and [t.word for t in tokens[start - 2 : start]] in (["of", "the"], ["of", "these"])
            told = _told(tokens, start + 1, _value(tokens[start - 3]) if some else 0)
            return many - told if told else 0
    return 0


def _told(tokens: Sequence[Token], at: int, first: int) -> int:
    """How many blocks are told apart by their colours, where nothing else is said; 0: something is. `first`: so many
    "of the five blocks", of which the colour follows."""
    words = [token.word for token in tokens]
    at += words[at] in lexicon.BLOCK if at < len(words) else 0
    told = first
    if first:
        while at < len(words) and words[at] in _ARE:
            at += 1
        at += 1
        if words[at - 1 : at] == [] or words[at - 1] not in lexicon.COLOR:
            return 0
    while at < len(words):
        if words[at] in _BETWEEN or (words[at] == "of" and words[at + 1 : at + 2] == ["which"]):
            at += 1 + (words[at] == "of")
            continue
        if end := _phrase(words, at, _THERE):
            at = end
            continue
        many = _value(tokens[at])
        at += 1
        while many and at < len(words) and (words[at] in _OF_THEM or words[at] in _ARE):
            at += 1
        if not many or at >= len(words) or words[at] not in lexicon.COLOR:
            return 0
        told += many
        at += 1
        at += at < len(words) and (words[at] in lexicon.BLOCK or words[at] in ("one", "ones"))
    return told
