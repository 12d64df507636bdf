"""Places of letters in a word that is spelled: they are told by the word already."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import structures as s
from rpg.language.meaning import At, Meaning
from rpg.passes.schema.resolve.orders.positions import SIDES, places_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def check_word(word: s.Spells, loose: list[tuple[Ref, Meaning, Span]], scene: Scene) -> None:
    """ "spell TOP down a tower, so that T is on top": what is said of a letter's place has to be so already."""
    kind = "stack" if word.along == "stack" else "row"
    text = word.word[::-1] if word.reverse != (kind == "stack") else word.word
    for ref, at_, span in loose:
        labels = [scene.things[n].label for n in ref.names]
        found = places_of(at_, len(text), len(ref.names), SIDES[kind], kind) if isinstance(at_, At) else []
        if not found or sorted(text[k] for k in found) != sorted(x or "" for x in labels):
            raise refuse("contradiction", f"this letter has another place in {word.word}", span, "leave it out")
