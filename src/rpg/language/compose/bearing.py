"""What lies on what is spoken of."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.coloring import has_at
from rpg.language.compose.nouns import resolve
from rpg.language.compose.relating import place
from rpg.language.compose.resting import on, on_patch, tops_of
from rpg.language.compose.scene import Fact, Ref, Scene, Unclear
from rpg.language.compose.syntax import Bears, Label, Noun, Phrase, Pronoun, any_number

_ITSELF = (Pronoun("it"), Pronoun("them"))


def bears(scene: Scene, ref: Ref, said: Bears) -> None:
    """Something lies on it, or nothing does."""
    if isinstance(said.what, Label):
        raise Unclear  # it may be the symbol on it
    if said.what is None:
        for n in tops_of(scene, ref):
            scene.facts.append(Fact(Ref("block", [n]), "clear"))
        return
    where = said.place
    on_each = where is not None and where.relation == "on" and where.of in _ITSELF and ref.kind == "block"
    if said.place is not None and said.place.relation != "top" and not on_each:
        if said.place.of is None and ref.kind == "figure" and said.place.relation in {"bottom", "middle"}:
            has_at(scene, ref, said.what, said.place.relation)
            return
        if said.place.of is None:
            raise Unclear
        own = said.place.of in {Pronoun("it"), Pronoun("its"), Pronoun("them")}  # it has something beside itself
        if own and (len(ref.ids) > 1 or ref.bound):
            raise Unclear
        first = resolve(scene, said.what)
        scene.around = (said.place.relation, ref, True) if own else scene.around
        place(scene, first, ref if own else resolve(scene, said.place.of), said.place)
        return
    if ref.kind == "patch":
        _bear_on_patches(scene, replace(ref, each=ref.each or said.each), said.what)
        return
    tops = tops_of(scene, ref)
    what = said.what
    if len(tops) > 1 and isinstance(what, Noun) and (what.det in {"a", "each"} or any_number(what)):
        for n in tops:
            one = resolve(scene, replace(what, det="a", many=False))
            on(scene, one, Ref("block", [n]), "on", no=False)
        return
    on(scene, resolve(scene, said.what), Ref("block", tops), "on", no=False)


def _bear_on_patches(scene: Scene, ref: Ref, what: Phrase) -> None:
    """ "Each mat gets a tower of two", "the two mats carry a white block each": what lies on each of these."""
    if not isinstance(what, Noun) or what.det not in {"a", ""} or what.many or what.count > 1:
        raise Unclear
    if len(ref.ids) > 1 and not ref.each:
        raise Unclear  # "the red and the blue mat get one block"
    for n in ref.ids:
        one = resolve(scene, what)
        if not one.fresh or one.kind not in {"block", "figure"}:
            raise Unclear
        on_patch(scene, one, Ref("patch", [n]), no=False)
