"""Verdicts of several people on the same snapshots: what share they accept, and how far they agree."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from rpg.core.diagnostics import UsageError
from rpg.ir.base import Record


class Ratings(Record):
    """One person's export of the page: a verdict per task, by its key."""

    rater: str
    verdicts: dict[str, bool]


@dataclass(frozen=True)
class Agreement:
    """`accepted`: percentage of verdicts that say the task is right. `kappa`: Fleiss' kappa over the tasks that
    everybody judged; None for fewer than two raters, or where all verdicts are alike and chance explains everything."""

    raters: int
    tasks: int
    accepted: float
    unanimous: float
    kappa: float | None


def read_ratings(paths: Iterable[Path]) -> list[Ratings]:
    """The exports at `paths`; UsageError where one cannot be read."""
    found = []
    for path in paths:
        try:
            found.append(Ratings.model_validate_json(path.read_bytes()))
        except OSError as error:
            raise UsageError(f"cannot read {path}: {error.strerror}") from error
        except (ValidationError, json.JSONDecodeError) as error:
            raise UsageError(f"{path} is no export of the page of verdicts") from error
    return found


def agreement(ratings: list[Ratings]) -> Agreement:
    """Fleiss, J. L. (1971), Measuring nominal scale agreement among many raters, for two categories."""
    everybody = sorted(set.intersection(*(set(r.verdicts) for r in ratings))) if ratings else []
    votes = [bool(verdict) for rating in ratings for verdict in rating.verdicts.values()]
    accepted = 100 * sum(votes) / len(votes) if votes else 0.0
    counts = [Counter(rating.verdicts[key] for rating in ratings) for key in everybody]
    unanimous = 100 * sum(len(count) == 1 for count in counts) / len(counts) if counts else 0.0
    return Agreement(len(ratings), len(everybody), accepted, unanimous, _kappa(counts, len(ratings)))


def _kappa(counts: list[Counter[bool]], raters: int) -> float | None:
    if raters < 2 or not counts:
        return None
    observed = sum(sum(n * (n - 1) for n in count.values()) for count in counts) / (len(counts) * raters * (raters - 1))
    shares = [sum(count[value] for count in counts) / (len(counts) * raters) for value in (True, False)]
    chance = sum(share * share for share in shares)
    return None if chance == 1.0 else (observed - chance) / (1.0 - chance)
