"""Shares of a number of blocks: half, a third, most, not all, all but one."""

from __future__ import annotations

from rpg.language.meaning import Amount, Noun, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

_PARTS = {"half": (1, 2), "third": (1, 3), "quarter": (1, 4), "two thirds": (2, 3), "three quarters": (3, 4)}
_BOUNDS = frozenset({"at least half", "at most half", "less than half"})
SHARES = frozenset({*_PARTS, *_BOUNDS, "most", "not all", "some", "all but"})


def share_of(noun: Noun, whole: Ref, scene: Scene) -> Amount | None:
    """How many of `whole` are meant; None where `noun` speaks of no share."""
    if noun.det == "some":
        return noun.amount
    if whole.patch or not whole.names or whole.quant is not None:
        raise refuse("ambiguous", "it is not said how many there are", noun.span, "say how many")
    if all(scene.things[n].elastic for n in whole.names):
        raise refuse(
            "ambiguous",
            "it is not said how many blocks there are",
            noun.span,
            "say for example 'half of the six blocks'",
        )
    total = len(whole.names)
    if noun.det == "most":
        return Amount(total // 2 + 1, None, True)
    if noun.det == "at least half":
        return Amount((total + 1) // 2, None, True)
    if noun.det in _BOUNDS:
        return Amount(0, (total - (noun.det == "less than half")) // 2, True)
    if noun.det == "not all":
        return Amount(0, total - 1, True)
    if noun.det == "all but":
        left = total - (noun.amount.low if noun.amount else 0)
        if left < 1:
            raise refuse("too-many-asked", f"there are only {total} of these", noun.span, f"say at most {total - 1}")
        scene.all_but.append(whole.names)
        return Amount(left, left, True)
    part, parts = _PARTS[noun.det]
    if total % parts:
        raise refuse(
            "count-mismatch",
            f"{total} blocks have no {noun.det}",
            noun.span,
            f"say how many of the {total} blocks",
            blocks=total,
        )
    return Amount(part * total // parts, part * total // parts, True)


def so_many_each(theme: Ref, mark: Ref, scene: Scene) -> Ref:
    """ "Two of the red blocks on each mat", where it is not said how many there are: as many as that takes."""
    quant, things = theme.quant, [scene.things[n] for n in theme.names]
    told = mark.each and quant is not None and quant.low == quant.high and not theme.built
    if not told or quant is None or quant.low < 1 or any(t.elastic is None or t.name in scene.told for t in things):
        return theme
    return replace(theme, names=scene.fit(theme.names, quant.low * len(mark.names)))


def just_these(theme: Ref, scene: Scene) -> bool:
    """ "exactly two blocks", where those two were not known before: as many again for every patch."""
    return (
        theme.quant is not None
        and theme.quant.low == len(theme.names)
        and not any(scene.things[n].declared for n in theme.names)
    )
