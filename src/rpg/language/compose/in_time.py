"""What is so at the start, and what at the end: texts that leave this open are not read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.compose.scene import Unclear
from rpg.language.compose.syntax import STAY, Chain, Clause, Looks, Made, Noun, Place, Predicate, Pronoun, is_figure


def check_in_time(way: Sequence[Clause], begun: int = 0) -> None:
    """What is told to be so, or to be there, beside what is to be done may be so at the start alone.

    The clauses that are `begun` tell how it starts. Raises Unclear where this is not clear, and where a clause may go
    on what is said in the one ahead of it.
    """
    way = _begun(way, begun)
    if any(clause.mood == "lies" for clause in way):
        raise Unclear
    if any(clause.first for clause in way) and not any(clause.later for clause in way):
        raise Unclear
    asks = [n for n, clause in enumerate(way) if clause.mood in {"put", "change"} or clause.later or _builds_of(clause)]
    last = asks[-1] if asks else 0
    pictured = _is_pictured(way)
    for n, clause in enumerate(way):
        told = bool(clause.predicates) or isinstance(clause.subject, Chain)
        if clause.mood in {"there", "seen"} and not pictured:
            ahead = n < last and (clause.mood == "seen" or way[last].mood != "put" or way[last].later)
            _check_there(clause, told=told, alone=len(way) == 1, ahead=ahead)
        # how things look is so all the time
        looks = bool(clause.predicates) and all(isinstance(said, Looks) or said == STAY for said in clause.predicates)
        ends = any(behind.mood == "end" for behind in way[n + 1 :])
        if (n < last or ends) and told and clause.mood in {"so", ""} and not looks:
            raise Unclear
        if clause.mood == "so" and asks and isinstance(clause.subject, Noun) and clause.subject.det == "a":
            raise Unclear
    if len(way) > 1 and way[0].mood == "so" and any(map(_on_table, way[0].predicates)):
        raise Unclear
    for clause, behind in pairwise(way):
        if behind.mood in {"", "there", "so"}:
            _check_joined(clause, behind)


def _is_pictured(way: Sequence[Clause]) -> bool:
    """ "I see a red block on a blue one. The green one is behind the red one": nothing is asked for but what is so."""
    moods = {clause.mood for clause in way}
    return moods <= {"there", "seen", "so"} or ("seen" in moods and moods <= {"there", "seen", "so", "must", ""})


def _begun(way: Sequence[Clause], first: int) -> list[Clause]:
    """What is told ahead of what changes it is so at the start."""
    return [replace(clause, mood="start") if n < first else clause for n, clause in enumerate(way)]


def _check_there(clause: Clause, *, told: bool, alone: bool, ahead: bool) -> None:
    """ "There is a tower": it is to be built, or is there from the start where something is asked for; it may be either
    where more is said of it, or where something else is made of things."""
    if any(_of_table(said) for said in clause.predicates):
        raise Unclear
    if not alone and (told or (ahead and is_figure(clause.subject))):
        raise Unclear


def _check_joined(clause: Clause, behind: Clause) -> None:
    """What stands behind a clause without a verb of its own may be so at the start, be denied, or be said of both."""
    if clause.mood == "start" != behind.mood:
        raise Unclear
    if not behind.mood and any(isinstance(said, Place) and said.no for said in clause.predicates):
        raise Unclear
    if not clause.mood and clause.predicates and not behind.mood and not behind.predicates:
        raise Unclear  # "on the mat are a red block and a tower": is the tower there, too?
    new = not isinstance(behind.subject, Noun) or behind.subject.det not in {"the", "each"}
    if is_figure(clause.subject) and not clause.predicates and is_figure(behind.subject) and behind.predicates and new:
        place = behind.predicates[0]
        of = place.of.of if isinstance(place, Place) and isinstance(place.of, Noun) else None  # "on its center"
        told = isinstance(place, Place) and place.of is not None
        if told and not isinstance(of, Pronoun) and not (isinstance(place, Place) and isinstance(place.of, Pronoun)):
            raise Unclear


def _builds_of(clause: Clause) -> bool:
    """Whether something is built of what was told ahead."""
    return clause.mood == "build" and any(isinstance(said, Made) for said in clause.predicates)


def _on_table(said: Predicate) -> bool:
    return (isinstance(said, Place) and said.relation == "table") or _of_table(said)


def _of_table(said: Predicate) -> bool:
    return isinstance(said, Place) and isinstance(said.of, Noun) and said.of.noun == "table"
