"""What "it", "they", "both" and "which" stand for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.compose.scene import Ref, Scene, Unclear
from rpg.language.compose.syntax import Noun, Place, Pronoun

_OPPOSITE = {"left": "right", "right": "left", "front": "behind", "behind": "front"}


def pronoun(scene: Scene, word: str) -> Ref:
    """The one thing, or the one lot, that was spoken of last and that it can stand for."""
    if word == "these blocks":  # not what they form already
        return scene.here[0]
    if word == "which":
        return _last(scene, scene.before if scene.subject else scene.here or scene.before)
    if word == "all blocks":
        told = scene.told_of("block") | {n for figure in scene.figures for n in figure.blocks}
        if len(told) < len(scene.blocks) or len(told) < 2:
            raise Unclear  # all that there are, or those that were told of
        return Ref("block", sorted(told))
    if word == "neither":
        if len(scene.patches) != 2:
            raise Unclear
        return Ref("patch", [0, 1], no=True)
    if word == "that one":  # of several that were told of
        some = [ref for ref in scene.before if ref.rest and len(ref.ids) == 1]
        new = [ref for ref in scene.before if ref.fresh and ref.kind == "block" and len(ref.ids) == 1]
        if not some and not scene.here and len(new) == 1 and not _is_member(scene, new[0].ids[0]):
            return replace(new[0], fresh=False)  # what is told of for the first time right before
        return replace(some[0], rest=[], bound="") if len(some) == 1 else pronoun(scene, "it")
    if word == "its":
        return _its(scene)
    many = word in {"they", "their", "them", "these", "those", "both", "each"}
    earlier = scene.earlier[::-1] if word == "both" else []  # two that were told of farther back
    for spoken in (scene.here, scene.before, *earlier):
        fits = [ref for ref in spoken if (len(ref.ids) > 1) == many and ref.kind != "table"]
        fits = [ref for ref in fits if not _is_subject(scene, ref)]
        if word == "both":
            fits = [ref for ref in fits if len(ref.ids) == 2] or _pair(scene, spoken)
        if many and not fits and spoken is scene.before and len(scene.figures) > 1:
            if any(figure.implied for figure in scene.figures) or (word == "both" and len(scene.figures) > 2):
                raise Unclear
            fits = [Ref("figure", list(range(len(scene.figures))))]
        if many and not fits:
            fits = _one_of_several(scene, spoken)
        if not fits:
            continue
        first = fits[0] if len({(ref.kind, tuple(ref.ids)) for ref in fits}) == 1 else None
        if first is None or (first.kind == "block" and not many and _is_member(scene, first.ids[0])):
            raise Unclear
        if many and word != "both" and first.kind == "block" and first.bound:
            raise Unclear  # "exactly two are on the mat, where they are stacked": all, or just so many
        stocked = {n for lot in scene.stock for n in lot}
        if many and first.kind == "block" and set(first.ids) < stocked and not stocked & scene.used:
            raise Unclear  # those that were told of last, or all that there are
        whole = next(
            (n for n, f in enumerate(scene.figures) if f.kind == "tower" and set(f.blocks) == set(first.ids)), None
        )
        if first.kind == "block" and whole is not None:
            return _of_each_of_them(scene) if word in {"both", "each"} else Ref("figure", [whole])
        return replace(first, fresh=False, each=word == "each", bound="", no=False)
    raise Unclear


def _its(scene: Scene) -> Ref:
    """ "(The red block stands on the mat,) a white one to its left": the block, not the mat that it stands on."""
    ahead = [ref for ref in scene.before if ref.kind == "patch"]
    kept = scene.before
    scene.before = [ref for ref in kept if ref not in ahead] or kept
    try:
        return pronoun(scene, "it")
    finally:
        scene.before = kept


def so_many(scene: Scene, noun: Noun) -> Ref:
    """ "Those three blocks", "the four": as many as were told together, or as all that there are."""
    every = Ref("block", list(range(len(scene.blocks))))
    spoken = [ref for told in (scene.here, scene.before) for ref in told if ref.kind == "block"]
    lots = [ref for ref in spoken if len(ref.ids) == noun.count or (not noun.count and len(ref.ids) > 1)]
    if noun.noun and any(not scene.blocks[ref.ids[0]].label for ref in lots):  # symbols need not be told as blocks
        lots = [ref for ref in lots if not scene.blocks[ref.ids[0]].label]
    new = [n for ref in spoken if ref.fresh and len(ref.ids) == 1 for n in ref.ids]  # told one by one
    if noun.near and len(new) > 1 and len(new) == (noun.count or len(new)):
        lots.append(Ref("block", list(dict.fromkeys(new))))
    if len(every.ids) == noun.count or not noun.near:
        lots.append(every)
    if noun.color:
        lots = [ref for ref in lots if all(scene.blocks[n].color == noun.color for n in ref.ids)]
    found = {tuple(sorted(ref.ids)): ref for ref in lots[::-1]}
    if len(found) != 1 or len(lots[0].ids) not in {noun.count, noun.count or len(lots[0].ids)} or lots[0].bound:
        raise Unclear
    return Ref("block", lots[0].ids, every=not noun.near)


def _of_each_of_them(scene: Scene) -> Ref:
    """ "(A and B form a tower, C and D another one,) both ...": the figures, not the blocks of the last one."""
    if len(scene.figures) != 2 or any(figure.implied for figure in scene.figures):
        raise Unclear
    return Ref("figure", [0, 1], each=True)


def _others(scene: Scene, spoken: Sequence[Ref]) -> list[Ref]:
    """What was spoken of, each thing once, without what something is being said of."""
    others = [ref for ref in spoken if not _is_subject(scene, ref)]
    return list({(ref.kind, tuple(ref.ids)): ref for ref in others}.values())


def _pair(scene: Scene, spoken: Sequence[Ref]) -> list[Ref]:
    """Two things that were told one by one, and nothing else."""
    others = _others(scene, spoken)
    kinds = {ref.kind for ref in others}
    if len(others) != 2 or len(kinds) > 1 or any(len(ref.ids) != 1 or ref.either for ref in others):
        return []
    return [Ref(kinds.pop(), [n for ref in others for n in ref.ids])]


def _one_of_several(scene: Scene, spoken: Sequence[Ref]) -> list[Ref]:
    """The only figure that was spoken of, if it was told of how many blocks it is: "they" are these."""
    others = _others(scene, spoken)
    return [ref for ref in others if len(others) == 1 and ref.kind == "figure" and scene.figures[ref.ids[0]].counted]


def landmark(scene: Scene, said: Place) -> Ref | None:
    """What "it" is, where things are told around it before: "(A and B left of D,) C right of it and E on it".

    What is first told to be at a part of a figure, and then another at its other side, is told around that part."""
    if scene.around is None or said.of not in {Pronoun("it"), Pronoun("its")} or _others(scene, scene.here):
        return None
    relation, target, by_it = scene.around
    inside = target.kind == "block" and _is_member(scene, target.ids[0])
    other_side = inside and _OPPOSITE.get(relation) == said.relation
    return target if other_side or (by_it and relation != said.relation) else None


def _is_member(scene: Scene, block: int) -> bool:
    """Whether a block was told as one of a figure: "it" may be either, unless it is said of one of them."""
    own = set(scene.subject[1]) if scene.subject is not None and scene.subject[0] == "block" else set()
    return any(block in f.blocks and not f.implied and not own & set(f.blocks) for f in scene.figures)


def _is_subject(scene: Scene, ref: Ref) -> bool:
    """Whether this is, or is one of, what something is being said of, or holds it: "it" is something else then."""
    if scene.subject is not None and (ref.kind, scene.subject[0]) == ("figure", "block"):
        return any(set(scene.subject[1]) & set(scene.figures[n].blocks) for n in ref.ids)
    return scene.subject is not None and ref.kind == scene.subject[0] and set(ref.ids) <= set(scene.subject[1])


def _last(scene: Scene, spoken: Sequence[Ref]) -> Ref:
    """What "which" stands for: what is told right before it."""
    if not spoken or spoken[-1].kind == "table" or (spoken[-1].rest and scene.subject):
        raise Unclear
    return replace(spoken[-1], fresh=False, each=False, bound="", no=False)
