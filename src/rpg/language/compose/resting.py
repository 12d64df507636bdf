"""What lies on what: on blocks, on towers, on patches."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.places_of import steps
from rpg.language.compose.scene import Fact, Figure, Ref, Scene, Unclear


def tops_of(scene: Scene, ref: Ref) -> list[int]:
    """The blocks that something lies on when it lies on these."""
    if ref.kind == "block" and not ref.bound:
        stairs = scene.figure_of(ref.ids[0])
        if stairs is None or stairs.kind != "staircase":
            return ref.ids
        order = stairs.blocks  # what lies on a step lies on its highest block
        return [n for n in ref.ids if steps(order.index(n) + 1) or order[order.index(n) + 1] not in ref.ids]
    if ref.kind != "figure":
        raise Unclear
    tops = []
    for at in ref.ids:
        figure = scene.figures[at]
        if figure.kind != "tower" or scene.may_change(figure):
            raise Unclear
        tops.append(scene.at(figure, len(figure.blocks) - 1))
    return tops


def on_patch(scene: Scene, ref: Ref, target: Ref, *, no: bool) -> None:
    if no and len(target.ids) == 2:
        for n in target.ids:
            on_patch(scene, ref, Ref("patch", [n]), no=True)
        return
    if len(target.ids) != 1 or ((ref.bound or ref.rest) and no) or ref.bound == "most":
        raise Unclear
    whole = scene.figure_of(ref.ids[0]) if ref.kind == "block" and ref.every else None
    if whole is not None and set(ref.ids) < set(whole.blocks):
        raise Unclear  # whether the others are there, too
    if ref.kind == "figure":
        for at in ref.ids:
            scene.facts.append(Fact(Ref("block", scene.figures[at].blocks), "patch", target, no=no))
        for n in (n for at in ref.rest for n in scene.figures[at].blocks):
            scene.facts.append(Fact(Ref("block", [n]), "patch", target, no=True))
        return
    if no:
        scene.facts += [Fact(Ref("block", [n]), "patch", target, no=True) for n in ref.ids]
    else:
        scene.facts.append(Fact(Ref("block", ref.ids), "patch", target))
    tacit = not ref.bound
    scene.facts += [Fact(Ref("block", [n]), "patch", target, no=True, tacit=tacit) for n in ref.rest]


def on(scene: Scene, ref: Ref, target: Ref, word: str, *, no: bool) -> None:
    """One on one, or one on each of as many."""
    if target.kind == "figure" and len(target.ids) == 1 and ref.kind == "block" and not no and word == "on":
        figure = scene.figures[target.ids[0]]
        if figure.kind != "tower" and len(ref.ids) > 1:
            scene.pending.append((ref.ids, figure.blocks))
            return
    rows = [scene.figures[r.ids[0]] for r in (ref, target) if r.kind == "figure" and len(r.ids) == 1]
    if len(rows) == 2 and all(row.kind == "row" and scene.alike(row.blocks) for row in rows):  # each on another one
        ref, target = (Ref("block", row.blocks) for row in rows)
    if target.kind == "figure" or (target.kind == "block" and len(target.ids) > 1 and len(ref.ids) == 1):
        target = Ref("block", tops_of(scene, target))
    upper = ref.ids
    if ref.kind == "figure":
        upper = []
        for at in ref.ids:
            if scene.figures[at].kind != "tower":
                raise Unclear
            upper.append(scene.at(scene.figures[at], 0))
    if ref.kind == "block" and any(f.kind == "word" and set(ref.ids) & set(f.blocks) for f in scene.figures):
        raise Unclear
    if ref.bound == "exactly" and len(target.ids) == 1 and word == "on" and not no:
        scene.facts += [Fact(Ref("block", [n]), word, target, no=True) for n in ref.rest]
        ref = replace(ref, bound="")
    if target.kind != "block" or ref.bound in {"exactly", "most", "least"} or len(upper) != len(target.ids):
        raise Unclear
    if no and len(upper) > 1:
        raise Unclear
    if len(upper) > 1 and not (scene.alike(upper) or scene.alike(target.ids)):
        raise Unclear
    if any(n in scene.used for n in upper) and len(upper) > 1:
        raise Unclear
    for a, b in zip(upper, target.ids, strict=True):
        if word == "on" and not no:
            _join_on_patch(scene, a, b)
        scene.facts.append(Fact(Ref("block", [a]), word, Ref("block", [b]), no=no))
        if word == "on" and not no and (tower := next((f for f in scene.figures if f.blocks[-1] == b), None)):
            if tower.implied:
                tower.blocks.append(a)
        elif word == "on" and not no and (under := next((f for f in scene.figures if f.blocks[0] == a), None)):
            if under.implied:
                under.blocks.insert(0, b)
        elif word == "on" and not no and not any({a, b} & set(f.blocks) for f in scene.figures):
            scene.figures.append(Figure("tower", [b, a], told=True, implied=True))


def _join_on_patch(scene: Scene, upper: int, lower: int) -> None:
    """ "(One lies on the red patch,) the third on top of it": what lies on a block on a patch is on the patch.

    Raises Unclear where it is said not to be."""
    patches = [fact for fact in scene.facts if fact.said == "patch" and fact.b is not None]
    there = [fact.b for fact in patches if not fact.no and lower in fact.a.ids]
    denied = [fact for fact in patches if fact.no and upper in fact.a.ids and fact.b in there]
    if not all(fact.tacit for fact in denied):
        raise Unclear
    scene.facts = [fact for fact in scene.facts if fact not in denied]
