"""Lists of instructions and sessions, as people keep them in files: YAML, JSON lines, or plain text.

A plain text file has one instruction per line; lines that begin with # are comments. A JSON lines file has an object
per line. A YAML file is a list, or a mapping with the lists `tasks` and `sessions`. An entry is an instruction, or an
object with `instruction` (or `base` and `edits`) and optionally `name`, `seed` and `author`.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from glob import glob, has_magic
from pathlib import Path
from typing import Any

import yaml
from pydantic import Field, ValidationError, model_validator

from rpg import __version__
from rpg.core.diagnostics import UsageError
from rpg.core.digest import digest_of
from rpg.ir.base import Record
from rpg.ir.schema import slug

LISTS = ("tasks", "sessions")
"""The keys of a YAML mapping that hold entries."""
_YAML = re.compile(rf"---|- |\[|(?:{'|'.join(LISTS)}):")


class Item(Record):
    """An entry as it is written."""

    instruction: str | None = None
    base: str | None = None
    edits: tuple[str, ...] = ()
    name: str | None = None
    seed: int = Field(0, ge=0)
    author: str | None = None

    @model_validator(mode="after")
    def _has_words(self) -> Item:
        if (self.instruction is None) == (self.base is None):
            raise ValueError("an entry has an `instruction`, or a `base` and its `edits`")
        return self


@dataclass(frozen=True)
class Entry:
    """An instruction to compile, and the edits to apply to it in turn. `place` is its file and line."""

    place: str
    instruction: str
    edits: tuple[str, ...] = ()
    name: str | None = None
    seed: int = 0
    author: str | None = None

    @property
    def digest(self) -> str:
        """What the entry's result depends on, besides MuJoCo: its words, its options and the version of rpg."""
        words = [self.instruction, *self.edits]
        return digest_of({"rpg": __version__, "words": words, "name": self.name, "seed": self.seed, "by": self.author})

    @property
    def title(self) -> str:
        return self.name or self.instruction


def read_entries(sources: Iterable[str]) -> tuple[Entry, ...]:
    """The entries of every file, each once; `-` is stdin, and globs are expanded. UsageError names file and line.

    Lists without any entry are an error too: most likely another file was meant.
    """
    paths = list(dict.fromkeys(_expanded(sources)))
    entries = [entry for path in paths for entry in _read(path)]
    if not entries:
        names = ", ".join("stdin" if path == "-" else path for path in paths)
        raise UsageError(f"no instruction in {names}: an entry is a line of text, or an item of a YAML list")
    named: dict[str, Entry] = {}
    for entry in entries:
        if entry.name is None:
            continue
        other = named.setdefault(entry.name, entry)
        if other is not entry:
            raise UsageError(f"{entry.place}: the name {entry.name!r} is taken by the entry at {other.place}")
    return tuple(entries)


def shard(entries: tuple[Entry, ...], part: str) -> tuple[Entry, ...]:
    """The i-th of n parts, from "i/n"; every entry is in exactly one part."""
    match = re.fullmatch(r"(\d+)/(\d+)", part)
    index, count = (int(match[1]), int(match[2])) if match else (0, 0)
    if not 1 <= index <= count:
        raise UsageError(f"--shard {part}: give a part and the number of parts, from 1/4 to 4/4")
    return entries[index - 1 :: count]


def _expanded(sources: Iterable[str]) -> Iterator[str]:
    for source in sources:
        if has_magic(source) and not Path(source).exists():
            found = sorted(glob(source, recursive=True))  # noqa: PTH207
            if not found:
                raise UsageError(f"no file matches {source}")
            yield from found
        else:
            yield source


def _read(source: str) -> Iterator[Entry]:
    try:
        data = sys.stdin.buffer.read() if source == "-" else Path(source).read_bytes()
        text = data.decode("utf-8-sig")
    except OSError as error:
        raise UsageError(f"cannot read {source}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise UsageError(f"{'stdin' if source == '-' else source}:{line}: not UTF-8 text") from error
    origin = "stdin" if source == "-" else source
    match Path(source).suffix.lower():
        case ".yaml" | ".yml":
            items = _yaml_items(origin, text)
        case ".jsonl" | ".ndjson":
            items = _json_items(origin, text)
        case _:
            items = _stream_items(origin, text) if source == "-" else _text_items(text)
    for line, item in items:
        yield _entry(f"{origin}:{line}", item)


def _stream_items(origin: str, text: str) -> Iterator[tuple[int, Any]]:
    """Stdin has no name to tell its format by: its first line does. What is neither JSON nor YAML is plain text."""
    first = next((line for _, line in _text_items(text)), "")
    if first.startswith("{"):
        return _json_items(origin, text)
    return _yaml_items(origin, text) if _YAML.match(first) else _text_items(text)


def _text_items(text: str) -> Iterator[tuple[int, Any]]:
    for number, line in enumerate(text.split("\n"), 1):
        if line.strip() and not line.lstrip().startswith("#"):
            yield number, line.strip()


def _json_items(origin: str, text: str) -> Iterator[tuple[int, Any]]:
    for number, line in _text_items(text):
        try:
            yield number, json.loads(line)
        except json.JSONDecodeError as error:
            raise UsageError(f"{origin}:{number}: not JSON: {error.msg} (column {error.colno})") from error


def _yaml_items(origin: str, text: str) -> Iterator[tuple[int, Any]]:
    loader = yaml.SafeLoader(text)
    try:
        node = loader.get_single_node()
        for child in _entry_nodes(origin, node):
            _no_key_twice(origin, child)
            yield child.start_mark.line + 1, loader.construct_object(child, deep=True)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = f":{mark.line + 1}" if mark else ""
        raise UsageError(f"{origin}{line}: {error.problem or error.context or 'not YAML'}") from error
    except (yaml.YAMLError, RecursionError) as error:
        raise UsageError(f"{origin}: not YAML: {' '.join(str(error).split())}") from error
    finally:
        loader.dispose()


def _entry_nodes(origin: str, node: yaml.Node | None) -> Iterator[yaml.Node]:
    if isinstance(node, yaml.SequenceNode):
        yield from node.value
    elif isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if key.value not in LISTS or not isinstance(value, yaml.SequenceNode):
                line = key.start_mark.line + 1
                raise UsageError(f"{origin}:{line}: `{key.value}` is no list of entries; use `tasks` or `sessions`")
            yield from value.value
    elif node is not None:
        raise UsageError(f"{origin}:{node.start_mark.line + 1}: a list of entries is wanted")


def _no_key_twice(origin: str, node: yaml.Node) -> None:
    """YAML readers take the last of equal keys, and would drop an instruction without a word."""
    if isinstance(node, yaml.MappingNode):
        seen: set[str] = set()
        for key, _ in node.value:
            if key.value in seen:
                raise UsageError(f"{origin}:{key.start_mark.line + 1}: `{key.value}` is there twice in one entry")
            seen.add(key.value)


def _entry(place: str, item: Any) -> Entry:
    try:
        read = Item.model_validate({"instruction": item} if isinstance(item, str) else item)
    except ValidationError as error:
        problem = error.errors()[0]
        raise UsageError(f"{place}: {_problem(problem['type'], problem['loc'], problem['msg'])}") from error
    name = slug(read.name) if read.name is not None else None
    if name == "":
        raise UsageError(f"{place}: name: {read.name!r} has no letter or digit to make a directory's name of")
    words = read.instruction if read.instruction is not None else read.base
    return Entry(place, words or "", read.edits, name, read.seed, read.author)


def _problem(kind: str, where: tuple[int | str, ...], message: str) -> str:
    """What is wrong with an entry, in the words of the file."""
    place = ".".join(str(part) for part in where)
    match kind:
        case "extra_forbidden":
            return f"an entry has no `{place}`; it may have {', '.join(Item.model_fields)}"
        case "model_type":
            return "an entry is a sentence, or an object with `instruction`"
        case "tuple_type":
            return f"`{place}` is a list"
        case _:
            return f"{place + ': ' if place else ''}{message.removeprefix('Value error, ')}"
