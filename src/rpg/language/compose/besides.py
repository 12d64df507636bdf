"""What is told by the way of those that a clause is about: "the red block, which carries the blue one, stands ..."."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

from rpg.language.compose.syntax import Clause, Noun


def told_besides(clause: Clause) -> tuple[Clause, list[Clause]]:
    """A clause without what is told besides, and that by itself."""
    found: list[Clause] = []
    main = _without(clause, found)
    assert isinstance(main, Clause)
    return main, found


def _without(part: Any, found: list[Clause]) -> Any:
    if isinstance(part, tuple):
        return tuple(_without(one, found) for one in part)
    if not is_dataclass(part) or isinstance(part, type):
        return part
    kept = replace(part, **{field.name: _without(getattr(part, field.name), found) for field in fields(part)})
    if isinstance(kept, Noun) and kept.besides:
        found.append(Clause(replace(kept, besides=()), kept.besides, "must"))
        return replace(kept, besides=())
    return kept
