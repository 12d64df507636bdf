"""What "it" is behind a part of a structure, and of what a corner is."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Absolute, At, Coord, In, Loc, Noun, Pronoun
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.two_lots import two_told
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def of_a_part(whole: Ref, theme: Ref, it: Pronoun, place: Loc, told: Sequence[Absolute]) -> None:
    """Refuse "a tower of four with blue second from the top and red right below it": below blue, or below all four?"""
    inside = [a for item in told for a in item.adjuncts if isinstance(a, At) and (a.side, a.index) != ("top", None)]
    further = bool(whole.built) and not set(theme.names) & set(whole.names)
    if inside and further and it.word in ("it", "that") and place.rel in ("on", "above", "under"):
        raise refuse("ambiguous", f"{it.word!r} could be the block or the structure", it.span, "name what you mean")


def of_its_own_corner(theme: Ref, whole: Ref, told: Spec) -> None:
    """Refuse "a grid of eight red blocks and a blue one, with the blue block in the upper left corner" of the table."""
    inside = len(whole.built) == 1 and whole.built[0].kind == "grid" and set(theme.names) < set(whole.names)
    for spot in told.places if inside else ():
        if isinstance(spot, In) and spot.region.endswith("_corner"):
            raise refuse("misplaced", "what is in the grid is in a corner of it", spot.span, "say 'of the grid'")


def onto_a_list(one: Loc, two: Loc) -> bool:
    """ "On B or C on D", "on the black mat and another one on the white mat": what lies on the second may be listed."""
    items = one.landmark.items if one.rel == "on" and isinstance(one.landmark, Coord) else ()
    another = any(isinstance(x, Noun) and x.det == "another" for x in items[-1:])
    return bool(items) and (another or getattr(two.landmark, "head", "patch") != "patch")


BESIDE = frozenset({"left", "right", "front", "behind", "beside", "adjacent", "near"})


def of_the_nearest(told: Absolute, it: Pronoun, place: Loc, scene: Scene) -> None:
    """Refuse "red left of blue with green behind it", where no comma tells it from "blue with green behind it"."""
    marks = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark"]
    beside = bool(marks) and marks[-1].rel in BESIDE and not (marks[-1].ref.patch or marks[-1].ref.built)
    next_to_it = beside and 0 < told.span[0] - marks[-1].ref.span[1] <= len(" with ")
    if next_to_it and it.word == "it" and place.rel in BESIDE:
        raise refuse("ambiguous", f"{it.word!r} could be the block that is placed or the one beside it", it.span,
                     "name the one you mean")  # fmt: skip


def whom(ref: Ref, last: Ref | None, word: Pronoun, loc: Loc, scene: Scene) -> Ref:
    """ "Place red left of blue with green behind them": behind both of these."""
    if (ends := two_told(ref, last, word, loc, scene)) is not None:
        return ends
    if len(ref.names) > 1 or word.word in ("it", "that"):
        return ref
    marks = [m.ref for m in scene.mentions if m.clause == scene.clause and m.role == "landmark" and not m.ref.patch]
    if len(marks) != 1 or len(marks[0].names) != 1:
        raise refuse("ambiguous", f"it is not clear what {word.word!r} are", word.span, "name the blocks")
    return Ref(names=(*ref.names, *marks[0].names), plural=True, det="both" if "both" in word.word else "the")
