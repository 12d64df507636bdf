"""As people type in a hurry and talk into a microphone: "u shud put it on the blue 1", "like five centimeters".

A letter or a digit that is typed for a word may be one that is on a block: it is a word only where a word must stand.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.harmless import exclaimed
from rpg.language.spelling import vocabulary
from rpg.language.tokens import Token

_TYPED = {
    "shld": "should", "shud": "should", "shd": "should", "wud": "would", "wld": "would",
    "cud": "could", "cld": "could", "ya": "you", "yall": "you", "da": "the", "de": "the", "dis": "this", "dat": "that",
    "dem": "them", "cuz": "because", "bcs": "because", "bcuz": "because", "nxt": "next", "bhnd": "behind",
    "sry": "sorry", "tho": "though", "frm": "from", "ther": "there", "evry": "every", "othr": "other",
    "wth": "with", "lil": "little", "smth": "something", "blu": "blue", "abv": "above", "blw": "below", "hv": "have",
    "nd": "and", "tht": "that", "ths": "this", "th": "the", "frnt": "front", "kk": "okay",
}  # fmt: skip
"""Words without some of their letters."""
_ENDS = frozenset({"left", "right", "front", "back", "top", "bottom", "near", "far"})
_ASIDE = [["the", side, "of"] for side in ("left", "right")]
"""Between two ends, and before such words, "2" is "to"."""
_TOLD_BY = frozenset({"one", "ones", *lexicon.BLOCK})
"""Before these "blk" is a colour."""
_HURRIED = frozenset({*_TYPED, "u", "ur", "r", "pls", "plz", "thx", "ty", "gimme", "lemme", "lol", "dont", "gonna",
                      "em", "wanna", "cant", "idk"})  # fmt: skip
"""Who types these types "1" for "one" as well."""
_GLUED = {("b", "4"): "before", ("2", "gether"): "together", ("m", "8"): "mate", ("2", "day"): "today"}
_MODALS = frozenset({"should", "must", "shall", "will", "can", "could", "would", "may", "to", "not"})
_TO_BE = frozenset({"be", "go", "stand", "sit", "lie", "see", "have", "rest"})
_SPOKEN_TO = frozenset({"u", "you", "they", "we"})
_ASKING = frozenset({"can", "could", "would", "will", "do", "if", "when", "thank", "are", "r", "before", "after"})
_PLACES = frozenset({"on", "onto", "in", "into", "behind", "next", "beside", "under", "above", "below", "near",
                     "between", "left", "right", "around", "against", "at"})  # fmt: skip
_BEING = _PLACES | lexicon.COLOR.keys() | {"the", "a", "placed", "put", "stacked", "touching", "sorted", "lined"}
_SEEN = lexicon.NUMBER.keys() | {"a", "an", "the"}
"""Behind these letters they are "be" and "see"."""
_TOLD = lexicon.BLOCK.keys() | lexicon.PATCH.keys() | {"one", "it", "them", "be", "is", "and", "then", "um", "uh"}
"""Behind these "like" may be a filler."""
_COUNTED = frozenset({*lexicon.COLOR, *lexicon.BLOCK})
_MARKS = frozenset({"u", "n", "b", "c", "k", "r", "1", "2", "like", "kind", "sort", "mean", "bit", "blk", "pcs", "pc",
                    "ltr", *_TYPED, *(word for pair in _GLUED for word in pair)})  # fmt: skip


def as_typed(tokens: list[Token]) -> list[Token]:
    """The tokens with the words that are meant."""
    tokens = [_drawn_out(token) for token in tokens]
    while tokens[-1:] and tokens[-1].word == "…":
        tokens.pop()
    words = [token.word for token in tokens]
    if _MARKS.isdisjoint(words):
        return tokens
    hurried = any(token.raw.lower() in _HURRIED for token in tokens)
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        said, end = next(_meant(tokens, words, at, hurried), ([words[at]], at))
        out += [tokens[at].saying(word) for word in said] if end > at else [tokens[at]]
        at = max(end, at + 1)
    return out


def _drawn_out(token: Token) -> Token:
    """ "Pleeeease", "aaaand", "reeed": the word that is drawn out; in capitals it shows what it says."""
    if token.kind != "word" or _LONG.search(token.word) is None or token.raw.isupper() or exclaimed(token.word):
        return token
    short = (_LONG.sub(r"\1" * many, token.word) for many in (1, 2))
    return next((token.saying(word) for word in short if len(word) > 1 and word in vocabulary()), token)


_LONG = re.compile(r"([a-z])\1\1+")


def _meant(tokens: list[Token], words: list[str], at: int, hurried: bool) -> Iterator[tuple[list[str], int]]:
    """What is meant by what stands here, and the position behind it."""
    token, before, behind = tokens[at], words[at - 1] if at else "", words[at + 1] if at + 1 < len(words) else ""
    small = token.raw == token.raw.lower()
    glued = at + 1 < len(tokens) and token.span[1] == tokens[at + 1].span[0]
    if glued and small and (word := _GLUED.get((words[at], behind))) and before not in lexicon.BLOCK:
        yield [word], at + 2
    elif small and token.word in _TYPED:
        yield [_TYPED[token.word]], at + 1
    elif token.word == "1" and hurried and before in lexicon.COLOR and behind not in lexicon.BLOCK:
        yield ["one"], at + 1
    elif token.word == "blk":
        yield ["black" if behind in _TOLD_BY and before not in lexicon.COLOR else "block"], at + 1
    elif token.word == "ltr":
        yield ["from", "left", "to", "right"], at + 1
    elif token.word == "pcs" and words[at + 1 : at + 3] == [".", ")"]:
        yield ["blocks"], at + 2
    elif token.word in ("pcs", "pc") and at and tokens[at - 1].kind == "number" and behind in _COUNTED:
        yield [], at + 1
    elif token.word == "2" and _from_end_to_end(words, at):
        yield ["to"], at + 1
    elif token.word == "2":
        beside = before in ("next", "nxt", "close") and words[at - 2 : at - 1] != ["the"]
        counted = any(lexicon.BLOCK.get(word) for word in words[at + 1 : at + 4])
        bound = before in ("need", "needs", "has", "have", "wants", "want", "got", "going", "able", "ought")
        if (beside and not counted) or (bound and (behind in _TO_BE or behind in lexicon.COMMANDS or behind == "b")):
            yield ["to"], at + 1
    elif words[at] == "u" and small and behind in _MODALS and words[at + 2 : at + 3] != [] and _done(words[at + 2]):
        yield ["you"], at + 1
    elif small and len(token.raw) == 1 and (meant := _letter(token.word, before, behind, words[:at])) is not None:
        yield meant, at + 1
    else:
        yield from _filling(tokens, words, at)


def _from_end_to_end(words: list[str], at: int) -> bool:
    """ "left 2 right", "2 the left of", and no "one left, 2 right of it"."""
    before, behind, then = (words[n] if 0 <= n < len(words) else "" for n in (at - 1, at + 1, at + 2))
    ahead = words[max(at - 4, 0) : max(at - 1, 0)]
    told = (then, *ahead) if "of" not in ahead else (then,)
    counted = then == "of" or any(word.isdigit() or word in lexicon.NUMBER for word in told)
    return words[at + 1 : at + 4] in _ASIDE or (before in _ENDS and behind in _ENDS and not counted)


def _done(word: str) -> bool:
    """Whether it is something that only somebody does: a block may stand and lie as well."""
    return word in lexicon.COMMANDS and word not in lexicon.POSTURE


_NOUNS = frozenset({"stack", "line", "row", "group", "order", "shape", "form"})
"""Commands that are called so as well, of which an N may be: "the A and the N stack"."""
_SHAPE = frozenset({"shape", "form"})
"""Commands, too, but "u shape" is a U."""


def _letter(letter: str, before: str, behind: str, ahead: list[str]) -> list[str] | None:
    """The word that a letter stands for."""
    if letter == "r" and (behind in _SPOKEN_TO or before in _SPOKEN_TO):
        return ["are"]
    if letter == "b" and (before in _MODALS or before in _TYPED or before == "2") and behind in _BEING:
        return ["be"]
    if letter == "c" and before in _MODALS | _SPOKEN_TO and (behind in _SEEN or behind.isdigit()):
        return ["see"]
    shape = before in ("a", "the", "letter", "one", "capital") or behind in _SHAPE
    if letter == "u" and not shape and (behind in lexicon.COMMANDS | {"guys", "are", "r", "know"} or before in _ASKING):
        return ["you"]
    joins = before in ("pls", "plz", "please", "thx", "thanks") or before in lexicon.BLOCK
    if letter == "n" and (joins or (not shape and behind in lexicon.COMMANDS - _NOUNS and len(ahead) > 1)):
        return ["and"]
    return ["okay"] if letter == "k" and not ahead else None


def _filling(tokens: list[Token], words: list[str], at: int) -> Iterator[tuple[list[str], int]]:
    """ "(a little bit) like five centimeters", "sort of on top of it", "(and then) like green on red"."""
    before, behind = words[at - 1] if at else "", words[at + 1 : at + 4]
    if words[at] == "like" and behind and before in _TOLD | {"about", "maybe", "move"}:
        many = tokens[at + 1].kind == "number" or behind[0] in lexicon.NUMBER
        if many and behind[1:2] and behind[1] in lexicon.UNIT:
            yield ["about"], at + 1
        elif behind[0] in _PLACES - {"in"} or (behind[0] in lexicon.COLOR and before in ("and", "then")):
            yield [], at + 1
    elif words[at : at + 2] in (["sort", "of"], ["kind", "of"]):
        if words[at + 2 : at + 3] and words[at + 2] in _PLACES | {"like", "to", "a", "an"}:
            yield [], at + 2
    elif words[at : at + 4] == ["a", "little", "bit", "like"] or words[at : at + 3] == ["a", "bit", "like"]:
        long = 4 if words[at + 1] == "little" else 3
        number = tokens[at + long : at + long + 1]
        if number and (number[0].kind == "number" or number[0].word in lexicon.NUMBER):
            yield ["about"], at + long
    elif words[at : at + 2] == ["i", "mean"] and at + 2 == len(words) and at:
        yield [], at + 2
