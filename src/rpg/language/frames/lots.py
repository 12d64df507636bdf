"""Lots of blocks: what a family says of its blocks, and how many there are of each look."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

from rpg.language.frames.pieces import Pattern, Piece, Unclear, number, patterns

_DET = "the|these|those|my|our|your|all|all the|both|both the|a|an|exactly|just|only|the other"
LOTS: list[Pattern] = [
    *patterns("lot", None,
        rf"(?:(?P<det>{_DET}) )?(?:(?P<count>NUM) )?(?:(?P<size>SIZE) )?(?:plain )?(?P<color>COLOR)(?P<many>s)?"
        r"(?: (?P<behind>SIZE))?(?: (?P<noun>BLOCK|ones|one(?! (?:SIZE )?COLOR)))?"),
    *patterns("total", lambda match: number(match["count"]),
        r"(?:of |from |with |using )?(?:the |all |exactly )?(?P<count>NUM) (?:identical |plain )?BLOCK"
        r"(?: in total| in all| altogether| overall)?",
        r"of (?:exactly )?(?P<count>NUM)(?= [,.;])",
        r"(?P<count>NUM) (?:in total|in all|altogether|overall)"),
]  # fmt: skip
"""Kinds "lot" (see `lot_of`) and "total" (a number)."""
_SINGLE = frozenset({"block", "cube", "piece", "element", "tile", "one"})


@dataclass(frozen=True)
class Lot:
    """Blocks of one look. `count`: None where it is left open; `known`: "the red one", which was told before; `plural`:
    several are meant."""

    look: str
    count: int | None = None
    known: bool = False
    plural: bool = False

    @property
    def blocks(self) -> str:
        """The lot as it is told: "2 red blocks", "red blocks"."""
        if self.count is None:
            return f"{self.look} blocks"
        return f"{self.count} {self.look} block{'s' if self.count > 1 else ''}"

    @property
    def again(self) -> str:
        """The lot with its verb where it is spoken of again: "the red block is"."""
        return f"the {self.look} block is" if self.count == 1 else f"the {self.count} {self.look} blocks are"


def lot_of(piece: Piece) -> Lot:
    """The blocks that a piece of the kind "lot" names."""
    named = piece.named
    look = f"{named.get('size') or named.get('behind', '')} {named['color']}".strip()
    det, single = named.get("det", ""), "many" not in named and named.get("noun") in _SINGLE
    count = number(named["count"]) if "count" in named else None
    if count is None and (
        single or det in ("a", "an") or (det == "the" and "noun" not in named and "many" not in named)
    ):
        count = 1
    plural = "many" in named or named.get("noun", "one") not in _SINGLE
    return Lot(look, count, det.split()[:1] in (["the"], ["these"], ["those"], ["both"]), plural)


def as_adjectives(pieces: Sequence[Piece], kind: str = "figure") -> list[Piece]:
    """Without the article of "a red tower", which is that of the tower and not of a red block."""
    found = list(pieces)
    for n, (piece, behind) in enumerate(pairwise(pieces)):
        if piece.kind == "lot" and behind.kind == kind and not {"count", "noun", "many"} & piece.named.keys():
            found[n] = replace(piece, named={**piece.named, "det": "", "many": "s"})
    return found


def counted(lots: Sequence[Lot], total: int | None, *, evenly: bool = False, singly: bool = False) -> list[Lot]:
    """The lots with their numbers, as far as they follow from the number of all of them. `evenly`: several lots whose
    numbers are left open share what is left; `singly`: where nothing else is told each of them is one block.

    Raises:
        Unclear: the numbers do not agree, or do not follow.
    """
    if len({lot.look for lot in lots}) < len(lots):
        raise Unclear
    left = [lot for lot in lots if lot.count is None]
    if lots and total is not None:
        rest = total - sum(lot.count or 0 for lot in lots)
        if rest != 0 if not left else (rest < len(left) or rest % len(left)):
            raise Unclear
        if len(left) > 1 and rest > len(left) and not evenly:
            raise Unclear
        return [lot if lot.count else replace(lot, count=rest // len(left)) for lot in lots]
    if singly and any(lot.plural for lot in left) and len(left) < len(lots):
        raise Unclear  # "four red and blue blocks"
    return [lot if lot.count or not singly else replace(lot, count=1) for lot in lots]


def with_placed(lots: Iterable[Lot], placed: Iterable[tuple[Lot, str]]) -> list[Lot]:
    """All lots: those of the figure, and those that are only told with their place.

    Raises:
        Unclear: "one red block" at a place where red blocks are told of already, or "the red one" where none is.
    """
    found = list(lots)
    first = len(found)
    for lot, _ in placed:
        same = [other for other in found if other.look == lot.look]
        if not same and lot.known and first:
            raise Unclear
        if same and not lot.known and lot.count is not None:
            raise Unclear
        found += [] if same else [replace(lot, count=lot.count or 1)]
    return found


def without_brackets(pieces: Sequence[Piece]) -> list[Piece]:
    """Without the brackets around one place: "red (at the bottom)"."""
    found = list(pieces)
    for n in range(len(found) - 3, -1, -1):
        if [piece.words for piece in found[n : n + 3 : 2]] == ["(", ")"] and found[n + 1].kind == "place":
            found[n : n + 3] = [found[n + 1]]
    return found


_DECLARES = frozenset({
    "has", "have", "having", "consists", "consist", "comprises", "contains", "should", "shall", "must", "with", "made",
    "built", "composed", "formed", "constructed", "assembled", "be", "to",
})  # fmt: skip


def declared(pieces: Sequence[Piece]) -> bool:
    """Whether what stands behind a figure tells what it is to be: "the plus has a red center"; "the plus is red" may
    tell of one that is there."""
    words = " ".join(piece.words for piece in pieces[:3]).split()
    alone = _DECLARES - {"made", "built", "be", "to"}
    return bool(words) and (
        words[0] in alone or (words[0] in ("is", "are") and words[1:2] != [] and words[1] in _DECLARES)
    )


def check_listed(pieces: Sequence[Piece]) -> None:
    """Lots are parted from each other, and are one list.

    Raises:
        Unclear: "a red blue tower", "red and blue, and green and yellow".
    """
    for one, other in pairwise(pieces):
        if one.kind == other.kind == "lot":
            raise Unclear
    for together, run in groupby(pieces, lambda piece: piece.kind in ("lot", "break")):
        said = [piece.words if piece.kind == "break" else piece.kind for piece in run] if together else []
        if said[said.index("lot") :].count("and") > 1 if "lot" in said else False:
            raise Unclear


def check_joined(pieces: Sequence[Piece]) -> None:
    """A number of blocks without a look is one of all, and no item of a list; and a lot is told at once.

    Raises:
        Unclear: "a tower of red and three blocks", "four red blocks, three red blocks".
    """
    for n, piece in enumerate(pieces[1:-1], 1):
        kinds = {pieces[n - 1].kind, pieces[n + 1].kind}
        beside = pieces[n - 1], pieces[n + 1]
        if kinds == {"lot"} and piece.kind == "break" and all("color" in p.named for p in beside):
            lot, other = map(lot_of, beside)
            if lot.look == other.look and other.count and (lot.count or 0) > 1:
                raise Unclear
        total = " ".join(p.words for p in pieces[n - 1 : n + 2] if p.kind == "total").split()
        if piece.words == "and" and kinds == {"lot", "total"} and _OF_ALL.isdisjoint(total):
            raise Unclear


_OF_ALL = frozenset({"total", "all", "altogether", "overall", "of", "from", "with", "using"})


def check_owned(pieces: Sequence[Piece], parts: Collection[str]) -> None:
    """What "has" so many blocks is the whole figure.

    Raises:
        Unclear: "its foot points to the right and has three blocks" tells of the foot; `parts` are such kinds.
    """
    before = ""
    for piece, behind in pairwise(pieces):
        if piece.kind not in ("glue", "break"):
            before = piece.kind
        owns = piece.kind == "glue" and piece.words in ("has", "have", "having", "contains", "contain", "containing")
        if owns and before in parts and behind.kind in ("lot", "total"):
            raise Unclear


def placed_lots(pieces: Sequence[Piece]) -> tuple[list[Lot], list[tuple[Lot, str]]]:
    """The lots of the figure, and those with a place in it: between two breaks each place has the lot beside it.

    Raises:
        Unclear: a place without blocks.
    """
    free: list[Lot] = []
    placed: list[tuple[Lot, str]] = []
    part: list[Piece] = []
    for piece in [*pieces, Piece("break", "")]:
        if piece.kind in ("lot", "place"):
            part.append(piece)
        if piece.kind != "break":
            continue
        kinds = [p.kind for p in part]
        if "place" not in kinds:
            free += map(lot_of, part)
        elif len(kinds) % 2 or kinds != kinds[:2] * (len(kinds) // 2) or kinds[0] == kinds[1]:
            raise Unclear
        else:
            pairs = zip(part[::2], part[1::2], strict=True)
            placed += [(lot_of(a), b.value) if a.kind == "lot" else (lot_of(b), a.value) for a, b in pairs]
        part = []
    return free, placed


def one(pieces: Sequence[Piece], kind: str) -> Piece | None:
    """The one piece of a kind, if there is one; what is said twice in the same way counts once.

    Raises:
        Unclear: there are several.
    """
    found = [piece for piece in pieces if piece.kind == kind]
    if any(piece.value != found[0].value for piece in found):
        raise Unclear
    return found[0] if found else None
