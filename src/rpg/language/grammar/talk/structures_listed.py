"""Structures of one kind that are told one by one behind their number: "two towers, one red with three blocks and one
blue with two", "two columns of three blocks, one white and one black, 10 cm apart"; and by their colours in front of
them: "for each of the colours red and blue there is a tower of two cubes of that colour"."""

from __future__ import annotations

from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_SINGULAR = {"towers": "tower", "stacks": "stack", "rows": "row", "lines": "line", "columns": "column"}
PLURALS = frozenset(_SINGULAR)
_MARKS = frozenset({",", ":"})
_JOINTS = frozenset({",", "and", ";"})
_ONE = frozenset({"one", "a", "an", "another"})
_OF = (("with",), ("of",), ("having",), ("has",), ("that", "has"), ("which", "has"), ("made", "of"), ("from",),
       ("consisting", "of"))  # fmt: skip
_UNITS = frozenset({"blocks", "cubes", "block", "cube", "ones"})


@dataclass(frozen=True)
class _Entry:
    """One of the structures: its colour, its number of blocks (None where that is told of them all), where it ends."""

    hue: Token
    number: Token | None
    end: int


def structures_listed(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with each of the structures in full: "a tower of three red blocks and a tower of two blue blocks"."""
    for at in (n for n, word in enumerate(words) if word in _SINGULAR and n and tokens[n - 1].many > 1):
        shared, mark = _shared(tokens, words, at)
        mark += words[mark : mark + 1] == ["please"]
        if words[mark : mark + 1] == [] or words[mark] not in _MARKS:
            continue
        entries = _entries(tokens, words, mark + 1)
        numbers = [entry.number or shared for entry in entries]
        closed = entries and (entries[-1].end == len(words) or words[entries[-1].end] in (*_MARKS, ".", ";", "!"))
        alone = shared is not None and entries and entries[-1].end >= len(words) - 1
        behind = words[entries[-1].end + 1 : entries[-1].end + 2] if entries else []
        if len(entries) != tokens[at - 1].many or None in numbers or not closed or alone or behind == ["with"]:
            continue
        out = tokens[: at - 1]
        for n, (entry, number) in enumerate(zip(entries, numbers, strict=True)):
            say = entry.hue.saying
            out += [say("and" if n == len(entries) - 1 else ",")] if n else []
            out += [say("a"), tokens[at].saying(_SINGULAR[words[at]]), say("of"), number or say("two"), entry.hue,
                    say("blocks")]  # fmt: skip
        return [*out, *tokens[entries[-1].end :]]
    return None


def _shared(tokens: list[Token], words: list[str], at: int) -> tuple[Token | None, int]:
    """ "of three blocks" behind the structures, and where it ends."""
    of = at + 1 + length_at(words, at + 1, _OF)
    if of == at + 1 or of + 1 >= len(words) or tokens[of].many < 2 or words[of + 1] not in _UNITS:
        return None, at + 1
    return tokens[of], of + 2 + (words[of + 2 : of + 3] == ["each"])


def _entries(tokens: list[Token], words: list[str], at: int) -> list[_Entry]:
    """The structures that are told from here on."""
    found: list[_Entry] = []
    while at + 1 < len(words) and words[at] in _ONE and words[at + 1] in lexicon.COLOR:
        hue, end = tokens[at + 1], at + 2
        end += words[end : end + 1] in (["one"], ["tower"], ["row"], ["column"], ["stack"], ["line"])
        of = end + length_at(words, end, _OF)
        number = tokens[of] if of > end and of < len(words) and tokens[of].many > 1 else None
        if number is not None:
            end = of + 1
            end += end < len(words) and words[end] in _UNITS
        elif of > end:
            return []
        found.append(_Entry(hue, number, end))
        at = end
        while at < len(words) and words[at] in _JOINTS:
            at += 1
    return found


_FOR_EACH = (
    *(("for", "each", "of", which, "colors") for which in ("the", "these")),
    ("for", "every", "color"), ("for", "each", "color"), ("for", "each", "of", "the", "following", "colors"),
)  # fmt: skip
_THERE = (("there", "is"), ("there", "should", "be"), ("there", "must", "be"), ("build",), ("make",), ("you", "build"))
_SUCH = (("of", "that", "color"), ("of", "this", "color"), ("in", "that", "color"), ("in", "this", "color"))


def one_of_each_color(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with a structure of each of the colours that are told in front of it."""
    for at in range(len(words)):
        lead = length_at(words, at, _FOR_EACH)
        hues, end = [], at + lead
        end += lead > 0 and words[end : end + 1] == [":"]
        while lead and end < len(words) and (words[end] in lexicon.COLOR or words[end] in _JOINTS):
            hues += [tokens[end]] if words[end] in lexicon.COLOR else []
            end += 1
        there = length_at(words, end, _THERE) if len(hues) > 1 else 0
        begin = end + there
        if not there or words[begin : begin + 1] != ["a"] or words[begin + 1] not in _SINGULAR.values():
            continue
        noun = next((n for n in range(begin + 2, min(begin + 8, len(words))) if words[n] in _UNITS), 0)
        last = noun + 1 + length_at(words, noun + 1, _SUCH) if noun else 0
        if not noun or any(word in lexicon.COLOR for word in words[begin:noun]):
            continue
        must = [tokens[end].saying(word) for word in ("there", "must", "be")]
        out = [*tokens[:at], *(must if words[end] == "there" else tokens[end:begin])]
        for n, hue in enumerate(hues):
            out += [hue.saying("and" if n == len(hues) - 1 else ",")] if n else []
            out += [*tokens[begin:noun], hue, tokens[noun]]
        return [*out, *tokens[last:]]
    return None
