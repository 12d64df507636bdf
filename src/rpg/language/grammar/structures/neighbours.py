"""Orders told of every two neighbours: "each block smaller than the one below it"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import OrderBy

_LEAD = "where|in_which|so_that|such_that|so|with|and"
_IS = "is|being|must_be|should_be|has_to_be?"
_EACH = (
    f"each|every|each_of_them one|block|cube|letter|number|digit? {_IS}",
    f"each|every_one of the two|three|four|five|six|seven|eight? ones|blocks|cubes|letters|numbers|digits {_IS}",
)
_SHOWS = "each|every one|block|cube? shows|has|carries a"
_NUMBER = "number|digit|value"
_ONE = "than the one|block|cube|number|digit|letter that_is|which_is|directly|immediately|right?"
_PREVIOUS, _NEXT = (f"than the|its {word} one|block|cube|number|digit?" for word in ("previous", "next"))
_LESS = "smaller|littler|lower|less"
_MORE = "bigger|larger|greater|higher"
_SIDES = {
    "bottom": ("below|beneath|under|underneath it?",),
    "top": ("above it?", "on_top_of it"),
    "left": ("to_the_left_of it", "to|on its left", "to_its_left|on_its_left|on_the_left", "left_of it", "before it?"),
    "right": ("to_the_right_of it", "to|on its right", "to_its_right|on_its_right|on_the_right", "right_of it",
              "after it?"),
    "front": ("in_front_of it",),
    "back": ("behind it",),
}  # fmt: skip
_NEIGHBOR = {"left": _PREVIOUS, "right": _NEXT}
_TOLD = tuple(
    (
        first,
        descending,
        Patterns(
            *(
                told
                for side in sides
                for told in (
                    *(f"{_LEAD}? {each} {more} {_ONE} {side}" for each in _EACH),
                    f"{_LEAD}? {_SHOWS} {more} {_NUMBER} {_ONE} {side}",
                )
            ),
            *(f"{_LEAD}? {each} {more} {_NEIGHBOR[first]}" for each in _EACH if first in _NEIGHBOR),
        ),
    )
    for first, sides in _SIDES.items()
    for descending, more in ((True, _LESS), (False, _MORE))
)
_EVERY = frozenset({"each", "every"})
_NUMBERS = frozenset({"number", "digit", "numbers", "digits"})


def by_neighbours(p: Parser, i: int) -> Iterator[tuple[OrderBy, int]]:
    """The order that begins on the side of the one that each is compared with."""
    if not p.rarely(_EVERY):
        return
    start = p.opt(i, ",")
    for first, descending, patterns in _TOLD:
        for j in patterns.matches(p, start):
            by = "ascending" if _NUMBERS.isdisjoint(p.words[start:j]) else "number"
            attribute = "size" if by == "ascending" else "color"
            yield OrderBy(by=by, first=first, descending=descending, attribute=attribute, span=p.span(i, j)), j
