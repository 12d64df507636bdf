"""What generated code may call: the public names of rpg.env and the signatures of BlockTask, as they are."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Iterable
from functools import lru_cache

from pydantic import BaseModel

import rpg.env
from rpg.env import BlockTask


@lru_cache(maxsize=1)
def public_names() -> frozenset[str]:
    """What `from rpg.env import ...` may name."""
    return frozenset(rpg.env.__all__)


@lru_cache(maxsize=1)
def methods() -> dict[str, inspect.Signature]:
    """Public methods of BlockTask with their signatures, without `self`."""
    found = {}
    for name, member in inspect.getmembers(BlockTask, inspect.isfunction):
        if not name.startswith("_"):
            signature = inspect.signature(member)
            found[name] = signature.replace(parameters=list(signature.parameters.values())[1:])
    return found


@lru_cache(maxsize=1)
def attributes() -> frozenset[str]:
    """Everything public that `self` has."""
    return frozenset(name for name in dir(BlockTask) if not name.startswith("_"))


@lru_cache(maxsize=1)
def fields() -> dict[str, tuple[frozenset[str], frozenset[str]]]:
    """For each record class of the surface: all its fields, and those it cannot do without."""
    found = {}
    for name in public_names():
        record = getattr(rpg.env, name)
        if isinstance(record, type) and issubclass(record, BaseModel):
            known = record.model_fields
            found[name] = (frozenset(known), frozenset(n for n, info in known.items() if info.is_required()))
    return found


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known name closest to `word`, if any is close."""
    matches = difflib.get_close_matches(word, sorted(known), n=1, cutoff=0.75)
    return matches[0] if matches else None
