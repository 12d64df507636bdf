"""Structures of one kind that are told one by one behind their number: "two towers, one red with three blocks and one
blue with two", "two columns of three blocks, one white and one black, 10 cm apart"."""

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
        if len(entries) != tokens[at - 1].many or None in numbers or not closed or alone:
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
