"""Readings that say the same in so many records: what is certain to come to the same task need not be resolved."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from dataclasses import fields
from functools import cache
from operator import attrgetter
from typing import Any, cast

from rpg.language.meaning import Absolute, Clause, Coord, Meaning, Size, Structure, replace


def wording(meaning: Any, known: dict[int, Hashable]) -> Hashable:
    """What a reading says, wherever it stands in the text. `known`: of records that were met before, and still exist.

    The parts of a structure may be told behind its noun or behind the clause that builds it, one by one or as a list,
    and so may its sizes.
    """
    if isinstance(meaning, Meaning):
        found = known.get(id(meaning))
        if found is None:
            found = known[id(meaning)] = _wording(meaning, known)
        return found
    if type(meaning) is tuple:
        return tuple([wording(part, known) for part in meaning])
    return cast(Hashable, meaning)


def _wording(meaning: Meaning, known: dict[int, Hashable]) -> Hashable:
    shape = meaning.theme if isinstance(meaning, Clause) else None
    if isinstance(meaning, Clause) and isinstance(shape, Structure):
        parts = wording(tuple(_parts((*shape.details, *meaning.adjuncts))), known)
        sizes = wording((*shape.sizes, *(one for one in meaning.adjuncts if isinstance(one, Size))), known)
        bare = _fields(replace(shape, details=_others(shape.details), sizes=()), known)
        return parts, sizes, bare, _fields(replace(meaning, theme=None, adjuncts=_others(meaning.adjuncts)), known)
    return _fields(meaning, known)


def _fields(meaning: Meaning, known: dict[int, Hashable]) -> Hashable:
    kind: Any = type(meaning)
    return kind, wording(_values(kind)(meaning), known)


def _parts(told: tuple[Meaning, ...]) -> Iterator[Meaning]:
    """What is said of the parts of a structure, one by one."""
    for one in told:
        yield from one.items if isinstance(one, Coord) and one.op == "absolutes" else (one,) if _is_part(one) else ()


def _others(told: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    return tuple(one for one in told if not _is_part(one) and not isinstance(one, Size))


def _is_part(one: Meaning) -> bool:
    return isinstance(one, Absolute) or (isinstance(one, Coord) and one.op == "absolutes")


@cache
def _values(kind: Any) -> Callable[[Any], Any]:
    """What the fields of a kind of record hold that do not say where it was read, the cost among them."""
    where = ("span", "word") if kind is Clause else ("span",)
    names = [field.name for field in fields(kind) if field.name not in where]
    return attrgetter(*names) if len(names) > 1 else lambda one: (one.cost,)
