"""What each of several has, or none of them: "every red block has a blue one beside it", "no block has one on it"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.grammar.things.retold import none_of
from rpg.language.meaning import At, Clause, Loc, Meaning, Noun, PartOf, Pronoun, replace

_TURNED = {"beside": "beside", "adjacent": "adjacent", "touching": "touching", "near": "near", "left": "right",
           "right": "left", "front": "behind", "behind": "front"}  # fmt: skip
"""How the owner stands to what it has, by how that stands to the owner."""
_MAY = ("may have", "can have", "is allowed to have", "are allowed to have", "is to have")

_HAS_NOT = Patterns(
    "shall|should|must|may|can|does|do|will|is_to|are_to not have", "is|are not allowed|supposed to have"
)


def denied(p: Parser, i: int, j: int, owner: Meaning, mode: str) -> Results[Clause]:
    """ "The red block must not have anything on top": nothing is there; "... a green block on it": no green one is."""
    k = max(_HAS_NOT.matches(p, j), default=0)
    for theme, start in noun_phrase(p, k) if k and isinstance(owner, Noun) else ():
        none = _none(theme)
        for found, end in adjuncts(p, start) if none is not None else ():
            place = found[0] if len(found) == 1 else None
            own = isinstance(place, At) and place.side == "top" and place.index is None
            if own or (isinstance(place, Loc) and place.rel == "on" and is_owner(place.landmark)):
                on = Loc(rel="on", landmark=owner, span=p.span(i, j))
                said = Clause(verb="be", theme=none, adjuncts=(on,), mode=mode, span=p.span(i, end), cost=1)
                yield replace(said, subject=owner), end


def _none(theme: Meaning) -> Meaning | None:
    """ "anything" as nothing, "a green block" as no green block."""
    if isinstance(theme, Pronoun) and theme.word == "anything":
        return replace(theme, word="nothing")
    if isinstance(theme, Noun) and theme.det in ("a", "any") and theme.head != "patch":
        return replace(theme, det="no", amount=None)
    return None


def is_owner(landmark: Meaning | None) -> bool:
    """ "on it", "on top (of it)" said of what has it."""
    if isinstance(landmark, PartOf) and landmark.part == "top":
        return is_owner(landmark.whole)
    return landmark is None or (isinstance(landmark, Pronoun) and landmark.word in ("it", "them", "itself"))


def may_have(p: Parser, owner: Meaning, j: int) -> int:
    """ "(no red block) may have (a blue one on it)": the position behind it, where it is denied of all."""
    return p.any_of(j, _MAY) if none_of(owner) else 0


def said_of_each(theme: Meaning, places: tuple[Meaning, ...], owner: Meaning) -> tuple[Meaning, tuple[Meaning, ...]]:
    """Who is where: told of so many owners, each of them has one of these, which others may have too."""
    place = places[0] if len(places) == 1 else None
    if isinstance(place, Loc) and isinstance(owner, Noun) and isinstance(theme, Pronoun):
        return _nothing(theme, place, owner)
    if not isinstance(place, Loc) or not isinstance(owner, Noun) or not isinstance(theme, Noun):
        return theme, places
    if owner.head == "patch" or not each_of(owner) or theme.det not in ("a", "bare", "any", "some"):
        return theme, places
    if theme.head == "patch" or (theme.amount is None and theme.det == "bare") or len(theme.traits.labels) == 1:
        return theme, places
    told = _TURNED.get(place.rel)
    so_many = theme.amount is not None and theme.amount.strict and theme.amount.low > 0
    if place.rel == "on" and (so_many or owner.det not in ("each", "all", "both")):
        told = "under"
    if told is None:
        return theme, places
    mods = ("directly",) if told == "under" else place.mods
    return owner, (replace(place, rel=told, landmark=theme, mods=mods),)


def each_of(owner: Meaning) -> bool:
    """Whether what is said of these is said of each of them: of all, of none, or of so many."""
    if not isinstance(owner, Noun):
        return False
    counted = owner.amount is not None and (owner.amount.strict or owner.part_of is not None)
    return owner.det in ("each", "all", "no", "both") or counted


def _nothing(theme: Pronoun, place: Loc, owner: Noun) -> tuple[Meaning, tuple[Meaning, ...]]:
    """ "None of the green blocks has anything on it": nothing is on any of them."""
    if theme.word != "anything" or owner.det != "no":
        return theme, (place,)
    whole = owner.part_of or replace(owner, det="all", plural=True)
    return replace(theme, word="nothing"), (replace(place, landmark=whole),)
