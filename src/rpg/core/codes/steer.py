"""Codes reported while a request is turned into an edit of a task."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = ()
