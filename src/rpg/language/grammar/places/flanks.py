"""Blocks on two sides of another one: "a white block on either side of it", "to the left and right of it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Loc, Pronoun, TableTop

_SIDES = {
    **{
        f"{at} {sides}": "sides"
        for at in ("on", "at", "to")
        for sides in ("either side", "both sides", "both its sides", "two opposite sides", "opposite sides")
    },
    **{f"{at} {sides}": "each" for at in ("on", "at", "to") for sides in ("each side", "each of its sides")},
}  # fmt: skip
_ACROSS = {
    **{
        f"{to}left and {again}right{side}": "across"
        for to, agains in (("", ("",)), ("on the ", ("", "the ", "on the ")), ("to the ", ("", "the ", "to the ")),
                           ("on its ", ("", "its ", "on its ")), ("to its ", ("", "its ", "to its ")),
                           ("both ", ("",)), ("both on the ", ("on the ",)), ("both to the ", ("to the ",)))
        for again in agains
        for side in ("", " side", " sides")
    },
    "in front of and behind": "deep", "both in front of and behind": "deep", "in front and behind": "deep",
}  # fmt: skip
_ONE_EACH = {
    **{f"one {phrase}": "one" for phrase in _SIDES},
    **{
        f"one {to}left {joint} {rest} {to}right": "across"
        for to in ("", "on the ", "to the ", "on its ", "to its ")
        for joint, rest in (("and", "one"), (",", "one"), ("and", "the other"), (",", "the other"), ("and", "another"))
    },
    "one in front and one behind": "deep", "one in front of and one behind": "deep",
    "one in front and the other behind": "deep",
}  # fmt: skip
"""Of two blocks that were named, where each is."""
_BESIDE = {**_SIDES, **_ACROSS, **_ONE_EACH}


@choice
def flanking(p: Parser, i: int) -> Results[Loc]:
    """One block on one side of a landmark and one on the other; without a landmark, of what "it" is."""
    for phrase, j in p.standing(i, _BESIDE):
        mods = (_BESIDE[phrase], *(("one",) if phrase.startswith("one ") or "opposite" in phrase else ()))
        named = j if phrase.endswith("behind") else p.one(j, "of")
        for mark, k in simple(p, named) if named else ():
            if not isinstance(mark, TableTop):
                yield Loc(rel="flank", landmark=mark, mods=mods, span=p.span(i, k)), k
        if (not named or phrase.endswith("behind")) and p.words[j] != "of":
            it = Pronoun(word="it", span=p.span(i, j))
            yield Loc(rel="flank", landmark=it, mods=mods, span=p.span(i, j), cost=1), j
