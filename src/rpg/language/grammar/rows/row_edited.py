"""A row that is there and has a block put into it, or two swapped: "insert a green block between B and C of the row A,
B, C", "there is a row 1, 2, 3; append a 4". It is told once as it begins and once as it ends."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from rpg.language.grammar.rows.vocabulary import COLOR, MANY, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_NAME = f"(?:{COLOR}|[a-z]|\\d)"
_NOUN = "(?: (?:block|cube|one|letter|digit|number))?"
_ARTICLE = "(?:(?:the|an?|one|another) )?(?:(?:letter|digit|number|block|cube) )?"
_ONE = f"{_ARTICLE}(?P<one>{_NAME}){_NOUN}"
_BESIDE = f"{_ARTICLE}(?P<left>{_NAME}){_NOUN}(?: block)? and {_ARTICLE}(?P<right>{_NAME}){_NOUN}"
_LISTED = f"(?P<list>{_NAME}(?:(?: ,| and| , and)? {_NAME})+)"
_LOT = f"of (?P<many>{MANY}) (?P<look>{COLOR})(?: blocks| cubes| ones)?"
_ROW = f"(?:(?:an?|the|this|my|our) (?:row|line)(?: :| is :| is)?|(?:row|line) :) {_LISTED}"
_ROWS = f"(?:{_ROW}|(?:an?|the|this) (?:row|line) {_LOT})"
_OF_IT = "(?: of (?:it|the row|the line|that row|this row))?"
_PUT = "(?:insert|squeeze|slot|add|(?:put|place)(?!.* of an? (?:row|line)\\b))"  # "a row" is still to be made
_LAST = "(?:at the (?:right )?end|to the (?:right )?end|(?:at|to) its (?:right )?end|(?:on|at) (?:the|its) right)"
_FIRST = (
    "(?:(?:at|to) the (?:beginning|start|left end)|(?:at|to) its (?:beginning|left end)|(?:on|at) (?:the|its) left)"
)
_SWAP = "(?:swap|exchange|switch)"
_BLOCKS = "(?: (?:blocks?|cubes?|ones?|letters?|digits?|numbers?))?"
_OUTER = (
    f"{_SWAP} (?:(?:the )?(?:first|leftmost){_BLOCKS} (?:and|with) (?:the )?(?:last|rightmost){_BLOCKS}|"
    f"(?:the )?(?:two )?(?:outer|outermost)(?: two)?{_BLOCKS}|(?:the )?(?:two )?(?:blocks |cubes |ones )?at the ends|"
    "the ends)"
)
_INNER = (
    f"{_SWAP} (?:(?:the )?(?:two )?(?:middle|inner|central)(?: two)?{_BLOCKS}|(?:the )?two(?: blocks| cubes| ones)? in "
    "the (?:middle|center))"
)
Edit = Callable[[list[str], re.Match[str]], list[str] | None]


def _between(row: list[str], told: re.Match[str]) -> list[str] | None:
    """With a block between two neighbours that are told apart."""
    ends = [told["left"], told["right"]]
    at = [n for n in range(1, len(row)) if sorted(row[n - 1 : n + 1]) == sorted(ends)]
    alike = any(row.count(end) > 1 for end in ends)
    return [*row[: at[0]], told["one"], *row[at[0] :]] if len(at) == 1 and not alike else None


def _in_the_middle(row: list[str], told: re.Match[str]) -> list[str] | None:
    half = len(row) // 2
    return None if len(row) % 2 else [*row[:half], told["one"], *row[half:]]


def _inner_two(row: list[str], told: re.Match[str]) -> list[str] | None:
    half = len(row) // 2
    return None if len(row) % 2 else [*row[: half - 1], row[half], row[half - 1], *row[half + 1 :]]


_INTO: tuple[tuple[str, Edit], ...] = (
    (f"(?:insert|squeeze|slot) {_ONE} (?:right |directly |exactly )?(?:in )?between {_BESIDE}", _between),
    (f"{_PUT} {_ONE} (?:right |exactly )?(?:in|into|at) (?:the|its) (?:very )?(?:middle|center)", _in_the_middle),
    (f"(?:append|add|attach) {_ONE} {_FIRST}", lambda row, told: [told["one"], *row]),
    (f"(?:append|add|attach) {_ONE} {_LAST}", lambda row, told: [*row, told["one"]]),
)
_SWAPPED: tuple[tuple[str, Edit], ...] = (
    (_OUTER, lambda row, told: [row[-1], *row[1:-1], row[0]]),
    (_INNER, _inner_two),
)
_THERE = (
    "(?:(?:at the start|initially|at first)(?: ,| :)? )?(?:(?:there is|we have|i have|you have|(?:start|begin)(?: with|"
    "ing with| from| :)) )?"
)
_STOP = "(?: \\.| ;| ,| and| then)+ (?:now )?(?:please )?"
_END = "(?: please)?(?: [.!])?"
_EDITS = [
    *(
        (on_demand(pattern), edit)
        for told, edit in (*_INTO, (f"append {_ONE}", _INTO[-1][1]), _SWAPPED[1])
        for pattern in (f"{_THERE}{_ROWS}(?: on the table)?{_STOP}{told}{_OF_IT}{_END}",)
    ),
    *(
        (on_demand(pattern), edit)
        for told, edit in (*_INTO, *_SWAPPED)
        for pattern in (f"{told} (?:of|in|into|within|to) {_ROWS}{_END}", f"in {_ROWS}(?: ,)? {told}{_END}")
    ),
]
"""The whole of a text, and what becomes of the row."""
_WORDS = frozenset(
    {"insert", "squeeze", "slot", "put", "place", "add", "append", "attach", "swap", "exchange", "switch"}
)


def row_edited(tokens: list[Token]) -> list[Token]:
    """The tokens with the row as it begins, and as it ends."""
    words = [token.word for token in tokens]
    if _WORDS.isdisjoint(words) or {"row", "line"}.isdisjoint(words):
        return tokens
    text = " ".join(word.replace(" ", "_") or "_" for word in words)
    for pattern, edit in _EDITS:
        told = pattern.fullmatch(text)
        row = _row_of(told) if told is not None else []
        ends = edit(row, told) if told is not None and len(row) > 1 else None
        if ends is not None:
            return [
                *_told(tokens, "at the start there is a row", row),
                *_told(tokens, "at the end there must be a row", ends),
            ]
    return tokens


def _row_of(told: re.Match[str]) -> list[str]:
    """What the row has, from left to right."""
    if told["many"]:
        return [told["look"]] * number(told["many"])
    return [word for word in told["list"].split() if word not in (",", "and")]


def _told(tokens: Sequence[Token], begins: str, row: Sequence[str]) -> list[Token]:
    """A sentence that lists the row; its symbols are those of the text."""
    known = {token.word: token for token in tokens if token.raw.isupper() or token.kind == "number"}
    out = [tokens[0].saying(word) for word in (*begins.split(), "from", "left", "to", "right", ":")]
    for name in row:
        out += [known.get(name) or tokens[0].saying(name), tokens[0].saying(",")]
    return [*out[:-1], tokens[0].saying(".")]
