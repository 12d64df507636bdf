"""What is said of a phrase that speaks of nothing in the task, or of more than one thing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rpg.blocks.nouns import bare, join
from rpg.core.diagnostics import Diagnostic, Refusal, Span
from rpg.steer.view import View


def missing(view: View, span: Span, word: str) -> Refusal:
    """There is no such object; what there is, instead."""
    there = join([f"the {bare(name, view.world)}" for name in _distinct(view, view.world.assets)])
    message = f"there is nothing that {word!r} could mean" if word else "the task has no such block"
    return Refusal([diagnostic("no-such-object", span, message, f"the task has {there}")])


def ambiguous(view: View, span: Span, found: Sequence[str], word: str) -> Refusal:
    message = f"{word!r} could be any of {len(found)} blocks" if word else f"this could be any of {len(found)} blocks"
    return Refusal([diagnostic("ambiguous-object", span, message, choices(view, found))])


def choices(view: View, found: Iterable[str]) -> str:
    named = [f"the {bare(name, view.world)}" for name in _distinct(view, found)]
    return (
        f"say which: {join(named, 'or')}" if len(named) > 1 else "say which by its place: the top one, the leftmost one"
    )


def _distinct(view: View, names: Iterable[str]) -> list[str]:
    found: dict[str, str] = {}
    for name in names:
        found.setdefault(bare(name, view.world), name)
    return list(found.values())


def diagnostic(code: str, span: Span, message: str, hint: str) -> Diagnostic:
    return Diagnostic(code=code, message=message, span=span, hint=hint, origin="steer")
