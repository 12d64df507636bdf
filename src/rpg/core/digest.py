"""Canonical JSON and SHA-256 digests: equal data give equal bytes on every machine."""

from __future__ import annotations

import hashlib
import json
from typing import Any


def canonical_json(data: Any) -> str:
    """Serialise `data` with sorted keys, no spaces and shortest round-trip floats."""
    return json.dumps(data, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False)


def sha256(data: str | bytes) -> str:
    """Hex SHA-256 digest of `data` (text is taken as UTF-8)."""
    return hashlib.sha256(data.encode() if isinstance(data, str) else data).hexdigest()


def digest_of(data: Any) -> str:
    """Hex SHA-256 digest of the canonical JSON of `data`."""
    return sha256(canonical_json(data))
