"""Where things are: relations to landmarks, regions of the table, distances."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.across import across
from rpg.language.grammar.places.against import against_side
from rpg.language.grammar.places.any_depth import how_far
from rpg.language.grammar.places.compared import compared
from rpg.language.grammar.places.diagonals import diagonal
from rpg.language.grammar.places.flanks import flanking
from rpg.language.grammar.places.measures import bounds, limited, measured, measured_bare, measured_so
from rpg.language.grammar.places.near_enough import close_by, near_enough
from rpg.language.grammar.places.nearer_one import nearer_one
from rpg.language.grammar.places.offsets import centred_on
from rpg.language.grammar.places.other_side import other_side
from rpg.language.grammar.places.outside import neither, outside
from rpg.language.grammar.places.prepositions import CLOSE, DIRECT, relation
from rpg.language.grammar.places.regions import quarter, region
from rpg.language.grammar.places.side_lengths import side_length
from rpg.language.grammar.places.sides import OVER
from rpg.language.grammar.places.two_relations import and_from, either_relation, not_but
from rpg.language.grammar.places.where_was import where_was
from rpg.language.grammar.places.whose import whose
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, In, Loc, Meaning, Noun, PartOf, Pronoun, Structure, TableTop, replace

_COMPARED = frozenset({"more", "less", "farther", "further", "closer", "nearer"})
""" "Not more than 10 cm from" is a measure, and denies no place."""


_NOWHERE = ("nowhere", "not anywhere", "not at all", "in no way", "by no means")
"""Stronger than "not"."""
_RATHER = ("rather than", "instead of", "as opposed to", "and definitely not", "and certainly not")
"""Behind a place these deny another one: "to the left of it rather than to its right"."""


THERE = frozenset({"in", "on", "at", "onto", "into", "near", "next", "beside", "behind", "by"})
"""What these may stand before without saying more: "over in the left half", "up on the blue one"."""


@rule
def loc(p: Parser, i: int) -> Results[Meaning]:
    """One statement of place, perhaps negated; "still on the mat" is where the one before is, too."""
    if k := p.one(i, "still"):
        yield from _loc(p, k)
        return
    if (k := p.one(i, OVER)) and p.stands(k, THERE):
        yield from _loc(p, k)
    yield from not_but(p, i)
    j = p.any_of(i, _NOWHERE) or p.one(i, "not") or (p.any_of(i, _RATHER) if i else 0)
    if j and p.stands(j, _COMPARED):
        j = 0
    for found, k in _loc(p, j or i):
        if j and isinstance(found, Loc | Coord):
            if isinstance(found, Coord):
                parts = tuple(replace(x, negated=True) for x in found.items if isinstance(x, Loc))
                yield Coord(op="and" if found.op == "or" else "or", items=parts, span=p.span(i, k)), k
                continue
            if found.rel == "beside" and p.words[i] in _INSTEAD and not _SIDED.isdisjoint(p.words[:i]):
                continue  # "in front of it rather than next to it": not at its side, or not so near?
            some = ("not all",) * (p.words[j] == "all" and getattr(found.landmark, "word", "") == "each other")
            yield replace(found, negated=True, mods=(*found.mods, *some), span=p.span(i, k)), k
        elif not j:
            yield found, k
            yield from and_from(p, i, found, k)
    if j:
        for found, k in region(p, j):
            yield replace(found, negated=True), k


_SIDED, _INSTEAD = frozenset({"left", "right", "front", "behind"}), frozenset({"rather", "instead", "as"})
_SPOTS = ("to a spot", "to a place", "to a position", "in a spot", "in a place", "at a spot", "in a position",
    "to the spot", "at a point", "to a point", "at the spot", "to the place", "to a location", "at a location",
          "in the spot", "to the position", "in the position")  # fmt: skip


_AFTER_THERE = frozenset({",", ";", "too", "as", "instead", "at", "and", "then", ")", "now", "first", "initially"})
"""What may follow "there" where it is a place: the patch spoken of."""


@rule
def _loc(p: Parser, i: int) -> Results[Meaning]:
    if j := p.any_of(i, _SPOTS):
        yield from _loc(p, j)
    yield from (*region(p, i), *quarter(p, i))
    yield from measured(p, i)
    yield from limited(p, i)
    yield from centred_on(p, i)
    yield from outside(p, i)
    yield from neither(p, i)
    yield from whose(p, i)
    yield from flanking(p, i)
    yield from diagonal(p, i)
    yield from (*across(p, i), *where_was(p, i))
    yield from compared(p, i)
    for (name, mods), j in relation(p, i):
        beside = name == "beside" and p.words[j - 1] == "by"
        if beside and (p.figure(j) is not None or p.words[j] in _SORTED_BY or not _HELD.isdisjoint(p.words[:i])):
            continue
        ends = p.words[i + 1 : j] == ["the", "top", "of"] and p.words[i] == "at"
        for landmark, k in noun_phrase(p, j):
            if ends and isinstance(landmark, Structure) and landmark.det == "a":
                continue
            if isinstance(landmark, PartOf) and landmark.part in ("left", "right") and p.words[j - 1] in ("on", "onto"):
                continue  # on top of the last block of a row, or beside it?
            if isinstance(landmark, Structure) and p.tokens[i].joined:  # "a red-on-blue tower"
                continue
            if name == "in" and isinstance(landmark, Pronoun) and landmark.word == "all":  # "four in all"
                continue
            if isinstance(landmark, TableTop) and p.words[i:j] == ["to"]:
                yield Loc(rel="on", landmark=landmark, mods=mods, span=p.span(i, k), cost=1), k
            if isinstance(landmark, TableTop) and name not in ("on", "off", "above", "behind", "front"):
                continue
            if isinstance(landmark, TableTop) and (name == "in" or p.words[i] in ("at", "to")):
                continue
            cost = (
                _listed_cost(landmark)
                + (5 if _stopped(p, landmark, j, k) else 0)
                + (1 if p.words[i] == "side" and p.words[j - 1] == "with" else 0)
                + (2 if name == "in" or p.words[i] == "by" else 0)
            )
            if isinstance(landmark, Noun) and (landmark.det, landmark.amount) == ("some", None):
                landmark = replace(landmark, det="a", plural=False) if _of_one_look(landmark) else landmark
            placed = Loc(rel=name, landmark=landmark, mods=mods, span=p.span(i, k), cost=cost)
            yield placed, k
            if same := p.any_of(k, _SAME_TOWER) if name in ("above", "under") else 0:
                yield replace(placed, span=p.span(i, same)), same
            yield from how_far(p, i, k, placed)
    if (j := p.any_of(i, _THERE)) and (j >= p.end or p.words[j] in _AFTER_THERE):
        yield Loc(rel="on", landmark=Pronoun(word="there", span=p.span(i, j)), span=p.span(i, j)), j
    yield from either_relation(p, i)
    yield from against_side(p, i)
    yield from near_enough(p, i)
    yield from other_side(p, i)
    yield from _either_place(p, i)
    yield from _between_two(p, i)
    yield from _possessive(p, i)
    yield from _bare(p, i)


_THERE = ("in there", "on there", "onto there", "into there", "over there", "right there", "there")
_SAME_TOWER = tuple(f"{of} same {tower}" for of in ("in the", "of the", "in") for tower in ("tower", "stack", "pile"))
"""Where everything is that is above another."""


def _of_one_look(mark: Noun) -> bool:
    """ "on some red", "next to some red block": on any one of them."""
    plain = mark.head == "any" or not mark.plural
    return plain and mark.part_of is None and not mark.conditions and len(mark.traits.colors) == 1


_SORTED_BY = frozenset(
    {"letter", "letters", "number", "numbers", "digit", "digits", "label", "symbol", "kind", "type", "size", "value"}
)
"""Behind "by" these are no landmarks: "groups by letter"."""
_HELD = frozenset({"carried", "supported", "borne", "topped", "covered", "crowned"})
"""Behind these a further "by" tells once more by what: "carried by the red one first, and then by the blue one"."""


@choice
def _either_place(p: Parser, i: int) -> Results[Meaning]:
    """ "either left of the red block or behind the blue one"."""
    start = p.one(i, "either")
    for first, j in _loc(p, start) if start else ():
        k = p.one(j, "or")
        for second, end in _loc(p, k) if k else ():
            if isinstance(first, Loc) and isinstance(second, Loc):
                yield Coord(op="or", items=(of_one_kind(first, second), second), span=p.span(i, end)), end


def of_one_kind(first: Meaning, second: Meaning) -> Meaning:
    """ "(either on the red) or on the blue patch": the first of them is on a patch, too."""
    if not isinstance(first, Loc) or not isinstance(second, Loc) or first.rel != second.rel:
        return first
    one, other = first.landmark, second.landmark
    alike = isinstance(one, Noun) and isinstance(other, Noun) and one.head == "any" and one.det == other.det != "bare"
    if not alike or not isinstance(one, Noun) or not isinstance(other, Noun) or other.head != "patch":
        return first
    like_it = not one.traits.colors or other.traits.colors  # not "on the blue one or on the mat"
    return replace(first, landmark=replace(one, head="patch")) if like_it else first


def on_its_own(place: Meaning) -> bool:
    """ "(red and blue each) on a mat of its own", "... on the mat of its colour", "... on a white block"."""
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" else None
    if not isinstance(mark, Noun) or mark.head != "patch":
        told = isinstance(place, In) and place.region not in ("corner", "edge")
        return told or (isinstance(mark, Noun) and (mark.head, mark.det) == ("block", "a"))
    return mark.traits.scheme == "different" or mark.traits.matching


@choice
def _between_two(p: Parser, i: int) -> Results[Meaning]:
    """A place between others, with what it is closer to."""
    for found, j in _between(p, i):
        yield found, j
        yield from nearer_one(p, j, i, found) if isinstance(found, Loc) else ()


@choice
def _between(p: Parser, i: int) -> Results[Meaning]:
    mods: tuple[str, ...] = ()
    j = i
    if p.words[j : j + 1] and p.words[j] in ("directly", "exactly", "right", "somewhere"):
        mods, j = (("somewhere",) if p.words[j] == "somewhere" else ("directly",)), p.reach(j + 1)
    j = p.opt(j, "strictly")
    name = "between"
    k = p.any_of(j, ("in between", "in the middle of", "midway between", "halfway between", "between",
                     "in the middle between", "in the space between", "in the center of", "centered between",
                     "collinear between", "in the gap between", "among"))  # fmt: skip
    if not k:
        k = p.any_of(j, ("sandwiched between", "sandwiched in between", "sandwiched by"))
        name = "sandwiched"
    if k and p.words[j] in ("midway", "halfway", "centered", "collinear"):
        mods = ("collinear",) if p.words[j] == "collinear" else ("halfway",)
    elif p.any_of(j, ("in the middle between",)):
        mods = ("middle",)
    if k:
        for landmark, end in noun_phrase(p, k):
            if isinstance(landmark, TableTop):
                continue
            told = p.words[k:end]  # "in between C, and D on C": two are seldom joined so
            cost = _APART * (told.count(",") == 1 and told[told.index(",") + 1] == "and")
            yield Loc(rel=name, landmark=landmark, mods=mods, span=p.span(i, end), cost=cost), end


_APART = 4
"""How unlikely it is that a comma and an "and" join the two that something is between."""


@choice
def _possessive(p: Parser, i: int) -> Results[Meaning]:
    """ "on its left", "to its right", "on the blue block's left side"."""
    close = p.one(i, frozenset((*DIRECT, *CLOSE, "somewhere")))
    j = p.any_of(close or i, ("on", "to", "at"))
    if not j:
        return
    loose = "somewhere" if p.words[i] == "somewhere" else "directly"
    mods = () if not close else ("immediate",) if p.words[i] in CLOSE else (loose,)
    if k := p.one(j, ("its", "their")):
        owners: list[tuple[Meaning, int]] = [
            (Pronoun(word="it" if p.words[j] == "its" else "them", span=p.span(j, k)), k)
        ]
    else:
        owners = [(o, p.one(k, "'s")) for o, k in noun_phrase(p, j) if p.one(k, "'s")]
    for owner, k in owners:
        if nearest := p.one(k, ("immediate", "direct")):
            mods, k = ("immediate",) if p.words[k] == "immediate" else ("directly",), nearest
        for word, name in (
            ("left", "left"),
            ("right", "right"),
            ("front", "front"),
            ("back", "behind"),
            ("top", "on"),
            ("side", "beside"),
        ):
            if end := p.one(k, word):
                end = p.any_of(end, ("hand side", "side")) or end
                near = mods if name not in ("on", "beside") else ()
                yield Loc(rel=name, landmark=owner, mods=near, span=p.span(i, end)), end


@choice
def _bare(p: Parser, i: int) -> Results[Meaning]:
    """Relations whose landmark is left unsaid: "nearby", "apart", "side by side"."""
    yield from (*measured_bare(p, i), *side_length(p, i), *close_by(p, i))
    for phrase, j in p.standing(i, _UNSAID) if not _on_two_patches(p, i) else ():
        if phrase == "touching" and p.stands(j, ("it", "them")):
            continue  # "not touching it": no landmark is left unsaid
        landmark = Pronoun(word="them" if _UNSAID[phrase] == "between" else "each other", span=p.span(i, j))
        yield Loc(rel=_UNSAID[phrase], landmark=landmark, span=p.span(i, j)), j
        if _UNSAID[phrase] == "apart" and p.stands(j, (",", ":")):
            for (low, high), k in bounds(p, j + 1):
                far = Loc(rel="distance", landmark=landmark, low=low, high=high, span=p.span(i, k))
                yield from measured_so(p, far, i, k)


def _on_two_patches(p: Parser, i: int) -> bool:
    """ "Two on one patch and one on the other": a further block on a further patch, and no tower."""
    joined = p.stands(i, ("one",)) and p.follows(i, ("and", ","))
    if not joined or i <= 2 or p.words[i - 2] not in lexicon.PATCH:
        return False
    return p.words[i - 3] == "one" or (p.words[i - 3] == "a" and p.words[i - 1] == "and")


_UNSAID = {
    "side by side": "side_by_side", "next to each other": "side_by_side", "beside each other": "side_by_side",
    "adjacent to each other": "adjacent", "next to one another": "side_by_side",
    "beside one another": "side_by_side",
    "by itself": "apart", "all by itself": "apart",
    "well away from each other": "apart", "well apart": "apart", "well separated": "apart", "wide apart": "apart",
    "well away from one another": "apart", "clearly apart": "apart", "clearly separated": "apart",
    "far apart": "apart", "apart": "apart", "far away from each other": "apart", "separated": "apart",
    "away from each other": "apart", "away from one another": "apart", "far apart from one another": "apart",
    "far away from one another": "apart", "apart from one another": "apart",
    "apart from each other": "apart", "far apart from each other": "apart", "separately": "apart",
    "close together": "near", "together": "together", "near each other": "near",
    "close to each other": "near",
    "touching": "touching", "in contact": "touching", "into contact": "touching",
    "adjacent": "adjacent", "nearby": "near", "flush": "touching", "flush with each other": "touching",
    "neighbors": "side_by_side", "direct neighbors": "adjacent", "immediate neighbors": "adjacent",
    "shoulder to shoulder": "side_by_side", "in one place": "together", "spread out": "apart",
    "touching each other": "touching", "touching one another": "touching", "all touching": "touching",
    "all touching each other": "touching", "all touching one another": "touching",
    "in contact with each other": "touching", "into contact with each other": "touching",
    "right next to each other": "adjacent", "immediately next to each other": "adjacent",
    "directly next to each other": "adjacent",
    "on top of each other": "heaped", "on top of one another": "heaped", "one on top of the other": "heaped",
    "one on top of another": "heaped", "on each other": "heaped", "one upon another": "heaped",
    "one over the other": "heaped",
    "one above the other": "heaped", "one atop the other": "heaped", "atop each other": "heaped",
    "atop one another": "heaped",
    "one on the other": "heaped", "on one another": "heaped", "one on another": "heaped",
    "on top of itself": "heaped",
    "each on top of the other": "heaped", "on top of each": "heaped",
    "one by one on top of each other": "heaped",
    "all on top of each other": "heaped", "upon each other": "heaped", "one upon the other": "heaped",
    "one next to the other": "side_by_side", "one beside the other": "side_by_side",
    "each next to the other": "side_by_side",
    "in between": "between", "between them": "between", "in between them": "between",
    "between the two": "between", "in the space between them": "between",
    "one in front of the other": "one_behind", "one behind the other": "one_behind",
    "one row behind the other": "one_behind", "one row in front of the other": "one_behind",
    "one behind another": "one_behind",
    **{
        f"{so}{their}{sides} {touch}": "touching"
        for so, touches in (("with ", ("touching", "in contact", "flush")), ("", ("touching", "in contact", "flush")),
                            ("so that ", ("touch", "are touching", "are in contact")),
                            ("such that ", ("touch", "are touching")))
        for touch in touches
        for their in (("their ", "the ", "") if "that" not in so else ("their ", "the "))
        for sides in ("sides", "faces", "side faces", "edges")
    },
    "with touching sides": "touching", "with touching faces": "touching",
}  # fmt: skip


def _stopped(p: Parser, landmark: Meaning, j: int, k: int) -> bool:
    """ "8, and 9": behind a comma, "and" begins another clause rather than the second of two symbols."""
    two = isinstance(landmark, Noun) and len(landmark.traits.labels) == 2
    return two and p.words[k - 3 : k - 1] == [",", "and"] and j < k - 3


def _listed_cost(landmark: Meaning) -> int:
    """A list as a landmark is less natural than a clause that begins with its last item."""
    if isinstance(landmark, Coord):
        return 1 if landmark.op == "and" else 0
    if not isinstance(landmark, Noun):
        return 0
    return (
        1
        if (landmark.head == "any" and len(landmark.traits.colors) > 1)
        or (landmark.det == "bare" and len(landmark.traits.labels) > 1)
        else 0
    )
