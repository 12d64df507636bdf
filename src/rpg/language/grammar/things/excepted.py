"""What is taken out of a noun phrase: "all blocks but the red one", "nothing but red", "all except A and B"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.retold import none_of, shares_head, universal
from rpg.language.later import later
from rpg.language.meaning import Coord, Meaning, Noun, Pronoun, Structure, TableTop, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import noun_phrase, simple
else:
    noun_phrase, simple = later(__name__, "rpg.language.grammar.things.nouns", "noun_phrase", "simple")


def _of_another_kind(whole: Meaning, out: Meaning) -> bool:
    """ "the letters apart from the digits": these are no exception, for they are none of those."""
    if not isinstance(whole, Noun) or not isinstance(out, Noun) or whole.head == "patch":
        return False
    one, two = whole.traits, out.traits
    told = [(one.kind, two.kind), (one.colors, two.colors), (one.quality, two.quality)]
    return any(a and b and a != b for a, b in told)


NO_MORE = ("and nothing else", "nothing else", "and nothing more", "nothing more", "and no other blocks",
           "and nothing besides", "and that is all", "but nothing else", "no more blocks", "no other blocks",
           "and no more blocks")  # fmt: skip
"""Behind a structure, and at the end of it all: no block is there anyway that is not called for."""


def exceptions(p: Parser, i: int, items: tuple[Meaning, ...], comma: int, op: str | None) -> Results[Coord | Structure]:
    """ "all blocks but the red one", "nothing but the red block", "all the blocks except A and B". `op` joins the
    items: of "red or blue, but not green" nothing is taken."""
    shape = items[0] if len(items) == 1 else None
    alone = p.any_of(comma, NO_MORE) if isinstance(shape, Structure) else 0
    if isinstance(shape, Structure) and alone and (alone >= p.end or p.words[alone] in (",", ";", ":")):
        yield shape, alone
    yield from _but_none_of(p, i, items, comma)
    whole = len(items) == 1 and universal(items[0]) and (taken := _but(items[0])) is not None
    if whole and p.words[comma : comma + 1] == ["but"] and p.words[comma + 1] not in ("not", "only", "first"):
        for item, j in noun_phrase(p, p.reach(comma + 1)):
            item = _of_its_kind(items[0], item)
            named = ("the", "all", "bare") if taken == "none but" and not _so_many(item) else ("the", "all")
            shown = isinstance(item, Noun) and bool(item.traits.labels)
            if isinstance(item, Coord) or (
                isinstance(item, Noun) and not item.part_of and (item.det in named or shown)
            ):
                yield Coord(op=str(taken), items=(*items, item), span=p.span(i, j)), j
    if isinstance(items[0], TableTop):
        return  # "(all go to the left side of) the table except the red one": out of all of them
    if (k := p.any_of(comma, _EXCEPT)) and op != "or" and not any(map(_any_of, items)):
        for item, j in noun_phrase(p, k) if len(items) == 1 else simple(p, k):
            item = _of_its_kind(items[0], item)
            closed = p.opt(j, ",") if p.words[comma - 1] == "," else j
            if p.words[comma] == "apart" and _of_another_kind(items[0], item):
                continue
            if p.words[k] == "that" and p.words[k + 1] != "one" and p.words[k + 1] not in lexicon.BLOCK:
                continue  # "except that yellow is not on top": that is a clause
            if p.words[k - 1] == "not" and _one(items[0]):
                continue
            if p.words[comma] == "without" and not _among(item, items):
                continue
            if (taken := _but(items[0])) is not None and not (universal(items[0]) and _so_many(item)):
                item = _all_such(item) if universal(items[0]) and taken == "except" else item
                parted = len(items) > 1 and isinstance(items[0], Noun) and items[0].part_of is not None
                cost = 2 * (parted or any(map(shares_head, items, items[1:])))  # "red, green and blue cubes" are one
                those = Coord(op=taken, items=(*items, item), span=p.span(i, j), cost=cost)
                yield from ((those, end) for end in {j: None, closed: None})


def _of_its_kind(whole: Meaning, item: Meaning) -> Meaning:
    """ "Any patch but the red one": the red patch."""
    marks = isinstance(whole, Noun) and whole.head == "patch" and universal(whole)
    if marks and isinstance(item, Noun) and item.head == "any":
        return replace(item, head="patch")
    return item


_WITHOUT = ("without using", "without")
_EXCEPT = ("but not", "except for", "except", "other than", "apart from", "and not", "excluding", *_WITHOUT)


def _among(item: Meaning, items: tuple[Meaning, ...]) -> bool:
    """ "the red, green and yellow cubes without the yellow one": one of those that are named."""
    named = [x.traits for x in items if isinstance(x, Noun) and x.head != "patch"]
    looks = {look for traits in named for look in (*traits.colors, *traits.labels)}
    own = (*item.traits.colors, *item.traits.labels) if isinstance(item, Noun) and item.det != "no" else ()
    return len(looks) > 1 and bool(own) and looks.issuperset(own)


def _all_such(item: Meaning) -> Meaning:
    """ "everything except red": all that is red."""
    bare = isinstance(item, Noun) and item.det == "bare" and item.head == "any" and item.amount is None
    if not bare or not isinstance(item, Noun) or item.traits != Traits(colors=item.traits.colors[:1]):
        return item
    return replace(item, head="block", det="all", plural=True) if item.traits.colors else item


def _any_of(item: Meaning) -> bool:
    """ "red, blue or white": any of these."""
    return isinstance(item, Noun) and item.traits.either and not universal(item)


def _one(whole: Meaning) -> bool:
    """ "(red and blue go on) the mat, but not the white one": out of one thing nothing is taken."""
    return isinstance(whole, Noun) and whole.head == "patch" and not (whole.plural or whole.conditions)


def _but(whole: Meaning) -> str | None:
    """ "All but red" are the others; "nothing but red", "no block except red" is red alone; "no A except B", "none of
    them except B" are none of these but it."""
    if isinstance(whole, Pronoun):
        return "only" if whole.word == "nothing" else "none but" if none_of(whole) else "except"
    if not isinstance(whole, Noun) or whole.det != "no":
        return "except"
    plain = whole.traits == Traits() and whole.head == "block" and whole.part_of is None and whole.amount is None
    return "only" if plain else "none but"


def _so_many(item: Meaning) -> bool:
    """ "all the blocks except one": so many of them, whichever these are, as in "all but one of the blocks"."""
    if isinstance(item, Pronoun):
        return item.word == "one"
    mere = isinstance(item, Noun) and item.head == "any" and item.traits == Traits() and item.part_of is None
    return mere and isinstance(item, Noun) and item.det == "bare"


def _but_none_of(p: Parser, i: int, items: tuple[Meaning, ...], comma: int) -> Results[Coord]:
    """ "A but neither of the red blocks", "both letters but no red block": the ones, and not the others."""
    but = p.one(comma, "but") if isinstance(items[0], Noun) and items[0].det not in ("no", "all", "each") else 0
    for item, j in simple(p, but) if p.stands(but, ("none", "neither", "no", "not")) and but else ():
        if not isinstance(item, Noun) or item.det != "no" or item.head == "patch" or item.conditions:
            continue
        those = item.part_of if isinstance(item.part_of, Noun) else replace(item, det="the", amount=None, plural=True)
        for end in {j: None, p.opt(j, ","): None} if p.words[comma - 1] == "," else {j: None}:
            yield Coord(op="except", items=(*items, those), span=p.span(i, j)), end


_THEN = frozenset({"is", "are", "must", "should", "shall", "has", "have", "may", "can", "will"})


def alone_in_this(p: Parser, i: int, one: Meaning, j: int) -> tuple[Meaning, int]:
    """ "The red blocks only (are in a corner)": no others are, as with "only" in front of them."""
    told = isinstance(one, Noun) and one.head != "patch" and one.det in ("the", "bare") and one.amount is None
    if not told or p.words[j : j + 1] != ["only"] or not p.stands(j + 1, _THEN):
        return one, j
    return Coord(op="only", items=(one,), span=p.span(i, j + 1)), j + 1


_NO_OTHER = tuple(
    f"{and_} {other}{ends}"
    for and_ in (", and", ", but", ",", "and")
    for other in ("no other", "no others", "no other one", "no other block", "no other cube", "none of the others",
                  "nothing else", "none other")
    for ends in (" ,", "")
)  # fmt: skip
"""Behind a block: it alone is so."""


def and_no_other(p: Parser, i: int, one: Meaning, j: int) -> Results[Coord]:
    """ "the red block, and no other, (is on the mat)": only the red one."""
    told = isinstance(one, Noun) and one.head != "patch" and not one.plural and one.det in ("the", "bare")
    k = p.any_of(j, _NO_OTHER) if told else 0
    if k and k < p.end and (p.words[k - 1] == ",") == (p.words[j] == ","):
        yield Coord(op="only", items=(one,), span=p.span(i, k)), k
