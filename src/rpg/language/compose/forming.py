"""What things that are there form: "A, B and C form a tower", "the two towers stand in a row"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.facing import face, one_more
from rpg.language.compose.lined import stand_in
from rpg.language.compose.nouns import resolve
from rpg.language.compose.scene import Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import TOWER, Noun, Phrase, Pronoun

_IN_ORDER = frozenset({("left",), ("right",), ("near",), ("far",)})
"""From which side on they are in the order in which they are told."""


def forms(scene: Scene, ref: Ref, phrase: Phrase) -> None:
    """These form a figure."""
    if not isinstance(phrase, Noun):
        raise Unclear
    if ref.each and ref.kind == "figure" and len(ref.ids) > 1:
        for n in ref.ids:  # "lay each in a row"
            forms(scene, Ref("figure", [n]), phrase)
        return
    before = scene.figures[ref.ids[0]] if ref.kind == "figure" and len(ref.ids) == 1 else None
    if before is not None and scene.may_change(before) and not scene.at_start:
        ref = Ref("block", list(before.blocks))  # what is there is made into something else
        if phrase.noun == "one":
            phrase = replace(phrase, noun=before.kind)
    side = phrase.ranks[0] if phrase.det == "the" and len(phrase.ranks) == 1 else ""
    phrase = one_more(scene, phrase)
    if phrase.content is not None or phrase.count > 1 or phrase.det not in {"a", ""} or phrase.color:
        raise Unclear
    if ref.kind in {"figure", "mixed"} and len(ref.ids) > 1 and not side:
        stand_in(scene, ref, phrase)
        return
    if ref.kind == "block" and ref.bound == "exactly" and phrase == TOWER:  # none of the others is on another
        scene.facts += [Fact(Ref("block", [n]), "table") for n in ref.rest]
    elif ref.bound or (ref.rest and len({scene.blocks[n].look for n in ref.ids}) > 1):
        raise Unclear
    if ref.kind != "block" or ref.each or (phrase.noun == "column" and phrase.way):
        raise Unclear  # in this order, or in any
    in_order = phrase.ranks in _IN_ORDER and not scene.alike(ref.ids)
    if in_order and len({scene.blocks[n].look for n in ref.ids}) < len(ref.ids):
        raise Unclear
    back = phrase.ranks in {("right",), ("far",)}
    made = replace(phrase, det="a", ranks=(), content=Pronoun("these blocks"))
    here, scene.here = scene.here, [Ref("block", ref.ids)]
    subject, scene.subject = scene.subject, None
    figure = scene.figures[resolve(scene, made).ids[0]]
    scene.here, scene.subject = [*here, *scene.here[1:]], subject
    if in_order:
        figure.told, figure.sided = True, figure.kind != "column"
        figure.blocks = figure.blocks[::-1] if back else figure.blocks
    if side:
        face(scene, side, scene.figures.index(figure))


def looks_so(scene: Scene, ref: Ref, like: Phrase) -> None:
    """These blocks are of a colour: blocks of which nothing was said of how they look."""
    if not isinstance(like, Noun) or not like.color or like.noun not in {"", "block", "one"} or like.count > 1:
        raise Unclear
    if ref.kind == "figure":
        ref = Ref("block", [n for at in ref.ids for n in scene.figures[at].blocks])
    if ref.kind != "block" or ref.bound:
        raise Unclear
    whole = scene.figure_of(ref.ids[0])
    part = whole is not None and not whole.counted and set(ref.ids) < set(whole.blocks)
    exception = part and whole is not None and scene.alike(whole.blocks)
    for n in ref.ids:
        block = scene.blocks[n]
        if block.label or (block.color not in {"", like.color} and not exception):
            raise Unclear
        block.color = like.color
