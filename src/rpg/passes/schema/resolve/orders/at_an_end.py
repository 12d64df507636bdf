"""Several blocks at one end of what was built: "the top two blocks", "the two leftmost ones", "the top blocks"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rpg.blocks.nouns import number
from rpg.language.meaning import Noun, replace
from rpg.passes.schema.resolve.orders.reordered import begun_in_order
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse

_ENDS = frozenset({"top", "bottom", "left", "right", "front", "back", "1", "last"})
_UPRIGHT = frozenset({"top", "bottom"})
One = Callable[[Noun], Ref]


def several_at_an_end(noun: Noun, wholes: Sequence[Built], scene: Scene, one: One) -> Ref | None:
    """So many from that end on, or the one that is there of each of several structures; None where one is meant."""
    rank, many = noun.traits.rank or "", noun.amount
    if rank == "middle" and noun.plural and noun.head != "patch" and many is not None and many.low > 1:
        return _inside(noun, many.low, wholes, scene)
    if not noun.plural or noun.head == "patch" or rank not in _ENDS:
        return None
    if many is None and noun.det == "bare":
        return None  # "the top and bottom blocks"
    swapped = scene.verbs.get(scene.clause, (None, False, ""))[2] == "swap"  # "swap the two upper ones"
    paired = many is not None and (many.low, many.high) == (len(wholes), len(wholes)) and rank in _UPRIGHT
    if len(wholes) > 1 and (many is None or (paired and swapped)):
        return _of_each(noun, wholes, scene, one)
    if many is None or many.low != many.high:
        raise refuse("ambiguous", "it is not said how many these are, or of which structures", noun.span,
                     "say 'the two ...', or first what there is, such as 'There are two towers, red on blue and green "
                     "on yellow.'")  # fmt: skip
    names = [name for place in _places(rank, many.low) for name in one(_at(noun, place)).names]
    if len(set(names)) != many.low:
        raise refuse("no-referent", "it is not clear which blocks these are", noun.span, "name them")
    return Ref(names=tuple(names), plural=True)


def _inside(noun: Noun, many: int, wholes: Sequence[Built], scene: Scene) -> Ref:
    """ "The two middle ones": as many on either side of them."""
    whole = wholes[0] if len(wholes) == 1 else None
    known = whole if whole is None or whole.ordered else begun_in_order(whole, scene)
    members = known.members if known is not None else ()
    beside, uneven = divmod(len(members) - many, 2)
    if members and (beside < 1 or uneven):
        told = f"{number(len(members))} blocks have no {number(many)} in their middle"
        raise refuse("count-mismatch", told, noun.span, "name the blocks")
    if not members:
        raise refuse("no-referent", f"it is not clear which the {number(many)} middle ones are", noun.span, "name them")
    return Ref(names=members[beside : beside + many], plural=True)


def _places(rank: str, many: int) -> list[str]:
    if rank == "1":
        return [str(n) for n in range(1, many + 1)]
    return [rank, *(f"{n} {rank}" for n in range(2, many + 1))]


def _at(noun: Noun, rank: str) -> Noun:
    return replace(noun, plural=False, amount=None, traits=replace(noun.traits, rank=rank))


def _of_each(noun: Noun, wholes: Sequence[Built], scene: Scene, one: One) -> Ref:
    """The one at the end of each structure, as though that were the only one."""
    built, names = scene.built, list[str]()
    for whole in wholes:
        scene.built = [whole]
        names += one(_at(noun, noun.traits.rank or "")).names
    scene.built = built
    return Ref(names=tuple(names), plural=True)
