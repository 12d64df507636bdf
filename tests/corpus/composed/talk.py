"""What people say around a task: the same tasks among politeness, reasons, remarks and the language of test engineers.

The wordings stand in talk.yaml; "(a|b|)" there is one of several. What carries meaning, or asks for something that
cannot be done, must not be passed over, wherever it stands: a text with it is to be refused.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import yaml

from tests.corpus.composed import Composed

_COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
_CHOICE = re.compile(r"\(([^()]*)\)")


@cache
def _said() -> dict[str, list[Any]]:
    """The wordings."""
    found: dict[str, list[Any]] = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
    return found


def composed(rng: Random) -> Composed:
    """A task in one of its forms, with talk around it."""
    said = _said()
    kind = rng.choices(("frames", "before", "behind", "aside", "lost"), (40, 12, 20, 13, 15))[0]
    frame = rng.choice(said[kind])
    bound = not frame.startswith("{core}") and kind != "before"
    text = frame.replace("{core}", "{do}")
    parts = _parts(text)
    core = rng.choice([c for c in said["cores"] if all(p in c for p in parts) and not (bound and "alone" in c)])
    meaning = {"refuse": True} if kind == "lost" else core["means"]
    for part in parts:
        text = text.replace(f"{{{part}}}", core[part])
    text = _tidied(_chosen(rng, text), rng)
    colors = dict(zip("abcd", rng.sample(_COLORS, 4), strict=True))
    return Composed(frame, _colored(text, colors), _all_colored(meaning, colors))


def _parts(frame: str) -> list[str]:
    return re.findall(r"{(\w+)}", frame)


def _chosen(rng: Random, text: str) -> str:
    """The text with one of the words of each choice."""
    while found := _CHOICE.search(text):
        text = text[: found.start()] + rng.choice(found.group(1).split("|")) + text[found.end() :]
    return text


def _tidied(text: str, rng: Random) -> str:
    """Spaces and a stop as they are typed: now and then with small letters and without a stop."""
    text = re.sub(r" +([,.!?:;)])", r"\1", re.sub(r"  +", " ", text)).replace("<", "(").replace(">", ")").strip()
    text = re.sub(r"^,\s*|,(?=,)", "", text)
    if rng.random() < 0.3:
        return text
    text = text[0].upper() + text[1:]
    return text if text[-1] in ".!?" else f"{text}."


def _colored(text: str, colors: dict[str, str]) -> str:
    return re.sub(r"\$([abcd])", lambda found: colors[found.group(1)], text)


def _all_colored(meaning: Any, colors: dict[str, str]) -> Any:
    if isinstance(meaning, dict):
        return {_colored(str(key), colors): _all_colored(value, colors) for key, value in meaning.items()}
    if isinstance(meaning, list):
        return [_all_colored(item, colors) for item in meaning]
    return _colored(meaning, colors) if isinstance(meaning, str) else meaning
