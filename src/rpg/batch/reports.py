"""A batch's report for machines and for people: JUnit XML, JSON, Markdown."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree

from rpg.batch.lines import Line, Report

OUTCOMES = ("current", "built", "same", "differs", "refused", "failed")


def as_data(report: Report) -> dict[str, Any]:
    """The report as one JSON document."""
    return {
        "good": report.good,
        "upgraded": report.upgraded or None,
        "counts": {outcome: report.count(outcome) for outcome in OUTCOMES if report.count(outcome)},
        "entries": [_line_data(line) for line in report.lines],
    }


def _line_data(line: Line) -> dict[str, Any]:
    return {
        "place": line.entry.place,
        "instruction": line.entry.instruction,
        "edits": list(line.entry.edits),
        "outcome": line.outcome,
        "family": line.family or None,
        "detail": line.detail or None,
        "diagnostics": list(line.diagnostics),
        "rejected": line.rejected or None,
    }


def as_junit(report: Report) -> bytes:
    """The report as JUnit XML: a refused or differing entry is a failure, a build that broke an error."""
    suite = ElementTree.Element(
        "testsuite",
        name="rpg batch",
        tests=str(len(report.lines)),
        failures=str(report.count("refused") + report.count("differs")),
        errors=str(report.count("failed")),
    )
    for line in report.lines:
        case = ElementTree.SubElement(suite, "testcase", classname=line.entry.place, name=_clean(line.entry.title))
        if not line.good:
            tag = "error" if line.outcome == "failed" else "failure"
            found = ElementTree.SubElement(case, tag, message=_clean(f"{line.outcome}: {line.detail.splitlines()[0]}"))
            found.text = _clean(line.detail)
    ElementTree.indent(suite)
    text = ElementTree.tostring(suite, encoding="unicode")
    return f'<?xml version="1.0" encoding="utf-8"?>\n{text}\n'.encode()


def as_markdown(report: Report) -> str:
    """The report as a table of what is not in order, below the counts."""
    counts = ", ".join(f"{report.count(o)} {o}" for o in OUTCOMES if report.count(o)) or "nothing to do"
    lines = [f"**{counts}**", ""]
    if report.upgraded:
        lines += [f"Verified by other versions before: {report.upgraded}.", ""]
    bad = [line for line in report.lines if not line.good]
    if bad:
        lines += ["| entry | instruction | outcome | why |", "| --- | --- | --- | --- |"]
        for line in bad:
            why = line.detail.splitlines()[0] if line.detail else ""
            cells = (line.entry.place, line.entry.instruction, line.outcome, why)
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines).rstrip() + "\n"


def _clean(text: str) -> str:
    """`text` without the control characters that XML cannot hold."""
    return "".join(char if char >= " " or char in "\t\n" else "\ufffd" for char in text)
