"""What "it" is behind a part of a structure."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Absolute, At, Loc, Pronoun
from rpg.passes.schema.resolve.things.world import Ref, refuse


def of_a_part(whole: Ref, theme: Ref, it: Pronoun, place: Loc, told: Sequence[Absolute]) -> None:
    """Refuse "a tower of four with blue second from the top and red right below it": below blue, or below all four?"""
    inside = [a for item in told for a in item.adjuncts if isinstance(a, At) and (a.side, a.index) != ("top", None)]
    further = bool(whole.built) and not set(theme.names) & set(whole.names)
    if inside and further and it.word in ("it", "that") and place.rel in ("on", "above", "under"):
        raise refuse("ambiguous", f"{it.word!r} could be the block or the structure", it.span, "name what you mean")
