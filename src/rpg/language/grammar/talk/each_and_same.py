"""Each and the same, told with a word more: "each one a different colour", "the same three cubes"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_OF_A = frozenset({"a", "of", "in", "with"})


def each_once(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Using each of the cubes 9, 4, 5, - and = exactly once, form a true equation": using these cubes."""
    for at in range(len(words) - 3):
        each = words[at] in ("using", "use") and words[at + 1 : at + 4] == ["each", "of", "the"]
        once = next((n for n in range(at, len(words)) if words[n] == "once"), 0)
        if not each or not once or not _STOPS.isdisjoint(words[at:once]):
            continue
        begin = once - (words[once - 1] in ("exactly", "only", "just"))
        return [*tokens[: at + 1], *tokens[at + 3 : begin], *tokens[once + 1 :]]
    return None


def each_one(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Each one (in) a different colour": each a different one."""
    for at in range(len(words) - 4):
        if words[at : at + 2] == ["each", "one"] and "different" in words[at + 2 : at + 5] and words[at + 2] in _OF_A:
            return [*tokens[: at + 1], *tokens[at + 2 :]]
    return None


def same_ones(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The same three cubes": the three cubes, which were told before."""
    for at in range(1, len(words) - 2):
        counted = tokens[at + 1].many > 1 and words[at + 2] in lexicon.BLOCK
        if words[at - 1 : at + 1] == ["the", "same"] and counted:
            return [*tokens[:at], *tokens[at + 1 :]]
    return None


def one_of_each(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "One block of each color on the mat: red, blue and yellow": a red, a blue and a yellow block on the mat."""
    for at in range(len(words) - 6):
        if words[at] not in ("one", "a") or words[at + 1] not in lexicon.BLOCK:
            continue
        end = next((n for n in range(at + 2, len(words)) if words[n] in _STOPS), len(words))
        colon = next((n for n in range(at + 2, end) if words[n] == ":"), 0)
        listed = tokens[colon + 1 : end] if colon else []
        hues = [token for token in listed if token.word in lexicon.COLOR]
        each = words[at + 2 : at + 5] in (["of", "each", "color"], ["of", "every", "color"])
        if not each or len(hues) < 2 or any(t.word not in ("and", ",") and t not in hues for t in listed):
            continue
        out = tokens[:at]
        for n, hue in enumerate(hues):
            out += [hue.saying("and" if n == len(hues) - 1 else ",")] if n else []
            out += [hue.saying("a"), hue, *([tokens[at + 1]] if n == len(hues) - 1 else [])]
        return [*out, *tokens[at + 5 : colon], *tokens[end:]]
    return None
