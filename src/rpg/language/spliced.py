"""Sentences that only a comma parts, or nothing: "four cubes in a row, three white and one red, red is second from the
left", "a tower of five blocks the top one is red and the rest are blue"; and those that are one: "red, then blue on the
mat. In that order"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import by_first, length_at
from rpg.language.tokens import Token

_AND = frozenset({"and", "but", "while", "whereas", "where"})
_BE = by_first(("is", "are", "comes", "stands", "goes", "sits", "must be", "should be", "has to be", "must come",
                "should come", "must stand", "should stand", "must go", "should go", "shall be", "is to be",
                "being", "lies"))  # fmt: skip
_ONE = frozenset({"one", "block", "cube", "brick", "box", "letter", "number", "digit", "ones", "blocks", "cubes"})
_PLACES = frozenset({"leftmost", "rightmost", "last", "topmost", "uppermost", "lowest", "highest", "closest",
                     "nearest", "farthest", "furthest", *lexicon.ORDINAL})  # fmt: skip
_AT = frozenset({"at", "on", "in"})
_ENDS = frozenset({"left", "right", "top", "bottom", "front", "back", "end", "beginning", "start", "very", "far",
                   "near", "middle", "center", "centre", "first", "second", "third", "last"})  # fmt: skip


def in_sentences(tokens: list[Token]) -> list[Token] | None:
    """The words with a full stop where behind a line of blocks it is said which one is at which place of it."""
    out: list[Token] = []
    lined = False
    n = 0
    while n < len(tokens):
        token = tokens[n]
        lined = lined or token.word in lexicon.STRUCTURE or token.word in ("stack", "stacked")
        if token.word == "," and lined:
            start = n + 1 + (n + 1 < len(tokens) and tokens[n + 1].word in _AND)
            if _tells_a_place(tokens, start):
                out.append(replace(token, word=".", raw="."))
                n = start
                continue
        out.append(token)
        n += 1
    return out if len(out) < len(tokens) or [t.word for t in out] != [t.word for t in tokens] else None


def _tells_a_place(tokens: list[Token], n: int) -> bool:
    """ "Red is the second from the left", "the blue one stands at the right end"."""
    words = [token.word for token in tokens[n : n + 12]] + [""] * 12
    at = 1 if words[0] == "the" else 0
    looks = words[at] in lexicon.COLOR or words[at] in lexicon.LETTER or (len(words[at]) == 1 and words[at].isalnum())
    if not looks:
        return False
    at += 1 + (words[at + 1] in _ONE)
    verb = max((length_at(words, at, found) for found in (_BE.get(words[at], ()),)), default=0)
    at += verb
    if not verb:
        return False
    at += words[at] == "the"
    if words[at] in _PLACES:
        return True
    at += words[at] in _AT
    at += words[at] == "the"
    return words[at - 1] in (*_AT, "the") and words[at] in _ENDS


_AFTERTHOUGHT = frozenset({"in", "from", "by", "all", "both", "with"})
_ORDERLY = frozenset({"gap", "gaps", *lexicon.STRUCTURE})
_SAID = frozenset({*lexicon.VERB, *lexicon.POSTURE, "is", "are", "be", "must", "should", "shall", "has", "have", "no",
                   "not", "goes", "go"}) - {"order", "line", "row", "stack", "lines"}  # fmt: skip
_STOPS = frozenset({".", "!", "?", ";"})


def stock_last(tokens: list[Token]) -> list[Token] | None:
    """The words with a full stop where only a comma parts what there is from what is asked: "..., there are three"."""
    words = [token.word for token in tokens]
    commas = [n for n in range(2, len(words) - 3) if words[n] == "," and length_at(words, n + 1, _THERE_IS)]
    last = commas[-1] if commas else 0
    return [*tokens[:last], tokens[last].saying("."), *tokens[last + 1 :]] if last else None


_THERE_IS = (("there", "are"), ("there", "is"), ("we", "have"), ("i", "have"), ("you", "have"))


def in_one_sentence(tokens: list[Token]) -> list[Token] | None:
    """The words with a comma where a sentence follows that has no verb, and only tells in which order or line."""
    words = [token.word for token in tokens]
    stops = [n for n, word in enumerate(words) if word in _STOPS]
    ends = zip(stops, [*stops, len(words)][1:], strict=True)
    thoughts = {n for n, end in ends if _only_orders(words[n + 1 : end])}
    comma = [replace(t, word=",", raw=",") if n in thoughts else t for n, t in enumerate(tokens)]
    return comma if thoughts else None


def _only_orders(words: list[str]) -> bool:
    """ "In that order", "all in one row", "from left to right"."""
    if not words or words[0] not in _AFTERTHOUGHT or not _SAID.isdisjoint(words):
        return False
    so = words[:3] in (["in", "that", "order"], ["in", "this", "order"])
    return so or not _ORDERLY.isdisjoint(words) or (words[0] == "from" and "to" in words)


_PARTS = frozenset({"top", "bottom", "middle", "center", "centre", "left", "right", "front", "back", "first", "last",
                    "second", "third", "upper", "lower", "lowest", "highest", "topmost", "uppermost", "leftmost",
                    "rightmost", "outer", "inner", "rest", "others", "other", "remaining", "bar", "crossbar", "stem",
                    "foot", "tip", "arms", "base", "corners", "sides", "border", "colors", "colours", "color",
                    "colour"})  # fmt: skip
"""What is told of in a sentence of its own behind that of a figure."""
_NAMED = frozenset({"row", "rows", "column", "columns", "layer", "layers", "two", "three", "four", *_ONE})
_TELLS = frozenset({"is", "are", "must", "should", "shall", "has", "have", "goes", "comes", "needs", "dont", "doesnt",
                    "don't", "doesn't", "do", "does"})  # fmt: skip
_ASIDE = (("i", "dont"), ("i", "don't"), ("i", "do", "not"), ("it", "doesnt"), ("it", "doesn't"), ("it", "does"),
          ("any", "color", "is"), ("any", "colour", "is"), ("any", "colors", "are"), ("any", "colours", "are"),
          ("colors", "dont"), ("colours", "dont"), ("colors", "do"), ("colours", "do"), ("they", "must"),
          ("they", "should"), ("they", "are"), ("they", "have"), ("there", "are"), ("there", "is"),
          ("all", "of", "them"), ("whatever", "color"), ("whatever", "colour"), ("no", "matter", "what"),
          ("no", "matter", "which"))  # fmt: skip
_ENDED = frozenset({"high", "tall", "wide", "long", "deep", "total", "them", "it", "please", "table", *_ONE,
                    *lexicon.BLOCK, *lexicon.PATCH, *lexicon.STRUCTURE, *lexicon.COLOR, *lexicon.COLOR_PLURAL,
                    *lexicon.NUMBER}) - {"a"}  # fmt: skip
"""What a sentence may end with that nothing parts from the next one."""


def run_together(tokens: list[Token]) -> list[Token] | None:
    """The words with a full stop where behind a figure, with nothing between, another sentence begins that tells of a
    part of it, of how many blocks there are, or that something is left open. "It" behind that could be that part."""
    out: list[Token] = []
    figure = False
    for n, token in enumerate(tokens):
        figure = figure or token.word in lexicon.STRUCTURE or token.word in ("stack", "spell", "letter")
        ended = figure and n > 0 and (tokens[n - 1].word in _ENDED or tokens[n - 1].kind == "number")
        if ended and _begins(tokens, n) and all(later.word != "it" for later in tokens[n + 1 :]):
            out.append(replace(token, kind="punct", word=".", raw=".", value=None))
        out.append(token)
    return out if len(out) > len(tokens) else None


def ordered_behind(tokens: list[Token]) -> list[Token] | None:
    """The words with a full stop where behind what there is, with no more than a comma between, an order begins that is
    about it: "there is a tower of red on blue take it apart"."""
    if not length_at([token.word for token in tokens[:2]], 0, _THERE_IS):
        return None
    for n in range(3, len(tokens) - 1):
        comma = tokens[n - 1].word == ","
        ordered = tokens[n].word in lexicon.COMMANDS and tokens[n + 1].word in _THEM
        if ordered and tokens[n - 1 - comma].word in _ENDED:
            return [*tokens[: n - comma], tokens[n].saying("."), *tokens[n:]]
    return None


_THEM = frozenset({"it", "them", "both", "everything"})


def _begins(tokens: list[Token], n: int) -> bool:
    """ "The top one has to be red", "i do not care which", "there are four in total"."""
    words = [token.word for token in tokens[n : n + 6]]
    if length_at(words, 0, _ASIDE):
        return True
    at = 2 if words[0] == "the" and words[1:2] and words[1] in _PARTS else 0
    while at and words[at : at + 1] and words[at] in _NAMED:
        at += 1
    return bool(at) and words[at : at + 1] != [] and words[at] in _TELLS
