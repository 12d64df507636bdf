"""Which towers, rows and figures a phrase of an edit speaks of: "the tower", "both rows", "the second tower"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rpg.blocks.nouns import join
from rpg.core.diagnostics import Refusal
from rpg.ir.node import members
from rpg.ir.relations import Behind, InFrontOf, LeftOf, RightOf
from rpg.ir.structures import Figure
from rpg.steer.absent import diagnostic
from rpg.steer.matching import matches
from rpg.steer.requests.language import m
from rpg.steer.view import NOUNS, Line, Shape, View

LINE_NOUNS = {"stack": "tower", "row": "row", "column": "column"}


@dataclass(frozen=True)
class Found:
    """The objects of a phrase; the line or figure it named, if it named one."""

    names: tuple[str, ...]
    line: Line | None = None
    figure: Shape | None = None

    @property
    def whole(self) -> bool:
        """Whether the phrase meant a structure rather than single blocks."""
        return self.line is not None or self.figure is not None


def structure(view: View, phrase: m.Structure, named: Sequence[str]) -> Found:
    """The phrase "the tower", "the row", "the pyramid": the last one of its kind that was mentioned."""
    found = structures_of(view, phrase, named)
    if several_of(phrase):
        return Found(tuple(name for each in found for name in each.names), None, found[-1].figure)
    if phrase.traits.rank:
        return _at_rank(view, phrase, found)
    found = _described(view, phrase, found) or found
    recent = [each for each in found if set(each.names) & set(view.focus)]
    chosen = (recent or found)[-1]
    _check_described(view, phrase, chosen)
    return chosen


def several_of(phrase: m.Structure) -> bool:
    return phrase.plural or phrase.det in ("each", "both", "all")


def structures_of(view: View, phrase: m.Structure, named: Sequence[str]) -> list[Found]:
    """All structures of the kind that a phrase says. `named`: the blocks that it says they are of."""
    wanted = LINE_NOUNS.get(phrase.kind)
    lines = [line for line in view.lines if wanted == line.kind or (phrase.kind == "row" and line.kind == "column")]
    figures = [figure for figure in view.figures if _is_kind(phrase.kind, figure)]
    if phrase.kind == "pile" and not figures:
        lines = [line for line in view.lines if line.kind == "tower"]
    words = [line for line in view.lines if line.node is not None and line.node.kind == _WORDS.get(phrase.kind)]
    found = [Found(line.members, line) for line in (words or lines)] + [Found(f.members, None, f) for f in figures]
    if named and len(found) > 1:
        found = [each for each in found if set(named) <= set(each.names)] or found
    if not found:
        kinds = sorted({noun_of(view, line) for line in view.lines} | {NOUNS[type(f.node)] for f in view.figures})
        hint = f"the task builds {join(['a ' + kind for kind in kinds])}" if kinds else "name the blocks instead"
        raise Refusal([diagnostic("no-such-object", phrase.span, f"the task has no {phrase.kind} like this", hint)])
    return found


def _at_rank(view: View, phrase: m.Structure, found: Sequence[Found]) -> Found:
    """The phrase "the second tower", in the order in which the goal has them; "the left tower", where it says so."""
    rank = phrase.traits.rank or ""
    lines = [each for each in found if each.line is not None]
    if len(lines) == len(found) > 1 and (rank.isdigit() or rank == "last"):
        at = int(rank) - 1 if rank.isdigit() else len(found) - 1
        if at < len(found):
            return found[at]
    left = [
        (set(members(a.a)), set(members(a.b)))
        for _, a in view.atoms
        if isinstance(a, LeftOf | RightOf | InFrontOf | Behind) and _toward(rank, a.kind) == 1
    ]
    left += [
        (set(members(a.b)), set(members(a.a)))
        for _, a in view.atoms
        if isinstance(a, LeftOf | RightOf | InFrontOf | Behind) and _toward(rank, a.kind) == -1
    ]
    chosen = [
        each
        for each in found
        if any(near & set(each.names) and not far & set(each.names) for near, far in left)
        and not any(far & set(each.names) and not near & set(each.names) for near, far in left)
    ]
    if len(chosen) != 1 or len(found) != 2:
        told = "the goal does not say which of them this is"
        raise Refusal([diagnostic("ambiguous-object", phrase.span, told, "name it by one of its blocks")])
    return chosen[0]


_SIDES = {"left": ("left_of", "right_of"), "right": ("right_of", "left_of"), "front": ("in_front_of", "behind")}
_SIDES |= {"back": ("behind", "in_front_of")}


def _toward(rank: str, kind: str) -> int:
    """Whether the first of two things that are related so is on that side, or the second, or neither."""
    nearer, farther = _SIDES.get(rank, ("", ""))
    return 1 if kind == nearer else -1 if kind == farther else 0


def _described(view: View, phrase: m.Structure, found: Sequence[Found]) -> list[Found]:
    """Of several structures those whose blocks are all as the phrase says; else the only one with most of them so."""
    told = [phrase.traits, phrase.members.traits if isinstance(phrase.members, m.Noun) else m.Traits()]
    share = []
    for each in found:
        blocks = [name for name in each.names if name in view.world.blocks]
        fitting = sum(all(matches(view, name, traits) for traits in told) for name in blocks)
        share.append(fitting / max(1, len(blocks)))
    every = [each for each, part in zip(found, share, strict=True) if part == 1.0]
    most = [each for each, part in zip(found, share, strict=True) if part > 0.5]
    return every or (most if len(most) == 1 and sum(part > 0.0 for part in share) == 1 else [])


def _check_described(view: View, phrase: m.Structure, found: Found) -> None:
    """Refuse a structure of another size, or of other blocks, than the phrase says."""
    members = phrase.members if isinstance(phrase.members, m.Noun) else None
    size = phrase.size or (members.amount if members is not None else None)
    if size is not None and phrase.kind in ("stack", "row", "column", "circle") and size.low != len(found.names):
        told = f"it has {len(found.names)} blocks, not {size.low}"
        raise Refusal([diagnostic("no-such-object", phrase.span, told, "say how many it has, or leave that out")])
    one = members is not None and members.det == "the" and not members.plural
    for traits in (phrase.traits, members.traits if members is not None and not one else m.Traits()):
        fits = [matches(view, name, traits) for name in found.names if name in view.world.blocks]
        if sum(fits) * 2 > len(fits) and traits.colors and not traits.labels:
            continue
        if not all(matches(view, name, traits) for name in found.names if name in view.world.blocks):
            told = "its blocks are not all like this"
            raise Refusal([diagnostic("no-such-object", phrase.span, told, "leave out what its blocks look like")])


_WORDS = {"word": "spells", "equation": "equation"}
_FIGURES = {
    "grid": ("grid",), "wall": ("grid",), "square": ("grid", "figure"), "pyramid": ("pyramid",),
    "staircase": ("staircase",), "pile": ("group_by", "towers"), "stack": ("towers",), "cube": ("grid",),
    "checkerboard": ("grid",), "rectangle": ("grid", "figure"),
    "circle": ("figure",), "triangle": ("figure",), "plus": ("figure",),
    "set": ("group_by",),
}  # fmt: skip


def _is_kind(kind: str, figure: Shape) -> bool:
    if figure.node.kind not in _FIGURES.get(kind, ("figure",) if kind in ("letter", "shape", "figure") else ()):
        return False
    return not isinstance(figure.node, Figure) or kind in ("letter", "shape", "figure", figure.node.shape)


def noun_of(view: View, line: Line) -> str:
    """What a line is called: a tower, a row, a word."""
    return NOUNS.get(type(line.node), line.kind) if line.node is not None else line.kind
