""" "Put A on the red and B on the blue patch": the noun at the end is that of all the colours before it."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Traits, replace


def patch_in_common(chain: Chain, text: str) -> Chain:
    """The sentence with its bare colours as patches, where a clause of the same make names a patch behind them."""
    clauses = list(chain.clauses)
    for n in reversed(range(len(clauses) - 1)):
        if chain.links[n + 1] in ("and", "or"):
            clauses[n] = _likewise(clauses[n], clauses[n + 1], text)
    return chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses))


def _likewise(one: Meaning, two: Meaning, text: str) -> Meaning:
    place, last = (x.adjuncts[0] if isinstance(x, Clause) and len(x.adjuncts) == 1 else None for x in (one, two))
    if not isinstance(one, Clause) or not isinstance(two, Clause) or one.word != two.word:
        return one
    if not isinstance(place, Loc) or not isinstance(last, Loc) or place.rel != "on" or last.rel != "on":
        return one
    mark, patch = place.landmark, last.landmark
    if not isinstance(mark, Noun) or not isinstance(patch, Noun) or patch.head != "patch":
        return one
    bare = mark.head == "any" and mark.traits == Traits(colors=mark.traits.colors) and len(mark.traits.colors) == 1
    alike = mark.det == patch.det == "the" and bool(patch.traits.colors) and not (mark.plural or patch.plural)
    elliptic = len(text[slice(*mark.span)].split()) == 2 and not text[slice(*mark.span)].lower().endswith("one")
    known = any(re.search(rf"\b{color} (?:block|cube|brick|box)", text, re.IGNORECASE) for color in mark.traits.colors)
    if not (bare and alike and elliptic) or mark.amount is not None or known:
        return one
    return replace(one, adjuncts=(replace(place, landmark=replace(mark, head="patch")),))
