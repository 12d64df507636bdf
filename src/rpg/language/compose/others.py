"""What is left of those that some were told of: "the rest", "the other two", "the other tower"."""

from __future__ import annotations

from rpg.language.compose.items import FIGURES
from rpg.language.compose.scene import Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import Bears, Clause, Noun, Place


def take(scene: Scene, ids: list[int]) -> Ref:
    scene.taken += [n for n in ids if n not in scene.taken]
    return Ref("block", ids)


def one_more_block(scene: Scene) -> Ref:
    """ "Another one" of blocks that look alike, of which some were taken."""
    left = [n for n in scene.whole if n not in scene.taken]
    if not scene.taken or not left or not scene.alike(left):
        raise Unclear
    return take(scene, left[:1])


def others(scene: Scene, noun: Noun) -> Ref:
    """Those of the last lot that were not yet told of by themselves, or the other one of two figures or patches."""
    if noun.word == "else":
        plain = [n for n, block in enumerate(scene.blocks) if not block.color and not block.label]
        if not 0 < len(plain) < len(scene.blocks):
            raise Unclear
        return Ref("block", plain)
    if noun.noun in {"", "one", *FIGURES} and noun == Noun("other", noun.count, noun=noun.noun, many=noun.many):
        rests = [ref.rest for ref in scene.before if ref.kind == "figure" and ref.rest]
        if len(rests) == 1 and len(rests[0]) == (noun.count or (len(rests[0]) if noun.many else 1)):
            return Ref("figure", list(rests[0]))
    of_figure = scene.subject is not None and scene.subject[0] == "figure" and noun == Noun("other", noun=noun.noun)
    if noun.noun in FIGURES or (of_figure and noun.noun in {"", "one"}):
        spoken = {n for told in (scene.here, scene.before) for ref in told if ref.kind == "figure" for n in ref.ids}
        if of_figure and scene.subject is not None:
            spoken = set(scene.subject[1])
        left = [n for n in range(len(scene.figures)) if n not in spoken]
        if len(left) != (noun.count or 1) or not spoken:
            raise Unclear
        return Ref("figure", left)
    if noun.noun == "patch" or _is_of_patches(scene, noun):
        return _other_patches(scene, noun)
    one = scene.subject if noun == Noun(det="other", noun=noun.noun) and noun.noun in {"", "one"} else None
    if one is not None and one[0] == "figure" and len(one[1]) == 1 and len(scene.figures) == 2:
        if scene.taken or scene.instead:
            raise Unclear
        return Ref("figure", [1 - one[1][0]])
    left = [n for n in scene.whole if n not in scene.taken]
    if noun.ranks or noun.nth or noun.content is not None:
        raise Unclear
    if not scene.taken and (apart := _spared(scene) or _left_there(scene)):
        if noun.count not in {0, len(apart)} or noun.color or not (noun.many or noun.count > 1):
            raise Unclear
        return Ref("block", apart)
    if not scene.taken or not left or (noun.count and noun.count != len(left)):
        raise Unclear
    if not noun.count and noun.many != (len(left) > 1):
        raise Unclear
    if scene.instead and scene.patches and not noun.noun:
        raise Unclear  # the other block, or the other patch
    if noun.color and any(scene.blocks[n].color != noun.color for n in left):
        raise Unclear
    return take(scene, left)


def _is_of_patches(scene: Scene, noun: Noun) -> bool:
    """Whether nothing but patches was told of, so that "the other two" are some of them."""
    return len(scene.patches) > 1 and not scene.blocks and noun.noun in {"", "one"} and not scene.figures


def _other_patches(scene: Scene, noun: Noun) -> Ref:
    """ "(Only the green mat is empty,) the other two ...": those that are not spoken of."""
    spoken = {n for ref in scene.here or scene.before if ref.kind == "patch" for n in ref.ids}
    left = [n for n in range(len(scene.patches)) if n not in spoken]
    plain = not (noun.color or noun.ranks or noun.nth or noun.bound or noun.of)
    if not plain or not spoken or len(left) != (noun.count or (len(left) if noun.many else 1)) or not left:
        raise Unclear
    return Ref("patch", left)


def _spared(scene: Scene) -> list[int]:
    """ "The rest" of the only figure there is, of blocks of which others were spoken of by themselves."""
    figures = [figure for figure in scene.figures if not figure.implied]
    if len(figures) != 1:
        return []
    plain = [n for n in figures[0].blocks if not scene.blocks[n].color and not scene.blocks[n].label]
    if 0 < len(plain) < len(figures[0].blocks):
        return plain  # "the others are white"
    told = {n for ref in scene.refs("block") for n in ref.ids if len(ref.ids) < len(figures[0].blocks)}
    return [n for n in figures[0].blocks if n not in told] if told & set(figures[0].blocks) else []


def _left_there(scene: Scene) -> list[int]:
    """ "(Move the top block off,) the other two": those of what is there at the start that this is taken from."""
    if scene.changed:
        return list(scene.changed[-1].kept)
    start = [figure for figure in scene.figures if figure.stage < 0]
    if len(start) != 1 or len(scene.figures) > 1 or scene.subject is None or scene.subject[0] != "block":
        return []
    moved = set(scene.subject[1])
    return [n for n in start[0].blocks if n not in moved] if moved < set(start[0].blocks) else []


def check_only(scene: Scene, clause: Clause, ahead: int) -> None:
    """ "Only the middle one gets a blue block": there is no other one that could lie elsewhere."""
    said = clause.predicates[0]
    empty = [n for fact in scene.facts[ahead:] if fact.said == "empty" for n in fact.a.ids]
    if said == Place("empty") and empty and len(empty) < len(scene.patches):
        rest = [n for n in range(len(scene.patches)) if n not in empty]
        scene.facts += [Fact(Ref("patch", [n]), "empty", no=True) for n in rest]
        return
    upper = [fact.a.ids[0] for fact in scene.facts[ahead:] if fact.said == "on" and not fact.no]
    looks = {scene.blocks[n].look for n in upper}
    like = [n for n, block in enumerate(scene.blocks) if block.look in looks]
    if not isinstance(said, Bears) or said.what is None or not upper or set(like) != set(upper):
        raise Unclear
