"""The heights of towers, told behind them: "three red towers. From left to right they have 3, 2 and 1 blocks"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_TOWERS = frozenset({"towers", "stacks", "columns"})
_HIGH = frozenset({"high", "tall", "heights"})
_WAYS = tuple(("from", one, "to", other) for one, other in (
    ("left", "right"), ("right", "left"), ("front", "back"), ("back", "front"), ("near", "far"), ("far", "near")
))  # fmt: skip
_SAID = (("they", "have"), ("they", "are"), ("these", "have"), ("these", "are"), ("the", "towers", "have"),
         ("the", "towers", "are"), ("the", "stacks", "have"), ("the", "stacks", "are"), ("have",), ("are",),
         ("they", "should", "have"), ("they", "must", "have"), ("they", "should", "be"), ("their", "heights"),
         ("the", "heights"), ("which", "have"), ("that", "have"), ("heights",), ("with", "heights"))  # fmt: skip
_IS = (("are",), (":",), ("should", "be"), ("must", "be"), ("of",))
_UNITS = frozenset({"blocks", "block", "cubes", "cube", "high", "tall"})
_STOPS = frozenset({".", "!", "?", ";"})


def heights_told(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The towers with their heights right behind them."""
    if _TOWERS.isdisjoint(words):
        return None
    for at in (n for n, word in enumerate(words) if word in _TOWERS and n):
        begin = at - 1 - (words[at - 1] in lexicon.COLOR)
        if begin < 0 or _number(tokens[begin]) is None:
            continue
        of = at + 1 if words[at + 1 : at + 2] == ["of"] and words[at + 3 : at + 4] in (["blocks"], ["cubes"]) else 0
        colored = bool(of) and words[at + 2] in lexicon.COLOR and begin == at - 1
        end = at + 4 if colored else at + 1
        told = _told(tokens, words, end)
        if told is None:
            continue
        heights, way, last = told
        if words[at] == "columns" and _HIGH.isdisjoint(words[at:last]):
            continue  # these lie on the table
        if sum(_number(t) is not None for t in heights) != _number(tokens[begin]):
            continue
        before = begin - (words[begin - 1 : begin] == ["the"])
        if before < begin and not _TOWERS.isdisjoint(words[:before]):
            continue  # those that were spoken of before
        before -= 3 if words[max(0, before - 3) : before] == ["the", "heights", "of"] else 0
        color = [tokens[at + 2]] if colored else tokens[begin + 1 : at]
        towers = [tokens[at].saying(word) for word in ("towers", "of", "heights")]
        return [*tokens[:before], tokens[begin], *color, *towers, *heights, *way, *tokens[last:]]
    return None


def _told(tokens: list[Token], words: list[str], at: int) -> tuple[list[Token], list[Token], int] | None:
    """The list of heights that stands at `at` behind what leads to it, the way it goes, and where both end."""
    way: list[Token] = []
    led = at + (words[at : at + 1] in (["."], [","], [";"], [":"]))
    led += words[led : led + 1] == ["seen"]
    led, way = _way(tokens, words, led)
    led += words[led : led + 1] == [","]
    said = length_at(words, led, _SAID)
    heights_said = "heights" in words[led : led + said]
    high = words[at : at + 1] == [":"] or "heights" in words[max(0, at - 6) : at]  # ": from left to right 3 and 2 high"
    if not said and not high:
        return None
    led += said
    if not way:
        led, way = _way(tokens, words, led)
    led += words[led : led + 1] == [":"]
    led += max((len(x) for x in _IS if heights_said and tuple(words[led : led + len(x)]) == x), default=0)
    end = led
    while end < len(words) and (_number(tokens[end]) is not None or words[end] in (",", "and")):
        end += 1
    end -= words[end - 1 : end] == [","]
    heights = tokens[led:end]
    if len(heights) < len(("2", "and", "3")) or _number(heights[0]) is None or _number(heights[-1]) is None:
        return None
    units = 0
    while words[end : end + 1] and words[end] in _UNITS:
        end, units = end + 1, units + 1
    heights_said = heights_said or "heights" in words[max(0, at - 6) : at]
    if not (units or heights_said) or not (said or heights_said or words[end - 1] in ("high", "tall")):
        return None
    if not way:
        end, way = _way(tokens, words, end + (words[end : end + 1] == [","]))
    return (heights, way, end) if end >= len(words) or words[end] in _STOPS else None


def _way(tokens: list[Token], words: list[str], at: int) -> tuple[int, list[Token]]:
    long = length_at(words, at, _WAYS)
    if not long and any(tuple(words[at : at + 3]) == x[1:] for x in _WAYS):  # "left to right"
        return at + 3, [tokens[at].saying("from"), *tokens[at : at + 3]]
    return at + long, tokens[at : at + long]


def _number(token: Token) -> int | None:
    if token.kind == "number" and isinstance(token.value, float | int):
        return int(token.value)
    return lexicon.NUMBER.get(token.word)
