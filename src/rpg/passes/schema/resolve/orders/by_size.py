"""Blocks by their size among others: "the smaller of the two red blocks", "the biggest one"."""

from __future__ import annotations

from dataclasses import replace as changed
from typing import TYPE_CHECKING

from rpg.blocks.nouns import number
from rpg.ir.order import Order
from rpg.language.later import later
from rpg.language.lexicon import BIG_EDGE, MEDIUM_EDGE, SMALL_EDGE
from rpg.language.meaning import Amount, Noun, OrderBy, Traits, replace
from rpg.passes.schema.resolve.places.patch_sizes import of_patches, patch_by_size
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")

BY_SIZE = frozenset({"largest", "smallest", "larger", "smaller",
                     *(f"{nth} {most}" for nth in range(2, 7) for most in ("largest", "smallest"))})  # fmt: skip
_TOLD_APART = range(2, 7)
"""So many blocks differ plainly in size, where no more is said than that they do."""
_BLOCK = ("block", "name its colour")


def by_size(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """The one that is so, of those that are named or of all that look so."""
    if of_patches(noun, scene, scope):
        return patch_by_size(noun, scene, scope)
    rank = noun.traits.rank or ""
    if rank.endswith("er") and noun.det in ("a", "any", "no", "each"):
        raise refuse("ambiguous", f"it is not said which block a {rank} one is {rank} than", noun.span,
                     "name its color, or say 'the 3 cm block'")  # fmt: skip
    those = _those(noun, scene, scope) or _unheard_of(noun, scene, scope)
    if rank.endswith("er") and len(those) > 2:
        raise refuse("ambiguous", f"of more than two blocks none is the {rank} one", noun.span, "name its colour")
    if _untold(those, scene):
        edges = _edges(len(those))
        for thing, edge in zip(those, edges, strict=True):
            thing.edge = edge
        told = f"{', '.join(f'{edge * 100:g}' for edge in edges[:-1])} and {BIG_EDGE * 100:g} cm"
        scene.assume(f"the sizes of the {number(len(those))} blocks are not said: {told}")
    sized = sorted(((edge_of(t), t.name) for t in those), reverse="large" in rank)
    if (nth := _nth(rank)) > 1:
        apart = len({edge for edge, _ in sized[nth - 2 : nth + 1]}) == len(sized[nth - 2 : nth + 1])
        if nth <= len(sized) and apart and not noun.plural:
            return Ref(names=(sized[nth - 1][1],))
        raise refuse("no-referent", f"no block is the one that is the {rank}", noun.span, "name its colour")
    if noun.plural and noun.amount is None:
        raise refuse("ambiguous", f"it is not said how many the {rank} ones are", noun.span, "say 'the two ...'")
    many = noun.amount.low if noun.amount is not None else 1
    if len(sized) > many and sized[many - 1][0] != sized[many][0]:
        return Ref(names=tuple(name for _, name in sized[:many]), plural=many > 1, listed=many > 1)
    what, hint = ("number", "name it, as in 'put the 7 on the patch'") if noun.traits.kind == "digit" else _BLOCK
    raise refuse("no-referent", f"no {what} is the {rank}", noun.span, hint)


_FEW = 3
"""So many blocks there are at least, where one is the largest and no more is said."""


def _nth(rank: str) -> int:
    """Which one in the order of sizes: 2 for the second largest."""
    return int(rank.split()[0]) if rank[:1].isdigit() else 1


def _unheard_of(noun: Noun, scene: Scene, scope: Scope) -> list[Thing]:
    """ "Put the biggest block on the mat", where no block was told of: as many as differ in size, and no others."""
    marks = replace(noun.traits, rank=None)
    plain = marks == Traits(colors=marks.colors) and len(marks.colors) < 2
    if not plain or scope.start or any(scene.blocks()):
        return []
    rank = noun.traits.rank or ""
    least = max(_nth(rank), noun.amount.low + 1 if noun.plural and noun.amount is not None else 1)
    count = min(_TOLD_APART) if rank.endswith("er") else max(_FEW, least)
    if count not in _TOLD_APART:
        return []
    lot = Noun(head="block", amount=Amount(count, count), plural=True, traits=marks, span=noun.span)
    scene.assume(f"the number of blocks is not said: {count}")
    return _those(replace(noun, part_of=lot), scene, scope)


def _not_yet_told_of(those: list[Thing], used: frozenset[str], scene: Scene) -> None:
    """ "The rest on top": of the blocks among which one is sought nothing was said by that."""
    scene.used.difference_update({thing.name for thing in those} - used)


def _edges(count: int) -> list[float]:
    """What so many blocks measure: evenly from small to big."""
    return [round(SMALL_EDGE + (BIG_EDGE - SMALL_EDGE) * n / (count - 1), 4) for n in range(count)]


def edge_of(thing: Thing) -> float:
    """How wide a block is, as far as that is said."""
    return thing.edge or {"small": SMALL_EDGE, "big": BIG_EDGE}.get(thing.size or "", MEDIUM_EDGE)


def at_one_end(order: OrderBy, things: list[Thing]) -> Order | None:
    """ "The biggest at the bottom", and no more: the others stand as they like. None where it is one of several."""
    edges = sorted(((edge_of(t), t.name) for t in things), reverse=order.descending)
    if len(edges) < _FEW or edges[0][0] == edges[1][0]:
        return None
    others = tuple(t.name for t in things if t.name != edges[0][1])
    ranks = ((edges[0][1],), others)
    return Order(by="given", ranks=ranks, first=order.first)  # type: ignore[arg-type]


def _those(noun: Noun, scene: Scene, scope: Scope) -> list[Thing]:
    """The blocks among which it is that one."""
    if noun.part_of is None:
        return matching(replace(noun.traits, rank=None), scene, False)
    used = frozenset(scene.used)
    them = refer(noun.part_of, scene, changed(scope, role="part"))
    scene.mentions.pop()
    if them.patch or them.quant is not None or them.op != "and":
        raise refuse("misplaced", "this is no description of blocks of several sizes", noun.span, "name the blocks")
    those = [scene.things[n] for n in them.names]
    for thing in those:
        thing.declared = True  # "the biggest of three": the others are there as well
    _not_yet_told_of(those, used, scene)
    return those


def _untold(those: list[Thing], scene: Scene) -> bool:
    """ "There are two red blocks. Put the smaller one on the bigger one.": of blocks that look alike and are told apart
    by nothing but their sizes, these are open."""
    looks = {(t.color, t.label, t.kind) for t in those}
    sized = scene.sized is not None or any(t.edge or t.size or t.elastic is not None or t.extra for t in those)
    return len(those) in _TOLD_APART and len(looks) == 1 and not sized
