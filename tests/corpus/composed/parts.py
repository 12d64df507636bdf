"""Figures whose parts have looks of their own, told in the same sentence or in following ones."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import NamedTuple

from tests.corpus.composed import Composed
from tests.corpus.composed.building import shapes
from tests.corpus.composed.building.parted import KINDS, Part, Parted
from tests.corpus.composed.building.plain import WANT
from tests.corpus.composed.ordering.phrased import COLORS, joined, said

RESTS = (
    "the rest", "all others", "everything else", "the others", "the other blocks", "all the other blocks",
    "the remaining blocks", "all the rest",
)  # fmt: skip
ARE = "[are|are|should be|must be|have to be|shall be]"
IS = "[is|is|should be|must be|has to be|shall be]"


class Said(NamedTuple):
    """A part as it is called, its colour, how many blocks it has, and whether it is what the others leave."""

    name: str
    color: str
    count: int
    rest: bool

    @property
    def are(self) -> str:
        """A verb that gives a colour."""
        last = self.name.split(" at ")[0].split(" in ")[0].split(" of ")[0].split()[-1]
        return ARE if last.endswith("s") or last == "four" else IS

    @property
    def bare(self) -> str:
        """Without its article."""
        return self.name.removeprefix("the ").removeprefix("all ").removeprefix("both ")

    @property
    def its(self) -> str:
        """As something that the figure has."""
        return f"its {self.bare}" if self.name.startswith("the ") and not self.rest else self.name


def within(rng: Random, parts: Sequence[Said]) -> str:
    """A frame for looks in the same sentence as the figure {x}."""
    first, last = parts[0], parts[-1]
    equal = joined([f"{p.name} {p.are} {p.color}" for p in parts], "[ and |, and |, ]")
    plain = joined([f"{p.name} {p.color}" for p in parts], "[ and |, ]")
    frames = [
        f"{{want}} {{x}}, {plain}", f"{{want}} {{x}}: {plain}", f"{{want}} {{x}} with {plain}",
        f"{{want}} {{x}} [in which|where|such that|so that] {equal}", f"{{want}} {{x}}; {equal}",
        f"{{want}} {{x}}, {joined([f'{p.name} [being|in] {p.color}' for p in parts])}",
        f"{{want}} {{x}} with {joined([f'{p.color} for {p.name}' for p in parts])}",
        f"{{want}} {{x}}, {joined([f'{p.its} {p.color}' for p in parts], ', ')}",
    ]  # fmt: skip
    if first.name.startswith("the ") and not first.rest and first.bare.split()[0] not in ("one", "block"):
        whose = joined([f"{first.bare} {first.are} {first.color}", *(f"{p.its} {p.are} {p.color}" for p in parts[1:])])
        frames.append(f"{{want}} {{x}} whose {whose}".replace(" its ", " whose "))
        frames.append(f"{{want}} {{x}}, {equal.replace(first.name, first.name + ' of which', 1)}")
    if len(parts) == 2 and last.rest:
        which = "which are" if first.are == ARE else "which is"
        one = (
            f"[which I want {first.color}|that should be {first.color}]"
            if first.are == IS
            else f"{which} {first.color}"
        )
        but = f"[except|except for|apart from] {first.name}, {which} {first.color}"
        frames += [
            f"{{want}} {{x}}, all {last.color} {but}",
            f"{{want}} {{x}} in {last.color} with {first.name} [in|being|] {first.color}",
            f"{{want}} {{x}}: [every block|everything] is {last.color} {but}",
            f"{{want}} {{x}}. Only {first.name} {first.are} {first.color}, {last.name} {last.are} {last.color}",
            f"{{want}} {{x}}, {last.color} except for {first.name}, {one}",
        ]
    return rng.choice(frames)


def capital(text: str) -> str:
    """As a sentence begins."""
    return text[0].upper() + text[1:]


def after(rng: Random, parts: Sequence[Said], short: str) -> str:
    """A frame for looks in sentences that follow."""
    made = "[consists of|is made of|is made up of|should be made of|is built from]"
    of_it = [p.name if p.rest or " of " in p.name else f"{p.name} of the {short}" for p in parts]
    frames = [
        [joined([f"{p.name} {p.are} {p.color}" for p in parts], "[ and |, |, and |; ]")],
        [f"{p.name} {p.are} {p.color}" for p in parts],
        [joined([f"{p.name} {p.color}" for p in parts], ", ")],
        [f"[Make|I want] {joined([f'{p.name} {p.color}' for p in parts])}"],
        [f"Use {joined([f'{p.color} for {p.name}' for p in parts])}"],
        [f"{p.its} {p.are} {p.color}" for p in parts],
        [f"{name} {p.are} {p.color}" for name, p in zip(of_it, parts, strict=True)],
        [f"[I want|I would like|We want] {joined([f'{p.name} in {p.color}' for p in parts])}"],
    ]
    if all(p.count > 1 and p.are == IS for p in parts):
        frames.append([f"{p.name} {made} {p.color} blocks" for p in parts])
    return ". ".join(["{want} {x}", *map(capital, rng.choice(frames))])


def called(rng: Random, one: Parted, part: Part, color: str, last: bool) -> Said:
    """A part with one of its names."""
    rest = not part.names or (last and one.rest and rng.random() < 0.3)
    rests = RESTS if len(part.cells) > 1 else RESTS[:1]
    name = rng.choice(rests if rest else part.names.split("|"))
    return Said(name, color, len(part.cells), rest or name in RESTS)


def composed(rng: Random) -> Composed:
    """One of them."""
    one = rng.choice(KINDS)(rng)
    colors = rng.sample(COLORS, len(one.parts))
    told = zip(one.parts, colors, strict=True)
    parts = [called(rng, one, part, color, part is one.parts[-1]) for part, color in told]
    if not any(p.rest or "between" in p.name for p in parts) and rng.random() < 0.3:
        parts.reverse()
    frame = within(rng, parts) if rng.random() < 0.55 else after(rng, parts, one.short)
    meaning = shapes.of_parts(one.figure, {color: part.cells for part, color in zip(one.parts, colors, strict=True)})
    name = frame
    for p in sorted(parts, key=lambda p: -len(p.name)):
        name = name.replace(p.name, "PART").replace(p.bare, "PART").replace(p.color, "COLOR")
    return Composed(f"{one.short}: {name}", said(rng, frame, {"want": WANT, "x": one.said}), meaning)
