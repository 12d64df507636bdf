"""Marks inside of lists: "the letters A; B and C" is one list, as is "two red, and three blue cubes"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_LISTED = frozenset({"blocks", "cubes", "letters", "digits", "numbers", "ones", ":"})
_STOPS = frozenset({".", ";", "!", "?"})
_ON = frozenset({"on", "onto", "behind", "under", "beside", "below", "above", "near", "to", "than", "touches"})
"""What stands before a place: "on two red, and three blue ones go ..."."""


def lists_in_one(tokens: list[Token]) -> list[Token]:
    """The tokens with a comma for each semicolon or slash inside a list, and none before the "and" of two counted
    colours."""
    tokens = _slashes(tokens)
    out = list(tokens)
    for n, token in enumerate(tokens):
        if token.word == ";" and token.raw.strip() == ";" and (_goes_on(tokens, n) or _of_groups(tokens, n)):
            out[n] = replace(token, word=",", raw=",")
    return _digits([token for n, token in enumerate(out) if not _before_and(out, n)])


def _slashes(tokens: list[Token]) -> list[Token]:
    """ "In a row: white/black/white/black": a list, where its items are single looks and nothing else parts them."""
    out = list(tokens)
    for colon in (n for n, token in enumerate(tokens) if token.word == ":"):
        if not _FIGURES.isdisjoint(token.word for token in tokens[:colon]):
            continue
        slashes, (kind, end) = [], _item(tokens, colon + 1)
        while end < len(tokens) and tokens[end].word == "/" and _item(tokens, end + 1)[0] == kind:
            slashes.append(end)
            end = _item(tokens, end + 1)[1]
        if kind and len(slashes) > 1 and (end == len(tokens) or tokens[end].word in _STOPS):
            for n in slashes:
                out[n] = replace(tokens[n], word=",", raw=",")
    return out


_FIGURES = frozenset({"grid", "rows", "columns", "matrix", "wall", "table", "layers", "towers", "stacks"})
"""Of these a slash may part the lines."""
_GROUPS = frozenset({"groups", "clusters", "bunches", "piles", "heaps", "clumps"})
_LOTS = frozenset({"letters", "digits", "numbers", "the", "and", ",", ";", "plain", "cube", *lexicon.BLOCK})


def _of_groups(tokens: list[Token], n: int) -> bool:
    """Whether the semicolon stands between groups that are listed: "three groups: the letters A, B; two red cubes"."""
    colon = next((k for k in range(n - 1, 0, -1) if tokens[k].word == ":"), 0)
    if not colon or tokens[colon - 1].word not in _GROUPS:
        return False
    end = next((k for k in range(n, len(tokens)) if tokens[k].word in _STOPS - {";"}), len(tokens))
    return all(token.word in _LOTS or _counts(token) or _item(tokens, k)[0]
               for k, token in enumerate(tokens[colon + 1 : end], colon + 1))  # fmt: skip


_DONE = frozenset({"stack", "pile", "up", "put", "place", "arrange", "sort", "order"})
_BEYOND = frozenset({"from", "in", "so", "with", "on"})
_FEW = 3
_LINES = frozenset(word for word, (_, several) in lexicon.STRUCTURE.items() if several)


def _digits(tokens: list[Token]) -> list[Token]:
    """ "Stack one, two and three": the digits, where no word says of what so many are meant."""
    out, at = list(tokens), 1
    while at < len(tokens):
        items, end = [], at
        while end < len(tokens) and (_counts(tokens[end]) or tokens[end].word == "one"):
            items.append(end)
            end += 1
            while end < len(tokens) and tokens[end].word in (",", "and"):
                end += 1
        closed = end >= len(tokens) or tokens[end].word in _STOPS or tokens[end].word in _BEYOND
        if len(items) >= _FEW and closed and tokens[at - 1].word in (_DONE | _LISTED) - {":"}:
            for n in items:
                value = lexicon.NUMBER.get(tokens[n].word)
                if value is not None:
                    out[n] = replace(tokens[n], kind="number", word=str(value), raw=str(value), value=float(value))
        at = max(end, at + 1)
    return out


def _goes_on(tokens: list[Token], n: int) -> bool:
    """Whether what stands before and behind the semicolon at `n` are items of one list, such as "1; 2 and 3"."""
    kind, begin = _ending(tokens, n)
    while begin > 1 and tokens[begin - 1].word in (",", ";") and _ending(tokens, begin - 1)[0] == kind:
        begin = _ending(tokens, begin - 1)[1]
    if not kind or not (begin and tokens[begin - 1].word in _LISTED):
        return False
    at = n
    while at < len(tokens) and tokens[at].word in (";", ",", "and") and not _asked(tokens, at + 1):
        at += 1 + (tokens[at].word == "," and tokens[at + 1 : at + 2] != [] and tokens[at + 1].word == "and")
        found, at = _item(tokens, at)
        if found != kind:
            return False
    if any(t.word == "," for t in tokens[begin:at]) and any(t.word in _LINES for t in tokens[:begin]):
        return False  # "two towers: red, blue; blue, red" tells one after the other
    named = tokens[begin - 1].word != ":"
    at += at < len(tokens) and tokens[at].word == "," and _asked(tokens, at + 1)
    return (
        at >= len(tokens) or tokens[at].word in _STOPS or _asked(tokens, at) or (named and tokens[at].word in _BEHIND)
    )


def _asked(tokens: list[Token], at: int) -> bool:
    """Whether nothing but a polite word stands from there to the end of the sentence."""
    polite = at < len(tokens) and tokens[at].word in _POLITE
    return polite and (at + 1 == len(tokens) or tokens[at + 1].word in _STOPS)


_POLITE = frozenset({"please", "pls", "plz", "thanks", "thx", "cheers"})
_BEHIND = frozenset({":", "with", "in", "from", "so"})
"""What may follow a list of things that were called blocks or letters before it."""


def _ending(tokens: list[Token], end: int) -> tuple[str, int]:
    """The kind of the item that ends at `end`, and where it begins."""
    for begin in (end - 2, end - 1):
        if begin >= 0 and (found := _item(tokens, begin))[1] == end and found[0]:
            return found[0], begin
    return "", end


def _item(tokens: list[Token], at: int) -> tuple[str, int]:
    """ "A", "3", "red" or "2 red": its kind, and where it ends."""
    here, after = (tokens[k] if k < len(tokens) else None for k in (at, at + 1))
    if here is None:
        return "", at
    if _counts(here) and after is not None and after.word in lexicon.COLOR:
        return "so many of a color", at + 2
    if here.word in lexicon.COLOR:
        return "color", at + 1
    if here.kind == "number" or (here.kind == "word" and len(here.raw) == 1 and here.raw.isupper()):
        return "symbol", at + 1
    return "", at


def _counts(token: Token) -> bool:
    return token.kind == "number" or (token.word in lexicon.NUMBER and token.word != "one")


def _before_and(tokens: list[Token], n: int) -> bool:
    """Is this the comma of "two red, and three blue cubes"? What follows has the noun of both."""
    if tokens[n].word != "," or n < 2 or n + 3 >= len(tokens) or tokens[n + 1].word != "and":
        return False
    counted = _counts(tokens[n - 2]) and tokens[n - 1].word in lexicon.COLOR
    more = n + 2 + (tokens[n + 2].word == "the")
    kind, _ = _item(tokens, more)
    return counted and kind == "so many of a color" and (n < 3 or tokens[n - 3].word not in _ON)
