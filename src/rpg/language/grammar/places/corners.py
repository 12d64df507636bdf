"""Corners of the table by where they are: "the corner near me on the right", "the left corner closest to the robot"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns

_VIEWER = "me|us|the_robot|the_viewer|the_camera|you|robot|camera|viewer"
_NEAR = Patterns(f"nearest|closest|nearer|closer|near|close|next to? {_VIEWER}", "in|at|on the front|near side?")
_FAR = Patterns(
    f"farthest|furthest|farther|further|far|away away? from {_VIEWER}", "far|farther|further|farthest|furthest away",
    "in|at|on the back|far|rear side?",
)  # fmt: skip
_SIDES = {"left": "left", "right": "right"}
_DEPTHS = {"near": "near", "front": "near", "far": "far", "back": "far", "rear": "far"}
_LINKS = (",", "and", ", and", "that is", "which is", "is", "but")


def told_corners(p: Parser, j: int) -> list[tuple[str, int]]:
    """A corner with what tells which one it is, before the word and behind it."""
    across, along = p.peek(j, _SIDES) or "", p.peek(j, _DEPTHS) or ""
    k = p.one(p.opt(p.reach(j + 1), "hand") if across or along else j, "corner")
    return _told(p, k, across, along) if k else []


def _told(p: Parser, k: int, across: str, along: str) -> list[tuple[str, int]]:
    """The corner once both are known: which side, and how far away."""
    if across and along:
        return [(f"{along}_{across}_corner", k)]
    k = p.any_of(k, ("of the table",)) or k if not (across or along) else k
    start = p.any_of(k, _LINKS) or k
    found: list[tuple[str, int]] = []
    if not along and (way := p.peek(start, _DEPTHS)) is not None:
        found += _told(p, p.reach(start + 1), across, way)
    if not along:
        for table, way in ((_NEAR, "near"), (_FAR, "far")):
            for end in table.matches(p, start):
                found += _told(p, end, across, way)
    if not across:
        side = p.any_of(start, ("on the", "to the", "at the", "on my", "to my", "in the")) or start
        if word := p.peek(side, _SIDES):
            end = p.opt(p.opt(p.reach(side + 1), "hand"), "side")
            found += _told(p, end, word, along)
    return found
