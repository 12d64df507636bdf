""" "Divide the six blocks equally between the two patches": so many of them on each."""

from __future__ import annotations

from typing import TypeGuard

from rpg.core.diagnostics import Refusal
from rpg.language.grammar.clauses.equal_numbers import EQUAL
from rpg.language.grammar.clauses.shared import SHARE, are_patches
from rpg.language.meaning import Amount, Chain, Clause, Coord, Loc, Meaning, Noun, That, Traits, parts_of, replace
from rpg.passes.schema.resolve.things.world import Scene, refuse

EACH, PATCHES = 2, 2
"""Blocks on each patch, and patches, where their number is open."""


def shared_out(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences with so many on each patch for what is shared."""
    chains = tuple(_equally(chain, chains, scene) for chain in chains)
    if (left := next((x for x in parts_of(chains) if _is_equal(x)), None)) is not None:
        raise _unclear(left)
    return tuple(
        replace(chain, clauses=tuple(_on_each(c, scene) if _shares(c) else c for c in chain.clauses))
        if any(map(_shares, chain.clauses))
        else chain
        for chain in chains
    )


def _equally(chain: Chain, chains: tuple[Chain, ...], scene: Scene) -> Chain:
    """ "Both patches have the same number of cubes": one on each or two on each, and so on; of blocks that are all to
    be there, equal shares."""
    found = [clause for clause in chain.clauses if _is_equal(clause)]
    if not found:
        return replace(chain, clauses=tuple(map(_all_there, chain.clauses)))
    one = found[0]
    if len(chain.clauses) > 1 or not isinstance(one.theme, Noun):
        raise _unclear(one)
    blocks = [x for c in chains if c != chain for x in parts_of(c) if isinstance(x, Noun) and x.head != "patch"]
    if len(blocks) == 1 and blocks[0].amount is not None and blocks[0].traits == one.theme.traits:
        one = replace(one, theme=replace(blocks[0], det="the"))
    elif blocks:
        raise _unclear(one)
    whole, among, marks = _whole(one, scene)
    several = [
        _so_many_each(one, whole, marks, Amount(each, each, True)) for each in range(1, _how_many(whole) // among + 1)
    ]
    scene.assume("whether the patches may be empty is not said: each has at least one block")
    return replace(chain, clauses=tuple(several), links=(*chain.links, *("or" for _ in several[1:])))


def _unclear(clause: Clause) -> Refusal:
    return refuse("ambiguous", "it is not said of which blocks there are as many on each patch", clause.span,
                  "say how many there are in the same sentence: 'divide the four cubes equally between the two "
                  "patches'")  # fmt: skip


def _is_equal(clause: Meaning) -> TypeGuard[Clause]:
    return isinstance(clause, Clause) and clause.lemma == EQUAL


def _all_there(clause: Meaning) -> Meaning:
    """ "Put the four cubes on the two patches so that each has the same number": equal shares of them."""
    parts = clause.adjuncts if isinstance(clause, Clause) and clause.verb in ("place", "arrange") else ()
    so = [x.clauses for x in parts if isinstance(x, That) and x.kind == "so"]
    told = so[0].clauses if len(so) == 1 and isinstance(so[0], Chain) else ()
    if not isinstance(clause, Clause) or len(told) != 1 or not _is_equal(one := told[0]):
        return clause
    on = [x for x in parts if isinstance(x, Loc) and x.rel in ("on", "in") and not x.negated]
    several = isinstance(clause.theme, Coord) or (isinstance(clause.theme, Noun) and clause.theme.plural)
    if not several or len(on) + len(so) < len(parts) or any(not are_patches(x.landmark) for x in on):
        return clause
    on = on or [x for x in one.adjuncts if isinstance(x, Loc)]
    return replace(clause, verb="place", lemma=SHARE, adjuncts=(replace(on[0], rel="on"),))


def _shares(clause: Meaning) -> bool:
    return isinstance(clause, Clause) and clause.lemma == SHARE


def _on_each(clause: Meaning, scene: Scene) -> Meaning:
    on = clause.adjuncts[0] if isinstance(clause, Clause) else None
    if not isinstance(clause, Clause) or not isinstance(on, Loc) or on.landmark is None:
        return clause
    whole, among, marks = _whole(clause, scene)
    many = _how_many(whole)
    if many % among:
        raise refuse("count-mismatch", f"{many} blocks cannot be shared equally by {among} patches", clause.span,
                     f"say how many are on each, or share {many - many % among or among}")  # fmt: skip
    return _so_many_each(clause, whole, marks, Amount(many // among, many // among))


def _whole(clause: Clause, scene: Scene) -> tuple[Meaning | None, int, Meaning | None]:
    """The blocks with their number, among how many patches they are, and these."""
    marks = clause.adjuncts[0].landmark if isinstance(clause.adjuncts[0], Loc) else None
    if isinstance(marks, Noun) and marks.det == "each" and marks.part_of is not None:
        marks = marks.part_of
    among = _how_many(marks) or PATCHES
    whole, many = clause.theme, _how_many(clause.theme)
    if not many and isinstance(whole, Noun):
        many = EACH * among
        whole = replace(whole, det="the", amount=Amount(many, many))
        colors = "".join(f"{color} " for color in whole.traits.colors)
        scene.assume(f"the number of {colors}blocks is not said: {many}")
    if isinstance(marks, Noun) and marks.amount is None and not marks.traits.colors:
        marks = replace(marks, amount=Amount(among, among))
    return whole, among, marks


def _so_many_each(clause: Clause, whole: Meaning | None, marks: Meaning | None, each: Amount) -> Clause:
    """So many of the blocks on each of the patches."""
    some = Noun(head="block", det="some", amount=each, plural=each.low > 1, part_of=whole, span=clause.span)
    on = clause.adjuncts[0]
    if isinstance(marks, Noun) and marks.det in ("both", "each", "all"):
        marks = replace(marks, det="the", plural=True)
    every = Noun(head="patch", det="each", plural=True, part_of=marks, span=on.span)
    place = Loc(rel="on", landmark=every, span=on.span)
    return replace(clause, lemma="put", theme=some, adjuncts=(place,))


def _how_many(theme: Meaning | None) -> int:
    """How many there are; 0 where it is not said."""
    if isinstance(theme, Coord):
        return sum(_how_many(item) or 1 for item in theme.items)
    if not isinstance(theme, Noun):
        return 0
    if theme.amount is not None:
        return theme.amount.low if theme.amount.low == theme.amount.high else 0
    look = theme.traits
    return len(look.labels or look.colors) if look != Traits() and len(look.labels or look.colors) > 1 else 0
