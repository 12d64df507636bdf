"""What "not" denies of a clause."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.language.meaning import (
    Amount,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.exception_last import exception_last
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, negation
from rpg.passes.schema.resolve.things.operands import DIRECTIONS
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Scene, refuse


def denied_once(clause: Clause) -> Clause:
    """ "is not on red and not on blue": both are denied, and neither twice."""
    clause = _on_no_patch(_not_any(exception_last(clause)))
    if clause.negated or getattr(clause.theme, "det", "") == "no":
        _said_in_one(clause)
    _all_that_are_not(clause)
    _either_is_not(clause)
    _not_to_all(clause)
    _not_in_pairs(clause)
    for near in clause.adjuncts if clause.negated and clause.lemma in ("move", "shift") else ():
        if isinstance(near, Loc) and near.rel in ("between", "beside", "adjacent", "near"):
            raise refuse("ambiguous", "it is not to get there, or it is there and is not to be moved?", near.span,
                         "say 'put' for 'move', or 'the block that is ...'")  # fmt: skip
    for far in clause.adjuncts if clause.negated else ():
        if isinstance(far, Loc) and far.rel in DIRECTIONS and (far.low is not None or far.high is not None):
            raise refuse("ambiguous", "it is not clear whether the side is denied, or how far it is", far.span,
                         "say 'at most 10 cm to the left of', or 'not to the left of'")  # fmt: skip
    again = [a for a in clause.adjuncts if isinstance(a, Loc | In) and a.negated]
    if not clause.negated or not again:
        return clause
    if len(again) == len(clause.adjuncts):
        raise refuse("ambiguous", "it is not clear what is denied here", clause.span, "say 'not' once")
    placed = tuple(replace(a, negated=False) for a in clause.adjuncts if isinstance(a, Loc | In))
    rest = (a for a in clause.adjuncts if not isinstance(a, Loc | In))
    return replace(clause, adjuncts=(Coord(op="and", items=placed, span=clause.span), *rest))


def _not_any(clause: Clause) -> Clause:
    """ "do not put any of them there", "never let either of them touch it": of none of them."""
    theme = clause.theme
    if isinstance(theme, Pronoun) and theme.word == "either of them":
        both = Pronoun(word="both of them", span=theme.span)
        theme = Noun(head="any", det="any", amount=Amount(1, 1), plural=True, part_of=both, span=theme.span)
    if _no_block_there(clause):
        return replace(clause, theme=replace(theme, det="no", amount=None), negated=False)
    single = isinstance(theme, Noun) and theme.det == "any" and theme.amount == Amount(1, 1)
    if not clause.negated or clause.verb not in ("be", "place") or not isinstance(theme, Noun) or not single:
        return clause
    if isinstance(theme.part_of, Structure):
        return clause  # "one of the towers is not there": of one of them alone
    return replace(clause, theme=replace(theme, det="no", amount=None), negated=False) if theme.part_of else clause


def _no_block_there(clause: Clause) -> bool:
    """ "Do not put any block on the mat": of whatever block."""
    theme, places = clause.theme, clause.adjuncts
    plain = isinstance(theme, Noun) and (theme.head, theme.det, theme.traits) == ("block", "any", Traits())
    plain = plain and isinstance(theme, Noun) and theme.part_of is None and not theme.conditions
    there = len(places) == 1 and isinstance(places[0], Loc | In) and not places[0].negated
    return clause.negated and clause.verb in ("be", "place") and plain and there


def denied_of_any(clause: Clause, scene: Scene) -> Clause:
    """ "A red block must not touch it", "do not put a red block there": where there are several, none of them."""
    theme = clause.theme
    if not clause.negated or not isinstance(theme, Noun) or theme.det != "a" or theme.head == "patch":
        return clause
    alike = matching(theme.traits, scene, False)
    if theme.amount != Amount(1, 1) or theme.part_of is not None or theme.conditions or len(alike) < 2:
        return clause
    if clause.lemma == "fact":
        raise refuse("ambiguous", "is there one of which this is not so, or is it so of none?", clause.span,
                     "say 'no ...', or 'at least one of the ... is not'")  # fmt: skip
    return replace(clause, theme=replace(theme, det="no", amount=None), negated=False)


def _on_no_patch(clause: Clause) -> Clause:
    """ "No patch has more than one block": each has at most one."""
    places = [a for a in clause.adjuncts if isinstance(a, Loc) and not a.negated]
    mark = places[0].landmark if len(places) == 1 else None
    theme = clause.theme
    many = theme.amount if isinstance(theme, Noun) and theme.head != "patch" else None
    of_none = isinstance(mark, Noun) and mark.head == "patch" and mark.det == "no" and not clause.negated
    if of_none and (
        getattr(theme, "op", "") == "and" or len(getattr(getattr(theme, "traits", None), "labels", ())) > 1
    ):
        raise refuse("ambiguous", "it is not clear whether each of these is denied, or both together", clause.span,
                     "say 'neither ... nor', or 'not both'")  # fmt: skip
    if of_none and isinstance(mark, Noun) and isinstance(theme, Noun) and (theme.det, many) == ("a", Amount(1, 1)):
        return _no_such_block(clause, theme, mark, places[0])
    if not of_none or many is None or not (many.strict or many.low > 1):
        return clause
    ahead = isinstance(mark, Noun) and isinstance(theme, Noun) and mark.span[0] < theme.span[0]
    some_more = many.low > 1 and (many.high is None or not many.strict)
    if len(clause.adjuncts) > 1 or not ahead or not some_more or not isinstance(theme, Noun):
        raise refuse("ambiguous", "it is not clear how many this leaves on each of them", clause.span,
                     "say 'each patch has at most ...'")  # fmt: skip
    each = replace(mark, det="each") if isinstance(mark, Noun) else mark
    fewer = replace(theme, amount=Amount(0, many.low - 1, True))
    return replace(clause, theme=fewer, adjuncts=(replace(places[0], landmark=each),))


def _no_such_block(clause: Clause, theme: Noun, mark: Noun, place: Loc) -> Clause:
    """ "No mat has a red block on it": no red block is on any of them."""
    if mark.span[0] > theme.span[0] or len(clause.adjuncts) > 1:
        raise refuse("ambiguous", "is there one that is on none of them, or is this so of all?", clause.span,
                     "say 'no ... is on any of them'")  # fmt: skip
    there = replace(place, landmark=replace(mark, det="any", amount=None))
    return replace(clause, theme=replace(theme, det="no", amount=None), adjuncts=(there,))


def _all_that_are_not(clause: Clause) -> None:
    """Refuse "all three red blocks are not on the patch": none of them, or not all of them?"""
    of_all = isinstance(clause.theme, Noun) and clause.theme.det in ("all", "each")
    for place in clause.adjuncts if clause.negated and of_all and clause.lemma == "fact" else ():
        if isinstance(place, In) or (isinstance(place, Loc) and not isinstance(place.landmark, Pronoun)):
            raise refuse("ambiguous", "it is not clear whether none of them are to be so, or not all", clause.span,
                         "say 'none of the ...', or 'not all of the ...'")  # fmt: skip


def _either_is_not(clause: Clause) -> None:
    """Refuse "either A or B must not be there": at least one of them, or neither?"""
    theme = clause.theme if clause.negated and clause.mode != "command" else None
    if isinstance(theme, Coord) and theme.op == "or" and theme.span[0] < theme.items[0].span[0]:
        raise refuse("ambiguous", "it is not clear whether one of them is not to be so, or neither", theme.span,
                     "say 'neither ... nor ...', or 'at least one of ... must not'")  # fmt: skip


def _not_to_all(clause: Clause) -> None:
    """Refuse "does not touch all three red blocks", "is not far from any of them": of none of them, or not of all?"""
    for place in clause.adjuncts if clause.negated else ():
        mark = place.landmark if isinstance(place, Loc) else None
        if not isinstance(mark, Noun) or mark.head == "patch":
            continue
        far = getattr(place, "rel", "") == "apart" and mark.det == "any"
        if far or mark.det in ("all", "each") or (mark.amount is not None and mark.amount.strict):
            raise refuse("ambiguous", "it is not clear whether this is so of none of them, or not of all", place.span,
                         "say 'any of', 'none of', or 'not both'")  # fmt: skip


def _not_in_pairs(clause: Clause) -> None:
    """Refuse "in a row: red, blue on green, yellow": two of them on two, or one on one, and all of it in a row?"""
    listed = _told_in_a_row(clause.theme) and any(isinstance(a, Into) for a in clause.adjuncts)
    for spot in clause.adjuncts if listed else ():
        if isinstance(spot, Loc) and spot.rel == "on" and _told_in_a_row(spot.landmark):
            raise refuse("ambiguous", "it is not clear which block is on which", spot.span, "say it block by block")


def _told_in_a_row(meaning: Meaning | None) -> bool:
    return isinstance(meaning, Noun) and meaning.cost > 0 and meaning.head == "any" and len(meaning.traits.colors) > 1


def _said_in_one(clause: Clause) -> None:
    """Refuse "is not on blue nor green on yellow", "not next to each other and green": who is meant besides?"""
    places = [place for place in clause.adjuncts if isinstance(place, Loc) and not place.negated]
    for place, before in zip(places, [None, *places], strict=False):
        twice = before is not None and before.rel == place.rel and place.rel in ("on", "beside", "touching")
        if twice or _beyond_each_other(place.landmark):
            raise refuse("ambiguous", "it is not clear what is denied of which block", place.span,
                         "say it in two sentences")  # fmt: skip


def _beyond_each_other(mark: Meaning | None) -> bool:
    items = mark.items if isinstance(mark, Coord) else ()
    return any(isinstance(item, Pronoun) and item.word == "each other" for item in items)


def of_the_same(clause: Clause) -> bool:
    """ "are not on the same patch": one of them may be there."""
    marks = (a.landmark for a in clause.adjuncts if isinstance(a, Loc))
    return any(isinstance(mark, Noun) and mark.traits.scheme == "same" for mark in marks)


def denied(goals: Atoms, clause: Clause, scene: Scene, together: Manner | None) -> Atoms:
    """The opposite of what a clause states. `together`: "not both", "not all", where some of it may be so, or "at least
    one of them is not", where it is told of how many it is denied."""
    if together is not None and together.value:
        return [_of_so_many(goal, clause) for goal in goals]
    if together is not None or of_the_same(clause):
        return [g.Not(goal=conj(goals, clause.span), span=clause.span)] if goals else []
    places = [place for place in clause.adjuncts if isinstance(place, Loc | In) and not place.negated]
    open_ = any(isinstance(place, Loc) and isinstance(place.landmark, Coord) for place in places)
    if len(places) > 1 and not open_:
        raise refuse("ambiguous", "it is not clear whether each of these is denied, or both together", places[1].span,
                     "say 'neither ... nor', or 'not both'")  # fmt: skip
    return negation(goals, clause.span)


def _of_so_many(goal: g.Goal, clause: Clause) -> g.Goal:
    """ "exactly two of them are not on the mat": so many of which it does not hold."""
    many = clause.theme.amount if isinstance(clause.theme, Noun) else None
    if isinstance(goal, g.Count) and many is not None and goal.at_least == many.low:
        return goal.model_copy(update={"goal": conj(negation([goal.goal], clause.span), clause.span)})
    if isinstance(goal, g.Any) and not any(isinstance(x, g.All | g.Any | g.Count | g.Not) for x in goal.goals):
        return g.Any(goals=tuple(g.Not(goal=x, span=clause.span) for x in goal.goals), span=clause.span)
    raise refuse("ambiguous", "it is not clear of how many this is denied", clause.span, "say 'none of', or 'not all'")
