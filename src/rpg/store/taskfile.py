"""task.yaml: a TaskSchema as people read and write it. What is wrong in one is said with its line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import yaml
from pydantic import BaseModel, ValidationError

from rpg.core.diagnostics import UsageError
from rpg.ir.schema import TaskSchema
from rpg.store.problems import explain
from rpg.store.records import UNSEEN
from rpg.store.yamltext import dump

MAX_BYTES = 1_000_000
DEEPEST = 100
"""Levels that a task may be nested; libyaml falls over its own stack at some ten thousand."""
TOO_DEEP = "nested too deeply for a task"
_FIRST = ("format", "kind", "type")
_LAST = ("span",)
_RESOLVED = {
    "tag:yaml.org,2002:bool": (r"true|True|TRUE|false|False|FALSE", "tTfF"),
    "tag:yaml.org,2002:int": (r"[-+]?[0-9]+", "-+0123456789"),
    "tag:yaml.org,2002:float": (r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+0123456789."),
    "tag:yaml.org,2002:null": (r"~|null|Null|NULL|", ["~", "n", "N", ""]),
}
"""Plain words that are not text: those of YAML 1.2, so that `kind: on` and `label: Y` are text."""


def dump_schema(schema: TaskSchema) -> str:
    """`schema` as task.yaml: keys in the schema's order, tolerances spelled out, what says nothing left out."""
    return dump(plain(schema))


def plain(record: BaseModel) -> dict[str, Any]:
    """A record of the IR as plain data, with what task.yaml shows of it."""
    found: dict[str, Any] = _plain(record, record.model_dump(mode="json"))
    return found


def _plain(value: Any, dumped: Any) -> Any:
    """`dumped` without the empty defaults of the records in `value`, and with what tells records apart first."""
    if isinstance(value, BaseModel):
        return {name: _plain(getattr(value, name), dumped[name]) for name in _ordered(value)}
    if isinstance(value, tuple) and isinstance(dumped, list):
        return [_plain(*pair) for pair in zip(value, dumped, strict=True)]
    return dumped


def _ordered(record: BaseModel) -> Iterator[str]:
    names = [name for name in type(record).model_fields if _says_something(record, name)]
    yield from (name for name in names if name in _FIRST)
    yield from (name for name in names if name not in _FIRST + _LAST)
    yield from (name for name in names if name in _LAST)


def _says_something(record: BaseModel, name: str) -> bool:
    """Numbers and words are shown even where they are defaults: a reader wants to see tolerances."""
    value = getattr(record, name)
    field = type(record).model_fields[name]
    if field.is_required() or value != field.default:
        return True
    return isinstance(value, int | float | str) and value is not False and value != ""


def read_schema(path: Path) -> TaskSchema:
    """The task described by the file at `path`; a UsageError that names the lines at fault where there is none."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from error
    if len(data) > MAX_BYTES:
        raise UsageError(f"{path} is too long for a task ({len(data):,} bytes; at most {MAX_BYTES:,})")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UsageError(f"{path} is not UTF-8 text (byte {error.start})") from error
    return parse_schema(text, str(path))


def parse_schema(text: str, origin: str = "task.yaml") -> TaskSchema:
    """The task described by `text`; `origin` names it in errors."""
    try:
        node, data = _parse(text)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = f":{mark.line + 1}" if mark else ""
        problem = error.problem or error.context or "not YAML"
        # Newer versions of libyaml stop at a depth of their own before ours is reached.
        said = TOO_DEEP if "nesting depth" in problem else problem
        raise UsageError(f"{origin}{line}: {said}") from error
    except yaml.YAMLError as error:
        raise UsageError(f"{origin}: not YAML: {' '.join(str(error).split())}") from error
    except RecursionError as error:
        raise UsageError(f"{origin}: {TOO_DEEP}") from error
    if not isinstance(data, dict):
        raise UsageError(f"{origin}:1: a task is a mapping that starts with `format: 1` and `name: ...`")
    try:
        return TaskSchema.model_validate(data)
    except ValidationError as error:
        raise UsageError("\n".join(f"{origin}:{line}: {what}" for line, what in explain(error, node))) from error


def _parse(text: str) -> tuple[yaml.Node | None, Any]:
    """The document's nodes, which know their lines, and its data."""
    _measure(text)
    loader = _loader()(text)
    try:
        node = loader.get_single_node()
        _check(node, set())
        return node, loader.construct_document(node) if node is not None else None
    finally:
        loader.dispose()


def _measure(text: str) -> None:
    """Refuse what is nested too deeply to be read safely."""
    depth = 0
    for event in yaml.parse(text, _loader()):
        depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
        if depth > DEEPEST:
            raise RecursionError


def _check(node: yaml.Node | None, seen: set[int]) -> None:
    """Refuse what would be read silently as something else than is meant: doubled keys, and aliases."""
    if node is None:
        return
    if id(node) in seen:
        raise yaml.MarkedYAMLError(problem="a task.yaml has no anchors; write it out", problem_mark=node.start_mark)
    seen.add(id(node))
    if isinstance(node, yaml.MappingNode):
        keys: set[str] = set()
        for key, value in node.value:
            if str(key.value) in keys:
                raise yaml.MarkedYAMLError(problem=f"`{key.value}` stands here twice", problem_mark=key.start_mark)
            keys.add(str(key.value))
            _check(key, seen)
            _check(value, seen)
    elif isinstance(node, yaml.ScalarNode) and UNSEEN.search(node.value):
        raise yaml.MarkedYAMLError(problem="a control character has no place here", problem_mark=node.start_mark)
    elif isinstance(node, yaml.SequenceNode):
        for item in node.value:
            _check(item, seen)


@cache
def _loader() -> Any:
    base = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    loader: Any = type("TaskLoader", (base,), {"yaml_implicit_resolvers": {}})
    for tag, (pattern, first) in _RESOLVED.items():
        loader.add_implicit_resolver(tag, re.compile(f"^(?:{pattern})$"), list(first))
    for tag, convert in (("int", int), ("float", float)):
        loader.add_constructor(f"tag:yaml.org,2002:{tag}", lambda _, node, convert=convert: convert(node.value))
    return loader
