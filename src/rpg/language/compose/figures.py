"""Figures and their parts: those that are spoken of, and further ones."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.facing import SIDED, face
from rpg.language.compose.items import FIGURES
from rpg.language.compose.lined import of_line, stand_in
from rpg.language.compose.making import make
from rpg.language.compose.scene import OPPOSITE, TOWARD, Fact, Figure, Ref, Resolve, Scene, Unclear
from rpg.language.compose.syntax import ALL, Both, Chain, Label, Listing, Noun, Phrase

_LINED = frozenset({"left", "right", "middle", "outer", "end"})


def figures_of(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """The figures that a phrase stands for: those of such a kind that are known, or as many further ones.

    Raises Unclear where it is not clear which of several, or what further ones are made of.
    """
    kind = noun.noun if noun.noun in FIGURES else scene.figures[-1].kind if scene.figures else ""
    if not kind:
        raise Unclear
    if noun.word == "same":
        return _same_again(scene)
    if noun.det in {"the", "each", "all", "both", "any"} or (not noun.det and noun.many and not noun.count):
        found = [n for n, figure in enumerate(scene.figures) if figure_fits(scene, figure, noun)]
        found = _ranked(scene, found, noun)
        if found:
            many = noun.many or noun.count > 1 or noun.det in ALL
            if (not many and len(found) > 1) or (noun.count and noun.count != len(found)) or noun.det == "any":
                raise Unclear
            for n in found:
                scene.figures[n].implied = False
            return Ref("figure", found, each=noun.det == "each")
        listed = isinstance(noun.content, Listing) and not scene.figures
        several = noun.count or 2 * (noun.det == "both")
        if several > 1 and noun == Noun(noun.det, noun.count, noun=kind, many=True, size=noun.size) and noun.size:
            if scene.figures or noun.det == "each":
                raise Unclear
            return figures_of(scene, replace(noun, det="", count=several), resolve)  # "both towers are three high"
        bare = noun.content is None and not noun.size and not noun.word
        if ((noun.many or noun.det in ALL) and not listed) or bare:
            raise Unclear
    side = noun.ranks[0] if len(noun.ranks) == 1 and noun.det in {"a", ""} and noun.ranks[0] in SIDED else ""
    if side and noun.count < 2:
        one = figures_of(scene, replace(noun, ranks=()), resolve)
        face(scene, side, one.ids[0])
        return one
    if noun.nth or noun.bound or set(noun.ranks) - {"tall", "short", "hollow", "full"}:
        raise Unclear
    if noun.count > 1 and (
        noun.made.startswith("from") or (isinstance(noun.content, Both | Chain) and noun.made != "each")
    ):
        raise Unclear  # these are all of their blocks, or those of each
    if kind in {"row", "line"} and isinstance(noun.content, Noun) and noun.content.noun == "tower":
        towers = resolve(scene, noun.content)
        if not towers.fresh or noun.count > 1 or noun.color or noun.size:
            raise Unclear
        stand_in(scene, towers, Noun(noun=kind))
        return towers
    if isinstance(noun.content, Listing):
        if noun.count not in {0, len(noun.content.parts)} or (noun.det == "a" and not noun.many):
            raise Unclear
        made = [make(scene, replace(noun, count=0, content=of), kind, resolve) for of in noun.content.parts]
        return Ref("figure", made, fresh=True)
    made = [make(scene, noun, kind, resolve) for _ in range(noun.count or 1)]
    if noun.many and not noun.count:
        raise Unclear
    return Ref("figure", made, fresh=True)


def _same_again(scene: Scene) -> Ref:
    """ "(A tower that goes red, white, red,) and the same thing again": a further figure like the one told last."""
    like = scene.figures[-1]
    blocks = [scene.blocks[n] for n in like.blocks]
    if like.implied or like.placed or (like.free and not scene.alike(like.blocks)) or scene.may_change(like):
        raise Unclear
    if (
        any(block.label or not block.color for block in blocks)
        or scene.stock
        or any(f is not like for f in scene.figures)
    ):
        raise Unclear  # of which blocks, or like which figure
    own = [scene.new_blocks(1, block.color)[0] for block in blocks]
    scene.figures.append(replace(like, blocks=own, placed={}, barred={}))
    return Ref("figure", [len(scene.figures) - 1], fresh=True)


def figure_fits(scene: Scene, figure: Figure, noun: Noun) -> bool:
    """Whether a figure may be the one that is spoken of."""
    if noun.noun in FIGURES and figure.kind != noun.noun:
        return False
    if noun.word == "pair" and len(figure.blocks) != 2:
        return False
    if noun.word not in {"", "pair", figure.word}:
        return False
    if noun.color and {scene.blocks[b].color for b in figure.blocks} != {noun.color}:
        return False
    if noun.size and (len(figure.blocks),) != noun.size and figure.size != noun.size:
        return False
    if noun.content is None:
        return True
    return _same_blocks(scene, figure, noun.content)


def _same_blocks(scene: Scene, figure: Figure, content: Phrase) -> bool:
    """Whether a figure is one of such blocks."""
    parts = content.parts if isinstance(content, Both) else (content,)
    blocks = [scene.blocks[n] for n in figure.blocks]
    for made in parts:
        if isinstance(made, Label):
            if not any(block.label == made.label for block in blocks):
                return False
        elif isinstance(made, Noun) and made.noun in {"block", "one", ""}:
            like = [block for block in blocks if not made.color or block.color == made.color]
            if not like or (made.count and made.count != len(like)) or (len(parts) == 1 and len(like) < len(blocks)):
                return False
        else:
            return False
    return True


def _ranked(scene: Scene, found: list[int], noun: Noun) -> list[int]:
    """Those of the figures that are the tall, the short, the first, the last ones."""
    if any(set(line) == set(found) for line in scene.lines) and _LINED & set(noun.ranks):
        return of_line(scene, found, noun.ranks, noun.nth, noun.count)
    for rank in noun.ranks:
        heights = [len(scene.figures[n].blocks) for n in found]
        if rank in {"hollow", "full"}:
            continue
        if rank in {"tall", "short"}:
            if len(found) < 2:
                continue
            best = max(heights) if rank == "tall" else min(heights)
            found = [n for n, height in zip(found, heights, strict=True) if height == best]
        elif rank in {"former", "latter"}:
            if len(scene.figures) != 2:
                raise Unclear
            found = [0 if rank == "former" else 1]
        else:
            among = Ref("figure", found)
            _tell_apart(scene, among, rank)
            found = [n for n in found if is_farthest(scene, n, among, rank)]
    if noun.nth:
        if noun.nth > len(found):
            raise Unclear
        found = [found[noun.nth - 1]]
    return found


def _tell_apart(scene: Scene, both: Ref, rank: str) -> None:
    """ "The left one" of two towers that look alike: one of them is to the left of the other, whichever."""
    a, b = (scene.figures[n] for n in both.ids) if len(both.ids) == 2 else (None, None)
    if a is None or b is None or a.kind != "tower" or rank not in TOWARD:
        return
    if len({scene.blocks[n].look[:2] for n in (*a.blocks, *b.blocks)}) > 1:
        return
    sides = any(fact.said in TOWARD.values() for fact in scene.facts)
    if not sides and not scene.told_of("block") & {*a.blocks, *b.blocks} and len(a.blocks) == len(b.blocks):
        scene.facts.append(Fact(Ref("figure", both.ids[:1]), TOWARD[rank], Ref("figure", both.ids[1:])))


def is_farthest(scene: Scene, n: int, among: Ref, rank: str) -> bool:
    """Whether one of several is said to be on that side of all others, or between them."""
    others = [m for m in among.ids if m != n]
    if rank == "middle":
        sides = [r for r in ("left", "near") if _is_between(scene, n, others, among.kind, r)]
        return bool(sides)
    if rank not in TOWARD:
        raise Unclear
    return all(_is_toward(scene, n, other, among.kind, rank) for other in others)


def _is_between(scene: Scene, n: int, others: list[int], kind: str, rank: str) -> bool:
    toward = [m for m in others if _is_toward(scene, n, m, kind, rank)]
    away = [m for m in others if _is_toward(scene, m, n, kind, rank)]
    return len(toward) == len(away) and len(toward) + len(away) == len(others) > 0


def _is_toward(scene: Scene, a: int, b: int, kind: str, rank: str) -> bool:
    return any(
        (fact.said.endswith(TOWARD[rank]) and fact.a.ids == [a] and fact.b.ids == [b])
        or (fact.said.endswith(TOWARD[OPPOSITE[rank]]) and fact.a.ids == [b] and fact.b.ids == [a])
        for fact in scene.facts
        if fact.b is not None and fact.a.kind == fact.b.kind == kind and not fact.no
    )
