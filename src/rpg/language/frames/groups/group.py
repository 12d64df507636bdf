"""Blocks in groups: by a property, or lot by lot."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.groups.mixed import among_others, each_alike, excepted, groups_of
from rpg.language.frames.groups.shared import (
    Gathered,
    belongs,
    check_clauses,
    gathered,
    said_of,
    settled,
)
from rpg.language.frames.groups.shared_words import START
from rpg.language.frames.groups.words import GS, KINDS, ORD, PATTERNS, G
from rpg.language.frames.lots import Lot, counted, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.lexicon import COLORS

__all__ = ["PATTERNS", "told"]

_NAMED = re.compile(rf"\b(?:{G}|{GS})\b")
_COMMAND = re.compile(
    "(?:make|build|create|form|put|place|bring|gather|collect|cluster|group|arrange|keep|sort|tidy up|clean up|must|"
    "should|shall|want|need)\\b"
)
_EQUAL = re.compile(r"\b(?:equal|equally|identical|same)\b")
_INTO = re.compile(r"into\b|.*\b(?:together|grouped|apart|with)\b")
_UNIQUE = frozenset({*ORD.split("|"), "here", "there", "other", *"123ABC"})


def told(pieces: Sequence[Piece]) -> str:
    """The groups in plain sentences.

    Raises:
        Unclear: it is not told what belongs together, or how many blocks there are.
    """
    check_clauses(pieces)
    pieces = _one_each(_parted(_put_together(_with_colors(excepted(pieces)))))
    named = {piece.kind for piece in pieces if piece.kind in ("figure", "parted")}
    kinds = [piece.kind for piece in pieces]
    sorts = "basis" in kinds and ("sorted" in kinds or any(_INTO.match(p.words) for p in pieces if p.kind == "basis"))
    sorts = sorts or ("sorted" in kinds and {"here", "there"} <= {piece.value for piece in pieces})
    if not (named or sorts or any(_NAMED.search(piece.words) for piece in pieces if piece.kind in ("slot", "basis"))):
        raise Unclear
    if (alike := each_alike(pieces)) is not None:
        return alike
    found = gathered(pieces)
    figures = {piece.value for piece in pieces if piece.kind == "figure" and piece.value is not None}
    bases = {piece.value for piece in pieces if piece.kind == "basis"}
    sorts_of = {piece.named.get("sort") for piece in pieces if piece.kind == "glyphs"}
    if sorts_of in ({"odd", "even"}, {"vowel", "consonant"}) and not found.places:
        bases.add("odd and even" if "odd" in sorts_of else "vowels and consonants")
    _without_nouns(found, bases)
    for piece in pieces:
        if piece.kind == "basis" and piece.value == "color":  # "red with red and blue with blue, three of each"
            each = one(pieces, "each")
            for look in dict.fromkeys(word.rstrip("s") for word in piece.words.split()):
                if look in COLORS and look not in found.lots:
                    found.lots[look] = Lot(look, each.value if each else None)
    classes = [look for look in found.lots if look[:1] == "<"]
    for look in classes:
        bases.add(KINDS.get(look.strip("<>"), "")) if look != "<rest>" else None
        del found.lots[look]
    if len(bases) > 1 or "" in bases or len(figures) > 1:
        raise Unclear
    basis, count = next(iter(bases), None), next(iter(figures), None)
    total, where, apart = (one(pieces, kind) for kind in ("total", "where", "apart"))
    lots = counted(list(found.lots.values()), total.value if total else None, evenly=_equal(pieces))
    found.lots = {lot.look: lot for lot in lots}
    if found.places:
        text = _by_lots(pieces, found, basis, count)
    elif basis or one(pieces, "strange"):
        text = _by_basis(pieces, found, basis or "color", count)
    else:
        text = _without_basis(pieces, found, count)
    text += f" {apart.value}" if apart else ""
    relation = one(pieces, "relation")
    text += f" {_related(relation, found, basis)}" if relation else ""
    text += f" All blocks are {where.value}." if where else ""
    return text + (f" {START}" if any(piece.kind == "start" for piece in pieces) else "")


def _without_nouns(found: Gathered, bases: set[str]) -> None:
    """Take out "these letters", where they are only what the blocks are called that are told one by one.

    Raises:
        Unclear: there are others among them.
    """
    told = {look for lots in (found.lots, *(here for _, here in found.places)) for look in lots}
    classes = [look for look in told if look[:1] == "<"]
    shown = [look for look in told if look[:1] != "<"]
    for name in ("<letters>", "<digits>"):
        if name not in found.lots or not shown or {"<letters>", "<digits>"} <= set(classes):
            continue
        if len(classes) > 1 or bases - {"letters and digits"}:
            if not all(belongs(name, look) for look in shown):
                raise Unclear
            del found.lots[name]


def _with_colors(pieces: Sequence[Piece]) -> list[Piece]:
    """ "A red pile" as a pile and its blocks.

    Raises:
        Unclear: other blocks are to be in it.
    """
    found: list[Piece] = []
    for piece in pieces:
        if piece.kind == "own":
            before = next((p for p in reversed(found) if p.kind != "glue"), piece)
            if before.kind != "lot" or lot_of(before).look != piece.value:
                raise Unclear
            found.append(Piece("slot", piece.words, "one"))  # "every red block in the red pile"
        elif piece.kind == "alone":
            named = {"color": piece.value, "many": "s"}
            found += [Piece("slot", f"one {piece.words}", "one"), Piece("lot", piece.words, None, named)]
        else:
            found.append(piece)
    return found


def _put_together(pieces: Sequence[Piece]) -> list[Piece]:
    """ "The reds together, the blues together" tells of groups; "together" by itself says nothing."""
    pieces = [
        replace(p, kind="figure", value=None)
        if p.kind == "slot"
        and p.value in ("a", "one")
        and [q.kind for q in pieces[:n] if q.kind != "glue"][-1:] == ["basis"]
        else p
        for n, p in enumerate(pieces)
    ]  # "blocks of the same colour in one pile": one for each of them
    pieces = [replace(p, value="one") if p.value == "together" and " in " in p.words else p for p in pieces]
    found = [piece for piece in pieces if piece.value == "together" and piece.kind == "slot"]
    as_one = [replace(piece, kind="slot" if len(found) > 1 else "glue", value="one") for piece in found]
    sides = {piece.value for piece in pieces if piece.kind == "slot"}
    plain = [as_one.pop(0) if piece in found else piece for piece in pieces]
    return [replace(p, kind="glue") if p.value == "there" and "here" not in sides else p for p in plain]


def _parted(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Separate X from Y": what stands on either side is a group."""
    found = list(pieces)
    begin = 0
    for n, piece in enumerate(pieces):
        if piece.kind == "stop":
            begin = n
        if piece.kind != "from":
            continue
        parted = [k for k in range(begin, n) if pieces[k].kind == "parted"]
        blocks = [k for k in range(begin, n) if pieces[k].kind in ("lot", "glyphs", "class")]
        if not blocks or (piece.words == "from" and not (parted and parted[0] < blocks[0])) or piece.words == "out of":
            continue
        end = next((k for k in range(n + 1, len(pieces)) if pieces[k].kind in ("stop", "from", "figure")), len(pieces))
        if "slot" in [p.kind for p in pieces[begin:end]]:
            continue
        if any(p.words == "there" for p in pieces[n:]):
            raise Unclear  # "take the red one away from the blue one and put the green one there": where it was
        found[n] = Piece("slot", f"group {piece.words}", "one")
        found.insert(end, Piece("slot", "group", "other"))
        found.insert(end + 1, Piece("stop", "."))
        return found
    return found


def _one_each(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Three piles, one red, one blue, one white, with four blocks each": the ones are piles, and no blocks."""
    lots = [piece for piece in pieces if piece.kind == "lot"]
    ones = all(p.words.startswith("one ") and p.named.get("noun") in (None, "one") for p in lots)
    kinds = {piece.kind for piece in pieces}
    count = [piece.value for piece in pieces if piece.kind == "figure" and piece.value]
    if not ones or count != [len(lots)] or not kinds & {"size", "each"} or kinds & {"slot", "basis", "glyphs", "every"}:
        return list(pieces)
    told_of = {"color", "size"}
    found = [
        replace(piece, named={name: said for name, said in piece.named.items() if name in told_of} | {"many": "s"})
        if piece.kind == "lot"
        else piece
        for piece in pieces
    ]
    return [*found, Piece("basis", "one each", "color")]


def _strangers(pieces: Sequence[Piece]) -> str:
    """What is said of strangers in the groups.

    Raises:
        Unclear: it is not said of each group, or not one number.
    """
    strange = one(pieces, "strange")
    every = any(piece.kind == "every" for piece in pieces)
    if strange:
        if not every:
            raise Unclear
        number_each = strange.value
    elif every:
        raise Unclear
    else:
        return ""
    return f" with exactly {number_each} outlier{'s' if number_each > 1 else ''} in each group"


def _by_basis(pieces: Sequence[Piece], found: Gathered, basis: str, count: int | None) -> str:
    """Groups by a property.

    Raises:
        Unclear: there are not so many groups, or a number of blocks is open.
    """
    lots, size, each = list(found.lots.values()), one(pieces, "size"), one(pieces, "each")
    if each and any(lot.count != each.value for lot in lots):
        raise Unclear
    if size:
        lots = [Lot(lot.look, lot.count or size.value) for lot in lots]
        if any(lot.count != size.value for lot in lots) or basis != "color":
            raise Unclear
    if any(lot.count is None for lot in lots) or not lots or any(piece.kind == "odd" for piece in pieces):
        raise Unclear
    sorts = {_of_basis(lot.look, basis) for lot in lots}
    if len(sorts) != (count or len(sorts)) or len(sorts) < 2 or None in sorts:
        raise Unclear
    if any(piece.kind == "mixed" for piece in pieces):
        if basis != "color":
            raise Unclear
        return groups_of(among_others(pieces, lots))
    return f"Group {said_of(lots)} by {basis}{_strangers(pieces)}."


def _of_basis(look: str, basis: str) -> str | None:
    """What a block is by a property."""
    if basis == "color":
        return look.split()[-1] if len(look) > 1 else None
    if basis == "size":
        return look.split()[0] if " " in look else "medium"
    if basis == "label":
        return look if len(look) == 1 else None
    if basis == "kind" and len(look) > 1:
        return "plain"
    names = ["letters", "digits"] if basis == "kind" else basis.split(" and ")
    return next((name for name in names if belongs(f"<{name}>", look)), None)


def _by_lots(pieces: Sequence[Piece], found: Gathered, basis: str | None, count: int | None) -> str:
    """Groups of which each is told with its blocks.

    Raises:
        Unclear: there are not so many groups, or they are not those of the property.
    """
    size, total = one(pieces, "size"), one(pieces, "total")
    if size:
        found.places = [(slot, _filled(here, size.value)) for slot, here in found.places]
    places = settled(found, belongs)
    if len(places) == 1 and total and not found.lots:
        places = [(places[0][0], counted(places[0][1], total.value))]
    if total and total.value != sum(lot.count or 0 for _, lots in places for lot in lots) and not size:
        raise Unclear
    slots = [slot for slot, _ in places]
    told_twice = any(slot in _UNIQUE and slots.count(slot) > 1 for slot in slots)
    if len(places) != (count or len(places)) or told_twice or "other" in slots[:-1] or slots == ["other"]:
        raise Unclear
    if size:
        places = [(slot, counted(lots, size.value)) for slot, lots in places]
    if any(lot.count is None for _, lots in places for lot in lots):
        raise Unclear
    if (each := one(pieces, "each")) and any(lot.count != each.value for _, lots in places for lot in lots):
        raise Unclear
    sorts = [{_of_basis(lot.look, basis) for lot in lots} for _, lots in places] if basis else []
    if basis and (any(len(of) > 1 for of in sorts) or len(set.union(*sorts)) < len(places)):
        raise Unclear
    strangers = _strangers(pieces)
    if strangers:
        if set(slots) & {"left", "right", "middle", "center"} or any(len(lots) > 1 for _, lots in places):
            raise Unclear
        return f"Group {said_of(lots[0] for _, lots in places)} by {basis or 'color'}{strangers}."
    if len(places) == 1:
        if slots[0] not in ("one", "a") or not _asked(pieces):
            raise Unclear
        return f"Make one group of {said_of(places[0][1])}."
    if (
        all(" " in lots[0].look for _, lots in places)
        and len({lots[0].look for _, lots in places}) > 1
        and basis
        in (
            None,
            "size",
        )
        and all(len(lots) == 1 for _, lots in places)
        and len({lots[0].look.split()[-1] for _, lots in places}) == 1
    ):
        return f"Group {said_of(lots[0] for _, lots in places)} by size."
    return groups_of([lots for _, lots in places]) + _sides(places)


def _filled(here: dict[str, Lot], size: int) -> dict[str, Lot]:
    """The blocks of a group of so many of which one colour is left open: "four in each, one all red but for a blue"."""
    open_ = [look for look, lot in here.items() if lot.count is None]
    if len(open_) != 1 or len(open_[0]) == 1 or open_[0][:1] == "<":
        return here
    return {lot.look: lot for lot in counted(list(here.values()), size)}


def _related(relation: Piece, found: Gathered, basis: str | None) -> str:
    """Which of two groups is left of the other.

    Raises:
        Unclear: there are no such groups.
    """
    names = {relation.named["one"], relation.named["other"]}
    groups = {"odd", "even"} if basis == "odd and even" else set(found.lots) if basis == "color" else set()
    if len(names) < 2 or not names <= groups or found.places:
        raise Unclear
    if basis == "color":
        return str(relation.value)
    members = {name: [look for look in found.lots if belongs(f"<{name}>", look)] for name in names}
    if not all(members.values()):
        raise Unclear
    one_of, other_of = (members[relation.named[name]][0] for name in ("one", "other"))
    return f"The group of the {one_of} is {relation.named['side']} of the group of the {other_of}."


def _equal(pieces: Sequence[Piece]) -> bool:
    """Whether the groups have the same number of blocks."""
    return any(p.kind == "even" or (p.kind == "figure" and _EQUAL.search(p.words)) for p in pieces)


def _asked(pieces: Sequence[Piece]) -> bool:
    """Whether something is to be done: what lies in a heap may be told of the start."""
    return any(_COMMAND.search(piece.words) for piece in pieces if piece.kind in ("figure", "glue", "parted"))


def _sides(places: Sequence[tuple[str, Sequence[Lot]]]) -> str:
    """Where groups are that are told by their sides.

    Raises:
        Unclear: only some have a side, or a group has no block of its own by which it can be named.
    """
    order = [slot if slot != "center" else "middle" for slot, _ in places]
    if not set(order) & {"left", "right", "middle"}:
        return ""
    ways = [["left", "right"], ["left", "middle", "right"]]
    named = order if "other" not in order else [*order[:-1], "right" if order[0] == "left" else "left"]
    if sorted(named) not in [sorted(way) for way in ways]:
        raise Unclear
    by_side = dict(zip(named, (lots for _, lots in places), strict=True))
    names = []
    for side in ("left", "middle", "right"):
        if side not in by_side:
            continue
        elsewhere = {lot.look for other, lots in by_side.items() for lot in lots if other != side}
        lot = by_side[side][0]
        if lot.look in elsewhere or (len(by_side[side]) > 1 and len(lot.look) > 1):
            raise Unclear
        names.append(f"group of the {lot.look}" if len(lot.look) == 1 else lot.blocks)
    verbs = ["is" if name.startswith("group") else "are" for name in names]
    return "".join(f" The {a} {verb} left of the {b}." for (a, b), verb in zip(pairwise(names), verbs, strict=False))


def _without_basis(pieces: Sequence[Piece], found: Gathered, count: int | None) -> str:
    """One group, equal groups of look-alikes, or as many groups as there are lots.

    Raises:
        Unclear: it is open which blocks belong together.
    """
    lots, size = list(found.lots.values()), one(pieces, "size")
    kinds = [piece.kind for piece in pieces]
    if any(lot.count is None for lot in lots) or not lots or _strangers(pieces) or count is None:
        raise Unclear
    if count == 1 and not size:
        if not _asked(pieces):
            raise Unclear
        return f"Make one group of {said_of(lots)}."
    if len(lots) == 1 and (size or _equal(pieces)):
        each = size.value if size else (lots[0].count or 0) // count
        if each * count != lots[0].count:
            raise Unclear
        return f"Split {lots[0].blocks} into {count} groups of {each}."
    ahead = [piece.kind for piece in pieces[: kinds.index("figure")]]
    behind = [piece.words for piece in pieces[kinds.index("figure") + 1 :]][:1]
    if count != len(lots) or "lot" in ahead or "glyphs" in kinds or behind not in (["of"], [":"], [","]) or size:
        raise Unclear
    return groups_of([[lot] for lot in lots])
