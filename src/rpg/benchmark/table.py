"""The table of a suite beside published figures, as data and as LaTeX."""

from __future__ import annotations

from typing import Any

from rpg.benchmark.measure import METRICS, Turn, share

TITLES = {"task_success": "Task success", "compiled": "Compile", "smoke": "Smoke test"}
PUBLISHED = {
    "RoboPlayground": {"task_success": (100.0, 0.0), "compiled": (100.0, 0.0), "smoke": (100.0, 0.0)},
    "Cursor": {"task_success": (100.0, 0.0), "compiled": (80.0, 24.8), "smoke": (80.0, 24.8)},
    "GenSim": {"task_success": (80.0, 24.8), "compiled": (80.0, 24.8), "smoke": (60.0, 30.4)},
}
"""Percentages and half-widths over the ten sessions from the table "Comparison of task specification quality across
three task authoring systems" of the RoboPlayground paper; its "Test Case" row is task success here."""
VERIFIED = {"RoboPlayground": (100.0, 0.0), "Cursor": (80.0, 24.8), "GenSim": (70.0, 28.4)}
"""The row "Human Verification" of the same table, to set beside what the people who judged the page accept."""


def rows(turns: list[Turn]) -> list[tuple[str, str, list[str]]]:
    """(title, ours, published figures in the order of PUBLISHED) for every metric, as text."""
    found = []
    for metric in METRICS:
        ours = share(turns, metric)
        others = [_cell(*figures[metric]) for figures in PUBLISHED.values()]
        found.append((TITLES[metric], _cell(ours.percent, ours.half_width), others))
    return found


def as_data(suite: str, turns: list[Turn]) -> dict[str, Any]:
    """Everything measured, as one JSON document."""
    metrics = {metric: vars(share(turns, metric)) for metric in METRICS}
    return {
        "suite": suite,
        "tasks": len(turns),
        "metrics": metrics,
        "published": {name: dict(figures) for name, figures in PUBLISHED.items()} if suite == "sessions" else {},
        "turns": [turn.model_dump(mode="json") for turn in turns],
    }


def as_latex(suite: str, turns: list[Turn]) -> str:
    """The table with booktabs rules; published figures stand beside the suite that they were measured on."""
    names = ["rpg", *(PUBLISHED if suite == "sessions" else ())]
    lines = [rf"\begin{{tabular}}{{l{'c' * len(names)}}}", r"\toprule"]
    lines += [" & ".join(["Metric", *names]) + r" \\", r"\midrule"]
    for title, ours, others in rows(turns):
        cells = [f"${cell.replace('±', chr(92) + 'pm')}$" for cell in (ours, *others)][: len(names)]
        lines.append(" & ".join([title, *cells]) + r" \\")
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}"]) + "\n"


def _cell(percent: float, half_width: float) -> str:
    return f"{percent:.1f} ± {half_width:.1f}"
