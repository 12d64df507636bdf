"""One kind before its opposite: "first the vowels, then the consonants, both in alphabetical order"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.later import later
from rpg.language.meaning import OrderBy

if TYPE_CHECKING:
    from rpg.language.grammar.structures.orders import order
else:
    (order,) = later(__name__, "rpg.language.grammar.structures.orders", "order")

_NOUNS = ("ones", "numbers", "digits", "cubes", "blocks")
_KINDS = {
    "even": "|".join(["evens", *(f"even_{noun}" for noun in _NOUNS)]),
    "odd": "|".join(["odds", *(f"odd_{noun}" for noun in _NOUNS)]),
    "vowel": "vowels|vowel_cubes|vowel_blocks",
    "consonant": "consonants|consonant_cubes|consonant_blocks",
}
_PAIRS = (("even", "odd"), ("odd", "even"), ("vowel", "consonant"), ("consonant", "vowel"))
_WORDS = frozenset(["evens", "even", "odds", "odd", "vowels", "vowel", "consonants", "consonant"])
_ALL = "the|all|all_the|all_of_the?"
_GO = "come|stand|are|go|coming|standing|being|placed|put?"
_WITH = "with|where|so_that|such_that|having|putting|placing|in_which|so?"
_THEN = "then|after_that|after_those|after_them|afterwards|followed_by|finally|next"
_LAST = "last|after|afterwards|after_that|after_them|after_those|second|next|behind|behind_them"
_AHEAD = {one: Patterns(f",|:? first|first_of_all {_ALL} {kinds}") for one, kinds in _KINDS.items()}
_FIRST = {one: Patterns(f",|:? {_WITH} {_ALL} {kinds} {_GO} first") for one, kinds in _KINDS.items()}
_BEFORE = {
    (one, other): Patterns(
        f",|:? {_WITH} {_ALL} {_KINDS[one]} {_GO} before|ahead_of|preceding|precede|followed_by {_ALL} {_KINDS[other]}",
        f",|:? {_WITH} {one} before {other}", f"{_KINDS[one]} then {_KINDS[other]}",
    )
    for one, other in _PAIRS
}  # fmt: skip
_AFTER = {
    other: Patterns(
        f",|,_and|and? {_THEN} {_ALL} {kinds}",
        f",|,_and|and|,_but|,_then|and_then? {_ALL} {kinds} {_GO} {_LAST}",
    )
    for other, kinds in _KINDS.items()
}
_EACH = Patterns(
    ",? within|in? each|both kind|group|set|lot|sort|class|part|kinds|groups|sets|sorts|of_them|of_these|of_the_two|"
    "of_the_two_kinds|of_the_two_groups|in_itself|one? sorted|ordered|arranged?",
)
_COMMA = Patterns(", sorted|ordered|arranged|all?")
_INNER = ("label", "number", "ascending")


@choice
def kinds_first(p: Parser, i: int) -> Results[OrderBy]:
    """Which kind comes first, and the order that each of them is in where that is said of each."""
    if not p.rarely(_WORDS):
        return
    for (one, other), before in _BEFORE.items():
        for k in before.matches(p, i):
            yield from _each(p, i, k, one, (one, other))
    for one, other in _PAIRS:
        for j in _AHEAD[one].matches(p, i):
            yield from _told(p, i, j, (one, other))
        for j in _FIRST[one].matches(p, i):
            yield from [*_told(p, i, j, (one, other))] or _each(p, i, j, one, ())


def _told(p: Parser, i: int, j: int, pair: tuple[str, str]) -> Results[OrderBy]:
    """The second kind behind the first one, and behind each its own order."""
    for k in _AFTER[pair[1]].matches(p, j):
        yield from _each(p, i, k, pair[0], pair)
    for own, m in _sorted(p, j):
        for k in _AFTER[pair[1]].matches(p, m):
            for two, end in _sorted(p, k):
                yield OrderBy(by=f"{pair[0]}_first", items=(own, two), values=pair, span=p.span(i, end)), end


def _each(p: Parser, i: int, k: int, one: str, pair: tuple[str, ...]) -> Results[OrderBy]:
    """ "(the vowels first,) each kind in alphabetical order"; without such words the order inside is left open."""
    inner = [found for j in (*_EACH.matches(p, k), *_COMMA.matches(p, k)) for found in _sorted(p, j)]
    for own, end in inner:
        yield OrderBy(by=f"{one}_first", items=(own, own), values=pair, span=p.span(i, end)), end
    if not inner:
        yield OrderBy(by=f"{one}_first", values=pair, span=p.span(i, k)), k


def _sorted(p: Parser, i: int) -> Results[OrderBy]:
    """ "in alphabetical order", "from small to large"."""
    for found, k in order(p, i):
        if isinstance(found, OrderBy) and found.by in _INNER and found.first is None:
            yield found, k
