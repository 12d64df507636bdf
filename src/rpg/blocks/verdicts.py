"""Verdicts under many namings of look-alikes, one for each, that are combined for all of them in one go."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from rpg.blocks.verdict import FALSE, TRUE, Verdict

Truths = npt.NDArray[np.bool_]
Margins = npt.NDArray[np.float64]


class Looked(Exception):
    """Code wants to know whether something holds where that cannot be told: it differs from naming to naming, say."""


class Closed:
    """What stands for a verdict but has no one value that could be looked at."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Any:
        raise Looked(name)

    def _look(self, *_: object) -> Any:
        raise Looked

    __bool__ = __iter__ = __eq__ = _look
    __hash__ = None  # type: ignore[assignment]


class Verdicts(Closed):
    """One verdict per naming; they combine as `Verdict` does."""

    __slots__ = ("_margins", "_truths")

    def __init__(self, truths: Truths, margins: Margins) -> None:
        self._truths, self._margins = truths, margins

    @classmethod
    def spread(cls, different: Sequence[Verdict], numbers: npt.NDArray[np.intp]) -> Verdicts:
        """The verdicts of which each naming has the one of its number."""
        truths, margins = zip(*different, strict=True)
        return cls(np.array(truths)[numbers], np.array(margins)[numbers])

    @classmethod
    def same(cls, verdict: Verdict, count: int) -> Verdicts:
        """So many times the same verdict."""
        return cls(np.full(count, verdict.value), np.full(count, verdict.margin))

    def best(self) -> int:
        """The naming that comes closest to success, the first of several."""
        margins = np.where(self._truths, self._margins, -np.inf) if self._truths.any() else self._margins
        return int(margins.argmax())

    def any(self) -> bool:
        """Does it hold under some naming?"""
        return bool(self._truths.any())

    def of(self, naming: int) -> Verdict:
        """The verdict under one naming."""
        return Verdict(bool(self._truths[naming]), float(self._margins[naming]))

    def __and__(self, other: Verdict | Verdicts) -> Verdicts:
        return self._joined(other, np.minimum, all_of=True)

    def __or__(self, other: Verdict | Verdicts) -> Verdicts:
        return self._joined(other, np.maximum, all_of=False)

    __rand__, __ror__ = __and__, __or__

    def __invert__(self) -> Verdicts:
        return Verdicts(~self._truths, -self._margins)

    def _joined(self, other: Verdict | Verdicts, closest: np.ufunc, *, all_of: bool) -> Verdicts:
        """Where both agree the margin that is closest to `all_of`'s limit, else that of the one that decides."""
        truths, margins = (other._truths, other._margins) if isinstance(other, Verdicts) else other
        mine = self._truths != all_of
        agree = self._truths == truths
        margin = np.where(agree, closest(self._margins, margins), np.where(mine, self._margins, margins))
        return Verdicts(self._truths & truths if all_of else self._truths | truths, margin)


def counted(at_least: int, at_most: int | None, verdicts: Iterable[Verdict | Verdicts], count: int) -> Verdicts:
    """At least / at most so many of `verdicts` hold, under each of `count` namings."""
    each = [v if isinstance(v, Verdicts) else Verdicts.same(v, count) for v in verdicts]
    found = Verdicts.same(TRUE, count)
    if not each:
        return Verdicts.same(FALSE, count) if at_least > 0 else found
    truths, margins = np.array([v._truths for v in each]), np.array([v._margins for v in each])
    order = np.lexsort((margins, truths), axis=0)[::-1]
    truths, margins = np.take_along_axis(truths, order, 0), np.take_along_axis(margins, order, 0)
    parts = []
    if at_least > 0:
        enough = at_least <= len(each)
        parts.append(Verdicts(truths[at_least - 1], margins[at_least - 1]) if enough else Verdicts.same(FALSE, count))
    if at_most is not None and at_most < len(each):
        parts.append(~Verdicts(truths[at_most], margins[at_most]))
    if not parts:
        return found
    return parts[0] if len(parts) == 1 else parts[0] & parts[1]
