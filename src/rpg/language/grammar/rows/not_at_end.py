"""What a line must not have at an end: "stack white, pink and cyan; the bottom one must not be white"."""

from __future__ import annotations

from functools import lru_cache

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turn, Turns, turned
from rpg.language.grammar.rows.vocabulary import MUST
from rpg.language.tokens import Token

_ENDS = (
    ("bottom|lowest|bottommost", "at the bottom"),
    ("top|topmost|highest|uppermost", "at the top"),
    ("leftmost", "at the left end"),
    ("rightmost", "at the right end"),
)
_ONE = "(?: one| block| cube)?"


def not_at_end(tokens: list[Token]) -> list[Token]:
    """The tokens, with a colour that an end must not have told as a place that a block must not have: a block that was
    named before, for of no other it says anything."""
    words = [token.word for token in tokens]
    named = sorted({word for word in words if word in lexicon.COLOR and words.count(word) > 1})
    return turned(tokens, _turns(tuple(named))) if named and "not" in words else tokens


@lru_cache(maxsize=256)
def _turns(colors: tuple[str, ...]) -> Turns:
    color = f"({'|'.join(colors)})"
    rows: list[Turn] = []
    for end, where in _ENDS:
        rows += [
            (f"\\b(?:(?:where|but|and) )?the (?:{end}){_ONE} (?:{MUST}|may|can) not be (?:the )?{color}{_ONE}$",
             f"{{1}} must not be {where}"),
            (f"(?: ,)?(?: but)? (?:whose|with the|(?:in which|where|so that|such that) the) (?:{end}){_ONE} "
             f"(?:(?:is|{MUST} be|being) )?(?:not|{MUST} not be|may not be|cannot be) {color}$",
             f"with {{1}} not {where}"),
        ]  # fmt: skip
    return Turns(rows)
