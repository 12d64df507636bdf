"""What the gallery shows of a version, read from its files."""

from __future__ import annotations

import base64
import re
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.ir.assets import GoalPatch
from rpg.ir.walk import atoms
from rpg.store import SteeringMeta, Version, Workspace

GATE = re.compile(r"^\d+ (?P<name>\S+)\s+(?P<result>pass|FAIL)\s*(?P<figures>.*)$", re.MULTILINE)
WIDTH = 480
"""Pictures are shown this wide (pixels), and stored so."""


@dataclass(frozen=True)
class Gate:
    """A check of a version, with what it measured."""

    name: str
    passed: bool
    figures: str


@dataclass(frozen=True)
class Card:
    """One version. `pictures`: "initial" and "goal" -> a data URI. `parent` is a version number."""

    family: str
    number: int
    short_hash: str
    head: bool
    parent: int | None
    instruction: str
    goal: str
    assumptions: tuple[str, ...]
    gates: tuple[Gate, ...]
    steering: SteeringMeta | None
    colors: tuple[str, ...]
    kinds: tuple[str, ...]
    blocks: int
    pictures: dict[str, str]

    @property
    def anchor(self) -> str:
        return f"{self.family}-{self.number}"

    @property
    def category(self) -> str:
        """The class of the change; "BASE" for version 0."""
        return self.steering.intent if self.steering else "BASE"


@dataclass(frozen=True)
class Album:
    """The cards of a family, by number."""

    name: str
    cards: tuple[Card, ...]


def albums(workspace: Workspace) -> tuple[tuple[Album, ...], tuple[str, ...]]:
    """Every family of a workspace that can be read, and what is wrong with the others."""
    found: list[Album] = []
    problems: list[str] = []
    for family in workspace.families():
        try:
            versions = family.versions()
            numbers = {version.hash: version.number for version in versions}
            head = family.head_name()
            cards = tuple(_card(version, numbers, version.directory.name == head) for version in versions)
        except UsageError as error:
            problems.append(str(error))
            continue
        if cards:
            found.append(Album(family.name, cards))
    return tuple(found), tuple(problems)


def _card(version: Version, numbers: dict[str, int], head: bool) -> Card:
    schema, snapshot = version.schema, version.snapshot
    blocks = schema.blocks
    return Card(
        family=version.family,
        number=version.number,
        short_hash=version.short_hash,
        head=head,
        parent=numbers.get(snapshot.parent or ""),
        instruction=schema.instruction,
        goal=snapshot.snapshot.goal_summary,
        assumptions=schema.assumptions,
        gates=tuple(Gate(m["name"], m["result"] == "pass", m["figures"]) for m in GATE.finditer(version.log)),
        steering=snapshot.steering,
        colors=tuple(dict.fromkeys(asset.color for asset in schema.assets if asset.color != "ivory")),
        kinds=tuple(dict.fromkeys(atom.kind.replace("_", " ") for atom in atoms(schema.goal))),
        blocks=sum(not isinstance(asset, GoalPatch) for asset in blocks),
        pictures=_pictures(version.directory),
    )


def _pictures(directory: Path) -> dict[str, str]:
    found: dict[str, str] = {}
    for name in ("initial", "goal"):
        path = directory / f"{name}.png"
        if path.is_file():
            found[name] = _data_uri(path)
    return found


def _data_uri(path: Path) -> str:
    """A picture small enough to be carried inside the page."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(path) as image:
            small = image.convert("RGB")
            small.thumbnail((WIDTH, WIDTH))
            buffer = BytesIO()
            small.save(buffer, "JPEG", quality=82, optimize=True)
    except (OSError, UnidentifiedImageError):
        return ""
    return "data:image/jpeg;base64," + base64.b64encode(buffer.getvalue()).decode()
