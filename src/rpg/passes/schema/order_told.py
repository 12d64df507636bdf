"""Lists behind "in order" that are in no order, "put the numbers in order: 3, 1, 2", and in two."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, takewhile

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_SHOWN = frozenset({"numbers", "digits", "letters", "number", "digit", "letter"})
_MARKS = frozenset({":", ","})


def check_order(words: list[Token]) -> None:
    """Refuse a list that could be the order itself, or what is to be put in the order that its symbols have.

    Raises:
        Refusal: "ambiguous", where the list is not in the order of the numbers or the alphabet.
    """
    for at in (n for n in range(2, len(words) - 3) if [w.word for w in words[n - 1 : n + 1]] == ["in", "order"]):
        shown = not _SHOWN.isdisjoint(word.word for word in words[max(0, at - 4) : at - 1])
        if not shown or words[at + 1].word not in _MARKS:
            continue
        listed = []
        for word in words[at + 2 :]:
            if word.kind == "number" or (len(word.word) == 1 and word.word.isalpha()):
                listed.append(word)
            elif word.word not in (",", "and"):
                break
        values = [word.many if word.kind == "number" else ord(word.word) for word in listed]
        rising = {one < other for one, other in pairwise(values)}
        if len(rising) > 1:
            raise refuse("ambiguous", "in the order of this list, or in that of these symbols?",
                         (listed[0].span[0], listed[-1].span[1]),
                         "say 'in this order', 'in alphabetical order' or 'in numerical order'")  # fmt: skip


_LINES = frozenset({"row", "line", "column", "tower", "stack"})
_LISTING = frozenset({",", "and", "then", "the", "a", "block", "cube"})
_SAID = frozenset({"order", "go", "goes", "read", "reads", "run", "runs", "left", "right", "top", "bottom"})
_BACKWARDS = ("right to left", "from the right", "top to bottom", "from the top", "top down", "back to front")
_LATER = frozenset({
    "start", "starts", "begin", "begins", "initially", "now", "currently", "was", "were", "finally", "end", "ends",
    "swap", "change", "rearrange", "reorder", "become", "becomes", "instead", "reverse", "reversed", "not", "or", "nor",
    "another", "other", "second", "descending", "decreasing",
})  # fmt: skip
"""With these a list may be of another line, or of the same at another time."""
_FEW = 6
List = tuple[list[str], int, int]
"""Names that are listed, and where the list begins and ends."""


def check_one_order(words: Sequence[Token]) -> None:
    """Refuse a second order of what was listed in one: "row: red, blue. The colours should go blue, red".

    Raises:
        Refusal: "order-conflict".
    """
    said = [token.word for token in words]
    if _LINES.isdisjoint(said) or _SAID.isdisjoint(said) or not _LATER.isdisjoint(said):
        return
    lists = list(_lists(words))
    for n, (names, begin, end) in enumerate(lists):
        colon = said[begin - 1 : begin] == [":"] and said[begin - 2] in _LINES
        behind = " ".join(takewhile(lambda word: word not in STOPS, said[end:]))
        if "alphabetical" in behind or "ascending" in behind or "numerical" in behind:
            names = sorted(names)
        elif not colon and "in this order" not in behind and "in that order" not in behind:
            continue
        names = names[::-1] if any(way in behind for way in _BACKWARDS) else names
        for others, at, last in lists[n + 1 :]:
            ahead = said[max(at - _FEW, end) : at]
            if sorted(names) != sorted(others) or _SAID.isdisjoint(ahead):
                continue
            back = any(way in " ".join((*ahead, ";", *said[last : last + _FEW])) for way in _BACKWARDS)
            if (others[::-1] if back else others) != names:
                raise refuse("order-conflict", "two orders are given for the same blocks",
                             (words[at].span[0], words[last - 1].span[1]), "keep one of them")  # fmt: skip


def _lists(words: Sequence[Token]) -> Iterator[List]:
    """The lists of two names or more."""
    names: list[str] = []
    begin = end = 0
    for n, token in enumerate((*words, None)):
        if token is not None and _is_name(token):
            begin = begin if names else n
            names, end = [*names, token.word], n + 1
        elif token is None or token.word not in _LISTING:
            if len(names) > 1:
                yield names, begin, end
            names = []


def _is_name(token: Token) -> bool:
    return token.word in lexicon.COLOR or token.kind == "number" or (len(token.raw) == 1 and token.raw.isupper())
