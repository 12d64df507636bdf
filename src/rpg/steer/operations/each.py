"""One new block for each of several: "a red block on top of each of them", "white blocks on all the towers"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.steer.draft import Draft
from rpg.steer.operations.make import new_assets
from rpg.steer.operations.place import put
from rpg.steer.refer import ALL_OF, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.wholes import Found

_SIDES = {"top": "on", "bottom": "under", "left": "left", "right": "right", "front": "front", "back": "behind"}
EACH = frozenset(
    {"each", "each of them", "each one", "every one", "each of those", "each of these", "every one of them"}
)


def one_for_each(draft: Draft, request: r.Add) -> bool:
    """Add a block at every place that the request means, if it means several; False where it means one."""
    if len(request.places) != 1 or not isinstance(request.theme, m.Noun) or request.theme.head == "patch":
        return False
    (place,) = request.places
    landmark = place.whole if isinstance(place, r.Spot) else getattr(place, "landmark", None)
    rel = _SIDES.get(place.side, "beside") if isinstance(place, r.Spot) else getattr(place, "rel", "")
    several = request.theme.plural and request.theme.amount is None
    if landmark is None or not (_each(landmark) or (several and _all(landmark) and rel == "on")):
        return False
    targets = _targets(draft, landmark, rel)
    if several or request.theme.amount is None or request.theme.amount.low == 1:
        theme = replace(request.theme, amount=m.Amount(len(targets), len(targets)), plural=True)
    else:
        told = f"{request.theme.amount.low} blocks for each of {len(targets)} cannot be told apart here"
        raise draft.refusal("edit-unclear", told, request.span, "add one block for each, then another")
    names = draft.add(new_assets(draft, theme), request.span)
    draft.note("add", list(names))
    draft.aim("EXTEND")
    for name, target in zip(names, targets, strict=True):
        now = _now(draft, target)
        put(draft, (name,), m.Loc(rel=rel, landmark=landmark, span=request.span), now, request.span)
    draft.look_at(names)
    return True


def _each(landmark: m.Meaning) -> bool:
    match landmark:
        case m.Pronoun():
            return landmark.word in EACH
        case m.Noun() | m.Structure():
            return landmark.det == "each"
    return False


def _all(landmark: m.Meaning) -> bool:
    match landmark:
        case m.Pronoun():
            return landmark.word in ALL_OF
        case m.Noun():
            return landmark.det in ("all", "the") and landmark.plural
        case m.Structure():
            return landmark.plural and landmark.det in ("all", "the", "both")
    return False


def _targets(draft: Draft, landmark: m.Meaning, rel: str) -> Sequence[Found]:
    """What each new block goes to: a tower or a block. On the towers, each means each tower."""
    towers = [line for line in draft.view.lines if line.kind == "tower"]
    if isinstance(landmark, m.Structure) or (isinstance(landmark, m.Pronoun) and len(towers) > 1):
        found = [Found(line.members, line) for line in towers]
        if found and (isinstance(landmark, m.Pronoun) or landmark.kind == "stack"):
            return found
        raise draft.refusal("no-such-object", "the task has no such structures", landmark.span, "name the blocks")
    if isinstance(landmark, m.Pronoun):
        landmark = m.Pronoun(word="them", span=landmark.span)
    names = resolve(draft.view, landmark).names
    under = {name for line in towers for name in line.members[:-1]}
    if rel == "on" and under & set(names):
        told, hint = "something is on some of these blocks already", "say which one: the top block"
        raise draft.refusal("edit-unclear", told, landmark.span, hint)
    return [Found((name,)) for name in names]


def _now(draft: Draft, target: Found) -> Found:
    """A tower as it is after what was added before."""
    line = target.line and draft.view.line_of(target.names)
    return Found(line.members, line) if line else target
