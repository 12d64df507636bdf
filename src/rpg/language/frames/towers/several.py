"""Several towers: alike, or each with its own blocks or height."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.groups.shared import (
    Gathered,
    check_clauses,
    gathered,
    listed,
    lots_in,
    settled,
)
from rpg.language.frames.groups.shared_words import START
from rpg.language.frames.lots import Lot, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.alike import Told, block_of_one, together, told_in_line
from rpg.language.frames.towers.words import ORD, PATTERNS, TS, T
from rpg.language.grammar.rows.parting import STOPS

__all__ = ["PATTERNS", "told"]

_SINGLE = re.compile("(?:single|one) color|monochrome")
_STACKED = re.compile("(?:is|are) stack(?:ed)?\\b")
_THING = re.compile(f"{T}|{TS}")
_UNIQUE = frozenset({*ORD.split("|"), "other", *"12345ABCDE"})
_NAMED = re.compile(rf"\b(?:{T}|{TS})\b")
_BECOMES = re.compile(r"\b(?:becomes?|turn into)\b")
_WAYS = (["left", "right"], ["left", "middle", "right"])


def told(pieces: Sequence[Piece]) -> str:
    """The towers in plain sentences.

    Raises:
        Unclear: it is not told what they are made of, or how high they are.
    """
    kinds_named = ("figure", "figures", "tinted", "each", "slot", "basis", "whole", "alone")
    named = [piece for piece in pieces if piece.kind in kinds_named]
    if pieces[0].words in ("is", "are", "there are", "there is") or not any(
        _NAMED.search(piece.words) for piece in named
    ):
        raise Unclear
    turned = next((n for n, piece in enumerate(pieces) if _BECOMES.search(piece.words)), 0)
    if any(_NAMED.search(piece.words) for piece in pieces[:turned]):
        raise Unclear  # "a red tower becomes a blue one": the first of them is there no more
    _no_scraps(pieces)
    pieces, mats = _on_mats(pieces)
    check_clauses(pieces)
    if any(a.kind == "lot" and lot_of(a).known and b.kind == "line" for a, b in pairwise(pieces)):
        raise Unclear  # "the yellow ones in a tower and the purple ones lined up"
    if any(a.kind == "lot" and _THING.fullmatch(b.words) for a, b in pairwise(pieces)):
        raise Unclear  # "a red stack"
    kinds = [piece.kind for piece in pieces]
    if any(kinds[n : n + 3] == ["lot", "near", "lot"] for n in range(len(kinds))):
        raise Unclear  # "the red one must not touch the blue one"
    if any(_STACKED.search(f"{a.words} {b.words}") for a, b in pairwise(pieces)):
        raise Unclear  # "four cubes are stacked up; ...": so they are at the start
    pieces, heights = _heights(_one_each(_apart(pieces)))
    kinds = [piece.kind for piece in pieces]
    if "line" in kinds and "slot" in kinds and any(piece.words == "line up" for piece in pieces):
        raise Unclear  # "line up a tower and ...": the towers, or the blocks of the first?
    figures = {piece.value for piece in pieces if piece.kind == "figure" and piece.value}
    if not figures and any(piece.kind == "each" and piece.words.startswith("both") for piece in pieces):
        figures = {2}
    size, where, near, total, relation = (one(pieces, kind) for kind in ("size", "where", "near", "total", "relation"))
    if len(figures) > 1:
        raise Unclear
    told_of = Told(next(iter(figures), None), size.value if size else None, total.value if total else None, heights)
    chains = _chains(pieces)
    if chains:
        text, looks = _stacked(pieces, chains, told_of)
    elif "slot" in kinds:
        text, looks = _one_by_one(pieces, gathered(pieces), told_of)
    else:
        found = gathered(pieces)
        text, looks = together(pieces, found, told_of)
    text += _mats_told(mats, looks, where)
    text += _near_told(near, kinds)
    if relation:
        if (
            not {relation.named["one"], relation.named["other"]} <= set(looks)
            or relation.named["one"] == relation.named["other"]
        ):
            raise Unclear
        text += f" {relation.value}"
    between = one(pieces, "between")
    text += f" A {between.value} block is between the towers." if between else ""
    text += " The towers stand in a row." if "line" in kinds else ""
    text += f" {START}" if "start" in kinds else ""
    return text + (f" The towers are {where.value}." if where else "")


def _no_scraps(pieces: Sequence[Piece]) -> None:
    """Refuse a sentence that says nothing by itself, "On the left.", "Red ones.", "identical" of no look, and "use all
    of them", which are not the blocks of each."""
    if any(a.words in ("use", "using") and b.kind == "each" for a, b in pairwise(pieces)):
        raise Unclear
    identical = any(piece.kind == "figure" and "identical" in piece.words for piece in pieces)
    if identical and not {"lot", "tinted", "basis", "whole", "alone"} & {piece.kind for piece in pieces}:
        raise Unclear
    stops = [-1, *(n for n, piece in enumerate(pieces) if piece.words in STOPS), len(pieces)]
    for begin, end in pairwise(stops):
        said = [piece for piece in pieces[begin + 1 : end] if piece.kind not in ("glue", "break")]
        scrap = [piece.kind for piece in said] == ["slot"] or (
            [piece.kind for piece in said] == ["lot"] and lot_of(said[0]).count is None
        )
        if end > begin + 1 and (scrap or not said):
            raise Unclear


def _on_mats(pieces: Sequence[Piece]) -> tuple[list[Piece], list[tuple[str, str]]]:
    """The pieces without the patches of which each is told of one tower, and the look of the tower of each."""
    said = [piece for piece in pieces if piece.kind in ("lot", "where", "slot", "whole", "alone")]
    blocks = [piece for piece in said if piece.kind in ("lot", "whole", "alone")]
    kinds = ["lot" if piece.kind in ("lot", "whole", "alone") else piece.kind for piece in said]
    places = [piece for piece in said if piece.kind == "where"]
    ways = (
        ["lot", "where"],
        ["where", "lot"],
        ["slot", "lot", "where"],
        ["slot", "where", "lot"],
        ["where", "slot", "lot"],
    )
    if len(places) < 2 or not any(kinds == way * len(places) for way in ways):
        return list(pieces), []
    looks = [lot_of(piece).look if piece.kind == "lot" else _color(piece) for piece in blocks]
    left: list[Piece] = []
    for piece in pieces:
        if piece.kind == "lot" and "slot" not in kinds:
            left.append(Piece("slot", "one tower", "one"))
        left += [piece] if piece.kind != "where" else []
    return left, [(look, place.value) for look, place in zip(looks, places, strict=True)]


def _near_told(near: Piece | None, kinds: Sequence[str]) -> str:
    """How near the towers are to each other.

    Raises:
        Unclear: "next to it", where there are more than two.
    """
    if near is None:
        return ""
    if near.value == "next to it":
        if kinds.count("slot") != 2:
            raise Unclear
        return " The towers are next to each other."
    return f" The towers are {near.value}." if near.value.startswith(("next", "near")) else f" The towers {near.value}."


def _mats_told(mats: Sequence[tuple[str, str]], looks: Sequence[str], where: Piece | None) -> str:
    """On which patch each tower is.

    Raises:
        Unclear: towers that are not told, or two of one colour.
    """
    if mats and (where or len(set(looks)) < len(looks) or set(looks) != {look for look, _ in mats}):
        raise Unclear
    return "".join(f" The {look} tower is {place}." for look, place in mats)


def _color(piece: Piece) -> str:
    """The colour of a tower that is told with it."""
    return str(piece.value[0] if piece.kind == "whole" else piece.value)


def _apart(pieces: Sequence[Piece]) -> list[Piece]:
    """A tower that is told with its colour and its height at once, as a tower and its blocks."""
    found: list[Piece] = []
    alone = [p.kind for p in pieces].count("slot") == 1 and "basis" in [p.kind for p in pieces]
    layered = {"place", "over", "under"} & {piece.kind for piece in pieces}
    for n, piece in enumerate(pieces):
        if piece.kind == "total" and n and pieces[n - 1].kind == "each" and not pieces[n - 1].value:
            found.append(replace(piece, kind="size"))  # "each tower from two cubes"
        elif piece.kind == "each" and piece.value and layered:
            found.append(replace(piece, kind="size"))  # "two blocks each, both red below and white above"
        elif piece.kind == "each" and piece.value == 1 and re.search("(?:for|per) (?:each|every) color", piece.words):
            found.append(replace(piece, kind="basis", value="color"))  # "three red, three green, one for each color"
        elif piece.kind == "figures":
            count, size = piece.value
            found += [replace(piece, kind="figure", value=count), replace(piece, kind="size", value=size)]
        elif piece.kind == "tinted":
            count, color = piece.value
            lot = Piece("lot", color, None, {"color": color, "noun": "blocks"})
            found += [replace(piece, kind="figure", value=count), lot]
        elif piece.kind == "slot" and alone:
            found.append(replace(piece, kind="figure", value=None))  # "for each color build a stack of ..."
        elif piece.kind == "lot" and set(piece.named) == {"det", "color"} and _before_alone(pieces[n + 1 :]):
            found += [Piece("slot", "one tower", "one"), replace(piece, named={**piece.named, "det": "", "many": "s"})]
        elif piece.kind == "alone":
            found += [
                Piece("slot", "one tower", "one"),
                Piece("lot", piece.words, None, {"color": piece.value, "many": "s"}),
            ]
        elif piece.kind == "whole":
            color, size = piece.value
            named = {"color": color, "count": str(size), "noun": "blocks"}
            slot = "other" if piece.words.startswith("the other") else "one"
            found += [Piece("slot", "one tower", slot), Piece("lot", piece.words, None, named)]
        else:
            found.append(piece)
            if piece.kind == "figure" and _SINGLE.search(piece.words):
                found.append(Piece("basis", "single color", "single"))
    return found


def _before_alone(pieces: Sequence[Piece]) -> bool:
    """Whether only a break parts a lot from a tower told with its colour: "a red and a blue tower"."""
    kinds = [piece.kind for piece in pieces[:2]]
    return kinds == ["break", "alone"]


def _one_each(pieces: list[Piece]) -> list[Piece]:
    """ "Two towers three high, one red and one blue": the ones are towers, and no blocks."""
    lots = [piece for piece in pieces if piece.kind == "lot"]
    ones = all(p.words.startswith("one ") and p.named.get("noun") in (None, "one") for p in lots)
    count = [piece.value for piece in pieces if piece.kind == "figure"]
    kinds = {"size" if piece.kind == "each" and piece.value else piece.kind for piece in pieces}
    if not ones or count != [len(lots)] or "size" not in kinds or kinds & {"slot", "place", "over", "under"}:
        return pieces
    found: list[Piece] = []
    for piece in pieces:
        if piece.kind == "even":
            continue  # they are, for the height of each is told
        if piece.kind == "each" and piece.value:
            found.append(replace(piece, kind="size"))  # "three blocks each"
        elif piece.kind == "lot":
            named = {name: said for name, said in piece.named.items() if name in ("color", "size")}
            found += [Piece("slot", "one", "one"), replace(piece, named=named | {"noun": "blocks"})]
        else:
            found.append(piece)
    return found


def _heights(pieces: Sequence[Piece]) -> tuple[list[Piece], list[int]]:
    """The heights that are told of one tower after the other, and the other pieces."""
    listed_ones = one(pieces, "heights")
    heights = list(listed_ones.value) if listed_ones else []
    left = list(pieces)
    slots = [piece for piece in pieces if piece.kind == "slot"]
    for n, piece in enumerate(pieces):
        behind = next((p for p in pieces[n + 1 :] if p.kind != "glue"), None)
        if (
            piece.kind == "slot"
            and behind
            and behind.kind in ("size", "total")
            and piece.value in ("one", "a", "other", "another", "tower", "stack")
        ):
            heights.append(behind.value)
            left.remove(piece)
            left.remove(behind)
    if heights and not listed_ones and len(heights) != len(slots):
        raise Unclear
    return left, heights


def _one_by_one(pieces: Sequence[Piece], found: Gathered, told_of: Told) -> tuple[str, list[str]]:
    """Towers of which each is told with its blocks, and the colours of those that have one.

    Raises:
        Unclear: there are not so many towers, or they are not of one colour each.
    """
    others = {piece.kind for piece in pieces if piece.kind != "each" or not piece.value}
    if {"place", "over", "under", "each", "even"} & others or len(found.places) < 2:
        raise Unclear
    places = settled(found, lambda name, look: False)
    slots = [slot for slot, _ in places]
    if block_of_one(pieces, places):
        raise Unclear
    if told_of.heights or len(places) != (told_of.count or len(places)):
        raise Unclear
    if any(slot in _UNIQUE and slots.count(slot) > 1 for slot in slots) or "other" in slots[:-1]:
        raise Unclear
    towers = []
    for _, lots in places:
        if len(lots) != 1 or len(lots[0].look) == 1:
            raise Unclear
        towers.append(Lot(lots[0].look, lots[0].count or told_of.size))
    numbers_of = [tower.count or 0 for tower in towers]
    if (
        min(numbers_of) < 2
        or told_of.size not in (None, *numbers_of[:1])
        or (told_of.size and len(set(numbers_of)) > 1)
    ):
        raise Unclear
    if told_of.total not in (None, sum(numbers_of)):
        raise Unclear
    looks = [tower.look for tower in towers]
    text = f"Build {len(towers)} towers, {listed([f'one of {tower.blocks}' for tower in towers])}."
    names = [f"the {look} tower" for look in looks] if len(set(looks)) == len(looks) else []
    return text + _sides(pieces, slots, names), looks


def _sides(pieces: Sequence[Piece], slots: Sequence[str], names: Sequence[str]) -> str:
    """Where towers are that are told by their sides, or from left to right.

    Raises:
        Unclear: only some have a side, or they have no names.
    """
    order = [{"center": "middle", "leftmost": "left", "rightmost": "right"}.get(slot, slot) for slot in slots]
    way = any(piece.kind == "way" for piece in pieces)
    if not set(order) & {"left", "right", "middle"}:
        if way and not names:
            raise Unclear
        return told_in_line(names) if way else ""
    if order[-1] in ("other", "another") and len(order) == 2:
        order[-1] = "right" if order[0] == "left" else "left"
    if sorted(order) not in [sorted(one_way) for one_way in _WAYS] or not names or way:
        raise Unclear
    return told_in_line([names[order.index(side)] for side in ("left", "middle", "right") if side in order])


def _chains(pieces: Sequence[Piece]) -> list[tuple[str, list[str]]]:
    """Towers that are told block by block, from the top to the bottom, with the place of each: "red on blue"."""
    said = _symbols_apart([p for p in pieces if p.kind in ("lot", "glyphs", "over", "under", "slot", "place")])
    joined = [piece.kind for piece in said if piece.kind in ("over", "under", "place")]
    if not joined or len(set(joined)) > 1 or any(piece.kind in ("each", "basis", "even") for piece in pieces):
        return []
    runs: list[list[Piece]] = []
    slots = [piece.value for piece in said if piece.kind == "slot"]
    for n, piece in enumerate(said):
        alone = n == 0 or {piece.kind, said[n - 1].kind} <= {"lot", "glyphs"}
        if piece.kind == "slot" or (not slots and alone):
            runs.append([])
        if not runs:
            return []
        runs[-1] += [piece] if piece.kind != "slot" else []
    chains = [_chain(run) for run in runs]
    if len(chains) < 2 or any(len(chain) < 2 for chain in chains):
        return []
    bare = [
        lot_of(piece).look
        for piece in said
        if piece.kind == "lot" and piece.named.get("det") not in ("a", "an") and "count" not in piece.named
    ]
    looks = [look for chain in chains for look in chain]
    levels = {(look, n) for chain in chains for n, look in enumerate(chain)}
    alike = len(chains) in [piece.value for piece in pieces if piece.kind == "figure"]
    if any(looks.count(look) > 1 and not (alike and [at for at, _ in levels].count(look) == 1) for look in bare):
        raise Unclear  # "red on blue and green on red": is it the same one?
    return list(zip(slots or ["one"] * len(chains), chains, strict=True))


def _symbols_apart(said: Sequence[Piece]) -> list[Piece]:
    """ "A over B, C over D": the list B, C ends one tower and begins another."""
    found: list[Piece] = []
    for n, piece in enumerate(said):
        between = 0 < n < len(said) - 1 and {said[n - 1].kind, said[n + 1].kind} <= {"over", "under"}
        if piece.kind == "glyphs" and len(piece.value) == 2 and between:
            found += [replace(piece, value=(glyph,)) for glyph in piece.value]
        else:
            found.append(piece)
    return found


def _same(one: Piece, other: Piece) -> bool:
    """Whether a block is spoken of again: "red is below green and green is below blue"."""
    return one.kind == other.kind and one.kind in ("lot", "glyphs") and lots_in(one) == lots_in(other)


def _chain(run: Sequence[Piece]) -> list[str]:
    """The blocks of a tower from top to bottom; none where they are not one by one."""
    run = [piece for n, piece in enumerate(run) if n == 0 or not _same(run[n - 1], piece)]
    lots = [lot for piece in run if piece.kind in ("lot", "glyphs") for lot in lots_in(piece)]
    looks = [lot.look for lot in lots]
    kinds = ["lot" if piece.kind == "glyphs" else piece.kind for piece in run]
    if any(lot.count not in (None, 1) for lot in lots) or len(kinds) < 3:
        return []
    if "place" not in kinds:
        alternating = kinds[::2] == ["lot"] * len(lots) and kinds[1::2] == kinds[1:2] * (len(lots) - 1)
        return [] if not alternating else looks if kinds[1] == "over" else looks[::-1]
    places = [piece.value for piece in run if piece.kind == "place"]
    if kinds not in (["lot", "place"] * 2, ["place", "lot"] * 2) or sorted(places) != ["at the bottom", "at the top"]:
        return []
    return looks if places[0] == "at the top" else looks[::-1]


def _stacked(pieces: Sequence[Piece], chains: Sequence[tuple[str, list[str]]], told_of: Told) -> tuple[str, list[str]]:
    """Towers that are told block by block.

    Raises:
        Unclear: there are not so many, or not so high.
    """
    slots = [slot for slot, _ in chains]
    heights = [len(chain) for _, chain in chains]
    if told_of.count not in (None, len(chains)) or told_of.heights or told_of.total not in (None, sum(heights)):
        raise Unclear
    if any(told_of.size not in (None, height) for height in heights) or "other" in slots[:-1]:
        raise Unclear
    if any(slot in _UNIQUE and slots.count(slot) > 1 for slot in slots):
        raise Unclear
    towers = [" on ".join(f"1 {look} block" if len(look) > 1 else look for look in chain) for _, chain in chains]
    nth = ["first", "second", "third", "fourth", "fifth"]
    names = [f"the {nth[n]} tower" for n in range(len(chains))] if len(chains) <= len(nth) else []
    return f"Build {len(chains)} towers: {listed(towers)}." + _sides(pieces, slots, names), []
