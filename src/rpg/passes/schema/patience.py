"""Which refusals of a reading let costlier readings be tried, and how much costlier ones."""

from __future__ import annotations

import re

from rpg.core.diagnostics import Diagnostic, Refusal

FINAL = frozenset({"false-equation", "bad-equation", "too-many-blocks", "too-many-labels", "too-many-colors",
    "does-not-fit", "unknown-symbol", "size-out-of-range",
                   "out-of-reach", "too-many-asked", "covered-face", "too-wide"})  # fmt: skip
"""Refusals that no other reading mends: the words are understood, and what they say cannot be done."""
SENSIBLE = frozenset(
    {
        "ambiguous",
        "contradiction",
        "support-cycle",
        "count-mismatch",
        "self-reference",
        "one-group",
        "missing-symbol",
        "unused-block",
        "fixed-patch",
        "order-conflict",
    }
)
"""Refusals of a reading that makes sense in itself: only readings hardly less natural are tried after one."""
LOST = "this was read, but nothing in the task would come"
"""How a word that a reading lost is told: a costlier reading that finds a place for it means something else."""
_TORN = frozenset({"self-reference", "support-cycle"})
_UNFOUND = (
    "'it' could be any of several blocks",
    "it is not said of each of them",
    "it is not said which symbols there are",
    "it is not clear what belongs to 'each'",
    "the blocks that are counted may be those that are described",
    "these places contradict each other",
    "one block cannot lie on several blocks",
    "a block is named twice in this list",
    "a row has no room on one block",
    "the blocks have other colours than the structure",
    "what is on a block is not on the table",
)
"""Refusals that come of words joined that do not belong together, so that a pronoun, a place or a colour finds nothing
to be of: a reading that joins them otherwise may be meant."""
_MORE_COLORS = re.compile(r"\d+ colours for \d+ objects")
"""The same of colours that are more than the blocks."""
_CUT = "it is not clear whether this is said of all that is listed"
"""What is told of a reading that cuts a list in two."""
_SOMEWHAT = 3
_OPEN = (
    "one for all of them, or one for each?",
    "it is not clear which block is on which",
    "nothing is placed relative to itself",
    "these could be the sides of the tower",
    "it is not clear how these alternate",
    "in a grid colours alternate, two of them",
    "of the last two of these, or of all that were told?",
)
"""Refusals of a reading that leaves open how many blocks there are, or how they lie: one as natural that does not see
it guesses."""


def patience(found: Diagnostic) -> int | None:
    """How much costlier than a reading that is refused so another may be; None: as much as it likes."""
    if found.message.startswith(_OPEN):
        return -1
    if found.code in _TORN or found.message.startswith(_UNFOUND) or _MORE_COLORS.match(found.message):
        return _SOMEWHAT
    return 0 if found.code in SENSIBLE or found.message.startswith(LOST) else None


def aimless(found: Refusal) -> bool:
    """Whether the cheapest reading makes sense, but asks for nothing: no costlier one tells better what is wrong."""
    first = found.diagnostics[0]
    return first.code == "no-goal" and "what should be done" in first.message


def torn(found: Refusal) -> bool:
    """Whether the cheapest reading tore a list apart: "a tower of a red, a blue and a green block" is no lone block."""
    first = found.diagnostics[0]
    return (first.code == "too-few" and "lone block" in first.message) or first.message.startswith(_CUT)
