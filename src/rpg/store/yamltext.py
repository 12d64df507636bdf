"""YAML as it is written in task.yaml: plain blocks without anchors, the same bytes on every machine.

Only mappings, lists, text, numbers and truth values occur. Text is quoted wherever any YAML reader might take it for
something else (`on`, `y` and `5` are words here), so that every reader gets back what was written.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

Scalar = str | int | float | bool | None
WIDTH = 120
_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*(?: [A-Za-z0-9_-]+)*")
_RESERVED = frozenset(["y", "n", "yes", "no", "on", "off", "true", "false", "null", "none", "nan", "inf"])
_UNPRINTABLE = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff\ud800-\udfff]")


def dump(data: Mapping[str, Any]) -> str:
    """`data` as a YAML document in block style; lists of scalars stand on one line where they fit."""
    return "".join(line + "\n" for line in _mapping(data, 0)) or "{}\n"


def _mapping(data: Mapping[str, Any], indent: int) -> Iterator[str]:
    pad = " " * indent
    for key, value in data.items():
        head = f"{pad}{_text(key)}:"
        inline = _inline(value)
        if inline is not None and (len(head) + 1 + len(inline) <= WIDTH or not isinstance(value, list)):
            yield f"{head} {inline}"
        else:
            yield head
            yield from _block(value, indent + 2)


def _block(value: Any, indent: int) -> Iterator[str]:
    if isinstance(value, Mapping):
        yield from _mapping(value, indent)
        return
    pad = " " * indent
    for item in value:
        inline = _inline(item)
        if inline is not None and (len(pad) + 2 + len(inline) <= WIDTH or not isinstance(item, list)):
            yield f"{pad}- {inline}"
            continue
        lines = list(_block(item, indent + 2))
        yield f"{pad}- {lines[0][indent + 2 :]}"
        yield from lines[1:]


def _inline(value: Any) -> str | None:
    """`value` on one line: scalars, empty collections, lists of what fits; None for everything else."""
    if isinstance(value, Mapping):
        return None if value else "{}"
    if isinstance(value, Sequence) and not isinstance(value, str):
        items = [_inline(item) for item in value]
        known = [item for item in items if item is not None]
        return f"[{', '.join(known)}]" if len(known) == len(items) else None
    return _scalar(value)


def _scalar(value: Scalar) -> str:
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return _float(value)
    return _text(value)


def _float(value: float) -> str:
    """Shortest text that reads back as the same float, also for readers that want a dot before the exponent."""
    mantissa, mark, exponent = repr(value).partition("e")
    return f"{mantissa if '.' in mantissa or not mark else mantissa + '.0'}{mark}{exponent}"


def _text(value: str) -> str:
    if _PLAIN.fullmatch(value) and value.lower() not in _RESERVED and len(value) < WIDTH:
        return value
    return _UNPRINTABLE.sub(lambda match: f"\\u{ord(match[0]):04x}", json.dumps(value, ensure_ascii=False))
