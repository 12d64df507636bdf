"""More or fewer blocks in a structure, and other dimensions of a figure."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from rpg.blocks.predicates.order import SORTED
from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.assets import Asset, Block, ColoredCube, SemanticCube
from rpg.ir.edits import AddAsset, ChangeCondition, RemoveAsset, SetField
from rpg.ir.order import Pattern
from rpg.ir.schema import COLORS_UNSAID
from rpg.ir.structures import Cells, Equation, Figure, Grid, Pyramid, Row, Spells, Stack, Staircase, Towers
from rpg.ir.walk import children
from rpg.steer.draft import Draft
from rpg.steer.operations.grow import grow, of_each_look
from rpg.steer.operations.lines import insert
from rpg.steer.operations.make import describe, named, unused_colors, unused_labels
from rpg.steer.operations.parties import raised
from rpg.steer.refer import ALL_OF, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.view import Line, Shape
from rpg.steer.wholes import Found, several_of


def recount(draft: Draft, request: r.Recount) -> None:
    """Another number of blocks: lines grow at their ends, figures by their dimensions."""
    if request.what == "each":
        draft.aim("TWEAK")
        of_each_look(draft, request)
        return
    _not_counted(draft, request)
    _not_mixed(draft, request)
    found = resolve(draft.view, request.theme) if request.theme is not None else None
    line = found.line if found and found.whole else draft.view.main_line()
    figure = found.figure if found and found.whole else draft.view.main_figure()
    draft.note("count", {"amount": request.amount, "dims": list(request.dims), "by": request.by})
    draft.aim("TWEAK")
    if figure is None and len(lines := _several(draft, request, found)) > 1:
        for each in lines:
            _line(draft, draft.view.line_of(each.members[:1]) or each, request)
        return
    if isinstance(request.theme, m.Pronoun) and request.theme.word == "each of them" and not _parties(draft):
        told, hint = "there are not several structures here", "say how many blocks there should be, or of each colour"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if request.times is not None and line is None:
        told, hint = ("a figure is made larger by its dimensions", "give its rows and columns, its base or its blocks")
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if figure is not None and (line is None or request.dims or (found is not None and found.figure is not None)):
        _figure(draft, figure, request)
    elif line is not None and not request.dims:
        _line(draft, line, request)
    elif request.what in ("blocks", "number") and not request.dims and request.times is None:
        _loose(draft, found.names if found else draft.view.focus or draft.view.busy, request)
    else:
        raise draft.refusal(
            "edit-unclear", "there is no structure whose size this could be", request.span, "say what is to be built"
        )


def _not_mixed(draft: Draft, request: r.Recount) -> None:
    """Refuse "two high each" where the goal has a tower by itself besides several that it speaks of together."""
    theme = request.theme
    alone = any(line.kind == "tower" and line.node is not None for line in draft.view.lines)
    together = any(isinstance(figure.node, Towers) for figure in draft.view.figures)
    every = isinstance(theme, m.Pronoun) and theme.word in _EVERY - {"them", "they"}
    every = every or (isinstance(theme, m.Structure) and several_of(theme) and not theme.traits.colors)
    if alone and together and every:
        told, hint = "these towers are asked for in two parts", "say it of each: make the green tower two high"
        raise draft.refusal("ambiguous-object", told, request.span, hint)


def _not_counted(draft: Draft, request: r.Recount) -> None:
    """Refuse a mere number where the goal counts: it may be how many of the blocks, and how many there are."""
    if request.what == "number" and request.amount and _counts(draft.schema.goal):
        told, hint = "this may be how many there are, or how many of them", "say 'use three blocks', or 'three of them'"
        raise draft.refusal("edit-unclear", told, request.span, hint)


def _counts(goal: g.Goal) -> bool:
    return isinstance(goal, g.Count) or any(_counts(part) for part in children(goal))


_EVERY = ALL_OF | {"both", "both of them", "each", "each of them", "each one", "every one", "every one of them"}


def _several(draft: Draft, request: r.Recount, found: Found | None) -> list[Line]:
    """The lines of which a request speaks that is about more than one: "both of them", "the towers"."""
    theme = request.theme
    if isinstance(theme, m.Pronoun) and theme.word in _EVERY:
        last = draft.view.main_line()
        return [line for line in draft.view.lines if last is not None and line.kind == last.kind]
    if isinstance(theme, m.Structure) and (theme.plural or theme.det in ("each", "all", "both")) and found is not None:
        return [line for line in draft.view.lines if set(line.members) <= set(found.names)]
    return []


def _parties(draft: Draft) -> bool:
    """Whether the goal builds several towers of one height."""
    nodes = [figure.node for figure in draft.view.figures]
    return any(isinstance(node, Towers) and node.heights is not None for node in nodes)


def _loose(draft: Draft, names: Sequence[str], request: r.Recount) -> None:
    """Another number of look-alikes that form nothing: those on a patch, in a region, in a group."""
    looks = {draft.view.world.look[name] for name in names if name in draft.view.world.blocks}
    alike = [name for name in draft.view.busy if draft.view.world.look[name] in looks]
    wanted = request.amount if request.amount is not None else len(alike) + (request.by or 0)
    if len(looks) != 1 or wanted < 1 or request.fewer_of(len(alike)):
        told, hint = "there is no structure whose size this could be", "say what is to be built, or which blocks"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if wanted == len(alike):
        raise draft.refusal("nothing-to-do", f"there are {wanted} already", request.span)
    grow(draft, alike, wanted, request.span)


def _line(draft: Draft, line: Line, request: r.Recount) -> None:
    if isinstance(line.node, Spells | Equation):
        raise draft.refusal(
            "breaks-structure",
            "the number of blocks follows from what they spell",
            request.span,
            "change the word instead",
        )
    if request.what == "number" and any(Traits(draft.view.world).symbol(name).isdigit() for name in line.members):
        told, hint = "this may be how many blocks or what they show", "say 'five blocks' or 'the number 5'"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if request.what == "number" and line.node is None and line.kind != "tower":
        told, hint = "there is no structure whose size this could be", "say what is to be built, or which blocks"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    shown = all(Traits(draft.view.world).symbol(name) for name in line.members)
    unsaid = draft.schema.assumed(COLORS_UNSAID)  # any of them may go or stay
    vague = (request.what == "number" or request.of_them) and not unsaid
    if vague and not shown and len({draft.view.world.look[name] for name in line.members}) > 1:
        told, hint = "these blocks do not all look alike, so that it is not said which", "say their colours"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    now = len(line.members)
    wanted = request.amount if request.amount is not None else now + (request.by or 0)
    if request.times is not None:
        wanted = round(now * request.times)
        if wanted != now * request.times:
            told = f"{now} blocks cannot be halved"
            raise draft.refusal("edit-unclear", told, request.span, "say how many blocks it should have")
    if wanted < 2:
        raise draft.refusal(
            "breaks-structure", f"a {line.kind} needs at least two blocks", request.span, "ask for two or more"
        )
    if wanted == now:
        raise draft.refusal("nothing-to-do", f"it has {now} blocks already", request.span)
    looks = {draft.view.world.look[name] for name in line.members}
    if _by_turns(draft, line, wanted, request):
        return
    if not line.ordered and 1 < len(looks) < now:
        told, hint = (
            "it is not said which of the blocks are to be more or fewer",
            "say of which colour, or of each colour",
        )
        raise draft.refusal("ambiguous-object", told, request.span, hint)
    for name in reversed(line.members[wanted:]):
        draft.do(RemoveAsset(name=name), request.span)
    if wanted > now:
        for asset in like(draft, line.members, wanted - now):
            draft.do(AddAsset(asset=asset), request.span)
            same = draft.view.line_of(line.members)
            assert same is not None
            join_line(draft, same, asset.name, request.span)
    if (whole := draft.view.line_of(line.members[:wanted])) is not None:
        draft.look_at(whole.members)


def _by_turns(draft: Draft, line: Line, wanted: int, request: r.Recount) -> bool:
    """A line that alternates between looks, of each of which it has as many, gets as many more (or fewer) of each."""
    counts = Counter(draft.view.world.look[name] for name in line.members)
    alternates = isinstance(line.node, Stack | Row) and line.node.order.by == "alternating"
    if not alternates or len(set(counts.values())) != 1 or wanted % len(counts):
        return False
    if set(line.members) != set(draft.view.busy):
        return False
    of_each_look(draft, replace(request, amount=wanted // len(counts), by=None, times=None, what="each"))
    return True


def join_line(draft: Draft, line: Line, name: str, span: Span) -> None:
    """One more block in a line: anywhere where its order is free, where a sorted one has it, else at its end."""
    free = isinstance(line.node, Stack | Row) and line.node.order.by == "any" and not line.ordered
    if free or (isinstance(line.node, Stack | Row) and line.node.order.by in SORTED):
        draft.do(SetField(at=line.path, field="blocks", value=(*line.members, name)), span)
    else:
        insert(draft, line, len(line.members), name, span)


def like(draft: Draft, members: Sequence[str], number: int) -> list[Asset]:
    """`number` more blocks of the sort that `members` are: of their look if they share one, else of looks unused."""
    world = draft.view.world
    model = world.blocks[members[-1]]
    looks = {world.look[name] for name in members}
    symbols = [Traits(world).symbol(name) for name in members]
    if len(looks) == 1:
        blocks: list[Block] = [model] * number
    elif all(symbols):
        labels = unused_labels(draft, number, all(symbol.isdigit() for symbol in symbols))
        blocks = describe(draft, m.Traits(labels=tuple(labels)), number)
    else:
        blocks = describe(draft, m.Traits(colors=tuple(unused_colors(draft, number))), number)
        draft.assume("new blocks have colours that the task did not have yet")
    return named(draft, [block.model_copy(update={"size": model.size, "origin": None}) for block in blocks])


def _figure(draft: Draft, figure: Shape, request: r.Recount) -> None:
    node = figure.node
    if raised(draft, figure, request):
        return
    update = _dimensions(draft, figure, request)
    if update is None:
        raise draft.refusal(
            "edit-unclear",
            f"a {node.kind.replace('_', ' ')} has no such dimension",
            request.span,
            "give its rows and columns, its base or its blocks",
        )
    assert isinstance(node, Cells)
    if node.pattern is not None and node.pattern.kind == "reading" and node.pattern.order.by == "given":
        told, hint = "its parts have colours, which fit this size alone", "say the whole structure with its colours"
        raise draft.refusal("breaks-structure", told, request.span, hint)
    changed = node.model_copy(update=update)
    there = list(figure.members)
    asked = request.amount or len(there) + (request.by or 0)
    needed = cells_of(changed, asked)
    if needed == len(there) and changed == node:
        raise draft.refusal("nothing-to-do", "it has this size already", request.span)
    pair = _pair(draft, figure, changed)
    kept = [name for k, look in enumerate(pair) for name in look[: (needed + 1 - k) // 2]] if pair else there[:needed]
    gone = [name for name in there if name not in kept]
    for name in gone:
        draft.do(SetField(at=figure.path, field="blocks", value=tuple(kept)), request.span)
        draft.do(RemoveAsset(name=name), request.span)
    if pair:
        new = [
            asset for k, look in enumerate(pair) for asset in like(draft, look[:1], (needed + 1 - k) // 2 - len(look))
        ]
        new = [asset.model_copy(update={"name": name}) for asset, name in zip(new, _free(draft, new), strict=True)]
    else:
        new = _filling(draft, figure, changed, needed - len(there))
    for asset in new:
        draft.do(AddAsset(asset=asset), request.span)
    blocks = (*kept, *(asset.name for asset in new))
    draft.do(ChangeCondition(at=figure.path, to=changed.model_copy(update={"blocks": blocks})), request.span)


def _pair(draft: Draft, figure: Shape, changed: Cells) -> list[list[str]]:
    """The blocks of the two looks that alternate in a figure, the more numerous first; none where none alternate."""
    pattern = changed.pattern
    if pattern is None or not (pattern.kind == "checkerboard" or pattern.order.by == "alternating"):
        return []
    found: dict[object, list[str]] = {}
    for name in figure.members:
        found.setdefault(draft.view.world.look[name], []).append(name)
    return sorted(found.values(), key=len, reverse=True) if len(found) == 2 else []


def _free(draft: Draft, assets: Sequence[Asset]) -> list[str]:
    """Names that none of the task's objects has, one for each."""
    blocks = [asset for asset in assets if isinstance(asset, ColoredCube | SemanticCube)]
    return [asset.name for asset in named(draft, blocks)]


def _dimensions(draft: Draft, figure: Shape, request: r.Recount) -> dict[str, object] | None:
    """The fields of a figure that the request changes."""
    node, dims = figure.node, request.dims
    step = request.by or 0
    match node:
        case Grid():
            if len(dims) == 3:
                return {"rows": dims[0], "columns": dims[1], "layers": dims[2]}
            if len(dims) == 2:
                wall = node.rows == 1 and node.layers > 1
                dims = dims[::-1] if wall and request.lines else dims
                return {"columns": dims[0], "layers": dims[1]} if wall else {"rows": dims[0], "columns": dims[1]}
            if request.what == "height" or (step and request.what != "length"):
                return {"layers": request.amount or node.layers + step}
            if step:
                return {"columns": node.columns + step}
            return {"columns": request.amount} if request.what == "length" and request.amount else None
        case Pyramid():
            if len(dims) == 2:
                return {"base": dims}
            size = request.amount or node.base[0] + step
            told = request.what not in ("blocks", "number") or step
            return {"base": (size, size if node.base[1] > 1 else 1)} if told else None
        case Staircase():
            told = not dims and request.what not in ("blocks", "number")
            return {"steps": request.amount or node.steps + step} if told else None
        case Figure():
            if len(dims) == 2 and node.shape in ("square", "rectangle"):
                return {"sides": dims}
            return {"sides": None} if request.amount or step else None
    return None


def cells_of(node: Cells, asked: int | None = None) -> int:
    """How many blocks a figure needs."""
    match node:
        case Grid():
            return node.rows * node.columns * node.layers
        case Pyramid():
            n, depth = node.base
            return sum((n - k) * (depth - k) for k in range(min(n, depth))) if depth > 1 else n * (n + 1) // 2
        case Staircase():
            return node.steps * (node.steps + 1) // 2
        case Figure(sides=(a, b)):
            return a * b if node.filled else 2 * (a + b) - 4
    return asked or len(node.blocks)


def _filling(draft: Draft, figure: Shape, changed: Cells, number: int) -> list[Asset]:
    """The blocks that a larger figure needs; where rows or layers have colours of their own, so have new ones."""
    if number <= 0:
        return []
    pattern = changed.pattern
    if isinstance(pattern, Pattern) and pattern.kind in ("row", "column", "layer") and pattern.attribute == "color":
        return _by_lines(draft, figure, changed, number)
    return like(draft, figure.members, number)


def _by_lines(draft: Draft, figure: Shape, changed: Cells, number: int) -> list[Asset]:
    """New blocks so that every row, column or layer has one colour: old colours are made up to the new length."""
    assert changed.pattern is not None
    lengths = line_lengths(changed)
    colors = [draft.view.world.blocks[name].color for name in figure.members]
    known = sorted(set(colors), key=colors.index)[: len(lengths)]
    missing: list[str] = []
    for color, length in zip(known, lengths, strict=False):
        missing += [color] * max(0, length - colors.count(color))
    more = unused_colors(draft, len(lengths) - len(known))
    for new, length in zip(more, lengths[len(known) :], strict=True):
        missing += [new] * length
    if len(missing) != number:
        raise draft.refusal(
            "breaks-structure",
            "the colours of its lines do not fit this size",
            None,
            "say the whole structure again, with its colours",
        )
    return named(draft, describe(draft, m.Traits(colors=tuple(missing)), number))


def line_lengths(node: Cells) -> list[int]:
    """How many cells each row, column or layer of a patterned figure has."""
    assert node.pattern is not None
    if isinstance(node, Grid):
        sizes = {"row": (node.rows, node.columns * node.layers), "column": (node.columns, node.rows * node.layers)}
        count, each = sizes.get(node.pattern.kind, (node.layers, node.rows * node.columns))
        return [each] * count
    if isinstance(node, Pyramid):
        n, depth = node.base
        return [(n - k) * (depth - k) if depth > 1 else n - k for k in range(min(n, depth) if depth > 1 else n)]
    return [len(node.blocks)]
