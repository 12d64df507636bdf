"""Several structures that are told one by one: "two towers, a red one of three and a blue one of two"."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_BETWEEN = frozenset({",", ":", "and"})
_OF_SIZE = frozenset({"with", "of", "a", "base", "height", "length", "size", "high", "long", "wide", "blocks", "cubes",
                      "block", "cube", "each", "every", "both", "x", "by", "tall"})  # fmt: skip
_EACH = frozenset({"each", "both", "every"})
_OF_PARTS = frozenset({"top", "bottom", "middle", "above", "below", "under", "underneath"})
"""With these "two towers, a red one on top" is told of the blocks of each."""
_MADE = frozenset({"from", "of", "made", "out", "built"})
_TAIL = frozenset({"the", "both", "with", "they", "all", "these"})
_ADJECTIVES = 4


def one_by_one(tokens: list[Token]) -> list[Token] | None:
    """The words with each of the structures named in full: "a red tower of three and a blue tower of two"."""
    words = [token.word for token in tokens]
    for at in (n for n, word in enumerate(words) if n and lexicon.STRUCTURE.get(word, ("", False))[1]):
        begin = next((n for n in range(at - 1, max(-1, at - 1 - _ADJECTIVES), -1) if _many(tokens[n]) > 1), -1)
        stop = next((n for n in range(at, len(words)) if words[n] in _STOPS), len(words))
        ones = ("one", words[at][:-1])
        firsts = [n for n in range(at + 2, stop) if words[n - 1] in _BETWEEN and _is_one(words, n, ones)]
        if begin >= 0 and len(firsts) == _many(tokens[begin]) and words[at][:-1] in lexicon.STRUCTURE:
            return _in_full(tokens, begin, at, firsts, stop)
    return _ones_named(tokens)


def _ones_named(tokens: list[Token]) -> list[Token] | None:
    """ "A red tower of three and a blue tower of two, the red one on the left": the red tower."""
    words = [token.word for token in tokens]
    ones = (n for n in range(2, len(words)) if words[n] == "one" and words[n - 1] in lexicon.COLOR)
    first = next((n - 2 for n in ones if words[n - 2] == "the"), 0)
    nouns = [n for n in range(first) if words[n] in lexicon.STRUCTURE]
    starts = [max((m for m in range(n) if words[m] in ("a", "an")), default=-1) for n in nouns]
    if len(nouns) < 2 or len({words[n] for n in nouns}) > 1 or len({*starts, -1}) <= len(nouns):
        return None
    told = [{*words[a:b]} & lexicon.COLOR.keys() for a, b in zip(starts, [*starts[1:], first], strict=True)]
    if any(len(colors) != 1 for colors in told) or len(colors := set().union(*told)) < len(told):
        return None
    stop = next((n for n in range(first, len(words)) if words[n] in _STOPS), len(words))
    tail = first - (words[first - 1] == ",")
    behind = _named_so(tokens[tail:], colors, tokens[nouns[0]]) if colors.isdisjoint(words[: starts[0]]) else []
    if not behind:
        return None
    return tokens[:tail] + _beside_the_other(behind, stop - tail, sorted(colors))


def _in_full(tokens: list[Token], begin: int, at: int, firsts: list[int], stop: int) -> list[Token] | None:
    words = [token.word for token in tokens]
    tail = next((n for n in range(firsts[-1], stop - 1) if words[n] == "," and words[n + 1] in _TAIL), stop)
    sizes = [t for t in tokens[at + 1 : firsts[0]] if t.word not in _BETWEEN]
    if any(t.word not in _OF_SIZE and t.kind != "number" and t.word not in lexicon.NUMBER for t in sizes):
        return None
    sizes = [t for t in sizes if t.word not in _EACH]
    if sizes and sizes[0].word != "with" and _many(sizes[0]):
        sizes.insert(0, _word("of", sizes[0]))
    noun = replace(tokens[at], word=words[at][:-1], raw=words[at][:-1])
    shape = [*tokens[begin + 1 : at], noun, *sizes]
    out, colors = tokens[:begin], set()
    for n, first in enumerate(firsts):
        end = tail if n == len(firsts) - 1 else firsts[n + 1]
        told = tokens[first + 1 : end]
        while told and told[-1].word in _BETWEEN:
            told.pop()
        if not _OF_PARTS.isdisjoint(token.word for token in told):
            return None
        looks = told[:1] if told and told[0].word in lexicon.COLOR else []
        rest = told[len(looks) :]
        rest = rest[1:] if rest and looks and rest[0].word in ("one", noun.word) else rest
        colors |= {token.word for token in told if token.word in lexicon.COLOR}
        joint = [_word("and" if n == len(firsts) - 1 else ",", tokens[begin])] if n else []
        out += [*joint, _word("a", tokens[begin]), *looks, *shape, *rest]
    behind = _named_so(tokens[tail:], colors, noun) if colors.isdisjoint(words[:begin]) else tokens[tail:]
    return out + _beside_the_other(behind, stop - tail, sorted(colors))


def _named_so(tokens: list[Token], colors: set[str], noun: Token) -> list[Token]:
    """ "The red one" behind them is the red structure, if nothing else there is red."""
    if any(t.word in colors and after.word not in ("one", noun.word) for t, after in pairwise(tokens)):
        return tokens
    ones = {
        n for n in range(2, len(tokens))
        if tokens[n].word == "one" and tokens[n - 1].word in colors and tokens[n - 2].word == "the"
    }  # fmt: skip
    return [replace(t, word=noun.word, raw=noun.raw) if n in ones else t for n, t in enumerate(tokens)]


def _beside_the_other(tokens: list[Token], end: int, colors: list[str]) -> list[Token]:
    """ ", the red tower on the left" of two is left of the other one."""
    words = [token.word for token in tokens[:end]]
    other = [color for color in colors if color not in words]
    if words[:2] != [",", "the"] or len(colors) != 2 or len(other) != 1 or (beside := tuple(words[4:])) not in _BESIDE:
        return tokens
    there = [*_BESIDE[beside], "the", other[0], words[3]]
    return [*tokens[:4], *(_word(word, tokens[3]) for word in there), *tokens[end:]]


_BESIDE = {
    ("on", "the", "left"): ("left", "of"), ("on", "the", "right"): ("right", "of"), ("behind",): ("behind",),
    ("in", "front"): ("in", "front", "of"), ("at", "the", "front"): ("in", "front", "of"),
    ("at", "the", "back"): ("behind",), ("in", "the", "back"): ("behind",),
}  # fmt: skip


def _is_one(words: list[str], at: int, ones: tuple[str, str]) -> bool:
    """ "a red one", "a red tower", "one red", "one from (three red blocks)"."""
    behind = words[at + 1] if at + 1 < len(words) else ""
    if words[at] == "one" and behind in _MADE:
        return True
    after = words[at + 2] if at + 2 < len(words) else ""
    if behind not in lexicon.COLOR or words[at] not in ("a", "an", "one"):
        return False
    return after in ones or (words[at] == "one" and after not in lexicon.BLOCK)


def _many(token: Token) -> int:
    if token.kind == "number" and isinstance(token.value, float):
        return int(token.value)
    return lexicon.NUMBER.get(token.word, 0) if token.kind == "word" else 0


def _word(word: str, like: Token) -> Token:
    return replace(like, kind="punct" if word == "," else "word", word=word, raw=word, value=None)
