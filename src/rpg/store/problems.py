"""What is wrong in a hand-written file, in sentences with lines, out of a validation error."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import yaml
from pydantic import ValidationError
from pydantic_core import ErrorDetails

from rpg.ir import assets, node, order, schema
from rpg.ir.base import Record

MOST = 5
"""How many problems are worth reading at once."""
Place = tuple[str | int, ...]
_OPERANDS = ("Lowest", "Highest")


def explain(error: ValidationError, root: yaml.Node | None) -> list[tuple[int, str]]:
    """Line and sentence for each problem, in the order of the file; the first few if there are many."""
    grouped: dict[Place, list[ErrorDetails]] = {}
    for detail in error.errors(include_url=False):
        location = detail["loc"]
        if detail["type"] == "union_tag_invalid":
            location = (*location, _key(detail))
        grouped.setdefault(_place(root, location), []).append(detail)
    found = [(_line(root, place), _sentence(place, details)) for place, details in grouped.items()]
    found.sort()
    return found[:MOST]


def _place(root: yaml.Node | None, location: Sequence[str | int]) -> Place:
    """The keys and indices of a location, without the names of the alternatives that were tried."""
    place: list[str | int] = []
    at = root
    for step in location:
        if step in _OPERANDS or str(step).startswith("function-before"):
            return tuple(place)
        inner = _child(at, step)
        if inner is not None:
            place.append(step)
            at = inner
    if location and isinstance(at, yaml.MappingNode) and location[-1] != (place[-1] if place else None):
        place.append(location[-1])
    return tuple(place)


def _child(at: yaml.Node | None, step: str | int) -> yaml.Node | None:
    if isinstance(at, yaml.MappingNode):
        return next((value for key, value in at.value if key.value == step), None)
    if isinstance(at, yaml.SequenceNode) and isinstance(step, int) and step < len(at.value):
        found: yaml.Node = at.value[step]
        return found
    return None


def _line(root: yaml.Node | None, place: Place) -> int:
    at = root
    for step in place:
        key = next((k for k, _ in at.value if k.value == step), None) if isinstance(at, yaml.MappingNode) else None
        inner = _child(at, step)
        if inner is None:
            break
        at = inner
        if key is not None and step == place[-1]:
            return int(key.start_mark.line) + 1
    return int(at.start_mark.line) + 1 if at is not None else 1


def _sentence(place: Place, details: list[ErrorDetails]) -> str:
    """One sentence for all that is wrong at one place; of several alternatives' complaints, the most telling."""
    if any(step in _OPERANDS for detail in details for step in detail["loc"]):
        return f"`{_path(place)}` should be a name, a list of names, or one of `lowest:` and `highest:` with names"
    ranked = sorted(details, key=lambda detail: _RANK.get(detail["type"], 1))
    detail = ranked[0]
    where = _path(place)
    say = _SENTENCES.get(detail["type"])
    if say is None:
        return f"{where}: {detail['msg'][:1].lower()}{detail['msg'][1:]}" if where else detail["msg"]
    return say(where, detail)


def _path(place: Place) -> str:
    text = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in place)
    return text.removeprefix(".")


def _context(detail: ErrorDetails, key: str) -> str:
    return str(detail.get("ctx", {}).get(key, ""))


def _missing(where: str, _: ErrorDetails) -> str:
    return f"`{where}` is missing"


def _unknown_key(where: str, detail: ErrorDetails) -> str:
    key = str(detail["loc"][-1])
    return f"`{where}` is not known here{_nearest(key, sorted(_known_keys()))}"


def _unknown_choice(where: str, detail: ErrorDetails) -> str:
    expected = _context(detail, "expected").replace(" or ", ", ")
    choices = [choice.strip("' ") for choice in expected.split(",")]
    return f"`{where}` cannot be {_shown(detail['input'])}{_nearest(detail['input'], choices)}"


def _unknown_tag(where: str, detail: ErrorDetails) -> str:
    choices = [choice.strip("' ") for choice in _context(detail, "expected_tags").split(",")]
    tag = _context(detail, "tag")
    return f"`{where}` cannot be {_shown(tag)}{_nearest(tag, choices)}"


def _no_tag(where: str, detail: ErrorDetails) -> str:
    return f"`{where}` needs a `{_key(detail)}`: what sort of thing it is"


def _key(detail: ErrorDetails) -> str:
    """The key that tells alternatives apart."""
    return _context(detail, "discriminator").strip("'")


def _not_text(where: str, detail: ErrorDetails) -> str:
    value = detail["input"]
    quoted = f'; write "{value}" in quotes' if isinstance(value, int | float) else ""
    return f"`{where}` should be text, not {_shown(value)}{quoted}"


def _should_be(what: str) -> Callable[[str, ErrorDetails], str]:
    return lambda where, detail: f"`{where}` should be {what}, not {_shown(detail['input'])}"


def _bound(what: str, key: str) -> Callable[[str, ErrorDetails], str]:
    return lambda where, detail: f"`{where}` should be {what} {_context(detail, key)}, not {_shown(detail['input'])}"


def _own(where: str, detail: ErrorDetails) -> str:
    return _context(detail, "error") or detail["msg"]


def _pattern(where: str, detail: ErrorDetails) -> str:
    return f"`{where}` should be lower-case words and numbers joined by hyphens, not {_shown(detail['input'])}"


def _shown(value: Any) -> str:
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list | tuple):
        return "a list"
    text = str(value) if not isinstance(value, str) else repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _nearest(word: Any, known: Sequence[str]) -> str:
    near = difflib.get_close_matches(str(word), known, n=1)
    if near:
        return f"; did you mean `{near[0]}`?"
    return f"; it can be {', '.join(known)}" if len(known) <= 40 else ""


def _known_keys() -> set[str]:
    def below(record: type[Record]) -> Iterator[str]:
        yield from record.model_fields
        for inner in record.__subclasses__():
            yield from below(inner)

    return {key for module in (assets, node, order, schema) for key in below(Record) if module}


_RANK = {"union_tag_invalid": 0, "value_error": 0, "tuple_type": 2, "model_type": 3}
_SENTENCES: dict[str, Callable[[str, ErrorDetails], str]] = {
    "missing": _missing,
    "extra_forbidden": _unknown_key,
    "literal_error": _unknown_choice,
    "union_tag_invalid": _unknown_tag,
    "union_tag_not_found": _no_tag,
    "string_type": _not_text,
    "string_pattern_mismatch": _pattern,
    "value_error": _own,
    "float_type": _should_be("a number"),
    "float_parsing": _should_be("a number"),
    "int_type": _should_be("a whole number"),
    "int_parsing": _should_be("a whole number"),
    "int_from_float": _should_be("a whole number"),
    "bool_type": _should_be("true or false"),
    "bool_parsing": _should_be("true or false"),
    "less_than_equal": _bound("at most", "le"),
    "greater_than_equal": _bound("at least", "ge"),
    "tuple_type": _should_be("a list"),
    "model_type": _should_be("a mapping"),
    "dict_type": _should_be("a mapping"),
    "model_attributes_type": _should_be("a mapping"),
}
