"""What is told of several towers, part by part, with the tower that each part is told of."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.heights_found import MOST, Towers, Which
from rpg.language.frames.towers.heights_words import RANKS

_ALL: Which = ("all", 0)
_GROUP: Which = ("group", 0)
_NEW = frozenset({"a", "an", "another", "one"})
_STOCK = re.compile(r"\b(?:there are|given|i have|we have)\b")
_OF = frozenset({"of", "with", "from", "made of", "consisting of", "built from"})
_HAS = re.compile(r"\b(?:of|with|has|have|having|is|are|be|contains?|containing|consists of)\b|^$")
_FROM = re.compile(r"\b(?:from|out of|using|use)\b")
_CROSSES = {"left of": ("left", 1), "right of": ("left", -1), "in front of": ("front", 1), "behind": ("front", -1)}
_TOLD = {"left of": "to the left of", "right of": "to the right of"}


@dataclass
class Besides:
    """What else is told: whether they stand in a row, one behind the other, or next to each other, and whether blocks
    may be left over."""

    line: bool = False
    behind: bool = False
    mutual: bool = False
    spare: bool = False


def gathered(pieces: Sequence[Piece]) -> tuple[Towers, Besides]:
    """What is told of the towers.

    Raises:
        Unclear: a part may be told of another tower.
    """
    said = _Said()
    for piece in _sized(pieces):
        said.take(piece)
    return said.settled(), said.besides


def _sized(pieces: Sequence[Piece]) -> list[Piece]:
    """A tower and how many blocks it is made of in one piece: "the tower of two blue blocks"."""
    found: list[Piece] = []
    for piece in pieces:
        behind = [p.kind for p in found[-2:]] in (["tower", "glue"], ["tower", "break"]) and found[-1].words in _OF
        if behind and piece.kind == "many" and "color" not in piece.named.keys() & found[-2].named.keys():
            tower = found[-2]
            found[-2:] = [replace(tower, value=piece.value, named={**tower.named, **piece.named})]
        else:
            found.append(piece)
    return found


class _Said:
    """What is being told. `of`: the tower that the clause is of; `last`, `before`: those that were told of last;
    `waits`: what is told of a tower and one that is still to come; `ahead`: what is told of the one that comes next."""

    def __init__(self) -> None:
        self.told, self.besides = Towers(), Besides()
        self.of: Which | None = None
        self.last: Which | None = None
        self.before: Which | None = None
        self.waits: tuple[Piece, Which] | None = None
        self.ahead: tuple[Piece, Which | None] | None = None
        self.sizes: dict[int, int] = {}
        self.after, self.words, self.way = "", "", ""
        self.look, self.each, self.equal = "", 0, False
        self.beside = False
        self.amid: list[Which] = []
        self.group: list[Which] = []

    def take(self, piece: Piece) -> None:
        """Take the next part."""
        if piece.kind in ("glue", "break"):
            self.words = f"{self.words} {piece.words}".strip()
            if piece.kind == "break" and piece.words != "with":
                self._stop()
                self.of, self.beside = None, False
            return
        getattr(self, f"_{piece.kind.replace(' ', '_')}")(piece)
        self.after, self.words = piece.kind, ""

    def settled(self) -> Towers:
        """All that is told, when nothing is left to come."""
        self._stop()
        told = self.told
        count = told.count or max(len(told.looks), len(told.listed))
        if self.ahead or not 2 <= count <= MOST or len(told.looks) > count:
            raise Unclear
        known = len(told.looks)
        told.looks += [""] * (count - known)
        told.count = count
        looks = {look for look in (*told.looks, *told.stock, self.look) if look}
        if len(looks) > 1 and ("" in told.looks or self.look):
            raise Unclear
        told.looks = [look or next(iter(looks), "") for look in told.looks]
        if any(look and look not in told.looks for look in told.stock):
            raise Unclear
        if len(looks) > 1 and any(which.startswith("at ") for which, _ in told.bounds):
            raise Unclear  # "each at least two high": so they need not take all blocks
        if self.each:
            told.facts += [("height", n, None, self.each) for n in range(count)]
        if self.equal:
            told.facts += [("times", n, 0, 1) for n in range(1, count)]
        for which in self.amid:
            if count % 2 == 0:
                raise Unclear
            told.begins(told.first or "left")
            told.facts.append(("at", which, None, count // 2))
        if self.way:
            self._in_order(known)
        return told

    def _in_order(self, known: int) -> None:
        """From one side to the other: as their heights are listed, or as the towers are told."""
        back = self.way in ("right", "back")
        self.told.begins({"right": "left", "back": "front"}.get(self.way, self.way))
        if self.told.listed:
            self.told.listed = self.told.listed[::-1] if back else self.told.listed
            self.told.in_order = True
        elif known == self.told.count:
            self.told.facts += [("at", n, None, -1 - n if back else n) for n in range(known)]
        else:
            raise Unclear

    def _towers(self, piece: Piece) -> None:
        count, color = piece.value
        if self.told.count not in (None, count or self.told.count) or (color and self.look not in ("", color)):
            raise Unclear
        self.told.count, self.look = count or self.told.count, color or self.look
        self.of = _ALL

    def _looks(self, piece: Piece) -> None:
        """A tower of each colour."""
        if self.of != _ALL or self.told.looks:
            raise Unclear
        for color in piece.value:
            self._new(color, None)

    def _tower(self, piece: Piece) -> None:
        which = self._which(piece)
        if self.waits is not None:
            said, of = self.waits
            self.waits = None
            self._link(said, of, which)
            self.beside = True
        elif self.ahead is not None:
            said, other = self.ahead
            self.ahead = None
            if said.kind == "rel":
                self._link(said, which, other)
            else:
                self._put(said, which)
        elif self.after == "tower" and self.of is not None:  # "the left one the taller"
            if isinstance(which, int) or which[0] != "rank":
                raise Unclear
            self.told.facts.append(("rank", self.of, None, which[1]))
        self.of, self.before, self.last = which, self.last if self.last != which else self.before, which

    def _which(self, piece: Piece) -> Which:
        """The tower that is named."""
        named = piece.named
        det, color = named.get("det", ""), named.get("color", "")
        if "side" in named or "middle" in named:
            return self._placed(named)
        if "rank" in named:
            rank = RANKS[named["rank"]]
            if det not in _NEW:
                if color or piece.value:
                    raise Unclear
                return ("rank", rank)
            new = self._new(color, piece.value)
            self.told.facts.append(("more", new, self._other(new), rank))
            return new
        if det in ("the other", "other"):
            other = self._other(self.last, make=True)
            self._is(other, color, piece.value)
            return other
        if det == "the" or (color and det not in _NEW):
            return self._known(color, piece.value)
        return self._new(color, piece.value)

    def _placed(self, named: dict[str, str]) -> Which:
        if "middle" in named:
            if self.told.count != 3:
                raise Unclear
            self.told.begins(self.told.first or "left")
            return ("place", 1)
        self.told.begins("left")
        return ("place", 0 if named["side"].startswith("left") else -1)

    def _known(self, color: str, size: int | None) -> Which:
        """The tower of this colour, or of so many blocks; a new one where there was none."""
        looks = self.told.looks
        found = [
            n for n, look in enumerate(looks) if (color and look == color) or (not color and self.sizes.get(n) == size)
        ]
        if not (color or size) or len(found) > 1:
            raise Unclear
        if not found:
            return self._new(color, size)
        self._is(found[0], color, size)
        return found[0]

    def _new(self, color: str, size: int | None) -> int:
        self.told.looks.append("")
        new = len(self.told.looks) - 1
        self._is(new, color, size)
        return new

    def _is(self, which: Which, color: str, size: int | None) -> None:
        """So many blocks of this colour."""
        if size:
            self.told.facts.append(("height", which, None, size))
        if isinstance(which, int):
            self.sizes |= {which: size} if size else {}
            if color and self.told.looks[which] not in ("", color):
                raise Unclear
            self.told.looks[which] = color or self.told.looks[which]
        elif color:
            raise Unclear

    def _other(self, which: Which | None, *, make: bool = False) -> Which:
        """The other one of two."""
        looks, count = self.told.looks, self.told.count
        if which is None or which == _ALL or count not in (None, 2):
            raise Unclear
        if isinstance(which, tuple):
            kind, n = which
            return (kind, -n if kind == "rank" else -1 - n)
        if len(looks) == 1 and (make or count == 2):
            return self._new("", None)
        if len(looks) != 2:
            raise Unclear
        return 1 - which

    def _group(self, piece: Piece) -> None:
        """Several towers of which so many blocks are told."""
        count, many = self.told.count or 0, piece.named.get("many")
        there = {"outer": 2, "inner": count - 2, "other": count - 1}[piece.value]
        if there < 2 or self.waits or self.ahead or (many and int(many) != there):
            raise Unclear
        inner = range(1, count - 1) if piece.value == "inner" else ()
        self.group = [("place", n) for n in ((0, -1) if piece.value == "outer" else inner)]
        if piece.value != "other":
            self.told.begins(self.told.first or "left")
        elif self.last is None:
            raise Unclear
        self.of = _GROUP

    def _it(self, piece: Piece) -> None:
        if self.waits is not None:
            said, of = self.waits
            other = self.last if self.last != of else self.before
            self.waits = None
            if other is None:
                raise Unclear
            self._link(said, of, other)
        elif self.ahead is not None and self.last is not None and self.ahead[1] is None:
            self.ahead = (self.ahead[0], self.last)
        elif self.last is not None:
            self.of = self.last
        else:
            raise Unclear

    def _many(self, piece: Piece) -> None:
        of_it = self.of is not None and (self.after in ("tower", "it", "towers", "group") or "high" in piece.named)
        color = piece.named.get("color", "")
        if "each" in piece.named and self.of not in (_ALL, _GROUP):
            raise Unclear
        if of_it and self.of == _GROUP:
            for which in self.group:
                self._is(which, color, piece.value)
            if not self.group:
                self.told.facts.append(("others", self.last or 0, None, piece.value))
        elif of_it and self.of != _ALL and _HAS.search(self.words) and self.of is not None:
            self._is(self.of, color, piece.value)
        elif of_it and self.of == _ALL and _HAS.search(self.words) and not _FROM.search(self.words):
            self.each, self.look = piece.value, color or self.look
        elif "high" in piece.named or self.told.stock.get(color, piece.value) != piece.value:
            raise Unclear
        else:
            self.told.stock[color] = piece.value
            self.besides.spare = self.besides.spare or _STOCK.search(self.words) is not None

    def _heights(self, piece: Piece) -> None:
        if self.told.listed or min(piece.value) < 2:
            raise Unclear
        self.told.listed, self.look = tuple(piece.value), piece.named.get("color", "") or self.look

    def _compared(self, piece: Piece) -> None:
        of = self.of if self.of is not None else self.last
        self._stop()
        kind, n = piece.value
        if of is None or of == _GROUP or (of == _ALL and piece.value != ("times", 1)):
            raise Unclear
        if of == _ALL:
            self.equal = True
        elif kind == "most":
            self.told.facts.append(("rank", of, None, n))
        else:
            self.waits = (piece, of)

    def _than(self, piece: Piece) -> None:
        if self.waits is None:
            raise Unclear

    def _rel(self, piece: Piece) -> None:
        if (of := self._told_of(piece)) is not None:
            self.waits = (piece, of)

    def _side(self, piece: Piece) -> None:
        if (of := self._told_of(piece)) is not None:
            self._put(piece, of)

    def _told_of(self, piece: Piece) -> Which | None:
        """The tower whose place is told; None where it comes behind."""
        self._stop()
        if self.of is None or self.of == _ALL:
            self.ahead = (piece, None)
            return None
        if self.beside or self.of == _GROUP:
            raise Unclear
        return self.of

    _middle = _side

    def _put(self, piece: Piece, which: Which) -> None:
        """At this place in the order."""
        if piece.kind == "middle":
            self.amid.append(which)
            return
        side, n = piece.value
        self.told.begins(side)
        self.told.facts.append(("at", which, None, n))

    def _link(self, piece: Piece, one: Which, other: Which | None) -> None:
        """What is told of two towers."""
        if other is None or one == other:
            raise Unclear
        rel, n = piece.value
        if piece.kind == "compared":
            self.told.facts.append((rel, one, other, n))
            return
        crosses = _CROSSES.get(rel)
        if crosses is not None:
            self.told.begins(crosses[0])
            self.told.facts.append(("before", *((one, other) if crosses[1] > 0 else (other, one)), 0))
        if crosses is None or n:
            self.told.rels.append((one, other, f"{n or ''}{_TOLD.get(rel, rel)}"))

    def _stop(self) -> None:
        """Nothing more is told of two towers: one is compared with the other."""
        if self.waits is None:
            return
        said, of = self.waits
        self.waits = None
        if said.kind == "rel":
            raise Unclear
        several = len(self.told.looks) > 2 or (self.told.count or 2) > 2
        self._link(said, of, self.before if several else self._other(of))

    def _unequal(self, piece: Piece) -> None:
        self.told.unequal = True

    def _bound(self, piece: Piece) -> None:
        self.told.bounds.append(piece.value)

    def _mutual(self, piece: Piece) -> None:
        self.besides.mutual = True

    def _line(self, piece: Piece) -> None:
        self.besides.line = True

    def _behind(self, piece: Piece) -> None:
        self.told.begins("front")
        self.besides.behind = True

    def _way(self, piece: Piece) -> None:
        if self.way not in ("", piece.value):
            raise Unclear
        self.way = piece.value

    def _all_used(self, piece: Piece) -> None:
        many = int(piece.value) if piece.value else None
        if many is not None and self.told.stock.get("", many) != many:
            raise Unclear
        self.told.stock |= {"": many} if many is not None else {}
        self.besides.spare = False
