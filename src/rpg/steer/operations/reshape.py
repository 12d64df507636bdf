"""The same blocks in another structure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.edits import ChangeCondition, SetGoal
from rpg.ir.order import Order, Pattern
from rpg.ir.relations import OnPatch
from rpg.ir.structures import Equation, Figure, Grid, Pyramid, Row, Spells, Stack, Staircase, Towers
from rpg.ir.walk import conjuncts
from rpg.steer.draft import Draft
from rpg.steer.operations.count import recount
from rpg.steer.operations.guard import check_shape
from rpg.steer.operations.kinds import listed
from rpg.steer.operations.words import ALONG, plain, respell, run_along
from rpg.steer.proof.shape import lasts
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.view import Line, View

FIGURES = ("circle", "square", "rectangle", "triangle", "plus", "L", "T", "V", "U", "X")
LEAST = {"circle": 5, "square": 4, "rectangle": 6, "triangle": 3, "plus": 5, "L": 3, "T": 4, "V": 3, "U": 5, "X": 5}


def reshape(draft: Draft, request: r.Reshape) -> None:
    """Phrases such as "turn the tower into a row", "make it a circle instead", "change the word to DOG"."""
    wanted = request.structure
    assert isinstance(wanted, m.Structure)
    if wanted.kind == "line":
        draft.assume("a line is a row from left to right")
        wanted = replace(wanted, kind="row")
    wanted = _measured(draft, _sided(wanted))
    if isinstance(request.theme, m.Structure) and request.theme.det == "each":
        told, hint = "each of several is changed one by one", "say it of one: turn the red tower into a row"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    found = resolve(draft.view, request.theme) if request.theme is not None else None
    names = _together(draft.view, found.names) if found else draft.view.busy
    line = draft.view.line_of(names)
    draft.note("structure", {"to": wanted.kind, "dims": list(wanted.dims)})
    if wanted.kind == "word" and wanted.letter:
        respell(draft, line, names, wanted.letter, request.span)
        return
    if line is not None and isinstance(line.node, Spells | Equation) and wanted.kind in ALONG and plain(wanted):
        run_along(draft, line, ALONG[wanted.kind], request.span)
        return
    if wanted.plural and wanted.kind == "stack":
        draft.aim("PIVOT")
        _part(draft, line, _towers(draft, wanted, listed(draft, names), request.span), names, request.span)
        return
    if _same_kind(draft.view, names, wanted):
        check_shape(wanted, sizes_used=True)
        recount(
            draft,
            r.Recount(
                theme=request.theme,
                dims=wanted.dims,
                amount=wanted.size.low if wanted.size else None,
                what="length" if wanted.sizes and wanted.sizes[0].what in _ACROSS else "height",
                span=request.span,
            ),
        )
        return
    blocks = [name for name in listed(draft, names) if name in draft.view.world.blocks]
    check_shape(wanted, sizes_used=True)
    _check_members(draft, wanted, blocks)
    if len(blocks) < 2:
        told = f"one block is no {wanted.kind}"
        raise draft.refusal("breaks-structure", told, request.span, "say of which blocks it should be")
    draft.aim("PIVOT")
    goal = _patterned(draft, structure(draft, wanted, blocks, line, request.span), blocks)
    _part(draft, line, goal, blocks, request.span)


def _together(view: View, names: tuple[str, ...]) -> tuple[str, ...]:
    """One block forms nothing: "make it a tower" is about what it is a part of."""
    if len(names) != 1:
        return names
    line, figure = view.line_of(names), next((f for f in view.figures if names[0] in f.members), None)
    return line.members if line is not None else figure.members if figure is not None else names


def _part(draft: Draft, line: Line | None, goal: g.Goal, names: Sequence[str], span: Span) -> None:
    """The new structure takes the place of the line, or of the whole goal where it has no other blocks; what is asked
    of the blocks besides what they form stays."""
    if set(names) >= set(draft.view.busy) or line is None or line.node is None:
        kept = [part for part in conjuncts(draft.schema.goal) if lasts(part)]
        patch = getattr(line.node, "patch", None) if line is not None else None
        kept += [OnPatch(a=tuple(names), patch=patch)] if patch else []
        draft.do(SetGoal(goal=g.All(goals=(goal, *kept)) if kept else goal), span)
    else:
        draft.do(ChangeCondition(at=line.path, to=goal), span)


def _sided(wanted: m.Structure) -> m.Structure:
    """Phrases such as "two rows and three columns": a grid told by both of its sides."""
    sides = {"row": "columns", "column": "rows"}
    across = next((s.amount.low for s in wanted.sizes if s.amount and s.what == sides.get(wanted.kind)), 0)
    if not across or len(wanted.sizes) > 1 or wanted.amount is None:
        return wanted
    along = wanted.amount.low
    dims = (along, across) if wanted.kind == "row" else (across, along)
    return replace(wanted, kind="grid", det="a", plural=False, amount=None, sizes=(), dims=dims)


_ACROSS = ("wide", "long", "columns")
_WAYS = {"wall": (_ACROSS, ("high", "layers", "rows")), "grid": (("rows", "deep"), _ACROSS)}
"""The words for the two sides of a figure, in the order of its dimensions."""


def _measured(draft: Draft, wanted: m.Structure) -> m.Structure:
    """Phrases such as "a wall of 3 rows and 5 columns": a figure with the dimensions that are said behind it."""
    ways = _WAYS.get(wanted.kind)
    if ways is None or not wanted.sizes or wanted.dims:
        return wanted
    told = next((size for size in wanted.sizes if size.what == "dims"), None)
    if told is not None:
        dims = told.dims[::-1] if told.named and wanted.kind == "wall" else told.dims
    else:
        dims = tuple(side for way in ways if (side := wanted.extent(*way)))
    if len(dims) == 2 and len(wanted.sizes) == (2 if told is None else 1):
        return replace(wanted, dims=dims, sizes=())
    if len(wanted.sizes) > 1 or (wanted.kind == "grid" and wanted.sizes[0].what in ways[0]):
        raise draft.refusal("edit-unclear", "it is not clear how large this is to be", wanted.span,
                            "say both of its sides, as in 'a grid of 2 rows and 3 columns'")  # fmt: skip
    return wanted


def _towers(draft: Draft, wanted: m.Structure, names: Sequence[str], span: Span) -> Towers:
    """Phrases such as "two towers of two": so many towers of the blocks that are there."""
    check_shape(replace(wanted, plural=False, amount=None, each_size=False), sizes_used=True)
    members = wanted.members
    said = m.Noun(span=wanted.span, head="any", det="bare") if members is None else members
    if not isinstance(said, m.Noun) or said.traits != m.Traits() or said.conditions:
        raise draft.refusal("edit-unclear", "these are not the blocks of the task", wanted.span, _WHOLE)
    each = wanted.size.low if wanted.size else said.amount.low if said.amount else 0
    if any(isinstance(figure.node, Towers) for figure in draft.view.figures):
        told = "this may be fewer of the towers that there are, or other towers of the same blocks"
        raise draft.refusal("edit-unclear", told, wanted.span, _WHOLE)
    count = wanted.amount.low if wanted.amount else len(names) // each if each else 0
    if count < 2 or (each and count * each != len(names)) or 2 * count > len(names):
        told = f"{len(names)} blocks do not form these towers"
        raise draft.refusal("breaks-structure", told, span, "change the number of blocks first")
    return Towers(blocks=tuple(names), count=count, heights=(each,) * count if each else None)


def _check_members(draft: Draft, wanted: m.Structure, blocks: Sequence[str]) -> None:
    """What the request says of the blocks of the new structure must be so: their number, or which they are."""
    said = wanted.size.low if wanted.size else None
    if isinstance(wanted.members, m.Noun):
        if wanted.members.traits == m.Traits() and not wanted.members.conditions:
            said = wanted.members.amount.low if wanted.members.amount else said
        elif set(resolve(draft.view, wanted.members).names) != set(blocks):
            raise draft.refusal("edit-unclear", "these are not the blocks of the task", wanted.span, _WHOLE)
    elif wanted.members is not None:
        raise draft.refusal("edit-unclear", "these are not the blocks of the task", wanted.span, _WHOLE)
    fits = {len(blocks)}
    if wanted.kind == "staircase":
        fits = {n for n in range(2, 8) if n * (n + 1) // 2 == len(blocks)}
    if wanted.kind == "pyramid":
        fits |= {n for n in range(2, 8) if len(blocks) in (n * (n + 1) // 2, n * (n + 1) * (2 * n + 1) // 6)}
    if said is not None and said not in fits:
        told = f"there are {len(blocks)} blocks, which do not form a {wanted.kind} of {said}"
        raise draft.refusal("breaks-structure", told, wanted.span, "change the number of blocks first")
    if (wanted.filled and wanted.kind in ("circle", "triangle", "plus")) or (wanted.upright and wanted.kind in FIGURES):
        raise draft.refusal("edit-unclear", f"the blocks cannot form a {wanted.kind} like this", wanted.span, _WHOLE)


_WHOLE = "give the whole instruction"


def _same_kind(view: View, names: Sequence[str], wanted: m.Structure) -> bool:
    figure = next((f for f in view.figures if set(names) <= set(f.members)), None)
    if figure is not None:
        kinds = {"grid": ("grid", "square", "cube", "wall"), "pyramid": ("pyramid",), "staircase": ("staircase",)}
        flat = isinstance(figure.node, Grid) and figure.node.layers == 1
        same = wanted.kind in kinds.get(figure.node.kind, ()) and not (flat and wanted.kind == "wall")
        return same and bool(wanted.dims or wanted.size)
    line = view.line_of(names)
    return (
        line is not None
        and wanted.kind == {"tower": "stack", "row": "row", "column": "column"}[line.kind]
        and wanted.size is not None
    )


def structure(draft: Draft, wanted: m.Structure, names: Sequence[str], line: Line | None, span: Span) -> g.Goal:
    """The structure that `names` are to form; a line hands its order on to another line."""
    blocks = tuple(names)
    ordered = line is not None and line.ordered and len({draft.view.world.look[n] for n in names}) > 1
    ranks = tuple((name,) for name in names)
    match wanted.kind:
        case "stack":
            return Stack(blocks=blocks, order=Order(by="given", ranks=ranks) if ordered else Order(), exact=not ordered)
        case "row" | "column":
            begin = "left" if wanted.kind == "row" else "front"
            order = Order.model_validate({"by": "given", "ranks": ranks, "first": begin}) if ordered else Order()
            return Row(blocks=blocks, axis="y" if wanted.kind == "row" else "x", order=order)
        case "pyramid":
            return Pyramid(blocks=blocks, base=_base(draft, len(blocks), wanted, span))
        case "staircase":
            steps = next((n for n in range(2, 8) if n * (n + 1) // 2 == len(blocks)), 0)
            if not steps:
                raise _unfit(draft, "staircase", len(blocks), "3, 6 or 10", span)
            return Staircase(blocks=blocks, steps=steps)
        case "grid" | "wall" | "cube":
            return _grid(draft, wanted, blocks, span)
        case kind if kind in FIGURES:
            if wanted.dims and len(wanted.dims) == 2 and kind in ("square", "rectangle"):
                return _grid(draft, wanted, blocks, span)
            if len(blocks) < LEAST[kind]:
                raise _unfit(draft, kind, len(blocks), f"at least {LEAST[kind]}", span)
            return Figure.model_validate({"blocks": blocks, "shape": kind})
    raise draft.refusal(
        "edit-unclear",
        f"these blocks cannot be turned into a {wanted.kind}",
        span,
        "say it as an instruction of its own",
    )


_PATTERNS = ("alternating", "mirrored", "together")
"""Orders that say how neighbours go together, and no more: any line may have them, and a ring may alternate."""


def _patterned(draft: Draft, new: g.Goal, names: Sequence[str]) -> g.Goal:
    """A structure with the pattern of the one that it comes instead of; where it cannot have it, that is told."""
    old = next((each.node for each in draft.view.lines if set(each.members) == set(names)), None)
    old = old or next((each.node for each in draft.view.figures if set(each.members) == set(names)), None)
    pattern = getattr(old, "pattern", None)
    order: Order | None = pattern.order if pattern and pattern.kind == "reading" else getattr(old, "order", None)
    if order is not None and order.by in _PATTERNS:
        order = Order(by=order.by, attribute=order.attribute)
        if isinstance(new, Stack | Row):
            return new.model_copy(update={"order": order, **({"exact": False} if isinstance(new, Stack) else {})})
        if isinstance(new, Figure) and new.shape == "circle" and order.by == "alternating":
            return new.model_copy(update={"pattern": Pattern(kind="reading", order=order)})
    ordered = pattern is not None or (order is not None and order.by != "any")
    if ordered and getattr(new, "pattern", None) is None and getattr(new, "order", Order()).by == "any":
        draft.assume("the new structure asks for no order of its blocks")
    return new


def _base(draft: Draft, count: int, wanted: m.Structure, span: Span) -> tuple[int, int]:
    if len(wanted.dims) == 2:
        flat = next((n for n in range(2, 8) if n * (n + 1) // 2 == count), 0)
        n, depth = wanted.dims
        if sum((n - k) * (depth - k) for k in range(min(n, depth))) == count:
            return n, depth
        if depth == 1 and flat == n:
            return n, 1
        raise _unfit(draft, "pyramid", count, str(sum((n - k) * (depth - k) for k in range(min(n, depth)))), span)
    for n in range(2, 8):
        if n * (n + 1) // 2 == count:
            return n, 1
        if n * (n + 1) * (2 * n + 1) // 6 == count:
            return n, n
    raise _unfit(draft, "pyramid", count, "3, 5, 6, 10 or 14", span)


def _grid(draft: Draft, wanted: m.Structure, blocks: tuple[str, ...], span: Span) -> g.Goal:
    dims = wanted.dims
    if wanted.kind == "wall":
        columns, layers = dims if len(dims) == 2 else (len(blocks) // 2, 2)
        sizes = (1, columns, layers)
    elif len(dims) == 3:
        sizes = (dims[0], dims[1], dims[2])
    else:
        side = round(len(blocks) ** 0.5)
        rows, columns = dims if len(dims) == 2 else (side, side)
        sizes = (rows, columns, 1)
    needed = sizes[0] * sizes[1] * sizes[2]
    if needed != len(blocks):
        raise _unfit(draft, wanted.kind, len(blocks), str(needed), span)
    return Grid(blocks=blocks, rows=sizes[0], columns=sizes[1], layers=sizes[2])


def _unfit(draft: Draft, kind: str, count: int, needed: str, span: Span) -> Exception:
    return draft.refusal(
        "breaks-structure",
        f"a {kind} takes {needed} blocks, and there are {count}",
        span,
        "change the number of blocks first",
    )
