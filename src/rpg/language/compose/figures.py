"""Figures and their parts: those that are spoken of, and further ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import isqrt, prod

from rpg.blocks.figures import FEWEST
from rpg.language.compose.facing import SIDED, face
from rpg.language.compose.items import FIGURES, PARTS, SYMBOL_KINDS, shows
from rpg.language.compose.lined import of_line, stand_in
from rpg.language.compose.ordering import as_at_start, put_in_order
from rpg.language.compose.places_of import DRAWN, line_of, places, steps
from rpg.language.compose.scene import OPPOSITE, TOWARD, Fact, Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import Both, Chain, Label, Listing, Noun, Phrase, Pronoun

Resolve = Callable[[Scene, Phrase], Ref]
"""What a phrase stands for."""
ALL = frozenset({"each", "all", "both"})
"""What is said of every one of several."""
_SIDES = frozenset({"left", "right"})
_LINED = frozenset({"left", "right", "middle", "outer", "end"})
_READ = frozenset({"word", "equation"})
"""What is read from the left."""
_COUNTED = frozenset({"tower", "row", "line", "column", "staircase", "pyramid"})
_SOLID = frozenset({"square", "grid", "wall", "cube"})
"""What is told by how wide, deep and high it is."""


def figures_of(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """The figures that a phrase stands for: those of such a kind that are known, or as many further ones.

    Raises Unclear where it is not clear which of several, or what further ones are made of.
    """
    kind = noun.noun if noun.noun in FIGURES else scene.figures[-1].kind if scene.figures else ""
    if not kind:
        raise Unclear
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
        if noun.count not in {0, len(noun.content.parts)}:
            raise Unclear
        made = [_made(scene, replace(noun, count=0, content=of), kind, resolve) for of in noun.content.parts]
        return Ref("figure", made, fresh=True)
    made = [_made(scene, noun, kind, resolve) for _ in range(noun.count or 1)]
    if noun.many and not noun.count:
        raise Unclear
    return Ref("figure", made, fresh=True)


def figure_fits(scene: Scene, figure: Figure, noun: Noun) -> bool:
    """Whether a figure may be the one that is spoken of."""
    if noun.noun in FIGURES and figure.kind != noun.noun:
        return False
    if noun.word and figure.word != noun.word:
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
    if a is None or b is None or a.kind != "tower" or rank not in TOWARD or not scene.alike([*a.blocks, *b.blocks]):
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


def _made(scene: Scene, noun: Noun, kind: str, resolve: Resolve) -> int:
    """A further figure, of further blocks unless its blocks are spoken of."""
    content, size, here = noun.content, noun.size, list(scene.here)
    if isinstance(content, Noun) and content.noun in {"block", "one", ""} and not content.color and content.count \
            and content.det == "" and not content.of and len(size) < 2 and not scene.stock:  # fmt: skip
        if content.bound not in {"", "exactly"} or prod(size or (content.count,)) != content.count:
            raise Unclear
        size, content = size or (content.count,), None
    figure = Figure(kind, [], size if len(size) > 1 else (), noun.word, way=noun.way)
    if noun.word == "pair" and (not isinstance(content, Chain) or len(content.parts) != 2):
        raise Unclear  # of what stands side by side, or of what lies on what
    figure.counted = isinstance(content, Noun) and content.count > 0
    if isinstance(content, Chain):
        _told_in_turn(scene, figure, noun, content, resolve)
    elif content is not None:
        if isinstance(content, Noun) and content.noun == "one" and content.color and content.count and not content.det:
            content = replace(content, noun="block")  # "a row of three red blocks behind a row of three blue ones"
        if isinstance(content, Noun) and content.many and not content.count and content.det == "" and size:
            content = replace(content, count=prod(size))
        ref = resolve(scene, content)
        if ref.kind != "block" or ref.bound or ref.no:
            raise Unclear
        figure.blocks = list(ref.ids)
        labels = [scene.blocks[n].label for n in ref.ids]
        if noun.made == "from" and len(labels) > 2 and all(map(str.isdigit, labels)) and labels == sorted(labels):
            raise Unclear  # "a row from 1 to 5" is in this order, one "from the digits 1 to 5" in any
        figure.free = isinstance(content, Both) and any(isinstance(p, Noun) and p.count > 1 for p in content.parts)
    elif noun.order == "alternating":
        figure.blocks = _alternating(scene, noun, size)
        figure.alternates = True
    elif noun.word:  # a word or an equation: a block for each of its symbols
        if any(block.label in noun.word for block in scene.blocks if block.label):
            raise Unclear
        figure.blocks = [scene.new_blocks(1, "", letter)[0] for letter in noun.word]
        figure.told = True
    else:
        alike = [f for f in scene.figures if f.kind == kind]
        if noun.det == "another" and not size and alike and noun.color:
            size = (len(alike[-1].blocks),)
        if not noun.color and any(scene.blocks[f.blocks[0]].color or f.stage < 0 for f in scene.figures):
            raise Unclear  # of the same colour as that one, or of another; of its blocks, or of others
        usual = kind == "plus" or (kind in DRAWN and noun.color)
        if usual and not size and scene.stock:
            raise Unclear  # of those that there are
        many = prod(size) if all(size) and size else FEWEST[kind] if usual else 0
        figure.blocks = scene.new_blocks(many, noun.color)
    if noun.color and any(scene.blocks[n].color != noun.color for n in figure.blocks):
        raise Unclear
    _check_size(figure, size, noun)
    kept = [f for f in scene.figures if scene.at_start or not scene.may_change(f)]
    if len(figure.blocks) < 2 or any(n in f.blocks for f in kept for n in figure.blocks):
        raise Unclear
    if noun.order in {"reversed", "kept"}:
        as_at_start(scene, figure, back=noun.order == "reversed")
    elif noun.order not in {"", "listed"} and not figure.alternates:
        put_in_order(scene, figure, noun.order)
    scene.figures.append(figure)
    scene.here = here  # "it" is the figure, not what it is made of
    return len(scene.figures) - 1


def _told_in_turn(scene: Scene, figure: Figure, noun: Noun, content: Chain, resolve: Resolve) -> None:
    """A tower from top to bottom, or a row from the right, of which the blocks are listed."""
    for of in reversed(content.parts):
        figure.blocks.append(_storey(scene, of, resolve, figure.blocks))
    upright = figure.kind == "tower" or (noun.order == "listed" and figure.kind == "row")
    if not upright or noun.made.startswith("from") or len(set(figure.blocks)) < len(figure.blocks):
        raise Unclear
    figure.told, figure.sided = True, figure.kind == "row"


def _storey(scene: Scene, phrase: Phrase, resolve: Resolve, below: list[int]) -> int:
    """A block of a tower told from top to bottom: one that lies below, or elsewhere, is not meant again."""
    told = isinstance(phrase, Noun) and phrase.color and not phrase.det and phrase.count < 2
    if told and isinstance(phrase, Noun):
        like = [n for n, block in enumerate(scene.blocks) if block.color == phrase.color]
        if like and all(n in below or scene.figure_of(n) for n in like):
            return scene.new_blocks(1, phrase.color)[0]
    if isinstance(phrase, Noun) and phrase.noun == "one" and phrase.det == "a" and phrase.color:
        phrase = replace(phrase, noun="block")
    return _one(scene, phrase, resolve)


def _alternating(scene: Scene, noun: Noun, size: tuple[int, ...]) -> list[int]:
    """Blocks of two colours in turn: as many of each, or one more of the first."""
    if len(size) != 1 or noun.noun not in {"tower", "row", "line"} or size[0] < 2:
        raise Unclear
    colors = noun.word.split()
    lots = [iter(scene.new_blocks((size[0] + 1 - n) // 2, color)) for n, color in enumerate(colors)]
    return [next(lots[n % 2]) for n in range(size[0])]


def _one(scene: Scene, phrase: Phrase, resolve: Resolve) -> int:
    ref = resolve(scene, phrase)
    if ref.kind != "block" or len(ref.ids) != 1:
        raise Unclear
    return ref.ids[0]


def _check_size(figure: Figure, size: tuple[int, ...], noun: Noun) -> None:
    """What is said of the size has to fit the blocks. A square of four is two by two, one of nine is filled."""
    many, kind = len(figure.blocks), figure.kind
    if kind not in _SOLID:
        unlike = size and size[0] != many and kind in _COUNTED
        if len(size) > 1 or unlike or (kind == "staircase" and not steps(many)):
            raise Unclear
        return
    side = isqrt(many)
    if kind == "square" and not size and "hollow" not in noun.ranks and (side < 4 or "full" in noun.ranks):
        size = (side, side) if side * side == many else ()
    if kind == "square" and not size and many % 4 == 0 and many >= 8 and (many != 16 or "hollow" in noun.ranks):
        return
    if kind == "cube":
        edge = round(many ** (1 / 3))
        size = size or (edge, edge, edge)
    if kind == "wall" and 0 in size and many % max(size) == 0:
        size = tuple(n or many // max(size) for n in size)
    uneven = kind in {"cube", "square"} and len({*size}) > 1
    if len(size) != (3 if kind == "cube" else 2) or prod(size) != many or uneven:
        raise Unclear
    figure.size = size if kind in {"wall", "cube"} else (size[1], size[0])
    figure.kind = "grid" if kind == "square" else kind


def has_first(figure: Figure) -> bool:
    """Whether its blocks are read one after the other, so that one is the first and one the last."""
    return figure.kind in _READ or figure.in_order


def part(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """The blocks of a figure at some of its places."""
    figures = whole_figures(scene, noun, resolve)
    unit = "step" if noun.noun == "one" and figures[0].kind == "staircase" else noun.noun
    said = (*noun.ranks, *((unit,) if unit in PARTS | {"row", "column"} else ()))
    if has_first(figures[0]):
        first, last = ("bottom", "top") if figures[0].kind == "tower" else ("left", "right")
        said = tuple({"last": last, "first": first}.get(rank, rank) for rank in said) or ((first,) if noun.nth else ())
    ids = []
    for figure in figures:
        count = noun.count or -noun.many
        if noun.many and not noun.count and said == ("middle",) and not figure.size:
            count = len(figure.blocks) - 2  # all but the outer ones
        at = places(figure, said, noun.nth, count)
        if scene.may_change(figure) and scene.subject is not None:
            raise Unclear  # what is put there is on the whole figure, or on what is left of it
        if noun.det == "other":
            if scene.place is None or scene.place[0] is not figure:
                raise Unclear
            at = [n for n in at if n != scene.place[1]]
            if len(at) != 1:
                raise Unclear
        found = [scene.at(figure, n) for n in at]
        scene.place = (figure, at[0]) if len(at) == 1 else None
        figure.sided |= figure.kind in _READ or (bool(_SIDES & set(said)) and figure.kind in {"row", "line"})
        ids += found
    if noun.color and any(scene.blocks[n].color != noun.color for n in ids):
        raise Unclear
    if noun.many and not noun.count and len(ids) == len(figures) and noun.noun in {"one", "block"} and noun.ranks:
        raise Unclear  # "the lower ones" are as many as are left
    whole = unit in {"row", "column", "layer", "side", "step"}
    if noun.noun in SYMBOL_KINDS and not all(shows(scene.blocks[n].label, noun.noun) for n in ids):
        raise Unclear
    if not noun.many and noun.det not in ALL and not noun.count and len(ids) > len(figures) and not whole:
        raise Unclear
    if noun.count and noun.count != len(ids):
        if noun.det in {"the", *ALL} or noun.bound or noun.count != 1:
            raise Unclear
        turned = figures[0].kind in {"row", "line"}  # either way round: one of the ends, whichever
        ids = [ids[0 if turned else scene.choose(len(ids))]]
        if not scene.alike(figures[0].blocks) or figures[0].sided:
            raise Unclear
    return Ref("block", ids, each=noun.det == "each")


def whole_figures(scene: Scene, noun: Noun, resolve: Resolve) -> list[Figure]:
    """The figures that a part is of: those said, or the one that was spoken of last."""
    if noun.of is not None and noun.of != Pronoun("it"):
        ref = resolve(scene, noun.of)
        if ref.kind == "figure":
            return [scene.figures[n] for n in ref.ids]
        held = scene.figure_of(ref.ids[0]) if ref.kind == "block" else None
        if held is None or not set(ref.ids) <= set(held.blocks):
            raise Unclear
        if len(held.blocks) == len(ref.ids):
            return [held]
        if isinstance(noun.of, Noun) and noun.of.noun in {"row", "column", "layer", "step"}:
            return [line_of(held, noun.of.noun, ref.ids)]
        raise Unclear
    if noun.color and (own := _of_color(scene, noun.color)) is not None:
        return [own]
    for spoken in (scene.here, scene.before):
        found = {n for ref in spoken if ref.kind == "figure" for n in ref.ids} - {*scene.placed}
        if len(found) == 1:
            scene.mention(Ref("figure", list(found)))
            return [scene.figures[found.pop()]]
        if found:
            raise Unclear
    if len(scene.figures) == 1:
        return [scene.figures[0]]
    raise Unclear


def _of_color(scene: Scene, color: str) -> Figure | None:
    """ "The middle red block": of several figures, the one that all red blocks are of."""
    own = {n for n, block in enumerate(scene.blocks) if block.color == color}
    return next((f for f in scene.figures if set(f.blocks) == own and not f.implied and len(scene.figures) > 1), None)


def within(scene: Scene) -> bool:
    """Whether a row that is spoken of is one of a grid, a wall, a cube or a pyramid."""
    return bool(scene.figures) and scene.figures[-1].kind in {"grid", "wall", "cube", "pyramid"}
