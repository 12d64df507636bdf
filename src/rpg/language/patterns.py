"""Patterns that are compiled when they are first asked something: to compile one may take a hundredth of a second, and
most texts ask few of them."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Any, cast


class _OnDemand:
    """Stands for a pattern, and has whatever of it has been asked for."""

    def __init__(self, text: str) -> None:
        self.text = text

    @cached_property
    def compiled(self) -> re.Pattern[str]:
        """The pattern itself."""
        return re.compile(self.text)

    def __getattr__(self, name: str) -> Any:
        """Looked for where there is nothing of the name yet: what is kept here is found as fast as in the pattern."""
        if name.startswith("__"):
            raise AttributeError(name)
        found = getattr(self.compiled, name)
        setattr(self, name, found)
        return found


def on_demand(text: str) -> re.Pattern[str]:
    """A pattern, compiled when it is first used."""
    return cast(re.Pattern[str], _OnDemand(text))
