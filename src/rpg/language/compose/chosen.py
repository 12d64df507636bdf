"""Those of several of which something is so: "the tower that has a pink block at the bottom", "those without white"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.figures import figure_fits
from rpg.language.compose.items import FIGURES
from rpg.language.compose.places_of import places
from rpg.language.compose.scene import SIDES, Fact, Figure, Ref, Resolve, Scene, Unclear
from rpg.language.compose.syntax import (
    ALL,
    Bears,
    Chain,
    Holding,
    Holds,
    Label,
    Looks,
    Noun,
    Owns,
    Phrase,
    Place,
    Predicate,
    Pronoun,
)

_BESIDE = {**SIDES, "next": "next to"}


def chosen(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """The blocks, figures or patches of which all this was told.

    Raises Unclear where it was told of none, of more than are spoken of, or of things of several kinds.
    """
    found = _candidates(scene, noun)
    for said in noun.that:
        found = [one for one in found if _so(scene, *one, said, resolve)]
    kinds = {kind for kind, _ in found}
    if len(kinds) != 1:
        raise Unclear
    ids = [n for _, n in found]
    many = noun.many or noun.det in ALL
    if (not many and len(ids) > 1) or (noun.count and noun.count != len(ids)):
        raise Unclear
    return Ref(kinds.pop(), ids, each=noun.det == "each")


def _candidates(scene: Scene, noun: Noun) -> list[tuple[str, int]]:
    """What is told of that the phrase may stand for, were it not for what is so of it."""
    if noun.ranks or noun.nth or noun.size or noun.word or (noun.of is not None and noun.of != Pronoun("them")):
        raise Unclear
    if noun.of is not None:  # of those that were told of together
        return [("block", n) for n in scene.whole]
    found: list[tuple[str, int]] = []
    if noun.noun in FIGURES | {"one"}:
        found += [("figure", n) for n, figure in enumerate(scene.figures) if figure_fits(scene, figure, noun)]
    if noun.noun in {"block", "one", ""}:
        found += [("block", n) for n, block in enumerate(scene.blocks) if noun.color in {"", block.color}]
    if noun.noun in {"patch", "one"}:
        found += [("patch", n) for n, patch in enumerate(scene.patches) if noun.color in {"", patch.color}]
    return found


def _so(scene: Scene, kind: str, n: int, said: Predicate, resolve: Resolve) -> bool:
    """Whether something was told of one of them."""
    if isinstance(said, Holds):
        return kind == "figure" and _holds(scene, n, said.what) != said.no
    if isinstance(said, Bears):
        return _bears(scene, kind, n, said)
    if isinstance(said, Looks):
        if said.no and kind == "block" and not scene.blocks[n].color and not scene.blocks[n].label:
            raise Unclear
        return _looks(scene, kind, n, said.like) != said.no
    if isinstance(said, Owns):
        return kind == "figure" and _owns(scene, scene.figures[n], said)
    if isinstance(said, Place) and not said.no and not said.cm:
        return _stands(scene, kind, n, said, resolve)
    if isinstance(said, Holding):
        what = _known(scene, said.what, resolve)
        facts = [fact for fact in scene.facts if not fact.no]
        there = any(_tells(fact, what.kind, what.ids[0], said.relation, Ref(kind, [n]), scene) for fact in facts)
        return there != said.no
    raise Unclear


def _holds(scene: Scene, n: int, what: Phrase) -> bool:
    """Whether some of the blocks of a figure look so, or whether it has so many."""
    blocks = [scene.blocks[m] for m in scene.figures[n].blocks]
    if isinstance(what, Label):
        return what.label in {*(block.label for block in blocks), *(scene.blocks[m].label for m in _upon(scene, n))}
    if not isinstance(what, Noun) or what.noun not in {"", "block", "one"} or what.ranks or what.of or what.nth:
        raise Unclear
    if what.det == "no":
        return not _holds(scene, n, replace(what, det="a", many=False))
    if what.color:
        if any(not block.color for block in blocks) or what.count > 1 or what.bound:
            raise Unclear
        return any(block.color == what.color for block in blocks)
    if not what.count:
        raise Unclear
    many = len(blocks)
    return {"least": many >= what.count, "most": many <= what.count}.get(what.bound, many == what.count)


def _upon(scene: Scene, figure: int) -> list[int]:
    """The blocks that were put on top of a tower, one on the other."""
    found = scene.figures[figure].blocks[-1:]
    for below in found:
        on = [fact.a.ids for fact in scene.facts if fact.said == "on" and fact.b == Ref("block", [below])]
        found += [n for ids in on for n in ids if n not in found]
    return found


def _bears(scene: Scene, kind: str, n: int, said: Bears) -> bool:
    """Whether it has such a block, at a place of it if that is told, or carries it."""
    if said.what is None:
        raise Unclear
    if kind != "figure":
        return False  # what lies on a block is told in other words
    where = said.place
    if where is None or (where.relation == "in" and isinstance(where.of, Pronoun)):
        return _holds(scene, n, said.what)
    if where.of is None and where.relation in {"top", "bottom", "middle", "left", "right"}:
        figure = scene.figures[n]
        at = places(figure, (where.relation,))
        blocks = [scene.blocks[m] for m in figure.blocks]
        if not figure.told and not scene.alike(figure.blocks):
            raise Unclear
        if not isinstance(said.what, Noun) or not said.what.color or len(at) != 1:
            raise Unclear
        return blocks[at[0]].color == said.what.color
    raise Unclear


def _owns(scene: Scene, figure: Figure, said: Owns) -> bool:
    """Whether its top block is of a colour, or its left end has a symbol."""
    part = said.part
    noun = () if part.noun in {"one", "block"} else (part.noun,)
    at = places(figure, (*part.ranks, *noun), part.nth)
    known = figure.told or scene.alike(figure.blocks) or set(at) <= set(figure.placed)
    if not known or part.many or part.color or part.count or len(at) != 1 or not isinstance(said.said, Looks):
        raise Unclear
    n = figure.placed.get(at[0], figure.blocks[at[0]])
    if isinstance(said.said.like, Label):
        return scene.blocks[n].label == said.said.like.label
    return _looks(scene, "block", n, said.said.like)


def _looks(scene: Scene, kind: str, n: int, like: Phrase) -> bool:
    """Whether it is of a colour, or told so from top to bottom."""
    if isinstance(like, Chain) and kind == "figure" and scene.figures[n].told:
        colors = [part.color if isinstance(part, Noun) else "" for part in reversed(like.parts)]
        return [scene.blocks[m].color for m in scene.figures[n].blocks] == colors
    if not isinstance(like, Noun) or not like.color or like.count > 1 or kind == "patch":
        raise Unclear
    blocks = scene.figures[n].blocks if kind == "figure" else [n]
    return {scene.blocks[m].color for m in blocks} == {like.color}


def _stands(scene: Scene, kind: str, n: int, said: Place, resolve: Resolve) -> bool:
    """Whether it was told to stand there."""
    if said.of is None or said.how in {"somewhere", "directly", "immediately"}:
        raise Unclear
    target = _known(scene, said.of, resolve)
    return any(_tells(fact, kind, n, said.relation, target, scene) for fact in scene.facts if not fact.no)


def _known(scene: Scene, phrase: Phrase, resolve: Resolve) -> Ref:
    """One thing that was told of before."""
    before = (len(scene.blocks), len(scene.figures), len(scene.patches))
    here = list(scene.here)
    found = resolve(scene, phrase)
    scene.here = here  # that which is meant is spoken of, not this
    if (len(scene.blocks), len(scene.figures), len(scene.patches)) != before:
        raise Unclear
    if len(found.ids) != 1 or found.bound or found.no or found.either:
        raise Unclear
    return found


def _tells(fact: Fact, kind: str, n: int, relation: str, target: Ref, scene: Scene) -> bool:
    """Whether a fact is that this is there."""
    if fact.b is None or fact.b.kind != target.kind or fact.b.ids != target.ids or fact.c is not None:
        return False
    if relation in _BESIDE:
        return fact.said == _BESIDE[relation] and fact.a.kind == kind and fact.a.ids == [n]
    if relation in {"on", "in"} and target.kind == "patch":
        blocks = scene.figures[n].blocks if kind == "figure" else [n]
        own = kind == "figure" or scene.figure_of(n) is None
        return fact.said == "patch" and own and kind != "patch" and set(blocks) <= set(fact.a.ids)
    if relation == "on":
        return fact.said == "on" and kind == "block" and fact.a.ids == [n]
    return False
