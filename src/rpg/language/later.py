"""Functions of modules that speak of one another: each is found when it is first called, and not again."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any


def later(user: str, module: str, *names: str) -> list[Callable[..., Any]]:
    """What stands in for functions of `module` in the module `user`, which imports it only when one is first called.

    An import in a function takes longer than most rules of a grammar do, and they are run many times for a sentence.
    """
    return [_stand_in(user, module, name) for name in names]


def _stand_in(user: str, module: str, name: str) -> Callable[..., Any]:
    def first(*args: Any, **more: Any) -> Any:
        found = getattr(import_module(module), name)
        setattr(sys.modules[user], name, found)
        return found(*args, **more)

    return first
