""" "Three red blocks on the red mat and two blue ones on the blue mat, each as a tower": every lot that was told."""

from __future__ import annotations

from rpg.core.diagnostics import Refusal
from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    That,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_EACH = frozenset({"each", "each one", "each of them"})
_BOTH = frozenset({"both", "both of them"})
_PUT = ("place", "be")


def each_lot(chain: Chain) -> Chain:
    """The sentence with the tower that is told behind several lots told of every one of them.

    Raises:
        Refusal: something else is told of each, or there are single blocks among them.
    """
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        if clauses and link == "and":
            _check_aside(_lots(clauses[-1]), clause)
        told = _told(clause)
        first = _first(clauses, [*links, link]) if told is not None else len(clauses)
        lots = [lot for before in clauses[first:] for lot in _lots(before)]
        several = [lot for lot in lots if getattr(lot.theme, "plural", False)]
        if told is None or len(lots) < 2 or not (several or _piled(told)):
            clauses, links = [*clauses, clause], [*links, link]
            continue
        if not _piled(told) or len(several) < len(lots):
            raise _of_which(told)
        clauses[first:] = [replace(lot, adjuncts=(*lot.adjuncts, told)) for lot in lots]
        links[first + 1 :] = ["and"] * (len(lots) - 1)
    return chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses), links=tuple(links))


def _of_which(told: Meaning) -> Refusal:
    return refuse("ambiguous", "this may be told of the last one, or of all", told.span, "say it of each by itself")


def _check_aside(before: list[Clause], clause: Meaning) -> None:
    """Refuse "red on blue and green on white, both in the left half", "two on the red mat and three on the blue one,
    as towers", "..., touching each other", where that would be said of the last two, or three."""
    if not before or not isinstance(clause, Clause) or not _lots(clause):
        return
    several = all(getattr(lot.theme, "plural", False) for lot in (*before, clause))
    several = several and not any(_of_several(told) for lot in before for told in lot.adjuncts)
    placed = any(isinstance(x, Loc) and isinstance(x.landmark, Noun) for x in clause.adjuncts)
    for told in clause.adjuncts if not isinstance(clause.theme, Coord) else ():
        if _of_each(told) or (several and placed and _of_several(told)):
            raise _of_which(told)


def _of_each(told: Meaning) -> bool:
    """ "Both in the left half", "each with a green block on top"."""
    if not isinstance(told, Absolute):
        return False
    marks = [_word(x.landmark) for x in told.adjuncts if isinstance(x, Loc)]
    return not (_EACH | _BOTH).isdisjoint((_word(told.theme), *marks))


def _of_several(told: Meaning) -> bool:
    """ "As towers", "touching each other", "without stacking them", where none is told of which."""
    match told:
        case Into(structure=Structure(plural=True) as shape):
            return not (shape.amount or shape.members or shape.sizes)
        case Loc(landmark=mark):
            return _word(mark) == "each other"
        case That():
            return any(_word(part) in ("them", "they") for part in parts_of(told))
    return False


def _word(meaning: Meaning | None) -> str:
    return meaning.word if isinstance(meaning, Pronoun) else ""


def _told(clause: Meaning) -> Meaning | None:
    """What is told of "each", where that is all of the clause: a tower of its own, or where it is."""
    word = _word(clause.theme) if isinstance(clause, Clause) else ""
    if not isinstance(clause, Clause) or clause.negated or clause.mode == "start" or len(clause.adjuncts) != 1:
        return None
    told = clause.adjuncts[0]
    shape = told.structure if isinstance(told, Into) else None
    if _piled(told) and isinstance(told, Into) and isinstance(shape, Structure) and word in _EACH | _BOTH:
        return replace(told, structure=replace(shape, plural=False, det="a", amount=Amount(1, 1)))
    return told if word in _EACH and clause.verb in _PUT else None


def _piled(told: Meaning) -> bool:
    """Whether a tower is told, and not of which blocks; "each in a row" may be of all of them, in one."""
    shape = told.structure if isinstance(told, Into) else None
    return isinstance(shape, Structure) and shape.kind == "stack" and shape.members is None


def _first(clauses: list[Meaning], links: list[str]) -> int:
    """Where the lots begin that were told one after the other up to here."""
    first = len(clauses)
    while first and links[first] == "and" and _lots(clauses[first - 1]):
        first -= 1
    return first


def _lots(clause: Meaning) -> list[Clause]:
    """The lots of which a clause tells where they are, each in a clause of its own."""
    if not isinstance(clause, Clause) or clause.verb not in _PUT or clause.negated or clause.mode == "start":
        return []
    items = clause.theme.items if isinstance(clause.theme, Coord) and clause.theme.op == "and" else (clause.theme,)
    named = all(isinstance(x, Noun) and x.head != "patch" for x in items)
    return [replace(clause, theme=x) for x in items] if named else []
