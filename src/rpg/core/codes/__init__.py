"""Every diagnostic code there is, one file for each room that reports them.

`CODES` maps an id to its `Code`. A code is added to its room's file; the documentation page and a test that every
reported code is known follow from here.
"""

from __future__ import annotations

from rpg.core.codes import arrange, batch, feasibility, language, starts, steer, store, validate
from rpg.core.codes.base import Code

ROOMS: dict[str, tuple[Code, ...]] = {
    "language": language.CODES,
    "feasibility": feasibility.CODES,
    "arrange": arrange.CODES,
    "starts": starts.CODES,
    "validate": validate.CODES,
    "store": store.CODES,
    "steer": steer.CODES,
    "batch": batch.CODES,
}
"""The codes of each room, in the order in which the documentation lists them."""


def _merged() -> dict[str, Code]:
    merged: dict[str, Code] = {}
    for room, codes in ROOMS.items():
        for code in codes:
            if code.id in merged:
                raise ValueError(f"the code {code.id!r} of {room!r} is registered twice")
            merged[code.id] = code
    return merged


CODES: dict[str, Code] = _merged()

__all__ = ["CODES", "ROOMS", "Code"]
