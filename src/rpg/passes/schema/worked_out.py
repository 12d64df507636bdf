"""Numbers and letters that are said for something else to be worked out from: of them nothing has to be in the task,
but of what comes of them."""

from __future__ import annotations

import string
from collections.abc import Collection, Sequence

from rpg.language import lexicon
from rpg.language.grammar.structures.equations import NAMED, value_of
from rpg.language.tokens import Token

_THAN = frozenset({"greater", "larger", "bigger", "higher", "more", "smaller", "lower", "less", "fewer", "littler",
                   "largest", "biggest", "greatest", "highest", "smallest", "lowest"})  # fmt: skip
_OR = frozenset({*_THAN, "up", "upwards"})
_BY = (["divisible", "by"], ["multiples", "of"], ["multiple", "of"])
_SIGNS = {"+": "+", "-": "-", "–": "-", "−": "-", "*": "*", "/": "/", "plus": "+", "minus": "-", "times": "*", "x": "*"}


def worked_out(words: Sequence[Token], index: int, shown: Collection[str]) -> bool:
    """Whether what stands there is said for a symbol that the cubes show."""
    if words[index].word == "alphabet":
        return _by_place(words, index, shown)
    if _in_the_row(words, index):
        return True
    digits = any(symbol.isdigit() for symbol in shown)
    return digits and (_compared(words, index) or _calculated(words, index, shown))


def _compared(words: Sequence[Token], index: int) -> bool:
    """ "(the digits) greater than 4", "5 or more", "divisible by 3"."""
    before = [token.word for token in words[max(index - 2, 0) : index]]
    after = [token.word for token in words[index + 1 : index + 3]]
    than = before[1:] == ["than"] and before[0] in _THAN
    return than or before in _BY or (after[:1] in (["or"], ["and"]) and not _OR.isdisjoint(after[1:]))


def _in_the_row(words: Sequence[Token], index: int) -> bool:
    """ "(The digits) below 5", "(the letters) after M"."""
    before = [token.word for token in words[max(index - 3, 0) : index]]
    return before[-1:] != [] and before[-1] in _BEYOND and not _SYMBOLS.isdisjoint(before)


_BEYOND = frozenset({"below", "under", "above", "over", "after", "before"})
_SYMBOLS = frozenset({"digits", "numbers", "letters", "come", "coming"})


def _calculated(words: Sequence[Token], index: int, shown: Collection[str]) -> bool:
    """ "(the answer to) 2 + 3": its result is there."""
    begin = end = index
    while begin > 1 and _sign(words[begin - 1]) and _number(words[begin - 2]) is not None:
        begin -= 2
    while end + 2 < len(words) and _sign(words[end + 1]) and _number(words[end + 2]) is not None:
        end += 2
    side = "".join(_sign(token) or str(_number(token)) for token in words[begin : end + 1])
    side = side if end > begin else _named(words, index)
    result = value_of(side) if side else None
    return result is not None and str(result) in shown


def _named(words: Sequence[Token], index: int) -> str:
    """ "The sum of 2 and 3": what is to be calculated there."""
    for at in (index - 2, index - 4):
        said = words[at : at + 5] if at >= 0 else ()
        if [token.word for token in said[1::2]] in (["of", "and"], ["between", "and"]) and said[0].word in NAMED:
            one, two = _number(said[2]), _number(said[4])
            return f"{one}{NAMED[said[0].word]}{two}" if one is not None and two is not None else ""
    return ""


def _by_place(words: Sequence[Token], index: int, shown: Collection[str]) -> bool:
    """ "The last letter of the alphabet", "the first three letters of the alphabet": the one at that end is there."""
    for token in words[max(index - 5, 0) : index]:
        rank = lexicon.ORDINAL.get(token.word, 0)
        if token.word == "last" or rank:
            letter = string.ascii_uppercase[rank - 1 : rank or None]
            return letter in shown
    return False


def _number(token: Token) -> int | None:
    if token.kind == "number":
        return int(token.word) if token.word.isdigit() else None
    return lexicon.NUMBER.get(token.word)


def _sign(token: Token) -> str:
    """The sign of a calculation; between spaces a minus may have been taken for a dash."""
    return _SIGNS.get(token.word) or _SIGNS.get(token.raw, "")


def asked_for(words: Sequence[Token], one: Token) -> bool:
    """ "Which number is bigger, 3 or 7?": where something stands in a question about numbers that is answered."""
    begin = max((n + 1 for n, x in enumerate(words) if x.word in _ENDS and x.span < one.span), default=0)
    end = next((n for n, x in enumerate(words) if x.word == "?" and x.span > one.span), begin)
    asked = [token.word for token in words[begin:end]]
    return asked[:1] in (["which"], ["what"]) and not _THAN.isdisjoint(asked) and any(word.isdigit() for word in asked)


_ENDS = frozenset({".", "!", "?", ";"})
