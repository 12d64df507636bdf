"""Instructions with misspelt words, read as they were meant, and told of as they were typed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from rpg.core.diagnostics import Diagnostic, Span
from rpg.ir.schema import TaskSchema
from rpg.language.tokens import Token


@dataclass(frozen=True)
class Respelt:
    """An instruction with misspelt words. `edits`: where each of them stands, and how it is meant."""

    typed: str
    edits: tuple[tuple[Span, str], ...]

    @classmethod
    def of(cls, text: str, words: Iterable[Token], typed: Iterable[Token]) -> Respelt:
        """The text of words of which some are mended. `typed`: as they were before, where what stands in place of a
        name is no misspelt word."""
        found = [*typed]
        many = Counter(token.span for token in found)
        own = {t.span for t in found if many[t.span] == 1 and t.raw.lower() == text[slice(*t.span)].lower()}
        plain = (w for w in words if w.kind == "word" and w.span in own)
        return cls(text, tuple((w.span, w.raw) for w in plain if w.raw.lower() != text[slice(*w.span)].lower()))

    @property
    def text(self) -> str:
        """The instruction as it was meant."""
        text = self.typed
        for (begin, end), word in reversed(self.edits):
            text = text[:begin] + word + text[end:]
        return text

    def _typed_at(self, place: int) -> int:
        """Where in the typed text what stands at `place` of the mended one begins or ends."""
        longer = 0
        for (begin, end), word in self.edits:
            if place <= begin + longer:
                break
            if place < begin + longer + len(word):
                return begin
            longer += len(word) - (end - begin)
        return place - longer

    def diagnosed(self, found: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
        """Diagnostics of the mended text, about the text that was typed."""
        return tuple(Diagnostic.model_validate(self._moved(d.model_dump())) for d in found)

    def task(self, task: TaskSchema) -> TaskSchema:
        """The task of the mended text as one of the text that was typed."""
        return TaskSchema.model_validate({**self._moved(task.model_dump()), "instruction": self.typed})

    def _moved(self, data: Any) -> Any:
        if isinstance(data, dict):
            return {
                key: self._span(value) if key == "span" and value is not None else self._moved(value)
                for key, value in data.items()
            }
        return type(data)(map(self._moved, data)) if isinstance(data, list | tuple) else data

    def _span(self, span: Span) -> Span:
        return self._typed_at(span[0]), self._typed_at(span[1])
