"""What the noun phrases of a text stand for."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.items import FIGURE, PART
from rpg.language.compose.places_of import columns, places
from rpg.language.compose.scene import Figure, Patch, Ref, Scene, Unclear
from rpg.language.compose.syntax import Both, Chain, Labels, Listing, Noun, Phrase, Pronoun

_FIGURES = frozenset(FIGURE.values())
_PARTS = frozenset(PART.values())
_ALL = frozenset({"each", "all", "both"})
_SIDES = frozenset({"left", "right"})


def resolve(scene: Scene, phrase: Phrase) -> Ref:
    """What a phrase stands for; what it tells of for the first time is put into the scene."""
    if isinstance(phrase, Pronoun):
        return scene.mention(_pronoun(scene, phrase.word))
    if isinstance(phrase, Labels):
        return scene.mention(Ref("block", [_labelled(scene, label, phrase.color) for label in phrase.labels]))
    if isinstance(phrase, Both):
        return _both(scene, phrase)
    if isinstance(phrase, Chain | Listing):
        raise Unclear
    ref = _noun(scene, replace(phrase, but=None))
    if phrase.but is not None:
        without = resolve(scene, phrase.but)
        if ref.kind != without.kind or not set(without.ids) < set(ref.ids) or ref.bound or ref.fresh:
            raise Unclear
        ref = replace(ref, ids=[n for n in ref.ids if n not in without.ids])
    return scene.mention(ref)


def _labelled(scene: Scene, label: str, color: str) -> int:
    found = [n for n, block in enumerate(scene.blocks) if block.label == label]
    if len(found) > 1:
        raise Unclear
    return found[0] if found else scene.new_blocks(1, color, label)[0]


def _both(scene: Scene, phrase: Both) -> Ref:
    """Several: all of one kind, or told of one by one."""
    if phrase.either:
        raise Unclear
    refs = [resolve(scene, part) for part in phrase.parts]
    if len({ref.kind for ref in refs}) > 1 or any(ref.bound or ref.no or ref.each for ref in refs):
        raise Unclear
    if len({isinstance(part, Noun) and part.of is not None and bool(part.count) for part in phrase.parts}) > 1:
        raise Unclear  # "one of the red block and the blue block"
    ids = [n for ref in refs for n in ref.ids]
    if len(set(ids)) < len(ids):
        raise Unclear
    rest = [n for ref in refs for n in ref.rest]
    return scene.mention(Ref(refs[0].kind, ids, rest, fresh=all(ref.fresh for ref in refs)))


def _pronoun(scene: Scene, word: str) -> Ref:
    """The one thing, or the one lot, that was spoken of last and that it can stand for."""
    if word == "which":
        return _last(scene)
    many = word in {"they", "their", "them", "these", "those", "both"}
    for spoken in (scene.here, scene.before):
        fits = [ref for ref in spoken if (len(ref.ids) > 1) == many and ref.kind != "table"]
        fits = [ref for ref in fits if not _is_subject(scene, ref)]
        if many and not fits and spoken is scene.before and len(scene.figures) > 1:
            if any(figure.implied for figure in scene.figures):
                raise Unclear
            fits = [Ref("figure", list(range(len(scene.figures))))]
        if word == "both":
            fits = [ref for ref in fits if len(ref.ids) == 2]
        if not fits:
            continue
        first = fits[0] if len({(ref.kind, tuple(ref.ids)) for ref in fits}) == 1 else None
        if first is None:
            raise Unclear
        whole = next(
            (n for n, f in enumerate(scene.figures) if f.kind == "tower" and set(f.blocks) == set(first.ids)), None
        )
        if first.kind == "block" and whole is not None:
            return Ref("figure", [whole])
        return replace(first, fresh=False, each=False, bound="", no=False)
    raise Unclear


def _is_subject(scene: Scene, ref: Ref) -> bool:
    """Whether this is, or is one of, what something is being said of: "it" is something else then."""
    return scene.subject is not None and ref.kind == scene.subject[0] and set(ref.ids) <= set(scene.subject[1])


def _last(scene: Scene) -> Ref:
    """What "which" stands for: what is told right before it."""
    spoken = scene.here or scene.before
    if not spoken or spoken[-1].kind == "table":
        raise Unclear
    return replace(spoken[-1], fresh=False, each=False, bound="", no=False)


def _noun(scene: Scene, noun: Noun) -> Ref:
    if noun.det == "other" and noun.noun not in _PARTS:
        return _others(scene, noun)
    if noun.of is not None and (noun.noun in _PARTS or noun.ranks or noun.nth):
        if noun.noun not in _FIGURES or noun.noun in {"row", "column"}:
            return part(scene, noun)
    if noun.of is not None or noun.det == "but":
        return _some_of(scene, noun)
    if noun.noun in {"row", "layer", "column"} and noun.ranks and _within(scene):
        return part(scene, noun)
    if noun.noun == "one" and noun.det in {"a", "another"} and not noun.color and scene.figures:
        return _figure(scene, noun)
    if noun.noun == "table":
        return Ref("table", [])
    if noun.noun == "patch":
        return _patch(scene, noun)
    if noun.noun in _FIGURES:
        return _figure(scene, noun)
    if noun.noun in {"letter", "digit"}:
        raise Unclear
    if noun.noun in _PARTS or (noun.ranks and noun.noun in {"block", "one"}) or (noun.nth and noun.noun == "one"):
        return _by_rank(scene, noun)
    return _blocks(scene, noun)


def _within(scene: Scene) -> bool:
    """Whether a row that is spoken of is one of a grid or a wall."""
    return bool(scene.figures) and scene.figures[-1].kind in {"grid", "wall"}


def _by_rank(scene: Scene, noun: Noun) -> Ref:
    """ "the middle one", "the left end", "the taller one", "the third": a part, a figure, or the one that is left."""
    if set(noun.ranks) & {"tall", "short", "former", "latter"} or (noun.noun == "one" and noun.det == "another"):
        return _figure(scene, noun)
    if noun.nth and not noun.ranks:
        left = [n for n in scene.whole if n not in scene.taken]
        if scene.whole and noun.nth == len(scene.whole) and len(left) == 1:
            return _take(scene, left)
        raise Unclear
    if noun.ranks == ("last",):
        left = [n for n in scene.whole if n not in scene.taken]
        if len(left) == 1:
            return _take(scene, left)
        raise Unclear
    return part(scene, noun)


def _take(scene: Scene, ids: list[int]) -> Ref:
    scene.taken += [n for n in ids if n not in scene.taken]
    return Ref("block", ids)


def part(scene: Scene, noun: Noun) -> Ref:
    """The blocks of a figure at some of its places."""
    figures = _whole_figures(scene, noun)
    said = (*noun.ranks, *((noun.noun,) if noun.noun in _PARTS | {"row", "column"} else ()))
    ids = []
    for figure in figures:
        at = places(figure, said, noun.nth, noun.count)
        if figure.stage < 0 and scene.subject is not None:
            raise Unclear  # what is put there is on the whole figure, or on what is left of it
        if noun.det == "other":
            at = [n for n in at if (figure.blocks, n) != scene.place]
            if len(at) != 1 or scene.place is None or scene.place[0] is not figure.blocks:
                raise Unclear
        scene.settle(figure)
        scene.place = (figure.blocks, at[0]) if len(at) == 1 else None
        figure.sided |= bool(_SIDES & set(said)) and figure.kind == "row"
        ids += [figure.blocks[n] for n in at]
    if noun.color and any(scene.blocks[n].color != noun.color for n in ids):
        raise Unclear
    whole = noun.noun in {"row", "column", "layer", "side"}
    if not noun.many and noun.det not in _ALL and not noun.count and len(ids) > len(figures) and not whole:
        raise Unclear
    if noun.count and noun.count != len(ids):
        if noun.det in {"the", *_ALL} or noun.bound or noun.count != 1:
            raise Unclear
        ids = ids[:1]  # one of the ends, whichever
        if not scene.alike(figures[0].blocks) or figures[0].sided:
            raise Unclear
    return Ref("block", ids, each=noun.det == "each")


def _whole_figures(scene: Scene, noun: Noun) -> list[Figure]:
    """The figures that a part is of: those said, or the one that was spoken of last."""
    if noun.of is not None and noun.of != Pronoun("it"):
        ref = resolve(scene, noun.of)
        if ref.kind == "figure":
            return [scene.figures[n] for n in ref.ids]
        held = [scene.figure_of(n) for n in ref.ids]
        if held and all(f is held[0] for f in held) and held[0] is not None and len(held[0].blocks) == len(ref.ids):
            return [held[0]]
        raise Unclear
    for spoken in (scene.here, scene.before):
        found = {n for ref in spoken if ref.kind == "figure" for n in ref.ids}
        if len(found) == 1:
            scene.mention(Ref("figure", list(found)))
            return [scene.figures[found.pop()]]
        if found:
            raise Unclear
    if len(scene.figures) == 1:
        return [scene.figures[0]]
    raise Unclear


def _others(scene: Scene, noun: Noun) -> Ref:
    """Those of the last lot that were not yet told of by themselves, or the other one of two figures or patches."""
    if noun.noun in _FIGURES:
        spoken = {n for ref in (*scene.here, *scene.before) if ref.kind == "figure" for n in ref.ids}
        left = [n for n in range(len(scene.figures)) if n not in spoken]
        if len(left) != (noun.count or 1) or not spoken:
            raise Unclear
        return Ref("figure", left)
    if noun.noun == "patch":
        raise Unclear
    left = [n for n in scene.whole if n not in scene.taken]
    if not scene.taken or not left or (noun.count and noun.count != len(left)):
        raise Unclear
    if not noun.many and not noun.count and len(left) > 1:
        raise Unclear
    if noun.color and any(scene.blocks[n].color != noun.color for n in left):
        raise Unclear
    return _take(scene, left)


def _some_of(scene: Scene, noun: Noun) -> Ref:
    """So many of a lot: any of those that look alike, of which nothing was said yet."""
    here = list(scene.here)
    if noun.of is None and not scene.whole:
        raise Unclear
    whole = resolve(scene, noun.of) if noun.of is not None else Ref("block", list(scene.whole))
    scene.here = here  # those that are meant are spoken of, not those that they are some of
    if whole.kind == "figure" and noun.noun in {"block", "one"}:
        whole = Ref("block", [n for at in whole.ids for n in scene.figures[at].blocks])
    if whole.fresh and scene.figures and isinstance(noun.of, Noun) and noun.of.det != "the":
        raise Unclear  # "one of two blocks" may be a figure
    ids = whole.ids
    if noun.det == "all" and noun.of == Pronoun("them") and len(ids) < len(scene.blocks):
        raise Unclear
    if noun.det in _ALL:
        if noun.det == "both" and len(ids) != 2:
            raise Unclear
        return Ref(whole.kind, ids, each=noun.det == "each", every=True)
    if noun.det == "no":
        return Ref(whole.kind, ids, no=True, each=True)
    count = len(ids) // 2 if noun.det == "half" else len(ids) - noun.count if noun.det == "but" else noun.count
    if whole.kind != "block" or not count or count > len(ids) or (noun.det == "half" and len(ids) % 2):
        raise Unclear
    if not scene.alike(ids) or noun.bound == "most":
        raise Unclear
    if scene.whole != ids:
        if any(n in scene.used for n in ids):
            raise Unclear  # which ones would not be clear
        scene.whole, scene.taken = list(ids), []
    left = [n for n in ids if n not in scene.taken]
    if len(left) < count or (noun.bound and scene.taken):
        raise Unclear
    chosen = left[:count]
    rest = [n for n in ids if n not in chosen] if noun.bound != "least" else []
    return replace(_take(scene, chosen), rest=rest, bound=noun.bound)


def _patch(scene: Scene, noun: Noun) -> Ref:
    if noun.ranks or noun.nth or noun.many or noun.count > 1 or noun.det not in {"a", "the", ""}:
        raise Unclear
    found = [n for n, patch in enumerate(scene.patches) if not noun.color or patch.color in {noun.color, ""}]
    if len(found) > 1:
        raise Unclear
    if not found:
        if not noun.color and scene.patches:
            raise Unclear
        scene.patches.append(Patch(noun.color))
        found = [len(scene.patches) - 1]
    patch = scene.patches[found[0]]
    patch.color = patch.color or noun.color
    return Ref("patch", found)


def _figure(scene: Scene, noun: Noun) -> Ref:
    kind = noun.noun if noun.noun in _FIGURES else scene.figures[-1].kind if scene.figures else ""
    if not kind:
        raise Unclear
    if noun.det in {"the", "each", "all", "both", "any"} or (not noun.det and noun.many and not noun.count):
        found = [n for n, figure in enumerate(scene.figures) if _fits(scene, n, figure, noun)]
        found = _ranked(scene, found, noun)
        if found:
            many = noun.many or noun.det in _ALL
            if (not many and len(found) > 1) or (noun.count and noun.count != len(found)) or noun.det == "any":
                raise Unclear
            for n in found:
                scene.figures[n].implied = False
            return Ref("figure", found, each=noun.det == "each")
        if noun.many or noun.det in _ALL or (noun.content is None and not noun.size):
            raise Unclear
    if noun.nth or noun.bound:
        raise Unclear
    if noun.count > 1 and noun.made == "from":
        raise Unclear
    if isinstance(noun.content, Listing):
        if noun.count != len(noun.content.parts):
            raise Unclear
        made = [_made(scene, replace(noun, count=0, content=part), kind) for part in noun.content.parts]
        return Ref("figure", made, fresh=True)
    made = [_made(scene, noun, kind) for _ in range(noun.count or 1)]
    if noun.many and not noun.count:
        raise Unclear
    return Ref("figure", made, fresh=True)


def _fits(scene: Scene, n: int, figure: Figure, noun: Noun) -> bool:
    """Whether a figure may be the one that is spoken of."""
    if noun.noun in _FIGURES and figure.kind != noun.noun:
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
        if isinstance(made, Labels):
            if not any(block.label == made.labels[0] for block in blocks):
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
    for rank in noun.ranks:
        heights = [len(scene.figures[n].blocks) for n in found]
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
            found = [n for n in found if _is_farthest(scene, n, found, rank)]
    if noun.nth:
        if noun.nth > len(found):
            raise Unclear
        found = [found[noun.nth - 1]]
    return found


_TOWARD = {"left": "to the left of", "right": "to the right of", "near": "in front of", "far": "behind"}
_OPPOSITE = {"left": "right", "right": "left", "near": "far", "far": "near"}


def _is_farthest(scene: Scene, n: int, found: list[int], rank: str) -> bool:
    """Whether a figure is said to be on that side of all others of these."""
    if rank == "middle":
        sides = [r for r in ("left", "near") if all(_is_between(scene, n, found, r) for _ in found)]
        return bool(sides)
    if rank not in _TOWARD:
        raise Unclear
    return all(_is_toward(scene, n, other, rank) for other in found if other != n)


def _is_between(scene: Scene, n: int, found: list[int], rank: str) -> bool:
    others = [m for m in found if m != n]
    toward = [m for m in others if _is_toward(scene, n, m, rank)]
    away = [m for m in others if _is_toward(scene, m, n, rank)]
    return len(toward) == len(away) and len(toward) + len(away) == len(others) > 0


def _is_toward(scene: Scene, a: int, b: int, rank: str) -> bool:
    return any(
        (fact.said.endswith(_TOWARD[rank]) and fact.a.ids == [a] and fact.b.ids == [b])
        or (fact.said.endswith(_TOWARD[_OPPOSITE[rank]]) and fact.a.ids == [b] and fact.b.ids == [a])
        for fact in scene.facts
        if fact.a.kind == "figure" and fact.b is not None and fact.b.kind == "figure" and not fact.no
    )


_DEFAULT: dict[str, int] = {"plus": 5}


def _made(scene: Scene, noun: Noun, kind: str) -> int:
    """A further figure, of further blocks unless its blocks are spoken of."""
    content, size, here = noun.content, noun.size, list(scene.here)
    if isinstance(content, Noun) and content.noun in {"block", "one", ""} and not content.color and content.count \
            and content.det == "" and not content.of and len(size) < 2 and not scene.stock:  # fmt: skip
        size, content = size or (content.count,), None
    figure = Figure(kind, [], size if len(size) == 2 else (), noun.word)
    if isinstance(content, Chain):
        figure.blocks = [_one(scene, part) for part in reversed(content.parts)]
        figure.told = True
        if kind != "tower" or len(set(figure.blocks)) < len(figure.blocks):
            raise Unclear
    elif content is not None:
        if isinstance(content, Noun) and content.many and not content.count and content.det == "" and size:
            content = replace(content, count=size[0] if len(size) == 1 else size[0] * size[1])
        ref = resolve(scene, content)
        if ref.kind != "block" or ref.bound or ref.no:
            raise Unclear
        figure.blocks = list(ref.ids)
    elif noun.word:
        if any(block.label in noun.word for block in scene.blocks if block.label):
            raise Unclear
        figure.blocks = [scene.new_blocks(1, "", letter)[0] for letter in noun.word]
        figure.told = True
    else:
        alike = [f for f in scene.figures if f.kind == kind]
        if noun.det == "another" and not size and alike and noun.color:
            size = (len(alike[-1].blocks),)
        if not noun.color and any(f.kind == kind and scene.blocks[f.blocks[0]].color for f in scene.figures):
            raise Unclear  # of the same colour as that one, or of another
        many = size[0] if len(size) == 1 else size[0] * size[1] if len(size) == 2 else _DEFAULT.get(kind, 0)
        figure.blocks = scene.new_blocks(many, noun.color)
    if noun.color and any(scene.blocks[n].color != noun.color for n in figure.blocks):
        raise Unclear
    _check_size(figure, size)
    if len(figure.blocks) < 2 or any(n in f.blocks for f in scene.figures for n in figure.blocks):
        raise Unclear
    scene.figures.append(figure)
    scene.here = here  # "it" is the figure, not what it is made of
    return len(scene.figures) - 1


def _one(scene: Scene, phrase: Phrase) -> int:
    ref = resolve(scene, phrase)
    if ref.kind != "block" or len(ref.ids) != 1:
        raise Unclear
    return ref.ids[0]


def _check_size(figure: Figure, size: tuple[int, ...]) -> None:
    """A square of four is two by two; what is said of the size has to fit the blocks."""
    many = len(figure.blocks)
    if figure.kind in {"square", "grid", "wall"}:
        if figure.kind == "square" and not size and many == 4:
            size = (2, 2)
        if len(size) != 2 or size[0] * size[1] != many:
            raise Unclear
        figure.size = size if figure.kind == "wall" else (size[1], size[0])
    elif len(size) > 1 or (size and size[0] != many and figure.kind in {"tower", "row", "column"}):
        raise Unclear
    if columns(figure) and figure.kind == "square":
        figure.kind = "grid"


def _blocks(scene: Scene, noun: Noun) -> Ref:
    """Blocks by their colour: those that are there, or further ones."""
    like = [n for n, block in enumerate(scene.blocks) if not noun.color or block.color == noun.color]
    definite = noun.det in {"the", *_ALL} or (not noun.det and not noun.count and bool(noun.color))
    many = noun.many or noun.det in _ALL or noun.count > 1
    if noun.bound or noun.det in {"any", "no"} or (noun.noun == "one" and not noun.color) or noun.nth or noun.ranks:
        raise Unclear
    if not like and definite and noun.det and not noun.noun:
        raise Unclear  # "the red" may be a patch
    if not like and definite and noun.noun == "one" and (scene.figures or not scene.blocks):
        raise Unclear  # the red one of what?
    if noun.noun == "one" and not definite and (not scene.here or scene.here[-1].kind != "block"):
        raise Unclear
    if definite and not like and any(not block.color and not block.label for block in scene.blocks):
        raise Unclear  # this could be one of those of which no colour was said
    if definite and like:
        if (noun.count and noun.count != len(like)) or (not many and len(like) > 1):
            raise Unclear
        if not noun.det and any(not noun.color for _ in like):
            raise Unclear
        return Ref("block", like, each=noun.det == "each", every=noun.det in _ALL)
    if not noun.color and (definite or (not noun.count and noun.det != "another")):
        raise Unclear
    count = noun.count or (2 if noun.det == "both" else 1)
    if many and not noun.count and noun.det != "both":
        raise Unclear
    if noun.det in {"a", ""} and (stock := _in_stock(scene, noun.color)):
        left = [n for n in stock if n not in scene.taken]
        if len(left) < count:
            raise Unclear
        if scene.whole != stock:
            scene.whole, scene.taken = list(stock), []
        return replace(_take(scene, left[:count]), fresh=True)
    if noun.det == "another" and like:
        left = [n for n in scene.whole if n not in scene.taken]
        if not scene.taken or not left or left[0] not in like:
            raise Unclear
        return replace(_take(scene, left[:count]), fresh=True)
    if not noun.color and any(not block.color and not block.label for block in scene.blocks):
        raise Unclear
    ids = scene.new_blocks(count, noun.color)
    return Ref("block", ids, fresh=True, each=noun.det == "each", every=noun.det in _ALL)


def _in_stock(scene: Scene, color: str) -> list[int]:
    """The lot of such blocks that the text said there is."""
    found = [lot for lot in scene.stock if not color or scene.blocks[lot[0]].color == color]
    if len(found) > 1:
        raise Unclear
    return found[0] if found else []
