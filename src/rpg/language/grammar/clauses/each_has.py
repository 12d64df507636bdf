"""What each of several has, or none of them: "every red block has a blue one beside it", "no block has one on it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.things.retold import none_of
from rpg.language.meaning import Loc, Meaning, Noun, replace

_TURNED = {"beside": "beside", "adjacent": "adjacent", "touching": "touching", "near": "near", "left": "right",
           "right": "left", "front": "behind", "behind": "front"}  # fmt: skip
"""How the owner stands to what it has, by how that stands to the owner."""
_MAY = ("may have", "can have", "is allowed to have", "are allowed to have", "is to have")


def may_have(p: Parser, owner: Meaning, j: int) -> int:
    """ "(no red block) may have (a blue one on it)": the position behind it, where it is denied of all."""
    return p.any_of(j, _MAY) if none_of(owner) else 0


def said_of_each(theme: Meaning, places: tuple[Meaning, ...], owner: Meaning) -> tuple[Meaning, tuple[Meaning, ...]]:
    """Who is where: told of so many owners, each of them has one of these, which others may have too."""
    place = places[0] if len(places) == 1 else None
    if not isinstance(place, Loc) or not isinstance(owner, Noun) or not isinstance(theme, Noun):
        return theme, places
    several = owner.det in ("each", "all", "no", "both") or (owner.amount is not None and owner.amount.strict)
    if owner.head == "patch" or not several or theme.det not in ("a", "bare", "any", "some"):
        return theme, places
    if theme.head == "patch" or (theme.amount is None and theme.det == "bare") or len(theme.traits.labels) == 1:
        return theme, places
    told = _TURNED.get(place.rel)
    if place.rel == "on" and owner.det not in ("each", "all", "both"):
        told = "under"
    if told is None:
        return theme, places
    mods = ("directly",) if told == "under" else place.mods
    return owner, (replace(place, rel=told, landmark=theme, mods=mods),)
