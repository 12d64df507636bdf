"""Codes reported when an instruction is understood but cannot be carried out."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = ()
