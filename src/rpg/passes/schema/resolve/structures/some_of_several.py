""" "Exactly one of the two towers is on the mat", "none of the rows ...": so many of several structures, whichever."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.language.meaning import Amount, Clause, In, Loc, Meaning, Noun, Structure, TableTop, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj, negation
from rpg.passes.schema.resolve.places.placing import places
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

_LEVEL = frozenset({"left", "right", "front", "behind", "beside", "adjacent", "near", "apart"})
"""Relations that a structure stands in on the table, besides "on" a patch."""


def of_so_many(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Atoms | None:
    """That so many of several structures are somewhere; None of a clause that speaks of blocks.

    What is said of each of them is said of the structure as a whole, as of one that is named alone.
    """
    noun = clause.theme
    if not isinstance(noun, Noun) or not isinstance(noun.part_of, Structure) or noun.traits.rank:
        return None
    spot = spec.places[0] if len(spec.places) == len(clause.adjuncts) - len(spec.manners) == 1 else None
    if clause.verb not in ("be", "place") or clause.negated or spot is None or scope.start or not _on_the_table(spot):
        raise refuse("misplaced", "this is not understood of some of several structures", noun.span,
                     "say of each of them by itself where it should be")  # fmt: skip
    whole = refer(noun.part_of, scene, scope)
    many = _many(noun, len(whole.built))
    goals = []
    for built in whole.built:
        spec.places = [spot]
        one = Ref(names=built.members, built=(built,), span=noun.span)
        goals.append(conj(places(one, spec, scene, scope, clause.span), clause.span))
        spot = _again(spot)
    return [so_many(goals, many, clause.span)]


def so_many(goals: Atoms, many: Amount, span: Span) -> g.Goal:
    """So many of the goals hold; those that do not are denied block by block, as of one thing that is not there."""
    count, everyone = len(goals), range(len(goals))
    high = count if many.high is None else many.high
    ways: list[tuple[Iterable[int], Iterable[int]]]
    if many.low and high < count:
        sizes = range(many.low, high + 1)
        ways = [(some, {*everyone} - {*some}) for size in sizes for some in combinations(everyone, size)]
    elif many.low:
        ways = [(some, ()) for some in combinations(everyone, many.low)]
    else:
        ways = [((), some) for some in combinations(everyone, count - high)]
    told = [([goals[n] for n in held], negation([goals[n] for n in left], span)) for held, left in ways]
    return disj([conj([*held, *left], span) for held, left in told], span)


def _many(noun: Noun, count: int) -> Amount:
    """How many of them are meant.

    Raises:
        Refusal: there are not so many of them.
    """
    amount = Amount(0, 0) if noun.det == "no" else noun.amount or Amount(1, None)
    pair = noun.det == "no" and noun.amount == Amount(2, 2, True)
    if count < 2 or amount.low > count or (pair and count != 2) or amount.high == -1:
        raise refuse("count-mismatch", f"so many are spoken of, but there are {count}", noun.span, "say of how many",
                     there=count)  # fmt: skip
    return amount


def _on_the_table(spot: Meaning) -> bool:
    """Whether a whole structure can be there, and not a block of it."""
    if isinstance(spot, In):
        return not spot.negated
    if not isinstance(spot, Loc) or spot.negated or isinstance(spot.landmark, TableTop):
        return False
    on_patch = spot.rel in ("on", "in") and isinstance(spot.landmark, Noun) and spot.landmark.head == "patch"
    return on_patch or spot.rel in _LEVEL


def _again(spot: Meaning) -> Meaning:
    """The same place, spoken of once more: "a patch" is "the patch" then."""
    mark = spot.landmark if isinstance(spot, Loc) else None
    if isinstance(spot, Loc) and isinstance(mark, Noun | Structure) and mark.det == "a":
        return replace(spot, landmark=replace(mark, det="the", amount=None))
    return spot
