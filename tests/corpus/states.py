"""Pictures of the corpus as states of a task. The notation is described in README.md of this folder."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from itertools import pairwise

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.state import BlockState, Quat, World, yaw_quat
from rpg.ir.assets import EDGE, SemanticCube
from tests.corpus.looks import Binding, Mismatch

MIDDLE = (0.55, 0.0)
TOKEN = re.compile(
    r"(?P<look>(?:[-+*/=]|[A-Z0-9]|[a-z]\w*(?::[-A-Z0-9+*/=])?)(?:\{[^}]*\})?)"
    r"(?P<all>\*)?(?:#(?P<index>\d+))?(?P<changes>(?:\([^)]*\)|~[xy]?-?[\d.]+)*)"
)
OPTION = re.compile(r"(at|pitch|yaw|circle|towers|groups|swap|drop)=(\S+)|(rev|side)$")


@dataclass
class Place:
    """A block in a piece: `x`, `y` in units from the piece's middle, `z` of its centre in metres above the foot."""

    name: str
    x: float
    y: float
    z: float
    quat: Quat = (1.0, 0.0, 0.0, 0.0)


@dataclass
class Piece:
    """One part of a picture: rows of cells, each a list of tokens from bottom to top, and its options."""

    rows: list[list[list[str]]]
    options: dict[str, str] = field(default_factory=dict)


class Painter:
    """Turns pictures into states of one task."""

    def __init__(self, binding: Binding) -> None:
        self.binding = binding
        self.world = World(binding.schema.assets)

    def state(self, picture: str, start: BlockState | None = None) -> BlockState:
        """The state that `picture` draws; blocks it does not mention stand far away."""
        pieces = [parse(part) for part in picture.split(";") if part.strip()]
        used = {name for piece in pieces for name in self._indexed(piece)}
        home = -1.2 if self.world.patches else 0.0
        position = {n: (5.0 + 0.4 * i, 0.0, TABLE_Z + e / 2) for i, (n, e) in enumerate(self.world.edge.items())}
        orientation: dict[str, Quat] = dict.fromkeys(position, (1.0, 0.0, 0.0, 0.0))
        right = math.inf
        for piece in pieces:
            places = self._layout(piece, used)
            if "at" in piece.options:
                x0, y0, level = self._at(piece.options["at"])
            else:
                half = max((abs(p.y) for p in places), default=0.0) + 0.5
                y0 = 0.0 if right == math.inf else (right - 4 - half) * EDGE
                right = (right if right != math.inf else half) - (0 if right == math.inf else 4) - 2 * half
                x0, level = home, 0.0
            for p in places:
                x, y = MIDDLE[0] + x0 + p.x * EDGE, MIDDLE[1] + y0 + p.y * EDGE
                position[p.name] = (x, y, TABLE_Z + level * EDGE + p.z)
                orientation[p.name] = p.quat
        return BlockState(world=self.world, position=position, orientation=orientation, start=start)

    def _indexed(self, piece: Piece) -> list[str]:
        found = []
        for token in (t for row in piece.rows for cell in row for t in cell):
            match = TOKEN.fullmatch(token)
            if match and match["index"]:
                found.append(self._pick(match["look"], int(match["index"])))
        return found

    def _pick(self, look: str, index: int) -> str:
        names = self.binding.blocks(look)
        if index > len(names):
            raise Mismatch(f"there are only {len(names)} {look}")
        return names[index - 1]

    def _take(self, look: str, used: set[str]) -> str:
        name = next((n for n in self.binding.blocks(look) if n not in used), None)
        if name is None:
            raise Mismatch(f"there are only {len(self.binding.blocks(look))} {look}")
        used.add(name)
        return name

    def _cells(self, row: list[list[str]], used: set[str]) -> list[list[tuple[str, str]]]:
        """Cells of (name, changes), with `red*` and `red^*` spread out."""
        cells: list[list[tuple[str, str]]] = []
        for tokens in row:
            if tokens == ["."]:
                cells.append([])
                continue
            if len(tokens) == 2 and tokens[1] == "*":
                rest = [n for n in self.binding.blocks(tokens[0]) if n not in used]
                used.update(rest)
                cells.append([(n, "") for n in rest])
                continue
            cell: list[tuple[str, str]] = []
            for token in tokens:
                match = TOKEN.fullmatch(token)
                if match is None:
                    raise ValueError(f"cannot read {token!r} in a picture")
                if match["all"]:
                    rest = [n for n in self.binding.blocks(match["look"]) if n not in used]
                    used.update(rest)
                    cells.extend([(n, "")] for n in rest)
                    continue
                name = self._pick(match["look"], int(match["index"])) if match["index"] else None
                cell.append((name or self._take(match["look"], used), match["changes"]))
            if cell:
                cells.append(cell)
        return cells

    def _layout(self, piece: Piece, used: set[str]) -> list[Place]:
        rows = [self._cells(row, used) for row in piece.rows]
        options = piece.options
        if "towers" in options or "groups" in options:
            names = [n for row in rows for cell in row for n, _ in cell] or list(self.world.blocks)
            used.update(names)
            places = self._spread(names, options)
        elif "circle" in options:
            places = self._circle([c for row in rows for c in row], float(options["circle"]))
        else:
            places = self._grid(rows, options)
        return _vary(places, options)

    def _grid(self, rows: list[list[list[tuple[str, str]]]], options: dict[str, str]) -> list[Place]:
        across, along = _pitch(options)
        columns = max((len(row) for row in rows), default=0)
        places = []
        for i, row in enumerate(rows):
            for j, cell in enumerate(row):
                y = ((columns - 1) / 2 - j) * across
                if "side" in options:
                    places += self._stack(cell, 0.0, y, foot=(len(rows) - 1 - i) * EDGE)
                else:
                    places += self._stack(cell, ((len(rows) - 1) / 2 - i) * along, y)
        return places

    def _circle(self, cells: list[list[tuple[str, str]]], radius: float) -> list[Place]:
        places = []
        for i, cell in enumerate(cells):
            angle = 2 * math.pi * i / len(cells)
            places += self._stack(cell, radius * math.cos(angle), -radius * math.sin(angle))
        return places

    def _spread(self, names: list[str], options: dict[str, str]) -> list[Place]:
        if options.get("towers") == "match":
            return self._matching(names)
        if "towers" in options:
            count = int(options["towers"])
            size, more = divmod(len(names), count)
            cuts = [i * size + min(i, more) for i in range(count + 1)]
            stacks = [names[a:b] for a, b in pairwise(cuts)]
            return [p for k, s in enumerate(stacks) for p in self._stack([(n, "") for n in s], 0.0, -4.0 * k)]
        groups: dict[str, list[str]] = {}
        for name in names:
            groups.setdefault(self._trait(name, options["groups"]), []).append(name)
        return [
            p
            for k, members in enumerate(groups.values())
            for j, n in enumerate(members)
            for p in self._stack([(n, "")], -5.0 * k, -1.25 * j)
        ]

    def _matching(self, names: list[str]) -> list[Place]:
        places = []
        for patch in self.world.patches.values():
            mine = [(n, "") for n in names if self.world.blocks[n].color == patch.color]
            x, y = patch.position or MIDDLE
            home = -1.2 / EDGE
            places += self._stack(mine, (x - MIDDLE[0]) / EDGE - home, (y - MIDDLE[1]) / EDGE)
        return places

    def _trait(self, name: str, attribute: str) -> str:
        block = self.world.blocks[name]
        symbol = block.symbol("top") if isinstance(block, SemanticCube) else ""
        match attribute:
            case "color":
                return block.color
            case "kind":
                return "letter" if symbol.isalpha() else "digit" if symbol.isdigit() else "plain"
            case "vowel":
                return str(symbol in "AEIOU")
            case "parity":
                return str(int(symbol) % 2)
        return symbol

    def _stack(self, cell: list[tuple[str, str]], x: float, y: float, foot: float = 0.0) -> list[Place]:
        places = []
        for name, changes in cell:
            edge = self.world.edge[name]
            place = Place(name, x, y, foot + edge / 2)
            for change in re.findall(r"\(([^)]*)\)|~([xy]?)(-?[\d.]+)", changes):
                _change(place, *change)
            places.append(place)
            foot += edge
        return places

    def _at(self, text: str) -> tuple[float, float, float]:
        """Middle of a piece: x, y in metres from the table's middle, and its level."""
        look, _, offset = text.rpartition("+") if "+" in text else (text, "", "")
        if "patch" not in text:
            x, y, *level = (float(v) for v in text.split(","))
            return x * EDGE, y * EDGE, level[0] if level else 0.0
        dx, dy = (float(v) for v in offset.split(",")) if offset else (0.0, 0.0)
        patches = self.binding.patches(look)
        if not patches:
            raise Mismatch(f"there is no {look}")
        px, py = patches[0].position or MIDDLE
        return px - MIDDLE[0] + dx * EDGE, py - MIDDLE[1] + dy * EDGE, 0.0


def parse(text: str) -> Piece:
    """Read one piece of a picture."""
    options: dict[str, str] = {}
    rows: list[list[list[str]]] = [[]]
    for word in text.split():
        option = OPTION.match(word)
        if option:
            options[option[1] or option[3]] = option[2] or ""
        elif word == "|":
            rows.append([])
        else:
            rows[-1].append(word.split("^"))
    return Piece(rows, options)


def _pitch(options: dict[str, str]) -> tuple[float, float]:
    across, _, along = options.get("pitch", "1.25").partition(",")
    return float(across), float(along or across)


def _vary(places: list[Place], options: dict[str, str]) -> list[Place]:
    """Reverse, swap and drop blocks, then turn the piece."""
    names = [p.name for p in places]
    if "rev" in options:
        names.reverse()
    if "swap" in options:
        i, j = (int(v) for v in options["swap"].split(","))
        names[i], names[j] = names[j], names[i]
    for place, name in zip(places, names, strict=True):
        place.name = name
    if "drop" in options:
        places = places[: -int(options["drop"])]
    angle = math.radians(float(options.get("yaw", 0)))
    if angle:
        for p in places:
            p.x, p.y = p.x * math.cos(angle) - p.y * math.sin(angle), p.x * math.sin(angle) + p.y * math.cos(angle)
            p.quat = _times(yaw_quat(angle), p.quat)
    return places


def _change(place: Place, offset: str, axis: str, degrees: str) -> None:
    if offset:
        dx, dy, *dz = (float(v) for v in offset.split(","))
        place.x, place.y, place.z = place.x + dx, place.y + dy, place.z + (dz[0] if dz else 0.0) * EDGE
        return
    half = math.radians(float(degrees)) / 2
    turn = {"x": (1, 0, 0), "y": (0, 1, 0), "": (0, 0, 1)}[axis]
    quat = (math.cos(half), *(math.sin(half) * c for c in turn))
    place.quat = _times(quat, place.quat)  # type: ignore[arg-type]


def _times(a: Quat, b: Quat) -> Quat:
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )
