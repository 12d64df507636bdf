"""Codes reported while reading an instruction."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = ()
