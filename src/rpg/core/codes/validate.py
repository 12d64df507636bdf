"""Codes reported by the validation gates and the repair agents."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = ()
