"""Lengths and ranges in words."""

from __future__ import annotations

import math

EXACT = 0.01
"""What a plain distance is good for, either way, in metres."""
ABOUT = 0.25
"""What "about" is good for, as a share."""


def cm(metres: float) -> str:
    """A length in centimetres: "7.5 cm"."""
    return f"{round(metres * 100, 2):g} cm"


def span(minimum: float | None, maximum: float | None) -> str:
    """A range of lengths: "12 cm", "about 10 cm", "at least 5 cm", "at most 8 cm", "between 3 cm and 9 cm"."""
    if minimum is None or minimum <= 0:
        return f"at most {cm(maximum or 0.0)}"
    if maximum is None:
        return f"at least {cm(minimum)}"
    middle = (minimum + maximum) / 2
    if math.isclose(maximum - middle, EXACT, abs_tol=1e-6):
        return cm(middle)
    if math.isclose(maximum - middle, ABOUT * middle, abs_tol=1e-6):
        return f"about {cm(middle)}"
    return f"between {cm(minimum)} and {cm(maximum)}"
