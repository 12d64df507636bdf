"""Two rows of colors told one by one, where the second may be told by the first: "the front row is red, white, blue and
the back row is the same in reverse", "two rows, one behind the other, each red, white, blue from left to right"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MUST

_AND = "(?: ,)?(?: and)? "
_RIGHT = "(?:(?: ,)? from (?:the )?left to (?:the )?right)?"
_IS = f"(?: (?:is|reads|goes|has|{MUST} be|{MUST} read|:))?"
_JOINT = "(?: ,| \\.| ;| and| but| while)+"
_ROWS = {"front": "(?:front|near|nearer)", "back": "(?:back|far|rear)"}
_REVERSED = (
    "(?:the same(?: colors)? |it |just the same )?(?:but )?(?:in reverse(?: order)?|reversed|backwards?|the other way "
    "round|mirrored|in (?:the )?(?:opposite|reverse) order)"
)
_SAME = "(?:(?:just |exactly )?the same(?: colors)?(?: in the same order)?|(?:just )?like it)"
_ONE_BEHIND = "(?: ,)? one (?:directly |right |straight )?(?:behind|in front of) the other(?: ,| :)?"
_NAMES = {number: word for word, number in lexicon.NUMBER.items()}


def _of_so_many(many: int) -> Iterator[Turn]:
    """The rows for lists of so many colors."""
    told = _AND.join([f"({COLOR})"] * many)
    again = " , ".join(f"{{{n}}}" for n in range(1, many + 1))
    back = " , ".join(f"{{{n}}}" for n in range(many, 0, -1))
    more = " , ".join(f"{{{n}}}" for n in range(many + 1, 2 * many + 1))
    rows = f"two(?: parallel)? rows(?: of (?:{many}|{_NAMES[many]})(?: blocks| cubes)?(?: each)?)?"
    begin = f"^(?:(?:build |make |lay )?{rows}(?:{_ONE_BEHIND}| ,| :| \\.)+ )?"
    for one, other in (("front", "back"), ("back", "front")):
        first = f"{begin}(?:the |in the )?{_ROWS[one]} row{_IS} {told}{_RIGHT}"
        second = f"{first}{_JOINT} (?:the |in the )?{_ROWS[other]} (?:row|one)"
        yield f"{second}{_IS} {_SAME}{_RIGHT}(?= \\.|$)", f"{one} row : {again} ; {other} row : {again}"
        yield f"{second}{_IS} {_REVERSED}(?= \\.|$)", f"{one} row : {again} ; {other} row : {back}"
        yield f"{second}{_IS} {told}{_RIGHT}(?= \\.|$)", f"{one} row : {again} ; {other} row : {more}"
    yield (
        f"^(?:build |make |lay )?{rows}{_ONE_BEHIND} (?:each|both)(?: of them)?{_IS}(?: of)? {told}{_RIGHT}(?= \\.|$)",
        f"front row : {again} ; back row : {again}",
    )


ROWS_ALIKE: tuple[Turn, ...] = tuple(turn for many in (2, 3, 4, 5, 6) for turn in _of_so_many(many))
"""What is looked for in a text, and what is said instead."""
WORDS = ("backward backwards mirrored reversed",)
"""Words that these take besides those that are read anyway."""
