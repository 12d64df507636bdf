"""The short natural-language specification that opens a generated class: objects, goal, success criteria."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

from rpg.blocks.english import describe_goal
from rpg.ir.assets import EDGE, Asset, GoalPatch, SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen.layout import WIDTH, Expr, Infix, Labelled

DOUBLE = ("no", "a", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def docstring(schema: TaskSchema, check: Expr) -> list[str]:
    """The lines of the class docstring, indented one level; `check` is the success check over named booleans."""
    criteria = "; ".join([*_criteria(check), "every block released, supported and at rest"])
    paragraphs = [
        f"{objects(schema.assets)}.",
        "",
        f"Goal: {describe_goal(schema)}",
        f"Success: {criteria}.",
    ]
    lines: list[str] = []
    for paragraph in paragraphs:
        lines += textwrap.wrap(_plain(paragraph), WIDTH - 7, break_on_hyphens=False) or [""]
    lines[0] = '"""' + lines[0]
    return [("    " + line).rstrip() for line in (*lines, '"""')]


def _criteria(check: Expr) -> list[str]:
    """The success check in words: "red_on_blue or red_on_green"."""
    if isinstance(check, Infix) and check.operator == "&":
        return [", ".join(_said(part) for part in check.operands)]
    return [_said(check)] if check else []


def _said(expr: Expr) -> str:
    match expr:
        case Infix():
            word = {"&": " and ", "|": " or "}[expr.operator]
            return word.join(f"({_said(p)})" if isinstance(p, Infix) else _said(p) for p in expr.operands)
        case Labelled():
            inner = _said(expr.value)
            return f"not ({inner})" if isinstance(expr.value, Infix) else f"not {inner}"
        case _:
            return str(expr)


def _plain(text: str) -> str:
    """Nothing in a docstring may end it or be read as an escape."""
    shown = text if text.isprintable() else "".join(char if char.isprintable() else " " for char in text)
    return shown.replace("\\", "/").replace('"', "'")


def objects(assets: Iterable[Asset]) -> str:
    """ "A red block, two letter blocks (A, B) and a green patch"."""
    counts: dict[str, list[str]] = {}
    for asset in assets:
        counts.setdefault(_kind(asset), []).append(_symbol(asset))
    parts = [_phrase(kind, symbols) for kind, symbols in counts.items()]
    text = parts[0] if len(parts) == 1 else ", ".join(parts[:-1]) + " and " + parts[-1]
    return text[:1].upper() + text[1:]


def _kind(asset: Asset) -> str:
    if isinstance(asset, GoalPatch):
        return f"{asset.color} {asset.shape} patch" if asset.shape != "square" else f"{asset.color} patch"
    size = "" if asset.size == EDGE else f"{asset.size * 100:g} cm "
    if isinstance(asset, SemanticCube):
        shown = _symbol(asset)
        sort = "letter" if shown.isalpha() else "number" if shown.isdecimal() else "symbol"
        return f"{size}{sort} block" if asset.color == "ivory" else f"{size}{asset.color} {sort} block"
    return f"{size}{asset.color} block"


def _symbol(asset: Asset) -> str:
    if not isinstance(asset, SemanticCube):
        return ""
    if asset.labels is None:
        return asset.label
    shown = [symbol for symbol in asset.labels.model_dump().values() if symbol]
    return "/".join(dict.fromkeys(shown))


def _phrase(kind: str, symbols: list[str]) -> str:
    number = len(symbols)
    count = DOUBLE[number] if number < len(DOUBLE) else str(number)
    if number == 1 and kind.startswith(("a", "e", "i", "o", "u", "8", "11")):
        count = "an"
    plural = kind if number == 1 else kind + ("es" if kind.endswith("ch") else "s")
    shown = ", ".join(symbol for symbol in symbols if symbol)
    return f"{count} {plural}" + (f" ({shown})" if shown else "")
