"""What is read from blocks: "so it reads CAT", "the row says 12"; and colours of which none lies beside itself."""

from __future__ import annotations

from itertools import chain, zip_longest

from rpg.language.compose.forming import forms
from rpg.language.compose.nouns import resolve
from rpg.language.compose.scene import Figure, Ref, Scene, Unclear
from rpg.language.compose.syntax import Clause, Noun, Pronoun, Reads

_LINED = frozenset({"row", "line", "word"})


def read_as(scene: Scene, clause: Clause) -> bool:
    """Whether a clause tells which word blocks show that were told of before, which it orders."""
    said = clause.predicates[0] if len(clause.predicates) == 1 else None
    if not isinstance(said, Reads):
        return False
    if clause.mood == "start":
        raise Unclear
    ref = _told_last(scene) if isinstance(clause.subject, Pronoun) else resolve(scene, clause.subject)
    if ref.kind == "block" and len(ref.ids) > 1:
        _check_letters(scene, ref.ids, said.word)
        forms(scene, ref, Noun(det="a", noun="line"))
        figure = scene.figures[-1]
    elif ref.kind == "figure" and len(ref.ids) == 1:
        figure = scene.figures[ref.ids[0]]
    else:
        raise Unclear
    _spell(scene, figure, said.word)
    return True


def _told_last(scene: Scene) -> Ref:
    """The letters that were told of last, or the row of them."""
    for spoken in (scene.here, scene.before):
        fits = {_as_figure(scene, ref) for ref in spoken if ref.kind == "figure" or len(ref.ids) > 1}
        if len(fits) == 1:
            kind, ids = fits.pop()
            return Ref(kind, list(ids))
        if fits:
            raise Unclear
    raise Unclear


def _as_figure(scene: Scene, ref: Ref) -> tuple[str, tuple[int, ...]]:
    """The figure that blocks form, or what it is itself."""
    own = [n for n, f in enumerate(scene.figures) if ref.kind == "block" and set(f.blocks) == set(ref.ids)]
    return ("figure", tuple(own)) if own else (ref.kind, tuple(ref.ids))


def _check_letters(scene: Scene, ids: list[int], word: str) -> None:
    if sorted(scene.blocks[n].label for n in ids) != sorted(word):
        raise Unclear


def _spell(scene: Scene, figure: Figure, word: str) -> None:
    """Its blocks show this word, from the left."""
    if figure.kind not in _LINED or figure.stage < 0:
        raise Unclear
    _check_letters(scene, figure.blocks, word)
    if figure.told or figure.placed:
        scene.settle(figure)
        if "".join(scene.blocks[n].label for n in figure.blocks) != word:
            raise Unclear
    left = list(figure.blocks)
    for at, letter in enumerate(word):
        n = next(n for n in left if scene.blocks[n].label == letter)
        left.remove(n)
        figure.blocks[at] = n
    figure.kind, figure.word, figure.told, figure.free = "word", word, True, False


def take_turns(scene: Scene, figure: Figure) -> None:
    """ "No two of the same colour on each other": of two colours, of which there are as many, or one more, they take
    turns."""
    colors = {scene.blocks[n].color for n in figure.blocks}
    lots = [[n for n in figure.blocks if scene.blocks[n].color == color] for color in sorted(colors)]
    if len(lots) != 2 or figure.told or figure.placed or figure.kind not in {"tower", "row", "line"}:
        raise Unclear
    lots.sort(key=len, reverse=True)
    if "" in colors or len(lots[0]) - len(lots[1]) > 1:
        raise Unclear
    figure.blocks = [n for n in chain(*zip_longest(*lots)) if n is not None]
    figure.free, figure.alternates, figure.told = False, True, len(lots[0]) > len(lots[1])
