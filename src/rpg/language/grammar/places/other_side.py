""" "On the opposite side of the black one", "on its other side", "on the same side": by a side that was told before."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Loc, Pronoun, TableTop

_WHICH = {
    **{f"{at} the {word} side": "other side" for at in ("on", "to", "at") for word in ("other", "opposite")},
    **{f"{at} the {word} side": "same side" for at in ("on", "to", "at") for word in ("same", "very same")},
}
_ITS = {
    **{f"{at} its {word} side": "other side" for at in ("on", "to", "at") for word in ("other", "opposite")},
    **{f"{at} its {word} side": "same side" for at in ("on", "to", "at") for word in ("same", "very same")},
}
_OWN = {"other": "other side", "opposite": "other side", "same": "same side"}
_SIDE = frozenset({"side"})


@choice
def other_side(p: Parser, i: int) -> Results[Loc]:
    if not p.rarely(_SIDE):
        return
    for phrase, j in p.standing(i, _WHICH):
        of = p.one(j, "of")
        for mark, k in noun_phrase(p, of) if of else ():
            if not isinstance(mark, TableTop):
                yield Loc(rel=_WHICH[phrase], landmark=mark, span=p.span(i, k)), k
        if not of and not p.stands(j, ("as",)):
            yield Loc(rel=_WHICH[phrase], span=p.span(i, j), cost=1), j
    for phrase, j in p.standing(i, _ITS):
        yield Loc(rel=_ITS[phrase], landmark=Pronoun(word="it", span=p.span(i, j)), span=p.span(i, j)), j
    at = p.any_of(i, ("on", "to", "at"))
    for mark, k in noun_phrase(p, at) if at else ():
        owned = p.one(k, "'s")
        which = _OWN.get(p.words[owned]) if owned else None
        end = p.one(owned + 1, "side") if which else 0
        if which and end:
            yield Loc(rel=which, landmark=mark, span=p.span(i, end)), end
