"""One self-contained page with the pictures of every task of a suite, for people to judge."""

from __future__ import annotations

import base64
import json
from importlib.resources import files
from pathlib import Path

from rpg.benchmark.measure import Turn

PICTURES = {"start": "initial.png", "goal": "goal.png"}


def page(turns: list[Turn]) -> str:
    """The page as HTML; it loads nothing from elsewhere. Above an edit stands what was said before it."""
    tasks = [
        {
            "key": turn.key,
            "before": [other.words for other in turns if other.case == turn.case and other.number < turn.number],
            "words": turn.words,
            "goal_text": turn.goal_text,
            "pictures": _pictures(turn.directory),
        }
        for turn in turns
        if turn.directory
    ]
    data = json.dumps(tasks, ensure_ascii=False).replace("<", "\\u003c")
    return files("rpg.benchmark").joinpath("page.html").read_text(encoding="utf-8").replace("@TASKS@", data)


def _pictures(directory: str | None) -> dict[str, str]:
    found = {}
    for title, name in PICTURES.items():
        path = Path(directory or "") / name
        if path.is_file():
            found[title] = "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode()
    return found
