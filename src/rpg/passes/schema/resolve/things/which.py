"""What "which" is in "..., to the left of which a block is to be placed": what was named right before it."""

from __future__ import annotations

from rpg.language.meaning import Pronoun
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def which(word: Pronoun, scene: Scene) -> Ref:
    """The last thing named in the sentence before the word; of several blocks, the structure that they are put in."""
    told = [m for m in scene.mentions if m.sentence == scene.sentence and m.ref.names and m.ref.span < word.span]
    told = [m for m in told if m.ref.quant is None or m.ref.quant.high != 0]
    last = max(told, key=lambda m: m.ref.span, default=None)
    if last is None:
        raise refuse("no-referent", "it is not clear what 'which' is", word.span, "name the block")
    if len(last.ref.names) == 1:
        return last.ref
    built = [m for m in told if m.ref.built and set(last.ref.names) <= set(m.ref.names)]
    if not built:
        raise refuse("ambiguous", "'which' could be any of several blocks", word.span, "name the one you mean")
    return built[-1].ref
