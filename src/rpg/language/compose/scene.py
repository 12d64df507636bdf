"""What a text has told of so far: blocks, figures, patches, and what is to hold of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from rpg.language.compose.syntax import Phrase
from rpg.language.frames.pieces import Unclear

__all__ = [
    "OPPOSITE", "SIDES", "TOWARD", "Block", "Fact", "Figure", "Impossible", "Patch", "Ref", "Resolve",
    "Scene", "Taken", "Unclear",
]  # fmt: skip


SIDES = {"left": "to the left of", "right": "to the right of", "front": "in front of", "behind": "behind"}
"""How facts tell on which side something is."""
TOWARD = {"left": SIDES["left"], "right": SIDES["right"], "near": SIDES["front"], "far": SIDES["behind"]}
OPPOSITE = {"left": "right", "right": "left", "near": "far", "far": "near"}


class Impossible(Unclear):
    """This way to have what is said cannot be; others may."""


@dataclass(slots=True)
class Block:
    """A block. No colour and no label: nothing is said of how it looks; those of one `lot` look alike then. `size`:
    "big" or "small", if it is told."""

    color: str = ""
    label: str = ""
    lot: int = 0
    size: str = ""

    @property
    def look(self) -> tuple[str, str, int, str]:
        return (self.color, self.label, 0 if self.color or self.label else self.lot, self.size)


@dataclass(slots=True)
class Patch:
    """A patch; no colour, no shape: nothing is said of it."""

    color: str = ""
    shape: str = ""


@dataclass(slots=True)
class Figure:
    """Blocks that form something, in the order of its places.

    `placed`: which block is at a place, as far as this was said; `told`: places matter, so that the order is told;
    `sided`: the places of a row are counted from the left; `free`: its blocks may be in any order, but for those
    that are `placed`, and for what is `barred` from places. `implied`: it is told by what lies on what.
    `stage`: when it is formed, -1 at the start; `way`: where it rises or points; `alternates`: its blocks are of two
    colours in turn, as they are listed or the other way round; `in_order`: they are sorted by their symbols; `counted`:
    of how many of a colour it is was said; `gaps`: how far apart those of a line are; `there`: the text said that
    there is such a figure. Places of a tower are counted
    from the bottom, those of a row from the left, of a letter and a staircase as they are drawn, of anything else row
    by row from the far left, or from the top left of what stands upright.
    """

    kind: str
    blocks: list[int]
    size: tuple[int, ...] = ()
    word: str = ""
    placed: dict[int, int] = field(default_factory=dict)
    barred: dict[int, set[int]] = field(default_factory=dict)
    told: bool = False
    free: bool = False
    sided: bool = False
    implied: bool = False
    stage: int = 0
    way: str = ""
    alternates: bool = False
    in_order: bool = False
    counted: bool = False
    gaps: str = ""
    there: bool = False


@dataclass(slots=True)
class Ref:
    """What a phrase stands for: `kind` "block", "figure", "patch" or "table", with the numbers of those in the scene;
    "mixed" are single blocks and the lowest ones of towers.

    `each`: what is said is said of each by itself. `bound`: "exactly" or "most" of `ids` and `rest`. `fresh`: they are
    told of for the first time, as some or other ones. `no`: it is said of none of them. `every`: it is said of
    "all" of them. `either`: they are one of several ways to have it.
    """

    kind: str
    ids: list[int]
    rest: list[int] = field(default_factory=list)
    each: bool = False
    bound: str = ""
    fresh: bool = False
    no: bool = False
    every: bool = False
    either: bool = False


class Taken(NamedTuple):
    """Blocks that are taken from a figure, and what is left; `rest`: "one" where this forms a figure again, "stay"."""

    figure: Figure
    ids: list[int]
    kept: list[int]
    stage: int
    rest: str = ""


@dataclass(frozen=True, slots=True)
class Fact:
    """A sentence of the goal: `a`, a verb phrase, and what it relates to. Operands are lists of blocks, or figures.

    `stage`: which of several in turn it is of, from 0 on; -1 at the start. `tacit`: it follows from what is said of
    others, of "one of them" that it is on the patch.
    """

    a: Ref
    said: str
    b: Ref | None = None
    c: Ref | None = None
    no: bool = False
    stage: int = 0
    tacit: bool = False


@dataclass
class Scene:
    """All that is told of, and what was spoken of last.

    `stock`: lots that the text says there are; `whole` is the lot of which some were told apart last, `taken` those.
    `subject` is what something is being said of, `place` the one of a figure that was told last, `around`
    what the clause ahead puts something at: in which relation, and whether it was told as "it"; `placed` are
    figures that are put somewhere, so that it is no part of them that they are put at.
    `pending`: blocks that lie somewhere on others, and it has still to be said on which of them. `lines`: towers that
    stand in a row; `asked`: something is to be put somewhere; `looked`: it was told how places of
    figures look, so that the others have to be told, too; `facing`: figures told by their sides, as "the left
    tower" and "the right one". `instead`: what
    "or" tells besides what was taken; `spare`: of these some were singled out, so that nothing need be said of the
    others. `wanted`: something is to be done; `said`: how many clauses there were, of which `begun` tell how it starts;
    `changed`: what is taken from figures that are there, `kept` what is left of the last one, `moved` what is moved.
    `script`: which of several ways to have it are taken, one after the other; `choices`: of how many each was one.
    `clear`: relations to things in which no block is, but for those that were told to be where "else" is said.
    """

    blocks: list[Block] = field(default_factory=list)
    figures: list[Figure] = field(default_factory=list)
    patches: list[Patch] = field(default_factory=list)
    facts: list[Fact] = field(default_factory=list)
    stock: list[list[int]] = field(default_factory=list)
    used: set[int] = field(default_factory=set)
    whole: list[int] = field(default_factory=list)
    taken: list[int] = field(default_factory=list)
    before: list[Ref] = field(default_factory=list)
    here: list[Ref] = field(default_factory=list)
    earlier: list[list[Ref]] = field(default_factory=list)
    lots: int = 0
    stage: int = 0
    at_start: bool = False
    asked: bool = False
    looked: bool = False
    subject: tuple[str, list[int]] | None = None
    place: tuple[Figure, int] | None = None
    placed: list[int] = field(default_factory=list)
    around: tuple[str, Ref, bool] | None = None
    pending: list[tuple[list[int], list[int]]] = field(default_factory=list)
    lines: list[list[int]] = field(default_factory=list)
    facing: dict[str, int] = field(default_factory=dict)
    instead: list[Ref] = field(default_factory=list)
    spare: set[int] = field(default_factory=set)
    wanted: bool = False
    said: int = 0
    begun: int = 0
    changed: list[Taken] = field(default_factory=list)
    kept: list[int] = field(default_factory=list)
    moved: list[int] = field(default_factory=list)
    script: tuple[int, ...] = ()
    choices: list[int] = field(default_factory=list)
    clear: list[tuple[str, Ref, bool, int]] = field(default_factory=list)

    def choose(self, ways: int) -> int:
        """Which of so many ways to have it is taken here: the first one, but for what is scripted."""
        self.choices.append(ways)
        return self.script[len(self.choices) - 1] if len(self.choices) <= len(self.script) else 0

    def new_blocks(self, count: int, color: str = "", label: str = "", size: str = "") -> list[int]:
        """So many further blocks that look alike."""
        self.lots += 1
        first = len(self.blocks)
        self.blocks += [Block(color, label, self.lots, size) for _ in range(count)]
        return list(range(first, first + count))

    def alike(self, ids: list[int]) -> bool:
        return len({self.blocks[n].look for n in ids}) == 1

    def mention(self, ref: Ref) -> Ref:
        """Remembers what is spoken of in this clause."""
        self.here.append(ref)
        return ref

    def refs(self, kind: str) -> Iterator[Ref]:
        """All things of a kind that facts are of."""
        return (r for fact in self.facts for r in (fact.a, fact.b, fact.c) if r is not None and r.kind == kind)

    def told_of(self, kind: str) -> set[int]:
        """The numbers of them."""
        return {n for ref in self.refs(kind) for n in ref.ids}

    def begin(self) -> None:
        """All that was told so far is so at the start, unless something was asked for already."""
        if self.wanted:
            return
        self.begun = self.said
        for figure in self.figures:
            figure.stage = -1
        self.facts = [replace(fact, stage=-1) for fact in self.facts]

    def next_clause(self) -> None:
        if self.here:
            self.earlier.append(self.before)
            self.before, self.here = self.here, []

    def figure_of(self, block: int) -> Figure | None:
        """The figure that a block is a part of, the one told last where it is taken from another."""
        return next((f for f in reversed(self.figures) if block in f.blocks), None)

    def may_change(self, figure: Figure) -> bool:
        """Whether a figure is there at the start and need not stay."""
        stays = [fact.a.ids for fact in self.facts if fact.said == "stay"]
        return figure.stage < 0 and not any(set(figure.blocks) <= set(ids) for ids in stays)

    def at(self, figure: Figure, place: int) -> int:
        """The block at a place; where any order will do, each of those that may be there."""
        if not figure.free:
            self.settle(figure)
            return figure.blocks[place]
        if place not in figure.placed:
            rest = [n for n in figure.blocks if n not in figure.placed.values()]
            looks = {self.blocks[n].look: n for n in reversed(rest) if place not in figure.barred.get(n, ())}
            if not looks:
                raise Impossible
            figure.placed[place] = list(looks.values())[self.choose(len(looks))]
        return figure.placed[place]

    def place_barred(self) -> None:
        """Puts what must not be at some places of a figure at each of the others."""
        for figure in self.figures:
            for n, never in list(figure.barred.items()):
                there = [at for at, block in figure.placed.items() if block == n]
                alike = [at for at, block in figure.placed.items() if self.blocks[block].look == self.blocks[n].look]
                able = [at for at in range(max(alike, default=-1) + 1, len(figure.blocks)) if at not in figure.placed]
                able = [at for at in there or able if at not in never]
                if not able:
                    raise Impossible
                figure.placed[able[0] if there else able[self.choose(len(able))]] = n

    def settle(self, figure: Figure) -> None:
        """Puts the blocks in the order of their places, where what was said leaves no other."""
        if figure.free:
            raise Unclear
        if figure.alternates and not figure.told:
            self._take_turns(figure)
        rest = [n for n in figure.blocks if n not in figure.placed.values()]
        if len(rest) > 1 and not self.alike(rest) and not figure.told:
            raise Unclear
        if not figure.told or figure.placed:
            order: list[int | None] = [figure.placed.get(at) for at in range(len(figure.blocks))]
            left = iter(rest)
            figure.blocks = [next(left) if n is None else n for n in order]
        figure.told = True
        figure.placed = {}

    def _take_turns(self, figure: Figure) -> None:
        """Which of two colours is at an end: said, or the same either way."""
        looks = [self.blocks[n].look for n in figure.blocks]
        ways = [n for n in (1, -1) if all(looks[::n][at] == self.blocks[m].look for at, m in figure.placed.items())]
        if not ways or (len(ways) > 1 and looks != looks[::-1]):
            raise Unclear
        figure.blocks, figure.placed, figure.told = figure.blocks[:: ways[0]], {}, True


Resolve = Callable[[Scene, Phrase], Ref]
"""What a phrase stands for."""
