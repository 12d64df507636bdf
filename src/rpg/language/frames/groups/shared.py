"""Several groups or towers side by side: which blocks belong to which of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby

from rpg.language import lexicon
from rpg.language.frames.lots import Lot, lot_of
from rpg.language.frames.pieces import Piece, Unclear, number


@dataclass
class Gathered:
    """Blocks by look: all of them, and those of each place that is told, in the order of the text."""

    lots: dict[str, Lot] = field(default_factory=dict)
    places: list[tuple[str, dict[str, Lot]]] = field(default_factory=list)


def said_of(lots: Iterable[Lot], noun: str = "the blocks ") -> str:
    """Blocks as they are told in a list: "2 red blocks, A and B"."""
    lots = list(lots)
    shown = [lot.look for lot in lots if len(lot.look) == 1 for _ in range(lot.count or 1)]
    plain = [lot.blocks for lot in lots if len(lot.look) > 1]
    if shown and plain:
        plain += [f"1 {glyph} block" for glyph in shown]
    elif shown:
        return (noun if len(shown) > 1 else "") + listed(shown)
    return listed(plain)


def listed(words: Sequence[str]) -> str:
    """ "a, b and c"."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def belongs(name: str, look: str) -> bool:
    """Whether a symbol is of a class."""
    match name:
        case "<vowels>":
            return look in tuple("AEIOU")
        case "<consonants>":
            return look in tuple("BCDFGHJKLMNPQRSTVWXYZ")
        case "<odd>":
            return look in tuple("13579")
        case "<even>":
            return look in tuple("02468")
        case "<letters>":
            return len(look) == 1 and look.isalpha()
        case "<digits>":
            return len(look) == 1 and look.isdigit()
        case "<big>" | "<small>":
            return lexicon.SIZE.get(look.split()[0]) == name.strip("<>")
    return False


_SORT = {"odd": "odd", "even": "even", "vowel": "vowels", "consonant": "consonants"}


def lots_in(piece: Piece) -> list[Lot]:
    """The lots that a piece of the kind "lot" or "glyphs" names; a class of symbols is one: "<vowels>"."""
    if piece.kind == "lot":
        lot, said = lot_of(piece), piece.named
        if said.get("det") in ("every", "each"):
            lot = replace(lot, count=None)
        if "paren" in said or "among" in said:
            count = number(said.get("paren") or said["among"])
            if lot.count not in (None, count):
                raise Unclear
            return [replace(lot, count=count)]
        left_open = "count" not in said and "noun" not in said and said.get("det") not in ("a", "an")
        left_open = left_open or (lot.plural and piece.words.startswith("one of ") and "of the" not in piece.words)
        return [replace(lot, count=None) if left_open else lot]
    if piece.kind == "class":
        return [Lot(piece.value)]
    if int(piece.named.get("number", len(piece.value))) != len(piece.value):
        raise Unclear
    if not all(
        belongs(f"<{_SORT.get(piece.named.get('sort', ''))}>", look) for look in piece.value if "sort" in piece.named
    ):
        raise Unclear
    return [Lot(glyph, count) for glyph, count in Counter(piece.value).items()]


def _added(lots: dict[str, Lot], new: Lot) -> None:
    """A lot put to others: told again it is the same one.

    Raises:
        Unclear: it has another number.
    """
    old = lots.get(new.look)
    if old and old.count and new.count and old.count != new.count:
        raise Unclear
    if old and new.count and not new.known and len(new.look) > 1:
        raise Unclear  # "a red block" beside red blocks that were told before
    lots[new.look] = old if old and old.count else new


def _stretches(pieces: Sequence[Piece]) -> tuple[list[Piece], list[tuple[str, list[Piece]]]]:
    """What stands with no place, and what stands with each: all places stand before their blocks, or all behind."""
    free: list[Piece] = []
    placed: list[tuple[str, list[Piece]]] = []
    part: list[Piece] = []
    for n, piece in enumerate([*pieces, Piece("stop", ".")]):
        if piece.kind in ("lot", "glyphs", "class", "slot"):
            part.append(piece)
        if piece.kind not in ("stop", "from") or (piece.words == ":" and pieces[n - 1].kind == "slot"):
            continue
        if any(p.kind == "slot" for p in part):
            _place(part, free, placed)
        else:
            free += part
        part = []
    return free, placed


def _without_stock(part: list[Piece], kinds: list[bool], free: list[Piece]) -> list[Piece]:
    """The places and their blocks, without those told ahead or behind of which all of them are.

    Raises:
        Unclear: there are none such, or they may be either.
    """
    first, last = kinds.index(True), len(kinds) - kinds[::-1].index(True)
    ahead, behind = part[:first], part[last:]
    classes = all(p.kind in ("slot", "class") for p in part[:last]) and all(p.kind == "glyphs" for p in behind)
    placed_first = classes or _are_of(part[:last], behind)
    if placed_first is _are_of(part[first:], ahead):
        raise Unclear
    free += behind if placed_first else ahead
    return part[:last] if placed_first else part[first:]


def _without_stock_behind(part: list[Piece], free: list[Piece]) -> list[Piece]:
    """ "One pile of reds and one of blues, 3 red, 3 blue": the last lots are those of all the places, told again."""
    last = max(n for n, piece in enumerate(part) if piece.kind == "slot")
    for n in range(last + 2, len(part)):
        if _are_of(part[:n], part[n:]) and len(part) - n == sum(p.kind != "slot" for p in part[:n]) > 1:
            free += part[n:]
            return part[:n]
    return part


def _are_of(placed: Sequence[Piece], stock: Sequence[Piece]) -> bool:
    """Whether the looks of the blocks at the places are those of the stock."""
    return {_look(p) for p in placed if p.kind != "slot"} == {_look(p) for p in stock}


def _look(piece: Piece) -> object:
    return lot_of(piece).look if piece.kind == "lot" else piece.value


_BARE = frozenset({"group", "pile", "cluster", "bunch", "heap", "tower", "stack", "pillar"})
"""Names of things that are told with no article."""


def _place(part: list[Piece], free: list[Piece], placed: list[tuple[str, list[Piece]]]) -> None:
    """Put what is told between two stops to the places, or to what has none.

    Raises:
        Unclear: a place without blocks, or blocks without a place.
    """
    kinds = [piece.kind == "slot" for piece in part]
    if kinds[0] and kinds[-1]:
        raise Unclear
    if not kinds[0] and not kinds[-1]:
        part = _without_stock(part, kinds, free)
        kinds = [piece.kind == "slot" for piece in part]
    if kinds[0]:
        part = _without_stock_behind(part, free)
    runs = [list(run) for _, run in groupby(part, lambda piece: piece.kind == "slot")]
    for n in range(0, len(runs), 2):
        slots, blocks = (runs[n], runs[n + 1]) if kinds[0] else (runs[n + 1], runs[n])
        if len(slots) > 1:
            raise Unclear
        if not kinds[0] and not placed:
            again = [
                k for k, p in enumerate(blocks) if p.kind == "class" and {q.kind for q in blocks[:k]} == {"glyphs"}
            ]
            again = again or [k for k, p in enumerate(blocks) if any(_same(p, q) for q in blocks[:k])]
            free += blocks[: again[0]] if again else []
            blocks = blocks[again[0] :] if again else blocks
        placed.append(("one" if slots[0].value in _BARE else slots[0].value, blocks))


def _same(one: Piece, other: Piece) -> bool:
    return one.kind == other.kind == "lot" and lot_of(one).look == lot_of(other).look


def gathered(pieces: Sequence[Piece]) -> Gathered:
    """The blocks and their places.

    Raises:
        Unclear: a lot is told with two numbers, or a place has no blocks.
    """
    free, placed = _stretches(_in_numbers(pieces))
    found = Gathered()
    each = {piece.value for piece in pieces if piece.kind == "each"}
    for lot in (lot for piece in free for lot in lots_in(piece)):
        _added(found.lots, lot)
    for slot, said in placed:
        found.places.append((slot, _together(said)))
    if len(each) > 1:
        raise Unclear
    if not found.lots and not {"left", "right"} & {slot for slot, _ in found.places}:
        for _, here in found.places:
            here |= {look: replace(lot, count=lot.count or max(each, default=None)) for look, lot in here.items()}
    for look, lot in found.lots.items():
        found.lots[look] = replace(lot, count=lot.count or max(each, default=None))
    return found


def _in_numbers(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Red cube left, blue cube right, three each": without an article the noun does not say that it is one."""
    of_all = any(piece.kind in ("each", "size", "total") for piece in pieces)
    counted = {piece.named["color"] for piece in pieces if piece.kind == "lot" and "count" in piece.named}
    return [
        replace(piece, named={**piece.named, "noun": "blocks", "many": "s"})
        if piece.kind == "lot"
        and not {"det", "count", "many", "paren", "among"} & piece.named.keys()
        and (of_all or piece.named["color"] in counted)
        else piece
        for piece in pieces
    ]


def _together(said: Sequence[Piece]) -> dict[str, Lot]:
    """The blocks of one place; "red, red, blue" is a list of single blocks.

    Raises:
        Unclear: a lot is told twice, and not in such a list.
    """
    lots = [lot for piece in said for lot in lots_in(piece)]
    looks = Counter(lot.look for lot in lots)
    if len(looks) < len(lots):
        bare = all(piece.kind == "lot" and not piece.named.keys() & {"many", "noun", "det", "count"} for piece in said)
        if not bare:
            raise Unclear
        return {look: Lot(look, count) for look, count in looks.items()}
    return {lot.look: lot for lot in lots}


def settled(found: Gathered, belongs: Callable[[str, str], bool]) -> list[tuple[str, list[Lot]]]:
    """Each place with its blocks, where every block has one. `belongs`: whether a class ("vowels") has a symbol.

    Raises:
        Unclear: blocks without a place, or with several; or numbers that do not agree.
    """
    places = [(slot, _members(here, found, belongs)) for slot, here in found.places]
    looks = [look for _, here in places for look in here]
    for look, lot in found.lots.items():
        told = [here[look].count for _, here in places if look in here]
        if not told or (None in told and len(told) > 1):
            raise Unclear
        if lot.count and None not in told and sum(count or 0 for count in told) != lot.count:
            raise Unclear
    if any(looks.count(look) > 1 and here[look].count is None for _, here in places for look in here):
        raise Unclear
    return [
        (
            slot,
            [
                replace(lot, count=lot.count or (found.lots[look].count if look in found.lots else None))
                for look, lot in here.items()
            ],
        )
        for slot, here in places
    ]


def _members(here: dict[str, Lot], found: Gathered, belongs: Callable[[str, str], bool]) -> dict[str, Lot]:
    """The blocks of a place, where those of a class are told one by one elsewhere.

    Raises:
        Unclear: a class that no symbol belongs to, or a symbol beside a class that it does not belong to.
    """
    classes = [look for look in here if look[:1] == "<"]
    own = {look: lot for look, lot in here.items() if look[:1] != "<"}
    if not classes:
        return own
    if own:
        if len(classes) > 1 or not all(belongs(classes[0], look) for look in own):
            raise Unclear
        return own
    elsewhere = {look for _, other in found.places for look in other if other is not here}
    rest = "<rest>" in classes
    members = {
        look: replace(lot, count=None)
        for look, lot in found.lots.items()
        if any(belongs(name, look) for name in classes)
        or (rest and look not in elsewhere and not any(belongs(name, look) for name in elsewhere))
    }
    if not members:
        raise Unclear
    return members


_EXCEPTED = frozenset({"lot", "glyphs", "class", "everything", "every", "each", "total", "glue", "even"})
"""Behind these "but" tells what is not meant."""


def check_clauses(pieces: Sequence[Piece]) -> None:
    """No letter A was taken for an article, and a place on the table is that of all the blocks.

    Raises:
        Unclear: else.
    """
    for n, piece in enumerate(pieces):
        behind = pieces[n + 1] if n + 1 < len(pieces) else Piece("stop", ".")
        if piece.kind == "glue" and piece.words == "a" and behind.kind in ("glyphs", "stop", "break"):
            raise Unclear
        if piece.words == "but" and n and pieces[n - 1].kind in _EXCEPTED:
            raise Unclear  # "everything but the green ones"
        if piece.kind != "where":
            continue
        ends = [k for k in range(n) if pieces[k].kind in ("stop", "break")]
        clause = {p.kind for p in pieces[ends[-1] if ends else 0 : n]}
        if clause & {"lot", "glyphs", "class", "slot"} and "figure" not in clause:
            raise Unclear  # "..., the letters on the blue patch"
