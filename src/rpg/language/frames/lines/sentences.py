"""A row told again, once its blocks, their places and their pattern are known."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from rpg.language.frames.lines.arranged import OPPOSITE, Fact, completed, filled, follows
from rpg.language.frames.lines.plainer import check_about_middle
from rpg.language.frames.lots import Lot, one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.lexicon import SIZE

_PATTERNS = {
    "": "",
    "alternating": " of alternating colors",
    "mirrored": " with mirrored colors",
    "rainbow": " in rainbow order",
    "grouped": " grouped by color",
    "increasing": " by increasing size",
    "decreasing": " by decreasing size",
}
_LENGTHWAYS = {"left": "from left to right", "front": "from front to back"}
_NTH = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
_SIZES = frozenset({*SIZE, "medium", "normal"})
_ENDS = frozenset({"left", "right", "front", "back"})


class Colored:
    """How blocks are named: coloured ones, if nothing else is said."""

    @staticmethod
    def blocks(counts: Counter[str]) -> str:
        """All of them."""
        told = [Lot(look, many).blocks for look, many in counts.items()]
        return " and ".join([", ".join(told[:-1]), told[-1]] if len(told) > 1 else told)

    @staticmethod
    def the(look: str) -> str:
        """The only one of a look."""
        return f"the {look} block"

    @staticmethod
    def an(look: str) -> str:
        """One of several."""
        return f"{'an' if look[0] in 'aeiouAEFHILMNORSX8' else 'a'} {look} block"


@dataclass
class Row:
    """What is known of a row: its noun, the direction in which it is listed, and the pattern of its colours; then how
    many blocks of each look, their order or what is told of places, their number where no look is told, and whether
    the list is set off by a colon or comma."""

    noun: str
    direction: str
    pattern: str
    counts: Counter[str] = field(default_factory=Counter)
    order: list[str] | None = None
    facts: list[Fact] = field(default_factory=list)
    size: int = 0
    set_off: bool = False

    @property
    def near(self) -> str:
        """The end from which its places are counted here."""
        named = {name for name, *_ in self.facts}
        away = "front" in self.direction or named & {"front", "back"}
        return (
            "front" if self.noun == "column" or (away and self.noun == "line") or "front" in self.direction else "left"
        )

    @property
    def first(self) -> str:
        """The end where reading begins."""
        return self.direction.split()[1] if self.direction else self.near


def in_words(row: Row, pieces: Sequence[Piece], names: Colored, lay: str = "") -> str:
    """The row in plain sentences. `lay`: the first of them, where it is told already.

    Raises:
        Unclear: what is told of it cannot be told again.
    """
    if {*row.counts} <= _SIZES and any(piece.kind == "pattern" and "color" in piece.words for piece in pieces):
        raise Unclear  # "small and large blocks of alternating colors"
    check_about_middle(pieces, sum(row.counts.values()), sum(many for *_, many in row.facts))
    if row.near != row.first and row.near not in (row.first, {"right": "left", "back": "front"}.get(row.first)):
        raise Unclear
    noun = "column" if row.near == "front" else "row" if row.direction else row.noun
    return " ".join([lay or _arranged(row, noun, names), *_spacing(pieces), *_where(pieces, noun)])


def _arranged(row: Row, noun: str, names: Colored) -> str:
    if not row.counts:
        return _uncolored(row, noun)
    if row.pattern in ("different", "same") and (
        len(row.counts) != (1 if row.pattern == "same" else sum(row.counts.values()))
    ):
        raise Unclear
    pattern = row.pattern if row.pattern not in ("different", "same") else ""
    size = sum(row.counts.values())
    if size < 2:
        raise Unclear
    lay = f"Lay {names.blocks(row.counts)} in a {noun}"
    if row.order:
        return _listed(row, lay, noun, pattern)
    about_middle = bool(row.facts) and all(name in ("middle", "sides") for name, *_ in row.facts)
    if pattern == "mirrored" and about_middle:
        known = filled(size, row.facts, row.near, row.first)
        row.facts = [] if follows(known, row.counts, pattern) else row.facts
    if not row.facts:
        if pattern == "alternating" and (len(row.counts) != 2 or abs(_difference(row.counts)) > 1 or row.direction):
            raise Unclear
        if (len(row.counts) == 1 and pattern) or (
            pattern == "mirrored" and sum(many % 2 for many in row.counts.values()) > 1
        ):
            raise Unclear
        toward = f" {row.direction}" if row.direction else ""
        if pattern == "alternating" and {*row.counts} <= _SIZES:
            return f"{lay} of alternating sizes."
        return f"{lay}{_PATTERNS[pattern]}{toward}."
    row.facts = _without_rest(row.facts, size)
    slots = filled(size, [fact for fact in row.facts if fact[0] not in ("end", "other")], row.near, row.first)
    left = row.counts - Counter(look for look in slots if look)
    if Counter(look for look in slots if look) - row.counts:
        raise Unclear
    turned = any(name in _ENDS or name in ("first", "last") for name, *_ in row.facts)
    oneway = any(name in ("end", "other") for name, *_ in row.facts)
    if (pattern or len(left) <= 1) and not oneway:
        orders = completed(slots, row.counts, pattern)
        if len(orders) > 1:
            raise Unclear
        if turned or (noun == "row" and orders[0] == orders[0][::-1]):
            return _in_order(row, lay, noun, _LENGTHWAYS[row.near], orders[0])
    if pattern:
        raise Unclear
    return _partly(row, lay, noun, names)


def _without_rest(facts: list[Fact], size: int) -> list[Fact]:
    """What is told of places but for all that is left between two ends.

    Raises:
        Unclear: some blocks in the middle, in no told order.
    """
    names = {name for name, *_ in facts}
    inner = sum(many for name, _, _, many in facts if name == "inner")
    ends = {"end", "other"} <= names or (
        inner and (names & _TWO or {"left", "right"} <= names or {"front", "back"} <= names)
    )
    if inner and (inner != size - 2 or not ends):
        raise Unclear
    kept = [fact for fact in facts if fact[0] != "inner"]
    return [fact for fact in kept if (fact[0], fact[3]) != ("middle", size - 2)] if {"end", "other"} <= names else kept


_TWO = frozenset({"ends", "each end"})


def _difference(counts: Counter[str]) -> int:
    one, other = counts.values()
    return one - other


def _uncolored(row: Row, noun: str) -> str:
    """Blocks of which no look is told."""
    if row.pattern in ("increasing", "decreasing") and not row.size and not row.facts:
        return f"Lay the blocks in a {noun}{_PATTERNS[row.pattern]}{f' {row.direction}' if row.direction else ''}."
    if row.pattern == "rainbow" and row.facts and not row.direction:
        [(name, nth, look, many)] = row.facts
        end = {"first": row.first, "last": OPPOSITE[row.first]}.get(name, name)
        if end not in _ENDS or (nth, many) != (1, 1):
            raise Unclear
        noun = "column" if end in ("front", "back") else noun
        return f"Lay {row.size} blocks in a {noun} in rainbow order, {look} at the {end} end."
    if row.size < 2 or row.facts or row.pattern not in ("", "different", "same", "rainbow", "increasing", "decreasing"):
        raise Unclear
    colors = {"different": " of different colors", "same": " of the same color"}.get(row.pattern, "")
    order = _PATTERNS.get(row.pattern, "") + f" {row.direction}" * bool(row.direction)
    return f"Lay {row.size} blocks{colors} in a {noun}{order}."


def _listed(row: Row, lay: str, noun: str, pattern: str) -> str:
    """A row whose blocks are listed in an order: places and patterns that are told besides agree with it."""
    order = row.order or []
    along = order if row.near == row.first else order[::-1]
    slots = filled(len(order), [fact for fact in row.facts if fact[0] not in ("end", "other")], row.near, row.first)
    if any(name in ("end", "other") for name, *_ in row.facts) or any(
        a not in ("", b) for a, b in zip(slots, along, strict=True)
    ):
        raise Unclear
    if pattern and along not in completed(along, row.counts, pattern):
        raise Unclear
    return _in_order(row, lay, noun, row.direction or _LENGTHWAYS[row.near], order)


def _in_order(row: Row, lay: str, noun: str, direction: str, order: Sequence[str]) -> str:
    """A row in an order; of many colours the order is told alone."""
    if len(row.counts) > 5 and all(look.isalpha() and len(look) > 1 for look in order):
        lay = f"Lay a {noun}"
    told = [f"a {look} block" if look in _SIZES else look for look in order]
    return f"{lay} {direction}: {', '.join(told)}."


def _partly(row: Row, lay: str, noun: str, names: Colored) -> str:
    """A row with some blocks at their places in it."""
    within, behind = [], []
    both = [look for name, _, look, many in row.facts if name in ("end", "other") and many == row.counts[look] == 1]
    if len(both) == 2:
        within.append(f"{both[0]} and {both[1]} at the ends")
    for name, nth, look, many in row.facts:
        end = {"first": row.first, "last": OPPOSITE[row.first]}.get(name, name)
        single = many == row.counts[look] == 1
        if name in ("ends", "each end") and many == 2:
            within.append(f"{names.an(look)} at each end")
        elif not single:
            raise Unclear
        elif len(both) == 2 and name in ("end", "other"):
            continue
        elif name in ("middle", "end", "other"):
            at = {"middle": "in the middle", "end": "at one end", "other": "at the other end"}[name]
            within.append(f"{names.the(look)} {at}")
        elif end in _ENDS:
            behind.append(
                f"T{names.the(look)[1:]} "
                f"is {f'at the {end} end of the {noun}' if nth == 1 else f'{_NTH[nth - 1]} from the {end}'}."
            )
        else:
            raise Unclear
    if behind and within and noun != "row":
        raise Unclear
    return " ".join([f"{lay}{' with ' + ' and '.join(within) if within else ''}.", *behind])


def _spacing(pieces: Sequence[Piece]) -> list[str]:
    """What is told of the gaps.

    Raises:
        Unclear: two things that differ, or a tolerance of nothing.
    """
    told = list(dict.fromkeys(piece.value for piece in pieces if piece.kind == "spacing"))
    even, tolerances = "The row is evenly spaced.", [said for said in told if said.startswith("The tolerance")]
    rest = [said for said in told if said not in tolerances]
    if len(rest) > 1 and even in rest and "touch" not in " ".join(rest):
        rest.remove(even)
    if len(rest) > 1 or len(tolerances) > 1 or (tolerances and (not rest or rest[0] == even or "touch" in rest[0])):
        raise Unclear
    if not tolerances:
        return rest
    return [f"{rest[0][:-1]} with a tolerance of {tolerances[0].removeprefix('The tolerance is ')}"]


def _where(pieces: Sequence[Piece], noun: str) -> list[str]:
    where = one(pieces, "where")
    verbs = all(piece.words.startswith("line up") for piece in pieces if piece.kind == "figure")
    if where and verbs and where.words.startswith(("standing", "sitting", "lying", "resting")):
        raise Unclear  # "line up A and B, standing on the mat": both?
    return [f"The {noun} is {where.value}."] if where else []
