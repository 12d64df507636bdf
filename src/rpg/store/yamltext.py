"""YAML as it is written in task.yaml: plain blocks without anchors, the same bytes on every machine.

PyYAML writes it, with its own choices taken away where they would surprise: text is quoted wherever any YAML reader
might take it for something else (`on`, `y` and `5` are words here), lists of scalars stand on one line where they fit,
and no line is folded.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Mapping
from typing import Any

import yaml

WIDTH = 120
_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*(?: [A-Za-z0-9_-]+)*")
_RESERVED = frozenset(["y", "n", "yes", "no", "on", "off", "true", "false", "null", "none", "nan", "inf"])


class _Dumper(yaml.SafeDumper):
    """Block style with indented lists, keys in their order, nothing written as a reference to something before it."""

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> None:
        super().increase_indent(flow, False)

    def ignore_aliases(self, data: Any) -> bool:
        return True

    def represent_text(self, text: str) -> yaml.ScalarNode:
        """Text in double quotes, but for plain words that no reader takes for something else."""
        plain = _PLAIN.fullmatch(text) and text.lower() not in _RESERVED and len(text) < WIDTH
        return self.represent_scalar("tag:yaml.org,2002:str", text, None if plain else '"')

    def represent_mapping(self, tag: str, mapping: Any, flow_style: bool | None = None) -> yaml.MappingNode:
        return super().represent_mapping(tag, mapping, not mapping)

    def serialize(self, node: yaml.Node) -> None:
        _lay_out(node, 0, 0)
        super().serialize(node)


_Dumper.add_representer(str, _Dumper.represent_text)


def dump(data: Mapping[str, Any]) -> str:
    """`data` as a YAML document in block style; lists of scalars stand on one line where they fit."""
    text: str = yaml.dump(data, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=sys.maxsize)
    return text


def _lay_out(node: yaml.Node, indent: int, head: int) -> None:
    """Choose one line or a block for every list; `head`: characters before the node on its line."""
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            _lay_out(value, indent + 2, indent + len(_shown(key)) + 2)
    elif isinstance(node, yaml.SequenceNode):
        inline = _inline(node)
        node.flow_style = inline is not None and head + len(inline) <= WIDTH
        for item in node.value:
            if not node.flow_style:
                _lay_out(item, indent + 2, indent + 2)


def _inline(node: yaml.Node) -> str | None:
    """A node on one line: scalars, and lists of what fits; None for mappings."""
    if isinstance(node, yaml.SequenceNode):
        items = [_inline(item) for item in node.value]
        node.flow_style = True
        return None if None in items else f"[{', '.join(item for item in items if item is not None)}]"
    return _shown(node) if isinstance(node, yaml.ScalarNode) else None


def _shown(node: yaml.ScalarNode) -> str:
    return json.dumps(node.value, ensure_ascii=False) if node.style == '"' else str(node.value)
