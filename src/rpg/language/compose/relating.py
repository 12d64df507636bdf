"""How blocks, figures and patches of a scene relate: on, beside, between, in a region, in a place of a figure."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

from rpg.language.compose.forming import forms
from rpg.language.compose.lined import rise
from rpg.language.compose.nouns import resolve
from rpg.language.compose.ordering import put_in_order
from rpg.language.compose.parts import whole_figures
from rpg.language.compose.places_of import places
from rpg.language.compose.reading import take_turns
from rpg.language.compose.resting import on, on_patch, tops_of
from rpg.language.compose.scene import SIDES, Fact, Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import Both, Noun, Phrase, Place

_RELATIONS = {"next": "next to", "near": "near", "far": "far from", "touch": "touch"}
_HOW = {"top": "", "directly": "directly ", "immediately": "immediately ", "somewhere": "somewhere ", "": ""}
_BOUND = {"least": "at least ", "most": "at most ", "about": "about "}
_FLAT = frozenset({"row", "line", "column", "word", "equation", "grid", "group", "circle"})
_NO_CORNERS = frozenset({"tower", "row", "line", "column", "word", "equation", "group", "circle"})
_BARE_PLACES = frozenset({"top", "bottom", "middle", "left", "right", "front", "behind"})


def bare(scene: Scene, ref: Ref, said: Place) -> None:
    """A place that is told without what it is a place of."""
    name = said.relation
    if name in {"free", "empty"} and ref.kind == "patch" and not said.no:
        scene.facts += [Fact(Ref("patch", [n]), "empty") for n in ref.ids]
    elif name == "free" and ref.kind == "figure" and not (said.no or ref.bound):
        scene.facts += [Fact(Ref("block", [n]), "clear") for n in tops_of(scene, ref)]
    elif name in {"free", "table", "flat"} and ref.kind == "block" and not ref.bound:
        word = {"free": "clear", "table": "table", "flat": "table"}[name]
        if said.no:
            raise Unclear
        scene.facts += [Fact(Ref("block", [n]), word) for n in ref.ids]
    elif name == "stay" and ref.kind in {"block", "figure"} and not (said.no or ref.bound or ref.rest or ref.either):
        if scene.stage:
            raise Unclear  # what was put somewhere first
        scene.facts.append(Fact(Ref("block", _blocks(scene, ref)), "stay"))
    elif name in {"side by side", "touching", "apart"} and not ref.each and not ref.bound:
        if ref.rest or len(ref.ids) < 2:
            raise Unclear
        if name == "side by side" and not said.no and len(ref.ids) > 2 and _are_letters(scene, ref):
            forms(scene, ref, Noun(det="a", noun="line"))  # "the letters C, A and T next to each other"
            return
        if len(ref.ids) != 2 and (name != "apart" and not said.no):
            raise Unclear
        word = {"side by side": "next to", "touching": "touch", "apart": "apart"}[name]
        if said.cm and ref.kind == "figure" and any(scene.figures[n].kind != "tower" for n in ref.ids):
            raise Unclear  # from which to which of their blocks?
        if said.cm:
            word = f"gap of {said.cm:g} cm" if said.how == "gap" else f"{_BOUND.get(said.bound, '')}{said.cm:g} cm from"
        scene.facts += [
            Fact(Ref(ref.kind, [a]), word, Ref(ref.kind, [b]), no=said.no) for a, b in combinations(ref.ids, 2)
        ]
    elif name == "unlike" and ref.kind == "figure" and len(ref.ids) == 1:
        take_turns(scene, scene.figures[ref.ids[0]])
    elif name == "any order" and not said.no:
        _in_any_order(scene, ref)
    elif name == "sorted" and ref.kind == "figure" and not said.no:
        for figure in (scene.figures[n] for n in ref.ids):
            if (figure.kind == "tower") != (said.side == "top"):
                raise Unclear  # which end is the first one
            put_in_order(scene, figure, said.how)
    elif name == "sorted" and ref.kind == "block" and said.side != "top" and not said.no:
        forms(scene, ref, Noun(det="a", noun="row", order=said.how))
    elif name == "rising" and not said.no:
        rise(scene, ref, said.side)
    elif name == "in turn" and ref.kind == "figure" and len(ref.ids) == 2 and not said.no:
        scene.facts.append(Fact(Ref("figure", ref.ids[1:]), "behind", Ref("figure", ref.ids[:1])))
    elif name in _BARE_PLACES:
        _in_figure(scene, ref, name, no=said.no, inside=said.how == "at" and name in SIDES)
    else:
        raise Unclear


def _are_letters(scene: Scene, ref: Ref) -> bool:
    return ref.kind == "block" and all(scene.blocks[n].label for n in ref.ids)


def _in_any_order(scene: Scene, ref: Ref) -> None:
    """These figures, or those that these blocks form, have no fixed order."""
    figures = [f for n, f in enumerate(scene.figures) if ref.kind == "figure" and n in ref.ids]
    if ref.kind == "block":
        figures = [f for f in scene.figures if set(f.blocks) == set(ref.ids)]
    if not figures or any(figure.told or figure.placed for figure in figures):
        raise Unclear
    for figure in figures:
        figure.free = not scene.alike(figure.blocks)


def in_region(scene: Scene, ref: Ref, said: Place) -> None:
    if ref.kind not in {"block", "figure"} or said.no or ref.bound not in {"", "least"} or ref.rest:
        raise Unclear
    if said.side == "bare" and any(figure.kind not in _NO_CORNERS for figure in scene.figures):
        raise Unclear  # "in the far left corner" may be one of the grid
    for ids in (scene.figures[n].blocks for n in ref.ids) if ref.kind == "figure" else (ref.ids,):
        scene.facts.append(Fact(Ref("block", ids), f"{said.how} of the table"))


def at_part(scene: Scene, ref: Ref, part: Noun, *, no: bool) -> None:
    """ "At the left end of the row", "not at an end of it": where in its figure a block is."""
    owners = whole_figures(scene, part, resolve)
    own = {scene.figures.index(figure) for n in ref.ids if (figure := scene.figure_of(n)) is not None}
    if ref.kind != "block" or len(owners) != 1 or [owners[0]] != [scene.figures[n] for n in own]:
        raise Unclear
    figure = owners[0]
    noun = () if part.noun in {"one", "block"} else (part.noun,)
    at = places(figure, (*part.ranks, *noun), part.nth, len(ref.ids))
    if no:
        _bar(scene, figure, ref.ids, at)
    elif len(ref.ids) == len(at) > 1 and scene.alike(ref.ids):
        for n, there in zip(ref.ids, at, strict=True):
            _put_there(scene, figure, n, there)
    elif len(ref.ids) == 1 and (len(at) == 1 or part.det in {"a", "any"}):
        _put_there(scene, figure, ref.ids[0], at[scene.choose(len(at))])
        figure.sided |= bool({"left", "right"} & set(part.ranks)) or len(at) > 1
        if set(figure.blocks) <= scene.spare:
            raise Unclear  # "with the smallest number on top": that one, or all of them in order
        figure.free |= not scene.alike([n for n in figure.blocks if n not in figure.placed.values()] or figure.blocks)
    else:
        raise Unclear


def _bar(scene: Scene, figure: Figure, ids: list[int], at: list[int]) -> None:
    """These blocks must not be at these places of the figure."""
    if figure.told:
        raise Unclear
    figure.free = figure.sided = True
    for n in ids:
        figure.barred.setdefault(n, set()).update(at)


def _put_there(scene: Scene, figure: Figure, block: int, at: int) -> None:
    if figure.told and scene.blocks[figure.blocks[at]].look == scene.blocks[block].look:
        return  # this is told again
    if figure.told or figure.placed.get(at, block) != block:
        raise Unclear
    figure.placed[at] = block
    scene.place = (figure, at)


def _in_figure(scene: Scene, ref: Ref, name: str, *, no: bool, inside: bool) -> None:
    """ "on top", "at the left end": in the figure that was spoken of, if it is one of its blocks; else on or beside."""
    spoken = [r for refs in (scene.here, scene.before) for r in refs if r.kind == "figure" and r is not ref]
    if ref.kind == "block" and len(ref.ids) == 1 and (own := scene.figure_of(ref.ids[0])) is not None:
        spoken = [Ref("figure", [scene.figures.index(own)])]
    if len({tuple(r.ids) for r in spoken}) > 1:
        raise Unclear
    last = spoken[0] if spoken else None
    pairs = {tuple(r.ids) for refs in (scene.here, scene.before) for r in refs if r.kind == "block" and len(r.ids) == 2}
    if last is None and name in SIDES and len(pairs) == 1 and ref.kind == "block" and len(ref.ids) == 1 and not no:
        pair = set(pairs.pop())
        if set(ref.ids) < pair:  # "the two side by side, the red one on the right"
            scene.facts.append(Fact(ref, SIDES[name], Ref("block", list(pair - set(ref.ids)))))
            return
    if last is not None and any(scene.blocks[n].look[2] for at in last.ids for n in scene.figures[at].blocks):
        raise Unclear  # it may be one of its blocks
    if last is None or len(last.ids) != 1 or ref.kind == "table":
        raise Unclear
    figure = scene.figures[last.ids[0]]
    if no:
        if ref.kind != "block" or not set(ref.ids) <= set(figure.blocks):
            raise Unclear
        _bar(scene, figure, ref.ids, places(figure, (name,)))
        return
    if ref.kind == "block" and set(ref.ids) <= set(figure.blocks):
        at = places(figure, (name,), 0, len(ref.ids))
        if len(at) != len(ref.ids) or not scene.alike(ref.ids):
            raise Unclear
        for n, there in zip(ref.ids, at, strict=True):
            _put_there(scene, figure, n, there)
        figure.sided |= name in {"left", "right"}
        loose = [n for n in figure.blocks if n not in figure.placed.values()]
        figure.free |= figure.kind == "tower" and not figure.told and len(loose) > 1 and not scene.alike(loose)
        return
    if name == "top" and ref.kind == "block":
        on(scene, ref, Ref("block", tops_of(scene, last)), "on", no=False)
    elif name in SIDES and ref.ids != last.ids and not inside:
        scene.facts.append(Fact(ref, SIDES[name], last))
    else:
        raise Unclear


def between(scene: Scene, ref: Ref, of: Phrase, said: Place) -> None:
    """Between two things, told one by one or as two."""
    if isinstance(of, Both) and len(of.parts) == 2:
        first, second = (resolve(scene, part) for part in of.parts)
    else:
        both = resolve(scene, of)
        if len(both.ids) != 2:
            raise Unclear
        first, second = (Ref(both.kind, [n]) for n in both.ids)
    if said.no or said.cm or ref.bound or first.kind == "patch" or second.kind == "patch":
        raise Unclear
    scene.facts.append(Fact(ref, "between", first, second))


def place(scene: Scene, ref: Ref, target: Ref, said: Place) -> None:
    """A relation to something that is told."""
    name = said.relation
    if target.no:
        said, target = replace(said, no=not said.no), replace(target, no=False)
        if said.no and said.relation == "on" and target.kind in {"block", "figure"} and len(target.ids) > 1:
            for n in target.ids:
                place(scene, ref, Ref(target.kind, [n]), said)
            return
    if target.kind == "figure" and target.bound == "exactly" and len(ref.ids) == 1 and not said.no:
        target = replace(target, bound="", rest=[])  # what is one is on no other one
    if ref.kind in {"patch", "table"} or target.bound:
        raise Unclear
    if ref.kind == "figure" != target.kind and set(_blocks(scene, ref)) & set(_blocks(scene, target)):
        raise Unclear  # a figure is nowhere on its own blocks
    if name == "flank":
        return  # on which side is told behind
    if name in {"in", "on"} and target.kind == "patch":
        on_patch(scene, ref, target, no=said.no)
        if said.how == "flat":
            bare(scene, ref, Place("flat", no=said.no))
    elif name == "off" and target.kind == "patch":
        on_patch(scene, ref, target, no=not said.no)
    elif name in {"off", "in", "opposite"}:
        raise Unclear
    elif name == "on" and target.kind == "table":
        if ref.kind not in {"block", "figure"} or said.no or ref.bound or ref.rest:
            raise Unclear
        scene.facts += [Fact(Ref("block", [n]), "table") for n in _lowest(scene, ref)]
    elif name == "under":
        if ref.kind != "block" or len(ref.ids) != 1 or said.how == "somewhere":
            raise Unclear
        on(scene, target, ref, "on", no=said.no)
    elif name == "on":
        on(scene, ref, target, "somewhere above" if said.how == "somewhere" else "on", no=said.no)
    elif not _in_row(scene, ref, target, said):
        _beside(scene, ref, target, said)


def _lowest(scene: Scene, ref: Ref) -> list[int]:
    """The blocks that are on the table where these are: of a tower the lowest one, of what is flat all of them."""
    found: list[int] = []
    for figure in (scene.figures[n] for n in ref.ids) if ref.kind == "figure" else ():
        if figure.kind not in {"tower", *_FLAT}:
            raise Unclear
        found += [scene.at(figure, 0)] if figure.kind == "tower" else figure.blocks
    return found if ref.kind == "figure" else ref.ids


def _in_row(scene: Scene, ref: Ref, target: Ref, said: Place) -> bool:
    """ "(A, B and C in a row, B in the middle,) A to the left of it": at the only place for it in the row."""
    figure = scene.figure_of(ref.ids[0]) if ref.kind == target.kind == "block" and len(ref.ids) == 1 else None
    if figure is None or figure.kind not in {"row", "line"} or figure.told or said.relation not in {"left", "right"}:
        return False
    of = [at for at, block in figure.placed.items() if [block] == target.ids]
    beyond = range(of[0]) if of and said.relation == "left" else range(of[0] + 1, len(figure.blocks)) if of else ()
    free = [at for at in beyond if figure.placed.get(at, ref.ids[0]) == ref.ids[0]]
    if len(free) != 1 or said.no:
        return False
    _put_there(scene, figure, ref.ids[0], free[0])
    figure.sided = True
    return True


def _beside(scene: Scene, ref: Ref, target: Ref, said: Place) -> None:
    """Sides, distances, touch."""
    if ref.bound or target.kind == "table":
        raise Unclear
    wide = ref.kind == "figure" and any(scene.figures[n].kind != "tower" for n in ref.ids)
    if wide and target.kind == "block" and scene.figure_of(target.ids[0]) is not None:
        raise Unclear  # "a column behind the left end of a row": all of it behind that block alone
    some = (
        [Ref(ref.kind, [n]) for n in ref.ids]
        if ref.each or said.no or said.relation in {"touch", "apart", "far"}
        else [ref]
    )
    several = len(target.ids) > 1
    others = [target]
    if said.relation in SIDES and not said.no and not said.cm:
        some = [replace(ref, each=False)]
        target = replace(target, each=False)
    if target.each or (several and said.relation in {"apart", "far", "near"}) or (several and said.no):
        others = [Ref(target.kind, [n]) for n in target.ids]
    if several and not said.no and (said.relation == "touch" or target.kind == "figure"):
        others = [Ref(target.kind, [n]) for n in target.ids]
    for a in some:
        for b in others:
            if set(_blocks(scene, a)) & set(_blocks(scene, b)) and a.kind == b.kind:
                raise Unclear
            scene.facts += _facts_beside(a, b, said)


def _facts_beside(a: Ref, b: Ref, said: Place) -> list[Fact]:
    if said.how not in _HOW:
        raise Unclear
    how = _HOW[said.how]
    far = [Fact(a, f"{_BOUND.get(said.bound, '')}{said.cm:g} cm from", b, no=said.no)] if said.cm else []
    if said.relation in SIDES:
        if said.no and (said.cm or said.how):
            raise Unclear
        return [Fact(a, f"{how}{SIDES[said.relation]}", b, no=said.no), *far]
    if said.relation == "apart" and said.cm and not said.how:
        return far
    if said.cm or said.how == "somewhere":
        raise Unclear
    if said.relation not in _RELATIONS:
        raise Unclear
    return [Fact(a, _RELATIONS[said.relation], b, no=said.no)]


def _blocks(scene: Scene, ref: Ref) -> list[int]:
    if ref.kind == "figure":
        return [n for at in ref.ids for n in scene.figures[at].blocks]
    return ref.ids if ref.kind == "block" else []
