"""Two rows told by where they are: "A and B in the back row and C and D in the front row", "first row: ..., second
row: ..."."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST
from rpg.language.tokens import Token

_ROW = "(?:back|far|rear|front|near)"
_HEADLESS = ("^(?!.*\\b(?:grid|square|rectangle|pyramid|wall|checkerboard|\\d+x\\d+|column|columns|rows|lines|words?|"
             "spell|write|read|reads)\\b)")  # fmt: skip
_DONE = "(?:(?:put|place|set|arrange|lay|make|build|form|line up) )?"
_AND = "(?: ,| and| , and)?"
_OF = f"(?:of|with|made of|made from|has|is|are|contains|consists of|being|{MUST} (?:be|have|contain|consist of))"

ROWS_PLACED: tuple[Turn, ...] = (
    (f"{_HEADLESS}{_DONE}(?!.* row .* row .* row)(?!all )(\\S+ .+?) (?:in|as|into|on) (?:the|a) ({_ROW}) row{_AND} "
     f"(?:{MUST} )?(\\S+ .+?) (?:in|as|into|on) (?:the|a) ({_ROW}) row$", "{2} row : {1} . {4} row : {3}"),
    (f"{_HEADLESS}{_DONE}(?!.* row .* row .* row)(?:the|a) ({_ROW}) row {_OF} (.+?){_AND} (?:the|a) ({_ROW}) row "
     f"{_OF} (.+)$", "{1} row : {2} . {3} row : {4}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
_PAGE = {"first": "back", "second": "front"}
_BOARDS = frozenset(
    {"grid", "square", "rectangle", "pyramid", "wall", "checkerboard", "layer", "third", "stack", "tower"}
)


def rows_by_number(tokens: list[Token]) -> list[Token]:
    """The tokens, with a first row as the one at the back and a second as the one in front, as on a page."""
    words = [token.word for token in tokens]
    heads = [n for n in range(len(words) - 2) if words[n + 1] == "row" and words[n + 2] == ":"]
    if [words[n] for n in heads] != [*_PAGE] or not _BOARDS.isdisjoint(words):
        return tokens
    return list(_paged(tokens, heads))


def _paged(tokens: list[Token], heads: list[int]) -> Iterator[Token]:
    for n, token in enumerate(tokens):
        yield replace(token, word=_PAGE[token.word]) if n in heads else token
