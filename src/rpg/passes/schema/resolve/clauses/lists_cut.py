""" "Line up A, B and C, standing on the mat", "two towers of red and blue blocks in the left half": a list is one, and
what is said behind it is not of its last item alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    Traits,
    parts_of,
)
from rpg.passes.schema.resolve.things.world import refuse, which_one


def check_lists(chains: tuple[Chain, ...], text: str) -> None:
    """Refuse a reading that cuts a list in two."""
    for chain in chains:
        for one in (part for part in parts_of(chain) if isinstance(part, Coord)):
            _check_looks(one, text)
        for clause in chain.clauses:
            _check_either(clause, text)
            _check_beside_it(clause, text)
            _check_sides(clause)
            _check_one_more(clause, text)
            _check_comma(clause, text)
            _check_standing(clause, text)
        for built in (part for part in parts_of(chain) if isinstance(part, Structure | Clause)):
            _check_none(built)
        for order in (part for part in parts_of(chain) if isinstance(part, OrderBy)):
            _check_count(order, text)
        for head, rest in _cuts(chain):
            between = text[head.span[1] : rest.span[0]].strip(" ,")
            finite = text[rest.span[1] :].lower().split()[:1] in _FINITE
            listed = _in_a_list(head, rest, text)
            cut = ((_open(head, text) or listed) and not finite) or _goes_on(head, rest, text)
            joined = between in ("and", "&") or (between == "" and listed)
            if joined and cut and not _ordered(rest, text):
                raise refuse("ambiguous", "it is not clear whether this is said of all that is listed, or of the last",
                             rest.span, "say it in a sentence of its own")  # fmt: skip


def _check_looks(listed: Coord, text: str) -> None:
    """Refuse "a red and blue tower" as of a red block, and a blue tower."""
    for one, other in pairwise(listed.items):
        if not isinstance(one, Noun) or not isinstance(other, Structure) or other.plural or other.det != "bare":
            continue
        if one.head == "any" and one.det == "a" and text[one.span[1] : other.span[0]].strip() == "and":
            raise refuse("ambiguous", "are these two looks of one thing, or two things?", one.span,
                         "say 'block' behind the first, and 'a' ahead of the second")  # fmt: skip


def _check_none(built: Structure | Clause) -> None:
    """Refuse "a tower of green blocks, no red one on ..." as built of these and of none."""
    listed = built.members if isinstance(built, Structure) else built.theme if built.verb == "build" else None
    denied = [isinstance(x, Noun) and x.det == "no" for x in listed.items] if isinstance(listed, Coord) else []
    if isinstance(listed, Coord) and listed.op == "and" and any(denied) and not all(denied):
        none = listed.items[denied.index(True)]
        raise refuse("misplaced", "none is no part of a list", none.span, "say it in a sentence of its own")


def _check_one_more(clause: Meaning, text: str) -> None:
    """Refuse "... behind a row of three red blocks and the X block right of it" as behind a row with the X in it."""
    places = [x for x in clause.adjuncts if isinstance(x, Loc)] if isinstance(clause, Clause) else []
    for one, other in pairwise(places):
        last = _last_listed(one, text)
        if last is not None and not text[one.span[1] : other.span[0]].strip():
            raise which_one("this could be one of those before it, or what is placed there", last.span,
                            "say it in a sentence of its own")  # fmt: skip


def _last_listed(place: Loc, text: str) -> Noun | None:
    """What ends the list that something is placed to, if it may as well be a block that is placed itself: one block
    behind "and", or a list that had its "and" before; but neither of "both B and C"."""
    if place.rel == "in" or " both " in text[slice(*place.span)]:
        return None
    mark = place.landmark.members if isinstance(place.landmark, Structure) else place.landmark
    joined = isinstance(mark, Coord) and mark.op == "and"
    last = mark.items[-1] if isinstance(mark, Coord) and joined else mark
    if not isinstance(last, Noun):
        return None
    several = len(last.traits.labels or last.traits.colors) > 1
    ended = several and _ends_ahead(last, text, placed=True)
    return last if ended or (joined and not last.plural) else None


def _check_comma(clause: Meaning, text: str) -> None:
    """Refuse "A is left of B and C, and D is left of A" as of "A left of B" and "C and D left of A"."""
    theme = clause.theme if isinstance(clause, Clause) else None
    if theme is not None and _ends_ahead(theme, text):
        raise which_one("a list ends ahead of this, or here?", theme.span, "say it in two sentences")


def _ends_ahead(told: Meaning, text: str, placed: bool = False) -> bool:
    """ "(A is left of B and) C, and D": the comma ends a list that has its "and", so that this is none. `placed`: other
    places follow, of which the last may be the block."""
    begin, end = told.span
    comma = re.search(r",\s+and\b", text[begin:end])
    ahead = text[:begin].rstrip()
    inside = comma is not None and re.search(r"\band\b", text[begin : begin + comma.start()])
    joined = re.search(r"[^,]\s+and$", ahead)
    return comma is not None and bool(joined or (inside and (placed or ahead.endswith(","))))


_OPPOSITE = ({"left", "right"}, {"front", "back"}, {"top", "bottom"})


def _check_sides(clause: Meaning) -> None:
    """Refuse "with a vowel on the left and on the right" as a vowel on the left, and everything on the right."""
    parts = clause.adjuncts if isinstance(clause, Clause) else ()
    placed = [(x.adjuncts[0] if isinstance(x, Absolute) else x, isinstance(x, Absolute)) for x in parts]
    for (one, inside), (other, told) in pairwise(placed):
        if (
            inside
            and not told
            and isinstance(one, At)
            and isinstance(other, At)
            and {one.side, other.side} in _OPPOSITE
        ):
            raise refuse("misplaced", "what this is said of is not clear", other.span, "say it of each side")


def _check_standing(clause: Meaning, text: str) -> None:
    """Refuse "four towers, each two high, stand in a row" as an order to stand something else there."""
    if not isinstance(clause, Clause) or clause.lemma not in _STANDING or clause.theme is not None:
        return
    told = text[: clause.span[0]].rstrip().endswith(" to") or text[slice(*(clause.word or (0, 0)))].endswith("s")
    if clause.mode == "command" and not told:
        raise refuse("misplaced", "it is not said what stands there", clause.span, "say it in a sentence of its own")


_STANDING = ("stand", "sit", "lie", "rest")


def _check_count(order: OrderBy, text: str) -> None:
    """Refuse "a tower: red, three blocks" as of a red block and three others: it may be of three in all."""
    for one, last in pairwise(order.items[-2:]):
        counted = isinstance(last, Noun) and last.amount is not None and last.head == "block" and last.det == "bare"
        bare = counted and isinstance(last, Noun) and last.traits == Traits() and not last.conditions
        if bare and text[one.span[1] : last.span[0]].strip() == ",":
            raise refuse("ambiguous", "so many in all, or so many more?", last.span, "say which blocks these are")


def _check_either(clause: Meaning, text: str) -> None:
    """Refuse "a blue block next to the red one, or a green one" as of what it is next to: it may be green itself."""
    theme = clause.theme if isinstance(clause, Clause) else None
    last = theme.items[-1] if isinstance(theme, Coord) else theme
    marks = [x.landmark for x in clause.adjuncts if isinstance(x, Loc)] if isinstance(clause, Clause) else []
    for mark in marks if isinstance(last, Noun) and last.det == "a" else ():
        if not isinstance(mark, Coord) or mark.op != "or" or len(mark.items) != 2:
            continue
        known, other = mark.items
        definite = isinstance(known, Pronoun) or getattr(known, "det", "") == "the"
        apart = text[known.span[1] : other.span[0]].strip().startswith(",")
        if definite and apart and isinstance(other, Noun) and other.det == "a":
            raise refuse("ambiguous", "is this the other one, or what it is next to?", other.span,
                         "say 'a blue or a green block ...'")  # fmt: skip


def _check_beside_it(clause: Meaning, text: str) -> None:
    """Refuse "a row of red blocks, a yellow block, and a white block behind it" as a row with two blocks behind it."""
    listed = clause.theme.items if isinstance(clause, Clause) and isinstance(clause.theme, Coord) else ()
    marks = [x.landmark for x in clause.adjuncts if isinstance(x, Loc)] if isinstance(clause, Clause) else []
    behind_it = len(listed) > 2 and any(isinstance(x, Pronoun) and x.word == "it" for x in marks)
    apart = behind_it and isinstance(listed[0], Structure) and isinstance(listed[1], Noun)
    if apart and text[listed[0].span[1] : listed[1].span[0]].strip() == ",":
        raise refuse("ambiguous", "is this one of the blocks before it, or beside them?", listed[1].span,
                     "say it in a sentence of its own")  # fmt: skip


_FINITE = (["is"], ["are"], ["should"], ["must"], ["has"], ["goes"], ["stands"], ["lies"])
"""What is said of the last one alone behind these."""


def _ordered(rest: Noun, text: str) -> bool:
    """ "Line up A, B and C in alphabetical order": an order is that of them all."""
    words = text[rest.span[1] :].lower().split()
    return words[:1] == ["in"] and "order" in words[1:4]


def _cuts(chain: Chain) -> Iterator[tuple[Noun, Noun]]:
    """What stands last in a clause, with what the words behind it are said of."""
    for link, (clause, after) in zip(chain.links[1:], pairwise(chain.clauses), strict=True):
        first = _first(after.theme) if isinstance(after, Clause) else None
        if link == "and" and isinstance(after, Clause) and first is not None and _told_short(after):
            yield from ((head, first) for head in _last(clause))
    for clause in chain.clauses:
        for part in clause.adjuncts if isinstance(clause, Clause) else ():
            if isinstance(part, Absolute) and isinstance(part.theme, Noun) and isinstance(clause, Clause):
                yield from ((head, part.theme) for head in _last(clause.theme))
        theme = clause.theme if isinstance(clause, Clause) else None
        items = theme.items if isinstance(theme, Coord) and theme.op == "and" else ()
        for one, other in pairwise(items):
            if isinstance(one, Structure) and isinstance(other, Noun):
                yield from ((head, other) for head in _last(one))


def _first(told: Meaning | None) -> Noun | None:
    """The noun with which some words begin."""
    first = told.items[0] if isinstance(told, Coord) else told
    return first if isinstance(first, Noun) else None


def _told_short(clause: Clause) -> bool:
    """A clause without a verb, or with a participle for one: "blue blocks in front", "C standing on the mat"."""
    return clause.theme is not None and clause.verb != "part" and clause.span[0] == clause.theme.span[0]


def _last(told: Meaning | None) -> Iterator[Noun]:
    """The noun with which some words end."""
    nouns = [part for part in parts_of(told) if isinstance(part, Noun)] if told is not None else []
    end = max((noun.span[1] for noun in nouns), default=0)
    yield from [noun for noun in nouns if noun.span[1] == end][-1:]


def _open(head: Noun, text: str) -> bool:
    """ "A, B": a list whose last item has not come yet."""
    named = len(head.traits.labels) > 1 or len(head.traits.colors) > 1
    return named and "," in text[slice(*head.span)] and " and " not in text[slice(*head.span)]


def _in_a_list(head: Noun, rest: Noun, text: str) -> bool:
    """ "(a row of red,) blue" and "green": the same by single words."""
    bare = all((x.det, x.amount, x.plural, bool(x.conditions)) == ("bare", None, False, False) for x in (head, rest))
    return bare and text[: head.span[0]].rstrip().endswith(",")


def _goes_on(head: Noun, rest: Noun, text: str) -> bool:
    """ "red" and "blue blocks", whose noun is for both."""
    alike = head.head == "any" and head.det == "bare" and head.amount is None and bool(head.traits.colors)
    plain = head.traits == Traits(colors=head.traits.colors)
    words = text[slice(*rest.span)].lower().split()
    bare = rest.head == "block" and rest.det == "bare" and bool(words) and words[0] in lexicon.COLOR
    several = rest.plural or any(lexicon.BLOCK.get(word.strip(",")) for word in words)
    return alike and plain and bare and several and bool(rest.traits.colors)
