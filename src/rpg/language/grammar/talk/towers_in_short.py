"""Towers told in short or in other words: by their floors, in pairs, a height for all of them, tidied up into them."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.talk.colored_groups import GROUPS
from rpg.language.phrases import behind, length_at
from rpg.language.tokens import Token

FLOORS = frozenset({"floors", "floor", "storeys", "stories", "storey", "levels", "layers"})
_TOWERS = frozenset({"tower", "towers", "stack", "stacks", "skyscraper", "skyscrapers"})
_SMALL = frozenset({"little", "small", "neat", "nice", "tidy"})
_STOPS = frozenset({".", "!", "?", ";"})


_ONE_OF = ("one", "other", "first", "second", "third", "each")


def floors_high(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Two towers, one with three floors and one with two": of so many blocks."""
    if _TOWERS.isdisjoint(words):
        return None
    out = list(tokens)
    for n in range(1, len(words)):
        plural = words[n] in FLOORS and (tokens[n - 1].many or words[n - 1] in ("one", "a"))
        led = n > 2 and words[n - 2] in ("with", "has", "of") and words[n - 3] in _ONE_OF
        if plural and led and words[n + 1 : n + 2] not in (["of"], ["is"], ["are"], [":"]):
            out[n] = tokens[n].saying("block" if words[n - 1] in ("one", "a") else "blocks")
    return out if out != tokens else None


def tidied_into(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Tidy them up into three little towers": stack them into three towers."""
    for at in range(len(words) - 3):
        if words[at] not in ("tidy", "clear", "clean") or "into" not in words[at:]:
            continue
        into = words.index("into", at)
        what = [t for t in tokens[at + 1 : into] if t.word != "up"]
        end = next((n for n in range(into, len(words)) if words[n] in _STOPS | {","}), len(words))
        towers = not _TOWERS.isdisjoint(words[into:end])
        stopped = not (_STOPS | {",", ":"}).isdisjoint(words[at:into])
        if not what or stopped or len(what) == into - at - 1:
            continue
        what = [what[0].saying("them")] if [t.word for t in what] == ["it"] else what
        rest = [t for n, t in enumerate(tokens[into:end], into) if not _small_towers(words, n)]
        return [*tokens[:at], tokens[at].saying("stack" if towers else "sort"), *what, *rest, *tokens[end:]]
    return None


def _small_towers(words: list[str], n: int) -> bool:
    """ "little" of "three little towers"."""
    after = next((word for word in words[n:] if word not in _SMALL), "")
    return words[n] in _SMALL and (after in _TOWERS or after in GROUPS)


_EACH_OF = tuple(
    (*comma, each, *of)
    for comma in ((",",), (), (",", "with"))
    for each in ("each", "both", "all")
    for of in (("of",), ("with",), ("has",), ("have",), ("having",), ())
)
_UNITS = frozenset({"blocks", "cubes", "bricks", "high", "tall"})


def one_height_for_all(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A red tower and a blue tower, each of two blocks": a tower of two red blocks and a tower of two blue ones."""
    for at in range(len(words) - 6):
        found: list[tuple[Token, Token]] = []
        end = at
        while words[end : end + 1] in (["a"], ["an"]) and end + 2 < len(words):
            if words[end + 1] not in lexicon.COLOR or words[end + 2] not in ("tower", "stack"):
                break
            found.append((tokens[end + 1], tokens[end + 2]))
            end += 3
            joint = end
            while words[joint : joint + 1] in ([","], ["and"]):
                joint += 1
            if joint == end or words[joint : joint + 1] not in (["a"], ["an"]):
                break
            end = joint
        number = behind(words, end, _EACH_OF) if len(found) > 1 else 0
        if not number or number >= len(words) or tokens[number].many < 2:
            continue
        last = number + 1
        while last < len(words) and words[last] in _UNITS:
            last += 1
        closed = last == len(words) or (words[last] in (*_STOPS, ",", ":") and words[last + 1 : last + 2] != ["with"])
        if not closed or (last == number + 1 and words[number - 1] not in ("of", "with")):
            continue
        out = tokens[:at]
        for n, (hue, tower) in enumerate(found):
            out += [hue.saying("and" if n == len(found) - 1 else ",")] if n else []
            of = [hue.saying("a"), tower, hue.saying("of"), tokens[number], hue, hue.saying("blocks")]
            out = [*out, *of]
        return [*out, *tokens[last:]]
    return None


_SHOULD = (("must", "have"), ("should", "have"), ("has",), ("must", "be"), ("should", "be"), ("is",), ("shall", "have"),
           ("must", "consist", "of"), ("should", "consist", "of"), ("needs",), ("has", "to", "have"))  # fmt: skip
_AT_LEAST = (("at", "least"), ("no", "fewer", "than"), ("exactly",), ("not", "fewer", "than"))


def one_tower_has(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "One tower must have at least three blocks": there must be a tower of these, where no others are told."""
    if sum(word in _TOWERS for word in words) > 1:
        return None
    for at in range(len(words) - 4):
        begun = at == 0 or words[at - 1] in (*_STOPS, ",", ":", "and")
        if not begun or words[at] not in ("one", "a", "some") or words[at + 1] not in ("tower", "stack"):
            continue
        least = behind(words, at + 2, _SHOULD)
        number = least + length_at(words, least, _AT_LEAST) if least else 0
        if not number or number == least or number >= len(words) or tokens[number].many < 2:
            continue
        end = number + 1
        while end < len(words) and words[end] in _UNITS:
            end += 1
        if end < len(words) and words[end] not in _STOPS:
            continue
        said = [tokens[at].saying(word) for word in ("there", "must", "be", "a", "tower", "of")]
        blocks = tokens[number].saying("blocks")
        return [*tokens[:at], *said, *tokens[least : number + 1], blocks, *tokens[end:]]
    return None


def pairs_stacked(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Three pairs, each a red block on a blue one": three towers, each of these."""
    for at in range(len(words) - 5):
        each = at + 1 + (words[at + 1] in (",", ":"))
        each += words[each : each + 1] == ["with"]
        if words[at] != "pairs" or words[each] not in ("each", "every") or "on" not in words[each : each + 9]:
            continue
        on = words.index("on", each)
        them = each + 1 + 2 * (words[each + 1 : each + 3] == ["of", "them"])
        if words[them] not in ("a", "an") or any(word in _STOPS or word == "," for word in words[each:on]):
            continue
        return [*tokens[:at], tokens[at].saying("towers"), tokens[at].saying(","), tokens[each], *tokens[them:]]
    return None


SPREAD = frozenset({"spread", "distribute", "divide", "split", "share", "sort"})
_AMONG = frozenset({"among", "over", "into", "between", "across", "onto", "in"})

_EVENLY = frozenset({"evenly", "equally"})


def spread_over(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Distribute eight cubes over two towers": stack them into two towers."""
    for at in (n for n, word in enumerate(words) if word in SPREAD):
        over = next((n for n in range(at + 1, len(words)) if words[n] in _AMONG or words[n] in _STOPS), len(words))
        if over >= len(words) - 2 or words[over] in _STOPS or over == at + 1 or not _TOWERS.isdisjoint(words[at:over]):
            continue
        number = over + 1
        noun = number + 1
        while noun < len(words) and words[noun] in ("equal", "equally", "high", "tall", "separate", *_SMALL):
            noun += 1
        if tokens[number].many > 1 and words[noun : noun + 1] in (["towers"], ["stacks"]):
            told = [t for t, word in zip(tokens[at + 1 : over], words[at + 1 : over], strict=True) if word != "up"]
            what = [t for t in told if t.word not in _EVENLY]
            size = [] if len(what) == len(told) or noun > number + 1 else [tokens[number].saying("equal")]
            into = [tokens[over].saying("into"), tokens[number], *size, *tokens[number + 1 :]]
            return [*tokens[:at], tokens[at].saying("stack"), *what, *into]
    return None
