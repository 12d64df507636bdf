"""What is said of everything, and blocks that are named only afterwards."""

from __future__ import annotations

from rpg.language.meaning import Coord, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def note_all(meaning: Meaning, found: Ref, scene: Scene, scope: Scope) -> None:
    """Remember that all blocks were spoken of that there were."""
    if scope.role == "theme" and not scope.given and _whole(meaning) and found.names and not found.patch:
        scene.universals.append((scene.clause, tuple(t.name for t in scene.blocks()), meaning.span))


def _whole(meaning: Meaning) -> bool:
    """ "everything", "all blocks", "all blocks but the red one": whichever blocks there are."""
    if isinstance(meaning, Coord):
        return meaning.op == "except" and _whole(meaning.items[0])
    plain = isinstance(meaning, Noun) and meaning.head == "block" and meaning.traits == Traits()
    of = meaning.part_of if isinstance(meaning, Noun) else None
    of_all = of is None or (isinstance(of, Noun) and of.det == "the" and of.amount is None and of.traits == Traits())
    each = plain and isinstance(meaning, Noun) and meaning.det in ("all", "each") and of_all
    return (each and getattr(meaning, "amount", None) is None) or (
        isinstance(meaning, Pronoun) and meaning.word == "everything"
    )


def none_after_all(scene: Scene) -> None:
    """ "Everything is on the mat. The yellow block is next to the red one.": are these among everything?"""
    for clause, names, span in scene.universals:
        later = [m.ref for m in scene.mentions if m.clause > clause and m.ref.det in ("the", "bare", "each", "all")]
        new = {n for ref in later for n in ref.names if not ref.patch} - {*names}
        if any(n in scene.things and not scene.things[n].extra and not scene.things[n].patch for n in new):
            told = "other blocks are named later, and it is not clear whether these are meant too"
            raise refuse("ambiguous", told, span, "say which blocks there are first")


def all_others(theme: Ref, mark: Ref, loc: Loc, scene: Scene) -> Ref:
    """ "All blocks must be within 15 cm of the red one": all others."""
    everything = any(clause == scene.clause and names == theme.names for clause, names, _ in scene.universals)
    alone = len(mark.names) == 1 and not (mark.patch or mark.built or mark.quant or theme.quant or loc.negated)
    if not everything or not alone or loc.rel not in ("near", "distance") or len(theme.names) < 3:
        return theme
    return replace(theme, names=tuple(n for n in theme.names if n not in mark.names))
