"""The built-in front end: English instruction -> TaskSchema, or what is wrong with it. No network, no chance."""

from __future__ import annotations

from typing import Protocol

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.schema import TaskSchema
from rpg.language.read import read_sentences
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from rpg.passes.schema.build import build
from rpg.passes.schema.feasibility import with_repairs
from rpg.passes.schema.guard import guard

Reading = tuple[TaskSchema | None, tuple[Diagnostic, ...]]


class FrontEnd(Protocol):
    """Reads an instruction. `name`: the family's, from the goal if None."""

    def read(self, text: str, *, name: str | None = None, seed: int = 0, author: str | None = None) -> Reading:
        """The task, or None with the diagnostics that say why not."""


class BuiltinFrontEnd:
    """Words, grammar, resolution: deterministic, bounded, and silent about nothing."""

    def read(self, text: str, *, name: str | None = None, seed: int = 0, author: str | None = None) -> Reading:
        """The task, or None with the diagnostics that say why not."""
        try:
            guard(text)
            tokens, strays = tokenize(text)
            words, notes, wrong = read_words(tokens)
            if wrong or strays:
                return None, (*wrong, *(_stray(s.text, s.span) for s in strays))
            texts = read_sentences(words)
            return build(texts, text, notes, name=name, seed=seed, author=author), ()
        except Refusal as refusal:
            return None, with_repairs(refusal.diagnostics)
        except RecursionError:
            message = "this is too tangled to be read"
            return None, (
                Diagnostic(
                    code="too-complex",
                    message=message,
                    span=(0, len(text)),
                    hint="use several short sentences",
                    origin="schema",
                ),
            )


def _stray(text: str, span: tuple[int, int]) -> Diagnostic:
    return Diagnostic(
        code="stray-character",
        message=f"the character {text!r} means nothing here",
        span=span,
        hint="leave it out",
        origin="schema",
    )
