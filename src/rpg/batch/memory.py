"""Memory of processes that compile for hours."""

from __future__ import annotations

import ctypes

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD = -1, -3
THRESHOLD = 128 * 1024
"""Bytes; where glibc begins, before it adapts to what was freed."""


def give_back() -> None:
    """Have glibc return freed memory to the system for good.

    MuJoCo's arenas come and go with every task. glibc takes their size for the usual one after the first was freed,
    and from then on keeps them in its heap, where the few objects that stay pin ever more of it. Elsewhere than with
    glibc this does nothing.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is not None:
        for option in (M_TRIM_THRESHOLD, M_MMAP_THRESHOLD):
            mallopt(option, THRESHOLD)
