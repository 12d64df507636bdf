"""Patterns that are compiled on demand: each can be, and answers like one that is compiled at once."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib import import_module
from pkgutil import walk_packages

import pytest

import rpg.language
import rpg.passes.schema
from rpg.language.patterns import _OnDemand, on_demand


def inside(value: object) -> Iterator[_OnDemand]:
    """The patterns in a value of a module."""
    if isinstance(value, _OnDemand):
        yield value
    elif isinstance(value, list | tuple):
        for item in value:
            yield from inside(item)


def test_every_pattern_can_be_compiled() -> None:
    patterns = [
        pattern
        for package in (rpg.language, rpg.passes.schema)
        for found in walk_packages(package.__path__, f"{package.__name__}.")
        for value in vars(import_module(found.name)).values()
        for pattern in inside(value)
    ]
    assert len(patterns) > 100
    for pattern in patterns:
        assert pattern.compiled.pattern == pattern.text


def test_a_pattern_answers_like_a_compiled_one() -> None:
    pattern, compiled = on_demand("(?P<one>a+)b"), re.compile("(?P<one>a+)b")
    for _ in range(2):
        assert pattern.search("xaab")["one"] == compiled.search("xaab")["one"]
        assert pattern.match("xaab") is None
        assert pattern.fullmatch("ab") is not None
        assert pattern.sub("c", "ab aab") == compiled.sub("c", "ab aab")
        assert pattern.groupindex == compiled.groupindex


def test_a_broken_pattern_is_told_when_it_is_asked() -> None:
    pattern = on_demand("(")
    with pytest.raises(re.error):
        pattern.search("a")
