"""Adding: new blocks and patches, in lines, beside things, on patches, in groups, or as distractors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.blocks.traits import symbol_of
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.edits import AddCondition, SetField
from rpg.ir.order import Order
from rpg.ir.relations import OnPatch, Stayed
from rpg.ir.structures import Row
from rpg.steer.draft import Draft
from rpg.steer.matching import matches
from rpg.steer.operations.each import one_for_each
from rpg.steer.operations.make import new_assets
from rpg.steer.operations.place import join, put, stand_on, there
from rpg.steer.operations.relate import relation
from rpg.steer.refer import exists, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.view import BEGINS, View
from rpg.steer.wholes import Found


def add(draft: Draft, request: r.Add) -> None:
    """New objects where the request wants them, or where the task leaves only one place."""
    places = tuple(there(draft, place) for place in request.places)
    request = replace(request, theme=_further(draft, request.theme), places=places)
    if one_for_each(draft, request):
        return
    if request.lacking and isinstance(request.theme, m.Noun) and _known(draft, request.theme):
        told, hint = "the task has this already", "say 'another' for one more"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    anchors = {id(place): _anchor(draft, place) for place in request.places}
    line, figure = draft.view.main_line(), draft.view.main_figure()
    assets = new_assets(draft, request.theme)
    names = draft.add(assets, request.span)
    draft.note("add", list(names))
    if request.stay:
        draft.aim("EXTEND")
        draft.do(AddCondition(goal=Stayed(a=names)), request.span)
        return
    if _extra(request.theme):
        draft.aim("TWEAK")
        return
    patches = [name for name in names if name in draft.view.world.patches]
    if patches:
        _add_patches(draft, patches, request, anchors)
        return
    draft.aim("EXTEND")
    if not request.places:
        if line is not None and line.node is None and line.kind != "tower":
            line = None
        join(draft, names, line, figure is not None, request.span)
    for place in request.places:
        put(draft, names, place, anchors[id(place)], request.span, line)
    draft.look_at(names)


def _known(draft: Draft, theme: m.Noun) -> bool:
    """Whether the task has any of the blocks that are named."""
    world = draft.view.world
    shown = {symbol_of(world, name) for name in world.blocks}
    return exists(draft.view, theme) or bool(shown & set(theme.traits.labels))


def _further(draft: Draft, theme: m.Meaning) -> m.Meaning:
    """Phrases such as "a third red block", where there are two: one more of them."""
    if not isinstance(theme, m.Noun) or theme.det != "a" or not (theme.traits.rank or "").isdigit():
        return theme
    plain = replace(theme, traits=replace(theme.traits, rank=None))
    view = draft.view
    there = [name for name in view.world.assets if matches(view, name, plain.traits)]
    there = [name for name in there if (name in view.world.patches) == (theme.head == "patch")]
    if len(there) + 1 != int(theme.traits.rank or 0):
        told, hint = (
            f"the task has {len(there)} of these so far",
            "say 'another' for one more, or how many there should be",
        )
        raise draft.refusal("count-mismatch", told, theme.span, hint)
    return plain


def _extra(theme: m.Meaning) -> bool:
    if isinstance(theme, m.Coord):
        return all(_extra(item) for item in theme.items)
    return isinstance(theme, m.Noun) and theme.traits.extra and theme.det != "another"


def _anchor(draft: Draft, place: r.Place) -> Found | None:
    """What a place is next to, resolved before anything new is there."""
    landmark = place.whole if isinstance(place, r.Spot) else getattr(place, "landmark", None)
    if landmark is None or isinstance(landmark, m.TableTop):
        return None
    rel = place.rel if isinstance(place, m.Loc) else {"top": "on"}.get(getattr(place, "side", ""), "")
    if isinstance(landmark, m.Pronoun):
        return _mentioned_before(draft, rel) or resolve(draft.view, landmark)
    found = resolve(draft.view, landmark)
    if isinstance(landmark, m.Noun) and landmark.traits.rank:
        _pinned(draft, found, landmark)
        _told_apart(draft.view, found, landmark)
    draft.beside = rel, found
    return found


def _pinned(draft: Draft, found: Found, landmark: m.Noun) -> None:
    """The one at a place of a row of look-alikes is from now on that very block, so that something can go with it."""
    line = draft.view.line_of(found.names)
    node = line.node if line is not None else None
    if line is None or not isinstance(node, Row) or len(found.names) != 1 or node.order.by != "any":
        return
    if len({draft.view.world.look[name] for name in line.members}) > 1:
        return
    at = line.members.index(found.names[0])
    ranks = tuple(rank for rank in (line.members[:at], found.names, line.members[at + 1 :]) if rank)
    order = Order.model_validate({"by": "given", "ranks": ranks, "first": BEGINS[line.kind], "match": "name"})
    draft.do(SetField(at=line.path, field="order", value=order.model_dump()), landmark.span)


def _told_apart(view: View, found: Found, landmark: m.Noun) -> None:
    """ "The middle one" of a line of look-alikes: any of them may come to stand there, so nothing can go with it."""
    look = view.world.look
    for line in view.lines:
        twins = [name for name in line.members if any(look[name] == look[other] for other in found.names)]
        by_name = getattr(getattr(line.node, "order", None), "match", "") == "name"
        if set(found.names) <= set(line.members) and len(twins) > len(found.names) and not by_name:
            raise Refusal(
                [
                    Diagnostic(
                        code="edit-unclear",
                        message="blocks that look alike are there, and any of them may be this one",
                        span=landmark.span,
                        hint="give that block a colour of its own first",
                        origin="steer",
                    )
                ]
            )


def _mentioned_before(draft: Draft, rel: str) -> Found | None:
    """What "it" means after "a green block to the left of the tower": the tower. What goes on what was put on
    something goes on top of that."""
    if draft.beside is None or draft.beside[0] == rel == "on":
        return None
    found: Found = draft.beside[1]
    return found


def _add_patches(draft: Draft, patches: Sequence[str], request: r.Add, anchors: dict[int, Found | None]) -> None:
    """Phrases such as "add a green patch under the tower": what stands on it, or beside what it is."""
    if not request.places:
        draft.aim("TWEAK")
        draft.assume("nothing has to be on what is added without a duty")
        return
    draft.aim("EXTEND")
    for place in request.places:
        anchor = anchors[id(place)]
        side = place.side if isinstance(place, r.Spot) else getattr(place, "rel", "")
        line = anchor.line if anchor else draft.view.main_line()
        if side in ("under", "bottom") and line is not None and (anchor is None or anchor.whole):
            stand_on(draft, line, patches[0], request.span)
        elif side in ("under", "bottom") and anchor is not None:
            draft.do(AddCondition(goal=OnPatch(a=anchor.names, patch=patches[0])), request.span)
        elif isinstance(place, m.Loc) and anchor is not None:
            draft.do(
                AddCondition(
                    goal=relation(draft, place.rel, tuple(patches), anchor.names, place.mods, request.span, place)
                ),
                request.span,
            )
        else:
            raise draft.refusal(
                "edit-unclear", "a patch cannot be there", request.span, "say what is to stand on it: under the tower"
            )
