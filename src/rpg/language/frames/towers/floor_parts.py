"""What is told of the floors of a tower: its blocks, and those that lie right on each other."""

from __future__ import annotations

from dataclasses import dataclass, field

from rpg.language.frames.pieces import Piece, Unclear, number

_SINGLE = frozenset({"block", "cube", "piece", "element", "tile", "one"})
_NOT_AGAIN = frozenset({"the", "both the", "all the", "its"})
"""With these a block may be one that was told before."""


@dataclass(frozen=True)
class Item:
    """Blocks of one look. `count`: None where it is left open; `known`: they may have been told before,
    `definite`: they have been."""

    look: str
    count: int | None
    known: bool
    plural: bool
    definite: bool = False


def item_of(piece: Piece) -> Item:
    """The blocks that a piece of the kind "item" names."""
    named = piece.named
    if "glyph" in named:
        return Item(named["glyph"], 1, known=True, plural=False)
    look = f"{named.get('size', '').split(' ')[0]} {named.get('color', '')}".strip()
    det = named.get("det", "")
    single = "many" not in named and named.get("noun") in _SINGLE
    plural = "many" in named or (named.get("noun", "one") not in _SINGLE)
    count = number(named["count"]) if "count" in named else None
    if count is None and (single or det in ("a", "an", "another", "one more", "the other", "the only", "again a")):
        count = 1
    known = det in _NOT_AGAIN or not (det or "count" in named)
    return Item(look, count, known, plural or det.startswith(("all", "both")), definite=det in _NOT_AGAIN)


@dataclass
class Run:
    """Blocks right on each other, from the lowest to the highest. `low`, `high`: the floor of the first from the bottom
    and of the last from the top, from 0, where they are told; `amid`: they are in the middle."""

    looks: list[str]
    low: int | None = None
    high: int | None = None
    amid: bool = False

    @property
    def anchored(self) -> bool:
        """Whether it is told where it is."""
        return self.amid or self.low is not None or self.high is not None


@dataclass
class Tower:
    """What is told so far. `bare`: blocks without a place; `rest`: what all others are like, and
    `inner`: these are in the middle; `related`: blocks are told by what they lie on."""

    way: str | None
    total: int | None
    runs: list[Run] = field(default_factory=list)
    bare: list[Item] = field(default_factory=list)
    rest: Item | None = None
    ends: str | None = None
    inner: bool = False
    related: bool = False
    alternating: bool = False
    last: Run | None = None
    downward: bool = False

    def extend(self, item: Item, *, up: bool) -> None:
        """Blocks on or under those that were told last."""
        run = self.last
        if run is None and len(self.bare) == 1 and not self.runs:
            run = self.begin(self.bare.pop())  # "start with a red one, put a blue one on it"
        if run is None or (run.high if up else run.low) is not None:
            raise Unclear
        looks = [item.look] * number_of(item)
        run.looks[:] = [*run.looks, *looks] if up else [*looks, *run.looks]

    def begin(self, item: Item, count: int | None = None) -> Run:
        """Blocks of which it will be told where they are."""
        run = Run([item.look] * number_of(item, count))
        self.runs.append(run)
        self.last = run
        return run

    def again(self, item: Item) -> bool:
        """Whether a block that has its place already may be spoken of again."""
        known = item.definite or (item.known and self.related)
        return known and item.count in (None, 1) and any(item.look in run.looks for run in self.runs)

    def unplaced(self, item: Item) -> bool:
        """Whether a block was told on others that may now be told with its place: "red, then blue, and blue on top"."""
        having = [run for run in self.runs if item.look in run.looks]
        ends = [run.looks[-1 if run.high is not None else 0] for run in having if run.anchored]
        return item.known and ends != [item.look] * len(having)

    def found(self, item: Item, *, up: bool) -> Run | None:
        """The run with a block that was told before at its top or bottom; None where there is no such block.

        Raises:
            Unclear: something else is on it, or it could be several.
        """
        if not item.known or item.count not in (None, 1):
            return None
        having = [run for run in self.runs if item.look in run.looks]
        if not having:
            return None
        run = having[0]
        if len(having) > 1 or run.looks.count(item.look) > 1 or run.looks[-1 if up else 0] != item.look:
            raise Unclear
        return run


def number_of(item: Item, count: int | None = None) -> int:
    """How many blocks there are.

    Raises:
        Unclear: it is not told.
    """
    if item.count is None and item.plural and count is None:
        raise Unclear
    if item.count is not None and count not in (None, item.count):
        raise Unclear
    return item.count or count or 1
