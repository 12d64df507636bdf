""" "A left of B and B left of C with 2 cm between each": a gap that is told last, of all the pairs that were told."""

from __future__ import annotations

import re

from rpg.core.diagnostics import Refusal
from rpg.language.meaning import (
    Chain,
    Clause,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Spacing,
    Structure,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_SIDES = frozenset({"left", "right", "front", "behind", "beside"})
_OF_EACH = frozenset({"each", "every", "all", "gaps", "spaces", "neighbors", "neighbours", "any"})
"""Words that tell a gap of more than one pair."""
_SET_OFF = re.compile(r",\s*(?:(?:but|and|with|all)\s+)?(?:\w|,)?$")
"""How the words end up to the first letter of what a comma sets off."""


def shared_gaps(chain: Chain, text: str) -> Chain:
    """The sentence with such a gap said of every pair.

    Raises:
        Refusal: it may be told of the last pair alone, or of all.
    """
    clauses = list(chain.clauses)
    for n, clause in enumerate(clauses):
        _check_piled(clause, len(clauses) == 1)
        told = _told_last(clause, clauses[n - 1]) if n and chain.links[n] == "and" else None
        if told is not None and _SET_OFF.search(text[: told.span[0] + 1]):
            raise _of_which(told)
        if n and chain.links[n] == "and" and (apart := _apart(clause, clauses[n - 1], text)):
            clause = clauses[n] = _of_the_two(clause, apart, clauses[n - 1])
        gap = _gap(clause)
        if gap is not None and _told_within(clause):
            raise _of_which(gap)
        pairs = [n] if gap is not None else []
        while pairs and pairs[0] and chain.links[pairs[0]] == "and" and _pair(clauses[pairs[0] - 1], 1):
            pairs.insert(0, pairs[0] - 1)
        if gap is None or len(pairs) < 2:
            continue
        said = text[slice(*gap.span)].lower().replace("each other", "").split()
        if _OF_EACH.isdisjoint(said):
            if _SET_OFF.search(text[: gap.span[0] + 1]) or _chained([clauses[k] for k in pairs]):
                raise _of_which(gap)
            continue
        for k in pairs[:-1]:
            one = clauses[k]
            if isinstance(one, Clause):
                clauses[k] = replace(one, adjuncts=(*one.adjuncts, gap))
    return chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses))


_TURNS = frozenset({"turn", "by", "by?", "facing"})


def _told_last(clause: Meaning, before: Meaning) -> Meaning | None:
    """ "(A on B) and C on D, turned to the left", "..., 10 cm from the mat": what is told of a block that is put there
    with no verb of its own, behind one of which no more is said than where it goes."""
    if not isinstance(clause, Clause) or not isinstance(before, Clause) or clause.theme is None:
        return None
    places = (*before.adjuncts, *clause.adjuncts[:1])
    if len(clause.adjuncts) < 2 or len(places) != 2 or not all(isinstance(x, Loc | In) for x in places):
        return None
    told, piled = clause.adjuncts[-1], all(isinstance(x, Loc) and _on_block(x) for x in places)
    turned = isinstance(told, Manner) and told.kind in _TURNS
    far = isinstance(told, Loc) and (piled or told.rel in ("distance", "near", "apart"))
    far = far and isinstance(told, Loc) and isinstance(told.landmark, Noun)
    own = clause.span[0] < clause.theme.span[0] and clause.word != before.word
    return told if (turned or far) and not own else None


def _on_block(place: Loc) -> bool:
    return place.rel in ("on", "under") and isinstance(place.landmark, Noun) and place.landmark.head != "patch"


def _of_which(told: Meaning) -> Refusal:
    return refuse("ambiguous", "of the last two of these, or of all that were told?", told.span,
                  "say it of each of them: 'A is 2 cm to the left of B'")  # fmt: skip


def _gap(clause: Meaning) -> Loc | Spacing | None:
    """What is told of the gap between the two blocks of a clause, behind how they stand."""
    gap = clause.adjuncts[-1] if isinstance(clause, Clause) and _pair(clause, 2) else None
    if isinstance(gap, Spacing):
        return gap if gap.kind == "touching" else None
    return gap if isinstance(gap, Loc) and _mutual(gap) else None


def _mutual(gap: Meaning) -> bool:
    each_other = isinstance(gap, Loc) and isinstance(gap.landmark, Pronoun) and gap.landmark.word == "each other"
    return isinstance(gap, Loc) and each_other and gap.rel in ("distance", "touching")


def _apart(clause: Meaning, before: Meaning, text: str) -> Loc | Spacing | None:
    """What a comma sets off behind a line or a group that is made, where nothing such is told of the one before: how
    far apart things are, or that they touch."""
    told = _gaps(clause) if _made(clause) and not _gaps(before) else []
    said = [x for x in told if _BLOCKS.isdisjoint(text[slice(*x.span)].lower().split())]
    return next((x for x in said if _SET_OFF.search(text[: x.span[0] + 1])), None)


_BLOCKS = frozenset({"blocks", "cubes", "neighbors", "neighbours"})


def _gaps(clause: Meaning) -> list[Loc | Spacing]:
    adjuncts = clause.adjuncts if isinstance(clause, Clause) else ()
    return [x for x in adjuncts if (isinstance(x, Loc) and _mutual(x)) or isinstance(x, Spacing)]


def _made(clause: Meaning) -> str:
    """The kind of the one line or group that a clause makes of some blocks."""
    if not isinstance(clause, Clause):
        return ""
    into = [x.structure for x in clause.adjuncts if isinstance(x, Into)]
    made = [x for x in (clause.theme, *into) if isinstance(x, Structure) and not x.plural]
    return made[0].kind if len(made) == 1 and made[0].kind in _LOTS else ""


_LOTS = frozenset({"row", "line", "column", "pile", "again"})


def _of_the_two(clause: Meaning, apart: Loc | Spacing, before: Meaning) -> Meaning:
    """ "(the red ones in one group and) the blue ones in another, 20 cm apart": of the groups, as it is not said of the
    blocks of one; of those of a line it could be said.

    Raises:
        Refusal: they are lines.
    """
    one = _made(before)
    if not (one and isinstance(before, Clause) and isinstance(clause, Clause)):
        return clause
    if one != "pile" or not isinstance(apart, Loc) or not isinstance(before.theme, Noun):
        raise refuse("ambiguous", "of the blocks of the last of these, or of the two?", apart.span,
                     "say 'the two rows are 10 cm apart', or '5 cm between its blocks'")  # fmt: skip
    others = replace(before.theme, det="the", amount=None, plural=True)
    adjuncts = tuple(replace(x, landmark=others) if x is apart else x for x in clause.adjuncts)
    return replace(clause, adjuncts=adjuncts)


def _check_piled(clause: Meaning, alone: bool) -> None:
    """Refuse "red on blue and green on white with a 5 cm gap between them", "touching", "next to it": one lies on the
    other."""
    places = [x for x in clause.adjuncts if isinstance(x, Loc)] if isinstance(clause, Clause) else []
    rels = [x.rel for x in places]
    told = ("distance",) if alone else ("distance", "touching", "side_by_side", "adjacent", "near", "apart", "beside")
    if len(rels) != 2 or rels[0] not in ("on", "under") or places[0].negated or rels[1] not in told:
        return
    named, theme = places[0].landmark, clause.theme if isinstance(clause, Clause) else None
    single = all(isinstance(x, Noun) and x.head != "patch" and not x.plural for x in (named, theme))
    word = places[1].landmark.word if isinstance(places[1].landmark, Pronoun) else ""
    if single and word == "it" and rels[1] in ("beside", "adjacent") and not alone:
        raise refuse("ambiguous", "next to what it lies on, or to what was told before?", places[1].span, "name it")
    if single and word == "each other":
        raise refuse("ambiguous", "blocks that lie on each other have no gap: is it between towers?", places[1].span,
                     "say between which blocks it is")  # fmt: skip


def _pair(clause: Meaning, adjuncts: int) -> bool:
    """Whether a clause says of one block on which side of another it is, and has so many adjuncts."""
    if not isinstance(clause, Clause) or clause.verb not in ("be", "place") or len(clause.adjuncts) != adjuncts:
        return False
    place = clause.adjuncts[0]
    told = isinstance(place, Loc) and place.rel in _SIDES and isinstance(place.landmark, Noun) and not place.negated
    return told and not clause.negated and clause.mode != "start"


def _told_within(clause: Meaning) -> bool:
    """ "A left of B, which is left of C": whether a second pair is told within a clause."""
    marks = [x.landmark for x in clause.adjuncts[:1] if isinstance(x, Loc)] if isinstance(clause, Clause) else []
    inner = [x for mark in marks if isinstance(mark, Noun) for x in mark.conditions]
    return any(isinstance(x, Loc) and x.rel in _SIDES and "aside" in x.mods for x in inner)


def _chained(clauses: list[Meaning]) -> bool:
    """Whether one block is of two pairs."""
    looks = [(x.traits.colors, x.traits.labels) for c in clauses for x in parts_of(c) if isinstance(x, Noun)]
    return len(set(looks)) < len(looks) or any(isinstance(x, Pronoun) for c in clauses[1:-1] for x in parts_of(c))
