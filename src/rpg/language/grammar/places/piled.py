""" "red on blue on green": each thing lies on the one named next, not all on the first."""

from __future__ import annotations

from rpg.language.grammar.places.onto import single
from rpg.language.meaning import Chain, Clause, Into, Loc, Meaning, Noun, OrderBy, Pronoun, Structure, That, replace


def piled(found: Meaning) -> Meaning:
    """`found` with what its landmark lies on said of the landmark."""
    if not isinstance(found, Clause):
        return found
    if found.lemma == "keep" and found.adjuncts and all(_bunched(part) for part in found.adjuncts):
        bunch = tuple(part for part in found.adjuncts if isinstance(part, Into))
        return replace(found, verb="place", lemma="put", adjuncts=bunch) if bunch else found
    if (each := _each_on_one(found)) is not None:
        return each
    if (tower := _looks_again(found) or _beside_a_tower(found)) is not None:
        return tower
    for index, (first, second) in enumerate(zip(found.adjuncts, found.adjuncts[1:], strict=False)):
        alike = getattr(first, "rel", "") == getattr(second, "rel", "")
        behind = first.span[0] < second.span[0] <= first.span[1] + 1
        if alike and behind and _lies_on(first) and _lies_on(second):
            assert isinstance(first, Loc) and isinstance(first.landmark, Noun)
            theme = replace(first.landmark, det="the", amount=None, cost=0)
            span = (first.landmark.span[0], found.span[1])
            below = Clause(verb="be", theme=theme, adjuncts=found.adjuncts[index + 1 :], mode=found.mode, span=span)
            chain = Chain(clauses=(piled(below),), links=("and",), span=span)
            said = That(kind="so", clauses=chain, span=span)
            return replace(found, adjuncts=(*found.adjuncts[: index + 1], said))
    return found


def _each_on_one(found: Clause) -> Clause | None:
    """ "stack each red block on a blue one": each on one of its own, and not all of them in one tower."""
    theme, places = found.theme, found.adjuncts
    place = places[0] if found.verb == "stack" and len(places) == 1 and not found.negated else None
    if not isinstance(theme, Noun) or theme.det != "each" or not isinstance(place, Loc) or not _lies_on(place):
        return None
    one = place.landmark
    some = isinstance(one, Noun) and one.det == "a" and one.head != "patch"
    return replace(found, verb="place", lemma="put") if some else None


def _looks_again(found: Clause) -> Clause | None:
    """ "red on blue on red": a look that comes again is that of a further block, and all of them form a tower."""
    places = [x for x in found.adjuncts if isinstance(x, Loc) and _lies_on(x) and not x.mods]
    items = (found.theme, *(x.landmark for x in places))
    nouns = [x for x in items if isinstance(x, Noun) and single(x) and x.det != "the"]
    looks = {x.traits for x in nouns}
    if len(nouns) < len(items) or len(places) < len(found.adjuncts) or found.negated or len(looks) in (1, len(nouns)):
        return None
    order = OrderBy(by="named", items=tuple(nouns), first="top", span=found.span)
    tower = Structure(kind="stack", det="a", details=(order,), span=found.span)
    return replace(found, verb="build", lemma="", theme=tower, adjuncts=())


_PUTTING = ("be", "place", "stack", "build")
_BESIDE = frozenset({"left", "right", "front", "behind", "beside", "adjacent"})


def _beside_a_tower(found: Clause) -> Clause | None:
    """ "(red on green,) and next to that tower yellow on brown": it is all of a second tower that stands there."""
    theme, places = found.theme, [x for x in found.adjuncts if isinstance(x, Loc) and not x.negated]
    below = [x for x in places if _lies_on(x) and not x.mods and isinstance(x.landmark, Noun) and single(x.landmark)]
    side = [x for x in places if x.rel in _BESIDE]
    if not isinstance(theme, Noun) or not single(theme) or found.negated or found.verb not in _PUTTING:
        return None
    if len(below) != 1 or len(side) != 1 or len(found.adjuncts) != 2:
        return None
    mark = side[0].landmark
    them = isinstance(mark, Pronoun) and mark.word == "them"  # "put green on yellow to the right of them"
    if side[0].span[0] > below[0].span[0] and not them:
        return None
    tower = isinstance(mark, Structure) and mark.kind == "stack" and mark.det == "the" and not mark.members
    first = side[0].span[0] < theme.span[0] and isinstance(mark, Pronoun) and mark.word in ("it", "that", "them")
    if not (tower or first or them):
        return None
    items = (theme, *(x.landmark for x in below if x.landmark))
    order = OrderBy(by="named", items=items, first="top", span=found.span)
    pile = Structure(kind="stack", det="a", details=(order,), span=found.span)
    return replace(found, verb="build", lemma="", theme=pile, adjuncts=(side[0],))


def _bunched(part: Meaning) -> bool:
    """ "(keep the white blocks) together in one bunch": they are put there."""
    if isinstance(part, Into):
        return isinstance(part.structure, Structure) and part.structure.kind == "pile"
    return isinstance(part, Loc) and part.rel == "together" and not part.negated


def _lies_on(part: Meaning) -> bool:
    upright = isinstance(part, Loc) and part.rel in ("on", "above") and not part.negated
    return upright and isinstance(part, Loc) and isinstance(part.landmark, Noun)
