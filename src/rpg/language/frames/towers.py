"""Several towers: alike, or each with its own blocks or height."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.frames.alike import Told, told_in_line, together
from rpg.language.frames.lots import Lot, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear, number, patterns
from rpg.language.frames.several import (
    LOTS,
    START,
    STARTS,
    STOPS,
    Gathered,
    check_clauses,
    gathered,
    listed,
    lots_in,
    settled,
)
from rpg.language.frames.shared import GLUE, WHERE

_T = "(?:tower|stack|pillar)"
_TS = "(?:towers|stacks|pillars)"
_ADJ = "(?:(?:little|small|neat|separate|identical|equal|single|own|different|similar|individual|short|matching|twin|distinct) )"
_ORD = "first|second|third|fourth|fifth|last|left|right|middle|center|leftmost|rightmost"
_IN = "(?:(?:in|into|as|to|on|forms?|makes?) )?"
_OF = "(?: (?:of|with|has|have|contains|containing|for|is for|BE|from|gets|consists of|consisting of|made of|made out of|made from|made up of|must|should|has to|to|shall|be|built|built from|uses|using|all|entirely|only|completely))*(?: :)?"
_EACH = f"(?:each|every|either|both|all)(?: one)?(?: of (?:them|these|the (?:NUM )?(?:{_TS})))?(?: {_TS}| {_T})?(?! other)"
_HAS = "(?:(?:of|with|has|have|contains|contain|consists of|consist of|consisting of|containing|made of|made from|made up of|BE|must|should|be|to|exactly|shall|will|have|has to|being|getting|gets|get|just|has exactly) )*"
_HIGH = "(?:high|tall|in height)"

PATTERNS = [
    *patterns("line", None, "(?:BE )?(?:lined up |standing |arranged )?(?:in|into|along|forming) (?:a|one) (?:straight |single )?(?:row|line)", "lined up|line up"),
    *patterns("relation", lambda match: f"The {match['one']} tower is {_SIDES[match['side']]} the {match['other']} tower.",
        rf"(?:with )?the (?P<one>COLOR)(?: {_T}| one| BLOCK)? (?:BE )?(?:placed |put )?(?:to the |on the |immediately |at the )*(?P<side>left|right|behind|in front|next|beside)(?: of| to)? (?:the )?(?P<other>COLOR)(?: {_T}| one| BLOCK)?"),
    *patterns("way", None, "(?:(?:reading|read|going|counted|seen) )?(?:from )?(?:the )?left (?:through )?to (?:the )?right(?: :)?"),
    *patterns("between", lambda match: match["color"],
        rf"(?:with |and )?(?:a|one) (?P<color>COLOR) (?:BLOCK|one) (?:BE )?(?:in )?between (?:them|the(?: NUM)? {_TS})"),
    *LOTS,
    *WHERE,
    *STARTS,
    *STOPS,
    *GLUE,
    *patterns("figure", lambda match: number(match["count"]) if match["count"] else None,
        rf"(?:(?:in|into|to|as|of) )?(?:the |exactly |a set of |a group of )*(?:(?P<count>NUM|both|pair of) )?{_ADJ}*{_TS}"),
    *patterns("size", lambda match: number(match["size"]),
        rf"(?:BE )?(?:of |each of |with )?(?:exactly )?(?P<size>[2-9])(?: BLOCK)?(?: (?:{_HIGH}|each|apiece|in each|per {_T}))+",
        rf"of (?:exactly )?(?P<size>[2-9])(?: BLOCK)?(?! (?:COLOR|SIZE)\b)",
        rf"(?:(?:with|where) )?{_EACH} {_HAS}(?P<size>[2-9])(?: BLOCK)?(?: {_HIGH})?(?! (?:COLOR|SIZE|x)\b)",
        rf"(?:BE )?(?:each |both |all )?(?:of |with |at )?(?:a |the )?height (?:of |BE )?(?P<size>[2-9])(?: BLOCK)?(?: each)?", rf"(?P<size>[2-9]) (?:BLOCK )?(?:per|in each|in every|to a|for each|in) {_T}", r"(?:BE )?(?P<size>[2-9]) BLOCK (?:{_HIGH})"),
    *patterns("heights", lambda match: [int(said) for said in re.findall(r"\d", match["list"])],
        r"(?:BE |of |with |having )*(?:the |different )?(?:heights?|sizes) (?:of |: |BE )*(?P<list>[1-9](?:(?: ,)?(?: and)? [1-9])+)(?: BLOCK)?",
        rf"(?:BE |of |with )*(?P<list>[1-9](?:(?: ,)?(?: and)? [1-9])+)(?: BLOCK)? {_HIGH}", r"of (?P<list>[1-9](?: , [1-9])*(?: ,)? and [1-9])(?: BLOCK)?(?! (?:COLOR|SIZE)\b)"),
    *patterns("even", None, "(?:BE |of |with )*(?:the )?(?:same|equal|equally tall|equally high|even|as tall as each other)(?: (?:height|size|high|tall|number of BLOCK))?|equally(?: high| tall)?|alike"),
    *patterns("basis", "color",
        rf"(?:by|per|for each|for every|according to) (?:their |its |the |own )*color", "color wise",
        rf"(?:one|a|an|its own|own) {_ADJ}*{_T} (?:per|for each|for every|of each|of every|for|in each) (?:one )?(?:of the )?colors?",
        rf"one (?:per|for each|for every|of each|of every|for|in each) color", "(?:each|every one|all)(?: one)? (?:in |of |with |has |having )?(?:a |its )?(?:color of its own|own color|color for itself)",
        rf"(?:each|every) color (?:BE |has |have |gets |forms |makes |becomes |goes |should have |must have |must form |must be |should form |into |to |in |on )*(?:a |an |its |one |in )*{_ADJ}*{_T}(?: of its own| for itself| by itself)?",
        rf"{_EACH} (?:tower |stack )?(?:BE )?(?:in |of |with |has |have |having )*a different color", "sorted by color"),
    *patterns("basis", "single",
        rf"{_EACH} {_HAS}(?:only |just |in )*(?:of |blocks of |BLOCK of )*(?:a |one |the )?(?:single|one|same|just one|only one) (?:single )?color(?: only| alone)?",
        rf"{_EACH} BLOCK (?:have|has|BE|of) (?:the )?same color",
        f"(?:each |all )?(?:of|in|with) (?:one|a single|the same|only one) color(?: each| per {_T})?", f"(?:single|one|same) color(?= {_TS})", "(?:no|without) (?:mixed colors|mixing(?: of)? (?:the )?colors)", "(?:do not|never) mix (?:the )?colors"),
    *patterns("basis", "different", f"{_TS} (?:have|of|in|with|BE|are of|are in|have all) different colors"),
    *patterns("each", None, f"(?:(?:in|with|where|of|for|on) )*{_EACH}(?: (?:with|has|have|of|contains?|is|are|must|should|be|consists? of|made of|made from|:))*", "of which each (?:has|is)|each of which (?:has|is|consists of|contains)|apiece"),
    *patterns("place", "at the bottom", "(?:BE )?(?:(?:at|on|in|as|forming) )?(?:the |its )?(?:very )?(?:bottom|base|lower part|foot)(?: (?:one|block|of it))?(?: BE)?(?: :)?", "(?:BE )?(?:the )?lower(?: one| BLOCK)?(?: BE)?", "(?:BE )?(?:below|underneath|under it)"),
    *patterns("place", "at the top", "(?:BE )?(?:(?:at|on|in|as) )?(?:the |its )?(?:very )?top(?: (?:one|block|of it))?(?: BE)?(?: :)?", "(?:BE )?(?:the )?upper(?: one| BLOCK)?(?: BE)?", "(?:BE )?(?:above|above it|over it|on it)"),
    *patterns("over", None, "(?:BE )?(?:directly )?(?:on|upon|over|on top of|above|atop|sitting on|standing on|stacked on)"),
    *patterns("under", None, "(?:BE )?(?:directly )?(?:under|below|beneath|underneath)"),
    *patterns("slot", lambda match: match["slot"],
        rf"{_IN}(?:the |a |an |its )*(?P<slot>one|a|other|another|{_ORD})(?: (?:hand|side))? {_ADJ}*{_T}{_OF}",
        rf"{_IN}(?:the )?(?P<slot>other|another|{_ORD})(?! BLOCK)(?: one| hand one)?{_OF}", rf"in (?P<slot>one)(?: of them)?(?: of)?",
        rf"(?P<slot>one) (?:of|with|has|contains|containing|is|from|consists of|consisting of|made of|made from|gets|:)(?: (?:of|for|all|entirely|only))*", rf"(?P<slot>a) {_ADJ}*{_T}{_OF}"),
    *patterns("near", "next to each other", f"(?:(?:{_TS} )?BE )?(?:right |standing |closely )*(?:next to|beside) (?:each other|one another)|side by side|adjacent(?: to each other)?|neighboring"),
    *patterns("near", "touch", f"(?:that |which |so that |and |with |the )*(?:they |{_TS} )*(?:BE )?(?:must |should |all )?(?:touching|touch)(?: (?:each other|one another))?", "no gaps? between (?:them|the towers)"),
    *patterns("near", "do not touch", f"(?:that |which |so that |and |the )*(?:they |{_TS} )*(?:must|may|should|shall|do|can|are) not (?:be )?(?:touch|touching)(?: (?:each other|one another))?", f"without touching(?: (?:each other|one another))?|not touching(?: (?:each other|one another))?"),
    *patterns("near", lambda match: f"are {match['least'] or ''}{match['length']} {match['unit']} apart",
        rf"(?:with |the |that |which )*(?:{_TS} )?(?:BE )?(?:(?P<least>at least) )?(?P<length>[\d.]+) (?P<unit>cm|mm) (?:apart|from each other|away from each other)"),
    *patterns("glue", None, "(?:the )?colors|sort|sorted|divide|divided|split|split up|distribute|distributed|distribute over|over|stack|stacked|up|separate|so that|such that|so|that|block|to"),
]  # fmt: skip
_SIDES = {"left": "left of", "right": "right of", "behind": "behind", "in front": "in front of", "next": "next to", "beside": "next to"}
_UNIQUE = frozenset({*_ORD.split("|"), "other"})
_NAMED = re.compile(rf"\b(?:{_T}|{_TS})\b")
_WAYS = (["left", "right"], ["left", "middle", "right"])


def told(pieces: Sequence[Piece]) -> str:
    """The towers in plain sentences.

    Raises:
        Unclear: it is not told what they are made of, or how high they are.
    """
    check_clauses(pieces)
    named = [piece for piece in pieces if piece.kind in ("figure", "slot", "basis")]
    if pieces[0].words in ("is", "are", "there are", "there is") or not any(_NAMED.search(piece.words) for piece in named):
        raise Unclear
    pieces, heights = _heights(pieces)
    kinds = [piece.kind for piece in pieces]
    if "line" in kinds and "slot" in kinds and any(piece.words == "line up" for piece in pieces):
        raise Unclear  # "line up a tower and ...": the towers, or the blocks of the first?
    figures = {piece.value for piece in pieces if piece.kind == "figure" and piece.value}
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
    if near:
        text += f" The towers are {near.value}." if near.value.startswith("next") else f" The towers {near.value}."
    if relation:
        if not {relation.named["one"], relation.named["other"]} <= set(looks) or relation.named["one"] == relation.named["other"]:
            raise Unclear
        text += f" {relation.value}"
    between = one(pieces, "between")
    text += f" A {between.value} block is between the towers." if between else ""
    text += " The towers stand in a row." if "line" in kinds else ""
    text += f" {START}" if "start" in kinds else ""
    return text + (f" The towers are {where.value}." if where else "")


def _heights(pieces: Sequence[Piece]) -> tuple[list[Piece], list[int]]:
    """The heights that are told of one tower after the other, and the other pieces."""
    listed_ones = one(pieces, "heights")
    heights = list(listed_ones.value) if listed_ones else []
    left = list(pieces)
    slots = [piece for piece in pieces if piece.kind == "slot"]
    for n, piece in enumerate(pieces):
        behind = next((p for p in pieces[n + 1 :] if p.kind != "glue"), None)
        if piece.kind == "slot" and behind and behind.kind in ("size", "total") and piece.value in ("one", "a", "other", "another"):
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
    if {"place", "over", "under", "each", "even"} & {piece.kind for piece in pieces} or len(found.places) < 2:
        raise Unclear
    places = settled(found, lambda name, look: False)
    slots = [slot for slot, _ in places]
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
    if min(numbers_of) < 2 or told_of.size not in (None, *numbers_of[:1]) or (told_of.size and len(set(numbers_of)) > 1):
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
    said = [piece for piece in pieces if piece.kind in ("lot", "glyphs", "over", "under", "slot", "place")]
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
    bare = [lot_of(piece).look for piece in said if piece.kind == "lot" and piece.named.get("det") not in ("a", "an") and "count" not in piece.named]
    looks = [look for chain in chains for look in chain]
    if any(looks.count(look) > 1 for look in bare):
        raise Unclear  # "red on blue and green on red": is it the same one?
    return list(zip(slots or ["one"] * len(chains), chains, strict=True))


def _chain(run: Sequence[Piece]) -> list[str]:
    """The blocks of a tower from top to bottom; none where they are not one by one."""
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
