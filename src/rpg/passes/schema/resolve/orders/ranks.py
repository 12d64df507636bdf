"""Blocks by their place or rank: "the top block", "the leftmost cube", "the second block from the left"."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.core.diagnostics import Span
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Amount, At, Noun, Places, Traits, replace
from rpg.passes.schema.resolve.orders.among_places import all_alike, left_alike, pinned, standing_there, wholes
from rpg.passes.schema.resolve.orders.at_an_end import several_at_an_end
from rpg.passes.schema.resolve.orders.by_size import BY_SIZE, by_size
from rpg.passes.schema.resolve.orders.by_value import HIGHEST, by_value, highest
from rpg.passes.schema.resolve.orders.in_grids import CELLS
from rpg.passes.schema.resolve.orders.letter_by_letter import told_alike
from rpg.passes.schema.resolve.orders.one_of_two import one_of_two
from rpg.passes.schema.resolve.orders.positions import SIDES
from rpg.passes.schema.resolve.orders.reordered import begun_in_order
from rpg.passes.schema.resolve.places.sided_patches import sided_patch
from rpg.passes.schema.resolve.things.things import alike, matching
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse, which_one

_FIRST = {"stack": "bottom", "row": "left", "line": "left", "column": "front", "word": "left"}


def ranked(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """The block at a place of the structure spoken of last, or the extreme in size."""
    rank = noun.traits.rank or ""
    if noun.det == "each" and rank.isdigit():  # "on every second one"
        raise refuse("ambiguous", "one block, or each one that comes so many places after another?", noun.span,
                     "name each of their places")  # fmt: skip
    if rank.startswith("@") and (own := _of_the_line(noun, rank[1:], scene)) is not None:
        return own
    if rank.startswith("@") and (told := one_of_two(noun, rank[1:], scene)) is not None:
        return told
    if rank.startswith("@"):
        return sided_patch(noun, rank[1:], scene, scope)
    if rank.startswith("#"):
        return _numbered(noun, rank[1:], scene)
    if rank in HIGHEST:
        return highest(noun, scene)
    if rank in BY_SIZE:
        return by_value(noun, scene) or by_size(noun, scene, scope)
    if rank == "outer":
        return _outer(noun, scene)
    if (left := _left_of_so_many(noun, rank, scene)) is not None:
        return left
    if (several := _several_off_the_top(noun, scene)) is not None:
        return several
    ends = several_at_an_end(noun, wholes(scene), scene, lambda one: ranked(one, scene, scope))
    if ends is not None:
        return ends
    there = () if noun.head == "patch" else _candidates(noun, rank, scene)
    if len(set(there)) > 1:
        raise which_one("this could be a block of several structures", noun.span, "name its colour or label")
    if there:
        return Ref(names=there[:1])
    left_alike(scene, scope)
    if (found_ := _among_alike(noun, rank, scene)) is not None:
        return found_
    if rank == "top" and noun.traits.colors and (top := _top_of_alike(noun, scene.built, scene)) is not None:
        return top
    if (told := _in_the_list(noun, rank, scene)) is not None:
        return told
    if rank.isdigit() or rank == "last":
        raise refuse(
            "no-referent",
            "it is not clear in which order the blocks are counted",
            noun.span,
            "name its colour or its label",
        )
    which = " from the ".join(rank.split())
    raise refuse(
        "no-referent", f"it is not clear which block is the {which} one", noun.span, "name its colour or its label"
    )


def of_the_whole(noun: Noun, whole: Ref, scene: Scene, scope: Scope) -> Ref:
    """ "the top block of the tower": of the one that is named, whichever others there are."""
    scene.mentions.pop()
    plain = replace(noun, part_of=None)
    if noun.amount is not None and noun.amount.low > 1 and len(scene.built) > 1:
        return _several_at_an_end(plain, noun.amount.low, whole, scene)
    found = ranked(plain, scene, scope) if len(scene.built) == 1 else None
    if found is None and noun.traits.rank == "top":
        found = _top_of_alike(plain, whole.built, scene)
    known = whole.built[0] if len(whole.built) == 1 else None
    if found is None and known is not None:
        known = known if known.ordered else begun_in_order(known, scene)
        name = _in(_such(known, plain, scene), noun.traits.rank or "") if known is not None else None
        found = Ref(names=(name,)) if name is not None else None
    if found is None or not {*found.names} <= {*whole.names}:
        raise refuse("no-referent", "it is not clear which block of the tower this is", noun.span,
                     "name its colour or its label")  # fmt: skip
    return found


def top_block(span: Span) -> Noun:
    """ "(Put) the top of the tower (on the mat)": the block there."""
    return Noun(head="block", det="the", amount=Amount(1, 1), traits=Traits(rank="top"), span=span)


def _several_at_an_end(noun: Noun, many: int, whole: Ref, scene: Scene) -> Ref:
    """ "(There are two towers.) Put the top two blocks of the red tower on the blue one"."""
    tower = whole.built[0] if len(whole.built) == 1 and whole.built[0].kind == "stack" else None
    known = tower if tower is None or tower.ordered else begun_in_order(tower, scene)
    names: tuple[str, ...] = ()
    if known is not None and known.ordered and many < len(known.members) and noun.traits.rank in ("top", "bottom"):
        names = known.members[-many:] if noun.traits.rank == "top" else known.members[:many]
    elif tower is not None and many < len(tower.members) and _is_taken(noun, tower, scene):
        names = tower.members[-many:]
        scene.taken |= dict.fromkeys(names, tower.members[:-many])
    if not names:
        raise refuse("no-referent", "it is not clear which blocks of the tower these are", noun.span,
                     "name their colours or their labels")  # fmt: skip
    return Ref(names=names, plural=True, det=noun.det, span=noun.span)


def _several_off_the_top(noun: Noun, scene: Scene) -> Ref | None:
    """ "(A tower of four red blocks.) The top two go on the mat": whichever are moved were on top."""
    there, many = wholes(scene), noun.amount
    tower = there[0] if len(there) == 1 and there[0].kind == "stack" and not there[0].ordered else None
    if tower is None or many is None or many.low != many.high or not 1 < many.low < len(tower.members):
        return None
    if noun.head == "patch" or not _is_taken(noun, tower, scene):
        return None
    names = tower.members[-many.low :]
    scene.taken |= dict.fromkeys(names, tower.members[: -many.low])
    return Ref(names=names, plural=True, det=noun.det, span=noun.span)


def _is_taken(noun: Noun, tower: Built, scene: Scene) -> bool:
    """Whether these come off the top of a tower of look-alikes that is there at first."""
    begun = any({*tower.members} <= {*names_in(fact)} for fact in scene.start_goals)
    return begun and noun.traits.rank == "top" and all_alike(tower, scene)


def middle_of(whole: Ref, span: Span, scene: Scene, scope: Scope) -> Ref | None:
    """ "Its center", of a grid or a plus that was built last: the block that is there."""
    built = next((b for b in scene.built if {*b.members} == {*whole.names}), None)
    if built is None or built.kind not in _WITH_MIDDLES:
        return None
    return ranked(Noun(head="any", det="the", traits=Traits(rank="middle"), span=span), scene, scope)


def _outer(noun: Noun, scene: Scene) -> Ref:
    """ "the outer ones": both ends of the line that was built, which any two of blocks that look alike may be."""
    line = scene.built[0] if len(scene.built) == 1 else None
    ends = (line.members[0], line.members[-1]) if line is not None and len(line.members) > 2 else ()
    plain = noun.traits == Traits(rank="outer") and noun.amount in (None, Amount(2, 2)) and noun.det != "no"
    loose = line is not None and ends and not line.ordered and all_alike(line, scene)
    if line is None or not plain or line.kind not in _LINES or not (loose or line.ordered):
        raise refuse("no-referent", "it is not clear what the outer ones are", noun.span, "name them")
    for name, index in zip(ends, (1, -1), strict=True) if loose else ():
        place = At(side="first", index=index, span=noun.span)
        scene.loose.append((Ref(names=(name,), span=noun.span), place, noun.span))
    return Ref(names=ends, plural=True, det=noun.det, each=noun.det == "each", span=noun.span)


_BOARDS = ("grid", "square", "rectangle")
_CROSSES = ("plus", "X", "cross")
_WITH_MIDDLES = (*_BOARDS, *_CROSSES)
"""Figures that may have one block in their middle."""
_LINES = ("row", "line", "column", "word")


def _of_the_line(noun: Noun, side: str, scene: Scene) -> Ref | None:
    """ "the left one": of the blocks of the one line that was built, where there are no patches."""
    found = wholes(scene)
    line = found[0] if len(found) == 1 and found[0].kind in _LINES else None
    if line is None or noun.head != "any" or any(t.patch for t in scene.things.values()):
        return None
    name = _in(line, side) if line.ordered else None
    return Ref(names=(name,)) if name is not None else _among_alike(noun, side, scene)


def _left_of_so_many(noun: Noun, rank: str, scene: Scene) -> Ref | None:
    """ "the third one" where two of three were spoken of: the one that is left."""
    left = [name for name in scene.whole if name not in scene.parted]
    plain = noun.head == "any" and noun.det == "the" and noun.traits == Traits(rank=rank)
    if not plain or len(left) != 1 or rank not in (str(len(scene.whole)), "last"):
        return None
    scene.parted.add(left[0])
    scene.used.add(left[0])
    return Ref(names=(left[0],))


def _in_the_list(noun: Noun, rank: str, scene: Scene) -> Ref | None:
    """ "There is a green block and a blue one. Put the first in front of the second": in the order of the list, where
    the things in it look different and nothing is built that they could be counted in."""
    lists = [m.ref for m in scene.mentions if m.role == "given"]
    listed = [scene.things[n] for n in dict.fromkeys(n for ref in lists for n in ref.names)]
    listed = [t for t in listed if noun.head == "any" or t.patch == (noun.head == "patch")]
    if scene.built or noun.traits != Traits(rank=rank) or not 1 < len(listed) <= _COUNTED:
        return None
    if len({(t.patch, t.color, t.label) for t in listed}) < len(listed) or any(t.invented or t.extra for t in listed):
        return None
    index = int(rank) if rank.isdigit() else len(listed) if rank == "last" else 0
    found = listed[index - 1] if 0 < index <= len(listed) else None
    return Ref(names=(found.name,), patch=found.patch) if found is not None else None


_COUNTED = 5
"""In longer lists nobody counts."""


def _candidates(noun: Noun, rank: str, scene: Scene) -> tuple[str, ...]:
    """The blocks at such a place of the structures spoken of, the last one first."""
    found: list[str] = []
    for built in reversed(scene.built):
        known = built if built.ordered else begun_in_order(built, scene)
        if known is None or (_counts(rank) and known.kind == "stack" and len(known.members) == 2):
            continue
        name = _in(_such(known, noun, scene), rank)
        if name is not None:
            _told_apart(known, name, noun, scene)
            found.append(name)
    return tuple(found)


def _counts(rank: str) -> bool:
    """Whether a place is counted along a structure, be it upright or not: two blocks on each other have no such."""
    return rank.isdigit() or rank in ("first", "last")


def _such(built: Built, noun: Noun, scene: Scene) -> Built:
    """The members that a place is counted among: "the second red block" of a row is the second of the red ones."""
    if noun.traits == Traits(rank=noun.traits.rank):
        return built
    such = {t.name for t in matching(replace(noun.traits, rank=None), scene, False)}
    return replace(built, members=tuple(name for name in built.members if name in such))


def _told_apart(built: Built, name: str, noun: Noun, scene: Scene) -> None:
    """One of the letters of a word that show the same stands in its own place, or is refused: any of them might."""
    labels = [scene.things[n].label for n in built.members]
    if built.kind not in ("word", "equation") or labels.count(scene.things[name].label) < 2:
        return
    if built.kind == "equation":
        raise told_alike(noun.span)
    scene.one_by_one[built.members] = noun.span


def _numbered(noun: Noun, number: str, scene: Scene) -> Ref:
    """ "red block 2", where several red blocks were spoken of."""
    there = [t for t in matching(replace(noun.traits, rank=None), scene, False) if t.declared]
    if len(there) < 2 or not alike(there) or not 1 <= int(number) <= len(there):
        raise refuse(
            "ambiguous",
            f"this could be a block with a {number} on it, or one of several blocks that look alike",
            noun.span,
            f"say 'labelled {number}', or say first how many such blocks there are",
        )
    return Ref(names=(there[int(number) - 1].name,))


def _among_alike(noun: Noun, rank: str, scene: Scene) -> Ref | None:
    """ "the middle one" of a row of blocks that look alike: any of them, which is then said to stand there."""
    there_are = wholes(scene)
    built = there_are[-1] if there_are else None
    if len(there_are) > 1 and noun.head == "any" and rank.isdigit():
        return _of_structures(noun, int(rank), scene)
    if built is None or built.ordered or len(there_are) > 1 or built.kind not in (*SIDES, *_WITH_MIDDLES):
        return None
    if noun.head == "patch" or (there := pinned(built, scene)) is None:
        return None
    colors = noun.traits.colors
    if not all_alike(built, scene, *there.values()) or (colors and scene.things[built.members[0]].color not in colors):
        return None
    over = [t for t in scene.blocks() if t.name not in built.members and alike([t, scene.things[built.members[0]]])]
    if rank == "last" and over:
        raise refuse("ambiguous", "the last one in it, or the one that is left over?", noun.span,
                     "say 'the remaining one', or at which end it is")  # fmt: skip
    count, _, told = rank.partition(" ")
    if built.kind in (*_CROSSES, *_BOARDS):
        return _in_the_grid(noun, rank, built, scene)
    side = told or {"last": "first"}.get(rank, "first" if rank.isdigit() else rank)
    if side not in ("first", "middle", *SIDES[built.kind][:2]):
        return None
    if side == "middle" and len(built.members) % 2 == 0:
        return None
    index = int(count) if count.isdigit() else -1 if rank == "last" else None
    if index is not None and not -1 <= index <= len(built.members):
        return None
    at_start = any(set(built.members) <= {*names_in(fact)} for fact in scene.start_goals)
    if at_start and built.kind == "stack" and side == "top" and index is None:
        return _taken_from_top(built, noun, scene)
    return standing_there(At(side=side, index=index, span=noun.span), built, noun.span, scene)


def _in_the_grid(noun: Noun, rank: str, built: Built, scene: Scene) -> Ref | None:
    """ "the middle one", "the far left one" of a grid of blocks that look alike."""
    place: At | Places = At(side=rank, own=True, span=noun.span)
    if rank in CELLS and built.kind in _BOARDS:
        place = Places(side=rank, unit="cell", span=noun.span)
    elif rank != "middle":
        return None
    return standing_there(place, built, noun.span, scene)


def _top_of_alike(noun: Noun, towers: Iterable[Built], scene: Scene) -> Ref | None:
    """ "The top red block" of the only tower of red ones at the start: whichever is moved, it was on top."""
    begun = [
        b for b in towers
        if b.kind == "stack" and not b.ordered and all_alike(b, scene)
        and (not noun.traits.colors or scene.things[b.members[0]].color in noun.traits.colors)
        and any(set(b.members) <= {*names_in(fact)} for fact in scene.start_goals)
    ]  # fmt: skip
    return _taken_from_top(begun[0], noun, scene) if len(begun) == 1 else None


def _taken_from_top(tower: Built, noun: Noun, scene: Scene) -> Ref:
    """One of blocks that look alike: whichever is moved was on top, and is taken from the others."""
    *below, top = tower.members
    scene.taken[top] = tuple(below)
    return Ref(names=(top,), span=noun.span)


def _of_structures(noun: Noun, index: int, scene: Scene) -> Ref:
    """ "the first" where two towers were built: the first of them."""
    of_one = any(m.clause == scene.clause and m.role == "theme" and m.ref.built for m in scene.mentions)
    unsaid = not of_one and any(n in scene.on_clause for b in scene.built for n in b.members)
    if noun.traits.colors or unsaid or len({b.kind for b in scene.built}) > 1 or index > len(scene.built):
        raise refuse("ambiguous", "it is not clear which block or structure this is", noun.span, "name it")
    built = scene.built[index - 1]
    return Ref(names=built.members, built=(built,), span=noun.span)


def _in(built: Built, rank: str) -> str | None:
    first = built.side or _FIRST.get(built.kind, "")
    opposite = {
        "bottom": "top",
        "top": "bottom",
        "left": "right",
        "right": "left",
        "front": "back",
        "back": "front",
    }.get(first)
    members = built.members
    if not members:
        return None
    count, _, side = rank.partition(" ")
    if count.isdigit() and side:
        counted = members if side == first else members[::-1] if side in (opposite, "last") else ()
        return counted[int(count) - 1] if int(count) <= len(counted) else None
    if rank == first:
        return members[0]
    if rank == opposite or rank == "last":
        return members[-1]
    if rank == "middle" and len(members) % 2:
        return members[len(members) // 2]
    if rank.isdigit() and int(rank) <= len(members):
        return members[int(rank) - 1]
    return None
