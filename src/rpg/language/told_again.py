"""Whether what a title names is told again behind it: "variant with letter cubes: first stack A on B", "two teams of
three: three white blocks in one row, three black blocks in another row". Nothing of the task is lost with it then."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_Shows = Callable[[Token], bool]
_GAPS = listed("gap gaps space spaces spacing distance distances")
_UNITS = lexicon.UNIT.keys() - {"in", "m"}
_KINDS: tuple[tuple[frozenset[str], _Shows], ...] = (
    (listed("size sizes"), lambda token: token.word in lexicon.SIZE or token.word in _UNITS),
    (listed("color colors"), lambda token: token.word in lexicon.COLOR),
    (_GAPS, lambda token: token.word in _GAPS | _UNITS or token.word == "apart"),
    (frozenset(lexicon.LETTER), lambda token: len(token.raw) == 1 and token.raw.isupper()),
    (frozenset(lexicon.DIGIT), lambda token: token.kind == "number"),
    (frozenset(lexicon.BLOCK), lambda token: True),
    (frozenset(lexicon.PATCH), lambda token: token.word in lexicon.PATCH),
)
"""Words for a kind of things or looks, and what is of that kind; blocks are what all of it is about."""
CHANGES = ("revers", "mirror", "rotat", "swap", "flip", "unstack", "remov", "dismantl", "disassembl")
_ORDERS = ("sort", "group", "separat", "order", "altern", "symmetr", *CHANGES)
"""How words begin by which the blocks of a figure are ordered, or changed."""
_BEGUN = listed("start initial starts starting begin begins beginning initially first now currently")
_IN_ORDER = _BEGUN | listed(
    "from biggest largest smallest bigger smaller ascending descending increasing decreasing alphabetical "
    "alphabetically top bottom"
)


def told_again(words: Sequence[str], n: int, behind: Sequence[Token]) -> bool:
    """Whether what one of the words of a title tells is told behind it as well."""
    word = words[n]
    if (many := lexicon.NUMBER.get(word, 0)) > 1:
        return _figures(behind) == many if n == 0 else any(token.many == many for token in behind)
    begun = _BEGUN if word.startswith(CHANGES) else ()
    return any(_the_same(word, token) or token.word in begun for token in behind)


def ordered_again(words: Sequence[str], behind: Sequence[Token]) -> bool:
    """Whether no title says in what order the blocks of a figure are that is told without one: "color sorting: (two
    red and two blue blocks in a row)"."""
    if not any(token.word in lexicon.STRUCTURE for token in behind):
        return True
    ordered = not _IN_ORDER.isdisjoint(token.word for token in behind)
    return all(
        told_again(words, n, behind) or (ordered and not word.startswith(CHANGES))
        for n, word in enumerate(words)
        if word.startswith(_ORDERS)
    )


def _the_same(word: str, token: Token) -> bool:
    for table in (lexicon.COLOR, lexicon.SIZE):
        if word in table:
            return table.get(token.word) == table[word]
    if word in lexicon.STRUCTURE:
        return _figure(word) == _figure(token.word)
    return (
        word == token.word
        or any(word in kind and shown(token) for kind, shown in _KINDS)
        or any(word.startswith(stem) and token.word.startswith(stem) for stem in (*_ORDERS, "distract"))
        or (word.startswith(("sort", "group")) and token.word.startswith(("sort", "group", "separat")))
    )


def _figure(word: str) -> str:
    """Which figure a word names; a line is a row as well."""
    return _LINED.get(kind := lexicon.STRUCTURE.get(word, ("", False))[0], kind)


_LINED = {"line": "row"}


def _figures(behind: Sequence[Token]) -> int:
    """How many figures are told: "three towers", "a row of ... and a row of ...", "one of ... and one of ..."."""
    counted = next((one.many for one, other in pairwise(behind) if one.many > 1 and other.word in _SEVERAL), 0)
    named = sum(lexicon.STRUCTURE.get(token.word, ("", True))[1] is False for token in behind)
    return counted or named or sum(one.word == "one" and other.word == "of" for one, other in pairwise(behind))


_SEVERAL = frozenset(word for word, (_, many) in lexicon.STRUCTURE.items() if many)


def so_many(many: int, behind: Sequence[Token]) -> bool:
    """Whether so many blocks are told of: by a number, or one by one by their colors or symbols."""
    colors = {lexicon.COLOR[token.word] for token in behind if token.word in lexicon.COLOR}
    symbols = {token.raw for token in behind if len(token.raw) == 1 and token.raw.isupper()}
    return many in (len(colors), len(symbols)) or any(token.many == many for token in behind)
