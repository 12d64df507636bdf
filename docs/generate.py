"""Writes what is derived from the code: the pages of docs/reference/ and the JSON Schemas of schemas/.

`python docs/generate.py` writes them, `--check` says whether they are up to date. A test runs the check.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from rpg.core.codes import ROOMS, Code
from rpg.ir.goal import GOAL
from rpg.ir.schema import TaskSchema
from rpg.store import Snapshot

sys.path.append(str(Path(__file__).resolve().parent))
from language_page import language_page

ROOT = Path(__file__).resolve().parent.parent
SCHEMAS: dict[str, Any] = {"task": TypeAdapter(TaskSchema), "goal": GOAL, "snapshot": TypeAdapter(Snapshot)}
"""What people and scripts exchange with rpg as files."""
ROOM_TITLES = {
    "language": "Reading an instruction",
    "feasibility": "Instructions that cannot be carried out",
    "validate": "Validation and repair",
    "store": "Workspaces",
    "steer": "Steering",
}


def generated() -> dict[Path, str]:
    """Every generated file, relative to the repository, and what it should hold."""
    found = {Path("schemas") / f"{name}.schema.json": json_schema(name) for name in SCHEMAS}
    found[Path("docs/reference/diagnostics.md")] = "\n".join(diagnostics_page())
    found[Path("docs/reference/language.md")] = language_page()
    found[Path("docs/reference/task-yaml.md")] = "\n".join(task_page())
    return found


def json_schema(name: str) -> str:
    """The JSON Schema of one kind of file."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **SCHEMAS[name].json_schema()}
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def diagnostics_page() -> Iterator[str]:
    """The reference of diagnostic codes."""
    yield "# Diagnostics\n"
    yield "Every refusal and failure carries one of these codes. `rpg compile --json` gives them with the place in the"
    yield "instruction (`span`), a message and a hint.\n"
    for room, codes in ROOMS.items():
        if codes:
            yield f"## {ROOM_TITLES.get(room, room.capitalize())}\n"
        for code in codes:
            yield from _code(code)


def _code(code: Code) -> Iterator[str]:
    yield f"### {code.id}\n"
    yield f"{code.title[:1].upper()}{code.title[1:]}. {code.explanation}\n"
    if code.example:
        yield f"- Comes up with: `{code.example}`"
    if code.remedy:
        yield f"- Works: `{code.remedy}`"
    if code.example or code.remedy:
        yield ""


def task_page() -> Iterator[str]:
    """The reference of task.yaml."""
    schema = SCHEMAS["task"].json_schema()
    models: dict[str, Any] = schema["$defs"]
    yield "# task.yaml\n"
    yield "The source of a task: it may be written and edited by hand, and `rpg compile --from task.yaml` builds"
    yield "from it. Lengths are metres, angles in goals degrees, fields that end in `_edges` multiples of a block's"
    yield "edge. A field with a default may be left out. Names may be a single name or a list.\n"
    yield from _fields("The task", schema)
    goals = {_kind(model): name for name, model in models.items() if _kind(model)}
    others = [name for name in models if name not in goals.values()]
    yield "## Parts\n"
    for name in others:
        yield from _fields(name, models[name], level=3)
    yield "## Goals\n"
    for kind in sorted(goals):
        yield from _fields(kind, models[goals[kind]], level=3)


def _kind(model: dict[str, Any]) -> str:
    return str(model.get("properties", {}).get("kind", {}).get("const", ""))


def _fields(title: str, model: dict[str, Any], level: int = 2) -> Iterator[str]:
    yield f"{'#' * level} {title}\n"
    if model.get("description"):
        yield model["description"].replace("\n\n", "\n").strip() + "\n"
    rows = [(name, field) for name, field in model.get("properties", {}).items() if name not in ("kind", "type")]
    if rows:
        yield "| field | value | default |\n|---|---|---|"
    for name, field in rows:
        needed = name in model.get("required", ())
        default = "required" if needed else json.dumps(field.get("default"), ensure_ascii=False)
        yield f"| `{name}` | {_value(field)} | {default} |"
    yield ""


def _value(field: dict[str, Any]) -> str:
    """A JSON Schema as words for a table cell."""
    if "$ref" in field:
        return str(field["$ref"]).rsplit("/", 1)[-1]
    if "enum" in field:
        return ", ".join(f"`{choice}`" for choice in field["enum"])
    if "const" in field:
        return f"`{field['const']}`"
    options = field.get("anyOf") or field.get("oneOf")
    if options:
        words = dict.fromkeys(_value(option) for option in options if option.get("type") != "null")
        return " or ".join(words) if len(words) <= 6 else "a goal"
    if field.get("type") == "array":
        items = field.get("prefixItems")
        return f"[{', '.join(map(_value, items))}]" if items else f"list of {_value(field.get('items', {}))}"
    return {"number": "number", "integer": "whole number", "string": "text", "boolean": "true or false"}.get(
        str(field.get("type")), "any"
    )


def main(arguments: list[str]) -> int:
    """Write the files, or with --check name those that are out of date."""
    stale = [p for p, text in generated().items() if not (ROOT / p).is_file() or (ROOT / p).read_text() != text]
    for path in stale:
        print(f"{'out of date' if '--check' in arguments else 'written'}: {path}")
        if "--check" not in arguments:
            (ROOT / path).parent.mkdir(parents=True, exist_ok=True)
            (ROOT / path).write_text(generated()[path])
    return 1 if stale and "--check" in arguments else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
