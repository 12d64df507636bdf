"""Towers of which it is told block by block how they look: ones that are there already, and ones like another."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.facing import SIDED, face
from rpg.language.compose.scene import Figure, Scene, Unclear
from rpg.language.compose.syntax import Chain, Clause, Label, Looks, Noun, Phrase, Place


def told_in_turn(scene: Scene, clause: Clause) -> Clause | None:
    """ "(Two towers of two blocks each;) the left one is red at the bottom and blue on top, the right one is the other
    way around". None where all of it is said, else what there is left to say."""
    like = clause.predicates[0].like if clause.predicates and isinstance(clause.predicates[0], Looks) else None
    subject = clause.subject
    if not isinstance(like, Chain) or not isinstance(subject, Noun):
        return clause
    plain = [n for n, figure in enumerate(scene.figures) if figure.kind == "tower" and _is_plain(scene, figure)]
    if like.back:
        like = Chain(_reversed(scene, like))
        clause = replace(clause, predicates=(Looks(like), *clause.predicates[1:]))
    if not plain or subject.noun not in {"tower", "one", ""}:
        return clause
    n = _which(scene, subject, plain)
    figure = scene.figures[n]
    if len(clause.predicates) > 1 or len(like.parts) != len(figure.blocks):
        raise Unclear
    for at, part in zip(figure.blocks, reversed(like.parts), strict=True):
        block = scene.blocks[at]
        if isinstance(part, Label):
            block.label = part.label
        elif isinstance(part, Noun) and part == Noun(color=part.color):
            block.color = part.color
        else:
            raise Unclear
    figure.told = True
    return None


def _is_plain(scene: Scene, figure: Figure) -> bool:
    """Whether nothing is said yet of how its blocks look."""
    blocks = [scene.blocks[n] for n in figure.blocks]
    return not figure.told and not figure.placed and not any(block.color or block.label for block in blocks)


def _which(scene: Scene, noun: Noun, plain: list[int]) -> int:
    """The tower that this is told of: told by its side, or any of those of which nothing was said, which are alike."""
    sizes = {len(scene.figures[n].blocks) for n in plain}
    where = noun.that[0] if len(noun.that) == 1 else None
    side = noun.ranks[0] if len(noun.ranks) == 1 and noun.det == "the" else ""
    if isinstance(where, Place) and where.of is None and not where.no:
        side = {"front": "near", "behind": "far"}.get(where.relation, where.relation)
    rest = replace(noun, det="", ranks=(), that=(), noun="", nth=0, count=0)
    if len(sizes) > 1 or rest != Noun() or any(n in scene.facing.values() for n in plain):
        raise Unclear
    if side:
        if side not in SIDED or side in scene.facing:
            raise Unclear
        face(scene, side, plain[0])
    elif noun.ranks or noun.that or (noun.det == "the" and not noun.nth) or (noun.det == "other" and len(plain) > 1):
        raise Unclear
    return plain[0]


def _reversed(scene: Scene, like: Chain) -> tuple[Phrase, ...]:
    """The blocks of the tower that was told last, from its lowest to its highest one."""
    told = [figure for figure in scene.figures if figure.kind == "tower" and figure.told and not figure.implied]
    blocks = [scene.blocks[n] for n in told[-1].blocks] if told else []
    parts = tuple(Label(block.label, block.color) if block.label else Noun(color=block.color) for block in blocks)
    if not parts or (like.parts and like.parts != parts):
        raise Unclear
    return parts
