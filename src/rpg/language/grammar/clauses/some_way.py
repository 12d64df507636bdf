"""Directions that are told only by those of others: "(all face) the same way", "(each faces) a different direction"."""

SOME_WAY = "some way"
"""The value of such a direction."""
SOME_WAYS = tuple(
    f"{to}{other} {way}"
    for to in ("", "in ", "into ")
    for other in ("the same", "a different", "different", "the opposite", "opposite")
    for way in ("direction", "directions", "way", "ways")
)
