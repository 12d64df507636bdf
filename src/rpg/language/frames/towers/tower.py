"""One tower."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.language.frames.lots import LOTS, Lot, check_listed, counted, lot_of, one, placed_lots, with_placed
from rpg.language.frames.pieces import Piece, Unclear, numbers, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE
from rpg.language.lexicon import SIZE

_LISTED = "(?:(?:going|reading|listed|counting|ordered|read|told) )?(?:from )?(?:the )?"
PATTERNS = [
    *LOTS,
    *WHERE,
    *BREAKS,
    *GLUE,
    *patterns("figure", "tower",
        "(?:one |single |tall |vertical )*(?:tower|stack|pillar)", "on top of (?:each other|one another)"),
    *patterns("height", numbers("height"),
        "(?P<height>NUM) (?:BLOCK )?(?:high|tall|in height)", "(?:with )?(?:a )?height (?:of |: |is "
        ")?(?P<height>NUM)(?: BLOCK)?"),
    *patterns("place", "at the bottom",
        "(?:BE )?(?:at|on|as|in|forming) the (?:very )?(?:bottom|base|lowest place)(?: of it)?", "(?:BE )?(?:at|on) "
        "bottom",
        "(?:BE )?(?:the )?(?:lowest|undermost|bottommost)", "bottom :?"),
    *patterns("place", "at the top",
        "(?:BE )?(?:on|at) (?:the (?:very )?)?top(?: of (?:it|them|all|everything))?",
        "(?:BE )?(?:the )?(?:highest|uppermost|topmost)", "top :?"),
    *patterns("place", "in the middle",
        "(?:BE )?(?:right )?in (?:the |its )?(?:very |exact )?(?:middle|center)(?: of (?:it|them)| between them)?",
        "(?:BE )?(?:in )?between(?: them)?", "middle :?"),
    *patterns("place", "under it", "(?:BE )?(?:under|below|underneath|beneath) (?:it|them)"),
    *patterns("place", "over it", "(?:BE )?(?:over|above) (?:it|them)"),
    *patterns("order", "from bottom to top",
        f"{_LISTED}bottom (?:end )?to (?:the )?top", "(?:from )?(?:the )?bottom up(?:wards)?",
        "(?:starting|beginning) (?:at|from) the bottom", "from (?:the )?bottom(?= [:,])", f"{_LISTED}lowest to "
        f"(?:the )?highest"),
    *patterns("order", "from top to bottom",
        f"{_LISTED}top (?:end )?to (?:the )?bottom", "(?:from )?(?:the )?top down(?:wards)?",
        "(?:starting|beginning) (?:at|from) the top", "from (?:the )?top(?= [:,])", f"{_LISTED}highest to (?:the "
        f")?lowest"),
    *patterns("colors", "alternating",
        "(?:in )?(?:strictly )?(?:alternating|alternate|alternates|alternately|alternation|striped)(?: colors| "
        "pattern| order)?",
        "(?:in )?(?:taking|take) turns", "by turns"),
    *patterns("colors", "different",
        "(?:each|all|every one)(?: one| of them| BLOCK)?(?: BE)?(?: has| of| in)?(?: a)? different colors?",
        "(?:of |in )?(?:all )?different colors"),
]  # fmt: skip
_ASIDE = {"under it": "at the bottom", "over it": "at the top"}
"""Where blocks are that are told by the one in the middle."""


def told(pieces: Sequence[Piece]) -> str:
    """The tower in plain sentences.

    Raises:
        Unclear: it is not told which blocks it is made of, or in which order.
    """
    check_listed(pieces)
    at = [n for n, piece in enumerate(pieces) if piece.kind == "figure"]
    ahead = " ".join(piece.words for piece in pieces[: at[0]]) if at else ""
    if (
        len(at) != 1
        or ahead == "the"
        or (ahead.endswith(("and a", "and")) and "lot" in [p.kind for p in pieces[: at[0]]])
    ):
        raise Unclear  # "the stack is ..." tells of the start; "two white blocks and a tower" is more than a tower
    height, total, order, colors, where = (
        one(pieces, kind) for kind in ("height", "total", "order", "colors", "where")
    )
    size = total.value if total else height.value["height"] if height else None
    if height and height.value["height"] != size:
        raise Unclear
    text = _ordered(pieces, size, order.value) if order else _placed(pieces, size, colors.value if colors else "")
    return f"{text} The tower is {where.value}." if where else text


def _placed(pieces: Sequence[Piece], size: int | None, colors: str) -> str:
    """A tower with some blocks at their places in it."""
    free, placed = placed_lots(pieces)
    if any(a.kind == "lot" and b.kind == "figure" and lot_of(a) in free for a, b in pairwise(pieces)):
        if len(free) > 1:
            raise Unclear  # "a cyan tower and a brown one"
        free = [Lot(free[0].look)]
    alternating = colors == "alternating"
    lots = counted(with_placed(free, placed), size, evenly=alternating, singly=len(free) > 1)
    places = [_ASIDE.get(place, place) for _, place in placed]
    if len(set(places)) < len(places) or not (lots or size) or any(lot.count is None for lot in lots):
        raise Unclear
    if any(place in _ASIDE for _, place in placed) and placed[0][1] != "in the middle":
        raise Unclear
    if (
        size
        and len(free) == 1
        and placed
        and free[0].count is None
        and free[0].look not in [lot.look for lot, _ in placed]
    ):
        raise Unclear  # "four blocks, blue with a red one on top"
    if (
        len(lots) - len(placed) > 1
        and len(lots) > 2
        and not alternating
        and all(lot.count == 1 for lot in lots)
        and placed
    ):
        raise Unclear  # the list may tell the order as well
    if alternating and any(lot.look in SIZE for lot in lots):
        raise Unclear  # sizes alternate, or colors that are not told?
    blocks = " and ".join(lot.blocks for lot in lots) or f"{size} blocks"
    text = f"Build a tower{' of alternating colors' if alternating else ''} from {blocks}"
    text += ", each a different color." if colors == "different" else "."
    for (lot, _), place in zip(placed, places, strict=True):
        known = next(other for other in lots if other.look == lot.look)
        if known.count != 1 and (lot.count is None or (lot.known and lot.count == 1)) and not alternating:
            raise Unclear  # all of them, or one of them?
        again = f"a {lot.look} block is" if known.count != 1 and alternating else Lot(lot.look, lot.count or 1).again
        text += f" {again.capitalize()} {place}."
    return text


def _ordered(pieces: Sequence[Piece], size: int | None, order: str) -> str:
    """A tower whose blocks are listed in an order: nothing else stands between them."""
    at = [n for n, piece in enumerate(pieces) if piece.kind == "lot"]
    between = {piece.kind for piece in pieces[at[0] : at[-1]]} if len(at) > 1 else {""}
    lots = [lot_of(pieces[n]) for n in at]
    listed = [lot.look for lot in lots for _ in range(lot.count or 1)]
    if not between <= {"lot", "break", "glue"} or size not in (None, len(listed)):
        raise Unclear
    if one(pieces, "colors") or any(piece.kind == "place" for piece in pieces):
        raise Unclear
    if any(piece.words in (".", ";") for piece in pieces[at[0] : at[-1]]):
        raise Unclear  # two lists, or blocks that are told before
    blocks = " and ".join(Lot(look, listed.count(look)).blocks for look in dict.fromkeys(listed))
    return f"Build a tower from {blocks}, {order}: {', '.join(listed)}."
