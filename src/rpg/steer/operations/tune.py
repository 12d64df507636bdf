"""Tolerances and gaps: tighter, looser, even, or at a value."""

from __future__ import annotations

from typing import Any

from rpg.ir import goal as g
from rpg.ir import relations as rel
from rpg.ir.edits import AddAsset, AddCondition, ChangeCondition, Path, SetField, SetStart
from rpg.ir.node import members
from rpg.ir.schema import InitialState
from rpg.ir.structures import Cells, GroupBy, Row
from rpg.steer.draft import Draft
from rpg.steer.operations.count import like
from rpg.steer.requests import requests as r
from rpg.steer.view import Shape

EDGES = {"on": ("offset_edges",), "row": ("line_edges",), "between": ("within_edges",)}
"""Tolerances in edges, by kind of atom."""
METRES = {
    "stayed": ("tolerance",),
    "swapped": ("tolerance",),
    "took_place": ("tolerance",),
    "moved": (),
    "touching": ("gap",),
    "on_table": ("gap",),
}
"""Tolerances in metres, by kind of atom."""


def loosen(draft: Draft, request: r.Loosen) -> None:
    """Change what the request names, wherever the goal has it."""
    draft.aim("TWEAK")
    draft.note("tune", {"what": request.what, "factor": request.factor, "value_m": request.value})
    if request.what == "distance":
        _stated(draft, request)
        return
    change = {"tolerance": _tolerance, "even": _even, "touching": _touching}.get(request.what, _spaced)
    if not change(draft, request):
        what = {"tolerance": "tolerance", "gap": "gap", "spacing": "spacing"}.get(request.what, "spacing")
        raise draft.refusal(
            "edit-unclear",
            f"nothing in the goal has a {what} that could change",
            request.span,
            "a row has a spacing; a stack of named blocks has a tolerance",
        )


def _spaced(draft: Draft, request: r.Loosen) -> bool:
    return _gaps(draft, request) or _measured_pair(draft, request)


def _stated(draft: Draft, request: r.Loosen) -> None:
    """A distance that the goal states is another one."""
    stated = [atom for _, atom in draft.view.atoms if _states(atom)]
    if len(stated) != 1:
        told = "the goal states no distance" if not stated else "the goal states more than one distance"
        raise draft.refusal("edit-unclear", told, request.span, "say between which blocks, and how far apart")
    _gaps(draft, request, only=stated[0])


def _states(atom: g.Goal) -> bool:
    return isinstance(atom, rel.Distance) or (isinstance(atom, Row) and (atom.spacing or atom.gap) is not None)


def _tolerance(draft: Draft, request: r.Loosen) -> bool:
    done = False
    for path, atom in draft.view.atoms:
        kinds = ("fit_edges",) if isinstance(atom, Cells) else EDGES.get(atom.kind, ())
        for field in kinds:
            edge = _edge(draft, atom)
            value = (
                request.value / edge if request.value is not None else getattr(atom, field) * (request.factor or 1.0)
            )
            done |= _set(draft, path, field, round(value, 6))
        for field in METRES.get(atom.kind, ()):
            value = request.value if request.value is not None else getattr(atom, field) * (request.factor or 1.0)
            done |= _set(draft, path, field, round(value, 6))
        if isinstance(atom, rel.Distance) and atom.minimum is not None and atom.maximum is not None:
            middle, half = (atom.minimum + atom.maximum) / 2, (atom.maximum - atom.minimum) / 2
            half = request.value if request.value is not None else half * (request.factor or 1.0)
            _set(draft, path, "minimum", round(max(0.0, middle - half), 6))
            done |= _set(draft, path, "maximum", round(middle + half, 6))
        if isinstance(atom, Row) and (atom.spacing is not None or atom.gap is not None):
            value = request.value if request.value is not None else atom.tolerance * (request.factor or 1.0)
            done |= _set(draft, path, "tolerance", round(value, 6))
    return done


def _edge(draft: Draft, atom: g.Goal) -> float:
    """The largest edge of the blocks of an atom."""
    from rpg.ir.walk import names

    return max((draft.view.world.edge[name] for name in names(atom) if name in draft.view.world.edge), default=0.04)


def _set(draft: Draft, path: Path, field: str, value: Any) -> bool:
    draft.do(SetField(at=path, field=field, value=value))
    return True


def _even(draft: Draft, request: r.Loosen) -> bool:
    done = False
    for path, atom in draft.view.atoms:
        if isinstance(atom, Row) and not atom.evenly:
            done |= _set(draft, path, "evenly", True)
            draft.aim("EXTEND")
    return done


def _touching(draft: Draft, request: r.Loosen) -> bool:
    done = False
    for path, atom in draft.view.atoms:
        if isinstance(atom, Row) and not atom.touching:
            draft.aim("EXTEND" if atom.gap is None and atom.spacing is None else "TWEAK")
            for field in ("gap", "spacing"):
                _set(draft, path, field, None)
            done |= _set(draft, path, "touching", True)
    return done or _touching_pair(draft, request)


def _side_by_side(draft: Draft) -> tuple[Path, rel.Directional | rel.Near | rel.Beside | rel.Adjacent] | None:
    """The relation between two blocks, if the goal has just one."""
    found = [(path, atom) for path, atom in draft.view.atoms if isinstance(atom, _SIDE_BY_SIDE)]
    pairs = [(members(atom.a), members(atom.b)) for _, atom in found]
    blocks = set(draft.view.world.blocks)
    if len(found) != 1 or any(len(a) != 1 or len(b) != 1 or not {*a, *b} <= blocks for a, b in pairs):
        return None
    return found[0]


def _measured_pair(draft: Draft, request: r.Loosen) -> bool:
    """Two blocks of which one is to be on a side of the other are so far apart, besides being on that side."""
    told = _side_by_side(draft)
    if told is None or not isinstance(told[1], rel.Directional) or not _measured(request):
        return False
    draft.aim("EXTEND")
    faces = "faces" if request.what == "gap" else "centres"
    pair = {"a": told[1].a, "b": told[1].b}
    goal = rel.Distance.model_validate({**pair, "minimum": request.low, "maximum": request.value, "measure": faces})
    draft.do(AddCondition(goal=goal), request.span)
    return True


def _touching_pair(draft: Draft, request: r.Loosen) -> bool:
    """Two blocks of which the goal has one relation side by side touch, besides being on that side, or level."""
    told = _side_by_side(draft)
    if told is None or any(isinstance(atom, rel.Touching) for _, atom in draft.view.atoms):
        return False
    path, atom = told
    touching = rel.Touching(a=atom.a, b=atom.b)
    if isinstance(atom, rel.Near):
        draft.aim("MODIFY")
        draft.do(ChangeCondition(at=path, to=touching), request.span)
    else:
        draft.aim("EXTEND")
        draft.do(AddCondition(goal=touching), request.span)
    return True


_SIDE_BY_SIDE = (rel.Directional, rel.Near, rel.Beside, rel.Adjacent)


def _gaps(draft: Draft, request: r.Loosen, only: g.Goal | None = None) -> bool:
    done = False
    kinds = {type(atom) for _, atom in draft.view.atoms}
    if only is None and rel.Apart in kinds and kinds & {rel.Near, rel.Beside, rel.Adjacent}:
        mixed = "some blocks are to be close and others far apart"
        raise draft.refusal("edit-unclear", mixed, request.span, "say which blocks, and how far apart")
    for path, atom in draft.view.atoms:
        if only is not None and atom != only:
            continue
        match atom:
            case Row():
                done |= _row(draft, path, atom, request)
            case rel.Near() | rel.Apart() | rel.Beside() | rel.Adjacent() if _measured(request):
                told = {"minimum": request.low, "maximum": request.value}
                faces = "faces" if request.what == "gap" else "centres"
                goal = rel.Distance.model_validate({"a": atom.a, "b": atom.b, **told, "measure": faces})
                draft.aim("MODIFY")
                draft.do(ChangeCondition(at=path, to=goal))
                done = True
            case rel.Near() | rel.Apart():
                value = request.value if request.value is not None else atom.distance * (request.factor or 1.0)
                done |= _set(draft, path, "distance", round(value, 6))
            case rel.Distance():
                done |= _distance(draft, path, atom, request)
            case rel.Beside() | rel.Adjacent():
                value = (
                    request.value / _edge(draft, atom)
                    if request.value is not None
                    else atom.gap_edges * (request.factor or 1.0)
                )
                done |= _set(draft, path, "gap_edges", round(value, 6))
            case GroupBy():
                done |= _set(draft, path, "outer_edges", round(atom.outer_edges * (request.factor or 1.0), 6))
    return done


def _measured(request: r.Loosen) -> bool:
    """Whether a request gives bounds of a distance rather than more or less of it."""
    return request.low is not None or request.value is not None


def _row(draft: Draft, path: Path, atom: Row, request: r.Loosen) -> bool:
    centers = atom.spacing is not None and (request.what == "spacing" or (request.what == "distance" and request.bare))
    field = "spacing" if centers or (request.what == "spacing" and request.value is not None) else "gap"
    other = "gap" if field == "spacing" else "spacing"
    if request.low is not None and request.value is None:
        told, hint = "a row has gaps of one size, or up to one", "say how wide: with gaps of 4 cm"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if request.value is not None:
        low = request.low if request.low is not None else request.value - atom.tolerance
        exact = request.low is None
        middle = request.value if exact else (low + request.value) / 2
        if not exact:
            _set(draft, path, "tolerance", round((request.value - low) / 2, 6))
    else:
        now = getattr(atom, field)
        if now is None and (request.factor or 1.0) < 1.0:
            return _set(draft, path, "gap_edges", round(atom.gap_edges * (request.factor or 1.0), 6))
        middle = now * (request.factor or 1.0) if now is not None else atom.gap_edges * _edge(draft, atom)
        if now is None:
            draft.assume(f"further apart: gaps of {middle * 100:.0f} cm, the widest that a row allows by itself")
    if getattr(atom, other) is not None:
        _set(draft, path, other, None)
    if atom.touching:
        _set(draft, path, "touching", False)
    return _set(draft, path, field, round(middle, 6))


def _distance(draft: Draft, path: Path, atom: rel.Distance, request: r.Loosen) -> bool:
    if request.low is not None and request.value is None:
        _set(draft, path, "minimum", request.low)
        return _set(draft, path, "maximum", None)
    if request.bare and atom.maximum is None and request.value is not None:
        return _set(draft, path, "minimum", request.value)
    if request.value is not None:
        low, high = request.low, request.value
        if low is None and atom.minimum is not None and atom.maximum is not None:
            half = (atom.maximum - atom.minimum) / 2
            low, high = round(high - half, 6), round(high + half, 6)
        _set(draft, path, "minimum", low)
        return _set(draft, path, "maximum", high)
    for field in ("minimum", "maximum"):
        value = getattr(atom, field)
        if value is not None:
            _set(draft, path, field, round(value * (request.factor or 1.0), 6))
    return True


def outliers(draft: Draft, request: r.Outliers) -> None:
    """Groups trade members: each has so many strangers."""
    figure = next((f for f in draft.view.figures if isinstance(f.node, GroupBy)), None)
    if figure is None or not isinstance(figure.node, GroupBy):
        raise draft.refusal(
            "no-such-object",
            "the task has no groups that could trade blocks",
            request.span,
            "sort the blocks into groups first",
        )
    figure = _grown(draft, figure, 2 * request.count + 1)
    assert isinstance(figure.node, GroupBy)
    small = min(len(group) for group in figure.node.groups)
    if request.count * 2 >= small:
        raise draft.refusal(
            "breaks-structure",
            f"with {request.count} strangers among {small} blocks a group is no group of its kind any more",
            request.span,
            f"at most {max(0, (small - 1) // 2)}",
        )
    draft.aim("MODIFY")
    draft.note("outliers", request.count)
    draft.do(SetField(at=figure.path, field="outliers", value=request.count), request.span)


def _grown(draft: Draft, figure: Shape, size: int) -> Shape:
    """The groups with blocks of their own sort added where they are too small for their strangers to stand out."""
    assert isinstance(figure.node, GroupBy)
    groups = [list(group) for group in figure.node.groups]
    for group in groups:
        for asset in like(draft, group, max(0, size - len(group))):
            draft.do(AddAsset(asset=asset))
            group.append(asset.name)
    if [tuple(group) for group in groups] == list(figure.node.groups):
        return figure
    draft.assume(f"groups of {size}, so that what does not belong there stands out")
    node = figure.node.model_copy(update={"groups": tuple(tuple(group) for group in groups)})
    draft.do(ChangeCondition(at=figure.path, to=node))
    if any(set(heap) & set(figure.members) for heap in draft.schema.init.heaps):
        draft.do(SetStart(init=_heaped(draft.schema.init, groups)))
    return next(f for f in draft.view.figures if f.path == figure.path)


def _heaped(init: InitialState, groups: list[list[str]]) -> InitialState:
    """Blocks that joined a group start in the heap of its first member."""
    heaps = [list(heap) for heap in init.heaps]
    for group in groups:
        home = next((heap for heap in heaps if group[0] in heap), None)
        if home is not None:
            home += [name for name in group if name not in home]
    return init.model_copy(update={"heaps": tuple(tuple(heap) for heap in heaps)})
