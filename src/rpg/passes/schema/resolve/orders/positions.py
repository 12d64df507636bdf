"""Places inside a line or a stack: ranks from "with the red block at the bottom"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from rpg.ir.order import Order
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Pronoun, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.left_over import ALONG, all_left, lies_beyond, not_so, one_or_all
from rpg.passes.schema.resolve.orders.parts import Groups, chosen, counted, place_of, so_many, standing
from rpg.passes.schema.resolve.places.either_end import at_an_end, ends_named
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import amount_of, matching, open_to
from rpg.passes.schema.resolve.things.world import Scene, Scope, Thing, refuse

SIDES = {"stack": ("bottom", "top"), "row": ("left", "right", "front", "back"),
         "line": ("left", "right", "front", "back"), "column": ("front", "back", "left", "right")}  # fmt: skip


MAX_ALTERNATIVES = 60
SYMMETRIC = ("ends", "outer", "inner", "middle")
"""Parts that are the same from either end of a line."""


def alternatives(order: Order, scene: Scene, *, line: bool = False) -> list[Order]:
    """The orders that stand for one whose free places are not all next to each other.

    `ranks` ties the blocks of each free run to that run; unless the free blocks look alike, every way to share them out
    is an order of its own. `line`: one on the table, which may begin at either end.
    """
    free = scene.free_runs.pop(order.ranks, ()) if order.by == "given" else ()
    if len(free) < 2:
        return [order]
    pool = [n for index in free for n in order.ranks[index]]
    if len({looks(scene.things[n]) for n in pool}) == 1 and scene.things[pool[0]].color:
        return [order]
    found: list[Order] = []
    for shares in _share_out(tuple(pool), [len(order.ranks[index]) for index in free]):
        ranks = list(order.ranks)
        for index, share in zip(free, shares, strict=True):
            ranks[index] = share
        if not (line and order.first is None and any(o.ranks == tuple(reversed(ranks)) for o in found)):
            found.append(order.model_copy(update={"ranks": tuple(ranks)}))
    if len(found) > MAX_ALTERNATIVES:
        raise refuse("ambiguous", "too many places of this order are left open", None, "name the order of all blocks")
    return found


def _share_out(pool: tuple[str, ...], sizes: list[int]) -> Iterator[tuple[tuple[str, ...], ...]]:
    if not sizes:
        yield ()
        return
    for some in combinations(pool, sizes[0]):
        rest = tuple(n for n in pool if n not in some)
        yield from ((some, *more) for more in _share_out(rest, sizes[1:]))


@dataclass(frozen=True)
class Placed:
    """Ranks from places; `first`: the side that they are counted from, None where either end may be the beginning.

    `paired`: places that come in twos were filled, and nobody said which block is at which of them.
    """

    ranks: tuple[tuple[str, ...], ...]
    first: str | None
    paired: bool = False


def positions(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene) -> Placed | None:
    """ "with the red block at the bottom", "white at both ends, red in between": ranks from places in the line."""
    held: dict[int, tuple[str, ...]] = {}
    rest: list[Absolute] = []
    parts: list[At | Places] = []
    bunches: list[tuple[str, ...]] = []
    swapped = False
    last: int | None = None
    way = 1
    spec.absolutes = [x if place_of(x) is None else not_so(x, names, scene) for x in spec.absolutes]
    one_or_all(spec, names, scene)
    turned = _at_ends(spec, names, kind, scene)
    sides = [place.side for item in spec.absolutes if (place := place_of(item)) is not None]
    ends = "rest" not in sides and ("ends" in sides or "outer" in sides)
    for item in list(spec.absolutes):
        place = place_of(item)
        if place is None or not belongs(item.theme, names, scene):
            continue
        if place.side == "rest" or (place.side == "middle" and ends and _whole(item, place, names, scene)):
            rest.append(item)
            continue
        groups = _following(item, last, way, scene) if place.side == "next" and last is not None else None
        found, last = _put(item, place, groups, held, names, kind, scene)
        if place.side != "next":
            way = -1 if place.side in FAR_ENDS else 1
        last = last + 1 - len(found) if way < 0 else last
        swapped |= kind == "stack" and place.side in ("ends", "outer")
        free = isinstance(place, At) and place.side in (*SIDES[kind], "middle") and not isinstance(item.theme, Noun)
        free = free or (isinstance(item.theme, Noun) and not item.theme.traits.labels)
        bunches += [found] if free or len({looks(scene.things[n]) for n in found}) == 1 else []
        parts.append(place)
        spec.absolutes.remove(item)
    told, beyond = tuple(held), ""
    for item in rest:
        beyond = _check_way(item, parts, kind) or beyond
        filled = _fill(item, held, told, names, scene)
        bunches += [filled] if _of_a_kind(item.theme) else []
        spec.absolutes.remove(item)
    if rest and len(held) < len(names):
        raise refuse("contradiction", "not all that is left is there", rest[-1].span, "say 'everything else'")
    if not held:
        return None
    paired = not beyond and all(p.side in SYMMETRIC for p in parts)
    first = beyond or (None if turned or paired else _side_of(parts, kind))
    if {"odd", "even"} & {p.side for p in parts} and len(names) % 2 == 0:
        scene.assume(f"places are counted from the {first}")
    ranks = tuple(ranks_from(held, names, scene, bunches))
    if swapped and len(scene.free_runs.get(ranks, ())) < 2:
        scene.free_runs[ranks] = (
            0,
            len(ranks) - 1,
        )  # "with an even one at both ends": either may be on top
    return Placed(ranks, first, paired)


def all_told(parts: Sequence[Absolute]) -> int:
    """How many blocks a tower has of which the lowest, the middle and the top one are told; 0 where they are not."""
    places = [x.adjuncts[0] for x in parts if len(x.adjuncts) == 1 and amount_of(x.theme) in (None, 1)]
    single = [x.side for x in places if isinstance(x, At) and x.index is None and not x.whole]
    return len(parts) if len(single) == len(parts) and sorted(single) == ["bottom", "middle", "top"] else 0


def _at_ends(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene) -> bool:
    """Give "one end" and "the other end" their names; whether the line may as well be the other way round."""
    told = [(item, place_of(item)) for item in spec.absolutes if belongs(item.theme, names, scene)]
    placed = [(item, place) for item, place in told if place is not None]
    sides, turned = ends_named([place for _, place in placed], SIDES[kind][0])
    if turned and kind == "stack":
        raise refuse("ambiguous", "the top, or the bottom?", placed[0][1].span, "say 'on top' or 'at the bottom'")
    for (item, place), side in zip([(i, p) for i, p in placed if at_an_end(p)], sides, strict=True):
        named = replace(item, adjuncts=(At(side=side, span=place.span),))
        spec.absolutes[spec.absolutes.index(item)] = named
    return turned


def _side_of(parts: list[At | Places], kind: str) -> str:
    """The side that places are counted from: a line has its own where one was said."""
    sides = {p.side for p in parts}
    if kind == "line" and sides & {"front", "back"}:
        return "front"
    return {"stack": "bottom", "column": "front"}.get(kind, "left")


def _check_way(item: Absolute, parts: list[At | Places], kind: str) -> str:
    """ "(the left one red,) the two to its right white": the side where the line begins, if the rest tells one."""
    ends = ALONG.get(getattr(place_of(item), "beyond", None) or "")
    if ends is None:
        return ""
    along = _side_of([*parts, At(side=ends[0], span=item.span)], kind) == ends[0]
    if not along or not {p.side for p in parts} & {*SIDES["line"], *SIDES["stack"]} <= {*ends}:
        raise refuse("contradiction", "this line does not run that way", item.span, "say 'the others'")
    return ends[0]


FAR_ENDS = ("top", "right", "back")
"""Ends from which on what comes next stands nearer to the beginning of the places."""


def _following(item: Absolute, last: int, way: int, scene: Scene) -> Groups:
    """ "then green", "the next two white": the places after the last one, or before it where the far end was told
    first."""
    place = item.adjuncts[0]
    known = item.theme.word[1:].split() if isinstance(item.theme, Pronoun) and item.theme.word[:1] == "=" else []
    several = place.several if isinstance(place, Places) else None
    count = several or amount_of(item.theme) or max(1, len(getattr(item.theme, "items", known)))
    alike = len({looks(scene.things[n]) for n in known}) == 1 and getattr(place, "whole", None)
    alike = alike or (several and isinstance(item.theme, Noun) and len(item.theme.traits.colors) == 1)
    if way < 0 and count > 1 and not alike:
        raise refuse("ambiguous", "it is not clear in which order these follow", item.span, "name them one by one")
    return [[last + way + way * k] for k in range(count)]


def _put(
    item: Absolute,
    place: At | Places,
    groups: Groups | None,
    held: dict[int, tuple[str, ...]],
    names: tuple[str, ...],
    kind: str,
    scene: Scene,
) -> tuple[tuple[str, ...], int]:
    """Note which blocks stand in a part of the line: the blocks, and its last place."""
    total = len(names)
    theme = item.theme
    if groups is None and isinstance(place, At):
        found = _refer(_single(theme), names, held, item, scene)
        indices = places_of(place, total, len(found), SIDES[kind], kind)
    else:
        groups = groups if groups is not None else line_groups(place, total, kind)
        if not groups:
            told = f"{total} blocks in a {kind} have no such part"
            raise refuse("count-mismatch", told, place.span, "name the blocks")
        indices = [k for group in groups for k in group]
        found = _refer(counted(theme, groups, place), names, held, item, scene)
    if _in_several_lines(theme, found):
        raise refuse("ambiguous", "several blocks are spoken of, and this structure has one of them", item.span,
                     "say it of each structure by itself")  # fmt: skip
    if isinstance(theme, Coord) and len(theme.items) > 2 and isinstance(place, At) and place.index is None:
        told, hint = "this could be the place of all of them or of the last one", "say the order from end to end"
        raise refuse("ambiguous", told, item.span, hint)
    if len({looks(scene.things[n]) for n in found}) == 1 or isinstance(theme, Noun):
        indices = sorted(indices)
    if set(found) >= set(names) or len(found) != len(indices) or any(not 0 <= i < total for i in indices):
        raise refuse("contradiction", "so many blocks have no room there", item.span, "name fewer blocks", blocks=total)
    for index, name in zip(indices, found, strict=True):
        if index in held and held[index] != (name,):
            raise refuse("contradiction", "two blocks are given the same place", item.span, "give each one of its own")
        if any(index != other and there == (name,) for other, there in held.items()):
            raise refuse("contradiction", "one block is given two places", item.span, "give it one of them")
        held[index] = (name,)
    return found, max(indices)


def _in_several_lines(theme: Meaning, found: tuple[str, ...]) -> bool:
    """ "A tower of A and 1 and a tower of B and 2 with the letters on top": several are spoken of, and one is here."""
    if not isinstance(theme, Noun) or theme.det not in ("the", "bare") or theme.amount is not None:
        return False
    return theme.plural and len(found) == 1


def _whole(item: Absolute, place: At | Places, names: tuple[str, ...], scene: Scene) -> bool:
    """ "white in the middle": all of it, however many; a single white one of more blocks is in the very middle."""
    theme = item.theme
    if getattr(place, "several", None) is not None or getattr(place, "own", False):
        return False  # "the middle one blue"
    if not isinstance(theme, Noun) or theme.det != "bare":
        return False
    such = [t for t in matching(theme.traits, scene, False) if t.name in names]
    return theme.amount is None and len(such) != 1


def looks(thing: Thing) -> tuple[object, ...]:
    """What a block is told by."""
    return thing.color, thing.label, thing.size, thing.kind


def _single(theme: Meaning) -> Meaning:
    """ "red at the bottom" is one red block."""
    if isinstance(theme, Noun) and theme.det == "bare" and theme.amount is None and not theme.plural:
        return replace(theme, amount=Amount(1, 1))
    return theme


def _refer(
    theme: Meaning, names: tuple[str, ...], held: dict[int, tuple[str, ...]], item: Absolute, scene: Scene
) -> tuple[str, ...]:
    free = tuple(n for n in names if (n,) not in held.values())
    if inside := so_many(theme, free, scene):
        return inside
    ref = refer(theme, scene, Scope(pool=names))
    if ref.op != "and" or ref.quant is not None:
        raise refuse("ambiguous", "it is not clear which block is here", item.span, "name one block for each place")
    if not set(ref.names) <= set(names):
        raise refuse("misplaced", "this is none of the structure's blocks", item.span, "name it among them")
    scene.mentions.pop()
    return ref.names


def _fill(
    item: Absolute, held: dict[int, tuple[str, ...]], told: Collection[int], names: tuple[str, ...], scene: Scene
) -> tuple[str, ...]:
    """ "and red in between": all the places that are left, or those on one side of all that were `told`; which blocks
    are there."""
    place = place_of(item)
    left = [k for k in range(len(names)) if k not in held and lies_beyond(place, k, told)]
    if not left and len(held) < len(names):
        raise refuse("contradiction", "nothing is left there", item.span, "say 'the others'")
    many = place.several if isinstance(place, Places) and place.beyond else None
    if many is not None and held and many < len(left):  # "the two below them", and others below those
        left = sorted(sorted(left, key=lambda k: min(abs(k - there) for there in held))[:many])
    if not left or not held:
        raise refuse("misplaced", "nothing is left for this", item.span, "leave it out")
    all_left(place, left, told)
    free = tuple(n for n in names if (n,) not in held.values())
    found = standing(item, Places(side="rest", unit="block", span=item.span), [left], free, scene)
    if len(found) != len(left):
        raise refuse("count-mismatch", f"{len(left)} places are left for this", item.span, f"say {len(left)}")
    held.update({k: (name,) for k, name in zip(left, found, strict=True)})
    return found


def _of_a_kind(theme: Meaning) -> bool:
    """ "(Vowels at the ends,) consonants in the middle": in any order among themselves."""
    return isinstance(theme, Noun) and bool(theme.traits.quality or theme.traits.kind) and not theme.traits.labels


def ranks_from(
    places: dict[int, tuple[str, ...]], names: tuple[str, ...], scene: Scene, bunches: Sequence[tuple[str, ...]] = ()
) -> list[tuple[str, ...]]:
    """Ranks from the fixed places of some of `names`; the others fill what is between them. `bunches`: blocks whose
    order among themselves is free."""
    bunch_of = {n: bunch for bunch in bunches for n in bunch}
    taken = {n for rank in places.values() for n in rank}
    remaining = iter([n for n in names if n not in taken])
    ranks: list[tuple[str, ...]] = []
    run: list[str] = []
    for index in range(len(names)):
        if index in places:
            ranks += [tuple(run)] if run else []
            run = []
            bunch = bunch_of.get(places[index][0])
            if bunch and index - 1 in places and places[index - 1][0] in bunch:
                ranks[-1] += places[index]
            else:
                ranks.append(places[index])
        else:
            run.append(next(remaining))
    ranks += [tuple(run)] if run else []
    return _free_runs(ranks, places, scene)


def doubled(names: tuple[str, ...], scene: Scene) -> bool:
    """ "black, white, white, black": a list that names a look twice, not side by side, is meant as an order."""
    looks = [(scene.things[n].color, scene.things[n].label) for n in names]
    runs = [look for i, look in enumerate(looks) if i == 0 or looks[i - 1] != look]
    return len(set(runs)) < len(runs)


def belongs(theme: Meaning, names: tuple[str, ...], scene: Scene) -> bool:
    """Whether a description can be one of the members: it fits one, or one whose looks are open could take it on."""
    if isinstance(theme, Coord):
        return all(belongs(item, names, scene) for item in theme.items)
    if isinstance(theme, Pronoun):
        return not theme.word.startswith("=") or set(theme.word[1:].split()) <= set(names)
    if not isinstance(theme, Noun):
        return False
    plain = replace(theme.traits, rank=None, scheme=None)
    if any(t.name in names for t in matching(plain, scene, False)):
        return True
    return any(open_to(scene.things[n], theme.traits) for n in names)


def _free_runs(ranks: list[tuple[str, ...]], places: dict[int, tuple[str, ...]], scene: Scene) -> list[tuple[str, ...]]:
    """Remember which ranks are free, so that `alternatives` can share their blocks out."""
    fixed = {n for rank in places.values() for n in rank}
    scene.free_runs[tuple(ranks)] = tuple(i for i, r in enumerate(ranks) if r[0] not in fixed)
    return ranks


def line_groups(place: At | Places, total: int, kind: str) -> Groups:
    """The places of a line or a tower that a part names; none where it has no such part."""
    sides = ("front", "back") if place.side in ("front", "back") else SIDES[kind][:2]
    unit = getattr(place, "unit", "block")
    several, index = getattr(place, "several", None), place.index
    if (kind == "row" and place.side in ("front", "back")) or (kind == "column" and place.side in ("left", "right")):
        raise refuse("misplaced", f"a {kind} has no {place.side}", place.span,
                     f"say '{SIDES[kind][0]}' or '{SIDES[kind][1]}', or which block is first")  # fmt: skip
    if unit in ("half", "third"):
        share, left = divmod(total, 2 if unit == "half" else 3)
        if left or several not in (None, 1):
            raise refuse(
                "count-mismatch", f"{total} blocks have no such {unit}", place.span, "say how many blocks it has"
            )
        several = share
        index = None if place.index is None else 1 + (place.index - 1) * share
    elif getattr(place, "each", False) and index is not None and 2 * index <= total:
        raise refuse("ambiguous", "one block, or each one that comes so many places after another?", place.span,
                     "name each of their places, or say 'alternating'")  # fmt: skip
    elif unit == "whole" and place.side in ("first", "last"):
        pass  # of a single line "the first" is a block, and no line
    elif unit not in ("block", "layer" if kind == "stack" else "block"):
        return []
    return [[k] for k in chosen(place.side, index, several, total, (sides[0], sides[1]))]


def places_of(at_: At, total: int, several: int, sides: tuple[str, ...], kind: str) -> list[int]:
    """Places counted from the first side (bottom, left or front)."""
    if at_.side == "middle" and (total - several) % 2:
        raise refuse(
            "count-mismatch",
            f"{total} blocks have no single middle one",
            at_.span,
            "use an odd number of blocks",
            blocks=total,
        )
    sides = sides[:2] if kind in ("row", "column") else sides
    if at_.side not in (*sides, "middle", "first"):
        raise refuse("misplaced", f"a {kind} has no {at_.side}", at_.span, f"say {sides[0]} or {sides[1]}")
    if at_.side in ("right", "top", "back"):
        return [total - (at_.index or 1) - k for k in range(several)]
    if at_.side == "first" and at_.index == -1:
        return [total - 1]
    return [k for (k,) in line_groups(_spread(at_, several), total, kind)]


def _spread(at_: At, several: int) -> Places:
    return Places(side=at_.side, unit="block", index=at_.index, several=several, span=at_.span)
