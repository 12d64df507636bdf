""" "D to the left of the red block and E to the right of it, both touching it": told of each that was put there."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Pronoun, Structure, replace

_EACH = frozenset({"each", "each one", "each of them"})
_BOTH = frozenset({"both", "both of them"})
_PUT = ("place", "be")
_SIDES = frozenset({"left", "right", "front", "behind", "beside", "adjacent", "near"})
_PAIR = 2


def each_beside(chain: Chain) -> Chain:
    """The sentence with what is told last of each of several blocks, put one by one beside the same thing, said of
    every one of them, and of that thing: "it" is none of those that were put there."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        told = _told(clause)
        put = _put_there(clauses, [*links, link]) if told else []
        if told is None or len(put) < _PAIR or (_word(told[0]) in _BOTH and len(put) != _PAIR):
            clauses, links = [*clauses, clause], [*links, link]
            continue
        clauses[-len(put) :] = [replace(one, adjuncts=(*one.adjuncts, *told[1])) for one in put]
    return chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses), links=tuple(links))


def _told(clause: Meaning) -> tuple[Meaning | None, tuple[Loc, ...]] | None:
    """Of "each" or "both", how these stand to "it", where that is all of the clause."""
    if not isinstance(clause, Clause) or clause.negated or clause.mode == "start" or clause.verb not in _PUT:
        return None
    told = tuple(x for x in clause.adjuncts if isinstance(x, Loc) and _word(x.landmark) == "it" and x.rel != "on")
    each = _word(clause.theme) in _EACH | _BOTH
    return (clause.theme, told) if each and told and len(told) == len(clause.adjuncts) else None


def _put_there(clauses: list[Meaning], links: list[str]) -> list[Clause]:
    """The last clauses that put one block each beside the same thing."""
    found: list[Clause] = []
    mark: Meaning | None = None
    for n in reversed(range(len(clauses))):
        clause, there = clauses[n], _beside(clauses[n])
        joined = links[n + 1] == "and" and there is not None and (mark is None or _same(there, mark))
        if not joined or not isinstance(clause, Clause):
            break
        found.insert(0, clause)
        mark = there if _word(there) != "it" else mark
    if isinstance(mark, Noun) and len(found) == _PAIR:
        found[1] = _beside_it(found[1], replace(mark, det="the", amount=None))
    return found


def _beside(clause: Meaning) -> Meaning | None:
    """What a clause puts one block beside, if it says no more."""
    if not isinstance(clause, Clause) or clause.negated or clause.mode == "start" or clause.verb not in _PUT:
        return None
    theme, place = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    single = isinstance(theme, Noun) and not theme.plural and theme.head != "patch"
    if not single or not isinstance(place, Loc) or place.negated or place.rel not in _SIDES:
        return None
    mark = place.landmark
    alone = isinstance(mark, Noun | Structure) and not mark.plural and getattr(mark, "head", "") != "patch"
    return mark if alone or _word(mark) == "it" else None


def _same(one: Meaning | None, other: Meaning) -> bool:
    """Whether two things are told by the same words."""
    return isinstance(one, Noun) and isinstance(other, Noun) and one.traits == other.traits


def _beside_it(clause: Clause, mark: Noun) -> Clause:
    """A clause with the thing that "it" is."""
    places = [replace(x, landmark=mark) if isinstance(x, Loc) and _word(x.landmark) == "it" else x
              for x in clause.adjuncts]  # fmt: skip
    return replace(clause, adjuncts=tuple(places))


def _word(meaning: Meaning | None) -> str:
    return meaning.word if isinstance(meaning, Pronoun) else ""
