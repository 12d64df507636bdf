"""Labels of one kind told together in a row: "the even digits 2, 4 and 6 on the left, the odd ones on the right"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.frames.lines.ordered import KINDS
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns

_LABEL = r"(?:[A-Z]|[b-hj-z]|\d|a(?= (?:,|and|[b-z]) ))"
_WORDS = {
    "even": "evens?(?: (?:digits|numbers|ones|BLOCK))?",
    "odd": "odds?(?: (?:digits|numbers|ones|BLOCK))?",
    "vowel": "vowels",
    "consonant": "consonants",
}
GROUPS: list[Pattern] = [
    pattern
    for kind, said in _WORDS.items()
    for pattern in patterns(
        "group", kind, rf"(?:the |all |all the |my )?{said}(?: BE)?(?=(?: [(:,]| like| namely| such as)? {_LABEL} )"
    )
]
"""Kind "group": the kind of the labels behind it."""
_AHEAD = frozenset({("left", 1), ("first", 1)})
_BEHIND = frozenset({("right", 1), ("last", 1)})
_PAIRS = ({"even", "odd"}, {"vowel", "consonant"})


def gathered(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with two such groups as a list of all labels, and which kind is ahead.

    Raises:
        Unclear: a group of other labels, or without a place.
    """
    at = [n for n, piece in enumerate(pieces) if piece.kind == "group"]
    if not at:
        return list(pieces)
    if len(at) == 1:
        found, place = _members(pieces, at[0])
        if place is not None or any(pieces[m].named["label"].upper() not in KINDS[pieces[at[0]].value] for m in found):
            raise Unclear
        return [piece for n, piece in enumerate(pieces) if n != at[0]]
    if len(at) != 2 or {pieces[n].value for n in at} not in _PAIRS:
        raise Unclear
    ahead: list[str] = []
    behind: list[str] = []
    gone: set[int] = set(at)
    members: set[int] = set()
    for n in at:
        kind = pieces[n].value
        found, place = _members(pieces, n)
        if not found or any(pieces[m].named["label"].upper() not in KINDS[kind] for m in found):
            raise Unclear
        where = None if place is None else pieces[place].value
        ahead += [kind] * (where in _AHEAD)
        behind += [kind] * (where in _BEHIND)
        members |= set(found)
        gone |= {place} if place is not None else set()
    ahead = ahead or [pieces[n].value for n in at if [pieces[n].value] != behind]
    if len(ahead) != 1 or len(behind) > 1 or ahead == behind:
        raise Unclear
    rest = [
        piece.named["label"].upper() for n, piece in enumerate(pieces) if "label" in piece.named and n not in members
    ]
    if rest and sorted(rest) != sorted(pieces[n].named["label"].upper() for n in members):
        raise Unclear
    other = next(pieces[n].value for n in at if pieces[n].value != ahead[0])
    for n in members:
        gone |= {m for m in (n - 1, n + 1) if pieces[m : m + 1] and pieces[m].kind == "break"}
    kept = [piece for n, piece in enumerate(pieces) if n not in gone | members]
    if not rest:
        listed = [Piece("break", ":")]
        for n in sorted(members):
            listed += [Piece("break", ",")] * (len(listed) > 1) + [pieces[n]]
        kept += listed
    return [*kept, Piece("break", ","), Piece("kinds", "groups", (ahead[0], other))]


def _members(pieces: Sequence[Piece], n: int) -> tuple[list[int], int | None]:
    """Where the labels of a group stand, and its place: ahead of the group, or behind them."""
    before = n - 1
    while before >= 0 and pieces[before].kind == "glue":
        before -= 1
    before = before if before >= 0 and pieces[before].kind == "place" else -1
    found: list[int] = []
    m = n + 1
    while m < len(pieces) and (pieces[m].kind in ("break", "glue") or "label" in pieces[m].named):
        found += [m] * ("label" in pieces[m].named)
        m += 1
    if m < len(pieces) and pieces[m].kind == "place" and before < 0:
        return found, m
    return found, before if before >= 0 else None
