"""How things look that were told of before: "the left tower is red at the bottom", "everything else is white"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.compose.forming import looks_so
from rpg.language.compose.lined import from_left
from rpg.language.compose.nouns import resolve
from rpg.language.compose.places_of import places
from rpg.language.compose.resting import on
from rpg.language.compose.scene import Ref, Scene, Unclear
from rpg.language.compose.syntax import Both, Clause, InTurn, Looks, Noun, Phrase


def looks(scene: Scene, ref: Ref, said: Looks) -> None:
    """These blocks, or those at a place of these figures, are of a colour."""
    if said.at:
        scene.looked = True
        ref = _at(scene, ref, said.at)
    looks_so(scene, ref, said.like)


def looks_but_for(scene: Scene, ref: Ref, said: Looks, but: Clause) -> None:
    """ "All are green except for the middle one, whose top block is yellow": those of which no look is told then."""
    other = but.predicates[0]
    if not isinstance(other, Looks):
        raise Unclear
    looks(scene, resolve(scene, but.subject), other)
    own = [n for at in ref.ids for n in scene.figures[at].blocks] if ref.kind == "figure" else ref.ids
    plain = [n for n in own if not scene.blocks[n].color]
    if not plain or len(plain) == len(own) or ref.kind not in {"block", "figure"}:
        raise Unclear
    looks(scene, Ref("block", plain), said)


def _at(scene: Scene, ref: Ref, part: str) -> Ref:
    """The blocks at a place of figures: of each of them one, of which no look was told."""
    if ref.kind != "figure":
        raise Unclear
    figures = [scene.figures[at] for at in ref.ids]
    if part in {"below", "above"} and any(len(figure.blocks) > 2 for figure in figures):
        raise Unclear  # one of them, or all but the other end
    part = {"below": "bottom", "above": "top"}.get(part, part)
    found = [scene.at(figure, n) for figure in figures for n in places(figure, (part,))]
    if len(found) != len(ref.ids) or any(scene.blocks[n].color for n in found):
        raise Unclear
    return Ref("block", found)


def colored_in_turn(scene: Scene, clause: Clause) -> bool:
    """ "On top are red, green and blue, respectively, from left to right": of towers in a row, one after the other."""
    subject, said = clause.subject, clause.predicates[0] if clause.predicates else None
    if not isinstance(said, InTurn) or not isinstance(subject, Both):
        return False
    line = scene.lines[-1] if scene.lines else []
    if len(line) != len(subject.parts) or len(scene.lines) > 1:
        raise Unclear
    from_left(scene, line)
    for at, color in zip(line, subject.parts, strict=True):
        figure = Ref("figure", [at])
        top = scene.at(scene.figures[at], -1) if said.at == "top" else 0
        if said.at == "top" and scene.blocks[top].color and isinstance(color, Noun):
            on(scene, resolve(scene, replace(color, det="a", noun="block")), figure, "on", no=False)
        else:
            looks(scene, figure, Looks(color, at=said.at))
    return True


def has_at(scene: Scene, ref: Ref, what: Phrase, part: str) -> None:
    """ "Each has a white block at the bottom": a block of it, of which no look was told."""
    if not isinstance(what, Noun) or replace(what, det="") != Noun(color=what.color, noun=what.noun):
        raise Unclear
    looks(scene, ref, Looks(Noun(color=what.color, noun=what.noun), at=part))
