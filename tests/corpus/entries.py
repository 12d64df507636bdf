"""Entries of the corpus, read from its YAML files."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

FOLDER = Path(__file__).parent
SPLITS = ("dev", "heldout", "fresh", "strangers", "hunters")
KEYS = {"say", "assets", "hold", "miss", "refuse", "may_refuse", "start", "start_miss", "heap"}


@dataclass(frozen=True)
class Entry:
    """One instruction with what it has to mean. A state is a tuple of pictures; more than one is a trajectory."""

    split: str
    phenomenon: str
    text: str
    marked: tuple[tuple[int, int], ...] = ()
    assets: dict[str, int | str] | None = None
    hold: tuple[tuple[str, ...], ...] = ()
    miss: tuple[tuple[str, ...], ...] = ()
    start: tuple[str, ...] = ()
    start_miss: tuple[str, ...] = ()
    heap: int = 0
    refuse: bool | tuple[str, ...] = False
    may_refuse: bool = False


LOADER: type[yaml.SafeLoader] = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
"""Seven times as fast where libyaml is there."""


@cache
def load(split: str) -> tuple[Entry, ...]:
    """Every entry of a split, in the order of files and lines."""
    found: list[Entry] = []
    for path in sorted((FOLDER / split).glob("*.yaml")):
        for data in yaml.load(path.read_text(encoding="utf-8"), Loader=LOADER):
            unknown = set(data) - KEYS
            if unknown:
                raise ValueError(f"{path}: unknown keys {sorted(unknown)}")
            found += [entry(split, path.stem, text, data) for text in data["say"]]
    return tuple(found)


def entry(split: str, phenomenon: str, said: str, data: dict[str, Any]) -> Entry:
    """An entry of one phrasing, from the data of its file."""
    text, marked = _marks(said) if data.get("refuse") else (said, ())
    refuse = data.get("refuse", False)
    return Entry(
        split=split,
        phenomenon=phenomenon,
        text=text,
        marked=marked,
        assets=data.get("assets"),
        hold=tuple(_states(s) for s in data.get("hold", ())),
        miss=tuple(_states(s) for s in data.get("miss", ())),
        start=tuple(data.get("start", ())),
        start_miss=tuple(data.get("start_miss", ())),
        heap=data.get("heap", 0),
        refuse=refuse if isinstance(refuse, bool) else tuple(refuse),
        may_refuse=data.get("may_refuse", False),
    )


def _states(data: str | int | list[str]) -> tuple[str, ...]:
    return tuple(data) if isinstance(data, list) else (str(data),)


def _marks(said: str) -> tuple[str, tuple[tuple[int, int], ...]]:
    """Take the marks «» out of a text; the spans are those of the plain text."""
    marked = []
    text = ""
    for part in re.split(r"(«[^»]*»)", said):
        if part.startswith("«"):
            marked.append((len(text), len(text) + len(part) - 2))
            part = part[1:-1]
        text += part
    return text, tuple(marked)
