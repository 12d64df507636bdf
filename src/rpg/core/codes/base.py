"""What is known about one diagnostic code."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Code:
    """A diagnostic code and its entry in the documentation.

    `id` is a kebab-case slug such as "unknown-word"; `title` says in a few words what is wrong; `explanation` says, in
    one to three sentences, when it is reported and why. `example` is an instruction (or a command) that brings it
    about; `remedy` is that example mended, so that it works.
    """

    id: str
    title: str
    explanation: str
    example: str = ""
    remedy: str = ""
