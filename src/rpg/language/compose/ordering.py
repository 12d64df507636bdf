"""Orders of the blocks of a figure: by what they show, or as they are at the start."""

from __future__ import annotations

from rpg.language.compose.scene import Figure, Scene, Unclear


def put_in_order(scene: Scene, figure: Figure, order: str) -> None:
    """ "In alphabetical order", "descending": by what its blocks show; from the left, or from the bottom up."""
    labels = [scene.blocks[n].label for n in figure.blocks]
    letters = order == "alphabetical" or (order == "ascending" and labels[0].isalpha())
    if figure.kind not in {"row", "line", "tower"} or figure.told:
        raise Unclear
    if not all(label.isalpha() if letters else label.isdigit() for label in labels):
        raise Unclear
    figure.blocks.sort(key=lambda n: scene.blocks[n].label, reverse=order == "descending")
    figure.told = figure.sided = figure.in_order = True


def as_at_start(scene: Scene, figure: Figure, *, back: bool) -> None:
    """In the order in which its blocks are at the start, or the other way round."""
    start = next((f for f in scene.figures if set(figure.blocks) <= set(f.blocks) and f.stage < 0), None)
    if start is None or not start.told or figure.kind != start.kind or figure.told:
        raise Unclear
    there = [at for at, n in enumerate(start.blocks) if n in figure.blocks]
    if there != list(range(there[0], there[-1] + 1)):
        raise Unclear
    figure.blocks = [start.blocks[at] for at in (there[::-1] if back else there)]
    figure.told, figure.sided = True, start.sided
    if figure.kind == "word":
        figure.word = "".join(scene.blocks[n].label for n in figure.blocks)
